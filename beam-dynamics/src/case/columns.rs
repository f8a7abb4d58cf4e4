//! Output of a run in time: columns of numbers, and how often they are written.

use nalgebra::Vector3;

use crate::elements::{
    Definition, EnergyPart, NodeQuantity, Part, Reading, RotorQuantity, Signal, StripQuantity,
};
use crate::model::Drive;

/// A number that is written for every state, with its name and its unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name, unique among the columns: letters, digits, `_`, `.` and `-`.
    pub name: String,
    /// The unit of the written numbers, as text.
    pub unit: String,
    /// SI units in one of it [SI unit of the quantity].
    pub factor: f64,
    /// Description of the quantity.
    pub words: String,
    /// Source of the number.
    pub quantity: Quantity,
}

/// Source of the number of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// A vector of a node, or of one node relative to another.
    Node(NodeQuantity),
    /// The sum of the momenta of all nodes \[kg m/s\].
    Momentum(Part),
    /// The angular momentum of the model \[kg m^2/s\].
    AngularMomentum {
        /// The point of reference of the moment [m].
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
    /// A quantity of the air at a strip, or between two strips.
    Strip {
        /// Names of the strips, with their weights, of the sum one.
        strips: Vec<(String, f64)>,
        /// The quantity.
        quantity: StripQuantity,
    },
    /// A quantity of a rotor.
    Rotor {
        /// Names of its strips.
        strips: Vec<String>,
        /// The quantity.
        quantity: RotorQuantity,
        /// Its definition.
        definition: Definition,
    },
    /// A quantity of an electrode.
    Electrode {
        /// The electrode's index.
        electrode: usize,
        /// The quantity.
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

/// A quantity of an electrode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ElectrodeQuantity {
    /// Voltage relative to ground \[V\].
    Voltage,
    /// Free charge \[C\].
    Charge,
    /// Current into it \[A\].
    Current,
}

/// How often something is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Every {
    /// Once in this number of steps.
    Steps(usize),
    /// At the first step at or after each multiple of a time \[s\].
    Time(f64),
}

/// The requested output of a run in time.
#[derive(Debug, Clone, PartialEq)]
pub struct OutputSettings {
    /// Columns, in their order; time precedes them.
    pub columns: Vec<Column>,
    /// How often they are written.
    pub every: Every,
    /// Whether a text table is written.
    pub csv: bool,
    /// Whether a binary table is written.
    pub netcdf: bool,
    /// Field files: one per this number of rows; `None` without.
    pub vtu: Option<usize>,
    /// Number of the last revolutions whose air is written; `None` without.
    pub air: Option<usize>,
    /// Whether the internal forces along blades and lines of beams are written, with envelopes.
    pub span_forces: bool,
    /// How often the state is saved for a restart; `None`: only at the end.
    pub restart: Option<Every>,
}

impl Default for OutputSettings {
    /// Every step in both tables, without columns.
    fn default() -> Self {
        Self {
            columns: Vec::new(),
            every: Every::Steps(1),
            csv: true,
            netcdf: true,
            vtu: None,
            air: None,
            span_forces: false,
            restart: None,
        }
    }
}
