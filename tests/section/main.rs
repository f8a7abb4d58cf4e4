//! The section solver against published and independent results.

mod binary_meshes;
mod closed_forms;
mod gmsh_formats;
mod gmsh_pairs;
mod invariances;
mod reference_cases;
mod sections;
