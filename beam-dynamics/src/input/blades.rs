//! Blades: a card for a whole line of beams.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::along::Along;
use super::beam_check::BeamCheck;
use super::blade_line::{BladeLine, Piece};
use super::draft::{Beam, Draft, Inertia};
use super::problem::InputProblem;
use super::properties::Properties;
use crate::case::BladeNodes;
use crate::elements::beams::{BeamGeometry, BeamNode};
use crate::model::Node;

/// Beams of one piece: more are a slip of the pen.
const MOST_ELEMENTS: usize = 1000;

/// A blade as its card means it.
struct Blade {
    name: String,
    azimuth: f64,
    line: BladeLine,
    /// Properties of each piece.
    properties: Vec<Properties>,
    inertia: Inertia,
    clamp_root: bool,
}

/// Adds every `[[blade]]` to the model.
pub(super) fn read(root: &Table<'_>, draft: &mut Draft) {
    for table in root.tables("blade") {
        let name = table.require_text("name", "the name of the blade");
        let is_new = name
            .as_ref()
            .is_some_and(|name| draft.take_label("blade", name, &table));
        let blade = blade(&table, draft, name.as_deref());
        table.finish();
        match (blade, name) {
            (Some(blade), _) if is_new => add(&blade, &table, draft),
            (None, Some(name)) => draft.note_broken_blade(&name),
            _ => draft.note_broken(),
        }
    }
}

fn blade(table: &Table<'_>, draft: &mut Draft, name: Option<&str>) -> Option<Blade> {
    let words = format!("blade \"{}\"", name.unwrap_or_default());
    let root = match table.has("root") {
        true => table.vector("root", Dimension::LENGTH),
        false => Some(Vector3::zeros()),
    };
    let azimuth = angle(table, "azimuth");
    let precone = shallow(table, "precone");
    let pitch = angle(table, "pitch");
    let inertia = Inertia::read(table);
    let clamp_root = match table.has("clamp_root") {
        true => table.boolean("clamp_root"),
        false => Some(true),
    };
    let is_named = table.has("properties");
    let default = Fallback {
        is_named,
        properties: is_named
            .then(|| draft.find_properties(table, &words))
            .flatten(),
    };
    let (pieces, properties) = pieces(table, draft, &words, default);
    let axes = axes(table, draft, azimuth?)?;
    let precone = vector::to_rotation(&Vector3::new(0.0, -precone?, 0.0));
    let line = BladeLine {
        root: draft.hub()?.at_azimuth(root?, azimuth?),
        axes: axes * precone,
        pitch: pitch?,
        pieces: pieces?,
    };
    Some(Blade {
        name: name?.to_owned(),
        azimuth: azimuth?,
        line,
        properties: properties?,
        inertia: inertia?,
        clamp_root: clamp_root?,
    })
}

/// Properties of the pieces that name none.
#[derive(Clone, Copy)]
struct Fallback {
    /// Whether the blade names any.
    is_named: bool,
    /// Those that it names; `None` when they are wrong.
    properties: Option<Properties>,
}

/// Axes of the blade at its azimuth, before precone.
fn axes(table: &Table<'_>, draft: &Draft, azimuth: f64) -> Option<Matrix3<f64>> {
    let axes = draft.hub()?.blade_axes(azimuth);
    if axes.is_none() {
        table.note("azimuth", &InputProblem::AxisAlongSpan);
    }
    axes
}

fn angle(table: &Table<'_>, key: &str) -> Option<f64> {
    match table.has(key) {
        true => table.quantity(key, Dimension::ANGLE),
        false => Some(0.0),
    }
}

/// An angle of less than a quarter turn; a line that leads back inward is a mistake.
fn shallow(table: &Table<'_>, key: &'static str) -> Option<f64> {
    let found = angle(table, key)?.to_degrees();
    if found.abs() < 90.0 {
        return Some(found.to_radians());
    }
    table.note(key, &InputProblem::SteepAngle { key, found });
    None
}

/// Geometry and properties of every piece; each is `None` when one of them is wrong.
fn pieces(
    blade: &Table<'_>,
    draft: &mut Draft,
    words: &str,
    default: Fallback,
) -> (Option<Vec<Piece>>, Option<Vec<Properties>>) {
    let tables = blade.tables("piece");
    if tables.is_empty() {
        let name = blade.text("name").unwrap_or_default();
        blade.note("piece", &InputProblem::NoPieces { blade: name });
        return (None, None);
    }
    let read: Vec<_> = tables
        .iter()
        .enumerate()
        .map(|(number, table)| {
            let words = format!("{words}, piece {}", number + 1);
            let properties = piece_properties(table, draft, &words, default);
            let piece = piece(table);
            table.finish();
            (piece, properties)
        })
        .collect();
    let (pieces, properties): (Vec<_>, Vec<_>) = read.into_iter().unzip();
    (
        pieces.into_iter().collect(),
        properties.into_iter().collect(),
    )
}

fn piece_properties(
    table: &Table<'_>,
    draft: &mut Draft,
    words: &str,
    default: Fallback,
) -> Option<Properties> {
    if table.has("properties") {
        return draft.find_properties(table, words);
    }
    if !default.is_named {
        let piece = words.to_owned();
        table.note("properties", &InputProblem::NoProperties { piece });
    }
    default.properties
}

fn piece(table: &Table<'_>) -> Option<Piece> {
    let length = table.require_positive("length", Dimension::LENGTH);
    let elements = table.require_count("elements").filter(|&found| {
        let (key, limit) = ("elements", MOST_ELEMENTS);
        if found > limit {
            table.note(key, &InputProblem::TooMany { key, found, limit });
        }
        found <= limit
    });
    let sweep = shallow(table, "sweep");
    let dihedral = shallow(table, "dihedral");
    let twist = twist(table);
    Some(Piece {
        length: length?,
        elements: elements?,
        sweep: sweep?,
        dihedral: dihedral?,
        twist: twist?,
    })
}

/// Twist at both ends; one number is that of both.
fn twist(table: &Table<'_>) -> Option<[f64; 2]> {
    if !table.has("twist") {
        return Some([0.0; 2]);
    }
    let numbers = table.quantities("twist", Dimension::ANGLE)?;
    match numbers[..] {
        [both] => Some([both; 2]),
        [inner, outer] => Some([inner, outer]),
        _ => {
            let (key, found) = ("twist", numbers.len());
            let expected = "one angle, or those at both ends";
            table.note(
                key,
                &InputProblem::Count {
                    key,
                    found,
                    expected,
                },
            );
            None
        }
    }
}

/// Adds nodes, beams and the clamp of a blade to the model.
fn add(blade: &Blade, table: &Table<'_>, draft: &mut Draft) {
    let laid = blade.line.lay();
    let last = laid.nodes.len() - 1;
    let mut nodes = Vec::with_capacity(laid.nodes.len());
    for (number, (position, rotation)) in laid.nodes.iter().enumerate() {
        let name = |end: &dyn std::fmt::Display| format!("{}/{end}", blade.name);
        let (label, alias) = match number {
            0 => (name(&"root"), Some(name(&0))),
            _ if number == last => (name(&"tip"), Some(name(&number))),
            _ => (name(&number), None),
        };
        let node = Node {
            label,
            position: *position,
            rotation: *rotation,
        };
        let Some(index) = draft.add_node(node, table, Some(blade.line.axes)) else {
            continue;
        };
        if let Some(alias) = alias {
            draft.name_node(&alias, Some(index), table);
        }
        nodes.push(index);
    }
    if nodes.len() != laid.nodes.len() {
        // A name was taken, which has been noted.
        return draft.note_loose_end();
    }
    for (number, laid) in laid.beams.iter().enumerate() {
        let beam = Beam {
            label: format!("{}/beam {}", blade.name, number + 1),
            nodes: std::array::from_fn(|k| nodes[2 * number + k]),
            geometry: BeamGeometry {
                nodes: laid.orientations.map(|orientation| BeamNode {
                    offset: Vector3::zeros(),
                    orientation,
                }),
            },
            along: Along::constant(&blade.properties[laid.piece]),
            inertia: blade.inertia,
        };
        let words = format!("blade \"{}\", piece {}", blade.name, laid.piece + 1);
        match BeamCheck::new(&words, &beam, draft.nodes()).note_on(table, "piece") {
            true => draft.add_beam(beam),
            false => return draft.note_loose_end(),
        }
    }
    if blade.clamp_root {
        draft.hold_root(nodes[0], table, "clamp_root");
    }
    draft.add_blade(BladeNodes {
        name: blade.name.clone(),
        azimuth: blade.azimuth,
        nodes,
    });
}
