//! The section solver against published and independent results.

mod closed_forms;
mod gmsh_pairs;
mod invariances;
mod reference_cases;
mod sections;
mod stresses;
