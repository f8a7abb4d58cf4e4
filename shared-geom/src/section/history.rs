//! Changes of section properties after their computation.

use std::fmt;

use nalgebra::Vector2;

use super::SectionProperties;
use crate::figure::tick_label;

/// A change of point or axes, and the program that made it.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// The change.
    pub change: Change,
    /// Name of the program.
    pub program: String,
    /// Version of the program.
    pub version: String,
}

/// A change of point or axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// The reference point moved by (y, z), in the axes at that step \[m\].
    Shift(Vector2<f64>),
    /// The axes turned about +x \[rad\].
    Rotate(f64),
}

impl SectionProperties {
    /// The same section after a change, which its provenance records as made by `program`
    /// of `version`.
    pub fn changed(&self, change: Change, program: &str, version: &str) -> Self {
        let mut changed = match change {
            Change::Shift(by) => self.shift(by),
            Change::Rotate(angle) => self.rotate(angle),
        };
        changed.provenance.history.push(Step {
            change,
            program: program.to_owned(),
            version: version.to_owned(),
        });
        changed
    }
}

/// As text, with six digits.
impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shift(by) => {
                let (y, z) = (tick_label(by.x, 0.0), tick_label(by.y, 0.0));
                write!(f, "reference point moved by ({y}, {z}) m")
            }
            Self::Rotate(angle) => {
                let degrees = tick_label(angle.to_degrees(), 0.0);
                write!(f, "axes turned by {degrees} deg about +x")
            }
        }
    }
}
