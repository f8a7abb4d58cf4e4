//! The relative motion of the ends of a joint, and the freedoms of the joint.

use nalgebra::{Matrix6, Vector3, Vector6};
use shared_geom::rotation;

use super::algebra::{End, Ends, Row, Seen};
use crate::elements::{JointMotion, JointState, Level, Motion, Part, ReadingRow};
use crate::model::Variable::{AngularVelocity, Position, Rotation, Velocity};

/// Singular values below this part of the largest are treated as zero: entries of order one.
const ZERO: f64 = 1e-9;

/// The state of the joint called `label` between the nodes `nodes`, with an angle about an axis if
/// it has one; `on_b` is its force and moment on the node of b.
pub(super) fn state(
    (label, nodes): (&str, &[usize]),
    (ends, about): (&Ends, Option<usize>),
    on_b: &[Vector3<f64>; 2],
) -> JointState {
    let (a, b) = (&ends.a, &ends.b);
    let node = |end: usize| ends.node(end).map(|node| nodes[node]);
    let of = |motion| vector(ends, motion);
    JointState {
        joint: label.to_owned(),
        nodes: [node(0), node(1)],
        axes: [a.axes, b.axes],
        force: on_b[0],
        moment: on_b[1] - b.arm.cross(&on_b[0]),
        displacement: of(JointMotion::Displacement),
        rotation: of(JointMotion::Rotation),
        angle: about.map(|axis| angle(ends, axis)),
        velocity: of(JointMotion::Velocity),
        angular_velocity: of(JointMotion::AngularVelocity),
    }
}

/// A motion of b relative to a, in the axes of a; zero for the angle.
fn vector(ends: &Ends, motion: JointMotion) -> Vector3<f64> {
    let (a, b) = (&ends.a, &ends.b);
    let back = a.axes.transpose();
    match motion {
        JointMotion::Displacement => back * ends.between(),
        JointMotion::Rotation => rotation::vector::from_rotation(&(back * b.axes)),
        JointMotion::Velocity => back * seen_from_a(ends),
        JointMotion::AngularVelocity => back * (b.omega - a.omega),
        JointMotion::Angle => Vector3::zeros(),
    }
}

/// Velocity of the point of b relative to axes that turn with a, model axes.
fn seen_from_a(ends: &Ends) -> Vector3<f64> {
    let (a, b) = (&ends.a, &ends.b);
    // The rate of the components in the axes of a.
    b.point_velocity() - a.point_velocity() - a.omega.cross(&ends.between())
}

/// Sine and cosine of the angle of b relative to a about an axis, times one factor.
fn sine_and_cosine(ends: &Ends, axis: usize) -> [f64; 2] {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let turned = ends.b.axes.column(u);
    [v, u].map(|own| ends.a.axes.column(own).dot(&turned))
}

fn angle(ends: &Ends, axis: usize) -> f64 {
    let [sine, cosine] = sine_and_cosine(ends, axis);
    sine.atan2(cosine)
}

/// A part of a motion of b relative to a, and its derivatives. With m the direction of the part in
/// the model, d from the point of a to the point of b, f the arms, V the velocity of the point of b
/// relative to a, and `n = m x omega_a`,
///
/// ```text
/// displacement      dx_b: m     theta_b: f_b x m     dx_a: -m    theta_a: m x d - f_a x m
/// rotation          theta_b - theta_a: A T^-T e
/// velocity          dv_b: m     domega_b: f_b x m    dv_a: -m    domega_a: -(f_a + d) x m
///                   dx_b: -n    dx_a: n              theta_a: m x V
///                   theta_b: f_b x ( m x omega_b - n )
/// angular velocity  domega_b: m     domega_a: -m     theta_a: m x ( omega_b - omega_a )
/// ```
pub(super) fn read(
    (ends, about): (&Ends, Option<usize>),
    (motion, part): (JointMotion, Part),
    row: Option<&mut ReadingRow<'_>>,
) -> Option<f64> {
    let (a, b) = (&ends.a, &ends.b);
    let axis = match motion {
        JointMotion::Angle => Some(about?),
        _ => None,
    };
    let w = vector(ends, motion);
    let value = axis.map_or_else(|| part.of(&w), |axis| angle(ends, axis));
    let Some(row) = row else {
        return Some(value);
    };
    let mut add = |end: &End, variable, slope: Vector3<f64>| {
        if let Some(node) = end.node {
            row.by_node(node, variable, &slope);
        }
    };
    let e = part.slope(&w);
    let m = a.axes * e;
    match motion {
        JointMotion::Displacement => {
            add(b, Position, m);
            add(b, Rotation, b.arm.cross(&m));
            add(a, Position, -m);
            add(a, Rotation, m.cross(&ends.between()) - a.arm.cross(&m));
        }
        JointMotion::Rotation | JointMotion::Angle => {
            let slope = match axis {
                None => a.axes * rotation::vector::tangent_inverse(&w).tr_mul(&e),
                Some(axis) => angle_slope(ends, axis),
            };
            add(b, Rotation, slope);
            add(a, Rotation, -slope);
        }
        JointMotion::Velocity => {
            let n = m.cross(&a.omega);
            add(b, Velocity, m);
            add(b, AngularVelocity, b.arm.cross(&m));
            add(a, Velocity, -m);
            add(a, AngularVelocity, -(a.arm + ends.between()).cross(&m));
            add(b, Position, -n);
            add(a, Position, n);
            add(b, Rotation, b.arm.cross(&(m.cross(&b.omega) - n)));
            add(a, Rotation, m.cross(&seen_from_a(ends)));
        }
        JointMotion::AngularVelocity => {
            add(b, AngularVelocity, m);
            add(a, AngularVelocity, -m);
            add(a, Rotation, m.cross(&(b.omega - a.omega)));
        }
    }
    Some(value)
}

/// w of `d angle = w . ( theta_b - theta_a )`.
fn angle_slope(ends: &Ends, axis: usize) -> Vector3<f64> {
    let [s, c] = sine_and_cosine(ends, axis);
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let (a, turned) = (&ends.a.axes, ends.b.axes.column(u));
    (s * a.column(u) - c * a.column(v)).cross(&turned) / (s * s + c * c)
}

/// The relative motions, of the point of b relative to a and of rotation, that the constraints
/// leave free at the undeformed state: the null space of the forces and moments that they can exert
/// on b at its point.
pub(super) fn free_motions(constraints: &[Row], seen: &Seen<'_>) -> Vec<Motion> {
    let (a, b) = (&seen.ends.a, &seen.ends.b);
    let mut rows = nalgebra::DMatrix::zeros(constraints.len().max(6), 6);
    let held = constraints.iter();
    let held = held.filter(|row| row.level() == Level::Position);
    for (i, row) in held.enumerate() {
        let [_, _, force, moment] = row.at(seen).reaction();
        let moment = moment - b.arm.cross(&force);
        let both = Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        let size = both.amax();
        if size > 0.0 && size.is_finite() {
            rows.set_row(i, &(both / size).transpose());
        }
    }
    let free = null_space(&rows);
    let from_a = b.position - a.position + a.arm;
    let forms = free.into_iter().map(|free| {
        let (d, r) = (free.fixed_rows::<3>(0), free.fixed_rows::<3>(3));
        let (d, r) = (d.into_owned(), r.into_owned());
        let on_a = [-d, -(from_a.cross(&d) + r)];
        let on_b = [d, b.arm.cross(&d) + r];
        match a.node {
            None => vec![on_b],
            Some(_) => vec![on_a, on_b],
        }
    });
    forms
        .map(|form| Motion {
            form,
            is_resisted: false,
        })
        .collect()
}

fn null_space(rows: &nalgebra::DMatrix<f64>) -> Vec<Vector6<f64>> {
    let square: Matrix6<f64> = (rows.transpose() * rows)
        .fixed_view::<6, 6>(0, 0)
        .into_owned();
    // The decomposition does not terminate for numbers that are not finite.
    let square = square.map(|value| if value.is_finite() { value } else { 0.0 });
    let found = square.symmetric_eigen();
    let largest = found.eigenvalues.amax();
    let values = found.eigenvalues.iter().enumerate();
    values
        .filter(|(_, value)| **value <= ZERO * largest.max(1.0))
        .map(|(i, _)| found.eigenvectors.column(i).into_owned())
        .collect()
}
