//! Distributed loads: the state that they add to the state of the internal force.
//!
//! Its generalized strain is found a second time, by the work of its stresses on the
//! central solutions, and must be the same:
//!
//! ```text
//! y = X' Q + T X' P                                                               (S-107)
//! ```

use super::Analysis;
use crate::assembly::{Rate, State, distributed_forces, largest, section_forces};
use crate::failure::Failure;
use crate::section::DistributedLoad;
use crate::solution::DistributedState;
use crate::solve::DistributedSolution;
use nalgebra::{DMatrix, Matrix6, Vector3, Vector6};
use shared_geom::wrench;

/// Loads that are solved together.
const TOGETHER: usize = 6;

impl Analysis<'_> {
    /// The state that each of `loads` adds; one solution per degree for six loads.
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`]; [`Failure::Inaccurate`] when the generalized strain from
    /// the work on the central solutions differs.
    pub fn distributed(
        &self,
        loads: &[&DistributedLoad],
    ) -> Result<Vec<DistributedState>, Failure> {
        let mut found = Vec::with_capacity(loads.len());
        for loads in loads.chunks(TOGETHER) {
            let forces = distributed_forces(self.section(), self.domain(), loads);
            let solved = self.distributed_solution(&forces)?;
            let errors = self.distributed_errors(&solved);
            for case in 0..loads.len() {
                self.require_work("the work of the distributed load", errors[case])?;
                found.push(self.distributed_in_si(loads[case], &solved, case, errors[case]));
            }
        }
        Ok(found)
    }

    /// The state under the derivatives `forces` of up to six loads, in the units of the
    /// domain.
    fn distributed_solution(
        &self,
        forces: &[DMatrix<f64>],
    ) -> Result<DistributedSolution, Failure> {
        let domain = self.domain();
        let unknowns = domain.unknowns();
        DistributedSolution::solve(domain, self.systems.steady(), self.central(), forces)
            .ok_or(Failure::OutOfMemory { unknowns })
    }

    /// The differences of the generalized strains from (S-107), relative to the largest of
    /// warping, rate and strain \[-\].
    fn distributed_errors(&self, solved: &DistributedSolution) -> Vector6<f64> {
        let (domain, central) = (self.domain(), self.central());
        let state = State {
            rate: Rate::Given(&solved.rate),
            warping: Some(&solved.x),
            strain: &solved.y,
        };
        let forces = section_forces(domain, state);
        let product = |columns| -> Matrix6<f64> {
            let product = central.x.tr_mul(columns);
            product.fixed_view::<6, 6>(0, 0).into_owned()
        };
        let along = domain.line.equilibrium().transpose();
        let work = product(&forces.within) + along * product(&forces.face);
        Vector6::from_fn(|case, _| {
            let difference = (solved.y - work).column(case).amax();
            let sizes = [&solved.x, &solved.rate].map(|field| field.column(case).amax());
            let size = largest(largest(sizes[0], sizes[1]), solved.y.column(case).amax());
            if difference == 0.0 {
                0.0
            } else {
                difference / size
            }
        })
    }

    /// Converts from the units of the domain to SI and from its origin to the origin of the
    /// mesh, as the central solutions.
    fn distributed_in_si(
        &self,
        load: &DistributedLoad,
        solved: &DistributedSolution,
        case: usize,
        error: f64,
    ) -> DistributedState {
        let scaling = &self.domain().scaling;
        let [y, z] = scaling.origin;
        let t = Vector3::new(0.0, y, z);
        let strain = solved.y.column(case).component_mul(&scaling.strain());
        let force = solved
            .resultant
            .column(case)
            .component_mul(&scaling.force())
            / scaling.length;
        DistributedState {
            warping: scaling.length * self.solved.on_mesh(&solved.x, case),
            rate: self.solved.on_mesh(&solved.rate, case),
            potential: scaling.potential * self.solved.potential_on_mesh(&solved.x, case),
            potential_rate: scaling.potential / scaling.length
                * self.solved.potential_on_mesh(&solved.rate, case),
            strain: wrench::shift_matrix(&t).transpose() * strain,
            force_per_length: wrench::shift_matrix(&-t) * force,
            pressure: self.pressure(load),
            error,
        }
    }

    /// The largest of the parts of a load \[Pa\].
    fn pressure(&self, load: &DistributedLoad) -> f64 {
        let length = self.domain().scaling.length;
        let densities = self.section().materials.iter().map(|known| known.density);
        let density = densities.fold(0.0, f64::max);
        let parts = load.parts.iter();
        parts.fold(0.0, |size, part| {
            largest(size, part.pressure(density, length))
        })
    }
}
