//! The matrices of a section over its warping unknowns.
//!
//! ```text
//! dLi' = [du'; du; dpsi]' [ M  C  L ; C' E  R ; L' R' A ] [u'; u; psi]
//! ```
//!
//! | symbol | shape | symmetric | joins |
//! | --- | --- | --- | --- |
//! | E | n x n | yes, not negative | u and u |
//! | R | n x 6 | | u and psi |
//! | A | 6 x 6 | yes | psi and psi |
//!
//! These three make the system that is factored. Products with all six, M, C and
//! L included, are integrals of stresses and need no matrix: see
//! [`super::section_forces`].
//!
//! # References
//! - Giavotto et al. 1983: the same matrices, from the internal work per length.
//! - Masarati 1999, section 5.3.4 and appendix E.2.

use super::domain::{Domain, DomainCell};
use super::pattern::Pattern;
use crate::element::{CellBlocks, CellIntegrals, LawBlocks, a_of_moments};
use crate::failure::Failure;
use nalgebra::{DMatrix, Matrix6};
use pulp::{Arch, Simd, WithSimd};
use sprs::CsMatI;

/// E, R, A in the units of the domain. Unknowns are ux, uy, uz node by node.
#[derive(Debug, Clone)]
pub struct SectionMatrices {
    /// `int B0' D B0`: the lower triangle in compressed columns, the diagonal
    /// entry first in each, n x n \[-\].
    pub e: CsMatI<f64, u32>,
    /// `int B0' D Bpsi`, n x 6 \[-\].
    pub r: DMatrix<f64>,
    /// `int Bpsi' D Bpsi` \[-\].
    pub a: Matrix6<f64>,
}

impl SectionMatrices {
    /// Sums the blocks of all cells.
    ///
    /// # Errors
    /// [`Failure::CellWithoutArea`] for an inverted or flat cell;
    /// [`Failure::OutOfMemory`] for more entries than 32 bits count.
    pub fn assemble(domain: &Domain, pattern: &Pattern) -> Result<Self, Failure> {
        Arch::new().dispatch(Summation { domain, pattern })
    }

    #[inline(always)]
    fn summed(domain: &Domain, pattern: &Pattern) -> Result<Self, Failure> {
        let unknowns = domain.unknowns();
        let structure = pattern.structure();
        let (starts, rows) = structure.ok_or(Failure::OutOfMemory { unknowns })?;
        let laws: Vec<LawBlocks> = domain.laws.iter().map(LawBlocks::new).collect();
        let mut e = vec![0.0; rows.len()];
        let mut r = DMatrix::zeros(unknowns, 6);
        let mut moments = vec![[0.0; 6]; laws.len()];
        for cell in &domain.cells {
            let places = domain.places(cell);
            let integrals = CellIntegrals::new(cell.kind, &places[..cell.kind.node_count()])
                .map_err(|_| Failure::CellWithoutArea { tag: cell.tag })?;
            let blocks = CellBlocks {
                integrals: &integrals,
                law: &laws[cell.law as usize],
            };
            add_e(&mut e, pattern, cell, &blocks);
            add_r(&mut r, cell, &blocks);
            let sums = &mut moments[cell.law as usize];
            for (sum, moment) in sums.iter_mut().zip(integrals.area()) {
                *sum += moment;
            }
        }
        let of_laws = moments.iter().zip(&laws);
        let a: Matrix6<f64> = of_laws.map(|(area, law)| a_of_moments(area, law)).sum();
        Ok(Self {
            e: CsMatI::new_csc((unknowns, unknowns), starts, rows, e),
            r,
            a: 0.5 * (a + a.transpose()),
        })
    }

    /// Number of warping unknowns n.
    pub fn unknowns(&self) -> usize {
        self.r.nrows()
    }
}

/// The sum over the cells, compiled for each width of registers.
struct Summation<'a> {
    domain: &'a Domain,
    pattern: &'a Pattern,
}

impl WithSimd for Summation<'_> {
    type Output = Result<SectionMatrices, Failure>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        SectionMatrices::summed(self.domain, self.pattern)
    }
}

/// Adds the blocks of the lower triangle.
#[inline(always)]
fn add_e(e: &mut [f64], pattern: &Pattern, cell: &DomainCell, blocks: &CellBlocks<'_>) {
    for (j, &column) in cell.nodes().iter().enumerate() {
        for (i, &row) in cell.nodes().iter().enumerate() {
            if row < column {
                continue;
            }
            let block = blocks.e(i, j);
            for (b, at) in pattern.block(row, column).into_iter().enumerate() {
                let first = if row == column { b } else { 0 };
                for a in first..3 {
                    e[at + a - first] += block[(a, b)];
                }
            }
        }
    }
}

#[inline(always)]
fn add_r(r: &mut DMatrix<f64>, cell: &DomainCell, blocks: &CellBlocks<'_>) {
    for (i, &node) in cell.nodes().iter().enumerate() {
        let mut rows = r.fixed_view_mut::<3, 6>(3 * node as usize, 0);
        rows += blocks.r(i);
    }
}
