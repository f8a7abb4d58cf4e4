//! The systems of all six central solutions, along any line of constant curvature.
//!
//! With `theta' = T' theta` the solutions `u = X theta`, `psi = Y theta` satisfy
//!
//! ```text
//! M X T'^2 + (C - C') X T' + L Y T' - E X - R Y = 0       L' X T' + R' X + A Y = I   (S-75)
//! ```
//!
//! T' = Q S Q^H has the eigenvalues 0, i w, -i w, each twice, w = |k|. With v0 = k/w,
//! and v the unit vector with `-k x v = i w v`, the columns of Q in the order
//!
//! ```text
//! (0, v0)  (0, v)  (0, v*)  (v0, 0)  (v, 0)  (v*, 0)
//! ```
//!
//! make S upper triangular exactly, for any small k (S-74): the moments are independent of
//! the forces, and the forces depend on the moments. The matrix of a column is the matrix
//! of solutions `exp(lambda x)` with its eigenvalue (S-73), so that two factorizations
//! suffice: a real one for 0, a Hermitian one for i w; the columns of v* are the conjugates
//! of the columns of v. With k = 0 all columns have lambda = 0.
//!
//! # References
//! - [Borri1992]: central solutions of beams with initial curvature.

use super::factor::{FactorError, Pivot};
use super::pins::Pins;
use super::system::CentralSystem;
use crate::assembly::{Model, Pattern, SectionMatrices};
use crate::failure::Failure;
use nalgebra::{Complex, DMatrix, DMatrixView, Matrix6, Matrix6xX, Vector3};

/// The factored systems of a section: of states that are steady along the beam, and, if it
/// is curved, of states that vary as exp(i w x).
#[derive(Debug)]
pub struct CentralSystems {
    steady: CentralSystem<f64>,
    pub(super) wave: Option<Wave>,
}

/// The system of lambda = i w, and its basis.
#[derive(Debug)]
pub(super) struct Wave {
    pub system: CentralSystem<Complex<f64>>,
    /// v0.
    pub axis: Vector3<f64>,
    /// v.
    pub turning: Vector3<Complex<f64>>,
}

/// Reason why there are no systems.
#[derive(Debug)]
pub enum SystemError {
    /// A matrix could not be assembled.
    Matrices(Failure),
    /// A matrix could not be factored.
    Factor(FactorError),
}

impl From<FactorError> for SystemError {
    fn from(error: FactorError) -> Self {
        Self::Factor(error)
    }
}

/// States in the basis of a wave: a real column and a complex one for three.
struct InBasis {
    steady: (DMatrix<f64>, Matrix6xX<f64>),
    wave: (DMatrix<Complex<f64>>, Matrix6xX<Complex<f64>>),
}

impl CentralSystems {
    /// Factors the systems of `model`; `matrices` are the matrices of the steady states.
    ///
    /// # Errors
    /// [`SystemError`] when a matrix is not positive definite with the pins held, or
    /// its Schur complement is not.
    pub fn new(
        model: &impl Model,
        pattern: &Pattern,
        matrices: SectionMatrices<f64>,
        pins: Pins,
    ) -> Result<Self, SystemError> {
        Ok(Self {
            steady: CentralSystem::new(pattern, matrices, pins.clone())?,
            wave: Wave::new(model, pattern, pins)?,
        })
    }

    /// The system of states that are steady along the beam.
    pub fn steady(&self) -> &CentralSystem<f64> {
        &self.steady
    }

    /// The smallest pivot of the factorizations.
    pub fn smallest_pivot(&self) -> Pivot {
        let steady = self.steady.factor().smallest_pivot();
        match self
            .wave
            .as_ref()
            .map(|wave| wave.system.factor().smallest_pivot())
        {
            Some(pivot) if pivot.ratio < steady.ratio => pivot,
            _ => steady,
        }
    }

    /// Estimate, from below, of the condition number of the worst factored matrix.
    pub fn condition(&self) -> f64 {
        let of_wave = self.wave.as_ref().map(|wave| wave.system.condition());
        of_wave.map_or(self.steady.condition(), |of_wave| {
            of_wave.max(self.steady.condition())
        })
    }

    /// The states that balance internal forces `theta` whose solutions do not depend on
    /// other internal forces: the moments, on any line; on a straight line also the axial
    /// force.
    pub fn balance_of(&self, theta: &Matrix6<f64>) -> (DMatrix<f64>, Matrix6<f64>) {
        let theta: Matrix6xX<f64> = theta.columns(0, 6).into_owned();
        let (x, y) = match &self.wave {
            None => self.steady.balance_of(&theta),
            Some(wave) => {
                let none = DMatrix::zeros(0, 6);
                let parts = wave.split(none.as_view(), &theta);
                wave.joined(&InBasis {
                    steady: self.steady.balance_of(&parts.steady.1),
                    wave: wave.system.balance_of(&parts.wave.1),
                })
            }
        };
        (x, y.fixed_view::<6, 6>(0, 0).into_owned())
    }

    /// Replaces missing forces `dq` (n x k, column by column) and `dtheta` (6 x k) of the
    /// central solutions by the changes of state that balance them; `None` if memory is
    /// insufficient. On a curved beam the columns belong to all forces, to all moments, or
    /// both.
    pub fn correct(&self, dq: &mut [f64], dtheta: &mut Matrix6xX<f64>) -> Option<()> {
        let Some(wave) = &self.wave else {
            return self.steady.correct(dq, dtheta);
        };
        let columns = dtheta.ncols();
        let n = dq.len() / columns;
        let mut parts = wave.split(DMatrixView::from_slice(dq, n, columns), dtheta);
        let (q, theta) = &mut parts.steady;
        self.steady.correct(q.as_mut_slice(), theta)?;
        let (q, theta) = &mut parts.wave;
        wave.system.correct(q.as_mut_slice(), theta)?;
        let (x, y) = wave.joined(&parts);
        dq.copy_from_slice(x.as_slice());
        *dtheta = y;
        Some(())
    }
}

impl Wave {
    /// Factors the system of lambda = i |k|; `None` for a straight beam.
    fn new(model: &impl Model, pattern: &Pattern, pins: Pins) -> Result<Option<Self>, SystemError> {
        let curvature = &model.line().curvature;
        let w = curvature.norm();
        if w == 0.0 {
            return Ok(None);
        }
        let lambda = Complex::new(0.0, w);
        let matrices = model.wave(pattern, lambda);
        let matrices = matrices.map_err(SystemError::Matrices)?;
        let (axis, turning) = basis(curvature);
        Ok(Some(Self {
            system: CentralSystem::new(pattern, matrices, pins)?,
            axis,
            turning,
        }))
    }

    /// Columns of forces or moments, in groups of three, times v0 and v.
    fn split(&self, q: DMatrixView<'_, f64>, theta: &Matrix6xX<f64>) -> InBasis {
        let groups = theta.ncols() / 3;
        let (mut real_q, mut wave_q) = (
            DMatrix::zeros(q.nrows(), groups),
            DMatrix::zeros(q.nrows(), groups),
        );
        let (mut real_theta, mut wave_theta) = (Matrix6xX::zeros(groups), Matrix6xX::zeros(groups));
        for group in 0..groups {
            for m in 0..3 {
                let (v0, v) = (self.axis[m], self.turning[m]);
                let column = 3 * group + m;
                real_q.column_mut(group).axpy(v0, &q.column(column), 1.0);
                for (sum, value) in wave_q.column_mut(group).iter_mut().zip(&q.column(column)) {
                    *sum += v * *value;
                }
                for i in 0..6 {
                    real_theta[(i, group)] += v0 * theta[(i, column)];
                    wave_theta[(i, group)] += v * theta[(i, column)];
                }
            }
        }
        InBasis {
            steady: (real_q, real_theta),
            wave: (wave_q, wave_theta),
        }
    }

    /// The inverse of the projection: `d0 v0' + 2 Re(d v^H)`.
    fn joined(&self, parts: &InBasis) -> (DMatrix<f64>, Matrix6xX<f64>) {
        let ((x0, y0), (x, y)) = (&parts.steady, &parts.wave);
        let groups = y0.ncols();
        let value = |d0: f64, d: Complex<f64>, m: usize| {
            d0 * self.axis[m] + 2.0 * (d * self.turning[m].conj()).re
        };
        let of = |column: usize| (column / 3, column % 3);
        let warping = DMatrix::from_fn(x0.nrows(), 3 * groups, |row, column| {
            let (group, m) = of(column);
            value(x0[(row, group)], x[(row, group)], m)
        });
        let mut strain = Matrix6xX::zeros(3 * groups);
        for column in 0..3 * groups {
            let (group, m) = of(column);
            for row in 0..6 {
                strain[(row, column)] = value(y0[(row, group)], y[(row, group)], m);
            }
        }
        (warping, strain)
    }
}

/// v0 and v of a curvature that is not zero: `v = (a + i b)/sqrt 2` with a normal to
/// v0, `b = v0 x a`, so that `-k x v = i w v`.
fn basis(curvature: &Vector3<f64>) -> (Vector3<f64>, Vector3<Complex<f64>>) {
    let axis = curvature.normalize();
    let a = axis.cross(&Vector3::ith(axis.iamin(), 1.0)).normalize();
    let b = axis.cross(&a);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let turning = Vector3::from_fn(|i, _| Complex::new(half * a[i], half * b[i]));
    (axis, turning)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Line;
    use approx::assert_relative_eq;

    /// (S-74): S = Q^H T' Q is upper triangular with 0, i w, -i w on its diagonal, for
    /// any curvature and slope.
    #[test]
    fn basis_makes_equilibrium_triangular() {
        let slope = Vector3::new(0.9, -0.3, 0.2);
        for k in [[0.3, -0.2, 0.5], [0.0, 0.0, 1e-9], [2.0, 0.0, 0.0]] {
            let curvature = Vector3::from(k);
            let line = Line { curvature, slope };
            let (axis, v) = basis(&curvature);
            let mut q: Matrix6<Complex<f64>> = Matrix6::zeros();
            for (group, rows) in [3, 0].into_iter().enumerate() {
                for i in 0..3 {
                    q[(rows + i, 3 * group)] = axis[i].into();
                    q[(rows + i, 3 * group + 1)] = v[i];
                    q[(rows + i, 3 * group + 2)] = v[i].conj();
                }
            }
            assert_relative_eq!(
                (q.adjoint() * q - Matrix6::identity()).camax(),
                0.0,
                epsilon = 1e-15
            );
            let s = q.adjoint() * line.equilibrium().map(Complex::from) * q;
            let w = curvature.norm();
            for i in 0..6 {
                let lambda = Complex::new(0.0, [0.0, w, -w][i % 3]);
                // round-off of entries of order w and one
                assert!((s[(i, i)] - lambda).norm() <= 4e-16 * w);
                for j in 0..i {
                    assert!(s[(i, j)].norm() <= 4e-16 * w, "{i} {j}: {}", s[(i, j)]);
                }
            }
        }
    }
}
