//! Sensors: a motion of a node as a scalar unknown, which signals read.
//!
//! With r the place of a node, or its distance from a second one, w the velocities so
//! taken, and e the direction of a component, fixed in the model or turning with the
//! angular velocity `omega_c` of a node c, the equation of the scalar s is `s - q = 0` with
//! (D-194)
//!
//! ```text
//! position           q = e . r                    displacement  q = e . r - e_0 . r_0
//! velocity           q = e . w + (omega_c x e) . r      the rate of the position
//! angular velocity   q = e . (omega_b - omega_a)
//! rotation           q = e . phi,    R(phi) = R_a^T R_b (R_a0^T R_b0)^T     in the axes of a
//! ```
//!
//! A variation theta_c of the axes turns e by `theta_c x e`, and the rotation vector
//! changes by `d phi = T^-1(phi) R_a^T (theta_b - theta_a)`.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::{Element, Local, LocalJacobian, LocalResidual};
use crate::model::{Node, NodeMotion, Quantity, Scalar, ScalarSpec, ScalarStart, Variable};

/// What is sensed of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sensed {
    /// Place.
    Position,
    /// Place less that of the undeformed model.
    Displacement,
    /// Component of the rotation vector from the undeformed attitude.
    Rotation,
    /// Rate of the position.
    Velocity,
    /// Angular velocity.
    AngularVelocity,
}

/// Where something is sensed, by numbers of nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Post {
    /// The node.
    pub node: usize,
    /// The node against which it moves; `None`: the model's frame.
    pub against: Option<usize>,
    /// The node whose axes the component is along; `None`: the model's.
    pub axes: Option<usize>,
}

impl Sensed {
    /// Its name and its unit.
    fn words(self) -> [&'static str; 2] {
        match self {
            Self::Position => ["position", "m"],
            Self::Displacement => ["displacement", "m"],
            Self::Rotation => ["rotation", "rad"],
            Self::Velocity => ["velocity", "m/s"],
            Self::AngularVelocity => ["angular velocity", "rad/s"],
        }
    }
}

/// A quantity that is sensed.
#[derive(Debug, Clone)]
pub struct Sensor {
    label: String,
    /// The nodes, once each.
    nodes: Vec<usize>,
    scalars: [Scalar; 1],
    sensed: Sensed,
    /// By places among the nodes of the element.
    post: Post,
    /// The component, in the axes that it is along.
    axis: Vector3<f64>,
    /// Value in the undeformed model, of a displacement [m].
    offset: f64,
    /// `(R_a0^T R_b0)^T`.
    undeformed: Matrix3<f64>,
}

impl Sensor {
    /// The unknown of a sensor called `label`.
    pub fn output(label: &str, sensed: Sensed) -> Scalar {
        let [name, unit] = sensed.words();
        let quantity = Quantity::new(name, unit, 1.0);
        Scalar::new(ScalarSpec {
            owner: label.to_owned(),
            equation: Quantity::new(format!("sensed {name}"), unit, 1.0),
            unknown: quantity,
            has_rate: false,
            rate: None,
            start: ScalarStart::Settled,
        })
    }

    /// The sensor of a scalar (see [`Self::output`]): component number `component` (from zero)
    /// of a quantity at `post`, of a model with the given nodes.
    pub fn new(
        label: impl Into<String>,
        (scalar, sensed): (Scalar, Sensed),
        post: Post,
        component: usize,
        nodes: &[Node],
    ) -> Self {
        let [own, against] = [Some(post.node), post.against].map(|node| {
            node.map_or((Vector3::zeros(), Matrix3::identity()), |node| {
                (nodes[node].position, nodes[node].rotation)
            })
        });
        let unit_vector = Vector3::ith(component, 1.0);
        let direction = post
            .axes
            .map_or(unit_vector, |node| nodes[node].rotation * unit_vector);
        let mut used = Vec::new();
        let mut place = |node: usize| {
            used.iter().position(|own| *own == node).unwrap_or_else(|| {
                used.push(node);
                used.len() - 1
            })
        };
        let seated = Post {
            node: place(post.node),
            against: post.against.map(&mut place),
            axes: post.axes.map(&mut place),
        };
        Self {
            label: label.into(),
            nodes: used,
            scalars: [scalar],
            sensed,
            post: seated,
            axis: match sensed {
                Sensed::Rotation => against.1.transpose() * direction,
                _ => unit_vector,
            },
            offset: match sensed {
                Sensed::Displacement => direction.dot(&(own.0 - against.0)),
                _ => 0.0,
            },
            undeformed: own.1.transpose() * against.1,
        }
    }

    /// The unknown that has its value.
    pub fn scalar(&self) -> &Scalar {
        &self.scalars[0]
    }

    /// What it finds in SI units, with `add` being told the derivatives.
    fn sense(
        &self,
        nodes: &[NodeMotion],
        add: &mut dyn FnMut(usize, Variable, Vector3<f64>),
    ) -> f64 {
        let Post {
            node,
            against,
            axes,
        } = self.post;
        let b = &nodes[node];
        let a = against.map(|node| &nodes[node]);
        let c = axes.map(|node| &nodes[node]);
        let e = c.map_or(self.axis, |c| c.rotation * self.axis);
        let spin = c.map_or(Vector3::zeros(), |c| c.angular_velocity);
        let mut both = |variable, row: Vector3<f64>| {
            add(node, variable, row);
            if let Some(against) = against {
                add(against, variable, -row);
            }
        };
        let less = |own: Vector3<f64>, other: Option<Vector3<f64>>| own - other.unwrap_or_default();
        let r = less(b.position, a.map(|a| a.position));
        match self.sensed {
            Sensed::Position | Sensed::Displacement => {
                both(Variable::Position, e);
                if let Some(axes) = axes {
                    add(axes, Variable::Rotation, e.cross(&r));
                }
                e.dot(&r) - self.offset
            }
            Sensed::Velocity => {
                let w = less(b.velocity, a.map(|a| a.velocity));
                both(Variable::Velocity, e);
                both(Variable::Position, spin.cross(&e));
                if let Some(axes) = axes {
                    add(axes, Variable::AngularVelocity, e.cross(&r));
                    let turned = e.cross(&(w + r.cross(&spin)));
                    add(axes, Variable::Rotation, turned);
                }
                e.dot(&w) + spin.cross(&e).dot(&r)
            }
            Sensed::AngularVelocity => {
                let w = less(b.angular_velocity, a.map(|a| a.angular_velocity));
                both(Variable::AngularVelocity, e);
                if let Some(axes) = axes {
                    add(axes, Variable::Rotation, e.cross(&w));
                }
                e.dot(&w)
            }
            Sensed::Rotation => {
                let into = a.map_or(Matrix3::identity(), |a| a.rotation.transpose());
                let phi = vector::from_rotation(&(into * b.rotation * self.undeformed));
                let row = vector::tangent_inverse(&phi) * into;
                both(Variable::Rotation, row.tr_mul(&self.axis));
                self.axis.dot(&phi)
            }
        }
    }
}

impl Element for Sensor {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn acts(&self) -> bool {
        false
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        out.add_scalar(0, at.scalars.values[0]);
        out.add_scalar(0, -self.sense(at.nodes, &mut |_, _, _| {}));
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        out.add_scalar(0, 0, 1.0, false);
        self.sense(at.nodes, &mut |node, variable, row| {
            out.add_scalar_row(0, (node, variable), &-row.transpose());
        });
    }
}
