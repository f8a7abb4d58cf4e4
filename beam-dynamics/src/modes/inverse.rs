//! The inverted eigenvalue problem.
//!
//! ```text
//! T = -(F_y + sigma F_y')^-1 F_y'        T v = v / (s - sigma)
//! ```
//!
//! The s nearest to the real shift sigma are the largest eigenvalues of T; multipliers
//! and massless freedoms, whose s is infinite, are at zero. Oscillations are far from the
//! positive real axis, so that a shift of the order of the lowest frequency costs no
//! digits, and motions without stiffness, `F_y q = 0`, are eigenvalues as any other.
//!
//! Unknowns of T are those that have rates: positions and rotations q, momenta and angular
//! momenta p, and charges and currents e of circuits. Multipliers, and what moves no mass,
//! have no rates and drop out. p is scaled so that the blocks `T_qp` and `T_pq` are of the
//! same size, and e likewise against both.

use std::collections::BTreeSet;

use faer::{Mat, c64};

use super::dense::eigenvalues;
use super::krylov::{Operator, largest, rough, start_value};
use crate::assembly::Entry;
use crate::model::NODE_UNKNOWNS;
use crate::solver::Factorization;

/// Up to this number of unknowns T is formed and all its eigenvalues are computed;
/// above, only the wanted ones.
pub(super) const DENSE: usize = 100;
/// Parts of the largest eigenvalue of T below which one is taken for zero: those at
/// zero are defective, and round-off moves them to the cube root of 1e-16 or so.
const INFINITE: f64 = 1e-7;

/// Vectors of a block and steps of a rough view.
const ROUGH_BLOCK: usize = 4;
const ROUGH_STEPS: usize = 6;

/// The operator T on the unknowns that have rates, scaled.
#[derive(Debug)]
pub(super) struct Inverse {
    factorization: Factorization,
    /// Entries of `F_y'` that are not zero: row, column among the unknowns of T, value.
    rates: Vec<Entry>,
    /// Number of unknowns of T that are of nodes, which come first.
    of_nodes: usize,
    /// Places of the unknowns of T in the system, ascending.
    places: Vec<usize>,
    shift: f64,
    /// Scale of each unknown: value = scale times scaled value.
    scale: Vec<f64>,
}

impl Inverse {
    /// T on all unknowns with a rate, of which those up to `size` are of nodes, for a
    /// factorization at `shift` and the entries of `F_y'` that are not zero; `None` when T
    /// is not finite.
    pub fn new(
        factorization: Factorization,
        rates: &[Entry],
        size: usize,
        shift: f64,
    ) -> Option<Self> {
        let places: BTreeSet<_> = rates.iter().map(|entry| entry.1).collect();
        let places: Vec<_> = places.into_iter().collect();
        // Every column of an entry is among the places.
        let number = |place: usize| places.binary_search(&place).unwrap_or_default();
        let rates = rates
            .iter()
            .map(|&(row, place, value)| (row, number(place), value));
        let mut inverse = Self {
            factorization,
            rates: rates.collect(),
            of_nodes: places.partition_point(|place| *place < size),
            scale: vec![1.0; places.len()],
            places,
            shift,
        };
        inverse.balance()?;
        Some(inverse)
    }

    /// The shift sigma [1/s].
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// Columns of `(F_y + sigma F_y')^-1` for right-hand sides of one in each of `rows`;
    /// `None` when they are not finite.
    pub fn columns(&self, rows: &[usize]) -> Option<Mat<f64>> {
        let mut columns = Mat::zeros(self.factorization.size(), rows.len());
        for (j, row) in rows.iter().enumerate() {
            columns[(*row, j)] = 1.0;
        }
        self.factorization.solve_columns(&mut columns)?;
        Some(columns)
    }

    /// Whether all eigenvalues are computed where `count` are asked for, as they are of
    /// problems of up to `dense` unknowns.
    pub fn is_small(&self, count: usize, dense: usize) -> bool {
        self.scale.len() <= dense.max(3 * Self::wanted(count))
    }

    /// Eigenvalues that lead the iteration where `count` pairs are asked for.
    fn wanted(count: usize) -> usize {
        2 * count + 10
    }

    /// A rough view of the eigenvalues s nearest to the shift.
    pub fn coarse(&self) -> Vec<c64> {
        let inverted = match self.scale.len() <= DENSE {
            true => self.all(),
            false => rough(self, ROUGH_BLOCK, ROUGH_STEPS),
        };
        self.restored(inverted)
    }

    /// At least the `2 count` eigenvalues s nearest to the shift, conjugate pairs and up
    /// to `copies` of one value included, where there are so many; all are computed of
    /// problems of up to `dense` unknowns.
    pub fn smallest(&self, count: usize, copies: usize, dense: usize) -> Vec<c64> {
        // One more pair, so that none is cut apart; the others only lead the iteration.
        let sure = 2 * count + 2;
        let inverted = match self.is_small(count, dense) {
            true => self.all(),
            false => largest(self, Self::wanted(count), sure, copies),
        };
        self.restored(inverted)
    }

    /// The finite s of eigenvalues of T.
    fn restored(&self, inverted: Vec<c64>) -> Vec<c64> {
        let size = inverted.iter().map(|value| value.norm());
        let size = size.fold(0.0, f64::max);
        let finite = inverted
            .into_iter()
            .filter(|value| value.norm() > INFINITE * size);
        finite
            .map(|value| c64::new(self.shift, 0.0) + c64::new(1.0, 0.0) / value)
            .collect()
    }

    /// `T x` for one scaled x, in place.
    fn multiply_one(&self, x: &mut [f64]) {
        let mut column = Mat::from_fn(x.len(), 1, |i, _| x[i]);
        self.multiply(&mut column);
        for (i, value) in x.iter_mut().enumerate() {
            *value = column[(i, 0)];
        }
    }

    /// Scales the momenta, and then what is not of nodes, by the sizes of the two blocks that
    /// couple them with the rest, estimated with one vector; `None` when T is not finite.
    fn balance(&mut self) -> Option<()> {
        let of_nodes = self.of_nodes;
        let numbers = self.places.iter().map(|place| place % NODE_UNKNOWNS);
        let momenta = numbers
            .map(|number| number >= NODE_UNKNOWNS / 2)
            .enumerate();
        let momenta: Vec<_> = momenta.map(|(i, is)| is && i < of_nodes).collect();
        self.balance_part(&momenta)?;
        let others: Vec<_> = (0..self.places.len()).map(|i| i >= of_nodes).collect();
        self.balance_part(&others)
    }

    /// Scales the unknowns that are in a part; nothing where all or none are.
    fn balance_part(&mut self, is_in_part: &[bool]) -> Option<()> {
        let count = is_in_part.iter().filter(|is| **is).count();
        if count == 0 || count == is_in_part.len() {
            return Some(());
        }
        let norm = |x: &[f64], part: bool| {
            let of_part = x.iter().enumerate();
            let of_part = of_part.filter(|(i, _)| is_in_part[*i] == part);
            of_part.map(|(_, value)| value * value).sum::<f64>().sqrt()
        };
        let size_of_block = |from_part: bool| {
            let value = |i: usize| {
                if is_in_part[i] == from_part {
                    start_value(i)
                } else {
                    0.0
                }
            };
            let mut x: Vec<_> = (0..self.scale.len()).map(value).collect();
            let before = norm(&x, from_part);
            self.multiply_one(&mut x);
            norm(&x, !from_part) / before
        };
        let (rest_by_part, part_by_rest) = (size_of_block(true), size_of_block(false));
        if !(rest_by_part.is_finite() && part_by_rest.is_finite()) {
            return None;
        }
        if rest_by_part > 0.0 && part_by_rest > 0.0 {
            let scale = (part_by_rest / rest_by_part).sqrt();
            for i in (0..self.scale.len()).filter(|&i| is_in_part[i]) {
                self.scale[i] = scale;
            }
        }
        Some(())
    }

    /// All eigenvalues of T; empty when the iteration fails.
    fn all(&self) -> Vec<c64> {
        let mut matrix = Mat::zeros(self.scale.len(), self.scale.len());
        matrix.diagonal_mut().fill(1.0);
        self.multiply(&mut matrix);
        eigenvalues(matrix.as_ref())
    }

    /// `|T v - v / (s - sigma)|` relative to `|v / (s - sigma)|`, v in all unknowns of the
    /// system: about 1e-12 for a well-conditioned model.
    pub fn residual(&self, s: c64, vector: &[c64]) -> f64 {
        let scaled = |i: usize| vector[self.places[i]] / self.scale[i];
        let numbers = 0..self.scale.len();
        let expected: Vec<_> = numbers.map(|i| scaled(i) / (s - self.shift)).collect();
        let mut parts = Mat::from_fn(self.scale.len(), 2, |i, part| match part {
            0 => scaled(i).re,
            _ => scaled(i).im,
        });
        self.multiply(&mut parts);
        let found = (0..self.scale.len()).map(|i| c64::new(parts[(i, 0)], parts[(i, 1)]));
        let error: f64 = found.zip(&expected).map(|(a, b)| (a - b).norm_sqr()).sum();
        let size: f64 = expected.iter().map(|value| value.norm_sqr()).sum();
        (error / size).sqrt()
    }
}

impl Operator for Inverse {
    fn size(&self) -> usize {
        self.scale.len()
    }

    fn multiply(&self, x: &mut Mat<f64>) {
        let mut product = Mat::zeros(self.factorization.size(), x.ncols());
        for j in 0..x.ncols() {
            let (from, mut to) = (x.col(j), product.col_mut(j));
            for &(row, column, value) in &self.rates {
                to[row] -= value * self.scale[column] * from[column];
            }
        }
        // A singular matrix was refused before; what is not finite shows as NaN.
        if self.factorization.solve_columns(&mut product).is_none() {
            product.fill(f64::NAN);
        }
        for j in 0..x.ncols() {
            for (i, &place) in self.places.iter().enumerate() {
                x[(i, j)] = product[(place, j)] / self.scale[i];
            }
        }
    }
}
