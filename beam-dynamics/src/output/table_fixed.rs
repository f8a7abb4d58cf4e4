//! Modes in the fixed system and critical speeds: text and CSV.

use super::critical_table::critical_text;
use super::mode_units::Columns;
use super::rows::{csv_text, number};
use super::text::aligned;
use crate::input::short_number;
use crate::result::{Direction, FixedPoint, FixedTable, FrequencyTable};

/// Speeds side by side: to fill the width of a page.
const SPEEDS_A_BLOCK: usize = 6;

/// One row per speed and mode of `fixed`, the modes of `table`: frequency in the fixed system, also
/// per revolution, damping ratio relative to it, and direction around the rotor, empty for
/// motion without one.
pub fn campbell_csv(table: &FrequencyTable, fixed: &FixedTable) -> String {
    let columns = Columns(table.style.unit);
    let mut rows = Vec::new();
    for (k, &speed) in table.speeds.iter().enumerate() {
        for line in &fixed.lines {
            let Some(point) = line.points.get(k).copied().flatten() else {
                continue;
            };
            let mut row = columns.speed(speed, number);
            row.push(line.name.clone());
            row.push(point.kind.word_in(table.style.words).to_owned());
            row.extend(columns.frequency(point.frequency(), speed));
            row.push(short_number(point.damping_ratio, 6));
            row.push(point.direction.map_or("", Direction::word).to_owned());
            rows.push(row);
        }
    }
    let heading = format!(
        "{},name,kind,{},damping ratio [-],direction",
        columns.speed_heading(),
        columns.frequency_heading()
    );
    csv_text(&heading, rows)
}

/// Frequencies in the fixed system and critical speeds as text for a report.
pub fn fixed_text(table: &FrequencyTable, fixed: &FixedTable) -> String {
    let unit = table.style.unit.word();
    let mut text = format!("Frequencies in the fixed system [{unit}]\n\n");
    let speeds: Vec<_> = (0..table.speeds.len()).collect();
    let blocks = speeds.len().div_ceil(SPEEDS_A_BLOCK).max(1);
    for block in speeds.chunks(speeds.len().div_ceil(blocks).max(1)) {
        text.push_str(&aligned(&rows(table, fixed, block)));
        text.push('\n');
    }
    text.push_str(&critical_text(table, "the fixed system", &fixed.critical));
    text
}

/// A heading of speeds and a row for each mode.
fn rows(table: &FrequencyTable, fixed: &FixedTable, block: &[usize]) -> Vec<Vec<String>> {
    let unit = table.style.unit;
    let shown = |speed: &usize| short_number(unit.speed(table.speeds[*speed]), 6);
    let mut heading = vec![format!("rotor speed [{}]", unit.speed_word())];
    heading.extend(block.iter().map(shown));
    let mut rows = vec![heading];
    for line in &fixed.lines {
        let frequency = |speed: &usize| line.points.get(*speed).copied().flatten();
        if block.iter().all(|speed| frequency(speed).is_none()) {
            continue;
        }
        let cell = |speed: &usize| {
            let value = |point: FixedPoint| unit.value(point.frequency(), table.speeds[*speed]);
            let value = frequency(speed).and_then(value);
            value.map_or_else(|| "-".to_owned(), |value| format!("{value:.3}"))
        };
        let mut row = vec![line.name.clone()];
        row.extend(block.iter().map(cell));
        rows.push(row);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::FrequencyUnit;
    use crate::output::{critical_csv, samples};

    // The lag waves of 2 Hz at 0, 60 and 180 rpm: 2 + n and 2 - n Hz.
    #[test]
    fn tables_have_a_row_per_mode_and_critical_speed() {
        let table = samples::waves();
        let fixed = FixedTable::new(&table, &[1]).unwrap();
        let text = fixed_text(&table, &fixed);
        let expected = "\
Frequencies in the fixed system [Hz]

rotor speed [rpm]      0     60    180
lag 1 progressive  2.000  3.000  5.000
lag 1 regressive   2.000  1.000  1.000

Critical speeds: frequency in the fixed system = n times the rotor speed

rotor speed [rpm]     Hz               n              mode
60.0000            1.000              1P  lag 1 regressive
120.0000           0.000  whirl reverses  lag 1 regressive

";
        assert_eq!(text, expected);
        let csv = campbell_csv(&table, &fixed);
        let expected = "\
rotor_speed [rpm],name,kind,frequency [Hz],frequency [1/rev],damping_ratio [-],direction
0,lag 1 progressive,lag,2,,0,forward
0,lag 1 regressive,lag,2,,0,backward
60,lag 1 progressive,lag,3,3,0,forward
60,lag 1 regressive,lag,1,1,0,backward
180,lag 1 progressive,lag,5,1.666666667,0,forward
180,lag 1 regressive,lag,1,0.3333333333,0,forward
";
        assert_eq!(csv, expected);
        let expected = "\
rotor_speed [rpm],harmonic [-],frequency [Hz],name
60,1,1,lag 1 regressive
120,0,0,lag 1 regressive
";
        assert_eq!(critical_csv(&table, &fixed.critical), expected);
    }

    // 60 rpm are 2 pi rad/s, 2 Hz are 120 rpm.
    #[test]
    fn tables_have_the_chosen_unit() {
        let mut table = samples::waves();
        let fixed = FixedTable::new(&table, &[1]).unwrap();
        table.style.unit = FrequencyUnit::RadiansPerSecond;
        let text = fixed_text(&table, &fixed);
        let expected = "\
Frequencies in the fixed system [rad/s]

rotor speed [rad/s]       0  6.28319  18.8496
lag 1 progressive    12.566   18.850   31.416
lag 1 regressive     12.566    6.283    6.283

Critical speeds: frequency in the fixed system = n times the rotor speed

rotor speed [rad/s]  rad/s               n              mode
6.2832               6.283              1P  lag 1 regressive
12.5664              0.000  whirl reverses  lag 1 regressive

";
        assert_eq!(text, expected);
        let csv = critical_csv(&table, &fixed.critical);
        let heading = "rotor_speed [rpm],rotor_speed [rad/s],harmonic [-],frequency [Hz],\
                       frequency [rad/s],name\n";
        assert!(csv.starts_with(heading), "{csv}");
        assert!(
            csv.contains("\n60,6.28319,1,1,6.28319,lag 1 regressive\n"),
            "{csv}"
        );
        table.style.unit = FrequencyUnit::PerRevolution;
        let text = fixed_text(&table, &fixed);
        assert!(
            text.contains("\nlag 1 progressive  -  3.000  1.667\n"),
            "{text}"
        );
    }
}
