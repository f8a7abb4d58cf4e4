//! Derivatives of stiffness, mass and centers of a section.
//!
//! Parameters are the constants of its materials, the angles of its plies, and the
//! positions of its nodes. A parameter changes the matrices G = [M C L; C' E R; L' R' A] by
//! dG, and with W = [X T'; X; Y] the compliance F and the stiffness K by
//!
//! ```text
//! dF = -W' dG W + T S + S T'       S = X' dPh + dPh' X       dK = -K dF K         (S-113)
//! ```
//!
//! The second term is the rate along the beam of the work that the changed stresses of the
//! face do on the warping; on a straight beam the work of the shear forces only, on a
//! curved beam the work of all forces.
//!
//! There are two methods for dPh: a solution for each parameter, [`direct`], and the dual
//! states of the section, which serve all parameters, [`all_at_once`]. With the dual states
//! a parameter needs only an integral over its own cells,
//!
//! ```text
//! e' dG w = int [ e' dD w + (de' D w + e' D dw + e' D w dJ/J) ] J dA              (S-120)
//! ```
//!
//! of the strains e, w of two states and of their rates de, dw while the nodes move, with
//! constant values at the nodes.
//!
//! Origin and units of the domain remain constant while nodes move: all derivatives are
//! about the origin of the mesh.
//!
//! # References
//! - Giavotto et al. 1983: the central solutions.
//! - [Haug1986]: direct and dual differentiation.

mod change;
mod contraction;
mod derivative;
mod direct;
mod fields;
mod parameter;

pub use contraction::all_at_once;
pub use derivative::Derivative;
pub use direct::direct;
pub use parameter::{
    Axis, CellTurn, Cells, MeshNode, Motion, NodeVelocity, Parameter, SensitivityProblem,
};

use crate::assembly::Domain;
use crate::section::Section;
use crate::solve::{CentralSystems, Decoupled};
use nalgebra::Matrix6;

/// A section with its central solutions and their factored systems.
#[derive(Debug, Clone, Copy)]
pub struct Solved<'a> {
    /// The section.
    pub section: &'a Section,
    /// The section as solved.
    pub domain: &'a Domain,
    /// The factored systems.
    pub systems: &'a CentralSystems,
    /// The central solutions.
    pub central: &'a Decoupled,
    /// F: compliance in the units of the domain \[-\].
    pub compliance: &'a Matrix6<f64>,
}

#[cfg(test)]
mod tests;
