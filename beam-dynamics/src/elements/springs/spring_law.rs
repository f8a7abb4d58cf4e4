//! The laws of a spring between two nodes: of its displacement, of its rotation, or of
//! both together.

use nalgebra::{Matrix6, Vector6};

use crate::elements::laws::{Law, Response};
use crate::model::Drive;

/// Laws of a spring.
#[derive(Debug, Clone, PartialEq)]
pub enum SpringLaw {
    /// Of displacement and rotation, each by itself; `None` where there is no spring.
    Apart {
        /// Force by displacement.
        displacement: Option<Law<3>>,
        /// Moment by rotation.
        rotation: Option<Law<3>>,
    },
    /// Of both, which may be coupled.
    Together(Law<6>),
}

impl From<Law<6>> for SpringLaw {
    fn from(law: Law<6>) -> Self {
        Self::Together(law)
    }
}

impl SpringLaw {
    /// Force by displacement alone.
    pub fn of_displacement(law: Law<3>) -> Self {
        Self::Apart {
            displacement: Some(law),
            rotation: None,
        }
    }

    /// Moment by rotation alone.
    pub fn of_rotation(law: Law<3>) -> Self {
        Self::Apart {
            displacement: None,
            rotation: Some(law),
        }
    }

    /// The laws that stand for themselves, with the first of their components.
    fn apart(&self) -> impl Iterator<Item = (usize, &Law<3>)> {
        let parts = match self {
            Self::Apart {
                displacement,
                rotation,
            } => [displacement.as_ref(), rotation.as_ref()],
            Self::Together(_) => [None; 2],
        };
        let placed = [0, 3].into_iter().zip(parts);
        placed.filter_map(|(first, law)| Some((first, law?)))
    }

    pub(super) fn at(&self, strain: &Vector6<f64>, rate: &Vector6<f64>, time: f64) -> Response<6> {
        if let Self::Together(law) = self {
            return law.at(strain, rate, time);
        }
        let mut both = Response::<6>::zero();
        for (first, law) in self.apart() {
            let [strain, rate] = [strain, rate].map(|all| all.fixed_rows::<3>(first).into_owned());
            let part = law.at(&strain, &rate, time);
            both.force.fixed_rows_mut::<3>(first).copy_from(&part.force);
            let place = (first, first);
            let mut view = both.by_strain.fixed_view_mut::<3, 3>(place.0, place.1);
            view.copy_from(&part.by_strain);
            let mut view = both.by_rate.fixed_view_mut::<3, 3>(place.0, place.1);
            view.copy_from(&part.by_rate);
        }
        both
    }

    pub(super) fn energy(&self, strain: &Vector6<f64>, time: f64) -> f64 {
        if let Self::Together(law) = self {
            return law.energy(strain, time);
        }
        let of = |(first, law): (usize, &Law<3>)| {
            law.energy(&strain.fixed_rows::<3>(first).into_owned(), time)
        };
        self.apart().map(of).sum()
    }

    pub(super) fn stiffness_at_rest(&self) -> Matrix6<f64> {
        let zero = Vector6::zeros();
        self.at(&zero, &zero, 0.0).by_strain
    }

    /// Whether there can be a force, beside a moment.
    pub(super) fn has_force(&self) -> bool {
        !matches!(
            self,
            Self::Apart {
                displacement: None,
                ..
            }
        )
    }

    pub(super) fn is_viscous(&self) -> bool {
        match self {
            Self::Together(law) => law.is_viscous(),
            Self::Apart { .. } => self.apart().any(|part| part.1.is_viscous()),
        }
    }

    pub(super) fn keeps_energy(&self) -> bool {
        match self {
            Self::Together(law) => law.keeps_energy(),
            Self::Apart { .. } => self.apart().all(|part| part.1.keeps_energy()),
        }
    }

    pub(super) fn each_drive<'a>(&'a self, visit: &mut dyn FnMut(&'a Drive)) {
        match self {
            Self::Together(law) => law.drives().for_each(visit),
            Self::Apart { .. } => self
                .apart()
                .flat_map(|part| part.1.drives())
                .for_each(visit),
        }
    }
}
