//! The requested stability over a parameter.

use super::{Sweep, Words};

/// The motion whose stability is analyzed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StabilityMethod {
    /// Eigenvalues about the equilibrium of the turning frame.
    Modes,
    /// Multipliers of the periodic motion.
    Floquet,
    /// Eigenvalues of the equations in multiblade coordinates, averaged over the period of the motion.
    Averaged,
}

impl StabilityMethod {
    /// Whether the roots are of a periodic motion.
    pub fn has_period(self) -> bool {
        self != Self::Modes
    }
}

/// The requested stability.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilitySettings {
    /// The parameter; its values increase or decrease.
    pub sweep: Sweep,
    /// The method.
    pub method: StabilityMethod,
    /// Whether boundaries of stability are searched between the values.
    pub boundaries: bool,
    /// Largest error of a boundary as a part of the range of the values [-].
    pub tolerance: f64,
    /// Number of roots, the least damped first; `None`: as many as the method gives.
    pub count: Option<usize>,
    /// Words for the motion of blades; `None`: of the requested modes, or else of rotors.
    pub words: Option<Words>,
}
