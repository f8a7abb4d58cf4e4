//! All parameters at once: the integrals (S-120) of the central and the dual states over
//! the cells that each parameter changes.

use super::Solved;
use super::change::{CellChange, Change};
use super::derivative::{Conversion, Derivative};
use super::parameter::{Parameter, SensitivityProblem};
use crate::assembly::{Domain, DomainCell};
use crate::element::{
    CellPoint, MovedPoint, NO_COLUMNS, NodalColumns, NodalState, cell_points, strain_at,
};
use crate::solve::DualStates;
use nalgebra::{DMatrix, Matrix6};

/// Derivatives with respect to `parameters`, by the dual states of the section: a number
/// of solutions that does not depend on theirs, and an integral over its own cells for
/// each.
///
/// # Errors
/// [`SensitivityProblem`] for the first parameter that the section does not have, or
/// without memory.
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

/// The states that the changes work on, and the integrals of each change.
pub(super) fn integrals(
    solved: Solved<'_>,
    changes: &[Change],
) -> Result<(Fields, Vec<Sums>), SensitivityProblem> {
    let domain = solved.domain;
    let unknowns = domain.unknowns();
    let duals = DualStates::solve(domain, solved.systems, solved.central)
        .ok_or(SensitivityProblem::OutOfMemory { unknowns })?;
    let fields = Fields::of(solved, duals);
    let mut sums = vec![Sums::none(fields.states.len()); changes.len()];
    for (cell, of_cell) in domain.cells.iter().zip(by_cell(domain, changes)) {
        let mut state = None;
        for index in of_cell {
            let change = &changes[index as usize];
            let sums = &mut sums[index as usize];
            sums.add_mass(domain, cell, change);
            let change = change.of_cell(cell);
            if change.law.is_none() && change.velocities.is_none() {
                continue;
            }
            let state = state.get_or_insert_with(|| CellStates::of(domain, cell, &fields));
            sums.add(domain, cell, &change, state);
        }
    }
    Ok((fields, sums))
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

/// A state of the whole section.
struct Field {
    rate: DMatrix<f64>,
    warping: DMatrix<f64>,
    psi: Matrix6<f64>,
}

/// The central state w, then the dual states e.
pub(super) struct Fields {
    states: Vec<Field>,
    /// c of the dual states.
    weights: Vec<Matrix6<f64>>,
    /// T'.
    along: Matrix6<f64>,
}

impl Fields {
    fn of(solved: Solved<'_>, duals: DualStates) -> Self {
        let central = solved.central;
        let along = solved.domain.line.equilibrium();
        let mut fields = Self {
            states: vec![Field {
                rate: turned(&central.x, &along),
                warping: central.x.clone(),
                psi: central.y,
            }],
            weights: Vec::new(),
            along,
        };
        for dual in duals.states {
            fields.weights.push(dual.weight);
            fields.states.push(Field {
                rate: dual.rate,
                warping: dual.x,
                psi: dual.y,
            });
        }
        fields
    }
}

/// The states in a cell: values at the nodes, strains at the points.
struct CellStates {
    nodal: Vec<(NodalColumns, NodalColumns, Matrix6<f64>)>,
    points: Vec<CellPoint>,
    /// Volume and strains of all states, by point; the strains are transposed.
    strains: Vec<(f64, Vec<Matrix6<f64>>)>,
}

impl CellStates {
    fn of(domain: &Domain, cell: &DomainCell, fields: &Fields) -> Self {
        let nodal: Vec<_> = fields
            .states
            .iter()
            .map(|field| {
                (
                    at_nodes(cell, &field.rate),
                    at_nodes(cell, &field.warping),
                    field.psi,
                )
            })
            .collect();
        let places = domain.places(cell);
        let points: Vec<_> = cell_points(cell.kind, &places[..cell.kind.node_count()]).collect();
        let line = &domain.line;
        let strains = points.iter().map(|point| {
            let of_state = nodal.iter().map(|(rate, warping, psi)| {
                strain_at(line, point, Some(rate), Some(warping), psi).transpose()
            });
            let volume = point.area * line.metric(point.y, point.z).volume;
            (volume, of_state.collect())
        });
        Self {
            strains: strains.collect(),
            nodal,
            points,
        }
    }
}

/// `x T'` (n x 6), `along` is T'.
pub(super) fn turned(x: &DMatrix<f64>, along: &Matrix6<f64>) -> DMatrix<f64> {
    let mut turned = DMatrix::zeros(x.nrows(), 6);
    turned.gemm(1.0, x, along, 0.0);
    turned
}

/// The six columns of `field` (n x 6) at the nodes of `cell`.
pub(super) fn at_nodes(cell: &DomainCell, field: &DMatrix<f64>) -> NodalColumns {
    let mut columns = NO_COLUMNS;
    for (at_node, &node) in columns.iter_mut().zip(cell.nodes()) {
        *at_node = field.fixed_view::<3, 6>(3 * node as usize, 0).into();
    }
    columns
}

/// What the cells add up to for a parameter.
#[derive(Clone)]
pub(super) struct Sums {
    /// `e' dG w`, of the central state, then of the dual ones.
    pub forms: Vec<Matrix6<f64>>,
    /// `d(rho (1, y, z, y y, y z, z z) dA)`.
    pub moments: [f64; 6],
}

impl Sums {
    pub fn none(states: usize) -> Self {
        Self {
            forms: vec![Matrix6::zeros(); states],
            moments: [0.0; 6],
        }
    }

    /// (S-113) with (S-116), (S-117).
    pub fn compliance(&self, fields: &Fields) -> Matrix6<f64> {
        let duals = self.forms[1..].iter().zip(&fields.weights);
        let z: Matrix6<f64> = duals.map(|(form, weight)| form * weight).sum();
        let half = fields.along.transpose() * z + z * fields.along;
        half + half.transpose() - self.forms[0]
    }

    /// (S-120).
    fn add(
        &mut self,
        domain: &Domain,
        cell: &DomainCell,
        change: &CellChange<'_>,
        states: &CellStates,
    ) {
        if let Some(law) = change.law {
            for (volume, strains) in &states.strains {
                let stress = *volume * law * strains[0].transpose();
                for (form, transposed) in self.forms.iter_mut().zip(strains) {
                    form.gemm(1.0, transposed, &stress, 1.0);
                }
            }
        }
        if let Some(velocities) = &change.velocities {
            let law = &domain.laws[cell.law as usize];
            for point in &states.points {
                let velocities = &velocities[..cell.kind.node_count()];
                let moved = MovedPoint::new(&domain.line, point, velocities);
                self.add_moved(law, &moved, &states.nodal);
            }
        }
    }

    fn add_moved(
        &mut self,
        law: &Matrix6<f64>,
        moved: &MovedPoint<'_>,
        nodal: &[(NodalColumns, NodalColumns, Matrix6<f64>)],
    ) {
        let (volume, growth) = moved.volume();
        let state =
            |(rate, warping, psi): &(_, _, _)| moved.strain(NodalState { rate, warping, psi });
        let (strain, rate) = state(&nodal[0]);
        let stress = law * strain;
        let with_growth = volume * law * rate + growth * stress;
        let stress = volume * stress;
        for (form, nodal) in self.forms.iter_mut().zip(nodal) {
            let (strain, rate) = state(nodal);
            *form += strain.tr_mul(&with_growth) + rate.tr_mul(&stress);
        }
    }

    /// The rate of `rho (1, y, z, y y, y z, z z) J dA`, of density and place.
    pub fn add_mass(&mut self, domain: &Domain, cell: &DomainCell, change: &Change) {
        let velocities = change.of_cell(cell).velocities;
        if change.density == 0.0 && velocities.is_none() {
            return;
        }
        let count = cell.kind.node_count();
        let places = domain.places(cell);
        let velocities = velocities.unwrap_or_default();
        for point in cell_points(cell.kind, &places[..count]) {
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
