//! Loads of voltages on a section, and the charges of states on its electrodes.
//!
//! A conductor at one volt is a potential that is one at its nodes; its forces are the
//! forces of the stresses of this state, and its charge balances the electric displacement
//! of the rest of the section there. The field of an interdigitated electrode is given, so
//! that its forces are integrals over its cells:
//!
//! ```text
//! f0 = int B0' e' E J dA      fp = int Bpsi' e' E J dA
//! q  = -sum Q_V of its nodes        conductor                                     (S-164)
//! q  = int E . (e eps + epsS E V) J dA        interdigitated                      (S-165)
//! ```
//!
//! # References
//! - [Masarati], section 9.1: voltages as prescribed potentials.

use super::cell::DomainCell;
use super::domain::Domain;
use super::electric::{DomainElectrode, Fingered};
use super::forces::{Rate, SectionForces, State};
use super::imposed::ImposedForces;
use super::stress::take_columns;
use crate::element::{CellPoint, NO_COLUMNS, NO_FIELD, NodalColumns, rule_points, strain_at};
use nalgebra::{DMatrix, Matrix6, RowVector6};

/// Up to six electrodes at one volt each, with everything else at rest, in the units of the
/// domain.
#[derive(Debug, Clone)]
pub struct VoltageForces {
    /// The potential of conductors among the unknowns, n x 6 \[-\].
    pub potential: DMatrix<f64>,
    /// Forces of the voltages within the section, n x 6 \[-\].
    pub within: DMatrix<f64>,
    /// Internal force of the voltages, a column for each electrode \[-\].
    pub resultant: Matrix6<f64>,
}

/// The forces of the first six of `electrodes`.
pub fn voltage_forces(domain: &Domain, electrodes: &[DomainElectrode]) -> VoltageForces {
    let n = domain.unknowns();
    let mut potential = DMatrix::zeros(n, 6);
    for (case, electrode) in electrodes.iter().enumerate().take(6) {
        for &node in &electrode.nodes {
            if let Some(unknown) = domain.potential_unknown(node as usize) {
                potential[(unknown, case)] = 1.0;
            }
        }
    }
    let mut forces = SectionForces::none(domain);
    let state = State {
        rate: Rate::Zero,
        warping: Some(&potential),
        strain: &Matrix6::zeros(),
    };
    forces.measure_in(domain, state, Some(&cells_at(domain, electrodes)));
    let mut requested = ImposedForces {
        within: -forces.within,
        resultant: -forces.resultant,
        ..ImposedForces::none(domain)
    };
    for (case, electrode) in electrodes.iter().enumerate().take(6) {
        each_fingered(domain, electrode, |cell, fingered, point| {
            requested.add(case, cell, &domain.line, point, &fingered.stress);
        });
    }
    VoltageForces {
        potential,
        within: requested.within,
        resultant: requested.resultant,
    }
}

/// For each cell of the domain whether it has a node of a conductor among `electrodes`.
fn cells_at(domain: &Domain, electrodes: &[DomainElectrode]) -> Vec<bool> {
    let mut is_conductor = vec![false; domain.nodes.len()];
    for &node in electrodes.iter().flat_map(|electrode| &electrode.nodes) {
        is_conductor[node as usize] = true;
    }
    let touches = |cell: &DomainCell| {
        let mut nodes = cell.nodes().iter();
        nodes.any(|&node| is_conductor[node as usize])
    };
    domain.cells.iter().map(touches).collect()
}

/// Calls a function at the points of the cells between the fingers of an electrode.
fn each_fingered(
    domain: &Domain,
    electrode: &DomainElectrode,
    mut see: impl FnMut(&DomainCell, &Fingered, &CellPoint),
) {
    if electrode.fingered.is_empty() {
        return;
    }
    let cells = domain.cells.iter().map(|cell| cell.mesh_cell).max();
    let mut of_mesh = vec![None; cells.map_or(0, |last| last as usize + 1)];
    for fingered in &electrode.fingered {
        if let Some(entry) = of_mesh.get_mut(fingered.mesh_cell as usize) {
            *entry = Some(fingered);
        }
    }
    for cell in &domain.cells {
        let Some(fingered) = of_mesh[cell.mesh_cell as usize] else {
            continue;
        };
        let positions = domain.positions(cell);
        for point in rule_points(cell.kind) {
            let point = point.of_cell(&positions[..cell.kind.node_count()]);
            see(cell, fingered, &point);
        }
    }
}

/// Charge per length on each of `electrodes` in the states of up to six cases that are
/// constant along the beam; `voltages` of each electrode in each case.
pub fn charges(
    domain: &Domain,
    electrodes: &[DomainElectrode],
    state: State<'_>,
    voltages: impl Fn(usize, usize) -> f64,
) -> Vec<RowVector6<f64>> {
    let mut forces = SectionForces::none(domain);
    forces.measure_in(domain, state, Some(&cells_at(domain, electrodes)));
    let within = &forces.within;
    let of_electrode = |(number, electrode): (usize, &DomainElectrode)| {
        let mut charge = RowVector6::zeros();
        for &node in &electrode.nodes {
            if let Some(unknown) = domain.potential_unknown(node as usize) {
                charge -= within.fixed_view::<1, 6>(unknown, 0);
            }
        }
        each_fingered(domain, electrode, |cell, fingered, point| {
            let volume = point.area * domain.line.metric(point.y, point.z).volume;
            let warping = state.warping.map(|field| columns_of(cell, field));
            let strain = strain_at(&domain.line, point, None, warping.as_ref(), state.strain);
            charge += volume * fingered.stress.transpose() * strain;
            for case in 0..6 {
                charge[case] += volume * fingered.charge * voltages(number, case);
            }
        });
        charge
    };
    electrodes.iter().enumerate().map(of_electrode).collect()
}

/// Six columns of a field at the nodes of a cell.
fn columns_of(cell: &DomainCell, field: &DMatrix<f64>) -> NodalColumns {
    let mut rows = NO_FIELD;
    take_columns(cell, field, &mut rows);
    let mut columns = NO_COLUMNS;
    for (columns, rows) in columns.iter_mut().zip(&rows) {
        *columns = nalgebra::Matrix3x6::from_fn(|axis, case| rows[axis][case]);
    }
    columns
}
