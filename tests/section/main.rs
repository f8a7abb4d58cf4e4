//! The section solver against published and independent results.

mod closed_forms;
mod gmsh_pairs;
mod invariances;
#[path = "../common/record.rs"]
mod record;
mod reference_cases;
mod sections;
