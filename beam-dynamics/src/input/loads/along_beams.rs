//! Loads along blades and beams.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{Quantities, Text, Texts, Vector, Vectors, Word};
use shared_geom::document::{Key, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::{CONSTANT, DRIVE, FOLLOWER, LoadProblem, RELEASE, kind, label};
use crate::elements::Signal;
use crate::elements::beams::{BeamGeometry, DistributedLoad, LineLoad};
use crate::elements::loads::{LoadFactor, Turning};
use crate::input::beam_card::Beam;
use crate::input::builder::ModelBuilder;
use crate::input::drives;
use crate::input::frames::{Frame, IN};
use crate::model::Node;

keys! {
    /// A load along a blade or along beams.
    pub(in crate::input) CARD = "[[distributed_load]]";
    /// Its name, for messages.
    NAME: Option<String> = "name", [Text], or "`distributed load` and its number", "\"lift\"";
    /// Force per undeformed length: a vector, or at most six coefficients of the powers of the arc
    /// length over the length of the line, or with `at` a row for each position.
    FORCE: Option<Vec<Vector3<f64>>> = "force",
        [Vector(3, Dimension::FORCE_PER_LENGTH), Vectors(3, Dimension::FORCE_PER_LENGTH)],
        optional, "[[0, 0, 0], [0, 0, 10]]";
    /// Moment per undeformed length, in the same form; one of force and moment is needed.
    MOMENT: Option<Vec<Vector3<f64>>> = "moment", [Vector(3, Dimension::FORCE), Vectors(3, Dimension::FORCE)],
        optional, "[0, 2, 0]";
    /// Ascending arc lengths of a table, linear between them and zero beyond; a repeated one is a
    /// jump.
    AT: Option<Vec<f64>> = "at", [Quantities(Dimension::LENGTH)], optional, "[0, 10]";
    /// Axes of the components: the model, or the undeformed section.
    AXES: usize = "axes", [Word(&["model", "section"])], or "\"model\"" = 0, "\"section\"";
    with BLADE.schema, BEAMS.schema, FOLLOWER.schema, CONSTANT.schema, RELEASE.schema,
        DRIVE.schema, IN.schema;
}

keys! {
    /// The name of a blade; either this or `beams`.
    pub(in crate::input) BLADE: Option<String> = "blade", [Text], optional, "\"blade\"";
    /// The names of beams, in the order of the line.
    pub(in crate::input) BEAMS: Option<Vec<String>> = "beams", [Texts], optional,
        "[\"arm\", \"blade/beam 3\"]";
}

/// Coefficients of a polynomial: the fifth degree is integrated exactly.
const COEFFICIENTS: usize = 6;
/// Part of the line's length by which a position may lie beyond the end: digits lost in the
/// input.
const ROUNDING: f64 = 1e-6;

/// Distribution along a line.
#[derive(Debug, Clone)]
enum Course {
    /// Coefficients of the powers of arc length over length.
    Polynomial(Vec<Vector3<f64>>),
    /// Values at arc lengths, linear between them, zero beyond.
    Table(Vec<(f64, Vector3<f64>)>),
}

/// The load of a card.
struct Card {
    /// The beams of each line.
    lines: Vec<Vec<usize>>,
    force: Course,
    moment: Course,
    kind: (Turning, LoadFactor),
    in_section: bool,
    frame: Frame,
    signal: Signal,
}

/// Adds every `[[distributed_load]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("distributed_load").iter().enumerate() {
        let label = label(table, &NAME, "distributed load", number);
        let is_new = builder.take_label("distributed load", &label, table);
        let card = card(table, builder, &label);
        table.finish();
        match card {
            Some(card) if is_new => {
                for beams in &card.lines {
                    for load in elements(&label, &card, beams, builder) {
                        builder.add_load(Box::new(load));
                    }
                }
            }
            _ => builder.note_broken(),
        }
    }
}

fn card(table: &Table<'_>, builder: &ModelBuilder, label: &str) -> Option<Card> {
    let lines = lines(table, builder, label);
    let in_section = table.get(&AXES);
    let kind = kind(table);
    let frame = builder.frames().of(table);
    let signal = drives::read_factor(table, &DRIVE.schema, builder.drives());
    let positions = positions(table);
    let force = course(table, &FORCE, &positions);
    let moment = course(table, &MOMENT, &positions);
    if !table.has(&FORCE) && !table.has(&MOMENT) {
        table.note("", &LoadProblem::NoLoad);
        return None;
    }
    let card = Card {
        lines: lines?,
        force: force?,
        moment: moment?,
        kind: kind?,
        in_section: in_section? == 1,
        frame: frame?,
        signal: signal?,
    };
    // All blades of a card have the same length.
    let length = card.lines.first().map_or(0.0, |line| length(line, builder));
    let beyond = positions.flatten().unwrap_or_default();
    let beyond = beyond
        .into_iter()
        .find(|position| *position < 0.0 || *position > length * (1.0 + ROUNDING));
    if let Some(found) = beyond {
        table.note(&AT, &LoadProblem::Beyond { found, length });
        return None;
    }
    Some(card)
}

/// Arc lengths of a table; `None` if they are wrong, `Some(None)` without a table.
fn positions(table: &Table<'_>) -> Option<Option<Vec<f64>>> {
    let Some(positions) = table.get(&AT)? else {
        return Some(None);
    };
    if positions.len() < 2 {
        let found = positions.len();
        table.note(&AT, &LoadProblem::FewPositions { found });
        return None;
    }
    if let Some(pair) = positions.windows(2).find(|pair| pair[1] < pair[0]) {
        let (before, after) = (pair[0], pair[1]);
        table.note(&AT, &LoadProblem::Falling { before, after });
        return None;
    }
    if positions.first() == positions.last() {
        table.note(
            &AT,
            &LoadProblem::OnePosition {
                position: positions[0],
            },
        );
        return None;
    }
    Some(Some(positions))
}

fn course(
    table: &Table<'_>,
    key: &Key<Option<Vec<Vector3<f64>>>>,
    positions: &Option<Option<Vec<f64>>>,
) -> Option<Course> {
    let Some(rows) = table.get(key)? else {
        return Some(Course::Polynomial(Vec::new()));
    };
    let key = key.name();
    let found = rows.len();
    let Some(positions) = positions.as_ref()? else {
        if found > COEFFICIENTS {
            let limit = COEFFICIENTS;
            table.note(key, &LoadProblem::Degree { key, found, limit });
            return None;
        }
        return Some(Course::Polynomial(rows));
    };
    let expected = positions.len();
    if found != expected {
        let problem = LoadProblem::Rows {
            key,
            found,
            expected,
        };
        table.note(key, &problem);
        return None;
    }
    Some(Course::Table(positions.iter().copied().zip(rows).collect()))
}

/// The beams of a card, in order along one line.
pub(in crate::input) fn beams(
    table: &Table<'_>,
    builder: &ModelBuilder,
    label: &str,
) -> Option<Vec<usize>> {
    let name = table.get(&BLADE).flatten();
    let is_of_card = |name: &String| builder.blades_called(name).len() > 1;
    if let Some(name) = name.filter(is_of_card) {
        note_unknown_blade(table, builder, label, name);
        return None;
    }
    lines(table, builder, label)?.into_iter().next()
}

/// The beams of each line of a card, in order along it: of a blade, of all blades of a `[[blade]]`,
/// or of a list of beams.
fn lines(table: &Table<'_>, builder: &ModelBuilder, label: &str) -> Option<Vec<Vec<usize>>> {
    match (table.has(&BLADE), table.has(&BEAMS)) {
        (false, false) => table.note("", &LoadProblem::NoLine),
        (true, true) => table.note(&BEAMS, &LoadProblem::BladeAndBeams),
        (true, false) => {
            let name = table.get(&BLADE)??;
            if builder.is_broken_blade(&name) {
                return None;
            }
            let blades = builder.blades_called(&name);
            if blades.is_empty() {
                note_unknown_blade(table, builder, label, name);
                return None;
            }
            let lines = blades.iter().map(|blade| builder.beams_of(blade));
            return Some(lines.collect());
        }
        (false, true) => return named_beams(table, builder, label).map(|line| vec![line]),
    }
    None
}

fn note_unknown_blade(table: &Table<'_>, builder: &ModelBuilder, label: &str, name: String) {
    let known = builder.blades().iter().map(|blade| blade.name.clone());
    let problem = LoadProblem::UnknownLine {
        kind: "blade",
        name,
        user: label.to_owned(),
        known: known.collect(),
    };
    table.note(&BLADE, &problem);
}

/// The beams under `beams` of a card, in order along the line.
pub(in crate::input) fn named_beams(
    table: &Table<'_>,
    builder: &ModelBuilder,
    label: &str,
) -> Option<Vec<usize>> {
    let mut found: Vec<usize> = Vec::new();
    for name in table.get(&BEAMS)?? {
        let index = builder.beams().iter().position(|beam| beam.label == name);
        let Some(index) = index else {
            let known = builder.beams().iter().map(|beam| beam.label.clone());
            let problem = LoadProblem::UnknownLine {
                kind: "beam",
                name,
                user: label.to_owned(),
                known: known.collect(),
            };
            table.note(&BEAMS, &problem);
            return None;
        };
        if found.contains(&index) {
            table.note(&BEAMS, &LoadProblem::BeamTwice { name });
            return None;
        }
        found.push(index);
    }
    if found.is_empty() {
        table.note(&BEAMS, &LoadProblem::NoBeams);
        return None;
    }
    Some(found)
}

fn ends<'a>(beam: &Beam, builder: &'a ModelBuilder) -> [&'a Node; 3] {
    beam.nodes.map(|node| &builder.nodes()[node])
}

fn length(beams: &[usize], builder: &ModelBuilder) -> f64 {
    let of_beam = |index: &usize| {
        let beam = &builder.beams()[*index];
        beam.geometry.length(&ends(beam, builder))
    };
    beams.iter().map(of_beam).sum()
}

fn elements(
    label: &str,
    card: &Card,
    beams: &[usize],
    builder: &ModelBuilder,
) -> Vec<DistributedLoad> {
    let whole = length(beams, builder);
    let mut start = 0.0;
    let mut loads = Vec::with_capacity(beams.len());
    for &index in beams {
        let beam = &builder.beams()[index];
        let ends = ends(beam, builder);
        let arc = |xi: f64| start + beam.geometry.arc_length(&ends, xi);
        let kinks = kinks(card, &beam.geometry, &ends, start);
        let load = |xi: f64| -> LineLoad {
            let s = arc(xi);
            let turn = if card.in_section {
                Some(beam.geometry.section_axes(&ends, xi))
            } else {
                None
            };
            [&card.force, &card.moment].map(|course| {
                let value = course.at(s, whole);
                turn.map_or(card.frame.direction(&value), |axes| axes * value)
            })
        };
        let name = format!("{label} on {}", beam.label);
        let (nodes, geometry) = (beam.nodes, beam.geometry);
        let load = DistributedLoad::new(name, nodes, geometry, ends, card.kind, &kinks, load);
        loads.push(load.driven(card.signal.clone()));
        start += beam.geometry.length(&ends);
    }
    loads
}

/// Values of xi of the rows of tables inside a beam that begins at arc length `start`.
fn kinks(card: &Card, geometry: &BeamGeometry, ends: &[&Node; 3], start: f64) -> Vec<f64> {
    let length = geometry.length(ends);
    let mut found = Vec::new();
    for course in [&card.force, &card.moment] {
        let Course::Table(rows) = course else {
            continue;
        };
        let inside = rows.iter().map(|row| row.0 - start);
        let inside = inside.filter(|s| *s > 0.0 && *s < length);
        found.extend(inside.map(|s| geometry.position(ends, s)));
    }
    found
}

impl Course {
    /// The value at arc length `s` of a line of length `whole`.
    fn at(&self, s: f64, whole: f64) -> Vector3<f64> {
        match self {
            Self::Polynomial(coefficients) => {
                let powers = coefficients.iter().rev();
                powers.fold(Vector3::zeros(), |sum, c| sum * (s / whole) + c)
            }
            Self::Table(rows) => {
                let around = rows
                    .windows(2)
                    .find(|pair| pair[0].0 <= s && s <= pair[1].0);
                around.map_or_else(Vector3::zeros, |pair| {
                    let part = (s - pair[0].0) / (pair[1].0 - pair[0].0);
                    if part.is_finite() {
                        pair[0].1.lerp(&pair[1].1, part)
                    } else {
                        pair[0].1
                    }
                })
            }
        }
    }
}
