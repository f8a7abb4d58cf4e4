//! First-order effect of the internal forces on the stiffness (trapeze, Wagner).
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `p` | generalized strain of axial, torsion, bending y, z; shear forces are zero | -, 1/m | 4 |
//! | `C4`, `K4` | compliance of these four, and its inverse | | 4x4 |
//! | `H_i` | displacement gradient per unit p_i, see [`PointGradient`] | -, m | 3x3 |
//! | `sigma_i` | stress per unit p_i | Pa, N/m | 6 |
//! | `T` | third derivatives of the energy | N, N m, .. | 4x4x4 |
//!
//! The energy per length of a uniform state is least over the warping, so that its
//! cubic part needs no more than the warping of the linear solution:
//!
//! ```text
//! psi = Y P K4 p      u = X P K4 p      u' = 0 for these four              (S-83)
//! S_ijk = int sigma_i . eps2(H_j, H_k) dA
//! T_ijk = S_ijk + S_ikj + S_jik + S_jki + S_kij + S_kji                    (S-84)
//! ```
//!
//! The axes of the section are those of the linear solution; its reference point moves
//! with the mean of the warping over the area, `int w dA = 0`.
//!
//! All of it is done about the area centroid, where no digits are lost, and the table
//! is moved to the reference point.
//!
//! What comes of it in axes along the tangent of the reference line is (S-87); closed
//! forms of isotropic sections are (S-88), and (S-89) the gain of a strip.
//!
//! # References
//! - [HouboltBrooks1958]: tension stiffens torsion by N Ip/A.
//! - [Wagner1936]: torsion of open sections under compression and bending.
//! - [PopescuHodges1999]: trapeze effect of composite strips from the second-order strain.

use std::fmt;

use nalgebra::{DMatrix, Matrix4, Matrix6, Matrix6x4, SMatrix, Vector2, Vector3, Vector4, Vector6};
use shared_geom::section::{CubicTable, PRESTRESS_COMPONENTS, Prestress, StrainMeasure};
use shared_geom::wrench;

use crate::element::{CellPoint, PointGradient, cell_points};
use crate::material::section_stiffness;
use crate::section::Section;

/// Why a section has no table of prestress.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoPrestress {
    /// The undeformed beam is curved or twisted.
    Curved,
    /// The compliance of the section has no inverse.
    Singular,
}

impl fmt::Display for NoPrestress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Curved => {
                "the effect of prestress is known for straight beams only, and this one has an \
                 initial curvature"
            }
            Self::Singular => "the compliance of the section has no inverse",
        })
    }
}

/// The table of `section` about its reference point, from its central solutions:
/// `warping` (rows ux, uy, uz of each node) and `strain` per unit internal force, as
/// [`crate::solution::SectionSolution`] holds them.
///
/// # Errors
/// [`NoPrestress`] for a curved beam.
pub fn prestress(
    section: &Section,
    warping: &DMatrix<f64>,
    strain: &Matrix6<f64>,
    strain_measure: StrainMeasure,
) -> Result<Prestress, NoPrestress> {
    if !section.initial_curvature.is_straight() {
        return Err(NoPrestress::Curved);
    }
    let fields = Fields::new(section, warping, strain).ok_or(NoPrestress::Singular)?;
    let third = fields.table(strain_measure);
    Ok(Prestress {
        strain_measure,
        third: third.shifted(-Vector2::from(fields.center)),
    })
}

/// The four uniform states of a section, about its area centroid.
struct Fields<'a> {
    section: &'a Section,
    /// Area centroid \[m\].
    center: [f64; 2],
    /// `Y P K4`: generalized strain per unit p.
    strain: Matrix6x4<f64>,
    /// `X P K4`: warping per unit p, three rows a node.
    warping: Vec<SMatrix<f64, 3, 4>>,
}

impl<'a> Fields<'a> {
    fn new(section: &'a Section, warping: &DMatrix<f64>, strain: &Matrix6<f64>) -> Option<Self> {
        let center = centroid(section);
        let back = wrench::shift_matrix(&-Vector3::new(0.0, center[0], center[1]));
        let about_center = back.transpose() * strain * back;
        let compliance = 0.5 * (about_center + about_center.transpose());
        let selected =
            |i: usize, j: usize| compliance[(PRESTRESS_COMPONENTS[i], PRESTRESS_COMPONENTS[j])];
        let stiffness = inverse(&Matrix4::from_fn(selected))?;
        // P K4: internal force about the centroid per unit p
        let mut force = Matrix6x4::zeros();
        for (i, row) in PRESTRESS_COMPONENTS.into_iter().enumerate() {
            force.set_row(row, &stiffness.row(i));
        }
        let about_reference: Matrix6x4<f64> = back * force;
        let nodes = 0..section.mesh.nodes.len();
        let of_node = |node| warping.fixed_view::<3, 6>(3 * node, 0) * about_reference;
        let mut fields = Self {
            section,
            center,
            strain: about_center * force,
            warping: nodes.map(of_node).collect(),
        };
        fields.remove_mean();
        Some(fields)
    }

    /// `int w dA = 0`.
    fn remove_mean(&mut self) {
        let (mut area, mut sum) = (0.0, SMatrix::<f64, 3, 4>::zeros());
        let mesh = &self.section.mesh;
        for cell in &mesh.cells {
            for point in self.points(cell) {
                area += point.area;
                for (&node, n) in cell.nodes().iter().zip(&point.n) {
                    sum += n * point.area * self.warping[node as usize];
                }
            }
        }
        let mean = sum / area;
        for at_node in &mut self.warping {
            *at_node -= mean;
        }
    }

    /// The integration points of a cell, from the centroid.
    fn points(&self, cell: &crate::mesh::SectionCell) -> Vec<CellPoint> {
        let places = self.section.mesh.places(cell);
        let places = places.map(|[y, z]| [y - self.center[0], z - self.center[1]]);
        cell_points(cell.kind, &places.collect::<Vec<_>>()).collect()
    }

    /// T about the centroid.
    fn table(&self, measure: StrainMeasure) -> CubicTable {
        let mut table = CubicTable::ZERO;
        let mut law = (None, Matrix6::zeros());
        for (cell, made_of) in self.section.mesh.cells.iter().zip(&self.section.cells) {
            if law.0 != Some(made_of) {
                let stiffness = self.section.materials[made_of.material].law.stiffness();
                let (fiber, plane) = (made_of.fiber_angle, made_of.plane_angle);
                law = (Some(made_of), section_stiffness(&stiffness, fiber, plane));
            }
            let mut warping = [[Vector3::zeros(); 9]; 4];
            for (i, &node) in cell.nodes().iter().enumerate() {
                for (k, of_state) in warping.iter_mut().enumerate() {
                    of_state[i] = self.warping[node as usize].column(k).into_owned();
                }
            }
            for point in self.points(cell) {
                let states: [_; 4] = std::array::from_fn(|k| {
                    let strain: Vector6<f64> = self.strain.column(k).into_owned();
                    PointGradient::at(&point, &strain, &warping[k])
                });
                table = table.plus(&at_point(&states, &law.1, measure).times(point.area));
            }
        }
        table
    }
}

/// The sum over the permutations of `sigma_i . eps2(H_j, H_k)` at a point.
fn at_point(states: &[PointGradient; 4], law: &Matrix6<f64>, measure: StrainMeasure) -> CubicTable {
    let stress = states.map(|state| law * state.strain());
    let mut second = [[Vector6::zeros(); 4]; 4];
    for j in 0..4 {
        for k in j..4 {
            second[j][k] = states[j].second_order(&states[k], measure);
            second[k][j] = second[j][k];
        }
    }
    let s = |i: usize, j: usize, k: usize| stress[i].dot(&second[j][k]);
    CubicTable::from_fn(|[i, j, k]| 2.0 * (s(i, j, k) + s(j, i, k) + s(k, i, j)))
}

/// Inverse of a symmetric positive definite matrix whose rows differ in units.
fn inverse(c: &Matrix4<f64>) -> Option<Matrix4<f64>> {
    let d = Vector4::from_fn(|i, _| 1.0 / c[(i, i)].sqrt());
    let scale = d * d.transpose();
    let inverse = c.component_mul(&scale).cholesky()?.inverse();
    Some(inverse.component_mul(&scale))
}

/// Area centroid, from a node so that a mesh far from its origin keeps its digits.
fn centroid(section: &Section) -> [f64; 2] {
    let mesh = &section.mesh;
    let base = mesh.nodes[0];
    let (mut area, mut sum) = (0.0, [0.0; 2]);
    for cell in &mesh.cells {
        let places: Vec<_> = mesh.places(cell).collect();
        for point in cell_points(cell.kind, &places) {
            area += point.area;
            sum[0] += point.area * (point.y - base[0]);
            sum[1] += point.area * (point.z - base[1]);
        }
    }
    [base[0] + sum[0] / area, base[1] + sum[1] / area]
}

#[cfg(test)]
#[path = "prestress_tests.rs"]
mod tests;
