//! The mesh of a section: from the mesh of a file to the plane mesh in meters that
//! the analysis uses, with every check that needs nothing but the mesh.
//!
//! [`SectionMesh::from_mesh`] checks that the mesh is plane, that no cell is
//! inverted and that the section is in one part, and tells all problems together.
//! [`generate`] makes meshes of simple shapes.

mod coincident;
mod components;
pub mod generate;
mod jacobian;
mod orientation;
mod plane;
mod problem;
pub mod quality;
mod section_mesh;
mod sides;

pub use problem::{Inversion, MeshProblem, Part};
pub use section_mesh::{Curve, CurveLine, MeshReport, SectionCell, SectionMesh};
