//! Geometry, meshes, units and the section-property contract: the common part of both
//! programs of Helicoid.
//!
//! Axes: x along the beam, y and z in the section. Six-component vectors and
//! matrices are always ordered axial, shear y, shear z, torsion, bending y,
//! bending z (see [`wrench`]).

pub mod blade;
pub mod command_help;
pub mod document;
pub mod error;
pub mod exchange;
pub mod expression;
pub mod figure;
pub mod file_kind;
pub mod files;
pub mod frame;
pub mod gmsh;
pub mod hash;
pub mod lagrange;
pub mod line;
pub mod mesh;
pub mod mesh_file;
pub mod quadrature;
pub mod rotation;
pub mod run_lock;
pub mod section;
pub mod spline;
pub mod stream;
pub mod table;
pub mod units;
pub mod vtk;
pub mod wrench;
