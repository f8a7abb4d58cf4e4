//! Properties of the modes, as CSV: a row for each speed and mode.

use std::f64::consts::TAU;

use super::mode_units::Columns;
use super::rows::{csv_text, number};
use super::text::share;
use crate::case::Words;
use crate::input::short_number;
use crate::result::{Direction, FrequencyTable, ModeKind, ModePoint};

/// The heading, with the word for lag.
fn heading(columns: Columns, lag: &str) -> String {
    format!(
        "{},mode,name,kind,{},damping ratio [-],growth [1/s],flap [-],{lag} [-],torsion [-],\
         axial [-],assurance [-],whirl,whirl share [-],{},fixed direction,blade files",
        columns.speed_heading(),
        columns.frequency_heading(),
        columns.heading("fixed frequency")
    )
}

/// Rows for each speed and mode, numbered from one, ascending in frequency: name, kind at this
/// speed, frequency, damping ratio, growth (the real part of the eigenvalue), shares of the kinetic
/// energy, assurance relative to the same mode at the previous speed; for a rotor of equal blades
/// their pattern of motion, its share in the kinetic energy of the blades, and its frequency and
/// direction in the fixed system; the files of the blades with their fingerprints. Missing values are
/// empty.
pub fn mode_csv(table: &FrequencyTable) -> String {
    let words = table.style.words;
    let columns = Columns(table.style.unit);
    let mut rows = Vec::new();
    for (index, &speed) in table.speeds.iter().enumerate() {
        for (entry, (branch, point)) in table.at_speed(index).into_iter().enumerate() {
            let mut row = columns.speed(speed, number);
            row.push((entry + 1).to_string());
            row.push(branch.name.clone());
            row.push(branch.kind_at(point).word_in(words).to_owned());
            row.extend(columns.frequency(point.frequency, speed));
            row.push(short_number(point.damping_ratio, 6));
            row.push(short_number(point.growth, 6));
            row.extend(point.shares.map(share));
            let assurance = point.assurance.map(|mac| format!("{mac:.4}"));
            row.push(assurance.unwrap_or_default());
            row.extend(whirl(point, speed / TAU, (words, columns)));
            row.push(table.blade_files.join("; "));
            rows.push(row);
        }
    }
    csv_text(&heading(columns, ModeKind::Lag.word_in(words)), rows)
}

/// Pattern of motion of the blades, its share, and its frequency and direction in the fixed system
/// at a rotor speed \[Hz\].
fn whirl(point: &ModePoint, speed: f64, (words, columns): (Words, Columns)) -> Vec<String> {
    let Some(whirl) = &point.whirl else {
        let frequencies = columns.values(0.0, |_| String::new());
        return vec![String::new(); 3 + frequencies.len()];
    };
    let (frequency, direction) = whirl.in_fixed_system(point.frequency, speed);
    let mut cells = vec![whirl.word_in(words), share(whirl.share)];
    // Two blades that move against each other have two frequencies, which the Campbell diagram has.
    let is_double = whirl.is_double();
    let cell = |value: f64| {
        if is_double {
            String::new()
        } else {
            number(value)
        }
    };
    cells.extend(columns.values(frequency, cell));
    cells.push(direction.map_or("", Direction::word).to_owned());
    cells
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;
    use crate::result::Whirl;

    // A progressive mode of 12.5 Hz in a rotor at 10 Hz has 22.5 Hz in the fixed system.
    #[test]
    fn a_row_a_speed_and_mode() {
        let mut table = samples::small();
        table.blade_files = vec!["a.blade.json 0123".to_owned()];
        if let Some(point) = &mut table.branches[0].points[1] {
            point.damping_ratio = 0.02;
            point.growth = -1.5;
            point.whirl = Some(Whirl {
                harmonic: 1,
                blades: 3,
                share: 0.9,
            });
        }
        let expected = "\
rotor_speed [rpm],mode,name,kind,frequency [Hz],frequency [1/rev],damping_ratio [-],growth [1/s],flap [-],lag [-],torsion [-],axial [-],assurance [-],whirl,whirl_share [-],fixed_frequency [Hz],fixed_direction,blade_files
0,1,flap 1,flap,1.4,,0,0,0.9900,0.0100,0.0000,0.0000,,,,,,a.blade.json 0123
0,2,lag 1,lag,22.25,,0,0,0.0100,0.9800,0.0100,0.0000,,,,,,a.blade.json 0123
600,1,flap 1,flap,12.5,1.25,0.02,-1.5,0.9900,0.0100,0.0000,0.0000,0.9990,progressive,0.9000,22.5,forward,a.blade.json 0123
600,2,lag 1,lag,23.333,2.3333,0,0,0.0100,0.9800,0.0100,0.0000,0.9980,,,,,a.blade.json 0123
600,3,torsion 1,torsion,99.5,9.95,0,0,0.0000,0.0000,1.0000,0.0000,,,,,,a.blade.json 0123
";
        assert_eq!(mode_csv(&table), expected);
        // A collective mode has its own frequency in the fixed system, and no direction.
        if let Some(point) = &mut table.branches[0].points[1] {
            point.shares = [0.1, 0.0, 0.9, 0.0];
            point.whirl = Some(Whirl {
                harmonic: 0,
                blades: 3,
                share: 1.0,
            });
        }
        table.style.words = Words::Wind;
        let text = mode_csv(&table);
        assert!(text.contains("\n600,1,flap 1,torsion,12.5,"), "{text}");
        assert!(
            text.contains(",collective,1.0000,12.5,,a.blade.json 0123\n"),
            "{text}"
        );
        assert!(text.contains(",edge [-],"), "{text}");
    }
}
