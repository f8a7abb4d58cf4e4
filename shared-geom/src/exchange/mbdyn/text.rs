//! The model in the input language of MBDyn.

use std::fmt::Write as _;

use nalgebra::{Matrix3, Matrix6, Vector3};

use super::{Model, Section};
use crate::blade::{Blade, BladeDamping};
use crate::exchange::frame::Convention;
use crate::exchange::header::Header;
use crate::exchange::text::upper;

/// The whole input file.
pub(super) fn model(blade: &Blade, model: &Model) -> String {
    let mut text = head(blade, model);
    nodes(&mut text, model);
    text += "\nbegin: elements;\n    joint: 1, clamp, 1, node, node;\n";
    for body in &model.bodies {
        let _ = writeln!(
            text,
            "\n    body: {}, {}, {},\n        {},\n        sym, {};",
            body.node + 1,
            body.node + 1,
            number(body.mass),
            vector(&body.center),
            symmetric_3(&body.inertia),
        );
    }
    for (e, element) in model.elements.iter().enumerate() {
        let _ = writeln!(
            text,
            "\n    # from {:.6} m to {:.6} m\n    beam3: {},\n        {}, null,\n        {}, \
             null,\n        {}, null,",
            element.from,
            element.to,
            e + 1,
            2 * e + 1,
            2 * e + 2,
            2 * e + 3
        );
        let [inner, outer] = &element.sections;
        let _ = writeln!(
            text,
            "{},\n{};",
            section(blade, inner),
            section(blade, outer)
        );
    }
    text += "end: elements;\n";
    text
}

fn head(blade: &Blade, model: &Model) -> String {
    let point = "the reference line; MBDyn's sections are x along the beam, y, z, as Helicoid's";
    let header = Header::new(blade, Convention::Helicoid, point);
    let mut text = header.lines("# ");
    text +=
        "# positions in the axes of the blade root: x to the tip, y to the leading edge, z up\n";
    text +=
        "# clamped at node 1, at rest; nodes 2 e - 1, 2 e, 2 e + 1 of element e; mass in bodies\n";
    text += "\nbegin: data;\n    problem: initial value;\nend: data;\n";
    text += "\nbegin: initial value;\n    initial time: 0.;\n    final time: 1.e-3;\n";
    text += "    time step: 1.e-3;\n    tolerance: 1.e-6;\n    max iterations: 20;\n";
    text += "    eigenanalysis: 0.,\n        parameter, 0.01,\n        output eigenvectors,\n";
    text += "        use lapack;\nend: initial value;\n";
    let _ = writeln!(
        text,
        "\nbegin: control data;\n    structural nodes: {};\n    rigid bodies: {};\n    beams: \
         {};\n    joints: 1;\nend: control data;",
        model.nodes.len(),
        model.bodies.len(),
        model.elements.len()
    );
    text
}

fn nodes(text: &mut String, model: &Model) {
    *text += "\nbegin: nodes;\n";
    for (i, node) in model.nodes.iter().enumerate() {
        let _ = writeln!(
            text,
            "    structural: {}, dynamic,\n        {},\n        matr, {},\n        null, null;",
            i + 1,
            vector(&node.position),
            rows(&node.axes),
        );
    }
    *text += "end: nodes;\n";
}

/// Orientation and constitutive law at an evaluation point.
fn section(blade: &Blade, section: &Section) -> String {
    let orientation = rows(&section.placed.axes);
    let stiffness = numbers(&upper(&section.stiffness));
    let law = match (&blade.damping, &section.damping) {
        (Some(BladeDamping::Proportional(time)), _) => format!(
            "linear viscoelastic generic,\n            sym, {stiffness},\n            \
             proportional, {}",
            number(*time)
        ),
        (_, Some(damping)) => format!(
            "linear viscoelastic generic,\n            sym, {stiffness},\n            matr, {}",
            rows_6(damping)
        ),
        _ => format!("linear elastic generic,\n            sym, {stiffness}"),
    };
    format!("        reference, global, matr, {orientation},\n        {law}")
}

fn number(value: f64) -> String {
    // no negative zero, which results from changes of axes
    format!("{:.16e}", value + 0.0)
}

fn numbers(values: &[f64]) -> String {
    let words: Vec<_> = values.iter().map(|&value| number(value)).collect();
    words.join(", ")
}

fn vector(value: &Vector3<f64>) -> String {
    numbers(value.as_slice())
}

/// A matrix row by row.
fn rows(matrix: &Matrix3<f64>) -> String {
    numbers(matrix.transpose().as_slice())
}

fn rows_6(matrix: &Matrix6<f64>) -> String {
    numbers(matrix.transpose().as_slice())
}

/// The upper triangle row by row.
fn symmetric_3(matrix: &Matrix3<f64>) -> String {
    let pairs = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    numbers(&pairs.map(|pair| matrix[pair]))
}
