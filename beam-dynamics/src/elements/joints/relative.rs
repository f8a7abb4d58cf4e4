//! The relative motion of the ends of a joint, and what of it the joint leaves free.

use nalgebra::{Matrix6, Vector3, Vector6};
use shared_geom::rotation::vector;

use super::joint::ConstraintJoint;
use crate::elements::{Element, JointState, Level, Motion};
use crate::model::{Loading, NodeMotion, Scalars};

/// Singular values below this part of the largest count as zero: entries of order one.
const ZERO: f64 = 1e-9;

/// What a joint tells of a state; `on_b` is its force and moment on the node of b.
pub(super) fn state(
    joint: &ConstraintJoint,
    nodes: &[NodeMotion],
    on_b: &[Vector3<f64>; 2],
) -> JointState {
    let ends = joint.ends(nodes);
    let (a, b) = (&ends.a, &ends.b);
    let back = a.axes.transpose();
    let node = |end: usize| ends.node(end).map(|node| joint.nodes()[node]);
    let between = ends.between();
    let rotation = vector::from_rotation(&(back * b.axes));
    // The rate of the components in the axes of a.
    let velocity = b.point_velocity() - a.point_velocity() - a.spin.cross(&between);
    JointState {
        joint: joint.label().to_owned(),
        nodes: [node(0), node(1)],
        axes: [a.axes, b.axes],
        force: on_b[0],
        moment: on_b[1] - b.arm.cross(&on_b[0]),
        displacement: back * between,
        rotation,
        angle: joint.angle_about().map(|axis| {
            let against = back * b.axes;
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            against[(v, u)].atan2(against[(u, u)])
        }),
        velocity: back * velocity,
        angular_velocity: back * (b.spin - a.spin),
    }
}

/// The relative motions, of the point of b seen from a and of rotation, that the
/// constraints leave free at the undeformed state: the null space of the forces and
/// moments that they can exert on b at its point.
pub(super) fn free_motions(joint: &ConstraintJoint, undeformed: &[NodeMotion]) -> Vec<Motion> {
    let seen = joint.seen(undeformed, &Loading::none(), Scalars::NONE);
    let (a, b) = (&seen.ends.a, &seen.ends.b);
    let mut rows = nalgebra::DMatrix::zeros(joint.rows().len().max(6), 6);
    let held = joint
        .rows()
        .iter()
        .filter(|row| row.level() == Level::Position);
    for (i, row) in held.enumerate() {
        let [_, _, force, moment] = row.at(&seen).reaction();
        let moment = moment - b.arm.cross(&force);
        let both = Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        let size = both.amax();
        if size > 0.0 && size.is_finite() {
            rows.set_row(i, &(both / size).transpose());
        }
    }
    let free = null_space(&rows);
    let from_a = b.place - a.place + a.arm;
    let forms = free.into_iter().map(|free| {
        let (d, r) = (free.fixed_rows::<3>(0), free.fixed_rows::<3>(3));
        let (d, r) = (d.into_owned(), r.into_owned());
        let on_a = [-d, -(from_a.cross(&d) + r)];
        let on_b = [d, b.arm.cross(&d) + r];
        match undeformed.len() {
            1 => vec![on_b],
            _ => vec![on_a, on_b],
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
    // The decomposition does not end on numbers that are not finite.
    let square = square.map(|value| if value.is_finite() { value } else { 0.0 });
    let found = square.symmetric_eigen();
    let largest = found.eigenvalues.amax();
    let values = found.eigenvalues.iter().enumerate();
    values
        .filter(|(_, value)| **value <= ZERO * largest.max(1.0))
        .map(|(i, _)| found.eigenvectors.column(i).into_owned())
        .collect()
}
