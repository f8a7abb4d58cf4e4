//! A section that is given by its matrices instead of by cells and materials: blocks
//! from another program, or the stiffness of a slice of the beam.
//!
//! # References
//! - [Masarati], appendix E.3: section matrices from other finite-element codes.

use nalgebra::{DMatrix, Matrix6};
use shared_geom::section::InitialCurvature;
use sprs::CsMat;

/// A section given by its matrices.
#[derive(Debug, Clone)]
pub struct ExternalSection {
    /// Name for reports.
    pub name: String,
    /// Numbers of the nodes in the program that made the matrices.
    pub tags: Vec<u64>,
    /// Positions (y, z) of the nodes in section axes \[m\].
    pub nodes: Vec<[f64; 2]>,
    /// M, C, E.
    pub blocks: Blocks,
    /// The slice from which they were computed.
    pub slice: Option<Slice>,
    /// L, R, A, if given too.
    pub reduced: Reduced,
    /// Mass per length about the reference point, order of
    /// [`shared_geom::wrench::COMPONENTS`]; zeros if not known \[kg/m, kg, kg m\].
    pub mass: Matrix6<f64>,
    /// The line of the beam for which the matrices were made.
    pub initial_curvature: InitialCurvature,
    /// Number of end effects to find.
    pub end_effects: Option<usize>,
}

/// A slice of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slice {
    /// Its thickness h \[m\].
    pub thickness: f64,
    /// Variation of displacements through it.
    pub through: Through,
}

/// M, C, E of a section over ux, uy, uz of its nodes, node by node, n x n.
#[derive(Debug, Clone)]
pub struct Blocks {
    /// `int B1' D B1`, symmetric \[N\].
    pub m: CsMat<f64>,
    /// `int B1' D B0`: rows belong to u', columns to u \[N/m\].
    pub c: CsMat<f64>,
    /// `int B0' D B0`, symmetric \[N/m^2\].
    pub e: CsMat<f64>,
}

/// L, R, A as given by another program; they follow from M, C, E, and are compared.
#[derive(Debug, Clone, Default)]
pub struct Reduced {
    /// `int B1' D Bpsi`, n x 6 \[N, N m\].
    pub l: Option<DMatrix<f64>>,
    /// `int B0' D Bpsi`, n x 6 \[N/m, N\].
    pub r: Option<DMatrix<f64>>,
    /// `int Bpsi' D Bpsi`, 6 x 6 \[N, N m, N m^2\].
    pub a: Option<Matrix6<f64>>,
}

/// Variation of displacements through the thickness of a slice.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Through {
    /// Linear between the two faces, all strains integrated: the slice is one layer of
    /// linear elements. M of the slice then also contains `h^2/12 E`, which is
    /// subtracted.
    Linear,
    /// The mean of the two faces: strains are evaluated in the middle of the slice.
    Middle,
}

impl Blocks {
    /// M, C, E from the stiffness of a slice of thickness h, whose two faces have the
    /// same nodes: with `u1 = u - h/2 u'`, `u2 = u + h/2 u'`,
    ///
    /// ```text
    /// K = [K11 K12; K21 K22]
    /// E = (K11 + K12 + K21 + K22)/h
    /// C = (-K11 - K12 + K21 + K22)/2
    /// M = (K11 - K12 - K21 + K22) h/4  - h^2/12 E                         (S-132)
    /// ```
    ///
    /// the last term if displacements are linear through the slice.
    pub fn of_slice(stiffness: &CsMat<f64>, slice: Slice) -> Self {
        let Slice { thickness, through } = slice;
        let n = stiffness.rows() / 2;
        let faces = |i: usize| if i < n { (i, -1.0) } else { (i - n, 1.0) };
        let sum = |weight: &dyn Fn(f64, f64) -> f64| {
            let mut block = sprs::TriMat::new((n, n));
            for (&value, (i, j)) in stiffness {
                let ((row, first), (column, second)) = (faces(i), faces(j));
                block.add_triplet(row, column, weight(first, second) * value);
            }
            block.to_csr()
        };
        let h = thickness;
        let rest = match through {
            Through::Linear => h / 12.0,
            Through::Middle => 0.0,
        };
        Self {
            e: sum(&|_, _| 1.0 / h),
            c: sum(&|first, _| 0.5 * first),
            m: sum(&|first, second| 0.25 * h * first * second - rest),
        }
    }
}
