//! The kinds of drives.

use std::sync::Arc;

use shared_geom::document::{Item, Table};
use shared_geom::expression::written;
use shared_geom::units::Dimension;

use super::keys::{CYCLES, DURATION, FREQUENCY, INTERVAL, PHASE, SEED, SHAPE, START, TERMS, TIME};
use super::measure::Measure;
use super::{DriveProblem, Find, columns, drive, formula};
use crate::model::{BandNoise, Doublet, Drive, Harmonic, Ramp, Step, SteppedNoise};

const KINDS: [&str; 10] = [
    "constant",
    "ramp",
    "step",
    "harmonic",
    "doublet",
    "table",
    "expression",
    "sum",
    "product",
    "random",
];

/// Whether the kind of a table is known; otherwise its keys are not checked.
pub(super) fn is_known(table: &Table<'_>) -> bool {
    let is_one = |kind: String| KINDS.contains(&&*kind);
    match table.has("kind") {
        true => table.is_text("kind") && table.text("kind").is_some_and(is_one),
        false => table.has("expression"),
    }
}

/// Reads a table with the key `kind`.
pub(super) fn read(table: &Table<'_>, measure: Measure, find: &Find<'_>) -> Option<Drive> {
    if matches!(measure, Measure::Declared(_)) && table.has("unit") {
        table.note("unit", &DriveProblem::InlineUnit);
    }
    // The key `expression` implies the kind.
    let kind = match !table.has("kind") && table.has("expression") {
        true => "expression",
        false => {
            table.require_text("kind", "the kind of the drive")?;
            KINDS[table.word("kind", &KINDS)?]
        }
    };
    match kind {
        "constant" => value(table, "value", measure).map(Drive::Constant),
        "ramp" => ramp(table, measure),
        "step" => step(table, measure),
        "harmonic" => harmonic(table, measure),
        "doublet" => doublet(table, measure),
        "table" => columns::read(table, measure),
        "expression" => {
            let item = table.require_item("expression", "an expression of t")?;
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
fn value(table: &Table<'_>, key: &str, measure: Measure) -> Option<f64> {
    measure.number(&table.require_item(key, &measure.words())?)
}

fn value_or_zero(table: &Table<'_>, key: &str, measure: Measure) -> Option<f64> {
    match table.item(key) {
        Some(item) => measure.number(&item),
        None => Some(0.0),
    }
}

fn ramp(table: &Table<'_>, measure: Measure) -> Option<Drive> {
    let from = value_or_zero(table, "from", measure);
    let to = value(table, "to", measure);
    let start = table.get(&START);
    let has = ["end", "duration"].map(|key| table.has(key));
    let end = match has {
        [true, false] => table.quantity("end", Dimension::TIME),
        [false, true] => {
            let duration = table.quantity("duration", Dimension::TIME);
            duration
                .zip(start)
                .map(|(duration, start)| start + duration)
        }
        [both, _] => {
            let found = if both { "both" } else { "none" };
            let keys = ["end", "duration"];
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
    let from = value_or_zero(table, "from", measure);
    let to = value(table, "to", measure);
    let time = table.get(&TIME);
    Some(Drive::Step(Step {
        from: from?,
        to: to?,
        time: time?,
    }))
}

fn harmonic(table: &Table<'_>, measure: Measure) -> Option<Drive> {
    let mean = value_or_zero(table, "mean", measure);
    let amplitude = value(table, "amplitude", measure);
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
    let amplitude = value(table, "amplitude", measure);
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
    let mean = value_or_zero(table, "mean", measure);
    let deviation = value(table, "deviation", measure).filter(|deviation| {
        let is_right = *deviation >= 0.0;
        if !is_right {
            table.wrong("deviation", "a number that is zero or more");
        }
        is_right
    });
    let seed = table.get(&SEED).map(|seed| seed as u64);
    let keys = ["band", "interval"];
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
            table.item("terms");
            let drive = table.title().to_owned();
            table.note("", &DriveProblem::OneOf { drive, keys, found });
            None
        }
    }
}

/// The least and the largest frequency of a random drive \[Hz\].
fn band(table: &Table<'_>) -> Option<[f64; 2]> {
    let [low, high] = table.quantities("band", Dimension::FREQUENCY)?[..] else {
        table.wrong("band", "an array of 2, each a frequency");
        return None;
    };
    let band = [low, high];
    if low < 0.0 || high <= low {
        table.note("band", &DriveProblem::Band { band });
        return None;
    }
    Some(band)
}

/// A sum of drives, or a product of a drive and pure numbers.
fn combined(table: &Table<'_>, is_sum: bool, measure: Measure, find: &Find<'_>) -> Option<Drive> {
    let key = if is_sum { "terms" } else { "factors" };
    let items = table.require_item(key, "a list of drives")?;
    let Some(items) = items.list() else {
        return items.wrong("a list of drives");
    };
    if items.is_empty() {
        table.note(key, &DriveProblem::Nothing { key });
        return None;
    }
    let part = |(i, item): (usize, &Item<'_>)| match is_sum || i == 0 {
        true => drive(item, measure, find),
        false => drive(item, Measure::Declared(Dimension::NUMBER), find),
    };
    // All parts are read, so that each problem is noted.
    let parts: Vec<_> = items.iter().enumerate().map(part).collect();
    let parts: Option<Vec<_>> = parts.into_iter().collect();
    Some(match is_sum {
        true => Drive::Sum(parts?.into()),
        false => Drive::Product(parts?.into()),
    })
}
