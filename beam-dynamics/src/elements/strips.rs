//! Strips: forces of the air on points of bodies and beams.

mod air;
mod carrier;
mod columns;
mod disk;
mod driven_wind;
mod in_disk;
mod kinematics;
mod observe;
mod quantity;
mod shaft;
mod strip;
mod tip;

#[cfg(test)]
mod tests;

pub use air::{Air, LARGER_TABLES};
pub use disk::{DiskInflow, Ground, RotorDisk};
pub use driven_wind::DrivenWind;
pub use shaft::Shaft;
pub use strip::{AirStrip, StripGeometry, StripRotor};
pub use tip::TipRadius;
