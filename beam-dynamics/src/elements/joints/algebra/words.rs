//! Texts of the constraints and their multipliers.
//!
//! Axes a and b are the axes of the joint that move with its ends; x is the axis of a joint that
//! has one. The undeformed axes are fixed in the frame.

use super::{Carrier, Held};
use crate::elements::ConstraintWords;

const AXES: [&str; 3] = ["x", "y", "z"];

impl Held {
    /// The constraint and its multiplier, as text.
    pub fn words(self) -> ConstraintWords {
        let (held, unit, reaction, reaction_unit) = match self {
            Self::Along(carrier, axis) => {
                let direction = along(carrier, axis);
                (format!("offset {direction}"), "m", direction, "N")
            }
            Self::Velocity(carrier, axis) => {
                let direction = along(carrier, axis);
                (format!("velocity {direction}"), "m/s", direction, "N")
            }
            Self::Distance => {
                let held = "distance of the points".to_owned();
                (held, "m", "along the line of the points".to_owned(), "N")
            }
            Self::Across(a, b) => match third(a, b) {
                Some(axis) => {
                    let direction = format!("about {} of axes a", AXES[axis]);
                    (format!("rotation {direction}"), "rad", direction, "N m")
                }
                None => {
                    let (a, b) = (AXES[a], AXES[b]);
                    let held = format!("cosine of the angle between {a} of a and {b} of b");
                    (held, "-", format!("across {a} of a and {b} of b"), "N m")
                }
            },
            Self::AngularVelocity(carrier, axis) => {
                let direction = format!("about {} of {}", AXES[axis], axes(carrier));
                let held = format!("angular velocity {direction}");
                (held, "rad/s", direction, "N m")
            }
        };
        let what = match reaction_unit {
            "N" => "force",
            _ => "moment",
        };
        ConstraintWords {
            held,
            unit,
            reaction: format!("{what} {reaction}"),
            reaction_unit,
        }
    }
}

fn along(carrier: Carrier, axis: usize) -> String {
    format!("along {} of {}", AXES[axis], axes(carrier))
}

fn axes(carrier: Carrier) -> &'static str {
    match carrier {
        Carrier::Frame => "the undeformed axes",
        Carrier::A => "axes a",
        Carrier::B => "axes b",
    }
}

/// The axis across two axes constrained to a right angle: the couple is about it.
fn third(a: usize, b: usize) -> Option<usize> {
    (a != b).then(|| 3 - a - b)
}
