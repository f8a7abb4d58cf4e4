//! Beam elements that turn too far for their number.
//!
//! Between the nodes a position is quadratic: the chord of an arc of half angle alpha is
//! short by `alpha^4/270` of its length, while curvatures stay exact.

use std::f64::consts::FRAC_PI_4;

use crate::elements::SectionState;

/// Rotation between the middle and an end of an element beyond which it is reported
/// \[rad\]: distances are then short by 1.4e-3.
const FAR: f64 = FRAC_PI_4;
/// The rotation recommended \[rad\]: distances are then short by 9e-5.
const GOOD: f64 = 0.5 * FRAC_PI_4;

/// A remark if an element of `sections` turns far within itself, at `when` given as text.
pub(super) fn bending(sections: &[SectionState], when: &str) -> Option<String> {
    let worst = sections.iter().max_by(|a, b| a.turn.total_cmp(&b.turn))?;
    let far: Vec<_> = sections
        .iter()
        .filter(|section| section.turn > FAR)
        .collect();
    (worst.turn > FAR).then(|| {
        format!(
            "{when} beam \"{}\" turns by {:.0} deg from end to end, and {} of {} elements by more \
             than {:.0} deg: positions are off by about {:.1e} of the length of an element; use {:.0} \
             times as many elements there",
            worst.beam,
            2.0 * worst.turn.to_degrees(),
            far.len().div_ceil(2),
            sections.len() / 2,
            2.0 * FAR.to_degrees(),
            worst.turn.powi(4) / 270.0,
            (worst.turn / GOOD).ceil()
        )
    })
}
