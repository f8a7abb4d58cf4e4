//! Constraints of elements in motion.

/// The highest derivative of the motion of the unknowns that a constraint contains.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// `Phi(x, R, t) = 0`: positions and rotations.
    Position,
    /// `Phi(x, R, v, omega, t) = 0`: velocities and angular velocities.
    Velocity,
}

/// A constraint of an element and its multiplier, as text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConstraintWords {
    /// The constrained quantity: `offset along y of axes a`.
    pub held: String,
    /// The unit of the constraint.
    pub unit: &'static str,
    /// The meaning of the multiplier: `force along y of axes a`.
    pub reaction: String,
    /// The unit of the multiplier.
    pub reaction_unit: &'static str,
}

impl ConstraintWords {
    /// Texts of a constraint of which only the index is known, from zero.
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

/// A jump of a position or an attitude that a drive prescribes.
#[derive(Debug, Clone, PartialEq)]
pub struct PositionJump {
    /// The prescribed quantity, as text.
    pub what: String,
    /// Its value before the jump, in [`Self::unit`].
    pub from: f64,
    /// Its value after the jump, in [`Self::unit`].
    pub to: f64,
    /// The unit of both.
    pub unit: &'static str,
}

/// Rates of the constraints of an element at given motion.
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
    /// Terms of the last derivative without accelerations [unit of it].
    pub convective: &'a mut [f64],
}
