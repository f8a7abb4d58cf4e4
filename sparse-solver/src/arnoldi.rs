//! The largest eigenvalues of a linear map of which only products are known.
//!
//! Arnoldi's method: with an orthonormal basis V of the Krylov space, `M V_m = V_m H + rest e_m^T`,
//! the eigenvalues of H approximate the largest ones of M, and with `H y = mu y`
//!
//! ```text
//! | M V y - mu V y | = |rest| |y_m|                                                  (D-444)
//! ```
//!
//! Where the space is invariant, as with repeated eigenvalues, another vector of the range of the
//! map continues it, so that every copy of an eigenvalue is found.
//!
//! References: [Arnoldi1951].

use faer::{Mat, c64};

mod repeated;

use super::dense::Eigenvectors;
use crate::gmres::{norm, orthogonalize};

/// A linear map of a vector space onto itself.
pub trait LinearMap {
    /// Dimension of the space.
    fn size(&self) -> usize;

    /// Replaces a vector by its image; `None` if it is not finite.
    fn apply(&self, x: &mut [f64]) -> Option<()>;

    /// Replaces any vector by one of the range of the map.
    fn project(&self, x: &mut [f64]) -> Option<()>;
}

/// An eigenvalue with its vector; of a pair the one with the positive imaginary part.
#[derive(Debug, Clone, PartialEq)]
pub struct Ritz {
    /// The eigenvalue [-].
    pub value: c64,
    /// Real and imaginary part of the vector \[-\].
    pub vector: [Vec<f64>; 2],
    /// Residual of a vector of unit length [-].
    pub residual: f64,
}

/// Eigenvalues found.
#[derive(Debug, Clone, PartialEq)]
pub struct Largest {
    /// The eigenvalues, by falling size.
    pub pairs: Vec<Ritz>,
    /// Products with the map.
    pub products: usize,
    /// Dimension of the space, if it is the whole range of the map.
    pub dimension: Option<usize>,
}

/// Part of an image below which the rest beyond the basis is round-off.
const ROUND_OFF: f64 = 1e-9;
/// The same of a new vector.
const INSIDE: f64 = 1e-7;
/// Residual of an eigenvalue relative to its size at which it is accepted.
const SETTLED: f64 = 1e-10;
/// Products between two checks.
const CHECKED: usize = 5;

/// The `count` largest eigenvalues, both of a pair counted, in a space of at most `most`
/// dimensions; those found until then if it is too small. `None` if the map is not finite.
pub fn largest(map: &dyn LinearMap, count: usize, most: usize) -> Option<Largest> {
    let mut space = Space {
        map,
        basis: Vec::new(),
        columns: Vec::new(),
        rest: 0.0,
        seed: 0,
    };
    let mut goes_on = space.renew()?;
    while goes_on && space.columns.len() < most.min(map.size()) {
        goes_on = space.extend()?;
        let dimension = space.columns.len();
        if goes_on && dimension >= count && dimension.is_multiple_of(CHECKED) {
            let found = space.pairs(count);
            let settled = found
                .iter()
                .all(|pair| pair.residual <= SETTLED * pair.value.norm());
            if settled && !found.is_empty() {
                break;
            }
        }
    }
    let dimension = space.columns.len();
    Some(Largest {
        pairs: space.pairs(count),
        products: dimension,
        dimension: (!goes_on).then_some(dimension),
    })
}

/// The space built so far; the basis has one vector more than H has columns.
struct Space<'a> {
    map: &'a dyn LinearMap,
    basis: Vec<Vec<f64>>,
    /// Columns of H, each to its own subdiagonal.
    columns: Vec<Vec<f64>>,
    /// Length of the rest of the last column.
    rest: f64,
    seed: u64,
}

impl Space<'_> {
    /// Adds the image of the last vector; returns whether there is more.
    fn extend(&mut self) -> Option<bool> {
        let mut w = self.basis[self.columns.len()].clone();
        self.map.apply(&mut w)?;
        let whole = norm(&w);
        let mut column = orthogonalize(&self.basis, &mut w);
        self.rest = norm(&w);
        if self.rest > ROUND_OFF * whole {
            column.push(self.rest);
            self.columns.push(column);
            let rest = self.rest;
            self.basis
                .push(w.iter().map(|value| value / rest).collect());
            return Some(true);
        }
        self.rest = 0.0;
        column.push(0.0);
        self.columns.push(column);
        self.renew()
    }

    /// Adds a vector of the range of the map outside of the basis; returns whether there is one.
    fn renew(&mut self) -> Option<bool> {
        let mut w = self.scattered();
        self.map.project(&mut w)?;
        let whole = norm(&w);
        orthogonalize(&self.basis, &mut w);
        let rest = norm(&w);
        if rest.is_nan() {
            return None;
        }
        let is_new = rest > INSIDE * whole;
        if is_new {
            self.basis
                .push(w.iter().map(|value| value / rest).collect());
        }
        Some(is_new)
    }

    /// Pseudorandom numbers between -1 and 1.
    fn scattered(&mut self) -> Vec<f64> {
        let mut next = || {
            self.seed = self
                .seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (self.seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        next();
        (0..self.map.size()).map(|_| next()).collect()
    }

    /// The largest eigenvalues, at least `count` if there are as many.
    fn pairs(&self, count: usize) -> Vec<Ritz> {
        let m = self.columns.len();
        let entry = |i: usize, j: usize| self.columns[j].get(i).copied().unwrap_or(0.0);
        let h = Mat::from_fn(m, m, entry);
        let mut found = Eigenvectors::new(h.as_ref()).firsts();
        for (value, parts) in found.iter_mut().filter(|own| own.0.im < 0.0) {
            *value = value.conj();
            parts.col_mut(1).iter_mut().for_each(|x| *x = -*x);
        }
        found.sort_by(|a, b| b.0.norm().total_cmp(&a.0.norm()));
        repeated::separate(&h, &mut found);
        let mut pairs = Vec::new();
        let mut counted = 0;
        for (value, parts) in found {
            if counted >= count {
                break;
            }
            counted += if value.im == 0.0 { 1 } else { 2 };
            let size = parts.norm_l2();
            let last = parts[(m - 1, 0)].hypot(parts[(m - 1, 1)]) / size;
            let part = |k: usize| {
                let mut vector = vec![0.0; self.map.size()];
                for (i, v) in self.basis.iter().take(m).enumerate() {
                    let y = parts[(i, k)] / size;
                    vector.iter_mut().zip(v).for_each(|(x, v)| *x += y * v);
                }
                vector
            };
            pairs.push(Ritz {
                value,
                vector: [part(0), part(1)],
                residual: self.rest * last,
            });
        }
        pairs
    }
}
