//! Meshes of simple shapes, made without a mesh generator: [`Rectangle`],
//! [`Tube`], [`Ellipse`]; and
//! of sections of blades: [`blade`].
//!
//! Each returns a [`shared_geom::mesh::Mesh`] in the plane z = 0 of the file axes (mesh x
//! is the section axis y, mesh y the section axis z), its cells counterclockwise, its
//! nodes and elements numbered from one, with one physical surface and physical curves of
//! its boundaries. The boundaries run clockwise: with s the direction of a line, n = x
//! cross s (x along the beam, y right, z up) points out of the shape; the inner boundary
//! of a tube runs as its outer one, so that n points outward there too.

mod bisect;
pub mod blade;
mod builder;
mod ellipse;
mod grid;
pub mod layup;
mod problem;
mod rectangle;
mod spacing;
mod tube;

pub use ellipse::Ellipse;
pub use problem::GenerateProblem;
pub use rectangle::Rectangle;
pub use tube::Tube;

#[cfg(test)]
mod tests;
