//! Materials: elastic laws, what makes them admissible, and their stiffness
//! in section axes.

mod admissibility;
mod elastic;
mod orientation;

pub use admissibility::MaterialProblem;
pub use elastic::{ElasticLaw, EngineeringConstants, Material};
pub use orientation::{material_axes, section_stiffness};
