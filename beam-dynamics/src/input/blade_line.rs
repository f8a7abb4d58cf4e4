//! The line of a blade: straight pieces laid end to end, with nodes and section axes.
//!
//! In the axes of the blade (x out, y the way the blade goes, z up) a piece with
//! sweep Lambda and dihedral Gamma, and its section twisted by beta, have the axes
//!
//! ```text
//! P = Rz(-Lambda) Ry(-Gamma)                Q = Rx(pitch) P Rx(beta)
//! ```
//!
//! so that sweep turns the line aft (toward -y), dihedral up, and twist and pitch the
//! nose up. Pitch turns the blade as a whole about the span at its root, as a pitch
//! bearing does. Within a piece the twist is linear.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

/// Entries of the relative rotation below this count as aligned: round-off of the
/// same axes found in two ways.
const ALIGNED: f64 = 1e-12;

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

/// A blade before it is cut into beams.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BladeLine {
    /// Place of the root \[m\].
    pub root: Vector3<f64>,
    /// Axes of the blade at the root (columns), precone included.
    pub axes: Matrix3<f64>,
    /// Pitch, positive nose up \[rad\].
    pub pitch: f64,
    /// The pieces from the root to the tip.
    pub pieces: Vec<Piece>,
}

/// A beam of the line: its first node is the number of beams before it times two.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LaidBeam {
    /// Number of the piece.
    pub piece: usize,
    /// Section axes at the three nodes, in the axes of the nodes.
    pub orientations: [Matrix3<f64>; 3],
}

/// Nodes and beams of a blade, from the root to the tip.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct LaidBlade {
    /// Place \[m\] and axes of each node. Where pieces meet these are the section axes
    /// of the inner piece.
    pub nodes: Vec<(Vector3<f64>, Matrix3<f64>)>,
    /// Beam k stands on the nodes 2k, 2k + 1, 2k + 2.
    pub beams: Vec<LaidBeam>,
}

impl Piece {
    /// Axes of the piece in the axes of the blade; its line is the first.
    fn axes(&self) -> Matrix3<f64> {
        let sweep = vector::to_rotation(&Vector3::new(0.0, 0.0, -self.sweep));
        sweep * vector::to_rotation(&Vector3::new(0.0, -self.dihedral, 0.0))
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

impl BladeLine {
    /// Cuts every piece into its beams.
    pub fn lay(&self) -> LaidBlade {
        let blade = self.axes * about_x(self.pitch);
        let mut laid = LaidBlade::default();
        let mut inner_end = self.root;
        for (number, piece) in self.pieces.iter().enumerate() {
            let outer_end = inner_end + blade * piece.axes().column(0) * piece.length;
            let steps = 2 * piece.elements;
            let at = |step: usize| {
                let s = step as f64 / steps as f64;
                (inner_end.lerp(&outer_end, s), blade * piece.section(s))
            };
            if laid.nodes.is_empty() {
                laid.nodes.push(at(0));
            }
            for element in 0..piece.elements {
                let mut orientations = [Matrix3::identity(); 3];
                if let Some((_, node)) = laid.nodes.last() {
                    orientations[0] = relative(node, &at(2 * element).1);
                }
                laid.nodes
                    .extend([at(2 * element + 1), at(2 * element + 2)]);
                laid.beams.push(LaidBeam {
                    piece: number,
                    orientations,
                });
            }
            inner_end = outer_end;
        }
        laid
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

#[cfg(test)]
mod tests {
    use super::*;
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

    fn line(pieces: Vec<Piece>) -> BladeLine {
        BladeLine {
            root: Vector3::new(2.0, 0.0, 0.0),
            axes: Matrix3::identity(),
            pitch: 0.0,
            pieces,
        }
    }

    fn assert_place(found: &Vector3<f64>, expected: [f64; 3]) {
        assert!(
            (found - Vector3::from(expected)).amax() < TOLERANCE,
            "{found} {expected:?}"
        );
    }

    // Sweep 30 degrees aft: the tip piece of length 4 ends at x = 8 + 4 cos 30,
    // y = -4 sin 30; its section axis y is (sin 30, cos 30, 0), turned by the twist of
    // 90 degrees into z.
    #[test]
    fn a_swept_and_twisted_tip_lies_where_it_should() {
        let mut tip = piece(4.0, 1);
        (tip.sweep, tip.twist) = (FRAC_PI_6, [0.0, FRAC_PI_2]);
        let laid = line(vec![piece(6.0, 2), tip]).lay();
        let (c, s) = (FRAC_PI_6.cos(), 0.5);
        assert_eq!((laid.nodes.len(), laid.beams.len()), (7, 3));
        for (node, x) in [2.0, 3.5, 5.0, 6.5, 8.0].into_iter().enumerate() {
            assert_place(&laid.nodes[node].0, [x, 0.0, 0.0]);
            assert_eq!(laid.nodes[node].1, Matrix3::identity());
        }
        assert_place(&laid.nodes[5].0, [8.0 + 2.0 * c, -2.0 * s, 0.0]);
        assert_place(&laid.nodes[6].0, [8.0 + 4.0 * c, -4.0 * s, 0.0]);
        let axes = |node: usize, column: usize| laid.nodes[node].1.column(column).into_owned();
        for node in [5, 6] {
            assert_place(&axes(node, 0), [c, -s, 0.0]);
        }
        let root_half = FRAC_PI_4.cos();
        assert_place(&axes(5, 1), [s * root_half, c * root_half, root_half]);
        assert_place(&axes(6, 1), [0.0, 0.0, 1.0]);
        assert_place(&axes(6, 2), [-s, -c, 0.0]);
    }

    // The node at the kink has the axes of the inner piece; the outer beam sees its
    // own, so that its undeformed section follows its line without a jump.
    #[test]
    fn a_kink_is_taken_up_by_the_outer_beam() {
        let mut tip = piece(4.0, 2);
        (tip.sweep, tip.dihedral, tip.twist) = (0.3, 0.2, [0.1, 0.1]);
        let laid = line(vec![piece(6.0, 2), tip]).lay();
        let aligned = [Matrix3::identity(); 3];
        for (beam, kinked) in [false, false, true, false].into_iter().enumerate() {
            assert_eq!(
                laid.beams[beam].orientations == aligned,
                !kinked,
                "beam {beam}"
            );
        }
        let section = laid.nodes[4].1 * laid.beams[2].orientations[0];
        assert!((section - laid.nodes[5].1).amax() < TOLERANCE);
        let along = (laid.nodes[6].0 - laid.nodes[4].0).normalize();
        assert!((section.column(0) - along).amax() < TOLERANCE);
        assert_place(
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
        let laid = line(vec![twisted]).lay();
        for (node, (_, axes)) in laid.nodes.iter().enumerate() {
            let angle = axes[(2, 1)].atan2(axes[(1, 1)]).to_degrees();
            assert!(
                (angle - (10.0 + 5.0 * node as f64)).abs() < 1e-12,
                "{node}: {angle}"
            );
        }
    }

    // Pitch by 90 degrees turns an aft sweep of 90 degrees (toward -y) down to -z.
    #[test]
    fn pitch_turns_the_blade_as_a_whole() {
        let mut tip = piece(1.0, 1);
        tip.sweep = FRAC_PI_2;
        let mut blade = line(vec![piece(1.0, 1), tip]);
        blade.pitch = FRAC_PI_2;
        let laid = blade.lay();
        assert_place(&laid.nodes[4].0, [3.0, 0.0, -1.0]);
        assert_place(&laid.nodes[0].1.column(1).into_owned(), [0.0, 0.0, 1.0]);
    }
}
