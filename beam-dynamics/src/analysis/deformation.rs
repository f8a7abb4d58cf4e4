//! Beams that deform too far: elements that turn too far for their number, and strains beyond those
//! of any material.
//!
//! Between the nodes a position is quadratic: the chord of an arc of half angle alpha is
//! short by `alpha^4/270` of its length, while curvatures stay exact.

use std::f64::consts::FRAC_PI_4;

use shared_geom::rotation::vector;

use crate::case::Model;
use crate::elements::SectionState;
use crate::model::State;

/// Rotation between the middle and an end of an element beyond which it is reported
/// \[rad\]: distances are then short by 1.4e-3.
const FAR: f64 = FRAC_PI_4;
/// Relative difference of a rotation from [`FAR`] that is round-off, as of elements that all turn by
/// exactly this angle [-].
const ROUND_OFF: f64 = 1e-6;
/// The rotation recommended \[rad\]: distances are then short by 9e-5.
const GOOD: f64 = 0.5 * FRAC_PI_4;

/// Strain of the line beyond which it is reported [-]: laminates and metals break or yield at a
/// tenth of it, and the equations take strains as small.
const STRAINED: f64 = 0.1;

/// Remarks if an element of `sections` turns far within itself, and if a beam is strained far, at
/// `when` given as text.
pub(super) fn deformation(sections: &[SectionState], when: &str) -> [Option<String>; 2] {
    [bending(sections, when), straining(sections, when)]
}

fn straining(sections: &[SectionState], when: &str) -> Option<String> {
    let size = |section: &SectionState| section.strain.fixed_rows::<3>(0).amax();
    let worst = sections.iter().max_by(|a, b| size(a).total_cmp(&size(b)))?;
    (size(worst) > STRAINED).then(|| {
        format!(
            "{when} the line of beam \"{}\" is strained by {:.0} %: the equations hold for small \
             strains, check loads and stiffness",
            worst.beam,
            100.0 * size(worst)
        )
    })
}

fn bending(sections: &[SectionState], when: &str) -> Option<String> {
    let worst = sections.iter().max_by(|a, b| a.turn.total_cmp(&b.turn))?;
    let is_far = |section: &&SectionState| section.turn > FAR * (1.0 + ROUND_OFF);
    let far = sections.iter().filter(is_far).count();
    (far > 0).then(|| {
        format!(
            "{when} beam \"{}\" turns by {:.0} deg from end to end, and {} of {} elements by more \
             than {:.0} deg: positions are off by about {:.1e} of the length of an element; use {:.0} \
             times as many elements there",
            worst.beam,
            2.0 * worst.turn.to_degrees(),
            far.div_ceil(2),
            sections.len() / 2,
            2.0 * FAR.to_degrees(),
            worst.turn.powi(4) / 270.0,
            (worst.turn / GOOD).ceil()
        )
    })
}

/// The node of a turning model that has turned farthest from its undeformed attitude, and
/// by how much \[deg\], where that is more than a quarter turn.
pub(super) fn folded(model: &Model, speed: f64, state: &State) -> Option<(String, f64)> {
    if speed == 0.0 {
        return None;
    }
    let pairs = model.system.nodes().iter().zip(&state.nodes);
    let turned = pairs.map(|(node, now)| {
        let turn = vector::from_rotation(&(now.rotation * node.rotation.transpose()));
        (node.label.clone(), turn.norm().to_degrees())
    });
    turned
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .filter(|most| most.1 > 90.0)
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3, Vector6};

    use super::*;

    fn section(strain: f64, turn: f64) -> SectionState {
        SectionState {
            beam: "b".into(),
            xi: 0.5,
            position: Vector3::zeros(),
            axes: Matrix3::identity(),
            strain: Vector6::new(0.01, -strain, 0.0, 5.0, 5.0, 5.0),
            internal_force: Vector6::zeros(),
            change_of_stiffness: None,
            turn,
        }
    }

    #[test]
    fn strains_and_turns_are_reported_beyond_their_limits() {
        assert_eq!(deformation(&[section(0.09, 0.7)], "there"), [None, None]);
        let far = [section(0.09, 0.8), section(0.12, 0.7)];
        let [bent, strained] = deformation(&far, "there").map(Option::unwrap);
        assert!(bent.starts_with("there beam \"b\" turns by 92 deg from end to end, and 1 of 1"));
        assert!(strained.starts_with("there the line of beam \"b\" is strained by 12 %"));
        assert_eq!(deformation(&[], ""), [None, None]);
        // Elements of a ring, all with the same angle up to round-off.
        let ring = [1.0, 1.0 + 1e-9, 1.0 - 1e-9].map(|part| section(0.0, part * FAR));
        assert_eq!(deformation(&ring, ""), [None, None]);
    }
}
