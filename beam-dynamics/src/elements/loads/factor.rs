//! Growth of loads, and whether they turn with their node or section.

use crate::model::Loading;

/// The factor that multiplies a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadFactor {
    /// Factor of the loads that are constant during an analysis.
    Constant,
    /// Factor of the loads that grow in proportion.
    Proportional,
    /// Factor of the loads that act in the equilibrium of the start of a run in time alone.
    Released,
}

impl LoadFactor {
    /// Its current value [-].
    pub fn value(self, loading: &Loading) -> f64 {
        match self {
            Self::Constant => loading.constant,
            Self::Proportional => loading.proportional,
            Self::Released => loading.released,
        }
    }

    /// Its derivative by the factor of the proportional loads [-].
    pub fn derivative(self) -> f64 {
        match self {
            Self::Constant | Self::Released => 0.0,
            Self::Proportional => 1.0,
        }
    }
}

/// Whether a load keeps its direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turning {
    /// A dead load: its direction is fixed in the model's frame.
    Dead,
    /// A follower load: it turns with the node or section that carries it.
    Follower,
}
