//! The report of a blade: one HTML page that needs no other file and no network.
//!
//! The page has its data as one block of JSON, from which its script draws the sections, the
//! tables and the curves. Matrices have all digits of the property files.

use serde::Serialize;
use shared_geom::blade::Blade;
use shared_geom::exchange::frame::Convention;
use shared_geom::wrench::COMPONENTS;

use super::section_picture::{MaterialPicture, SectionPicture};
use super::span::{SolvedSpan, SolvedStation, SpanRow, values_beside};
use super::text::rows;
use crate::input::result_tables::{ListedReserve, ModeTable};

const PAGE: &str = include_str!("report_page/page.html");
const STYLE: &str = include_str!("report_page/report.css");
/// The parts of the script, in their order.
const SCRIPT: &str = concat!(
    include_str!("report_page/base.js"),
    include_str!("report_page/cells.js"),
    include_str!("report_page/criteria.js"),
    include_str!("report_page/stress.js"),
    include_str!("report_page/viewer.js"),
    include_str!("report_page/tables.js"),
    include_str!("report_page/curves.js"),
    include_str!("report_page/loads.js"),
    include_str!("report_page/page.js"),
    include_str!("report_page/selftest_stress.js"),
    include_str!("report_page/selftest.js"),
);

/// A remark about some stations, or about the blade.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Remark {
    /// The remark.
    pub text: String,
    /// Names of the sections; empty if it is about the blade.
    pub sections: Vec<String>,
}

/// The content of the report of a blade.
#[derive(Debug)]
pub struct ReportPage<'a> {
    /// The sections, with their pictures.
    pub span: &'a SolvedSpan<'a>,
    /// Remarks about the blade and its sections.
    pub remarks: &'a [Remark],
    /// Reserve factors of plies; empty if there are none.
    pub reserves: &'a [ListedReserve],
    /// Modes of the blade.
    pub modes: Option<&'a ModeTable>,
    /// Another blade, whose values stand beside.
    pub other: Option<&'a Blade>,
}

impl ReportPage<'_> {
    /// The page.
    pub fn html(&self) -> String {
        let blade = self.span.blade();
        let data = Data {
            blade: Head::new(&blade),
            components: COMPONENTS,
            materials: self.materials(),
            stations: self.stations(),
            remarks: self.remarks,
            reserves: self.reserves,
            modes: self.modes,
            orders: ORDERS.map(Order::new),
            other: self.other.map(|other| self.beside(other)),
        };
        // numbers and texts can always be written
        let data = serde_json::to_string(&data).unwrap_or_default();
        // the block of data ends at the next tag
        let data = data.replace('<', "\\u003c");
        let name = escaped(self.span.name);
        let mut page = String::with_capacity(PAGE.len() + SCRIPT.len() + data.len() + (1 << 15));
        let mut rest = PAGE;
        for (mark, text) in [
            ("{{title}}", name.as_str()),
            ("{{style}}", STYLE),
            ("{{name}}", name.as_str()),
            ("{{data}}", data.as_str()),
            ("{{script}}", SCRIPT),
        ] {
            if let Some((before, after)) = rest.split_once(mark) {
                page.push_str(before);
                page.push_str(text);
                rest = after;
            }
        }
        page.push_str(rest);
        page
    }

    /// The materials of all sections: a name has one meaning in a blade.
    fn materials(&self) -> Vec<&MaterialPicture> {
        let pictures = self.span.stations.iter();
        let pictures = pictures.filter_map(|station| station.picture.as_ref());
        let mut found: Vec<&MaterialPicture> = Vec::new();
        for material in pictures.flat_map(|picture| &picture.materials) {
            if found.iter().all(|known| known.name != material.name) {
                found.push(material);
            }
        }
        found
    }

    /// The values of another blade at the sections that are drawn.
    fn beside<'a>(&self, other: &'a Blade) -> Other<'a> {
        let drawn = self.span.stations.iter();
        let drawn = drawn.filter(|station| station.picture.is_some());
        Other {
            name: &other.name,
            length: other.length(),
            values: drawn.map(|one| values_beside(one, other)).collect(),
        }
    }

    fn stations(&self) -> Vec<Station<'_>> {
        let drawn = self.span.stations.iter();
        let drawn = drawn.filter_map(|station| Some((station, station.picture.as_ref()?)));
        drawn
            .map(|(station, picture)| Station::new(self.span, station, picture))
            .collect()
    }
}

/// The data of a page.
#[derive(Serialize)]
struct Data<'a> {
    blade: Head<'a>,
    components: [&'static str; 6],
    materials: Vec<&'a MaterialPicture>,
    stations: Vec<Station<'a>>,
    remarks: &'a [Remark],
    reserves: &'a [ListedReserve],
    modes: Option<&'a ModeTable>,
    orders: [Order; 4],
    other: Option<Other<'a>>,
}

/// Conventions in whose order and axes matrices are shown.
const ORDERS: [Convention; 4] = [
    Convention::Helicoid,
    Convention::BeamDyn,
    Convention::Hawc2,
    Convention::Vabs,
];

/// The order of the components of a program.
#[derive(Serialize)]
struct Order {
    name: &'static str,
    words: &'static str,
    components: [&'static str; 6],
    /// The component of Helicoid that each one is, and its sign.
    index: [usize; 6],
    sign: [f64; 6],
}

impl Order {
    fn new(convention: Convention) -> Self {
        // columns are its axes in Helicoid's
        let axes = convention.axes();
        let axis = |i: usize| (0..3).find(|&j| axes[(j, i % 3)] != 0.0).unwrap_or(i % 3);
        let all = [0, 1, 2, 3, 4, 5];
        let (name, components) = match convention {
            Convention::Helicoid => ("Helicoid", COMPONENTS),
            Convention::Vabs => ("VABS", ["F1", "F2", "F3", "M1", "M2", "M3"]),
            Convention::BeamDyn => ("BeamDyn", AXES),
            Convention::Hawc2 | Convention::Anba4 => ("HAWC2", AXES),
        };
        Self {
            name,
            words: convention.axes_in_words(),
            components,
            index: all.map(|i| axis(i) + i / 3 * 3),
            sign: all.map(|i| axes[(axis(i), i % 3)]),
        }
    }
}

/// Forces and moments by the axes.
const AXES: [&str; 6] = ["Fx", "Fy", "Fz", "Mx", "My", "Mz"];

/// Another blade beside the stations: mass, EA, EI flap, EI edge and GJ of the station and of it.
#[derive(Serialize)]
struct Other<'a> {
    name: &'a str,
    length: f64,
    values: Vec<[[f64; 5]; 2]>,
}

/// The blade.
#[derive(Serialize)]
struct Head<'a> {
    name: &'a str,
    length: f64,
    /// Mass, center of mass, flap inertia about the root; of a sound blade.
    mass: Option<f64>,
    center: Option<[f64; 3]>,
    flap_inertia: Option<f64>,
    program: &'a str,
    version: &'a str,
    input_hash: &'a str,
}

impl<'a> Head<'a> {
    fn new(blade: &'a Blade) -> Self {
        let moments = blade.problems().is_empty().then(|| blade.mass_moments());
        Self {
            name: &blade.name,
            length: blade.length(),
            mass: moments.map(|moments| moments.mass),
            center: moments.map(|moments| moments.center.into()),
            flap_inertia: moments.map(|moments| moments.inertia[(1, 1)]),
            program: &blade.provenance.program,
            version: &blade.provenance.version,
            input_hash: &blade.provenance.input_hash,
        }
    }
}

/// A section; lengths in m, angles in deg, all in SI units otherwise.
#[derive(Serialize)]
struct Station<'a> {
    name: &'a str,
    eta: f64,
    arc_length: f64,
    chord: f64,
    twist: f64,
    stiffness: [[f64; 6]; 6],
    mass: [[f64; 6]; 6],
    tension_center: [f64; 2],
    shear_center: [f64; 2],
    mass_center: [f64; 2],
    bending_angle: f64,
    inertia_angle: f64,
    /// EA, GAy, GAz, GJ with all other internal forces zero.
    free_stiffness: [f64; 4],
    /// Bending stiffness about the principal axes near y and z.
    bending: [f64; 2],
    layers: Vec<Layer<'a>>,
    picture: &'a SectionPicture,
}

/// A layer of the shell, or a ply of a web.
#[derive(Serialize)]
struct Layer<'a> {
    name: &'a str,
    material: &'a str,
    arcs: Option<[f64; 2]>,
    thickness: Option<f64>,
    nominal: f64,
    meshed: f64,
}

impl<'a> Station<'a> {
    fn new(span: &SolvedSpan<'_>, station: &'a SolvedStation, picture: &'a SectionPicture) -> Self {
        let row = SpanRow::new(span, station);
        let properties = &station.properties;
        let (centers, axes) = (&properties.centers, &properties.principal_axes);
        let layers = station.layers.iter().map(|row| Layer {
            name: &row.layer,
            material: &row.material,
            arcs: row.arcs,
            thickness: row.thickness,
            nominal: row.nominal,
            meshed: row.meshed,
        });
        Self {
            name: &properties.name,
            eta: station.eta,
            arc_length: row.arc_length,
            chord: station.chord,
            twist: row.twist.to_degrees(),
            stiffness: rows(&properties.stiffness),
            mass: rows(&properties.mass),
            tension_center: centers.tension.into(),
            shear_center: centers.shear.into(),
            mass_center: centers.mass.into(),
            bending_angle: axes.bending_angle.to_degrees(),
            inertia_angle: axes.inertia_angle.to_degrees(),
            free_stiffness: row.stiffness,
            bending: row.bending,
            layers: layers.collect(),
            picture,
        }
    }
}

/// A text without the characters that have a meaning in HTML.
fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}
