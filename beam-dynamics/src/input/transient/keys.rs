//! The keys of `[transient]`.

use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{
    Count, NotNegative, Positive, Quantity, Table, Word,
};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::{MOST_ITERATIONS, MOST_MODES, SCHEMES};

keys! {
    /// The motion of the model in time.
    pub(in crate::input) TRANSIENT = "[transient]";
    /// First instant.
    pub(in crate::input) FROM: f64 = "from", [Quantity(Dimension::TIME)], or "0" = 0.0, "1";
    /// Last instant.
    pub(super) TO: f64 = "to", [Quantity(Dimension::TIME)], required, "2";
    /// Length of the steps, shortened if the iteration fails; or steps by the local error.
    pub(super) STEP: f64 = "step", [Positive(Dimension::TIME), Table(&VARIABLE_STEP)], required,
        "1e-3";
    /// Integration scheme.
    pub(super) SCHEME: usize = "scheme", [Word(&SCHEMES)], or "\"two-step\"" = 0, "\"bdf2\"";
    /// Asymptotic spectral radius of the schemes `two-step` and `cubic`, from 0 to 1: the part of
    /// the fastest motions that remains after a step.
    pub(super) RADIUS: Option<f64> = "radius", [NotNegative(Dimension::NUMBER)]
        as "a number from 0 to 1", or "0.6", "0.8";
    /// Position of the inner stage of the scheme `parabolic`, between -1 and 0.
    pub(super) ZETA: Option<f64> = "zeta", [Quantity(Dimension::NUMBER)]
        as "a number above -1 and below 0", or "-2/3", "-0.5";
    /// Jacobian: exact, or rotations linearized as at their prediction.
    pub(super) JACOBIAN: usize = "jacobian", [Word(&["exact", "simplified"])],
        or "\"exact\"" = 0, "\"simplified\"";
    /// Settings of the iteration of a step.
    pub(super) NEWTON: ByHand = "newton", [Table(&ITERATION)], optional, "";
    /// Start: the given positions and velocities of the nodes, at rest under the loads at `from`,
    /// or turning steadily about the axis of the hub at `speed`.
    pub(in crate::input) START: usize = "start", [Word(&["given", "equilibrium", "rotating"])],
        or "\"given\"" = 0, "\"rotating\"";
    /// Angular velocity of a rotating start.
    pub(super) SPEED: Option<f64> = "speed", [Quantity(Dimension::ROTATION_SPEED)], optional, "300";
    /// Shape of a mode that is added to the equilibrium of the start.
    pub(super) SHAPE: ByHand = "shape", [Table(&START_SHAPE)], optional, "";
    /// Accelerations at the start.
    pub(super) START_ACCELERATIONS: usize = "start_accelerations",
        [Word(&["consistent", "zero", "dummy", "at-rest"])], or "\"consistent\"" = 0, "\"dummy\"";
    /// Redundant constraints: an error, or sharing of the loads with the smallest reactions.
    pub(in crate::input) REDUNDANT: usize = "redundant", [Word(&["error", "remove"])],
        or "\"error\"" = 0, "\"remove\"";
}

keys! {
    /// The shape of a mode as a start.
    START_SHAPE = "shape = { ... }";
    /// Number of the mode, by frequency.
    pub(super) MODE: usize = "mode", [Count(MOST_MODES)], required, "2";
    /// Largest displacement of a node.
    pub(super) DISPLACEMENT: f64 = "displacement", [Quantity(Dimension::LENGTH)], required,
        "\"10 mm\"";
}

keys! {
    /// Steps by the local error.
    VARIABLE_STEP = "step = { ... }";
    /// Length of the first step.
    pub(super) FIRST: f64 = "first", [Positive(Dimension::TIME)], required, "1e-4";
    /// Smallest length, 1e-6 of `first` unless given.
    pub(super) LEAST: Option<f64> = "least", [Positive(Dimension::TIME)], optional, "1e-9";
    /// Largest length, a fiftieth of the run unless given.
    pub(super) MOST: Option<f64> = "most", [Positive(Dimension::TIME)], optional, "1e-2";
    /// Local error of a step, in sizes of the model and radians.
    pub(super) TOLERANCE: f64 = "tolerance", [Positive(Dimension::NUMBER)], or "1e-4" = 1e-4,
        "1e-5";
}

keys! {
    /// Settings of the iteration of a step.
    ITERATION = "newton = { ... }";
    /// A Jacobian in every step, or one that is kept over steps and turns with the model: two times
    /// faster for rotors in the air.
    pub(super) METHOD: Option<usize> = "method", [Word(&["full", "modified"])],
        or "`\"modified\"` with strips, otherwise `\"full\"`", "\"full\"";
    /// Largest number of iterations in a step, 15 unless given.
    pub(super) ITERATIONS: Option<usize> = "iterations", [Count(MOST_ITERATIONS)], optional, "30";
    /// Remaining error after the last correction, in sizes of the model and radians, from 1e-13
    /// to 0.01.
    pub(super) CORRECTION: Option<f64> = "tolerance", [Positive(Dimension::NUMBER)]
        as "a number from 1e-13 to 0.01", optional, "1e-9";
}
