//! Materials: elastic laws, what makes them admissible, their stiffness in section
//! axes, and their strengths.

mod admissibility;
mod elastic;
mod orientation;
mod strength;

pub use admissibility::MaterialProblem;
pub use elastic::{ElasticLaw, EngineeringConstants, Material};
pub(crate) use orientation::MATERIAL_ORDER;
pub use orientation::{material_axes, section_stiffness, section_strain};
pub use strength::{
    DEFAULT_INTERACTION, DirectionalLimits, MaterialLimits, StrainLimit, Strength, StrengthProblem,
    UniformLimits,
};
