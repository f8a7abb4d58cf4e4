//! From internal force back to strain and stress in the section.
//!
//! ```text
//! u = X theta      u' = X T' theta      psi = Y theta
//! eps = B1 u' + B0 u + Bpsi psi         sigma = D eps            (S-33)
//! ```
//!
//! A [`Recoverer`] holds what the load cases of a section share and gives a
//! [`Recovery`] for each: integration points, means of cells, smoothed nodes, and the
//! resultants that vouch for them. [`region_stresses`] and [`region_failures`] are what
//! a report says about it.
//!
//! All values are in SI units. Vectors of strain and stress have the usual order
//! 11 22 33 23 13 12 with engineering shear strains. In section axes 1 is x along the
//! beam, 2 is y, 3 is z; in material axes 1 is the fiber, 2 the transverse direction
//! in the ply, 3 its normal.
//!
//! # References
//! - \[Giavotto1983\]: stresses of the central solutions.

mod axes;
mod criteria;
mod extrapolate;
mod extremes;
mod locate;
mod recoverer;
mod resultant;
mod state;

pub use criteria::{Criterion, FailureIndex, Mode, failure_indices};
pub use extremes::{
    Extreme, Range, RegionFailure, RegionStresses, STRESS_NAMES, criteria_of, region_failures,
    region_stresses,
};
pub use recoverer::{Recoverer, recover};
pub use state::{CellState, LoadCase, NodalState, PointState, Recovery, Tensors};
