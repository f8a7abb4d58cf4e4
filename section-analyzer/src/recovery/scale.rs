//! What round-off of recovered stresses and strains is measured beside: where heat strains
//! a body freely, or loads cancel, it is all there is of them.

use super::imposed::Imposed;
use super::recoverer::Recoverer;
use super::state::PointState;
use crate::assembly::largest;
use crate::solution::DistributedState;

/// Sizes of stress and strain under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scales {
    /// The largest stress, or that of what acts if nothing gave way \[Pa\].
    pub stress: f64,
    /// The largest strain, or that of such a stress \[-\].
    pub strain: f64,
}

impl Recoverer<'_> {
    /// The sizes where the stresses at the `points` are those of imposed states and of a
    /// load along the beam too.
    pub(super) fn scales(
        &self,
        imposed: Option<&Imposed>,
        added: Option<&DistributedState>,
        points: &[PointState],
    ) -> Scales {
        let found = points.iter().fold([0.0, 0.0], |[stress, strain], point| {
            let tensors = &point.tensors;
            [
                largest(stress, tensors.stress.amax()),
                largest(strain, tensors.strain.amax()),
            ]
        });
        let free = imposed.map_or([0.0; 2], |imposed| self.largest_held(imposed, points));
        let pressure = added.map_or(0.0, |state| state.pressure);
        let stress = largest(found[0], largest(free[0], pressure));
        let ratio = if found[0] > 0.0 {
            stress / found[0]
        } else {
            1.0
        };
        Scales {
            stress,
            strain: largest(free[1], found[1] * ratio),
        }
    }

    /// The largest stress \[Pa\] and strain \[-\] of imposed states, were they held.
    fn largest_held(&self, imposed: &Imposed, points: &[PointState]) -> [f64; 2] {
        points.iter().fold([0.0, 0.0], |[stress, strain], point| {
            let free = imposed.free_strain(self.section(), point.cell, point.place);
            let held = self.stiffness(point.cell) * free;
            [largest(stress, held.amax()), largest(strain, free.amax())]
        })
    }

    /// The force that the imposed stresses would have if all of them pulled the same way
    /// \[N\]: what their resultant is measured beside.
    pub(super) fn held(&self, imposed: &Imposed, points: &[PointState]) -> f64 {
        let of_point = |point: &PointState| {
            let strain = imposed.free_strain(self.section(), point.cell, point.place);
            point.area * (self.stiffness(point.cell) * strain).amax()
        };
        points.iter().map(of_point).sum()
    }
}
