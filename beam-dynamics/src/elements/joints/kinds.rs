//! The rows of each kind of joint.
//!
//! Axes h, u, v: the first is the axis of the joint. With d from the point of a to the point of b,
//! and the index of the end that carries an axis, and a\* the axes of a as a drive turns them:
//!
//! | joint | rows | reactions |
//! | --- | --- | --- |
//! | clamp | d = 0; v_a . u_b, h_a . v_b, u_a . h_b | force, moment |
//! | spherical | d = 0 | force |
//! | revolute | d = 0; u_a . h_b, v_a . h_b | force, moment across h |
//! | universal | d = 0; h_a . h_b as undeformed | force, moment along h_a x h_b |
//! | cylindrical | u_a . d, v_a . d; u_a . h_b, v_a . h_b | all but those along h |
//! | prismatic | u_a . d, v_a . d; three of a clamp | all but the force along h |
//! | in-line | u_a . d, v_a . d | force across h |
//! | in-plane | h_a . d | force along h |
//! | plane rotation | u_a . h_b, v_a . h_b | moment across h |
//! | distance | (d.d/l - l)/2 | force along d |
//! | spin | angular velocity about h_a; or u_a\* . v_b | moment along h |
//! | total | any of the above, by freedoms | by freedoms |
//!
//! A driven rotation of a revolute, cylindrical or prismatic joint turns a\* by an angle
//! about h, and holds all three axes to it: regular at every angle, full turns included.
//!
//! Rotations of a total joint, by how many of the three are free: none: the three rows of a clamp
//! against a\*; one, about axis k: k_b stays at right angles to both other axes of a\*, at any
//! angle; two, i and j with k held: the rotation is k (driven), then i about an axis of a, then j
//! about one of b, a universal joint whose row `i_a* . j_b = 0` is regular wherever it is
//! fulfilled; three: none.

use nalgebra::{Matrix3, Vector3};

use super::algebra::{Carrier, Held, Row};
use super::joint::{ConstraintJoint, JointEnds, Pose, same_point};
use crate::elements::Signal;
use crate::model::Drive;

/// Treatment of one of the six relative freedoms of a joint.
#[derive(Debug, Clone, PartialEq)]
pub enum Freedom {
    /// Nothing holds it.
    Free,
    /// Held as in the undeformed model.
    Locked,
    /// It follows a signal, in m or rad.
    Driven(Signal),
}

impl Freedom {
    fn is_held(&self) -> bool {
        *self != Self::Free
    }

    /// The row of a distance, which is `now` in the undeformed model [m].
    fn row(self, held: Held, now: f64) -> Option<Row> {
        match self {
            Self::Free => None,
            Self::Locked if now == 0.0 => Some(Row::zero(held)),
            Self::Locked => Some(Row::driven(held, Drive::Constant(now))),
            Self::Driven(signal) => Some(Row::driven(held, signal)),
        }
    }

    fn signal(self) -> Signal {
        match self {
            Self::Driven(signal) => signal,
            Self::Free | Self::Locked => Drive::Constant(0.0).into(),
        }
    }
}

/// Drive of the rotation about the axis of a joint.
#[derive(Debug, Clone, PartialEq)]
pub enum Turning {
    /// By an angle of b relative to a [rad].
    Angle(Signal),
    /// By the angular velocity of b relative to a [rad/s].
    Speed(Signal),
}

/// Points and axes of a joint in the undeformed model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placing {
    /// The points on a and on b, in the model's frame [m].
    pub points: [Vector3<f64>; 2],
    /// The axes (columns) of a and of b, in the model's frame [-].
    pub axes: [Matrix3<f64>; 2],
}

impl Placing {
    /// One point and one set of axes for both ends.
    pub fn at(point: &Vector3<f64>, axes: &Matrix3<f64>) -> Self {
        Self {
            points: [*point; 2],
            axes: [*axes; 2],
        }
    }

    /// From the point of a to the point of b, along the axes of a [m].
    fn apart(&self) -> Vector3<f64> {
        let [a, b] = &self.points;
        self.axes[0].tr_mul(&(b - a))
    }

    fn poses(&self) -> [Pose; 2] {
        [0, 1].map(|end| (self.points[end], self.axes[end]))
    }
}

/// Axes with the first along `axis` (of any length but zero), the others across it.
pub fn axes_along(axis: &Vector3<f64>) -> Matrix3<f64> {
    let h = axis.normalize();
    // Across the coordinate axis farthest from h: never near zero.
    let mut other = Vector3::zeros();
    other[h.iamin()] = 1.0;
    let u = other.cross(&h).normalize();
    Matrix3::from_columns(&[h, u, h.cross(&u)])
}

/// `u_a . h_b` and `v_a . h_b`: both share the first axis.
const SAME_AXIS: [Held; 2] = [Held::Across(1, 0), Held::Across(2, 0)];
/// The three right angles of a clamp: their moments are along the axes 1, 2, 3.
const SAME_AXES: [Held; 3] = [Held::Across(2, 1), Held::Across(0, 2), Held::Across(1, 0)];

/// The right angle of a clamp that prevents rotation about an axis.
pub(super) fn about(axis: usize) -> Held {
    SAME_AXES[axis]
}

fn zero(held: impl IntoIterator<Item = Held>) -> impl Iterator<Item = Row> {
    held.into_iter().map(Row::zero)
}

fn across_the_axis() -> [Row; 2] {
    [1, 2].map(|axis| Row::zero(Held::Along(Carrier::A, axis)))
}

/// Three signals, the first of them given.
fn about_first(angle: Signal) -> [Signal; 3] {
    [
        angle,
        Drive::Constant(0.0).into(),
        Drive::Constant(0.0).into(),
    ]
}

impl ConstraintJoint {
    /// The rows `on_points`, and rows for a rotation about one axis that is free or driven.
    fn turning(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        on_points: Vec<Row>,
        turning: Option<Turning>,
    ) -> Self {
        let mut rows = on_points;
        let mut turn = None;
        match turning {
            None => rows.extend(zero(SAME_AXIS)),
            Some(Turning::Angle(angle)) => {
                rows.extend(zero(SAME_AXES));
                turn = Some(about_first(angle));
            }
            Some(Turning::Speed(speed)) => {
                rows.extend(zero(SAME_AXIS));
                rows.push(Row::driven(Held::AngularVelocity(Carrier::A, 0), speed));
            }
        }
        let joint = Self::of_rows(label, ends, at.poses(), rows).with_angle_about(0);
        match turn {
            Some(turn) => joint.turned_by(turn),
            None => joint,
        }
    }

    /// Holds b to a in position and attitude.
    pub fn clamp(label: impl Into<String>, ends: &JointEnds<'_>, at: &Placing) -> Self {
        let rows = same_point(Carrier::Frame)
            .into_iter()
            .chain(zero(SAME_AXES));
        Self::of_rows(label, ends, at.poses(), rows.collect())
    }

    /// Holds the points together.
    pub fn spherical(label: impl Into<String>, ends: &JointEnds<'_>, at: &Placing) -> Self {
        let rows = same_point(Carrier::Frame).to_vec();
        Self::of_rows(label, ends, at.poses(), rows)
    }

    /// Lets b turn relative to a about the first axis only, freely or driven.
    pub fn revolute(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        turning: Option<Turning>,
    ) -> Self {
        Self::turning(
            label,
            ends,
            at,
            same_point(Carrier::Frame).to_vec(),
            turning,
        )
    }

    /// Lets b slide along the first axis, freely or driven [m], and turn about it.
    pub fn cylindrical(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        slide: Freedom,
        turning: Option<Turning>,
    ) -> Self {
        let mut rows = across_the_axis().to_vec();
        rows.extend(slide.row(Held::Along(Carrier::A, 0), at.apart()[0]));
        Self::turning(label, ends, at, rows, turning)
    }

    /// Holds the points together and the first axis of a at its undeformed angle to the first axis
    /// of b, which must not be parallel.
    pub fn universal(label: impl Into<String>, ends: &JointEnds<'_>, at: &Placing) -> Self {
        let cosine = at.axes[0].column(0).dot(&at.axes[1].column(0));
        let mut rows = same_point(Carrier::Frame).to_vec();
        rows.push(Row::driven(Held::Across(0, 0), Drive::Constant(cosine)));
        Self::of_rows(label, ends, at.poses(), rows)
    }

    /// Lets b slide along the first axis without turning, freely or driven [m].
    pub fn prismatic(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        slide: Freedom,
    ) -> Self {
        let mut rows = across_the_axis().to_vec();
        rows.extend(slide.row(Held::Along(Carrier::A, 0), at.apart()[0]));
        rows.extend(zero(SAME_AXES));
        Self::of_rows(label, ends, at.poses(), rows)
    }

    /// Keeps the point of b on the first axis of a.
    pub fn in_line(label: impl Into<String>, ends: &JointEnds<'_>, at: &Placing) -> Self {
        Self::of_rows(label, ends, at.poses(), across_the_axis().to_vec())
    }

    /// Keeps the point of b in the plane across the first axis through the point of a, or
    /// at a driven distance from it [m].
    pub fn in_plane(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        height: Option<Signal>,
    ) -> Self {
        let held = Held::Along(Carrier::A, 0);
        let row = match height {
            None => Row::zero(held),
            Some(height) => Row::driven(held, height),
        };
        Self::of_rows(label, ends, at.poses(), vec![row])
    }

    /// Lets b turn relative to a about the first axis only, for any position of its point.
    pub fn plane_rotation(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        turning: Option<Turning>,
    ) -> Self {
        Self::turning(label, ends, at, Vec::new(), turning)
    }

    /// Keeps the points at a distance above zero [m].
    pub fn distance(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        length: impl Into<Signal>,
    ) -> Self {
        let rows = vec![Row::driven(Held::Distance, length)];
        Self::of_rows(label, ends, at.poses(), rows)
    }

    /// Drives the rotation of b relative to a about the first axis of a only: for use with a joint
    /// that holds the axis.
    pub fn spin(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        turning: Turning,
    ) -> Self {
        let (row, turn) = match turning {
            Turning::Speed(speed) => (
                Row::driven(Held::AngularVelocity(Carrier::A, 0), speed),
                None,
            ),
            Turning::Angle(angle) => (Row::zero(Held::Across(1, 2)), Some(about_first(angle))),
        };
        let joint = Self::of_rows(label, ends, at.poses(), vec![row]).with_angle_about(0);
        match turn {
            Some(turn) => joint.turned_by(turn),
            None => joint,
        }
    }

    /// Imposes velocities of the point of b along the axes of a, relative to a, and angular
    /// velocities about them; `None` if free [m/s, rad/s].
    pub fn velocity(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        rates: [Option<Signal>; 6],
    ) -> Self {
        let rows = rates.into_iter().enumerate().filter_map(|(i, rate)| {
            let held = match i {
                0..3 => Held::Velocity(Carrier::A, i),
                _ => Held::AngularVelocity(Carrier::A, i - 3),
            };
            Some(Row::driven(held, rate?))
        });
        Self::of_rows(label, ends, at.poses(), rows.collect())
    }

    /// Any of the six relative freedoms free, locked or driven: displacements of the point of b
    /// along the axes of a from the point of a, rotations about them, relative to coinciding axes:
    /// locked rotations need axes that coincide undeformed.
    pub fn total(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        at: &Placing,
        freedoms: [Freedom; 6],
    ) -> Self {
        let [x, y, z, about_x, about_y, about_z] = freedoms;
        let along = [x, y, z].into_iter().enumerate();
        let mut rows: Vec<_> = along
            .filter_map(|(i, freedom)| freedom.row(Held::Along(Carrier::A, i), at.apart()[i]))
            .collect();
        let rotations = [about_x, about_y, about_z];
        let held = [0, 1, 2].map(|i| rotations[i].is_held());
        rows.extend(zero(rotations_held(held)));
        let joint = Self::of_rows(label, ends, at.poses(), rows);
        let joint = match held {
            [false, true, true] => joint.with_angle_about(0),
            [true, false, true] => joint.with_angle_about(1),
            [true, true, false] => joint.with_angle_about(2),
            _ => joint,
        };
        if rotations
            .iter()
            .any(|freedom| matches!(freedom, Freedom::Driven(_)))
        {
            joint.turned_by(rotations.map(Freedom::signal))
        } else {
            joint
        }
    }
}

/// Right angles that constrain the given rotations.
fn rotations_held(held: [bool; 3]) -> Vec<Held> {
    let free: Vec<_> = (0..3).filter(|&axis| !held[axis]).collect();
    match free[..] {
        [axis] => vec![
            Held::Across((axis + 1) % 3, axis),
            Held::Across((axis + 2) % 3, axis),
        ],
        _ => (0..3)
            .filter(|&axis| held[axis])
            .map(|axis| SAME_AXES[axis])
            .collect(),
    }
}
