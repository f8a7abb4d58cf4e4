//! Straight base lines, lines of other lines, and points on lines.

use shared_geom::error::shortened;

use super::super::Points;
use super::super::files::{Element, Notes};
use super::{Geometry, Kind, Line, Spot, extent};
use crate::mesh::distance;

/// A line through points, or through one point at an angle.
pub(super) fn straight<'x>(
    geometry: &mut Geometry<'x>,
    element: Element<'x>,
    notes: &mut Notes,
) -> Option<Line> {
    if element.child("points").is_none() && element.child("angle").is_some() {
        return endless(geometry, element, notes);
    }
    let (list, text) = element.required("points", notes)?;
    let mut points: Points = Vec::new();
    let mut kind = Kind::Straight;
    let mut is_complete = true;
    for part in text.split(',').map(str::trim) {
        let more = match part.split_once(':') {
            None => geometry.point(part, list, notes).map(|spot| vec![spot.at]),
            Some((from, to)) => {
                kind = Kind::Curve;
                ranged(geometry, [from.trim(), to.trim()], list, notes)
            }
        };
        is_complete &= more.is_some();
        points.extend(more.unwrap_or_default());
    }
    is_complete.then_some(Line { points, kind })
}

/// The points from one name to another: along the line on which they are, or of the list.
fn ranged<'x>(
    geometry: &mut Geometry<'x>,
    names: [&str; 2],
    at: Element<'x>,
    notes: &mut Notes,
) -> Option<Points> {
    let [first, last] = names.map(|name| geometry.point(name, at, notes));
    let (first, last) = (first?, last?);
    match first.on.as_ref().or(last.on.as_ref()) {
        Some((line, _)) => along(geometry, &line.clone(), [&first, &last], at, notes),
        None => geometry.range(names, at, notes),
    }
}

/// The part of a line between two of its points, in its direction.
fn along<'x>(
    geometry: &mut Geometry<'x>,
    name: &str,
    ends: [&Spot; 2],
    at: Element<'x>,
    notes: &mut Notes,
) -> Option<Points> {
    let line = geometry.line(name, at, notes)?;
    let own = |spot: &Spot| spot.on.as_ref().filter(|on| on.0 == name).map(|on| on.1);
    let places = ends.map(|spot| own(spot).or_else(|| place(&line, spot.at)));
    let [Some(from), Some(to)] = places else {
        let what = format!("the range of {}", at.text());
        let expected = format!("two points of the line \"{name}\"");
        notes.wrong(
            at,
            [
                &what,
                "a point that is not on the line",
                &expected,
                "use on=\"...\"",
            ],
        );
        return None;
    };
    let count = line.points.len() - 1;
    let last = count as f64;
    let is_closed = line.is_closed();
    let to = if to <= from && is_closed {
        to + last
    } else {
        to
    };
    if to < from {
        let what = format!("the range of {}", at.text());
        let help = "exchange the points, or reverse the line";
        notes.wrong(
            at,
            [
                &what,
                "its end before its start",
                "points along the line",
                help,
            ],
        );
        return None;
    }
    let between = (from.floor() as usize + 1)..(to.ceil() as usize);
    let between = between.map(|i| line.points[if is_closed { i % count } else { i.min(count) }]);
    Some(
        [ends[0].at]
            .into_iter()
            .chain(between)
            .chain([ends[1].at])
            .collect(),
    )
}

/// The place of a point on a line; `None` if it is not on it.
fn place(line: &Line, point: [f64; 2]) -> Option<f64> {
    let near = 1e-7 * extent(&line.points);
    let mut segments = line.points.windows(2).enumerate();
    segments.find_map(|(i, ends)| {
        let d = [0, 1].map(|k| ends[1][k] - ends[0][k]);
        let square = d[0] * d[0] + d[1] * d[1];
        let part = (0..2).map(|k| (point[k] - ends[0][k]) * d[k]).sum::<f64>() / square;
        let part = part.clamp(0.0, 1.0);
        let foot = [0, 1].map(|k| ends[0][k] + part * d[k]);
        (distance(foot, point) <= near).then_some(i as f64 + part)
    })
}

/// The line through a point at an angle from x2, directed upward, or to the right.
fn endless<'x>(
    geometry: &mut Geometry<'x>,
    element: Element<'x>,
    notes: &mut Notes,
) -> Option<Line> {
    let (point, name) = element.required("point", notes)?;
    let angle = element.child("angle")?.numbers::<1>(notes);
    if let Some(place) = point.attribute("loc").filter(|place| *place != "inner") {
        let found = format!("\"{place}\"");
        let help = "a web reaches from one side to the other";
        notes.wrong(point, ["loc", &found, "\"inner\"", help]);
        return None;
    }
    let at = geometry.point(&name, point, notes)?.at;
    let (sine, cosine) = angle?[0].to_radians().sin_cos();
    let is_down = sine < -1e-12 || (sine.abs() <= 1e-12 && cosine < 0.0);
    let sign = if is_down { -1.0 } else { 1.0 };
    let ahead = [at[0] + sign * cosine, at[1] + sign * sine];
    let kind = Kind::Endless;
    Some(Line {
        points: vec![at, ahead],
        kind,
    })
}

/// The lines that an element names, one after the other.
pub(super) fn joined<'x>(
    geometry: &mut Geometry<'x>,
    element: Element<'x>,
    notes: &mut Notes,
) -> Option<Line> {
    let mut points: Points = Vec::new();
    let mut kind = Kind::Straight;
    for part in element
        .children()
        .filter(|one| matches!(one.name(), "line" | "baseline"))
    {
        let line = geometry.line(&part.text(), part, notes)?;
        if line.kind != Kind::Straight {
            kind = Kind::Curve;
        }
        let mut more = line.points.clone();
        if let Some(end) = points.last() {
            if distance(*end, more[0]) > distance(*end, more[more.len() - 1]) {
                more.reverse();
            }
            let gap = distance(*end, more[0]);
            if gap > 1e-6 * extent(&more) {
                let what = format!("line \"{}\" of {}", part.text(), element.shown());
                let found = format!("a gap of {gap:.3e}");
                let expected = "an end at the end of the line before it";
                notes.wrong(
                    part,
                    [&what, &found, expected, "list the lines in their order"],
                );
                return None;
            }
        }
        points.extend(more);
    }
    if points.is_empty() {
        let help = "write <line>NAME</line> for each of them";
        notes.wrong(
            element,
            [&element.shown(), "no lines", "the names of lines", help],
        );
        return None;
    }
    Some(Line { points, kind })
}

/// A point as written: coordinates, on a line, or between two points.
pub(super) fn spot<'x>(
    geometry: &mut Geometry<'x>,
    element: Element<'x>,
    notes: &mut Notes,
) -> Option<Spot> {
    match element.attribute("constraint").unwrap_or("none") {
        "none" | "" => {}
        "middle" => return middle(geometry, element, notes),
        other => {
            let found = format!("\"{}\"", shortened(other));
            let help = "give its coordinates";
            notes.wrong(
                element,
                ["constraint of a point", &found, "\"middle\"", help],
            );
            return None;
        }
    }
    let Some(name) = element.attribute("on") else {
        let at = element.numbers::<2>(notes)?;
        return Some(Spot { at, on: None });
    };
    on_line(geometry, name, element, notes)
}

/// The point of a line at a coordinate x2: the uppermost one, or the lowest one.
fn on_line<'x>(
    geometry: &mut Geometry<'x>,
    name: &str,
    element: Element<'x>,
    notes: &mut Notes,
) -> Option<Spot> {
    let by = element.attribute("by").unwrap_or("x2");
    if !matches!(by, "x2" | "y") {
        let found = format!("\"{}\"", shortened(by));
        notes.wrong(
            element,
            ["by of a point", &found, "\"x2\"", "give its coordinate x2"],
        );
        return None;
    }
    let line = geometry.line(name, element, notes)?;
    let [value] = element.numbers::<1>(notes)?;
    let mut found = crossings(&line, value);
    let which = element.attribute("which").unwrap_or("top");
    let sign = match which {
        "top" => -1.0,
        "bottom" => 1.0,
        _ => {
            let found = format!("\"{}\"", shortened(which));
            let help = "the surfaces of the line at this x2";
            notes.wrong(element, ["which", &found, "\"top\" or \"bottom\"", help]);
            return None;
        }
    };
    found.sort_by(|a, b| (sign * a.1[1]).total_cmp(&(sign * b.1[1])));
    let Some((place, at)) = found.first().copied() else {
        let what = format!("{} on line \"{name}\"", element.shown());
        let range = |pick: fn(f64, f64) -> f64, start: f64| {
            line.points.iter().map(|point| point[0]).fold(start, pick)
        };
        let (low, high) = (
            range(f64::min, f64::INFINITY),
            range(f64::max, f64::NEG_INFINITY),
        );
        let expected = format!("x2 from {low} to {high}");
        let help = "coordinates are those before <translate>, <scale> and <rotate>";
        notes.wrong(element, [&what, &format!("x2 = {value}"), &expected, help]);
        return None;
    };
    let on = Some((name.to_owned(), place));
    Some(Spot { at, on })
}

/// The places and points of a line at a coordinate x2.
fn crossings(line: &Line, value: f64) -> Vec<(f64, [f64; 2])> {
    let mut found = Vec::new();
    for (i, ends) in line.points.windows(2).enumerate() {
        let [a, b] = [ends[0][0] - value, ends[1][0] - value];
        if a * b > 0.0 || a == b {
            continue;
        }
        let part = a / (a - b);
        let z = ends[0][1] + part * (ends[1][1] - ends[0][1]);
        found.push((i as f64 + part, [value, z]));
    }
    found
}

/// The middle of two points.
fn middle<'x>(
    geometry: &mut Geometry<'x>,
    element: Element<'x>,
    notes: &mut Notes,
) -> Option<Spot> {
    let text = element.text();
    let names: Vec<&str> = text
        .split([',', ' '])
        .filter(|name| !name.is_empty())
        .collect();
    let [first, last] = names[..] else {
        let found = format!("\"{}\"", shortened(&text));
        let help = "separate the names by a blank";
        notes.wrong(
            element,
            [&element.shown(), &found, "the names of two points", help],
        );
        return None;
    };
    let [first, last] = [first, last].map(|name| geometry.point(name, element, notes));
    let ends = [first?.at, last?.at];
    let at = [0, 1].map(|i| 0.5 * (ends[0][i] + ends[1][i]));
    Some(Spot { at, on: None })
}
