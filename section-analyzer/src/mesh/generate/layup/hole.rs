//! Arcs of the shell without a layer: nothing joins the layers on both sides of them there.

use super::super::bisect::bisect;
use super::problem::{Hole, LayupProblem};
use super::wall::Wall;

/// Part of the contour beyond a hole at which its layer is.
const BESIDE: f64 = 1e-7;

impl Wall {
    /// Refuses a wall with arcs without a layer.
    pub fn check_closed(&self) -> Result<(), LayupProblem> {
        let holes = self.holes();
        match holes.is_empty() {
            true => Ok(()),
            false => Err(LayupProblem::Holes { holes }),
        }
    }

    /// The arcs without a layer. Between kinks of the thicknesses their sum is a straight line.
    fn holes(&self) -> Vec<Hole> {
        let perimeter = self.outline.perimeter();
        let is_ring = self.edge.is_ring();
        let [from, to] = if is_ring { [0.0, perimeter] } else { self.ends };
        let spar = self.spar.iter().flat_map(|spar| &spar.webs);
        let kinks = self.stack.kinks().into_iter().map(|kink| kink.s);
        let inside = kinks.chain(spar.flat_map(|web| web.corners));
        let inside = inside.filter(|s| *s > from && *s < to);
        let mut ends: Vec<f64> = [from, to].into_iter().chain(inside).collect();
        ends.sort_by(f64::total_cmp);
        let between = ends
            .windows(2)
            .flat_map(|two| [two[0], 0.5 * (two[0] + two[1])]);
        let at: Vec<f64> = between.chain([to]).collect();
        let turned = |s: f64| if is_ring { s.rem_euclid(perimeter) } else { s };
        let is_there = |s: f64| self.stack.total(turned(s)) > 0.0;
        let Some(first) = at.iter().position(|s| is_there(*s)) else {
            return Vec::new();
        };
        // on a ring once around from a place with a layer
        let again = at[..=first].iter().map(|s| s + perimeter);
        let again = again.filter(|_| is_ring);
        let at: Vec<f64> = at[first..].iter().copied().chain(again).collect();
        let mut holes = Vec::new();
        let mut start = None;
        for two in at.windows(2) {
            let is = [is_there(two[0]), is_there(two[1])];
            let edge = || bisect([two[0], two[1]], is[0], is_there);
            match (is, start) {
                ([true, false], _) => start = Some(edge()),
                ([false, true], Some(start)) => holes.push(self.hole([start, edge()], turned)),
                _ => {}
            }
        }
        holes
    }

    /// The hole between two arc lengths, with the ends of its layers if they are near.
    fn hole(&self, ends: [f64; 2], turned: impl Fn(f64) -> f64) -> Hole {
        let perimeter = self.outline.perimeter();
        let beside = [ends[0] - BESIDE * perimeter, ends[1] + BESIDE * perimeter].map(&turned);
        let found = beside.map(|s| self.stack.outermost(s).unwrap_or(0));
        let arc = |which: usize| {
            let given = self.stack.ends(found[which])[1 - which];
            let s = turned(ends[which]);
            let is_near = (given - s).abs() < self.size;
            (if is_near { given } else { s }) / perimeter
        };
        Hole {
            layers: found.map(|layer| self.stack.name(layer).to_owned()),
            arcs: [arc(0), arc(1)],
        }
    }
}
