//! Airfoils of windIO turbine files.
//!
//! | | version 1 | version 2 |
//! |---|---|---|
//! | angles | rad | deg |
//! | thickness over chord | `relative_thickness` | `rthick` |
//! | tables | `polars[]`: `re`, `c_l`, `c_d`, `c_m` | `polars[].re_sets[]`: `re`, `cl`, `cd`, `cm` |
//! | | | one list per `configuration` |
//!
//! Each coefficient has `grid` and `values`. The unit follows `windIO_version`, or the names of
//! the tables if the file does not state its version. Tables that end at 3.14 are closed at pi.

use shared_geom::exchange::yaml::{Node, Value};

use super::grid::{Grid, Row, Unit};
use super::notes::Notes;
use super::reading::{Options, ReadAirfoil};
use super::tree::{column, list, optional, required, root, word};

/// Whether `text` has a list of airfoils in YAML.
pub(super) fn recognize(text: &str) -> bool {
    text.lines().any(|line| line.starts_with("airfoils:"))
}

/// Reads the airfoils of a file of either version.
pub(super) fn read(text: &str, _: &Options, notes: &mut Notes) -> Option<Vec<ReadAirfoil>> {
    let root = root(text, notes)?;
    airfoils(&root, true, notes)
}

/// The airfoils of a file that is parsed; without `needs_polars` those without polars are left out.
pub(super) fn airfoils(
    root: &Node,
    needs_polars: bool,
    notes: &mut Notes,
) -> Option<Vec<ReadAirfoil>> {
    let node = required(root, "the file", "airfoils", notes)?;
    let items = list(node, "airfoils", notes)?;
    let stated = stated_unit(root, notes);
    let counted = items.iter().filter(|item| needs_polars || has_polars(item));
    let read = counted.map(|item| airfoil(item, stated, notes));
    let read: Vec<_> = read.flatten().collect();
    // The problems of all of them are noted.
    (items.is_empty() || !read.is_empty()).then_some(read)
}

/// Whether an airfoil has the key of its polars with a content.
fn has_polars(item: &Node) -> bool {
    let is_empty = |polars: &Node| match &polars.value {
        Value::List(polars) => polars.is_empty(),
        Value::Text(text) => matches!(text.as_str(), "" | "~" | "null"),
        Value::Table(_) => false,
    };
    item.entry("polars").is_some_and(|polars| !is_empty(polars))
}

/// The unit of the angles that the version states.
fn stated_unit(root: &Node, notes: &mut Notes) -> Option<Unit> {
    let at = root.entry("windIO_version")?;
    let version = at.text().unwrap_or_default();
    match version.trim_start_matches('v').chars().next() {
        Some('0' | '1') => Some(Unit::Radians),
        Some('2') => Some(Unit::Degrees),
        _ => {
            notes.wrong(
                at.line,
                [
                    "windIO_version",
                    &at.kind(),
                    "1.x or 2.x",
                    "state the version of the file",
                ],
            );
            None
        }
    }
}

/// The airfoils of an item, one per configuration.
fn airfoil(item: &Node, stated: Option<Unit>, notes: &mut Notes) -> Vec<ReadAirfoil> {
    let Some(name) = required(item, "an airfoil", "name", notes).and_then(Node::text) else {
        return Vec::new();
    };
    let of = format!("airfoil \"{name}\"");
    let thickness =
        optional(item, "rthick", notes).or_else(|| optional(item, "relative_thickness", notes));
    let mut empty = ReadAirfoil {
        aerodynamic_center: optional(item, "aerodynamic_center", notes),
        ..ReadAirfoil::default()
    };
    empty.data.thickness = thickness;
    let polars = required(item, &of, "polars", notes).and_then(|at| list(at, "polars", notes));
    let Some(polars) = polars else {
        return Vec::new();
    };
    let is_nested = polars.iter().any(|polar| polar.entry("re_sets").is_some());
    let unit = stated.unwrap_or(if is_nested {
        Unit::Degrees
    } else {
        Unit::Radians
    });
    let mut airfoils: Vec<(String, ReadAirfoil)> = Vec::new();
    for polar in polars {
        let configuration = word(polar, "configuration")
            .filter(|_| is_nested)
            .unwrap_or_default();
        let found = airfoils
            .iter()
            .position(|(known, _)| known == configuration);
        let index = found.unwrap_or_else(|| {
            airfoils.push((configuration.to_owned(), empty.clone()));
            airfoils.len() - 1
        });
        if let Some((_, airfoil)) = airfoils.get_mut(index) {
            sets(polar, is_nested, unit, (&of, airfoil), notes);
        }
    }
    if polars.is_empty() {
        notes.missing(
            item.line,
            &format!("a polar of {of}"),
            "give at least one polar",
        );
    }
    named(name, airfoils)
}

/// The airfoils with their names; configurations are named if there are several.
fn named(name: &str, airfoils: Vec<(String, ReadAirfoil)>) -> Vec<ReadAirfoil> {
    let is_one = airfoils.len() == 1;
    let named = airfoils.into_iter().map(|(configuration, mut airfoil)| {
        airfoil.data.name = if is_one {
            name.to_owned()
        } else {
            full_name(name, &configuration)
        };
        airfoil
    });
    named.collect()
}

/// The name of a configuration of an airfoil that has several.
pub(super) fn full_name(name: &str, configuration: &str) -> String {
    format!("{name}/{configuration}")
}

/// Adds the tables of a polar, one per Reynolds number.
fn sets(
    polar: &Node,
    is_nested: bool,
    unit: Unit,
    (of, airfoil): (&str, &mut ReadAirfoil),
    notes: &mut Notes,
) {
    if !is_nested {
        table(polar, ["c_l", "c_d", "c_m"], unit, (of, airfoil), notes);
        return;
    }
    let sets = required(polar, of, "re_sets", notes).and_then(|at| list(at, "re_sets", notes));
    for set in sets.unwrap_or_default() {
        table(set, ["cl", "cd", "cm"], unit, (of, airfoil), notes);
    }
}

/// Adds the three coefficients of one Reynolds number.
fn table(
    set: &Node,
    keys: [&str; 3],
    unit: Unit,
    (of, airfoil): (&str, &mut ReadAirfoil),
    notes: &mut Notes,
) {
    let reynolds = optional(set, "re", notes).filter(|&re| re > 0.0);
    let known = ["re", "configuration", keys[0], keys[1], keys[2]];
    let others: Vec<_> = set
        .keys()
        .into_iter()
        .filter(|key| !known.contains(key))
        .collect();
    if !others.is_empty() {
        notes.remark(set.line, &format!("{of}: not used: {}", others.join(", ")));
    }
    let lists = [
        &mut airfoil.data.lift,
        &mut airfoil.data.drag,
        &mut airfoil.data.moment,
    ];
    for ((i, key), curves) in keys.into_iter().enumerate().zip(lists) {
        // The moment alone may be missing.
        let node = match i {
            2 => set.entry(key),
            _ => required(set, of, key, notes),
        };
        let Some(node) = node else {
            continue;
        };
        let what = format!("{key} of {of}");
        if let Some(grid) = grid(node, unit, &what, notes) {
            curves.extend(grid.curve(0, [None, reynolds, None]));
        }
    }
}

/// A coefficient over checked angles.
fn grid(node: &Node, unit: Unit, what: &str, notes: &mut Notes) -> Option<Grid> {
    let column = column(node, what, notes)?;
    let pairs = column.grid.iter().zip(&column.values);
    let rows = pairs.map(|(alpha, value)| Row {
        line: column.line,
        alpha: *alpha,
        values: vec![*value],
    });
    let rows: Vec<_> = rows.collect();
    let mut grid = Grid::of(&rows, unit, (what, column.line), notes)?;
    grid.close(what, column.line, notes);
    Some(grid)
}
