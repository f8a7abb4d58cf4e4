//! A section given by its matrices M, C, E instead of by cells and laws.
//!
//! The other three follow from the rigid motions, (S-15):
//!
//! ```text
//! L = M H      R = C^T H      A = L^T H                                           (S-130)
//! ```
//!
//! and the remaining identities show whether the three are consistent: `C H = L T`,
//! `E H = R T`, `R^T H = A T`. Products with the matrices replace the integrals of
//! stresses.
//!
//! # References
//! - [Masarati], appendix E.3: section matrices from other finite-element codes.

use super::forces::{Rate, SectionForces, State};
use super::matrices::{Scalar, SectionMatrices};
use super::model::Model;
use super::pattern::Pattern;
use super::rigid::{add_rigid_motions, resultant};
use super::scaling::{Scaling, largest};
use crate::element::Line;
use crate::failure::Failure;
use crate::section::{Blocks, Reduced};
use nalgebra::{Complex, DMatrix, Matrix6, Vector3, Vector6};
use shared_geom::wrench;
use sprs::{CsMat, CsMatI};

/// A section of given matrices in the units of the solver.
#[derive(Debug, Clone)]
pub struct ExternalDomain {
    nodes: Vec<[f64; 2]>,
    line: Line,
    scaling: Scaling,
    m: CsMat<f64>,
    c: CsMat<f64>,
    ct: CsMat<f64>,
    e: CsMat<f64>,
    l: DMatrix<f64>,
    r: DMatrix<f64>,
    a: Matrix6<f64>,
}

/// The identities between given matrices, as [`ExternalDomain::identities`] orders them.
pub const EXTERNAL_IDENTITIES: [&str; 5] =
    ["M = M'", "E = E'", "C H = L T", "E H = R T", "R' H = A T"];

impl ExternalDomain {
    /// The section with `nodes` (y, z) in `scaling`, and `blocks` in SI, both in the
    /// order in which unknowns are eliminated.
    pub fn new(nodes: Vec<[f64; 2]>, line: Line, scaling: Scaling, blocks: &Blocks) -> Self {
        let Scaling {
            length, modulus, ..
        } = scaling;
        let scaled = |matrix: &CsMat<f64>, unit: f64| matrix.map(|value| value / unit).to_csr();
        let c = scaled(&blocks.c, modulus * length);
        let mut domain = Self {
            m: scaled(&blocks.m, modulus * length * length),
            e: scaled(&blocks.e, modulus),
            ct: c.transpose_view().to_csr(),
            c,
            l: DMatrix::zeros(0, 6),
            r: DMatrix::zeros(0, 6),
            a: Matrix6::zeros(),
            nodes,
            line,
            scaling,
        };
        let h = domain.rigid_motions();
        domain.l = product(&domain.m, &h);
        domain.r = product(&domain.ct, &h);
        let a = resultant(&domain, &domain.l);
        domain.a = 0.5 * (a + a.transpose());
        domain
    }

    /// The units.
    pub fn scaling(&self) -> &Scaling {
        &self.scaling
    }

    /// H: a column per rigid motion, n x 6.
    fn rigid_motions(&self) -> DMatrix<f64> {
        let mut motions = DMatrix::zeros(self.unknowns(), 6);
        add_rigid_motions(self, &Matrix6::identity(), &mut motions);
        motions
    }

    /// `M + tolerance diag(M) - less E` in the structure of `pattern`: whether M is
    /// positive semidefinite to `tolerance`, without the part `less` of E.
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`] for more entries than 32 bits count.
    pub fn face_matrix(
        &self,
        pattern: &Pattern,
        tolerance: f64,
        less: f64,
    ) -> Result<CsMatI<f64, u32>, Failure> {
        let unknowns = self.unknowns();
        let structure = pattern.structure();
        let (starts, rows) = structure.ok_or(Failure::OutOfMemory { unknowns })?;
        let mut entries = vec![0.0; rows.len()];
        for (matrix, factor) in [(&self.m, 1.0), (&self.e, -less)] {
            for (&value, (i, j)) in matrix {
                // the mean of both triangles
                let part = if i == j { 1.0 } else { 0.5 };
                entries[pattern.entry(i.max(j), i.min(j))] += part * factor * value;
            }
        }
        for (&value, (i, j)) in &self.m {
            if i == j {
                entries[pattern.entry(i, i)] += tolerance * value;
            }
        }
        Ok(CsMatI::new_csc((unknowns, unknowns), starts, rows, entries))
    }

    /// Error of each of the [`EXTERNAL_IDENTITIES`], relative to the largest sum of
    /// absolute terms of its products.
    pub fn identities(&self) -> [f64; 5] {
        let h = self.rigid_motions();
        let t = self.line.equilibrium().transpose();
        let asymmetry = |matrix: &CsMat<f64>| {
            let transposed = matrix.transpose_view().to_csr();
            let difference = matrix - &transposed;
            let of = |matrix: &CsMat<f64>| matrix.data().iter().map(|v| v.abs()).fold(0.0, largest);
            of(&difference) / of(matrix)
        };
        let of_c = product(&self.c, &h) - &self.l * t;
        let of_e = product(&self.e, &h) - &self.r * t;
        let of_r = resultant(self, &self.r) - (self.a * t).transpose();
        [
            asymmetry(&self.m),
            asymmetry(&self.e),
            of_c.amax() / terms(&self.c, &h),
            of_e.amax() / terms(&self.e, &h),
            of_r.amax() / (self.a.amax() * t.amax()),
        ]
    }

    /// Differences of the given L, R, A, in SI about the reference point and in the order
    /// of the nodes before `order`, from the L, R, A of M and C, relative to their largest
    /// entry; each with the identity that it violates.
    pub fn compared(&self, given: &Reduced, order: &[u32]) -> Vec<(&'static str, f64)> {
        let Scaling {
            origin: [y, z],
            length,
            modulus,
            ..
        } = self.scaling;
        // from motions about the reference point to motions about the origin: H_O = H_c
        // U(-t)'
        let shift = wrench::shift_matrix(&Vector3::new(0.0, -y, -z)).transpose();
        let unit = Vector6::new(1.0, 1.0, 1.0, length, length, length);
        let to_reference = Matrix6::from_diagonal(&unit) * shift;
        let rows = |field: &DMatrix<f64>| {
            let mut ordered = DMatrix::zeros(field.nrows(), 6);
            for (node, &old) in order.iter().enumerate() {
                let at_node = field.fixed_view::<3, 6>(3 * old as usize, 0);
                ordered
                    .fixed_view_mut::<3, 6>(3 * node, 0)
                    .copy_from(&at_node);
            }
            ordered
        };
        let off = |found: DMatrix<f64>, own: DMatrix<f64>| (found - &own).amax() / own.amax();
        let field = |given: &Option<DMatrix<f64>>, own: &DMatrix<f64>, unit: f64| {
            let given = given.as_ref()?;
            Some(off(rows(given), times(own, &to_reference) * unit))
        };
        let stress = modulus * length;
        let a = given.a.as_ref().map(|given| {
            let own = to_reference.transpose() * self.a * to_reference * (stress * length);
            (given - own).amax() / own.amax()
        });
        let compared = [
            ("M H = L", field(&given.l, &self.l, stress * length)),
            ("C' H = R", field(&given.r, &self.r, stress)),
            ("L' H = A", a),
        ];
        let known = compared
            .into_iter()
            .filter_map(|(name, error)| Some((name, error?)));
        known.collect()
    }

    /// E and R of solutions that vary along the beam as `exp(lambda x)`, in the
    /// structure of `pattern`:
    ///
    /// ```text
    /// E - lambda (C - C^T) - lambda^2 M      R - lambda L                        (S-131)
    /// ```
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`] for more entries than 32 bits count.
    pub fn system<T: Scalar>(
        &self,
        pattern: &Pattern,
        lambda: T,
    ) -> Result<SectionMatrices<T>, Failure> {
        let unknowns = self.unknowns();
        let structure = pattern.structure();
        let (starts, rows) = structure.ok_or(Failure::OutOfMemory { unknowns })?;
        let mut e = vec![T::zero(); rows.len()];
        let mut add = |matrix: &CsMat<f64>, factor: T| {
            for (&value, (i, j)) in matrix {
                if i >= j {
                    e[pattern.entry(i, j)] += factor.scale(value);
                }
            }
        };
        // half of each triangle: removes the remaining asymmetry
        let half = T::from_real(0.5);
        add(&self.e, half);
        add(&self.e.transpose_view().to_csr(), half);
        if lambda != T::zero() {
            add(&self.c, -lambda);
            add(&self.ct, lambda);
            add(&self.m, -(lambda * lambda));
        }
        let (l, r) = (self.l.map(T::from_real), self.r.map(T::from_real));
        Ok(SectionMatrices {
            e: CsMatI::new_csc((unknowns, unknowns), starts, rows, e),
            r: r - l * lambda,
            a: self.a,
            order: Vec::new(),
        })
    }
}

impl Model for ExternalDomain {
    fn nodes(&self) -> &[[f64; 2]] {
        &self.nodes
    }

    fn line(&self) -> &Line {
        &self.line
    }

    fn measure(&self, state: State<'_>, forces: &mut SectionForces) {
        let n = self.unknowns();
        let six = |field: &DMatrix<f64>| {
            let columns = field.ncols().min(6);
            let mut six = DMatrix::zeros(n, 6);
            six.columns_mut(0, columns)
                .copy_from(&field.columns(0, columns));
            six
        };
        let u = state.warping.map_or_else(|| DMatrix::zeros(n, 6), six);
        let rate = match state.rate {
            Rate::Zero => None,
            Rate::Given(rate) => Some(six(rate)),
            Rate::Central => Some(times(&u, &self.line.equilibrium())),
        };
        let psi = state.strain;
        forces.face = product(&self.c, &u) + times(&self.l, psi);
        forces.within = product(&self.e, &u) + times(&self.r, psi);
        let mut theta = self.r.tr_mul(&u) + self.a * psi;
        if let Some(rate) = &rate {
            forces.face += product(&self.m, rate);
            forces.within += product(&self.ct, rate);
            theta += self.l.tr_mul(rate);
        }
        let theta: Matrix6<f64> = theta.fixed_view::<6, 6>(0, 0).into();
        let mut work = u.tr_mul(&forces.within) + psi.transpose() * theta;
        if let Some(rate) = &rate {
            work += rate.tr_mul(&forces.face);
        }
        let work: Matrix6<f64> = work.fixed_view::<6, 6>(0, 0).into();
        forces.work = 0.5 * (work + work.transpose());
        forces.resultant = theta;
    }

    fn wave(
        &self,
        pattern: &Pattern,
        lambda: Complex<f64>,
    ) -> Result<SectionMatrices<Complex<f64>>, Failure> {
        self.system(pattern, lambda)
    }
}

/// Six columns times a small matrix.
fn times(x: &DMatrix<f64>, by: &Matrix6<f64>) -> DMatrix<f64> {
    let mut result = DMatrix::zeros(x.nrows(), 6);
    result.gemm(1.0, x, by, 0.0);
    result
}

/// A sparse matrix by rows times columns.
fn product(matrix: &CsMat<f64>, x: &DMatrix<f64>) -> DMatrix<f64> {
    let mut result = DMatrix::zeros(matrix.rows(), x.ncols());
    for (i, row) in matrix.outer_iterator().enumerate() {
        for (j, &value) in row.iter() {
            for k in 0..x.ncols() {
                result[(i, k)] += value * x[(j, k)];
            }
        }
    }
    result
}

/// The largest sum of absolute terms in [`product`].
fn terms(matrix: &CsMat<f64>, x: &DMatrix<f64>) -> f64 {
    let absolute = matrix.map(|value| value.abs());
    product(&absolute, &x.map(f64::abs)).amax()
}
