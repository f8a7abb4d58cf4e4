//! A spar inside of the outer layers, whose layers turn into one web or two.
//!
//! ```text
//!         suction side                     suction side
//!      *---------------.                *------------------.
//!      |  *----------.  \               |  *----------*  |  \
//!      |  |           \  |              |  |          |  |   |
//!      |  *----------'  /               |  *----------*  |  /
//!      *---------------'                *------------------'
//!       aft web                          aft web    fore web
//! ```
//!
//! The layers outside of the spar continue beyond its webs. Columns bend at their inner face, at the
//! depth D, by a lean M, which at a corner is `(n_w . e) / (1 + n_w . n)` with n_w the normal of the
//! outer face of the web and e the direction along the contour into the spar: a node at a corner has
//! one depth below the surface and below the web. Away from the corner M fades as beside a corner
//! of the contour.

use super::super::bisect::zero;
use super::bend::{Bend, Lean, Turn};
use super::feet::feet;
use super::line::Line;
use super::mitre::Fade;
use super::outline::Outline;
use super::problem::{LayupProblem, Upright};
use super::stack::Stack;
use super::types::{SIDES, Spar, SparWeb};

/// Part of the way to the nose, or to the middle between two webs, that a mitre takes at most.
const MOST_OF_WAY: f64 = 0.9;
/// Parts of the contour around the line of a web in which its corners are searched.
const AROUND: f64 = 0.02;

/// The spar of a wall.
#[derive(Debug, Clone)]
pub(in super::super) struct SparWall {
    /// Number of its first layer.
    pub first: usize,
    /// Its aft web; and its fore web, if there is one.
    pub webs: Vec<WebWall>,
}

/// A web of a spar.
#[derive(Debug, Clone)]
pub(in super::super) struct WebWall {
    /// Its name.
    pub name: String,
    /// Arcs of its outer face on both sides [-].
    pub arcs: [f64; 2],
    /// Whether it is the fore one.
    pub is_fore: bool,
    /// Numbers of the layers along it, from the outside in.
    pub layers: Vec<usize>,
    /// Numbers of the layers that continue each of them on both sides.
    pub feet: [Vec<Option<usize>>; 2],
    /// Arc lengths of the columns at its corners.
    pub corners: [f64; 2],
    /// Its outer face.
    pub line: Line,
    /// M at the corners.
    pub leans: [f64; 2],
    turns: [Turn; 2],
    fades: [Fade; 2],
}

/// A corner during its search.
struct Corner<'a> {
    web: &'a SparWeb,
    line: &'a Line,
    is_fore: bool,
    side: usize,
    s: f64,
    /// The end of the way along the surface into the spar: the nose, or the corner of the other web.
    end: (f64, bool),
}

impl SparWall {
    /// The spar on a contour; the layers of `stack` inside of it end at its corners.
    pub fn new(spar: &Spar, outline: &Outline, stack: &mut Stack) -> Result<Self, LayupProblem> {
        let at = |arc: f64| outline.position(arc * outline.perimeter());
        let lines: Vec<Line> = spar
            .webs
            .iter()
            .map(|web| Line::between(web.arcs.map(at)))
            .collect();
        let mut corners = Vec::new();
        for (web, line) in spar.webs.iter().zip(&lines) {
            let corner = |side: usize| {
                let near = web.arcs[side] * outline.perimeter();
                let depth = |s: f64| stack.before(spar.first, s);
                foot(line, outline, depth, (side, near)).ok_or(LayupProblem::WebOutside {
                    web: Upright::Web(web.name.clone()),
                    side: SIDES[side],
                    arc: web.arcs[side],
                })
            };
            corners.push([corner(0)?, corner(1)?]);
        }
        stack.end_inside(corners.clone());
        let mut webs = Vec::new();
        for (number, web) in spar.webs.iter().enumerate() {
            let at = |side: usize| {
                let other = corners.get(1 - number.min(1)).filter(|_| corners.len() > 1);
                Corner {
                    web,
                    line: &lines[number],
                    is_fore: number > 0,
                    side,
                    s: corners[number][side],
                    end: other.map_or((outline.nose(), false), |other| (other[side], true)),
                }
            };
            webs.push(WebWall::new(spar.first, [at(0), at(1)], outline, stack)?);
        }
        let first = spar.first;
        Ok(Self { first, webs })
    }

    /// The bend of the column at an arc length; `None` if it has none.
    pub fn bend(&self, outline: &Outline, stack: &Stack, s: f64) -> Option<Bend> {
        if stack.is_beyond(s) {
            return None;
        }
        for web in &self.webs {
            for side in 0..2 {
                let sign = sign(web.is_fore, side);
                let away = sign * (s - web.corners[side]);
                let lean = Some(away).filter(|x| *x >= 0.0);
                let Some(lean) = lean.and_then(|x| web.fades[side].at(x)) else {
                    continue;
                };
                let (n, depth) = (outline.inward(s), stack.before(self.first, s));
                return Some(Bend {
                    depth,
                    normal: n,
                    direction: [-sign * n[1], sign * n[0]],
                    bend: below(outline.bend(s), depth),
                    lean: Lean::Part(lean / web.leans[side], web.turns[side]),
                });
            }
        }
        None
    }

    /// The web and the side of the corner at an arc length.
    pub fn corner_at(&self, s: f64) -> Option<(&WebWall, usize)> {
        let mut webs = self.webs.iter();
        webs.find_map(|web| Some((web, web.corners.iter().position(|corner| *corner == s)?)))
    }
}

/// Direction along the contour into the spar, at a corner.
fn sign(is_fore: bool, side: usize) -> f64 {
    if is_fore == (side == 0) { -1.0 } else { 1.0 }
}

/// The curvature of a surface below another one.
fn below(bend: f64, depth: f64) -> f64 {
    bend / (1.0 - bend * depth)
}

/// The arc length on a side, near another one, at which the surface at a depth below the contour
/// meets a line.
pub(in super::super) fn foot(
    line: &Line,
    outline: &Outline,
    depth: impl Fn(f64) -> f64,
    (side, near): (usize, f64),
) -> Option<f64> {
    let off = |s: f64| {
        let (p, n) = (outline.position(s), outline.inward(s));
        let depth = depth(s);
        line.offset([0, 1].map(|i| p[i] + depth * n[i]))
    };
    let reach = AROUND * outline.perimeter() + 2.0 * depth(near);
    let toward_nose = [1.0, -1.0][side];
    let [end, nose] = [outline.corners()[side], outline.nose()];
    let within = |s: f64| s.clamp(end.min(nose), end.max(nose));
    let ends = [-reach, reach].map(|by| within(near + toward_nose * by));
    zero(ends, off).filter(|_| off(ends[0]) <= 0.0 && off(ends[1]) >= 0.0)
}

impl WebWall {
    fn new(
        first: usize,
        corners: [Corner<'_>; 2],
        outline: &Outline,
        stack: &Stack,
    ) -> Result<Self, LayupProblem> {
        let (web, line, is_fore) = (corners[0].web, *corners[0].line, corners[0].is_fore);
        let feet = feet(web, first, stack, corners.each_ref().map(|corner| corner.s))?;
        let [suction, pressure] = corners
            .each_ref()
            .map(|corner| corner.fade(first, outline, stack));
        let (suction, pressure) = (suction?, pressure?);
        Ok(Self {
            name: web.name.clone(),
            arcs: web.arcs,
            is_fore,
            layers: web.layers.clone(),
            feet,
            corners: corners.each_ref().map(|corner| corner.s),
            line,
            leans: [suction.0.lean(), pressure.0.lean()],
            turns: [suction.0, pressure.0],
            fades: [suction.1, pressure.1],
        })
    }

    /// Unit normal of its outer face, into the spar.
    pub fn inward(&self) -> [f64; 2] {
        let sign = if self.is_fore { -1.0 } else { 1.0 };
        self.line.normal.map(|x| sign * x)
    }
}

impl Corner<'_> {
    /// The turn from the surface to the web, and the fade of its lean.
    fn fade(
        &self,
        first: usize,
        outline: &Outline,
        stack: &Stack,
    ) -> Result<(Turn, Fade), LayupProblem> {
        let (s, sign) = (self.s, sign(self.is_fore, self.side));
        let n = outline.inward(s);
        let forward = if self.is_fore { -1.0 } else { 1.0 };
        let w = self.line.normal.map(|x| forward * x);
        let turn = Turn {
            cosine: n[0] * w[0] + n[1] * w[1],
            sine: sign * (n[0] * w[1] - n[1] * w[0]),
            bend: below(outline.bend(s), stack.before(first, s)),
        };
        let lean = turn.lean();
        let thickness = |s: f64| stack.total(s) - stack.before(first, s);
        let (end, is_shared) = self.end;
        let way = MOST_OF_WAY * (end - s).abs();
        let (length, room) = (thickness(s) * lean, if is_shared { 0.5 * way } else { way });
        if !(lean > 0.0 && length < room) {
            return Err(LayupProblem::Tight {
                layer: stack.innermost(s).to_owned(),
                arc: self.web.arcs[self.side],
                thickness: thickness(s),
                radius: room / lean.abs(),
            });
        }
        let surface = |x: f64| {
            let at = s + sign * x;
            let thickness = thickness(at).max(thickness(s));
            (thickness, below(outline.bend(at), stack.before(first, at)))
        };
        Ok((turn, Fade::new([lean, length], room, surface)))
    }
}
