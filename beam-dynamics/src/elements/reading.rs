//! Readings: numbers of a state for columns and for the scalars of sensors.

use nalgebra::{Matrix3, RowVector3, Vector3};

use super::{EnergyPart, LocalJacobian, Observations, RotorSum, StripQuantity};
use crate::model::{Equation, Variable};

/// A part of a vector of a node, or of one node relative to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeQuantity {
    /// Index of the node.
    pub node: usize,
    /// The vector.
    pub vector: NodeVector,
    /// The part of the vector.
    pub part: Part,
    /// The reference node; `None` for the model.
    pub against: Option<usize>,
    /// Axes of the components.
    pub axes: Axes,
}

/// A vector of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NodeVector {
    /// From the origin, or from the other node \[m\].
    Position,
    /// From the undeformed position; relative to another node the difference of both \[m\].
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
    /// Momentum of all bodies that move with the node \[kg m/s\].
    Momentum,
    /// Angular momentum of these bodies about the node \[kg m^2/s\].
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
    /// Reaction of a joint on a node.
    Reaction {
        /// Index of the node.
        node: usize,
        /// The moment about the node; else the force.
        moment: bool,
        /// The part of the vector.
        part: Part,
        /// Axes of the components.
        axes: Axes,
    },
    /// Motion of the second end of a joint relative to its first, in the axes of the first end.
    Joint {
        /// The motion.
        motion: JointMotion,
        /// The part of the vector.
        part: Part,
    },
    /// Observation of a rod or a spring between two ends, in its own axes.
    Spring {
        /// The vector.
        vector: SpringVector,
        /// The part of the vector.
        part: Part,
    },
    /// The share of a strip in a sum over its rotor [N, N m].
    Rotor(RotorSum),
    /// A quantity of a strip times its weight in a mean \[-\].
    Strip(StripQuantity, f64),
}

/// A motion of the second end of a joint relative to the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointMotion {
    /// From the point of the first end to the point of the second \[m\].
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

/// Observations of a rod or a spring, in the axes of its first node, or for a rod along its line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpringVector {
    /// Of the second end relative to the first; for a rod its elongation along x \[m\].
    Displacement,
    /// Rotation vector of the second end relative to the first \[rad\].
    Rotation,
    /// Force against the displacement; for a rod its tension along x \[N\].
    Force,
    /// Moment against the rotation \[N m\].
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

/// Axes of components.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axes {
    /// The axes of the model's frame.
    Model,
    /// Fixed in the model's frame, as columns \[-\].
    Fixed(Matrix3<f64>),
    /// The current axes of a node.
    Node(usize),
    /// Of reactions: the axes of the joint that turn with its first end (0) or its second.
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

    /// The derivative of the part by the vector; zero for the length of a zero vector.
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
    /// Whether it is a sum over elements, with one common scalar.
    pub fn is_share(&self) -> bool {
        matches!(self, Self::Energy(_) | Self::Rotor(_) | Self::Strip(..))
    }

    /// Its value from the observations of the element, in SI units, with the `rotation` of a node;
    /// `None` if the element has no reading of this kind.
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
                let all = if *strain {
                    &section.strain
                } else {
                    &section.internal_force
                };
                all.iter().nth(*component).copied()
            }
            Self::Energy(_) => None,
            Self::Rotor(sum) => Some(sum.share(observed.air.first()?)),
            Self::Strip(quantity, weight) => Some(weight * quantity.of(observed.air.first()?)),
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
        let vector = if *moment {
            &reaction.moment
        } else {
            &reaction.force
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

/// Receives the derivatives of a reading: the derivatives of a scalar equation, from which the
/// reading is subtracted.
#[derive(Debug)]
pub struct ReadingRow<'a> {
    row: usize,
    out: &'a mut LocalJacobian,
}

impl<'a> ReadingRow<'a> {
    /// The derivatives of the equation of scalar `row`. The derivatives of the residual of the
    /// element must have been added to `out` before.
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

    /// Adds the derivative of the element's contribution to an equation of a node, along a
    /// direction.
    pub fn by_equation(&mut self, node: usize, equation: Equation, along: &Vector3<f64>) {
        self.out
            .add_equation_to_scalar(self.row, (node, equation), &-along);
    }
}
