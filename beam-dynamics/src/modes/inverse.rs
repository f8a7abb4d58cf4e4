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
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::evd::{ComputeEigenvectors, EvdParams, evd_real, evd_scratch};
use faer::matrix_free::LinOp;
use faer::matrix_free::eigen::{PartialEigenParams, partial_eigen, partial_eigen_scratch};
use faer::{Auto, Col, Mat, MatMut, MatRef, Par, c64};

use super::eigen::start_value;
use crate::assembly::Sparse;
use crate::model::NODE_UNKNOWNS;
use crate::solver::Factorization;

/// Up to this number of unknowns T is formed and all its eigenvalues are computed;
/// above, only the wanted ones by Krylov iteration.
const DENSE: usize = 200;
/// Parts of the largest eigenvalue of T below which one is taken for zero: those at
/// zero are defective, and round-off moves them to the cube root of 1e-16 or so.
const INFINITE: f64 = 1e-7;
/// Residual to which the Krylov iteration is driven, relative.
const KRYLOV: f64 = 1e-12;
/// Eigenvalues sought in one Krylov iteration, and the dimension of its space. The
/// multishift QR iteration of faer 0.24, which it uses from dimension 75 on, has been
/// seen not to end; the plain one below that is bounded.
const BATCH: usize = 32;
const SPACE: usize = 72;
/// Krylov iterations at most.
const ROUNDS: usize = 60;

/// The operator T on the unknowns of the nodes, with scaled momenta.
#[derive(Debug)]
pub(super) struct Inverse {
    factorization: Factorization,
    by_rates: Sparse,
    size: usize,
    /// Scale of each unknown: value = scale times scaled value.
    scale: Vec<f64>,
}

impl Inverse {
    /// T on the first `size` unknowns; `None` when it is not finite.
    pub fn new(factorization: Factorization, by_rates: Sparse, size: usize) -> Option<Self> {
        let mut inverse = Self {
            factorization,
            by_rates,
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
        let inverted = if self.size <= DENSE || wanted * 3 > self.size {
            self.all()
        } else {
            self.largest(wanted)
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
        let mut values = vec![0.0; self.by_rates.pattern().size()];
        let mut product = values.clone();
        for i in 0..self.size {
            values[i] = -self.scale[i] * x[i];
        }
        self.by_rates.multiply_add(&values, &mut product);
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
        let n = self.size;
        let mut matrix = Mat::zeros(n, n);
        let mut column = vec![0.0; n];
        for j in 0..n {
            column.fill(0.0);
            column[j] = 1.0;
            self.multiply(&mut column);
            for i in 0..n {
                matrix[(i, j)] = column[i];
            }
        }
        // The plain QR iteration at any size: see BATCH.
        let mut parameters = <EvdParams as Auto<f64>>::auto();
        parameters.schur.blocking_threshold = usize::MAX;
        let no = ComputeEigenvectors::No;
        let spec = parameters.into();
        let mut memory = MemBuffer::new(evd_scratch::<f64>(n, no, no, Par::Seq, spec));
        let stack = MemStack::new(&mut memory);
        let (mut real, mut imaginary) = (Diag::zeros(n), Diag::zeros(n));
        let (re, im) = (real.as_mut(), imaginary.as_mut());
        match evd_real(matrix.as_ref(), re, im, None, None, Par::Seq, stack, spec) {
            Ok(()) => (0..n).map(|i| c64::new(real[i], imaginary[i])).collect(),
            Err(_) => Vec::new(),
        }
    }

    /// The `count` largest eigenvalues of T.
    ///
    /// A Krylov iteration sees one copy of a repeated eigenvalue. With Q an orthonormal
    /// basis of the invariant space found so far, `(I - Q Q^T) T` has the eigenvalues
    /// that are left: the search is repeated on it until none of them is larger than
    /// the smallest wanted.
    fn largest(&self, count: usize) -> Vec<c64> {
        let mut found: Vec<c64> = Vec::new();
        let mut deflated = Deflated {
            inverse: self,
            basis: Vec::new(),
        };
        for _ in 0..ROUNDS {
            let (values, vectors) = deflated.krylov();
            let limit = nth_largest(&found, count);
            let new: Vec<_> = (0..values.len())
                .filter(|&j| values[j].norm() > limit * (1.0 - 1e-9))
                .collect();
            if new.is_empty() {
                break;
            }
            for j in new {
                found.push(values[j]);
                deflated.extend(&vectors, j);
            }
        }
        found
    }
}

/// Magnitude of the value number `count` by falling magnitude, zero where there is none.
fn nth_largest(values: &[c64], count: usize) -> f64 {
    let mut sizes: Vec<_> = values.iter().map(|value| value.norm()).collect();
    sizes.sort_by(|a, b| b.total_cmp(a));
    sizes.get(count - 1).copied().unwrap_or(0.0)
}

/// `(I - Q Q^T) T`.
#[derive(Debug)]
struct Deflated<'a> {
    inverse: &'a Inverse,
    /// Orthonormal columns of Q.
    basis: Vec<Vec<f64>>,
}

impl Deflated<'_> {
    /// The converged ones of the largest eigenvalues, and their vectors.
    fn krylov(&self) -> (Vec<c64>, Mat<c64>) {
        let size = self.inverse.size;
        let count = BATCH;
        let mut vectors = Mat::<c64>::zeros(size, count);
        let mut values = vec![c64::new(0.0, 0.0); count];
        let mut start: Vec<_> = (0..size)
            .map(|i| start_value(i + size * self.basis.len()))
            .collect();
        self.project(&mut start);
        let start = Col::from_fn(size, |i| start[i]);
        let parameters = PartialEigenParams {
            max_dim: SPACE,
            ..PartialEigenParams::default()
        };
        let mut memory = MemBuffer::new(partial_eigen_scratch(self, count, Par::Seq, parameters));
        let found = partial_eigen(
            vectors.as_mut(),
            &mut values,
            self,
            start.as_ref(),
            KRYLOV,
            Par::Seq,
            MemStack::new(&mut memory),
            parameters,
        );
        values.truncate(found.n_converged_eigen);
        (values, vectors)
    }

    /// Adds the real and imaginary part of a vector to Q, where they are new.
    fn extend(&mut self, vectors: &Mat<c64>, j: usize) {
        for part in [|z: &c64| z.re, |z: &c64| z.im] {
            let mut column: Vec<_> = (0..vectors.nrows())
                .map(|i| part(&vectors[(i, j)]))
                .collect();
            let before = norm(&column);
            self.project(&mut column);
            self.project(&mut column);
            let after = norm(&column);
            if after > 1e-6 * before {
                column.iter_mut().for_each(|value| *value /= after);
                self.basis.push(column);
            }
        }
    }

    fn project(&self, x: &mut [f64]) {
        for column in &self.basis {
            let along: f64 = column.iter().zip(x.iter()).map(|(c, x)| c * x).sum();
            x.iter_mut().zip(column).for_each(|(x, c)| *x -= along * c);
        }
    }
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|value| value * value).sum::<f64>().sqrt()
}

impl LinOp<f64> for Deflated<'_> {
    fn apply_scratch(&self, _columns: usize, _par: Par) -> StackReq {
        StackReq::EMPTY
    }

    fn nrows(&self) -> usize {
        self.inverse.size
    }

    fn ncols(&self) -> usize {
        self.inverse.size
    }

    fn apply(
        &self,
        mut out: MatMut<'_, f64>,
        rhs: MatRef<'_, f64>,
        _par: Par,
        _stack: &mut MemStack,
    ) {
        for j in 0..rhs.ncols() {
            let mut column: Vec<f64> = rhs.col(j).iter().copied().collect();
            self.inverse.multiply(&mut column);
            self.project(&mut column);
            for (i, value) in column.into_iter().enumerate() {
                out[(i, j)] = value;
            }
        }
    }

    fn conj_apply(
        &self,
        out: MatMut<'_, f64>,
        rhs: MatRef<'_, f64>,
        par: Par,
        stack: &mut MemStack,
    ) {
        self.apply(out, rhs, par, stack);
    }
}
