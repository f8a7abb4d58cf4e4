//! Steps of the thickness along a smooth wall: the levels of both laminates divide all
//! their plies, so that cells on either side of the step share whole sides. Levels that
//! nearly agree are first made equal, to avoid slivers between them.

use super::joints::{End, Joint, Meeting, SMOOTH, turn};
use super::layers::Layers;
use super::mitre::View;
use super::segments::Segment;

/// Levels of two laminates that differ by less, relative to the thickness, are intended
/// to be equal.
const NEAR: f64 = 1e-4;

/// Divides the layers of laminates with steps between them, until nothing changes: each
/// laminate then has the levels of all others within its thickness.
pub(super) fn cut(joints: &[Joint], segments: &[Segment], layers: &mut [Layers]) {
    let pairs: Vec<[End; 2]> = joints.iter().flat_map(of_joint).collect();
    // a level made equal to one neighbor is passed on to the next
    for _ in 0..layers.len() {
        let near: Vec<_> = pairs
            .iter()
            .flat_map(|&[before, behind]| near(segments, layers, before, behind))
            .collect();
        for &(lamina, index, level) in &near {
            layers[lamina].levels[index] = level;
        }
        if near.is_empty() {
            break;
        }
    }
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

/// The ends that meet at a joint, in pairs.
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

/// The levels of the later one of two laminates that nearly agree with a level of the
/// other: laminate, index, and new level.
fn near(
    segments: &[Segment],
    layers: &[Layers],
    before: End,
    behind: End,
) -> Vec<(usize, usize, f64)> {
    let one = View::new(segments, layers, before, true);
    let other = View::new(segments, layers, behind, false);
    let [a, b] = [before, behind].map(|end| segments[end.segment].lamina);
    if !steps(&one, &other, [a, b]) {
        return Vec::new();
    }
    let (kept, (moved, lamina)) = if a < b {
        (&one, (&other, b))
    } else {
        (&other, (&one, a))
    };
    let own = &layers[lamina];
    let tolerance = NEAR * layers[a].thickness().max(layers[b].thickness());
    let mut found = Vec::new();
    for (level, _) in kept.levels() {
        let level = moved.turned(level);
        let index = own.levels.iter().position(|x| {
            let off = (x - level).abs();
            *x != 0.0 && off > own.tolerance() && off <= tolerance
        });
        if let Some(index) = index.filter(|&index| own.may_be_at(index, level)) {
            found.push((lamina, index, level));
        }
    }
    found
}

/// Whether two laminates in line have different levels.
fn steps(one: &View<'_>, other: &View<'_>, [a, b]: [usize; 2]) -> bool {
    let is_smooth = turn(one.tangent, other.tangent).abs() <= SMOOTH;
    a != b && is_smooth && one.bank() == other.bank() && !one.equals(other)
}

/// Missing levels of two laminates, if there is a step between them: each level with the
/// laminate to be divided.
fn missing(segments: &[Segment], layers: &[Layers], before: End, behind: End) -> Vec<(f64, usize)> {
    let one = View::new(segments, layers, before, true);
    let other = View::new(segments, layers, behind, false);
    let [a, b] = [before, behind].map(|end| segments[end.segment].lamina);
    if !steps(&one, &other, [a, b]) {
        return Vec::new();
    }
    let for_other = one.levels().into_iter();
    let for_one = other.levels().into_iter();
    let for_other = for_other.map(|(level, _)| (other.turned(level), b));
    let for_one = for_one.map(|(level, _)| (one.turned(level), a));
    for_other.chain(for_one).collect()
}
