//! The numbers of a disk across its shaft: velocities of the air, moments of the thrust, and gradients
//! of the induced velocity.

use rotor_aero::inflow::Inflow;

use super::{DiskInflow, LOADS, STATES};
use crate::elements::{FixedAxes, FixedVector};

impl FixedAxes for DiskInflow {
    fn vectors(&self) -> Vec<FixedVector> {
        let gradients = self.disk.disk.model.gradients();
        let gradients = gradients.map(|[first, _]| STATES + first);
        let all = [Some(0), Some(LOADS + 1), gradients];
        let vector = |first| FixedVector::Scalars {
            first,
            shaft: self.disk.shaft.axis,
        };
        all.into_iter().flatten().map(vector).collect()
    }
}
