//! Linear models against closed forms, modes, equilibria and direct solutions of all equations.

use beam_dynamics::analysis::linear::{LinearFailure, linearize};
use beam_dynamics::analysis::steady::equilibrium;
use beam_dynamics::case::{LinearAbout, LinearPort};
use beam_dynamics::input::{self, Input, LinearRequest};
use beam_dynamics::result::LinearModel;
use beam_dynamics::solver::LinearSolver;
use nalgebra::{Complex, DMatrix, DVector};

mod closed_forms;
mod files;
mod hoop;
mod problems;
mod random;
mod rotors;

/// Inputs, outputs and the rotor speed \[rad/s\].
type Asked<'a> = (&'a [&'a str], &'a [&'a str], f64);

fn request((inputs, outputs, speed): Asked<'_>) -> LinearRequest {
    let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
    LinearRequest {
        inputs: owned(inputs),
        outputs: owned(outputs),
        speed: (speed != 0.0).then_some(speed),
        about: None,
    }
}

/// Cards in radians and SI units.
fn text(cards: &str) -> String {
    format!("[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n{cards}")
}

fn parsed(cards: &str, asked: Asked<'_>) -> Input {
    let found = input::parse_linear(&text(cards), "model.dynamics.toml", &request(asked), &[]);
    found.unwrap_or_else(|problems| panic!("{problems}\n{cards}"))
}

fn attempt(cards: &str, asked: Asked<'_>) -> Result<LinearModel, LinearFailure> {
    let (input, asked) = (parsed(cards, asked), request(asked));
    let text = text(cards);
    let read =
        |given: &[(String, f64)]| input::parse_linear(&text, "model.dynamics.toml", &asked, given);
    linearize(&input, &read)
}

fn linear(cards: &str, asked: Asked<'_>) -> LinearModel {
    let found = attempt(cards, asked);
    let found = found.unwrap_or_else(|failure| panic!("{failure}\n{cards}"));
    // Round-off of some ten terms.
    assert!(found.residual < 1e-12, "{:e}\n{cards}", found.residual);
    found
}

/// `C (s - A)^-1 B + D`.
fn response(model: &LinearModel, s: Complex<f64>) -> DMatrix<Complex<f64>> {
    let [a, b, c, d] =
        [&model.a, &model.b, &model.c, &model.d].map(|matrix| matrix.map(Complex::from));
    let whole = DMatrix::identity(a.nrows(), a.nrows()) * s - a;
    c * whole.full_piv_lu().solve(&b).unwrap() + d
}

/// The same by all linearized equations at once, in which an input is held at one.
fn direct(cards: &str, asked: Asked<'_>, s: Complex<f64>) -> DMatrix<Complex<f64>> {
    let input = parsed(cards, asked);
    let (model, settings) = (&input.model, input.linear.as_ref().unwrap());
    let LinearAbout::Equilibrium { speed, .. } = settings.about else {
        panic!("a trim");
    };
    let conditions = model.conditions(speed, 1.0, 1.0);
    let solver = LinearSolver::new(model.system.pattern());
    let rest = (&model.conditions(0.0, 1.0, 1.0), &model.system.rest());
    let steady = equilibrium(model, &solver, rest, &conditions).unwrap();
    let tangent = model.system.tangent(&steady.state, &conditions);
    let first = model.system.numbering().first_scalar();
    let place = |port: &LinearPort| {
        let mut scalars = model.system.scalars().iter();
        first + scalars.position(|scalar| *scalar == port.scalar).unwrap()
    };
    let inputs: Vec<_> = settings.inputs.iter().map(place).collect();
    let outputs: Vec<_> = settings.outputs.iter().map(place).collect();
    let n = model.system.numbering().unknowns();
    let mut whole = DMatrix::zeros(n, n);
    for (row, column, value) in tangent.by_unknowns.triplets() {
        whole[(row, column)] += Complex::from(value);
    }
    for (row, column, value) in tangent.by_rates.triplets() {
        whole[(row, column)] += s * value;
    }
    for &row in &inputs {
        whole.row_mut(row).fill(Complex::from(0.0));
        whole[(row, row)] = Complex::from(1.0);
    }
    let factors = whole.full_piv_lu();
    let mut found = DMatrix::zeros(outputs.len(), inputs.len());
    for (j, &row) in inputs.iter().enumerate() {
        let mut right = DVector::zeros(n);
        right[row] = Complex::from(1.0);
        let solution = factors.solve(&right).unwrap();
        outputs
            .iter()
            .enumerate()
            .for_each(|(i, &row)| found[(i, j)] = solution[row]);
    }
    found
}

/// The largest difference relative to the largest entry.
fn off(found: &DMatrix<Complex<f64>>, expected: &DMatrix<Complex<f64>>) -> f64 {
    let largest = |matrix: &DMatrix<Complex<f64>>| {
        matrix.iter().map(|entry| entry.norm()).fold(0.0, f64::max)
    };
    largest(&(found - expected)) / largest(expected)
}
