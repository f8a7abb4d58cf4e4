//! Blades: a card for whole lines of beams, their roots and their masses.

use nalgebra::Vector3;
use shared_geom::document::schema::TableSchema;
use shared_geom::document::schema::ValueKind::{Boolean, Tables};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;

use super::beam_card::Beam;
use super::beam_check::BeamCheck;
use super::draft::Draft;
use super::formulation::{self, FORMULATION, INERTIA, INTERPOLATION, Inertia};
use super::transient::{
    ANGULAR_VELOCITY, INITIAL_WEIGHT, VELOCITY, VELOCITY_WEIGHT, initial_motion,
};
use crate::case::{BladeNodes, InitialMotion};
use crate::elements::beams::{BeamGeometry, BeamNode, Formulation};
use crate::elements::bodies::RigidInertia;
use crate::model::Node;

mod hinges;
mod laid;
mod masses;
mod mesh;
mod piece_line;
mod pieces;
mod problem;
mod seats;
mod source;
mod stations;

#[cfg(test)]
mod tests;

pub use problem::BladeProblem;

use hinges::BladeHinge;
use laid::Laid;
use masses::PointMass;
use seats::Seat;
use source::Source;

/// Blades of a rotor.
pub(super) const CARD: TableSchema = TableSchema {
    title: "[[blade]]",
    meaning: "One blade or several equal ones, with nodes, beams, root and masses.",
    keys: &[
        seats::NAME.schema,
        seats::HUB_RADIUS.schema,
        seats::ROOT.schema,
        seats::AZIMUTH.schema,
        seats::COUNT.schema,
        seats::AZIMUTHS.schema,
        seats::NAMES.schema,
        seats::PRECONE.schema,
        seats::PITCH.schema,
        FORMULATION.schema,
        INTERPOLATION.schema,
        INERTIA.schema,
        CLAMP_ROOT.schema,
        HINGES.schema,
        MASS.schema,
        VELOCITY.schema,
        ANGULAR_VELOCITY.schema,
        INITIAL_WEIGHT.schema,
        VELOCITY_WEIGHT.schema,
    ],
    families: &[pieces::PIECES, stations::STATIONS],
};

keys! {
    /// Whether the root is clamped to the frame, or to the hub if it has a support.
    CLAMP_ROOT: ByHand = "clamp_root", [Boolean], or "true without `hinges`", "false";
    /// Hinges between hub and root, from the hub outward.
    HINGES: ByHand = "hinges", [Tables(&hinges::CARD)], optional, "";
    /// Point masses on every blade of the card.
    MASS: ByHand = "mass", [Tables(&masses::CARD)], optional, "";
}

/// Attachment of the root of a blade.
enum Root {
    /// Clamped to the hub.
    Clamped,
    /// Not attached by this card.
    Free,
    /// By hinges, from the hub outward.
    Hinged(Vec<BladeHinge>),
}

/// The blades of a card.
struct Card {
    name: String,
    seats: Vec<Seat>,
    laid: Laid,
    formulation: (Formulation, Inertia),
    root: Root,
    /// Motion at the start.
    initial: InitialMotion,
    /// Index of the node that carries it, and the inertia about that node.
    masses: Vec<(usize, RigidInertia)>,
}

/// Adds every `[[blade]]` to the model.
pub(super) fn read(root: &Table<'_>, draft: &mut Draft) {
    for table in root.tables("blade") {
        let places = seats::places(&table);
        let mut are_new = true;
        for (name, _) in places.iter().flatten() {
            are_new &= draft.take_label("blade", name, &table);
        }
        let card = card(&table, draft, places.as_ref());
        table.finish();
        match card {
            Some(card) if are_new => {
                for seat in &card.seats {
                    add(&card, seat, &table, draft);
                }
                let names = card.seats.iter().map(|seat| seat.name.clone()).collect();
                draft.add_blade_card(card.name, names);
            }
            Some(_) => draft.note_broken(),
            None => note_broken(places, &table, draft),
        }
    }
}

/// Notes the names of blades that could not be read.
fn note_broken(places: Option<seats::Places>, table: &Table<'_>, draft: &mut Draft) {
    draft.note_broken();
    let names = places.into_iter().flatten().map(|place| place.0);
    for name in names.chain(table.text("name")) {
        draft.note_broken_blade(&name);
    }
}

fn card(table: &Table<'_>, draft: &mut Draft, places: Option<&seats::Places>) -> Option<Card> {
    let name = match table.has("name") {
        true => table.text("name").unwrap_or_default(),
        false => String::new(),
    };
    let seats = seats::read(table, draft, places);
    let formulation = formulation::read(table);
    let root = root(table, &name, draft);
    let masses = masses::read(table);
    let initial = initial_motion(table);
    let source = source::read(table, draft, &name)?;
    let (laid, masses) = lay(&source, &masses?, table, &name, draft)?;
    Some(Card {
        name,
        seats: seats?,
        laid,
        formulation: formulation?,
        root: root?,
        initial: initial?,
        masses,
    })
}

/// Nodes and beams of a blade, and its masses on them.
fn lay(
    source: &Source,
    masses: &[PointMass],
    table: &Table<'_>,
    name: &str,
    draft: &mut Draft,
) -> Option<(Laid, Vec<(usize, RigidInertia)>)> {
    let length = source.length();
    let places: Vec<_> = masses
        .iter()
        .map(|mass| mass.place(length, table))
        .collect();
    let places: Vec<f64> = places.into_iter().collect::<Option<_>>()?;
    let laid = source.lay(&places, table)?;
    let on_nodes = masses.iter().zip(&places);
    let remarks = on_nodes.clone().enumerate();
    let remarks =
        remarks.filter_map(|(number, (mass, place))| mass.remark(*place, &laid, number, name));
    draft.add_remarks(remarks.collect());
    let on_nodes = on_nodes.map(|(mass, place)| mass.on_node(*place, source, &laid));
    let masses = on_nodes.collect();
    Some((laid, masses))
}

fn root(table: &Table<'_>, name: &str, draft: &Draft) -> Option<Root> {
    let hinges = match table.has("hinges") {
        true => Some(hinges::read(table, draft.drives())?),
        false => None,
    };
    if !table.has("clamp_root") {
        return Some(match hinges {
            Some(hinges) if !hinges.is_empty() => Root::Hinged(hinges),
            _ => Root::Clamped,
        });
    }
    let clamped = table.boolean("clamp_root")?;
    if hinges.is_some_and(|hinges| !hinges.is_empty()) {
        let blade = name.to_owned();
        table.note("clamp_root", &BladeProblem::HingesAndClamp { blade });
        return None;
    }
    Some(match clamped {
        true => Root::Clamped,
        false => Root::Free,
    })
}

/// Adds nodes, beams, masses and the root of one blade to the model.
fn add(card: &Card, seat: &Seat, table: &Table<'_>, draft: &mut Draft) {
    let nodes = add_nodes(card, seat, table, draft);
    if nodes.len() != card.laid.nodes.len() {
        // A name is taken already, which has been noted.
        return draft.note_loose_end();
    }
    if !add_beams(card, seat, &nodes, table, draft) {
        return draft.note_loose_end();
    }
    set_initial(&card.initial, &nodes, draft);
    for (number, (node, inertia)) in card.masses.iter().enumerate() {
        let label = format!("{}/mass {}", seat.name, number + 1);
        draft.add_body(label, nodes[*node], *inertia);
    }
    match &card.root {
        Root::Clamped => draft.hold_root(nodes[0], table, "clamp_root"),
        Root::Free => {}
        Root::Hinged(hinges) => match hinges::offsets(table, hinges, seat.radius) {
            Some(offsets) => hinges::add((hinges, &offsets), seat, nodes[0], table, draft),
            None => draft.note_loose_end(),
        },
    }
    draft.add_blade(BladeNodes {
        name: seat.name.clone(),
        azimuth: seat.azimuth,
        nodes,
    });
}

/// Gives the nodes of a blade the motion of a rigid body: its velocity at the center of rotation,
/// and its angular velocity.
fn set_initial(initial: &InitialMotion, nodes: &[usize], draft: &mut Draft) {
    let center = draft
        .hub()
        .map_or_else(Vector3::zeros, |hub| hub.spin().center);
    for &node in nodes {
        let arm = draft.nodes()[node].position - center;
        let spin = initial.angular_velocity;
        let velocity = match (initial.velocity, spin) {
            (None, None) => None,
            (velocity, spin) => {
                Some(velocity.unwrap_or_default() + spin.unwrap_or_default().cross(&arm))
            }
        };
        let initial = InitialMotion {
            velocity,
            ..*initial
        };
        draft.set_initial(node, initial);
    }
}

/// Adds the nodes of a blade; fewer if a name is taken already.
fn add_nodes(card: &Card, seat: &Seat, table: &Table<'_>, draft: &mut Draft) -> Vec<usize> {
    let last = card.laid.nodes.len().saturating_sub(1);
    let axes = seat.blade_axes();
    let mut nodes = Vec::with_capacity(card.laid.nodes.len());
    for (number, laid) in card.laid.nodes.iter().enumerate() {
        let name = |end: &dyn std::fmt::Display| format!("{}/{end}", seat.name);
        let (label, alias) = match number {
            0 => (name(&"root"), Some(name(&0))),
            _ if number == last => (name(&"tip"), Some(name(&number))),
            _ => (name(&number), None),
        };
        let node = Node {
            label,
            position: seat.root + axes * laid.position,
            rotation: axes * laid.axes,
        };
        let Some(index) = draft.add_node(node, table, Some(seat.axes)) else {
            continue;
        };
        if let Some(alias) = alias {
            draft.name_node(&alias, Some(index), table);
        }
        nodes.push(index);
    }
    nodes
}

/// Adds the beams of a blade; returns false if one cannot be added, which is noted.
fn add_beams(
    card: &Card,
    seat: &Seat,
    nodes: &[usize],
    table: &Table<'_>,
    draft: &mut Draft,
) -> bool {
    let key = if table.has("piece") { "piece" } else { "file" };
    let (formulation, inertia) = card.formulation;
    for (number, laid) in card.laid.beams.iter().enumerate() {
        let beam = Beam {
            label: format!("{}/beam {}", seat.name, number + 1),
            nodes: std::array::from_fn(|k| nodes[2 * number + k]),
            geometry: BeamGeometry::new(laid.orientations.map(|orientation| BeamNode {
                offset: Vector3::zeros(),
                orientation,
            }))
            .formulated(formulation),
            along: laid.along.clone(),
            inertia,
        };
        let words = format!("blade \"{}\"{}", seat.name, laid.part);
        if !BeamCheck::new(&words, &beam, draft.nodes()).note_on(table, key) {
            return false;
        }
        draft.add_beam(beam);
    }
    true
}
