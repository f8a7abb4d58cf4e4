//! Blades of windIO turbine files.
//!
//! | | version 1 | version 2 |
//! |---|---|---|
//! | table | `components.blade.outer_shape_bem` | `components.blade.outer_shape` |
//! | axis | `reference_axis` there | `components.blade.reference_axis` |
//! | twist | rad | deg |
//! | airfoils | `airfoil_position`: `grid`, `labels` | `airfoils[]`: `name`, `spanwise_position`, `configuration`, `weight` |
//! | reference point | `pitch_axis`, over chord | `section_offset_y` [m] |
//!
//! The axis has x downwind, y to the trailing edge, z along the blade; twist is positive towards
//! feather. Stations are at the positions of all grids. Between the stations of two airfoils,
//! weights are linear in the position.

use shared_geom::exchange::yaml::Node;

use super::super::grid::Unit;
use super::super::notes::Notes;
use super::super::reading::ReadAirfoil;
use super::super::tree::{Column, column, list, numbers, required, root, scalar, word};
use super::super::windio::{airfoils, full_name};
use super::BladeOptions;
use super::station::{AeroStation, BladeAero, BladeFormat, SpanOrigin, StationAirfoil};

/// Positions that differ by less are one [-].
const SAME: f64 = 1e-9;

/// Whether `text` is a turbine file with the outer shape of a blade.
pub(super) fn recognize(text: &str) -> bool {
    let has = |name: &str| text.lines().any(|line| line.trim_start().starts_with(name));
    has("components:") && has("blade:") && has("outer_shape")
}

/// The tables of the outer shape.
struct Shape {
    axis: [Column; 3],
    chord: Column,
    /// Towards feather [rad].
    feather: Column,
    /// Reference point: over chord in version 1, [m] in version 2.
    point: Option<Column>,
    is_over_chord: bool,
    thickness: Option<Column>,
    /// Airfoils with weights at positions.
    airfoils: Vec<(f64, Vec<(String, f64)>)>,
}

/// Reads the blade of a file of either version.
pub(super) fn read(text: &str, _: &BladeOptions, notes: &mut Notes) -> Option<BladeAero> {
    let root = root(text, notes)?;
    let read = match root.entry("airfoils") {
        // Polars may be in another file.
        Some(_) => airfoils(&root, false, notes).unwrap_or_default(),
        None => Vec::new(),
    };
    let parts = required(&root, "the file", "components", notes)?;
    let blade = required(parts, "components", "blade", notes)?;
    let of_version_1 = blade.entry("outer_shape_bem");
    let shape = match of_version_1 {
        Some(table) => version_1(table, notes),
        None => version_2(blade, &read, notes),
    }?;
    let mut blade = BladeAero::of(BladeFormat::WindIo, SpanOrigin::Root, shape.stations(&read));
    blade.name = word(&root, "name").unwrap_or("blade").to_owned();
    blade.airfoils = read;
    whole(&root, &mut blade, of_version_1.is_none(), notes);
    Some(blade)
}

/// Largest cone of a turbine \[rad\].
const LARGEST_CONE: f64 = std::f64::consts::PI / 6.0;

/// Values of the turbine as a whole, with angles in degrees or in radians.
fn whole(root: &Node, blade: &mut BladeAero, has_degrees: bool, notes: &mut Notes) {
    let number = |path: &[&str], notes: &mut Notes| {
        let node = root.path(path)?;
        scalar(node, path.last().copied().unwrap_or_default(), notes)
    };
    let count = number(&["assembly", "number_of_blades"], notes);
    let is_count = |count: &f64| (1.0..=100.0).contains(count) && count.fract() == 0.0;
    blade.blades = count.filter(is_count).map(|count| count as usize);
    if let Some(wrong) = count.filter(|count| !is_count(count)) {
        let (found, expected) = (format!("{wrong}"), "a whole number from 1 to 100");
        notes.wrong(
            0,
            [
                "number_of_blades",
                &found,
                expected,
                "give the number of blades of the rotor",
            ],
        );
    }
    let half = |diameter: Option<f64>| diameter.filter(|&d| d > 0.0).map(|diameter| diameter / 2.0);
    blade.tip_radius = half(number(&["assembly", "rotor_diameter"], notes));
    let mut of_hub = |key: &'static str| {
        let shapes = ["outer_shape_bem", "outer_shape"];
        let mut shaped = shapes.into_iter();
        let found = shaped.find_map(|shape| number(&["components", "hub", shape, key], notes));
        found.or_else(|| number(&["components", "hub", key], notes))
    };
    blade.hub_radius = half(of_hub("diameter"));
    let radians = |angle: f64| {
        if has_degrees {
            angle.to_radians()
        } else {
            angle
        }
    };
    // Of both kinds of rotors, positive is away from the tower.
    let orientation = root.path(&["assembly", "rotor_orientation"]);
    let orientation = orientation.and_then(Node::text).unwrap_or_default();
    let is_downwind = orientation.to_lowercase().starts_with("down");
    let side = if is_downwind { -1.0 } else { 1.0 };
    let cone = of_hub("cone_angle").map(radians);
    blade.cone = cone.map(|cone| side * cone);
    if let Some(cone) = cone.filter(|cone| cone.abs() > LARGEST_CONE) {
        let found = format!("{:.4} deg", cone.to_degrees());
        let (expected, help) = (
            "at most 30 deg",
            "angles are in rad in version 1 and in deg in version 2",
        );
        notes.wrong(0, ["cone_angle of the hub", &found, expected, help]);
    }
    let tilt = ["components", "nacelle", "drivetrain", "uptilt"];
    blade.tilt = number(&tilt, notes).map(radians);
}

/// A required table on an ascending grid.
fn table(node: &Node, key: &str, notes: &mut Notes) -> Option<Column> {
    let column =
        required(node, "the outer shape", key, notes).and_then(|at| column(at, key, notes))?;
    column.is_ascending(key, notes).then_some(column)
}

/// A table that may be missing.
fn optional(node: &Node, key: &str, notes: &mut Notes) -> Option<Column> {
    node.entry(key)?;
    table(node, key, notes)
}

fn axis(node: &Node, notes: &mut Notes) -> Option<[Column; 3]> {
    let node = required(node, "the blade", "reference_axis", notes)?;
    let [x, y, z] = ["x", "y", "z"].map(|key| table(node, key, notes));
    Some([x?, y?, z?])
}

fn version_1(node: &Node, notes: &mut Notes) -> Option<Shape> {
    let axis = axis(node, notes);
    let (chord, feather) = (table(node, "chord", notes), table(node, "twist", notes));
    let point = optional(node, "pitch_axis", notes);
    let thickness = optional(node, "rthick", notes);
    let position = required(node, "the outer shape", "airfoil_position", notes)?;
    let grid = required(position, "airfoil_position", "grid", notes)
        .and_then(|at| numbers(at, "grid of airfoil_position", notes));
    let labels = required(position, "airfoil_position", "labels", notes)
        .and_then(|at| list(at, "labels", notes));
    let (grid, labels) = (grid?, labels?);
    if grid.len() != labels.len() || grid.is_empty() || grid.windows(2).any(|two| two[1] <= two[0])
    {
        let found = format!("{} positions and {} labels", grid.len(), labels.len());
        notes.wrong(
            position.line,
            [
                "airfoil_position",
                &found,
                "increasing positions, and a label for each",
                "correct the list",
            ],
        );
        return None;
    }
    let named = grid.into_iter().zip(labels);
    let airfoils =
        named.map(|(at, label)| (at, vec![(label.text().unwrap_or_default().to_owned(), 1.0)]));
    Some(Shape {
        airfoils: airfoils.collect(),
        axis: axis?,
        chord: chord?,
        feather: feather?,
        point,
        is_over_chord: true,
        thickness,
    })
}

fn version_2(blade: &Node, read: &[ReadAirfoil], notes: &mut Notes) -> Option<Shape> {
    let node = required(blade, "the blade", "outer_shape", notes)?;
    let axis = axis(blade, notes);
    let (chord, feather) = (table(node, "chord", notes), table(node, "twist", notes));
    let point = optional(node, "section_offset_y", notes);
    let thickness = optional(node, "rthick", notes);
    let items = required(node, "the outer shape", "airfoils", notes)
        .and_then(|at| list(at, "airfoils", notes))?;
    let airfoils: Vec<_> = items
        .iter()
        .filter_map(|item| mixture(item, read, notes))
        .collect();
    if airfoils.is_empty() || airfoils.windows(2).any(|two| two[1].0 <= two[0].0) {
        let found = format!("{} airfoils", airfoils.len());
        notes.wrong(
            node.line,
            [
                "airfoils of the outer shape",
                &found,
                "at least one, with increasing spanwise_position",
                "correct the list",
            ],
        );
        return None;
    }
    let mut feather = feather?;
    feather.values = feather
        .values
        .iter()
        .map(|angle| Unit::Degrees.radians(*angle))
        .collect();
    Some(Shape {
        airfoils,
        axis: axis?,
        chord: chord?,
        feather,
        point,
        is_over_chord: false,
        thickness,
    })
}

/// An airfoil of version 2 at its position: the configurations with their weights.
fn mixture(
    item: &Node,
    read: &[ReadAirfoil],
    notes: &mut Notes,
) -> Option<(f64, Vec<(String, f64)>)> {
    let name = required(item, "an airfoil of the blade", "name", notes)?.text()?;
    let at = required(item, "an airfoil of the blade", "spanwise_position", notes)?;
    let position = scalar(at, "spanwise_position", notes)?;
    let Some(configurations) = item.entry("configuration") else {
        return Some((position, vec![(name.to_owned(), 1.0)]));
    };
    let configurations = list(configurations, "configuration", notes)?;
    let weights = match item.entry("weight") {
        Some(weights) => numbers(weights, "weight", notes)?,
        None => vec![1.0; configurations.len()],
    };
    let sum: f64 = weights.iter().sum();
    if weights.len() != configurations.len() || (sum - 1.0).abs() > 1e-6 {
        let found = format!(
            "{} configurations, weights {weights:?}",
            configurations.len()
        );
        notes.wrong(
            item.line,
            [
                &format!("airfoil \"{name}\" of the blade"),
                &found,
                "a weight for each, with the sum 1",
                "correct the weights",
            ],
        );
        return None;
    }
    // Airfoils of one configuration have their plain name.
    let full = |configuration: &str| {
        let full = full_name(name, configuration);
        let is_known = read.iter().any(|airfoil| airfoil.data.name == full);
        if is_known { full } else { name.to_owned() }
    };
    let named = configurations
        .iter()
        .map(|item| full(item.text().unwrap_or_default()));
    Some((position, named.zip(weights).collect()))
}

impl Shape {
    /// The positions of all grids, each once.
    fn positions(&self) -> Vec<f64> {
        let grids = [&self.chord.grid, &self.feather.grid];
        let mut all: Vec<f64> = grids.into_iter().flatten().copied().collect();
        all.extend(self.airfoils.iter().map(|(at, _)| *at));
        all.sort_by(f64::total_cmp);
        all.dedup_by(|a, b| (*a - *b).abs() < SAME);
        all
    }

    fn stations(&self, read: &[ReadAirfoil]) -> Vec<AeroStation> {
        let positions = self.positions();
        positions
            .into_iter()
            .map(|at| self.station(at, read))
            .collect()
    }

    fn station(&self, at: f64, read: &[ReadAirfoil]) -> AeroStation {
        let [x, y, z] = &self.axis;
        let chord = self.chord.at(at);
        let point = self.point.as_ref().map(|point| point.at(at));
        let reference_point = match point {
            Some(point) if self.is_over_chord => point,
            Some(point) if chord > 0.0 => point / chord,
            _ => 0.25,
        };
        let parts = self.parts(at);
        let mean = |value: fn(&ReadAirfoil) -> Option<f64>| {
            let of = |(name, weight): &(String, f64)| {
                let airfoil = read.iter().find(|airfoil| airfoil.data.name == *name)?;
                Some(weight * value(airfoil)?)
            };
            parts.iter().map(of).sum::<Option<f64>>()
        };
        let thickness = self.thickness.as_ref().map(|thickness| thickness.at(at));
        AeroStation {
            sweep: -y.at(at),
            prebend: x.at(at),
            reference_point,
            aerodynamic_center: mean(|airfoil| airfoil.aerodynamic_center),
            thickness: thickness.or_else(|| mean(|airfoil| airfoil.data.thickness)),
            airfoil: StationAirfoil::Blend(parts.clone()),
            ..AeroStation::plain(z.at(at), chord, -self.feather.at(at))
        }
    }

    /// The airfoils and weights at a position.
    fn parts(&self, at: f64) -> Vec<(String, f64)> {
        let behind = self.airfoils.partition_point(|(known, _)| *known <= at);
        let before = behind.checked_sub(1).and_then(|i| self.airfoils.get(i));
        let (Some((from, first)), Some((to, second))) = (before, self.airfoils.get(behind)) else {
            let only = before.or_else(|| self.airfoils.first());
            return only.map(|(_, parts)| parts.clone()).unwrap_or_default();
        };
        let part = (at - from) / (to - from);
        let mut parts: Vec<(String, f64)> = Vec::new();
        let weighted = first
            .iter()
            .map(|it| (it, 1.0 - part))
            .chain(second.iter().map(|it| (it, part)));
        for ((name, weight), part) in weighted {
            match parts.iter_mut().find(|(known, _)| known == name) {
                Some((_, sum)) => *sum += weight * part,
                None => parts.push((name.clone(), weight * part)),
            }
        }
        parts.retain(|(_, weight)| *weight > 0.0);
        parts
    }
}
