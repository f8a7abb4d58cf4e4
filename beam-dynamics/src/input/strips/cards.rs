//! Strips of bodies and beams without a rotor: `[[strip]]`.
//!
//! The line of a strip goes along t, from `from` to `to` on a body, or along beams. With the
//! direction f of `forward`, normal to t,
//!
//! ```text
//! B = (t, f, t x f)
//! ```
//!
//! takes the place of the axes of a blade.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};
use rotor_aero::strip::SectionModel;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Text, Vector};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::{
    Along, FLAPS, POINTS, RADIAL_DRAG, SECTION, SECTIONS, STATIONS, StripsInflow, airfoil_axes,
    deflected, elements, ends, flaps, placed_beams, stations, strips,
};
use crate::elements::strips::{AirStrip, StripGeometry};
use crate::input::aerodynamics::StripProblem;
use crate::input::builder::ModelBuilder;
use crate::input::ends::label;
use crate::input::loads::{BEAMS, named_beams};

keys! {
    /// Strips in the air on a body or on beams, without induced velocity: a wing, a tail.
    pub(in crate::input) CARD = "[[strip]]";
    /// Its name, for messages.
    NAME: Option<String> = "name", [Text], or "`strip` and its number", "\"tail\"";
    /// The name of a node that carries the strips; either this or `beams`.
    NODE: Option<String> = "node", [Text], optional, "\"fuselage\"";
    /// Beginning of the line of the strips on a node, in its axes.
    FROM: Option<Vector3<f64>> = "from", [Vector(3, Dimension::LENGTH)], optional, "[0, 1, 0]";
    /// End of the line of the strips on a node, in its axes.
    TO: Option<Vector3<f64>> = "to", [Vector(3, Dimension::LENGTH)], optional, "[0, -1, 0]";
    /// Direction toward the leading edge at zero twist, of any length, in the axes of the node, or
    /// on beams in the axes of the model. The upper surface is on the side of the direction of the
    /// line times this direction (cross product).
    FORWARD: Vector3<f64> = "forward", [Vector(3, Dimension::NUMBER)], required, "[1, 0, 0]";
    with BEAMS.schema, SECTION.schema, POINTS.schema, RADIAL_DRAG.schema, STATIONS.schema,
        FLAPS.schema;
}

/// Lines of strips shorter than this part of the distance of their ends from the node are
/// points: digits lost in the input.
const SHORTEST: f64 = 1e-9;
/// Smallest sine of the angle between the line and the direction forward.
const ALONG: f64 = 1e-3;

/// The line of strips.
enum Line {
    /// A node, and both ends in its axes \[m\].
    Body(usize, [Vector3<f64>; 2]),
    /// Indices of beams.
    Beams(Vec<usize>),
}

/// Adds the strips of every `[[strip]]` to the model.
pub(in crate::input) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("strip").iter().enumerate() {
        let label = label(table, &NAME, "strip", number);
        let is_new = builder.take_label("strip", &label, table);
        let added = card(table, &label, builder);
        table.finish();
        if !is_new || added.is_none() {
            builder.note_broken();
        }
    }
}

/// Adds the strips of a card; `None` if it is wrong.
fn card(table: &Table<'_>, label: &str, builder: &mut ModelBuilder) -> Option<()> {
    let words = format!("strip \"{label}\"");
    let line = line(table, (label, &words), builder);
    let (section, points) = (table.get(&SECTION), table.get(&POINTS));
    let (radial_drag, forward) = (table.get(&RADIAL_DRAG), table.get(&FORWARD));
    let Some(line) = line else {
        let airfoils = &builder.aerodynamics().airfoils;
        stations::read(table, airfoils, (&words, f64::INFINITY));
        flaps::read(table, None, builder.drives());
        return None;
    };
    let (span, length) = line.span(builder);
    let airfoils = &builder.aerodynamics().airfoils;
    let stations = stations::read(table, airfoils, (&words, length));
    let flaps = flaps::read(table, stations.as_ref(), builder.drives());
    let axes = axes(table, &span, &forward?)?;
    let air = Along {
        stations: stations?,
        flaps: flaps?,
        model: SectionModel::of_word(SECTIONS.get(section?)?)?,
        points: points?,
        radial_drag: radial_drag?,
    };
    add(&air, &axes, (label, line), builder)
}

/// The axes B; notes a direction forward along the line.
fn axes(table: &Table<'_>, span: &Vector3<f64>, forward: &Vector3<f64>) -> Option<Matrix3<f64>> {
    if span.norm() == 0.0 {
        table.note(&BEAMS, &StripProblem::NoSpan);
        return None;
    }
    let across = forward - span * span.dot(forward);
    if across.norm() <= ALONG * forward.norm() {
        table.note(&FORWARD, &StripProblem::ForwardAlong);
        return None;
    }
    let x = across.normalize();
    Some(Matrix3::from_columns(&[*span, x, span.cross(&x)]))
}

/// Reads the line of a card.
fn line(
    table: &Table<'_>,
    (label, words): (&str, &str),
    builder: &mut ModelBuilder,
) -> Option<Line> {
    let (node, ends) = (table.get(&NODE), [&FROM, &TO].map(|key| table.get(key)));
    let [from, to] = ends;
    let (node, from, to) = (node?, from?, to?);
    let found = match (node, from, to, table.has(&BEAMS)) {
        (Some(name), Some(from), Some(to), false) => {
            let node = builder.find_node(&name, table, NODE.name(), words)?;
            if (to - from).norm() <= SHORTEST * from.norm().max(to.norm()) {
                table.note(&TO, &StripProblem::NoSpan);
                return None;
            }
            return Some(Line::Body(node, [from, to]));
        }
        (None, None, None, true) => return named_beams(table, builder, label).map(Line::Beams),
        (None, _, _, false) => "neither \"node\" nor \"beams\"",
        (Some(_), _, _, true) => "both \"node\" and \"beams\"",
        (Some(_), _, _, false) => "\"node\" without both ends",
        (None, _, _, true) => "\"beams\" with an end on a node",
    };
    let _read = table.get(&BEAMS);
    table.note("", &StripProblem::Carrier { found });
    None
}

impl Line {
    /// Its direction, in the axes of the node or of the model, and its length \[m\].
    fn span(&self, builder: &ModelBuilder) -> (Vector3<f64>, f64) {
        match self {
            Self::Body(_, [from, to]) => {
                let along = to - from;
                (along.normalize(), along.norm())
            }
            Self::Beams(beams) => {
                let lengths = beams.iter().map(|&beam| {
                    let beam = &builder.beams()[beam];
                    beam.geometry.length(&ends(beam, builder))
                });
                let point = |beam: Option<&usize>, xi: f64| {
                    beam.map_or_else(Vector3::zeros, |&beam| {
                        let beam = &builder.beams()[beam];
                        beam.geometry.line_point(&ends(beam, builder), xi).0
                    })
                };
                let along = point(beams.last(), 1.0) - point(beams.first(), -1.0);
                let direction = along.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
                (direction, lengths.sum())
            }
        }
    }
}

fn add(
    air: &Along,
    axes: &Matrix3<f64>,
    (label, line): (&str, Line),
    builder: &mut ModelBuilder,
) -> Option<()> {
    let still = builder.aerodynamics().air.clone()?;
    match line {
        Line::Beams(beams) => {
            let beams = placed_beams(beams, builder);
            let strips = strips(air, (axes, &beams), builder, &StripsInflow::default());
            for element in elements(label, (&beams, &strips), (None, &still), builder) {
                builder.add_load(Box::new(element));
            }
        }
        Line::Body(node, [from, to]) => {
            let (span, length) = ((to - from).normalize(), (to - from).norm());
            let points = air.points([0.0, length], None).into_iter();
            for (number, (position, length, between)) in points.enumerate() {
                let (offset, axes) = airfoil_axes(&between, axes, &span);
                let geometry = StripGeometry {
                    offset,
                    axes,
                    length,
                };
                let (strip, flap) = air.strip(between, position, None);
                let element = AirStrip::on_body(
                    format!("{label}/strip {}", number + 1),
                    (node, &builder.nodes()[node], from + span * position),
                    (Arc::new(strip), geometry),
                    None,
                    Arc::clone(&still),
                );
                builder.add_load(Box::new(deflected(element, flap)));
            }
        }
    }
    Some(())
}
