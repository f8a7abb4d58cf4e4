//! The blocks of one cell for the matrices E, R, A of the section (S-10).
//!
//! The law is constant over a cell, so every matrix is a few integrals of products of shape
//! functions (numbers) times constant 3x3 parts of the law: the integration loop contains
//! only numbers.
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `D` | law in section axes, order yz yy zz xx xy xz | Pa | 6x6 |
//! | `S`, `Py`, `Pz` | map a rate, a y derivative, a z derivative of (ux, uy, uz) to the strain | - | 6x3 |
//! | `E` | `int B0' D B0` | Pa | n x n |
//! | `R` | `int B0' D Bpsi` | Pa m, Pa m^2 | n x 6 |
//! | `A` | `int Bpsi' D Bpsi` | Pa m^2 .. Pa m^4 | 6x6 |
//!
//! ```text
//! B0 = Py N,y + Pz N,z      Bpsi = S [I, -t x]
//! ```
//!
//! # References
//! - Giavotto et al. 1983: the matrices E, R, A of the internal work per length.
//! - Masarati 1999, section 5.3.4 and appendix E.2.

use super::point::{CellPoint, rule_points};
use super::strain::{FACE_STRAINS, Fed, rigid_displacement};
use crate::material::CoupledLaw;
use nalgebra::{Matrix3, Matrix3x6, Matrix6, SMatrix};
use shared_geom::mesh::CellKind;

/// The parts of a law that form the blocks, for cells whose nodes have C unknowns: three
/// displacements, and on dielectrics the potential \[Pa\].
#[derive(Debug, Clone, PartialEq)]
pub struct LawBlocks<const C: usize> {
    /// `S' D S` of the displacements.
    ss: Matrix3<f64>,
    /// `Py' D S`, S of the displacements.
    ys: SMatrix<f64, C, 3>,
    /// `Pz' D S`, S of the displacements.
    zs: SMatrix<f64, C, 3>,
    /// `Py' D Py`
    yy: SMatrix<f64, C, C>,
    /// `Py' D Pz`
    yz: SMatrix<f64, C, C>,
    /// `Pz' D Pz`
    zz: SMatrix<f64, C, C>,
}

impl LawBlocks<3> {
    /// The parts of the law `d`, order yz yy zz xx xy xz \[Pa\].
    pub fn new(d: &Matrix6<f64>) -> Self {
        Self::of_entries(&Fed::DISPLACEMENTS, |i, j| d[(i, j)])
    }
}

impl LawBlocks<4> {
    /// The parts of the coupled law `d`, order of [`CoupledLaw`] \[Pa\].
    pub fn coupled(d: &CoupledLaw) -> Self {
        Self::of_entries(&Fed::WITH_POTENTIAL, |i, j| d[(i, j)])
    }
}

impl<const C: usize> LawBlocks<C> {
    fn of_entries(fed: &Fed<C>, entry: impl Fn(usize, usize) -> f64) -> Self {
        let loads = |rows: &[usize; C]| {
            SMatrix::<f64, C, 3>::from_fn(|i, j| entry(rows[i], FACE_STRAINS[j]))
        };
        let part = |rows: &[usize; C], columns: &[usize; C]| {
            SMatrix::<f64, C, C>::from_fn(|i, j| entry(rows[i], columns[j]))
        };
        Self {
            ss: Matrix3::from_fn(|i, j| entry(FACE_STRAINS[i], FACE_STRAINS[j])),
            ys: loads(&fed.along_y),
            zs: loads(&fed.along_z),
            yy: part(&fed.along_y, &fed.along_y),
            yz: part(&fed.along_y, &fed.along_z),
            zz: part(&fed.along_z, &fed.along_z),
        }
    }

    /// The part of A from the cells of this law, whose integrals
    /// `int (1, y, z, y y, y z, z z)` are `area`.
    pub fn a_of_moments(&self, area: &[f64; 6]) -> Matrix6<f64> {
        a_of_moments(area, &self.ss)
    }
}

/// One number per pair of nodes; row i, column j.
pub(super) type PairIntegrals = [[f64; 9]; 9];

/// Sums of f, f y and f z over a cell.
pub(super) type Moments = [f64; 3];

/// Integrals over a cell of products of shape functions and coordinates.
#[derive(Debug, Clone)]
pub struct CellIntegrals {
    /// `int Ni,y Nj,y` \[-\]
    yy: PairIntegrals,
    /// `int Ni,y Nj,z` \[-\]
    yz: PairIntegrals,
    /// `int Ni,z Nj,z` \[-\]
    zz: PairIntegrals,
    /// `int Ni,y (1, y, z)` \[m, m^2, m^2\]
    dy: [Moments; 9],
    /// `int Ni,z (1, y, z)` \[m, m^2, m^2\]
    dz: [Moments; 9],
    /// `int (1, y, z, y y, y z, z z)` \[m^2 .. m^4\]
    area: [f64; 6],
}

impl CellIntegrals {
    /// `int (1, y, z, y y, y z, z z)` \[m^2 .. m^4\].
    pub fn area(&self) -> &[f64; 6] {
        &self.area
    }

    /// Integrates over the cell with `nodes` (y, z).
    ///
    /// # Errors
    /// The first area of an integration point that is not positive \[m^2\]: the
    /// cell is inverted or has no area.
    #[inline(always)]
    pub fn new(kind: CellKind, nodes: &[[f64; 2]]) -> Result<Self, f64> {
        let mut integrals = Self {
            yy: [[0.0; 9]; 9],
            yz: [[0.0; 9]; 9],
            zz: [[0.0; 9]; 9],
            dy: [[0.0; 3]; 9],
            dz: [[0.0; 3]; 9],
            area: [0.0; 6],
        };
        for point in rule_points(kind) {
            let point = point.of_cell(nodes);
            let positive = point.area > 0.0;
            if !positive {
                return Err(point.area);
            }
            integrals.add(&point);
        }
        Ok(integrals)
    }

    #[inline(always)]
    fn add(&mut self, p: &CellPoint) {
        for i in 0..p.count {
            let (dy, dz) = (p.area * p.dy[i], p.area * p.dz[i]);
            for j in 0..p.count {
                self.yy[i][j] += dy * p.dy[j];
                self.yz[i][j] += dy * p.dz[j];
                self.zz[i][j] += dz * p.dz[j];
            }
            for (sums, f) in [(&mut self.dy, dy), (&mut self.dz, dz)] {
                sums[i][0] += f;
                sums[i][1] += f * p.y;
                sums[i][2] += f * p.z;
            }
        }
        let products = [1.0, p.y, p.z, p.y * p.y, p.y * p.z, p.z * p.z];
        for (sum, product) in self.area.iter_mut().zip(products) {
            *sum += p.area * product;
        }
    }
}

/// The blocks of one cell: integrals and law together.
#[derive(Debug, Clone, Copy)]
pub struct CellBlocks<'a, const C: usize> {
    /// Integrals over the cell.
    pub integrals: &'a CellIntegrals,
    /// Parts of its law.
    pub law: &'a LawBlocks<C>,
}

impl<const C: usize> CellBlocks<'_, C> {
    /// `E_ij = int Ni,y Nj,y Py'DPy + int Ni,z Nj,z Pz'DPz
    ///       + int Ni,y Nj,z Py'DPz + int Ni,z Nj,y Pz'DPy`.
    #[inline(always)]
    pub fn e(&self, i: usize, j: usize) -> SMatrix<f64, C, C> {
        let (integrals, law) = (self.integrals, self.law);
        let normal = integrals.yy[i][j] * law.yy + integrals.zz[i][j] * law.zz;
        let mixed = integrals.yz[i][j] * law.yz + integrals.yz[j][i] * law.yz.transpose();
        normal + mixed
    }

    /// `R_i = Py'DS int Ni,y [I, -t x] + Pz'DS int Ni,z [I, -t x]`.
    #[inline(always)]
    pub fn r(&self, i: usize) -> SMatrix<f64, C, 6> {
        self.law.ys * rigid(&self.integrals.dy[i]) + self.law.zs * rigid(&self.integrals.dz[i])
    }
}

/// `A = int [I, -t x]' S'DS [I, -t x]` of all cells of one law, from the sums of
/// their `int (1, y, z, y y, y z, z z)`.
///
/// `[I, -t x] = G1 + y Gy + z Gz` with constant parts, so A is a sum over the six
/// moments.
fn a_of_moments(area: &[f64; 6], ss: &Matrix3<f64>) -> Matrix6<f64> {
    let parts = [
        rigid_displacement(1.0, 0.0, 0.0),
        rigid_displacement(0.0, 1.0, 0.0),
        rigid_displacement(0.0, 0.0, 1.0),
    ];
    // (1, y, z) (1, y, z)' in terms of 1 y z yy yz zz
    const MOMENT: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
    let mut a = Matrix6::zeros();
    for (p, left) in parts.iter().enumerate() {
        for (q, right) in parts.iter().enumerate() {
            a += area[MOMENT[p][q]] * (left.transpose() * ss * right);
        }
    }
    a
}

/// `int f [I, -t x]` from the sums of f, f y, f z.
pub(super) fn rigid(moments: &Moments) -> Matrix3x6<f64> {
    rigid_displacement(moments[0], moments[1], moments[2])
}

#[cfg(test)]
#[path = "blocks_tests.rs"]
mod tests;
