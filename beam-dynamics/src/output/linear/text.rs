//! The report of a linear model.

use std::f64::consts::TAU;

use crate::input::short_number;
use crate::output::text::aligned;
use crate::result::{LinearModel, LinearVariable};

/// Eigenvalues in the report, the smallest first.
const SHOWN: usize = 40;
/// Digits of numbers.
const DIGITS: usize = 7;
/// Damping ratios up to this are written as zero [-].
const ROUND_OFF: f64 = 1e-12;

/// States, inputs, outputs, gains at rest, and the smallest eigenvalues.
pub fn linear_text(model: &LinearModel) -> String {
    let mut text = format!("{}: linear model about {}\n", model.name, model.about);
    for remark in &model.remarks {
        text.push_str(&format!("  remark: {remark}\n"));
    }
    let [states, inputs, outputs] = [&model.states, &model.inputs, &model.outputs].map(Vec::len);
    text.push_str(&format!(
        "\n{states} states, {inputs} inputs, {outputs} outputs; residual {:.1e}\n",
        model.residual
    ));
    for (title, variables) in [("Inputs", &model.inputs), ("Outputs", &model.outputs)] {
        if !variables.is_empty() {
            text.push_str(&format!("\n{title}\n{}", listed(variables)));
        }
    }
    text.push_str(&format!("\nStates\n{}", listed(&model.states)));
    text.push_str(&format!("\nEigenvalues\n{}", eigenvalues(model)));
    text
}

/// Names, units and values.
fn listed(variables: &[LinearVariable]) -> String {
    let row = |own: &LinearVariable| {
        let value = own.value.map(|value| short_number(value, DIGITS));
        vec![
            format!("  {} [{}]", own.name, own.unit),
            value.unwrap_or_default(),
        ]
    };
    aligned(&variables.iter().map(row).collect::<Vec<_>>())
}

/// Damping ratio of an eigenvalue, or zero if it is round-off [-].
fn ratio(own: &nalgebra::Complex<f64>) -> f64 {
    let ratio = -own.re / own.norm();
    if ratio.abs() > ROUND_OFF { ratio } else { 0.0 }
}

fn eigenvalues(model: &LinearModel) -> String {
    let heading = ["  growth [1/s]", "frequency [Hz]", "damping [-]"];
    let all = model.eigenvalues.iter().filter(|own| own.im >= 0.0);
    let row = |own: &nalgebra::Complex<f64>| {
        let damping = if own.im > 0.0 {
            short_number(ratio(own), DIGITS)
        } else {
            String::new()
        };
        vec![
            format!("  {}", short_number(own.re, DIGITS)),
            short_number(own.im / TAU, DIGITS),
            damping,
        ]
    };
    let count = all.clone().count();
    let rows = std::iter::once(heading.map(str::to_owned).to_vec()).chain(all.map(row));
    let rows: Vec<_> = rows.take(SHOWN + 1).collect();
    let rest = if count > SHOWN {
        format!("  and {} larger ones\n", count - SHOWN)
    } else {
        String::new()
    };
    aligned(&rows) + &rest
}
