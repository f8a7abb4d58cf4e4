//! Constants of a run (nodes, numbering) and variables (state).

mod axes;
mod conditions;
mod drive;
mod frame;
mod name;
mod node;
mod numbering;
mod scalar;
mod state;

pub use axes::NamingAxes;
pub use conditions::{Conditions, Loading};
pub use drive::{
    BandNoise, Doublet, Drive, DriveTable, DriveValue, Extrapolation, Formula, Harmonic,
    Interpolation, Pace, Ramp, Step, SteppedNoise, TableProblem,
};
pub use frame::TurningFrame;
pub use name::Name;
pub use node::Node;
pub use numbering::{Equation, MOTION_WORDS, NODE_UNKNOWNS, Numbering, Variable};
pub use scalar::{Quantity, Scalar, ScalarSpec, ScalarStart, Scalars};
pub use state::{NodeMotion, State};
