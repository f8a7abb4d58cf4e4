//! Properties of the modes, as CSV: a row for each speed and mode.

use std::f64::consts::TAU;

use super::rows::{csv_text, number};
use super::text::{RPM, per_rev};
use crate::input::short_number;
use crate::result::{Direction, FrequencyTable, ModePoint};

const HEADING: &str = "speed_rpm,mode,name,kind,frequency_hz,per_rev,damping_ratio,growth_per_s,\
    flap,lag,torsion,axial,assurance,whirl,whirl_share,fixed_frequency_hz,fixed_direction";

/// Rows for each speed and mode, numbered from one, ascending in frequency: name, kind at the first
/// speed, frequency, damping ratio, growth (the real part of the eigenvalue), shares of the kinetic
/// energy, assurance relative to the same mode at the previous speed; for a rotor of equal blades
/// their pattern of motion, its share in the kinetic energy of the blades, and its frequency and
/// direction in the fixed system. Missing values are empty.
pub fn mode_csv(table: &FrequencyTable) -> String {
    let mut rows = Vec::new();
    for (index, &speed) in table.speeds.iter().enumerate() {
        for (place, (branch, point)) in table.at_speed(index).into_iter().enumerate() {
            let mut row = vec![number(speed * RPM), (place + 1).to_string()];
            row.extend([branch.name.clone(), branch.kind.word().to_owned()]);
            row.push(number(point.frequency));
            row.push(per_rev(point.frequency, speed).map_or_else(String::new, number));
            row.push(short_number(point.damping_ratio, 6));
            row.push(short_number(point.growth, 6));
            row.extend(point.shares.map(|share| format!("{share:.4}")));
            let assurance = point.assurance.map(|mac| format!("{mac:.4}"));
            row.push(assurance.unwrap_or_default());
            row.extend(whirl(point, speed / TAU));
            rows.push(row);
        }
    }
    csv_text(HEADING, rows)
}

/// Pattern of motion of the blades, its share, and its frequency and direction in the fixed system
/// at a rotor speed \[Hz\].
fn whirl(point: &ModePoint, speed: f64) -> [String; 4] {
    let Some(whirl) = &point.whirl else {
        return Default::default();
    };
    let fixed = whirl.in_fixed_system(point.frequency, speed);
    let direction = fixed.map(|(_, direction)| match direction {
        Direction::Forward => "forward".to_owned(),
        Direction::Backward => "backward".to_owned(),
    });
    [
        whirl.word(),
        format!("{:.4}", whirl.share),
        fixed.map_or_else(String::new, |(frequency, _)| number(frequency)),
        direction.unwrap_or_default(),
    ]
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
speed_rpm,mode,name,kind,frequency_hz,per_rev,damping_ratio,growth_per_s,flap,lag,torsion,axial,assurance,whirl,whirl_share,fixed_frequency_hz,fixed_direction
0,1,flap 1,flap,1.4,,0,0,0.9900,0.0100,0.0000,0.0000,,,,,
0,2,lag 1,lag,22.25,,1e-15,0,0.0100,0.9800,0.0100,0.0000,,,,,
600,1,flap 1,flap,12.5,1.25,0.02,-1.5,0.9900,0.0100,0.0000,0.0000,0.9990,progressive,0.9000,22.5,forward
600,2,lag 1,lag,23.333,2.3333,0,0,0.0100,0.9800,0.0100,0.0000,0.9980,,,,
600,3,torsion 1,torsion,99.5,9.95,0,0,0.0000,0.0000,1.0000,0.0000,,,,,
";
        assert_eq!(mode_csv(&table), expected);
    }
}
