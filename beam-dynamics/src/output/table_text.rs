//! The frequency table as text for a report: one row per mode, columns of speeds.

use super::table_changes::changes;
use super::text::{DAMPED, aligned, per_rev};
use crate::case::Words;
use crate::input::short_number;
use crate::result::{FrequencyTable, ModeKind};

/// Speeds side by side, without and with damping: to fill the width of a page. Blocks are of equal
/// width.
const SPEEDS_A_BLOCK: [usize; 2] = [4, 3];

/// Meaning of the numbers and names of the tables.
pub const CONVENTION: &str = "\
Convention
  Hz    frequency of small motions about the steady equilibrium, in the turning axes
  /rev  frequency over rotor speed; undefined at rest
  mode  named at its first speed, or at name_at, by the motion with most of the kinetic
        energy, numbered from the lowest, and followed over the speeds by its shape
          flap     out of the plane of rotation
          lag      in the plane of rotation
          torsion  about the axis of the beam
          axial    along the span
          coupled  none of these has most of the energy
  -     no value, or not among the modes computed at this speed
";

/// The kind of modes of shafts and hubs.
const LATERAL: &str = "\
\x20 lateral: across the axis of rotation, of nodes on the axis that belong to no blade; their
        axial motion is along the axis, and torsion about it
";

/// The kinds of modes of towers.
const TOWER: &str = "\
\x20 tower fore-aft, tower side-side: of tower, nacelle and hub, along the wind and across it
";

/// The kind of modes of parts that nothing holds.
const RIGID: &str = "\
\x20 rigid: motion without strain of parts that nothing holds, of frequency zero
";

/// Further columns of the tables of damped modes.
const DAMPING: &str = "\
\x20 %     damping ratio: part of the critical damping in per cent, negative if the motion
        grows
";

/// Further parts of the names of modes of a rotor.
const WHIRL: &str = "\
\x20 collective, progressive, regressive, differential: relative motion of the blades,
        in the turning axes: all in phase, a wave with the rotation, a wave against the
        rotation, or neighbors in antiphase; x2 is a wave twice around the rotor
";

/// Further parts of the names of modes of a shaft.
const SHAFT_WHIRL: &str = "\
\x20 progressive, regressive: whirl with the rotation or against it, in the turning axes at the
        speed of the name, which is kept where the frequency passes through zero
";

/// Meaning of the numbers and names of `table`, without the kinds of blades for a shaft.
pub fn convention(table: &FrequencyTable) -> String {
    let text = of_all_kinds(table);
    if !(has_whirls(table) && table.is_shaft()) {
        return text;
    }
    let is_of_blades = |line: &&str| {
        let word = line.split_whitespace().next();
        word.is_some_and(|word| ["flap", "lag", "edge"].contains(&word))
    };
    let lines = text.split_inclusive('\n');
    lines.filter(|line| !is_of_blades(line)).collect()
}

/// Meaning of the numbers and names of `table`, with the kinds of blades.
fn of_all_kinds(table: &FrequencyTable) -> String {
    let damping = if is_damped(table) { DAMPING } else { "" };
    let whirl = match has_whirls(table) {
        true if table.is_shaft() => SHAFT_WHIRL,
        true => WHIRL,
        false => "",
    };
    let of_kind = |kind, text| {
        if table.branches.iter().any(|branch| branch.kind == kind) {
            text
        } else {
            ""
        }
    };
    let lateral = of_kind(ModeKind::Lateral, LATERAL);
    let of_tower = [ModeKind::ForeAft, ModeKind::SideSide].map(|kind| of_kind(kind, TOWER));
    let tower = if of_tower[0].is_empty() {
        of_tower[1]
    } else {
        TOWER
    };
    let rigid = of_kind(ModeKind::Rigid, RIGID);
    let text = format!("{CONVENTION}{lateral}{tower}{rigid}{damping}{whirl}");
    let unit = table.style.unit.of_column().word();
    let text = text.replace("  Hz    ", &format!("  {unit:<6}"));
    match table.style.words {
        Words::Rotor => text,
        Words::Wind => text
            .replace("  lag    ", "  edge   ")
            .replace("progressive", "forward")
            .replace("regressive", "backward"),
    }
}

/// Whether any mode has a pattern around the axis, in its name or at a speed.
fn has_whirls(table: &FrequencyTable) -> bool {
    let mut points = table
        .branches
        .iter()
        .flat_map(|b| b.points.iter().flatten());
    let mut branches = table.branches.iter();
    branches.any(|branch| branch.harmonic.is_some())
        || points.any(|point| {
            point
                .whirl
                .is_some_and(|w| w.is_pure() && w.has_direction())
        })
}

/// Whether any mode is damped or grows.
fn is_damped(table: &FrequencyTable) -> bool {
    let mut points = table
        .branches
        .iter()
        .flat_map(|b| b.points.iter().flatten());
    points.any(|point| point.damping_ratio.abs() > DAMPED)
}

/// The table in blocks of speeds, and remarks; see [`CONVENTION`].
pub fn frequency_text(table: &FrequencyTable) -> String {
    let mut text = format!("{}\n\nFrequencies over rotor speed\n\n", table.name);
    if table.speeds.is_empty() {
        text.push_str("  no rotor speed was reached\n\n");
    }
    let speeds: Vec<_> = (0..table.speeds.len()).collect();
    let blocks = speeds
        .len()
        .div_ceil(SPEEDS_A_BLOCK[usize::from(is_damped(table))])
        .max(1);
    for block in speeds.chunks(speeds.len().div_ceil(blocks).max(1)) {
        text.push_str(&aligned(&rows(table, block)));
        text.push('\n');
    }
    text.push_str(&remarks(table));
    text
}

/// Two lines of heading and a row for each mode that has a point in the block.
fn rows(table: &FrequencyTable, block: &[usize]) -> Vec<Vec<String>> {
    let damped = is_damped(table);
    let unit = table.style.unit;
    let column = unit.of_column();
    let mut speeds = vec![format!("rotor speed [{}]", unit.speed_word())];
    let mut units = vec!["mode".to_owned()];
    for &speed in block {
        let shown = short_number(unit.speed(table.speeds[speed]), 6);
        speeds.extend([String::new(), shown, String::new()]);
        units.extend([String::new(), column.word().to_owned(), "/rev".to_owned()]);
        if damped {
            speeds.push(String::new());
            units.push("%".to_owned());
        }
    }
    let mut rows = vec![speeds, units];
    for branch in &table.branches {
        let mut row = vec![branch.name.clone()];
        let mut has_point = false;
        for &speed in block {
            let point = branch.points.get(speed).and_then(Option::as_ref);
            let frequency = point.map(|point| point.frequency);
            let over_speed = frequency.and_then(|f| per_rev(f, table.speeds[speed]));
            let shown = frequency.and_then(|f| column.value(f, table.speeds[speed]));
            row.extend([String::new(), decimal(shown), decimal(over_speed)]);
            if damped {
                let per_cent = point.map(|point| 100.0 * point.damping_ratio);
                // Adding zero removes the sign of a negative zero.
                row.push(decimal(per_cent.map(|x| (1e3 * x).round() / 1e3 + 0.0)));
            }
            has_point |= point.is_some();
        }
        if has_point {
            rows.push(row);
        }
    }
    rows
}

fn decimal(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.3}"))
}

/// Remarks, and the convergence of the equilibria.
fn remarks(table: &FrequencyTable) -> String {
    let mut text = String::new();
    for change in changes(table) {
        text.push_str(&format!("  {change}\n"));
    }
    for remark in &table.remarks {
        text.push_str(&format!("  {remark}\n"));
    }
    // Without loads at rest a relative residual is meaningless.
    let turning = table
        .equilibria
        .iter()
        .zip(&table.speeds)
        .filter(|(_, speed)| **speed > 0.0);
    let (mut iterations, mut residual) = (0, 0.0_f64);
    for (report, _) in turning {
        iterations = iterations.max(report.iterations);
        residual = residual.max(report.residual);
    }
    if iterations > 0 {
        text.push_str(&format!(
            "  steady equilibrium: at most {iterations} Newton iterations a speed, relative \
             residual at most {residual:.1e}\n"
        ));
    }
    if text.is_empty() {
        text
    } else {
        format!("Remarks\n{text}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::FrequencyUnit;
    use crate::output::samples;
    use crate::result::Whirl;

    #[test]
    fn modes_are_rows_and_speeds_are_columns() {
        let text = frequency_text(&samples::small());
        let expected = "\
two speeds

Frequencies over rotor speed

rotor speed [rpm]         0             600
mode                     Hz  /rev        Hz   /rev
flap 1                1.400     -    12.500  1.250
lag 1                22.250     -    23.333  2.333
torsion 1                 -     -    99.500  9.950

Remarks
  made up
  steady equilibrium: at most 4 Newton iterations a speed, relative residual at most 2.0e-13
";
        assert_eq!(text, expected);
        assert!(CONVENTION.lines().all(|line| line.len() <= 96));
    }

    #[test]
    fn damping_has_a_column_where_there_is_any() {
        let mut table = samples::small();
        if let Some(point) = &mut table.branches[0].points[1] {
            point.damping_ratio = 0.0123;
        }
        let text = frequency_text(&table);
        let expected = "\
rotor speed [rpm]         0                    600
mode                     Hz  /rev      %        Hz   /rev      %
flap 1                1.400     -  0.000    12.500  1.250  1.230
lag 1                22.250     -  0.000    23.333  2.333  0.000
torsion 1                 -     -      -    99.500  9.950  0.000
";
        assert!(text.contains(expected), "{text}");
        assert!(convention(&table).contains("\n  %     damping ratio"));
        assert_eq!(convention(&samples::small()), CONVENTION);
        table.branches[0].harmonic = Some(0);
        assert!(convention(&table).contains("\n  collective, progressive"));
        assert!(convention(&table).contains("\n          lag  "));
        let points = table.branches.iter_mut().flat_map(|b| b.points.iter_mut());
        for point in points.flatten() {
            point.whirl = Some(Whirl {
                harmonic: 1,
                blades: 0,
                share: 1.0,
            });
        }
        // at rest its modes have no direction, and its names no pattern
        table.branches[0].harmonic = None;
        let of_shaft = convention(&table);
        assert!(of_shaft.contains("\n  progressive, regressive: whirl"));
        assert!(
            !of_shaft.contains("flap") && !of_shaft.contains("lag"),
            "{of_shaft}"
        );
        assert!(convention(&table).lines().all(|line| line.len() <= 96));
    }

    // 600 rpm are 20 pi rad/s, 12.5 Hz are 25 pi rad/s.
    #[test]
    fn frequencies_and_speeds_have_the_chosen_unit() {
        let mut table = samples::small();
        table.style.unit = FrequencyUnit::RadiansPerSecond;
        let text = frequency_text(&table);
        let expected = "\
rotor speed [rad/s]          0          62.8319
mode                     rad/s  /rev      rad/s   /rev
flap 1                   8.796     -     78.540  1.250
";
        assert!(text.contains(expected), "{text}");
        assert!(convention(&table).contains("\n  rad/s frequency of small motions"));
        table.style.unit = FrequencyUnit::PerRevolution;
        assert_eq!(convention(&table), CONVENTION);
    }

    #[test]
    fn many_speeds_come_in_blocks() {
        let text = frequency_text(&samples::swept_tip(9));
        assert_eq!(text.matches("rotor speed [rpm]").count(), 3, "{text}");
        assert!(text.lines().all(|line| line.len() <= 96), "{text}");
    }

    #[test]
    fn nothing_reached_is_said() {
        let mut table = samples::small();
        table.speeds.clear();
        table.equilibria.clear();
        assert!(frequency_text(&table).contains("no rotor speed was reached"));
    }
}
