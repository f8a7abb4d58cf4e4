//! Regions as written: a physical group, its material, and the two angles.

use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::problem::InputProblem;

/// Largest angle \[rad\]: 1000 revolutions. For a much larger angle the remainder after
/// whole revolutions has no accurate digit.
const LARGEST_ANGLE: f64 = 1000.0 * std::f64::consts::TAU;

/// `[[region]]` as far as it could be read.
#[derive(Debug, Clone)]
pub(super) struct WrittenRegion {
    pub line: usize,
    pub group: Option<Written>,
    pub material: Option<Written>,
    pub fiber_angle: Option<WrittenAngle>,
    pub plane_angle: Option<WrittenAngle>,
}

/// A name and its line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Written {
    pub text: String,
    pub line: usize,
}

/// An angle as given in the input.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum WrittenAngle {
    /// The same for all cells \[rad\].
    Constant(f64),
    /// From a table by cell.
    Table(Written),
    /// The direction of a curve, or the opposite direction.
    Follow { curve: Written, reverse: bool },
}

/// Reads every `[[region]]`.
pub(super) fn read(root: &Table<'_>) -> Vec<WrittenRegion> {
    let tables = root.tables("region");
    tables
        .iter()
        .map(|table| {
            let region = WrittenRegion {
                line: table.line(),
                group: name(table, "group", "the name of a physical surface"),
                material: name(table, "material", "the name of a material"),
                fiber_angle: angle(table, "fiber_angle"),
                plane_angle: angle(table, "plane_angle"),
            };
            table.finish();
            region
        })
        .collect()
}

/// A required name, or a number that represents a name.
pub(super) fn name(table: &Table<'_>, key: &str, expected: &str) -> Option<Written> {
    let text = if table.is_list(key) || table.is_table(key) {
        table.wrong(key, expected);
        return None;
    } else if table.has(key) && !table.is_text(key) {
        table.count(key)?.to_string()
    } else {
        table.require_text(key, expected)?
    };
    let line = table.line_of(key);
    Some(Written { text, line })
}

/// A constant, `{ table = ... }`, or for the plane angle `{ follow = ... }`; zero if
/// absent.
fn angle(region: &Table<'_>, key: &'static str) -> Option<WrittenAngle> {
    if !region.has(key) {
        return Some(WrittenAngle::Constant(0.0));
    }
    if !region.is_table(key) {
        return constant_angle(region, key).map(WrittenAngle::Constant);
    }
    let table = region.table(key)?;
    let may_follow = key == "plane_angle";
    let (has_table, has_follow) = (table.has("table"), may_follow && table.has("follow"));
    let found = match (has_table, has_follow) {
        (true, true) => {
            table.note("follow", &InputProblem::TableAndFollow { key });
            None
        }
        (true, false) => named(&table, "table").map(WrittenAngle::Table),
        (false, true) => follow(&table),
        (false, false) => {
            let expected = match may_follow {
                true => "\"table\" or \"follow\"",
                false => "\"table\"",
            };
            table.note("", &InputProblem::NoAngle { key, expected });
            None
        }
    };
    table.finish();
    found
}

/// One angle \[rad\].
pub(super) fn constant_angle(table: &Table<'_>, key: &str) -> Option<f64> {
    let angle = table.quantity(key, Dimension::ANGLE)?;
    if angle.abs() > LARGEST_ANGLE {
        table.wrong(key, "an angle of at most 1000 revolutions");
        return None;
    }
    Some(angle)
}

fn follow(table: &Table<'_>) -> Option<WrittenAngle> {
    let reverse = match table.has("reverse") {
        true => table.boolean("reverse"),
        false => Some(false),
    };
    let curve = name(table, "follow", "the name of a physical curve")?;
    Some(WrittenAngle::Follow {
        curve,
        reverse: reverse?,
    })
}

fn named(table: &Table<'_>, key: &str) -> Option<Written> {
    let text = table.text(key)?;
    let line = table.line_of(key);
    Some(Written { text, line })
}
