//! The keys of `[trim]`.

use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{
    Count, Drive, NotNegative, Positive, Quantity, Table, Tables, Text, Word,
};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::super::sweep::TRIM_SWEEP;

/// Largest number of iterations, harmonics or steps.
const MOST: usize = 100_000;

keys! {
    /// Numbers that are found so that quantities have given values.
    pub(in crate::input) TRIM = "[trim]";
    /// By Newton's method for the periodic motion, by an auto-pilot while the periodic motion is
    /// integrated, or in the equilibrium of the turning frame.
    pub(super) METHOD: usize = "method", [Word(&["shooting", "autopilot", "equilibrium"])],
        or "\"shooting\"" = 0, "\"equilibrium\"";
    /// Rotor speed of the equilibrium.
    pub(super) SPEED: f64 = "speed", [NotNegative(Dimension::ROTATION_SPEED)], or "0" = 0.0, "300";
    /// Largest error of the targets of parameters and of an auto-pilot, relative to their `scale`.
    pub(super) TOLERANCE: f64 = "tolerance", [Positive(Dimension::NUMBER)], or "1e-6" = 1e-6, "1e-4";
    /// Largest number of iterations for controls that are parameters.
    pub(super) ITERATIONS: usize = "iterations", [Count(MOST)], or "30" = 30, "60";
    /// Gain of the auto-pilot per period.
    pub(super) GAIN: f64 = "gain", [Positive(Dimension::NUMBER)], or "0.3" = 0.3, "0.15";
    /// Time constant of the filter of the auto-pilot, in periods.
    pub(super) FILTER: f64 = "filter", [Positive(Dimension::NUMBER)], or "1" = 1.0, "3";
    /// The numbers.
    pub(super) CONTROL: ByHand = "control", [Tables(&CONTROL_CARD)], required, "";
    /// The values of quantities, one for each control.
    pub(super) TARGET: ByHand = "target", [Tables(&TARGET_CARD)], required, "";
    /// Values of a parameter at which the trim is found.
    pub(super) SWEEP: ByHand = "sweep", [Table(&TRIM_SWEEP)], optional, "";
}

keys! {
    /// A number that is found: a new name, which expressions read, constant in time; or one of the
    /// `[parameters]`, whose value is the first guess.
    CONTROL_CARD = "[[trim.control]]";
    /// Its name.
    pub(super) NAME: String = "name", [Text], required, "\"collective\"";
    /// First guess, and its value in runs in time.
    pub(super) GUESS: f64 = "guess", [Quantity(Dimension::NUMBER)], or "0" = 0.0, "8";
    /// Size relative to which changes are measured.
    pub(super) SCALE: f64 = "scale", [Positive(Dimension::NUMBER)], or "1" = 1.0, "0.1";
    /// Least value.
    pub(super) LOWER: Option<f64> = "lower", [Quantity(Dimension::NUMBER)], optional, "-5";
    /// Largest value.
    pub(super) UPPER: Option<f64> = "upper", [Quantity(Dimension::NUMBER)], optional, "20";
    /// Largest change in an iteration.
    pub(super) STEP: Option<f64> = "step", [Positive(Dimension::NUMBER)], optional, "5";
}

keys! {
    /// A quantity that has a given value: of a motion the mean over the period, or the factor of the
    /// cosine or sine of a harmonic.
    TARGET_CARD = "[[trim.target]]";
    /// Its name.
    pub(super) TARGET_NAME: String = "name", [Text], required, "\"thrust\"";
    /// The quantity: a sensor or an output, or an expression of these.
    pub(super) SIGNAL: ByHand = "signal", [Drive(Dimension::NUMBER)], required, "\"= thrust/weight\"";
    /// The value.
    pub(super) VALUE: f64 = "value", [Quantity(Dimension::NUMBER)], required, "700";
    /// Size relative to which its error is measured.
    pub(super) TARGET_SCALE: f64 = "scale", [Positive(Dimension::NUMBER)], or "1" = 1.0, "700";
    /// Harmonic of a revolution, or without rotor speed of the period, in place of the mean.
    pub(super) HARMONIC: usize = "harmonic", [Count(MOST)], or "the mean" = 0, "1";
    /// Factor of the cosine or of the sine, from the first instant of the period.
    pub(super) PART: usize = "part", [Word(&["cosine", "sine"])], or "\"cosine\"" = 0, "\"sine\"";
}
