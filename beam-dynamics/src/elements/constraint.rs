//! What elements tell of their constraints in motion, and of energy.

/// The highest derivative of the unknowns' motion that a constraint holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// `Phi(x, R, t) = 0`: positions and rotations.
    Position,
    /// `Phi(x, R, v, omega, t) = 0`: velocities and angular velocities.
    Velocity,
}

/// A constraint of an element and its multiplier in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConstraintWords {
    /// What it holds: `offset along y of axes a`.
    pub held: String,
    /// In which unit that counts.
    pub unit: &'static str,
    /// What its multiplier is: `force along y of axes a`.
    pub reaction: String,
    /// In which unit the multiplier counts.
    pub reaction_unit: &'static str,
}

impl ConstraintWords {
    /// Those of a constraint of which no more is known than its number, from zero.
    pub fn numbered(constraint: usize) -> Self {
        let number = constraint + 1;
        Self {
            held: format!("constraint {number}"),
            unit: "-",
            reaction: format!("multiplier {number}"),
            reaction_unit: "-",
        }
    }
}

/// A jump of what a drive holds in place.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaceJump {
    /// What is held, in words.
    pub what: String,
    /// Its value before the jump [`Self::unit`].
    pub from: f64,
    /// Its value after the jump [`Self::unit`].
    pub to: f64,
    /// The unit of both.
    pub unit: &'static str,
}

/// How the constraints of an element change by themselves.
///
/// With `Phi_y` the derivatives by spatial variations of position and rotation, the
/// velocities v, omega and the accelerations a, alpha relative to the frame, a
/// constraint of positions fulfills
///
/// ```text
/// Phi'  = Phi_y [v; omega] + by_time            = 0
/// Phi'' = Phi_y [a; alpha] + convective         = 0
/// ```
///
/// and one of velocities, with `Phi_y'` its derivatives by v and omega,
///
/// ```text
/// Phi'  = Phi_y' [a; alpha] + convective        = 0      (by_time stays zero)
/// ```
#[derive(Debug)]
pub struct ConstraintRates<'a> {
    /// `d Phi / d t` at fixed positions and rotations [unit of the constraint/s].
    pub by_time: &'a mut [f64],
    /// What is left of the last derivative without accelerations [unit of it].
    pub convective: &'a mut [f64],
}
