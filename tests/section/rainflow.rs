//! Cycles of a history against the counts of a public implementation.
//!
//! Source: the package rainflow 3.2.0 (Python Package Index), `tests/reference/rainflow`. The values
//! are whole numbers, so that ranges and means are exact: equality.

use std::collections::BTreeMap;

use section_analyzer::recovery::rainflow::cycles;

/// The history of `counts.py`: a sum of steps from a linear congruential sequence.
fn history() -> Vec<f64> {
    let (mut state, mut value) = (2024_u64, 0_i64);
    let step = |_| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        value += ((state >> 40) % 401) as i64 - 200 - value / 16;
        value as f64
    };
    (0..5000).map(step).collect()
}

#[test]
fn counts_are_those_of_the_package() {
    let table = include_str!("../reference/rainflow/counts.csv");
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        // halves as whole numbers
        let [range, mean, count] = [cells[0], cells[1], cells[2]].map(|value| (2.0 * value) as i64);
        ((range, mean), count)
    };
    let expected: BTreeMap<_, _> = table.lines().skip(1).map(row).collect();
    let mut found: BTreeMap<(i64, i64), i64> = BTreeMap::new();
    for cycle in cycles(history()) {
        let key = [cycle.range, cycle.mean].map(|value| (2.0 * value) as i64);
        *found.entry((key[0], key[1])).or_default() += (2.0 * cycle.count) as i64;
    }
    assert_eq!(expected.len(), 1294);
    assert_eq!(found, expected);
}
