//! Small dense residual and Jacobian of one element.

use nalgebra::{DMatrix, Matrix3, RowVector3, Vector3};

use super::Element;
use crate::model::{Equation, NODE_UNKNOWNS, Variable};

mod removal;

/// Numbers of nodes, multipliers and scalars of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct LocalSize {
    /// Nodes.
    pub nodes: usize,
    /// Multipliers.
    pub multipliers: usize,
    /// Scalars.
    pub scalars: usize,
}

impl LocalSize {
    /// The size of `element`.
    pub fn of<E: Element + ?Sized>(element: &E) -> Self {
        Self {
            nodes: element.nodes().len(),
            multipliers: element.constraints().map_or(0, |own| own.count()),
            scalars: element.scalars().len(),
        }
    }

    /// The size of an element of `nodes` nodes and `multipliers` multipliers, without scalars.
    pub fn without_scalars(nodes: usize, multipliers: usize) -> Self {
        Self {
            nodes,
            multipliers,
            scalars: 0,
        }
    }

    /// Number of rows: twelve per node, one per constraint, and one per scalar.
    pub fn rows(self) -> usize {
        self.scalar(self.scalars)
    }

    /// Row of a multiplier.
    fn multiplier(self, index: usize) -> usize {
        NODE_UNKNOWNS * self.nodes + index
    }

    /// Row of a scalar.
    fn scalar(self, index: usize) -> usize {
        self.multiplier(self.multipliers) + index
    }
}

/// Residual of one element: twelve rows per node, then one per constraint, then one per scalar.
#[derive(Debug, Clone)]
pub struct LocalResidual {
    size: LocalSize,
    values: Vec<f64>,
    sizes: Vec<f64>,
}

impl LocalResidual {
    /// A residual of zeros for an element of the given size.
    pub fn new(size: LocalSize) -> Self {
        Self {
            size,
            values: vec![0.0; size.rows()],
            sizes: vec![0.0; size.rows()],
        }
    }

    /// A residual that ignores all terms.
    pub fn ignored() -> Self {
        Self {
            size: LocalSize::default(),
            values: Vec::new(),
            sizes: Vec::new(),
        }
    }

    /// Whether it ignores all terms.
    pub fn is_ignored(&self) -> bool {
        self.values.is_empty()
    }

    /// Adds to a vector equation of a node.
    pub fn add(&mut self, node: usize, equation: Equation, value: &Vector3<f64>) {
        if self.is_ignored() {
            return;
        }
        let row = NODE_UNKNOWNS * node + equation.row();
        let sums = self.values[row..row + 3].iter_mut();
        let sizes = self.sizes[row..row + 3].iter_mut();
        for ((sum, size), value) in sums.zip(sizes).zip(value.as_slice()) {
            *sum += value;
            *size += value.abs();
        }
    }

    /// Adds to a constraint equation of the element.
    pub fn add_constraint(&mut self, constraint: usize, value: f64) {
        self.add_at(self.size.multiplier(constraint), value);
    }

    /// Adds to the equation of a scalar.
    pub fn add_scalar(&mut self, scalar: usize, value: f64) {
        self.add_at(self.size.scalar(scalar), value);
    }

    /// Adds to the equation of a scalar a sum whose terms have the absolute values `terms` together.
    pub fn add_scalar_sum(&mut self, scalar: usize, value: f64, terms: f64) {
        let row = self.size.scalar(scalar);
        self.add_at(row, value);
        if let Some(size) = self.sizes.get_mut(row) {
            *size += terms;
        }
    }

    fn add_at(&mut self, row: usize, value: f64) {
        if self.values.is_empty() {
            return;
        }
        self.values[row] += value;
        self.sizes[row] += value.abs();
    }

    /// Sets it to zero.
    pub fn clear(&mut self) {
        self.values.fill(0.0);
        self.sizes.fill(0.0);
    }

    /// A vector equation of a node.
    pub fn of(&self, node: usize, equation: Equation) -> Vector3<f64> {
        let row = NODE_UNKNOWNS * node + equation.row();
        Vector3::from_column_slice(&self.values[row..row + 3])
    }

    /// The residual [unit of each equation].
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Sum of the absolute values of the terms of each equation: the reference of a residual [unit
    /// of each equation].
    pub fn sizes(&self) -> &[f64] {
        &self.sizes
    }
}

/// Consecutive entries in a column of a local Jacobian.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LocalRun {
    /// First entry, column by column.
    pub first: u32,
    /// Number of entries.
    pub count: u32,
}

impl LocalRun {
    /// The entries, column by column.
    pub fn range(self) -> std::ops::Range<usize> {
        let first = self.first as usize;
        first..first + self.count as usize
    }
}

/// Jacobian of one element, by the unknowns and by their rates.
///
/// Rows as in [`LocalResidual`]; columns: twelve per node, then the multipliers, then the scalars.
#[derive(Debug, Clone)]
pub struct LocalJacobian {
    size: LocalSize,
    by_unknowns: DMatrix<f64>,
    by_rates: DMatrix<f64>,
    /// Empty if the pattern is known already.
    touched: DMatrix<bool>,
    touches_rates: bool,
}

impl LocalJacobian {
    /// A Jacobian of zeros for an element of the given size.
    pub fn new(size: LocalSize) -> Self {
        let n = size.rows();
        Self {
            touched: DMatrix::from_element(n, n, false),
            ..Self::unmarked(size)
        }
    }

    /// As [`Self::new`], without recording touched entries.
    pub fn unmarked(size: LocalSize) -> Self {
        let n = size.rows();
        Self {
            size,
            by_unknowns: DMatrix::zeros(n, n),
            by_rates: DMatrix::zeros(n, n),
            touched: DMatrix::from_element(0, 0, false),
            touches_rates: false,
        }
    }

    /// Sets the given entries to zero, among them all that are ever touched.
    pub fn clear(&mut self, touched: &[LocalRun]) {
        let clear = |matrix: &mut DMatrix<f64>| {
            let values = matrix.as_mut_slice();
            for run in touched {
                values[run.range()].fill(0.0);
            }
        };
        clear(&mut self.by_unknowns);
        if self.touches_rates {
            clear(&mut self.by_rates);
        }
        self.touches_rates = false;
    }

    /// Adds `d equation / d variable`: rows of `row.0`, columns of `column.0`.
    pub fn add(&mut self, row: (usize, Equation), column: (usize, Variable), block: &Matrix3<f64>) {
        let first_row = NODE_UNKNOWNS * row.0 + row.1.row();
        let first_column = NODE_UNKNOWNS * column.0 + column.1.column();
        let rate = column.1.is_rate();
        let n = self.by_unknowns.nrows();
        let first = first_row + n * first_column;
        if !self.touched.is_empty() {
            for column in self.touched.as_mut_slice()[first..].chunks_mut(n).take(3) {
                column[..3].fill(true);
            }
        }
        self.touches_rates |= rate;
        let sums = if rate {
            self.by_rates.as_mut_slice()
        } else {
            self.by_unknowns.as_mut_slice()
        };
        let sums = &mut sums[first..first + 2 * n + 3];
        for j in 0..3 {
            let column = &mut sums[n * j..n * j + 3];
            for i in 0..3 {
                column[i] += block[(i, j)];
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
        let index = self.size.multiplier(multiplier);
        self.add_column((first_row, index), column.as_slice(), false);
    }

    /// Adds `d constraint / d variable`.
    pub fn add_constraint(
        &mut self,
        constraint: usize,
        column: (usize, Variable),
        row: &RowVector3<f64>,
    ) {
        self.add_row(self.size.multiplier(constraint), column, row);
    }

    /// Adds `d equation / d scalar`, or the derivative by the scalar's rate if `scalar.1` is set.
    pub fn add_by_scalar(
        &mut self,
        row: (usize, Equation),
        (scalar, rate): (usize, bool),
        column: &Vector3<f64>,
    ) {
        let first_row = NODE_UNKNOWNS * row.0 + row.1.row();
        let index = self.size.scalar(scalar);
        self.add_column((first_row, index), column.as_slice(), rate);
    }

    /// Adds `d constraint / d scalar`.
    pub fn add_constraint_by_scalar(&mut self, constraint: usize, scalar: usize, value: f64) {
        let row = self.size.multiplier(constraint);
        self.add_column((row, self.size.scalar(scalar)), &[value], false);
    }

    /// Adds `d scalar equation / d variable`.
    pub fn add_scalar_row(
        &mut self,
        scalar: usize,
        column: (usize, Variable),
        row: &RowVector3<f64>,
    ) {
        self.add_row(self.size.scalar(scalar), column, row);
    }

    /// Adds `d scalar equation / d variable` for at most three scalars, a row of `rows` for each.
    pub fn add_scalar_rows(
        &mut self,
        scalars: &[usize],
        column: (usize, Variable),
        rows: &Matrix3<f64>,
    ) {
        let n = self.by_unknowns.nrows();
        let first = n * (NODE_UNKNOWNS * column.0 + column.1.column());
        let rate = column.1.is_rate();
        self.touches_rates |= rate;
        let sums = if rate {
            self.by_rates.as_mut_slice()
        } else {
            self.by_unknowns.as_mut_slice()
        };
        for j in 0..3 {
            for (i, scalar) in scalars.iter().enumerate() {
                let index = first + n * j + self.size.scalar(*scalar);
                sums[index] += rows[(i, j)];
                if !self.touched.is_empty() {
                    self.touched.as_mut_slice()[index] = true;
                }
            }
        }
    }

    /// Adds `d scalar equation / d scalar`, or the derivative by the scalar's rate.
    pub fn add_scalar(&mut self, row: usize, column: usize, value: f64, rate: bool) {
        let index = (self.size.scalar(row), self.size.scalar(column));
        self.add_column(index, &[value], rate);
    }

    /// Adds a direction times the present rows of an equation of a node to the row of a scalar.
    pub fn add_equation_to_scalar(
        &mut self,
        scalar: usize,
        (node, equation): (usize, Equation),
        along: &Vector3<f64>,
    ) {
        let row = self.size.scalar(scalar);
        let first = NODE_UNKNOWNS * node + equation.row();
        for i in 0..3 {
            for column in 0..self.by_unknowns.ncols() {
                let from = (first + i, column);
                let is_known = self.touched.is_empty();
                if !is_known && !self.touched[from] {
                    continue;
                }
                self.by_unknowns[(row, column)] += along[i] * self.by_unknowns[from];
                self.by_rates[(row, column)] += along[i] * self.by_rates[from];
                if !is_known {
                    self.touched[(row, column)] = true;
                }
            }
        }
    }

    /// Adds to a row in the columns of a vector variable.
    fn add_row(&mut self, index: usize, column: (usize, Variable), row: &RowVector3<f64>) {
        let first_column = NODE_UNKNOWNS * column.0 + column.1.column();
        for j in 0..3 {
            self.add_column((index, first_column + j), &[row[j]], column.1.is_rate());
        }
    }

    /// Adds the difference of two Jacobians of one element.
    pub fn add_difference(&mut self, later: &Self, before: &Self) {
        self.by_unknowns += &later.by_unknowns - &before.by_unknowns;
        self.by_rates += &later.by_rates - &before.by_rates;
        self.touches_rates |= later.touches_rates;
        if self.touched.shape() == later.touched.shape() {
            self.touched
                .zip_apply(&later.touched, |touched, other| *touched |= other);
        }
    }

    /// Adds to consecutive entries in a column, from `index` on.
    fn add_column(&mut self, index: (usize, usize), values: &[f64], rate: bool) {
        let n = self.by_unknowns.nrows();
        let first = index.0 + n * index.1;
        let range = first..first + values.len();
        if !self.touched.is_empty() {
            self.touched.as_mut_slice()[range.clone()].fill(true);
        }
        self.touches_rates |= rate;
        let matrix = if rate {
            &mut self.by_rates
        } else {
            &mut self.by_unknowns
        };
        let sums = matrix.as_mut_slice()[range].iter_mut();
        sums.zip(values).for_each(|(sum, value)| *sum += value);
    }

    /// Converts the derivatives by a vector of a node and by its rate into derivatives by u and u',
    /// with `theta = turn du`, `d omega = turn du' + rate_by_turn du` for a rotation; `touched` are
    /// the entries in the first of these columns, next to which are the other columns' entries.
    pub fn turn(
        &mut self,
        (node, vector): (usize, Variable),
        touched: &[LocalRun],
        [turn, rate_by_turn]: &[Matrix3<f64>; 2],
    ) {
        let n = self.by_unknowns.nrows();
        let first = n * (NODE_UNKNOWNS * node + vector.column());
        let still = *turn == Matrix3::identity();
        let theta = self.by_unknowns.as_mut_slice();
        if !still {
            map_columns(&mut theta[first..first + 3 * n], touched, first, turn);
        }
        if self.touches_rates {
            let omega = &mut self.by_rates.as_mut_slice()[first..first + 3 * n];
            add_mapped(
                &mut theta[first..first + 3 * n],
                omega,
                (touched, first),
                rate_by_turn,
            );
            if !still {
                map_columns(omega, touched, first, turn);
            }
        }
    }

    /// The size of the element.
    pub fn size(&self) -> LocalSize {
        self.size
    }

    /// Derivatives by the unknowns.
    pub fn by_unknowns(&self) -> &DMatrix<f64> {
        &self.by_unknowns
    }

    /// Derivatives by the rates of the unknowns.
    pub fn by_rates(&self) -> &DMatrix<f64> {
        &self.by_rates
    }

    /// Whether a term was added to the derivatives by rates.
    pub fn touches_rates(&self) -> bool {
        self.touches_rates
    }

    /// Entries to which a term was ever added.
    pub fn touched(&self) -> &DMatrix<bool> {
        &self.touched
    }
}

/// `A <- A M` in the rows of `touched`, where A has three columns from entry `first` on.
fn map_columns(a: &mut [f64], touched: &[LocalRun], first: usize, m: &Matrix3<f64>) {
    let n = a.len() / 3;
    for i in rows(touched, first) {
        [a[i], a[n + i], a[2 * n + i]] = times([a[i], a[n + i], a[2 * n + i]], m);
    }
}

/// `B <- B + A M` in the rows of `touched`, where both have three columns from entry `first` on.
fn add_mapped(b: &mut [f64], a: &[f64], (touched, first): (&[LocalRun], usize), m: &Matrix3<f64>) {
    let n = a.len() / 3;
    for i in rows(touched, first) {
        let row = times([a[i], a[n + i], a[2 * n + i]], m);
        for k in 0..3 {
            b[n * k + i] += row[k];
        }
    }
}

/// The row `a M`.
#[inline]
fn times(a: [f64; 3], m: &Matrix3<f64>) -> [f64; 3] {
    let entry = |column: &[f64; 3]| a[0] * column[0] + a[1] * column[1] + a[2] * column[2];
    let [first, second, third] = &m.data.0;
    [entry(first), entry(second), entry(third)]
}

/// Rows of entries in a column that begins at entry `first`.
fn rows(touched: &[LocalRun], first: usize) -> impl Iterator<Item = usize> + '_ {
    let ranges = touched.iter().map(|run| run.range());
    ranges.flat_map(move |range| range.start - first..range.end - first)
}
