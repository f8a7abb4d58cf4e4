//! Comparison of two blade files.

use shared_geom::blade::BladeDifference;

use super::text::aligned;

/// Largest number of entries in the list of differences.
const SHOWN: usize = 12;

/// The differences of the files `a` and `b` as text, and whether they are equal within the
/// `tolerance`; a `note` states the reason why frequencies are not compared.
pub fn blade_comparison(
    [a, b]: [&str; 2],
    all: &[BladeDifference],
    tolerance: f64,
    note: Option<&str>,
) -> String {
    let mut text = format!(
        "Comparison\n  A  {a}\n  B  {b}\n\nLargest differences: of the line relative to the \
         length, of twist to one radian,\nof matrices to sqrt(Aii Ajj), of other quantities to \
         A\n"
    );
    text += &table(all.iter());
    if let Some(note) = note {
        text += &format!("\nFrequencies are not compared: {note}\n");
    }
    text.push('\n');
    let mut beyond: Vec<_> = all
        .iter()
        .filter(|one| one.relative.is_nan() || one.relative > tolerance)
        .collect();
    beyond.sort_by(|a, b| b.relative.total_cmp(&a.relative));
    let most = all.iter().map(|one| one.relative).fold(0.0, f64::max);
    if beyond.is_empty() {
        text +=
            &format!("Equal within {tolerance:e}: the largest relative difference is {most:.1e}\n");
        return text;
    }
    text += &format!(
        "Different: {} of {} quantities by more than {tolerance:e}, largest first\n",
        beyond.len(),
        all.len()
    );
    text += &table(beyond.iter().copied().take(SHOWN));
    if beyond.len() > SHOWN {
        text += &format!("  and {} more\n", beyond.len() - SHOWN);
    }
    text
}

/// A table of differences.
fn table<'a>(all: impl Iterator<Item = &'a BladeDifference>) -> String {
    let head = ["  quantity", "A", "B", "unit", "relative", "at m"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(all.map(row));
    aligned(&rows)
}

fn row(one: &BladeDifference) -> Vec<String> {
    let (factor, unit) = match one.unit {
        "rad" => (180.0 / std::f64::consts::PI, "deg"),
        unit => (1.0, unit),
    };
    let number = |value: f64| {
        if value == 0.0 {
            "0".to_owned()
        } else {
            format!("{:.5e}", value * factor)
        }
    };
    vec![
        format!("  {}", one.name),
        number(one.a),
        number(one.b),
        unit.to_owned(),
        if one.relative == 0.0 {
            "0".to_owned()
        } else {
            format!("{:.1e}", one.relative)
        },
        one.at.map_or(String::new(), |at| format!("{at:.4}")),
    ]
}
