//! Strips of bodies and beams that are no blade of `[[blade]]`: `[[strip]]`.
//!
//! The line of a strip goes along t, from `from` to `to` on a body, or along beams. With the
//! direction f of `forward`, normal to t,
//!
//! ```text
//! B = (t, f, t x f)
//! ```
//!
//! replaces the axes of a blade.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};
use rotor_aero::strip::SectionModel;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Text, Vector};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::rotor::{self, Rotor};
use super::stations::{self, Between};
use super::{
    BLADE_STALL_DELAY, FAMILY, FLAPS, INFLOW_NAME, LineAir, OnRotor, POINTS, PlacedBeam,
    RADIAL_DRAG, SECTION, SECTIONS, STATIONS, airfoil_axes, deflected, delay, elements, ends,
    flaps, place, placed_beams, point_at, remark_on_end, strip_rotor, strips, unused,
};
use crate::elements::strips::{Air, AirStrip, StripGeometry, StripRotor};
use crate::input::aerodynamics::StripProblem;
use crate::input::builder::ModelBuilder;
use crate::input::ends::label;
use crate::input::frames::IN;
use crate::input::loads::{BEAMS, named_beams};

keys! {
    /// Strips in the air on a body or on beams: a wing, a tail, a blade of bodies.
    pub(in crate::input) CARD = "[[strip]]";
    /// Its name, for messages and readings.
    NAME: Option<String> = "name", [Text], or "`strip` and its number", "\"tail\"";
    /// The name of a node that carries the strips; either this or `beams`.
    NODE: Option<String> = "node", [Text], optional, "\"fuselage\"";
    /// Beginning of the line of the strips on a node, in its axes.
    FROM: Option<Vector3<f64>> = "from", [Vector(3, Dimension::LENGTH)], optional, "[0, 1, 0]";
    /// End of the line of the strips on a node, in its axes.
    TO: Option<Vector3<f64>> = "to", [Vector(3, Dimension::LENGTH)], optional, "[0, -1, 0]";
    /// Direction toward the leading edge at zero twist, of any length, in the axes of the node, or
    /// on beams in the axes of the model, or of the frame `in`. The upper surface is on the side of the direction of the
    /// line times this direction (cross product).
    FORWARD: Vector3<f64> = "forward", [Vector(3, Dimension::NUMBER)], required, "[1, 0, 0]";
    with INFLOW_NAME.schema, IN.schema, BEAMS.schema, SECTION.schema, POINTS.schema,
        RADIAL_DRAG.schema, BLADE_STALL_DELAY.schema, STATIONS.schema, FAMILY.schema, FLAPS.schema;
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
    /// Beams.
    Beams(Vec<PlacedBeam>),
}

/// Adds the strips of every `[[strip]]` to the model.
pub(in crate::input) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("strip").iter().enumerate() {
        let label = label(table, &NAME, "strip", number);
        let is_new = builder.take_label("strip", &label, table);
        let added = card(table, &label, builder);
        table.finish();
        if !is_new || added.is_none() {
            builder.note_broken_air();
        }
    }
}

/// Adds the strips of a card; `None` if it is wrong.
fn card(table: &Table<'_>, label: &str, builder: &mut ModelBuilder) -> Option<()> {
    let words = format!("strip \"{label}\"");
    let line = line(table, (label, &words), builder);
    let (section, points) = (table.get(&SECTION), table.get(&POINTS));
    let (radial_drag, forward) = (table.get(&RADIAL_DRAG), table.get(&FORWARD));
    let (inflow, frame) = (table.get(&INFLOW_NAME), builder.frames().of(table));
    let Some(line) = line else {
        let airfoils = &builder.aerodynamics().airfoils;
        stations::read(table, airfoils, (&words, f64::INFINITY));
        flaps::read(table, None, builder.drives());
        delay(table, None, &words, &mut Vec::new());
        return None;
    };
    let (span, length) = line.span(builder);
    let airfoils = &builder.aerodynamics().airfoils;
    let stations = stations::read(table, airfoils, (&words, length));
    let flaps = flaps::read(table, stations.as_ref(), builder.drives());
    let mut remarks = Vec::new();
    let delay = delay(table, stations.as_ref(), &words, &mut remarks);
    builder.add_remarks(remarks);
    let (forward, frame) = (forward?, frame?);
    let forward = match line {
        Line::Body(..) => forward,
        Line::Beams(_) => frame.direction(&forward),
    };
    let axes = axes(table, &span, &forward)?;
    let user = words.clone();
    let rotor = match inflow? {
        Some(name) => Some(rotor(&name, table, (label, words), builder)?),
        None => None,
    };
    let delay = delay?;
    if delay.is_some() && rotor.is_none() {
        let user = label.to_owned();
        table.note(
            &BLADE_STALL_DELAY,
            &StripProblem::DelayWithoutRotor { user },
        );
        return None;
    }
    let (model, stations) = (SectionModel::of_word(SECTIONS.get(section?)?)?, stations?);
    let unused = unused::remark(&user, &model, stations.sections());
    builder.add_remarks(unused.into_iter().collect());
    let air = LineAir {
        stations,
        flaps: flaps?,
        model,
        points: points?,
        radial_drag: radial_drag?,
        delay,
        is_mirrored: false,
    };
    add((&air, &axes), (label, &line), rotor.as_ref(), builder)
}

/// The rotor with the inflow of a card.
fn rotor(
    name: &str,
    table: &Table<'_>,
    (label, words): (&str, String),
    builder: &mut ModelBuilder,
) -> Option<Rotor> {
    let found = rotor::find(Some(name), table, builder, words)?;
    if let Some(inflow) = found.without_blades() {
        let problem = StripProblem::Blades {
            name: inflow.to_owned(),
            user: label.to_owned(),
        };
        table.note(&INFLOW_NAME, &problem);
        return None;
    }
    Some(found)
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
        (None, None, None, true) => {
            let beams = named_beams(table, builder, label)?;
            return Some(Line::Beams(placed_beams(beams, builder)));
        }
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
                let (last, start) = beams.last().copied().unwrap_or_default();
                let last = &builder.beams()[last];
                let length = start + last.geometry.length(&ends(last, builder));
                let along = point_at(beams, length, builder) - point_at(beams, 0.0, builder);
                let direction = along.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
                (direction, length)
            }
        }
    }

    /// The node of its end, and the end in the axes of the node \[m\].
    fn tip(&self, builder: &ModelBuilder) -> (usize, Vector3<f64>) {
        match self {
            Self::Body(node, [_, to]) => (*node, *to),
            Self::Beams(beams) => {
                let (last, _) = beams.last().copied().unwrap_or_default();
                (builder.beams()[last].nodes[2], Vector3::zeros())
            }
        }
    }

    /// A position on it, in the model \[m\].
    fn point(&self, at: f64, builder: &ModelBuilder) -> Vector3<f64> {
        match self {
            Self::Body(node, [from, to]) => {
                let node = &builder.nodes()[*node];
                node.position + node.rotation * (from + (to - from).normalize() * at)
            }
            Self::Beams(beams) => point_at(beams, at, builder),
        }
    }
}

/// Adds the strips of a line.
fn add(
    (air, axes): (&LineAir, &Matrix3<f64>),
    (label, line): (&str, &Line),
    rotor: Option<&Rotor>,
    builder: &mut ModelBuilder,
) -> Option<()> {
    let still = builder.aerodynamics().air.clone()?;
    let (mut length, mut of_strip) = (line.span(builder).1, None);
    if let Some(rotor) = rotor {
        let tip = line.tip(builder);
        let node = &builder.nodes()[tip.0];
        length = rotor.distance(&(node.position + node.rotation * tip.1));
        let disk = rotor.disk(length, builder);
        of_strip = Some(strip_rotor(label, (rotor, disk), tip, builder));
    }
    let of = (of_strip.as_ref(), &still);
    let strips = along((air, axes), (label, line), (rotor, length), of, builder);
    if let Some(rotor) = rotor {
        let first = air.stations.positions().next().unwrap_or_default();
        let first = rotor.distance(&line.point(first, builder));
        let remark = remark_on_end(
            air.delay.as_ref(),
            &format!("strip \"{label}\""),
            [first, length],
        );
        builder.add_remarks(remark.into_iter().collect());
    }
    let limits = rotor.map(|rotor| {
        let radius = |at| rotor.distance(&line.point(at, builder));
        air.stations.mach_limits(radius)
    });
    let of = (label, rotor, limits.unwrap_or_default());
    place(strips.into_iter(), of, (length, None), builder);
    Some(())
}

/// The strips of a line, with their positions \[m\]; `length` is the radius of its tip \[m\].
fn along(
    (air, axes): (&LineAir, &Matrix3<f64>),
    (label, line): (&str, &Line),
    (rotor, length): (Option<&Rotor>, f64),
    of: (Option<&StripRotor>, &Arc<Air>),
    builder: &ModelBuilder,
) -> Vec<(AirStrip, f64)> {
    // The inflow has the number of blades if it needs it.
    let on_rotor = rotor.map(|rotor| {
        let radius = |at| rotor.distance(&line.point(at, builder));
        OnRotor::new((rotor, &air.stations), (1, length), radius)
    });
    let on_rotor = on_rotor.unwrap_or_default();
    match line {
        Line::Beams(beams) => {
            let strips = strips(air, (axes, beams), builder, &on_rotor);
            let elements = elements(label, (beams, &strips), of, builder);
            let spans = strips.iter().map(|strip| strip.span);
            elements.into_iter().zip(spans).collect()
        }
        Line::Body(node, ends) => {
            on_body((air, axes), (label, *node, ends), (&on_rotor, of), builder)
        }
    }
}

/// The strips of a line on a node, with their positions \[m\].
fn on_body(
    (air, axes): (&LineAir, &Matrix3<f64>),
    (label, node, [from, to]): (&str, usize, &[Vector3<f64>; 2]),
    (on_rotor, (rotor, still)): (&OnRotor<'_>, (Option<&StripRotor>, &Arc<Air>)),
    builder: &ModelBuilder,
) -> Vec<(AirStrip, f64)> {
    let (span, length) = ((to - from).normalize(), (to - from).norm());
    let points = air.points([0.0, length], on_rotor.end).into_iter();
    let strip = |(number, (position, length, between)): (usize, (f64, f64, Between))| {
        let (offset, axes) = airfoil_axes((&between, 1.0), axes, &span);
        let geometry = StripGeometry {
            offset,
            axes,
            length,
        };
        let (strip, flap) = air.strip(position, &between, on_rotor);
        let element = AirStrip::on_body(
            format!("{label}/strip {}", number + 1),
            (node, &builder.nodes()[node], from + span * position),
            (strip, geometry),
            rotor.cloned(),
            Arc::clone(still),
        );
        (deflected(element, flap), position)
    };
    points.enumerate().map(strip).collect()
}
