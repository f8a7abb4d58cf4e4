//! A blade as nodes and beams, in its own axes: root at the origin, x out
//! along the span, y in the direction of motion, z up.

use nalgebra::{Matrix3, Vector3};

use crate::input::beam_properties::BeamProperties;

/// Entries of the relative rotation below this are aligned: round-off of the
/// same axes found in two ways.
const ALIGNED: f64 = 1e-12;

/// A node of a blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::input) struct LayoutNode {
    /// Arc length from the root along the line \[m\].
    pub arc_length: f64,
    /// Position \[m\].
    pub position: Vector3<f64>,
    /// Axes of the section; between beams with different section axes, the axes of the inner
    /// one.
    pub axes: Matrix3<f64>,
}

/// A beam of a blade; beam k has the nodes 2k, 2k + 1, 2k + 2.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input) struct LayoutBeam {
    /// Description of the part of the blade to which it belongs.
    pub part: String,
    /// Section axes at the three nodes, in the axes of the nodes.
    pub orientations: [Matrix3<f64>; 3],
    /// Its properties.
    pub properties: BeamProperties,
}

/// Nodes and beams of a blade, from the root to the tip.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::input) struct BladeLayout {
    pub nodes: Vec<LayoutNode>,
    pub beams: Vec<LayoutBeam>,
}

impl BladeLayout {
    /// Adds a beam outboard of the others: its three positions and section axes there.
    pub fn add(&mut self, positions: [LayoutNode; 3], part: String, properties: BeamProperties) {
        let mut orientations = [Matrix3::identity(); 3];
        match self.nodes.last() {
            Some(inner) => orientations[0] = relative(&inner.axes, &positions[0].axes),
            None => self.nodes.push(positions[0]),
        }
        self.nodes.extend(&positions[1..]);
        self.beams.push(LayoutBeam {
            part,
            orientations,
            properties,
        });
    }

    /// Index of the node, at an end or in the middle of an element, that is nearest to a
    /// position on the line.
    pub fn nearest(&self, arc_length: f64) -> usize {
        let far = |node: &usize| (self.nodes[*node].arc_length - arc_length).abs();
        (0..self.nodes.len())
            .min_by(|a, b| far(a).total_cmp(&far(b)))
            .unwrap_or(0)
    }
}

/// Section axes in the axes of the node; exactly the identity if they agree.
fn relative(node: &Matrix3<f64>, section: &Matrix3<f64>) -> Matrix3<f64> {
    let relative = node.transpose() * section;
    if (relative - Matrix3::identity()).amax() <= ALIGNED {
        Matrix3::identity()
    } else {
        relative
    }
}
