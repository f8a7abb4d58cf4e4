//! Strain and stress of a cell in six cases at once, as plain arrays, so that the compiler
//! uses the widest registers of the machine.
//!
//! ```text
//! eps = B1 u' + B0 u + Bpsi psi            sigma = D eps
//! ```
//!
//! The operators are (S-5) for a straight beam, and (S-73) for a curved one.
//!
//! Derivatives are taken of the differences from the first node, which is the same in exact
//! arithmetic (the derivatives of the shape functions add up to zero) and loses no digits
//! when the displacement of the cell is much larger than its strain, as in walls of thin
//! sections.
//!
//! # References
//! - Giavotto et al. 1983, section 2: the strain of a straight section.

use super::line::{Line, Metric};
use super::point::CellPoint;
use super::strain::FACE_STRAINS;
use nalgebra::Matrix6;
use pulp::{Arch, Simd, WithSimd};

/// Index of the first of the strains of the face, which are consecutive.
pub const FACE: usize = FACE_STRAINS[0];

/// Number of cases: six, and two unused ones that fill whole registers.
pub const CASES: usize = 8;

/// A number for each case.
pub type Row = [f64; CASES];

/// Rounding of `a b + c`: machines with a fused instruction round once.
pub trait Product {
    /// `a b + c`.
    fn add(a: f64, b: f64, c: f64) -> f64;
}

/// Rounded once.
#[derive(Debug, Clone, Copy)]
pub struct Fused;

/// Rounded twice.
#[derive(Debug, Clone, Copy)]
pub struct Plain;

impl Product for Fused {
    #[inline(always)]
    fn add(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}

impl Product for Plain {
    #[inline(always)]
    fn add(a: f64, b: f64, c: f64) -> f64 {
        a * b + c
    }
}

/// Six rows of zeros: no strain, no stress, no work.
pub const NO_ROWS: [Row; 6] = [[0.0; CASES]; 6];

/// A loop over cells that is compiled for each width of registers.
pub trait CaseLoop {
    /// Result of the loop.
    type Output;

    /// The loop; to be inlined into the code of each width.
    fn run<P: Product>(self) -> Self::Output;
}

/// Runs `work` with the widest registers of the machine.
pub fn in_widest_registers<W: CaseLoop>(work: W) -> W::Output {
    Arch::new().dispatch(Widest(work))
}

struct Widest<W>(W);

impl<W: CaseLoop> WithSimd for Widest<W> {
    type Output = W::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> W::Output {
        // machines with registers of four or more numbers have fused products, as ARM does
        if size_of::<S::f64s>() >= 32 || cfg!(target_arch = "aarch64") {
            self.0.run::<Fused>()
        } else {
            self.0.run::<Plain>()
        }
    }
}

/// A field at the nodes of a cell, `[node][component][case]`; entries after its node count
/// are not read.
pub type CellField = [[Row; 3]; 9];

/// No displacement at any node.
pub const NO_FIELD: CellField = [[[0.0; CASES]; 3]; 9];

/// Warping of a cell and its rate in six cases.
#[derive(Debug, Clone, Copy)]
pub struct CellState {
    /// u': rate of the warping along the beam.
    pub rate: CellField,
    /// u: warping.
    pub warping: CellField,
}

impl CellState {
    /// No displacement at any node.
    pub const NONE: Self = Self {
        rate: NO_FIELD,
        warping: NO_FIELD,
    };

    /// The warping minus the warping of the first node.
    #[inline(always)]
    pub fn differences(&self) -> CellField {
        let mut difference = self.warping;
        for node in (0..9).rev() {
            for axis in 0..3 {
                for k in 0..CASES {
                    difference[node][axis][k] -= self.warping[0][axis][k];
                }
            }
        }
        difference
    }
}

/// The matrix of six cases.
pub fn matrix_of(rows: &[Row; 6]) -> Matrix6<f64> {
    Matrix6::from_fn(|i, k| rows[i][k])
}

/// Rows of a matrix, a case for each column.
pub fn rows_of(matrix: &Matrix6<f64>) -> [Row; 6] {
    let entry = |i, k| if k < 6 { matrix[(i, k)] } else { 0.0 };
    std::array::from_fn(|i| std::array::from_fn(|k| entry(i, k)))
}

/// `eps = S N u' + Dop N u + Bpsi psi` of a straight beam, order yz yy zz xx xy xz; u by
/// its differences from the first node.
#[inline(always)]
pub fn strain_in_cases<P: Product>(
    point: &CellPoint,
    rate: &CellField,
    difference: &CellField,
    psi: &[Row; 6],
) -> [Row; 6] {
    let (y, z) = (point.y, point.z);
    let [mut yz, mut yy, mut zz, mut xx, mut xy, mut xz] = [[0.0; CASES]; 6];
    for k in 0..CASES {
        xx[k] = psi[0][k] + z * psi[4][k] - y * psi[5][k];
        xy[k] = psi[1][k] - z * psi[3][k];
        xz[k] = psi[2][k] + y * psi[3][k];
    }
    for node in 0..point.count {
        let (n, dy, dz) = (point.n[node], point.dy[node], point.dz[node]);
        let ([ux, uy, uz], [rx, ry, rz]) = (&difference[node], &rate[node]);
        for k in 0..CASES {
            xx[k] = P::add(n, rx[k], xx[k]);
            xy[k] = P::add(n, ry[k], P::add(dy, ux[k], xy[k]));
            xz[k] = P::add(n, rz[k], P::add(dz, ux[k], xz[k]));
            yy[k] = P::add(dy, uy[k], yy[k]);
            zz[k] = P::add(dz, uz[k], zz[k]);
            yz[k] = P::add(dz, uy[k], P::add(dy, uz[k], yz[k]));
        }
    }
    [yz, yy, zz, xx, xy, xz]
}

/// Strain as [`strain_in_cases`], (S-73) with the metric at the point of a beam along
/// `line`; `difference` is the warping minus the warping of the first node.
#[inline(always)]
pub fn strain_along<P: Product>(
    (line, metric): (&Line, &Metric),
    point: &CellPoint,
    state: &CellState,
    difference: &CellField,
    psi: &[Row; 6],
) -> [Row; 6] {
    let turn = line.curvature.as_ref();
    let mut strain = strain_in_cases::<P>(point, &state.rate, &NO_FIELD, psi);
    let gradients = along_section::<P>(point, difference);
    let position = at_point::<P>(point, &state.warping);
    for k in 0..CASES {
        let turned = cross(turn, &position, k);
        for axis in 0..3 {
            let slid =
                metric.tilt[0] * gradients[0][axis][k] + metric.tilt[1] * gradients[1][axis][k];
            let face = &mut strain[FACE + axis][k];
            *face = (*face + turned[axis] - slid) / metric.volume;
        }
        let [[xy, yy, zy], [xz, yz, zz]] = gradients.map(|of| of.map(|row| row[k]));
        for (row, part) in [(0, zy + yz), (1, yy), (2, zz), (4, xy), (5, xz)] {
            strain[row][k] += part;
        }
    }
    strain
}

/// A field at a point, from its values at the nodes of the cell.
#[inline(always)]
fn at_point<P: Product>(point: &CellPoint, field: &CellField) -> [Row; 3] {
    let mut sum = [[0.0; CASES]; 3];
    for node in 0..point.count {
        for (sum, value) in sum.iter_mut().zip(&field[node]) {
            for k in 0..CASES {
                sum[k] = P::add(point.n[node], value[k], sum[k]);
            }
        }
    }
    sum
}

/// Derivatives of a field along y and along z at a point, `[y or z][component][case]`.
#[inline(always)]
fn along_section<P: Product>(point: &CellPoint, field: &CellField) -> [[Row; 3]; 2] {
    let mut sums = [[[0.0; CASES]; 3]; 2];
    for node in 0..point.count {
        for (sums, d) in sums.iter_mut().zip([point.dy[node], point.dz[node]]) {
            for (sum, value) in sums.iter_mut().zip(&field[node]) {
                for k in 0..CASES {
                    sum[k] = P::add(d, value[k], sum[k]);
                }
            }
        }
    }
    sums
}

/// `a x v` of case `k`.
#[inline(always)]
pub fn cross(a: &[f64; 3], [x, y, z]: &[Row; 3], k: usize) -> [f64; 3] {
    [
        a[1] * z[k] - a[2] * y[k],
        a[2] * x[k] - a[0] * z[k],
        a[0] * y[k] - a[1] * x[k],
    ]
}

/// `D eps`, times the area of the point.
#[inline(always)]
pub fn stress_in_cases<P: Product>(law: &[[f64; 6]; 6], strain: &[Row; 6], area: f64) -> [Row; 6] {
    let mut stress = [[0.0; CASES]; 6];
    for (stress, law) in stress.iter_mut().zip(law) {
        for (strain, entry) in strain.iter().zip(law) {
            let entry = area * entry;
            for k in 0..CASES {
                stress[k] = P::add(entry, strain[k], stress[k]);
            }
        }
    }
    stress
}

/// Adds the work of the stresses of each case (columns) on the strains of the first N
/// (rows).
#[inline(always)]
pub fn add_work<P: Product, const N: usize, const R: usize>(
    work: &mut [Row; N],
    strain: &[Row; R],
    stress: &[Row; R],
) {
    // row by row in copies, which for the compiler do not alias
    for (i, work) in work.iter_mut().enumerate() {
        let mut row = *work;
        for (strain, stress) in strain.iter().zip(stress) {
            for k in 0..CASES {
                row[k] = P::add(strain[i], stress[k], row[k]);
            }
        }
        *work = row;
    }
}
