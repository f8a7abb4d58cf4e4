//! Blades for MBDyn: a model of three-node beams with constitutive laws at their two
//! evaluation points, and bodies that hold the mass, clamped at the root. Written only.
//!
//! MBDyn's sections are Helicoid's: x along the beam, components axial, shear y, shear z,
//! torsion, bending y, bending z; matrices row by row, `sym` the upper triangle. The
//! nodes have the section axes of the blade, positions in the axes of the blade root.
//!
//! ```text
//! node 2 e - 1       node 2 e          node 2 e + 1   element e, xi = -1, 0, 1
//!    o--------x---------o---------x--------o          x: evaluation points, xi = -+1/sqrt 3
//!    [ body  ][       body        ][  body ]
//! ```
//!
//! A beam of MBDyn has no mass. The mass of the blade goes into bodies, each with the
//! integral of the rigid slices between the evaluation points around its node: with T
//! from the slice to the node, `sum of T M T^T ds`.
//!
//! # References
//! - MBDyn input file format manual (mbdyn.org): structural nodes, body, beam3,
//!   constitutive laws, clamp, eigenanalysis.

use std::path::PathBuf;

use nalgebra::{Matrix6, Vector3};

use super::Writing;
use crate::blade::Blade;
use crate::line::{Curve, Placed, Side};

mod bodies;
mod text;

#[cfg(test)]
mod tests;

use bodies::Body;

/// Coordinate of an evaluation point between the middle and the end of an element [-].
const EVALUATION: f64 = 0.577_350_269_189_625_8;

/// Smaller differences are round-off [-].
const EQUAL: f64 = 1e-12;

/// Whether `text` is a model of MBDyn.
pub(super) fn recognize(text: &str) -> bool {
    let compact = |line: &str| line.split_whitespace().collect::<String>();
    let mut lines = text.lines().map(compact);
    lines.any(|line| line.starts_with("begin:data;") || line.starts_with("begin:nodes;"))
}

/// The section at an evaluation point.
#[derive(Debug)]
struct Section {
    placed: Placed,
    stiffness: Matrix6<f64>,
    damping: Option<Matrix6<f64>>,
}

/// An element between two arc lengths of the blade.
#[derive(Debug)]
struct Element {
    from: f64,
    to: f64,
    sections: [Section; 2],
}

/// The model: nodes at the ends and middles of the elements.
#[derive(Debug)]
struct Model {
    nodes: Vec<Placed>,
    elements: Vec<Element>,
    bodies: Vec<Body>,
}

/// The blade as a model of MBDyn.
pub(super) fn write(blade: &Blade, name: &str) -> Writing {
    let blade = &blade.on_line();
    let curve = blade.line.curve();
    let model = model(blade, &curve);
    Writing {
        files: vec![(
            PathBuf::from(format!("{name}.mbd")),
            text::model(blade, &model),
        )],
        lost: lost(blade, &curve, &model),
    }
}

fn model(blade: &Blade, curve: &Curve) -> Model {
    let positions = mesh(blade, curve.length());
    let elements: Vec<_> = positions
        .windows(2)
        .map(|two| element(blade, curve, two[0], two[1]))
        .collect();
    // A line of straight pieces may have a kink at a node, which belongs to both.
    let first = positions.first().map(|&s| curve.at(s));
    let others = positions.windows(2).flat_map(|two| {
        [
            curve.at(0.5 * (two[0] + two[1])),
            curve.on(two[1], Side::Inner),
        ]
    });
    let nodes: Vec<_> = first.into_iter().chain(others).collect();
    let bodies = bodies::of(blade, curve, &positions, &nodes);
    Model {
        nodes,
        elements,
        bodies,
    }
}

/// Ends of the elements: the stations of the blade, and the ends of its line [m].
fn mesh(blade: &Blade, length: f64) -> Vec<f64> {
    let near = 1e-9 * length;
    let mut positions = vec![0.0];
    let inside = |s: &f64| *s > near && *s < length - near;
    positions.extend(blade.positions().into_iter().filter(inside));
    positions.push(length);
    positions
}

fn element(blade: &Blade, curve: &Curve, from: f64, to: f64) -> Element {
    let section = |xi: f64| {
        let s = 0.5 * (from + to) + 0.5 * xi * (to - from);
        Section {
            placed: curve.at(s),
            stiffness: blade.at(s, Side::Outer).0,
            damping: blade.damping_at(s, Side::Outer),
        }
    };
    Element {
        from,
        to,
        sections: [section(-EVALUATION), section(EVALUATION)],
    }
}

/// Properties that the model cannot carry, with their size.
fn lost(blade: &Blade, curve: &Curve, model: &Model) -> Vec<String> {
    let mut lost = Vec::new();
    let heaviest = model
        .bodies
        .iter()
        .map(|body| body.mass)
        .fold(0.0, f64::max);
    lost.push(format!(
        "consistent inertia: the mass is lumped into {} bodies at the nodes of {} elements, the \
         heaviest of {:.1} % of the blade",
        model.bodies.len(),
        model.elements.len(),
        100.0 * heaviest / blade.mass()
    ));
    let change = model.elements.iter().map(|element| {
        let [inner, outer] = [(element.from, Side::Outer), (element.to, Side::Inner)]
            .map(|(s, side)| blade.at(s, side).0);
        change(&inner, &outer)
    });
    let change = change.fold(0.0, f64::max);
    if change > EQUAL {
        lost.push(format!(
            "interpolation between stations: laws at two points of each element represent \
             stiffnesses that change by up to {:.0} % along an element",
            100.0 * change
        ));
    }
    let off = off_line(curve, model);
    if off > EQUAL * curve.length() {
        lost.push(format!(
            "the shape of the line between its points: parabolas through three nodes, off by up to {off:.1e} m"
        ));
    }
    let beyond = model
        .bodies
        .iter()
        .map(|body| body.beyond)
        .fold(0.0, f64::max);
    if beyond > EQUAL {
        lost.push(format!(
            "mass matrices that no rigid body has: up to {beyond:.1e} of the mass and moments of \
             inertia of a body"
        ));
    }
    lost
}

/// The greatest change of a diagonal entry, as part of the greater one.
fn change(a: &Matrix6<f64>, b: &Matrix6<f64>) -> f64 {
    let part = |i: usize| {
        let (a, b) = (a[(i, i)], b[(i, i)]);
        if a == b {
            0.0
        } else {
            (a - b).abs() / a.max(b)
        }
    };
    (0..6).map(part).fold(0.0, f64::max)
}

/// Distance of the parabola through the nodes of an element from the line, at its
/// evaluation points [m].
fn off_line(curve: &Curve, model: &Model) -> f64 {
    let elements = model.elements.iter().enumerate();
    let off = elements.flat_map(|(e, element)| {
        let node = |i: usize| {
            model
                .nodes
                .get(2 * e + i)
                .map_or(Vector3::zeros(), |at| at.position)
        };
        let nodes = [node(0), node(1), node(2)];
        [-EVALUATION, EVALUATION].map(|xi| {
            let shape = [0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)];
            let point = nodes[0] * shape[0] + nodes[1] * shape[1] + nodes[2] * shape[2];
            let s = 0.5 * (element.from + element.to) + 0.5 * xi * (element.to - element.from);
            (point - curve.at(s).position).norm()
        })
    });
    off.fold(0.0, f64::max)
}
