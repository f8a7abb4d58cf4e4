//! A cell whose nodes move: changes of strains and forces of a given state.
//!
//! With the velocity v of the points, linear in the velocities of the nodes, and constant
//! values at the nodes,
//!
//! ```text
//! d(u,y) = -(vy,y u,y + vz,y u,z)      d(u,z) = -(vy,z u,y + vz,z u,z)
//! d(dA)  = (vy,y + vz,z) dA            dJ = k2 vz - k3 vy      da = -k1 vz      db = k1 vy
//! h  = [I, -t x] psi + u' + k x u - a u,y - b u,z          face strain g = h/J   (S-121)
//! dg = (dh - g dJ)/J
//! ```
//!
//! exact derivatives of the integrand at a point of the rule, so that their sum is the
//! derivative of the sum.
//!
//! # References
//! - [Haug1986], chapter 3: shape as the parameter.

use super::line::{Line, Metric};
use super::point::CellPoint;
use super::strain::{
    FACE_STRAINS, NodalColumns, Y_GRADIENT_STRAINS, Z_GRADIENT_STRAINS, rigid_displacement,
};
use nalgebra::{Matrix3x6, Matrix6};
use shared_geom::rotation::skew;

/// A state of six cases at the nodes of a cell.
#[derive(Debug, Clone, Copy)]
pub struct NodalState<'a> {
    /// u': rate of the warping along the beam.
    pub rate: &'a NodalColumns,
    /// u: warping.
    pub warping: &'a NodalColumns,
    /// psi: generalized strain, a column for each case \[-, 1/m\].
    pub psi: &'a Matrix6<f64>,
}

/// A point of a cell, and its motion.
#[derive(Debug, Clone)]
pub struct MovedPoint<'a> {
    line: &'a Line,
    point: &'a CellPoint,
    metric: Metric,
    /// Velocity of the point.
    velocity: [f64; 2],
    /// `[[vy,y, vy,z], [vz,y, vz,z]]`.
    gradient: [[f64; 2]; 2],
    /// dJ.
    volume_rate: f64,
    /// da, db.
    tilt_rate: [f64; 2],
}

/// Forces of the stresses of six cases at the nodes of a cell.
#[derive(Debug, Clone)]
pub struct NodalForces {
    /// Within the section.
    pub within: NodalColumns,
    /// On the face.
    pub face: NodalColumns,
    /// Internal force, a column for each case \[N, N m\].
    pub resultant: Matrix6<f64>,
}

impl<'a> MovedPoint<'a> {
    /// The point of a cell whose nodes move with `velocities` (y, z).
    pub fn new(line: &'a Line, point: &'a CellPoint, velocities: &[[f64; 2]]) -> Self {
        let sum = |axis: usize, values: &[f64; 9]| -> f64 {
            let terms = velocities.iter().zip(values);
            terms.map(|(v, n)| v[axis] * n).sum()
        };
        let velocity = [0, 1].map(|axis| sum(axis, &point.n));
        let gradient = [0, 1].map(|axis| [sum(axis, &point.dy), sum(axis, &point.dz)]);
        let k = &line.curvature;
        let [vy, vz] = velocity;
        Self {
            metric: line.metric(point.y, point.z),
            volume_rate: k.y * vz - k.z * vy,
            tilt_rate: [-k.x * vz, k.x * vy],
            line,
            point,
            velocity,
            gradient,
        }
    }

    /// The point of a cell at rest.
    pub fn at_rest(line: &'a Line, point: &'a CellPoint) -> Self {
        Self::new(line, point, &[])
    }

    /// Volume per length of the line that the point represents, and its rate \[m^2\].
    pub fn volume(&self) -> (f64, f64) {
        let area = self.point.area;
        let growth = self.growth();
        (
            area * self.metric.volume,
            area * (growth * self.metric.volume + self.volume_rate),
        )
    }

    /// Velocity of the point.
    pub fn velocity(&self) -> [f64; 2] {
        self.velocity
    }

    /// Strain, order yz yy zz xx xy xz, and its rate; six cases each.
    pub fn strain(&self, state: NodalState<'_>) -> (Matrix6<f64>, Matrix6<f64>) {
        let point = self.point;
        let (mut along_y, mut along_z) = (Matrix3x6::zeros(), Matrix3x6::zeros());
        let (mut rate, mut value) = (Matrix3x6::zeros(), Matrix3x6::zeros());
        for i in 0..point.count {
            // the same in exact arithmetic, as in the strain of a cell at rest
            let difference = state.warping[i] - state.warping[0];
            along_y += point.dy[i] * difference;
            along_z += point.dz[i] * difference;
            rate += point.n[i] * state.rate[i];
            value += point.n[i] * state.warping[i];
        }
        let [[vy_y, vy_z], [vz_y, vz_z]] = self.gradient;
        let moved_y = -(vy_y * along_y + vz_y * along_z);
        let moved_z = -(vy_z * along_y + vz_z * along_z);

        let [a, b] = self.metric.tilt;
        let [da, db] = self.tilt_rate;
        let [vy, vz] = self.velocity;
        let turned = skew(&self.line.curvature) * value;
        let rigid = rigid_displacement(1.0, point.y, point.z) * state.psi;
        let face = (rigid + rate + turned - a * along_y - b * along_z) / self.metric.volume;
        let moved = rigid_displacement(0.0, vy, vz) * state.psi
            - (da * along_y + db * along_z + a * moved_y + b * moved_z);
        let face_rate = (moved - self.volume_rate * face) / self.metric.volume;
        (
            placed([&face, &along_y, &along_z]),
            placed([&face_rate, &moved_y, &moved_z]),
        )
    }

    /// Adds the forces of `stress`, times the volume of the point.
    pub fn add_forces(&self, stress: &Matrix6<f64>, forces: &mut NodalForces) {
        let [face, y, z] = parts(stress).map(|part| self.point.area * part);
        let volume = self.metric.volume;
        let plane = [volume * y, volume * z];
        self.add(&face, &plane, self.metric.tilt, &self.point.dy_dz(), forces);
        forces.resultant += rigid_displacement(1.0, self.point.y, self.point.z).transpose() * face;
    }

    /// Adds the rate of the forces of `stress` while the nodes move; `rate` is the rate of
    /// the stress itself.
    pub fn add_force_rates(
        &self,
        stress: &Matrix6<f64>,
        rate: &Matrix6<f64>,
        forces: &mut NodalForces,
    ) {
        let point = self.point;
        // the rate of the stress, and the rate of the volume
        self.add_forces(rate, forces);
        let [face, y, z] = parts(stress).map(|part| point.area * part);
        let (volume, growth) = (self.metric.volume, self.growth());
        let grown = growth * face;
        let growing = growth * volume + self.volume_rate;
        let plane = [growing * y, growing * z];
        self.add(&grown, &plane, self.metric.tilt, &point.dy_dz(), forces);
        let rigid = |one, y, z| rigid_displacement(one, y, z).transpose();
        let [vy, vz] = self.velocity;
        forces.resultant += rigid(1.0, point.y, point.z) * grown + rigid(0.0, vy, vz) * face;

        // the change of the operators
        let none = Matrix3x6::zeros();
        let [[vy_y, vy_z], [vz_y, vz_z]] = self.gradient;
        let mut moved = point.dy_dz();
        for [dy, dz] in &mut moved {
            (*dy, *dz) = (-(vy_y * *dy + vz_y * *dz), -(vy_z * *dy + vz_z * *dz));
        }
        let at_rest = [volume * y, volume * z];
        self.add_gradients(&face, &at_rest, self.metric.tilt, &moved, forces);
        let still = [none, none];
        self.add_gradients(&face, &still, self.tilt_rate, &point.dy_dz(), forces);
    }

    fn growth(&self) -> f64 {
        self.gradient[0][0] + self.gradient[1][1]
    }

    /// Nodal forces of the stresses of the face and of the stresses that work on gradients.
    fn add(
        &self,
        face: &Matrix3x6<f64>,
        plane: &[Matrix3x6<f64>; 2],
        tilt: [f64; 2],
        gradients: &[[f64; 2]; 9],
        forces: &mut NodalForces,
    ) {
        // u . (s x k) = s . (k x u)
        let turned = -(skew(&self.line.curvature) * face);
        for i in 0..self.point.count {
            let n = self.point.n[i];
            forces.within[i] += n * turned;
            forces.face[i] += n * face;
        }
        self.add_gradients(face, plane, tilt, gradients, forces);
    }

    fn add_gradients(
        &self,
        face: &Matrix3x6<f64>,
        plane: &[Matrix3x6<f64>; 2],
        [a, b]: [f64; 2],
        gradients: &[[f64; 2]; 9],
        forces: &mut NodalForces,
    ) {
        for i in 0..self.point.count {
            let [dy, dz] = gradients[i];
            forces.within[i] += dy * plane[0] + dz * plane[1] - (a * dy + b * dz) * face;
        }
    }
}

impl CellPoint {
    fn dy_dz(&self) -> [[f64; 2]; 9] {
        std::array::from_fn(|i| [self.dy[i], self.dz[i]])
    }
}

/// A strain from its face part and the gradients along y and z.
fn placed(parts: [&Matrix3x6<f64>; 3]) -> Matrix6<f64> {
    let mut strain = Matrix6::zeros();
    for (rows, part) in ROWS.into_iter().zip(parts) {
        for (component, row) in rows.into_iter().enumerate() {
            for column in 0..6 {
                strain[(row, column)] += part[(component, column)];
            }
        }
    }
    strain
}

/// The stresses that work on the face part and on the gradients along y and z.
fn parts(stress: &Matrix6<f64>) -> [Matrix3x6<f64>; 3] {
    ROWS.map(|rows| Matrix3x6::from_fn(|i, k| stress[(rows[i], k)]))
}

const ROWS: [[usize; 3]; 3] = [FACE_STRAINS, Y_GRADIENT_STRAINS, Z_GRADIENT_STRAINS];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::{NO_COLUMNS, cell_points, strain_at};
    use crate::section::samples::Random;
    use approx::assert_relative_eq;
    use nalgebra::Vector3;
    use shared_geom::mesh::CellKind;

    const LINE: Line = Line {
        curvature: Vector3::new(0.3, -0.2, 0.25),
        slope: Vector3::new(0.9, 0.1, -0.05),
    };

    struct Case {
        kind: CellKind,
        nodes: Vec<[f64; 2]>,
        velocities: Vec<[f64; 2]>,
        rate: NodalColumns,
        warping: NodalColumns,
        psi: Matrix6<f64>,
        law: Matrix6<f64>,
    }

    fn case(kind: CellKind) -> Case {
        let mut random = Random(7);
        let reference = kind.reference_nodes().iter();
        let nodes = reference.map(|&[r, s]| [1.0 + 0.7 * r - 0.3 * s, 0.2 * r + 0.5 * s]);
        let mut columns = || {
            let mut columns = NO_COLUMNS;
            columns
                .iter_mut()
                .flatten()
                .for_each(|c| *c = random.next());
            columns
        };
        let (rate, warping) = (columns(), columns());
        let mut random = Random(11);
        Case {
            nodes: nodes.collect(),
            velocities: (0..kind.node_count()).map(|_| random.point()).collect(),
            psi: Matrix6::from_fn(|_, _| random.next()),
            law: Matrix6::from_fn(|i, j| if i == j { 3.0 } else { 0.1 * (i + j) as f64 }),
            kind,
            rate,
            warping,
        }
    }

    impl Case {
        fn state(&self) -> NodalState<'_> {
            NodalState {
                rate: &self.rate,
                warping: &self.warping,
                psi: &self.psi,
            }
        }

        fn nodes_at(&self, time: f64) -> Vec<[f64; 2]> {
            let moved = self.nodes.iter().zip(&self.velocities);
            moved
                .map(|(p, v)| [p[0] + time * v[0], p[1] + time * v[1]])
                .collect()
        }

        /// Forces of the stresses, by the kernel of a cell at rest.
        fn forces_at(&self, line: &Line, time: f64) -> NodalForces {
            let mut forces = none();
            for point in cell_points(self.kind, &self.nodes_at(time)) {
                let at = MovedPoint::at_rest(line, &point);
                let (strain, _) = at.strain(self.state());
                at.add_forces(&(self.law * strain), &mut forces);
            }
            forces
        }
    }

    fn none() -> NodalForces {
        NodalForces {
            within: NO_COLUMNS,
            face: NO_COLUMNS,
            resultant: Matrix6::zeros(),
        }
    }

    /// Oracle: the strain of a cell at rest, and its central differences; with a step of
    /// 1e-5 they are good to 1e-10 times third derivatives of order one to a hundred.
    #[test]
    fn strains_follow_the_nodes() {
        for (kind, line) in CellKind::ALL
            .into_iter()
            .flat_map(|kind| [(kind, Line::STRAIGHT), (kind, LINE)])
        {
            let case = case(kind);
            let h = 1e-5;
            let [before, now, after] = [-h, 0.0, h].map(|time| case.nodes_at(time));
            let points = |nodes: &Vec<[f64; 2]>| cell_points(kind, nodes).collect::<Vec<_>>();
            let (before, after) = (points(&before), points(&after));
            for (i, point) in points(&now).iter().enumerate() {
                let plain = |point: &CellPoint| {
                    strain_at(
                        &line,
                        point,
                        Some(&case.rate),
                        Some(&case.warping),
                        &case.psi,
                    )
                };
                let moved = MovedPoint::new(&line, point, &case.velocities);
                let (strain, rate) = moved.strain(case.state());
                assert_relative_eq!(strain, plain(point), epsilon = 1e-13);
                let difference = (plain(&after[i]) - plain(&before[i])) / (2.0 * h);
                assert_relative_eq!(rate, difference, epsilon = 1e-7 * strain.amax());
            }
        }
    }

    /// Oracle: virtual work for the forces, their central differences for the rates.
    #[test]
    fn forces_follow_the_nodes() {
        for (kind, line) in CellKind::ALL
            .into_iter()
            .flat_map(|kind| [(kind, Line::STRAIGHT), (kind, LINE)])
        {
            let case = case(kind);
            let forces = case.forces_at(&line, 0.0);
            let mut work = case.psi.transpose() * forces.resultant;
            for i in 0..kind.node_count() {
                work += case.rate[i].transpose() * forces.face[i];
                work += case.warping[i].transpose() * forces.within[i];
            }
            let (mut of_stress, mut rates) = (Matrix6::zeros(), none());
            for point in cell_points(kind, &case.nodes) {
                let moved = MovedPoint::new(&line, &point, &case.velocities);
                let (strain, rate) = moved.strain(case.state());
                of_stress += moved.volume().0 * strain.transpose() * case.law * strain;
                moved.add_force_rates(&(case.law * strain), &(case.law * rate), &mut rates);
            }
            assert_relative_eq!(work, of_stress, epsilon = 1e-12 * of_stress.amax());

            // fourth order: 1e-16 of the fifth derivative, 1e-11 of the forces by round-off
            let h = 1e-4;
            let [far, near, next, last] =
                [-2.0 * h, -h, h, 2.0 * h].map(|t| case.forces_at(&line, t));
            let weight = 1.0 / (12.0 * h);
            let scale = 1e-8 * forces.resultant.amax();
            let difference = |of: &dyn Fn(&NodalForces) -> Matrix3x6<f64>| {
                weight * (of(&far) - of(&last) + 8.0 * (of(&next) - of(&near)))
            };
            for rows in [0, 3] {
                let of = |forces: &NodalForces| forces.resultant.fixed_rows::<3>(rows).into_owned();
                assert_relative_eq!(of(&rates), difference(&of), epsilon = scale);
            }
            for i in 0..kind.node_count() {
                let of = |forces: &NodalForces| forces.within[i];
                assert_relative_eq!(of(&rates), difference(&of), epsilon = scale);
                let of = |forces: &NodalForces| forces.face[i];
                assert_relative_eq!(of(&rates), difference(&of), epsilon = scale);
            }
        }
    }
}
