//! The matrices of a section over its warping unknowns.
//!
//! ```text
//! dLi' = [du'; du; dpsi]' [ M  C  L ; C' E  R ; L' R' A ] [u'; u; psi]     (S-10)
//! ```
//!
//! | symbol | shape | symmetric | joins |
//! | --- | --- | --- | --- |
//! | E | n x n | yes, not negative | u and u |
//! | R | n x 6 | | u and psi |
//! | A | 6 x 6 | yes | psi and psi |
//!
//! These three form the system that is factored. For a solution that varies along the beam
//! as `exp(lambda x)`, `B0 + lambda B1` replaces B0, and the system is Hermitian for an
//! imaginary lambda (S-73). Products with all six, M, C and L included, are integrals of
//! stresses and need no matrix: see [`super::section_forces`].
//!
//! # References
//! - Giavotto et al. 1983: the same matrices, from the internal work per length.
//! - Masarati 1999, section 5.3.4 and appendix E.2.

use super::cell::DomainCell;
use super::domain::Domain;
use super::electric::Electric;
use super::pattern::Pattern;
use crate::element::{CellBlocks, CellIntegrals, CurvedCell, LawBlocks, TurningLaw};
use crate::failure::Failure;
use nalgebra::{ComplexField, DMatrix, Matrix6, SMatrix};
use pulp::{Arch, Simd, WithSimd};
use sprs::CsMatI;

/// A number of a section matrix: real, or complex with real parts of double precision.
pub trait Scalar: ComplexField<RealField = f64> + Copy {}

impl<T: ComplexField<RealField = f64> + Copy> Scalar for T {}

/// E, R, A in the units of the domain. Unknowns are ux, uy, uz node by node, then the
/// potentials; in E, where each potential follows the displacements of its node, they are
/// in the order `order`.
#[derive(Debug, Clone)]
pub struct SectionMatrices<T> {
    /// `int B0' D B0 J`: the lower triangle in compressed columns, the diagonal
    /// entry first in each, n x n \[-\].
    pub e: CsMatI<T, u32>,
    /// `int B0' D Bpsi J`, n x 6 \[-\].
    pub r: DMatrix<T>,
    /// `int Bpsi' D Bpsi J` \[-\].
    pub a: Matrix6<f64>,
    /// For each row of `e` its unknown; empty if they are the same.
    pub order: Vec<u32>,
}

impl SectionMatrices<f64> {
    /// Sums the blocks of all cells, of solutions that are steady along the beam.
    ///
    /// # Errors
    /// [`Failure::CellWithoutArea`] for an inverted or flat cell; [`Failure::OutOfMemory`]
    /// for more entries than 32 bits can count.
    pub fn assemble(domain: &Domain, pattern: &Pattern) -> Result<Self, Failure> {
        if domain.line.is_straight() {
            Arch::new().dispatch(StraightSum { domain, pattern })
        } else {
            Self::of_wave(domain, pattern, 0.0)
        }
    }
}

impl<T: Scalar> SectionMatrices<T> {
    /// Sums the blocks of all cells, of solutions that vary along the beam as
    /// `exp(lambda x)`: lambda is imaginary or zero, per unit of length of the domain.
    ///
    /// # Errors
    /// As [`SectionMatrices::assemble`].
    pub fn of_wave(domain: &Domain, pattern: &Pattern, lambda: T) -> Result<Self, Failure> {
        Arch::new().dispatch(CurvedSum {
            domain,
            pattern,
            lambda,
        })
    }

    /// Number of warping unknowns n.
    pub fn unknowns(&self) -> usize {
        self.r.nrows()
    }
}

/// E and R during the summation, and the moments of A, by law.
struct Sums<'a, T> {
    pattern: &'a Pattern,
    starts: Vec<u32>,
    rows: Vec<u32>,
    e: Vec<T>,
    r: DMatrix<T>,
    /// First row of the potentials in R.
    potentials: usize,
    moments: Vec<[f64; 6]>,
}

impl<'a, T: Scalar> Sums<'a, T> {
    fn none(domain: &Domain, pattern: &'a Pattern) -> Result<Self, Failure> {
        let unknowns = domain.unknowns();
        let structure = pattern.structure();
        let (starts, rows) = structure.ok_or(Failure::OutOfMemory { unknowns })?;
        Ok(Self {
            pattern,
            e: vec![T::zero(); rows.len()],
            r: DMatrix::zeros(unknowns, 6),
            potentials: 3 * domain.nodes.len(),
            moments: vec![[0.0; 6]; domain.laws.len()],
            starts,
            rows,
        })
    }

    /// Adds the blocks of a cell to the lower triangle of E and to R, and its moments to A.
    #[inline(always)]
    fn add<const C: usize>(
        &mut self,
        (electric, cell): (&Electric, &DomainCell),
        area: &[f64; 6],
        e: impl Fn(usize, usize) -> SMatrix<T, C, C>,
        r: impl Fn(usize) -> SMatrix<T, C, 6>,
    ) {
        for (j, &column) in cell.nodes().iter().enumerate() {
            for (i, &row) in cell.nodes().iter().enumerate() {
                if row < column {
                    continue;
                }
                let block = e(i, j);
                let indices = self.pattern.block(row, column);
                for (b, at) in indices.into_iter().enumerate().take(C) {
                    let first = if row == column { b } else { 0 };
                    for a in first..C {
                        self.e[at + a - first] += block[(a, b)];
                    }
                }
            }
        }
        for (i, &node) in cell.nodes().iter().enumerate() {
            let of_node = r(i);
            let mut rows = self.r.fixed_view_mut::<3, 6>(3 * node as usize, 0);
            rows += of_node.fixed_rows::<3>(0);
            if C == 4
                && let Some(potential) = electric.potential(node as usize)
            {
                let mut row = self.r.row_mut(self.potentials + potential);
                row += of_node.row(3);
            }
        }
        let sums = &mut self.moments[cell.law as usize];
        for (sum, moment) in sums.iter_mut().zip(area) {
            *sum += moment;
        }
    }

    fn matrices(self, laws: &[LawBlocks<3>]) -> SectionMatrices<T> {
        let of_laws = self.moments.iter().zip(laws);
        let a: Matrix6<f64> = of_laws.map(|(area, law)| law.a_of_moments(area)).sum();
        let n = self.r.nrows();
        SectionMatrices {
            e: CsMatI::new_csc((n, n), self.starts, self.rows, self.e),
            r: self.r,
            a: 0.5 * (a + a.transpose()),
            order: self.pattern.order().map_or_else(Vec::new, <[u32]>::to_vec),
        }
    }
}

/// The sum over the cells of a straight beam, compiled for each width of registers.
struct StraightSum<'a> {
    domain: &'a Domain,
    pattern: &'a Pattern,
}

impl WithSimd for StraightSum<'_> {
    type Output = Result<SectionMatrices<f64>, Failure>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        let Self { domain, pattern } = self;
        let laws: Vec<_> = domain.laws.iter().map(LawBlocks::new).collect();
        let coupled: Vec<_> = domain
            .electric
            .laws
            .iter()
            .map(LawBlocks::coupled)
            .collect();
        let mut sums = Sums::none(domain, pattern)?;
        for cell in &domain.cells {
            let positions = domain.positions(cell);
            let integrals = CellIntegrals::new(cell.kind, &positions[..cell.kind.node_count()])
                .map_err(|_| Failure::CellWithoutArea { tag: cell.tag })?;
            let (of, integrals) = ((&domain.electric, cell), &integrals);
            if let Some(law) = cell.coupled {
                let law = &coupled[law as usize];
                let blocks = CellBlocks { integrals, law };
                let (e, r) = (|i, j| blocks.e(i, j), |i| blocks.r(i));
                sums.add(of, integrals.area(), e, r);
            } else {
                let law = &laws[cell.law as usize];
                let blocks = CellBlocks { integrals, law };
                let (e, r) = (|i, j| blocks.e(i, j), |i| blocks.r(i));
                sums.add(of, integrals.area(), e, r);
            }
        }
        Ok(sums.matrices(&laws))
    }
}

/// The sum over the cells of a curved beam, compiled for each width of registers.
struct CurvedSum<'a, T> {
    domain: &'a Domain,
    pattern: &'a Pattern,
    lambda: T,
}

impl<T: Scalar> WithSimd for CurvedSum<'_, T> {
    type Output = Result<SectionMatrices<T>, Failure>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        let Self {
            domain,
            pattern,
            lambda,
        } = self;
        let (line, electric) = (&domain.line, &domain.electric);
        let turning = domain.laws.iter();
        let turning: Vec<_> = turning
            .map(|law| TurningLaw::new(line, lambda, law))
            .collect();
        let coupled = electric.laws.iter();
        let coupled: Vec<_> = coupled
            .map(|law| TurningLaw::coupled(line, lambda, law))
            .collect();
        let mut sums = Sums::none(domain, pattern)?;
        for cell in &domain.cells {
            let positions = domain.positions(cell);
            let integrals = CurvedCell::new(line, cell.kind, &positions[..cell.kind.node_count()])
                .map_err(|_| Failure::CellWithoutArea { tag: cell.tag })?;
            let of = (electric, cell);
            if let Some(law) = cell.coupled {
                let law = &coupled[law as usize];
                let (e, r) = (|i, j| integrals.e(law, i, j), |i| integrals.r(law, i));
                sums.add(of, integrals.area(), e, r);
            } else {
                let law = &turning[cell.law as usize];
                let (e, r) = (|i, j| integrals.e(law, i, j), |i| integrals.r(law, i));
                sums.add(of, integrals.area(), e, r);
            }
        }
        let laws: Vec<_> = domain.laws.iter().map(LawBlocks::new).collect();
        Ok(sums.matrices(&laws))
    }
}
