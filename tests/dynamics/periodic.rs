//! Periodic motion and its stability against closed forms and independent integration.

use beam_dynamics::analysis::periodic::{PeriodicOutcome, periodic};
use beam_dynamics::model::State;
use beam_dynamics::result::{AcceptedStep, FloquetMode, Recorder};
use nalgebra::{Complex, DMatrix};

mod far_start;
mod linear;
pub mod mathieu;
mod orbit;
pub mod rotor;
mod shafts;
mod trim;

/// Keeps all states of a period.
#[derive(Default)]
pub struct Kept(pub Vec<(f64, State)>);

impl Recorder for Kept {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        self.0.push((accepted.time, accepted.state.clone()));
        true
    }
}

/// The periodic motion of a file in radians and SI units.
fn attempt(cards: &str) -> (PeriodicOutcome, Kept) {
    let units = "[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n";
    let text = format!("{units}{cards}");
    let input = beam_dynamics::input::parse(&text, "model.dynamics.toml")
        .unwrap_or_else(|problems| panic!("{problems}\n{text}"));
    let mut kept = Kept::default();
    let settings = input.periodic.as_ref().unwrap();
    let outcome = periodic(&input.model, settings, &mut kept);
    (outcome, kept)
}

/// The same of a motion that repeats.
fn analyzed(cards: &str) -> (PeriodicOutcome, Kept) {
    let (outcome, kept) = attempt(cards);
    if let Some(failure) = &outcome.failure {
        panic!("{failure}\n{:#?}", outcome.result.passes);
    }
    (outcome, kept)
}

/// The modes of a result.
fn modes(outcome: &PeriodicOutcome) -> &[FloquetMode] {
    &outcome.result.floquet.as_ref().unwrap().modes
}

/// All multipliers, both of a pair.
fn multipliers(outcome: &PeriodicOutcome) -> Vec<Complex<f64>> {
    let all = modes(outcome).iter().map(|mode| mode.multiplier);
    let both = all.flat_map(|mu| {
        if mu.im == 0.0 {
            vec![mu]
        } else {
            vec![mu, mu.conj()]
        }
    });
    both.collect()
}

/// The largest distance of an expected number from the nearest of the found ones.
fn farthest(found: &[Complex<f64>], expected: &[Complex<f64>]) -> f64 {
    let nearest = |e: &Complex<f64>| {
        let distances = found.iter().map(|f| (f - e).norm());
        distances.fold(f64::INFINITY, f64::min)
    };
    expected.iter().map(nearest).fold(0.0, f64::max)
}

/// The largest difference of the sums of the first powers, as many as there are numbers, each relative
/// to the power of the largest number or one: unlike the numbers it is not sensitive where two of them
/// are close.
fn off_by_sums(found: &[Complex<f64>], expected: &[Complex<f64>]) -> f64 {
    let largest = expected.iter().map(|mu| mu.norm()).fold(1.0, f64::max);
    let sum =
        |of: &[Complex<f64>], k: usize| of.iter().map(|mu| mu.powi(k as i32)).sum::<Complex<f64>>();
    let off = |k| (sum(found, k) - sum(expected, k)).norm() / largest.powi(k as i32);
    (1..=expected.len()).map(off).fold(0.0, f64::max)
}

/// The map over `period` of `x' = A(t) x` by the classical Runge-Kutta formula.
fn monodromy(a: impl Fn(f64) -> DMatrix<f64>, period: f64, steps: usize) -> DMatrix<f64> {
    let h = period / steps as f64;
    let n = a(0.0).nrows();
    let mut x = DMatrix::identity(n, n);
    for step in 0..steps {
        let t = h * step as f64;
        let (first, middle, last) = (a(t), a(t + 0.5 * h), a(t + h));
        let k1 = &first * &x;
        let k2 = &middle * (&x + 0.5 * h * &k1);
        let k3 = &middle * (&x + 0.5 * h * &k2);
        let k4 = &last * (&x + h * &k3);
        x += (k1 + 2.0 * k2 + 2.0 * k3 + k4) * (h / 6.0);
    }
    x
}

/// Pseudorandom numbers between -1 and 1.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
