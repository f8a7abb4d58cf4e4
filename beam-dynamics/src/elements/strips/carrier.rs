//! The point at which a strip is carried: of a body, or of the line of a beam.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{skew, skew_skew};

use crate::elements::LocalJacobian;
use crate::elements::beams::{LinePoint, LineState};
use crate::elements::carried::{CarriedPoint, LoadShare, Share};
use crate::model::Equation::Moment;
use crate::model::{NodeMotion, Variable};

/// A point of a body or of a beam.
#[derive(Debug, Clone)]
pub(super) enum Carrier {
    /// Offset of the point from the node \[m\], and its axes (columns), in the axes of the node.
    Body(Vector3<f64>, Matrix3<f64>),
    /// A point of the line of a beam.
    Beam(Box<LinePoint>),
}

/// A carrier at a state.
pub(super) enum CarrierState<'a> {
    /// A point of a body.
    Body(CarriedPoint),
    /// A point of the line of a beam.
    Beam(LineState<'a>),
}

impl Carrier {
    /// Number of its nodes, the first ones of the element.
    pub fn nodes(&self) -> usize {
        match self {
            Self::Body(..) => 1,
            Self::Beam(_) => 3,
        }
    }

    /// The carrier at the motion of its nodes, the first ones of `nodes`.
    pub fn at(&self, nodes: &[NodeMotion]) -> CarrierState<'_> {
        match self {
            Self::Body(offset, axes) => {
                let node = &nodes[0];
                let offset = node.rotation * offset;
                CarrierState::Body(CarriedPoint {
                    position: node.position + offset,
                    rotation: node.rotation * axes,
                    shares: [
                        Share {
                            weight: 1.0,
                            offset,
                            turn: Matrix3::identity(),
                            load: LoadShare {
                                force: 1.0,
                                moment_by_force: skew(&offset),
                                moment_by_moment: Matrix3::identity(),
                            },
                        },
                        Share::default(),
                        Share::default(),
                    ],
                    count: 1,
                })
            }
            Self::Beam(point) => CarrierState::Beam(point.at(nodes)),
        }
    }
}

impl CarrierState<'_> {
    /// The point, and the shares of its nodes.
    pub fn carried(&self) -> CarriedPoint {
        match self {
            Self::Body(point) => *point,
            Self::Beam(line) => line.carried(),
        }
    }

    /// Adds the variation of the loads on the nodes with the geometry, at fixed force and moment.
    pub fn add_variation(
        &self,
        force: &Vector3<f64>,
        moment: &Vector3<f64>,
        out: &mut LocalJacobian,
    ) {
        match self {
            Self::Body(point) => {
                // d(f x F) = [F]x [f]x theta.
                let by_rotation = skew_skew(force, &point.shares[0].offset);
                out.add((0, Moment), (0, Variable::Rotation), &by_rotation);
            }
            Self::Beam(line) => line.add_variation(force, moment, out),
        }
    }
}
