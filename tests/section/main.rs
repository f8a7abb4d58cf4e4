//! The section solver against published and independent results.

mod binary_meshes;
mod blade_sections;
mod blade_spars;
mod closed_forms;
mod converged;
mod curved_lines;
mod curved_references;
mod distributed_loads;
#[path = "../common/effort.rs"]
mod effort;
mod end_effects;
mod external_matrices;
mod gmsh_formats;
mod gmsh_pairs;
mod imposed;
mod invariances;
mod line_cells;
mod line_features;
mod lines;
mod mesh_error;
mod piezo;
mod piezo_recovery;
mod prestress;
mod quads;
mod rainflow;
mod random_sections;
#[path = "../common/record.rs"]
mod record;
mod reference_cases;
mod restrained_warping;
mod sections;
mod sensitivities;
mod stresses;
