//! A linear system of states: filter, actuator or control law.
//!
//! With the inputs u, signals of time and of any scalars, the states x and the outputs y,
//!
//! ```text
//! x' - A x - B u = 0
//! y  - C x - D u = 0                                                           (D-275)
//! ```
//!
//! A transfer function is taken in its observer form: from
//! `y = ( b_n s^n + ... + b_0 ) / ( s^n + a_{n-1} s^{n-1} + ... + a_0 ) u` with `d = b_n`,
//!
//! ```text
//! x_i' = -a_{n-i} x_1 + x_{i+1} + ( b_{n-i} - a_{n-i} d ) u ,    y = x_1 + d u  (D-276)
//! ```
//!
//! each state divided by a power of the mean corner frequency `sqrt[n]( |a_0| )`, so that all are
//! of similar size.

use nalgebra::DMatrix;

use super::inputs::Inputs;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual, Signal};
use crate::model::{Quantity, Scalar, ScalarSpec, ScalarStart};

/// The matrices of a linear system.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrices {
    /// States x states [1/s].
    pub a: DMatrix<f64>,
    /// States x inputs [1/s].
    pub b: DMatrix<f64>,
    /// Outputs x states [-].
    pub c: DMatrix<f64>,
    /// Outputs x inputs [-].
    pub d: DMatrix<f64>,
}

impl Matrices {
    /// A gain: no states.
    pub fn gain(d: DMatrix<f64>) -> Self {
        let (outputs, inputs) = d.shape();
        Self {
            a: DMatrix::zeros(0, 0),
            b: DMatrix::zeros(0, inputs),
            c: DMatrix::zeros(outputs, 0),
            d,
        }
    }

    /// One input and one output, by the coefficients of falling powers of s (D-276). `None` if the
    /// numerator is of a higher degree than the denominator, or if the denominator begins with a
    /// zero.
    pub fn transfer(numerator: &[f64], denominator: &[f64]) -> Option<Self> {
        let (&leading, rest) = denominator.split_first()?;
        let order = rest.len();
        if leading == 0.0 || numerator.is_empty() || numerator.len() > order + 1 {
            return None;
        }
        let of_power = |power: usize| {
            let index = numerator.len().checked_sub(power + 1);
            index.map_or(0.0, |index| numerator[index] / leading)
        };
        let through = of_power(order);
        let mut matrices = Self::gain(DMatrix::from_element(1, 1, through));
        matrices.a = DMatrix::zeros(order, order);
        matrices.b = DMatrix::zeros(order, 1);
        matrices.c = DMatrix::from_fn(1, order, |_, i| if i == 0 { 1.0 } else { 0.0 });
        let last = rest.last().map_or(0.0, |last| (last / leading).abs());
        let corner = if last > 0.0 {
            last.powf(1.0 / order as f64)
        } else {
            1.0
        };
        for (i, coefficient) in rest.iter().enumerate() {
            let coefficient = coefficient / leading;
            let size = corner.powi(i as i32);
            matrices.a[(i, 0)] -= coefficient / size;
            if i + 1 < order {
                matrices.a[(i, i + 1)] = corner;
            }
            matrices.b[(i, 0)] = (of_power(order - 1 - i) - coefficient * through) / size;
        }
        Some(matrices)
    }

    /// Systems in parallel: entry `[i][j]` leads from input j to output i, if it exists.
    pub fn of_entries(entries: &[Vec<Option<Self>>], inputs: usize) -> Self {
        let all = || entries.iter().flatten().flatten();
        let states = all().map(|entry| entry.a.nrows()).sum();
        let mut matrices = Self {
            a: DMatrix::zeros(states, states),
            b: DMatrix::zeros(states, inputs),
            c: DMatrix::zeros(entries.len(), states),
            d: DMatrix::zeros(entries.len(), inputs),
        };
        let mut first = 0;
        for (i, row) in entries.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let Some(entry) = entry else { continue };
                let n = entry.a.nrows();
                let whole = (first, first);
                matrices.a.view_mut(whole, (n, n)).copy_from(&entry.a);
                matrices.b.view_mut((first, j), (n, 1)).copy_from(&entry.b);
                matrices.c.view_mut((i, first), (1, n)).copy_from(&entry.c);
                matrices.d[(i, j)] = entry.d[(0, 0)];
                first += n;
            }
        }
        matrices
    }

    /// Numbers of states, inputs and outputs.
    pub fn sizes(&self) -> [usize; 3] {
        [self.a.nrows(), self.d.ncols(), self.d.nrows()]
    }
}

/// A linear system of states between signals and scalars.
#[derive(Debug, Clone)]
pub struct StateSpace {
    label: String,
    matrices: Matrices,
    inputs: Inputs,
    /// The states, the outputs, and the scalars of all inputs in turn.
    scalars: Vec<Scalar>,
}

impl StateSpace {
    /// The unknown of an output called `name`.
    pub fn output(owner: &str, name: &str) -> Scalar {
        Scalar::new(ScalarSpec {
            owner: owner.to_owned(),
            unknown: Quantity::new(name, "-", 1.0),
            equation: Quantity::new(format!("output \"{name}\""), "-", 1.0),
            has_rate: false,
            rate: None,
            start: ScalarStart::Settled,
        })
    }

    /// The system `matrices` from the `inputs` to the `outputs`, in its numbers (see
    /// [`Self::output`]); `start` is the start of each state.
    pub fn new(
        label: impl Into<String>,
        matrices: Matrices,
        inputs: Vec<Signal>,
        outputs: Vec<Scalar>,
        start: &[ScalarStart],
    ) -> Self {
        let label = label.into();
        let states = start.iter().enumerate().map(|(i, start)| {
            let name = format!("state {}", i + 1);
            Scalar::new(ScalarSpec {
                owner: label.clone(),
                equation: Quantity::new(format!("rate of {name}"), "1/s", 1.0),
                unknown: Quantity::new(name, "-", 1.0),
                has_rate: true,
                rate: None,
                start: *start,
            })
        });
        let mut scalars: Vec<_> = states.chain(outputs).collect();
        Self {
            label,
            matrices,
            inputs: Inputs::new(inputs, &mut scalars),
            scalars,
        }
    }

    /// The unknowns of the states.
    pub fn states(&self) -> &[Scalar] {
        &self.scalars[..self.matrices.a.nrows()]
    }

    /// Factors of the states and of the inputs in the equation of the scalar `row`.
    fn row(&self, row: usize) -> [nalgebra::RowDVector<f64>; 2] {
        let Matrices { a, b, c, d } = &self.matrices;
        let states = a.nrows();
        match row.checked_sub(states) {
            None => [a.row(row).into_owned(), b.row(row).into_owned()],
            Some(output) => [c.row(output).into_owned(), d.row(output).into_owned()],
        }
    }
}

impl Element for StateSpace {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &[]
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.inputs.signals().iter().for_each(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let [states, _, outputs] = self.matrices.sizes();
        let Matrices { a, b, c, d } = &self.matrices;
        for i in 0..states {
            out.add_scalar(i, at.scalars.rates[i]);
        }
        for i in 0..outputs {
            out.add_scalar(states + i, at.scalars.values[states + i]);
        }
        for j in 0..states {
            let x = at.scalars.values[j];
            (0..states).for_each(|i| out.add_scalar(i, -a[(i, j)] * x));
            (0..outputs).for_each(|i| out.add_scalar(states + i, -c[(i, j)] * x));
        }
        for (j, u) in self.inputs.values(at).enumerate() {
            (0..states).for_each(|i| out.add_scalar(i, -b[(i, j)] * u));
            (0..outputs).for_each(|i| out.add_scalar(states + i, -d[(i, j)] * u));
        }
        let Some(out) = jacobian else { return };
        let [states, _, outputs] = self.matrices.sizes();
        for row in 0..states + outputs {
            out.add_scalar(row, row, 1.0, row < states);
            let [by_states, by_inputs] = self.row(row);
            for (j, value) in by_states.iter().enumerate() {
                out.add_scalar(row, j, -value, false);
            }
            self.inputs.gradient(at, |j, scalar, slope| {
                out.add_scalar(row, scalar, -by_inputs[j] * slope, false);
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;

    /// `C (s - A)^-1 B + D` of one input and one output.
    fn response(of: &Matrices, s: Complex<f64>) -> Complex<f64> {
        let n = of.a.nrows();
        let complex = |real: &DMatrix<f64>| real.map(|value| Complex::new(value, 0.0));
        let shifted = DMatrix::identity(n, n) * s - complex(&of.a);
        let x = shifted.lu().solve(&complex(&of.b)).unwrap();
        (complex(&of.c) * x)[(0, 0)] + of.d[(0, 0)]
    }

    // Polynomials by Horner's rule; orders one to five, with and without a direct part, which
    // cancels to 3e-6 of itself in one of them; corner frequencies over six decades.
    #[test]
    fn a_transfer_function_is_that_of_its_matrices() {
        let horner = |of: &[f64], s: Complex<f64>| {
            of.iter()
                .fold(Complex::new(0.0, 0.0), |sum, c| sum * s + *c)
        };
        for (numerator, denominator) in [
            (vec![1.0], vec![0.5, 1.0]),
            (vec![2.0, 3.0], vec![0.5, 1.0]),
            (vec![4.0], vec![1.0, 0.0, 0.0]),
            (vec![3.0, 0.0], vec![2.0, 0.3, 900.0]),
            (vec![1.0, 2.0, 3.0], vec![1.0, 2e3, 1e6]),
            (vec![1e-3, 5.0], vec![1e-9, 2e-6, 4e-3, 1.0]),
            (vec![7.0, -1.0, 4.0], vec![1.0, 3.0, 5.0, 6.0, 4.0, 2.0]),
        ] {
            let matrices = Matrices::transfer(&numerator, &denominator).unwrap();
            for frequency in [0.03, 1.0, 40.0, 3e3] {
                let s = Complex::new(0.1, frequency);
                let exact = horner(&numerator, s) / horner(&denominator, s);
                let off = (response(&matrices, s) - exact).norm() / exact.norm();
                assert!(off < 1e-9, "{denominator:?} {frequency}: {off:e}");
            }
        }
        for (numerator, denominator) in [
            (&[1.0, 0.0][..], &[1.0][..]),
            (&[][..], &[1.0][..]),
            (&[1.0][..], &[0.0, 1.0][..]),
            (&[1.0][..], &[][..]),
        ] {
            assert_eq!(Matrices::transfer(numerator, denominator), None);
        }
    }
}
