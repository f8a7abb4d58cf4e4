//! Performance of rigid rotors: turbines, propellers and lifting rotors in steady wind.
//!
//! [`RigidRotor::performance`] is a pure function: annular momentum at each station and azimuth,
//! the trapezoidal rule along the span with zero loads at hub and tip, the mean over the azimuth;
//! [`RigidRotor::with_panels`] gives a blade of few stations enough of them.
//! The core has the signs of propellers; [`Machine`] converts at the border.

mod balance;
mod blade;
mod coefficients;
mod operating;
mod panels;
mod performance;
mod stall_delay;

pub use balance::{BalanceOutcome, balanced_speed, pitch_for_power};
pub use blade::{AnnulusRadius, Machine, RigidRotor, Station};
pub use coefficients::{HelicopterCoefficients, PropellerCoefficients, TurbineCoefficients};
pub use operating::OperatingPoint;
pub use performance::{Performance, Sector, SpanLoad};
