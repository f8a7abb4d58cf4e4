//! The mesh of a section: converts the mesh of a file to the plane mesh in meters that
//! the analysis uses, with all checks that need only the mesh.
//!
//! [`SectionMesh::from_mesh`] checks that the mesh is plane, that no cell is inverted,
//! that cells neither overlap nor touch without sharing nodes, and that the section is in
//! one part, and reports all problems together. [`quality`] measures the shapes of the
//! cells. [`generate`] makes meshes of simple shapes.

mod alone;
mod boundary;
mod checks;
mod coincident;
mod components;
mod contact;
mod curve_sides;
mod findings;
pub mod generate;
mod jacobian;
mod laminate;
mod orientation;
mod overlap;
mod parts;
mod plane;
mod positions;
mod problem;
pub mod quality;
mod refine;
mod seams;
mod section_mesh;
mod sides;
mod words;

pub use alone::alone_in_walls;
pub use curve_sides::{Bank, CurveSide};
pub use findings::{CellOverlap, DoubledNodes, HangingNode, NarrowGap, Seam};
pub use laminate::{
    Lamina, LaminaCell, LaminaFace, LaminaProblem, LaminaSide, Laminated, Wall, add_laminae,
    of_laminae,
};
pub(crate) use overlap::is_within;
pub(crate) use parts::Sets;
pub(crate) use plane::{distance, polygon_area};
pub use problem::{Inversion, MeshProblem, Part};
pub use refine::{Refined, refined};
pub use section_mesh::{Curve, CurveLine, MeshReport, SectionCell, SectionMesh};
pub(crate) use words::{counted, short};
