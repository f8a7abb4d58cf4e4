//! Tests of the inflow models.

mod derivatives;
mod disk;
mod distributions;
mod flapping;
mod momentum;
mod rotor;
