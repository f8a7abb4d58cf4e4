//! Jumps of positions or attitudes that the drives of a joint prescribe: no motion can follow them.

use nalgebra::Vector3;
use shared_geom::rotation::vector;

use super::{ConstraintJoint, by_axis};
use crate::elements::joints::algebra::Held;
use crate::elements::{Instant, PositionJump};
use crate::model::{DriveValue, Loading, Scalars};

/// Changes of the value of a drive between two instants, beyond its rate, that are ignored:
/// relative (round-off) and absolute [m, rad].
const ROUND_OFF: f64 = 1e-9;
const NEXT_TO_NOTHING: f64 = 1e-12;

/// Whether a number jumps between two instants `delay` \[s\] apart, beyond the change by its rate.
fn jumps([from, to]: [DriveValue; 2], delay: f64) -> bool {
    let carried = 2.0 * delay * (from.rate.abs() + to.rate.abs());
    let round_off = ROUND_OFF * from.value.abs().max(to.value.abs());
    (to.value - from.value).abs() > carried.max(round_off).max(NEXT_TO_NOTHING)
}

impl ConstraintJoint {
    /// The first jump of a position or of an attitude between two instants.
    pub(super) fn position_jump(
        &self,
        between: [&Loading; 2],
        scalars: Scalars<'_>,
    ) -> Option<PositionJump> {
        let delay = between[1].time - between[0].time;
        let now = |at: &Loading| Instant {
            time: at.time,
            scalars,
        };
        let positions = self.rows.iter().filter_map(|row| {
            let target = row.target.as_ref()?;
            let what = match row.held {
                Held::Along(_, axis) => {
                    format!("displacement along its {}", ["x", "y", "z"][axis % 3])
                }
                Held::Distance => "length".to_owned(),
                Held::Across(..) | Held::Velocity(..) | Held::AngularVelocity(..) => return None,
            };
            let held = between.map(|at| target.at(&now(at)).times(self.scale(at, &now(at))));
            jumps(held, delay).then(|| PositionJump {
                what,
                from: held[0].value,
                to: held[1].value,
                unit: "m",
            })
        });
        let mut positions = positions;
        positions.next().or_else(|| {
            let turn = self.turn.as_ref()?;
            let turned = between.map(|at| by_axis(turn, &now(at), &self.scale(at, &now(at))));
            self.attitude_jump(&turned, delay)
        })
    }

    /// Whole turns are no jump.
    fn attitude_jump(&self, turned: &[[Vector3<f64>; 3]; 2], delay: f64) -> Option<PositionJump> {
        let [from, to] = turned.map(|[phi, ..]| vector::to_rotation(&phi));
        let off = vector::from_rotation(&(from.transpose() * to)).norm();
        let rates = turned[0][1].norm() + turned[1][1].norm();
        let round_off = ROUND_OFF * turned[0][0].norm().max(turned[1][0].norm());
        if off <= (2.0 * delay * rates).max(round_off).max(NEXT_TO_NOTHING) {
            return None;
        }
        let axis = (turned[1][0] - turned[0][0]).iamax();
        let what = match self.angle_about {
            Some(about) if about == axis => "angle".to_owned(),
            _ => format!("rotation about its axis {}", axis + 1),
        };
        Some(PositionJump {
            what,
            from: turned[0][0][axis].to_degrees(),
            to: turned[1][0][axis].to_degrees(),
            unit: "deg",
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "test helpers")]

    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::elements::Queries;
    use crate::elements::joints::{Freedom, JointEnds, Placing, Turning};
    use crate::model::{Drive, Node, Ramp, Step};

    fn step(to: f64) -> Drive {
        Drive::Step(Step {
            from: 0.0,
            to,
            time: 0.5,
        })
    }

    fn ramp() -> Drive {
        Drive::Ramp(Ramp {
            from: 0.0,
            to: 3.0,
            start: 0.5,
            end: 0.6,
            smooth: false,
        })
    }

    fn reported(joint: &ConstraintJoint) -> Option<String> {
        let at = |time: f64| Loading {
            time,
            ..Loading::none()
        };
        let jump = joint.jump([&at(0.5_f64.next_down()), &at(0.5)], Scalars::NONE)?;
        let PositionJump {
            what,
            from,
            to,
            unit,
        } = jump;
        Some(format!("{what} {from:.3} {to:.3} {unit}"))
    }

    #[test]
    fn steps_of_positions_are_reported_and_ramps_and_whole_turns_are_not() {
        let node = Node {
            label: "b".to_owned(),
            position: Vector3::x(),
            rotation: Matrix3::identity(),
        };
        let ends = JointEnds {
            a: None,
            b: (0, &node),
        };
        let at = Placing::at(&node.position, &Matrix3::identity());
        let angle = |drive: Drive| {
            let turning = Some(Turning::Angle(drive.into()));
            reported(&ConstraintJoint::revolute("hinge", &ends, &at, turning))
        };
        assert_eq!(angle(step(0.5)).unwrap(), "angle 0.000 28.648 deg");
        assert_eq!(angle(ramp()), None);
        assert_eq!(angle(step(4.0 * std::f64::consts::PI)), None);
        let slide = |drive: Drive| {
            let slide = Freedom::Driven(drive.into());
            reported(&ConstraintJoint::prismatic("guide", &ends, &at, slide))
        };
        let expected = "displacement along its x 0.000 -0.010 m";
        assert_eq!(slide(step(-0.01)).unwrap(), expected);
        assert_eq!(slide(ramp()), None);
        // A jump of a velocity is an impulse, not a jump of positions.
        let speed = Some(Turning::Speed(step(1.0).into()));
        let wheel = ConstraintJoint::revolute("wheel", &ends, &at, speed);
        assert_eq!(reported(&wheel), None);
    }
}
