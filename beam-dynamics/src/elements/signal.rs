//! Signals: numbers that depend on time and on what is sensed of nodes.
//!
//! With r the place of a node, or its distance from a second one, w the velocities so
//! taken, and e the direction of a component, fixed in the model or turning with the
//! angular velocity `omega_c` of a node c, what is sensed is (D-194)
//!
//! ```text
//! position           e . r                          displacement  e . r - e_0 . r_0
//! velocity           e . w + (omega_c x e) . r      the rate of the position
//! angular velocity   e . (omega_b - omega_a)
//! rotation           e . phi,    R(phi) = R_a^T R_b (R_a0^T R_b0)^T     in the axes of a
//! ```
//!
//! A variation theta_c of the axes turns e by `theta_c x e`, and the rotation vector
//! changes by `d phi = T^-1(phi) R_a^T (theta_b - theta_a)`.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};
use shared_geom::expression::{Expression, Jet};
use shared_geom::rotation::vector;

use super::Local;
use crate::model::{Drive, Node, NodeMotion, Variable};

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

/// A quantity that is sensed.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensor {
    sensed: Sensed,
    post: Post,
    /// The component, in the axes that it is along.
    axis: Vector3<f64>,
    /// Value in the undeformed model, of a displacement [m].
    offset: f64,
    /// `(R_a0^T R_b0)^T`.
    undeformed: Matrix3<f64>,
    /// SI units in one unit of the expression [SI unit of the quantity].
    unit: f64,
}

impl Sensor {
    /// Component number `component` (from zero) of what is sensed at `post` of a model
    /// with the given nodes, in units of `unit` \[SI unit of the quantity\].
    pub fn new(sensed: Sensed, post: Post, component: usize, unit: f64, nodes: &[Node]) -> Self {
        let [own, against] = [Some(post.node), post.against].map(|node| {
            node.map_or((Vector3::zeros(), Matrix3::identity()), |node| {
                (nodes[node].position, nodes[node].rotation)
            })
        });
        let unit_vector = Vector3::ith(component, 1.0);
        let direction = post
            .axes
            .map_or(unit_vector, |node| nodes[node].rotation * unit_vector);
        Self {
            sensed,
            post,
            axis: match sensed {
                Sensed::Rotation => against.1.transpose() * direction,
                _ => unit_vector,
            },
            offset: match sensed {
                Sensed::Displacement => direction.dot(&(own.0 - against.0)),
                _ => 0.0,
            },
            undeformed: own.1.transpose() * against.1,
            unit,
        }
    }

    /// The nodes that it senses.
    fn nodes(&self) -> impl Iterator<Item = usize> + use<> {
        let Post {
            node,
            against,
            axes,
        } = self.post;
        [Some(node), against, axes].into_iter().flatten()
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

/// An expression of time and of what is sensed.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensing {
    /// Its variables are time, then the sensors in their order.
    expression: Expression,
    sensors: Vec<Sensor>,
    /// Unit of time of the expression [s].
    second: f64,
    /// Unit of its value [unit of the signal].
    factor: f64,
}

/// A number that depends on time and on what is sensed of nodes.
#[derive(Debug, Clone, PartialEq)]
pub enum Signal {
    /// Of time alone.
    Drive(Drive),
    /// Of time and of what is sensed.
    Sensing(Arc<Sensing>),
}

impl Default for Signal {
    /// Always one.
    fn default() -> Self {
        Self::Drive(Drive::Constant(1.0))
    }
}

impl Signal {
    /// An expression whose variables are time, in units of `second` \[s\], and then the
    /// values of sensors; its value is in units of `factor`.
    pub fn sensing(
        expression: Expression,
        sensors: Vec<Sensor>,
        [second, factor]: [f64; 2],
    ) -> Self {
        Self::Sensing(Arc::new(Sensing {
            expression,
            sensors,
            second,
            factor,
        }))
    }

    /// Takes the sensed nodes among those of an element: behind, unless they are there,
    /// and the sensors are told their places.
    #[must_use]
    pub fn seated(self, nodes: &mut Vec<usize>) -> Self {
        let Self::Sensing(sensing) = self else {
            return self;
        };
        let mut place = |node: usize| match nodes.iter().position(|own| *own == node) {
            Some(place) => place,
            None => {
                nodes.push(node);
                nodes.len() - 1
            }
        };
        let mut sensing = (*sensing).clone();
        for sensor in &mut sensing.sensors {
            sensor.post = Post {
                node: place(sensor.post.node),
                against: sensor.post.against.map(&mut place),
                axes: sensor.post.axes.map(&mut place),
            };
        }
        Self::Sensing(Arc::new(sensing))
    }

    /// Whether it depends on what is sensed.
    pub fn senses(&self) -> bool {
        matches!(self, Self::Sensing(_))
    }

    /// The nodes that it senses.
    pub fn nodes(&self) -> Vec<usize> {
        match self {
            Self::Drive(_) => Vec::new(),
            Self::Sensing(sensing) => sensing.sensors.iter().flat_map(Sensor::nodes).collect(),
        }
    }

    /// Its value for an element among whose nodes it is seated \[unit of the signal\].
    pub fn value(&self, at: &Local<'_>) -> f64 {
        match self {
            Self::Drive(drive) => drive.at(at.loading.time).value,
            Self::Sensing(sensing) => {
                let variable = |index| Jet::constant(sensing.variable(index, at));
                sensing.factor * sensing.expression.at(variable).value
            }
        }
    }

    /// Tells `add` its derivatives: place of the node, variable, row.
    pub fn gradient(&self, at: &Local<'_>, mut add: impl FnMut(usize, Variable, Vector3<f64>)) {
        let Self::Sensing(sensing) = self else {
            return;
        };
        for (i, sensor) in sensing.sensors.iter().enumerate() {
            let jet = sensing.expression.at(|index| {
                let value = sensing.variable(index, at);
                match index == i + 1 {
                    true => Jet::variable(value),
                    false => Jet::constant(value),
                }
            });
            let slope = sensing.factor * jet.first / sensor.unit;
            let mut scaled = |place, variable, row| add(place, variable, slope * row);
            sensor.sense(at.nodes, &mut scaled);
        }
    }

    /// The drive that it is, where it senses nothing.
    pub fn drive(&self) -> Option<&Drive> {
        match self {
            Self::Drive(drive) => Some(drive),
            Self::Sensing(_) => None,
        }
    }

    /// The first corner or jump after `time` that time alone makes \[s\].
    pub fn next_corner(&self, time: f64) -> f64 {
        match self {
            Self::Drive(drive) => drive.next_corner(time),
            Self::Sensing(sensing) => {
                let variable = |index, time: f64| match index {
                    0 => Jet::line(time / sensing.second, 1.0 / sensing.second),
                    // What is sensed is not known ahead, and nothing follows from it.
                    _ => Jet::constant(f64::NAN),
                };
                sensing.expression.next_corner(time, variable)
            }
        }
    }
}

impl Sensing {
    fn variable(&self, index: usize, at: &Local<'_>) -> f64 {
        match index.checked_sub(1) {
            None => at.loading.time / self.second,
            Some(i) => {
                let sensor = &self.sensors[i];
                sensor.sense(at.nodes, &mut |_, _, _| {}) / sensor.unit
            }
        }
    }
}
