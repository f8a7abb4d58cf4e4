//! Ends of webs on the inner face of the wall.
//!
//! The boundaries of the plies of a web are parallels to the line between its two points
//! A and B of the contour. The inner ends X of the columns at the arc lengths s with
//!
//! ```text
//! (X(s) - A) . e = o,    e the unit normal of the line, o the offset of the boundary,
//! ```
//!
//! are nodes of the web, so that web and wall share their nodes.

use super::super::bisect::bisect;
use super::kinks::{Kink, beside};
use super::line::Line;
use super::problem::{LayupProblem, Upright};
use super::types::{Bound, LayupSection, SIDES, Web};
use super::wall::{Edge, Wall};

/// Samples of the inner face of each side.
const SAMPLES: usize = 240;
/// Part of the size of cells that a column of a web is wide at most.
const WIDEST: f64 = 0.6;
/// Part of the contour around the nose that may be on either side.
const AT_NOSE: f64 = 0.01;

/// A web, or a line that bounds a fill, on the inner faces.
#[derive(Debug, Clone)]
pub(super) struct Standing {
    /// The web; a line that bounds a fill has the name of the fill, and no plies.
    pub web: Web,
    /// The ply between each boundary and the next one.
    pub plies: Vec<usize>,
    /// Arc lengths of the boundaries on both sides, the foremost first.
    pub stations: [Vec<f64>; 2],
    line: Line,
    /// Whether it is the outer face of the web of a spar, whose cells the spar has.
    pub is_spar: bool,
}

impl Standing {
    /// Distance of a point from the middle of the web, positive ahead of it.
    pub fn offset(&self, point: [f64; 2]) -> f64 {
        self.line.offset(point)
    }

    /// Whether it is a web, and not only a line.
    pub fn is_web(&self) -> bool {
        self.is_spar || !self.plies.is_empty()
    }

    fn upright(&self) -> Upright {
        if self.is_spar {
            Upright::Web(self.web.name.clone())
        } else {
            upright(&self.web)
        }
    }

    /// The arc lengths between which it meets a side.
    pub fn range(&self, side: usize) -> [f64; 2] {
        let stations = &self.stations[side];
        let (first, last) = (stations[0], stations[stations.len() - 1]);
        [first.min(last), first.max(last)]
    }
}

fn upright(web: &Web) -> Upright {
    let name = web.name.clone();
    if web.plies.is_empty() {
        Upright::Bound(name)
    } else {
        Upright::Web(name)
    }
}

/// The webs with plies, and the lines that bound fills.
fn uprights(section: &LayupSection) -> Vec<Web> {
    let is_inside = |web: &&Web| !web.plies.is_empty() && !web.is_at_edge();
    let webs = section.webs.iter().filter(is_inside);
    let mut all: Vec<Web> = webs.cloned().collect();
    for fill in &section.fills {
        for bound in [&fill.ahead_of, &fill.aft_of].into_iter().flatten() {
            let Bound::Line(arcs) = bound else {
                continue;
            };
            let is_known = |web: &Web| web.plies.is_empty() && web.arcs == *arcs;
            if !all.iter().any(is_known) {
                all.push(Web {
                    name: fill.name.clone(),
                    arcs: *arcs,
                    plies: Vec::new(),
                });
            }
        }
    }
    all
}

/// The inner face of a side: arc lengths and inner ends of columns.
type Face = Vec<(f64, [f64; 2])>;

/// A web during the search.
struct Search<'a> {
    web: &'a Web,
    wall: &'a Wall,
    faces: &'a [Face; 2],
    line: Line,
}

/// The webs of a section, and the lines that bound its fills, on its wall.
pub(super) fn stand(section: &LayupSection, wall: &Wall) -> Result<Vec<Standing>, LayupProblem> {
    let uprights = uprights(section);
    let of_spar = wall.spar.iter().flat_map(|spar| &spar.webs);
    let of_spar = of_spar.map(|web| Standing {
        web: Web {
            name: web.name.clone(),
            arcs: web.arcs,
            plies: Vec::new(),
        },
        plies: Vec::new(),
        stations: web.corners.map(|s| vec![s]),
        line: web.line,
        is_spar: true,
    });
    let mut all: Vec<Standing> = of_spar.collect();
    if uprights.is_empty() {
        return Ok(all);
    }
    let nose = wall.outline.nose();
    let faces = [0, 1].map(|side| {
        let s = |i: usize| wall.ends[side] + (nose - wall.ends[side]) * i as f64 / SAMPLES as f64;
        (0..=SAMPLES)
            .map(|i| (s(i), wall.column(s(i)).inner()))
            .collect()
    });
    for web in &uprights {
        check_sides(web, nose / wall.outline.perimeter())?;
        let points = web
            .arcs
            .map(|arc| wall.outline.position(arc * wall.outline.perimeter()));
        let search = Search {
            web,
            wall,
            faces: &faces,
            line: Line::between(points),
        };
        all.push(search.standing()?);
    }
    check_order(&all)?;
    Ok(all)
}

impl Search<'_> {
    fn standing(&self) -> Result<Standing, LayupProblem> {
        let (offsets, plies) = self.boundaries();
        let mut standing = Standing {
            web: self.web.clone(),
            plies,
            stations: [self.stations(0, &offsets)?, self.stations(1, &offsets)?],
            line: self.line,
            is_spar: false,
        };
        let added = self.added(&standing, &offsets);
        if !added.is_empty() {
            let mut pairs: Vec<(f64, usize)> = offsets
                .iter()
                .copied()
                .zip(standing.plies.iter().copied())
                .collect();
            for offset in added {
                let at = pairs.partition_point(|pair| pair.0 > offset);
                pairs.insert(at, (offset, pairs[at - 1].1));
            }
            let mut offsets_now: Vec<f64> = pairs.iter().map(|pair| pair.0).collect();
            offsets_now.push(offsets[offsets.len() - 1]);
            standing.plies = pairs.into_iter().map(|pair| pair.1).collect();
            standing.stations = [
                self.stations(0, &offsets_now)?,
                self.stations(1, &offsets_now)?,
            ];
        }
        self.check_contacts(&standing)?;
        Ok(standing)
    }

    /// Offsets of the boundaries of cells, the foremost first, and the ply behind each.
    fn boundaries(&self) -> (Vec<f64>, Vec<usize>) {
        let total: f64 = self.web.plies.iter().map(|ply| ply.thickness).sum();
        let mut offset = 0.5 * total;
        let (mut offsets, mut plies) = (vec![offset], Vec::new());
        for (number, ply) in self.web.plies.iter().enumerate() {
            let cells = (ply.thickness / (WIDEST * self.wall.size))
                .ceil()
                .clamp(1.0, 20.0);
            for i in 1..=cells as usize {
                offsets.push(offset - ply.thickness * i as f64 / cells);
                plies.push(number);
            }
            offset -= ply.thickness;
        }
        (offsets, plies)
    }

    fn offset(&self, point: [f64; 2]) -> f64 {
        self.line.offset(point)
    }

    /// Offsets of the ends of ramps under the feet, which become boundaries.
    fn added(&self, standing: &Standing, offsets: &[f64]) -> Vec<f64> {
        let same = 1e-10 * self.wall.outline.perimeter();
        let is_within = |offset: &f64| *offset < offsets[0] && *offset > offsets[offsets.len() - 1];
        let kinks = self.wall.stack.kinks();
        let mut found: Vec<(f64, f64)> = Vec::new();
        for side in 0..2 {
            let [low, high] = standing.range(side);
            let inside = kinks.iter().filter(|kink| kink.s > low && kink.s < high);
            let offset = |s: f64| self.offset(self.wall.column(s).inner());
            found.extend(inside.map(|kink| (kink.near, offset(kink.s))));
        }
        found.sort_by(|a, b| Kink::order(*a, *b));
        let mut added: Vec<f64> = Vec::new();
        for (near, offset) in found {
            let known = offsets.iter().chain(&added).map(|other| other - offset);
            let by = beside(known, near, same).filter(|_| is_within(&offset));
            added.extend(by.map(|by| offset + by).filter(is_within));
        }
        added
    }

    /// Arc lengths of boundaries on a side.
    fn stations(&self, side: usize, offsets: &[f64]) -> Result<Vec<f64>, LayupProblem> {
        let outside = || LayupProblem::WebOutside {
            web: upright(self.web),
            side: SIDES[side],
            arc: self.web.arcs[side],
        };
        let stations: Option<Vec<f64>> = offsets
            .iter()
            .map(|offset| self.station(side, *offset))
            .collect();
        let stations = stations.ok_or_else(outside)?;
        let sign = [-1.0, 1.0][side];
        let least = 1e-9 * self.wall.outline.perimeter();
        let is_in_order = stations
            .windows(2)
            .all(|pair| sign * (pair[1] - pair[0]) > least);
        if is_in_order {
            Ok(stations)
        } else {
            Err(outside())
        }
    }

    /// The station of a boundary that is nearest to the web.
    fn station(&self, side: usize, offset: f64) -> Option<f64> {
        let face = &self.faces[side];
        let near = self.web.arcs[side] * self.wall.outline.perimeter();
        let off = |point: [f64; 2]| self.offset(point) - offset;
        let crossings = face
            .windows(2)
            .filter(|pair| (off(pair[0].1) > 0.0) != (off(pair[1].1) > 0.0));
        let nearest =
            crossings.min_by(|a, b| (a[0].0 - near).abs().total_cmp(&(b[0].0 - near).abs()))?;
        let is_ahead = |s: f64| off(self.wall.column(s).inner()) > 0.0;
        let ends = [nearest[0].0, nearest[1].0];
        Some(bisect(ends, off(nearest[0].1) > 0.0, is_ahead))
    }

    /// Refuses feet where the layers of both sides meet.
    fn check_contacts(&self, standing: &Standing) -> Result<(), LayupProblem> {
        if self.wall.edge == Edge::Smooth {
            return Ok(());
        }
        for side in 0..2 {
            let [a, b] = standing.range(side).map(|s| self.wall.pairs.x(side, s));
            let (low, high) = (a.min(b), a.max(b));
            let mut contacts = self.wall.contacts.iter();
            if let Some(contact) = contacts.find(|one| one[0] < high && one[1] > low) {
                let perimeter = self.wall.outline.perimeter();
                let mut arcs = contact.map(|x| self.wall.pairs.at(side, x) / perimeter);
                arcs.sort_by(f64::total_cmp);
                return Err(LayupProblem::WebInContact {
                    web: upright(self.web),
                    side: SIDES[side],
                    arc: self.web.arcs[side],
                    contact: arcs,
                    thickest: self.wall.stack.thickest(self.web.arcs[side] * perimeter),
                });
            }
        }
        Ok(())
    }
}

/// Refuses a web with both places on one side of the arc of the nose.
fn check_sides(web: &Web, nose: f64) -> Result<(), LayupProblem> {
    let beyond = [web.arcs[0] - nose, nose - web.arcs[1]];
    match beyond.iter().position(|beyond| *beyond > AT_NOSE) {
        None => Ok(()),
        Some(side) => Err(LayupProblem::OneSide {
            web: upright(web),
            side: SIDES[side],
            arc: web.arcs[side],
            nose,
        }),
    }
}

/// Refuses webs that overlap or cross.
fn check_order(all: &[Standing]) -> Result<(), LayupProblem> {
    let mut order: Vec<&Standing> = all.iter().collect();
    order.sort_by(|a, b| a.range(0)[0].total_cmp(&b.range(0)[0]));
    for pair in order.windows(2) {
        let webs = || [0, 1].map(|i| pair[i].upright());
        let gaps = [
            pair[1].range(0)[0] - pair[0].range(0)[1],
            pair[0].range(1)[0] - pair[1].range(1)[1],
        ];
        if pair[0].range(1)[1] < pair[1].range(1)[0] {
            return Err(LayupProblem::WebsCross { webs: webs() });
        }
        for (side, gap) in gaps.into_iter().enumerate() {
            if gap <= 0.0 {
                return Err(LayupProblem::WebsOverlap {
                    webs: webs(),
                    side: SIDES[side],
                    overlap: -gap,
                });
            }
        }
    }
    Ok(())
}
