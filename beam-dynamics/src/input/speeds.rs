//! The requested modes: rotor speeds, the number of modes, and animated shapes.

use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{
    Boolean, Count, Quantities, Quantity, Table as OneTable,
};
use shared_geom::error::Explain;
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::misplaced_keys::OF_MODES;
use super::modal_damping;
use super::mode_style::{self, FREQUENCY_UNIT, HARMONICS, NAME_AT, WORDS};
use super::problem::InputProblem;
use super::rotor_speed::{RPM, SAME_SPEED, analyzed};
use crate::case::ModesSettings;

keys! {
    /// Frequencies and modes of small motions about the equilibrium at each rotor speed.
    pub(super) CARD = "[modes]";
    /// Rotor speeds: one, a list, or a range. They are required, but where `words` is the only key.
    SPEEDS: Option<Vec<f64>> = "speeds", [Quantities(Dimension::ROTATION_SPEED), OneTable(&RANGE)]
        as "a list of rotation speeds, or { from, to, steps }",
        optional, "[0, 300]";
    /// Number of modes to report; with `free` the rigid ones are beside them.
    COUNT: usize = "count", [Count(MOST_MODES)], or "10" = DEFAULT_COUNT, "8";
    /// Whether to write animated mode shapes for ParaView.
    SHAPES: bool = "shapes", [Boolean], or "false" = false, "true";
    /// Speeds, among `speeds`, at which shapes are drawn and animated.
    SHAPE_SPEEDS: Option<Vec<f64>> = "shape_speeds", [Quantities(Dimension::ROTATION_SPEED)],
        or "the first and the last", "[0, 300]";
    /// Whether parts that nothing holds may move, at rest: rigid-body modes of frequency zero.
    FREE: bool = "free", [Boolean], or "false" = false, "true";
    with modal_damping::RATIO.schema, WORDS.schema, FREQUENCY_UNIT.schema, HARMONICS.schema,
        NAME_AT.schema;
}

keys! {
    /// Speeds at equal distances, both ends included.
    RANGE = "speeds = { ... }";
    /// First speed.
    FROM: f64 = "from", [Quantity(Dimension::ROTATION_SPEED)], required, "0";
    /// Last speed; below the first one too.
    TO: f64 = "to", [Quantity(Dimension::ROTATION_SPEED)], required, "750";
    /// Number of speeds.
    STEPS: usize = "steps", [Count(MOST_SPEEDS)], required, "6";
}

/// Default number of modes.
const DEFAULT_COUNT: usize = 10;
/// Speeds of one run: more are treated as an error.
const MOST_SPEEDS: usize = 10_000;
/// Modes of one run: more than any model that can be solved here.
const MOST_MODES: usize = 10_000;

/// A range of rotor speeds as text.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("\"speeds\" is \"{found}\", expected a list of rotation speeds, or a table")]
struct RangeAsText {
    found: String,
    /// First and last number.
    ends: [String; 2],
}

impl Explain for RangeAsText {
    fn help(&self) -> Option<String> {
        let [from, to] = &self.ends;
        Some(format!(
            "write speeds = {{ from = {from}, to = {to}, steps = 5 }}"
        ))
    }
}

/// Reads `[modes]`.
pub(super) fn read(root: &Table<'_>) -> Option<ModesSettings> {
    let table = root.require_table("modes", "the rotor speeds: [modes] with \"speeds\"")?;
    let speeds = speeds(&table);
    let count = table.get(&COUNT);
    let shapes = shapes(&table, speeds.as_deref());
    let damping = modal_damping::read(&table);
    let style = mode_style::read(&table, speeds.as_deref());
    let free = free(&table, speeds.as_deref());
    table.finish_beside(&OF_MODES);
    let mut settings = ModesSettings::new(speeds?, count?);
    (settings.animate, settings.shapes) = shapes?;
    settings.damping = damping?;
    settings.style = style?;
    settings.free = free?;
    if settings.shapes.is_empty() {
        settings.shapes = settings.ends();
    }
    Some(settings)
}

fn speeds(table: &Table<'_>) -> Option<Vec<f64>> {
    let item = table.require_item(&SPEEDS, SPEEDS.schema.expected)?;
    let text = item.text().unwrap_or_default();
    if let Some(ends) = ends(text) {
        let (found, ends) = (text.to_owned(), ends.map(str::to_owned));
        table.note(&SPEEDS, &RangeAsText { found, ends });
        return None;
    }
    let speeds = if table.is_table(&SPEEDS) {
        range(&table.table(&SPEEDS)?)
    } else {
        table.get(&SPEEDS)?
    };
    ascending(table, speeds?)
}

/// The numbers at the ends of a range as text, such as `0-8` or `0:8`.
fn ends(text: &str) -> Option<[&str; 2]> {
    let separated = ["..", "-", ":", " to "]
        .into_iter()
        .find_map(|sign| text.split_once(sign));
    let (from, to) = separated?;
    let ends = [from.trim(), to.trim()];
    let is_number = |end: &&str| end.parse::<f64>().is_ok_and(|number| number >= 0.0);
    ends.iter().all(is_number).then_some(ends)
}

/// `steps` speeds at equal distances, both ends included.
fn range(table: &Table<'_>) -> Option<Vec<f64>> {
    let (from, to, steps) = (table.get(&FROM), table.get(&TO), table.get(&STEPS));
    table.finish();
    let (from, to, steps) = (from?, to?, steps?);
    if to == from {
        let rpm = to / RPM;
        table.note(&TO, &InputProblem::EmptyRange { rpm });
        return None;
    }
    if steps < 2 {
        table.wrong("steps", "at least 2: \"from\" and \"to\" are both speeds");
        return None;
    }
    let last = (steps - 1) as f64;
    Some(
        (0..steps)
            .map(|k| from + (to - from) * k as f64 / last)
            .collect(),
    )
}

fn ascending(table: &Table<'_>, mut speeds: Vec<f64>) -> Option<Vec<f64>> {
    let key = SPEEDS.name();
    let note = |problem: InputProblem| table.note(key, &problem);
    if speeds.is_empty() {
        note(InputProblem::NoSpeeds);
        return None;
    }
    speeds.sort_by(f64::total_cmp);
    let below: Vec<_> = speeds.iter().filter(|speed| **speed < 0.0).collect();
    for speed in &below {
        note(InputProblem::NegativeSpeed {
            key,
            rpm: **speed / RPM,
        });
    }
    let doubled: Vec<_> = speeds
        .windows(2)
        .filter(|pair| pair[1] - pair[0] <= SAME_SPEED * pair[1].abs())
        .collect();
    for pair in &doubled {
        note(InputProblem::SpeedTwice { rpm: pair[0] / RPM });
    }
    (below.is_empty() && doubled.is_empty()).then_some(speeds)
}

/// Reads `shapes` and `shape_speeds` of `[modes]`: whether shapes are animated, and the
/// speeds chosen for shapes, of `speeds`; empty if none are chosen.
fn shapes(table: &Table<'_>, speeds: Option<&[f64]>) -> Option<(bool, Vec<f64>)> {
    let animate = table.get(&SHAPES);
    let chosen = chosen_shapes(table, speeds);
    Some((animate?, chosen?))
}

/// Reads `free`: a model that nothing holds has no steady rotation about a given axis.
fn free(table: &Table<'_>, speeds: Option<&[f64]>) -> Option<bool> {
    let free = table.get(&FREE)?;
    let highest = speeds?.last().copied().filter(|speed| free && *speed > 0.0);
    if let Some(speed) = highest {
        let rpm = speed / RPM;
        table.note(FREE.name(), &InputProblem::FreeRotation { rpm });
        return None;
    }
    Some(free)
}

/// The speeds of the analysis that `shape_speeds` names; each one that is not analyzed is
/// noted.
fn chosen_shapes(table: &Table<'_>, speeds: Option<&[f64]>) -> Option<Vec<f64>> {
    let Some(wanted) = table.get(&SHAPE_SPEEDS)? else {
        return Some(Vec::new());
    };
    let speeds = speeds?;
    let mut found = Vec::with_capacity(wanted.len());
    for &wanted in &wanted {
        let (is_analyzed, nearest) = analyzed(speeds, wanted)?;
        if is_analyzed {
            found.push(nearest);
            continue;
        }
        let [rpm, nearest] = [wanted, nearest].map(|speed| speed / RPM);
        let key = SHAPE_SPEEDS.name();
        table.note(key, &InputProblem::ShapeSpeed { key, rpm, nearest });
    }
    (found.len() == wanted.len()).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::ModalDamping;
    use shared_geom::document::Document;

    fn settings(text: &str) -> Result<ModesSettings, String> {
        let document = Document::parse(&format!("[modes]\n{text}"), "a.toml").unwrap();
        let settings = read(&document.root());
        document
            .finish(settings)
            .map_err(|problems| problems.to_string())
    }

    fn rpm(text: &str) -> Vec<f64> {
        settings(text)
            .unwrap()
            .speeds
            .iter()
            .map(|speed| (speed / RPM).round())
            .collect()
    }

    #[test]
    fn speeds_come_in_order_from_lists_and_ranges() {
        assert_eq!(rpm("speeds = [500, 0, \"2 rev/s\"]"), [0.0, 120.0, 500.0]);
        assert_eq!(rpm("speeds = 300"), [300.0]);
        assert_eq!(
            rpm("speeds = { from = 100, to = 400, steps = 4 }"),
            [100.0, 200.0, 300.0, 400.0]
        );
        for range in ["from = 100, to = 400", "from = 400, to = 100"] {
            let text = format!("speeds = {{ {range}, steps = 2 }}");
            assert_eq!(rpm(&text), [100.0, 400.0]);
        }
        // Far apart, but close relative to the largest.
        assert_eq!(rpm("speeds = [0, 1, 1e12]"), [0.0, 1.0, 1e12]);
        assert_eq!(settings("speeds = [1]").unwrap().count, 10);
    }

    #[test]
    fn damping_ratios_are_given_for_all_by_order_or_by_name() {
        let ratio = |value: &str, order, name| {
            let text = format!("speeds = [0]\ndamping_ratio = {value}");
            settings(&text).unwrap().damping.ratio(order, name)
        };
        assert_eq!(ratio("0.01", 7, "lag 3"), Some(0.01));
        assert_eq!(ratio("[0.01, 0.02]", 1, "lag 1"), Some(0.02));
        assert_eq!(ratio("[0.01]", 1, "lag 1"), None);
        let named = "{ \"flap 1\" = 0.03, \"lag 1\" = 0 }";
        assert_eq!(ratio(named, 5, "flap 1"), Some(0.03));
        assert_eq!(ratio(named, 0, "flap 2"), None);
        assert_eq!(
            settings("speeds = [0]").unwrap().damping,
            ModalDamping::Found
        );
    }

    #[test]
    fn shapes_are_those_of_the_ends_or_of_speeds_that_are_named() {
        let shapes = |text: &str| {
            let settings = settings(&format!("speeds = [0, 100, 200]\n{text}")).unwrap();
            let rpm = settings.shapes.iter().map(|speed| (speed / RPM).round());
            (settings.animate, rpm.collect::<Vec<_>>())
        };
        assert_eq!(shapes(""), (false, vec![0.0, 200.0]));
        assert_eq!(shapes("shapes = true"), (true, vec![0.0, 200.0]));
        assert_eq!(
            shapes("shapes = true\nshape_speeds = [100, \"200 rpm\"]"),
            (true, vec![100.0, 200.0])
        );
    }

    #[test]
    fn wrong_speeds_are_reported() {
        for (text, expected) in [
            (
                "speeds = [1]\ndamping_ratio = 1.5",
                "\"damping_ratio\" is 1.5, expected a damping ratio from 0 to below 1",
            ),
            (
                "speeds = [1]\ndamping_ratio = { \"flap 1\" = -1, flop = 0.1 }",
                "\"flop\" is not a name of a mode",
            ),
            ("speeds = []", "\"speeds\" is empty"),
            (
                "speeds = [-3, 0]",
                "has the speed -3 rpm, expected zero or more",
            ),
            ("speeds = [5, 5]", "has the speed 5 rpm twice"),
            ("speeds = [0, 0]", "has the speed 0 rpm twice"),
            (
                "speeds = { from = 5, to = 5, steps = 2 }",
                "\"speeds\" runs from 5 rpm to 5 rpm, expected two speeds",
            ),
            (
                "speeds = { from = 5, to = 9, steps = 1 }",
                "\"steps\" is 1, expected at least 2",
            ),
            (
                "speeds = { from = 5, to = 9, steps = 100000 }",
                "\"steps\" is 100000, expected at most",
            ),
            (
                "speed = 1",
                "has no \"speeds\", expected a list of rotation speeds",
            ),
            ("speeds = [1]\ncount = 0", "\"count\" is 0"),
            (
                "speeds = [1, 9]\nshape_speeds = [1, 7]",
                "has the speed 7 rpm, expected some of \"speeds\"\n  help: the nearest is 9 rpm",
            ),
            (
                "speeds = [1]\nshapes = 3",
                "\"shapes\" is 3, expected true or false",
            ),
            (
                "speeds = [1]\ncount = 9223372036854775807",
                "\"count\" is 9223372036854775807, expected at most 10000",
            ),
        ] {
            let shown = settings(text).unwrap_err();
            assert!(shown.contains(expected), "{text}: {shown}");
        }
    }
}
