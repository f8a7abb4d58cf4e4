//! What a run in time writes: columns of numbers, and how often.

use nalgebra::{Matrix3, Vector3};

use crate::elements::Signal;
use crate::model::Drive;

/// A number of every state that is written, with its name and its unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name, unique among the columns: letters, digits, `_`, `.` and `-`.
    pub name: String,
    /// The unit of the numbers that are written, in words.
    pub unit: String,
    /// SI units in one of it [SI unit of the quantity].
    pub factor: f64,
    /// What it is, in words.
    pub words: String,
    /// Where the number comes from.
    pub quantity: Quantity,
}

/// Where the number of a column comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// A vector of a node, or of one node relative to another.
    Node(NodeQuantity),
    /// The sum of the momenta of all nodes \[kg m/s\].
    Momentum(Part),
    /// The angular momentum of the model \[kg m^2/s\].
    AngularMomentum {
        /// The point about which it is [m].
        about: Vector3<f64>,
        /// The part of it.
        part: Part,
    },
    /// A component of what a beam tells at an evaluation point.
    Section {
        /// Name of the beam.
        beam: String,
        /// Evaluation point, from zero.
        point: usize,
        /// The generalized strain; else the internal force.
        strain: bool,
        /// Component, from zero.
        component: usize,
    },
    /// What a joint exerts on a node.
    Reaction {
        /// Name of the joint.
        joint: String,
        /// Number of the node.
        node: usize,
        /// The moment about the node; else the force.
        moment: bool,
        /// The part of it.
        part: Part,
        /// Axes of the components.
        axes: Axes,
    },
    /// How the second end of a joint moves against its first.
    Joint {
        /// Name of the joint.
        joint: String,
        /// The motion, in the axes of the first end.
        motion: JointMotion,
        /// The part of it.
        part: Part,
    },
    /// What a rod or a spring between two ends tells.
    Spring {
        /// Name of the rod or spring.
        spring: String,
        /// What of it, in its own axes.
        vector: SpringVector,
        /// The part of it.
        part: Part,
    },
    /// What is asked of an electrode.
    Electrode {
        /// Its number.
        electrode: usize,
        /// What of it.
        quantity: ElectrodeQuantity,
    },
    /// The value of a drive \[its unit\].
    Drive(Drive),
    /// A number that depends on time and on scalars \[its unit\].
    Signal(Signal),
    /// Energy of the model \[J\].
    Energy(EnergyPart),
    /// Length of the step that led to the state \[s\].
    StepLength,
    /// Iterations of that step.
    Iterations,
}

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

/// What a rod or a spring tells, in the axes of its first node, or of a rod in its line.
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

/// What is asked of an electrode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ElectrodeQuantity {
    /// Against ground \[V\].
    Voltage,
    /// Free charge \[C\].
    Charge,
    /// That flows to it \[A\].
    Current,
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

/// A part of the energy of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergyPart {
    /// Of motion in space.
    Kinetic,
    /// Stored in elastic parts.
    Elastic,
    /// Potential of gravity.
    Gravity,
    /// Of electric fields and inductances.
    Electric,
    /// The sum of them.
    Total,
}

/// How often something is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Every {
    /// Every so many steps.
    Steps(usize),
    /// At the first step at or after each multiple of a time \[s\].
    Time(f64),
}

/// What is asked to be written of a run in time.
#[derive(Debug, Clone, PartialEq)]
pub struct OutputQuestion {
    /// Columns, in their order; time stands before them.
    pub columns: Vec<Column>,
    /// How often they are written.
    pub every: Every,
    /// Whether there is a table as text.
    pub csv: bool,
    /// Whether there is a table in binary.
    pub netcdf: bool,
    /// Field files: one of so many rows has one; `None` without.
    pub vtu: Option<usize>,
    /// How often the state is kept to go on from; `None`: at the end alone.
    pub restart: Option<Every>,
}

impl Default for OutputQuestion {
    /// Every step in both tables, without columns.
    fn default() -> Self {
        Self {
            columns: Vec::new(),
            every: Every::Steps(1),
            csv: true,
            netcdf: true,
            vtu: None,
            restart: None,
        }
    }
}
