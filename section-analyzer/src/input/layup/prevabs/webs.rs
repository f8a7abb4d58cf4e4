//! Webs: straight segments from one side of the contour to the other.

use super::super::course::Course;
use super::super::place::Place;
use super::super::{WrittenLayer, WrittenWeb};
use super::components::{Segment, Side};
use super::contour::Contour;
use super::files::Notes;
use super::geometry::{Kind, extent};
use super::layups::Ply;
use crate::mesh::distance;

/// Part of the length of a line by which its points may leave it.
const STRAIGHT: f64 = 1e-6;

/// The web of a segment; `depth` is the thickness of the shell at most. Notes problems.
pub(super) fn web(
    segment: &Segment<'_>,
    contour: &Contour,
    depth: f64,
    notes: &mut Notes,
) -> Option<WrittenWeb> {
    let what = segment.element.shown();
    let d = direction(segment, notes)?;
    let left = [-d[1], d[0]];
    let (first, last) = ends(segment);
    let (plies, center) = across(segment);
    let origin = [0, 1].map(|i| first[i] + center * left[i]);
    let ahead = |p: [f64; 2]| (0..2).map(|i| (p[i] - origin[i]) * left[i]).sum::<f64>() > 0.0;
    let outline = &contour.outline;
    let [Some(suction), Some(pressure)] = [0, 1].map(|side| outline.first_behind(side, ahead))
    else {
        let expected = "a line that meets both sides of the contour";
        let help = "move the web into the section";
        notes.wrong(
            segment.element,
            [&what, "a line beside the contour", expected, help],
        );
        return None;
    };
    let feet = [suction, pressure].map(|s| outline.position(s));
    reaches(segment, [first, last], feet, depth, notes)?;
    // a web runs from the pressure to the suction side, with its plies from the leading edge aft
    let run: f64 = (0..2).map(|i| d[i] * (feet[0][i] - feet[1][i])).sum();
    let mut plies = plies;
    if run < 0.0 {
        plies.reverse();
    }
    let line = segment.element.line();
    let written = plies.into_iter().map(|(number, ply)| {
        let name = format!("{}_{}", segment.name, number + 1);
        let named = (name, ply.material.clone());
        let (thickness, whole) = (Course::constant(ply.thickness), [0.0, 1.0].map(Place::arc));
        WrittenLayer {
            fiber_angle: Course::constant((ply.angle * run.signum()).to_radians()),
            ..WrittenLayer::plain(named, thickness, whole, line)
        }
    });
    Some(WrittenWeb {
        name: segment.name.clone(),
        places: [suction, pressure].map(|s| Place::arc(s / outline.perimeter())),
        range: [0.0, 1.0],
        plies: written.collect(),
        line,
    })
}

/// First and last point of the line of a segment.
fn ends(segment: &Segment<'_>) -> ([f64; 2], [f64; 2]) {
    let points = &segment.points;
    (points[0], points[points.len() - 1])
}

/// The direction of a straight line; notes another line.
fn direction(segment: &Segment<'_>, notes: &mut Notes) -> Option<[f64; 2]> {
    let (first, last) = ends(segment);
    let length = distance(first, last);
    let d = [0, 1].map(|i| (last[i] - first[i]) / length);
    let off = |point: &[f64; 2]| (point[1] - first[1]) * d[0] - (point[0] - first[0]) * d[1];
    let mut points = segment.points.iter();
    let is_straight = points.all(|point| off(point).abs() <= STRAIGHT * length);
    if is_straight && length > 1e-9 * extent(&segment.points) {
        return Some(d);
    }
    let what = segment.element.shown();
    let found = "a curved line that is not part of the contour";
    let expected = "a straight web, or a segment of the closed contour";
    let help = "lay the web along a straight line; laminates inside are not read";
    notes.wrong(segment.element, [&what, found, expected, help]);
    None
}

/// The layers of a web from the right of its line to the left, with their numbers, and the
/// distance of their middle from the line, positive on the left.
fn across<'s>(segment: &'s Segment<'_>) -> (Vec<(usize, &'s Ply)>, f64) {
    let listed: Vec<(usize, &Ply)> = segment.plies.iter().enumerate().collect();
    let total: f64 = segment.plies.iter().map(|ply| ply.thickness).sum();
    let center = (0.5 - segment.position) * total;
    let reversed = || listed.iter().rev().copied();
    match segment.side {
        Side::Left => (listed, center),
        Side::Right => (reversed().collect(), -center),
        Side::Both => {
            let count = listed.len();
            let mirrored = reversed().map(|(number, ply)| (number + count, ply));
            (mirrored.chain(listed.iter().copied()).collect(), 0.0)
        }
    }
}

/// Notes a web that ends before it reaches the shell.
fn reaches(
    segment: &Segment<'_>,
    ends: [[f64; 2]; 2],
    feet: [[f64; 2]; 2],
    depth: f64,
    notes: &mut Notes,
) -> Option<()> {
    if segment.kind == Kind::Endless {
        return Some(());
    }
    let width: f64 = segment.plies.iter().map(|ply| ply.thickness).sum();
    let length = distance(ends[0], ends[1]);
    let along = |p: [f64; 2]| {
        let d = [0, 1].map(|i| (ends[1][i] - ends[0][i]) / length);
        (0..2).map(|i| (p[i] - ends[0][i]) * d[i]).sum::<f64>()
    };
    let mut places = feet.map(along);
    places.sort_by(f64::total_cmp);
    // a foot is oblique where the contour is
    let room = 2.0 * depth + width + 0.02 * distance(feet[0], feet[1]);
    let short = [-places[0], places[1] - length]
        .into_iter()
        .fold(0.0, f64::max);
    if short <= room {
        return Some(());
    }
    let found = format!("an end {short:.4e} before the contour");
    let expected = "a web from one side to the other";
    let help = "let its base line reach the contour";
    notes.wrong(
        segment.element,
        [&segment.element.shown(), &found, expected, help],
    );
    None
}
