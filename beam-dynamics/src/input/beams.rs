//! Explicit beams.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::schema::ValueKind::{Rows, Table as OneTable, Tables, Text, Texts};
use shared_geom::document::{ByHand, Key, Table};
use shared_geom::keys;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::beam_card::Beam;
use super::beam_check::BeamCheck;
use super::beam_properties::BeamProperties;
use super::beam_section::Properties;
use super::builder::ModelBuilder;
use super::curved_fit;
use super::ends;
use super::formulation;
use super::heat;
use super::laws::{self, LawProblem};
use super::problem::InputProblem;
use crate::elements::beams::{BeamGeometry, BeamNode};

keys! {
    /// A beam of three nodes.
    pub(super) CARD = "[[beam]]";
    /// Its name, for messages and output.
    NAME: Option<String> = "name", [Text], or "`beam` and its number", "\"arm\"";
    /// The names of three nodes along the beam, the middle one within 5 % of the middle.
    NODES: Vec<String> = "nodes", [Texts] as "the names of three nodes", required, "[\"root\", \"mid\", \"tip\"]";
    /// The name of properties; needed unless the beam has a `law`.
    PROPERTIES: Option<String> = "properties", [Text], optional, "\"strip\"";
    /// Law of the section in place of stiffness and damping of the properties, which then give
    /// only the mass.
    LAW: ByHand = "law", [OneTable(&laws::SECTION), Tables(&laws::SECTION)], optional, "";
    /// Offsets of the beam from its three nodes, in the axes of the nodes.
    OFFSETS: [[f64; 3]; 3] = "offsets", [Rows(3, 3)], or "zero" = [[0.0; 3]; 3], "[[0, 0, 0], [0, 0.1, 0], [0, 0.1, 0]]";
    /// Rotation vectors from the axes of the three nodes to the axes of the section, x along the
    /// beam.
    SECTION_AXES: [[f64; 3]; 3] = "section_axes", [Rows(3, 3)], or "zero" = [[0.0; 3]; 3],
        "[[0, 0, 90], [0, 0, 90], [0, 0, 90]]";
    with formulation::FORMULATION.schema, formulation::INTERPOLATION.schema,
        formulation::INERTIA.schema, heat::HEAT[0], heat::HEAT[1];
}

/// Adds every `[[beam]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("beam").iter().enumerate() {
        let label = ends::label(table, &NAME, "beam", number);
        let is_new = builder.take_label("beam", &label, table);
        let beam = beam(table, builder, label);
        table.finish();
        let sound = |beam: &Beam| {
            let words = format!("beam \"{}\"", beam.label);
            BeamCheck::new(&words, beam, builder.nodes()).note_on(table, NODES.name())
        };
        let beam = beam.filter(sound);
        match beam.filter(|beam| curved_fit::suits_beam(beam, table, builder)) {
            Some(beam) if is_new => builder.add_beam(beam),
            _ => builder.note_broken(),
        }
    }
}

fn beam(table: &Table<'_>, builder: &mut ModelBuilder, label: String) -> Option<Beam> {
    let words = format!("beam \"{label}\"");
    let nodes = nodes(table, builder, &words);
    let properties = properties(table, builder, &words);
    let formulation = formulation::read(table);
    let geometry = geometry(table);
    let (formulation, inertia) = formulation?;
    Some(Beam {
        label,
        nodes: nodes?,
        geometry: geometry?.formulated(formulation),
        properties: properties?,
        inertia,
    })
}

/// The properties of a beam, and its law if it has one.
fn properties(
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    words: &str,
) -> Option<BeamProperties> {
    let properties = if table.has(&PROPERTIES) {
        Some(builder.find_properties(table, &PROPERTIES, words))
    } else {
        None
    };
    if table.has(&LAW) {
        let is_named = properties.is_some();
        let known = properties.flatten();
        if known
            .as_ref()
            .is_some_and(|found| found.prestress.is_some())
        {
            let problem = LawProblem::LawAndPrestress {
                beam: words.to_owned(),
            };
            table.note(&LAW, &problem);
            return None;
        }
        let law = laws::of_section(table, builder.drives(), words, known.as_ref())?;
        if let Some(properties) = known {
            let properties = Properties {
                law: Some(law),
                ..properties
            };
            let heated = heat::read(table, Some(properties), builder.drives(), words)?;
            return Some(BeamProperties::constant(&heated));
        }
        heat::refuse_without_properties(table, words)?;
        return (!is_named).then(|| BeamProperties::of_law(law, None));
    }
    if properties.is_none() {
        let _ = table.require_item(&PROPERTIES, "the name of properties");
    }
    let heated = heat::read(table, properties?, builder.drives(), words)?;
    Some(BeamProperties::constant(&heated))
}

fn nodes(table: &Table<'_>, builder: &mut ModelBuilder, words: &str) -> Option<[usize; 3]> {
    let Some(names) = table.get(&NODES) else {
        builder.note_loose_end();
        return None;
    };
    let found: Vec<_> = names
        .iter()
        .map(|name| builder.find_node(name, table, NODES.name(), words))
        .collect();
    let [first, middle, last] = found[..] else {
        let expected = "three: first, middle and last";
        let problem = ends::count(NODES.name(), names.len(), expected);
        table.note(&NODES, &problem);
        builder.note_loose_end();
        return None;
    };
    let nodes = [first?, middle?, last?];
    let twice = (1..3).find(|&k| nodes[..k].contains(&nodes[k]));
    if let Some(k) = twice {
        let node = builder.nodes()[nodes[k]].label.clone();
        let beam = words.to_owned();
        table.note(&NODES, &InputProblem::NodeTwice { beam, node });
        builder.note_loose_end();
        return None;
    }
    Some(nodes)
}

/// Offsets and section axes, both in the axes of the nodes.
fn geometry(table: &Table<'_>) -> Option<BeamGeometry> {
    let offsets = vectors(table, &OFFSETS, Dimension::LENGTH);
    let turns = vectors(table, &SECTION_AXES, Dimension::ANGLE);
    let (offsets, turns) = (offsets?, turns?);
    Some(BeamGeometry::new(std::array::from_fn(|k| BeamNode {
        offset: offsets[k],
        orientation: if turns[k] == Vector3::zeros() {
            Matrix3::identity()
        } else {
            vector::to_rotation(&turns[k])
        },
    })))
}

/// One vector for each node, in SI units; zeros when absent.
fn vectors(
    table: &Table<'_>,
    key: &Key<[[f64; 3]; 3]>,
    dimension: Dimension,
) -> Option<[Vector3<f64>; 3]> {
    let factor = table.document().factor(dimension);
    let rows = table.get(key)?;
    Some(rows.map(|row| Vector3::from(row) * factor))
}
