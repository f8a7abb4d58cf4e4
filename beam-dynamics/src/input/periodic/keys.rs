//! The keys of `[periodic]`.

use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{
    Boolean, Count, Positive, Quantities, Quantity, Table, Word,
};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::super::transient::{FROM, REDUNDANT, START};

/// Largest number of steps in a period.
const MOST_STEPS: usize = 1_000_000;
/// Largest number of periods or iterations.
const MOST_PERIODS: usize = 10_000_000;
/// Largest number of harmonics.
const MOST_HARMONICS: usize = 100_000;
/// Largest number of multipliers: the dimension of their space.
const MOST_MULTIPLIERS: usize = 400;

keys! {
    /// Motion that repeats after a period, and its stability.
    pub(in crate::input) PERIODIC = "[periodic]";
    /// The period; or `speed`; without both it is a revolution of the first `[[rotor]]`, or `revolutions`.
    pub(super) PERIOD: Option<f64> = "period", [Positive(Dimension::TIME)], optional, "0.2";
    /// Speed of the rotor: the period is one revolution, or `revolutions`. With
    /// `start = "rotating"` it is the speed of the start, too.
    pub(super) SPEED: Option<f64> = "speed", [Quantity(Dimension::ROTATION_SPEED)], optional, "300";
    /// Revolutions in a period.
    pub(super) REVOLUTIONS: usize = "revolutions", [Count(MOST_STEPS)], or "1" = 1, "2";
    /// Equal steps in a period.
    pub(super) STEPS: usize = "steps", [Count(MOST_STEPS)], or "96" = 96, "48";
    /// Stages of a step of Radau IIA: errors of exponents decrease with the fifth power of the step
    /// with three stages, with the third with two.
    pub(super) STAGES: usize = "stages", [Word(&["three", "two"])], or "\"three\"" = 0, "\"two\"";
    /// By Newton's method for the first state, or by period after period.
    pub(super) METHOD: usize = "method", [Word(&["shooting", "march"])], or "\"shooting\"" = 0,
        "\"march\"";
    /// Largest change in a period: relative to the size of the model, in radians, relative to momenta
    /// of the size of the model moving in a period, and to the sizes of scalars. At least 1e-13, the round-off.
    pub(super) TOLERANCE: f64 = "tolerance", [Positive(Dimension::NUMBER)], or "1e-9" = 1e-9,
        "1e-7";
    /// Largest number of Newton iterations.
    pub(super) ITERATIONS: usize = "iterations", [Count(MOST_PERIODS)], or "20" = 20, "40";
    /// Largest number of periods of `march`.
    pub(super) PERIODS: usize = "periods", [Count(MOST_PERIODS)], or "1000" = 1000, "5000";
    /// Periods that are marched before `shooting`.
    pub(super) SETTLE: usize = "settle", [Count(MOST_PERIODS)], or "1" = 1, "5";
    /// Harmonics of the columns.
    pub(super) HARMONICS: usize = "harmonics", [Count(MOST_HARMONICS)], or "8" = 8, "4";
    /// Multipliers, exponents and frequencies of small motions about the periodic one.
    pub(super) FLOQUET: ByHand = "floquet", [Table(&FLOQUET_TABLE)], optional, "";
    with FROM.schema, START.schema, REDUNDANT.schema;
}

keys! {
    /// Stability of the periodic motion.
    FLOQUET_TABLE = "[periodic.floquet]";
    /// Multipliers, the largest first; a pair counts as two.
    pub(super) COUNT: usize = "count", [Count(MOST_MULTIPLIERS)], or "20" = 20, "6";
    /// Frequencies nearest to which the exponents are shown, instead of the frequency of the largest
    /// motion in the fixed frame.
    pub(super) NEAR: Option<Vec<f64>> = "near", [Quantities(Dimension::FREQUENCY)], optional,
        "[\"1.2 Hz\", \"3 Hz\"]";
    /// Whether to estimate the errors of the exponents by an analysis with half the steps.
    pub(super) ERROR: bool = "error_estimate", [Boolean], or "true" = true, "false";
}
