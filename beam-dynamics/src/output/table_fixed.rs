//! Modes in the fixed system and critical speeds: text and CSV.

use super::rows::{csv_text, number};
use super::text::{RPM, aligned, cleared};
use crate::input::short_number;
use crate::result::{CriticalSpeed, Direction, FixedTable, FrequencyTable};

/// Speeds side by side: to fill the width of a page.
const SPEEDS_A_BLOCK: usize = 6;
/// Critical speeds that are printed; the table for programs has all.
const MOST: usize = 40;
const CAMPBELL: &str = "rotor speed [rpm],name,kind,frequency [Hz],frequency [1/rev],\
    damping ratio [-],direction";
const CRITICAL: &str = "rotor speed [rpm],harmonic [-],frequency [Hz],name";

/// One row per speed and mode of `fixed`, the modes of `table`: frequency in the fixed system, also
/// per revolution, damping ratio relative to it, and direction around the rotor, empty for
/// motion without one.
pub fn campbell_csv(table: &FrequencyTable, fixed: &FixedTable) -> String {
    let mut rows = Vec::new();
    for (k, &speed) in table.speeds.iter().enumerate() {
        for line in &fixed.lines {
            let Some(point) = line.points.get(k).copied().flatten() else {
                continue;
            };
            let per_rev = super::text::per_rev(point.frequency(), speed);
            rows.push(vec![
                number(speed * RPM),
                line.name.clone(),
                point.kind.word_in(table.style.words).to_owned(),
                number(point.frequency()),
                per_rev.map_or_else(String::new, number),
                short_number(cleared(point.damping_ratio), 6),
                point.direction.map_or("", Direction::word).to_owned(),
            ]);
        }
    }
    csv_text(CAMPBELL, rows)
}

/// One row per critical speed, ascending; the harmonic 0 is a frequency that passes through zero.
pub fn critical_csv(fixed: &FixedTable) -> String {
    let row = |critical: &CriticalSpeed| {
        vec![
            short_number(critical.speed * RPM, 6),
            critical.order.to_string(),
            short_number(critical.frequency, 6),
            critical.name.clone(),
        ]
    };
    csv_text(CRITICAL, fixed.critical.iter().map(row))
}

/// Frequencies in the fixed system and critical speeds as text for a report.
pub fn fixed_text(table: &FrequencyTable, fixed: &FixedTable) -> String {
    let mut text = "Frequencies in the fixed system [Hz]\n\n".to_owned();
    let speeds: Vec<_> = (0..table.speeds.len()).collect();
    let blocks = speeds.len().div_ceil(SPEEDS_A_BLOCK).max(1);
    for block in speeds.chunks(speeds.len().div_ceil(blocks).max(1)) {
        text.push_str(&aligned(&rows(table, fixed, block)));
        text.push('\n');
    }
    text.push_str(&critical_text(fixed));
    text
}

/// A heading of speeds and a row for each mode.
fn rows(table: &FrequencyTable, fixed: &FixedTable, block: &[usize]) -> Vec<Vec<String>> {
    let rpm = |speed: &usize| short_number(table.speeds[*speed] * RPM, 6);
    let mut heading = vec!["rotor speed [rpm]".to_owned()];
    heading.extend(block.iter().map(rpm));
    let mut rows = vec![heading];
    for line in &fixed.lines {
        let frequency = |speed: &usize| line.points.get(*speed).copied().flatten();
        if block.iter().all(|speed| frequency(speed).is_none()) {
            continue;
        }
        let cell = |speed: &usize| {
            let point = frequency(speed);
            point.map_or_else(|| "-".to_owned(), |p| format!("{:.3}", p.frequency()))
        };
        let mut row = vec![line.name.clone()];
        row.extend(block.iter().map(cell));
        rows.push(row);
    }
    rows
}

/// The critical speeds as text; empty without any.
fn critical_text(fixed: &FixedTable) -> String {
    if fixed.critical.is_empty() {
        return String::new();
    }
    let heading = ["rotor speed [rpm]", "Hz", "n", "mode"].map(str::to_owned);
    let row = |critical: &CriticalSpeed| {
        let order = match critical.order {
            0 => "whirl reverses".to_owned(),
            order => format!("{order}P"),
        };
        vec![
            format!("{:.4}", critical.speed * RPM),
            format!("{:.3}", critical.frequency),
            order,
            critical.name.clone(),
        ]
    };
    let shown = fixed.critical.iter().take(MOST).map(row);
    let lines: Vec<_> = std::iter::once(heading.to_vec()).chain(shown).collect();
    let mut text = format!(
        "Critical speeds: frequency in the fixed system = n times the rotor speed\n\n{}\n",
        aligned(&lines)
    );
    let more = fixed.critical.len().saturating_sub(MOST);
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
rotor speed [rpm],name,kind,frequency [Hz],frequency [1/rev],damping ratio [-],direction
0,lag 1 progressive,lag,2,,0,forward
0,lag 1 regressive,lag,2,,0,backward
60,lag 1 progressive,lag,3,3,0,forward
60,lag 1 regressive,lag,1,1,0,backward
180,lag 1 progressive,lag,5,1.666666667,0,forward
180,lag 1 regressive,lag,1,0.3333333333,0,forward
";
        assert_eq!(csv, expected);
        let expected = "\
rotor speed [rpm],harmonic [-],frequency [Hz],name
60,1,1,lag 1 regressive
120,0,0,lag 1 regressive
";
        assert_eq!(critical_csv(&fixed), expected);
    }
}
