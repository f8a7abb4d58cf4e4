//! The inverted eigenvalue problem.
//!
//! ```text
//! T = -(F_y)^-1 F_y'        T v = v / s
//! ```
//!
//! The smallest |s| are the largest eigenvalues of T; multipliers and massless
//! freedoms, whose s is infinite, are at zero. Unknowns of T are positions and
//! rotations q, momenta and angular momenta p; the multipliers have no rates and
//! drop out. p is scaled so that the blocks `T_qp` and `T_pq` are of the same size.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, EvdParams, evd_real, evd_scratch};
use faer::{Auto, Mat, MatRef, Par, c64};

use super::eigen::start_value;
use crate::assembly::Sparse;
use crate::model::NODE_UNKNOWNS;
use crate::solver::Factorization;

/// Up to this number of unknowns T is formed and all its eigenvalues are computed;
/// above, only the wanted ones by subspace iteration.
const DENSE: usize = 400;
/// Parts of the largest eigenvalue of T below which one is taken for zero: those at
/// zero are defective, and round-off moves them to the cube root of 1e-16 or so.
const INFINITE: f64 = 1e-7;
/// Change of the wanted eigenvalues from one subspace iteration to the next at which
/// they count as found, relative: near enough for inverse iteration, which gives the
/// last digits.
const FOUND: f64 = 1e-8;
/// Subspace iterations at most. Blades need 10 to 30: each takes the error of the
/// last wanted value down by its ratio to the first one outside the space.
const ITERATIONS: usize = 100;

/// The operator T on the unknowns of the nodes, with scaled momenta.
#[derive(Debug)]
pub(super) struct Inverse {
    factorization: Factorization,
    /// Entries (row, column, value) of `F_y'` that are not zero.
    rates: Vec<(usize, usize, f64)>,
    size: usize,
    /// Scale of each unknown: value = scale times scaled value.
    scale: Vec<f64>,
}

impl Inverse {
    /// T on the first `size` unknowns; `None` when it is not finite.
    pub fn new(factorization: Factorization, by_rates: &Sparse, size: usize) -> Option<Self> {
        let mut inverse = Self {
            factorization,
            rates: by_rates.triplets().filter(|entry| entry.2 != 0.0).collect(),
            size,
            scale: vec![1.0; size],
        };
        inverse.balance()?;
        Some(inverse)
    }

    /// At least the `2 count` eigenvalues s of smallest magnitude, conjugate pairs and
    /// copies included, where there are so many.
    pub fn smallest(&self, count: usize) -> Vec<c64> {
        let wanted = 2 * count + 8;
        // The room beyond the wanted ones sets the rate of convergence.
        let space = wanted + wanted / 2 + 8;
        let inverted = if self.size <= DENSE || space * 2 > self.size {
            self.all()
        } else {
            self.largest(wanted, 2 * count, space)
        };
        let largest = inverted
            .iter()
            .map(|value| value.norm())
            .fold(0.0, f64::max);
        let finite = inverted
            .into_iter()
            .filter(|value| value.norm() > INFINITE * largest);
        finite.map(|value| c64::new(1.0, 0.0) / value).collect()
    }

    /// `T x` for scaled x, in place.
    fn multiply(&self, x: &mut [f64]) {
        let mut product = vec![0.0; self.factorization.size()];
        for &(i, j, value) in &self.rates {
            product[i] -= value * self.scale[j] * x[j];
        }
        // A singular matrix was refused before; what is not finite shows as NaN.
        if self.factorization.solve(&mut product).is_none() {
            product.fill(f64::NAN);
        }
        for i in 0..self.size {
            x[i] = product[i] / self.scale[i];
        }
    }

    /// Scales the momenta by the sizes of the two blocks that couple them with the
    /// positions, estimated with one vector; `None` when T is not finite.
    fn balance(&mut self) -> Option<()> {
        let is_momentum = |i: usize| i % NODE_UNKNOWNS >= NODE_UNKNOWNS / 2;
        let norm = |x: &[f64], momenta: bool| {
            let part = x
                .iter()
                .enumerate()
                .filter(|(i, _)| is_momentum(*i) == momenta);
            part.map(|(_, value)| value * value).sum::<f64>().sqrt()
        };
        let size_of_block = |from_momenta: bool| {
            let value = |i: usize| {
                if is_momentum(i) == from_momenta {
                    start_value(i)
                } else {
                    0.0
                }
            };
            let mut x: Vec<_> = (0..self.size).map(value).collect();
            let before = norm(&x, from_momenta);
            self.multiply(&mut x);
            norm(&x, !from_momenta) / before
        };
        let (q_by_p, p_by_q) = (size_of_block(true), size_of_block(false));
        if !(q_by_p.is_finite() && p_by_q.is_finite()) {
            return None;
        }
        if q_by_p > 0.0 && p_by_q > 0.0 {
            let scale = (p_by_q / q_by_p).sqrt();
            for i in (0..self.size).filter(|&i| is_momentum(i)) {
                self.scale[i] = scale;
            }
        }
        Some(())
    }

    /// All eigenvalues of T; empty when the iteration fails.
    fn all(&self) -> Vec<c64> {
        let mut matrix = Mat::zeros(self.size, self.size);
        matrix.diagonal_mut().fill(1.0);
        self.multiply_columns(&mut matrix);
        eigenvalues(matrix.as_ref())
    }

    /// The `wanted` largest eigenvalues of T, by iteration of a whole space, which sees
    /// all copies of a repeated eigenvalue:
    ///
    /// ```text
    /// Y = T Q,    eigenvalues of Q^T Y,    Q <- orthonormal basis of Y
    /// ```
    ///
    /// It ends when the first `sure` of them stand still.
    fn largest(&self, wanted: usize, sure: usize, space: usize) -> Vec<c64> {
        let start = |i, j| start_value(i + j * self.size);
        let mut basis = Mat::from_fn(self.size, space, start).qr().compute_thin_Q();
        let mut before: Vec<f64> = Vec::new();
        let mut values = Vec::new();
        for _ in 0..ITERATIONS {
            let mut image = basis.clone();
            self.multiply_columns(&mut image);
            values = eigenvalues((basis.transpose() * &image).as_ref());
            values.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
            values.truncate(wanted);
            let sizes: Vec<_> = values.iter().take(sure).map(|value| value.norm()).collect();
            let close = |(a, b): (&f64, &f64)| (a - b).abs() <= FOUND * b;
            if !sizes.is_empty()
                && sizes.len() == before.len()
                && sizes.iter().zip(&before).all(close)
            {
                break;
            }
            before = sizes;
            basis = image.qr().compute_thin_Q();
        }
        values
    }

    /// `|T v - v / s|` relative to `|v / s|`, v in the unknowns of the nodes: about 1e-12
    /// for a well-conditioned model.
    pub fn residual(&self, s: c64, vector: &[c64]) -> f64 {
        let scaled = |part: fn(&c64) -> f64| -> Vec<f64> {
            vector
                .iter()
                .zip(&self.scale)
                .map(|(v, scale)| part(v) / scale)
                .collect()
        };
        let (mut real, mut imaginary) = (scaled(|v| v.re), scaled(|v| v.im));
        let expected: Vec<_> = real
            .iter()
            .zip(&imaginary)
            .map(|(re, im)| c64::new(*re, *im) / s)
            .collect();
        self.multiply(&mut real);
        self.multiply(&mut imaginary);
        let found = real
            .iter()
            .zip(&imaginary)
            .map(|(re, im)| c64::new(*re, *im));
        let error: f64 = found.zip(&expected).map(|(a, b)| (a - b).norm_sqr()).sum();
        let size: f64 = expected.iter().map(|value| value.norm_sqr()).sum();
        (error / size).sqrt()
    }

    fn multiply_columns(&self, matrix: &mut Mat<f64>) {
        for j in 0..matrix.ncols() {
            let mut column: Vec<_> = matrix.col(j).iter().copied().collect();
            self.multiply(&mut column);
            for (i, value) in column.into_iter().enumerate() {
                matrix[(i, j)] = value;
            }
        }
    }
}

/// All eigenvalues of a square matrix; empty when it is not finite or the iteration
/// fails.
///
/// The plain QR iteration at any size: the multishift one of faer 0.24, which it takes
/// from size 75 on by itself, has been seen not to end.
fn eigenvalues(matrix: MatRef<'_, f64>) -> Vec<c64> {
    let n = matrix.nrows();
    if !matrix.is_all_finite() {
        return Vec::new();
    }
    let mut parameters = <EvdParams as Auto<f64>>::auto();
    parameters.schur.blocking_threshold = usize::MAX;
    let no = ComputeEigenvectors::No;
    let spec = parameters.into();
    let mut memory = MemBuffer::new(evd_scratch::<f64>(n, no, no, Par::Seq, spec));
    let stack = MemStack::new(&mut memory);
    let (mut real, mut imaginary) = (Diag::zeros(n), Diag::zeros(n));
    let (re, im) = (real.as_mut(), imaginary.as_mut());
    match evd_real(matrix, re, im, None, None, Par::Seq, stack, spec) {
        Ok(()) => (0..n).map(|i| c64::new(real[i], imaginary[i])).collect(),
        Err(_) => Vec::new(),
    }
}
