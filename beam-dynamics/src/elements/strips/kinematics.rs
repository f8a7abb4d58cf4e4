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
//! d w = R_a^T (d g + [g]x theta)                 d q = e_z . R_a^T (d omega + [omega + Omega]x theta)
//! d b_i = e_i . d(Q - c) + d . d e_i              (in a disk with the axes e_i)
//! d s = R_a^T ([n]x theta - [n]x theta_h)        d r = [(d - n (n . d)) . d(Q - c) - (n . d) d . d n] / r
//! ```
//!
//! References: [Masarati], 5.9.

use std::sync::Arc;

use nalgebra::{Matrix3, RowVector3, Vector3};
use shared_geom::rotation::{product, skew, skew_skew};

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
/// Index of r.
const RADIUS: usize = 7;
/// Index of the first component of b.
const POSITION: usize = 8;

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
    pub state: &'a CarrierState<'a>,
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

    /// The flow at a state of the carrier.
    pub fn flow<'a>(
        &self,
        state: &'a CarrierState<'a>,
        at: &Local<'_>,
        air: &AirMotion<'_>,
    ) -> Flow<'a> {
        let point = state.carried();
        let arm = point.rotation * self.offset;
        let axes = product(&point.rotation, &self.axes);
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

    /// Angular velocity relative to the frame [rad/s].
    pub fn turning(&self) -> &Vector3<f64> {
        &self.turning[1]
    }

    /// `[Omega]x - grad V` [1/s].
    pub fn gradient(&self) -> &Matrix3<f64> {
        &self.gradient
    }

    /// Derivatives by Q, g, theta and omega of a quantity with derivatives `by` the numbers.
    pub fn slopes(&self, by: &[f64; FLOW]) -> [RowVector3<f64>; 4] {
        let velocity = self.axes * Vector3::new(by[0], by[1], by[2]);
        let omega = self.axes.column(2) * by[3];
        let mut turn = velocity.cross(&self.relative) + omega.cross(&self.turning[0]);
        if let Some((shaft, _)) = &self.shaft {
            turn += self.of_shaft(by).cross(&shaft.axis);
        }
        let rows = [velocity, turn, omega].map(|it| it.transpose());
        [self.by_point(by), rows[0], rows[1], rows[2]]
    }

    /// Derivatives by the variables of node `j` of the carrier, of a quantity with these derivatives
    /// by Q, g, theta and omega.
    pub fn by_node(
        &self,
        at: &Local<'_>,
        j: usize,
        [point, velocity, turn, omega]: &[RowVector3<f64>; 4],
    ) -> [(Variable, RowVector3<f64>); 4] {
        let share = &self.point.shares[j];
        let (n, offset) = (share.weight, &share.offset);
        let position = point + velocity * self.gradient;
        let turned = skew_skew(&self.turning[1], &self.arm);
        let axes = turn - position * skew(&self.arm) - velocity * turned;
        let node = skew_skew(&at.nodes[j].angular_velocity, offset);
        let by_omega = omega - velocity * skew(&(offset + self.arm));
        let by_offset = position * skew(offset) + velocity * node;
        [
            (Variable::Position, n * position),
            (Variable::Velocity, n * velocity),
            (Variable::AngularVelocity, n * by_omega),
            (Variable::Rotation, axes * share.turn - n * by_offset),
        ]
    }

    /// The derivative by s, model axes.
    fn of_shaft(&self, by: &[f64; FLOW]) -> Vector3<f64> {
        self.axes * Vector3::new(by[SHAFT], by[SHAFT + 1], by[SHAFT + 2])
    }

    /// The derivative by Q, through r and b.
    fn by_point(&self, by: &[f64; FLOW]) -> RowVector3<f64> {
        let mut point = RowVector3::zeros();
        if let Some((_, distance)) = &self.shaft {
            point += distance.by_point * by[RADIUS];
        }
        for (axis, slope) in self.across().zip(&by[POSITION..]) {
            point += axis.transpose() * *slope;
        }
        point
    }

    /// Axes of the disk across the shaft.
    fn across(&self) -> impl Iterator<Item = Vector3<f64>> + '_ {
        self.disk.iter().flat_map(|disk| disk.across)
    }

    /// Derivatives of r and b by the rotation of the node of the shaft.
    pub fn by_turn_of_hub(&self) -> [RowVector3<f64>; FLOW - RADIUS] {
        let mut by = [RowVector3::zeros(); FLOW - RADIUS];
        let Some((shaft, distance)) = &self.shaft else {
            return by;
        };
        by[0] = shaft.by_turn(distance);
        let turns = self.disk.iter().flat_map(DiskAxes::by_turn);
        for ((by, axis), turn) in by[1..].iter_mut().zip(self.across()).zip(turns) {
            *by = axis.cross(&shaft.offset).transpose() + distance.from_center.transpose() * turn;
        }
        by
    }

    /// Derivatives by the position and the rotation of the node of the shaft, with the ones of
    /// [`Self::by_turn_of_hub`].
    pub fn slopes_by_hub(
        &self,
        by: &[f64; FLOW],
        by_turn: &[RowVector3<f64>; FLOW - RADIUS],
    ) -> [RowVector3<f64>; 2] {
        let Some((shaft, _)) = &self.shaft else {
            return [RowVector3::zeros(); 2];
        };
        let mut turn = -self.of_shaft(by).cross(&shaft.axis).transpose();
        for (by_turn, slope) in by_turn.iter().zip(&by[RADIUS..]) {
            turn += by_turn * *slope;
        }
        [-self.by_point(by), turn]
    }
}
