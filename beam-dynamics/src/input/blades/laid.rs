//! A blade laid out as nodes and beams, in its own axes: root at the origin, x out
//! along the span, y the way the blade goes, z up.

use nalgebra::{Matrix3, Vector3};

use crate::input::along::Along;

/// Entries of the relative rotation below this count as aligned: round-off of the
/// same axes found in two ways.
const ALIGNED: f64 = 1e-12;

/// A node of a blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::input) struct LaidNode {
    /// Arc length from the root along the line \[m\].
    pub arc_length: f64,
    /// Place \[m\].
    pub position: Vector3<f64>,
    /// Axes: those of the section; where beams with different section axes meet, those
    /// of the inner one.
    pub axes: Matrix3<f64>,
}

/// A beam of a blade; beam k stands on the nodes 2k, 2k + 1, 2k + 2.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input) struct LaidBeam {
    /// The part of the blade to which it belongs, in words.
    pub part: String,
    /// Section axes at the three nodes, in the axes of the nodes.
    pub orientations: [Matrix3<f64>; 3],
    /// Its properties.
    pub along: Along,
}

/// Nodes and beams of a blade, from the root to the tip.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::input) struct Laid {
    pub nodes: Vec<LaidNode>,
    pub beams: Vec<LaidBeam>,
}

impl Laid {
    /// Adds a beam outboard of the others: its three places and section axes there.
    pub fn add(&mut self, places: [LaidNode; 3], part: String, along: Along) {
        let mut orientations = [Matrix3::identity(); 3];
        match self.nodes.last() {
            Some(inner) => orientations[0] = relative(&inner.axes, &places[0].axes),
            None => self.nodes.push(places[0]),
        }
        self.nodes.extend(&places[1..]);
        self.beams.push(LaidBeam {
            part,
            orientations,
            along,
        });
    }

    /// Number of the node, at an end or in the middle of an element, that is nearest to a
    /// place on the line.
    pub fn nearest(&self, arc_length: f64) -> usize {
        let far = |node: &usize| (self.nodes[*node].arc_length - arc_length).abs();
        (0..self.nodes.len())
            .min_by(|a, b| far(a).total_cmp(&far(b)))
            .unwrap_or(0)
    }
}

/// Section axes in the axes of the node; exactly those of the node where they agree.
fn relative(node: &Matrix3<f64>, section: &Matrix3<f64>) -> Matrix3<f64> {
    let relative = node.transpose() * section;
    match (relative - Matrix3::identity()).amax() <= ALIGNED {
        true => Matrix3::identity(),
        false => relative,
    }
}
