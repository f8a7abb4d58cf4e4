//! Effects of a distributed load on the section.

use nalgebra::{DVector, Vector6};

/// The state that a distributed load adds to the state of the internal force at the
/// section: about the reference point, in section axes, as [`super::SectionSolution`].
#[derive(Debug, Clone, PartialEq)]
pub struct DistributedState {
    /// w: warping, rows ux, uy, uz of each node of the mesh \[m\]; zero at nodes without
    /// a cell. The rigid part is removed: the stress of internal forces does no work on
    /// it.
    pub warping: DVector<f64>,
    /// w': rate of the warping along the beam, without the rate of the internal force at
    /// the section, rows as in `warping` \[-\].
    pub rate: DVector<f64>,
    /// Potential at the nodes of the mesh, with all electrodes at zero \[V\].
    pub potential: DVector<f64>,
    /// Rate of the potential along the beam, as the rate of the warping \[V/m\].
    pub potential_rate: DVector<f64>,
    /// y: generalized strain \[-, 1/m\].
    pub strain: Vector6<f64>,
    /// Force and moment per length \[N/m, N\].
    pub force_per_length: Vector6<f64>,
    /// Size of the load: the largest of the tractions and of the volume forces times the
    /// size of the section. The reference for round-off of stresses \[Pa\].
    pub pressure: f64,
    /// Difference of the generalized strain from the strain by the work on the central
    /// solutions (S-107), relative to the largest deformation \[-\].
    pub error: f64,
}
