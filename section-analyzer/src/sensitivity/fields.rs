//! The central and dual states of a section, and their strains in a cell.

use super::Solved;
use crate::assembly::{Domain, DomainCell, take_columns};
use crate::element::{
    CASES, CellPoint, CellState, NO_COLUMNS, NO_ROWS, NodalColumns, NodalState, Product, Row,
    cell_points, rows_of, strain_along, strain_in_cases,
};
use crate::solve::{DualState, DualStates};
use nalgebra::{DMatrix, Matrix6};

/// Up to [`CASES`] cases of states of the whole section.
struct Field {
    rate: DMatrix<f64>,
    warping: DMatrix<f64>,
    psi: [Row; 6],
}

impl Field {
    fn none(unknowns: usize) -> Self {
        Self {
            rate: DMatrix::zeros(unknowns, CASES),
            warping: DMatrix::zeros(unknowns, CASES),
            psi: NO_ROWS,
        }
    }

    fn set(&mut self, lane: usize, dual: &DualState, column: usize) {
        self.rate.set_column(lane, &dual.rate.column(column));
        self.warping.set_column(lane, &dual.x.column(column));
        for (row, value) in self.psi.iter_mut().zip(&dual.y.column(column)) {
            row[lane] = *value;
        }
    }
}

/// Location of a case: its field and its index there.
pub(super) type Lane = (usize, usize);

/// The central state w, then the dual states e.
pub(super) struct Fields {
    /// The central state, then the cases of the dual states, packed to fill registers.
    fields: Vec<Field>,
    /// c of each dual state, and the locations of its solved cases.
    duals: Vec<(Matrix6<f64>, [Option<Lane>; 6])>,
    /// T'.
    pub along: Matrix6<f64>,
}

impl Fields {
    pub fn of(solved: Solved<'_>, duals: DualStates) -> Self {
        let central = solved.central;
        let along = solved.domain.line.equilibrium();
        let mut fields = Self {
            fields: vec![Field {
                rate: turned(&central.x, &along),
                warping: central.x.clone(),
                psi: rows_of(&central.y),
            }],
            duals: Vec::new(),
            along,
        };
        let mut count = 0;
        for dual in duals.states {
            let mut lanes = [None; 6];
            for column in dual.columns.clone() {
                let lane = (1 + count / CASES, count % CASES);
                if lane.0 == fields.fields.len() {
                    fields.fields.push(Field::none(solved.domain.unknowns()));
                }
                fields.fields[lane.0].set(lane.1, &dual, column);
                lanes[column] = Some(lane);
                count += 1;
            }
            fields.duals.push((dual.weight, lanes));
        }
        fields
    }

    /// Number of fields.
    pub fn count(&self) -> usize {
        self.fields.len()
    }

    /// c of each dual state with the locations of its cases.
    pub fn duals(&self) -> &[(Matrix6<f64>, [Option<Lane>; 6])] {
        &self.duals
    }

    /// The central and each dual state at the nodes of `cell`.
    pub fn at_nodes(&self, cell: &DomainCell) -> Vec<AtNodes> {
        let duals = self.duals.iter().map(|(_, lanes)| *lanes);
        let states = std::iter::once(CENTRAL).chain(duals);
        let at_nodes = states.map(|lanes| AtNodes::new(&self.fields, lanes, cell));
        at_nodes.collect()
    }
}

/// Locations of the cases of the central state.
const CENTRAL: [Option<Lane>; 6] = [
    Some((0, 0)),
    Some((0, 1)),
    Some((0, 2)),
    Some((0, 3)),
    Some((0, 4)),
    Some((0, 5)),
];

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

/// A state at the nodes of a cell.
pub(super) struct AtNodes {
    /// Locations of its cases.
    pub lanes: [Option<Lane>; 6],
    rate: NodalColumns,
    warping: NodalColumns,
    psi: Matrix6<f64>,
}

impl AtNodes {
    fn new(fields: &[Field], lanes: [Option<Lane>; 6], cell: &DomainCell) -> Self {
        let mut of_cell = Self {
            lanes,
            rate: NO_COLUMNS,
            warping: NO_COLUMNS,
            psi: Matrix6::zeros(),
        };
        for (column, lane) in lanes.into_iter().enumerate() {
            let Some((field, lane)) = lane else { continue };
            let Field { rate, warping, psi } = &fields[field];
            for (i, &node) in cell.nodes().iter().enumerate() {
                let at = (3 * node as usize, lane);
                let take = |from: &DMatrix<f64>| from.fixed_view::<3, 1>(at.0, at.1).into_owned();
                of_cell.rate[i].set_column(column, &take(rate));
                of_cell.warping[i].set_column(column, &take(warping));
            }
            for (i, row) in psi.iter().enumerate() {
                of_cell.psi[(i, column)] = row[lane];
            }
        }
        of_cell
    }

    pub fn state(&self) -> NodalState<'_> {
        NodalState {
            rate: &self.rate,
            warping: &self.warping,
            psi: &self.psi,
        }
    }
}

/// The strains of all fields at the points of a cell; reused for each cell.
pub(super) struct Strains<'a> {
    domain: &'a Domain,
    fields: &'a Fields,
    at_nodes: CellState,
    points: Vec<CellPoint>,
    /// By point, then by field.
    strains: Vec<[Row; 6]>,
}

impl<'a> Strains<'a> {
    pub fn new(domain: &'a Domain, fields: &'a Fields) -> Self {
        Self {
            domain,
            fields,
            at_nodes: CellState::NONE,
            points: Vec::new(),
            strains: Vec::new(),
        }
    }

    /// Moves to `cell`.
    #[inline(always)]
    pub fn go_to<P: Product>(&mut self, cell: &DomainCell) {
        let count = self.fields.count();
        let positions = self.domain.positions(cell);
        let points = cell_points(cell.kind, &positions[..cell.kind.node_count()]);
        self.points.clear();
        self.points.extend(points);
        self.strains.resize(count * self.points.len(), NO_ROWS);
        let line = &self.domain.line;
        for (k, field) in self.fields.fields.iter().enumerate() {
            let psi = &field.psi;
            take_columns(cell, &field.rate, &mut self.at_nodes.rate);
            take_columns(cell, &field.warping, &mut self.at_nodes.warping);
            let difference = self.at_nodes.differences();
            let strains = self.strains[k..].iter_mut().step_by(count);
            for (strain, point) in strains.zip(&self.points) {
                *strain = if line.is_straight() {
                    strain_in_cases::<P>(point, &self.at_nodes.rate, &difference, psi)
                } else {
                    let metric = line.metric(point.y, point.z);
                    let at = (line, &metric);
                    strain_along::<P>(at, point, &self.at_nodes, &difference, psi)
                };
            }
        }
    }

    /// Volume of each point of the cell, and the strains of all fields there.
    #[inline(always)]
    pub fn points(&self) -> impl Iterator<Item = (f64, &[[Row; 6]])> {
        let volumes = self.points.iter().map(|point| {
            let metric = self.domain.line.metric(point.y, point.z);
            point.area * metric.volume
        });
        volumes.zip(self.strains.chunks_exact(self.fields.count()))
    }
}
