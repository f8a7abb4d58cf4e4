//! The result of an analysis: the properties of the section for a beam, and the data to
//! recover its strains and stresses.

use crate::properties::{Centers, PrincipalAxes};
use crate::section::ImposedStrain;
use nalgebra::{DMatrix, DVector, Matrix6, Vector6};

/// Properties of a section and its central solutions.
///
/// Matrices are about the reference point, the origin of the mesh, in section axes;
/// components are in the order of [`shared_geom::wrench::COMPONENTS`].
#[derive(Debug, Clone)]
pub struct SectionSolution {
    /// Internal force per unit generalized strain (S-24), 6x6 \[N, N m, N m^2\].
    pub stiffness: Matrix6<f64>,
    /// Generalized strain per unit internal force (S-23), 6x6 \[1/N, 1/(N m), 1/(N m^2)\].
    pub compliance: Matrix6<f64>,
    /// Momentum per unit velocity, per length, 6x6 \[kg/m, kg, kg m\].
    pub mass: Matrix6<f64>,
    /// Tension, shear and mass center, from the reference point.
    pub centers: Centers,
    /// Principal axes of bending: values are bending stiffness \[N m^2\].
    pub principal_bending: PrincipalAxes,
    /// Principal axes of rotary inertia about the mass center \[kg m\]; `None`
    /// without mass.
    pub principal_inertia: Option<PrincipalAxes>,
    /// Warping per unit internal force, n x 6, rows ux, uy, uz of each node of the
    /// mesh \[m/N, 1/N\]; zero at nodes without a cell. The rigid part is removed: the
    /// stress on the section does no work on it.
    pub warping: DMatrix<f64>,
    /// Generalized strain per unit internal force for `warping`, 6x6; equal to the
    /// compliance, but computed independently \[1/N, 1/(N m), 1/(N m^2)\].
    pub strain: Matrix6<f64>,
    /// Checks of the solution.
    pub checks: Checks,
    /// Number of unknowns of the section: displacements and potentials.
    pub unknowns: usize,
    /// Effects of voltages on electrodes; `None` without electrodes.
    pub piezo: Option<PiezoSolution>,
}

/// Effects of an imposed strain on the section: about the reference point, in section axes,
/// as [`SectionSolution`].
#[derive(Debug, Clone, PartialEq)]
pub struct ImposedSolution {
    /// The state.
    pub state: ImposedStrain,
    /// Warping of the section without internal force, rows ux, uy, uz of each node of
    /// the mesh \[m\]; zero at nodes without a cell. The rigid part is removed: the
    /// stress of internal forces does no work on it.
    pub warping: DVector<f64>,
    /// Potential at the nodes of the mesh, with all electrodes at zero \[V\].
    pub potential: DVector<f64>,
    /// psi_T: generalized strain without internal force (S-92) \[-, 1/m\].
    pub free_strain: Vector6<f64>,
    /// Internal force at zero generalized strain (S-93) \[N, N m\].
    pub restrained_force: Vector6<f64>,
    /// Difference of the free strain from the strain by the work on the central solutions
    /// (S-94), relative to the largest imposed strain \[-\].
    pub error: f64,
}

/// Effects of heat and other imposed strains on a section.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ImposedSolutions {
    /// Uniform heating by one kelvin; `None` if no material expands.
    pub per_kelvin: Option<ImposedSolution>,
    /// The named states.
    pub states: Vec<ImposedSolution>,
}

/// Self-checks of the analysis; all errors are relative, and at round-off for a valid
/// result.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Checks {
    /// Error of the rigid-body identities of the assembled matrices, order of
    /// [`crate::assembly::ASSEMBLED_IDENTITIES`] \[-\].
    pub identities: [f64; 2],
    /// Last correction of the linear systems, relative to their solution \[-\]: the error
    /// removed by iterative refinement.
    pub correction: f64,
    /// Difference of the internal force of the six solutions from a unit force, as
    /// resultant of their stresses and of their nodal forces on the face,
    /// entry (i, j) times `sqrt(C_ii / C_jj)` \[-\].
    pub equilibrium: f64,
    /// Asymmetry of the generalized strains per unit internal force, relative to
    /// `sqrt(C_ii C_jj)` \[-\].
    pub asymmetry: f64,
    /// Difference of these strains from the energy compliance, relative to
    /// `sqrt(C_ii C_jj)` \[-\].
    pub decoupling: f64,
    /// Estimate, from below, of the condition number of the factored matrix in the
    /// 1-norm \[-\].
    pub condition: f64,
    /// Smallest pivot of the factorization, relative to its diagonal entry \[-\]: about
    /// 1e-16 for a section that is not connected.
    pub smallest_pivot: f64,
}

mod circuit;
mod discretization;
mod distributed;
mod end_effects;
mod piezo;
mod results;

pub use discretization::DiscretizationError;
pub use distributed::DistributedState;
pub use end_effects::{DecayingMode, EndEffects};
pub use piezo::{ElectrodeSolution, InCircuit, PiezoChecks, PiezoSolution};
