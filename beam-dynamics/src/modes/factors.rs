//! All real factors at which a tangent is singular, and their shapes.
//!
//! ```text
//! ( K_0 + lambda K_1 ) v = 0                                                    (D-70)
//! ```
//!
//! Where the two are symmetric, with A the part of `K_0^-1` that leads from the forces and
//! moments on the motions S that K_1 works on to these motions, positive or negative
//! definite for all that can move,
//!
//! ```text
//! A = s L L^T,   s = +-1       - s L^T K_1 L z = z / lambda,    v_S = L z         (D-274)
//! ```
//!
//! is one symmetric matrix. All its eigenvalues are computed at once, repeated ones with all
//! their shapes: none can be lost, and if all vanish there is no critical load. In
//! a column with torsional prestress every evaluation point buckles at the same load, and most
//! of the eigenvalues of `- K_0^-1 K_1` are zero. Follower loads, finite volumes and unstable
//! equilibria give other matrices: of small ones all eigenvalues are computed too, of large
//! ones only the largest.

use faer::{Mat, Side, c64};

use super::copies::CONFIRMED;
use super::eigen::EigenProblem;
use super::eigenpair::Eigenpair;
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
/// Values this near to each other are found together.
const NEAR: f64 = 1e-5;
/// Factors beyond this part of the lowest are infinite.
const INFINITE: f64 = 1e-9;
/// Relative error of a pair from which on it is none.
const NO_PAIR: f64 = 1e-5;

/// Real factors of smallest magnitude.
#[derive(Debug, Clone, Default)]
pub struct Factors {
    /// The factors, as growth, with their shapes.
    pub pairs: Vec<Eigenpair>,
    /// Whether no other factor has a smaller magnitude than the largest of these, or, if they
    /// are fewer than requested, whether no other exists.
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
        self.pairs_of(self.real_values(count, DENSE))
    }

    /// At most `count` real eigenvalues of smallest magnitude, all being computed of problems
    /// of up to `dense` unknowns.
    fn real_values(&self, count: usize, dense: usize) -> Vec<f64> {
        let mut values = self.inverse().smallest(count, self.copies(), dense);
        values.retain(|s| s.im.abs() <= OSCILLATING.sqrt() * s.norm());
        values.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        values.truncate(count);
        values.iter().map(|s| s.re).collect()
    }

    /// The pairs of real values by magnitude, near ones together: each is found once.
    fn pairs_of(&self, values: Vec<f64>) -> Vec<Eigenpair> {
        let mut pairs: Vec<Eigenpair> = Vec::with_capacity(values.len());
        let mut sorted = values;
        sorted.sort_by(f64::total_cmp);
        let mut rest = &sorted[..];
        while let Some(first) = rest.first() {
            let is_near = |value: &&f64| (**value - first).abs() <= NEAR * first.abs();
            let (near, others) = rest.split_at(rest.iter().take_while(is_near).count().max(1));
            let near: Vec<_> = near.iter().map(|value| c64::new(*value, 0.0)).collect();
            pairs.extend(self.vectors(&near));
            rest = others;
        }
        pairs.sort_by(|a, b| a.growth.abs().total_cmp(&b.growth.abs()));
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
        // Infinite values become large ones by round-off, which no vector confirms.
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
        match Compliance::new(self).and_then(|compliance| compliance.factors()) {
            Some(mut factors) => {
                factors.truncate(count);
                Factors::of(self.pairs_of(factors), true)
            }
            None => Factors::of(
                self.pairs_of(self.real_values(count, ALL)),
                self.inverse().is_small(count, ALL),
            ),
        }
    }
}

impl Factors {
    /// Without pairs that are none.
    fn of(mut pairs: Vec<Eigenpair>, is_complete: bool) -> Self {
        let found = pairs.len();
        // NaN is kept, so that it is reported.
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
    compliance: Mat<f64>,
    rates: Mat<f64>,
}

/// The force or moment that a motion of a node is balanced by.
fn balance(index: usize) -> Option<usize> {
    let number = index % NODE_UNKNOWNS;
    let is_motion = number < Variable::Rotation.column() + 3;
    is_motion.then(|| index + Equation::Force.row())
}

impl Compliance {
    /// `None` where the matrices are no symmetric ones of moderate size.
    fn new(problem: &EigenProblem<'_>) -> Option<Self> {
        let rates = problem.rates();
        let mut indices: Vec<_> = rates.iter().map(|entry| entry.1).collect();
        indices.sort_unstable();
        indices.dedup();
        let is_of_node = |index: &usize| *index < problem.size() && balance(*index).is_some();
        if indices.len() > WHOLE || !indices.iter().all(is_of_node) {
            return None;
        }
        let rows: Vec<_> = indices.iter().filter_map(|index| balance(*index)).collect();
        let inverse = problem.inverse().columns(&rows)?;
        let n = indices.len();
        let all = Mat::from_fn(n, n, |i, j| inverse[(indices[i], j)]);
        let sign = (0..n).map(|i| all[(i, i)]).sum::<f64>().signum();
        let scale = |i: usize| {
            if sign * all[(i, i)] > 0.0 {
                all[(i, i)].abs().sqrt()
            } else {
                0.0
            }
        };
        let scale: Vec<_> = (0..n).map(scale).collect();
        let by = |i: usize| if scale[i] > 0.0 { 1.0 / scale[i] } else { 0.0 };
        let compliance = Mat::from_fn(n, n, |i, j| sign * by(i) * all[(i, j)] * by(j));
        let rates = scaled(rates, (&indices, &rows), &scale, -sign)?;
        let is_sound = is_symmetric(&compliance) && is_symmetric(&rates);
        is_sound.then_some(Self { compliance, rates })
    }

    /// All finite factors, by magnitude; `None` where A is not definite.
    fn factors(&self) -> Option<Vec<f64>> {
        let own = self.compliance.self_adjoint_eigen(Side::Lower).ok()?;
        let values: Vec<_> = own.S().column_vector().iter().copied().collect();
        let largest = values.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        if values.iter().any(|value| *value < -SYMMETRIC * largest) {
            return None;
        }
        let n = values.len();
        let root = Mat::from_fn(n, n, |i, j| own.U()[(i, j)] * values[j].max(0.0).sqrt());
        let turned = root.transpose() * &self.rates * &root;
        let turned = Mat::from_fn(n, n, |i, j| 0.5 * (turned[(i, j)] + turned[(j, i)]));
        let inverses = turned.self_adjoint_eigenvalues(Side::Lower).ok()?;
        let largest = inverses.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        let finite = inverses
            .iter()
            .filter(|value| value.abs() > INFINITE * largest);
        let mut factors: Vec<_> = finite.map(|value| 1.0 / value).collect();
        factors.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        Some(factors)
    }
}

/// K_1 at the given rows and columns, scaled on both sides and by `factor`; `None` where it
/// has others.
fn scaled(
    entries: &[Entry],
    (indices, rows): (&[usize], &[usize]),
    scale: &[f64],
    factor: f64,
) -> Option<Mat<f64>> {
    let mut matrix = Mat::zeros(indices.len(), indices.len());
    for (row, column, value) in entries {
        let i = rows.binary_search(row).ok()?;
        let j = indices.binary_search(column).ok()?;
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
