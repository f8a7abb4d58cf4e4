//! Small systems of equations for the integrators.

use std::sync::Arc;

use beam_dynamics::assembly::{Combination, Pattern, Residual};
use beam_dynamics::integrator::{Corner, Dae, Renewal};
use beam_dynamics::model::Name;
use beam_dynamics::solver::Worst;
use nalgebra::DMatrix;

/// Equations `F(y, y', t) = 0` written out.
pub trait Equations {
    /// Which unknowns are algebraic.
    const ALGEBRAIC: &'static [bool];
    /// Unknowns with a checked local error.
    const POSITIONS: &'static [usize];

    /// Terms of each equation: they sum up to the residual.
    fn terms(&self, time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>>;

    /// `F_y` and `F_y'`.
    fn derivatives(&self, time: f64, y: &[f64], rates: &[f64]) -> [DMatrix<f64>; 2];

    /// The first corner after a time.
    fn next_corner(&self, _time: f64) -> f64 {
        f64::INFINITY
    }

    /// Computes the rates that agree with the conditions just after a time.
    fn renew(&self, _time: f64, _y: &mut [f64], _rates: &mut [f64]) -> bool {
        false
    }
}

/// Values and rates.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    pub y: Vec<f64>,
    pub rates: Vec<f64>,
}

/// A state under trial and its prediction.
#[derive(Debug, Clone)]
struct Trial {
    time: f64,
    predicted: State,
    state: State,
}

/// Equations with their states.
#[derive(Debug)]
pub struct System<E> {
    pub equations: E,
    pub latest: State,
    pub before: State,
    trials: Vec<Trial>,
    pattern: Arc<Pattern>,
    /// Part of each entry that is lost in a residual, as by round-off of stiff forces.
    pub noise: f64,
    noise_sign: f64,
}

impl<E: Equations> System<E> {
    pub fn new(equations: E, y: &[f64], rates: &[f64]) -> Self {
        let n = y.len();
        let (y, rates) = (y.to_vec(), rates.to_vec());
        let latest = State { y, rates };
        let trial = Trial {
            time: 0.0,
            predicted: latest.clone(),
            state: latest.clone(),
        };
        let all = (0..n).flat_map(|j| (0..n).map(move |i| (i, j)));
        Self {
            equations,
            before: latest.clone(),
            latest,
            trials: vec![trial; 3],
            pattern: Arc::new(Pattern::new(n, all.collect())),
            noise: 0.0,
            noise_sign: 1.0,
        }
    }
}

impl<E: Equations> Dae for System<E> {
    fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    fn algebraic(&self) -> &[bool] {
        E::ALGEBRAIC
    }

    fn past(&self, ago: f64, y: &mut [f64], rates: &mut [f64]) {
        let back = usize::from(ago > 0.0);
        let state = [&self.latest, &self.before][back];
        rates.copy_from_slice(&state.rates);
        for i in 0..y.len() {
            y[i] = state.y[i] - self.latest.y[i];
        }
    }

    fn renew(&mut self, corner: &Corner, _step: f64) -> Renewal {
        let State { y, rates } = &mut self.latest;
        if self.equations.renew(corner.after, y, rates) {
            Renewal::Rates
        } else {
            Renewal::Unknown
        }
    }

    fn predict(&mut self, stage: usize, [time, _]: [f64; 2], y: &[f64], rates: &[f64]) {
        let trial = &mut self.trials[stage];
        trial.time = time;
        trial.predicted.rates.copy_from_slice(rates);
        for i in 0..y.len() {
            trial.predicted.y[i] = self.latest.y[i] + y[i];
        }
        trial.state.clone_from(&trial.predicted);
    }

    fn correct(&mut self, stage: usize, y: &[f64], rates: &[f64]) {
        let trial = &mut self.trials[stage];
        for i in 0..y.len() {
            trial.state.y[i] = trial.predicted.y[i] + y[i];
            trial.state.rates[i] = trial.predicted.rates[i] + rates[i];
        }
    }

    fn residual(&mut self, stage: usize, out: &mut Residual) {
        let Trial { time, state, .. } = &self.trials[stage];
        let terms = self.equations.terms(*time, &state.y, &state.rates);
        self.noise_sign = -self.noise_sign;
        for (i, terms) in terms.iter().enumerate() {
            out.sizes[i] = terms.iter().map(|term| term.abs()).sum();
            let lost = self.noise_sign * self.noise * out.sizes[i];
            out.values[i] = terms.iter().sum::<f64>() + lost;
        }
    }

    fn jacobian(
        &mut self,
        stage: usize,
        out: &mut [Combination<'_>],
        residual: Option<&mut Residual>,
    ) {
        if let Some(residual) = residual {
            self.residual(stage, residual);
        }
        let Trial { time, state, .. } = &self.trials[stage];
        let [by_y, by_rates] = self.equations.derivatives(*time, &state.y, &state.rates);
        let n = E::ALGEBRAIC.len();
        for sum in out {
            for j in 0..n {
                for i in 0..n {
                    sum.matrix.values_mut()[j * n + i] = if E::ALGEBRAIC[j] {
                        sum.by_algebraic * by_y[(i, j)]
                    } else {
                        sum.by_unknowns * by_y[(i, j)] + sum.by_rates * by_rates[(i, j)]
                    };
                }
            }
        }
    }

    fn accept(&mut self, stage: usize) {
        std::mem::swap(&mut self.before, &mut self.latest);
        self.latest.clone_from(&self.trials[stage].state);
    }

    fn next_corner(&self, time: f64) -> f64 {
        self.equations.next_corner(time)
    }

    /// All equations have the same kind here.
    fn worst(&self, residual: &Residual) -> Worst {
        let largest = residual.sizes.iter().fold(1e-300_f64, |a, b| a.max(*b));
        let relative = residual.values.iter().map(|value| value.abs() / largest);
        let worst = relative.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        let (position, relative) = worst.unwrap();
        Worst {
            relative,
            index: position,
            scale: largest,
        }
    }

    fn size(&self, _stage: usize, correction: &[f64]) -> f64 {
        let sizes = correction.iter().zip(E::ALGEBRAIC).filter(|(_, is)| !**is);
        sizes.fold(0.0, |size, (value, _)| size.max(value.abs()))
    }

    fn describe_error(&self, difference: &[f64]) -> String {
        let sizes = difference.iter().map(|value| value.abs()).enumerate();
        let largest = sizes.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        format!("unknown {}, off by {:.3e}", largest.0, largest.1)
    }

    fn error(&self, difference: &[f64]) -> f64 {
        let sizes = E::POSITIONS.iter().map(|&i| difference[i].abs());
        sizes.fold(0.0, f64::max)
    }

    fn speeds(&self, stage: Option<usize>, out: &mut Vec<f64>) {
        let state = stage.map_or(&self.latest, |stage| &self.trials[stage].state);
        out.clear();
        out.extend(E::POSITIONS.iter().map(|&i| state.rates[i]));
    }

    fn drift(&self, missed: &[f64], _now: [&[f64]; 2], time: f64) -> f64 {
        time * missed.iter().fold(0.0, |a: f64, b| a.max(b.abs()))
    }

    fn name(&self, index: usize) -> Name {
        Name::of_system(format!("equation {index}"), "-")
    }
}

/// `y' = lambda y` for complex lambda: real and imaginary part.
#[derive(Debug)]
pub struct Linear {
    pub lambda: [f64; 2],
}

impl Equations for Linear {
    const ALGEBRAIC: &'static [bool] = &[false; 2];
    const POSITIONS: &'static [usize] = &[0, 1];

    fn terms(&self, _time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        let [a, b] = self.lambda;
        vec![
            vec![rates[0], -a * y[0], b * y[1]],
            vec![rates[1], -b * y[0], -a * y[1]],
        ]
    }

    fn derivatives(&self, _time: f64, _y: &[f64], _rates: &[f64]) -> [DMatrix<f64>; 2] {
        let [a, b] = self.lambda;
        let by_y = DMatrix::from_row_slice(2, 2, &[-a, b, -b, -a]);
        [by_y, DMatrix::identity(2, 2)]
    }
}

/// A pendulum of unit length in coordinates x, y (along gravity), u, v and its tension:
/// `x' = u, y' = v, u' + x lambda = 0, v' + y lambda = 1, (x^2 + y^2 - 1) / 2 = 0`.
#[derive(Debug)]
pub struct Pendulum;

/// Horizontal, moving down with unit velocity.
pub const PENDULUM_START: [f64; 5] = [1.0, 0.0, 0.0, 1.0, 0.0];

impl Pendulum {
    /// At the start, with rates as the initial derivatives without the centripetal part.
    pub fn inconsistent() -> System<Self> {
        System::new(Self, &PENDULUM_START, &[0.0, 1.0, 0.0, 1.0, 0.0])
    }

    /// At the start, with its accelerations: lambda = 1.
    pub fn consistent() -> System<Self> {
        let start = [1.0, 0.0, 0.0, 1.0, 1.0];
        System::new(Self, &start, &[0.0, 1.0, -1.0, 1.0, 0.0])
    }
}

impl Equations for Pendulum {
    const ALGEBRAIC: &'static [bool] = &[false, false, false, false, true];
    const POSITIONS: &'static [usize] = &[0, 1];

    fn terms(&self, _time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        vec![
            vec![rates[0], -y[2]],
            vec![rates[1], -y[3]],
            vec![rates[2], y[0] * y[4]],
            vec![rates[3], y[1] * y[4], -1.0],
            vec![0.5 * y[0] * y[0], 0.5 * y[1] * y[1], -0.5],
        ]
    }

    fn derivatives(&self, _time: f64, y: &[f64], _rates: &[f64]) -> [DMatrix<f64>; 2] {
        let mut by_rates = DMatrix::identity(5, 5);
        by_rates[(4, 4)] = 0.0;
        let mut by_y = DMatrix::zeros(5, 5);
        (by_y[(0, 2)], by_y[(1, 3)]) = (-1.0, -1.0);
        (by_y[(2, 0)], by_y[(2, 4)]) = (y[4], y[0]);
        (by_y[(3, 1)], by_y[(3, 4)]) = (y[4], y[1]);
        (by_y[(4, 0)], by_y[(4, 1)]) = (y[0], y[1]);
        [by_y, by_rates]
    }
}

/// `y' = v, v' + lambda = 0, y = cos t`: Table C.1 of the thesis.
#[derive(Debug)]
pub struct Imposed;

impl Equations for Imposed {
    const ALGEBRAIC: &'static [bool] = &[false, false, true];
    const POSITIONS: &'static [usize] = &[0];

    fn terms(&self, time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        vec![
            vec![rates[0], -y[1]],
            vec![rates[1], y[2]],
            vec![y[0], -time.cos()],
        ]
    }

    fn derivatives(&self, _time: f64, _y: &[f64], _rates: &[f64]) -> [DMatrix<f64>; 2] {
        let by_y = [0.0, -1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0];
        let by_rates = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        [by_y, by_rates].map(|values| DMatrix::from_row_slice(3, 3, &values))
    }
}

/// Bathe's pendulum: angle from the horizontal, elongation of the rod, and their rates:
/// `theta' = phi, u' = w, (L + u) phi' = g cos theta - 2 w phi,
/// m w' = m (L + u) phi^2 + m g sin theta - (EA / L) u`.
#[derive(Debug)]
pub struct Bathe {
    pub length: f64,
    pub mass: f64,
    pub gravity: f64,
    pub stiffness: f64,
}

impl Equations for Bathe {
    const ALGEBRAIC: &'static [bool] = &[false; 4];
    const POSITIONS: &'static [usize] = &[0, 1];

    fn terms(&self, _time: f64, y: &[f64], rates: &[f64]) -> Vec<Vec<f64>> {
        let (arm, m, g) = (self.length + y[1], self.mass, self.gravity);
        let [sin, cos] = [y[0].sin(), y[0].cos()];
        vec![
            vec![rates[0], -y[2]],
            vec![rates[1], -y[3]],
            vec![arm * rates[2], -g * cos, 2.0 * y[3] * y[2]],
            vec![
                m * rates[3],
                -m * arm * y[2] * y[2],
                -m * g * sin,
                self.stiffness * y[1],
            ],
        ]
    }

    fn derivatives(&self, _time: f64, y: &[f64], rates: &[f64]) -> [DMatrix<f64>; 2] {
        let (arm, m, g) = (self.length + y[1], self.mass, self.gravity);
        let [sin, cos] = [y[0].sin(), y[0].cos()];
        let by_rates = nalgebra::DVector::from_row_slice(&[1.0, 1.0, arm, m]);
        let mut by_y = DMatrix::zeros(4, 4);
        (by_y[(0, 2)], by_y[(1, 3)]) = (-1.0, -1.0);
        by_y.row_mut(2)
            .copy_from_slice(&[g * sin, rates[2], 2.0 * y[3], 2.0 * y[2]]);
        let by_elongation = self.stiffness - m * y[2] * y[2];
        let by_phi = -2.0 * m * arm * y[2];
        by_y.row_mut(3)
            .copy_from_slice(&[-m * g * cos, by_elongation, by_phi, 0.0]);
        [by_y, DMatrix::from_diagonal(&by_rates)]
    }
}
