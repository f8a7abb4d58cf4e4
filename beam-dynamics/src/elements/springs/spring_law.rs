//! The laws of a spring between two nodes: of its displacement, of its rotation, or of
//! both together.

use nalgebra::{Matrix6, Vector6};

use crate::elements::laws::{Law, Response};
use crate::elements::{Instant, Signal};
use crate::model::Scalar;

/// Laws of a spring.
#[derive(Debug, Clone, PartialEq)]
pub enum SpringLaw {
    /// Of displacement and rotation, independently; `None` without a spring.
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

    /// The independent laws, with the first of their components.
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

    /// See [`Law::bind`].
    pub(super) fn bind(&mut self, scalars: &mut Vec<Scalar>) {
        match self {
            Self::Together(law) => law.bind(scalars),
            Self::Apart {
                displacement,
                rotation,
            } => {
                let parts = [displacement, rotation].into_iter().flatten();
                parts.for_each(|law| law.bind(scalars));
            }
        }
    }

    pub(super) fn at(
        &self,
        strain: &Vector6<f64>,
        rate: &Vector6<f64>,
        now: &Instant<'_>,
    ) -> Response<6> {
        if let Self::Together(law) = self {
            return law.at(strain, rate, now);
        }
        let mut both = Response::<6>::zero();
        for (first, law) in self.apart() {
            let [strain, rate] = [strain, rate].map(|all| all.fixed_rows::<3>(first).into_owned());
            let part = law.at(&strain, &rate, now);
            both.force.fixed_rows_mut::<3>(first).copy_from(&part.force);
            let position = (first, first);
            let mut view = both
                .by_strain
                .fixed_view_mut::<3, 3>(position.0, position.1);
            view.copy_from(&part.by_strain);
            let mut view = both.by_rate.fixed_view_mut::<3, 3>(position.0, position.1);
            view.copy_from(&part.by_rate);
        }
        both
    }

    /// See [`Law::by_scalars`].
    pub(super) fn by_scalars(
        &self,
        strain: &Vector6<f64>,
        rate: &Vector6<f64>,
        now: &Instant<'_>,
        mut add: impl FnMut(usize, &Vector6<f64>, bool),
    ) {
        if let Self::Together(law) = self {
            return law.by_scalars(strain, rate, now, add);
        }
        for (first, law) in self.apart() {
            let [strain, rate] = [strain, rate].map(|all| all.fixed_rows::<3>(first).into_owned());
            law.by_scalars(&strain, &rate, now, |scalar, part, of_rate| {
                let mut force = Vector6::zeros();
                force.fixed_rows_mut::<3>(first).copy_from(part);
                add(scalar, &force, of_rate);
            });
        }
    }

    pub(super) fn energy(&self, strain: &Vector6<f64>, now: &Instant<'_>) -> f64 {
        if let Self::Together(law) = self {
            return law.energy(strain, now);
        }
        let of = |(first, law): (usize, &Law<3>)| {
            law.energy(&strain.fixed_rows::<3>(first).into_owned(), now)
        };
        self.apart().map(of).sum()
    }

    pub(super) fn stiffness_at_rest(&self) -> Matrix6<f64> {
        let zero = Vector6::zeros();
        self.at(&zero, &zero, &Instant::START).by_strain
    }

    /// Whether there can be a force, in addition to a moment.
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

    pub(super) fn has_kinks(&self) -> bool {
        match self {
            Self::Together(law) => law.has_kinks(),
            Self::Apart { .. } => self.apart().any(|part| part.1.has_kinks()),
        }
    }

    pub(super) fn keeps_energy(&self) -> bool {
        match self {
            Self::Together(law) => law.keeps_energy(),
            Self::Apart { .. } => self.apart().all(|part| part.1.keeps_energy()),
        }
    }

    pub(super) fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        match self {
            Self::Together(law) => law.signals().for_each(visit),
            Self::Apart { .. } => self
                .apart()
                .flat_map(|part| part.1.signals())
                .for_each(visit),
        }
    }
}
