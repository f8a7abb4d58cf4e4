//! The forces of a given state of one cell, by integration of its stresses.
//!
//! ```text
//! eps   = B1 u' + B0 u + Bpsi psi          sigma = D eps
//! Q     = int B0' sigma J dA               at the nodes, within the section
//! P     = int B1' sigma J dA               at the nodes, on the face
//! theta = int Bpsi' sigma J dA             internal force
//! W     = int eps' sigma J dA              work of each case on each
//! ```
//!
//! The operators are (S-5) for a straight beam, with J = 1, and (S-73) for a curved one.
//!
//! This is the innermost loop of the program next to the factorization.
//!
//! # References
//! - Giavotto et al. 1983, section 2: the strain of a straight section.

use super::cases::{
    CASES, CellField, CellState, FACE, NO_FIELD, NO_ROWS, Product, Row, add_work, cross, matrix_of,
    strain_along, strain_in_cases, stress_in_cases,
};
use super::line::{Line, Metric};
use super::point::{CellPoint, RulePoint};
use nalgebra::Matrix6;

/// Forces and work of a cell's stresses, in six cases.
#[derive(Debug, Clone)]
pub struct CellForces {
    /// Q: `[node][component][case]`.
    pub within: CellField,
    /// P: `[node][component][case]`.
    pub face: CellField,
    /// theta: `[component][case]`.
    resultant: [Row; 6],
    /// W: `[case][case]`.
    pub(super) work: [Row; 6],
}

impl CellForces {
    /// No forces yet.
    pub const NONE: Self = Self {
        within: NO_FIELD,
        face: NO_FIELD,
        resultant: NO_ROWS,
        work: NO_ROWS,
    };

    /// Adds the stresses of `state` with the generalized strain `psi`, at the points of
    /// the rule of a cell with `nodes` (y, z) and the law `law`, order
    /// yz yy zz xx xy xz.
    #[inline(always)]
    pub fn add<P: Product>(
        &mut self,
        (rule, nodes): (&[RulePoint], &[[f64; 2]]),
        law: &[[f64; 6]; 6],
        state: &CellState,
        psi: &[Row; 6],
    ) {
        let difference = state.differences();
        for point in rule {
            let point = point.of_cell(nodes);
            let strain = strain_in_cases::<P>(&point, &state.rate, &difference, psi);
            let stress = stress_in_cases::<P>(law, &strain, point.area);
            self.add_point::<P>(&point, &strain, &stress);
        }
    }

    /// As [`CellForces::add`], for a beam along `line`.
    #[inline(always)]
    pub fn add_along<P: Product>(
        &mut self,
        line: &Line,
        (rule, nodes): (&[RulePoint], &[[f64; 2]]),
        law: &[[f64; 6]; 6],
        state: &CellState,
        psi: &[Row; 6],
    ) {
        let difference = state.differences();
        for point in rule {
            let point = point.of_cell(nodes);
            let metric = line.metric(point.y, point.z);
            let at = (line, &metric);
            let strain = strain_along::<P>(at, &point, state, &difference, psi);
            let stress = stress_in_cases::<P>(law, &strain, point.area * metric.volume);
            self.add_turned::<P>(&point, at, &strain, &stress);
        }
    }

    /// The forces of the stresses at a point of a curved beam: as for a straight beam with
    /// the stresses of the face over J, plus the terms of the turn and the tilt of the
    /// material line within the section.
    #[inline(always)]
    pub(super) fn add_turned<P: Product>(
        &mut self,
        point: &CellPoint,
        (line, metric): (&Line, &Metric),
        strain: &[Row; 6],
        stress: &[Row; 6],
    ) {
        let mut face = [[0.0; CASES]; 3];
        for (axis, face) in face.iter_mut().enumerate() {
            for k in 0..CASES {
                face[k] = stress[FACE + axis][k] / metric.volume;
            }
        }
        // q x k: force of the work of the face stress on k x u
        let mut turned = [[0.0; CASES]; 3];
        for k in 0..CASES {
            let of_case = cross(line.curvature.as_ref(), &face, k);
            for axis in 0..3 {
                turned[axis][k] = -of_case[axis];
            }
        }
        let [yz, yy, zz, _, xy, xz] = stress;
        let [a, b] = metric.tilt;
        for node in 0..point.count {
            let (n, dy, dz) = (point.n[node], point.dy[node], point.dz[node]);
            let slid = -(a * dy + b * dz);
            let plane = [[xy, xz], [yy, yz], [yz, zz]];
            for (axis, [of_y, of_z]) in plane.into_iter().enumerate() {
                let within = &mut self.within[node][axis];
                let on_face = &mut self.face[node][axis];
                for k in 0..CASES {
                    within[k] = P::add(dy, of_y[k], P::add(dz, of_z[k], within[k]));
                    within[k] = P::add(n, turned[axis][k], P::add(slid, face[axis][k], within[k]));
                    on_face[k] = P::add(n, face[axis][k], on_face[k]);
                }
            }
        }
        self.add_resultant([point.y, point.z], &face);
        add_work::<P, 6, 6>(&mut self.work, strain, stress);
    }

    #[inline(always)]
    pub(super) fn add_point<P: Product>(
        &mut self,
        point: &CellPoint,
        strain: &[Row; 6],
        stress: &[Row; 6],
    ) {
        let [yz, yy, zz, xx, xy, xz] = stress;
        for node in 0..point.count {
            let (n, dy, dz) = (point.n[node], point.dy[node], point.dz[node]);
            let (within, face) = (&mut self.within[node], &mut self.face[node]);
            for k in 0..CASES {
                within[0][k] = P::add(dy, xy[k], P::add(dz, xz[k], within[0][k]));
                within[1][k] = P::add(dy, yy[k], P::add(dz, yz[k], within[1][k]));
                within[2][k] = P::add(dy, yz[k], P::add(dz, zz[k], within[2][k]));
                face[0][k] = P::add(n, xx[k], face[0][k]);
                face[1][k] = P::add(n, xy[k], face[1][k]);
                face[2][k] = P::add(n, xz[k], face[2][k]);
            }
        }
        self.add_resultant([point.y, point.z], &[*xx, *xy, *xz]);
        add_work::<P, 6, 6>(&mut self.work, strain, stress);
    }

    /// `[I, -t x]'` times the stress of the face at t = (y, z).
    #[inline(always)]
    fn add_resultant(&mut self, [y, z]: [f64; 2], [xx, xy, xz]: &[Row; 3]) {
        let theta = &mut self.resultant;
        for k in 0..CASES {
            theta[0][k] += xx[k];
            theta[1][k] += xy[k];
            theta[2][k] += xz[k];
            theta[3][k] += y * xz[k] - z * xy[k];
            theta[4][k] += z * xx[k];
            theta[5][k] -= y * xx[k];
        }
    }

    /// theta, a column for each case.
    pub fn resultant(&self) -> Matrix6<f64> {
        matrix_of(&self.resultant)
    }

    /// W: work of the stresses of case k on the strains of case i.
    pub fn work(&self) -> Matrix6<f64> {
        matrix_of(&self.work)
    }

    /// Clears the forces at the nodes for the next cell.
    #[inline(always)]
    pub fn clear_nodes(&mut self) {
        self.within = NO_FIELD;
        self.face = NO_FIELD;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::cases::{Fused, Plain, rows_of};
    use crate::element::{NO_COLUMNS, NodalColumns, cell_points, rule_points, strain_at};
    use approx::assert_relative_eq;
    use nalgebra::{Matrix3x6, Vector3};
    use shared_geom::mesh::CellKind;

    const NODES: [[f64; 2]; 9] = [
        [0.0, 0.1],
        [1.1, 0.0],
        [1.0, 0.9],
        [-0.1, 1.0],
        [0.5, -0.1],
        [1.1, 0.5],
        [0.4, 1.0],
        [0.0, 0.5],
        [0.5, 0.5],
    ];

    const LINE: Line = Line {
        curvature: Vector3::new(0.3, -0.2, 0.25),
        slope: Vector3::new(0.9, 0.1, -0.05),
    };

    fn field(seed: usize) -> (CellField, NodalColumns) {
        let (mut field, mut columns) = (NO_FIELD, NO_COLUMNS);
        for node in 0..9 {
            columns[node] = Matrix3x6::from_fn(|i, k| {
                (((node + seed) * 31 + i * 17 + k * 7) % 23) as f64 / 11.0 - 1.0
            });
            for axis in 0..3 {
                for k in 0..6 {
                    field[node][axis][k] = columns[node][(axis, k)];
                }
            }
        }
        (field, columns)
    }

    /// Oracle: the plain strain of [`strain_at`], and the balance of work: the work of the
    /// stresses equals the work of the nodal forces and of the internal force.
    #[test]
    fn forces_are_those_of_the_plain_strains() {
        let law = Matrix6::from_fn(|i, j| if i == j { 3.0 } else { 0.1 * (i + j) as f64 });
        let law_rows = std::array::from_fn(|i| std::array::from_fn(|j| law[(i, j)]));
        let psi = Matrix6::from_fn(|i, j| ((3 * i + 5 * j) % 7) as f64 - 3.0);
        let ((rate, rate_columns), (warping, warping_columns)) = (field(1), field(4));
        for (kind, line) in CellKind::ALL
            .into_iter()
            .flat_map(|k| [(k, None), (k, Some(LINE))])
        {
            let nodes = &NODES[..kind.node_count()];
            let state = CellState { rate, warping };
            let cell = (rule_points(kind), nodes);
            let (mut forces, mut plain) = (CellForces::NONE, CellForces::NONE);
            let rows = rows_of(&psi);
            if let Some(line) = &line {
                forces.add_along::<Fused>(line, cell, &law_rows, &state, &rows);
                plain.add_along::<Plain>(line, cell, &law_rows, &state, &rows);
            } else {
                forces.add::<Fused>(cell, &law_rows, &state, &rows);
                plain.add::<Plain>(cell, &law_rows, &state, &rows);
            }
            assert_relative_eq!(forces.work(), plain.work(), max_relative = 1e-12);

            let line = line.unwrap_or(Line::STRAIGHT);
            let mut work = Matrix6::zeros();
            for point in cell_points(kind, nodes) {
                let (rate, warping) = (Some(&rate_columns), Some(&warping_columns));
                let strain = strain_at(&line, &point, rate, warping, &psi);
                let volume = point.area * line.metric(point.y, point.z).volume;
                work += volume * strain.transpose() * law * strain;
            }
            assert_relative_eq!(forces.work(), work, epsilon = 1e-13 * work.amax());

            let mut of_forces = psi.transpose() * forces.resultant();
            for node in 0..kind.node_count() {
                for axis in 0..3 {
                    for (i, k) in (0..6).flat_map(|i| (0..6).map(move |k| (i, k))) {
                        of_forces[(i, k)] += rate[node][axis][i] * forces.face[node][axis][k]
                            + warping[node][axis][i] * forces.within[node][axis][k];
                    }
                }
            }
            assert_relative_eq!(of_forces, work, epsilon = 1e-13 * work.amax());
        }
    }
}
