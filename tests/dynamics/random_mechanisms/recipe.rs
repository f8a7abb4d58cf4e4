//! Recipe of a random mechanism.

use beam_dynamics::elements::beams::{Beam, BeamGeometry, BeamNode, MassAlong, lumped_bodies};
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::{ConstraintJoint, Freedom, JointEnds, Placing, Turning};
use beam_dynamics::elements::laws::{Law, LawKind};
use beam_dynamics::elements::springs::{End, Measure, Rod, Spring};
use beam_dynamics::model::{Drive, Node, Ramp};
use nalgebra::{Matrix1, Matrix3, Matrix6, Rotation3, Vector3, Vector6};

use crate::chain::Chain;

/// Kinds of joints between links; see [`Link::joint`].
pub const KINDS: usize = 15;

/// A link of the chain and the joint to the previous link.
#[derive(Debug, Clone)]
pub struct Link {
    pub is_beam: bool,
    pub length: f64,
    /// Attitude relative to the previous link, a rotation vector.
    pub turn: Vector3<f64>,
    pub kind: usize,
    /// Attitude of the axes of the joint, and of nodes in the link.
    pub axes: Vector3<f64>,
    /// Freedoms that a total joint holds, by bits.
    pub held: u32,
}

/// All data of a mechanism.
#[derive(Debug, Clone)]
pub struct Recipe {
    pub links: Vec<Link>,
    /// Whether the first node is held in space by a spherical joint.
    pub is_held: bool,
    /// Angular velocity of the whole about the first node.
    pub spin: Vector3<f64>,
    /// Whether the masses have their centers at the nodes.
    pub is_centered: bool,
    /// Unstrained length of the rod between the ends, relative to its distance.
    pub relaxed: f64,
}

/// A mechanism.
pub struct Parts {
    is_centered: bool,
    pub chain: Chain,
    /// The last node of each link.
    pub ends: Vec<usize>,
    pub mass: f64,
}

fn matrix(rotation: &Vector3<f64>) -> Matrix3<f64> {
    *Rotation3::new(*rotation).matrix()
}

/// From nothing to `to` in five hundredths of a second, smoothly.
fn growing(to: f64) -> Drive {
    Drive::Ramp(Ramp {
        from: 0.0,
        to,
        start: 0.0,
        end: 0.05,
        smooth: true,
    })
}

impl Link {
    /// The joint at `point`; all except a clamp have free or driven motions.
    fn joint(
        &self,
        label: &str,
        ends: &JointEnds<'_>,
        point: &Vector3<f64>,
        axes: &Matrix3<f64>,
    ) -> Option<ConstraintJoint> {
        let at = Placing::at(point, axes);
        let arm = 0.3 * axes.column(0).into_owned();
        let apart = Placing {
            points: [*point, point + arm],
            axes: [*axes; 2],
        };
        let across = Placing {
            axes: [
                *axes,
                Matrix3::from_columns(&[axes.column(1), axes.column(2), axes.column(0)]),
            ],
            ..at
        };
        let turned = Some(Turning::Angle(growing(0.1).into()));
        let freedoms = std::array::from_fn(|i| match self.held >> i & 1 {
            0 => Freedom::Free,
            _ => Freedom::Locked,
        });
        Some(match self.kind {
            0 => ConstraintJoint::clamp(label, ends, &at),
            1 => ConstraintJoint::spherical(label, ends, &at),
            2 => ConstraintJoint::revolute(label, ends, &at, None),
            3 => ConstraintJoint::revolute(label, ends, &at, turned),
            4 => ConstraintJoint::cylindrical(label, ends, &at, Freedom::Free, None),
            5 => {
                let slide = Freedom::Driven(growing(0.02).into());
                ConstraintJoint::cylindrical(label, ends, &at, slide, turned)
            }
            6 => ConstraintJoint::universal(label, ends, &across),
            7 => ConstraintJoint::prismatic(label, ends, &at, Freedom::Free),
            8 => ConstraintJoint::in_line(label, ends, &at),
            9 => ConstraintJoint::in_plane(label, ends, &at, None),
            10 => ConstraintJoint::plane_rotation(label, ends, &at, None),
            11 => ConstraintJoint::distance(label, ends, &apart, Drive::Constant(0.3)),
            12 | 13 => ConstraintJoint::total(label, ends, &at, freedoms),
            _ => return None,
        })
    }
}

impl Recipe {
    /// The mechanism, turned about the origin and shifted.
    pub fn parts(&self, turn: &Matrix3<f64>, shift: &Vector3<f64>) -> Parts {
        let mut parts = Parts {
            is_centered: self.is_centered,
            chain: Chain::new(),
            ends: Vec::new(),
            mass: 0.0,
        };
        let (mut point, mut attitude) = (*shift, *turn);
        for (i, link) in self.links.iter().enumerate() {
            attitude *= matrix(&link.turn);
            let before = parts.ends.last().copied();
            let first = parts.chain.nodes.len();
            let along = attitude * Vector3::new(link.length, 0.0, 0.0);
            if link.is_beam {
                parts.add_beam(link, &point, &attitude)
            } else {
                parts.add_body(&(point + 0.4 * along), &(attitude * matrix(&link.axes)))
            }
            if let Some(before) = before {
                parts.join(
                    i,
                    link,
                    [before, first],
                    (&point, &(attitude * matrix(&link.axes))),
                );
            }
            parts.ends.push(parts.chain.nodes.len() - 1);
            point += along;
        }
        let last = parts.chain.nodes.len() - 1;
        let ends = [0, last].map(|node| End::Node {
            node,
            offset: Vector3::new(0.05, 0.1, -0.05),
        });
        let nodes = &parts.chain.nodes;
        let length = (nodes[last].position - nodes[0].position).norm();
        let law = (Measure::Strain, Law::linear(Matrix1::new(20.0)));
        let rod = Rod::new(
            "rod",
            ends,
            nodes,
            Some(Drive::Constant(self.relaxed * length).into()),
            law,
        );
        parts.chain.elements.push(Box::new(rod));
        if self.is_held {
            parts.hold();
        }
        parts
    }
}

impl Parts {
    fn add_node(&mut self, position: Vector3<f64>, rotation: Matrix3<f64>) {
        let label = format!("n{}", self.chain.nodes.len());
        self.chain.nodes.push(Node {
            label,
            position,
            rotation,
        });
    }

    /// Gives a node the mass of a rigid body.
    fn add_mass(&mut self, node: usize, mut inertia: RigidInertia) {
        if self.is_centered {
            inertia.first_moment.fill(0.0);
        }
        self.mass += inertia.mass;
        let body = RigidBody::new(format!("mass {}", self.chain.elements.len()), node, inertia);
        self.chain.elements.push(Box::new(body));
    }

    fn add_body(&mut self, position: &Vector3<f64>, attitude: &Matrix3<f64>) {
        self.add_node(*position, *attitude);
        let central = Matrix3::from_diagonal(&Vector3::new(0.02, 0.01, 0.015));
        let offset = Vector3::new(0.02, -0.03, 0.05);
        let inertia = RigidInertia::about_node(0.5, &offset, &central);
        self.add_mass(self.chain.nodes.len() - 1, inertia);
    }

    /// A beam whose nodes are not aligned with its sections.
    fn add_beam(&mut self, link: &Link, point: &Vector3<f64>, attitude: &Matrix3<f64>) {
        let first = self.chain.nodes.len();
        let tilt = matrix(&(0.3 * link.axes));
        for part in [0.0, 0.5, 1.0] {
            let position = point + attitude * Vector3::new(part * link.length, 0.0, 0.0);
            self.add_node(position, attitude * tilt);
        }
        let on = [first, first + 1, first + 2];
        let geometry = BeamGeometry::new(
            [BeamNode {
                offset: Vector3::zeros(),
                orientation: tilt.transpose(),
            }; 3],
        );
        let section = Matrix6::from_diagonal(&Vector6::new(0.4, 0.4, 0.4, 4e-4, 2e-4, 2e-4));
        let stiffness = Matrix6::from_diagonal(&Vector6::new(1e3, 4e2, 4e2, 2.0, 1.5, 3.0));
        let undeformed = on.map(|node| &self.chain.nodes[node]);
        let label = format!("beam {first}");
        let beam = Beam::elastic(label, on, geometry, undeformed, [stiffness; 2]);
        let bodies = lumped_bodies(&geometry, undeformed, &MassAlong::smooth(&|_| section)).bodies;
        self.chain.elements.push(Box::new(beam));
        for (node, inertia) in on.into_iter().zip(bodies) {
            self.add_mass(node, inertia);
        }
    }

    /// A joint and a spring between two nodes, at a point.
    fn join(
        &mut self,
        number: usize,
        link: &Link,
        [a, b]: [usize; 2],
        (point, axes): (&Vector3<f64>, &Matrix3<f64>),
    ) {
        let nodes = &self.chain.nodes;
        let ends = JointEnds {
            a: Some((a, &nodes[a])),
            b: (b, &nodes[b]),
        };
        let joint = link.joint(&format!("joint {number}"), &ends, point, axes);
        let stiffness = Vector6::new(200.0, 300.0, 250.0, 15.0, 10.0, 20.0);
        let law = Law::from(LawKind::Viscoelastic {
            stiffness: Matrix6::from_diagonal(&stiffness),
            viscosity: Matrix6::from_diagonal(&(0.01 * stiffness)),
        });
        let spring = Spring::new(
            format!("spring {number}"),
            (&[a, b], nodes),
            point,
            axes,
            law,
        );
        if let Some(joint) = joint {
            self.chain.elements.push(Box::new(joint));
        }
        self.chain.elements.push(Box::new(spring));
    }

    fn hold(&mut self) {
        let first = &self.chain.nodes[0];
        let ends = JointEnds {
            a: None,
            b: (0, first),
        };
        let at = Placing::at(&first.position, &first.rotation);
        let joint = ConstraintJoint::spherical("ground", &ends, &at);
        self.chain.elements.push(Box::new(joint));
    }
}
