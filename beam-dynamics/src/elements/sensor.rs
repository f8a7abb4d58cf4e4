//! Sensors of nodes: a number of their motion as a scalar, for signals.
//!
//! A vector w of a node b, or of b relative to a node a, and a part of it along e, a direction of
//! the model or of the axes of a node c: the equation of the scalar s is `s - e . w = 0`, with
//! (D-194)
//!
//! ```text
//! position   w = x_b - x_a                displacement   w = x_b - x_a - (x_b - x_a)_0
//! velocity   w = v_b - v_a                in space       v + Omega x (x - x_0) in place of v
//! rotation   R(w) = R_a^T R_b (R_a^T R_b)_0^T            attitude       R(w) = R_a^T R_b
//! ```
//!
//! and angular velocities and momenta likewise; without a, x_a, v_a are zero and R_a is I. The
//! rotation vector has components in the axes of a, so that its part is `e . R_a w`: seen in the axes
//! of a, the component itself. It changes by `d w = T^-1(w) R_a^T (theta_b - theta_a)`, a variation
//! theta_a turns R_a w by `theta_a x R_a w`, and theta_c of the axes turns e by `theta_c x e`.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::euler::euler_angles;
use super::{
    Axes, Element, Local, LocalJacobian, LocalResidual, NodeQuantity, NodeVector, Part, ReadingRow,
};
use crate::model::{
    Node, NodeMotion, Quantity, Scalar, ScalarSpec, ScalarStart, TurningFrame, Variable,
};

/// A number of the motion of nodes.
#[derive(Debug, Clone)]
pub struct NodeReading {
    /// The nodes, each once.
    nodes: Vec<usize>,
    /// The vector, by indices among these nodes.
    quantity: NodeQuantity,
    /// `(x_b - x_a)_0` of a displacement, else zero [m].
    offset: Vector3<f64>,
    /// `(R_a^T R_b)_0^T` of a rotation, else the identity.
    undeformed: Matrix3<f64>,
}

impl NodeReading {
    /// The reading of a model with the given undeformed nodes.
    pub fn new(quantity: &NodeQuantity, nodes: &[Node]) -> Self {
        let mut used = Vec::new();
        let mut index = |node: usize| {
            used.iter().position(|own| *own == node).unwrap_or_else(|| {
                used.push(node);
                used.len() - 1
            })
        };
        let local = NodeQuantity {
            node: index(quantity.node),
            against: quantity.against.map(&mut index),
            axes: match quantity.axes {
                Axes::Node(node) => Axes::Node(index(node)),
                axes => axes,
            },
            ..*quantity
        };
        let rest: Vec<_> = used
            .iter()
            .map(|&node| NodeMotion::at_rest(&nodes[node]))
            .collect();
        let (b, a) = ends(&local, &rest);
        Self {
            offset: match local.vector {
                NodeVector::Displacement => {
                    b.position - a.map_or_else(Vector3::zeros, |a| a.position)
                }
                _ => Vector3::zeros(),
            },
            undeformed: match local.vector {
                NodeVector::Rotation => attitude(b, a).transpose(),
                _ => Matrix3::identity(),
            },
            quantity: local,
            nodes: used,
        }
    }

    /// Indices of the nodes on which it depends.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Its value for the motion of these nodes, in SI units.
    pub fn value(&self, nodes: &[NodeMotion], frame: &TurningFrame) -> f64 {
        let vector = self.vector(nodes, frame);
        match self.quantity.vector {
            // Angles about axes are not a vector.
            NodeVector::Euler(_) => self.quantity.part.of(&vector),
            _ => self.quantity.part.in_axes(&vector, &self.axes(nodes)),
        }
    }

    /// The axes (columns) of its components.
    fn axes(&self, nodes: &[NodeMotion]) -> Matrix3<f64> {
        match self.quantity.axes {
            Axes::Model | Axes::End(_) => Matrix3::identity(),
            Axes::Fixed(axes) => axes,
            Axes::Node(node) => nodes[node].rotation,
        }
    }

    /// w, of rotations `R_a w`.
    fn vector(&self, nodes: &[NodeMotion], frame: &TurningFrame) -> Vector3<f64> {
        let (b, a) = ends(&self.quantity, nodes);
        let less =
            |of: &dyn Fn(&NodeMotion) -> Vector3<f64>| of(b) - a.map_or_else(Vector3::zeros, of);
        match self.quantity.vector {
            NodeVector::Position | NodeVector::Displacement => {
                less(&|node| node.position) - self.offset
            }
            NodeVector::Velocity => less(&|node| node.velocity),
            NodeVector::VelocityInSpace => less(&|node| node.velocity_in_space(frame)),
            NodeVector::AngularVelocity => less(&|node| node.angular_velocity),
            NodeVector::AngularVelocityInSpace => {
                less(&|node| node.angular_velocity_in_space(frame))
            }
            NodeVector::Momentum => less(&|node| node.momentum),
            NodeVector::AngularMomentum => less(&|node| node.angular_momentum),
            NodeVector::Rotation | NodeVector::Attitude => {
                let w = vector::from_rotation(&(attitude(b, a) * self.undeformed));
                a.map_or(w, |a| a.rotation * w)
            }
            NodeVector::Euler(axes) => euler_angles(&attitude(b, a), axes),
        }
    }

    /// Adds its derivatives. The derivatives of [`NodeVector::Euler`] are not available.
    pub fn gradient(&self, nodes: &[NodeMotion], frame: &TurningFrame, row: &mut ReadingRow<'_>) {
        let NodeQuantity {
            node,
            against,
            part,
            ..
        } = self.quantity;
        let w = self.vector(nodes, frame);
        let axes = self.axes(nodes);
        let e = axes * part.slope(&(axes.transpose() * w));
        let mut both = |variable, slope: &Vector3<f64>| {
            row.by_node(node, variable, slope);
            if let Some(against) = against {
                row.by_node(against, variable, &-slope);
            }
        };
        match self.quantity.vector {
            NodeVector::Position | NodeVector::Displacement => both(Variable::Position, &e),
            NodeVector::Velocity => both(Variable::Velocity, &e),
            NodeVector::VelocityInSpace => {
                both(Variable::Velocity, &e);
                both(Variable::Position, &e.cross(&frame.angular_velocity));
            }
            NodeVector::AngularVelocity | NodeVector::AngularVelocityInSpace => {
                both(Variable::AngularVelocity, &e);
            }
            NodeVector::Momentum => both(Variable::Momentum, &e),
            NodeVector::AngularMomentum => both(Variable::AngularMomentum, &e),
            NodeVector::Rotation | NodeVector::Attitude | NodeVector::Euler(_) => {
                let (_, a) = ends(&self.quantity, nodes);
                let into = a.map_or_else(Matrix3::identity, |a| a.rotation);
                let inverse = vector::tangent_inverse(&into.tr_mul(&w));
                let slope = inverse.tr_mul(&into.tr_mul(&e));
                both(Variable::Rotation, &(into * slope));
                if let (Some(against), Part::Component(_)) = (against, part) {
                    row.by_node(against, Variable::Rotation, &w.cross(&e));
                }
            }
        }
        if let (Axes::Node(node), Part::Component(_)) = (self.quantity.axes, part) {
            row.by_node(node, Variable::Rotation, &e.cross(&w));
        }
    }
}

/// Motion of b, and of a if there is one.
fn ends<'a>(
    quantity: &NodeQuantity,
    nodes: &'a [NodeMotion],
) -> (&'a NodeMotion, Option<&'a NodeMotion>) {
    let a = quantity.against.map(|against| &nodes[against]);
    (&nodes[quantity.node], a)
}

/// `R_a^T R_b`.
fn attitude(b: &NodeMotion, a: Option<&NodeMotion>) -> Matrix3<f64> {
    match a {
        Some(a) => a.rotation.transpose() * b.rotation,
        None => b.rotation,
    }
}

/// A reading of nodes as a scalar.
#[derive(Debug, Clone)]
pub struct Sensor {
    label: String,
    scalars: [Scalar; 1],
    reading: NodeReading,
}

impl Sensor {
    /// The unknown of a sensor called `label` of a quantity.
    pub fn output(label: &str, quantity: Quantity) -> Scalar {
        Scalar::new(ScalarSpec {
            owner: label.to_owned(),
            equation: Quantity {
                name: format!("sensed {}", quantity.name),
                ..quantity.clone()
            },
            unknown: quantity,
            has_rate: false,
            rate: None,
            start: ScalarStart::Settled,
        })
    }

    /// The sensor of a scalar (see [`Self::output`]).
    pub fn new(label: impl Into<String>, scalar: Scalar, reading: NodeReading) -> Self {
        Self {
            label: label.into(),
            scalars: [scalar],
            reading,
        }
    }
}

impl Element for Sensor {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        self.reading.nodes()
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn acts(&self) -> bool {
        false
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        out.add_scalar(0, at.scalars.values[0]);
        out.add_scalar(0, -self.reading.value(at.nodes, at.frame));
        let Some(out) = jacobian else { return };
        out.add_scalar(0, 0, 1.0, false);
        let mut row = ReadingRow::new(0, out);
        self.reading.gradient(at.nodes, at.frame, &mut row);
    }
}
