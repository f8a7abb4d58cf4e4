//! Which mode at one speed is which at the next.
//!
//! The modal assurance criterion of two modes, weighted with the mass,
//!
//! ```text
//! MAC = |q_a^H M q_b| |q_b^H M q_a| / (|q_a^H M q_a| |q_b^H M q_b|)
//! ```
//!
//! is one for equal shapes and near zero for different ones. Where two modes exchange
//! their shapes, the assurance of both is about one half with either; then the frequency
//! decides that is nearer to the one expected from the slope over speed.

use super::ModeMotion;

/// Least assurance, weighted by the closeness of the frequency, for which two modes are
/// treated as the same one.
const SAME: f64 = 0.4;
/// Relative distance from the expected frequency at which the closeness is one half.
const HALF: f64 = 0.05;
/// Least closeness: a shape that is the same is the same mode at any frequency.
const FAR: f64 = 0.6;

/// Assurance of each mode of `before` (rows) with each of `after` (columns).
pub fn assurances(before: &[ModeMotion], after: &[ModeMotion]) -> Vec<Vec<f64>> {
    let row = |a: &ModeMotion| {
        let own = a.product(a).norm();
        let with = |b: &ModeMotion| {
            let cross = a.product(b).norm() * b.product(a).norm();
            cross / (own * b.product(b).norm())
        };
        after.iter().map(with).collect()
    };
    before.iter().map(row).collect()
}

/// Closeness of a frequency to the expected one, from one down to a least; frequencies of whirls
/// in the fixed system have a sign.
///
/// ```text
/// closeness = FAR + (1 - FAR) / (1 + (distance / HALF)^2),   distance = |f - expected| / larger
/// ```
pub fn closeness(expected: f64, found: f64) -> f64 {
    let larger = expected.abs().max(found.abs()).max(f64::MIN_POSITIVE);
    let distance = (found - expected) / larger / HALF;
    FAR + (1.0 - FAR) / (1.0 + distance * distance)
}

/// For each mode before, the mode after that continues it: pairs are taken by falling
/// assurance times closeness, each mode once, while it is enough.
pub fn follow(assurances: &[Vec<f64>], closeness: &[Vec<f64>]) -> Vec<Option<usize>> {
    let mut pairs: Vec<_> = assurances
        .iter()
        .enumerate()
        .zip(closeness)
        .flat_map(|((i, row), near)| {
            let weighted = row.iter().zip(near).map(|(mac, near)| mac * near);
            weighted.enumerate().map(move |(j, weight)| (weight, i, j))
        })
        .filter(|pair| pair.0 >= SAME)
        .collect();
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut continued = vec![None; assurances.len()];
    let mut taken = std::collections::HashSet::new();
    for (_, i, j) in pairs {
        if continued[i].is_none() && taken.insert(j) {
            continued[i] = Some(j);
        }
    }
    continued
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossing_modes_are_followed_and_strangers_are_not() {
        let macs = vec![
            vec![0.1, 0.9, 0.0],
            vec![0.8, 0.7, 0.0],
            vec![0.0, 0.0, 0.3],
        ];
        let nothing_expected = vec![vec![1.0; 3]; 3];
        assert_eq!(follow(&macs, &nothing_expected), [Some(1), Some(0), None]);
    }

    // Two modes that exchange their shapes: by assurance alone either could be either; the
    // frequencies 10 and 12 were expected to be 12.1 and 10.1.
    #[test]
    fn the_slope_decides_between_equal_shapes() {
        let macs = vec![vec![0.52, 0.48], vec![0.48, 0.52]];
        let near =
            [12.1, 10.1].map(|expected| [10.0, 12.0].map(|f| closeness(expected, f)).to_vec());
        assert_eq!(follow(&macs, &near), [Some(1), Some(0)]);
        assert_eq!(closeness(3.0, 3.0), 1.0);
        assert!(closeness(-3.0, 3.0) < 0.601);
    }
}
