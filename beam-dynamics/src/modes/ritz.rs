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

/// Relative error of a vector up to which it is used as it is: inverse iteration is limited by
/// the round-off of the factorization, about 1e-12 of well-conditioned models.
const ACCURATE: f64 = 1e-10;

/// Accurate vectors of oscillations, each with its value.
pub(super) struct Ready(Vec<(c64, Eigenpair)>);

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
        let products = inverse.complete(&vectors);
        let pair = |(k, ritz): (usize, &&Ritz)| {
            let s = inverse.value(ritz.value);
            let (vector, product) = (vectors.subcols(2 * k, 2), products.subcols(2 * k, 2));
            let residual = inverse.error(s, vector, product);
            // The vector of the conjugate value is the conjugate one.
            let sign = if s.im < 0.0 { -1.0 } else { 1.0 };
            let pair = Eigenpair {
                growth: s.re,
                angular_frequency: s.im.abs(),
                real: (0..size).map(|i| product[(i, 0)]).collect(),
                imaginary: (0..size).map(|i| sign * product[(i, 1)]).collect(),
                residual,
            };
            (residual <= ACCURATE).then_some((c64::new(s.re, s.im.abs()), pair))
        };
        Self(wanted.iter().enumerate().filter_map(pair).collect())
    }

    /// The pairs of a value and its copies, orthonormal if they are the same up to round-off;
    /// `None` unless all are accurate and independent.
    pub fn pairs(&self, copies: &[c64]) -> Option<Vec<Eigenpair>> {
        let is_copy = |(s, _): &&(c64, Eigenpair)| copies.contains(s);
        let found: Vec<_> = self
            .0
            .iter()
            .filter(is_copy)
            .map(|(_, pair)| pair)
            .collect();
        if found.len() != copies.len() {
            return None;
        }
        let mut vectors: Vec<_> = found.iter().map(|pair| complex(pair)).collect();
        let size = vectors[0].len();
        let mut values = copies.to_vec();
        match groups(copies).len() {
            1 => {
                orthonormalize(&mut vectors, size);
                let mean = copies.iter().sum::<c64>() / copies.len() as f64;
                values.fill(mean);
            }
            _ => {
                let each = vectors.iter_mut();
                each.for_each(|vector| orthonormalize(std::slice::from_mut(vector), size));
                values = found
                    .iter()
                    .map(|pair| c64::new(pair.growth, pair.angular_frequency))
                    .collect();
            }
        }
        let pair = |((vector, s), of): ((&Vec<c64>, &c64), &&Eigenpair)| Eigenpair {
            growth: s.re,
            angular_frequency: s.im,
            real: vector.iter().map(|v| v.re).collect(),
            imaginary: vector.iter().map(|v| v.im).collect(),
            residual: of.residual,
        };
        let pairs: Vec<_> = vectors.iter().zip(&values).zip(&found).map(pair).collect();
        is_independent(&pairs).then_some(pairs)
    }
}

fn complex(pair: &Eigenpair) -> Vec<c64> {
    let parts = pair.real.iter().zip(&pair.imaginary);
    parts.map(|(re, im)| c64::new(*re, *im)).collect()
}
