//! Reports of a strip: its flow and loads for output, and its parts of the thrust, torque and power
//! of the rotor as readings; its other quantities are in [`super::quantity`].
//!
//! With the center c and the direction n of the shaft, the forces F_j and moments M_j on the nodes
//! at x_j, the parts of thrust and torque and their variations are
//!
//! ```text
//! T   = n . sum F_j                Q   = n . sum ((x_j - c) x F_j + M_j)
//! d T = n . sum dF_j + theta_h . (n x sum F_j)
//! d Q = sum ((n x (x_j - c)) . dF_j + n . dM_j + (F_j x n) . dx_j) - (sum F_j x n) . dc
//!       + theta_h . (n x sum ((x_j - c) x F_j + M_j))
//! ```
//!
//! and with the angular velocity W in space of the hub, or without a hub of the section,
//! `W = sum N_j W_j`,
//!
//! ```text
//! P   = Q n . W                  d P = n . W dQ + Q (n . dW + theta_h . (n x W))
//! ```

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::Vector3;

use super::kinematics::Flow;
use super::shaft::ShaftState;
use super::strip::AirStrip;
use crate::elements::{
    AirState, Charges, Element, Local, LocalResidual, LocalSize, Observations, Reading, ReadingRow,
    Reports, RotorMotion, RotorSum,
};
use crate::model::{Equation, NodeMotion, Variable};

impl AirStrip {
    /// Flow and loads at a state.
    fn state(&self, at: &Local<'_>) -> AirState {
        let carrier = self.carrier(at);
        let flow = self.flow(&carrier, at);
        let numbers = self.numbers(&flow, at);
        let states = self.states();
        let (values, rates) = (&at.scalars.values[..states], &at.scalars.rates[..states]);
        let report = self.strip.report(self.acting(at), &numbers, values, rates);
        let position = flow.point.position + flow.arm;
        let per_length = flow.axes * Vector3::from(report.force);
        let force = per_length * self.length;
        let own = flow.axes.column(2) * (report.moment * self.length);
        let shaft = self.mount.shaft_at(at.nodes);
        let from_center = position - shaft.map_or_else(Vector3::zeros, |shaft| shaft.center);
        let (radius, azimuth, tangent) = match &shaft {
            Some(shaft) => (
                shaft.distance(&position).radius,
                azimuth(&shaft.axis, &self.location.zero, &from_center),
                shaft.axis.cross(&from_center),
            ),
            None => (f64::NAN, f64::NAN, flow.axes.column(0).into_owned()),
        };
        let tangent = tangent.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        AirState {
            location: Arc::clone(&self.location),
            radius,
            azimuth,
            position,
            flow: report,
            attached: self.strip.attached(report.alpha),
            tangential: per_length.dot(&tangent),
            force,
            moment: from_center.cross(&force) + own,
            rotor: shaft.map(|shaft| self.rotor(&shaft, &flow, at)),
        }
    }

    /// Its rotor at a state.
    fn rotor(&self, shaft: &ShaftState, flow: &Flow<'_>, at: &Local<'_>) -> RotorMotion {
        let hub = self.mount.hub.map(|hub| &at.nodes[hub]);
        RotorMotion {
            axis: shaft.axis,
            turning: self.turning(flow, at).dot(&shaft.axis),
            velocity: self.velocity_of_center(shaft, hub, at),
            tip_radius: at.scalars.values[self.states()],
            density: self.air.atmosphere.density,
        }
    }

    /// W, of the hub or of the section [rad/s].
    fn turning(&self, flow: &Flow<'_>, at: &Local<'_>) -> Vector3<f64> {
        match self.mount.hub {
            Some(hub) => at.nodes[hub].angular_velocity_in_space(at.frame),
            None => flow.turning_in_space(),
        }
    }

    /// Velocity of the center of the shaft against the air without induction [m/s].
    fn velocity_of_center(
        &self,
        shaft: &ShaftState,
        hub: Option<&NodeMotion>,
        at: &Local<'_>,
    ) -> Vector3<f64> {
        let own = hub.map_or_else(Vector3::zeros, |hub| {
            hub.velocity + hub.angular_velocity.cross(&(shaft.center - hub.position))
        });
        let (wind, _) = self.air.motion(&shaft.center, at.loading.time);
        at.frame.velocity(&shaft.center, &own) - wind
    }

    /// The part of the thrust, the torque or the power.
    fn sum(&self, of: RotorSum, at: &Local<'_>, row: Option<&mut ReadingRow<'_>>) -> Option<f64> {
        let shaft = self.mount.shaft_at(at.nodes)?;
        let mut forces = LocalResidual::new(LocalSize::of(self));
        self.evaluate(at, &mut forces, None);
        let mut sum = Vector3::zeros();
        for j in 0..self.mount.carrier.nodes() {
            let force = forces.of(j, Equation::Force);
            sum += match of {
                RotorSum::Thrust => force,
                RotorSum::Torque | RotorSum::Power => {
                    let arm = at.nodes[j].position - shaft.center;
                    arm.cross(&force) + forces.of(j, Equation::Moment)
                }
            };
        }
        let along = shaft.axis.dot(&sum);
        if of != RotorSum::Power {
            let side = match of {
                RotorSum::Thrust => self.location.side,
                _ => 1.0,
            };
            if let Some(row) = row {
                self.add_slope((of, side), at, (&shaft, &forces, &sum), row);
            }
            return Some(side * along);
        }
        let carrier = self.carrier(at);
        let flow = self.flow(&carrier, at);
        let turning = self.turning(&flow, at);
        let speed = turning.dot(&shaft.axis);
        if let Some(row) = row {
            self.add_slope((of, speed), at, (&shaft, &forces, &sum), row);
            self.add_by_speed((&shaft.axis, &turning, along), &flow, row);
        }
        Some(along * speed)
    }

    /// Adds the derivatives `Q d(n . W)` of the power.
    fn add_by_speed(
        &self,
        (axis, turning, torque): (&Vector3<f64>, &Vector3<f64>, f64),
        flow: &Flow<'_>,
        row: &mut ReadingRow<'_>,
    ) {
        let slope = axis * torque;
        if let Some(hub) = self.mount.hub {
            row.by_node(hub, Variable::AngularVelocity, &slope);
            row.by_node(hub, Variable::Rotation, &(axis.cross(turning) * torque));
            return;
        }
        for (j, share) in flow.point.shares().iter().enumerate() {
            row.by_node(j, Variable::AngularVelocity, &(slope * share.weight));
        }
    }

    /// Adds `factor` times the derivatives of the part of the thrust or the torque, whose vector is
    /// `sum` [N, N m].
    fn add_slope(
        &self,
        (of, factor): (RotorSum, f64),
        at: &Local<'_>,
        (shaft, forces, sum): (&ShaftState, &LocalResidual, &Vector3<f64>),
        row: &mut ReadingRow<'_>,
    ) {
        let n = shaft.axis * factor;
        let mut total = Vector3::zeros();
        for j in 0..self.mount.carrier.nodes() {
            let force = forces.of(j, Equation::Force);
            total += force;
            match of {
                RotorSum::Thrust => row.by_equation(j, Equation::Force, &n),
                RotorSum::Torque | RotorSum::Power => {
                    let arm = at.nodes[j].position - shaft.center;
                    row.by_equation(j, Equation::Force, &n.cross(&arm));
                    row.by_equation(j, Equation::Moment, &n);
                    row.by_node(j, Variable::Position, &force.cross(&n));
                }
            }
        }
        let Some(hub) = self.mount.hub else { return };
        let mut by_turn = n.cross(sum);
        if of != RotorSum::Thrust {
            let along = total.cross(&n);
            let offset = shaft.center - at.nodes[hub].position;
            row.by_node(hub, Variable::Position, &-along);
            by_turn -= offset.cross(&along);
        }
        row.by_node(hub, Variable::Rotation, &by_turn);
    }
}

/// Angle about an axis from the projection of a direction to the projection of a vector, from zero
/// to a full turn \[rad\].
fn azimuth(axis: &Vector3<f64>, zero: &Vector3<f64>, vector: &Vector3<f64>) -> f64 {
    let across = zero - axis * axis.dot(zero);
    let angle = axis.cross(&across).dot(vector).atan2(across.dot(vector));
    // The remainder of a tiny negative angle is a full turn.
    let turned = angle.rem_euclid(TAU);
    if turned < TAU { turned } else { 0.0 }
}

impl Reports for AirStrip {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        out.air.push(self.state(at));
    }

    fn reading(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        match *reading {
            Reading::Rotor(of) => self.sum(of, at, row),
            Reading::Strip(quantity, weight) => self.quantity((quantity, weight), at, row),
            _ => None,
        }
    }

    fn report_charges(&self, _at: &Local<'_>, _out: &mut Charges) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counterclockwise about z from x; the component along the axis is left out.
    #[test]
    fn azimuths_are_about_the_axis() {
        let (axis, zero) = (Vector3::z(), Vector3::new(1.0, 0.0, 3.0));
        for (vector, degrees) in [
            ([2.0, 0.0, 5.0], 0.0),
            ([0.0, 3.0, 0.0], 90.0),
            ([-1.0, -1.0, 0.0], 225.0),
            ([1.0, -1e-30, 0.0], 0.0),
        ] {
            let found = azimuth(&axis, &zero, &Vector3::from(vector)).to_degrees();
            assert!((found - degrees).abs() < 1e-12, "{found}");
        }
        let found = azimuth(&-axis, &zero, &Vector3::y()).to_degrees();
        assert!((found - 270.0).abs() < 1e-12, "{found}");
    }
}
