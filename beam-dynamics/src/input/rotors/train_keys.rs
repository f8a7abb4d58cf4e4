//! The keys of `[rotor.drive]`.

use shared_geom::document::Nested;
use shared_geom::document::schema::ValueKind::{Boolean, NotNegative, Positive, Table as OneTable};
use shared_geom::keys;
use shared_geom::units::Dimension;

keys! {
    /// Drive train between the engine, which then has the `speed`, `angle` or `torque`, and the hub.
    pub(super) TRAIN: Nested = "drive", [OneTable(&TRAIN_TABLE)], optional, "";
}

keys! {
    /// Engine, governor, shaft and free wheel; torques, stiffness and damping are those about the
    /// shaft of the rotor.
    TRAIN_TABLE = "[rotor.drive]";
    /// Moment of inertia of the engine about its own axis; for an engine with a torque or a governor.
    pub(super) INERTIA: Option<f64> = "inertia", [Positive(Dimension::INERTIA)], optional, "0.8";
    /// Speed of the engine in speeds of the rotor.
    pub(super) GEAR: f64 = "gear", [Positive(Dimension::NUMBER)], or "1" = 1.0, "15.2";
    /// Stiffness of the shaft, moment per radian.
    pub(super) STIFFNESS: Option<f64> = "stiffness", [Positive(Dimension::MOMENT)], or "rigid",
        "\"90 kN*m\"";
    /// Damper of a shaft with stiffness, moment per angular velocity in radians per time.
    pub(super) DAMPING: f64 = "damping", [NotNegative(Dimension::TURNING_DAMPER)], or "0" = 0.0,
        "\"200 N*m*s\"";
    /// Whether a shaft with stiffness has a free wheel, which transmits no torque from the rotor to the
    /// engine.
    pub(super) FREE_WHEEL: bool = "free_wheel", [Boolean], or "false" = false, "true";
    /// Governor of the speed, in place of a torque.
    pub(super) GOVERNOR: Nested = "governor", [OneTable(&GOVERNOR_TABLE)], optional, "";
}

keys! {
    /// A torque of the engine, zero at least, that follows the difference of a required speed and the
    /// speed of the engine, and the integral of this difference.
    GOVERNOR_TABLE = "governor = { ... }";
    /// Torque per difference of angular velocity in radians per time.
    pub(super) PROPORTIONAL: f64 = "proportional", [Positive(Dimension::TURNING_DAMPER)], required,
        "\"9 kN*m*s\"";
    /// Torque per integral of the difference, an angle in radians.
    pub(super) INTEGRAL: f64 = "integral", [NotNegative(Dimension::MOMENT)], or "0" = 0.0,
        "\"5 kN*m\"";
    /// Required speed of the rotor.
    pub(super) REQUIRED: Option<f64> = "speed", [Positive(Dimension::ROTATION_SPEED)],
        or "the `speed` of the rotor", "395";
    /// Largest torque.
    pub(super) LARGEST: Option<f64> = "largest", [Positive(Dimension::MOMENT)], or "unlimited",
        "\"20 kN*m\"";
}
