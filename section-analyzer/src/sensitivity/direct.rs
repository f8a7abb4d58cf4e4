//! Derivatives for one parameter after the other, each by the solution of its own change.

use super::Solved;
use super::change::Change;
use super::contraction::Sums;
use super::derivative::{Conversion, Derivative};
use super::fields::{at_nodes, turned};
use super::parameter::{Parameter, SensitivityProblem};
use crate::assembly::{DomainCell, SectionForces};
use crate::element::{MovedPoint, NO_COLUMNS, NodalColumns, NodalForces, NodalState, cell_points};
use crate::solve::Variation;
use nalgebra::{DMatrix, Matrix6};

/// Derivatives with respect to `parameters`, with a solution of six columns each: for few
/// parameters, and independent of the dual states.
///
/// # Errors
/// [`SensitivityProblem`] for the first parameter that the section does not have, or if
/// memory is insufficient.
pub fn direct(
    solved: Solved<'_>,
    parameters: &[Parameter],
) -> Result<Vec<Derivative>, SensitivityProblem> {
    let domain = solved.domain;
    let changes = Change::of_parameters(solved.section, domain, parameters)?;
    let conversion = Conversion::new(solved);
    let along = domain.line.equilibrium();
    let rate = turned(&solved.central.x, &along);
    let derivatives = changes.iter().map(|change| {
        let given = given_forces(solved, &rate, change);
        let variation = Variation::solve(domain, solved.systems, &given).ok_or(
            SensitivityProblem::OutOfMemory {
                unknowns: domain.unknowns(),
            },
        )?;
        let z: Matrix6<f64> = solved
            .central
            .x
            .tr_mul(&variation.face)
            .fixed_view::<6, 6>(0, 0)
            .into();
        let df = correction(&along, &z) - given.work;
        let mut sums = Sums::none(0);
        for &cell in &change.cells {
            sums.add_mass(domain, &domain.cells[cell as usize], change);
        }
        Ok(conversion.derivative(&df, &sums.moments))
    });
    derivatives.collect()
}

/// `T S + S T'` of (S-113), with `Z = X' dPh`.
fn correction(along: &Matrix6<f64>, z: &Matrix6<f64>) -> Matrix6<f64> {
    let s = z + z.transpose();
    along.transpose() * s + s * along
}

/// The forces of a change on the central state, (S-114), and their work on it, `W' dG W`.
fn given_forces(solved: Solved<'_>, rate: &DMatrix<f64>, change: &Change) -> SectionForces {
    let (domain, central) = (solved.domain, solved.central);
    let mut forces = SectionForces::none(domain);
    for &cell in &change.cells {
        let cell = &domain.cells[cell as usize];
        let (rate, warping) = (at_nodes(cell, rate), at_nodes(cell, &central.x));
        let state = NodalState {
            rate: &rate,
            warping: &warping,
            psi: &central.y,
        };
        let of_cell = cell_forces(solved, cell, change, state);
        let work = |values: &NodalColumns, forces: &NodalColumns| -> Matrix6<f64> {
            let count = cell.kind.node_count();
            let pairs = values.iter().zip(forces).take(count);
            pairs.map(|(value, force)| value.tr_mul(force)).sum()
        };
        forces.work += work(&rate, &of_cell.face)
            + work(&warping, &of_cell.within)
            + central.y.tr_mul(&of_cell.resultant);
        forces.resultant += of_cell.resultant;
        for (i, &node) in cell.nodes().iter().enumerate() {
            let mut within = forces.within.fixed_view_mut::<3, 6>(3 * node as usize, 0);
            within += of_cell.within[i];
            let mut face = forces.face.fixed_view_mut::<3, 6>(3 * node as usize, 0);
            face += of_cell.face[i];
        }
    }
    forces
}

fn cell_forces(
    solved: Solved<'_>,
    cell: &DomainCell,
    change: &Change,
    state: NodalState<'_>,
) -> NodalForces {
    let domain = solved.domain;
    let mut forces = NodalForces {
        within: NO_COLUMNS,
        face: NO_COLUMNS,
        resultant: Matrix6::zeros(),
    };
    let count = cell.kind.node_count();
    let (law_rate, velocities) = (change.law(cell), change.velocities(cell));
    for point in cell_points(cell.kind, &domain.positions(cell)[..count]) {
        if let Some(law) = law_rate {
            let at = MovedPoint::at_rest(&domain.line, &point);
            let (strain, _) = at.strain(state);
            at.add_forces(&(law * strain), &mut forces);
        }
        if let Some(velocities) = &velocities {
            let law = &domain.laws[cell.law as usize];
            let at = MovedPoint::new(&domain.line, &point, &velocities[..count]);
            let (strain, rate) = at.strain(state);
            at.add_force_rates(&(law * strain), &(law * rate), &mut forces);
        }
    }
    forces
}
