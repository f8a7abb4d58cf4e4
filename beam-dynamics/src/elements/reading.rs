//! Readings: numbers of a state that columns show and that sensors make scalars of.

use nalgebra::{Matrix3, RowVector3, Vector3};

use super::{EnergyPart, LocalJacobian, Observations};
use crate::model::{Equation, Variable};

/// A part of a vector of a node, or of one node relative to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeQuantity {
    /// Number of the node.
    pub node: usize,
    /// The vector.
    pub vector: NodeVector,
    /// The part of it.
    pub part: Part,
    /// The node from which it is counted; `None` for the model.
    pub against: Option<usize>,
    /// Axes of the components.
    pub axes: Axes,
}

/// A vector of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NodeVector {
    /// From the origin, or from the other node \[m\].
    Position,
    /// From the undeformed place; against another node the difference of both \[m\].
    Displacement,
    /// Relative to the model's frame \[m/s\].
    Velocity,
    /// In space \[m/s\].
    VelocityInSpace,
    /// Rotation vector from the undeformed attitude \[rad\].
    Rotation,
    /// Rotation vector from the axes of the model, or of the other node \[rad\].
    Attitude,
    /// The attitude as the angles of turns about these axes of the node, one after the
    /// other (0 is x) \[rad\].
    Euler([usize; 3]),
    /// Relative to the model's frame \[rad/s\].
    AngularVelocity,
    /// In space \[rad/s\].
    AngularVelocityInSpace,
    /// Momentum of what moves with the node \[kg m/s\].
    Momentum,
    /// Angular momentum of it about the node \[kg m^2/s\].
    AngularMomentum,
}

/// A number that an element reports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reading {
    /// The share of an element in the energy of the model \[J\].
    Energy(EnergyPart),
    /// A component of a beam section at an evaluation point.
    Section {
        /// Evaluation point, from zero.
        point: usize,
        /// The generalized strain; else the internal force.
        strain: bool,
        /// Component, from zero.
        component: usize,
    },
    /// What a joint exerts on a node.
    Reaction {
        /// Number of the node.
        node: usize,
        /// The moment about the node; else the force.
        moment: bool,
        /// The part of it.
        part: Part,
        /// Axes of the components.
        axes: Axes,
    },
    /// How the second end of a joint moves against its first, in the axes of that.
    Joint {
        /// The motion.
        motion: JointMotion,
        /// The part of it.
        part: Part,
    },
    /// What a rod or a spring between two ends reports, in its own axes.
    Spring {
        /// The vector.
        vector: SpringVector,
        /// The part of it.
        part: Part,
    },
}

/// A motion of the second end of a joint against the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointMotion {
    /// From the point of the first end to that of the second \[m\].
    Displacement,
    /// Rotation vector, at most half a turn \[rad\].
    Rotation,
    /// About the axis of the joint, between minus and plus half a turn \[rad\].
    Angle,
    /// Rate of the displacement \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\].
    AngularVelocity,
}

/// What a rod or a spring reports, in the axes of its first node, or of a rod in its line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpringVector {
    /// Of the second end against the first; of a rod its elongation along x \[m\].
    Displacement,
    /// Rotation vector of the second end against the first \[rad\].
    Rotation,
    /// With which it resists the displacement; of a rod its tension along x \[N\].
    Force,
    /// With which it resists the rotation \[N m\].
    Moment,
}

/// A part of a vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// A component, from zero.
    Component(usize),
    /// The length of the vector.
    Magnitude,
}

/// Axes in which components are taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axes {
    /// Those of the model's frame.
    Model,
    /// Fixed in the model's frame, as columns \[-\].
    Fixed(Matrix3<f64>),
    /// Those of a node, as they are at the time.
    Node(usize),
    /// Of reactions: those of the joint that turn with its first end (0) or its second.
    End(usize),
}

impl Part {
    /// The part of a vector.
    pub fn of(self, vector: &Vector3<f64>) -> f64 {
        match self {
            Self::Component(k) => vector[k],
            Self::Magnitude => vector.norm(),
        }
    }

    /// The derivative of the part by the vector; zero for the length of no vector.
    pub fn slope(self, vector: &Vector3<f64>) -> Vector3<f64> {
        match self {
            Self::Component(k) => Vector3::ith(k, 1.0),
            Self::Magnitude => match vector.norm() {
                0.0 => Vector3::zeros(),
                length => vector / length,
            },
        }
    }

    /// The part of a vector of the model's frame in axes (columns).
    pub fn in_axes(self, vector: &Vector3<f64>, axes: &Matrix3<f64>) -> f64 {
        match self {
            Self::Component(k) => axes.column(k).dot(vector),
            Self::Magnitude => vector.norm(),
        }
    }
}

impl Reading {
    /// Whether it is a part of a sum over elements, which have its scalar in common.
    pub fn is_share(&self) -> bool {
        matches!(self, Self::Energy(_))
    }

    /// Its value among what the element reports, in SI units, with the `rotation` of a node;
    /// `None` where the element reports nothing of the kind.
    pub fn of(
        &self,
        observed: &Observations,
        rotation: impl Fn(usize) -> Matrix3<f64>,
    ) -> Option<f64> {
        match self {
            Self::Section {
                point,
                strain,
                component,
            } => {
                let section = observed.sections.get(*point)?;
                let all = match strain {
                    true => &section.strain,
                    false => &section.internal_force,
                };
                all.iter().nth(*component).copied()
            }
            Self::Energy(_) => None,
            Self::Reaction { .. } => self.reaction(observed, rotation),
            Self::Joint { motion, part } => {
                let joint = observed.joints.first()?;
                let vector = match motion {
                    JointMotion::Angle => return joint.angle,
                    JointMotion::Displacement => &joint.displacement,
                    JointMotion::Rotation => &joint.rotation,
                    JointMotion::Velocity => &joint.velocity,
                    JointMotion::AngularVelocity => &joint.angular_velocity,
                };
                Some(part.of(vector))
            }
            Self::Spring { vector, part } => {
                let spring = observed.springs.first()?;
                let vector = match vector {
                    SpringVector::Displacement => &spring.displacement,
                    SpringVector::Rotation => &spring.rotation,
                    SpringVector::Force => &spring.force,
                    SpringVector::Moment => &spring.moment,
                };
                Some(part.of(vector))
            }
        }
    }
}

impl Reading {
    fn reaction(
        &self,
        observed: &Observations,
        rotation: impl Fn(usize) -> Matrix3<f64>,
    ) -> Option<f64> {
        let Self::Reaction {
            node,
            moment,
            part,
            axes,
        } = self
        else {
            return None;
        };
        let mut reactions = observed.reactions.iter();
        let reaction = reactions.find(|reaction| reaction.node == *node)?;
        let vector = match moment {
            true => &reaction.moment,
            false => &reaction.force,
        };
        let axes = match axes {
            Axes::Model => Matrix3::identity(),
            Axes::Fixed(axes) => *axes,
            Axes::Node(node) => rotation(*node),
            Axes::End(end) => *observed.joints.first()?.axes.get(*end)?,
        };
        Some(part.in_axes(vector, &axes))
    }
}

/// Takes the derivatives of a reading: those of a scalar equation, from which the reading is
/// subtracted.
#[derive(Debug)]
pub struct ReadingRow<'a> {
    row: usize,
    out: &'a mut LocalJacobian,
}

impl<'a> ReadingRow<'a> {
    /// Those of the equation of the scalar number `row`. The derivatives of the residual of the
    /// element that is read must have been added to `out` before.
    pub(super) fn new(row: usize, out: &'a mut LocalJacobian) -> Self {
        Self { row, out }
    }

    /// Adds the derivative by a variable of a node.
    pub fn by_node(&mut self, node: usize, variable: Variable, slope: &Vector3<f64>) {
        let slope = RowVector3::from_fn(|_, i| -slope[i]);
        self.out.add_scalar_row(self.row, (node, variable), &slope);
    }

    /// Adds the derivative by a scalar of the element, or by its rate.
    pub fn by_scalar(&mut self, (scalar, rate): (usize, bool), slope: f64) {
        self.out.add_scalar(self.row, scalar, -slope, rate);
    }

    /// Adds the derivative of what the element adds to an equation of a node, along a direction.
    pub fn by_equation(&mut self, node: usize, equation: Equation, along: &Vector3<f64>) {
        self.out
            .add_equation_to_scalar(self.row, (node, equation), &-along);
    }
}
