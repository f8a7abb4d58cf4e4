//! Derivatives for all parameters at once: the integrals (S-120) of the central and the
//! dual states over the cells changed by each parameter.

use super::Solved;
use super::change::Change;
use super::derivative::{Conversion, Derivative};
use super::fields::{AtNodes, Fields, Lane, Strains};
use super::parameter::{Parameter, SensitivityProblem};
use crate::assembly::{Domain, DomainCell};
use crate::element::{
    CASES, CaseLoop, MovedPoint, Product, Row, add_work, cell_points, in_widest_registers,
    stress_in_cases,
};
use crate::solve::DualStates;
use nalgebra::Matrix6;

/// Derivatives with respect to `parameters`, by the dual states of the section: the number
/// of solutions does not depend on the number of parameters, and each parameter needs an
/// integral over its own cells.
///
/// # Errors
/// [`SensitivityProblem`] for the first parameter that the section does not have, or if
/// memory is insufficient.
pub fn all_at_once(
    solved: Solved<'_>,
    parameters: &[Parameter],
) -> Result<Vec<Derivative>, SensitivityProblem> {
    let changes = Change::of_parameters(solved.section, solved.domain, parameters)?;
    let (fields, sums) = integrals(solved, &changes)?;
    let conversion = Conversion::new(solved);
    let derivatives = sums.iter().map(|sums| {
        let df = sums.compliance(&fields);
        conversion.derivative(&df, &sums.moments)
    });
    Ok(derivatives.collect())
}

/// The central and dual states, and the integrals of each change.
pub(super) fn integrals(
    solved: Solved<'_>,
    changes: &[Change],
) -> Result<(Fields, Vec<Sums>), SensitivityProblem> {
    let domain = solved.domain;
    let unknowns = domain.unknowns();
    let duals = DualStates::solve(domain, solved.systems, solved.central)
        .ok_or(SensitivityProblem::OutOfMemory { unknowns })?;
    let fields = Fields::of(solved, duals);
    let sums = in_widest_registers(Integration {
        domain,
        changes,
        fields: &fields,
    });
    Ok((fields, sums))
}

/// The integrals of each change, over the cells.
struct Integration<'a> {
    domain: &'a Domain,
    changes: &'a [Change],
    fields: &'a Fields,
}

impl CaseLoop for Integration<'_> {
    type Output = Vec<Sums>;

    #[inline(always)]
    fn run<P: Product>(self) -> Vec<Sums> {
        let Self {
            domain,
            changes,
            fields,
        } = self;
        let mut sums = vec![Sums::none(fields.count()); changes.len()];
        let mut strains = Strains::new(domain, fields);
        for (cell, of_cell) in domain.cells.iter().zip(by_cell(domain, changes)) {
            let (mut is_here, mut at_nodes) = (false, None);
            for index in of_cell {
                let change = &changes[index as usize];
                let sums = &mut sums[index as usize];
                sums.add_mass(domain, cell, change);
                if let Some(law) = change.law(cell) {
                    if !is_here {
                        strains.go_to::<P>(cell);
                        is_here = true;
                    }
                    sums.add_law::<P>(law, &strains);
                }
                if let Some(velocities) = change.velocities(cell) {
                    let at_nodes = at_nodes.get_or_insert_with(|| fields.at_nodes(cell));
                    sums.add_motion(domain, cell, &velocities, at_nodes);
                }
            }
        }
        sums
    }
}

/// The changes of each cell of the domain.
fn by_cell(domain: &Domain, changes: &[Change]) -> Vec<Vec<u32>> {
    let mut of_cell = vec![Vec::new(); domain.cells.len()];
    for (index, change) in (0..).zip(changes) {
        for &cell in &change.cells {
            of_cell[cell as usize].push(index);
        }
    }
    of_cell
}

/// The sums over the cells for a parameter.
#[derive(Clone)]
pub(super) struct Sums {
    /// `e' dG w` of each field: a row for each of its cases.
    forms: Vec<[Row; CASES]>,
    /// `d(rho (1, y, z, y y, y z, z z) dA)`.
    pub moments: [f64; 6],
}

impl Sums {
    pub fn none(fields: usize) -> Self {
        Self {
            forms: vec![[[0.0; CASES]; CASES]; fields],
            moments: [0.0; 6],
        }
    }

    /// (S-113) with (S-116), (S-117).
    pub fn compliance(&self, fields: &Fields) -> Matrix6<f64> {
        let of_dual = |lanes: &[Option<Lane>; 6]| -> Matrix6<f64> {
            Matrix6::from_fn(|i, k| {
                lanes[i].map_or(0.0, |(field, lane)| self.forms[field][lane][k])
            })
        };
        let duals = fields.duals().iter();
        let z: Matrix6<f64> = duals.map(|(weight, lanes)| of_dual(lanes) * weight).sum();
        let half = fields.along.transpose() * z + z * fields.along;
        half + half.transpose() - self.of_central()
    }

    /// `w' dG w`.
    pub fn of_central(&self) -> Matrix6<f64> {
        Matrix6::from_fn(|i, k| self.forms[0][i][k])
    }

    /// (S-120), of the law.
    #[inline(always)]
    fn add_law<P: Product>(&mut self, law: &Matrix6<f64>, strains: &Strains<'_>) {
        let law = law.transpose().into();
        for (volume, strains) in strains.points() {
            let stress = stress_in_cases::<P>(&law, &strains[0], volume);
            for (form, strain) in self.forms.iter_mut().zip(strains) {
                add_work::<P, CASES, 6>(form, strain, &stress);
            }
        }
    }

    /// (S-120), of the node positions.
    fn add_motion(
        &mut self,
        domain: &Domain,
        cell: &DomainCell,
        velocities: &[[f64; 2]; 9],
        at_nodes: &[AtNodes],
    ) {
        let law = &domain.laws[cell.law as usize];
        let count = cell.kind.node_count();
        for point in cell_points(cell.kind, &domain.positions(cell)[..count]) {
            let moved = MovedPoint::new(&domain.line, &point, &velocities[..count]);
            self.add_moved(law, &moved, at_nodes);
        }
    }

    fn add_moved(&mut self, law: &Matrix6<f64>, moved: &MovedPoint<'_>, at_nodes: &[AtNodes]) {
        let (volume, growth) = moved.volume();
        let (strain, rate) = moved.strain(at_nodes[0].state());
        let stress = law * strain;
        let with_growth = volume * law * rate + growth * stress;
        let stress = volume * stress;
        for at_nodes in at_nodes {
            let (strain, rate) = moved.strain(at_nodes.state());
            let more = strain.tr_mul(&with_growth) + rate.tr_mul(&stress);
            for (i, lane) in at_nodes.lanes.into_iter().enumerate() {
                let Some((field, lane)) = lane else { continue };
                for (sum, more) in self.forms[field][lane].iter_mut().zip(&more.row(i)) {
                    *sum += more;
                }
            }
        }
    }

    /// The rate of `rho (1, y, z, y y, y z, z z) J dA`, from density and position.
    pub fn add_mass(&mut self, domain: &Domain, cell: &DomainCell, change: &Change) {
        let velocities = change.velocities(cell);
        if change.density == 0.0 && velocities.is_none() {
            return;
        }
        let count = cell.kind.node_count();
        let positions = domain.positions(cell);
        let velocities = velocities.unwrap_or_default();
        for point in cell_points(cell.kind, &positions[..count]) {
            let moved = MovedPoint::new(&domain.line, &point, &velocities[..count]);
            let (volume, growth) = moved.volume();
            let [vy, vz] = moved.velocity();
            let (y, z) = (point.y, point.z);
            let weight = change.density * volume + cell.density * growth;
            let still = [1.0, y, z, y * y, y * z, z * z];
            let moving = [0.0, vy, vz, 2.0 * y * vy, vy * z + y * vz, 2.0 * z * vz];
            for ((sum, still), moving) in self.moments.iter_mut().zip(still).zip(moving) {
                *sum += weight * still + cell.density * volume * moving;
            }
        }
    }
}
