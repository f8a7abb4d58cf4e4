//! The air, airfoils and inflows: all that strips share.

use std::sync::Arc;

use nalgebra::Vector3;
use rotor_aero::wind::Atmosphere;
use shared_geom::document::Table;

use super::drives;
use super::number::short_number;
use crate::elements::strips::Air;

mod air;
mod airfoil_files;
mod airfoils;
mod changes;
pub(super) mod family;
mod inflows;
mod mach;
mod problem;
pub(super) mod rotor_delay;
pub(super) mod switches;
mod unsteady;

pub use air::AirProblem;
pub use family::FamilyProblem;
pub use problem::StripProblem;

pub(super) use air::{CARD as AIR, check_boxes, check_ground, check_mach, check_steady};
pub(super) use airfoil_files::{checked as checked_airfoil, constants as airfoil_constants};
pub(super) use airfoils::{Airfoils, CARD as AIRFOIL, read as read_airfoils};
pub(super) use inflows::{CARD as INFLOW, DiskDesign, Disks, Inflow, InflowKind, OF_ROTOR};
pub(super) use mach::{MachLimit, mach_limits};

/// Density above which air is suspect: brine has up to 1200, sea water 1025 [kg/m^3].
const DENSE: f64 = 1200.0;

/// A remark on air that is denser than water.
pub(super) fn remark_on_density(atmosphere: &Atmosphere) -> Option<String> {
    let density = atmosphere.density;
    (density > DENSE).then(|| {
        let density = short_number(density, 6);
        format!("[air]: the density is {density} kg/m^3, more than of water: check the unit")
    })
}

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

impl Aerodynamics {
    /// The air if strips move in it: they share it.
    pub fn used_air(&self) -> Option<&Air> {
        let air = self.air.as_ref().filter(|air| Arc::strong_count(air) > 1);
        air.map(Arc::as_ref)
    }
}

/// Reads `[air]`, `[airfoils]` and `[[inflow]]`; `gravity` \[m/s^2\] is opposite to the vertical.
pub(super) fn read(
    root: &Table<'_>,
    gravity: &Vector3<f64>,
    drives: &drives::Catalog,
) -> Aerodynamics {
    Aerodynamics {
        air: air::read(root, gravity, drives).map(Arc::new),
        airfoils: airfoils::read(root),
        inflows: inflows::read(root),
    }
}
