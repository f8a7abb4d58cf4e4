//! Angles of windIO files, which are in rad in version 1 and in deg in version 2.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::Notes;
use super::version::Version;

/// Kind of angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Angle {
    /// Of fibers or of the twist, within a right angle.
    Small,
    /// Of a plane.
    Any,
}

/// Checks the angles of a table, in the unit of the file: those beyond a turn are no rad, those
/// beyond a right angle are a remark.
pub(super) fn check(
    version: Version,
    (what, line): (&str, usize),
    angles: impl Iterator<Item = (f64, f64)>,
    kind: Angle,
    notes: &mut Notes,
) -> Option<()> {
    let largest = angles.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let (Some((eta, angle)), Version::One) = (largest, version) else {
        return Some(());
    };
    if angle.abs() > TAU {
        let found = format!("{angle} at {eta}");
        let help = "angles of version 1 of windIO are in rad: divide degrees by 57.29578";
        notes.wrong(line, [what, &found, "an angle in rad, within a turn", help]);
        return None;
    }
    if kind == Angle::Small && angle.abs() > FRAC_PI_2 {
        notes.remarks.push(format!(
            "line {line}: {what} is {angle} rad = {:.1} deg at {eta}, more than a right angle",
            angle.to_degrees()
        ));
    }
    Some(())
}
