//! The blocks of one cell of a curved beam for the matrices of the section.
//!
//! With the metric J, a, b of the line (S-71), and for solutions that vary along the beam
//! as `exp(lambda x)`, `B = B0 + lambda B1` replaces B0 (S-73): `E`, `R` are then the
//! matrices of the varying solution, Hermitian for an imaginary lambda. Each node i enters
//! the strain through four functions times constant operators:
//!
//! ```text
//! B_i = (k x + lambda) S N_i/J  -  S (a N_i,y + b N_i,z)/J  +  Py N_i,y  +  Pz N_i,z
//!     = sum_p W_p f_pi      W = S (k x + lambda), S, Py, Pz
//! E_ij = int B_i^H D B_j J dA  = sum_pq (W_p^H D W_q) int f_pi f_qj J dA
//! R_i  = int B_i^H D Bpsi J dA = sum_p  (W_p^H D S)   int f_pi [I, -t x] dA
//! A    = int Bpsi' D Bpsi J dA = int [I, -t x]' S' D S [I, -t x] dA / J
//! ```
//!
//! The law is constant over a cell, so that the integrals are the same for all lambda.
//!
//! # References
//! - Giavotto et al. 1983: the matrices of the straight section.
//! - [Borri1992]: the matrices of beams with initial curvature.

use super::blocks::{Moments, PairIntegrals, rigid};
use super::line::Line;
use super::point::{CellPoint, rule_points};
use super::strain::{FACE_STRAINS, Fed};
use crate::material::CoupledLaw;
use nalgebra::{ComplexField, Matrix6, SMatrix};
use shared_geom::mesh::CellKind;
use shared_geom::rotation::skew;

/// Number of functions of a node in the strain.
const PARTS: usize = 4;

/// Integrals over a cell of a curved beam, of products of the four functions of its
/// nodes.
#[derive(Debug, Clone)]
pub struct CurvedCell {
    /// `int f_pi f_qj J dA`, `[p][q][i][j]`.
    pairs: [[PairIntegrals; PARTS]; PARTS],
    /// `int f_pi (1, y, z) dA`, `[p][i]`.
    moments: [[Moments; 9]; PARTS],
    /// `int (1, y, z, y y, y z, z z) dA / J`.
    area: [f64; 6],
}

impl CurvedCell {
    /// Integrates over the cell with `nodes` (y, z).
    ///
    /// # Errors
    /// The first area of an integration point that is not positive \[m^2\]: the
    /// cell is inverted or has no area.
    #[inline(always)]
    pub fn new(line: &Line, kind: CellKind, nodes: &[[f64; 2]]) -> Result<Self, f64> {
        let mut cell = Self {
            pairs: [[[[0.0; 9]; 9]; PARTS]; PARTS],
            moments: [[[0.0; 3]; 9]; PARTS],
            area: [0.0; 6],
        };
        for point in rule_points(kind) {
            let point = point.of_cell(nodes);
            let positive = point.area > 0.0;
            if !positive {
                return Err(point.area);
            }
            cell.add(line, &point);
        }
        Ok(cell)
    }

    #[inline(always)]
    fn add(&mut self, line: &Line, point: &CellPoint) {
        let metric = line.metric(point.y, point.z);
        let per_volume = 1.0 / metric.volume;
        let [a, b] = metric.tilt.map(|tilt| tilt * per_volume);
        let mut functions = [point.n, [0.0; 9], point.dy, point.dz];
        for i in 0..point.count {
            functions[0][i] *= per_volume;
            functions[1][i] = -(a * point.dy[i] + b * point.dz[i]);
        }
        let volume = point.area * metric.volume;
        for (of_p, f) in self.pairs.iter_mut().zip(&functions) {
            for (pairs, g) in of_p.iter_mut().zip(&functions) {
                for i in 0..point.count {
                    let f = volume * f[i];
                    for j in 0..point.count {
                        pairs[i][j] += f * g[j];
                    }
                }
            }
        }
        for (sums, f) in self.moments.iter_mut().zip(&functions) {
            for i in 0..point.count {
                let f = point.area * f[i];
                sums[i][0] += f;
                sums[i][1] += f * point.y;
                sums[i][2] += f * point.z;
            }
        }
        let (y, z, weight) = (point.y, point.z, point.area * per_volume);
        for (sum, product) in (self.area.iter_mut()).zip([1.0, y, z, y * y, y * z, z * z]) {
            *sum += weight * product;
        }
    }

    /// `int (1, y, z, y y, y z, z z) dA / J`.
    pub fn area(&self) -> &[f64; 6] {
        &self.area
    }

    /// `E_ij`.
    #[inline(always)]
    pub fn e<T, const C: usize>(
        &self,
        law: &TurningLaw<T, C>,
        i: usize,
        j: usize,
    ) -> SMatrix<T, C, C>
    where
        T: ComplexField<RealField = f64> + Copy,
    {
        let mut block = SMatrix::<T, C, C>::zeros();
        for (of_p, laws) in self.pairs.iter().zip(&law.products) {
            for (pairs, law) in of_p.iter().zip(laws) {
                let factor = pairs[i][j];
                block.zip_apply(law, |sum: &mut T, entry: T| *sum += entry.scale(factor));
            }
        }
        block
    }

    /// `R_i`.
    #[inline(always)]
    pub fn r<T, const C: usize>(&self, law: &TurningLaw<T, C>, i: usize) -> SMatrix<T, C, 6>
    where
        T: ComplexField<RealField = f64> + Copy,
    {
        let mut rows = SMatrix::<T, C, 6>::zeros();
        for (moments, law) in self.moments.iter().zip(&law.loads) {
            rows += law * rigid(&moments[i]).map(T::from_real);
        }
        rows
    }
}

/// The products of a law with the operators of a line and a rate lambda, for cells whose
/// nodes have C unknowns. The potential does not turn with the section: for it k x + lambda
/// reduces to lambda.
#[derive(Debug, Clone)]
pub struct TurningLaw<T, const C: usize> {
    /// `W_p^H D W_q` \[Pa\].
    products: [[SMatrix<T, C, C>; PARTS]; PARTS],
    /// `W_p^H D S`, S of the displacements \[Pa\].
    loads: [SMatrix<T, C, 3>; PARTS],
}

impl<T: ComplexField<RealField = f64> + Copy> TurningLaw<T, 3> {
    /// The products of the law `d`, order yz yy zz xx xy xz \[Pa\], for solutions that
    /// vary along the `line` as `exp(lambda x)`.
    pub fn new(line: &Line, lambda: T, d: &Matrix6<f64>) -> Self {
        Self::of_entries(&Fed::DISPLACEMENTS, (line, lambda), |i, j| d[(i, j)])
    }
}

impl<T: ComplexField<RealField = f64> + Copy> TurningLaw<T, 4> {
    /// As [`TurningLaw::new`], of a coupled law.
    pub fn coupled(line: &Line, lambda: T, d: &CoupledLaw) -> Self {
        Self::of_entries(&Fed::WITH_POTENTIAL, (line, lambda), |i, j| d[(i, j)])
    }
}

impl<T: ComplexField<RealField = f64> + Copy, const C: usize> TurningLaw<T, C> {
    fn of_entries(
        fed: &Fed<C>,
        (line, lambda): (&Line, T),
        entry: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let rows = [&fed.face, &fed.face, &fed.along_y, &fed.along_z];
        let of_line = skew(&line.curvature);
        let turn = SMatrix::<T, C, C>::from_fn(|i, j| {
            let turn = if i < 3 && j < 3 { of_line[(i, j)] } else { 0.0 };
            T::from_real(turn) + if i == j { lambda } else { T::zero() }
        });
        let product = |p: usize, q: usize| {
            let mut part =
                SMatrix::<T, C, C>::from_fn(|i, j| T::from_real(entry(rows[p][i], rows[q][j])));
            if q == 0 {
                part *= turn;
            }
            if p == 0 { turn.adjoint() * part } else { part }
        };
        let load = |p: usize| {
            let part = SMatrix::<T, C, 3>::from_fn(|i, j| {
                T::from_real(entry(rows[p][i], FACE_STRAINS[j]))
            });
            if p == 0 { turn.adjoint() * part } else { part }
        };
        Self {
            products: std::array::from_fn(|p| std::array::from_fn(|q| product(p, q))),
            loads: std::array::from_fn(load),
        }
    }
}
