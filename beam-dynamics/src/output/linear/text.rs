//! The report of a linear model.

use std::f64::consts::TAU;

use crate::input::short_number;
use crate::output::text::aligned;
use crate::result::{LinearModel, LinearVariable};

/// Eigenvalues in the report, the smallest first.
const SHOWN: usize = 40;
/// Digits of numbers.
const DIGITS: usize = 7;
/// Round-off of the growth of an eigenvalue, as a part of the largest eigenvalue: some tens of the
/// round-off of numbers, since all of them have the error of the matrix [-].
const ROUND_OFF: f64 = 1e-14;

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

fn eigenvalues(model: &LinearModel) -> String {
    let heading = ["  growth [1/s]", "frequency [Hz]", "damping [-]"];
    let all = model.eigenvalues.iter().filter(|own| own.im >= 0.0);
    let norms = model.eigenvalues.iter().map(|own| own.norm());
    let limit = ROUND_OFF * norms.fold(0.0, f64::max);
    let row = |own: &nalgebra::Complex<f64>| {
        let growth = if own.re.abs() > limit { own.re } else { 0.0 };
        let damping = if own.im > 0.0 {
            // Not "-0".
            short_number(0.0 - growth / own.norm(), DIGITS)
        } else {
            String::new()
        };
        vec![
            format!("  {}", short_number(growth, DIGITS)),
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

#[cfg(test)]
mod tests {
    use nalgebra::{Complex, DMatrix};

    use super::*;

    #[test]
    fn growth_within_the_round_off_of_the_largest_eigenvalue_is_zero() {
        let none = || DMatrix::zeros(0, 0);
        let mut model = LinearModel {
            name: "a".to_owned(),
            about: "rest".to_owned(),
            speed: 0.0,
            states: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            a: none(),
            b: none(),
            c: none(),
            d: none(),
            eigenvalues: vec![Complex::new(3e-12, TAU), Complex::new(-0.1, 1e3)],
            residual: 0.0,
            remarks: Vec::new(),
        };
        let first = |model: &LinearModel| {
            let text = eigenvalues(model);
            let row = text.lines().nth(1).map(|row| row.split_whitespace());
            row.into_iter()
                .flatten()
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        assert_eq!(first(&model), ["0", "1", "0"]);
        model.eigenvalues[0].re = 3e-11;
        assert_eq!(first(&model)[0], "3e-11");
    }
}
