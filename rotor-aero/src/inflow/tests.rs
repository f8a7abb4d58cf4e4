//! Tests of the inflow models.

mod derivatives;
mod disk;
mod distributions;
mod flapping;
mod momentum;
mod rotor;

use crate::real::Real;

/// The position toward the advancing side and toward the tail at a radius over R and an azimuth.
fn polar<T: Real>(radius: T, azimuth: T) -> [T; 2] {
    let (sine, cosine) = azimuth.sin_cos();
    [radius * sine, radius * cosine]
}
