//! States of the section, and their forces.

use nalgebra::{DMatrix, Matrix6};

/// A state of the section in the units of the domain, up to six cases at once.
#[derive(Debug, Clone, Copy)]
pub struct State<'a> {
    /// u': derivative of the warping along the beam.
    pub rate: Rate<'a>,
    /// u: warping, n x k; zero where `None` \[-\].
    pub warping: Option<&'a DMatrix<f64>>,
    /// psi: generalized strain \[-\].
    pub strain: &'a Matrix6<f64>,
}

/// u': derivative of the warping along the beam.
#[derive(Debug, Clone, Copy)]
pub enum Rate<'a> {
    /// Zero: the state is constant along the beam.
    Zero,
    /// Of six cases per unit internal force, in their order: `u' = X T'`, which on a
    /// straight beam is minus the warping of M3 for F2, the warping of M2 for F3, and zero
    /// for the others.
    Central,
    /// Any, n x k.
    Given(&'a DMatrix<f64>),
}

/// Forces and work of a state of six cases, in the units of the domain.
#[derive(Debug, Clone)]
pub struct SectionForces {
    /// Q: at the unknowns within the section, n x 6 \[-\].
    pub within: DMatrix<f64>,
    /// P: at the unknowns on the face, n x 6 \[-\].
    pub face: DMatrix<f64>,
    /// theta: internal force, a column for each case \[-\].
    pub resultant: Matrix6<f64>,
    /// W: work of the stresses of each case on the strains of each, symmetric \[-\].
    pub work: Matrix6<f64>,
}
