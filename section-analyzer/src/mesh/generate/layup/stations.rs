//! The stations along the contour at which columns of cells stand.
//!
//! Fixed stations are the ends, the nose, the corners, the middle of a base that is a wall, the
//! boundaries of webs and, in pairs, the forks of contacts. The ends of ramps are stations, or have one near on both
//! sides, so that layers have their areas. The places at which layers are cut are stations
//! unless a fixed one is near. The rest is divided by the length of cells
//! and the turn of the surface; between a web's boundaries nothing is divided.

use super::super::spacing::Progress;
use super::column::Toward;
use super::kinks::{Kink, NEAR, beside};
use super::pairs::Pair;
use super::remedies::FINE;
use super::wall::{Edge, Wall};
use super::webs::Standing;

/// Largest turn of the surface along a cell \[rad\]: 8 degrees.
const TURN: f64 = 0.14;
/// Part of the distance of a station beside a corner within which another one takes its place.
const NEAR_CORNER: f64 = 0.3;
/// Part of the contour, and of x, within which stations are one.
const SAME: f64 = 1e-10;
/// Round-off of a number of cells.
const ROUND_OFF: f64 = 1e-6;
/// Samples of the density of stations in an interval.
const SAMPLES: usize = 24;

/// A station.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Station {
    /// Arc length.
    pub s: f64,
    /// Number of its pair.
    pub pair: Option<usize>,
}

/// The stations of a wall.
#[derive(Debug, Clone)]
pub(in super::super) struct Stations {
    /// In the order of the contour. On a ring the last one is the first one again, one
    /// length of the contour further.
    pub all: Vec<Station>,
    /// The pairs, and the lean of their columns.
    pub pairs: Vec<(Pair, Toward)>,
}

/// A mark along x.
#[derive(Debug, Clone, Copy)]
struct Mark {
    at: f64,
    kind: Kind,
}

/// Kind of a mark.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// It is a station.
    Fixed,
    /// It is a station, or has one on both sides within this distance.
    Kink(f64),
    /// It is a station unless another is near.
    Soft,
}

/// The stations of a wall with its webs.
pub(super) fn stations(wall: &Wall, webs: &[Standing]) -> Stations {
    let perimeter = wall.outline.perimeter();
    let same = SAME * perimeter;
    let mut pairs = Vec::new();
    let mut fixed: Vec<Station> = Vec::new();
    for zone in &wall.zones {
        for mark in zone_marks(wall, webs, *zone) {
            let s = [0, 1].map(|side| wall.pairs.at(side, mark.at));
            let pair = Some(pairs.len());
            let lean = wall.toward_at(mark.at).unwrap_or(Toward::NONE);
            pairs.push((wall.pairs.between(s), lean));
            // both points are one at the nose, but for round-off
            let is_nose = s[1] - s[0] <= same;
            let nose = Some(wall.outline.nose()).filter(|_| is_nose);
            let points = s.into_iter().filter(|_| !is_nose).chain(nose);
            fixed.extend(points.map(|s| Station { s, pair }));
        }
    }
    let single = |s: f64| Station { s, pair: None };
    let mut singles = vec![wall.outline.nose()];
    singles.extend(wall.outline.breaks().iter().map(|corner| corner.s));
    if wall.edge != Edge::Smooth {
        singles.extend(wall.ends);
    }
    // both sides meet in the middle of the base, where angles of fibers turn around
    singles.extend(wall.edge.is_ring().then_some(0.0));
    let of_webs = webs.iter().flat_map(|web| web.stations.iter().flatten());
    singles.extend(of_webs);
    let is_new = |s: &f64, fixed: &[Station]| fixed.iter().all(|known| (known.s - s).abs() > same);
    for s in singles {
        if is_new(&s, &fixed) {
            fixed.push(single(s));
        }
    }
    let mut all = fixed.clone();
    for kink in wall.stack.kinks() {
        let is_free = |s| zone_of(wall, s).is_none() && !is_under(webs, s, 0.0);
        if !is_free(kink.s) || !is_inside(wall, kink.s) {
            continue;
        }
        let known = all.iter().map(|known| from_to(wall, kink.s, known.s));
        let by = beside(known, kink.near, same);
        let s = by.map(|by| turned(wall, kink.s + by));
        let s = s.filter(|s| is_free(*s) && is_inside(wall, *s));
        all.extend(s.map(single));
    }
    add_beside_corners(wall, webs, &mut all);
    all.sort_by(|a, b| a.s.total_cmp(&b.s));
    if wall.edge.is_ring() {
        let first = all[0];
        all.push(Station {
            s: first.s + perimeter,
            ..first
        });
    }
    Stations {
        all: divided(wall, webs, &all),
        pairs,
    }
}

/// Adds stations beside the corners of a box, where no other ones are near.
fn add_beside_corners(wall: &Wall, webs: &[Standing], all: &mut Vec<Station>) {
    for (s, near) in beside_corners(wall) {
        let is_far = |known: &Station| from_to(wall, s, known.s).abs() > near;
        let is_free = zone_of(wall, s).is_none() && !is_under(webs, s, near);
        if is_free && is_inside(wall, s) && all.iter().all(is_far) {
            all.push(Station { s, pair: None });
        }
    }
}

/// Places beside the corners of a box, where the stress changes over the thickness T of the wall: at T, 2 T,
/// 4 T and so on from each corner, as far as cells would be longer; with the distance within which another
/// station takes their place. None at the trailing edge of a contour without other corners.
fn beside_corners(wall: &Wall) -> Vec<(f64, f64)> {
    let corners = wall.mitres.iter().map(|mitre| mitre.s);
    let corners = corners.filter(|_| !wall.outline.breaks().is_empty());
    let beside = corners.flat_map(|corner| {
        let first = wall.stack.total(corner);
        let ways = std::iter::successors(Some(first), |way| Some(2.0 * way));
        let ways = ways.take_while(|way| *way > 0.0 && *way < 0.75 * wall.size);
        ways.flat_map(move |way| [-way, way].map(|by| (corner + by, NEAR_CORNER * way)))
    });
    beside.map(|(s, near)| (turned(wall, s), near)).collect()
}

fn is_inside(wall: &Wall, s: f64) -> bool {
    wall.edge.is_ring() || (s > wall.ends[0] && s < wall.ends[1])
}

/// Length along the contour from one point to another; on a ring the shorter one.
fn from_to(wall: &Wall, a: f64, b: f64) -> f64 {
    let perimeter = wall.outline.perimeter();
    if wall.edge.is_ring() {
        (b - a + 0.5 * perimeter).rem_euclid(perimeter) - 0.5 * perimeter
    } else {
        b - a
    }
}

/// The arc length of a point of a ring, from 0 to the length of the contour.
fn turned(wall: &Wall, s: f64) -> f64 {
    if wall.edge.is_ring() {
        s.rem_euclid(wall.outline.perimeter())
    } else {
        s
    }
}

fn side(wall: &Wall, s: f64) -> usize {
    usize::from(s > wall.outline.nose())
}

/// The zone of pairs around a point of the contour.
fn zone_of(wall: &Wall, s: f64) -> Option<[f64; 2]> {
    let corners = wall.outline.corners();
    if wall.edge == Edge::Smooth || s < corners[0] || s > corners[1] {
        return None;
    }
    let x = wall.pairs.x(side(wall, s), s);
    wall.zones
        .iter()
        .copied()
        .find(|zone| x >= zone[0] && x <= zone[1])
}

/// Whether the foot of a web is around a point of the contour, or nearer than a length.
fn is_under(webs: &[Standing], s: f64, near: f64) -> bool {
    let is_under = |web: &Standing| {
        (0..2).any(|side| {
            let [low, high] = web.range(side);
            s > low - near && s < high + near
        })
    };
    webs.iter().any(is_under)
}

/// The x of the pairs of a zone.
fn zone_marks(wall: &Wall, webs: &[Standing], [from, to]: [f64; 2]) -> Vec<Mark> {
    let mut marks = Vec::new();
    let is_in = |x: f64| x >= from && x <= to;
    let mark = |at: f64, kind: Kind| Mark { at, kind };
    for contact in wall.contacts.iter().filter(|one| is_in(one[0])) {
        marks.extend(contact.map(|x| mark(x, Kind::Fixed)));
        let before = wall.stretched_from(contact[0]);
        marks.extend(before.map(|before| mark(before, Kind::Fixed)));
        marks.extend(
            wall.pairs
                .cuts(&wall.stack, *contact)
                .into_iter()
                .map(|x| mark(x, Kind::Soft)),
        );
    }
    let kinks = wall.stack.kinks();
    let kinks = kinks.iter().filter(|kink| zone_of(wall, kink.s).is_some());
    let x = |s: f64| wall.pairs.x(side(wall, s), s);
    let mut kinks: Vec<(f64, f64)> = kinks.map(|kink| (kink.near, x(kink.s))).collect();
    kinks.sort_by(|a, b| Kink::order(*a, *b));
    let kinks = kinks.into_iter().filter(|(_, at)| is_in(*at));
    marks.extend(kinks.map(|(near, at)| mark(at, Kind::Kink(near / wall.pairs.scale()))));
    let fan = wall.pairs.fan().filter(|end| is_in(*end));
    marks.extend(fan.map(|end| mark(end, Kind::Fixed)));
    let last = if to >= 1.0 { Kind::Fixed } else { Kind::Soft };
    marks.extend([mark(from, Kind::Soft), mark(to, last)]);
    let scale = wall.size / wall.pairs.scale();
    let size = wall.size * wall.fineness([from, to]);
    let mut marks = divided_zone(wall, size, &thinned(marks, NEAR * scale));
    let is_free = |mark: &Mark| {
        let near = match mark.kind {
            Kind::Fixed => return true,
            Kind::Kink(near) => near * wall.pairs.scale(),
            Kind::Soft => NEAR * wall.size,
        };
        let mut places = (0..2).map(|side| wall.pairs.at(side, mark.at));
        !places.any(|s| is_under(webs, s, near))
    };
    marks.retain(is_free);
    marks
}

/// Marks in order, without soft ones near others, and without doubled ones.
fn thinned(marks: Vec<Mark>, near: f64) -> Vec<Mark> {
    let mut kept: Vec<Mark> = Vec::new();
    let of = |is_kind: fn(&Mark) -> bool| marks.iter().copied().filter(is_kind);
    let fixed = of(|mark| mark.kind == Kind::Fixed);
    let kinks = of(|mark| matches!(mark.kind, Kind::Kink(_)));
    let soft = of(|mark| mark.kind == Kind::Soft);
    for mark in fixed.chain(kinks).chain(soft) {
        let known = kept.iter().map(|known| known.at - mark.at);
        let by = match mark.kind {
            Kind::Fixed => known.map(f64::abs).all(|other| other > SAME).then_some(0.0),
            Kind::Kink(near) => beside(known, near, SAME),
            Kind::Soft => known.map(f64::abs).all(|other| other > near).then_some(0.0),
        };
        kept.extend(by.map(|by| Mark {
            at: mark.at + by,
            ..mark
        }));
    }
    kept.sort_by(|a, b| a.at.total_cmp(&b.at));
    kept
}

/// The marks of a zone with those between them.
fn divided_zone(wall: &Wall, size: f64, marks: &[Mark]) -> Vec<Mark> {
    let mut all = Vec::new();
    for pair in marks.windows(2) {
        all.push(pair[0]);
        let [from, to] = [pair[0].at, pair[1].at];
        let length = |side: usize| (wall.pairs.at(side, from) - wall.pairs.at(side, to)).abs();
        let cells = (length(0).max(length(1)) / size).max(turn_ahead(wall, [from, to]) / TURN);
        // a ramp may be exactly as long as a cell
        let cells = (cells - ROUND_OFF).ceil().max(1.0);
        all.extend((1..cells as usize).map(|i| Mark {
            at: from + (to - from) * i as f64 / cells,
            kind: Kind::Soft,
        }));
    }
    all.extend(marks.last());
    all
}

/// The larger turn of both surfaces between two x, with circles ahead; 0 without them.
fn turn_ahead(wall: &Wall, ends: [f64; 2]) -> f64 {
    if wall.pairs.fan().is_none() {
        return 0.0;
    }
    let turn = |side: usize| {
        let [a, b] = ends.map(|x| wall.outline.inward(wall.pairs.at(side, x)));
        (a[0] * b[1] - a[1] * b[0])
            .atan2(a[0] * b[0] + a[1] * b[1])
            .abs()
    };
    turn(0).max(turn(1))
}

/// Stations with those that divide the intervals between them.
fn divided(wall: &Wall, webs: &[Standing], marks: &[Station]) -> Vec<Station> {
    let mut all = Vec::new();
    for pair in marks.windows(2) {
        all.push(pair[0]);
        let [from, to] = [pair[0].s, pair[1].s];
        let middle = (0.5 * (from + to)).rem_euclid(wall.outline.perimeter());
        let is_paired = pair[0].pair.is_some() && pair[1].pair.is_some();
        let is_contact = || is_paired && wall.column(middle).is_closed;
        if is_under(webs, middle, 0.0) || is_contact() {
            continue;
        }
        all.extend(
            between(wall, from, to)
                .into_iter()
                .map(|s| Station { s, pair: None }),
        );
    }
    all.extend(marks.last());
    all
}

/// Stations that divide an interval by lengths and turns.
fn between(wall: &Wall, from: f64, to: f64) -> Vec<f64> {
    let perimeter = wall.outline.perimeter();
    let step = (to - from) / SAMPLES as f64;
    let density = |i: usize| {
        let s = (from + step * (i as f64 + 0.5)).rem_euclid(perimeter);
        let part = if wall.is_fine(s) { FINE } else { 1.0 };
        (1.0 / (part * wall.size)).max(wall.outline.bend(s).abs() / TURN)
    };
    let densities: Vec<f64> = (0..SAMPLES).map(density).collect();
    let progress = Progress::new([from, to], &densities);
    let whole = progress.whole();
    let cells = (whole - 1e-9).ceil().clamp(1.0, 1e5);
    let at = |i: usize| progress.place(whole * i as f64 / cells);
    (1..cells as usize).map(at).collect()
}
