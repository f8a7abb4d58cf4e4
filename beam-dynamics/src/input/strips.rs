//! Strips in the air: `[blade.aerodynamics]`.
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
use rotor_aero::strip::{AnnularInflow, SectionModel, Strip, StripDesign};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Count, Text, Word};
use shared_geom::keys;
use shared_geom::quadrature;

use super::aerodynamics::{Inflow, StripProblem};
use super::beam_card::Beam;
use super::builder::{AirBlade, ModelBuilder};
use crate::case::BladeNodes;
use crate::elements::strips::{AirStrip, Shaft, StripGeometry, StripRotor, TipRadius};
use crate::elements::{Element, NO_INFLOW, StripPlace};
use crate::model::Node;

mod files;
mod line;
mod stations;

pub(super) use line::BladeLine;

use stations::{Between, STATIONS, Stations};

/// Words of the models of sections.
const SECTIONS: [&str; 5] = ["quasi_steady", "lagged", "separation_lag", "oye", "hgm"];

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
    with STATIONS.schema, files::FILE.schema, files::AIRFOILS.schema, files::AIRFOIL_FILE.schema,
        files::SET.schema, files::TWIST_FILE.schema, files::ROOT_RADIUS.schema;
}

/// Strips of the blades of one card.
#[derive(Debug)]
pub(super) struct BladeAir {
    stations: Stations,
    model: SectionModel,
    points: usize,
    inflow: Option<Inflow>,
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
            let found = files::read(table, airfoils, (&user, line), &mut remarks);
            if has_both {
                stations::read(table, airfoils, (&user, line.length));
                files::note_stations(table);
            }
            found.filter(|_| !has_both)
        }
        (false, _) => {
            files::note_without_file(table);
            stations::read(table, airfoils, (&user, line.length))
        }
    };
    builder.add_remarks(remarks);
    let (section, points) = (table.get(&SECTION), table.get(&POINTS));
    let wanted = table.get(&INFLOW_NAME);
    table.finish();
    let inflow = match wanted? {
        None => None,
        Some(wanted) => Some(find_inflow(&wanted, table, builder, user)?),
    };
    Some(BladeAir {
        stations: stations?,
        model: SectionModel::of_word(SECTIONS.get(section?)?)?,
        points: points?,
        inflow,
    })
}

fn find_inflow(
    name: &str,
    table: &Table<'_>,
    builder: &ModelBuilder,
    user: String,
) -> Option<Inflow> {
    // Wrong inflows are reported already.
    let inflows = builder.aerodynamics().inflows.as_ref()?;
    let found = inflows.iter().find(|inflow| inflow.name == name);
    if found.is_none() {
        let known = inflows.iter().map(|inflow| inflow.name.clone());
        let problem = StripProblem::Unknown {
            kind: "inflow",
            name: name.to_owned(),
            user,
            known: known.collect(),
        };
        table.note(&INFLOW_NAME, &problem);
    }
    found.cloned()
}

/// Adds the strips of the blades of a card, by their names and axes (columns, pitch included). The
/// blades are equal: their strips are, too.
pub(super) fn add(air: &BladeAir, blades: &[(&str, Matrix3<f64>)], builder: &mut ModelBuilder) {
    let mut placed: Option<Vec<PlacedStrip>> = None;
    for (name, axes) in blades {
        let found = builder.blades().iter().find(|blade| blade.name == *name);
        // A blade that could not be added is noted already.
        let Some(blade) = found.cloned() else {
            continue;
        };
        let beams = beams(&blade, builder);
        let strips = placed.get_or_insert_with(|| {
            let inflow = air.inflow.as_ref().map(|inflow| {
                let first = air.stations.positions().next().unwrap_or_default();
                inflow.annular(blades.len(), radius_at(&beams, first, builder))
            });
            strips(air, (axes, &beams), builder, inflow)
        });
        let name = air.inflow.as_ref().map(|inflow| inflow.name.as_str());
        add_blade(&blade, name.unwrap_or(NO_INFLOW), (&beams, strips), builder);
    }
}

/// A beam by its index, with the arc length from the root at which it begins [m].
type PlacedBeam = (usize, f64);

/// The beams of a blade, from the root to the tip.
fn beams(blade: &BladeNodes, builder: &ModelBuilder) -> Vec<PlacedBeam> {
    let mut start = 0.0;
    let beams = builder.beams_of(blade).into_iter();
    beams
        .map(|index| {
            let placed = (index, start);
            let beam = &builder.beams()[index];
            start += beam.geometry.length(&ends(beam, builder));
            placed
        })
        .collect()
}

/// Adds the strips of one blade of the rotor called `rotor`.
fn add_blade(
    blade: &BladeNodes,
    rotor_name: &str,
    (beams, strips): (&[PlacedBeam], &[PlacedStrip]),
    builder: &mut ModelBuilder,
) {
    let air = builder.aerodynamics().air.clone();
    let (Some(shaft), Some(held), Some(air)) = (shaft(builder), builder.hub().copied(), air) else {
        return;
    };
    let hub = builder.hub_node();
    let tip = blade.nodes.last().copied().unwrap_or_default();
    let mut placed = AirBlade {
        name: blade.name.clone(),
        rotor: rotor_name.to_owned(),
        tip_radius: held.distance(&builder.nodes()[tip].position),
        strips: Vec::new(),
    };
    let tip = TipRadius::new(format!("{} tip", blade.name), tip, shaft, hub);
    let rotor = StripRotor {
        shaft,
        hub,
        tip_radius: tip.scalar().clone(),
    };
    builder.add_load(Box::new(tip));
    for (number, strip) in strips.iter().enumerate() {
        let Some(&(beam, _)) = beams.get(strip.beam) else {
            continue;
        };
        let beam = &builder.beams()[beam];
        let element = AirStrip::on_beam(
            format!("{}/strip {}", blade.name, number + 1),
            (beam.nodes, beam.geometry, &ends(beam, builder)),
            strip.xi,
            (Arc::clone(&strip.strip), strip.geometry),
            rotor.clone(),
            Arc::clone(&air),
        );
        let element = element.placed(StripPlace {
            rotor: rotor_name.to_owned(),
            blade: blade.name.clone(),
            number: number + 1,
            span: strip.span,
            zero: held.axes().column(0).into_owned(),
        });
        let radius = held.distance(element.start());
        placed.strips.push((element.label().to_owned(), radius));
        builder.add_load(Box::new(element));
    }
    builder.add_air_blade(placed);
}

/// The shaft of the rotor: in the frame, or in the axes of the hub's node.
fn shaft(builder: &ModelBuilder) -> Option<Shaft> {
    let rotation = builder.hub()?.frame_rotation();
    let node = builder.hub_node().map(|node| &builder.nodes()[node]);
    Some(match node {
        None => Shaft {
            center: rotation.center,
            axis: rotation.axis,
        },
        Some(node) => Shaft {
            center: node.rotation.tr_mul(&(rotation.center - node.position)),
            axis: node.rotation.tr_mul(&rotation.axis),
        },
    })
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
}

/// Distance from the axis of rotation of a position on the line \[m\].
fn radius_at(beams: &[PlacedBeam], position: f64, builder: &ModelBuilder) -> f64 {
    let Some(hub) = builder.hub() else { return 0.0 };
    let after = beams.partition_point(|(_, start)| *start <= position);
    let Some((beam, start)) = beams.get(after.saturating_sub(1)) else {
        return 0.0;
    };
    let beam = &builder.beams()[*beam];
    let ends = ends(beam, builder);
    let xi = beam.geometry.position(&ends, position - start);
    hub.distance(&beam.geometry.line_point(&ends, xi).0)
}

fn ends<'a>(beam: &Beam, builder: &'a ModelBuilder) -> [&'a Node; 3] {
    beam.nodes.map(|node| &builder.nodes()[node])
}

/// The strips of a blade, from the root to the tip.
fn strips(
    air: &BladeAir,
    (axes, beams): (&Matrix3<f64>, &[PlacedBeam]),
    builder: &ModelBuilder,
    inflow: Option<AnnularInflow>,
) -> Vec<PlacedStrip> {
    let mut strips = Vec::new();
    let limits: Vec<f64> = air.stations.positions().collect();
    let (Some(first), Some(last)) = (limits.first(), limits.last()) else {
        return strips;
    };
    for (number, (beam, start)) in beams.iter().enumerate() {
        let beam = &builder.beams()[*beam];
        let ends = ends(beam, builder);
        let end = start + beam.geometry.length(&ends);
        let mut cuts = vec![start.max(*first)];
        cuts.extend(limits.iter().filter(|at| **at > *start && **at < end));
        cuts.push(end.min(*last));
        cuts.dedup_by(|b, a| *b - *a <= SHORTEST * (end - start));
        for pair in cuts.windows(2) {
            let half = 0.5 * (pair[1] - pair[0]);
            for (abscissa, weight) in quadrature::line(air.points) {
                let position = pair[0] + half * (1.0 + abscissa);
                let Some(between) = air.stations.at(position) else {
                    continue;
                };
                let xi = beam.geometry.position(&ends, position - start);
                strips.push(PlacedStrip {
                    beam: number,
                    span: position,
                    xi,
                    geometry: geometry(&between, axes, (beam, &ends), (xi, weight * half)),
                    strip: Arc::new(Strip::new(StripDesign {
                        chord: between.chord,
                        section: between.airfoil,
                        model: air.model,
                        inflow,
                    })),
                });
            }
        }
    }
    strips
}

/// Part of a beam below which a piece between two stations has no strip of its own.
const SHORTEST: f64 = 1e-6;

fn geometry(
    between: &Between,
    blade_axes: &Matrix3<f64>,
    (beam, ends): (&Beam, &[&Node; 3]),
    (xi, length): (f64, f64),
) -> StripGeometry {
    let (_, tangent) = beam.geometry.line_point(ends, xi);
    let section = beam.geometry.section_axes(ends, xi);
    let (sin, cos) = between.twist.sin_cos();
    let forward = blade_axes * Vector3::new(0.0, cos, sin);
    let x = (forward - tangent * tangent.dot(&forward)).normalize();
    let axes = Matrix3::from_columns(&[x, tangent.cross(&x), tangent]);
    let into = section.transpose();
    // The quarter chord is ahead of the line by (axis - 1/4) chords.
    let ahead = (between.axis - 0.25) * between.chord;
    StripGeometry {
        offset: into * (x * ahead),
        axes: into * axes,
        length,
    }
}
