//! The section solver against published and independent results.

mod closed_forms;
mod converged;
mod gmsh_pairs;
mod invariances;
mod quads;
mod random_sections;
mod reference_cases;
mod restrained_warping;
mod sections;
mod stresses;
