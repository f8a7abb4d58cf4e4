//! Measured frequencies compared with computed ones.

use super::text::{RPM, aligned};
use crate::input::short_number;
use crate::result::{Comparison, FrequencyTable, Measured, ModeKind};

const DIGITS: usize = 10;
const HEADING: &str =
    "rotor speed [rpm],order,name,measured [Hz],computed [Hz],difference [Hz],difference [%]";

/// Computed minus measured frequency [Hz].
fn difference(row: &Comparison) -> f64 {
    row.computed - row.measured.frequency
}

/// The difference in per cent of the measured frequency.
fn per_cent(row: &Comparison) -> f64 {
    100.0 * difference(row) / row.measured.frequency
}

fn order(row: &Comparison) -> String {
    row.measured
        .order
        .map_or_else(String::new, |order| order.to_string())
}

/// Rows with rotor speed, order and name of the mode, measured and computed frequency and their
/// difference, which is computed minus measured, in per cent of measured.
pub fn comparison_csv(rows: &[Comparison]) -> String {
    let mut text = format!("{HEADING}\n");
    for row in rows {
        let cells = [
            short_number(row.measured.speed * RPM, DIGITS),
            order(row),
            row.name.clone(),
            short_number(row.measured.frequency, DIGITS),
            short_number(row.computed, DIGITS),
            short_number(difference(row), 6),
            short_number(per_cent(row), 6),
        ];
        text.push_str(&cells.join(","));
        text.push('\n');
    }
    text
}

/// The comparison of `measured` with `table` as text for a report.
pub fn comparison_text(measured: &Measured, table: &FrequencyTable) -> String {
    let rows = measured.compare(table);
    let mut text = "Comparison with measurements\n\n".to_owned();
    let cells = |cells: [&str; 7]| cells.map(str::to_owned).to_vec();
    let mut lines = vec![
        cells([
            "speed",
            "order",
            "mode",
            "measured",
            "computed",
            "difference",
            "",
        ]),
        cells(["[rpm]", "", "", "[Hz]", "[Hz]", "[Hz]", "[%]"]),
    ];
    for row in &rows {
        lines.push(vec![
            short_number(row.measured.speed * RPM, 6),
            order(row),
            row.name.clone(),
            format!("{:.3}", row.measured.frequency),
            format!("{:.3}", row.computed),
            format!("{:+.3}", difference(row)),
            format!("{:+.1}", per_cent(row)),
        ]);
    }
    if !rows.is_empty() {
        text.push_str(&aligned(&lines));
        text.push('\n');
    }
    text.push_str(&conclusion(&rows));
    text.push_str(&left_out(measured, rows.len()));
    text
}

/// Mean and largest difference.
fn conclusion(rows: &[Comparison]) -> String {
    let size = |row: &Comparison| per_cent(row).abs();
    let Some(worst) = rows.iter().max_by(|a, b| size(a).total_cmp(&size(b))) else {
        return String::new();
    };
    let mean = rows.iter().map(size).sum::<f64>() / rows.len() as f64;
    let speed = short_number(worst.measured.speed * RPM, 6);
    format!(
        "difference: computed minus measured; {mean:.1} % of measured in the mean, at most \
         {:.1} % ({} at {speed} rpm)\n",
        size(worst),
        worst.name
    )
}

/// Points left out by the settings, and points without a computed counterpart.
fn left_out(measured: &Measured, compared: usize) -> String {
    let mut text = String::new();
    if !measured.leave_out.is_empty() {
        let words: Vec<_> = measured
            .leave_out
            .iter()
            .map(|kind| ModeKind::word(*kind))
            .collect();
        text.push_str(&format!(
            "order: ascending at each speed, without {}\n",
            words.join(", ")
        ));
    }
    let without_order = measured
        .points
        .iter()
        .filter(|point| point.order.is_none())
        .count();
    let beside_nothing = measured.points.len() - compared - without_order;
    for (count, reason) in [
        (without_order, "without an order"),
        (
            beside_nothing,
            "at speeds or of orders that were not computed",
        ),
    ] {
        match count {
            0 => {}
            1 => text.push_str(&format!("not compared: 1 measured point {reason}\n")),
            _ => text.push_str(&format!("not compared: {count} measured points {reason}\n")),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn rows_hold_both_numbers_and_their_difference() {
        let rows = samples::measured().compare(&samples::small());
        let expected = "\
rotor speed [rpm],order,name,measured [Hz],computed [Hz],difference [Hz],difference [%]
0,1,flap 1,1.5,1.4,-0.1,-6.66667
600,2,torsion 1,99,99.5,0.5,0.505051
";
        assert_eq!(comparison_csv(&rows), expected);
    }

    #[test]
    fn text_reports_what_was_not_compared() {
        let text = comparison_text(&samples::measured(), &samples::small());
        let expected = "\
Comparison with measurements

speed  order       mode  measured  computed  difference
[rpm]                        [Hz]      [Hz]        [Hz]   [%]
0          1     flap 1     1.500     1.400      -0.100  -6.7
600        2  torsion 1    99.000    99.500      +0.500  +0.5

difference: computed minus measured; 3.6 % of measured in the mean, at most 6.7 % (flap 1 at 0 rpm)
order: ascending at each speed, without lag
not compared: 1 measured point without an order
not compared: 2 measured points at speeds or of orders that were not computed
";
        assert_eq!(text, expected);
    }

    #[test]
    fn nothing_to_compare_is_no_table() {
        let mut measured = samples::measured();
        measured.points.truncate(0);
        let text = comparison_text(&measured, &samples::small());
        assert!(!text.contains("[Hz]"), "{text}");
    }
}
