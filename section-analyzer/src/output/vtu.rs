//! Field files: values on the mesh of a section as unstructured grids of VTK.
//!
//! A point (y, z) of the section is at (0, y, z): x is along the beam, as in all
//! of this program. Coordinates are in meters, values in SI units.

mod grid;
mod stress;
mod warping;

#[cfg(test)]
mod tests;

pub use stress::stress_vtu;
pub use warping::{external_warping_vtu, warping_vtu};
