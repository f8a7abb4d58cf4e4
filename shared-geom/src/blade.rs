//! **The blade contract**: section properties at stations along a reference line, and
//! the blade file.
//!
//! Components are ordered as in [`crate::wrench::COMPONENTS`], in section axes (twist
//! included). The matrices of the stations are about the reference point of the blade,
//! which need not lie on its line; [`Blade::at`] returns them about the line. SI units.
//!
//! # Example
//!
//! ```
//! use nalgebra::{Matrix6, Vector2, Vector6};
//! use shared_geom::blade::{Blade, Interpolation, Station};
//! use shared_geom::line::{ReferenceLine, Side};
//!
//! // a uniform blade of 5 m and 2 kg/m
//! let station = |arc_length| Station {
//!     arc_length,
//!     stiffness: Matrix6::from_diagonal(&Vector6::new(1e8, 1e7, 1e7, 1e4, 1e4, 1e5)),
//!     mass: Matrix6::from_diagonal(&Vector6::new(2.0, 2.0, 2.0, 0.02, 0.01, 0.01)),
//! };
//! let blade = Blade {
//!     name: "blade".into(),
//!     line: ReferenceLine::straight(5.0),
//!     reference_point: Vector2::zeros(),
//!     stations: vec![station(0.0), station(5.0)],
//!     interpolation: Interpolation::Linear,
//!     damping: None,
//!     provenance: Default::default(),
//! };
//! assert!(blade.problems().is_empty());
//! assert!((blade.mass() - 10.0).abs() < 1e-12);
//! let (stiffness, _) = blade.at(2.5, Side::Outer);
//! assert!((stiffness[(4, 4)] - 1e4).abs() < 1e-8);
//! ```

use nalgebra::{Matrix6, Vector2};

use crate::line::ReferenceLine;
use crate::section::Provenance;

mod check;
mod compare;
mod curved;
mod evaluate;
mod file;
mod input;
mod moments;
mod problem;
mod reading;
mod remark;
mod rigid;
mod shared;
mod transform;

pub use crate::line::Side;
pub use compare::BladeDifference;
pub(crate) use curved::CurvedStation;
pub(crate) use file::parse_with;
pub use file::{VERSION, parse, read, write};
pub use input::{BLADE as BLADE_FILE, InputProblem, LINE_TABLE, read_line};
pub use moments::MassMoments;
pub use problem::BladeProblem;
pub use reading::Reading;
pub use remark::{section_remark, written_section_remark};
pub(crate) use rigid::{rigid_force, rigid_torsion};
pub(crate) use shared::PlacedProblem;

/// A blade: its line and the properties of its sections.
#[derive(Debug, Clone, PartialEq)]
pub struct Blade {
    /// Name, for messages and tables.
    pub name: String,
    /// Reference line with twist, in root axes.
    pub line: ReferenceLine,
    /// Reference point of the matrices of the stations: (y, z) from the line, in section
    /// axes [m]. Zero if they are about the line.
    pub reference_point: Vector2<f64>,
    /// Stations in order of arc length, from the root to the tip; two at one arc length
    /// are the properties on both sides of a jump.
    pub stations: Vec<Station>,
    /// Properties between stations.
    pub interpolation: Interpolation,
    /// Internal damping; `None` without damping.
    pub damping: Option<BladeDamping>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

/// Properties of one section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Arc length from the root along the reference line [m].
    pub arc_length: f64,
    /// Stiffness, 6x6 symmetric positive definite [N, N m, N m^2].
    pub stiffness: Matrix6<f64>,
    /// Mass per length, 6x6 symmetric [kg/m, kg, kg m].
    pub mass: Matrix6<f64>,
}

/// Properties between two stations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Entry by entry, linear in arc length.
    Linear,
    /// Constant, from the station on the inner side.
    Constant,
}

/// Internal damping of the sections of a blade.
#[derive(Debug, Clone, PartialEq)]
pub enum BladeDamping {
    /// `D = time K` [s].
    Proportional(f64),
    /// `D = diag(times) K`, a time for each component [s].
    Times([f64; 6]),
    /// `D` of each station, 6x6 [N s, N m s, N m^2 s].
    Viscous(Vec<Matrix6<f64>>),
}

#[cfg(test)]
mod compare_tests;
#[cfg(test)]
mod rigid_tests;
#[cfg(test)]
mod tests;
