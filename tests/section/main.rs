//! The section solver against published and independent results.

mod binary_meshes;
mod closed_forms;
mod converged;
mod curved_lines;
mod gmsh_formats;
mod gmsh_pairs;
mod invariances;
mod line_cells;
mod lines;
mod outside_matrices;
mod quads;
mod random_sections;
#[path = "../common/record.rs"]
mod record;
mod reference_cases;
mod restrained_warping;
mod sections;
mod stresses;
