//! A spar around the nose whose layers turn into a web.
//!
//! ```text
//!         suction side
//!      *---------------.
//!      |  *----------.  \
//!      |  |           \  |    the layers outside of the spar continue behind the web
//!      |  *----------'  /
//!      *---------------'
//!         pressure side
//! ```
//!
//! Columns bend at the inner face of the layers outside of the spar, at the depth D; with t along
//! the contour,
//!
//! ```text
//! x = p + D n + (d - D) (n + M t),    M = (n_w . t) / (1 + n_w . n) at a corner,
//! ```
//!
//! so that a node at a corner has one depth below the surface and below the outer face of the web,
//! of normal n_w; away from the corner M fades as beside a corner of the contour.

use super::super::super::{distance, short};
use super::super::grid::Grid;
use super::line::Line;
use super::mitre::Fade;
use super::outline::Outline;
use super::problem::{LayupProblem, Upright};
use super::stack::Stack;
use super::types::Spar;

/// Names of the sides.
pub(super) const SIDES: [&str; 2] = ["suction", "pressure"];
/// Part of the way to the nose that a mitre takes at most.
const MOST_OF_WAY: f64 = 0.9;
/// Parts of the contour around the line of a web in which its corners are searched.
const AROUND: f64 = 0.02;
/// Relative difference of thicknesses that are equal.
const SAME: f64 = 1e-6;

/// The spar of a wall.
#[derive(Debug, Clone)]
pub(super) struct SparWall {
    /// Name of its web.
    pub web: String,
    /// Arcs of the outer face of the web on both sides [-].
    pub arcs: [f64; 2],
    /// Number of its first layer.
    pub first: usize,
    /// Numbers of the layers along the web, from the outside in.
    pub layers: Vec<usize>,
    /// Arc lengths of the columns at its corners.
    pub corners: [f64; 2],
    /// The outer face of the web.
    pub line: Line,
    /// M at the corners.
    pub leans: [f64; 2],
    fades: [Fade; 2],
}

impl SparWall {
    /// The spar on a contour; the layers of `stack` inside of it end at its corners.
    pub fn new(spar: &Spar, outline: &Outline, stack: &mut Stack) -> Result<Self, LayupProblem> {
        let points = spar
            .arcs
            .map(|arc| outline.position(arc * outline.perimeter()));
        let line = Line::between(points);
        let first = spar.layers[0];
        let corner = |side: usize| corner((spar, &line), (outline, stack), side);
        let corners = [corner(0)?, corner(1)?];
        stack.end_inside(corners);
        let sides = [0, 1].map(|side| {
            check_plies(spar, stack, (side, corners[side]))?;
            fade((spar, &line), (outline, stack), (side, corners[side]))
        });
        let [suction, pressure] = sides;
        let ((suction, lean_suction), (pressure, lean_pressure)) = (suction?, pressure?);
        Ok(Self {
            web: spar.web.clone(),
            arcs: spar.arcs,
            first,
            layers: spar.layers.clone(),
            corners,
            line,
            leans: [lean_suction, lean_pressure],
            fades: [suction, pressure],
        })
    }

    /// The depth at which the column at an arc length bends, and its lean beyond; `None` if it does
    /// not.
    pub fn knee(&self, stack: &Stack, s: f64) -> Option<(f64, f64)> {
        let [suction, pressure] = self.corners;
        if s < suction || s > pressure {
            return None;
        }
        let ahead = self.fades[0].at(s - suction);
        let lean = ahead.or_else(|| Some(-self.fades[1].at(pressure - s)?));
        Some((stack.before(self.first, s), lean?))
    }

    /// The side of the corner at an arc length.
    pub fn corner_at(&self, s: f64) -> Option<usize> {
        self.corners.iter().position(|corner| *corner == s)
    }

    /// Adds the cells of the web between the nodes of its corners, those inside of the bend on the
    /// suction and the pressure side. `plies` has the names of the layer of each level, and `size`
    /// is the largest length of cells.
    pub fn add_web(
        &self,
        corners: [Vec<u32>; 2],
        plies: &[[String; 2]],
        size: f64,
        grid: &mut Grid,
    ) {
        let levels = corners[0].len().min(corners[1].len());
        let ends = |level: usize| [0, 1].map(|side| grid.position(corners[side][level]));
        let ends: Vec<[[f64; 2]; 2]> = (0..levels).map(ends).collect();
        let length = ends.iter().map(|[a, b]| distance(*a, *b));
        let count = (length.fold(0.0, f64::max) / size)
            .ceil()
            .clamp(2.0, 2000.0) as usize;
        let mut rows = vec![corners[0].clone()];
        for row in 1..count {
            let part = row as f64 / count as f64;
            let nodes = ends.iter().map(|[a, b]| {
                let position = [0, 1].map(|i| a[i] + part * (b[i] - a[i]));
                grid.node(position)
            });
            rows.push(nodes.collect());
        }
        rows.push(corners[1].clone());
        for pair in rows.windows(2) {
            let [a, b] = [&pair[0], &pair[1]];
            for (level, names) in plies.iter().enumerate() {
                grid.cell([a[level], b[level], b[level + 1], a[level + 1]], names);
            }
        }
        for pair in rows.windows(2).rev() {
            let ends = [pair[1][levels - 1], pair[0][levels - 1]];
            grid.line(ends, std::slice::from_ref(&self.web));
        }
    }
}

/// The arc length on a side at which the inner face of the layers outside of the spar meets the
/// outer face of the web.
fn corner(
    (spar, line): (&Spar, &Line),
    (outline, stack): (&Outline, &Stack),
    side: usize,
) -> Result<f64, LayupProblem> {
    let perimeter = outline.perimeter();
    let near = spar.arcs[side] * perimeter;
    let off = |s: f64| {
        let (p, n) = (outline.position(s), outline.inward(s));
        let depth = stack.before(spar.layers[0], s);
        line.offset([0, 1].map(|i| p[i] + depth * n[i]))
    };
    let reach = AROUND * perimeter + 2.0 * stack.before(spar.layers[0], near);
    let toward_nose = [1.0, -1.0][side];
    let [end, nose] = [outline.corners()[side], outline.nose()];
    let within = |s: f64| s.clamp(end.min(nose), end.max(nose));
    let mut aft = within(near - toward_nose * reach);
    let mut fore = within(near + toward_nose * reach);
    if off(aft) > 0.0 || off(fore) < 0.0 {
        return Err(LayupProblem::WebOutside {
            web: Upright::Web(spar.web.clone()),
            side: SIDES[side],
            arc: spar.arcs[side],
        });
    }
    for _ in 0..60 {
        let middle = 0.5 * (aft + fore);
        if off(middle) > 0.0 {
            fore = middle;
        } else {
            aft = middle;
        }
    }
    Ok(0.5 * (aft + fore))
}

/// Checks that the layers inside of a corner have the thicknesses of those along the web, and that
/// no layer reaches it from behind.
fn check_plies(spar: &Spar, stack: &Stack, (side, s): (usize, f64)) -> Result<(), LayupProblem> {
    let first = spar.layers[0];
    let present = (first..stack.len()).filter(|layer| stack.thickness(*layer, s) > 0.0);
    let present: Vec<usize> = present.collect();
    if let Some(layer) = present.iter().find(|layer| !stack.is_inside(**layer)) {
        return Err(LayupProblem::AtSpar {
            layer: stack.name(*layer).to_owned(),
            web: spar.web.clone(),
        });
    }
    let thick =
        |layers: &[usize]| -> Vec<f64> { layers.iter().map(|layer| stack.full(*layer)).collect() };
    let (found, expected) = (thick(&present), thick(&spar.layers));
    let is_full = present
        .iter()
        .all(|layer| (stack.thickness(*layer, s) / stack.full(*layer) - 1.0).abs() < SAME);
    let is_same = |(a, b): (&f64, &f64)| (a / b - 1.0).abs() < SAME;
    let are_same = found.len() == expected.len() && found.iter().zip(&expected).all(is_same);
    if are_same && is_full {
        return Ok(());
    }
    let text = |all: Vec<f64>| {
        let all: Vec<String> = all.into_iter().map(short).collect();
        all.join(", ")
    };
    Err(LayupProblem::SparPlies {
        web: spar.web.clone(),
        side: SIDES[side],
        found: text(
            present
                .iter()
                .map(|layer| stack.thickness(*layer, s))
                .collect(),
        ),
        expected: text(expected),
    })
}

/// The fade of the lean from a corner on a side, and the lean at the corner.
fn fade(
    (spar, line): (&Spar, &Line),
    (outline, stack): (&Outline, &Stack),
    (side, s): (usize, f64),
) -> Result<(Fade, f64), LayupProblem> {
    let n = outline.inward(s);
    let (cosine, sine) = (
        n[0] * line.normal[0] + n[1] * line.normal[1],
        n[0] * line.normal[1] - n[1] * line.normal[0],
    );
    let sign = [1.0, -1.0][side];
    let lean = sign * sine / (1.0 + cosine);
    let first = spar.layers[0];
    let thickness = |s: f64| stack.total(s) - stack.before(first, s);
    let (length, room) = (
        thickness(s) * lean,
        MOST_OF_WAY * (outline.nose() - s).abs(),
    );
    if !(lean > 0.0 && length < room) {
        return Err(LayupProblem::Tight {
            layer: stack.innermost(s).to_owned(),
            arc: spar.arcs[side],
            thickness: thickness(s),
            radius: room / lean.abs(),
        });
    }
    let surface = |x: f64| {
        let at = s + sign * x;
        let bend = outline.bend(at);
        let thickness = thickness(at).max(thickness(s));
        (thickness, bend / (1.0 - bend * stack.before(first, at)))
    };
    Ok((Fade::new([lean, length], room, surface), lean))
}
