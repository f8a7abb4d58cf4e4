//! Blades: a card for whole lines of beams, their roots and their masses.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{
    Boolean, NotNegative, Table as OneTable, Tables, Word,
};
use shared_geom::document::schema::{KeySchema, TableSchema};
use shared_geom::document::{Declared, Nested, NestedList, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::beam_card::Beam;
use super::beam_check::BeamCheck;
use super::builder::ModelBuilder;
use super::formulation::{self, FORMULATION, INERTIA, INTERPOLATION, Inertia};
use super::frames::IN;
use super::strips::{self, BladeAir, BladeLine};
use super::transient::{
    ANGULAR_VELOCITY, INITIAL_WEIGHT, VELOCITY, VELOCITY_WEIGHT, initial_motion,
};
use crate::case::{BladeNodes, InitialMotion};
use crate::elements::beams::{BeamGeometry, BeamNode, Formulation};
use crate::elements::bodies::RigidInertia;
use crate::model::Node;

mod hinges;
mod layout;
mod masses;
mod mesh;
mod mirror;
mod mounts;
mod piece_line;
mod pieces;
mod problem;
mod source;
mod stations;

#[cfg(test)]
mod tests;

pub(in crate::input) use mounts::{HUB_RADIUS, remark_on_hub};
pub(in crate::input) use pieces::{ELEMENTS, LENGTH, PIECES};
pub use problem::BladeProblem;
pub(in crate::input) use stations::{BODY, STATIONS};

use hinges::BladeHinge;
use layout::BladeLayout;
use masses::PointMass;
use mounts::BladeMount;
use source::Source;

/// Blades of a rotor.
pub(super) const CARD: TableSchema = TableSchema {
    title: "[[blade]]",
    meaning: "One blade or several equal ones, with nodes, beams, root and masses.",
    keys: &[
        mounts::NAME.schema,
        mounts::HUB_RADIUS.schema,
        mounts::ROOT.schema,
        mounts::AZIMUTH.schema,
        mounts::COUNT.schema,
        mounts::AZIMUTHS.schema,
        mounts::NAMES.schema,
        mounts::PRECONE.schema,
        mounts::PITCH.schema,
        FORMULATION.schema,
        INTERPOLATION.schema,
        INERTIA.schema,
        CLAMP_ROOT.schema,
        PART.schema,
        MIRROR.schema,
        HINGES.schema,
        MASS.schema,
        AERODYNAMICS.schema,
        VELOCITY.schema,
        ANGULAR_VELOCITY.schema,
        INITIAL_WEIGHT.schema,
        VELOCITY_WEIGHT.schema,
        IN.schema,
    ],
    families: &[PIECES, STATIONS],
};

/// The blade of a rotor, without the keys that follow from the rotor.
pub(super) const OF_ROTOR: TableSchema = TableSchema {
    title: "[rotor.blade]",
    meaning: "The blade, of which the rotor has several: keys of `[[blade]]`.",
    keys: &[
        mounts::HUB_RADIUS.schema,
        mounts::PRECONE.schema,
        mounts::PITCH.schema,
        FORMULATION.schema,
        INTERPOLATION.schema,
        INERTIA.schema,
        MASS.schema,
        AERODYNAMICS.schema,
    ],
    families: &[PIECES, STATIONS],
};

/// The flexbeam of a rotor, without the keys that follow from the rotor.
pub(super) const FLEXBEAM: TableSchema = TableSchema {
    title: "[rotor.flexbeam]",
    meaning: "The flexible beam between hub and blade, whose twist is the pitch: keys of `[[blade]]`.",
    keys: &[
        OFFSET.schema,
        mounts::PITCH.schema,
        FORMULATION.schema,
        INTERPOLATION.schema,
        INERTIA.schema,
        MASS.schema,
    ],
    families: &[PIECES, STATIONS],
};

keys! {
    /// Distance of its inner end from the center of the hub, along the blade.
    pub(super) OFFSET: f64 = "offset", [NotNegative(Dimension::LENGTH)], required, "0.1";
}

keys! {
    /// Whether the root is clamped to the frame, or to the hub if it has a support.
    CLAMP_ROOT: Option<bool> = "clamp_root", [Boolean], or "true without `hinges`", "false";
    /// Whether it is a part of another blade, such as a flexbeam: results and multiblade
    /// coordinates then do not count it as a blade; `"tower"` names modes after it.
    PART: Part = "part", [Boolean, Word(&[TOWER])] as "true, false or \"tower\"",
        or "false" = Part::No, "true";
    /// Whether all of the card is the mirror image in the plane of rotation, as of a lifting rotor that
    /// turns the other way: heights, precone, pitch, twist, airfoils, and the couplings of the sections.
    MIRROR: bool = "mirror", [Boolean], or "false" = false, "true";
    /// Hinges between hub and root, from the hub outward.
    HINGES: NestedList = "hinges", [Tables(&hinges::CARD)], optional, "";
    /// Strips of every blade of the card in the air.
    AERODYNAMICS: Nested = "aerodynamics", [OneTable(&strips::CARD)], optional, "";
    /// Point masses on every blade of the card.
    MASS: NestedList = "mass", [Tables(&masses::CARD)], optional, "";
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
    mounts: Vec<BladeMount>,
    layout: BladeLayout,
    /// The file of its sections, with its fingerprint.
    file: Option<String>,
    formulation: (Formulation, Inertia),
    root: Root,
    part: Part,
    /// Motion at the start, and the center about which it turns \[m\].
    initial: (InitialMotion, Vector3<f64>),
    /// Index of the node that carries it, and the inertia about that node.
    masses: Vec<(usize, RigidInertia)>,
    air: Option<BladeAir>,
}

/// Adds every `[[blade]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for table in root.tables("blade") {
        let named = mounts::named_azimuths(&table);
        let mut are_new = true;
        for (name, _) in named.iter().flatten() {
            are_new &= builder.take_label("blade", name, &table);
        }
        let card = card(&table, builder, named.as_ref());
        table.finish();
        match card {
            Some(card) if are_new => {
                for mount in &card.mounts {
                    add(&card, mount, &table, builder);
                }
                if let Some(air) = &card.air {
                    let blades = card.mounts.iter();
                    let blades = blades.map(|mount| (mount.name.as_str(), mount.blade_axes()));
                    strips::add(air, &blades.collect::<Vec<_>>(), builder);
                }
                let names = card.mounts.iter().map(|mount| mount.name.clone()).collect();
                builder.add_blade_card(card.name, names);
            }
            Some(_) => builder.note_broken(),
            None => note_broken(named, &table, builder),
        }
    }
}

/// Notes the names of blades that could not be read.
fn note_broken(
    named: Option<mounts::NamedAzimuths>,
    table: &Table<'_>,
    builder: &mut ModelBuilder,
) {
    builder.note_broken();
    let names = named.into_iter().flatten().map(|one| one.0);
    for name in names.chain(table.text("name")) {
        builder.note_broken_blade(&name);
    }
}

fn card(
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    named: Option<&mounts::NamedAzimuths>,
) -> Option<Card> {
    let name = if table.has("name") {
        table.text("name").unwrap_or_default()
    } else {
        String::new()
    };
    let mounts = mounts::read(table, builder, named);
    let formulation = formulation::read(table);
    let root = root(table, &name, builder);
    let part = part(table, &name);
    let masses = masses::read(table);
    let initial = initial(table, builder);
    let source = source::read(table, builder, &name);
    let precone = mounts.iter().flatten().next().map(|mount| mount.precone);
    let air = air(table, (&name, source.as_ref()), precone, builder);
    let source = source?;
    let radius = table.given(&HUB_RADIUS).unwrap_or_default();
    let remark = remark_on_hub(&format!("blade \"{name}\""), radius, source.length());
    builder.add_remarks(remark.into_iter().collect());
    let mirrors = mirror::read(table, &name);
    let (layout, masses) = lay(&source, &masses?, table, &name, builder)?;
    let (layout, masses, air) = match mirrors? {
        false => (layout, masses, air?),
        true => mirror::mirrored((layout, masses, air?), table, &name)?,
    };
    Some(Card {
        name,
        mounts: mounts?,
        layout,
        file: source.file().map(str::to_owned),
        formulation: formulation?,
        root: root?,
        part: part?,
        initial: initial?,
        masses,
        air,
    })
}

/// The part that a card is; parts have no strips.
fn part(table: &Table<'_>, name: &str) -> Option<Part> {
    let part = table.get(&PART)?;
    if part != Part::No && table.has(&AERODYNAMICS) {
        let problem = BladeProblem::Both {
            blade: format!("blade \"{name}\""),
            first: PART.name(),
            second: AERODYNAMICS.name(),
        };
        table.note(&AERODYNAMICS, &problem);
        return None;
    }
    Some(part)
}

/// Strips of a blade; on an endless line if its own is wrong, so that all problems are noted.
fn air(
    table: &Table<'_>,
    (name, source): (&str, Option<&Source>),
    precone: Option<f64>,
    builder: &mut ModelBuilder,
) -> Option<Option<BladeAir>> {
    if !table.has(&AERODYNAMICS) {
        return Some(None);
    }
    let air = table.table(&AERODYNAMICS)?;
    let line = BladeLine {
        length: source.map_or(f64::INFINITY, Source::length),
        position: &|at| match source {
            Some(source) => source.position(at),
            None => Vector3::new(at, 0.0, 0.0),
        },
        precone,
    };
    let strips = strips::read(&air, builder, (name, &line));
    if strips.is_none() {
        builder.note_broken_air();
    }
    strips.map(Some)
}

/// Nodes and beams of a blade, and its masses on them.
fn lay(
    source: &Source,
    masses: &[PointMass],
    table: &Table<'_>,
    name: &str,
    builder: &mut ModelBuilder,
) -> Option<(BladeLayout, Vec<(usize, RigidInertia)>)> {
    let length = source.length();
    let positions: Vec<_> = masses
        .iter()
        .map(|mass| mass.position(length, table))
        .collect();
    let positions: Vec<f64> = positions.into_iter().collect::<Option<_>>()?;
    let layout = source.lay(&positions, table)?;
    let on_nodes = masses.iter().zip(&positions);
    let remarks = on_nodes.clone().enumerate();
    let remarks = remarks
        .filter_map(|(number, (mass, position))| mass.remark(*position, &layout, number, name));
    builder.add_remarks(remarks.collect());
    let on_nodes = on_nodes.map(|(mass, position)| mass.on_node(*position, source, &layout));
    let masses = on_nodes.collect();
    Some((layout, masses))
}

fn root(table: &Table<'_>, name: &str, builder: &ModelBuilder) -> Option<Root> {
    let hinges = if table.has(&HINGES) {
        Some(hinges::read(table, builder.drives())?)
    } else {
        None
    };
    let Some(clamped) = table.get(&CLAMP_ROOT)? else {
        return Some(match hinges {
            Some(hinges) if !hinges.is_empty() => Root::Hinged(hinges),
            _ => Root::Clamped,
        });
    };
    if hinges.is_some_and(|hinges| !hinges.is_empty()) {
        let blade = name.to_owned();
        table.note(&CLAMP_ROOT, &BladeProblem::HingesAndClamp { blade });
        return None;
    }
    Some(if clamped { Root::Clamped } else { Root::Free })
}

/// Whether a card is a part of another blade or a tower.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    No,
    Other,
    Tower,
}

impl Declared for Part {}

/// Whether it is a part, or the word of a tower.
impl Value for Part {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if table.is_text(key) {
            return table.word(key.name, &[TOWER]).map(|_| Self::Tower);
        }
        let is_part = table.boolean(key.name)?;
        Some(if is_part { Self::Other } else { Self::No })
    }
}

/// The word of a part that is a tower.
pub(super) const TOWER: &str = "tower";

/// Adds nodes, beams, masses and the root of one blade to the model.
fn add(card: &Card, mount: &BladeMount, table: &Table<'_>, builder: &mut ModelBuilder) {
    let nodes = add_nodes(card, mount, table, builder);
    if nodes.len() != card.layout.nodes.len() {
        // A name is taken already, which has been noted.
        return builder.note_loose_end();
    }
    if !add_beams(card, mount, &nodes, table, builder) {
        return builder.note_loose_end();
    }
    set_initial((&card.initial.0, card.initial.1), &nodes, builder);
    for (number, (node, inertia)) in card.masses.iter().enumerate() {
        let label = format!("{}/mass {}", mount.name, number + 1);
        builder.add_body(label, nodes[*node], *inertia);
    }
    match &card.root {
        Root::Clamped => builder.hold_root(nodes[0], table, CLAMP_ROOT.name()),
        Root::Free => {}
        Root::Hinged(hinges) => match hinges::offsets(table, hinges, mount.radius) {
            Some(offsets) => hinges::add((hinges, &offsets), mount, nodes[0], table, builder),
            None => builder.note_loose_end(),
        },
    }
    match card.part {
        Part::No => builder.add_blade(BladeNodes {
            name: mount.name.clone(),
            azimuth: mount.azimuth,
            nodes,
            axes: mount.blade_axes(),
            file: card.file.clone(),
        }),
        Part::Tower => builder.add_tower(mount.axes),
        Part::Other => {}
    }
}

/// The motion of a card at the start, and the center about which it turns \[m\].
fn initial(table: &Table<'_>, builder: &ModelBuilder) -> Option<(InitialMotion, Vector3<f64>)> {
    let motion = initial_motion(table);
    let frame = builder.frames().of(table);
    let center = mounts::hub(table, builder).map(|hub| hub.frame_rotation().center);
    let (motion, frame) = (motion?, frame?);
    let turned = |vector: Vector3<f64>| frame.direction(&vector);
    let motion = InitialMotion {
        velocity: motion.velocity.map(turned),
        angular_velocity: motion.angular_velocity.map(turned),
        ..motion
    };
    Some((motion, center.unwrap_or_else(Vector3::zeros)))
}

/// Gives the nodes of a blade the motion of a rigid body: its velocity at the center of rotation,
/// and its angular velocity.
fn set_initial(
    (initial, center): (&InitialMotion, Vector3<f64>),
    nodes: &[usize],
    builder: &mut ModelBuilder,
) {
    for &node in nodes {
        let arm = builder.nodes()[node].position - center;
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
        builder.set_initial(node, initial);
    }
}

/// Adds the nodes of a blade; fewer if a name is taken already.
fn add_nodes(
    card: &Card,
    mount: &BladeMount,
    table: &Table<'_>,
    builder: &mut ModelBuilder,
) -> Vec<usize> {
    let last = card.layout.nodes.len().saturating_sub(1);
    let axes = mount.blade_axes();
    let mut nodes = Vec::with_capacity(card.layout.nodes.len());
    for (number, layout) in card.layout.nodes.iter().enumerate() {
        let name = |end: &dyn std::fmt::Display| format!("{}/{end}", mount.name);
        let (label, alias) = match number {
            0 => (name(&"root"), Some(name(&0))),
            _ if number == last => (name(&"tip"), Some(name(&number))),
            _ => (name(&number), None),
        };
        let node = Node {
            label,
            position: mount.root + axes * layout.position,
            rotation: axes * layout.axes,
        };
        let Some(index) = builder.add_node(node, table, Some(mount.axes)) else {
            continue;
        };
        if let Some(alias) = alias {
            builder.name_node(&alias, Some(index), table);
        }
        nodes.push(index);
    }
    nodes
}

/// Adds the beams of a blade; returns false if one cannot be added, which is noted.
fn add_beams(
    card: &Card,
    mount: &BladeMount,
    nodes: &[usize],
    table: &Table<'_>,
    builder: &mut ModelBuilder,
) -> bool {
    let key = if table.has("piece") { "piece" } else { "file" };
    let (formulation, inertia) = card.formulation;
    for (number, layout) in card.layout.beams.iter().enumerate() {
        let beam = Beam {
            label: format!("{}/beam {}", mount.name, number + 1),
            nodes: std::array::from_fn(|k| nodes[2 * number + k]),
            geometry: BeamGeometry::new(layout.orientations.map(|orientation| BeamNode {
                offset: Vector3::zeros(),
                orientation,
            }))
            .formulated(formulation),
            properties: layout.properties.clone(),
            inertia,
        };
        let words = format!("blade \"{}\"{}", mount.name, layout.part);
        if !BeamCheck::new(&words, &beam, builder.nodes()).note_on(table, key) {
            return false;
        }
        builder.add_beam(beam);
    }
    true
}
