//! Curves of the Campbell diagram: modes in the fixed system.

use shared_geom::figure::Color;

use super::groups::{SAME_DAMPING, joined};
use super::{Curve, looks};
use crate::result::{FixedLine, FixedPoint, FixedTable, FrequencyTable, Whirl};

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
            // The two waves of two blades run around the rotor.
            blades: if line.harmonic == 0 { blades } else { 0 },
            share: 1.0,
        };
        let shift = match line.harmonic {
            1 => ", + 1P",
            -1 => ", - 1P",
            _ => "",
        };
        let word = match number {
            2 => "several waves".to_owned(),
            0 if blades > 2 && blades.is_multiple_of(2) => "collective, differential".to_owned(),
            _ => whirl.word_in(table.style.words),
        };
        found.push((number, format!("{word}{shift}")));
    }
    found.sort_by_key(|known| (known.0 != 0, known.0));
    found
}

/// The curves of `fixed`, the modes of `table`: modes of one name in one color; those that coincide
/// in one pattern are drawn once.
pub(super) fn curves(fixed: &FixedTable, table: &FrequencyTable) -> Vec<Curve> {
    let groups = groups(fixed);
    let first = groups.iter().map(|lines| lines[0]);
    let stems: Vec<_> = first.map(|line| (line.kind, line.stem.as_str())).collect();
    let curves = groups.iter().zip(looks::colors(&stems));
    curves
        .map(|(lines, color)| curve(lines, color, table))
        .collect()
}

/// The lines of `fixed`, in groups of one name and pattern that coincide.
fn groups(fixed: &FixedTable) -> Vec<Vec<&FixedLine>> {
    let points = fixed.lines.iter().flat_map(|line| &line.points).flatten();
    let highest = points.map(FixedPoint::frequency).fold(0.0, f64::max);
    let is_same = |a: &Option<FixedPoint>, b: &Option<FixedPoint>| match (a, b) {
        (Some(a), Some(b)) => {
            a.kind == b.kind
                && (a.frequency() - b.frequency()).abs() <= looks::SAME_LINE * highest
                && (a.damping_ratio - b.damping_ratio).abs() <= SAME_DAMPING
        }
        (a, b) => a.is_none() && b.is_none(),
    };
    let mut groups: Vec<Vec<&FixedLine>> = Vec::new();
    for line in &fixed.lines {
        let coincides = |group: &&mut Vec<&FixedLine>| {
            let first = group[0];
            (first.stem == line.stem)
                && pattern(first.harmonic) == pattern(line.harmonic)
                && (first.points.iter().zip(&line.points)).all(|(a, b)| is_same(a, b))
        };
        match groups.iter_mut().find(coincides) {
            Some(group) => group.push(line),
            None => groups.push(vec![line]),
        }
    }
    groups
}

/// The curve of lines that coincide.
fn curve(lines: &[&FixedLine], color: Color, table: &FrequencyTable) -> Curve {
    let line = lines[0];
    let points = || line.points.iter();
    let values = points().zip(&table.speeds).map(|(point, speed)| {
        let frequency = point.as_ref()?.frequency();
        table.style.unit.value(frequency, *speed)
    });
    let zeros = line.zeros(&table.speeds);
    let last = points().rev().flatten().next().map(|point| point.kind);
    let now = last.filter(|kind| *kind != line.kind);
    let name = match lines {
        [line] => line.name.clone(),
        _ => joined(&line.stem, lines.iter().map(|line| line.name.as_str())),
    };
    Curve {
        name: match now {
            Some(kind) => format!("{name}, now {}", kind.word_in(table.style.words)),
            None => name,
        },
        kind: line.kind,
        kinds: points().map(|point| Some(point.as_ref()?.kind)).collect(),
        frequencies: values.collect(),
        zeros: zeros.iter().map(|s| table.style.unit.speed(*s)).collect(),
        color,
        damping: points()
            .map(|point| Some(100.0 * point.as_ref()?.damping_ratio))
            .collect(),
        pattern: pattern(line.harmonic),
    }
}
