//! Modes that have another kind than their name states, after veering.

use crate::input::short_number;
use crate::result::{FrequencyTable, ModeKind};

/// A sentence for each mode that changes its kind: the kinds, and the speeds at which it has them.
pub(super) fn changes(table: &FrequencyTable) -> Vec<String> {
    let (words, unit) = (table.style.words, table.style.unit);
    let mut found = Vec::new();
    for branch in &table.branches {
        let mut runs: Vec<(ModeKind, [usize; 2])> = Vec::new();
        for (k, point) in branch.points.iter().enumerate() {
            let Some(point) = point else { continue };
            let kind = branch.kind_at(point);
            match runs.last_mut().filter(|run| run.0 == kind) {
                Some(run) => run.1[1] = k,
                None => runs.push((kind, [k, k])),
            }
        }
        let others = runs.into_iter().filter(|run| run.0 != branch.kind);
        let runs: Vec<_> = others
            .map(|(kind, ends)| {
                let [first, last] = ends.map(|k| short_number(unit.speed(table.speeds[k]), 6));
                let speeds = if first == last {
                    format!("at {first} {}", unit.speed_word())
                } else {
                    format!("from {first} to {last} {}", unit.speed_word())
                };
                format!("{} {speeds}", kind.word_in(words))
            })
            .collect();
        if !runs.is_empty() {
            found.push(format!("{} is {}", branch.name, runs.join(", ")));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn a_mode_that_becomes_another_one_is_reported() {
        let mut table = samples::small();
        assert_eq!(changes(&table), Vec::<String>::new());
        if let Some(point) = &mut table.branches[0].points[1] {
            point.shares = [0.1, 0.0, 0.9, 0.0];
        }
        assert_eq!(changes(&table), ["flap 1 is torsion at 600 rpm"]);
        // Neither one nor the other: the name is kept.
        if let Some(point) = &mut table.branches[0].points[1] {
            point.shares = [0.5, 0.0, 0.5, 0.0];
        }
        assert_eq!(changes(&table), Vec::<String>::new());
    }
}
