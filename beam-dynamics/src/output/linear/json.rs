//! A linear model as JSON.

use nalgebra::DMatrix;
use serde_json::{Value, json};

use crate::result::{LinearModel, LinearVariable};

/// Version of the keys.
const VERSION: u32 = 1;

/// The matrices by rows, with names, units and values of states, inputs and outputs.
pub fn linear_json(model: &LinearModel) -> String {
    let eigenvalues = model.eigenvalues.iter();
    let eigenvalues: Vec<_> = eigenvalues.map(|value| [value.re, value.im]).collect();
    let value = json!({
        "format": "helicoid linear model",
        "version": VERSION,
        "name": model.name,
        "equations": "x' = A x + B u, y = C x + D u: changes about the point of operation, SI units",
        "about": model.about,
        "rotor_speed": model.speed,
        "states": variables(&model.states),
        "inputs": variables(&model.inputs),
        "outputs": variables(&model.outputs),
        "A": rows(&model.a),
        "B": rows(&model.b),
        "C": rows(&model.c),
        "D": rows(&model.d),
        "eigenvalues": eigenvalues,
        "residual": model.residual,
        "remarks": model.remarks,
    });
    serde_json::to_string(&value).unwrap_or_default() + "\n"
}

fn variables(all: &[LinearVariable]) -> Vec<Value> {
    let one = |own: &LinearVariable| match own.value {
        Some(value) => json!({ "name": own.name, "unit": own.unit, "value": value }),
        None => json!({ "name": own.name, "unit": own.unit }),
    };
    all.iter().map(one).collect()
}

fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    let rows = matrix.row_iter();
    rows.map(|row| row.iter().copied().collect()).collect()
}
