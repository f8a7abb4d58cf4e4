//! The local error of velocities, for errors that positions do not show.
//!
//! A force that jumps, or has a kink, between the last inner stage and the end of a step hardly
//! moves the end of a stage formula: for Radau IIA the weight of the end force in the end position
//! is zero. It does change the velocity at the end. With u the velocities at the ends of the steps,
//! and the polynomials through the latest m of them,
//!
//! ```text
//! d_m = u_n - u_m(t_n),    C_m = prod_{j=1..m} (t_n - t_{n-j}) / (m! h^m)          (D-118)
//! ```
//!
//! a smooth velocity deviates from them by `(C_m - C) h^m d^m u/dt^m`, a jump by its change in the
//! step, for any m. The error is therefore, p being the order of the formula,
//!
//! ```text
//! max( |C / (C_{p+1} - C)| |d_{p+1}| ,  kappa min_m D_m ) ,  D_m = max( |d_m| , |d_{m+1}| )    (D-119)
//! ```
//!
//! times the time for which it lasts: steps are short where forces jump, and grow again after it.
//! With W the longest of the previous steps, each reduced by a fraction of the time elapsed since
//! it,
//!
//! ```text
//! W_n = max( h_n , W_{n-1} - delta h_n ),    T = W min( W / h , 10 )               (D-120)
//! ```
//!
//! as the errors of up to ten short steps in the time of a long one add up. For equal steps, T is
//! the step.
//!
//! With the trapezoid rule, constrained velocities alternate from step to step about the true ones,
//! by an amount that no step reduces; the mean of two successive ones does not. It is used instead,
//! at the middle of the step.

use serde::{Deserialize, Serialize};

use super::{Dae, Formula};

/// Largest number of velocities of a polynomial.
const MOST: usize = 6;

/// kappa: fraction of an unpredicted change that is an error. A larger one requires more steps of
/// third-order formulas in smooth motion, where they are long: this one requires 3 more of 30, and
/// none of 60.
const UNFORESEEN: f64 = 0.2;

/// delta: fraction of the elapsed time by which the memory W of a long step decreases.
const FORGOTTEN: f64 = 0.3;

/// Largest number of short steps in the time of a long one whose errors add up.
const ADDED: f64 = 10.0;

/// Velocities of the previous accepted states, and the duration of their error.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Speeds {
    /// Times of the states, the latest first [s].
    times: Vec<f64>,
    /// Their velocities, and buffers for the states to come.
    values: [Vec<f64>; MOST],
    /// The largest so far.
    largest: Vec<f64>,
    /// W [s].
    memory: f64,
    #[serde(skip)]
    trial: Vec<f64>,
    #[serde(skip)]
    missed: Vec<f64>,
}

impl Speeds {
    /// Order in which the error of a long step grows, for the choice of the next step.
    pub const ORDER: usize = MOST;

    /// Begins with the latest accepted state of `dae`, at `time` \[s\], and allocates the buffers
    /// of all later states.
    pub fn restart(&mut self, dae: &dyn Dae, time: f64) {
        self.times.clear();
        self.times.reserve(MOST + 1);
        self.add(dae, time);
        let count = self.values[0].len();
        let later = self.values.iter_mut().skip(1);
        for values in later.chain([&mut self.trial, &mut self.missed]) {
            values.resize(count, 0.0);
        }
    }

    /// Copies `other` without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.times.clone_from(&other.times);
        self.values.clone_from(&other.values);
        self.largest.clone_from(&other.largest);
        self.memory = other.memory;
    }

    /// Takes the latest accepted state of `dae`, reached by a step of `length` \[s\].
    pub fn accept(&mut self, dae: &dyn Dae, time: f64, length: f64) {
        self.memory = length.max(self.memory - FORGOTTEN * length);
        self.add(dae, time);
    }

    fn add(&mut self, dae: &dyn Dae, time: f64) {
        self.values.rotate_right(1);
        let values = &mut self.values[0];
        dae.speeds(None, values);
        self.largest.resize(values.len(), 0.0);
        for (largest, value) in self.largest.iter_mut().zip(values) {
            *largest = largest.max(value.abs());
        }
        self.times.insert(0, time);
        self.times.truncate(MOST);
    }

    /// The error (D-119) of the end of a trial step, relative to the sizes of the system; `None` if
    /// too few states are known.
    pub fn error(
        &mut self,
        dae: &dyn Dae,
        formula: &Formula,
        end: f64,
        length: f64,
    ) -> Option<f64> {
        let order = formula.order.min(3);
        let seen = if formula.alternates() {
            Seen::Means
        } else {
            Seen::Values
        };
        let times = self.times(seen, end);
        let known = self.known(seen);
        if known <= order {
            return None;
        }
        dae.speeds(Some(formula.stages - 1), &mut self.trial);
        let own = formula.counted_constant();
        let of_polynomial = (0..=order).fold(1.0, |product, j| {
            product * (times[0] - times[j + 1]) / (length * (j + 1) as f64)
        });
        let factor = (own / (of_polynomial - own)).abs();
        self.missed.resize(self.trial.len(), 0.0);
        for i in 0..self.trial.len() {
            let misses = self.misses(i, seen, &times);
            let unforeseen = unforeseen(&misses[..known]);
            self.missed[i] = (factor * misses[order].abs()).max(UNFORESEEN * unforeseen);
        }
        let lasting = self.memory.max(length);
        let time = lasting * ADDED.min(lasting / length);
        Some(dae.drift(&self.missed, [&self.trial, &self.largest], time))
    }

    /// Number of previous velocities, or of their means.
    fn known(&self, seen: Seen) -> usize {
        match seen {
            Seen::Values => self.times.len(),
            Seen::Means => self.times.len().saturating_sub(1),
        }
    }

    /// Times of the velocities, or of their means: at the trial state, and at the previous ones.
    fn times(&self, seen: Seen, end: f64) -> [f64; MOST + 1] {
        let mut times = [end; MOST + 1];
        times[1..=self.times.len()].copy_from_slice(&self.times);
        seen.of(times)
    }

    /// `d_1, d_2, ...` of one number at the trial state, by Newton's divided differences.
    fn misses(&self, i: usize, seen: Seen, times: &[f64; MOST + 1]) -> [f64; MOST] {
        let known = self.known(seen);
        let mut values = [self.trial[i]; MOST + 1];
        for (value, behind) in values[1..].iter_mut().zip(&self.values) {
            *value = behind[i];
        }
        let values = seen.of(values);
        let (mut misses, mut table) = ([0.0; MOST], values);
        let (mut sum, mut product) = (0.0, 1.0);
        for m in 0..known {
            sum += table[1] * product;
            misses[m] = values[0] - sum;
            product *= times[0] - times[m + 1];
            for j in 1..known - m {
                let between = times[j] - times[j + m + 1];
                table[j] = (table[j] - table[j + 1]) / between;
            }
        }
        misses
    }
}

/// The part of a change that none of the polynomials predicted: two in succession, as a single one
/// may agree with a jump by chance.
fn unforeseen(misses: &[f64]) -> f64 {
    let pairs = misses.windows(2).map(|two| two[0].abs().max(two[1].abs()));
    let one = misses.first().map_or(0.0, |miss| miss.abs());
    pairs.reduce(f64::min).unwrap_or(one)
}

/// Form in which velocities are used.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Seen {
    Values,
    /// The mean of each and the previous one.
    Means,
}

impl Seen {
    /// The numbers in this form, the latest first; the last has no previous one.
    fn of(self, mut numbers: [f64; MOST + 1]) -> [f64; MOST + 1] {
        if self == Self::Means {
            for k in 0..MOST {
                numbers[k] = 0.5 * (numbers[k] + numbers[k + 1]);
            }
        }
        numbers
    }
}
