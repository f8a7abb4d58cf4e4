//! Sections from files: compared with sections whose cells are known in closed form, and
//! files of any content.

// A failed unwrap fails the test, with its line.
#![allow(clippy::unwrap_used)]

mod electrodes;
mod follow;
mod laminae;
mod layup_schema;
mod mesh_files;
mod models;
mod moved_nodes;
#[path = "../../../shared-geom/tests/robust/mutation.rs"]
mod mutation;
mod robust;
mod schema;
mod temperatures;
