//! Grids of operating points: `[[sweep]]`.

use std::f64::consts::{PI, TAU};

use shared_geom::document::schema::ValueKind::{Numbers, Quantities, Table as OneTable, Text};
use shared_geom::document::{Key, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::PerformanceProblem;
use super::values::{self, RANGE};
use crate::case::{Abscissa, OperatingSetting, PerformancePart, PerformanceRequest};
use crate::input::short_number;

keys! {
    /// A grid of operating points: two of the speed, the rotor speed and a ratio of them, and the
    /// pitch. Every value is combined with every other.
    pub(super) CARD = "[[sweep]]";
    /// Name in tables and figures.
    pub(super) NAME: Option<String> = "name", [Text], or "sweep 1, sweep 2, ...", "\"map\"";
    /// Speed of the wind, or of flight along the shaft.
    SPEED: Option<Vec<f64>> = "speed", [Quantities(Dimension::VELOCITY), OneTable(&RANGE)],
        optional, "{ from = 3, to = 25, steps = 23 }";
    /// Speed of rotation.
    ROTOR_SPEED: Option<Vec<f64>> = "rotor_speed",
        [Quantities(Dimension::ROTATION_SPEED), OneTable(&RANGE)], optional, "12.1";
    /// Speed of the tip over the speed.
    TIP_SPEED_RATIO: Option<Vec<f64>> = "tip_speed_ratio",
        [Quantities(Dimension::NUMBER), OneTable(&RANGE)], optional,
        "{ from = 2, to = 14, steps = 50 }";
    /// Speed over revolutions per second and diameter.
    ADVANCE_RATIO: Option<Vec<f64>> = "advance_ratio",
        [Quantities(Dimension::NUMBER), OneTable(&RANGE)], optional, "[0, 0.2, 0.4, 0.6]";
    /// Pitch, added to the twist.
    PITCH: Option<Vec<f64>> = "pitch", [Quantities(Dimension::ANGLE), OneTable(&RANGE)],
        or "0", "[0, 5, 10]";
    /// Values of the first key with several values, as plain numbers in m/s, rpm, degrees or as
    /// ratios, at which loads along the blade are written.
    pub(super) LOADS_AT: Vec<f64> = "loads_at", [Numbers(100)], or "none" = Vec::new(), "[7.5]";
}

/// Points of one sweep: tables beyond a million rows are treated as an error.
const MOST: usize = 1_000_000;
/// Least number of values of both axes of a map.
const LEAST_OF_MAP: usize = 3;

/// Values of a quantity, in SI units.
#[derive(Debug, Clone)]
struct Axis {
    of: Abscissa,
    key: &'static str,
    values: Vec<f64>,
}

/// Reads a sweep of a rotor with this radius \[m\]; `usual` is its name if it has none.
pub(super) fn read(table: &Table<'_>, usual: String, radius: f64) -> Option<PerformancePart> {
    let name = table.get(&NAME);
    let keys: [(&Key<_>, Abscissa); 5] = [
        (&TIP_SPEED_RATIO, Abscissa::TipSpeedRatio),
        (&ADVANCE_RATIO, Abscissa::AdvanceRatio),
        (&SPEED, Abscissa::Speed),
        (&ROTOR_SPEED, Abscissa::RotorSpeed),
        (&PITCH, Abscissa::Pitch),
    ];
    let read = keys.map(|(key, of)| {
        let values = values::read(table, key)?;
        let key = key.name();
        Some(values.map(|values| Axis { of, key, values }))
    });
    let loads_at = table.get(&LOADS_AT);
    table.finish();
    let read: Vec<Option<Axis>> = read.into_iter().collect::<Option<_>>()?;
    let mut axes: Vec<Axis> = read.into_iter().flatten().collect();
    if !axes.iter().any(|axis| axis.of == Abscissa::Pitch) {
        let (of, key, values) = (Abscissa::Pitch, PITCH.name(), vec![0.0]);
        axes.push(Axis { of, key, values });
    }
    let axes = checked(table, axes)?;
    let count: usize = axes.iter().map(|axis| axis.values.len()).product();
    if count > MOST {
        let (found, most) = (count, MOST);
        table.note("", &PerformanceProblem::TooMany { found, most });
        return None;
    }
    Some(part(&axes, name?.unwrap_or(usual), loads_at?, radius))
}

/// The axes, if two of them give the speeds; notes other combinations, and ratios and speeds by
/// which others would be infinite.
fn checked(table: &Table<'_>, axes: Vec<Axis>) -> Option<[Axis; 3]> {
    let is_ratio =
        |axis: &Axis| matches!(axis.of, Abscissa::TipSpeedRatio | Abscissa::AdvanceRatio);
    let ratios = axes.iter().filter(|axis| is_ratio(axis)).count();
    let axes = match <[Axis; 3]>::try_from(axes) {
        Ok(axes) if ratios <= 1 => axes,
        Ok(axes) => return wrong(table, &axes),
        Err(axes) => return wrong(table, &axes),
    };
    let [first, second, _] = &axes;
    let divisors: &[(&Axis, &'static str)] = match (first.of, second.of) {
        (Abscissa::TipSpeedRatio, Abscissa::RotorSpeed) => &[(first, "speed")],
        (Abscissa::AdvanceRatio, Abscissa::Speed) => &[(first, "rotor_speed")],
        (Abscissa::TipSpeedRatio, Abscissa::Speed) => &[(second, "rotor_speed")],
        (Abscissa::AdvanceRatio, Abscissa::RotorSpeed) => &[(second, "speed")],
        _ => &[],
    };
    let mut sound = true;
    for (axis, other) in divisors {
        if let Some(found) = axis.values.iter().copied().find(|value| *value <= 0.0) {
            let key = axis.key;
            table.note(key, &PerformanceProblem::NotPositive { key, found, other });
            sound = false;
        }
    }
    sound.then_some(axes)
}

fn wrong(table: &Table<'_>, axes: &[Axis]) -> Option<[Axis; 3]> {
    let speeds = axes.iter().filter(|axis| axis.of != Abscissa::Pitch);
    let keys: Vec<_> = speeds.map(|axis| format!("\"{}\"", axis.key)).collect();
    let found = match keys.len() {
        0 => "none of them".to_owned(),
        1 => format!("{} alone", keys[0]),
        _ => keys.join(", "),
    };
    table.note("", &PerformanceProblem::Speeds { found });
    None
}

/// The points: the first axis with several values is the abscissa of the curves.
fn part(axes: &[Axis; 3], name: String, loads_at: Vec<f64>, radius: f64) -> PerformancePart {
    let several = |axis: &&Axis| axis.values.len() > 1;
    let inner = axes.iter().position(|axis| several(&axis)).unwrap_or(0);
    let outer: Vec<&Axis> = axes
        .iter()
        .enumerate()
        .filter(|(index, _)| *index != inner)
        .map(|(_, axis)| axis)
        .collect();
    let (mut settings, mut curves) = (Vec::new(), Vec::new());
    for &low in &outer[1].values {
        for &high in &outer[0].values {
            curves.push(label(&[(outer[0], high), (outer[1], low)]));
            for &value in &axes[inner].values {
                let values = [
                    (axes[inner].of, value),
                    (outer[0].of, high),
                    (outer[1].of, low),
                ];
                settings.push(setting(&values, radius));
            }
        }
    }
    let is_map = axes[0].of == Abscissa::TipSpeedRatio
        && axes[0].values.len() >= LEAST_OF_MAP
        && axes[1].values.len() == 1
        && axes[2].values.len() >= LEAST_OF_MAP;
    PerformancePart {
        name,
        request: PerformanceRequest::Settings(settings),
        abscissa: axes[inner].of,
        curves,
        is_map,
        loads_at,
    }
}

/// The name of a curve: the axes with several values.
fn label(values: &[(&Axis, f64)]) -> String {
    let several = values.iter().filter(|(axis, _)| axis.values.len() > 1);
    let parts = several.map(|(axis, value)| {
        let title = axis.of.title();
        let (name, unit) = title.split_once(" [").unwrap_or((title, "]"));
        let unit = unit.trim_end_matches(']').trim_matches('-');
        let value = match axis.of {
            Abscissa::RotorSpeed => value * 30.0 / PI,
            Abscissa::Pitch => value.to_degrees(),
            _ => *value,
        };
        format!("{name} {} {unit}", short_number(value, 4))
            .trim_end()
            .to_owned()
    });
    parts.collect::<Vec<_>>().join(", ")
}

/// The operating point of three values.
fn setting(values: &[(Abscissa, f64); 3], radius: f64) -> OperatingSetting {
    let of = |wanted: Abscissa| {
        let found = values.iter().find(|(axis, _)| *axis == wanted);
        found.map(|(_, value)| *value)
    };
    let (speed, omega) = (of(Abscissa::Speed), of(Abscissa::RotorSpeed));
    let ratio = of(Abscissa::TipSpeedRatio);
    let advance = of(Abscissa::AdvanceRatio);
    let diameter = 2.0 * radius;
    let (speed, omega) = match (speed, omega, ratio, advance) {
        (Some(speed), None, Some(ratio), _) => (speed, ratio * speed / radius),
        (Some(speed), None, _, Some(advance)) => (speed, TAU * speed / (advance * diameter)),
        (None, Some(omega), Some(ratio), _) => (omega * radius / ratio, omega),
        (None, Some(omega), _, Some(advance)) => (advance * diameter * omega / TAU, omega),
        (speed, omega, ..) => (speed.unwrap_or(0.0), omega.unwrap_or(0.0)),
    };
    OperatingSetting {
        speed,
        omega,
        pitch: of(Abscissa::Pitch).unwrap_or(0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shared_geom::document::Document;

    fn part_of(text: &str) -> Result<PerformancePart, String> {
        let document = Document::parse(text, "a.toml").unwrap();
        let part = read(&document.root_of(&CARD), "sweep 1".to_owned(), 2.0);
        document
            .finish(part)
            .map_err(|problems| problems.to_string())
    }

    fn settings(part: &PerformancePart) -> Vec<OperatingSetting> {
        match &part.request {
            PerformanceRequest::Settings(settings) => settings.clone(),
            PerformanceRequest::PowerCurve(_) => Vec::new(),
        }
    }

    #[test]
    fn the_other_speed_follows_from_the_ratio() {
        for (text, expected) in [
            ("speed = 8\ntip_speed_ratio = 5", [8.0, 20.0]),
            (
                "rotor_speed = \"20 rad/s\"\ntip_speed_ratio = 5",
                [8.0, 20.0],
            ),
            // J = V / (n D) = pi V / (omega R)
            (
                "speed = 8\nadvance_ratio = 0.5",
                [8.0, 8.0 * PI / (0.5 * 2.0)],
            ),
            ("rotor_speed = 60\nadvance_ratio = 0", [0.0, TAU]),
            ("rotor_speed = 60\nspeed = 3", [3.0, TAU]),
        ] {
            let found = settings(&part_of(text).unwrap())[0];
            assert!(
                (found.speed - expected[0]).abs() < 1e-12,
                "{text}: {found:?}"
            );
            assert!(
                (found.omega - expected[1]).abs() < 1e-12,
                "{text}: {found:?}"
            );
        }
    }

    #[test]
    fn the_first_key_with_several_values_runs_along_the_curves() {
        let text =
            "speed = 8\ntip_speed_ratio = { from = 2, to = 4, steps = 3 }\npitch = [0, 1, 2]";
        let part = part_of(text).unwrap();
        assert!(part.is_map);
        assert_eq!(part.abscissa, Abscissa::TipSpeedRatio);
        assert_eq!(part.curves, ["pitch 0 deg", "pitch 1 deg", "pitch 2 deg"]);
        let found = settings(&part);
        assert_eq!(found.len(), 9);
        assert!((found[1].omega - 12.0).abs() < 1e-12);
        assert!((found[3].pitch.to_degrees() - 1.0).abs() < 1e-12);
        let part = part_of("speed = 0\nrotor_speed = 300\npitch = [4, 8]").unwrap();
        assert_eq!((part.abscissa, part.is_map), (Abscissa::Pitch, false));
        assert_eq!(part.curves, [""]);
    }

    #[test]
    fn wrong_sweeps_are_reported() {
        for (text, expected) in [
            (
                "speed = 8",
                "[[sweep]] has \"speed\" alone, expected two of",
            ),
            ("pitch = 8", "[[sweep]] has none of them, expected two of"),
            (
                "speed = 8\nrotor_speed = 9\ntip_speed_ratio = 3",
                "has \"tip_speed_ratio\", \"speed\", \"rotor_speed\", expected two of",
            ),
            (
                "tip_speed_ratio = 8\nadvance_ratio = 9",
                "has \"tip_speed_ratio\", \"advance_ratio\", expected two of",
            ),
            (
                "speed = []\nrotor_speed = 2",
                "\"speed\" is empty, expected at least one value",
            ),
            (
                "speed = 8\nadvance_ratio = [0, 1]",
                "\"advance_ratio\" has the value 0, expected a value above zero: \"rotor_speed\" \
                 follows from it",
            ),
            (
                "speed = { from = 1, to = 2 }\nrotor_speed = 2",
                "has no \"steps\"",
            ),
            (
                "speed = { from = 1, to = 2, steps = 9000 }\nrotor_speed = { from = 1, to = 2, \
                 steps = 9000 }",
                "the sweep has 81000000 points, expected at most 1000000",
            ),
        ] {
            let shown = part_of(text).unwrap_err();
            assert!(shown.contains(expected), "{text}: {shown}");
            assert!(shown.contains("a.toml:"), "{shown}");
        }
    }
}
