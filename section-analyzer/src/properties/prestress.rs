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
//! The energy per length of a uniform state is a minimum over the warping, so that its
//! cubic part needs only the warping of the linear solution:
//!
//! ```text
//! psi = Y P K4 p      u = X P K4 p      u' = 0 for these four              (S-83)
//! S_ijk = int sigma_i . eps2(H_j, H_k) dA
//! T_ijk = S_ijk + S_ikj + S_jik + S_jki + S_kij + S_kji                    (S-84)
//! ```
//!
//! The axes of the section are the axes of the linear solution; its reference point moves
//! with the mean of the warping over the area, `int w dA = 0`.
//!
//! The computation is about the area centroid, where no digits are lost; the table is then
//! moved to the reference point.
//!
//! A state of imposed strain eps_p, without internal force, has a self-equilibrated stress
//! sigma_0 and a gradient H_0. It is a fifth state, with the index 0, of the same sum:
//!
//! ```text
//! sigma_0 = D ( eps_0 - eps_p )
//! T_0jk = S_0jk + S_0kj + S_j0k + S_jk0 + S_k0j + S_kj0                    (S-150)
//! ```
//!
//! Its form in axes along the tangent of the reference line is (S-87); closed forms of
//! isotropic sections are (S-88), and (S-89) is the gain of a strip.
//!
//! # References
//! - [HouboltBrooks1958]: tension stiffens torsion by N Ip/A.
//! - [Wagner1936]: torsion of open sections under compression and bending.
//! - [PopescuHodges1999]: trapeze effect of composite strips from the second-order strain.

use std::fmt;

use nalgebra::{
    DMatrix, DVector, Matrix4, Matrix6, Matrix6x4, SMatrix, Vector2, Vector3, Vector4, Vector6,
};
use shared_geom::section::{
    CubicTable, InitialCurvature, PRESTRESS_COMPONENTS, Prestress, StrainMeasure, strains_of_moved,
};
use shared_geom::wrench;

use crate::element::{CellPoint, PointGradient, cell_points};
use crate::material::{section_stiffness, section_strain};
use crate::section::{ImposedStrain, Section};

/// Reason why a section has no table of prestress.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoPrestress {
    /// The undeformed beam is curved or twisted.
    Curved,
    /// Its reference line is not normal to the section.
    Oblique,
    /// The compliance of the section has no inverse.
    Singular,
}

impl NoPrestress {
    /// Requires a straight beam, normal to its section: the table exists only for these.
    ///
    /// # Errors
    /// The reason if the beam is not straight and normal.
    pub fn require_straight(initial: &InitialCurvature) -> Result<(), Self> {
        match (initial.is_straight(), initial.curvature == Vector3::zeros()) {
            (true, _) => Ok(()),
            (false, true) => Err(Self::Oblique),
            (false, false) => Err(Self::Curved),
        }
    }
}

impl fmt::Display for NoPrestress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Curved => {
                "the effect of prestress is known for straight beams only, and this one has an \
                 initial curvature"
            }
            Self::Oblique => {
                "the effect of prestress is known for beams whose line is normal to the section \
                 only, and the slope of this one is oblique"
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
/// [`NoPrestress`] for a curved or oblique beam.
pub fn prestress(
    section: &Section,
    warping: &DMatrix<f64>,
    strain: &Matrix6<f64>,
    strain_measure: StrainMeasure,
) -> Result<Prestress, NoPrestress> {
    NoPrestress::require_straight(&section.initial_curvature)?;
    let fields = Fields::new(section, warping, strain).ok_or(NoPrestress::Singular)?;
    let third = fields.table(strain_measure);
    Ok(Prestress {
        strain_measure,
        third: third.shifted(-Vector2::from(fields.center)),
        per_kelvin: None,
    })
}

/// An imposed strain, and the state of the section under it without internal force.
#[derive(Debug, Clone, Copy)]
pub struct FreeState<'a> {
    /// The imposed strain.
    pub imposed: &'a ImposedStrain,
    /// Warping, rows ux, uy, uz of each node of the mesh \[m\].
    pub warping: &'a DVector<f64>,
    /// psi_T: generalized strain about the reference point \[-, 1/m\].
    pub strain: &'a Vector6<f64>,
}

/// The change of the stiffness of `section` by each of `states` without internal force,
/// `T_0jk` of (S-150) over axial, torsion, bending y and bending z, about the reference
/// point \[N, N m, N m^2\]; arguments as of [`prestress`].
///
/// # Errors
/// [`NoPrestress`] for a curved or oblique beam.
pub fn prestress_of_imposed(
    section: &Section,
    warping: &DMatrix<f64>,
    strain: &Matrix6<f64>,
    strain_measure: StrainMeasure,
    states: &[FreeState<'_>],
) -> Result<Vec<Matrix4<f64>>, NoPrestress> {
    NoPrestress::require_straight(&section.initial_curvature)?;
    let fields = Fields::new(section, warping, strain).ok_or(NoPrestress::Singular)?;
    let v = strains_of_moved(-Vector2::from(fields.center));
    let of_state = |state: &FreeState<'_>| {
        let change = v.transpose() * fields.change_by(state, strain_measure) * v;
        0.5 * (change + change.transpose())
    };
    Ok(states.iter().map(of_state).collect())
}

/// The four uniform states of a section, about its area centroid.
struct Fields<'a> {
    section: &'a Section,
    /// Area centroid \[m\].
    center: [f64; 2],
    /// `Y P K4`: generalized strain per unit p.
    strain: Matrix6x4<f64>,
    /// `X P K4`: warping per unit p, three rows per node.
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
        let mean = fields.mean(&fields.warping);
        for at_node in &mut fields.warping {
            *at_node -= mean;
        }
        Some(fields)
    }

    /// Mean of a field over the area; after its subtraction `int w dA = 0`.
    fn mean<const N: usize>(&self, field: &[SMatrix<f64, 3, N>]) -> SMatrix<f64, 3, N> {
        let (mut area, mut sum) = (0.0, SMatrix::zeros());
        for cell in &self.section.mesh.cells {
            for point in self.points(cell) {
                area += point.area;
                for (&node, n) in cell.nodes().iter().zip(&point.n) {
                    sum += n * point.area * field[node as usize];
                }
            }
        }
        sum / area
    }

    /// The integration points of a cell, from the centroid.
    fn points(&self, cell: &crate::mesh::SectionCell) -> Vec<CellPoint> {
        let positions = self.section.mesh.positions(cell);
        let positions = positions.map(|[y, z]| [y - self.center[0], z - self.center[1]]);
        cell_points(cell.kind, &positions.collect::<Vec<_>>()).collect()
    }

    /// T about the centroid.
    fn table(&self, measure: StrainMeasure) -> CubicTable {
        let mut table = CubicTable::ZERO;
        self.each_point(|point, _, law, states| {
            table = table.plus(&at_point(states, law, measure).times(point.area));
        });
        table
    }

    /// T_0 of an imposed state about the centroid.
    fn change_by(&self, free: &FreeState<'_>, measure: StrainMeasure) -> Matrix4<f64> {
        let [y, z] = self.center;
        let to_center = wrench::shift_matrix(&-Vector3::new(0.0, y, z)).transpose();
        let strain = to_center * free.strain;
        let at_node = |node: usize| free.warping.fixed_rows::<3>(3 * node).into_owned();
        let mut warping: Vec<_> = (0..self.warping.len()).map(at_node).collect();
        let mean = self.mean(&warping);
        for at_node in &mut warping {
            *at_node -= mean;
        }
        let mut sum = Matrix4::zeros();
        self.each_point(|point, index, law, states| {
            let nodes = self.section.mesh.cells[index].nodes();
            let of_cell = warping_of_cell(nodes, |node| warping[node]);
            let own = PointGradient::at(point, &strain, &of_cell);
            let made_of = &self.section.cells[index];
            let position = [point.y + y, point.z + z];
            let imposed = free.imposed.cells.get(index);
            let imposed = imposed.map_or_else(Vector6::zeros, |imposed| imposed.at(position));
            let imposed = section_strain(&imposed, made_of.fiber_angle, made_of.plane_angle);
            let stress = law * (own.strain() - imposed);
            sum += point.area * change_at_point(states, (&own, &stress), law, measure);
        });
        sum
    }

    /// Calls `user` at every integration point with the number of its cell, its law in
    /// section axes and the four states there.
    fn each_point(
        &self,
        mut user: impl FnMut(&CellPoint, usize, &Matrix6<f64>, &[PointGradient; 4]),
    ) {
        let mut law = (None, Matrix6::zeros());
        let section = self.section;
        for (index, (cell, made_of)) in section.mesh.cells.iter().zip(&section.cells).enumerate() {
            if law.0 != Some(made_of) {
                let stiffness = section.materials[made_of.material].law.stiffness();
                let (fiber, plane) = (made_of.fiber_angle, made_of.plane_angle);
                law = (Some(made_of), section_stiffness(&stiffness, fiber, plane));
            }
            let warping: [_; 4] = std::array::from_fn(|k| {
                warping_of_cell(cell.nodes(), |node| {
                    self.warping[node].column(k).into_owned()
                })
            });
            for point in self.points(cell) {
                let states: [_; 4] = std::array::from_fn(|k| {
                    let strain: Vector6<f64> = self.strain.column(k).into_owned();
                    PointGradient::at(&point, &strain, &warping[k])
                });
                user(&point, index, &law.1, &states);
            }
        }
    }
}

/// The warping at the nodes of a cell \[m\].
fn warping_of_cell(nodes: &[u32], at: impl Fn(usize) -> Vector3<f64>) -> [Vector3<f64>; 9] {
    let mut warping = [Vector3::zeros(); 9];
    for (of_node, &node) in warping.iter_mut().zip(nodes) {
        *of_node = at(node as usize);
    }
    warping
}

/// `T_0jk` at a point, from gradient and stress of the state 0.
fn change_at_point(
    states: &[PointGradient; 4],
    (own, own_stress): (&PointGradient, &Vector6<f64>),
    law: &Matrix6<f64>,
    measure: StrainMeasure,
) -> Matrix4<f64> {
    let stress = states.map(|state| law * state.strain());
    let with_own = states.map(|state| state.second_order(own, measure));
    Matrix4::from_fn(|j, k| {
        let both = states[j].second_order(&states[k], measure);
        let turned = stress[j].dot(&with_own[k]) + stress[k].dot(&with_own[j]);
        2.0 * (own_stress.dot(&both) + turned)
    })
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
        let positions: Vec<_> = mesh.positions(cell).collect();
        for point in cell_points(cell.kind, &positions) {
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
