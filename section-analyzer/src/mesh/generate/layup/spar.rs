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
use super::types::{SIDES, Spar};

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
    /// The turn at each corner, and the fade of its lean.
    sides: Vec<(Turn, Fade)>,
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
        for (number, (web, line)) in spar.webs.iter().zip(lines).enumerate() {
            let others = corners
                .iter()
                .enumerate()
                .find(|(other, _)| *other != number);
            // as far as the middle between two webs, or as the nose
            let way = [0, 1].map(|side| {
                let s = corners[number][side];
                let other = others.map(|(_, other)| 0.5 * (other[side] - s).abs());
                MOST_OF_WAY * other.unwrap_or((outline.nose() - s).abs())
            });
            let mut made = WebWall {
                name: web.name.clone(),
                arcs: web.arcs,
                is_fore: number > 0,
                layers: web.layers.clone(),
                feet: feet(web, spar.first, stack, corners[number])?,
                corners: corners[number],
                line,
                leans: [0.0; 2],
                sides: Vec::new(),
            };
            for (side, way) in way.into_iter().enumerate() {
                let (turn, fade) = made.fade(spar.first, (side, way), outline, stack)?;
                made.leans[side] = turn.lean();
                made.sides.push((turn, fade));
            }
            webs.push(made);
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
            for (side, (turn, fade)) in web.sides.iter().enumerate() {
                let sign = sign(web.is_fore, side);
                let away = sign * (s - web.corners[side]);
                let Some(lean) = fade.at(away).filter(|_| away >= 0.0) else {
                    continue;
                };
                let (n, depth) = (outline.inward(s), stack.before(self.first, s));
                return Some(Bend {
                    depth,
                    normal: n,
                    direction: [-sign * n[1], sign * n[0]],
                    bend: below(outline.bend(s), depth),
                    lean: Lean::Part(lean / web.leans[side], *turn),
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
    /// Unit normal of its outer face, into the spar.
    pub fn inward(&self) -> [f64; 2] {
        let sign = if self.is_fore { -1.0 } else { 1.0 };
        self.line.normal.map(|x| sign * x)
    }

    /// The turn from the surface to the web at its corner on a side, and the fade of the lean within a
    /// way along the surface.
    fn fade(
        &self,
        first: usize,
        (side, way): (usize, f64),
        outline: &Outline,
        stack: &Stack,
    ) -> Result<(Turn, Fade), LayupProblem> {
        let (s, sign) = (self.corners[side], sign(self.is_fore, side));
        let (n, w) = (outline.inward(s), self.inward());
        let turn = Turn {
            cosine: n[0] * w[0] + n[1] * w[1],
            sine: sign * (n[0] * w[1] - n[1] * w[0]),
            bend: below(outline.bend(s), stack.before(first, s)),
        };
        let lean = turn.lean();
        let thickness = |s: f64| stack.total(s) - stack.before(first, s);
        let length = thickness(s) * lean;
        if !(lean > 0.0 && length < way) {
            return Err(LayupProblem::Tight {
                layer: stack.innermost_name(s).to_owned(),
                arc: self.arcs[side],
                thickness: thickness(s),
                radius: way / lean.abs(),
                thickest: stack.thickest(s),
            });
        }
        let surface = |x: f64| {
            let at = s + sign * x;
            let thickness = thickness(at).max(thickness(s));
            (thickness, below(outline.bend(at), stack.before(first, at)))
        };
        Ok((turn, Fade::new([lean, length], way, surface)))
    }
}
