//! Curves of the Campbell diagram: modes in the fixed system.

use shared_geom::figure::CATEGORIES;

use super::{COLORS, Curve};
use crate::result::{FixedLine, FixedTable, FrequencyTable, Whirl};

/// Pattern of a line by its waves around the rotor: none, one forward, one backward, more.
fn pattern(harmonic: i32) -> usize {
    match harmonic {
        0 => 0,
        1 => 1,
        -1 => 3,
        _ => 2,
    }
}

/// The patterns that the lines have, with their meaning.
pub(super) fn patterns(fixed: &FixedTable, table: &FrequencyTable) -> Vec<(usize, String)> {
    let blades = table.blades();
    let mut found: Vec<(usize, String)> = Vec::new();
    for line in &fixed.lines {
        let number = pattern(line.harmonic);
        if found.iter().any(|known| known.0 == number) {
            continue;
        }
        let whirl = Whirl {
            harmonic: line.harmonic,
            blades,
            share: 1.0,
        };
        let shift = match line.harmonic {
            1 => ", + 1P",
            -1 => ", - 1P",
            _ => "",
        };
        let word = match number {
            2 => "several waves".to_owned(),
            0 if blades > 0 && blades.is_multiple_of(2) => "collective, differential".to_owned(),
            _ => whirl.word_in(table.style.words),
        };
        found.push((number, format!("{word}{shift}")));
    }
    found.sort_by_key(|known| (known.0 != 0, known.0));
    found
}

/// The curves of `fixed`, the modes of `table`: modes of one name in one color.
pub(super) fn curves(fixed: &FixedTable, table: &FrequencyTable) -> Vec<Curve> {
    let mut stems: Vec<&str> = Vec::new();
    let mut curves = Vec::with_capacity(fixed.lines.len());
    for line in &fixed.lines {
        let known = stems.iter().position(|stem| *stem == line.stem);
        let index = known.unwrap_or_else(|| {
            stems.push(&line.stem);
            stems.len() - 1
        });
        curves.push(curve(line, index, table));
    }
    curves
}

fn curve(line: &FixedLine, index: usize, table: &FrequencyTable) -> Curve {
    let points = || line.points.iter();
    let values = points().zip(&table.speeds).map(|(point, speed)| {
        let frequency = point.as_ref()?.frequency();
        table.style.unit.value(frequency, *speed)
    });
    let zeros = line.zeros(&table.speeds);
    let last = points().rev().flatten().next().map(|point| point.kind);
    let now = last.filter(|kind| *kind != line.kind);
    Curve {
        name: match now {
            Some(kind) => format!("{}, now {}", line.name, kind.word_in(table.style.words)),
            None => line.name.clone(),
        },
        kinds: points().map(|point| Some(point.as_ref()?.kind)).collect(),
        frequencies: values.collect(),
        zeros: zeros.iter().map(|s| table.style.unit.speed(*s)).collect(),
        color: CATEGORIES[index % COLORS],
        damping: points()
            .map(|point| Some(100.0 * point.as_ref()?.damping_ratio))
            .collect(),
        pattern: pattern(line.harmonic),
    }
}
