//! Inflow of a strip: by the momentum of its annulus, or by a disk.

use crate::momentum::Options;
use crate::wake::{Forcing, TimeScale};

/// Wake of an annulus.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Wake {
    /// In equilibrium with the loads at all times.
    #[default]
    Equilibrium,
    /// With the two lags of Oye and the given time constants, by the velocities of the annulus; they
    /// follow the quasi-steady velocities of the given origin. [`Forcing::Thrust`] has no smooth form
    /// and is taken as [`Forcing::Lagged`].
    Dynamic(TimeScale, Forcing),
}

impl Wake {
    /// Whether the velocities follow the steady state, which then has unknowns of its own.
    pub fn has_steady(&self) -> bool {
        matches!(self, Self::Dynamic(_, Forcing::Steady))
    }

    /// Number of its unknowns.
    pub(super) fn unknowns(&self) -> usize {
        match self {
            Self::Equilibrium => 2,
            Self::Dynamic(..) if self.has_steady() => 6,
            Self::Dynamic(..) => 4,
        }
    }
}

/// Inflow by the momentum of an annulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnnularInflow {
    /// Number of blades.
    pub blades: usize,
    /// Radius at which the blades begin [m].
    pub hub_radius: f64,
    /// Switches.
    pub options: Options,
    /// Wake.
    pub wake: Wake,
}

/// Inflow of a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StripInflow {
    /// By the momentum of its annulus.
    Annular(AnnularInflow),
    /// The same, distributed over the azimuth or changed by the ground: the velocity at the strip is an
    /// unknown before the mean of the annulus. Its row has the value of the unknown, from which the user of the strip subtracts
    /// the distribution's.
    Distributed(AnnularInflow),
    /// By a model of the disk: the velocity against the shaft is an unknown of the strip, its row has
    /// the value of the unknown, from which the user of the strip subtracts the model's.
    Disk,
}

impl From<AnnularInflow> for StripInflow {
    fn from(inflow: AnnularInflow) -> Self {
        Self::Annular(inflow)
    }
}
