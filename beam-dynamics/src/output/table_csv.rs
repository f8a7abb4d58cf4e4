//! The frequency table as CSV: a row for each speed and mode.

use super::mode_units::Columns;
use super::rows::{csv_text, number};
use super::text::share;
use crate::input::short_number;
use crate::result::{FrequencyTable, ModeKind};

/// Rows with the rotor speed, number and name of the mode, frequency, also per revolution and in the
/// chosen unit, damping ratio, four shares and the assurance, below a heading `name [unit]`.
///
/// Modes are numbered at each speed from one, ascending in frequency. The four shares are shares of
/// the kinetic energy, and the assurance is relative to the same mode at the previous speed.
/// Missing values are empty.
pub fn frequency_csv(table: &FrequencyTable) -> String {
    let lag = ModeKind::Lag.word_in(table.style.words);
    let columns = Columns(table.style.unit);
    let heading = format!(
        "{},mode,name,{},damping ratio [-],flap [-],{lag} [-],torsion [-],axial [-],\
         assurance [-]",
        columns.speed_heading(),
        columns.frequency_heading()
    );
    let mut rows = Vec::new();
    for (index, &speed) in table.speeds.iter().enumerate() {
        for (entry, (branch, point)) in table.at_speed(index).into_iter().enumerate() {
            let mut cells = columns.speed(speed, number);
            cells.push((entry + 1).to_string());
            cells.push(branch.name.clone());
            cells.extend(columns.frequency(point.frequency, speed));
            cells.push(short_number(point.damping_ratio, 6));
            cells.extend(point.shares.map(share));
            cells.push(
                point
                    .assurance
                    .map_or_else(String::new, |mac| format!("{mac:.4}")),
            );
            rows.push(cells);
        }
    }
    csv_text(&heading, rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn a_row_a_speed_and_mode() {
        let text = frequency_csv(&samples::small());
        let expected = "\
rotor_speed [rpm],mode,name,frequency [Hz],frequency [1/rev],damping_ratio [-],flap [-],lag [-],torsion [-],axial [-],assurance [-]
0,1,flap 1,1.4,,0,0.9900,0.0100,0.0000,0.0000,
0,2,lag 1,22.25,,0,0.0100,0.9800,0.0100,0.0000,
600,1,flap 1,12.5,1.25,0,0.9900,0.0100,0.0000,0.0000,0.9990
600,2,lag 1,23.333,2.3333,0,0.0100,0.9800,0.0100,0.0000,0.9980
600,3,torsion 1,99.5,9.95,0,0.0000,0.0000,1.0000,0.0000,
";
        assert_eq!(text, expected);
    }
}
