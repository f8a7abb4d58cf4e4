//! The states that changes of a section work on, and what they do in a cell.

use super::Solved;
use crate::assembly::{Domain, DomainCell, take_columns};
use crate::element::{
    CellPoint, CellState, NO_COLUMNS, NO_ROWS, NodalColumns, NodalState, Product, Row, cell_points,
    rows_of, strain_along, strain_in_cases,
};
use crate::solve::DualStates;
use nalgebra::{DMatrix, Matrix6};

/// A state of the whole section.
pub(super) struct Field {
    pub rate: DMatrix<f64>,
    pub warping: DMatrix<f64>,
    pub psi: Matrix6<f64>,
}

/// The central state w, then the dual states e.
pub(super) struct Fields {
    pub states: Vec<Field>,
    /// c of the dual states.
    pub weights: Vec<Matrix6<f64>>,
    /// T'.
    pub along: Matrix6<f64>,
}

impl Fields {
    pub fn of(solved: Solved<'_>, duals: DualStates) -> Self {
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

    /// Each state at the nodes of `cell`.
    pub fn at_nodes(&self, cell: &DomainCell) -> Vec<AtNodes> {
        let states = self.states.iter();
        let at_nodes = states.map(|field| AtNodes {
            rate: at_nodes(cell, &field.rate),
            warping: at_nodes(cell, &field.warping),
            psi: field.psi,
        });
        at_nodes.collect()
    }
}

/// A state at the nodes of a cell.
pub(super) struct AtNodes {
    rate: NodalColumns,
    warping: NodalColumns,
    psi: Matrix6<f64>,
}

impl AtNodes {
    pub fn state(&self) -> NodalState<'_> {
        NodalState {
            rate: &self.rate,
            warping: &self.warping,
            psi: &self.psi,
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

/// The strains of all states at the points of a cell; goes from cell to cell.
pub(super) struct Strains<'a> {
    domain: &'a Domain,
    fields: &'a Fields,
    psi: Vec<[Row; 6]>,
    at_nodes: CellState,
    points: Vec<CellPoint>,
    /// By point, then by state.
    strains: Vec<[Row; 6]>,
}

impl<'a> Strains<'a> {
    pub fn new(domain: &'a Domain, fields: &'a Fields) -> Self {
        Self {
            domain,
            fields,
            psi: fields.states.iter().map(|of| rows_of(&of.psi)).collect(),
            at_nodes: CellState::NONE,
            points: Vec::new(),
            strains: Vec::new(),
        }
    }

    /// Goes to `cell`.
    #[inline(always)]
    pub fn go_to<P: Product>(&mut self, cell: &DomainCell) {
        let states = self.fields.states.len();
        let places = self.domain.places(cell);
        let points = cell_points(cell.kind, &places[..cell.kind.node_count()]);
        self.points.clear();
        self.points.extend(points);
        self.strains.resize(states * self.points.len(), NO_ROWS);
        let line = &self.domain.line;
        for (k, (field, psi)) in self.fields.states.iter().zip(&self.psi).enumerate() {
            take_columns(cell, &field.rate, &mut self.at_nodes.rate);
            take_columns(cell, &field.warping, &mut self.at_nodes.warping);
            let difference = self.at_nodes.differences();
            let strains = self.strains[k..].iter_mut().step_by(states);
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

    /// Volume of each point of the cell, and the strains of all states there.
    #[inline(always)]
    pub fn points(&self) -> impl Iterator<Item = (f64, &[[Row; 6]])> {
        let volumes = self.points.iter().map(|point| {
            let metric = self.domain.line.metric(point.y, point.z);
            point.area * metric.volume
        });
        volumes.zip(self.strains.chunks_exact(self.fields.states.len()))
    }
}
