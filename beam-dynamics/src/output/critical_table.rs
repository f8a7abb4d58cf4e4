//! Critical speeds: text and CSV.

use super::mode_units::Columns;
use super::rows::csv_text;
use super::text::aligned;
use crate::input::short_number;
use crate::result::{CriticalSpeed, FrequencyTable};

/// Critical speeds that are printed; the table for programs has all.
const MOST: usize = 40;
/// Digits in the table for programs: of an interpolation.
const DIGITS: usize = 6;

/// One row per critical speed of the modes of `table`, ascending; the harmonic 0 is a frequency that
/// passes through zero.
pub fn critical_csv(table: &FrequencyTable, critical: &[CriticalSpeed]) -> String {
    let columns = Columns(table.style.unit);
    let short = |value: f64| short_number(value, DIGITS);
    let row = |critical: &CriticalSpeed| {
        let mut row = columns.speed(critical.speed, short);
        row.push(critical.order.to_string());
        row.extend(columns.values(critical.frequency, short));
        row.push(critical.name.clone());
        row
    };
    let heading = format!(
        "{},harmonic [-],{},name",
        columns.speed_heading(),
        columns.heading("frequency")
    );
    csv_text(&heading, critical.iter().map(row))
}

/// The critical speeds of the modes of `table` in these axes as text for a report; empty without
/// any.
pub(super) fn critical_text(
    table: &FrequencyTable,
    axes: &str,
    critical: &[CriticalSpeed],
) -> String {
    if critical.is_empty() {
        return String::new();
    }
    // Per revolution the frequency is n.
    let unit = table.style.unit;
    let column = unit.of_column();
    let speed = format!("rotor speed [{}]", unit.speed_word());
    let heading = [&speed, column.word(), "n", "mode"].map(str::to_owned);
    let row = |critical: &CriticalSpeed| {
        let order = match critical.order {
            0 => "whirl reverses".to_owned(),
            order => format!("{order}P"),
        };
        let frequency = column.value(critical.frequency, critical.speed);
        vec![
            format!("{:.4}", unit.speed(critical.speed)),
            frequency.map_or_else(String::new, |value| format!("{value:.3}")),
            order,
            critical.name.clone(),
        ]
    };
    let shown = critical.iter().take(MOST).map(row);
    let lines: Vec<_> = std::iter::once(heading.to_vec()).chain(shown).collect();
    let mut text = format!(
        "Critical speeds: frequency in {axes} = n times the rotor speed\n\n{}\n",
        aligned(&lines)
    );
    let more = critical.len().saturating_sub(MOST);
    if more > 0 {
        text.push_str(&format!(
            "  and {more} more in the table of critical speeds\n\n"
        ));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    // The flap mode of 1.4 Hz at rest and 12.5 Hz at 600 rpm meets 2P where 1.4 + 11.1 x = 20 x.
    #[test]
    fn the_speeds_of_a_single_blade_are_those_of_the_turning_axes() {
        let mut table = samples::small();
        assert!(table.critical_of_blade(&table.harmonics()).is_empty());
        table.is_single_blade = true;
        let critical = table.critical_of_blade(&table.harmonics());
        let expected = "\
Critical speeds: frequency in the turning axes = n times the rotor speed

rotor speed [rpm]      Hz   n    mode
44.4444             2.222  3P  flap 1
94.3820             3.146  2P  flap 1
461.6661           23.083  3P   lag 1

";
        assert_eq!(
            critical_text(&table, "the turning axes", &critical),
            expected
        );
        let csv = critical_csv(&table, &critical[1..2]);
        let expected = "\
rotor_speed [rpm],harmonic [-],frequency [Hz],name
94.382,2,3.14607,flap 1
";
        assert_eq!(csv, expected);
    }
}
