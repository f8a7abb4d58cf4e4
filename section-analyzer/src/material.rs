//! Materials: elastic and electric laws, their admissibility, their stiffness in section
//! axes and its derivatives, and their strengths.

mod admissibility;
mod coupled;
mod derivative;
mod elastic;
mod electric;
mod electric_checks;
mod fatigue;
mod orientation;
#[cfg(test)]
pub(crate) mod samples;
mod strength;
mod turned;

pub use admissibility::MaterialProblem;
pub use coupled::{CoupledLaw, coupled_law, turned_coupling};
pub use derivative::{Constant, fiber_angle_rate, plane_angle_rate};
pub use elastic::{ElasticLaw, EngineeringConstants, Material};
pub use electric::{ElectricLaw, VACUUM_PERMITTIVITY};
pub use electric_checks::{Coupling, ElectricProblem, MeasuredAt};
pub use fatigue::{Fatigue, Slopes};
pub(crate) use orientation::MATERIAL_ORDER;
pub use orientation::{material_axes, section_stiffness, section_strain};
pub use strength::{
    DEFAULT_INTERACTION, DirectionalLimits, MaterialLimits, StrainLimit, Strength, StrengthProblem,
    UniformLimits,
};
pub use turned::{AxesProblem, data_axes};
