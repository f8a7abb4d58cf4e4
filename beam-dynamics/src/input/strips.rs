//! Strips in the air: `[blade.aerodynamics]`; `[[strip]]` is in `cards`.
//!
//! The airfoil axes at a station of twist b, with the axes B of the blade (x along the span, y in
//! the direction of motion, z up, pitch included) and the line of the beam along t:
//!
//! ```text
//! z = t                 x = (cos b B e_y + sin b B e_z), normal to t          y = z x x
//! ```
//!
//! Each beam is cut at the stations; each piece has strips at Gauss points, whose lengths are the
//! weights times the length of the piece.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};
use rotor_aero::airfoil::RotorStallDelay;
use rotor_aero::strip::{SectionModel, Strip, StripDesign};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Boolean, Count, Text, Word};
use shared_geom::keys;
use shared_geom::quadrature;

use super::aerodynamics::MachLimit;
use super::aerodynamics::family::{self, FAMILY};
use super::aerodynamics::rotor_delay::{self, BLADE_STALL_DELAY, remark_on_end};
use super::beam_card::Beam;
use super::builder::{AirBlade, ModelBuilder};
use crate::case::BladeNodes;
use crate::elements::strips::{Air, AirStrip, RotorDisk, StripGeometry, StripRotor, TipRadius};
use crate::elements::{Element, Signal, StripLocation};
use crate::model::Node;

mod cards;
mod files;
mod flaps;
mod inflow_check;
mod line;
mod on_rotor;
mod rotor;
mod stations;
mod unused;

pub(super) use cards::{CARD as STRIP, read as read_cards};
pub(super) use files::Pool;
pub use inflow_check::InflowProblem;
pub(super) use inflow_check::check as check_inflows;
pub(super) use line::BladeLine;

use flaps::{FLAPS, Flap};
use on_rotor::OnRotor;
use rotor::Rotor;
use stations::{Between, STATIONS, Stations};

/// Words of the models of sections.
const SECTIONS: [&str; 6] = [
    "quasi_steady",
    "lagged",
    "separation_lag",
    "oye",
    "hgm",
    "dynamic_stall",
];

keys! {
    /// Strips along a blade.
    pub(super) CARD = "[blade.aerodynamics]";
    /// The name of an `[[inflow]]`; without it no velocity is induced.
    INFLOW_NAME: Option<String> = "inflow", [Text], optional, "\"rotor\"";
    /// Model of the section.
    SECTION: usize = "section", [Word(&SECTIONS)],
        or "\"separation_lag\"" = 2, "\"quasi_steady\"";
    /// Number of strips on each beam, or on each part of a beam between two stations.
    POINTS: usize = "strips", [Count(20)], or "2" = 2, "3";
    /// Whether the flow along the span has friction, with the drag at zero angle of attack.
    RADIAL_DRAG: bool = "radial_drag", [Boolean], or "false" = false, "true";
    with BLADE_STALL_DELAY.schema, STATIONS.schema, FAMILY.schema, FLAPS.schema, files::FILE.schema, files::AIRFOILS.schema, files::AIRFOIL_FILE.schema,
        files::SET.schema, files::TWIST_FILE.schema, files::ROOT_RADIUS.schema;
}

/// Strips of the blades of one card.
#[derive(Debug)]
pub(super) struct BladeAir {
    user: String,
    along: LineAir,
    rotor: Rotor,
}

/// Strips along a line.
#[derive(Debug)]
struct LineAir {
    stations: Stations,
    flaps: Vec<Flap>,
    model: SectionModel,
    points: usize,
    radial_drag: bool,
    delay: Option<RotorStallDelay>,
    /// Whether the sections are upside down, with the opposite twist.
    is_mirrored: bool,
}

impl BladeAir {
    /// The mirror image in the plane of rotation.
    pub fn mirrored(mut self) -> Self {
        self.along.is_mirrored = true;
        self.rotor.side = -1.0;
        self
    }
}

/// Reads the table of a `[[blade]]` called `name`, with the line of its beams.
pub(super) fn read(
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    (name, line): (&str, &BladeLine<'_>),
) -> Option<BladeAir> {
    let user = format!("blade \"{name}\"");
    let mut remarks = Vec::new();
    let airfoils = &builder.aerodynamics().airfoils;
    let stations = match (table.has(&files::FILE), table.has(&STATIONS)) {
        (true, has_both) => {
            let has_family = !has_both && family::note_beside_file(table);
            let found = files::read(table, airfoils, (&user, line), &mut remarks);
            if has_both {
                stations::read(table, airfoils, (&user, line.length));
                files::note_stations(table);
            }
            found.filter(|_| !has_both && !has_family)
        }
        (false, _) => {
            files::note_without_file(table);
            stations::read(table, airfoils, (&user, line.length))
        }
    };
    let flaps = flaps::read(table, stations.as_ref(), builder.drives());
    let (section, points) = (table.get(&SECTION), table.get(&POINTS));
    let model = section.and_then(|index| SectionModel::of_word(SECTIONS.get(index)?));
    let pair = model.as_ref().zip(stations.as_ref());
    let unused = pair.and_then(|(model, own)| unused::remark(&user, model, own.sections()));
    remarks.extend(unused);
    if let Some(own) = &stations {
        remarks.extend(own.remark_on_chord(&user, line.length));
        remarks.extend(own.remark_on_span(&user, line.length));
    }
    let delay = delay(table, stations.as_ref(), &user, &mut remarks);
    builder.add_remarks(remarks);
    let radial_drag = table.get(&RADIAL_DRAG);
    let wanted = table.get(&INFLOW_NAME);
    table.finish();
    let rotor = rotor::find(wanted?.as_deref(), table, builder, user.clone());
    Some(BladeAir {
        user,
        along: LineAir {
            stations: stations?,
            flaps: flaps?,
            model: model?,
            points: points?,
            radial_drag: radial_drag?,
            delay: delay?,
            is_mirrored: false,
        },
        rotor: rotor?,
    })
}

/// Reads the delay of stall of a table, and checks it with its stations.
fn delay(
    table: &Table<'_>,
    stations: Option<&Stations>,
    user: &str,
    remarks: &mut Vec<String>,
) -> Option<Option<RotorStallDelay>> {
    let delay = rotor_delay::read(table)?;
    if let (Some(delay), Some(stations)) = (&delay, stations) {
        rotor_delay::check((table, delay), stations.sections(), user, remarks)?;
    }
    Some(delay)
}

/// Adds the strips of the blades of a card, by their names and axes (columns, pitch included). The
/// blades are equal: their strips are, too.
pub(super) fn add(air: &BladeAir, blades: &[(&str, Matrix3<f64>)], builder: &mut ModelBuilder) {
    let mut placed: Option<(Vec<PlacedStrip>, Vec<MachLimit>)> = None;
    for (name, axes) in blades {
        let found = builder.blades().iter().find(|blade| blade.name == *name);
        // A blade that could not be added is noted already.
        let Some(blade) = found.cloned() else {
            continue;
        };
        let beams = beams(&blade, builder);
        let tip = blade.nodes.last().map(|node| &builder.nodes()[*node]);
        let radius = tip.map_or(0.0, |tip| air.rotor.distance(&tip.position));
        let disk = air.rotor.disk(radius, builder);
        let (strips, limits) = placed.get_or_insert_with(|| {
            let stations = &air.along.stations;
            let first = stations.positions().next().unwrap_or_default();
            let first = air.rotor.distance(&point_at(&beams, first, builder));
            let remark = air.rotor.remark_on_hub(name, first, radius);
            let delay = air.along.delay.as_ref();
            let delay = remark_on_end(delay, &air.user, [first, radius]);
            builder.add_remarks(remark.into_iter().chain(delay).collect());
            let distance = |at: f64| air.rotor.distance(&point_at(&beams, at, builder));
            let on_rotor = OnRotor::new((&air.rotor, stations), (blades.len(), radius), distance);
            let strips = strips(&air.along, (axes, &beams), builder, &on_rotor);
            (strips, stations.mach_limits(distance))
        });
        add_blade(
            (&blade, &air.rotor, disk),
            (&beams, strips),
            (limits.clone(), blades.len()),
            builder,
        );
    }
}

/// A beam by its index, with the arc length of the line at which it begins [m].
type PlacedBeam = (usize, f64);

/// The beams of a blade, from the root to the tip.
fn beams(blade: &BladeNodes, builder: &ModelBuilder) -> Vec<PlacedBeam> {
    placed_beams(builder.beams_of(blade), builder)
}

/// Beams by their indices in the order of a line, with their arc lengths.
fn placed_beams(beams: Vec<usize>, builder: &ModelBuilder) -> Vec<PlacedBeam> {
    let mut start = 0.0;
    let beams = beams.into_iter();
    beams
        .map(|index| {
            let placed = (index, start);
            let beam = &builder.beams()[index];
            start += beam.geometry.length(&ends(beam, builder));
            placed
        })
        .collect()
}

/// Adds the strips of one blade of a rotor.
fn add_blade(
    (blade, rotor, disk): (&BladeNodes, &Rotor, Option<Arc<RotorDisk>>),
    (beams, strips): (&[PlacedBeam], &[PlacedStrip]),
    (mach_limits, siblings): (Vec<MachLimit>, usize),
    builder: &mut ModelBuilder,
) {
    let Some(air) = builder.aerodynamics().air.clone() else {
        return;
    };
    let tip = blade.nodes.last().copied().unwrap_or_default();
    let radius = rotor.distance(&builder.nodes()[tip].position);
    let at_tip = (tip, Vector3::zeros());
    let of_strip = strip_rotor(&blade.name, (rotor, disk), at_tip, builder);
    let of = (Some(&of_strip), &air);
    let elements = elements(&blade.name, (beams, strips), of, builder);
    let elements = elements
        .into_iter()
        .zip(strips.iter().map(|strip| strip.span));
    let of = (blade.name.as_str(), Some(rotor), mach_limits);
    place(elements, of, (radius, Some(siblings)), builder);
}

/// The rotor of the strips of a blade or a card, with the tip at an offset from a node \[m\]; its
/// radius becomes an unknown of the model.
fn strip_rotor(
    name: &str,
    (rotor, disk): (&Rotor, Option<Arc<RotorDisk>>),
    tip: (usize, Vector3<f64>),
    builder: &mut ModelBuilder,
) -> StripRotor {
    let tip = TipRadius::new(format!("{name} tip"), tip, rotor.shaft, rotor.hub);
    let found = StripRotor {
        shaft: rotor.shaft,
        hub: rotor.hub,
        tip_radius: tip.scalar().clone(),
        disk,
    };
    builder.add_load(Box::new(tip));
    found
}

/// Adds the strips of a blade or a card with their positions on its line \[m\]; `length` is the radius
/// of the tip, without a rotor the length of the line \[m\]; `siblings` the number of blades of a card.
fn place(
    strips: impl Iterator<Item = (AirStrip, f64)>,
    (name, rotor, mach_limits): (&str, Option<&Rotor>, Vec<MachLimit>),
    (length, siblings): (f64, Option<usize>),
    builder: &mut ModelBuilder,
) {
    let mut placed = AirBlade {
        name: name.to_owned(),
        rotor: rotor.map(|rotor| rotor.name().to_owned()),
        has_inflow: rotor.is_some_and(Rotor::has_inflow),
        length,
        strips: Vec::new(),
        points: Vec::new(),
        shaft: rotor.map(Rotor::start),
        siblings,
        mach_limits,
    };
    for (number, (element, span)) in strips.enumerate() {
        let element = element.placed(StripLocation {
            rotor: placed.rotor.clone(),
            blade: name.to_owned(),
            number: number + 1,
            span,
            zero: rotor.map_or_else(Vector3::x, |rotor| rotor.zero),
            side: rotor.map_or(1.0, |rotor| rotor.side),
        });
        let position = rotor.map_or(span, |rotor| rotor.distance(element.start()));
        placed.points.push(*element.start());
        placed.strips.push((element.label().to_owned(), position));
        builder.add_load(Box::new(element));
    }
    builder.add_air_blade(placed);
}

/// The strips of a line of beams, of a rotor or without one.
fn elements(
    name: &str,
    (beams, strips): (&[PlacedBeam], &[PlacedStrip]),
    (rotor, air): (Option<&StripRotor>, &Arc<Air>),
    builder: &ModelBuilder,
) -> Vec<AirStrip> {
    let numbered = strips.iter().enumerate();
    let elements = numbered.filter_map(|(number, strip)| {
        let beam = &builder.beams()[beams.get(strip.beam)?.0];
        let element = AirStrip::on_beam(
            format!("{name}/strip {}", number + 1),
            (beam.nodes, beam.geometry, &ends(beam, builder)),
            strip.xi,
            (Arc::clone(&strip.strip), strip.geometry),
            rotor.cloned(),
            Arc::clone(air),
        );
        Some(deflected(element, strip.flap.clone()))
    });
    elements.collect()
}

/// A strip with the deflection of its flap, if it has one.
fn deflected(strip: AirStrip, flap: Option<Signal>) -> AirStrip {
    match flap {
        Some(deflection) => strip.deflected(deflection),
        None => strip,
    }
}

/// A strip and its position on a beam.
struct PlacedStrip {
    /// Number of the beam of the blade, from zero.
    beam: usize,
    /// Arc length from the root \[m\].
    span: f64,
    xi: f64,
    strip: Arc<Strip>,
    geometry: StripGeometry,
    /// Deflection of its flap \[rad\].
    flap: Option<Signal>,
}

/// A position on the line of beams \[m\].
fn point_at(beams: &[PlacedBeam], position: f64, builder: &ModelBuilder) -> Vector3<f64> {
    let after = beams.partition_point(|(_, start)| *start <= position);
    let Some((beam, start)) = beams.get(after.saturating_sub(1)) else {
        return Vector3::zeros();
    };
    let beam = &builder.beams()[*beam];
    let ends = ends(beam, builder);
    let xi = beam.geometry.position(&ends, position - start);
    beam.geometry.line_point(&ends, xi).0
}

fn ends<'a>(beam: &Beam, builder: &'a ModelBuilder) -> [&'a Node; 3] {
    beam.nodes.map(|node| &builder.nodes()[node])
}

/// The strips of a line of beams, from its beginning to its end.
fn strips(
    air: &LineAir,
    (axes, beams): (&Matrix3<f64>, &[PlacedBeam]),
    builder: &ModelBuilder,
    on_rotor: &OnRotor<'_>,
) -> Vec<PlacedStrip> {
    let mut strips = Vec::new();
    for (number, (beam, start)) in beams.iter().enumerate() {
        let beam = &builder.beams()[*beam];
        let ends = ends(beam, builder);
        let end = start + beam.geometry.length(&ends);
        for (position, length, between) in air.points([*start, end], on_rotor.end) {
            let xi = beam.geometry.position(&ends, position - start);
            let side = if air.is_mirrored { -1.0 } else { 1.0 };
            let geometry = geometry((&between, side), axes, (beam, &ends), (xi, length));
            let (strip, flap) = air.strip(position, &between, on_rotor);
            strips.push(PlacedStrip {
                beam: number,
                span: position,
                xi,
                geometry,
                strip,
                flap,
            });
        }
    }
    strips
}

/// Part of a line below which a piece between two stations has no strip of its own.
const SHORTEST: f64 = 1e-6;

impl LineAir {
    /// Strips of the part of a line between two arc lengths, also cut at `cut`: their positions and
    /// lengths \[m\].
    fn points(&self, [start, end]: [f64; 2], cut: Option<f64>) -> Vec<(f64, f64, Between)> {
        let mut limits: Vec<f64> = self.stations.positions().collect();
        let (Some(&first), Some(&last)) = (limits.first(), limits.last()) else {
            return Vec::new();
        };
        limits.extend(cut);
        limits.extend(self.flaps.iter().flat_map(|flap| flap.range));
        limits.sort_by(f64::total_cmp);
        let mut cuts = vec![start.max(first)];
        cuts.extend(limits.iter().filter(|at| **at > start && **at < end));
        cuts.push(end.min(last));
        cuts.dedup_by(|b, a| *b - *a <= SHORTEST * (end - start));
        let mut points = Vec::new();
        for pair in cuts.windows(2) {
            let half = 0.5 * (pair[1] - pair[0]);
            for (abscissa, weight) in quadrature::line(self.points) {
                let position = pair[0] + half * (1.0 + abscissa);
                let between = self.stations.at(position);
                points.extend(between.map(|between| (position, weight * half, between)));
            }
        }
        points
    }

    /// The strip of a position \[m\], and the deflection of its flap.
    fn strip(
        &self,
        position: f64,
        between: &Between,
        on_rotor: &OnRotor<'_>,
    ) -> (Arc<Strip>, Option<Signal>) {
        let strip = Strip::new(StripDesign {
            chord: between.chord,
            section: on_rotor.section(self.delay.as_ref(), position, between),
            model: self.model,
            inflow: on_rotor.inflow,
            radial_drag: self.radial_drag,
        });
        let strip = if on_rotor.end.is_none_or(|end| position <= end) {
            strip
        } else {
            strip.with_lift(0.0)
        };
        match self.flaps.iter().find(|flap| flap.is_at(position)) {
            Some(flap) => {
                let strip = Arc::new(strip.with_flap(flap.law));
                (strip, Some(flap.deflection.clone()))
            }
            None => (Arc::new(strip), None),
        }
    }
}

fn geometry(
    between: (&Between, f64),
    blade_axes: &Matrix3<f64>,
    (beam, ends): (&Beam, &[&Node; 3]),
    (xi, length): (f64, f64),
) -> StripGeometry {
    let (_, tangent) = beam.geometry.line_point(ends, xi);
    let section = beam.geometry.section_axes(ends, xi);
    let (ahead, axes) = airfoil_axes(between, blade_axes, &tangent);
    let into = section.transpose();
    StripGeometry {
        offset: into * ahead,
        axes: into * axes,
        length,
    }
}

/// The quarter chord from a line along `tangent` \[m\], and the airfoil axes; of an airfoil upside down, which
/// has the side -1, turned by half a turn about the chord.
fn airfoil_axes(
    (between, side): (&Between, f64),
    axes: &Matrix3<f64>,
    tangent: &Vector3<f64>,
) -> (Vector3<f64>, Matrix3<f64>) {
    let (sin, cos) = between.twist.sin_cos();
    let forward = axes * Vector3::new(0.0, cos, side * sin);
    let x = (forward - tangent * tangent.dot(&forward)).normalize();
    // The quarter chord is ahead of the line by (axis - 1/4) chords.
    let ahead = x * ((between.axis - 0.25) * between.chord);
    (
        ahead,
        Matrix3::from_columns(&[x, side * tangent.cross(&x), side * tangent]),
    )
}
