//! The strain of a curved beam against the motion of its points in space.

use super::cases::{CellState, NO_FIELD, Plain, matrix_of, rows_of, strain_along};
use super::line::Line;
use super::point::CellPoint;
use super::strain::{NO_COLUMNS, NodalColumns, strain_at};
use crate::section::samples::Random;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::mesh::CellKind;
use shared_geom::rotation;

fn vector(random: &mut Random) -> Vector3<f64> {
    Vector3::from_fn(|_, _| random.next())
}

/// A beam along a helix, of one cell, and its motion; all in section axes.
struct Beam {
    line: Line,
    nodes: [[f64; 2]; 9],
    /// Displacement and rotation of the axis at x = 0.
    position: [Vector3<f64>; 2],
    psi: Vector6<f64>,
    warping: [Vector3<f64>; 9],
    rate: [Vector3<f64>; 9],
}

impl Beam {
    fn random(random: &mut Random) -> Self {
        let reference = CellKind::Quadrilateral9.reference_nodes();
        let nodes = std::array::from_fn(|i| {
            let [r, s] = reference[i];
            [r + 0.1 * random.next(), 0.2 + s + 0.1 * random.next()]
        });
        Self {
            // J is at least 0.4
            line: Line {
                curvature: 0.2 * vector(random),
                slope: Vector3::x() + 0.1 * vector(random),
            },
            nodes,
            position: [vector(random), vector(random)],
            psi: Vector6::from_fn(|_, _| random.next()),
            warping: std::array::from_fn(|_| vector(random)),
            rate: std::array::from_fn(|_| vector(random)),
        }
    }

    /// The axis at x: `int exp(x k x) l dx`, by its series.
    fn axis(&self, x: f64) -> Vector3<f64> {
        let (mut term, mut sum) = (x * self.line.slope, Vector3::zeros());
        for order in 2..12 {
            sum += term;
            term = self.line.curvature.cross(&term) * (x / f64::from(order));
        }
        sum
    }

    /// A material point and its displacement, both in space: it is at `x0 + R0 t` and moves
    /// by `R0 (p + phi x t + w)`. The generalized strain at x = 0,
    /// `R0 nu = (R0 p)' - R0 phi x x0'` and `R0 kappa = (R0 phi)'`, gives p' and phi'.
    fn point(&self, x: f64, r: f64, s: f64) -> [Vector3<f64>; 2] {
        let (k, l) = (&self.line.curvature, &self.line.slope);
        let frame = rotation::vector::to_rotation(&(x * k));
        let at = CellPoint::at(CellKind::Quadrilateral9, &self.nodes, r, s, 1.0);
        let t = Vector3::new(0.0, at.y, at.z);
        let [p, phi] = &self.position;
        let (nu, kappa) = (self.psi.fixed_rows::<3>(0), self.psi.fixed_rows::<3>(3));
        let p = p + x * (nu - k.cross(p) + phi.cross(l));
        let phi = phi + x * (kappa - k.cross(phi));
        let mut warping = Vector3::zeros();
        for i in 0..9 {
            warping += at.n[i] * (self.warping[i] + x * self.rate[i]);
        }
        [
            self.axis(x) + frame * t,
            frame * (p + phi.cross(&t) + warping),
        ]
    }

    /// The symmetric gradient at (r, s) of the section x = 0, by central differences of
    /// fourth order in x, r, s, order yz yy zz xx xy xz.
    fn strain_of_motion(&self, r: f64, s: f64) -> Vector6<f64> {
        const H: f64 = 4e-3;
        let (mut position, mut moved) = (Matrix3::zeros(), Matrix3::zeros());
        for axis in 0..3 {
            let at = |steps: f64| {
                let step = Vector3::ith(axis, steps * H);
                self.point(step.x, r + step.y, s + step.z)
            };
            let (near, far) = ([at(1.0), at(-1.0)], [at(2.0), at(-2.0)]);
            let slope = |what: usize| {
                let [near, far] = [near, far].map(|[after, before]| after[what] - before[what]);
                (8.0 * near - far) / (12.0 * H)
            };
            position.set_column(axis, &slope(0));
            moved.set_column(axis, &slope(1));
        }
        let gradient = moved * position.try_inverse().expect("a sound cell");
        let g = gradient + gradient.transpose();
        Vector6::new(
            g[(1, 2)],
            0.5 * g[(1, 1)],
            0.5 * g[(2, 2)],
            0.5 * g[(0, 0)],
            g[(0, 1)],
            g[(0, 2)],
        )
    }
}

/// Both forms of (S-73), for a point and for six cases at once, against the displacement of
/// material points in space, for any curvature, slope of the line and motion, including a
/// rigid motion, which causes no strain.
///
/// Differences of fourth order over 0.004 of fields of order one: h^4 = 3e-10 times a
/// hundredth, and round-off over h, 1e-13.
#[test]
fn strain_is_that_of_the_motion_in_space() {
    let mut random = Random(7);
    let mut worst = 0.0_f64;
    for _ in 0..40 {
        let beam = Beam::random(&mut random);
        let columns = |field: &[Vector3<f64>; 9]| -> NodalColumns {
            let mut columns = NO_COLUMNS;
            for (column, value) in columns.iter_mut().zip(field) {
                column.set_column(0, value);
            }
            columns
        };
        let mut psi = Matrix6::zeros();
        psi.set_column(0, &beam.psi);
        let mut state = CellState {
            rate: NO_FIELD,
            warping: NO_FIELD,
        };
        for i in 0..9 {
            for axis in 0..3 {
                state.rate[i][axis][0] = beam.rate[i][axis];
                state.warping[i][axis][0] = beam.warping[i][axis];
            }
        }
        for [r, s] in [[0.0, 0.0], [0.7, -0.4], [-0.9, 0.8]] {
            let point = CellPoint::at(CellKind::Quadrilateral9, &beam.nodes, r, s, 1.0);
            let (rate, warping) = (columns(&beam.rate), columns(&beam.warping));
            let found = strain_at(&beam.line, &point, Some(&rate), Some(&warping), &psi);
            let metric = beam.line.metric(point.y, point.z);
            assert!(metric.volume > 0.3, "{metric:?}");
            let differences = state.differences();
            let (line, psi) = ((&beam.line, &metric), rows_of(&psi));
            let along = strain_along::<Plain>(line, &point, &state, &differences, &psi);
            let expected = beam.strain_of_motion(r, s);
            for found in [found, matrix_of(&along)] {
                worst = worst.max((found.column(0) - expected).amax() / expected.amax());
            }
        }
    }
    println!("{worst:e}");
    assert!(worst < 1e-11, "{worst:e}");
}
