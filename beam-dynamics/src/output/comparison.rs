//! Measured frequencies compared with computed ones.

use super::mode_units::Columns;
use super::rows::{csv_text, number};
use super::text::aligned;
use crate::case::FrequencyUnit;
use crate::input::short_number;
use crate::result::{Comparison, FrequencyTable, Measured, ModeKind};

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

/// The rows of `measured` that `table` has: rotor speed, order and name of the mode, measured and
/// computed frequency, also in the chosen unit, and their difference, which is computed minus
/// measured, in per cent of measured.
pub fn comparison_csv(measured: &Measured, table: &FrequencyTable) -> String {
    let columns = Columns(table.style.unit);
    let short = |value: f64| short_number(value, 6);
    let row = |row: Comparison| {
        let mut cells = columns.speed(row.measured.speed, number);
        cells.extend([order(&row), row.name.clone()]);
        cells.extend(columns.values(row.measured.frequency, number));
        cells.extend(columns.values(row.computed, number));
        cells.extend(columns.values(difference(&row), short));
        cells.push(short(per_cent(&row)));
        cells
    };
    let [measured_heading, computed, difference] =
        ["measured", "computed", "difference"].map(|name| columns.heading(name));
    let heading = format!(
        "{},order,name,{measured_heading},{computed},{difference},difference [%]",
        columns.speed_heading()
    );
    csv_text(&heading, measured.compare(table).into_iter().map(row))
}

/// The comparison of `measured` with `table` as text for a report.
pub fn comparison_text(measured: &Measured, table: &FrequencyTable) -> String {
    let rows = measured.compare(table);
    let mut text = "Comparison with measurements\n\n".to_owned();
    let unit = table.style.unit;
    let column = unit.of_column();
    let cells = |cells: [&str; 7]| cells.map(str::to_owned).to_vec();
    let [speeds, frequencies] = [unit.speed_word(), column.word()].map(|word| format!("[{word}]"));
    // None of these units depends on the speed.
    let value = |frequency: f64| column.value(frequency, 0.0).unwrap_or(frequency);
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
        cells([
            &speeds,
            "",
            "",
            &frequencies,
            &frequencies,
            &frequencies,
            "[%]",
        ]),
    ];
    for row in &rows {
        lines.push(vec![
            short_number(unit.speed(row.measured.speed), 6),
            order(row),
            row.name.clone(),
            format!("{:.3}", value(row.measured.frequency)),
            format!("{:.3}", value(row.computed)),
            format!("{:+.3}", value(difference(row))),
            format!("{:+.1}", per_cent(row)),
        ]);
    }
    if !rows.is_empty() {
        text.push_str(&aligned(&lines));
        text.push('\n');
    }
    text.push_str(&conclusion(&rows, unit));
    text.push_str(&left_out(measured, rows.len()));
    text
}

/// Mean and largest difference.
fn conclusion(rows: &[Comparison], unit: FrequencyUnit) -> String {
    let size = |row: &Comparison| per_cent(row).abs();
    let Some(worst) = rows.iter().max_by(|a, b| size(a).total_cmp(&size(b))) else {
        return String::new();
    };
    let mean = rows.iter().map(size).sum::<f64>() / rows.len() as f64;
    let speed = short_number(unit.speed(worst.measured.speed), 6);
    format!(
        "difference: computed minus measured; {mean:.1} % of measured in the mean, at most \
         {:.1} % ({} at {speed} {})\n",
        size(worst),
        worst.name,
        unit.speed_word()
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
        let mut table = samples::small();
        let expected = "\
rotor_speed [rpm],order,name,measured [Hz],computed [Hz],difference [Hz],difference [%]
0,1,flap 1,1.5,1.4,-0.1,-6.66667
600,2,torsion 1,99,99.5,0.5,0.505051
";
        assert_eq!(comparison_csv(&samples::measured(), &table), expected);
        table.style.unit = FrequencyUnit::Rpm;
        let csv = comparison_csv(&samples::measured(), &table);
        assert!(
            csv.contains("\n0,1,flap 1,1.5,90,1.4,84,-0.1,-6,-6.66667\n"),
            "{csv}"
        );
        let text = comparison_text(&samples::measured(), &table);
        assert!(
            text.contains("\n0          1     flap 1    90.000    84.000      -6.000  -6.7\n"),
            "{text}"
        );
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
