//! What a beam model needs of a section, from its compliance and mass: stiffness,
//! centers and principal axes.

mod centers;
mod difference;
mod principal;
mod scaled;

pub use centers::Centers;
pub use difference::{Difference, Entry, Part, radius_of_gyration};
pub use principal::PrincipalAxes;
pub use scaled::{invert_symmetric, scaled_difference};
