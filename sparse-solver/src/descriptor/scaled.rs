//! A descriptor system in scaled rows, columns, inputs and time.

use faer::{Mat, c64};

use super::graded::graded_eigenvalues;
use super::system::{Descriptor, DescriptorState, Minimal, NotMinimal};

/// Sweeps over rows and columns, each of which brings their largest entries nearer to one.
const SWEEPS: usize = 8;

/// The system with entries of the size of one.
pub(super) struct Scaled {
    pub by_rates: Mat<f64>,
    pub by_unknowns: Mat<f64>,
    pub by_inputs: Mat<f64>,
    /// Value of an unknown per scaled one.
    columns: Vec<f64>,
    /// Value of an input per scaled one.
    inputs: Vec<f64>,
    /// Rate per scaled one [1/s].
    rate: f64,
}

/// The nearest power of two, so that scales add no round-off.
fn power_of_two(value: f64) -> f64 {
    value.log2().round().exp2()
}

impl Scaled {
    /// The `system` in time of the given `rate` \[1/s\].
    pub fn new(system: &Descriptor, rate: f64) -> Result<Self, NotMinimal> {
        let n = system.by_unknowns.nrows();
        let rate = power_of_two(rate);
        let all = [&system.by_rates, &system.by_unknowns, &system.by_inputs];
        if !rate.is_finite() || all.iter().any(|matrix| !matrix.as_ref().is_all_finite()) {
            return Err(NotMinimal::NotFinite);
        }
        let size = Mat::from_fn(n, n, |i, j| {
            system.by_unknowns[(i, j)].abs() + rate * system.by_rates[(i, j)].abs()
        });
        let [rows, columns] = scales(&size)?;
        let scale = |matrix: &Mat<f64>, factor: f64| {
            Mat::from_fn(n, n, |i, j| factor * rows[i] * matrix[(i, j)] * columns[j])
        };
        let of_input = |k: usize| {
            let entries = (0..n).map(|i| (rows[i] * system.by_inputs[(i, k)]).abs());
            match entries.fold(0.0, f64::max) {
                largest if largest > 0.0 => power_of_two(1.0 / largest),
                _ => 1.0,
            }
        };
        let inputs: Vec<_> = (0..system.by_inputs.ncols()).map(of_input).collect();
        Ok(Self {
            by_rates: scale(&system.by_rates, rate),
            by_unknowns: scale(&system.by_unknowns, 1.0),
            by_inputs: Mat::from_fn(n, inputs.len(), |i, k| {
                rows[i] * system.by_inputs[(i, k)] * inputs[k]
            }),
            columns,
            inputs,
            rate,
        })
    }

    /// The largest remainder of an equation for the motions of a minimal form, relative to its
    /// terms: of `E X A + K X` and of `E X B + K Y + F`, with the unknowns X by the states and Y by
    /// the inputs.
    pub fn residual(&self, [x, y]: [&Mat<f64>; 2], [a, b]: [&Mat<f64>; 2]) -> f64 {
        let (e, k) = (&self.by_rates, &self.by_unknowns);
        let none = Mat::zeros(x.nrows(), x.ncols());
        let of_states = worst([(e, &(x * a)), (k, x)], &none);
        of_states.max(worst([(e, &(x * b)), (k, y)], &self.by_inputs))
    }

    /// A minimal form of the scaled system in the units of the system.
    pub fn unscaled(
        &self,
        states: Vec<DescriptorState>,
        [a, b]: [&Mat<f64>; 2],
        [x, y]: [&Mat<f64>; 2],
        residual: f64,
    ) -> Minimal {
        let of_state = |j: usize| self.columns[states[j].unknown];
        let (n, r, m) = (x.nrows(), states.len(), self.inputs.len());
        let columns = &self.columns;
        Minimal {
            a: Mat::from_fn(r, r, |i, j| {
                self.rate * of_state(i) * a[(i, j)] / of_state(j)
            }),
            b: Mat::from_fn(r, m, |i, k| {
                self.rate * of_state(i) * b[(i, k)] / self.inputs[k]
            }),
            eigenvalues: self.eigenvalues(a),
            by_states: Mat::from_fn(n, r, |i, j| columns[i] * x[(i, j)] / of_state(j)),
            by_inputs: Mat::from_fn(n, m, |i, k| columns[i] * y[(i, k)] / self.inputs[k]),
            states,
            residual,
        }
    }
}

impl Scaled {
    /// Eigenvalues of the scaled A by ascending size, in the time of the system.
    fn eigenvalues(&self, a: &Mat<f64>) -> Vec<c64> {
        let scaled = graded_eigenvalues(a).into_iter();
        scaled.map(|own| own * self.rate).collect()
    }
}

/// Scales of rows and columns that bring their largest entries to the size of one.
fn scales(size: &Mat<f64>) -> Result<[Vec<f64>; 2], NotMinimal> {
    let n = size.nrows();
    let (mut rows, mut columns) = (vec![1.0; n], vec![1.0; n]);
    for _ in 0..SWEEPS {
        let (mut of_rows, mut of_columns) = (vec![0.0_f64; n], vec![0.0_f64; n]);
        for j in 0..n {
            for i in 0..n {
                let entry = rows[i] * size[(i, j)] * columns[j];
                of_rows[i] = of_rows[i].max(entry);
                of_columns[j] = of_columns[j].max(entry);
            }
        }
        let empty = of_rows.iter().zip(&of_columns);
        let mut empty = empty.map(|(row, column)| *row == 0.0 || *column == 0.0);
        if let Some(index) = empty.position(|is_empty| is_empty) {
            return Err(NotMinimal::Undetermined(index));
        }
        for i in 0..n {
            rows[i] /= of_rows[i].sqrt();
            columns[i] /= of_columns[i].sqrt();
        }
    }
    Ok([rows, columns].map(|scales| scales.into_iter().map(power_of_two).collect()))
}

/// The largest entry of the sum of products and `plus` in a column, relative to the terms of the
/// column: the left factors have rows and columns of the size of one.
fn worst(products: [(&Mat<f64>, &Mat<f64>); 2], plus: &Mat<f64>) -> f64 {
    let largest = |matrix: &Mat<f64>, column: usize| {
        let entries = (0..matrix.nrows()).map(|i| matrix[(i, column)].abs());
        entries.fold(0.0, larger)
    };
    let mut sum = plus.clone();
    products
        .iter()
        .for_each(|(left, right)| sum += *left * *right);
    let part = |j: usize| {
        let terms = products.iter().map(|(_, right)| largest(right, j));
        let terms = terms.fold(largest(plus, j), |a, b| a + b);
        match largest(&sum, j) {
            0.0 => 0.0,
            rest => rest / terms,
        }
    };
    (0..plus.ncols()).map(part).fold(0.0, larger)
}

/// The larger of two numbers; NaN is larger than all.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}
