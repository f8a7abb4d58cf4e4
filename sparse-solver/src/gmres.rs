//! Generalized minimal residuals: a linear system of which only products are known.
//!
//! With an orthonormal basis V of the Krylov space of the right side and `A V_m = V_{m+1} H`, the
//! solution `x = V_m y` minimizes the residual,
//!
//! ```text
//! | b - A x | = | |b| e_1 - H y |                                                    (D-443)
//! ```
//!
//! by Givens rotations of H.
//!
//! References: [SaadSchultz1986].

/// An approximate solution.
#[derive(Debug, Clone, PartialEq)]
pub struct Gmres {
    /// The solution \[unit of the unknowns\].
    pub x: Vec<f64>,
    /// Products with the matrix.
    pub products: usize,
    /// Residual relative to the right side [-].
    pub residual: f64,
}

/// Part of a product below which the rest beyond the basis is round-off.
const ROUND_OFF: f64 = 1e-14;

/// Solves `A x = b` to a relative residual `tolerance` with at most `most` products; `product`
/// replaces a vector by its product. `None` if a product is not finite.
pub fn gmres(
    product: &mut dyn FnMut(&mut [f64]) -> Option<()>,
    b: &[f64],
    (tolerance, most): (f64, usize),
) -> Option<Gmres> {
    let size = norm(b);
    if size == 0.0 {
        return Some(Gmres {
            x: vec![0.0; b.len()],
            products: 0,
            residual: 0.0,
        });
    }
    let mut space = Space {
        basis: vec![b.iter().map(|value| value / size).collect()],
        columns: Vec::new(),
        rotations: Vec::new(),
        right: vec![size],
    };
    while space.columns.len() < most {
        let mut w = space.basis[space.columns.len()].clone();
        product(&mut w)?;
        let whole = norm(&w);
        if !whole.is_finite() {
            return None;
        }
        let Some(rest) = space.add(&mut w, whole) else {
            // The matrix maps the basis onto less: no smaller residual in this space.
            break;
        };
        let left = space.right.last().map_or(0.0, |left| left.abs());
        if left <= tolerance * size || rest <= ROUND_OFF * whole {
            break;
        }
        space
            .basis
            .push(w.iter().map(|value| value / rest).collect());
    }
    Some(Gmres {
        x: space.solution(),
        products: space.columns.len(),
        residual: space.right.last().map_or(0.0, |left| left.abs()) / size,
    })
}

/// The Krylov space, with H turned into a triangle.
struct Space {
    basis: Vec<Vec<f64>>,
    /// Columns of the triangle.
    columns: Vec<Vec<f64>>,
    /// Cosine and sine of each rotation.
    rotations: Vec<[f64; 2]>,
    /// The turned right side; the last entry is the residual.
    right: Vec<f64>,
}

impl Space {
    /// Adds the product `w`, of the length `whole`, of the last vector, and leaves its part beyond
    /// the basis in `w`; returns the length of this part, or `None` if the product adds nothing.
    fn add(&mut self, w: &mut [f64], whole: f64) -> Option<f64> {
        let mut column = orthogonalize(&self.basis, w);
        let rest = norm(w);
        for (i, [c, s]) in self.rotations.iter().enumerate() {
            let (a, b) = (column[i], column[i + 1]);
            (column[i], column[i + 1]) = (c * a + s * b, c * b - s * a);
        }
        let last = column.len() - 1;
        let length = column[last].hypot(rest);
        if length <= ROUND_OFF * whole {
            return None;
        }
        let [c, s] = [column[last] / length, rest / length];
        column[last] = length;
        self.rotations.push([c, s]);
        self.columns.push(column);
        let value = self.right[last];
        self.right[last] = c * value;
        self.right.push(-s * value);
        Some(rest)
    }

    fn solution(&self) -> Vec<f64> {
        let m = self.columns.len();
        let mut y = self.right[..m].to_vec();
        for i in (0..m).rev() {
            let known: f64 = (i + 1..m).map(|j| self.columns[j][i] * y[j]).sum();
            y[i] = (y[i] - known) / self.columns[i][i];
        }
        let mut x = vec![0.0; self.basis[0].len()];
        for (y, v) in y.iter().zip(&self.basis) {
            x.iter_mut().zip(v).for_each(|(x, v)| *x += y * v);
        }
        x
    }
}

/// Removes the parts of `w` in an orthonormal basis, twice; returns them.
pub fn orthogonalize(basis: &[Vec<f64>], w: &mut [f64]) -> Vec<f64> {
    let mut parts = vec![0.0; basis.len()];
    for _ in 0..2 {
        for (part, v) in parts.iter_mut().zip(basis) {
            let own: f64 = v.iter().zip(&*w).map(|(v, w)| v * w).sum();
            *part += own;
            w.iter_mut().zip(v).for_each(|(w, v)| *w -= own * v);
        }
    }
    parts
}

/// The length of a vector.
pub fn norm(v: &[f64]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}
