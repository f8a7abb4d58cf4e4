//! Properties of a section for a beam model, from its compliance and mass: stiffness,
//! centers and principal axes; also the geometry of its regions and the constants of
//! restrained warping.

mod areas;
mod boundary;
mod centers;
mod difference;
mod moments;
mod prestress;
mod principal;
mod restrained;
mod scaled;

pub use areas::{AreaProperties, AreaTable};
pub use boundary::Perimeter;
pub use centers::Centers;
pub use difference::{Difference, Entry, Part, radius_of_gyration};
pub use moments::{AreaMoments, SecondMoments};
pub use prestress::{FreeState, NoPrestress, prestress, prestress_of_imposed};
pub use principal::PrincipalAxes;
pub use restrained::{NoRestrainedWarping, RestrainedWarping};
pub use scaled::{invert_symmetric, scaled_difference};
