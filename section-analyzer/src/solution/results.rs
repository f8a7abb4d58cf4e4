//! The solution of a section from the numbers of its result files.

use nalgebra::{DMatrix, Matrix6};

use super::{Checks, SectionSolution};
use crate::properties::{Centers, PrincipalAxes, invert_symmetric};

impl SectionSolution {
    /// The solution with this stiffness \[N, N m, N m^2\], mass \[kg/m, kg, kg m\] and warping per
    /// unit internal force (n x 6 \[m/N, 1/N\]), of a section without electrodes. Its checks are
    /// zero: they have passed when these numbers were written. `None` if the stiffness is not
    /// positive definite.
    pub fn of_results(
        stiffness: &Matrix6<f64>,
        mass: &Matrix6<f64>,
        warping: DMatrix<f64>,
    ) -> Option<Self> {
        let compliance = invert_symmetric(stiffness)?;
        let centers = Centers::new(&compliance, mass);
        Some(Self {
            stiffness: *stiffness,
            compliance,
            mass: *mass,
            principal_bending: PrincipalAxes::of_bending(&compliance),
            principal_inertia: PrincipalAxes::of_mass(mass, centers.mass),
            centers,
            strain: compliance,
            checks: Checks::default(),
            unknowns: warping.nrows(),
            warping,
            piezo: None,
        })
    }
}
