//! The real program on real files: its output, its files, its exit codes.

// A failed unwrap fails the test, with its line.
#![allow(clippy::unwrap_used)]

mod analyze;
mod bad_files;
mod bad_property_files;
mod bad_section;
mod blade;
mod blade_cache;
mod blade_options;
mod blade_report;
mod compare;
mod curvature;
mod distributed;
#[path = "../../../tests/common/effort.rs"]
mod effort;
mod electric;
mod electrodes;
mod help;
mod imposed;
mod layup;
mod many;
mod matrices;
mod mesh_checks;
mod mesh_error;
mod prestress;
mod property_files;
mod report_stress;
mod sensitivity;
mod strength;
mod strength_tables;
mod stress;
mod unchanged;
#[path = "../../../tests/common/unpacked.rs"]
mod unpacked;
mod whole_blade;
mod workplace;
