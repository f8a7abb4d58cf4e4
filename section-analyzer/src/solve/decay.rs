//! Solutions that decay along the beam: what ends and jumps of the load add to the
//! central solutions.
//!
//! Solutions `exp(lambda x)` of the section without load and without internal force,
//! with P the forces on the face, meet
//!
//! ```text
//! [E - lambda (C - C') - lambda^2 M] u + (R - lambda L) psi = 0
//! (R' + lambda L') u + A psi = 0                                                  (S-109)
//! ```
//!
//! They come as lambda and -lambda: one decays from each end. The operator that takes
//! (u', P') of a state to (u, P) has the eigenvalues 1/lambda on the states without
//! internal force and without rigid motion; it is one solution with the factored system
//! of steady states,
//!
//! ```text
//! C' u' + E u + R psi = P'      L' u' + R' u + A psi = 0      Ph' u = 0
//! P = M u' + C u + L psi                                                          (S-110)
//! ```
//!
//! which leaves out the rigid motions and the central solutions: on a straight beam the
//! twelve zeros of the pencil, on a curved one those at 0 and +-i |k|. Its square has
//! 1/lambda^2 twice, and the eigenvalues of largest magnitude, which are those nearest
//! to zero of the pencil, are found in a block [`krylov`] space.
//!
//! # References
//! - [Giavotto1983], section 5: extremity solutions.
//! - [Masarati], appendix E.4.

mod dense;
mod krylov;
#[cfg(test)]
mod tests;

use super::particular::{Load, ParticularSolution};
use super::system::CentralSystem;
use crate::assembly::{Model, Rate, SectionForces, State};
use krylov::Space;
use nalgebra::{Complex, DMatrix, Matrix6};

/// Vectors of a block: as many as are solved side by side.
const BLOCK: usize = 6;

/// Blocks of the space at most.
const MOST_BLOCKS: usize = 48;

/// Rates that are looked for beyond those that are wanted: the nearest to zero need not
/// decay slowest, as they may oscillate.
const SPARE: usize = 2;

/// Change of the rates by the last block at which they count as found, relative. It is
/// the error before that block, and the next ones gain digits quickly.
const FOUND: f64 = 1e-9;

/// Rates that differ by less, relative, are one: copies of it, by symmetry of the
/// section and by the square of the operator.
const COPIES: f64 = 1e-6;

/// The slowest of the decaying solutions.
#[derive(Debug, Clone, PartialEq)]
pub struct DecayRates {
    /// lambda, per unit of length of the domain, real part positive and rising,
    /// imaginary part not negative; equal ones once \[-\].
    pub rates: Vec<Complex<f64>>,
    /// Change of them by the last block, relative to each, the largest \[-\].
    pub change: f64,
    /// Whether the change is small enough.
    pub is_converged: bool,
    /// Vectors of the space.
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
    /// Replaces the states by those whose rate along the beam they are.
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
    /// central solutions. `None` when there is no memory for it.
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
        // what has a resultant or moves rigidly goes with the first product
        operator.multiply(&mut states)?;
        // forces are integrals over the cells around a node: made comparable
        let weight = states.u.norm() / states.p.norm();
        // the twelve rigid motions and central solutions are no part of the space
        let all = (2 * n).saturating_sub(12);
        let most = (MOST_BLOCKS * BLOCK).min(all);
        let mut space = Space::new(&stacked(&states, weight), most);
        let mut before: Vec<Complex<f64>> = Vec::new();
        loop {
            unstack(&space.last_block(), weight, &mut states);
            operator.multiply(&mut states)?;
            operator.multiply(&mut states)?;
            space.grow(stacked(&states, weight));
            let mut rates = distinct(dense::eigenvalues(&space.projection()));
            rates.truncate(wanted + SPARE);
            let change = change(&before, &rates);
            let is_whole = space.is_whole() || space.dimension() >= all;
            let is_converged = change <= FOUND || is_whole;
            if is_converged || space.is_full() {
                rates.sort_by(|a, b| a.re.total_cmp(&b.re));
                rates.truncate(wanted);
                return Some(Self {
                    rates,
                    change,
                    is_converged,
                    vectors: space.dimension(),
                });
            }
            before = rates;
        }
    }
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
    squares.retain(|value| value.norm() > 0.0);
    squares.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    let mut rates: Vec<Complex<f64>> = Vec::new();
    for square in squares {
        let root = (Complex::new(1.0, 0.0) / square).sqrt();
        // copies of a real one come as pairs next to the axis
        let is_real = root.im.abs() <= COPIES * root.norm();
        let rate = Complex::new(root.re, if is_real { 0.0 } else { root.im.abs() });
        let is_known = |known: &Complex<f64>| (known - rate).norm() <= COPIES * rate.norm();
        if !rates.iter().any(is_known) {
            rates.push(rate);
        }
    }
    rates
}

/// Largest relative change of the rates; infinite where their number has changed.
fn change(before: &[Complex<f64>], rates: &[Complex<f64>]) -> f64 {
    if before.len() != rates.len() || rates.is_empty() {
        return f64::INFINITY;
    }
    let pairs = before.iter().zip(rates);
    let changes = pairs.map(|(old, new)| (old - new).norm() / new.norm());
    changes.fold(0.0, f64::max)
}
