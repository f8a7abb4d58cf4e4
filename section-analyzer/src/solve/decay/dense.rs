//! All eigenvalues of a small dense matrix.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, EvdParams, evd_real, evd_scratch};
use faer::{Auto, MatRef, Par};
use nalgebra::{Complex, DMatrix};

/// All eigenvalues of a square matrix; none if it is not finite or the iteration fails.
///
/// Uses the plain QR iteration at any size: the multishift iteration of faer 0.24, its
/// default from size 75 on, was observed not to end.
pub(super) fn eigenvalues(matrix: &DMatrix<f64>) -> Vec<Complex<f64>> {
    let n = matrix.nrows();
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return Vec::new();
    }
    let matrix = MatRef::from_column_major_slice(matrix.as_slice(), n, n);
    let mut parameters = <EvdParams as Auto<f64>>::auto();
    parameters.schur.blocking_threshold = usize::MAX;
    let no = ComputeEigenvectors::No;
    let spec = parameters.into();
    let mut memory = MemBuffer::new(evd_scratch::<f64>(n, no, no, Par::Seq, spec));
    let stack = MemStack::new(&mut memory);
    let (mut real, mut imaginary) = (Diag::zeros(n), Diag::zeros(n));
    let (re, im) = (real.as_mut(), imaginary.as_mut());
    match evd_real(matrix, re, im, None, None, Par::Seq, stack, spec) {
        Ok(()) => (0..n)
            .map(|i| Complex::new(real[i], imaginary[i]))
            .collect(),
        Err(_) => Vec::new(),
    }
}
