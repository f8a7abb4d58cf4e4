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

use super::frequencies::{highest_of_a_node, lowest_oscillation};
use super::inverse::{DENSE, Inverse};
use super::krylov::start_value;
use super::sorted::Sorted;
use crate::assembly::{Entry, MasslessMotions, Tangent};
use crate::model::NODE_UNKNOWNS;
use crate::solver::{ComplexFactorization, LinearSolver};

/// Values within this part of each other are copies of one value: far above the
/// round-off of the eigenvalues of stiff models, far below what frequencies differ by.
pub(super) const COPIES: f64 = 1e-6;
/// Values within this part of each other cannot be told apart.
const SAME: f64 = 1e-9;
/// Two unit vectors of more overlap than this are one and the same.
const PARALLEL: f64 = 0.9;
/// The matrix is inverted this part beside the eigenvalue: near enough that one
/// iteration suffices, far enough that the factorization keeps its digits.
const BESIDE: f64 = 1e-10;
/// The shift of the inversion, in parts of the lowest frequency.
const SHIFT: f64 = 0.3;
/// Parts of the shift below which a value may be a zero that round-off has split: those of
/// motions without stiffness are double, and come apart by the root of the round-off.
const SPLIT: f64 = 0.1;
/// Parts of itself in which a value is seen again from a shift beside it, where a split zero
/// has moved toward zero with the shift.
const STAYS: std::ops::Range<f64> = 0.7..1.5;
/// Frequencies below this part of the highest frequency of a node on its own are zero:
/// stiffness is known to 1e-16 of its largest, frequencies to the root of that.
const ZERO: f64 = 3e-8;
/// The shift for the vectors of such motions, in parts of the lowest other frequency.
const FREE_SHIFT: f64 = 1e-2;
/// The first shift, in parts of the highest frequency of a node on its own.
const BELOW: f64 = 1e-5;
/// Eigenvalues that are asked for at most, in parts of the oscillations that are wanted.
const MOST: usize = 8;
/// Inverse iterations; the first already leaves other modes smaller by 1e-10 over
/// their distance.
const ITERATIONS: usize = 3;
/// Part of a vector by which inverse iteration may change it for the last time: the rest
/// shrinks by 1e-10 over the distance of the other modes.
const PARALLEL_BY: f64 = 1e-8;
/// Part of itself by which inverse iteration may change a value that it confirms.
pub(super) const CONFIRMED: f64 = 1e-3;

/// An eigenvalue `s` [1/s] and its vector: twelve entries a node.
#[derive(Debug, Clone)]
pub struct Eigenpair {
    /// Real part of s: growth [1/s].
    pub growth: f64,
    /// Imaginary part of s: angular frequency [rad/s].
    pub angular_frequency: f64,
    /// Real parts of the vector [unit of each unknown].
    pub real: Vec<f64>,
    /// Imaginary parts of the vector [unit of each unknown].
    pub imaginary: Vec<f64>,
    /// Error of the pair in the inverted problem, relative [-].
    pub residual: f64,
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
    /// Magnitude below which an eigenvalue is zero [1/s].
    zero: f64,
    /// Magnitude of the lowest that is not [1/s].
    lowest: f64,
}

impl<'a> EigenProblem<'a> {
    /// Prepares the eigenvalues of `tangent` of a system with motions that move no mass,
    /// with up to `copies` of one value; `None` when something moves that neither mass nor
    /// stiffness determines.
    ///
    /// The shift is a part of the lowest frequency, which a coarse look from a shift
    /// below all frequencies finds.
    pub fn new(
        solver: &'a LinearSolver,
        tangent: &'a Tangent,
        massless: &'a MasslessMotions,
        copies: usize,
    ) -> Option<Self> {
        // Where nothing has stiffness, all frequencies are zero, in any unit.
        let highest = highest_of_a_node(tangent, massless.nodes()).unwrap_or(1.0);
        let coarse = Self::shifted(solver, tangent, massless, copies, BELOW * highest)?;
        let shift = coarse.inverse.shift();
        let zero = ZERO * highest;
        let values = coarse.inverse.coarse();
        let above = |size: f64| lowest_oscillation(&values, size).unwrap_or(highest);
        let mut lowest = above(3.0 * zero);
        if lowest < SPLIT * shift {
            let nearer = Self::shifted(solver, tangent, massless, copies, SHIFT * lowest);
            let stays = |s: &c64| STAYS.contains(&(s.norm() / lowest));
            if !nearer.is_some_and(|nearer| nearer.inverse.coarse().iter().any(stays)) {
                lowest = above(SPLIT * shift);
            }
        }
        let mut problem = if (SHIFT / 10.0 * lowest..10.0 * SHIFT * lowest).contains(&shift) {
            coarse
        } else {
            Self::shifted(solver, tangent, massless, copies, SHIFT * lowest)?
        };
        (problem.zero, problem.lowest) = (zero, lowest);
        Some(problem)
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
        Some(Self {
            solver,
            tangent,
            massless,
            inverse: Inverse::new(solver.factorize(matrix)?, &rates, size, shift)?,
            rates,
            size,
            copies,
            zero: 0.0,
            lowest: 0.0,
        })
    }

    /// The `count` eigenpairs of smallest angular frequency, ascending, where there are
    /// so many, those without stiffness first; and the real eigenvalues found on the way.
    pub fn lowest(&self, count: usize) -> (Vec<Eigenpair>, Vec<f64>) {
        let (free, Sorted { real, above, .. }) = self.sorted(count);
        let mut pairs = self.free(free.min(count));
        let mut rest = &above[..];
        while let Some(first) = rest.first().filter(|_| pairs.len() < count) {
            let copies = copies_at_front(rest);
            let found = self.vectors(&rest[..copies]);
            // Multipliers, whose values are infinite, come out as large ones by round-off,
            // which no vector confirms.
            let s = |pair: &Eigenpair| c64::new(pair.growth, pair.angular_frequency);
            let confirmed = |pair: &Eigenpair| (s(pair) - first).norm() <= CONFIRMED * first.norm();
            pairs.extend(found.into_iter().filter(confirmed));
            rest = &rest[copies..];
        }
        pairs.truncate(count);
        (pairs, self.confirmed(real))
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

    /// The values nearest to the shift, as many as hold `count` oscillations, where real
    /// ones of overdamped motions do not use up too many; and how many motions without
    /// stiffness there are.
    fn sorted(&self, count: usize) -> (usize, Sorted) {
        let mut asked = count;
        loop {
            let values = self.inverse.smallest(asked, self.copies, DENSE);
            let is_all = values.len() < 2 * asked;
            let sorted = Sorted::new(values, self.zero);
            let free = self.free_motions(sorted.zeros, asked);
            if free + sorted.above.len() >= count || is_all || asked >= MOST * count {
                return (free, sorted);
            }
            asked *= 2;
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
        let mut pairs = problem.vectors_beside(c64::new(FREE_SHIFT * self.lowest, 0.0), count);
        for pair in &mut pairs {
            (pair.growth, pair.angular_frequency, pair.residual) = (0.0, 0.0, 0.0);
        }
        pairs
    }

    /// Number of motions without stiffness. The zero of one is double, but simple where a
    /// damper acts on it, and a charge that leaks away slowly is no motion: they are counted
    /// without dampers and circuits.
    fn free_motions(&self, zeros: usize, count: usize) -> usize {
        if zeros == 0 {
            return 0;
        }
        let alone = self.without_circuits(self.tangent);
        let alone = match undamped(alone.as_ref().unwrap_or(self.tangent)) {
            Some(undamped) => Some(undamped),
            None => alone,
        };
        let counted = alone.as_ref().and_then(|tangent| {
            let values = self
                .beside(tangent)?
                .inverse
                .smallest(count, self.copies, DENSE);
            Some(values.iter().filter(|s| s.norm() <= self.zero).count())
        });
        counted.unwrap_or(zeros).div_ceil(2)
    }

    /// The same question to another system of the same unknowns.
    fn beside<'b>(&self, tangent: &'b Tangent) -> Option<EigenProblem<'b>>
    where
        'a: 'b,
    {
        let shift = self.inverse.shift();
        EigenProblem::shifted(self.solver, tangent, self.massless, self.copies, shift)
    }

    /// The same system with circuits as they are for what grows at a rate, the lowest
    /// frequency: without poles of their own, and never singular, since no circuit grows by
    /// itself. `None` without circuits that have any.
    fn without_circuits(&self, tangent: &Tangent) -> Option<Tangent> {
        let places: Vec<_> = tangent.by_rates.triplets().enumerate().collect();
        let of_circuits = places
            .iter()
            .filter(|(_, (_, column, value))| *column >= self.size && *value != 0.0);
        let mut result = tangent.clone();
        let mut has_circuits = false;
        for (place, (_, _, value)) in of_circuits {
            result.by_rates.values_mut()[*place] = 0.0;
            result.by_unknowns.values_mut()[*place] += self.lowest * value;
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
        let value = |pair: &Eigenpair| c64::new(pair.growth, pair.angular_frequency);
        let groups = groups(&together.iter().map(value).collect::<Vec<_>>());
        if groups.len() < 2 {
            return together;
        }
        let apart: Vec<_> = groups.iter().flat_map(|group| beside(group)).collect();
        // Copies that only round-off tells apart may come out twice.
        match is_independent(&apart) {
            true => apart,
            false => together,
        }
    }

    /// The `count` eigenpairs nearest to `beside`.
    fn vectors_beside(&self, beside: c64, count: usize) -> Vec<Eigenpair> {
        let Tangent {
            by_unknowns,
            by_rates,
        } = self.tangent;
        let solved = self
            .solver
            .factorize_complex(by_unknowns, beside, by_rates)
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
        let pair = |(vector, s): (Vec<c64>, c64)| Eigenpair {
            growth: s.re,
            angular_frequency: s.im,
            real: vector[..self.size].iter().map(|v| v.re).collect(),
            imaginary: vector[..self.size].iter().map(|v| v.im).collect(),
            residual: self.inverse.residual(s, &vector),
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
            // Those of the last iteration count, before which the vectors are orthonormal.
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
    fn rates_times(&self, x: &[c64]) -> Vec<c64> {
        let mut product = vec![c64::new(0.0, 0.0); x.len()];
        for &(i, j, value) in &self.rates {
            product[i] += x[j] * value;
        }
        product
    }
}

/// Number of values from the first on that are copies of it, itself included.
fn copies_at_front(values: &[c64]) -> usize {
    let is_copy = |s: &&c64| (**s - values[0]).norm() <= COPIES * values[0].norm();
    values.iter().take_while(is_copy).count().max(1)
}

/// The same system without dampers, which are the forces and moments by the velocities;
/// `None` where it has none.
fn undamped(tangent: &Tangent) -> Option<Tangent> {
    let is_damping = |&(row, column, value): &(usize, usize, f64)| {
        let half = NODE_UNKNOWNS / 2;
        value != 0.0 && row % NODE_UNKNOWNS >= half && column % NODE_UNKNOWNS < half
    };
    let mut result = tangent.clone();
    let places: Vec<_> = tangent.by_rates.triplets().enumerate().collect();
    let damping = places.iter().filter(|(_, entry)| is_damping(entry));
    let mut is_damped = false;
    for (place, _) in damping {
        result.by_rates.values_mut()[*place] = 0.0;
        is_damped = true;
    }
    is_damped.then_some(result)
}

/// Vectors of copies, and the factors by which the last iteration made them grow.
type Vectors = (Vec<Vec<c64>>, Vec<c64>);

/// Values that are the same up to round-off, put together; ascending.
fn groups(values: &[c64]) -> Vec<Vec<c64>> {
    let mut sorted = values.to_vec();
    sorted.sort_by(|a, b| a.im.total_cmp(&b.im).then(a.re.total_cmp(&b.re)));
    let mut groups: Vec<Vec<c64>> = Vec::new();
    for value in sorted {
        match groups.last_mut() {
            Some(group) if (value - group[0]).norm() <= SAME * value.norm() => group.push(value),
            _ => groups.push(vec![value]),
        }
    }
    groups
}

/// Whether no two of the vectors are nearly parallel.
fn is_independent(pairs: &[Eigenpair]) -> bool {
    let complex = |pair: &Eigenpair| -> Vec<c64> {
        let parts = pair.real.iter().zip(&pair.imaginary);
        parts.map(|(re, im)| c64::new(*re, *im)).collect()
    };
    let vectors: Vec<_> = pairs.iter().map(complex).collect();
    // The vectors are of unit size.
    let overlap = |i: usize, j: usize| product(&vectors[i], &vectors[j], vectors[i].len()).norm();
    (0..vectors.len()).all(|i| (0..i).all(|j| overlap(i, j) < PARALLEL))
}

/// `a^H b` over the positions and rotations of the nodes: the reactions, which follow
/// from these, are larger by the stiffness and would hide them.
fn product(a: &[c64], b: &[c64], size: usize) -> c64 {
    let is_motion = |i: &usize| i % NODE_UNKNOWNS < NODE_UNKNOWNS / 2;
    (0..size)
        .filter(is_motion)
        .map(|i| a[i].conj() * b[i])
        .sum()
}

/// Orthonormalizes by Gram and Schmidt, twice for the round-off.
fn orthonormalize(vectors: &mut [Vec<c64>], size: usize) {
    for j in 0..vectors.len() {
        let (before, rest) = vectors.split_at_mut(j);
        let vector = &mut rest[0];
        for other in before.iter().chain(before.iter()) {
            let along = product(other, vector, size);
            vector
                .iter_mut()
                .zip(other)
                .for_each(|(v, o)| *v -= along * o);
        }
        let norm = product(vector, vector, size).re.sqrt();
        if norm > 0.0 {
            vector.iter_mut().for_each(|v| *v /= norm);
        }
    }
}
