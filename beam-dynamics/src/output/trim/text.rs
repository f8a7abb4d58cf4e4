//! The report of a trim.

use shared_geom::error::counted;

use crate::input::short_number;
use crate::output::text::aligned;
use crate::result::{TrimPoint, TrimResult};

/// Digits of numbers.
const DIGITS: usize = 9;

/// Controls and targets of all points, and remarks.
pub fn trim_text(result: &TrimResult) -> String {
    let mut text = format!("{}: trim, {}\n", result.name, result.method);
    for remark in &result.remarks {
        text.push_str(&format!("  remark: {remark}\n"));
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

/// The first point that is not met, with its reason and its remedy; `None` if all are met.
pub fn trim_failure(result: &TrimResult) -> Option<String> {
    let mut points = result.points.iter();
    let (point, [reason, remedy]) =
        points.find_map(|point| Some((point, point.failure.as_ref()?)))?;
    let place = match (&result.sweep, point.at) {
        (Some(sweep), Some(at)) => format!(" at {sweep} = {}", short_number(at, 6)),
        _ => String::new(),
    };
    Some(format!("{place}: {reason}\n  help: {remedy}"))
}

fn single(result: &TrimResult, point: &TrimPoint) -> String {
    let mut text = format!(
        "\n{}, largest residual {:.3e}\n\nControls\n",
        counted(point.iterations, "iteration"),
        point.residual
    );
    for (name, value) in result.controls.iter().zip(&point.controls) {
        text.push_str(&format!("  {name} = {}\n", short_number(*value, DIGITS)));
    }
    text.push_str("\nTargets\n");
    if point.targets.is_empty() && !point.controls.is_empty() {
        text.push_str("  unknown: the period from the last state has no solution\n");
    }
    for (name, [found, required]) in result.targets.iter().zip(&point.targets) {
        text.push_str(&format!(
            "  {name} = {}, required {}, error {:.1e}\n",
            short_number(*found, DIGITS),
            short_number(*required, DIGITS),
            found - required
        ));
    }
    text + "\n"
}

/// A line for each point.
fn table(result: &TrimResult) -> String {
    let names = result.sweep.iter().chain(&result.controls);
    let mut heading: Vec<_> = names.chain(&result.targets).cloned().collect();
    heading.extend(["iterations", "residual", ""].map(str::to_owned));
    let rows = result.points.iter().map(|point| {
        let found = point.targets.iter().map(|pair| pair[0]);
        let numbers = point.at.into_iter().chain(point.controls.iter().copied());
        let numbers = numbers.chain(found);
        let mut row: Vec<_> = numbers.map(|own| short_number(own, DIGITS)).collect();
        // A point without a solution has fewer numbers.
        row.resize(heading.len() - 3, String::new());
        row.push(point.iterations.to_string());
        row.push(format!("{:.2e}", point.residual));
        row.extend(point.failure.as_ref().map(|_| "not met".to_owned()));
        row
    });
    let rows: Vec<_> = std::iter::once(heading.clone()).chain(rows).collect();
    format!("\n{}\n", aligned(&rows))
}
