//! Steps of the thickness along a smooth wall: the levels of both laminates are cut
//! through all their plies, so that cells on either side of the step share whole sides.

use super::joints::{End, Joint, Meeting, SMOOTH, turn};
use super::layers::Layers;
use super::mitre::View;
use super::segments::Segment;

/// Cuts the layers of laminates that step into each other, until nothing changes: the
/// levels of all of them are then those of all, as far as each reaches.
pub(super) fn cut(joints: &[Joint], segments: &[Segment], layers: &mut [Layers]) {
    let pairs: Vec<[End; 2]> = joints.iter().flat_map(of_joint).collect();
    let mut changed = true;
    while changed {
        changed = false;
        for &[before, behind] in &pairs {
            for (level, lamina) in missing(segments, layers, before, behind) {
                changed |= layers[lamina].cut(level);
            }
        }
    }
}

/// The ends that meet at a joint, by twos.
fn of_joint(joint: &Joint) -> Vec<[End; 2]> {
    match &joint.meeting {
        Meeting::Free(_) => Vec::new(),
        Meeting::Tee { wall, .. } => vec![*wall],
        Meeting::Through([before, behind]) => before
            .iter()
            .flat_map(|&one| behind.iter().map(move |&other| [one, other]))
            .collect(),
    }
}

/// The levels of each of two laminates, as the other sees them, if one steps into the
/// other: each with the laminate to be cut.
fn missing(segments: &[Segment], layers: &[Layers], before: End, behind: End) -> Vec<(f64, usize)> {
    let one = View::new(segments, layers, before, true);
    let other = View::new(segments, layers, behind, false);
    let [a, b] = [before, behind].map(|end| segments[end.segment].lamina);
    let is_smooth = turn(one.tangent, other.tangent).abs() <= SMOOTH;
    if a == b || !is_smooth || one.bank() != other.bank() || one.equals(&other) {
        return Vec::new();
    }
    let for_other = one.levels().into_iter();
    let for_one = other.levels().into_iter();
    let for_other = for_other.map(|(level, _)| (other.turned(level), b));
    let for_one = for_one.map(|(level, _)| (one.turned(level), a));
    for_other.chain(for_one).collect()
}
