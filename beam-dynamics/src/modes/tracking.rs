//! Which mode at one speed is which at the next.
//!
//! The modal assurance criterion of two modes, weighted with the mass,
//!
//! ```text
//! MAC = |q_a^H M q_b| |q_b^H M q_a| / (|q_a^H M q_a| |q_b^H M q_b|)
//! ```
//!
//! is one for equal shapes and near zero for different ones.

use super::ModeMotion;

/// Least assurance for which two modes are taken for the same one.
const SAME: f64 = 0.5;

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

/// For each mode before, the mode after that continues it: pairs are taken by falling
/// assurance, each mode once, while it is at least one half.
pub fn follow(assurances: &[Vec<f64>]) -> Vec<Option<usize>> {
    let mut pairs: Vec<_> = assurances
        .iter()
        .enumerate()
        .flat_map(|(i, row)| row.iter().enumerate().map(move |(j, &mac)| (mac, i, j)))
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
        assert_eq!(follow(&macs), [Some(1), Some(0), None]);
    }
}
