//! The two formulations of the three-node beam, each with its test functions.
//!
//! With the section force `q = [F~; M~]` at the evaluation points and the strains W of the test
//! motion of each formulation, the forces on the nodes are
//!
//! ```text
//! force_j = - sum_points W_j^T q                                             (D-23)
//! ```
//!
//! | formulation | W | bodies | loads |
//! | --- | --- | --- | --- |
//! | variational | J0 B: the variation of the strain | nodal weights N_j | work-equivalent |
//! | finite volume | balance of portions between the points | of portions | resultants on portions |
//!
//! The variational forces are the gradient of the energy `sum J0 W(eps)`, so that the tangent at an
//! equilibrium is symmetric and undamped motion keeps its energy. The finite volumes follow
//! [Masarati]; their tangent is not symmetric even at rest, and undamped modes with few elements
//! per wave can grow. Forces, bodies and loads of the two must not be mixed: each set is consistent
//! in itself.
//!
//! Tangents are `- W^T dq` and the geometric part, by W at fixed forces.

use nalgebra::Vector3;

use super::attachment::Formulation;
use super::forces::LineForce;
use super::strain::SectionPoint;
use super::{portions, variational};
use crate::elements::LocalJacobian;
use crate::elements::carried::LoadShare;
use crate::model::Equation;

impl Formulation {
    /// Adds a force and a moment on the line at a point of portion `portion`: `add` takes the
    /// forces and moments on the nodes.
    pub(super) fn add_on_line(
        self,
        portion: usize,
        at: &SectionPoint<'_>,
        load: &LineForce,
        add: impl FnMut(usize, Equation, &Vector3<f64>),
    ) {
        match self {
            Self::Variational => variational::add_on_line(at, load, add),
            Self::FiniteVolume(_) => portions::add_on_line(portion, at, load, add),
        }
    }

    /// The part of a force and a moment on the line that acts on each node.
    pub(super) fn shares(self, portion: usize, at: &SectionPoint<'_>) -> [LoadShare; 3] {
        match self {
            Self::Variational => variational::shares(at),
            Self::FiniteVolume(_) => portions::shares(portion, at),
        }
    }

    /// Adds the variation of the terms of [`Self::add_on_line`].
    pub(super) fn add_on_line_variation(
        self,
        portion: usize,
        at: &SectionPoint<'_>,
        load: &LineForce,
        out: &mut LocalJacobian,
    ) {
        match self {
            Self::Variational => variational::add_on_line_variation(at, load, out),
            Self::FiniteVolume(_) => portions::add_on_line_variation(portion, at, load, out),
        }
    }
}
