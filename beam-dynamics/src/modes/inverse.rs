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
//! momenta p, and charges and currents e of circuits. Multipliers and unknowns that move
//! no mass have no rates and drop out. q is scaled by the root of its mass, so that light and heavy
//! bodies weigh the same, p so that the blocks `T_qp` and `T_pq` are of the same size, and e
//! likewise against both.

use std::collections::BTreeSet;

use faer::{Mat, MatRef, c64};

use super::krylov::{Found, Operator, largest, rough, start_value};
use crate::assembly::Entry;
use crate::model::NODE_UNKNOWNS;
use crate::solver::Factorization;
use crate::solver::{Eigenvectors, eigenvalues};

/// Up to this number of unknowns T is formed and all its eigenvalues are computed;
/// above, only the wanted ones.
pub(super) const DENSE: usize = 100;
/// An eigenvalue of T below this part of the largest one is treated as zero: eigenvalues at
/// zero are defective, and round-off moves them to about the cube root of 1e-16.
pub(super) const INFINITE: f64 = 1e-7;

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
    /// Indices of the unknowns of T in the system, ascending.
    indices: Vec<usize>,
    shift: f64,
    /// Magnitude of s below which it is zero [1/s].
    zero: f64,
    /// Scale of each unknown: value = scale times scaled value.
    scale: Vec<f64>,
}

impl Inverse {
    /// T on all unknowns with a rate, of which the first have `masses` and are of nodes, for
    /// a factorization at `shift` and the entries of `F_y'` that are not zero; `None` when T
    /// is not finite.
    pub fn new(
        factorization: Factorization,
        rates: &[Entry],
        masses: &[f64],
        shift: f64,
    ) -> Option<Self> {
        let size = masses.len();
        let indices: BTreeSet<_> = rates.iter().map(|entry| entry.1).collect();
        let indices: Vec<_> = indices.into_iter().collect();
        // Every column of an entry is among the indices.
        let number = |index: usize| indices.binary_search(&index).unwrap_or_default();
        let rates = rates
            .iter()
            .map(|&(row, index, value)| (row, number(index), value));
        let mut inverse = Self {
            factorization,
            rates: rates.collect(),
            of_nodes: indices.partition_point(|index| *index < size),
            scale: scales(&indices, masses),
            indices,
            shift,
            zero: 0.0,
        };
        inverse.balance()?;
        Some(inverse)
    }

    /// The shift sigma [1/s].
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// Magnitude of s below which it is zero \[1/s\].
    pub fn zero(&self) -> f64 {
        self.zero
    }

    /// Takes s of a magnitude below `zero` for zero.
    pub fn set_zero(&mut self, zero: f64) {
        self.zero = zero;
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

    /// Whether all eigenvalues are computed if `count` are requested, as for problems of up to
    /// `dense` unknowns.
    pub fn is_small(&self, count: usize, dense: usize) -> bool {
        self.scale.len() <= dense.max(3 * Self::wanted(count))
    }

    /// Number of eigenvalues that the iteration converges if `count` pairs are requested.
    fn wanted(count: usize) -> usize {
        2 * count + 10
    }

    /// A rough view of the eigenvalues s nearest to the shift, of a pair the first, by
    /// magnitude, with their vectors: real and imaginary part a column each.
    pub fn coarse(&self) -> Vec<(c64, Mat<f64>)> {
        let inverted = if self.scale.len() <= DENSE {
            Eigenvectors::new(self.whole().as_ref()).firsts()
        } else {
            rough(self, ROUGH_BLOCK, ROUGH_STEPS)
        };
        let sizes = inverted.iter().map(|(value, _)| value.norm());
        let largest = sizes.fold(0.0, f64::max);
        let finite = inverted.into_iter();
        let finite = finite.filter(|(value, _)| value.norm() > INFINITE * largest);
        let mut found: Vec<_> = finite
            .map(|(value, vector)| (self.shift + value.inv(), vector))
            .collect();
        found.sort_by(|a, b| a.0.norm().total_cmp(&b.0.norm()));
        found
    }

    /// The eigenvalues s of T in the space of some `columns` in all unknowns of the system, of a pair the one with
    /// positive imaginary part, with their vectors in all unknowns, real and imaginary part a column each, and
    /// their relative errors.
    pub fn within(&self, columns: &Mat<f64>) -> Vec<(c64, Mat<f64>, f64)> {
        let scaled = |columns: &Mat<f64>| {
            let entry = |i: usize, j: usize| columns[(self.indices[i], j)] / self.scale[i];
            Mat::from_fn(self.indices.len(), columns.ncols(), entry)
        };
        let mut start = scaled(columns);
        for j in 0..start.ncols() {
            let size = start.col(j).norm_l2();
            let factor = if size > 0.0 { size.recip() } else { 0.0 };
            let mut column = start.col_mut(j);
            column *= faer::Scale(factor);
        }
        let basis = start.qr().compute_thin_Q();
        let products = self.product(&basis);
        let projected = basis.transpose() * scaled(&products);
        let firsts = Eigenvectors::new(projected.as_ref()).firsts().into_iter();
        let firsts = firsts.filter(|(inverted, _)| inverted.norm() > 0.0);
        let found = |(inverted, mut parts): (c64, Mat<f64>)| {
            let s = self.value(inverted);
            // The vector of the conjugate value is the conjugate one.
            if s.im < 0.0 {
                parts.col_mut(1).iter_mut().for_each(|part| *part = -*part);
            }
            let s = c64::new(s.re, s.im.abs());
            let (vector, product) = (&basis * &parts, &products * &parts);
            let error = self.error(s, vector.as_ref(), product.as_ref());
            (s, product, error)
        };
        firsts.map(found).collect()
    }

    /// Error of a rough value s with its vector and their product by [`Self::product`],
    /// relative.
    pub fn error(&self, s: c64, vector: MatRef<'_, f64>, product: MatRef<'_, f64>) -> f64 {
        let pairs = self.indices.iter().zip(&self.scale).enumerate();
        let parts = pairs.map(|(i, (&index, scale))| {
            let expected = c64::new(vector[(i, 0)], vector[(i, 1)]) / (s - self.shift);
            let found = c64::new(product[(index, 0)], product[(index, 1)]) / *scale;
            [(found - expected).norm_sqr(), expected.norm_sqr()]
        });
        let [error, size] = parts.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
        (error / size).sqrt()
    }

    /// At least the `2 count` eigenvalues s nearest to the shift, conjugate pairs and up
    /// to `copies` of one value included, where there are so many; all are computed of
    /// problems of up to `dense` unknowns.
    pub fn smallest(&self, count: usize, copies: usize, dense: usize) -> Vec<c64> {
        self.nearest(count, copies, dense).0
    }

    /// As [`Self::smallest`], with the space of the vectors if it was built.
    pub fn nearest(&self, count: usize, copies: usize, dense: usize) -> (Vec<c64>, Option<Found>) {
        if self.is_small(count, dense) {
            return (self.restored(&self.all()), None);
        }
        // One more pair, so that none is cut apart; the others only lead the iteration.
        let sure = 2 * count + 2;
        let found = largest(self, Self::wanted(count), sure, copies);
        (self.restored(&found.values), Some(found))
    }

    /// The s of an eigenvalue of T.
    pub fn value(&self, inverted: c64) -> c64 {
        c64::new(self.shift, 0.0) + c64::new(1.0, 0.0) / inverted
    }

    /// The finite s of eigenvalues of T.
    fn restored(&self, inverted: &[c64]) -> Vec<c64> {
        let size = inverted.iter().map(|value| value.norm());
        let size = size.fold(0.0, f64::max);
        let finite = inverted
            .iter()
            .filter(|value| value.norm() > INFINITE * size);
        finite.map(|value| self.value(*value)).collect()
    }

    /// `T x` for one scaled x, in place.
    fn multiply_one(&self, x: &mut [f64]) {
        let mut column = Mat::from_fn(x.len(), 1, |i, _| x[i]);
        self.multiply(&mut column);
        for (i, value) in x.iter_mut().enumerate() {
            *value = column[(i, 0)];
        }
    }

    /// Scales the momenta, and then the unknowns that are not of nodes, by the sizes of the two
    /// blocks that couple them with the rest, estimated with one vector; `None` when T is not finite.
    fn balance(&mut self) -> Option<()> {
        let of_nodes = self.of_nodes;
        let numbers = self.indices.iter().map(|index| index % NODE_UNKNOWNS);
        let momenta = numbers
            .map(|number| number >= NODE_UNKNOWNS / 2)
            .enumerate();
        let momenta: Vec<_> = momenta.map(|(i, is)| is && i < of_nodes).collect();
        self.balance_part(&momenta)?;
        let others: Vec<_> = (0..self.indices.len()).map(|i| i >= of_nodes).collect();
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
                self.scale[i] *= scale;
            }
        }
        Some(())
    }

    /// T as a matrix.
    fn whole(&self) -> Mat<f64> {
        let mut matrix = Mat::identity(self.scale.len(), self.scale.len());
        self.multiply(&mut matrix);
        matrix
    }

    /// All eigenvalues of T; empty when the iteration fails.
    fn all(&self) -> Vec<c64> {
        eigenvalues(self.whole().as_ref())
    }

    /// `T x` column by column, in all unknowns of the system, also those without rates.
    pub fn product(&self, x: &Mat<f64>) -> Mat<f64> {
        let mut product = Mat::zeros(self.factorization.size(), x.ncols());
        for j in 0..x.ncols() {
            let (from, mut to) = (x.col(j), product.col_mut(j));
            for &(row, column, value) in &self.rates {
                to[row] -= value * self.scale[column] * from[column];
            }
        }
        // A singular matrix was refused before; entries that are not finite become NaN.
        if self.factorization.solve_columns(&mut product).is_none() {
            product.fill(f64::NAN);
        }
        product
    }

    /// `|T v - v / (s - sigma)|` relative to `|v / (s - sigma)|`, v in all unknowns of the
    /// system: about 1e-12 for a well-conditioned model.
    pub fn residual(&self, s: c64, vector: &[c64]) -> f64 {
        let scaled = |i: usize| vector[self.indices[i]] / self.scale[i];
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
    fn is_in_cluster(&self, value: &c64) -> bool {
        (value * self.shift + 1.0).norm() <= self.zero * value.norm()
    }

    fn size(&self) -> usize {
        self.scale.len()
    }

    fn multiply(&self, x: &mut Mat<f64>) {
        let product = self.product(x);
        for j in 0..x.ncols() {
            for (i, &index) in self.indices.iter().enumerate() {
                x[(i, j)] = product[(index, j)] / self.scale[i];
            }
        }
    }
}

/// First scales of the unknowns at `indices`, by the mass of each node: a motion is
/// multiplied by the square root of the mass and a momentum divided by it, so that light and
/// heavy bodies have the same weight. Rotations have the scale of their node: with the scale
/// of their own small inertia, the round-off of large stiffnesses would have more weight.
fn scales(indices: &[usize], masses: &[f64]) -> Vec<f64> {
    let of_node = |node: &[f64]| node.iter().take(3).fold(0.0_f64, |a, b| a.max(*b));
    let of_nodes: Vec<_> = masses.chunks(NODE_UNKNOWNS).map(of_node).collect();
    let largest = of_nodes.iter().fold(0.0_f64, |a, b| a.max(*b));
    let scale = |&index: &usize| match of_nodes.get(index / NODE_UNKNOWNS) {
        Some(own) if largest > 0.0 => {
            let root = if *own > 0.0 { own } else { &largest }.sqrt();
            if index % NODE_UNKNOWNS < NODE_UNKNOWNS / 2 {
                root.recip()
            } else {
                root
            }
        }
        _ => 1.0,
    };
    indices.iter().map(scale).collect()
}
