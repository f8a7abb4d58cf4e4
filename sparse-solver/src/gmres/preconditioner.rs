//! A preconditioner from the spaces of solved systems.
//!
//! In the space of a solution `A U = C` with orthonormal C, so that
//!
//! ```text
//! P r = U C^T r + P_0 ( r - C C^T r )                                                (D-449)
//! ```
//!
//! is the inverse of A on C, and the one before, P_0, on the rest: the identity at first. For the
//! matrix of a later iteration, or of the next value of a parameter, P A is near the identity.
//!
//! References: [Parks2006].

use super::Space;

/// Largest number of vectors of each kind.
const MOST: usize = 400;

/// An approximate inverse of a matrix from the spaces of solved systems \[unit of the unknowns by unit of the right side\].
#[derive(Debug, Clone, Default)]
pub struct Preconditioner {
    layers: Vec<Layer>,
}

/// The space of a solution.
#[derive(Debug, Clone)]
struct Layer {
    /// C.
    products: Vec<Vec<f64>>,
    /// U.
    directions: Vec<Vec<f64>>,
}

impl Preconditioner {
    /// Replaces a right side by the approximate solution.
    pub(super) fn apply(&self, r: &mut [f64]) {
        let mut x = vec![0.0; r.len()];
        for layer in self.layers.iter().rev() {
            for (c, u) in layer.products.iter().zip(&layer.directions) {
                let part: f64 = c.iter().zip(&*r).map(|(c, r)| c * r).sum();
                r.iter_mut().zip(c).for_each(|(r, c)| *r -= part * c);
                x.iter_mut().zip(u).for_each(|(x, u)| *x += part * u);
            }
        }
        r.iter_mut().zip(&x).for_each(|(r, x)| *r += x);
    }

    /// Adds the space of a solution, or forgets all if they saved little.
    pub(super) fn add(&mut self, space: Space) {
        let known: usize = self.layers.iter().map(|layer| layer.products.len()).sum();
        let added = space.columns.len();
        if known > 0 && (2 * added > known || known + added > MOST) {
            self.layers.clear();
        } else if added > 0 {
            self.layers.push(Layer::new(space));
        }
    }
}

impl Layer {
    /// `C = V Q` and `U = P V R^-1` with `H = Q R`.
    fn new(space: Space) -> Self {
        let Space {
            basis: mut products,
            mut directions,
            columns,
            rotations,
            ..
        } = space;
        let n = directions[0].len();
        products.resize(columns.len() + 1, vec![0.0; n]);
        for (i, [c, s]) in rotations.iter().enumerate() {
            for k in 0..n {
                let (a, b) = (products[i][k], products[i + 1][k]);
                (products[i][k], products[i + 1][k]) = (c * a + s * b, c * b - s * a);
            }
        }
        products.truncate(columns.len());
        for (j, column) in columns.iter().enumerate() {
            let (before, own) = directions.split_at_mut(j);
            let own = &mut own[0];
            for (u, r) in before.iter().zip(column) {
                own.iter_mut().zip(u).for_each(|(own, u)| *own -= r * u);
            }
            own.iter_mut().for_each(|own| *own /= column[j]);
        }
        Self {
            products,
            directions,
        }
    }
}
