//! The energy of a section in large uniform strain, by Newton's method on its warping:
//! independent of the cubic table, which is its expansion.
//!
//! ```text
//! F = [(1 + nu) e1 + kappa x (t + w),  e2 + w,y ,  e3 + w,z]
//! U = min int 1/2 (E - c eps_p)' D (E - c eps_p) dA ,   E = 1/2 (F'F - I)
//! int w dA = 0 ,   int (y w_z - z w_y) dA = 0
//! ```
//!
//! The axes follow the tangent of the reference line (no shear strain) and the mean turn
//! of the warping.

use nalgebra::{DMatrix, DVector, Matrix3, Matrix6, Vector3, Vector4, Vector6};

use crate::element::{CellPoint, cell_points};
use crate::material::{section_stiffness, section_strain};
use crate::section::{ImposedStrain, Section};

/// Variation of F with one unknown: its columns.
type Columns = [Vector3<f64>; 3];

pub(super) struct LargeStrain {
    points: Vec<(CellPoint, Vec<u32>, Matrix6<f64>)>,
    /// c eps_p at the points, order yz yy zz xx xy xz.
    imposed: Vec<Vector6<f64>>,
    nodes: usize,
    /// Four rows of constraints on the warping.
    constraints: DMatrix<f64>,
}

impl LargeStrain {
    pub fn new(section: &Section) -> Self {
        let mesh = &section.mesh;
        let mut points = Vec::new();
        let nodes = mesh.nodes.len();
        let mut constraints = DMatrix::zeros(4, 3 * nodes);
        for (cell, made_of) in mesh.cells.iter().zip(&section.cells) {
            let law = section.materials[made_of.material].law.stiffness();
            let law = section_stiffness(&law, made_of.fiber_angle, made_of.plane_angle);
            let positions: Vec<_> = mesh.positions(cell).collect();
            for point in cell_points(cell.kind, &positions) {
                for (i, &node) in cell.nodes().iter().enumerate() {
                    let n = point.n[i] * point.area;
                    let first = 3 * node as usize;
                    for axis in 0..3 {
                        constraints[(axis, first + axis)] += n;
                    }
                    constraints[(3, first + 1)] -= point.z * n;
                    constraints[(3, first + 2)] += point.y * n;
                }
                points.push((point, cell.nodes().to_vec(), law));
            }
        }
        Self {
            imposed: vec![Vector6::zeros(); points.len()],
            points,
            nodes,
            constraints,
        }
    }

    /// The same under an imposed strain times a factor.
    pub fn under(&self, section: &Section, imposed: &ImposedStrain, factor: f64) -> Self {
        let mut all = Vec::new();
        for ((cell, made_of), free) in section
            .mesh
            .cells
            .iter()
            .zip(&section.cells)
            .zip(&imposed.cells)
        {
            let positions: Vec<_> = section.mesh.positions(cell).collect();
            for point in cell_points(cell.kind, &positions) {
                let strain = free.at([point.y, point.z]);
                let turned = section_strain(&strain, made_of.fiber_angle, made_of.plane_angle);
                all.push(factor * turned);
            }
        }
        Self {
            points: self.points.clone(),
            imposed: all,
            nodes: self.nodes,
            constraints: self.constraints.clone(),
        }
    }

    /// Force per generalized strain `dU/dp` at `p` = (nu, k1, k2, k3).
    pub fn force(&self, p: &Vector4<f64>) -> Vector4<f64> {
        let mut warping = DVector::zeros(3 * self.nodes);
        for _ in 0..12 {
            let (step, size) = self.newton_step(p, &warping);
            warping += step;
            if size < 1e-15 {
                break;
            }
        }
        let mut force = Vector4::zeros();
        for ((point, nodes, law), free) in self.points.iter().zip(&self.imposed) {
            let (f, position) = gradient(p, point, nodes, &warping);
            let stress = law * (green(&f) - free);
            for a in 0..4 {
                let by = match a {
                    0 => Vector3::x(),
                    _ => Vector3::ith(a - 1, 1.0).cross(&position),
                };
                let by = [by, Vector3::zeros(), Vector3::zeros()];
                force[a] += point.area * stress.dot(&variation(&f, &by));
            }
        }
        force
    }

    /// The correction of the warping, and its size.
    fn newton_step(&self, p: &Vector4<f64>, warping: &DVector<f64>) -> (DVector<f64>, f64) {
        let unknowns = 3 * self.nodes;
        let mut matrix = DMatrix::zeros(unknowns + 4, unknowns + 4);
        let mut right = DVector::zeros(unknowns + 4);
        let curvature = Vector3::new(p[1], p[2], p[3]);
        for ((point, nodes, law), free) in self.points.iter().zip(&self.imposed) {
            let (f, _) = gradient(p, point, nodes, warping);
            let stress = law * (green(&f) - free);
            let tensor = tensor(&stress);
            let count = 3 * nodes.len();
            let [mut varied, mut stressed] = [(); 2].map(|()| DMatrix::zeros(15, count));
            let mut rows = Vec::new();
            for (i, &node) in nodes.iter().enumerate() {
                for axis in 0..3 {
                    let e = Vector3::ith(axis, 1.0);
                    let by = [
                        curvature.cross(&e) * point.n[i],
                        e * point.dy[i],
                        e * point.dz[i],
                    ];
                    let (row, column) = (3 * node as usize + axis, rows.len());
                    let strain = variation(&f, &by);
                    right[row] -= point.area * stress.dot(&strain);
                    let by = Matrix3::from_columns(&by);
                    set_column(&mut varied, column, &strain, &by);
                    set_column(&mut stressed, column, &(law * strain), &(by * tensor));
                    rows.push(row);
                }
            }
            let of_point = point.area * varied.transpose() * stressed;
            for (i, row) in rows.iter().enumerate() {
                for (j, column) in rows.iter().enumerate() {
                    matrix[(*row, *column)] += of_point[(i, j)];
                }
            }
        }
        let of_constraints = -&self.constraints * warping;
        right.rows_mut(unknowns, 4).copy_from(&of_constraints);
        matrix
            .view_mut((unknowns, 0), (4, unknowns))
            .copy_from(&self.constraints);
        matrix
            .view_mut((0, unknowns), (unknowns, 4))
            .copy_from(&self.constraints.transpose());
        let all = matrix.lu().solve(&right).expect("the warping is held");
        let step = all.rows(0, unknowns).into_owned();
        let size = step.amax();
        (step, size)
    }
}

/// Stress of order yz yy zz xx xy xz as a tensor.
fn tensor(s: &Vector6<f64>) -> Matrix3<f64> {
    Matrix3::new(s[3], s[4], s[5], s[4], s[1], s[0], s[5], s[0], s[2])
}

/// Writes six and nine numbers in a column.
fn set_column(of: &mut DMatrix<f64>, column: usize, six: &Vector6<f64>, nine: &Matrix3<f64>) {
    let numbers = six.iter().chain(nine);
    for (entry, number) in of.column_mut(column).iter_mut().zip(numbers) {
        *entry = *number;
    }
}

/// F, and t + w.
fn gradient(
    p: &Vector4<f64>,
    point: &CellPoint,
    nodes: &[u32],
    warping: &DVector<f64>,
) -> (Matrix3<f64>, Vector3<f64>) {
    let mut position = Vector3::new(0.0, point.y, point.z);
    let (mut along_y, mut along_z) = (Vector3::y(), Vector3::z());
    for (i, &node) in nodes.iter().enumerate() {
        let at_node: Vector3<f64> = warping.fixed_rows::<3>(3 * node as usize).into_owned();
        position += point.n[i] * at_node;
        along_y += point.dy[i] * at_node;
        along_z += point.dz[i] * at_node;
    }
    let curvature = Vector3::new(p[1], p[2], p[3]);
    let along_x = (1.0 + p[0]) * Vector3::x() + curvature.cross(&position);
    (
        Matrix3::from_columns(&[along_x, along_y, along_z]),
        position,
    )
}

/// Green's strain, order yz yy zz xx xy xz, engineering shears.
fn green(f: &Matrix3<f64>) -> Vector6<f64> {
    let e = 0.5 * (f.transpose() * f - Matrix3::identity());
    Vector6::new(
        2.0 * e[(1, 2)],
        e[(1, 1)],
        e[(2, 2)],
        e[(0, 0)],
        2.0 * e[(0, 1)],
        2.0 * e[(0, 2)],
    )
}

/// Its variation when the columns of F vary by `by`.
fn variation(f: &Matrix3<f64>, by: &Columns) -> Vector6<f64> {
    let product = |i: usize, j: usize| f.column(i).dot(&by[j]);
    Vector6::new(
        product(1, 2) + product(2, 1),
        product(1, 1),
        product(2, 2),
        product(0, 0),
        product(0, 1) + product(1, 0),
        product(0, 2) + product(2, 0),
    )
}
