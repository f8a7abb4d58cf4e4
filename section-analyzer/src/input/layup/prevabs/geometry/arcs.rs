//! Arcs and circles, as points of equal angles.

use std::f64::consts::{PI, TAU};

use super::super::files::{Element, Notes, word};
use super::{Geometry, Kind, Line, positive};
use crate::mesh::distance;

/// Largest angle between two points \[rad\]: 3 degrees, for which the spline through them leaves
/// the circle by less than 1e-6 of its radius.
const STEP: f64 = PI / 60.0;
/// Part of the radius by which start and end may differ in their distance from the center.
const SAME: f64 = 1e-3;

/// 1 for counterclockwise, the default, and -1 for clockwise.
fn direction(element: Element<'_>, notes: &mut Notes) -> Option<f64> {
    let Some(given) = element.child("direction") else {
        return Some(1.0);
    };
    let found = word(given, &given.shown(), &given.text(), &["ccw", "cw"], notes)?;
    Some(1.0 - 2.0 * found as f64)
}

/// Points from `start` around `center`.
fn points(center: [f64; 2], start: [f64; 2], sweep: f64) -> Line {
    let count = (sweep.abs() / STEP - 1e-9).ceil().clamp(2.0, 240.0) as usize;
    let from = [0, 1].map(|i| start[i] - center[i]);
    let at = |i: usize| {
        let (sine, cosine) = (sweep * i as f64 / count as f64).sin_cos();
        [
            center[0] + cosine * from[0] - sine * from[1],
            center[1] + sine * from[0] + cosine * from[1],
        ]
    };
    Line {
        points: (0..=count).map(at).collect(),
        kind: Kind::Curve,
    }
}

/// A circle by its center and its radius, or a point on it.
pub(super) fn circle<'x>(
    geometry: &mut Geometry<'x>,
    element: Element<'x>,
    notes: &mut Notes,
) -> Option<Line> {
    let (at, name) = element.required("center", notes)?;
    let center = geometry.point(&name, at, notes).map(|spot| spot.at);
    let sign = direction(element, notes);
    let start = match (element.child("radius"), element.child("point")) {
        (Some(radius), _) => {
            let radius = positive(radius, notes);
            center.zip(radius).map(|([y, z], radius)| [y + radius, z])
        }
        (None, Some(point)) => geometry
            .point(&point.text(), point, notes)
            .map(|spot| spot.at),
        (None, None) => {
            let help = "write <radius> or the name of a <point> on the circle";
            notes.wrong(
                element,
                [&element.shown(), "no radius", "<radius> or <point>", help],
            );
            None
        }
    };
    let mut line = points(center?, start?, TAU * sign?);
    let last = line.points.len() - 1;
    line.points[last] = line.points[0];
    Some(line)
}

/// An arc by its center, or by its radius.
pub(super) fn arc<'x>(
    geometry: &mut Geometry<'x>,
    element: Element<'x>,
    notes: &mut Notes,
) -> Option<Line> {
    let mut named = |name: &str, notes: &mut Notes| {
        let (at, text) = element.required(name, notes)?;
        geometry.point(&text, at, notes).map(|spot| spot.at)
    };
    let start = named("start", notes);
    let has = |name: &str| element.child(name).is_some();
    if !has("center") && has("end") && (has("radius") || has("curvature")) {
        let end = named("end", notes);
        return by_radius([start?, end?], element, notes);
    }
    let center = named("center", notes);
    let end = if has("end") {
        Some(named("end", notes)?)
    } else {
        None
    };
    let sign = direction(element, notes)?;
    let (center, start) = (center?, start?);
    let angle = |p: [f64; 2]| (p[1] - center[1]).atan2(p[0] - center[0]);
    let Some(end) = end else {
        let (given, _) = element.required("angle", notes)?;
        let [sweep] = given.numbers::<1>(notes)?;
        let sweep = sweep.to_radians().clamp(-TAU, TAU);
        return Some(points(center, start, sign * sweep));
    };
    let radii = [start, end].map(|point| distance(point, center));
    if (radii[0] - radii[1]).abs() > SAME * radii[0].max(radii[1]) {
        let found = format!("{} and {}", radii[0], radii[1]);
        let expected = "equal distances of start and end from the center";
        notes.wrong(
            element,
            [
                &element.shown(),
                &found,
                expected,
                "correct one of the points",
            ],
        );
        return None;
    }
    let sweep = (sign * (angle(end) - angle(start))).rem_euclid(TAU);
    let mut line = points(center, start, sign * if sweep < 1e-9 { TAU } else { sweep });
    let last = line.points.len() - 1;
    line.points[last] = end;
    Some(line)
}

/// An arc of a radius or curvature between two points. With the default side and direction its
/// center is on the left of the way from start to end.
fn by_radius(ends: [[f64; 2]; 2], element: Element<'_>, notes: &mut Notes) -> Option<Line> {
    let curvature = match (element.child("radius"), element.child("curvature")) {
        (Some(radius), _) => 1.0 / positive(radius, notes)?,
        (None, Some(curvature)) => curvature.numbers::<1>(notes)?[0],
        (None, None) => return None,
    };
    let mut sign = direction(element, notes)?;
    if let Some(side) = element.child("side") {
        let found = word(side, &side.shown(), &side.text(), &["right", "left"], notes)?;
        if found == 1 {
            let help = "give the center of the arc, or exchange its ends";
            notes.wrong(side, [&side.shown(), "\"left\"", "\"right\"", help]);
            return None;
        }
    }
    let [start, end] = ends;
    if curvature == 0.0 {
        let kind = Kind::Straight;
        return Some(Line {
            points: vec![start, end],
            kind,
        });
    }
    let left = curvature.signum();
    sign *= left;
    let (radius, chord) = (1.0 / curvature.abs(), distance(start, end));
    let square = radius * radius - 0.25 * chord * chord;
    if square < -1e-9 * radius * radius || chord == 0.0 {
        let found = format!("radius {radius}");
        let expected = format!("half the distance of its ends, {}, or more", 0.5 * chord);
        notes.wrong(
            element,
            [&element.shown(), &found, &expected, "a larger radius"],
        );
        return None;
    }
    let away = left * square.max(0.0).sqrt() / chord;
    let d = [end[0] - start[0], end[1] - start[1]];
    let center = [
        start[0] + 0.5 * d[0] - away * d[1],
        start[1] + 0.5 * d[1] + away * d[0],
    ];
    let angle = |p: [f64; 2]| (p[1] - center[1]).atan2(p[0] - center[0]);
    let sweep = (sign * (angle(end) - angle(start))).rem_euclid(TAU);
    let mut line = points(center, start, sign * sweep);
    let last = line.points.len() - 1;
    line.points[last] = end;
    Some(line)
}
