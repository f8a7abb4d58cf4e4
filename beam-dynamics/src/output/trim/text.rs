//! The report of a trim.

use crate::input::short_number;
use crate::result::{TrimPoint, TrimResult};

/// Digits of numbers.
const DIGITS: usize = 9;
/// Width of a column of numbers.
const WIDTH: usize = 17;

/// Controls and targets of all points, and remarks.
pub fn trim_text(result: &TrimResult) -> String {
    let mut text = format!("{}: trim, {}\n", result.name, result.method);
    for remark in &result.remarks {
        text.push_str(&format!("  note: {remark}\n"));
    }
    match (&result.sweep, result.points.as_slice()) {
        (None, [point]) => text.push_str(&single(result, point)),
        _ => text.push_str(&table(result)),
    }
    let met = result.met().count();
    text.push_str(&match (met, result.requested) {
        (1, 1) => "the targets are met\n".to_owned(),
        (0, 1) => "the targets are not met\n".to_owned(),
        (met, requested) => format!("the targets are met at {met} of {requested} points\n"),
    });
    text
}

fn single(result: &TrimResult, point: &TrimPoint) -> String {
    let mut text = format!(
        "\n{} iterations, largest residual {:.3e}\n\nControls\n",
        point.iterations, point.residual
    );
    for (name, value) in result.controls.iter().zip(&point.controls) {
        text.push_str(&format!("  {name} = {}\n", short_number(*value, DIGITS)));
    }
    text.push_str("\nTargets\n");
    for (name, [found, required]) in result.targets.iter().zip(&point.targets) {
        text.push_str(&format!(
            "  {name} = {}, required {}\n",
            short_number(*found, DIGITS),
            short_number(*required, DIGITS)
        ));
    }
    text + "\n"
}

/// A line for each point.
fn table(result: &TrimResult) -> String {
    let names = result.sweep.iter().chain(&result.controls);
    let names: Vec<_> = names.chain(&result.targets).collect();
    let mut text = "\n".to_owned();
    for name in names {
        text.push_str(&format!(
            "{name:>width$}",
            width = WIDTH.max(name.len() + 2)
        ));
    }
    text.push_str("  iterations   residual\n");
    for point in &result.points {
        let found = point.targets.iter().map(|pair| pair[0]);
        let numbers = point.at.into_iter().chain(point.controls.iter().copied());
        let all = result.sweep.iter().chain(&result.controls);
        let mut all = all.chain(&result.targets);
        for number in numbers.chain(found) {
            let width = WIDTH.max(all.next().map_or(0, |name| name.len() + 2));
            text.push_str(&format!("{:>width$}", short_number(number, DIGITS)));
        }
        let status = match point.failure {
            None => "",
            Some(_) => "  not met",
        };
        text.push_str(&format!(
            "{:12}  {:9.2e}{status}\n",
            point.iterations, point.residual
        ));
    }
    text + "\n"
}
