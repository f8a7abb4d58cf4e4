//! Eigenvalues of the linearized system nearest to zero, and their vectors.
//!
//! ```text
//! (F_y + s F_y') v = 0
//! ```
//!
//! The values are found by inversion ([`super::inverse`]), the vectors by inverse
//! iteration on the original matrices, for all copies of a repeated value at once: a
//! round blade, or a rotor of equal blades, has every frequency several times.

use faer::{Mat, c64};

use super::copies::{CONFIRMED, groups, is_independent, orthonormalize, product};
use super::eigenpair::Eigenpair;
use super::frequencies::{fastest, highest_of_a_node, masses, undamped};
use super::inverse::{DENSE, INFINITE, Inverse};
use super::krylov::{Found, start_value};
use super::ritz::Ready;
use super::round_off::RoundOff;
use super::shift::{LOOKS, SHIFT, Search};
use super::sorted::{Sorted, copies_at_front};
use crate::assembly::{Entry, MasslessMotions, Tangent};
use crate::model::NODE_UNKNOWNS;
use crate::solver::{ComplexFactorization, LinearSolver};

/// The matrix is inverted this part beside the eigenvalue: near enough that one
/// iteration suffices, far enough that the factorization keeps its digits.
const BESIDE: f64 = 1e-10;
/// Frequencies below this part of the highest frequency of a node on its own are zero:
/// stiffness is known to 1e-16 of its largest, frequencies to the root of that.
const ZERO: f64 = 3e-8;
/// The shift for the vectors of such motions, in parts of the lowest other frequency.
const FREE_SHIFT: f64 = 1e-2;
/// A free body has six.
const FREE: usize = 8;
/// The first shift, in parts of the highest frequency of a single node.
const BELOW: f64 = 1e-5;
/// Largest number of computed eigenvalues, as a multiple of the requested oscillations.
const MOST: usize = 8;
/// Inverse iterations; the first already leaves other modes smaller by 1e-10 over
/// their distance.
const ITERATIONS: usize = 3;
/// Part of a vector by which inverse iteration may change it for the last time: the rest
/// shrinks by 1e-10 over the distance of the other modes.
const PARALLEL_BY: f64 = 1e-8;

/// The lowest modes of a system.
#[derive(Debug, Clone, Default)]
pub struct Lowest {
    /// Pairs of oscillations and of motions without stiffness, by their frequency.
    pub pairs: Vec<Eigenpair>,
    /// Real eigenvalues that were found on the way [1/s].
    pub real: Vec<f64>,
    /// Number of oscillations that were found but that no vector confirmed.
    pub unconfirmed: usize,
    /// Whether the model has no others, if these are fewer than requested.
    pub is_all: bool,
}

/// A linearized system, ready for its eigenvalues.
#[derive(Debug)]
pub struct EigenProblem<'a> {
    solver: &'a LinearSolver,
    tangent: &'a Tangent,
    massless: &'a MasslessMotions,
    /// Entries of `F_y'`, without the momenta of motions that move no mass.
    rates: Vec<Entry>,
    inverse: Inverse,
    /// Unknowns of the nodes.
    size: usize,
    /// Copies of one value that are looked for.
    copies: usize,
    /// Magnitude of the lowest that is not [1/s].
    lowest: f64,
    /// The system without the forces of the air, if there is air.
    vacuum: Option<&'a Tangent>,
}

impl<'a> EigenProblem<'a> {
    /// Prepares the eigenvalues of `tangent` of a system with motions that move no mass,
    /// with up to `copies` of one value; `None` when something moves that neither mass nor
    /// stiffness determines.
    ///
    /// The shift is a part of the lowest frequency, which a coarse look from a shift
    /// below all frequencies finds, and from others where that shows little.
    pub fn new(
        solver: &'a LinearSolver,
        tangent: &'a Tangent,
        massless: &'a MasslessMotions,
        copies: usize,
    ) -> Option<Self> {
        // Where nothing has stiffness, all frequencies are zero, in any unit.
        let highest = highest_of_a_node(tangent, massless.nodes()).unwrap_or(1.0);
        let round_off = RoundOff::new(tangent, NODE_UNKNOWNS * massless.nodes());
        let mut search = Search::new(BELOW * highest, highest, ZERO * highest);
        let mut last = None;
        let mut is_certain = false;
        for _ in 0..LOOKS {
            let found = Self::shifted(solver, tangent, massless, copies, search.shift);
            let Some(mut problem) = found else {
                search.singular();
                is_certain = false;
                continue;
            };
            problem.know(search.zero_and_lowest());
            if is_certain {
                return Some(problem);
            }
            let look = search.look(&problem.inverse, &round_off);
            problem.know(search.zero_and_lowest());
            if look.is_near {
                return Some(problem);
            }
            is_certain = look.is_certain;
            last = Some(problem);
        }
        last
    }

    /// The same with the tangent of the system in which no air acts, from which modes among slow states of the air
    /// are found.
    #[must_use]
    pub fn with_vacuum(self, vacuum: Option<&'a Tangent>) -> Self {
        Self { vacuum, ..self }
    }

    /// The system without the forces of the air, if there is air.
    pub(super) fn vacuum(&self) -> Option<&Tangent> {
        self.vacuum
    }

    /// Takes values up to `zero` for zero, and the lowest other one for known.
    fn know(&mut self, (zero, lowest): (f64, f64)) {
        self.inverse.set_zero(zero);
        self.lowest = lowest;
    }

    /// The same from a shift that is given.
    pub(super) fn shifted(
        solver: &'a LinearSolver,
        tangent: &'a Tangent,
        massless: &'a MasslessMotions,
        copies: usize,
        shift: f64,
    ) -> Option<Self> {
        let matrix = tangent.by_unknowns.plus(shift, &tangent.by_rates);
        let size = NODE_UNKNOWNS * massless.nodes();
        let rates = massless.rates(tangent);
        let masses = masses(tangent, size);
        Some(Self {
            solver,
            tangent,
            massless,
            inverse: Inverse::new(solver.factorize(matrix)?, &rates, &masses, shift)?,
            rates,
            size,
            copies,
            lowest: 0.0,
            vacuum: None,
        })
    }

    /// The `count` eigenpairs of smallest angular frequency, ascending, where there are
    /// so many, those without stiffness first; and the other eigenpairs that were found.
    pub fn lowest(&self, count: usize) -> Lowest {
        let (free, sorted, is_all, space) = self.sorted(count);
        let mut pairs = self.free(free.min(count));
        if self.is_crowded(&sorted, count - pairs.len()) {
            return self.lowest_of_crowd(pairs, &sorted, count);
        }
        let Sorted { real, above, .. } = sorted;
        let mut unconfirmed = 0;
        let fastest = fastest(self.tangent, self.size);
        let first = above.len().min(count + self.copies);
        let ready = Ready::new(&self.inverse, space.as_ref(), &above[..first], self.size);
        let mut rest = &above[..];
        while let Some(first) = rest.first().filter(|_| pairs.len() < count) {
            let copies = copies_at_front(rest);
            let found = ready.pairs(&rest[..copies]);
            let mut found = found.unwrap_or_else(|| self.vectors(&rest[..copies]));
            // Multipliers, whose values are infinite, become large ones by round-off,
            // which no vector confirms.
            found.retain(|pair| (pair.value() - first).norm() <= CONFIRMED * first.norm());
            if first.norm() <= fastest {
                unconfirmed += copies - found.len();
            }
            pairs.append(&mut found);
            rest = &rest[copies..];
        }
        pairs.truncate(count);
        self.clear_round_off(&mut pairs);
        Lowest {
            pairs,
            real: self.confirmed(real),
            unconfirmed,
            is_all: is_all && unconfirmed == 0,
        }
    }

    /// As [`Self::lowest`], after the motions without stiffness, where real values of scalars are
    /// nearer than the oscillations. Of the real values only growing ones are reported.
    fn lowest_of_crowd(&self, mut pairs: Vec<Eigenpair>, sorted: &Sorted, count: usize) -> Lowest {
        let (mut found, unconfirmed) = self.beside_states(count - pairs.len());
        pairs.append(&mut found);
        self.clear_round_off(&mut pairs);
        let growing = sorted.real.iter().copied().filter(|value| *value > 0.0);
        Lowest {
            pairs,
            real: self.confirmed(growing.collect()),
            unconfirmed,
            is_all: false,
        }
    }

    /// Real values without those that no vector confirms.
    fn confirmed(&self, mut real: Vec<f64>) -> Vec<f64> {
        real.retain(|&value| {
            let found = || self.vectors(&[c64::new(value, 0.0)]).into_iter().next();
            let is_same = |pair: Eigenpair| (pair.growth - value).abs() <= CONFIRMED * value.abs();
            value == 0.0 || found().is_some_and(is_same)
        });
        real
    }

    /// The pair of a real value [1/s] that [`Self::lowest`] found.
    pub fn real_pair(&self, value: f64) -> Eigenpair {
        let beside = c64::new(value * (1.0 + BESIDE), 0.0);
        let pair = self.vectors_beside(beside, 1).into_iter().next();
        pair.unwrap_or_else(|| {
            Eigenpair::new(
                c64::new(value, 0.0),
                &vec![c64::new(0.0, 0.0); self.size],
                0.0,
            )
        })
    }

    /// The values nearest to the shift, as many as hold `count` oscillations, where real
    /// ones of overdamped motions do not use up too many; and how many motions without
    /// stiffness there are; whether they are all that the system has; and the space of their
    /// vectors, if it was built.
    fn sorted(&self, count: usize) -> (usize, Sorted, bool, Option<Found>) {
        let fastest = fastest(self.tangent, self.size);
        let mut requested = count;
        let mut counted = None;
        loop {
            let (values, space) = self.inverse.nearest(requested, self.copies, DENSE);
            let is_all = values.len() < 2 * requested;
            let distance = |s: &c64| (s - self.inverse.shift()).norm();
            let nearest = values.iter().map(distance).fold(f64::INFINITY, f64::min);
            let mut sorted = Sorted::new(values, self.inverse.zero());
            let free = match sorted.zeros {
                0 => 0,
                zeros => *counted.get_or_insert_with(|| self.free_motions(zeros)),
            };
            // The other zeros are of scalars that hardly change, as in a frozen wake; the one of a free
            // motion is double.
            sorted.zeros = sorted.zeros.saturating_sub(2 * free);
            let is_crowded = self.is_crowded(&sorted, count.saturating_sub(free));
            if free + sorted.above.len() >= count
                || is_all
                || is_crowded
                || requested >= MOST * count
            {
                let is_all = is_all && nearest >= INFINITE * fastest;
                return (free, sorted, is_all, space);
            }
            requested *= 2;
        }
    }

    /// Copies of one value that are looked for.
    pub(super) fn copies(&self) -> usize {
        self.copies
    }

    /// Unknowns of the nodes.
    pub(super) fn size(&self) -> usize {
        self.size
    }

    /// The linearized system.
    pub(super) fn tangent(&self) -> &Tangent {
        self.tangent
    }

    /// The factors of `F_y + s F_y'`.
    pub(super) fn factorized(&self, s: c64) -> Option<ComplexFactorization> {
        let Tangent {
            by_unknowns,
            by_rates,
        } = self.tangent;
        self.solver.factorize_complex(by_unknowns, s, by_rates)
    }

    /// Whether scalars have rates.
    pub(super) fn has_slow_scalars(&self) -> bool {
        let mut rates = self.rates.iter();
        rates.any(|(_, column, value)| *column >= self.size && *value != 0.0)
    }

    /// Entries of the derivatives by rates.
    pub(super) fn rates(&self) -> &[Entry] {
        &self.rates
    }

    /// The inverted problem.
    pub(super) fn inverse(&self) -> &Inverse {
        &self.inverse
    }

    /// Motions without stiffness: from a shift far below the lowest frequency.
    fn free(&self, count: usize) -> Vec<Eigenpair> {
        if count == 0 {
            return Vec::new();
        }
        // Slow charges lie as near.
        let alone = self.without_circuits(self.tangent);
        let alone = alone.as_ref().and_then(|tangent| self.beside(tangent));
        let problem = alone.as_ref().unwrap_or(self);
        let beside = (FREE_SHIFT * self.lowest).max(self.inverse.zero().min(SHIFT * self.lowest));
        let mut pairs = problem.vectors_beside(c64::new(beside, 0.0), count);
        for pair in &mut pairs {
            (pair.growth, pair.angular_frequency, pair.residual) = (0.0, 0.0, 0.0);
        }
        pairs
    }

    /// Number of motions without stiffness, where so many values are zero. The zero of one
    /// is double, but simple where a damper acts on it, and a charge that leaks away slowly
    /// is no motion: they are counted without dampers and circuits.
    fn free_motions(&self, zeros: usize) -> usize {
        let alone = self.without_circuits(self.tangent);
        let alone = match undamped(alone.as_ref().unwrap_or(self.tangent)) {
            Some(undamped) => Some(undamped),
            None => alone,
        };
        let beside = alone.as_ref().and_then(|tangent| self.beside(tangent));
        let inverse = beside
            .as_ref()
            .map_or(&self.inverse, |beside| &beside.inverse);
        // A block sees as many as it has vectors: those that it sees are all once they are
        // fewer.
        let mut block = self.copies.max(zeros.div_ceil(2) + 1).max(FREE);
        loop {
            let values = inverse.smallest(block, block, DENSE);
            let zeros = values
                .iter()
                .filter(|s| s.norm() <= self.inverse.zero())
                .count();
            // A third one is of the round-off; a single one of a motion whose rate is held.
            let free = if zeros > 1 { zeros / 2 } else { zeros };
            if free < block || values.len() < 2 * block {
                return free;
            }
            block *= 2;
        }
    }

    /// The eigenvalue problem of another system with the same unknowns.
    pub(super) fn beside<'b>(&self, tangent: &'b Tangent) -> Option<EigenProblem<'b>>
    where
        'a: 'b,
    {
        let shift = self.inverse.shift();
        let problem =
            EigenProblem::shifted(self.solver, tangent, self.massless, self.copies, shift);
        let mut problem = problem?;
        problem.know((self.inverse.zero(), self.lowest));
        Some(problem)
    }

    /// The same system with circuits as they act on a motion that grows at the lowest
    /// frequency: without poles of their own, and never singular, since no circuit grows by
    /// itself. `None` without circuits that have any.
    pub(super) fn without_circuits(&self, tangent: &Tangent) -> Option<Tangent> {
        let indices: Vec<_> = tangent.by_rates.triplets().enumerate().collect();
        let of_circuits = indices
            .iter()
            .filter(|(_, (_, column, value))| *column >= self.size && *value != 0.0);
        let mut result = tangent.clone();
        let mut has_circuits = false;
        for (index, (_, _, value)) in of_circuits {
            result.by_rates.values_mut()[*index] = 0.0;
            result.by_unknowns.values_mut()[*index] += self.lowest * value;
            has_circuits = true;
        }
        has_circuits.then_some(result)
    }

    /// Independent vectors of a value and its copies; of values that lie near each other
    /// but are not the same, each with its own.
    pub(super) fn vectors(&self, copies: &[c64]) -> Vec<Eigenpair> {
        let beside = |values: &[c64]| {
            let mean = values.iter().sum::<c64>() / values.len() as f64;
            self.vectors_beside(mean * (1.0 + BESIDE), values.len())
        };
        let together = beside(copies);
        let groups = groups(&together.iter().map(Eigenpair::value).collect::<Vec<_>>());
        if groups.len() < 2 {
            return together;
        }
        let apart: Vec<_> = groups.iter().flat_map(|group| beside(group)).collect();
        // Copies that differ only by round-off may be found twice.
        if is_independent(&apart) {
            apart
        } else {
            together
        }
    }

    /// The `count` eigenpairs nearest to `beside`.
    fn vectors_beside(&self, beside: c64, count: usize) -> Vec<Eigenpair> {
        let by_rates = &self.tangent.by_rates;
        let solved = self
            .factorized(beside)
            .and_then(|matrix| self.iterate(&matrix, count));
        // Where the inversion overflows there is no vector: the mode moves nothing.
        let all = by_rates.pattern().size();
        let nothing = || (vec![vec![c64::new(0.0, 0.0); all]; count], Vec::new());
        let (vectors, factors) = solved.unwrap_or_else(nothing);
        let mut values: Vec<_> = factors.iter().map(|factor| beside - factor.inv()).collect();
        values.resize(count, beside);
        if groups(&values).len() < 2 {
            let mean = values.iter().sum::<c64>() / count as f64;
            values.fill(mean);
        }
        let pair = |(vector, s): (Vec<c64>, c64)| {
            Eigenpair::new(s, &vector[..self.size], self.inverse.residual(s, &vector))
        };
        vectors.into_iter().zip(values).map(pair).collect()
    }

    /// `x <- (F_y + beside F_y')^-1 F_y' x`, orthonormal, for several x at once, and the
    /// factors `1 / (beside - s)` by which they grow: the eigenvalues of the operator
    /// projected on them; `None` when a solution is not finite. On one side of the shift
    /// and on the other they have opposite signs, so that a mean would not do.
    fn iterate(&self, matrix: &ComplexFactorization, count: usize) -> Option<Vectors> {
        let n = self.tangent.by_rates.pattern().size();
        let start = |copy: usize| {
            let value = |i: usize| {
                c64::new(
                    start_value(i + copy * n),
                    start_value(i + (copy + count) * n),
                )
            };
            (0..n).map(value).collect::<Vec<_>>()
        };
        let mut vectors: Vec<_> = (0..count).map(start).collect();
        let mut factors = Vec::new();
        for _ in 0..ITERATIONS {
            let before = vectors.clone();
            for vector in &mut vectors {
                *vector = self.rates_times(vector);
                matrix.solve(vector)?;
            }
            // The vectors before the last iteration are orthonormal; the others are not used.
            let projected = Mat::from_fn(count, count, |i, j| {
                product(&before[i], &vectors[j], self.size)
            });
            factors = projected.eigenvalues().unwrap_or_default();
            let is_found =
                count == 1 && self.is_parallel(&vectors[0], &before[0], projected[(0, 0)]);
            orthonormalize(&mut vectors, self.size);
            if is_found {
                break;
            }
        }
        let sound = |factor: &c64| factor.is_finite() && factor.norm() > 0.0;
        factors.retain(sound);
        Some((vectors, factors))
    }

    /// Whether `x` is `factor` times the unit vector `before`, so nearly that the next product
    /// would not change it.
    fn is_parallel(&self, x: &[c64], before: &[c64], factor: c64) -> bool {
        let off: Vec<_> = x.iter().zip(before).map(|(x, b)| x - factor * b).collect();
        let size = |x: &[c64]| product(x, x, self.size).re;
        size(&off) <= PARALLEL_BY.powi(2) * size(x)
    }

    /// `F_y' x`.
    pub(super) fn rates_times(&self, x: &[c64]) -> Vec<c64> {
        let mut product = vec![c64::new(0.0, 0.0); x.len()];
        for &(i, j, value) in &self.rates {
            product[i] += x[j] * value;
        }
        product
    }
}

/// Vectors of copies, and the factors by which the last iteration made them grow.
type Vectors = (Vec<Vec<c64>>, Vec<c64>);
