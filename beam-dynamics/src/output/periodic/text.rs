//! The report of a periodic motion.

use std::f64::consts::TAU;

use crate::input::short_number;
use crate::result::{FloquetMode, FloquetTable, PeriodicResult};

/// Passes that are listed at the start and at the end of a long march.
const SHOWN: usize = 12;

/// The conventions of the report.
pub const PERIODIC_CONVENTION: &str = "\
Changes: of the state in a period, positions relative to the size of the model, rotations in rad,
momenta relative to a motion by the size of the model in a period, scalars relative to their sizes.
Multipliers: factor of a small motion in a period; of a pair the one with positive frequency.
Frequencies: on the branch of the largest motion in the fixed frame, blades in multiblade
coordinates, or nearest to the given ones; others with more than 5 % of the energy after it.
";

/// Passes, controls, multipliers and remarks.
pub fn periodic_text(result: &PeriodicResult) -> String {
    let stages = match result.stages {
        2 => "two",
        _ => "three",
    };
    let mut text = format!(
        "{}: period {} s in {} steps of Radau IIA with {stages} stages\n",
        result.name,
        short_number(result.period, 9),
        result.steps
    );
    for remark in &result.remarks {
        text.push_str(&format!("  remark: {remark}\n"));
    }
    text.push_str(&passes(result));
    let ending = if result.is_periodic {
        "the motion repeats"
    } else {
        "the motion does not repeat"
    };
    text.push_str(&format!(
        "{ending}; {} periods were integrated\n",
        result.periods
    ));
    if !result.controls.is_empty() {
        text.push_str("\nControls\n");
    }
    for (name, value) in &result.controls {
        text.push_str(&format!("  {name} = {}\n", short_number(*value, 10)));
    }
    if let Some(table) = &result.floquet {
        text.push_str(&multipliers(table, result.period));
    }
    text
}

fn passes(result: &PeriodicResult) -> String {
    let count = result.passes.len();
    let mut text = "\n  no      change  products  applied  largest change\n".to_owned();
    for (index, pass) in result.passes.iter().enumerate() {
        if count > 2 * SHOWN && (SHOWN..count - SHOWN).contains(&index) {
            if index == SHOWN {
                text.push_str("  ...\n");
            }
            continue;
        }
        text.push_str(&format!(
            "{:4}  {:10.3e}  {:8}  {:7.2}  {}\n",
            index, pass.residual, pass.products, pass.part, pass.worst
        ));
    }
    text
}

fn multipliers(table: &FloquetTable, period: f64) -> String {
    let found = match table.states {
        Some(states) => format!("of a complete space of {states} directions"),
        None => "of a part of the space of all states".to_owned(),
    };
    let mut text = format!(
        "\nMultipliers {found}, {} products\n  no     size    growth [1/s]  frequency [Hz]  \
         [1/period]  damping [%]      error  residual  stability    share  motion\n",
        table.products
    );
    for (index, mode) in table.modes.iter().enumerate() {
        text.push_str(&row(index, mode, period));
    }
    let counts = |word: &str| {
        let own = table
            .modes
            .iter()
            .filter(|mode| mode.stability().word() == word);
        own.count()
    };
    let unstable = counts("unstable");
    let verdict = match unstable {
        0 => "no unstable motion among them".to_owned(),
        1 => "1 unstable motion".to_owned(),
        many => format!("{many} unstable motions"),
    };
    text + &format!("{verdict}\n")
}

fn row(index: usize, mode: &FloquetMode, period: f64) -> String {
    let hertz = mode.frequency() / TAU;
    let damping = mode
        .damping_ratio()
        .map(|ratio| format!("{:.4}", 100.0 * ratio));
    let error = mode.error.map(|error| format!("{error:.1e}"));
    let mut row = format!(
        "{:4}  {:7.5}  {:14.7e}  {:14.6}  {:10.5}  {:>11}  {:>9}  {:8.0e}  {:11}  {:5.3}  {}",
        index + 1,
        mode.multiplier.norm(),
        mode.exponent.re,
        hertz,
        hertz * period,
        damping.unwrap_or_default(),
        error.unwrap_or_default(),
        mode.residual,
        mode.stability().word(),
        mode.share,
        mode.label()
    );
    for other in &mode.others {
        row.push_str(&format!(
            "; {} Hz {:.2}",
            short_number(other.frequency / TAU, 5),
            other.share
        ));
    }
    row.push('\n');
    row
}
