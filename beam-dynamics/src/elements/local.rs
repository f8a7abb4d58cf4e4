//! Small dense residual and Jacobian of one element.

use nalgebra::{DMatrix, Matrix3, RowVector3, Vector3};

use crate::model::{Equation, NODE_UNKNOWNS, Variable};

mod removal;

/// Residual of one element: twelve rows a node, then one a constraint.
#[derive(Debug, Clone)]
pub struct LocalResidual {
    nodes: usize,
    values: Vec<f64>,
    sizes: Vec<f64>,
}

impl LocalResidual {
    /// Zero, for an element of `nodes` nodes and `multipliers` constraints.
    pub fn new(nodes: usize, multipliers: usize) -> Self {
        let rows = NODE_UNKNOWNS * nodes + multipliers;
        Self {
            nodes,
            values: vec![0.0; rows],
            sizes: vec![0.0; rows],
        }
    }

    /// Adds to a vector equation of a node.
    pub fn add(&mut self, node: usize, equation: Equation, value: &Vector3<f64>) {
        let row = NODE_UNKNOWNS * node + equation.row();
        for i in 0..3 {
            self.add_at(row + i, value[i]);
        }
    }

    /// Adds to a constraint equation of the element.
    pub fn add_constraint(&mut self, constraint: usize, value: f64) {
        self.add_at(NODE_UNKNOWNS * self.nodes + constraint, value);
    }

    fn add_at(&mut self, row: usize, value: f64) {
        self.values[row] += value;
        self.sizes[row] += value.abs();
    }

    /// The residual [unit of each equation].
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Sum of the absolute values of the terms of each equation: what a residual
    /// must be small against [unit of each equation].
    pub fn sizes(&self) -> &[f64] {
        &self.sizes
    }
}

/// Jacobian of one element, by the unknowns and by their rates.
///
/// Rows as in [`LocalResidual`]; columns: twelve a node, then the multipliers.
#[derive(Debug, Clone)]
pub struct LocalJacobian {
    nodes: usize,
    by_unknowns: DMatrix<f64>,
    by_rates: DMatrix<f64>,
    touched: DMatrix<bool>,
}

impl LocalJacobian {
    /// Zero, for an element of `nodes` nodes and `multipliers` constraints.
    pub fn new(nodes: usize, multipliers: usize) -> Self {
        let n = NODE_UNKNOWNS * nodes + multipliers;
        Self {
            nodes,
            by_unknowns: DMatrix::zeros(n, n),
            by_rates: DMatrix::zeros(n, n),
            touched: DMatrix::from_element(n, n, false),
        }
    }

    /// Adds `d equation / d variable`: rows of `row.0`, columns of `column.0`.
    pub fn add(&mut self, row: (usize, Equation), column: (usize, Variable), block: &Matrix3<f64>) {
        let first_row = NODE_UNKNOWNS * row.0 + row.1.row();
        let first_column = NODE_UNKNOWNS * column.0 + column.1.column();
        for j in 0..3 {
            for i in 0..3 {
                let place = (first_row + i, first_column + j);
                self.add_at(place, block[(i, j)], column.1.is_rate());
            }
        }
    }

    /// Adds `d equation / d multiplier`.
    pub fn add_multiplier(
        &mut self,
        row: (usize, Equation),
        multiplier: usize,
        column: &Vector3<f64>,
    ) {
        let first_row = NODE_UNKNOWNS * row.0 + row.1.row();
        let place = NODE_UNKNOWNS * self.nodes + multiplier;
        for i in 0..3 {
            self.add_at((first_row + i, place), column[i], false);
        }
    }

    /// Adds `d constraint / d variable`.
    pub fn add_constraint(
        &mut self,
        constraint: usize,
        column: (usize, Variable),
        row: &RowVector3<f64>,
    ) {
        let place = NODE_UNKNOWNS * self.nodes + constraint;
        let first_column = NODE_UNKNOWNS * column.0 + column.1.column();
        for j in 0..3 {
            self.add_at((place, first_column + j), row[j], column.1.is_rate());
        }
    }

    /// Adds the difference of two Jacobians of one element.
    pub fn add_difference(&mut self, later: &Self, before: &Self) {
        self.by_unknowns += &later.by_unknowns - &before.by_unknowns;
        self.by_rates += &later.by_rates - &before.by_rates;
        self.touched
            .zip_apply(&later.touched, |touched, other| *touched |= other);
    }

    fn add_at(&mut self, place: (usize, usize), value: f64, rate: bool) {
        self.touched[place] = true;
        if rate {
            self.by_rates[place] += value;
        } else {
            self.by_unknowns[place] += value;
        }
    }

    /// Derivatives by the unknowns.
    pub fn by_unknowns(&self) -> &DMatrix<f64> {
        &self.by_unknowns
    }

    /// Derivatives by the rates of the unknowns.
    pub fn by_rates(&self) -> &DMatrix<f64> {
        &self.by_rates
    }

    /// Entries to which something was ever added.
    pub fn touched(&self) -> &DMatrix<bool> {
        &self.touched
    }
}
