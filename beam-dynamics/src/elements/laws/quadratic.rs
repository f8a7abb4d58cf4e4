//! The quadratic force of a section whose stiffness changes with its strain, and with heat
//! and other imposed states.
//!
//! ```text
//! q = e - sum c_i(t) psi_i                                                      (D-252)
//! f = 1/2 T q q + sum c_i(t) T_i q
//! energy  1/6 T q q q + 1/2 sum c_i(t) q . T_i q
//! ```

use nalgebra::{SMatrix, SVector};

use super::Response;
use crate::elements::{Instant, Signal};

/// `f = 1/2 T q q + sum c_i T_i q`, with q the strain beyond the free strain.
#[derive(Debug, Clone, PartialEq)]
pub struct Quadratic<const N: usize> {
    /// `T_ijk`, symmetric in all its indices: the derivative of the stiffness by the strain k is
    /// the matrix k [unit of force / unit of strain^2].
    pub third: Box<[SMatrix<f64, N, N>; N]>,
    /// Imposed states.
    pub imposed: Vec<Imposed<N>>,
}

/// An imposed state of a quadratic force.
#[derive(Debug, Clone, PartialEq)]
pub struct Imposed<const N: usize> {
    /// psi_i: strain without force for the factor one [unit of strain].
    pub free_strain: SVector<f64, N>,
    /// T_i: symmetric change of the stiffness without force for the factor one
    /// [unit of force / unit of strain].
    pub change: SMatrix<f64, N, N>,
    /// c_i [-].
    pub signal: Signal,
}

impl<const N: usize> Quadratic<N> {
    /// The force of `third` without any imposed state.
    pub fn new(third: Box<[SMatrix<f64, N, N>; N]>) -> Self {
        Self {
            third,
            imposed: Vec::new(),
        }
    }

    /// Adds force and derivative.
    pub(super) fn add(&self, strain: &SVector<f64, N>, now: &Instant<'_>, out: &mut Response<N>) {
        let (q, change) = self.now(strain, now);
        let by_strain = self.by_strain(&q);
        out.force += 0.5 * (by_strain * q) + change * q;
        out.by_strain += by_strain + change;
    }

    /// Calls `add` with the derivatives by scalars, see [`super::Law::by_scalars`]:
    /// `df/dc_i = -( T q + sum c_j T_j ) psi_i + T_i q`.
    pub(super) fn by_scalars(
        &self,
        strain: &SVector<f64, N>,
        now: &Instant<'_>,
        add: &mut impl FnMut(usize, &SVector<f64, N>, bool),
    ) {
        if !self.imposed.iter().any(|state| state.signal.senses()) {
            return;
        }
        let (q, change) = self.now(strain, now);
        let by_strain = self.by_strain(&q) + change;
        for state in &self.imposed {
            let force = state.change * q - by_strain * state.free_strain;
            let mut add = |scalar, slope: f64| add(scalar, &(slope * force), false);
            state.signal.gradient(now, &mut add);
        }
    }

    /// Energy at an instant.
    pub(super) fn energy(&self, strain: &SVector<f64, N>, now: &Instant<'_>) -> f64 {
        let (q, change) = self.now(strain, now);
        q.dot(&(self.by_strain(&q) * q)) / 6.0 + 0.5 * q.dot(&(change * q))
    }

    /// `T_ijk e_k`.
    pub(super) fn by_strain(&self, strain: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.third.iter().zip(strain).map(|(by, e)| by * *e).sum()
    }

    /// q, and the change of the stiffness by the imposed states.
    fn now(
        &self,
        strain: &SVector<f64, N>,
        now: &Instant<'_>,
    ) -> (SVector<f64, N>, SMatrix<f64, N, N>) {
        let (mut q, mut change) = (*strain, SMatrix::zeros());
        for state in &self.imposed {
            let factor = state.signal.value(now);
            q -= factor * state.free_strain;
            change += factor * state.change;
        }
        (q, change)
    }
}
