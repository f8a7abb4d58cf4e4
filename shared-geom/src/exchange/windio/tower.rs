//! Towers of windIO turbine files: straight tubes with walls of isotropic layers, from the outside inward.
//!
//! | | version 1 | version 2 |
//! |---|---|---|
//! | under `components.tower` | `outer_shape_bem.outer_diameter` | `outer_shape.outer_diameter` |
//! | wall | `internal_structure_2d_fem.layers` | `structure.layers` |
//! | axis | `outer_shape_bem.reference_axis` | `reference_axis` |
//!
//! Diameter and thicknesses are linear between the positions of their grids. A ring between the radii `r_i` and
//! `r_o` has
//!
//! ```text
//! A = pi (r_o^2 - r_i^2)     I = pi/4 (r_o^4 - r_i^4)     J = 2 I     A_s = A / 2
//! ```
//!
//! with the area in shear `A_s` of thin walls. The mass has the factor `outfitting_factor`.

use std::f64::consts::PI;
use std::path::Path;
use std::rc::Rc;

use nalgebra::{Matrix6, Vector2, Vector3};

use super::super::Reading;
use super::super::problem::{ExchangeProblem, Problems};
use super::super::stations::{name_of, provenance};
use super::super::text::number;
use super::fields::{self, Column, required};
use crate::blade::{Blade, Interpolation, Station};
use crate::exchange::yaml::{Node, Value};
use crate::line::{Course, LinePoint, ReferenceLine};

/// The name of the body.
pub(in crate::exchange) const BODY: &str = "tower";
/// Its table, as text.
const OF_TOWER: &str = "components.tower";
/// Stations in an interval of the grids, in which diameter and thickness are linear.
const STATIONS: usize = 4;
/// Change of x and y along a tower that is straight, as a part of its height.
const STRAIGHT: f64 = 1e-9;

/// A layer of the wall.
struct Layer {
    /// Thickness \[m\].
    thickness: Column,
    /// Moduli of elasticity and of shear \[Pa\].
    moduli: [f64; 2],
    /// Density \[kg/m^3\].
    density: f64,
}

/// A tower.
struct Tower {
    height: f64,
    diameter: Column,
    layers: Vec<Layer>,
    outfitting: f64,
}

/// The tower of a file as a line of sections; `None` if it is wrong, which is noted.
pub(super) fn reading(
    root: &Node,
    (text, file): (&str, &Path),
    problems: &mut Problems,
) -> Option<Reading> {
    let components = required(root, "the file", "components", problems)?;
    let node = required(components, "components", BODY, problems)?;
    let is_first = node.entry("outer_shape_bem").is_some();
    let tables = match is_first {
        true => ["outer_shape_bem", "internal_structure_2d_fem"],
        false => ["outer_shape", "structure"],
    };
    let [shape, structure] = tables.map(|key| required(node, OF_TOWER, key, problems));
    let (shape, structure) = (shape?, structure?);
    let tower = tower(root, [node, shape, structure], problems)?;
    let stations = tower.stations(structure.line, problems)?;
    let point = |x: f64| LinePoint {
        position: Vector3::new(x, 0.0, 0.0),
        twist: 0.0,
    };
    let version = if is_first { 1 } else { 2 };
    let blade = Blade {
        name: name_of(file),
        line: ReferenceLine::through(vec![point(0.0), point(tower.height)], Course::Polyline),
        reference_point: Vector2::zeros(),
        stations,
        interpolation: Interpolation::Linear,
        damping: None,
        provenance: provenance(&format!("windIO {version}"), &[text]),
    };
    let remark = format!(
        "the tower is a tube whose diameter and thickness are linear between the positions of their grids, without \
         flanges; its mass has the outfitting factor {}",
        tower.outfitting
    );
    Some(Reading::new(blade, vec![remark]))
}

/// The tower of its table, with the ones of its shape and its structure.
fn tower(
    root: &Node,
    [node, shape, structure]: [&Node; 3],
    problems: &mut Problems,
) -> Option<Tower> {
    let axis = node.entry("reference_axis");
    let axis = axis.or_else(|| shape.entry("reference_axis"));
    let height = match axis {
        Some(axis) => height(axis, problems),
        None => required(node, OF_TOWER, "reference_axis", problems).and(None),
    };
    let diameter = required(shape, OF_TOWER, "outer_diameter", problems);
    let diameter = diameter.and_then(|node| fields::column(node, "outer_diameter", problems));
    let layers = layers(root, structure, problems);
    let outfitting = match structure.entry("outfitting_factor") {
        Some(node) => positive(node, "outfitting_factor", problems),
        None => Some(1.0),
    };
    Some(Tower {
        height: height?,
        diameter: diameter?,
        layers: layers?,
        outfitting: outfitting?,
    })
}

/// The height of a straight vertical axis \[m\].
fn height(axis: &Node, problems: &mut Problems) -> Option<f64> {
    let z = required(axis, "reference_axis", "z", problems)?;
    let (line, z) = (z.line, fields::column(z, "reference_axis.z", problems)?);
    let height = z.at(1.0) - z.at(0.0);
    if height <= 0.0 {
        let problem = ExchangeProblem::Other {
            what: "reference_axis.z".to_owned(),
            found: format!("{height} m in all"),
            expected: "more than zero".to_owned(),
            help: "z is the height, from the foot to the top".to_owned(),
        };
        problems.push(line, &problem);
        return None;
    }
    for key in ["x", "y"] {
        let Some(node) = axis.entry(key) else {
            continue;
        };
        let what = format!("reference_axis.{key}");
        let values = fields::column(node, &what, problems)?.values;
        let first = values.first().copied().unwrap_or_default();
        if let Some(value) = values
            .iter()
            .find(|value| (*value - first).abs() > STRAIGHT * height)
        {
            let found = format!("{value} after {first}");
            let problem = ExchangeProblem::Other {
                what,
                found,
                expected: "the same value along the tower".to_owned(),
                help: "a tower is a straight vertical tube".to_owned(),
            };
            problems.push(node.line, &problem);
            return None;
        }
    }
    Some(height)
}

/// A number above zero; notes another value.
fn positive(node: &Node, what: &str, problems: &mut Problems) -> Option<f64> {
    let found = node.text().and_then(number);
    let found = found.filter(|number| *number > 0.0 && number.is_finite());
    if found.is_none() {
        let problem = ExchangeProblem::Other {
            what: what.to_owned(),
            found: node.text().map_or_else(|| node.kind(), str::to_owned),
            expected: "one number above zero".to_owned(),
            help: "layers of towers are isotropic: E, nu and rho are numbers".to_owned(),
        };
        problems.push(node.line, &problem);
    }
    found
}

/// The layers of the wall.
fn layers(root: &Node, structure: &Node, problems: &mut Problems) -> Option<Vec<Layer>> {
    let node = required(structure, "the structure of the tower", "layers", problems)?;
    let items = items(node, "layers of the tower", problems)?;
    // All are read, so that all problems are reported.
    let layers: Vec<_> = items
        .iter()
        .map(|item| layer(root, item, problems))
        .collect();
    layers.into_iter().collect()
}

/// The items of a list; notes another value.
fn items<'a>(node: &'a Node, what: &str, problems: &mut Problems) -> Option<&'a [Rc<Node>]> {
    if let Value::List(items) = &node.value {
        return Some(items);
    }
    let problem = ExchangeProblem::Other {
        what: what.to_owned(),
        found: node.kind(),
        expected: "a list".to_owned(),
        help: "begin the items with \"-\"".to_owned(),
    };
    problems.push(node.line, &problem);
    None
}

fn layer(root: &Node, item: &Node, problems: &mut Problems) -> Option<Layer> {
    let of = "a layer of the tower";
    let thickness = required(item, of, "thickness", problems);
    let thickness = thickness.and_then(|node| fields::column(node, "thickness", problems));
    let name = required(item, of, "material", problems)?;
    let list = required(root, "the file", "materials", problems)?;
    let materials = items(list, "materials", problems)?;
    let is_it = |node: &&Rc<Node>| node.entry("name").and_then(Node::text) == name.text();
    let Some(material) = materials.iter().find(is_it) else {
        let problem = ExchangeProblem::Missing {
            what: format!("the material \"{}\"", name.text().unwrap_or_default()),
            help: "add it to materials, or correct the name".to_owned(),
        };
        problems.push(name.line, &problem);
        return None;
    };
    let of = format!("material \"{}\"", name.text().unwrap_or_default());
    let [e, nu, rho] = ["E", "nu", "rho"].map(|key| {
        let node = required(material, &of, key, problems)?;
        positive(node, &format!("{key} of {of}"), problems)
    });
    let (e, nu) = (e?, nu?);
    Some(Layer {
        thickness: thickness?,
        moduli: [e, 0.5 * e / (1.0 + nu)],
        density: rho?,
    })
}

impl Tower {
    /// The stations: at the positions of all grids and between them.
    fn stations(&self, line: usize, problems: &mut Problems) -> Option<Vec<Station>> {
        let mut parts: Vec<f64> = vec![0.0, 1.0];
        parts.extend(&self.diameter.grid);
        parts.extend(self.layers.iter().flat_map(|layer| &layer.thickness.grid));
        parts.retain(|part| (0.0..=1.0).contains(part));
        parts.sort_by(f64::total_cmp);
        parts.dedup();
        let between = parts.windows(2).flat_map(|two| {
            let at = |i: usize| two[0] + (two[1] - two[0]) * i as f64 / STATIONS as f64;
            (0..STATIONS).map(at).collect::<Vec<_>>()
        });
        let stations: Vec<_> = between.chain([1.0]).collect();
        let stations = stations
            .into_iter()
            .map(|part| self.station(part, line, problems));
        stations.collect()
    }

    /// The section at a part of the height; `None` without a wall, or with one thicker than the radius,
    /// which is noted.
    fn station(&self, part: f64, line: usize, problems: &mut Problems) -> Option<Station> {
        let outer = 0.5 * self.diameter.at(part);
        let mut stiffness = [0.0; 6];
        let mut mass = [0.0; 6];
        let mut radius = outer;
        for layer in &self.layers {
            let inner = radius - layer.thickness.at(part);
            let area = PI * (radius * radius - inner * inner);
            let second = 0.25 * PI * (radius.powi(4) - inner.powi(4));
            let [e, g] = layer.moduli;
            let own = [
                e * area,
                0.5 * g * area,
                0.5 * g * area,
                2.0 * g * second,
                e * second,
                e * second,
            ];
            let density = self.outfitting * layer.density;
            let inertia = [area, area, area, 2.0 * second, second, second].map(|one| density * one);
            for i in 0..6 {
                stiffness[i] += own[i];
                mass[i] += inertia[i];
            }
            radius = inner;
        }
        if !(radius >= 0.0 && radius < outer) {
            let problem = ExchangeProblem::Other {
                what: format!("the wall of the tower at the part {part} of its height"),
                found: format!("{} m thick, with the radius {outer} m", outer - radius),
                expected: "a thickness above zero, at most the radius".to_owned(),
                help: "diameters and thicknesses are in meters".to_owned(),
            };
            problems.push(line, &problem);
            return None;
        }
        Some(Station {
            arc_length: part * self.height,
            stiffness: Matrix6::from_diagonal(&stiffness.into()),
            mass: Matrix6::from_diagonal(&mass.into()),
        })
    }
}

#[cfg(test)]
mod tests;
