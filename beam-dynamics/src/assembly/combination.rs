//! Sums of the derivatives of a system, by the unknowns of an integration formula.

use nalgebra::Matrix3;

use super::Sparse;

/// A weighted sum of the derivatives of a residual, and the matrix that holds it.
#[derive(Debug)]
pub struct Combination<'a> {
    /// Weight of the derivatives by the unknowns [-].
    pub by_unknowns: f64,
    /// Weight of the derivatives by the rates of the unknowns [-].
    pub by_rates: f64,
    /// Weight of the columns of multipliers, to which the other two do not apply [-].
    pub by_algebraic: f64,
    /// The matrix of the sum.
    pub matrix: &'a mut Sparse,
}

impl<'a> Combination<'a> {
    /// The derivatives by the unknowns.
    pub fn by_unknowns(matrix: &'a mut Sparse) -> Self {
        Self {
            by_unknowns: 1.0,
            by_rates: 0.0,
            by_algebraic: 1.0,
            matrix,
        }
    }

    /// The derivatives by the rates of the unknowns.
    pub fn by_rates(matrix: &'a mut Sparse) -> Self {
        Self {
            by_unknowns: 0.0,
            by_rates: 1.0,
            by_algebraic: 0.0,
            matrix,
        }
    }

    /// The three weights.
    pub(super) fn weights(&self) -> [f64; 3] {
        [self.by_unknowns, self.by_rates, self.by_algebraic]
    }
}

/// Motion of a node by the unknowns of a formula: with u the Gibbs-Rodrigues parameters of its
/// correction, xi another of its vectors, u' and xi' their rates,
///
/// ```text
/// theta = G du          d omega = G du' + W du
/// dx    = U dxi         dv      = U dxi' + S dxi          and the same for the momenta
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variation {
    /// G [-].
    pub turn: Matrix3<f64>,
    /// W [1/s].
    pub rate_by_turn: Matrix3<f64>,
    /// U and S [1/s]; `None` if U is the identity and S is zero.
    pub axes: Option<[Matrix3<f64>; 2]>,
}
