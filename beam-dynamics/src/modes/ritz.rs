//! Vectors of the Krylov space that need no inverse iteration.
//!
//! Of the values that lead the space, the lowest have converged to round-off when the last
//! wanted one is found. One more product with the operator gives their vectors in all unknowns,
//! and their error
//!
//! ```text
//! |T x - mu x| / |mu x|
//! ```

use faer::c64;

use super::copies::{groups, is_independent, orthonormalize};
use super::eigenpair::Eigenpair;
use super::inverse::Inverse;
use super::krylov::{Found, Ritz};

/// Relative error of a vector in the space up to which it is used as it is.
const ACCURATE: f64 = 1e-10;
/// Relative error of its product up to which the round-off of the factorization explains it,
/// which limits inverse iteration too: 1e-12 of well-conditioned models, 1e-8 of a hundred
/// slender beams.
const ROUND_OFF: f64 = 1e-7;

/// Accurate pairs of oscillations.
pub(super) struct Ready(Vec<Eigenpair>);

impl Ready {
    /// Accurate vectors in `space` of some of the `values`, in the first `size` unknowns.
    pub fn new(inverse: &Inverse, space: Option<&Found>, values: &[c64], size: usize) -> Self {
        let Some(space) = space else {
            return Self(Vec::new());
        };
        let is_wanted = |ritz: &&Ritz| {
            let s = inverse.value(ritz.value);
            ritz.error <= ACCURATE && (values.contains(&s) || values.contains(&s.conj()))
        };
        let wanted: Vec<_> = space.ritz.iter().filter(is_wanted).collect();
        let vectors = space.vectors(&wanted);
        let products = inverse.product(&vectors);
        let pair = |(k, ritz): (usize, &&Ritz)| {
            let s = inverse.value(ritz.value);
            let (vector, product) = (vectors.subcols(2 * k, 2), products.subcols(2 * k, 2));
            let residual = inverse.error(s, vector, product);
            // The vector of the conjugate value is the conjugate one.
            let sign = if s.im < 0.0 { -1.0 } else { 1.0 };
            let complete = (0..size).map(|i| c64::new(product[(i, 0)], sign * product[(i, 1)]));
            let s = c64::new(s.re, s.im.abs());
            let pair = Eigenpair::new(s, &complete.collect::<Vec<_>>(), residual);
            (residual <= ROUND_OFF).then_some(pair)
        };
        Self(wanted.iter().enumerate().filter_map(pair).collect())
    }

    /// The pairs of a value and its copies, orthonormal if they are the same up to round-off;
    /// `None` unless all are accurate and independent.
    pub fn pairs(&self, copies: &[c64]) -> Option<Vec<Eigenpair>> {
        let is_copy = |pair: &&Eigenpair| copies.contains(&pair.value());
        let found: Vec<_> = self.0.iter().filter(is_copy).collect();
        if found.len() != copies.len() {
            return None;
        }
        let mut vectors: Vec<_> = found.iter().map(|pair| pair.vector()).collect();
        let mut values: Vec<_> = found.iter().map(|pair| pair.value()).collect();
        let size = vectors[0].len();
        if groups(copies).len() == 1 {
            orthonormalize(&mut vectors, size);
            values.fill(copies.iter().sum::<c64>() / copies.len() as f64);
        } else {
            let each = vectors.iter_mut();
            each.for_each(|vector| orthonormalize(std::slice::from_mut(vector), size));
        }
        let pair = |((vector, s), of): ((&Vec<c64>, &c64), &&Eigenpair)| {
            Eigenpair::new(*s, vector, of.residual)
        };
        let pairs: Vec<_> = vectors.iter().zip(&values).zip(&found).map(pair).collect();
        is_independent(&pairs).then_some(pairs)
    }
}
