//! Reference sizes for round-off of recovered stresses and strains, which may be zero (free
//! expansion, loads that cancel).

use super::imposed::Imposed;
use super::recoverer::Recoverer;
use super::state::PointState;
use crate::assembly::largest;
use crate::solution::DistributedState;

/// Sizes of stress and strain under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scales {
    /// The largest stress, or the largest stress of the actions on a restrained section
    /// \[Pa\].
    pub stress: f64,
    /// The largest strain, or the strain of that stress \[-\].
    pub strain: f64,
}

impl Recoverer<'_> {
    /// The sizes for stresses at the `points` that include imposed states and a distributed
    /// load.
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

    /// The largest stress \[Pa\] and strain \[-\] of fully restrained imposed states.
    fn largest_held(&self, imposed: &Imposed, points: &[PointState]) -> [f64; 2] {
        points.iter().fold([0.0, 0.0], |[stress, strain], point| {
            let free = imposed.free_strain(self.section(), point.cell, point.position);
            let held = self.stiffness(point.cell) * free;
            [largest(stress, held.amax()), largest(strain, free.amax())]
        })
    }

    /// The force of the imposed stresses, all taken in the same direction \[N\]: the
    /// reference for their resultant.
    pub(super) fn held(&self, imposed: &Imposed, points: &[PointState]) -> f64 {
        let of_point = |point: &PointState| {
            let strain = imposed.free_strain(self.section(), point.cell, point.position);
            point.area * (self.stiffness(point.cell) * strain).amax()
        };
        points.iter().map(of_point).sum()
    }
}
