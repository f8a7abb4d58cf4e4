//! Flow at a strip, from the motion of its nodes, with derivatives.
//!
//! The quarter chord Q is at `a = R a~` from the carried point p, the airfoil axes are `R_a = R
//! R~_a` (x toward the leading edge, y to the upper surface, z along the span). With the velocity
//! of the air `V(Q, t)`, the shaft axis n through c, and the motion of p (see
//! [`crate::elements::carried`]),
//!
//! ```text
//! Q  = p + a           d = Q - c                 g = p' + omega x a + Omega x (Q - c_0) - V
//! w  = R_a^T g         q = e_z . R_a^T (omega + Omega)
//! s  = R_a^T n         r = |d - n (n . d)|              b_i = e_i . d
//! ```
//!
//! and their variations
//!
//! ```text
//! d Q = N_j (d x_j - [f_j]x theta_j) - [a]x theta
//! d g = N_j (d x'_j - [f_j + a]x d omega_j - [omega_j]x [f_j]x theta_j) - [omega]x [a]x theta
//!       + ([Omega]x - grad V) d Q
//! d w = R_a^T (d g + [g]x theta)                 d q = e_z . R_a^T (N_j d omega_j + [omega + Omega]x theta)
//! d b_i = e_i . d(Q - c) + d . d e_i              (in a disk with the axes e_i)
//! d s = R_a^T ([n]x theta - [n]x theta_h)        d r = [(d - n (n . d)) . d(Q - c) - (n . d) d . d n] / r
//! ```
//!
//! References: [Masarati], 5.9.

use std::sync::Arc;

use nalgebra::{Matrix3, SMatrix, Vector3};
use shared_geom::rotation::{skew, skew_skew, skew_times};

use super::carrier::{Carrier, CarrierState};
use super::disk::{DiskAxes, RotorDisk};
use super::shaft::{Distance, Shaft, ShaftState};
use crate::elements::Local;
use crate::elements::carried::CarriedPoint;
use crate::model::{NodeMotion, Variable};

/// Numbers of the flow: w (3), q, s (3), r, b (2).
pub(super) const FLOW: usize = 10;
/// Index of the first component of s.
pub(super) const SHAFT: usize = 4;
/// Index of the first component of b.
const POSITION: usize = 8;

/// Derivatives of the flow by a vector variable of a node.
pub(super) type FlowBlock = SMatrix<f64, FLOW, 3>;

/// Geometry of a strip.
#[derive(Debug, Clone)]
pub(super) struct Mount {
    pub carrier: Carrier,
    /// Quarter chord from the carried point, in the carried axes [m].
    pub offset: Vector3<f64>,
    /// Airfoil axes (columns) in the carried axes.
    pub axes: Matrix3<f64>,
    /// The shaft of its rotor; without a rotor s is e_y and r is zero.
    pub shaft: Option<Shaft>,
    /// Index among the nodes of the element of the node that carries the shaft; the frame if none.
    pub hub: Option<usize>,
    /// The disk of its rotor, if it has one.
    pub disk: Option<Arc<RotorDisk>>,
}

/// The flow at a strip.
pub(super) struct Flow<'a> {
    pub state: CarrierState<'a>,
    pub point: CarriedPoint,
    /// Q from p, model axes [m].
    pub arm: Vector3<f64>,
    /// `R_a`.
    pub axes: Matrix3<f64>,
    /// w [m/s], q [rad/s], s \[-\], r and b \[m\].
    pub numbers: [f64; FLOW],
    /// The shaft, and the distance of Q from it.
    shaft: Option<(ShaftState, Distance)>,
    /// Axes of the disk.
    disk: Option<DiskAxes>,
    /// g [m/s].
    relative: Vector3<f64>,
    /// Angular velocity in space and relative to the frame [rad/s].
    turning: [Vector3<f64>; 2],
    /// `[Omega]x - grad V` [1/s].
    gradient: Matrix3<f64>,
}

/// Velocity of the air at a point and a time [m/s], and its derivatives by the point [1/s].
pub(super) type AirMotion<'a> = dyn Fn(&Vector3<f64>, f64) -> (Vector3<f64>, Matrix3<f64>) + 'a;

impl Mount {
    /// The quarter chord at the motion of the nodes \[m\].
    pub fn quarter_chord(&self, nodes: &[NodeMotion]) -> Vector3<f64> {
        let point = self.carrier.at(nodes).carried();
        point.position + point.rotation * self.offset
    }

    /// The shaft at the motion of the nodes; `None` without a rotor.
    pub fn shaft_at(&self, nodes: &[NodeMotion]) -> Option<ShaftState> {
        let hub = self.hub.map(|hub| &nodes[hub]);
        self.shaft.map(|shaft| shaft.at(hub))
    }

    /// The flow at a state.
    pub fn flow(&self, at: &Local<'_>, air: &AirMotion<'_>) -> Flow<'_> {
        let state = self.carrier.at(at.nodes);
        let point = state.carried();
        let arm = point.rotation * self.offset;
        let axes = point.rotation * self.axes;
        let position = point.position + arm;
        let [velocity, omega] = point.velocities(at.nodes);
        let (wind, by_position) = air(&position, at.loading.time);
        let relative = at
            .frame
            .velocity(&position, &(velocity + omega.cross(&arm)))
            - wind;
        let in_space = omega + at.frame.angular_velocity;
        let shaft = self
            .shaft_at(at.nodes)
            .map(|shaft| (shaft, shaft.distance(&position)));
        let w = axes.tr_mul(&relative);
        let (s, radius) = match &shaft {
            Some((shaft, distance)) => (axes.tr_mul(&shaft.axis), distance.radius),
            None => (Vector3::y(), 0.0),
        };
        let pitch_rate = axes.column(2).dot(&in_space);
        let in_disk = self.disk.as_ref().zip(shaft.as_ref());
        let in_disk = in_disk.map(|(disk, (shaft, distance))| {
            let axes = disk.axes(shaft);
            (axes, axes.components(&distance.from_center))
        });
        let (disk, [b, c]) = match in_disk {
            Some((axes, position)) => (Some(axes), position),
            None => (None, [0.0; 2]),
        };
        Flow {
            numbers: [w.x, w.y, w.z, pitch_rate, s.x, s.y, s.z, radius, b, c],
            disk,
            state,
            point,
            arm,
            axes,
            shaft,
            relative,
            turning: [in_space, omega],
            gradient: at.frame.skew() - by_position,
        }
    }
}

impl Flow<'_> {
    /// Angular velocity in space [rad/s].
    pub fn turning_in_space(&self) -> Vector3<f64> {
        self.turning[0]
    }

    /// Derivatives by the given variables of node `j` of the carrier.
    pub fn by_node(&self, at: &Local<'_>, j: usize) -> [(Variable, FlowBlock); 4] {
        let share = &self.point.shares[j];
        let (n, turn) = (share.weight, &share.turn);
        let arm = skew(&self.arm);
        let offset = skew(&share.offset);
        // d Q and d g by rotation; d g by position is `gradient n`.
        let position = -n * offset - arm * turn;
        let omega = &at.nodes[j].angular_velocity;
        let velocity = -n * skew_skew(omega, &share.offset)
            - skew_skew(&self.turning[1], &self.arm) * turn
            + self.gradient * position;
        let identity = n * Matrix3::identity();
        let zero = Matrix3::zeros();
        [
            (
                Variable::Position,
                self.block(&identity, &(n * self.gradient), None, &zero),
            ),
            (
                Variable::Rotation,
                self.block(&position, &velocity, Some(turn), &zero),
            ),
            (
                Variable::Velocity,
                self.block(&zero, &identity, None, &zero),
            ),
            (
                Variable::AngularVelocity,
                self.block(&zero, &(-n * (offset + arm)), None, &identity),
            ),
        ]
    }

    /// Derivatives from the derivatives of Q, g, theta and omega.
    fn block(
        &self,
        position: &Matrix3<f64>,
        velocity: &Matrix3<f64>,
        turn: Option<&Matrix3<f64>>,
        omega: &Matrix3<f64>,
    ) -> FlowBlock {
        let transposed = self.axes.transpose();
        let mut g = *velocity;
        let mut rates = *omega;
        if let Some(turn) = turn {
            g += skew_times(&self.relative, turn);
            rates += skew_times(&self.turning[0], turn);
        }
        let mut out = FlowBlock::zeros();
        out.fixed_view_mut::<3, 3>(0, 0)
            .copy_from(&(transposed * g));
        out.set_row(3, &(transposed.row(2) * rates));
        if let Some((shaft, distance)) = &self.shaft {
            if let Some(turn) = turn {
                let by_turn = transposed * skew_times(&shaft.axis, turn);
                out.fixed_view_mut::<3, 3>(4, 0).copy_from(&by_turn);
            }
            out.set_row(7, &(distance.by_point * position));
        }
        for (i, axis) in self.across().enumerate() {
            out.set_row(POSITION + i, &(axis.transpose() * position));
        }
        out
    }

    /// Axes of the disk across the shaft.
    fn across(&self) -> impl Iterator<Item = Vector3<f64>> + '_ {
        self.disk.iter().flat_map(|disk| disk.across)
    }

    /// Derivatives by the position and the rotation of the node of the shaft.
    pub fn by_hub(&self) -> [(Variable, FlowBlock); 2] {
        let mut by_position = FlowBlock::zeros();
        let mut by_rotation = FlowBlock::zeros();
        if let Some((shaft, distance)) = &self.shaft {
            by_position.set_row(7, &-distance.by_point);
            by_rotation
                .fixed_view_mut::<3, 3>(4, 0)
                .copy_from(&(-self.axes.transpose() * skew(&shaft.axis)));
            by_rotation.set_row(7, &shaft.by_turn(distance));
            for (i, axis) in self.across().enumerate() {
                by_position.set_row(POSITION + i, &-axis.transpose());
                let by_center = axis.transpose() * skew(&shaft.offset);
                by_rotation.set_row(POSITION + i, &by_center);
            }
            let turns = self.disk.iter().flat_map(|disk| disk.by_turn);
            for (i, turn) in turns.enumerate() {
                let mut row = by_rotation.row_mut(POSITION + i);
                row += distance.from_center.transpose() * turn;
            }
        }
        [
            (Variable::Position, by_position),
            (Variable::Rotation, by_rotation),
        ]
    }
}
