//! The points of a trim as CSV.

use crate::input::short_number;
use crate::output::rows::{csv_text, heading};
use crate::result::{TrimPoint, TrimResult};

/// Digits of numbers.
const DIGITS: usize = 12;

/// A row for each point: parameter of the sweep, controls, targets found and required with their error in
/// the unit of the target, iterations, residual, and whether the targets are met. Missing values are empty.
pub fn trim_csv(result: &TrimResult) -> String {
    let mut header: Vec<_> = result.sweep.iter().cloned().collect();
    header.extend(result.controls.iter().cloned());
    for name in &result.targets {
        header.extend([
            name.clone(),
            format!("{name} required"),
            format!("{name} error"),
        ]);
    }
    header.extend(["iterations", "residual [-]", "status"].map(str::to_owned));
    let rows = result.points.iter().map(|point| row(result, point));
    csv_text(&heading(header.iter().map(String::as_str)), rows)
}

fn row(result: &TrimResult, point: &TrimPoint) -> Vec<String> {
    let number = |value: Option<f64>| {
        let value = value.filter(|value| value.is_finite());
        value.map_or_else(String::new, |value| short_number(value, DIGITS))
    };
    let mut row: Vec<_> = point.at.iter().map(|at| number(Some(*at))).collect();
    let controls = 0..result.controls.len();
    row.extend(controls.map(|i| number(point.controls.get(i).copied())));
    for i in 0..result.targets.len() {
        let pair = point.targets.get(i);
        row.extend([0, 1].map(|k| number(pair.map(|pair| pair[k]))));
        row.push(small(pair.map_or(f64::NAN, |pair| pair[0] - pair[1])));
    }
    row.push(point.iterations.to_string());
    row.push(small(point.residual));
    row.push(match point.failure {
        None => "met".to_owned(),
        Some(_) => "not met".to_owned(),
    });
    row
}

/// An error or a residual; empty if it is not known.
fn small(value: f64) -> String {
    if value.is_finite() {
        format!("{value:.3e}")
    } else {
        String::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_a_point() {
        let point = |failure| TrimPoint {
            at: Some(0.2),
            controls: vec![1.5],
            targets: vec![[700.0, 701.0]],
            iterations: 3,
            residual: 2e-12,
            failure,
        };
        let failed = TrimPoint {
            targets: Vec::new(),
            ..point(Some(["why".to_owned(), "how".to_owned()]))
        };
        let result = TrimResult {
            name: "x".to_owned(),
            method: "shooting",
            sweep: Some("mu".to_owned()),
            requested: 3,
            controls: vec!["a,b".to_owned()],
            targets: vec!["lift".to_owned()],
            points: vec![point(None), failed],
            remarks: Vec::new(),
        };
        let text = trim_csv(&result);
        let expected = "mu,\"a,b\",lift,lift_required,lift_error,iterations,residual [-],\
                        status\n0.2,1.5,700,701,-1.000e0,3,2.000e-12,met\n\
                        0.2,1.5,,,,3,2.000e-12,not met\n";
        assert_eq!(text, expected);
    }
}
