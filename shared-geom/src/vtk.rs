//! Field files: values on unstructured grids of VTK, and series of them.
//!
//! Coordinates and values are in SI units. A grid is a `.vtu` file, XML with its arrays
//! in binary; a series over time or phase is a `.pvd` file that names one grid for
//! each value.
//!
//! # References
//! - W. Schroeder, K. Martin, B. Lorensen, "The Visualization Toolkit", 4th ed.
//!   (2006): cell types, order of nodes, XML files.

mod array;
mod escape;
mod grid;
mod series;

#[cfg(test)]
mod tests;

pub use grid::{Cell, FieldFile};
pub use series::Series;
