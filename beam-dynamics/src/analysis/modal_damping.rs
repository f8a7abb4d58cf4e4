//! Given damping ratios of modes replace the computed ones.
//!
//! With the natural frequency `|s|` of a mode kept and a damping ratio zeta,
//!
//! ```text
//! s = |s| ( -zeta + i sqrt(1 - zeta^2) )
//! ```

use std::f64::consts::TAU;

use shared_geom::error::nearest_name;

use crate::case::ModalDamping;
use crate::result::{ModeBranch, ModePoint};

/// Sets the damping ratios of the modes; reports names without a mode.
pub(super) fn give(damping: &ModalDamping, branches: &mut [ModeBranch]) -> Vec<String> {
    for (order, branch) in branches.iter_mut().enumerate() {
        if let Some(ratio) = damping.ratio(order, &branch.name) {
            for point in branch.points.iter_mut().flatten() {
                damp(point, ratio);
            }
        }
    }
    match damping {
        ModalDamping::ByName(ratios) => unknown(ratios, branches),
        ModalDamping::ByOrder(ratios) if ratios.len() > branches.len() => vec![format!(
            "{} damping ratios are given for {} modes",
            ratios.len(),
            branches.len()
        )],
        _ => Vec::new(),
    }
}

fn damp(point: &mut ModePoint, ratio: f64) {
    let natural = point.growth.hypot(TAU * point.frequency);
    point.damping_ratio = ratio;
    point.growth = -ratio * natural;
    point.frequency = natural * (1.0 - ratio * ratio).sqrt() / TAU;
}

fn unknown(ratios: &[(String, f64)], branches: &[ModeBranch]) -> Vec<String> {
    let names = || branches.iter().map(|branch| branch.name.as_str());
    let is_unknown = |(name, _): &&(String, f64)| names().all(|known| known != name);
    let report = |(name, _): &(String, f64)| {
        let near = nearest_name(name, names());
        let near = near.map_or_else(String::new, |near| format!("; did you mean \"{near}\"?"));
        format!("a damping ratio is given for \"{name}\", but no mode has this name{near}")
    };
    ratios.iter().filter(is_unknown).map(report).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::result::ModeKind;

    fn branch(name: &str) -> ModeBranch {
        let point = ModePoint {
            frequency: 3.0,
            damping_ratio: 0.0,
            growth: 0.0,
            shares: [1.0, 0.0, 0.0, 0.0],
            lateral: 0.0,
            tower: [0.0; 2],
            whirl: None,
            assurance: None,
            shape: None,
        };
        ModeBranch {
            name: name.to_owned(),
            kind: ModeKind::Flap,
            harmonic: None,
            points: vec![None, Some(point)],
        }
    }

    #[test]
    fn ratios_go_to_modes_by_order_or_name() {
        let ratios = |damping: &ModalDamping| -> Vec<f64> {
            let mut branches = [branch("flap 1"), branch("flap 2")];
            assert_eq!(give(damping, &mut branches), Vec::<String>::new());
            let points = branches.iter().flat_map(|branch| &branch.points).flatten();
            points.map(|point| point.damping_ratio).collect()
        };
        assert_eq!(ratios(&ModalDamping::Found), [0.0, 0.0]);
        assert_eq!(ratios(&ModalDamping::All(0.02)), [0.02, 0.02]);
        assert_eq!(ratios(&ModalDamping::ByOrder(vec![0.03])), [0.03, 0.0]);
        let named = ModalDamping::ByName(vec![("flap 2".to_owned(), 0.04)]);
        assert_eq!(ratios(&named), [0.0, 0.04]);
    }

    // zeta = 0.6: s = w (-0.6 + 0.8 i).
    #[test]
    fn the_natural_frequency_is_kept() {
        let mut branches = [branch("flap 1")];
        give(&ModalDamping::All(0.6), &mut branches);
        let point = branches[0].points[1].as_ref().unwrap();
        assert!((point.frequency - 2.4).abs() < 1e-15);
        assert!((point.growth + 0.6 * TAU * 3.0).abs() < 1e-14);
    }

    #[test]
    fn names_that_no_mode_has_are_reported() {
        let damping = ModalDamping::ByName(vec![("flap 3".to_owned(), 0.04)]);
        let reported = give(&damping, &mut [branch("flap 1")]);
        assert_eq!(
            reported,
            [
                "a damping ratio is given for \"flap 3\", but no mode has this name; did you mean \"flap 1\"?"
            ]
        );
    }
}
