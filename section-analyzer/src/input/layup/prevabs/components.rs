//! Components: segments of base lines with layups.

use std::collections::HashSet;

use shared_geom::error::shortened;
use shared_geom::exchange::text::number;

use super::Points;
use super::files::{Element, Notes, word};
use super::geometry::{Geometry, Kind, Line, Placement};
use super::layups::{Layups, Ply};
use crate::mesh::distance;

/// Difference of places on a line that are one.
const SAME: f64 = 1e-9;
/// Largest coordinate.
const LARGEST: f64 = 1e100;

/// The side of a base line on which a layup lies, walking along the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
    Both,
}

/// A base line with its layup.
#[derive(Debug, Clone)]
pub(super) struct Segment<'x> {
    pub name: String,
    /// Points of the line.
    pub points: Points,
    pub kind: Kind,
    pub side: Side,
    /// Place of the base line in the layup, 0 at its first layer to 1 at its last one.
    pub position: f64,
    /// From the base line on.
    pub plies: Vec<Ply>,
    pub element: Element<'x>,
}

/// Segments that belong together.
#[derive(Debug, Clone)]
pub(super) struct Component<'x> {
    pub segments: Vec<Segment<'x>>,
    pub element: Element<'x>,
}

/// The components of a section.
#[derive(Debug, Clone)]
pub(super) struct List<'x> {
    pub components: Vec<Component<'x>>,
}

impl List<'_> {
    /// The names of the materials of all plies.
    pub fn materials(&self) -> impl Iterator<Item = &str> {
        let segments = self.components.iter().flat_map(|one| &one.segments);
        let plies = segments.flat_map(|segment| &segment.plies);
        plies.map(|ply| ply.material.as_str())
    }

    /// The components with their points in the axes of the section; notes points that are no
    /// finite numbers.
    pub fn placed(mut self, placement: &Placement, notes: &mut Notes) -> Option<Self> {
        for segment in self.components.iter_mut().flat_map(|one| &mut one.segments) {
            let points = &mut segment.points;
            points
                .iter_mut()
                .for_each(|point| *point = placement.at(*point));
            let is_small = |value: &f64| value.abs() < LARGEST;
            if !points.iter().flatten().all(is_small) {
                let what = segment.element.shown();
                let expected = "finite coordinates";
                let help = "compare the points, <translate> and <scale>";
                notes.wrong(
                    segment.element,
                    [&what, "numbers that are too large", expected, help],
                );
                return None;
            }
        }
        Some(self)
    }
}

/// The components of a main file but fills; notes problems and components that are not read.
pub(super) fn read<'x>(
    main: Element<'x>,
    geometry: &mut Geometry<'x>,
    layups: &Layups<'_>,
    notes: &mut Notes,
) -> Option<List<'x>> {
    let mut components = Vec::new();
    let mut is_complete = true;
    let mut names = HashSet::new();
    for element in main.named("component") {
        match element.attribute("type").unwrap_or("laminate") {
            "" | "laminate" => {}
            "fill" => continue,
            kind => {
                let found = format!("type \"{}\"", shortened(kind));
                let expected = "type \"laminate\" or \"fill\"";
                let texts = [&element.shown(), &found, expected, "correct the type"];
                notes.wrong(element, texts);
                is_complete = false;
                continue;
            }
        }
        let mut segments = Vec::new();
        for (i, one) in element.named("segment").enumerate() {
            let read = segment(one, i, geometry, layups, notes);
            is_complete &= read.is_some();
            segments.extend(read);
        }
        for (i, one) in element.named("segments").enumerate() {
            let read = divided(one, i, geometry, layups, notes);
            is_complete &= read.is_some();
            segments.extend(read.unwrap_or_default());
        }
        for segment in &mut segments {
            let mut count = 1;
            let plain = segment.name.clone();
            while !names.insert(segment.name.clone()) {
                count += 1;
                segment.name = format!("{plain}_{count}");
            }
        }
        components.push(Component { segments, element });
    }
    let has_segments = components.iter().any(|one| !one.segments.is_empty());
    if is_complete && !has_segments {
        let help = "write <component> with <segment>, each with <baseline> and <layup>";
        notes.wrong(
            main,
            [&main.shown(), "no segments", "one component or more", help],
        );
    }
    (is_complete && has_segments).then_some(List { components })
}

/// Place and side of a layup; notes problems.
fn place(
    baseline: Element<'_>,
    side: Option<(Element<'_>, String)>,
    notes: &mut Notes,
) -> Option<(f64, Side)> {
    let sides = ["left", "right", "both"];
    let side = match side {
        Some((at, text)) => word(at, "direction of the layup", &text, &sides, notes)?,
        None => 0,
    };
    let position = baseline
        .attribute("position")
        .unwrap_or("begin")
        .to_lowercase();
    let position = match position.as_str() {
        "begin" | "" => Some(0.0),
        "middle" | "center" => Some(0.5),
        "end" => Some(1.0),
        text => number(text).filter(|part| (0.0..=1.0).contains(part)),
    };
    if position.is_none() {
        let found = baseline.attribute("position").unwrap_or_default();
        let expected = "begin, middle, end or a number from 0 to 1";
        let help = "the place of the base line in the layup";
        notes.wrong(baseline, ["position of <baseline>", found, expected, help]);
    }
    Some((position?, [Side::Left, Side::Right, Side::Both][side]))
}

/// The layers of a layup by its name; notes another name.
fn plies(name: &str, at: Element<'_>, layups: &Layups<'_>, notes: &mut Notes) -> Option<Vec<Ply>> {
    let Some(found) = layups.get(name) else {
        let mut names: Vec<&str> = layups.keys().copied().collect();
        names.sort_unstable();
        notes.unknown(at, ["the layup", name], &names);
        return None;
    };
    found.clone()
}

/// A segment of one layup.
fn segment<'x>(
    element: Element<'x>,
    index: usize,
    geometry: &mut Geometry<'x>,
    layups: &Layups<'_>,
    notes: &mut Notes,
) -> Option<Segment<'x>> {
    if let Some(end) = element.attribute("free") {
        let found = format!("free=\"{}\"", shortened(end));
        let help = "layers end on the contour, and webs reach from one side to the other";
        notes.wrong(element, [&element.shown(), &found, "no free end", help]);
        return None;
    }
    let line = element.required("baseline", notes);
    let layup = element.required("layup", notes);
    let (line_at, line_name) = line?;
    let line = geometry.line(&line_name, line_at, notes);
    let (at, name) = layup?;
    let side = at.attribute("direction").map(|text| (at, text.to_owned()));
    let place = place(line_at, side, notes);
    let plies = plies(&name, at, layups, notes);
    let (position, side) = place?;
    let line = line?;
    Some(Segment {
        name: name_of(element, index),
        points: line.points.clone(),
        kind: line.kind,
        side,
        position,
        plies: plies?,
        element,
    })
}

/// The name of a segment, or its component and number.
fn name_of(element: Element<'_>, index: usize) -> String {
    let own = element.attribute("name").filter(|name| !name.is_empty());
    let component = element.parent().and_then(|parent| parent.attribute("name"));
    own.map_or_else(
        || format!("{}_{}", component.unwrap_or("segment"), index + 1),
        str::to_owned,
    )
}

/// A part of a line under a layup.
struct Part {
    from: f64,
    to: f64,
    plies: Vec<Ply>,
}

/// The segments of a line with several layups, each between two parts of its length.
fn divided<'x>(
    element: Element<'x>,
    index: usize,
    geometry: &mut Geometry<'x>,
    layups: &Layups<'_>,
    notes: &mut Notes,
) -> Option<Vec<Segment<'x>>> {
    let (line_at, line_name) = element.required("baseline", notes)?;
    let line = geometry.line(&line_name, line_at, notes)?;
    let side = element.child("layup_side").map(|one| (one, one.text()));
    let (position, side) = place(line_at, side, notes)?;
    let parts = parts(element, line.is_closed(), layups, notes)?;
    let mut ends: Vec<f64> = parts.iter().flat_map(|part| [part.from, part.to]).collect();
    ends.extend([0.0, 1.0]);
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|a, b| (*a - *b).abs() < SAME);
    let mut segments = Vec::new();
    for (i, ends) in ends.windows(2).enumerate() {
        let middle = 0.5 * (ends[0] + ends[1]);
        let here = parts
            .iter()
            .filter(|part| part.from < middle && middle < part.to);
        let plies: Vec<Ply> = here.flat_map(|part| part.plies.clone()).collect();
        if plies.is_empty() {
            let what = format!("{} from {} to {}", element.shown(), ends[0], ends[1]);
            let help = "let a layup cover the whole line";
            notes.wrong(element, [&what, "no layup", "a layup", help]);
            return None;
        }
        segments.push(Segment {
            name: format!("{}_{}", name_of(element, index), i + 1),
            points: cut(&line, [ends[0], ends[1]]),
            kind: line.kind,
            side,
            position,
            plies,
            element,
        });
    }
    Some(segments)
}

/// The layups of a line with their parts of it; notes problems.
fn parts(
    element: Element<'_>,
    is_closed: bool,
    layups: &Layups<'_>,
    notes: &mut Notes,
) -> Option<Vec<Part>> {
    let mut parts: Vec<Part> = Vec::new();
    let mut is_complete = true;
    for at in element.named("layup") {
        let plies = plies(&at.text(), at, layups, notes);
        let (Some(plies), Some([from, to])) = (plies, range(at, is_closed, notes)) else {
            is_complete = false;
            continue;
        };
        // on a closed line a range may go through its end
        let turns = if is_closed { from.floor() } else { 0.0 };
        let (from, to) = (from - turns, to - turns);
        if to > 1.0 + SAME {
            parts.push(Part {
                from: 0.0,
                to: to - 1.0,
                plies: plies.clone(),
            });
        }
        let to = to.min(1.0);
        parts.push(Part { from, to, plies });
    }
    is_complete.then_some(parts)
}

/// First and last part of the length of a line under a layup; notes problems.
fn range(at: Element<'_>, is_closed: bool, notes: &mut Notes) -> Option<[f64; 2]> {
    let value = |name: &str, default: f64| at.attribute(name).map_or(Some(default), number);
    let found = value("begin", 0.0).zip(value("end", 1.0));
    let is_fine = |ends: &(f64, f64)| {
        let width = ends.1 - ends.0;
        let is_on = is_closed || (ends.0 >= 0.0 && ends.1 <= 1.0);
        is_on && width > SAME && width <= 1.0 + SAME && ends.0.abs() < 1e6
    };
    let found = found.filter(is_fine);
    if found.is_none() {
        let text = |name: &str| at.attribute(name).unwrap_or("absent");
        let shown = format!("begin {}, end {}", text("begin"), text("end"));
        let expected = if is_closed {
            "begin before end, at most 1 apart"
        } else {
            "0 <= begin < end <= 1"
        };
        let help = "parts of the length of the base line";
        notes.wrong(at, ["the range of a layup", &shown, expected, help]);
    }
    found.map(|(from, to)| [from, to])
}

/// The points of a line between two parts of its length.
fn cut(line: &Line, [from, to]: [f64; 2]) -> Points {
    let mut sums = vec![0.0];
    for pair in line.points.windows(2) {
        sums.push(sums[sums.len() - 1] + distance(pair[0], pair[1]));
    }
    let length = sums[sums.len() - 1];
    let at = |part: f64| {
        let target = part * length;
        let after = sums
            .partition_point(|sum| *sum <= target)
            .clamp(1, sums.len() - 1);
        let part = (target - sums[after - 1]) / (sums[after] - sums[after - 1]);
        let (a, b) = (line.points[after - 1], line.points[after]);
        [0, 1].map(|i| a[i] + part * (b[i] - a[i]))
    };
    let is_between = |sum: f64| sum > (from + SAME) * length && sum < (to - SAME) * length;
    let between = sums
        .iter()
        .zip(&line.points)
        .filter(|(sum, _)| is_between(**sum));
    let between = between.map(|(_, point)| *point);
    [at(from)]
        .into_iter()
        .chain(between)
        .chain([at(to)])
        .collect()
}
