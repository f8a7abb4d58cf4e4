//! The restraining forces of imposed strains.
//!
//! ```text
//! f0 = int B0' D eps_p J dA       within the section       sigma_p = D eps_p      (S-91)
//! fp = int Bpsi' D eps_p J dA     internal force
//! ```
//!
//! With the parts sS, sY, sZ of sigma_p that belong to the face and to the gradients along
//! y and along z, and the metric (S-71), node by node:
//!
//! ```text
//! fp = sum [I, -t x]' sS w                                 w: area of the point
//! on dielectrics:  f0_V = int grad N . e eps_p J dA, restraint of the potentials
//! f0 = sum [J (N,y sY + N,z sZ) - N k x sS - (a N,y + b N,z) sS] w
//! ```

use super::cell::DomainCell;
use super::domain::Domain;
use super::scaling::largest;
use crate::element::{
    CellPoint, FACE_STRAINS, Line, Y_GRADIENT_STRAINS, Z_GRADIENT_STRAINS, rigid_displacement,
    rule_points,
};
use crate::material::section_strain;
use crate::section::{CellMaterial, FreeStrain, ImposedStrain, Section};
use nalgebra::{DMatrix, Matrix6, Vector3, Vector6};

/// Forces of up to six states of imposed strain, in the units of the domain.
#[derive(Debug, Clone)]
pub struct ImposedForces {
    /// f0: at the unknowns within the section, n x 6 \[-\].
    pub within: DMatrix<f64>,
    /// fp: internal force, a column for each state \[-\].
    pub resultant: Matrix6<f64>,
    /// Largest component of the imposed strain of each state \[-\].
    pub largest: Vector6<f64>,
}

/// The forces of the first six of `states` of `section`, whose domain is `domain`.
pub fn imposed_forces(
    section: &Section,
    domain: &Domain,
    states: &[ImposedStrain],
) -> ImposedForces {
    let mut forces = ImposedForces::none(domain);
    for cell in &domain.cells {
        let index = cell.mesh_cell as usize;
        let made_of = &section.cells[index];
        let positions = domain.positions(cell);
        let positions = &positions[..cell.kind.node_count()];
        for (case, state) in states.iter().take(6).enumerate() {
            // a state without an entry for the cell has no strain there
            let Some(free) = state.cells.get(index) else {
                continue;
            };
            let free = in_section_axes(free, made_of);
            for point in rule_points(cell.kind) {
                let point = point.of_cell(positions);
                let strain = free.at(position_in_mesh(domain, &point));
                forces.largest[case] = largest(forces.largest[case], strain.amax());
                let stress = domain.laws[cell.law as usize] * strain;
                forces.add(case, cell, &domain.line, &point, &stress);
                if let Some(law) = cell.coupled {
                    let law = &domain.electric.laws[law as usize];
                    let flux = law.fixed_view::<3, 6>(6, 0) * strain;
                    forces.add_charges(case, (domain, cell), &point, &flux);
                }
            }
        }
    }
    forces
}

/// The free strain of a cell in section axes, order yz yy zz xx xy xz.
fn in_section_axes(free: &FreeStrain, made_of: &CellMaterial) -> FreeStrain {
    let turned =
        |strain: &Vector6<f64>| section_strain(strain, made_of.fiber_angle, made_of.plane_angle);
    FreeStrain {
        at_origin: turned(&free.at_origin),
        by_y: turned(&free.by_y),
        by_z: turned(&free.by_z),
    }
}

/// The position of a point in the mesh \[m\].
fn position_in_mesh(domain: &Domain, point: &CellPoint) -> [f64; 2] {
    let scaling = &domain.scaling;
    let [y, z] = scaling.origin;
    [y + scaling.length * point.y, z + scaling.length * point.z]
}

impl ImposedForces {
    /// No forces on `domain`.
    pub fn none(domain: &Domain) -> Self {
        Self {
            within: DMatrix::zeros(domain.unknowns(), 6),
            resultant: Matrix6::zeros(),
            largest: Vector6::zeros(),
        }
    }

    /// Adds the charges of an electric displacement y z x at a point of a dielectric cell
    /// to its potentials, (S-163).
    fn add_charges(
        &mut self,
        case: usize,
        (domain, cell): (&Domain, &DomainCell),
        point: &CellPoint,
        flux: &Vector3<f64>,
    ) {
        let metric = domain.line.metric(point.y, point.z);
        let [a, b] = metric.tilt;
        let by_y = metric.volume * flux.x - a * flux.z;
        let by_z = metric.volume * flux.y - b * flux.z;
        for (i, &node) in cell.nodes().iter().enumerate() {
            if let Some(unknown) = domain.potential_unknown(node as usize) {
                self.within[(unknown, case)] +=
                    point.area * (point.dy[i] * by_y + point.dz[i] * by_z);
            }
        }
    }

    /// Adds the forces of `stress`, order yz yy zz xx xy xz, at a point of a cell.
    pub(super) fn add(
        &mut self,
        case: usize,
        cell: &DomainCell,
        line: &Line,
        point: &CellPoint,
        stress: &Vector6<f64>,
    ) {
        let part = |rows: [usize; 3]| rows.map(|row| stress[row]);
        let face = Vector3::from(part(FACE_STRAINS));
        let along_y = Vector3::from(part(Y_GRADIENT_STRAINS));
        let along_z = Vector3::from(part(Z_GRADIENT_STRAINS));
        let metric = line.metric(point.y, point.z);
        let [a, b] = metric.tilt;
        let by_y = metric.volume * along_y - a * face;
        let by_z = metric.volume * along_z - b * face;
        let turned = line.curvature.cross(&face);

        for (i, &node) in cell.nodes().iter().enumerate() {
            let within =
                point.area * (point.dy[i] * by_y + point.dz[i] * by_z - point.n[i] * turned);
            let first = 3 * node as usize;
            for axis in 0..3 {
                self.within[(first + axis, case)] += within[axis];
            }
        }
        let resultant = rigid_displacement(1.0, point.y, point.z).tr_mul(&(point.area * face));
        let mut column = self.resultant.column_mut(case);
        column += resultant;
    }
}
