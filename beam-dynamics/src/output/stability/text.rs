//! The report of stability over a parameter.

use std::f64::consts::TAU;

use crate::input::short_number;
use crate::output::text::aligned;
use crate::result::{StabilityPoint, StabilityResult, StabilityRoot};

/// Digits of values of the parameter, and of boundaries.
const DIGITS: [usize; 2] = [7, 10];
/// Values side by side: to fill the width of a page.
const VALUES_A_BLOCK: usize = 8;
/// Tables over the values: title, and the number of a root.
type OverValues = (&'static str, fn(&StabilityRoot) -> Option<f64>);
const OVER_VALUES: [OverValues; 2] = [
    ("Frequency [Hz]", |root| Some(root.frequency() / TAU)),
    ("Damping [%]", |root| Some(100.0 * root.damping_ratio()?)),
];

/// Boundaries, the stability of each value with its least damped mode, and remarks.
pub fn stability_text(result: &StabilityResult) -> String {
    let (name, parameter) = (&result.name, &result.parameter);
    let mut text = format!("{name}: stability over {parameter}, {}\n", result.method);
    for remark in &result.remarks {
        text.push_str(&format!("  remark: {remark}\n"));
    }
    text.push_str(&boundaries(result));
    text.push_str("\nLeast damped mode of each value\n");
    let has_errors = has_errors(result);
    let mut heading = vec!["", "unstable", "growth [1/s]", "frequency [Hz]", "mode"];
    if has_errors {
        heading.insert(3, "error [1/s]");
    }
    let mut rows = vec![heading.into_iter().map(str::to_owned).collect::<Vec<_>>()];
    rows[0][0].clone_from(parameter);
    for point in result.points.iter().filter(|point| point.is_requested) {
        let mut row = vec![short_number(point.at, DIGITS[0]), unstable(point)];
        if let Some((root, mode)) = point.least_damped() {
            row.extend(numbers(root, has_errors));
            row.push(named(root, &result.modes[mode]));
        }
        rows.push(row);
    }
    text.push_str(&aligned(&rows));
    text.push_str(&of_slight(result));
    let points = result.points.iter();
    let found = points.filter(|point| point.is_requested).count();
    let requested = result.requested;
    let added = result.points.len() - found;
    text + &format!("{found} of {requested} values were analyzed, and {added} between them\n")
}

/// The number of unstable roots, and how many of them are slight.
fn unstable(point: &StabilityPoint) -> String {
    let slight = point.roots.iter().filter(|root| root.is_slight());
    match slight.map(StabilityRoot::unstable).sum() {
        0 => point.unstable().to_string(),
        slight => format!("{} ({slight} *)", point.unstable()),
    }
}

/// The meaning of slight roots, if there are some.
fn of_slight(result: &StabilityResult) -> String {
    let requested = result.points.iter().filter(|point| point.is_requested);
    let mut roots = requested.flat_map(|point| &point.roots);
    if !roots.any(StabilityRoot::is_slight) {
        return String::new();
    }
    format!(
        "* the motion has no structural damping, and the air feeds it with less than {} % of the critical \
         damping: with the structural damping of a real blade it may decay (\"damping\" of the sections)\n",
        100.0 * StabilityRoot::SLIGHT
    )
}

/// Growth, perhaps its error, and frequency.
fn numbers(root: &StabilityRoot, has_errors: bool) -> Vec<String> {
    let mut texts = vec![format!("{:.6e}", root.growth())];
    if has_errors {
        let error = root.error.map(|error| format!("{error:.1e}"));
        texts.push(error.unwrap_or_else(|| "-".to_owned()));
    }
    texts.push(format!("{:.6}", root.frequency() / TAU));
    texts
}

/// The name of a mode, with a remark if its growth is below twice its error.
fn named(root: &StabilityRoot, name: &str) -> String {
    if root.is_resolved() {
        name.to_owned()
    } else {
        format!("{name}, growth below error")
    }
}

fn has_errors(result: &StabilityResult) -> bool {
    let mut roots = result.points.iter().flat_map(|point| &point.roots);
    roots.any(|root| root.error.is_some())
}

fn boundaries(result: &StabilityResult) -> String {
    if result.requested < 2 {
        return "\nOne value has no boundaries\n".to_owned();
    }
    if result.boundaries.is_empty() {
        return "\nNo boundary was found\n".to_owned();
    }
    let heading = [
        "",
        "type",
        "frequency [Hz]",
        "stable",
        "unstable below, above",
        "mode",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    rows[0][0].clone_from(&result.parameter);
    for own in &result.boundaries {
        rows.push(vec![
            short_number(own.at, DIGITS[1]),
            own.kind.word().to_owned(),
            format!("{:.6}", own.frequency / TAU),
            own.stable.word().to_owned(),
            format!("{}, {}", own.unstable[0], own.unstable[1]),
            own.name.clone(),
        ]);
    }
    format!("\nBoundaries\n{}", aligned(&rows))
}

/// Frequency and damping ratio of each mode at the requested values, side by side in blocks; `?` marks
/// modes whose growth is below twice its estimated error.
pub(super) fn modes_text(result: &StabilityResult) -> String {
    let requested = result.points.iter().filter(|point| point.is_requested);
    let points: Vec<_> = requested.collect();
    let seen = |mode: usize, point: &&StabilityPoint| point.root_of(mode).is_some();
    let blocks = points.len().div_ceil(VALUES_A_BLOCK).max(1);
    let mut text = String::new();
    for (title, number) in OVER_VALUES {
        text.push_str(&format!("\n{title}\n"));
        for block in points.chunks(points.len().div_ceil(blocks).max(1)) {
            let mut rows = vec![vec![result.parameter.clone()]];
            rows[0].extend(block.iter().map(|point| short_number(point.at, DIGITS[0])));
            for (mode, name) in result.modes.iter().enumerate() {
                if !block.iter().any(|point| seen(mode, point)) {
                    continue;
                }
                let cell = |point: &&StabilityPoint| {
                    let root = point.root_of(mode);
                    let mark = if root.is_some_and(|root| !root.is_resolved()) {
                        "?"
                    } else {
                        ""
                    };
                    let found = root.and_then(number);
                    found.map_or_else(|| "-".to_owned(), |number| format!("{number:.3}{mark}"))
                };
                let cells = block.iter().map(cell);
                rows.push(std::iter::once(name.clone()).chain(cells).collect());
            }
            text.push_str(&aligned(&rows));
            text.push('\n');
        }
    }
    let mut roots = points.iter().flat_map(|point| &point.roots);
    if roots.any(|root| !root.is_resolved()) {
        text.push_str("? the growth is below twice its estimated error: use more \"steps\"\n");
    }
    text
}

/// All roots of all values.
pub(super) fn roots_text(result: &StabilityResult) -> String {
    let has_errors = has_errors(result);
    let mut heading = vec!["", "growth [1/s]", "frequency [Hz]", "damping [%]", "mode"];
    if has_errors {
        heading.insert(2, "error [1/s]");
    }
    let mut rows = vec![heading.into_iter().map(str::to_owned).collect::<Vec<_>>()];
    rows[0][0].clone_from(&result.parameter);
    for point in &result.points {
        for (root, mode) in point.roots.iter().zip(&point.modes) {
            let mut row = vec![short_number(point.at, DIGITS[0])];
            row.extend(numbers(root, has_errors));
            let ratio = root
                .damping_ratio()
                .map(|ratio| format!("{:.4}", 100.0 * ratio));
            row.push(ratio.unwrap_or_default());
            row.push(named(root, &result.modes[*mode]));
            rows.push(row);
        }
    }
    format!("\nAll roots\n{}", aligned(&rows))
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;

    /// A result at one value with roots by falling growth and their modes.
    fn result(roots: Vec<StabilityRoot>, modes: Vec<usize>) -> StabilityResult {
        StabilityResult {
            name: "rotor".to_owned(),
            method: "eigenvalues",
            parameter: "wind".to_owned(),
            requested: 1,
            controls: Vec::new(),
            modes: ["axial 1", "edge 1", "flap 1"].map(str::to_owned).to_vec(),
            points: vec![StabilityPoint {
                at: 8.0,
                is_requested: true,
                roots,
                modes,
                controls: Vec::new(),
            }],
            boundaries: Vec::new(),
            failures: Vec::new(),
            remarks: Vec::new(),
        }
    }

    fn root(growth: f64, frequency: f64) -> StabilityRoot {
        StabilityRoot::new(Complex::new(growth, frequency))
    }

    // Growths that differ by 1e-9 of the roots are one; a difference of 1e-3 is none of round-off.
    #[test]
    fn the_first_of_equal_roots_is_the_least_damped_one() {
        for (second, expected) in [(-0.1 - 1e-8, "edge 1"), (-0.11, "flap 1")] {
            let roots = vec![root(-0.1, 12.0), root(second, 11.0), root(-5.0, 60.0)];
            let text = stability_text(&result(roots, vec![2, 1, 0]));
            let row = text.lines().find(|line| line.starts_with("8 ")).unwrap();
            assert!(row.ends_with(expected), "{text}");
            assert!(text.contains("One value has no boundaries"), "{text}");
        }
    }

    // 0.1 % of the critical damping without structural damping is slight, with it or with 2 % it is not.
    #[test]
    fn slight_growth_without_structural_damping_is_marked() {
        let at = |growth: f64, has_none: bool| StabilityRoot {
            has_no_structural_damping: has_none,
            ..root(growth, 60.0)
        };
        for (growth, has_none, expected) in [
            (0.06, true, "2 (2 *)"),
            (0.06, false, "2  "),
            (1.2, true, "2  "),
            (-0.06, true, "0  "),
        ] {
            let text = stability_text(&result(vec![at(growth, has_none)], vec![0]));
            let row = text.lines().find(|line| line.starts_with("8 ")).unwrap();
            assert!(row.contains(expected), "{expected}: {text}");
            let is_explained = text.contains("less than 0.5 % of the critical damping");
            assert_eq!(is_explained, expected.contains('*'), "{text}");
        }
    }
}
