//! The kinds of drives.

use std::sync::Arc;

use shared_geom::document::{ByHand, Item, Key, Table};
use shared_geom::expression::written;
use shared_geom::units::Dimension;

use super::keys::{
    AMPLITUDE, BAND, CYCLES, DEVIATION, DRIVE, DURATION, END, EXPRESSION, FACTORS, FREQUENCY, FROM,
    INTERVAL, KIND, MEAN, PHASE, RAMP_DURATION, SEED, SHAPE, START, SUMMANDS, TERMS, TIME, TO,
    UNIT, VALUE,
};
use super::measure::Measure;
use super::{DriveProblem, Find, columns, drive, formula};
use crate::model::{BandNoise, Doublet, Drive, Harmonic, Ramp, Step, SteppedNoise};

/// Whether the kind of a table is known; otherwise its keys are not checked.
pub(super) fn is_known(table: &Table<'_>) -> bool {
    if table.has(KIND[0]) {
        table.has_choice(&DRIVE, KIND[0])
    } else {
        table.has(&EXPRESSION)
    }
}

/// Reads a table with the key `kind`.
pub(super) fn read(table: &Table<'_>, measure: Measure, find: &Find<'_>) -> Option<Drive> {
    if matches!(measure, Measure::Declared(_)) && table.has(&UNIT) {
        table.note(&UNIT, &DriveProblem::InlineUnit);
    }
    // The key `expression` implies the kind.
    let kind = if !table.has(KIND[0]) && table.has(&EXPRESSION) {
        EXPRESSION.name()
    } else {
        table.choice(&DRIVE, KIND[0])?
    };
    match kind {
        "constant" => value(table, &VALUE, measure).map(Drive::Constant),
        "ramp" => ramp(table, measure),
        "step" => step(table, measure),
        "harmonic" => harmonic(table, measure),
        "doublet" => doublet(table, measure),
        "table" => columns::read(table, measure),
        "expression" => {
            let item = table.require_item(&EXPRESSION, "an expression of t")?;
            match item.text() {
                Some(text) => formula(&item, written(text).unwrap_or(text), measure),
                None => item.wrong("an expression of t, as in \"2*sin(t)\""),
            }
        }
        "random" => random(table, measure),
        kind => combined(table, kind == "sum", measure, find),
    }
}

/// A required number in the measure of the drive.
fn value(table: &Table<'_>, key: &Key<ByHand>, measure: Measure) -> Option<f64> {
    measure.number(&table.require_item(key, &measure.words())?)
}

fn value_or_zero(table: &Table<'_>, key: &Key<ByHand>, measure: Measure) -> Option<f64> {
    match table.item(key) {
        Some(item) => measure.number(&item),
        None => Some(0.0),
    }
}

fn ramp(table: &Table<'_>, measure: Measure) -> Option<Drive> {
    let from = value_or_zero(table, &FROM, measure);
    let to = value(table, &TO, measure);
    let start = table.get(&START);
    let keys = [END.name(), RAMP_DURATION.name()];
    let end = match keys.map(|key| table.has(key)) {
        [true, false] => table.get(&END).flatten(),
        [false, true] => {
            let duration = table.get(&RAMP_DURATION).flatten();
            duration
                .zip(start)
                .map(|(duration, start)| start + duration)
        }
        [both, _] => {
            let found = if both { "both" } else { "none" };
            let drive = table.title().to_owned();
            table.note("", &DriveProblem::OneOf { drive, keys, found });
            None
        }
    };
    let smooth = table.get(&SHAPE).map(|word| word == 1);
    let (start, end) = (start?, end?);
    if end <= start {
        table.note("", &DriveProblem::Backward { start, end });
        return None;
    }
    Some(Drive::Ramp(Ramp {
        from: from?,
        to: to?,
        start,
        end,
        smooth: smooth?,
    }))
}

fn step(table: &Table<'_>, measure: Measure) -> Option<Drive> {
    let from = value_or_zero(table, &FROM, measure);
    let to = value(table, &TO, measure);
    let time = table.get(&TIME);
    Some(Drive::Step(Step {
        from: from?,
        to: to?,
        time: time?,
    }))
}

fn harmonic(table: &Table<'_>, measure: Measure) -> Option<Drive> {
    let mean = value_or_zero(table, &MEAN, measure);
    let amplitude = value(table, &AMPLITUDE, measure);
    let frequency = table.get(&FREQUENCY);
    let phase = table.get(&PHASE);
    let start = table.get(&START);
    let cycles = table.get(&CYCLES);
    Some(Drive::Harmonic(Harmonic {
        mean: mean?,
        amplitude: amplitude?,
        frequency: frequency?,
        phase: phase?,
        start: start?,
        cycles: cycles?,
    }))
}

fn doublet(table: &Table<'_>, measure: Measure) -> Option<Drive> {
    let amplitude = value(table, &AMPLITUDE, measure);
    let start = table.get(&START);
    let duration = table.get(&DURATION);
    Some(Drive::Doublet(Doublet {
        amplitude: amplitude?,
        start: start?,
        duration: duration?,
    }))
}

fn random(table: &Table<'_>, measure: Measure) -> Option<Drive> {
    // All keys are read before the function returns, so that each problem is noted.
    let mean = value_or_zero(table, &MEAN, measure);
    let deviation = value(table, &DEVIATION, measure).filter(|deviation| {
        let is_right = *deviation >= 0.0;
        if !is_right {
            table.wrong(&DEVIATION, "a number that is zero or more");
        }
        is_right
    });
    let seed = table.get(&SEED).map(|seed| seed as u64);
    let keys = [BAND.name(), INTERVAL.name()];
    match keys.map(|key| table.has(key)) {
        [false, true] => {
            let interval = table.get(&INTERVAL);
            Some(Drive::Noise(SteppedNoise {
                mean: mean?,
                deviation: deviation?,
                interval: interval?,
                seed: seed?,
            }))
        }
        [true, false] => {
            let terms = table.get(&TERMS);
            let band = band(table);
            let noise = BandNoise::new([mean?, deviation?], band?, terms?, seed?);
            Some(Drive::Band(Arc::new(noise)))
        }
        [both, _] => {
            let found = if both { "both" } else { "none" };
            // Terms may belong to a missing band.
            table.item(&TERMS);
            let drive = table.title().to_owned();
            table.note("", &DriveProblem::OneOf { drive, keys, found });
            None
        }
    }
}

/// The least and the largest frequency of a random drive \[Hz\].
fn band(table: &Table<'_>) -> Option<[f64; 2]> {
    let band = table.get(&BAND)?;
    let [low, high] = band;
    if low < 0.0 || high <= low {
        table.note(&BAND, &DriveProblem::Band { band });
        return None;
    }
    Some(band)
}

/// A sum of drives, or a product of a drive and pure numbers.
fn combined(table: &Table<'_>, is_sum: bool, measure: Measure, find: &Find<'_>) -> Option<Drive> {
    let key = if is_sum {
        SUMMANDS.name()
    } else {
        FACTORS.name()
    };
    let items = table.require_item(key, "a list of drives")?;
    let Some(items) = items.list() else {
        return items.wrong("a list of drives");
    };
    if items.is_empty() {
        table.note(key, &DriveProblem::Nothing { key });
        return None;
    }
    let part = |(i, item): (usize, &Item<'_>)| {
        if is_sum || i == 0 {
            drive(item, measure, find)
        } else {
            drive(item, Measure::Declared(Dimension::NUMBER), find)
        }
    };
    // All parts are read, so that each problem is noted.
    let parts: Vec<_> = items.iter().enumerate().map(part).collect();
    let parts: Option<Vec<_>> = parts.into_iter().collect();
    Some(if is_sum {
        Drive::Sum(parts?.into())
    } else {
        Drive::Product(parts?.into())
    })
}
