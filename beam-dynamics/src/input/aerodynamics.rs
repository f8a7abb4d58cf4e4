//! The air, airfoils and inflows: all that strips share.

use std::sync::Arc;

use shared_geom::document::Table;

use crate::elements::strips::Air;

mod air;
mod airfoil_files;
mod airfoils;
mod inflows;
mod problem;

pub use problem::StripProblem;

pub(super) use air::CARD as AIR;
pub(super) use airfoils::{Airfoils, CARD as AIRFOIL, read as read_airfoils};
pub(super) use inflows::{CARD as INFLOW, Inflow};

/// The air, the airfoils and the inflows of a model.
#[derive(Debug, Clone, Default)]
pub(super) struct Aerodynamics {
    /// The air; `None` if its card is wrong.
    pub air: Option<Arc<Air>>,
    /// Airfoils by name.
    pub airfoils: Airfoils,
    /// Inflows; `None` if one is wrong.
    pub inflows: Option<Vec<Inflow>>,
}

/// Reads `[air]`, `[airfoils]` and `[[inflow]]`.
pub(super) fn read(root: &Table<'_>) -> Aerodynamics {
    Aerodynamics {
        air: air::read(root).map(Arc::new),
        airfoils: airfoils::read(root),
        inflows: inflows::read(root),
    }
}
