//! Angles of windIO files, which are in rad in version 1 and in deg in version 2.

use std::f64::consts::FRAC_PI_2;

use super::super::angle::is_within_a_turn;
use super::Notes;
use super::version::Version;

/// Round-off of a right angle in deg.
const ROUND_OFF: f64 = 1e-9;

/// Kind of angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Angle {
    /// Of fibers or of the twist, within a right angle.
    Small,
    /// Of a plane.
    Any,
}

/// Checks the angles of a table, in the unit of the file: angles beyond a turn have another unit, angles
/// beyond a right angle are a remark.
pub(super) fn check(
    version: Version,
    (what, line): (&str, usize),
    angles: impl Iterator<Item = (f64, f64)>,
    kind: Angle,
    notes: &mut Notes,
) -> Option<()> {
    let largest = angles.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let Some((eta, written)) = largest else {
        return Some(());
    };
    let angle = written * version.angle();
    if !is_within_a_turn(angle) {
        let found = format!("{written} at {eta}");
        let [expected, help] = match version {
            Version::One => [
                "an angle in rad, within a turn",
                "angles of version 1 of windIO are in rad: divide degrees by 57.29578",
            ],
            Version::Two => [
                "an angle in deg, within a turn",
                "angles of version 2 of windIO are in deg, from -360 to 360",
            ],
        };
        notes.wrong(line, [what, &found, expected, help]);
        return None;
    }
    if kind == Angle::Small && angle.abs() > FRAC_PI_2 * (1.0 + ROUND_OFF) {
        let shown = match version {
            Version::One => format!("{written} rad = {:.1} deg", angle.to_degrees()),
            Version::Two => format!("{written} deg"),
        };
        notes.remarks.push(format!(
            "line {line}: {what} is {shown} at {eta}, more than a right angle"
        ));
    }
    Some(())
}
