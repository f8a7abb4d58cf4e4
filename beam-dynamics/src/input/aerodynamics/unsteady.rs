//! Constants of unsteady models of an airfoil: `unsteady = { ... }`.

use std::ops::RangeInclusive;

use rotor_aero::airfoil::UnsteadyConstants;
use rotor_aero::unsteady::StallConstants;
use shared_geom::document::schema::ValueKind::{
    NotNegative, Positive, Quantity, Table as OneTable,
};
use shared_geom::document::{ByHand, Key, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

keys! {
    /// Constants of unsteady models, in place of the ones of the file or of the models.
    pub(super) UNSTEADY: ByHand = "unsteady", [OneTable(&CARD)], optional, "";
}

keys! {
    /// Constants of unsteady models of an airfoil, times in semichords travelled.
    CARD = "unsteady = { ... }";
    /// Mach number at which the published constants of NACA 0012 are taken, from 0.3 to 0.8; the other
    /// keys replace them.
    MACH: Option<f64> = "mach", [NotNegative(Dimension::NUMBER)], optional, "0.5";
    /// Slope of attached lift per radian.
    SLOPE: Option<f64> = "slope", [Positive(Dimension::NUMBER)], optional, "6.2";
    /// Angle of attack without lift.
    ZERO_LIFT: Option<f64> = "zero_lift", [Quantity(Dimension::ANGLE)], optional, "-3.2";
    /// Time constant of the pressure at the leading edge, T_p.
    PRESSURE_TIME: Option<f64> = "pressure_time", [Positive(Dimension::NUMBER)], optional, "1.7";
    /// Time constant of separation, T_f.
    SEPARATION_TIME: Option<f64> = "separation_time", [Positive(Dimension::NUMBER)], optional, "3";
    /// Time constant of the decay of the vortex, T_v.
    VORTEX_TIME: Option<f64> = "vortex_time", [Positive(Dimension::NUMBER)], optional, "6";
    /// Time of the vortex from the leading to the trailing edge, T_vl.
    PASSAGE_TIME: Option<f64> = "passage_time", [Positive(Dimension::NUMBER)], optional, "7";
    /// Coefficient of normal force at which the vortex is shed, C_N1.
    CRITICAL_NORMAL: Option<f64> = "critical_normal", [Positive(Dimension::NUMBER)], optional,
        "1.45";
    /// Offset of the aerodynamic center from the quarter chord, K_0.
    CENTER: Option<f64> = "center", [Quantity(Dimension::NUMBER)], optional, "0.0025";
    /// Shift of the center of pressure with separation, K_1.
    CENTER_SHIFT: Option<f64> = "center_shift", [Quantity(Dimension::NUMBER)], optional, "-0.135";
    /// Depth of the moment break, K_2.
    MOMENT_BREAK: Option<f64> = "moment_break", [Quantity(Dimension::NUMBER)], optional, "0.04";
    /// Recovery of the suction at the leading edge.
    SUCTION: Option<f64> = "suction", [Positive(Dimension::NUMBER)], optional, "0.965";
    /// Angle of attack at which 0.7 of the chord is attached, of the model with a vortex.
    BREAK_ANGLE: Option<f64> = "break_angle", [Quantity(Dimension::ANGLE)], optional, "15.25";
    /// Scale of the attached part before that angle, S_1.
    SCALE_BEFORE: Option<f64> = "scale_before", [Positive(Dimension::ANGLE)], optional, "3";
    /// Scale of the attached part beyond it, S_2.
    SCALE_BEYOND: Option<f64> = "scale_beyond", [Positive(Dimension::ANGLE)], optional, "2.3";
}

/// Keys of angles, with the names of the constants in files, in deg.
const ANGLES: [(&Key<Option<f64>>, &str); 4] = [
    (&ZERO_LIFT, "alpha0"),
    (&BREAK_ANGLE, "alpha1"),
    (&SCALE_BEFORE, "S1"),
    (&SCALE_BEYOND, "S2"),
];

/// Mach numbers of the published constants [-].
const PUBLISHED: RangeInclusive<f64> = 0.3..=0.8;

/// Keys of numbers, with the names of the constants in files.
const NUMBERS: [(&Key<Option<f64>>, &str); 10] = [
    (&SLOPE, "C_nalpha"),
    (&PRESSURE_TIME, "T_p"),
    (&SEPARATION_TIME, "T_f0"),
    (&VORTEX_TIME, "T_V0"),
    (&PASSAGE_TIME, "T_VL"),
    (&CRITICAL_NORMAL, "Cn1"),
    (&CENTER, "K_0"),
    (&CENTER_SHIFT, "K_1"),
    (&MOMENT_BREAK, "K_2"),
    (&SUCTION, "eta_e"),
];

/// Reads the constants of an airfoil over the ones of its file.
pub(super) fn read(table: &Table<'_>, mut found: UnsteadyConstants) -> Option<UnsteadyConstants> {
    if !table.has(&UNSTEADY) {
        return Some(found);
    }
    let table = table.table(&UNSTEADY)?;
    let mach = table.get(&MACH);
    let angles = ANGLES.map(|(key, name)| {
        let value = table.get(key);
        (name, value.map(|value| value.map(f64::to_degrees)))
    });
    let numbers = NUMBERS.map(|(key, name)| (name, table.get(key)));
    table.finish();
    let mach = mach?;
    if mach.is_some_and(|mach| !PUBLISHED.contains(&mach)) {
        table.wrong(&MACH, "a Mach number from 0.3 to 0.8");
        return None;
    }
    if let Some(mach) = mach {
        for (name, value) in StallConstants::naca0012(mach).values() {
            found.set(name, value);
        }
    }
    for (name, value) in angles.into_iter().chain(numbers) {
        if let Some(value) = value? {
            found.set(name, value);
        }
    }
    Some(found)
}
