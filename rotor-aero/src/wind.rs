//! The air: atmosphere, mean wind, gusts, turbulence, and the influence of a tower.
//!
//! ```text
//! velocity(x, t) = tower[ mean(x, t) + events(x, t) + gusts(x, t) + turbulence(x, t) ]
//! ```
//!
//! [`Wind`] is this sum. It is evaluated at points of an inertial frame; its parts are written in
//! the axes of a [`WindFrame`]: x downwind, y to the left of an observer who looks downwind, z up
//! from the ground.
//!
//! # Example
//!
//! ```
//! use nalgebra::Vector3;
//! use rotor_aero::wind::{Mean, MeanWind, Shear, Wind, WindField};
//!
//! let mean = MeanWind {
//!     speed: 8.0,
//!     reference_height: 90.0,
//!     shear: Shear::Power { exponent: 0.2 },
//!     ..MeanWind::default()
//! };
//! let wind = Wind { mean: Mean::Steady(mean), ..Wind::default() };
//! let (velocity, gradient) = wind.velocity_and_gradient(&Vector3::new(0.0, 0.0, 90.0), 0.0);
//! assert!((velocity.x - 8.0).abs() < 1e-14);
//! assert!((gradient[(0, 2)] - 0.2 * 8.0 / 90.0).abs() < 1e-14);
//! ```

mod atmosphere;
mod bladed;
mod bts;
mod bytes;
mod coverage;
mod event;
mod field;
mod frame;
mod generate;
mod grid;
mod gust;
mod iec;
mod kaimal;
mod mann;
mod planes;
mod problem;
mod profile;
mod scale;
mod statistics;
mod summary;
mod table;
mod tower;
mod turbulence;
mod uniform_file;

pub use atmosphere::{Atmosphere, AtmosphereInput};
pub use bladed::{BladedInput, read_bladed, write_bladed};
pub use bts::{read_bts, write_bts};
pub use coverage::{Extent, TooSmall};
pub use event::{Event, EventShape};
pub use field::{Wind, WindField};
pub use frame::WindFrame;
pub use generate::{GeneratorInput, generate};
pub use grid::{BoxGrid, BoxValues};
pub use gust::{GustShape, TravelingGust};
pub use iec::{IecTurbine, TurbulenceCategory, WindClass};
pub use kaimal::Kaimal;
pub use mann::{MannInput, PlaneOrder, read_mann, write_mann};
pub use planes::CacheCount;
pub use problem::WindProblem;
pub use profile::{MeanWind, Shear};
pub use statistics::BoxStatistics;
pub use summary::{BladedSummary, read_summary};
pub use table::{Mean, WindOverTime, WindTable};
pub use tower::{Tower, TowerPotential, TowerShadow};
pub use turbulence::{OutsideGrid, TurbulenceBox};
pub use uniform_file::read_uniform_wind;
