//! Airfoils, propellers, wind turbines and lifting rotors against measurements, published tables and
//! other programs.

mod airfoils;
mod compare;
mod hover;
mod measured_propellers;
mod propellers;
#[path = "../../../tests/common/record.rs"]
mod record;
#[path = "../support/mod.rs"]
mod support;
mod turbines;
mod wake;
