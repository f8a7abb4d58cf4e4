//! Solutions that decay along the beam, which ends and jumps of the load add to the central
//! solutions.
//!
//! Solutions `exp(lambda x)` of the section without load and without internal force, with P
//! the forces on the face, satisfy
//!
//! ```text
//! [E - lambda (C - C') - lambda^2 M] u + (R - lambda L) psi = 0
//! (R' + lambda L') u + A psi = 0                                                  (S-109)
//! ```
//!
//! They occur in pairs lambda and -lambda: one decays from each end. The operator that maps
//! (u', P') of a state to (u, P) has the eigenvalues 1/lambda on the states without
//! internal force and without rigid motion; it is one solution with the factored system of
//! steady states,
//!
//! ```text
//! C' u' + E u + R psi = P'      L' u' + R' u + A psi = 0      Ph' u = 0
//! P = M u' + C u + L psi                                                          (S-110)
//! ```
//!
//! which excludes the rigid motions and the central solutions: on a straight beam the
//! twelve zeros of the pencil, on a curved beam the eigenvalues at 0 and +-i |k|. Its
//! square has each 1/lambda^2 twice. Its eigenvalues of largest magnitude, the ones nearest
//! to zero of the pencil, are found in a block [`krylov`] space.
//!
//! # References
//! - [Giavotto1983], section 5: extremity solutions.
//! - [Masarati], appendix E.4.

mod krylov;
#[cfg(test)]
mod tests;

use super::particular::{Load, ParticularSolution};
use super::system::CentralSystem;
use crate::assembly::{Model, Rate, SectionForces, State};
use krylov::Space;
use nalgebra::{Complex, DMatrix, Matrix6};
use sparse_solver::eigenvalues_of;

/// Vectors of a block: the number that is solved at once.
const BLOCK: usize = 6;

/// Maximum number of blocks of the space.
const MOST_BLOCKS: usize = 64;

/// Rates are found nearest to zero first, but the real part of an oscillating rate is less
/// than its distance from zero: all rates are computed with `|lambda|` up to this factor
/// times the real part of the last requested rate. A rate is missed if its imaginary part
/// is more than twice its real part; the largest ratio observed in sections of admissible
/// orthotropic materials is 1.8.
const REACH: f64 = 2.2;

/// The same once [`MANY`] rates are found, which show the degree of oscillation of the
/// section.
const REACH_OF_MANY: f64 = 1.5;

/// Number of rates that show the degree of oscillation.
const MANY: usize = 12;

/// The same if some rates oscillate more: times the largest `|lambda|` over real part among
/// the rates found.
const MARGIN: f64 = 1.25;

/// Eigenvalues below this part of the largest are round-off.
const NEGLIGIBLE: f64 = 1e-13;

/// Number of vectors up to which the rates are evaluated after every block; later after
/// every tenth more.
const FEW: usize = 60;

/// Relative change of the rates since their last evaluation, a block or more before, at
/// which they are converged. It is the error of the previous rates, and further blocks gain
/// digits quickly.
const FOUND: f64 = 1e-9;

/// The same of rates that are not requested: accurate enough to show that they decay
/// faster.
const KNOWN: f64 = 5e-3;

/// Relative difference below which rates are one: copies of it, due to symmetry of the
/// section and to the square of the operator.
const COPIES: f64 = 1e-6;

/// The slowest of the decaying solutions.
#[derive(Debug, Clone, PartialEq)]
pub struct DecayRates {
    /// lambda, per unit of length of the domain, real part positive and ascending,
    /// imaginary part not negative; equal ones once \[-\].
    pub rates: Vec<Complex<f64>>,
    /// Largest relative change by the last vectors of the space; if the requested rates
    /// have converged but others that may be as slow have not, the change of the others
    /// \[-\].
    pub change: f64,
    /// Whether the change is small enough.
    pub is_converged: bool,
    /// Number of vectors of the space.
    pub vectors: usize,
}

/// The operator (S-110) in the units of the domain.
struct Shifted<'a, M> {
    model: &'a M,
    system: &'a CentralSystem<f64>,
    /// Ph.
    face: &'a DMatrix<f64>,
    forces: SectionForces,
}

/// Six states: warping and forces on the face.
struct States {
    u: DMatrix<f64>,
    p: DMatrix<f64>,
}

impl<M: Model> Shifted<'_, M> {
    /// Replaces the states by the states whose rates along the beam they are.
    fn multiply(&mut self, states: &mut States) -> Option<()> {
        let load = Load {
            within: &states.p,
            resultant: &Matrix6::zeros(),
            rate: Rate::Given(&states.u),
        };
        let found = ParticularSolution::solve(self.model, self.system, self.face, &load)?;
        let state = State {
            rate: Rate::Given(&states.u),
            warping: Some(&found.x),
            strain: &found.y,
        };
        self.model.measure(state, &mut self.forces);
        states.p.copy_from(&self.forces.face);
        states.u = found.x;
        Some(())
    }
}

impl DecayRates {
    /// The `wanted` slowest of the decaying solutions of `model`, with its factored
    /// `system` of steady states; `face` (Ph, n x 6) are the forces on the face of the
    /// central solutions. `None` if memory is insufficient.
    pub fn find(
        model: &impl Model,
        system: &CentralSystem<f64>,
        face: &DMatrix<f64>,
        wanted: usize,
    ) -> Option<Self> {
        let mut operator = Shifted {
            model,
            system,
            face,
            forces: SectionForces::none(model),
        };
        let n = model.unknowns();
        let mut states = States {
            u: DMatrix::from_fn(n, BLOCK, |i, j| krylov::start_value(i + j * n)),
            p: DMatrix::zeros(n, BLOCK),
        };
        // the first product removes resultants and rigid motions
        operator.multiply(&mut states)?;
        // forces are integrals over the cells around a node: made comparable
        let weight = states.u.norm() / states.p.norm();
        // the twelve rigid motions and central solutions are not in the space
        let all = (2 * n).saturating_sub(12);
        let most = (MOST_BLOCKS * BLOCK).min(all);
        let mut space = Space::new(&stacked(&states, weight), most);
        let mut search = Search::new(wanted);
        loop {
            unstack(&space.last_block(), weight, &mut states);
            operator.multiply(&mut states)?;
            operator.multiply(&mut states)?;
            space.grow(stacked(&states, weight));
            let vectors = space.dimension();
            let is_whole = space.is_whole() || vectors >= all;
            let is_last = is_whole || space.is_full();
            if !is_last && vectors > FEW && 10 * vectors < 11 * search.vectors {
                continue;
            }
            search.look(
                distinct(eigenvalues_of(space.projection().as_slice())),
                vectors,
            );
            if search.is_found || is_last {
                return Some(search.into_rates(is_whole));
            }
        }
    }
}

/// The latest rates.
struct Search {
    wanted: usize,
    /// Nearest to zero first.
    rates: Vec<Complex<f64>>,
    /// Number of them, nearest to zero, that are evaluated.
    looked_at: usize,
    /// Largest relative change of the slowest of them; of all, if the slowest have
    /// converged.
    change: f64,
    /// Whether these are sufficient and converged.
    is_found: bool,
    vectors: usize,
}

impl Search {
    fn new(wanted: usize) -> Self {
        Self {
            wanted,
            rates: Vec::new(),
            looked_at: 0,
            change: f64::INFINITY,
            is_found: false,
            vectors: 0,
        }
    }

    /// Evaluates the rates of a space of `vectors` vectors.
    fn look(&mut self, rates: Vec<Complex<f64>>, vectors: usize) {
        let needed = needed(&rates, self.wanted);
        self.looked_at = needed.unwrap_or(rates.len());
        let mut looked_at = rates[..self.looked_at].to_vec();
        let others = change(&self.rates, &looked_at);
        looked_at.sort_by(|a, b| a.re.total_cmp(&b.re));
        looked_at.truncate(self.wanted);
        self.change = change(&self.rates, &looked_at);
        self.is_found = needed.is_some() && self.change <= FOUND && others <= KNOWN;
        if self.change <= FOUND && !self.is_found {
            self.change = others;
        }
        (self.rates, self.vectors) = (rates, vectors);
    }

    /// The slowest rates; a whole space has them all.
    fn into_rates(mut self, is_whole: bool) -> DecayRates {
        self.rates.truncate(self.looked_at);
        self.rates.sort_by(|a, b| a.re.total_cmp(&b.re));
        self.rates.truncate(self.wanted);
        DecayRates {
            rates: self.rates,
            change: if is_whole { 0.0 } else { self.change },
            is_converged: is_whole || self.is_found,
            vectors: self.vectors,
        }
    }
}

/// Number of `rates`, nearest to zero first, that must be known for the `wanted` slowest:
/// all that may be as slow. `None` if there are too few.
fn needed(rates: &[Complex<f64>], wanted: usize) -> Option<usize> {
    let mut slowest: Vec<f64> = Vec::new();
    let mut seen: f64 = 0.0;
    for (count, rate) in (1..).zip(rates) {
        slowest.insert(slowest.partition_point(|re| *re <= rate.re), rate.re);
        seen = seen.max(rate.norm() / rate.re);
        let least = if count < MANY { REACH } else { REACH_OF_MANY };
        let reach = least.max(MARGIN * seen);
        let last = wanted.checked_sub(1).and_then(|last| slowest.get(last));
        if last.is_some_and(|last| rate.norm() >= reach * last) {
            return Some(count);
        }
    }
    None
}

fn stacked(states: &States, weight: f64) -> DMatrix<f64> {
    let n = states.u.nrows();
    let mut both = DMatrix::zeros(2 * n, BLOCK);
    both.rows_mut(0, n).copy_from(&states.u);
    both.rows_mut(n, n).copy_from(&(weight * &states.p));
    both
}

fn unstack(both: &DMatrix<f64>, weight: f64, states: &mut States) {
    let n = states.u.nrows();
    states.u.copy_from(&both.rows(0, n));
    states.p.copy_from(&(both.rows(n, n) / weight));
}

/// lambda of the eigenvalues 1/lambda^2, nearest to zero first, each once and one of
/// each pair of conjugates.
fn distinct(mut squares: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
    let largest = squares.iter().map(|value| value.norm()).fold(0.0, f64::max);
    squares.retain(|value| value.norm() > NEGLIGIBLE * largest);
    squares.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    let mut rates: Vec<Complex<f64>> = Vec::new();
    for square in squares {
        let root = (Complex::new(1.0, 0.0) / square).sqrt();
        // copies of a real rate appear as pairs next to the axis
        let is_real = root.im.abs() <= COPIES * root.norm();
        let rate = Complex::new(root.re, if is_real { 0.0 } else { root.im.abs() });
        let is_known = |known: &Complex<f64>| (known - rate).norm() <= COPIES * rate.norm();
        if !rates.iter().any(is_known) {
            rates.push(rate);
        }
    }
    rates
}

/// Largest relative distance of one of `rates` from the nearest of the previous rates;
/// infinite without previous rates.
fn change(before: &[Complex<f64>], rates: &[Complex<f64>]) -> f64 {
    let nearest = |rate: &Complex<f64>| {
        let distances = before.iter().map(|old| (old - rate).norm() / rate.norm());
        distances.fold(f64::INFINITY, f64::min)
    };
    rates.iter().map(nearest).fold(0.0, f64::max)
}
