//! All real factors at which a tangent is singular, and their shapes.
//!
//! ```text
//! ( K_0 + lambda K_1 ) v = 0                                                    (D-276)
//! ```
//!
//! Where the two are symmetric, with A the part of `K_0^-1` that leads from the forces and
//! moments on the motions S that K_1 works on to these motions, positive or negative
//! definite for all that can move,
//!
//! ```text
//! A = s L L^T,   s = +-1       - s L^T K_1 L z = z / lambda,    v_S = L z         (D-277)
//! ```
//!
//! is one symmetric matrix whose eigenvalues are all known at once, repeated ones with as
//! many shapes as they have: none can be lost, and where they all vanish there is none. In
//! a column with torsional prestress every evaluation point gives way at one load, and most
//! of the eigenvalues of `- K_0^-1 K_1` are zero. Other matrices are those of follower
//! loads, of finite volumes, or of unstable equilibria; small ones are solved as a whole
//! too, of large ones the largest eigenvalues are sought.

use faer::{Mat, Side, c64};

use super::eigen::{CONFIRMED, EigenProblem, Eigenpair, copies_at_front};
use super::inverse::DENSE;
use super::sorted::OSCILLATING;
use crate::assembly::{Entry, MasslessMotions, Tangent};
use crate::model::{Equation, NODE_UNKNOWNS, Variable};
use crate::solver::LinearSolver;

/// Motions up to which the symmetric problem is solved as a whole: in a few seconds.
const WHOLE: usize = 900;
/// Unknowns up to which all eigenvalues of an unsymmetric problem are computed.
const ALL: usize = 400;
/// A matrix is symmetric up to this part of its largest entry.
const SYMMETRIC: f64 = 1e-8;
/// Eigenvalues of A below this part of the largest are zero.
const ZERO: f64 = 1e-12;
/// Factors beyond this part of the lowest are infinite.
const INFINITE: f64 = 1e-9;
/// Relative error of a pair from which on it is none.
const NO_PAIR: f64 = 1e-5;

/// Real factors of smallest magnitude.
#[derive(Debug, Clone, Default)]
pub struct Factors {
    /// The factors, as growth, with their shapes.
    pub pairs: Vec<Eigenpair>,
    /// Whether there are no others of smaller magnitude than the largest of these, or, where
    /// they are fewer than asked for, none at all.
    pub is_complete: bool,
    /// Values that were found with an error that is too large for a factor.
    pub uncertain: usize,
}

impl<'a> EigenProblem<'a> {
    /// Prepares the real eigenvalues nearest to zero of `by_unknowns + s by_rates`,
    /// whatever the two matrices are, with all rates where no motions are `massless`;
    /// `None` when the first is singular.
    pub fn about_zero(
        solver: &'a LinearSolver,
        tangent: &'a Tangent,
        massless: &'a MasslessMotions,
        copies: usize,
    ) -> Option<Self> {
        Self::shifted(solver, tangent, massless, copies, 0.0)
    }

    /// The real eigenvalues of smallest magnitude with their vectors, at most `count`.
    pub fn real(&self, count: usize) -> Vec<Eigenpair> {
        self.real_within(count, DENSE)
    }

    /// The same, all eigenvalues being computed of problems of up to so many unknowns.
    fn real_within(&self, count: usize, dense: usize) -> Vec<Eigenpair> {
        let mut values = self.inverse().smallest(count, self.copies(), dense);
        values.retain(|s| s.im.abs() <= OSCILLATING.sqrt() * s.norm());
        values.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        values.truncate(count);
        let mut pairs: Vec<Eigenpair> = Vec::with_capacity(values.len());
        while pairs.len() < values.len() {
            let rest = &values[pairs.len()..];
            let reals: Vec<_> = rest[..copies_at_front(rest)]
                .iter()
                .map(|s| c64::new(s.re, 0.0))
                .collect();
            pairs.extend(self.vectors(&reals));
        }
        pairs
    }

    /// Oscillations of a damping ratio below `least`, of all that the system has, one of each
    /// pair; `None` where they are too many to be looked at.
    pub fn growing(&self, least: f64) -> Option<Vec<c64>> {
        if !self.inverse().is_small(0, ALL) {
            return None;
        }
        let is_growing = |s: &c64| s.im > 0.0 && -s.re < least * s.norm();
        let values = self.inverse().smallest(0, self.copies(), ALL);
        let growing = values.into_iter().filter(is_growing);
        // Infinite values come out as large ones by round-off, which no vector confirms.
        let confirmed = growing.filter_map(|value| {
            let pair = self.vectors(&[value]).into_iter().next()?;
            let s = c64::new(pair.growth, pair.angular_frequency);
            let is_same = (s - value).norm() <= CONFIRMED * value.norm();
            (is_same && is_growing(&s)).then_some(s)
        });
        Some(confirmed.collect())
    }

    /// The real factors s of smallest magnitude of `by_unknowns + s by_rates`, at most
    /// `count`.
    pub fn factors(&self, count: usize) -> Factors {
        match self.symmetric_pairs(count) {
            Some((pairs, is_complete)) => Factors::of(pairs, is_complete),
            None => Factors::of(
                self.real_within(count, ALL),
                self.inverse().is_small(count, ALL),
            ),
        }
    }

    /// All pairs of (D-277), `count` of them at most; `None` where it does not apply.
    fn symmetric_pairs(&self, count: usize) -> Option<(Vec<Eigenpair>, bool)> {
        let compliance = Compliance::new(self)?;
        let (factors, motions) = compliance.factors()?;
        let pairs = factors.iter().zip(motions.iter()).take(count);
        let pairs = pairs.map(|(&factor, motion)| self.pair(factor, motion));
        Some((pairs.collect(), true))
    }

    /// The pair of a factor whose shape moves the unknowns with rates by `motion`.
    fn pair(&self, factor: f64, motion: &[f64]) -> Eigenpair {
        let moved = self.inverse().moved(motion, -factor);
        let vector: Vec<_> = moved.iter().map(|value| c64::new(*value, 0.0)).collect();
        Eigenpair {
            growth: factor,
            angular_frequency: 0.0,
            residual: self.inverse().residual(c64::new(factor, 0.0), &vector),
            real: moved[..self.size()].to_vec(),
            imaginary: vec![0.0; self.size()],
        }
    }
}

impl Factors {
    /// Without pairs that are none.
    fn of(mut pairs: Vec<Eigenpair>, is_complete: bool) -> Self {
        let found = pairs.len();
        // What is not a number is told as such.
        pairs.retain(|pair| pair.residual.is_nan() || pair.residual <= NO_PAIR);
        let uncertain = found - pairs.len();
        Self {
            pairs,
            is_complete: is_complete && uncertain == 0,
            uncertain,
        }
    }
}

/// A, and K_1 on the same motions, scaled to a unit diagonal of A.
struct Compliance {
    /// What each is scaled by.
    scale: Vec<f64>,
    compliance: Mat<f64>,
    rates: Mat<f64>,
}

/// The force or moment that a motion of a node is balanced by.
fn balance(place: usize) -> Option<usize> {
    let number = place % NODE_UNKNOWNS;
    let is_motion = number < Variable::Rotation.column() + 3;
    is_motion.then(|| place + Equation::Force.row())
}

impl Compliance {
    /// `None` where the matrices are no symmetric ones of moderate size.
    fn new(problem: &EigenProblem<'_>) -> Option<Self> {
        let rates = problem.rates();
        let mut places: Vec<_> = rates.iter().map(|entry| entry.1).collect();
        places.sort_unstable();
        places.dedup();
        let is_of_node = |place: &usize| *place < problem.size() && balance(*place).is_some();
        if places.len() > WHOLE || !places.iter().all(is_of_node) {
            return None;
        }
        let rows: Vec<_> = places.iter().filter_map(|place| balance(*place)).collect();
        let inverse = problem.inverse().columns(&rows)?;
        let n = places.len();
        let all = Mat::from_fn(n, n, |i, j| inverse[(places[i], j)]);
        let sign = (0..n).map(|i| all[(i, i)]).sum::<f64>().signum();
        let scale = |i: usize| match sign * all[(i, i)] > 0.0 {
            true => all[(i, i)].abs().sqrt(),
            false => 0.0,
        };
        let scale: Vec<_> = (0..n).map(scale).collect();
        let by = |i: usize| if scale[i] > 0.0 { 1.0 / scale[i] } else { 0.0 };
        let compliance = Mat::from_fn(n, n, |i, j| sign * by(i) * all[(i, j)] * by(j));
        let rates = scaled(rates, (&places, &rows), &scale, -sign)?;
        let is_sound = is_symmetric(&compliance) && is_symmetric(&rates);
        is_sound.then_some(Self {
            scale,
            compliance,
            rates,
        })
    }

    /// All finite factors, by magnitude, and the motions of their shapes; `None` where A is
    /// not definite.
    fn factors(&self) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
        let own = self.compliance.self_adjoint_eigen(Side::Lower).ok()?;
        let values: Vec<_> = own.S().column_vector().iter().copied().collect();
        let largest = values.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        if values.iter().any(|value| *value < -SYMMETRIC * largest) {
            return None;
        }
        let kept: Vec<_> = (0..values.len())
            .filter(|&j| values[j] > ZERO * largest)
            .collect();
        let root = Mat::from_fn(values.len(), kept.len(), |i, j| {
            own.U()[(i, kept[j])] * values[kept[j]].sqrt()
        });
        let turned = root.transpose() * &self.rates * &root;
        let turned = Mat::from_fn(kept.len(), kept.len(), |i, j| {
            0.5 * (turned[(i, j)] + turned[(j, i)])
        });
        let inverted = turned.self_adjoint_eigen(Side::Lower).ok()?;
        let inverses: Vec<_> = inverted.S().column_vector().iter().copied().collect();
        let largest = inverses.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        let finite = |j: &usize| inverses[*j].abs() > INFINITE * largest;
        let mut order: Vec<_> = (0..inverses.len()).filter(finite).collect();
        order.sort_by(|i, j| inverses[*j].abs().total_cmp(&inverses[*i].abs()));
        let motions = &root * inverted.U();
        let motion = |j: &usize| -> Vec<f64> {
            let column = motions.col(*j);
            column
                .iter()
                .zip(&self.scale)
                .map(|(value, scale)| value * scale)
                .collect()
        };
        Some((
            order.iter().map(|j| 1.0 / inverses[*j]).collect(),
            order.iter().map(motion).collect(),
        ))
    }
}

/// K_1 at the given rows and columns, scaled on both sides and by `factor`; `None` where it
/// has others.
fn scaled(
    entries: &[Entry],
    (places, rows): (&[usize], &[usize]),
    scale: &[f64],
    factor: f64,
) -> Option<Mat<f64>> {
    let mut matrix = Mat::zeros(places.len(), places.len());
    for (row, column, value) in entries {
        let i = rows.binary_search(row).ok()?;
        let j = places.binary_search(column).ok()?;
        matrix[(i, j)] += factor * scale[i] * value * scale[j];
    }
    Some(matrix)
}

fn is_symmetric(matrix: &Mat<f64>) -> bool {
    let n = matrix.nrows();
    let largest = matrix.norm_max();
    let pairs = (0..n).flat_map(|j| (0..j).map(move |i| (i, j)));
    let mut off = pairs.map(|(i, j)| (matrix[(i, j)] - matrix[(j, i)]).abs());
    largest.is_finite() && off.all(|off| off <= SYMMETRIC * largest)
}
