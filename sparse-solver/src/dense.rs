//! All eigenvalues of a small dense matrix.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, EvdParams, evd_real, evd_scratch};
use faer::{Auto, Mat, MatMut, MatRef, Par, c64};

/// All eigenvalues of a square matrix; empty when it is not finite or the iteration
/// fails.
///
/// The plain QR iteration at any size: the multishift one of faer 0.24, which it takes
/// from size 75 on by itself, has been seen not to end.
pub fn eigenvalues(matrix: MatRef<'_, f64>) -> Vec<c64> {
    values_and_vectors(matrix, None)
}

/// All eigenvalues of the square matrix with entries `entries`, column by column, as
/// [`eigenvalues`].
pub fn eigenvalues_of(entries: &[f64]) -> Vec<c64> {
    let n = entries.len().isqrt();
    eigenvalues(MatRef::from_column_major_slice(entries, n, n))
}

/// Eigenvalues and right eigenvectors.
#[derive(Debug)]
pub struct Eigenvectors {
    /// The eigenvalues \[-\].
    pub values: Vec<c64>,
    /// A column of each real value, and of a pair the real and the imaginary part of the
    /// vector of its first value.
    columns: Mat<f64>,
}

impl Eigenvectors {
    /// All of a square matrix; none when it is not finite or the iteration fails.
    pub fn new(matrix: MatRef<'_, f64>) -> Self {
        let n = matrix.nrows();
        let mut columns = Mat::zeros(n, n);
        Self {
            values: values_and_vectors(matrix, Some(columns.as_mut())),
            columns,
        }
    }

    /// Real values, and the first of each pair, with real and imaginary part of the vector
    /// as columns.
    pub fn firsts(&self) -> Vec<(c64, Mat<f64>)> {
        let n = self.columns.nrows();
        let mut found = Vec::new();
        let mut next = 0;
        while let Some(value) = self.values.get(next) {
            let of_pair = if value.im == 0.0 { 1 } else { 2.min(n - next) };
            let mut parts = Mat::zeros(n, 2);
            let own = self.columns.subcols(next, of_pair);
            parts.subcols_mut(0, of_pair).copy_from(own);
            found.push((*value, parts));
            next += of_pair;
        }
        found
    }
}

/// The eigenvalues, and where they are wanted their vectors.
fn values_and_vectors(matrix: MatRef<'_, f64>, vectors: Option<MatMut<'_, f64>>) -> Vec<c64> {
    let n = matrix.nrows();
    if !matrix.is_all_finite() {
        return Vec::new();
    }
    let mut parameters = <EvdParams as Auto<f64>>::auto();
    parameters.schur.blocking_threshold = usize::MAX;
    let wanted = match &vectors {
        Some(_) => ComputeEigenvectors::Yes,
        None => ComputeEigenvectors::No,
    };
    let spec = parameters.into();
    let no = ComputeEigenvectors::No;
    let mut memory = MemBuffer::new(evd_scratch::<f64>(n, no, wanted, Par::Seq, spec));
    let stack = MemStack::new(&mut memory);
    let (mut real, mut imaginary) = (Diag::zeros(n), Diag::zeros(n));
    let (re, im) = (real.as_mut(), imaginary.as_mut());
    match evd_real(matrix, re, im, None, vectors, Par::Seq, stack, spec) {
        Ok(()) => (0..n).map(|i| c64::new(real[i], imaginary[i])).collect(),
        Err(_) => Vec::new(),
    }
}
