//! Voltages on the electrodes of a section: their effects, and the charges.
//!
//! ```text
//! [E R; R' A]_ff [x; y] = -[E_fc V; R_c' V]      theta = 0       r = -Ph_u' x_u   (S-166)
//! X_v = x + H r      Y_v = y - T r      Theta = -K Y_v
//! q at theta = 0 = freecap V      cap = freecap + Theta' Y_v
//! ```
//!
//! Y_v is found a second time, by the work of the voltages on the central solutions, and
//! must be the same:
//!
//! ```text
//! Y_v = X' f0 + Y' fp + T (X' P - Ph_V' x_V)        P = C x + L Y_v               (S-168)
//! ```
//!
//! where f0 and fp are the loads of the voltages, and x excludes the potential of the
//! conductors.
//!
//! # References
//! - [Masarati], section 9.1: piezoelectric beam sections.

use super::central::{Central, OF_CELLS, require_small};
use super::{Solved, named};
use crate::assembly::{
    Domain, Rate, State, VoltageForces, charges, largest, section_forces, voltage_forces,
};
use crate::failure::Failure;
use crate::section::ElectrodeShape;
use crate::solution::{ElectrodeSolution, PiezoChecks, PiezoSolution, SectionSolution};
use crate::solve::{CentralSystems, Load, ParticularSolution, electric_work};
use nalgebra::{DMatrix, DVector, Matrix6, Vector3, Vector6};
use shared_geom::wrench;

/// Last correction up to which the forces before it are accurate enough for the check: a
/// tenth of its limit.
const CORRECTED: f64 = 1e-10;

/// Electrodes that are solved together.
const TOGETHER: usize = 6;

/// All electrodes at one volt each, in the units of the domain.
#[derive(Debug)]
pub(super) struct Voltages {
    /// Displacements and potentials, n x 6 for every six electrodes.
    x: Vec<DMatrix<f64>>,
    /// Y_v, a column per electrode.
    y: Vec<Vector6<f64>>,
    /// Charges at no internal force, electrodes x electrodes.
    charges: DMatrix<f64>,
    /// Differences of `y` from (S-168).
    errors: Vec<Vector6<f64>>,
    checks: PiezoChecks,
}

impl Voltages {
    /// Solves for the electrodes of `domain`; `None` without any.
    pub(super) fn solve(
        domain: &Domain,
        systems: &CentralSystems,
        central: &Central,
    ) -> Result<Option<Self>, Failure> {
        let electrodes = &domain.electric.electrodes;
        if electrodes.is_empty() {
            return Ok(None);
        }
        let mut found = Self {
            x: Vec::new(),
            y: Vec::new(),
            charges: DMatrix::zeros(electrodes.len(), electrodes.len()),
            errors: Vec::new(),
            checks: PiezoChecks::default(),
        };
        for first in (0..electrodes.len()).step_by(TOGETHER) {
            let last = electrodes.len().min(first + TOGETHER);
            let forces = voltage_forces(domain, &electrodes[first..last]);
            let load = Load {
                within: &forces.within,
                resultant: &forces.resultant,
                rate: Rate::Zero,
            };
            let face = &central.decoupled.face;
            let unknowns = domain.unknowns();
            let solved = ParticularSolution::solve(domain, systems.steady(), face, &load)
                .ok_or(Failure::OutOfMemory { unknowns })?;
            found.add((domain, central), &forces, solved, first..last);
        }
        found.check(domain, &central.compliance);
        Ok(Some(found))
    }

    /// Adds the solution of the electrodes `range`.
    fn add(
        &mut self,
        (domain, central): (&Domain, &Central),
        forces: &VoltageForces,
        solved: ParticularSolution,
        range: std::ops::Range<usize>,
    ) {
        let central = &central.decoupled;
        let ParticularSolution {
            mut x,
            y,
            face,
            correction,
        } = solved;
        let face = if correction <= CORRECTED {
            face
        } else {
            section_forces(domain, steady(&x, &y)).face
        };
        let charges_work = electric_work(domain, &central.face, &x);
        x += &forces.potential;
        let one_volt = |electrode: usize, case: usize| {
            if electrode == range.start + case {
                1.0
            } else {
                0.0
            }
        };
        let electrodes = &domain.electric.electrodes;
        let rows = charges(domain, electrodes, steady(&x, &y), one_volt);
        for (electrode, row) in rows.iter().enumerate() {
            for (case, column) in range.clone().enumerate() {
                self.charges[(electrode, column)] = row[case];
            }
        }
        let product = |columns: &DMatrix<f64>| -> Matrix6<f64> {
            let product = central.x.tr_mul(columns);
            product.fixed_view::<6, 6>(0, 0).into_owned()
        };
        let on_face = product(&face) - charges_work;
        let tt = domain.line.equilibrium().transpose();
        let work =
            product(&forces.within) + central.y.transpose() * forces.resultant + tt * on_face;
        for case in 0..range.len() {
            self.errors.push((y - work).column(case).into_owned());
            self.y.push(y.column(case).into_owned());
        }
        self.x.push(x);
    }

    /// Computes the checks and makes the capacitance symmetric. A strain is relative to
    /// `sqrt(C_ii cap_ee)`, the strain with the energy of one volt.
    fn check(&mut self, domain: &Domain, compliance: &Matrix6<f64>) {
        let electrodes = &domain.electric.electrodes;
        let is_conductor = |&electrode: &usize| electrodes[electrode].fingered.is_empty();
        let conductors: Vec<usize> = (0..electrodes.len()).filter(is_conductor).collect();
        let charge = self.charges.diagonal().amax();
        let down = compliance
            .diagonal()
            .map(|entry| 1.0 / (entry * charge).sqrt());
        let beside = |strain: &Vector6<f64>| strain.component_mul(&down).amax();

        let common: Vector6<f64> = conductors.iter().map(|&electrode| self.y[electrode]).sum();
        let mut charges = DVector::zeros(electrodes.len());
        for &electrode in &conductors {
            charges += self.charges.column(electrode);
        }
        let transposed = self.charges.transpose();
        self.checks = PiezoChecks {
            work: self.errors.iter().map(beside).fold(0.0, largest),
            asymmetry: (&self.charges - &transposed).amax() / charge,
            common: largest(beside(&common), charges.amax() / charge),
        };
        self.charges = 0.5 * (&self.charges + transposed);
    }
}

/// A state that is constant along the beam.
fn steady<'a>(warping: &'a DMatrix<f64>, strain: &'a Matrix6<f64>) -> State<'a> {
    State {
        rate: Rate::Zero,
        warping: Some(warping),
        strain,
    }
}

impl Solved<'_> {
    /// Effects of voltages, in SI about the origin of the mesh; `None` without electrodes.
    ///
    /// # Errors
    /// [`Failure::Inaccurate`] when a check fails.
    pub(super) fn piezo(
        &self,
        solution: &SectionSolution,
    ) -> Result<Option<PiezoSolution>, Failure> {
        let Some(voltages) = &self.voltages else {
            return Ok(None);
        };
        self.require_voltages(voltages)?;
        let scaling = &self.domain.scaling;
        let [y, z] = scaling.origin;
        let v = wrench::shift_matrix(&Vector3::new(0.0, y, z));
        let units = scaling.strain() / scaling.potential;
        let in_si = |y: &Vector6<f64>| v.transpose() * y.component_mul(&units);
        let section = self.section.electrodes.iter().enumerate();
        let electrodes = section.map(|(number, electrode)| {
            let (field, column) = (&voltages.x[number / TOGETHER], number % TOGETHER);
            let free_strain = in_si(&voltages.y[number]);
            ElectrodeSolution {
                name: electrode.name.clone(),
                circuit: electrode.circuit,
                is_conductor: matches!(electrode.shape, ElectrodeShape::Conductor { .. }),
                warping: scaling.length / scaling.potential * self.on_mesh(field, column),
                potential: self.potential_on_mesh(field, column),
                free_strain,
                coupling: -(solution.stiffness * free_strain),
            }
        });
        let electrodes: Vec<ElectrodeSolution> = electrodes.collect();
        let length = scaling.length / scaling.potential;
        let free_capacitance = scaling.modulus * length * length * &voltages.charges;
        let count = electrodes.len();
        let by_strain = DMatrix::from_fn(count, count, |i, j| {
            electrodes[i].coupling.dot(&electrodes[j].free_strain)
        });
        let capacitance = &free_capacitance + 0.5 * (&by_strain + by_strain.transpose());
        let nodes = self.section.mesh.nodes.len();
        let mut has_potential = vec![false; nodes];
        for (node, &mesh_node) in self.domain.mesh_nodes.iter().enumerate() {
            has_potential[mesh_node as usize] = self.domain.potential_unknown(node).is_some();
        }
        Ok(Some(PiezoSolution {
            electrodes,
            capacitance,
            free_capacitance,
            potential: self.potential_of_forces(&v),
            has_potential,
            checks: voltages.checks,
        }))
    }

    fn require_voltages(&self, voltages: &Voltages) -> Result<(), Failure> {
        let PiezoChecks {
            work,
            asymmetry,
            common,
        } = voltages.checks;
        let weakest = named(self.section, &self.domain, self.weakest);
        for check in [
            ("the work of the voltages", work),
            ("the symmetry of the capacitance", asymmetry),
            ("a voltage common to all conductors", common),
        ] {
            require_small(check, OF_CELLS.check, weakest)?;
        }
        Ok(())
    }

    /// Potential at the nodes of the mesh per unit of the forces about the origin of the
    /// mesh, which `v` shifts to the origin of the domain \[V/N, V/(N m)\].
    fn potential_of_forces(&self, v: &Matrix6<f64>) -> DMatrix<f64> {
        let scaling = &self.domain.scaling;
        let per_force = scaling.force().map(|unit| scaling.potential / unit);
        let forces = Matrix6::from_diagonal(&per_force) * v;
        let mut potential = DMatrix::zeros(self.section.mesh.nodes.len(), 6);
        for (node, &mesh_node) in self.domain.mesh_nodes.iter().enumerate() {
            if let Some(unknown) = self.domain.potential_unknown(node) {
                let row = self.central.decoupled.x.fixed_view::<1, 6>(unknown, 0) * forces;
                potential.row_mut(mesh_node as usize).copy_from(&row);
            }
        }
        potential
    }

    /// A column of the potentials of a field of the domain at the nodes of the mesh.
    pub(super) fn potential_on_mesh(&self, field: &DMatrix<f64>, column: usize) -> DVector<f64> {
        let mut on_mesh = DVector::zeros(self.section.mesh.nodes.len());
        for (node, &mesh_node) in self.domain.mesh_nodes.iter().enumerate() {
            if let Some(unknown) = self.domain.potential_unknown(node) {
                on_mesh[mesh_node as usize] = field[(unknown, column)];
            }
        }
        on_mesh
    }
}

#[cfg(test)]
#[path = "piezo_tests.rs"]
mod tests;
