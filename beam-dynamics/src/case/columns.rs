//! What a run in time writes: columns of numbers, and how often.

use nalgebra::Vector3;

use crate::elements::{EnergyPart, NodeQuantity, Part, Reading, Signal};
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
    /// A number that an element reports.
    Element {
        /// Name of the element.
        label: String,
        /// The number.
        reading: Reading,
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
