//! The outer shape of a windIO blade.

use shared_geom::exchange::windio_fields::numbers;
use shared_geom::exchange::yaml::Node;
use shared_geom::units::rounded;

use super::super::LayupFileProblem;
use super::super::course::Course;
use super::super::shape::{Points, Shape};
use super::airfoil::contour;
use super::version::Version;
use super::{Notes, course, items, remark_on_ends, required};

/// Largest difference of the stated and the measured thickness of an airfoil that is not reported, as a
/// part of it.
const OTHER_THICKNESS: f64 = 0.05;
/// Thicknesses and positions that differ by less are one [-].
const SAME: f64 = 1e-6;

/// The position of an airfoil, if it has one, and its name.
type Label<'n> = (Option<f64>, &'n Node);

/// An airfoil of the blade.
struct Placed {
    name: String,
    line: usize,
    thickness: f64,
    points: Points,
}

/// Reads the contours of a blade: chord, place of the axis, relative thickness and airfoils.
pub(super) fn read(
    root: &Node,
    outer: &Node,
    version: Version,
    notes: &mut Notes,
) -> Option<Shape> {
    let what = "the outer shape";
    let chord = required(outer, what, "chord", notes).and_then(|at| course(at, "chord", notes));
    let optional = |key: &str, notes: &mut Notes| match outer.entry(key) {
        Some(node) => course(node, key, notes).map(Some),
        None => Some(None),
    };
    let thickness = optional("rthick", notes);
    let offset = optional("section_offset_x", notes);
    let key = match version {
        Version::One => "pitch_axis",
        Version::Two => "section_offset_y",
    };
    let origin = required(outer, what, key, notes).and_then(|at| course(at, key, notes));
    if let Some(origin) = &origin {
        remark_on_origin(outer, (key, origin), notes);
    }
    for (key, table) in [
        ("chord", chord.as_ref()),
        (key, origin.as_ref()),
        ("rthick", thickness.as_ref().and_then(Option::as_ref)),
        ("section_offset_x", offset.as_ref().and_then(Option::as_ref)),
    ] {
        remark_on_table(outer, key, table, notes);
    }
    let labels = match version {
        Version::One => labels_1(outer, notes),
        Version::Two => labels_2(outer, outer.entry("rthick").is_some(), notes),
    };
    let labels = ascending(labels?, notes);
    let airfoils = placed(root, labels?, notes)?;
    let (chord, origin) = (chord?, origin?);
    let origin = match version {
        Version::One => origin,
        // at the positions of both tables
        Version::Two => {
            let both = origin.plus(&chord, 0.0);
            both.map(|eta, offset| offset / chord.at(eta))
        }
    };
    let thickness = match thickness? {
        Some(thickness) => thickness,
        None => by_position((outer, version), &airfoils, notes)?,
    };
    let offset = offset?.unwrap_or_else(|| Course::constant(0.0));
    let points = by_thickness(airfoils, notes);
    let made = Shape::new([chord, origin, offset], Some(thickness), points);
    let note = |problem: LayupFileProblem| note_shape(outer, key, &problem, notes);
    made.and_then(Shape::checked)
        .and_then(Shape::near_airfoils)
        .map_err(note)
        .ok()
}

/// Notes a problem of the shape by the key of the file; `axis` is the key of the place of the axis.
fn note_shape(outer: &Node, axis: &str, problem: &LayupFileProblem, notes: &mut Notes) {
    let LayupFileProblem::Shape {
        key,
        found,
        at,
        expected,
    } = problem
    else {
        let help = "correct the points of the airfoils";
        let found = problem.to_string();
        return notes.wrong(outer.line, ["airfoils", &found, "closed contours", help]);
    };
    let number = "write a thickness over the chord, as 0.3, not percent";
    let (key, help) = match *key {
        "origin" if axis == "pitch_axis" => (axis, "write the part of the chord ahead of the axis"),
        "origin" => (
            axis,
            "write the length from the leading edge to the axis in m",
        ),
        "thickness" => ("rthick", number),
        other => (other, "write lengths in m"),
    };
    let of_chord = if key == "section_offset_y" {
        " of the chord"
    } else {
        ""
    };
    let line = outer.entry(key).map_or(outer.line, |node| node.line);
    let found = format!("{}{of_chord} at {}", rounded(*found), rounded(*at));
    notes.wrong(line, [key, &found, expected, help]);
}

/// A remark on a place of the axis ahead of the leading edge.
fn remark_on_origin(outer: &Node, (key, origin): (&str, &Course), notes: &mut Notes) {
    let line = outer.entry(key).map_or(outer.line, |node| node.line);
    if let Some((eta, value)) = origin.points().find(|(_, value)| *value < 0.0) {
        notes.remarks.push(format!(
            "line {line}: {key} is {value} at {eta}: the axis is ahead of the leading edge"
        ));
    }
}

/// A remark on a table that ends before the tip, or begins behind the root.
fn remark_on_table(outer: &Node, key: &str, table: Option<&Course>, notes: &mut Notes) {
    let line = outer.entry(key).map_or(outer.line, |node| node.line);
    let positions = table.map_or(&[][..], Course::positions);
    remark_on_ends((key, line), positions, notes);
}

/// Positions and names of version 1.
fn labels_1<'n>(outer: &'n Node, notes: &mut Notes) -> Option<Vec<Label<'n>>> {
    let what = "airfoil_position";
    let table = required(outer, "the outer shape", what, notes)?;
    let grid = required(table, what, "grid", notes)
        .and_then(|at| numbers(at, "grid of airfoil_position", &mut notes.problems));
    let labels = required(table, what, "labels", notes).and_then(|at| items(at, "labels", notes));
    let (grid, labels) = (grid?, labels?);
    if grid.len() != labels.len() {
        let found = format!("{} positions and {} labels", grid.len(), labels.len());
        let expected = "a label for each position";
        notes.wrong(table.line, [what, &found, expected, "complete the list"]);
        return None;
    }
    Some(grid.into_iter().map(Some).zip(labels).collect())
}

/// Positions and names of version 2, which needs no positions if the blade has thicknesses.
fn labels_2<'n>(outer: &'n Node, has_thickness: bool, notes: &mut Notes) -> Option<Vec<Label<'n>>> {
    let list = required(outer, "the outer shape", "airfoils", notes)?;
    let airfoils = items(list, "airfoils", notes)?;
    let one = |item: &'n Node| {
        let what = "an airfoil of the outer shape";
        let key = "spanwise_position";
        let at = match item.entry(key) {
            None if has_thickness => Some(None),
            _ => required(item, what, key, notes)
                .and_then(|at| one_number(at, key, notes))
                .map(Some),
        };
        let name = required(item, what, "name", notes);
        Some((at?, name?))
    };
    let all: Vec<_> = airfoils.into_iter().map(one).collect();
    all.into_iter().collect()
}

/// Notes positions of airfoils that do not grow from the root to the tip.
fn ascending<'n>(labels: Vec<Label<'n>>, notes: &mut Notes) -> Option<Vec<Label<'n>>> {
    let mut is_right = true;
    let mut last = f64::NEG_INFINITY;
    for (at, label) in &labels {
        let Some(at) = at else {
            continue;
        };
        let found = match *at {
            at if !(-SAME..=1.0 + SAME).contains(&at) => format!("{at}"),
            at if at <= last => format!("{at} after {last}"),
            _ => {
                last = *at;
                continue;
            }
        };
        is_right = false;
        let name = label.text().unwrap_or_default();
        let what = format!("the position of airfoil \"{name}\"");
        let expected = "positions from 0 to 1 that grow";
        let help = "list the airfoils from root (0) to tip (1), one at each position";
        notes.wrong(label.line, [&what, &found, expected, help]);
    }
    is_right.then_some(labels)
}

fn one_number(node: &Node, what: &str, notes: &mut Notes) -> Option<f64> {
    let value = node.text().and_then(shared_geom::exchange::text::number);
    if value.is_none() {
        notes.wrong(
            node.line,
            [what, &node.kind(), "a number", "write a number"],
        );
    }
    value
}

/// The airfoils at positions along the span, by their names.
fn placed(
    root: &Node,
    labels: Vec<Label<'_>>,
    notes: &mut Notes,
) -> Option<Vec<(Option<f64>, Placed)>> {
    let list = required(root, "the file", "airfoils", notes)?;
    let known = items(list, "airfoils", notes)?;
    let name_of = |item: &Node| item.entry("name").and_then(Node::text).map(str::to_owned);
    let names: Vec<String> = known.iter().filter_map(|item| name_of(item)).collect();
    let mut all: Vec<(Option<f64>, Placed)> = Vec::new();
    let mut is_complete = !labels.is_empty();
    for (at, label) in labels {
        let name = label.text().unwrap_or_default();
        let Some(item) = known
            .iter()
            .find(|item| name_of(item).as_deref() == Some(name))
        else {
            let expected = ["the name of an airfoil of the file", &names.join("\n")];
            notes.unknown(label.line, "airfoil of the blade", name, expected);
            is_complete = false;
            continue;
        };
        match airfoil(item, name, notes) {
            Some(one) => all.push((at, one)),
            None => is_complete = false,
        }
    }
    is_complete.then_some(all)
}

fn airfoil(item: &Node, name: &str, notes: &mut Notes) -> Option<Placed> {
    let of = format!("airfoil \"{name}\"");
    let key = match item.entry("rthick") {
        Some(_) => "rthick",
        None => "relative_thickness",
    };
    let thickness = required(item, &of, key, notes)
        .and_then(|at| one_number(at, &format!("{key} of {of}"), notes));
    let coordinates = required(item, &of, "coordinates", notes)?;
    let [x, y] = ["x", "y"].map(|key| {
        let node = required(coordinates, &of, key, notes)?;
        numbers(node, &format!("{key} of {of}"), &mut notes.problems)
    });
    let points = match contour(&x?, &y?) {
        Ok(points) => points,
        Err([found, expected, help]) => {
            notes.wrong(coordinates.line, [&of, &found, &expected, &help]);
            return None;
        }
    };
    let thickness = thickness?;
    if !(thickness > 0.0 && thickness <= 1.0 + SAME) {
        let line = item.entry(key).map_or(item.line, |node| node.line);
        let what = format!("{key} of {of}");
        let expected = "a part of the chord, more than 0 and at most 1";
        let help = "write a number as 0.3, not percent";
        notes.wrong(line, [&what, &thickness.to_string(), expected, help]);
        return None;
    }
    let found = thickness_of(&points);
    if (found / thickness - 1.0).abs() > OTHER_THICKNESS {
        let remark = format!(
            "line {}: {of} has a {key} of {thickness}, and its points are {found:.4} thick: the contour is \
             taken as it is, at the place of {thickness}",
            item.line
        );
        // an airfoil may be at several positions
        if !notes.remarks.contains(&remark) {
            notes.remarks.push(remark);
        }
    }
    Some(Placed {
        name: name.to_owned(),
        line: item.line,
        thickness,
        points,
    })
}

/// Largest distance of both sides of a contour, over its chord.
fn thickness_of(points: &[[f64; 2]]) -> f64 {
    let nose = (0..points.len()).min_by(|a, b| points[*a][0].total_cmp(&points[*b][0]));
    let (upper, lower) = points.split_at(nose.unwrap_or(0));
    let below = |x: f64| {
        let behind = lower.partition_point(|point| point[0] < x);
        let behind = behind.clamp(1, lower.len().max(2) - 1);
        let [a, b] = [lower.get(behind - 1)?, lower.get(behind)?];
        let part = ((x - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0);
        Some(a[1] + part * (b[1] - a[1]))
    };
    let heights = upper.iter().filter_map(|p| Some(p[1] - below(p[0])?));
    heights.fold(0.0, f64::max)
}

/// Relative thickness over the span if the file has no table of it: of the airfoils at
/// their positions.
fn by_position(
    (outer, version): (&Node, Version),
    airfoils: &[(Option<f64>, Placed)],
    notes: &mut Notes,
) -> Option<Course> {
    let points = airfoils
        .iter()
        .filter_map(|(at, one)| Some(((*at)?, one.thickness)));
    let (eta, value): (Vec<f64>, Vec<f64>) = points.unzip();
    let key = match version {
        Version::One => "airfoil_position",
        Version::Two => "airfoils",
    };
    let line = outer.entry(key).map_or(outer.line, |node| node.line);
    remark_on_ends((key, line), &eta, notes);
    match eta.len() {
        0 => None,
        1 => Some(Course::constant(value[0])),
        _ => Some(Course::monotone(eta, value)),
    }
}

/// The airfoils in ascending order of their thicknesses, one of each.
fn by_thickness(airfoils: Vec<(Option<f64>, Placed)>, notes: &mut Notes) -> Vec<(f64, Points)> {
    let mut all: Vec<Placed> = airfoils.into_iter().map(|(_, one)| one).collect();
    all.sort_by(|a, b| a.thickness.total_cmp(&b.thickness));
    all.dedup_by(|next, kept| {
        let is_same = next.thickness - kept.thickness < SAME;
        if is_same && next.name != kept.name {
            notes.remarks.push(format!(
                "line {}: airfoils \"{}\" and \"{}\" have one thickness: the first is taken",
                next.line, kept.name, next.name
            ));
        }
        is_same
    });
    all.into_iter()
        .map(|one| (one.thickness, one.points))
        .collect()
}
