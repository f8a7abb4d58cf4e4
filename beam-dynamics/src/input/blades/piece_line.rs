//! The line of a blade: straight pieces laid end to end, with nodes and section axes.
//!
//! In the axes of the blade (x out, y in the direction of motion, z up) a piece with
//! sweep Lambda and dihedral Gamma, and its section twisted by beta, have the axes
//!
//! ```text
//! P = Rz(-Lambda) Ry(-Gamma)                Q = P Rx(beta)
//! ```
//!
//! so that sweep turns the line aft (toward -y), dihedral up, and twist the nose up.
//! Within a piece the twist is linear.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::layout::{BladeLayout, LayoutNode};
use crate::input::beam_properties::BeamProperties;

/// A straight piece of a blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// Length \[m\].
    pub length: f64,
    /// Number of three-node beams.
    pub elements: usize,
    /// Angle of the line in the rotor plane, positive aft \[rad\].
    pub sweep: f64,
    /// Angle of the line out of the rotor plane, positive up \[rad\].
    pub dihedral: f64,
    /// Twist at the inner and the outer end, positive nose up \[rad\].
    pub twist: [f64; 2],
}

/// The line of a blade in its own axes, from the root to the tip.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PieceLine {
    /// The pieces.
    pub pieces: Vec<Piece>,
}

impl Piece {
    /// Axes of the piece in the axes of the blade; its line is the first.
    fn axes(&self) -> Matrix3<f64> {
        let sweep = vector::to_rotation(&Vector3::new(0.0, 0.0, -self.sweep));
        sweep * vector::to_rotation(&Vector3::new(0.0, -self.dihedral, 0.0))
    }

    /// Change of the twist along the piece, per length \[rad/m\].
    pub fn twist_rate(&self) -> f64 {
        (self.twist[1] - self.twist[0]) / self.length
    }

    /// Section axes at the part `s` of the length, in the axes of the blade.
    fn section(&self, s: f64) -> Matrix3<f64> {
        let twist = self.twist[0] + (self.twist[1] - self.twist[0]) * s;
        self.axes() * about_x(twist)
    }
}

fn about_x(angle: f64) -> Matrix3<f64> {
    vector::to_rotation(&Vector3::new(angle, 0.0, 0.0))
}

impl PieceLine {
    /// Length \[m\].
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.length).sum()
    }

    /// Position \[m\] on the line at an arc length; beyond an end, the position of the end.
    pub fn position(&self, arc_length: f64) -> Vector3<f64> {
        let mut left = arc_length.max(0.0);
        let mut position = Vector3::zeros();
        for piece in &self.pieces {
            position += piece.axes().column(0) * left.min(piece.length);
            left = (left - piece.length).max(0.0);
        }
        position
    }

    /// Cuts every piece into its beams, with `words` and `properties` of a piece's index.
    pub fn lay(
        &self,
        words: impl Fn(usize) -> String,
        properties: impl Fn(usize) -> BeamProperties,
    ) -> BladeLayout {
        let mut layout = BladeLayout::default();
        let (mut inner_end, mut arc_length) = (Vector3::zeros(), 0.0);
        for (number, piece) in self.pieces.iter().enumerate() {
            let outer_end = inner_end + piece.axes().column(0) * piece.length;
            let steps = 2 * piece.elements;
            let at = |step: usize| {
                let s = step as f64 / steps as f64;
                LayoutNode {
                    arc_length: arc_length + s * piece.length,
                    position: inner_end.lerp(&outer_end, s),
                    axes: piece.section(s),
                }
            };
            for element in 0..piece.elements {
                let positions = [0, 1, 2].map(|k| at(2 * element + k));
                layout.add(positions, words(number), properties(number));
            }
            (inner_end, arc_length) = (outer_end, arc_length + piece.length);
        }
        layout
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::beam_section::Properties;
    use nalgebra::Matrix6;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, FRAC_PI_6};

    // Round-off of a few products of numbers up to 10.
    const TOLERANCE: f64 = 1e-14;

    fn piece(length: f64, elements: usize) -> Piece {
        Piece {
            length,
            elements,
            sweep: 0.0,
            dihedral: 0.0,
            twist: [0.0; 2],
        }
    }

    fn lay(pieces: Vec<Piece>) -> BladeLayout {
        let properties = Properties {
            stiffness: Matrix6::identity(),
            mass: Matrix6::identity(),
            damping: None,
            law: None,
            heat: crate::input::beam_section::Heat::default(),
            prestress: None,
            torsional_buckling: None,
            piezo: None,
            curved: None,
        };
        PieceLine { pieces }.lay(|_| String::new(), |_| BeamProperties::constant(&properties))
    }

    fn assert_position(found: &Vector3<f64>, expected: [f64; 3]) {
        assert!(
            (found - Vector3::from(expected)).amax() < TOLERANCE,
            "{found} {expected:?}"
        );
    }

    // Sweep 30 degrees aft: the tip piece of length 4 ends at x = 6 + 4 cos 30,
    // y = -4 sin 30; its section axis y is (sin 30, cos 30, 0), turned by the twist of
    // 90 degrees into z.
    #[test]
    fn a_swept_and_twisted_tip_lies_where_it_should() {
        let mut tip = piece(4.0, 1);
        (tip.sweep, tip.twist) = (FRAC_PI_6, [0.0, FRAC_PI_2]);
        let layout = lay(vec![piece(6.0, 2), tip]);
        let (c, s) = (FRAC_PI_6.cos(), 0.5);
        assert_eq!((layout.nodes.len(), layout.beams.len()), (7, 3));
        for (node, x) in [0.0, 1.5, 3.0, 4.5, 6.0].into_iter().enumerate() {
            assert_position(&layout.nodes[node].position, [x, 0.0, 0.0]);
            assert_eq!(layout.nodes[node].axes, Matrix3::identity());
        }
        assert_position(&layout.nodes[5].position, [6.0 + 2.0 * c, -2.0 * s, 0.0]);
        assert_position(&layout.nodes[6].position, [6.0 + 4.0 * c, -4.0 * s, 0.0]);
        let axes = |node: usize, column: usize| layout.nodes[node].axes.column(column).into_owned();
        for node in [5, 6] {
            assert_position(&axes(node, 0), [c, -s, 0.0]);
        }
        let root_half = FRAC_PI_4.cos();
        assert_position(&axes(5, 1), [s * root_half, c * root_half, root_half]);
        assert_position(&axes(6, 1), [0.0, 0.0, 1.0]);
        assert_position(&axes(6, 2), [-s, -c, 0.0]);
    }

    // The node at the kink has the axes of the inner piece; the outer beam has its
    // own, so that its undeformed section follows its line without a jump.
    #[test]
    fn a_kink_is_taken_up_by_the_outer_beam() {
        let mut tip = piece(4.0, 2);
        (tip.sweep, tip.dihedral, tip.twist) = (0.3, 0.2, [0.1, 0.1]);
        let layout = lay(vec![piece(6.0, 2), tip]);
        let aligned = [Matrix3::identity(); 3];
        for (beam, kinked) in [false, false, true, false].into_iter().enumerate() {
            assert_eq!(
                layout.beams[beam].orientations == aligned,
                !kinked,
                "beam {beam}"
            );
        }
        let section = layout.nodes[4].axes * layout.beams[2].orientations[0];
        assert!((section - layout.nodes[5].axes).amax() < TOLERANCE);
        let along = (layout.nodes[6].position - layout.nodes[4].position).normalize();
        assert!((section.column(0) - along).amax() < TOLERANCE);
        assert_position(
            &along,
            [
                0.2_f64.cos() * 0.3_f64.cos(),
                -0.2_f64.cos() * 0.3_f64.sin(),
                0.2_f64.sin(),
            ],
        );
    }

    // Twist is linear: from 10 to 40 degrees over three beams, 15 degrees at the first
    // middle node.
    #[test]
    fn twist_is_linear_along_a_piece() {
        let mut twisted = piece(3.0, 3);
        twisted.twist = [10.0_f64.to_radians(), 40.0_f64.to_radians()];
        let layout = lay(vec![twisted]);
        for (node, found) in layout.nodes.iter().enumerate() {
            let angle = found.axes[(2, 1)].atan2(found.axes[(1, 1)]).to_degrees();
            assert!(
                (angle - (10.0 + 5.0 * node as f64)).abs() < 1e-12,
                "{node}: {angle}"
            );
        }
    }

    // Positions at arc lengths of nodes are the nodes' positions; beyond the ends, the
    // ends.
    #[test]
    fn positions_are_found_by_arc_length() {
        let mut tip = piece(4.0, 2);
        (tip.sweep, tip.dihedral) = (0.3, 0.2);
        let line = PieceLine {
            pieces: vec![piece(6.0, 2), tip],
        };
        let layout = lay(line.pieces.clone());
        for node in &layout.nodes {
            let found = line.position(node.arc_length);
            assert!((found - node.position).amax() < TOLERANCE);
        }
        assert_eq!((line.length(), layout.nodes[8].arc_length), (10.0, 10.0));
        assert_eq!(line.position(11.0), layout.nodes[8].position);
        assert_eq!((layout.nearest(7.9), layout.nearest(7.1)), (6, 5));
    }
}
