//! Blades of windIO turbine files, versions 1 and 2, as layups.
//!
//! | | version 1 | version 2 |
//! | --- | --- | --- |
//! | outer shape | `outer_shape_bem` | `outer_shape` |
//! | structure | `internal_structure_2d_fem` | `structure` |
//! | angles | rad | deg |
//! | place of the axis | `pitch_axis`, part of the chord | `section_offset_y` \[m\] |
//! | places | arcs, or offset, rotation, width, side, midpoint | `anchors` |
//!
//! The file has x toward the suction side, y toward the trailing edge and z along the blade; its
//! twist is positive nose down. Tables along the span are monotone cubics.
//!
//! # References
//! - IEA Wind Task 37, windIO 1.0, documentation of the turbine: blade.
//! - IEA Wind Task 55, windIO 2.1, `turbine_schema.yaml`.

use std::path::Path;

use shared_geom::error::{Diagnostics, SourceLocation, nearest_name, quoted};
use shared_geom::exchange::problem::{ExchangeProblem, Problems};
use shared_geom::exchange::windio_fields;
use shared_geom::exchange::yaml::{self, Node, Value};

use super::course::Course;
use super::names::wrong_names;
use super::resolve::Resolver;
use super::{Layup, Materials, WrittenLayer};

mod airfoil;
mod angles;
mod ends;
mod known;
mod layers;
mod materials;
mod places;
mod planes;
mod seam;
mod shape;
mod version;
mod version1;

use places::{Doubt, Places};
use planes::Tilt;

/// Largest difference of two rules for one place that is not reported, in chords.
const SAME_PLACE: f64 = 0.02;
/// Stations at which two rules are compared.
const COMPARED: usize = 20;
/// Part of the span at an end of the blade that tables need not have.
const OPEN: f64 = 1e-3;

/// Problems, and remarks on choices.
struct Notes {
    file: String,
    problems: Problems,
    remarks: Vec<String>,
}

impl Notes {
    /// Notes a wrong value: its name, the value found, the expected one, and the remedy.
    fn wrong(&mut self, line: usize, [what, found, expected, help]: [&str; 4]) {
        let [what, found, expected, help] = [what, found, expected, help].map(str::to_owned);
        let problem = ExchangeProblem::Other {
            what,
            found,
            expected,
            help,
        };
        self.problems.push(line, &problem);
    }

    /// Notes a name that is none of the known ones.
    fn unknown(&mut self, line: usize, what: &str, found: &str, [expected, known]: [&str; 2]) {
        let names = || known.split('\n').filter(|name| !name.is_empty());
        let help = match nearest_name(found, names()) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None if known.is_empty() => "the file has none".to_owned(),
            None => format!("there are {}", names().collect::<Vec<_>>().join(", ")),
        };
        self.wrong(line, [what, &format!("\"{found}\""), expected, &help]);
    }
}

/// The material of a name.
fn named<'n>(root: &'n Node, name: &str) -> Option<&'n Node> {
    let Value::List(list) = &root.entry("materials")?.value else {
        return None;
    };
    let is_it = |node: &&Node| node.entry("name").and_then(Node::text) == Some(name);
    list.iter().map(AsRef::as_ref).find(is_it)
}

/// Whether a text is a turbine file with a blade.
pub(super) fn recognize(text: &str, path: &Path) -> bool {
    let has = |name: &str| text.lines().any(|line| line.trim_start().starts_with(name));
    let is_yaml = path
        .extension()
        .is_some_and(|end| end == "yaml" || end == "yml");
    is_yaml || (has("components:") && has("blade:") && has("outer_shape"))
}

/// Reads the blade of a turbine file.
///
/// # Errors
/// All problems of the shape, the layers, the webs and their materials.
pub(super) fn read(text: &str, path: &Path, materials: Materials) -> Result<Layup, Diagnostics> {
    let file = path.display().to_string();
    let mut notes = Notes {
        problems: Problems::new(&file),
        file: file.clone(),
        remarks: Vec::new(),
    };
    let layup = match yaml::parse(text) {
        Ok(root) => blade(&root, (file, text), materials, &mut notes),
        Err((line, problem)) => {
            notes.problems.push(line, &problem);
            None
        }
    };
    notes
        .remarks
        .extend(layup.iter().flat_map(Layup::odd_shape));
    let remarks = notes.remarks;
    notes
        .problems
        .finish(layup.map(|layup| Layup { remarks, ..layup }))
}

fn blade(
    root: &Node,
    (file, text): (String, &str),
    materials: Materials,
    notes: &mut Notes,
) -> Option<Layup> {
    let parts = required(root, "the file", "components", notes)?;
    let blade = required(parts, "components", "blade", notes)?;
    let version = version::read(root, blade, notes)?;
    let [outer, structure] = version.tables();
    let outer = required(blade, "the blade", outer, notes);
    let structure = required(blade, "the blade", structure, notes);
    let shape = outer.and_then(|outer| shape::read(root, outer, version, notes));
    let tilt = outer.and_then(|outer| Tilt::read(blade, outer, (version, text), notes));
    let structure = structure?;
    let places = Places::new(structure, version, tilt.as_ref(), notes);
    let (used, parts) = layers::read(structure, root, &places, notes);
    known::report_others(structure, version, notes);
    let constants = materials::constants(root, &used, materials, notes);
    let (shape, (layers, webs, named)) = (shape?, parts?);
    for (line, problem) in wrong_names(&layers, &webs, &[]) {
        let location = SourceLocation::line(&file, line);
        let _: Option<()> = notes
            .problems
            .keep(Err(Diagnostics::one(location, &problem)));
    }
    let shape_line = outer.map_or(1, |outer| outer.line);
    let layup = Layup {
        name: None,
        shape,
        places: named,
        layers,
        webs,
        fills: Vec::new(),
        size: None,
        line: tilt.as_ref().map(|tilt| tilt.line.clone()),
        stations: Vec::new(),
        constants: super::constants::constants(&constants?),
        unit: 1.0,
        remarks: Vec::new(),
        file,
        shape_line,
        size_line: shape_line,
    };
    let mut layup = seam::with_used_places(layup);
    // A layup file with such a web is refused.
    for (line, problem) in layup.idle_webs() {
        layup.webs.retain(|web| web.line != line);
        notes.remarks.push(format!("{problem}: it is not meshed"));
    }
    for (line, problem) in layup.wrong_ends() {
        let location = SourceLocation::line(&layup.file, line);
        let _: Option<()> = notes
            .problems
            .keep(Err(Diagnostics::one(location, &problem)));
    }
    compare(&layup, &places, notes);
    notes.remarks.extend(fiber_sign(&layup.layers));
    Some(layup)
}

/// The sign of the fiber angles, as windIO states it, of which other programs take another one: angles of
/// layers that are not of webs.
fn fiber_sign(layers: &[WrittenLayer]) -> Option<String> {
    let inclined = layers
        .iter()
        .filter(|layer| !layer.fiber_angle.is_zero() && layer.web.is_none());
    let names: Vec<&String> = inclined.map(|layer| &layer.name).collect();
    (!names.is_empty()).then(|| {
        format!(
            "fiber angles are from the span toward the leading edge on both sides, as windIO states; along \
             the contour, as other programs take them, they are with toward = \"contour\" in a layup \
             file: {}",
            quoted(&names)
        )
    })
}

/// Reports where two rules for one place differ.
fn compare(layup: &Layup, places: &Places<'_>, notes: &mut Notes) {
    let doubts = places.doubts.take();
    if doubts.is_empty() {
        return;
    }
    let etas = (0..=COMPARED).map(|i| i as f64 / COMPARED as f64);
    let resolvers: Vec<_> = etas
        .filter_map(|eta| Some((eta, Resolver::new(layup, eta).ok()?)))
        .collect();
    for Doubt {
        what,
        line,
        rules,
        pair,
    } in doubts
    {
        let mut worst = (0.0, String::new());
        for (eta, resolver) in &resolvers {
            if !pair.iter().all(|place| place.covers(*eta)) {
                continue;
            }
            let [Some(used), Some(other)] = pair.each_ref().map(|place| resolver.place(place))
            else {
                continue;
            };
            // The shorter way, which may be over the trailing edge.
            let apart = (used[0] - other[0]).abs();
            let difference = apart.min((1.0 - apart).abs()) * used[1];
            if difference > worst.0 {
                let values = format!(
                    "{:.4} by {}, {:.4} by {} at eta {eta}",
                    used[0], rules[0], other[0], rules[1]
                );
                worst = (difference, values);
            }
        }
        if worst.0 > SAME_PLACE {
            let percent = (100.0 * worst.0).round();
            notes.remarks.push(format!(
                "line {line}: of two rules for {what} the first is used; they differ by {percent} % of \
                 the chord: {}",
                worst.1
            ));
        }
    }
}

/// A remark on a table that has no values at the root or the tip.
fn remark_on_ends((what, line): (&str, usize), positions: &[f64], notes: &mut Notes) {
    let (Some(&first), Some(&last)) = (positions.first(), positions.last()) else {
        return;
    };
    if first > OPEN {
        notes.remarks.push(format!(
            "line {line}: {what} begins at {first}: its first value is taken from the root on"
        ));
    }
    if last < 1.0 - OPEN {
        notes.remarks.push(format!(
            "line {line}: {what} ends at {last}: its last value is taken up to the tip"
        ));
    }
}

/// The value of `key` in the table `node`, which is called `parent`; notes a missing key.
fn required<'n>(node: &'n Node, parent: &str, key: &str, notes: &mut Notes) -> Option<&'n Node> {
    yaml::required(node, parent, key, &mut notes.problems)
}

/// The items of a list; notes another kind of value.
fn items<'n>(node: &'n Node, what: &str, notes: &mut Notes) -> Option<Vec<&'n Node>> {
    match &node.value {
        Value::List(items) => Some(items.iter().map(AsRef::as_ref).collect()),
        _ => {
            let help = "begin the items with \"-\"";
            notes.wrong(node.line, [what, &node.kind(), "a list", help]);
            None
        }
    }
}

/// The text of a required entry; notes problems.
fn word<'n>(node: &'n Node, parent: &str, key: &str, notes: &mut Notes) -> Option<&'n str> {
    let found = required(node, parent, key, notes)?;
    if found.text().is_none() {
        let what = format!("\"{key}\" of {parent}");
        notes.wrong(found.line, [&what, &found.kind(), "a text", "write a name"]);
    }
    found.text()
}

/// A table along the span; notes problems.
fn course(node: &Node, what: &str, notes: &mut Notes) -> Option<Course> {
    let column = windio_fields::column(node, what, &mut notes.problems)?;
    let grid = column.grid.iter().map(|eta| eta.clamp(0.0, 1.0)).collect();
    Some(Course::monotone(grid, column.values))
}
