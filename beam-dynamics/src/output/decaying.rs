//! Motions that decay without oscillation: text and CSV.

use super::mode_units::Columns;
use super::rows::{csv_text, number};
use super::text::aligned;
use crate::input::short_number;
use crate::result::FrequencyTable;

/// One row per speed and decaying motion of `table`: time constant, the eigenvalue and the kind of
/// the motion, the slowest first.
pub fn decaying_csv(table: &FrequencyTable) -> String {
    let columns = Columns(table.style.unit);
    let mut rows = Vec::new();
    for (speed, motions) in table.speeds.iter().zip(&table.decaying) {
        for motion in motions {
            let mut row = columns.speed(*speed, number);
            row.push(number(motion.time_constant()));
            row.push(number(motion.growth));
            row.push(motion.kind.word_in(table.style.words).to_owned());
            rows.push(row);
        }
    }
    let heading = format!(
        "{},time constant [s],growth [1/s],kind",
        columns.speed_heading()
    );
    csv_text(&heading, rows)
}

/// The same as text for a report; empty without any.
pub(super) fn decaying_text(table: &FrequencyTable) -> String {
    let unit = table.style.unit;
    let speed = format!("rotor speed [{}]", unit.speed_word());
    let heading = [&speed, "time constant [s]", "1/s", "kind"].map(str::to_owned);
    let mut rows = vec![heading.to_vec()];
    for (speed, motions) in table.speeds.iter().zip(&table.decaying) {
        let row = |motion: &crate::result::DecayingMotion| {
            vec![
                short_number(unit.speed(*speed), 6),
                short_number(motion.time_constant(), 5),
                short_number(motion.growth, 5),
                motion.kind.word_in(table.style.words).to_owned(),
            ]
        };
        rows.extend(motions.iter().map(row));
    }
    if rows.len() < 2 {
        return String::new();
    }
    let table = aligned(&rows);
    format!("Motions that decay without oscillation\n\n{table}\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;
    use crate::result::{DecayingMotion, ModeKind};

    #[test]
    fn decaying_motions_have_their_time_constant() {
        let mut table = samples::small();
        assert_eq!(decaying_text(&table), "");
        let [slow, fast] = [-0.5, -8.0].map(|growth| DecayingMotion {
            growth,
            kind: ModeKind::Lag,
        });
        table.decaying = vec![vec![slow, fast], vec![slow]];
        let expected = "\
Motions that decay without oscillation

rotor speed [rpm]  time constant [s]   1/s  kind
0                                  2  -0.5   lag
0                              0.125    -8   lag
600                                2  -0.5   lag

";
        assert_eq!(decaying_text(&table), expected);
        let expected = "\
rotor_speed [rpm],time_constant [s],growth [1/s],kind
0,2,-0.5,lag
0,0.125,-8,lag
600,2,-0.5,lag
";
        assert_eq!(decaying_csv(&table), expected);
    }
}
