//! Program 1 feeds program 2: from a mesh to frequencies compared with measurements.

#![allow(clippy::unwrap_used, reason = "a test that cannot continue fails")]

mod active_twist_rotor;
mod bimetal;
mod composite_axes;
#[allow(dead_code, reason = "this suite has no random cases")]
#[path = "../common/effort.rs"]
mod effort;
mod iea15_layup;
mod layup_strength;
mod piezo;
mod pretwisted;
mod princeton;
#[path = "../common/record.rs"]
mod record;
mod ring;
mod swept_tip;
mod tee_column;
mod trapeze;
