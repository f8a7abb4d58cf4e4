//! Tests of the inflow models.

mod derivatives;
mod distributions;
mod flapping;
mod momentum;
mod rotor;
