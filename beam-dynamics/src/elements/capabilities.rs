//! Capabilities of elements: each is a set of methods that an element implements completely or not
//! at all. No method has a default, so that a decorator cannot omit one.
//!
//! The rest of the program calls [`Queries`](super::Queries), which every element implements, also
//! without the capability.

use nalgebra::{Matrix3, Vector3};

use super::{
    Charges, ConstraintRates, ConstraintWords, Element, Energy, EnergySlope, Exchange, FixedVector,
    Level, Local, LocalJacobian, LocalResidual, Motion, Observations, PositionJump, Reading,
    ReadingRow, SmallMotion,
};
use crate::model::{Loading, NodeMotion, Scalars};

/// Declares in the `Element` of a type its capabilities: `has!(energetic: Energetic)`.
macro_rules! has {
    ($($query:ident: $capability:ident),+) => {
        $(
            fn $query(&self) -> Option<&dyn $capability> {
                Some(self)
            }
        )+
    };
}

pub(crate) use has;

/// Constraints with multipliers.
pub trait Constraints {
    /// Number of constraints, and of multipliers.
    fn count(&self) -> usize;

    /// See [`super::Queries::level`].
    fn level_of(&self, constraint: usize) -> Level;

    /// See [`super::Queries::constraint_words`].
    fn words_of(&self, constraint: usize) -> ConstraintWords;

    /// See [`super::Queries::constraint_rates`].
    fn add_rates(&self, at: &Local<'_>, out: &mut ConstraintRates<'_>) -> bool;

    /// See [`super::Queries::jump`].
    fn position_jump(&self, between: [&Loading; 2], scalars: Scalars<'_>) -> Option<PositionJump>;

    /// See [`super::Queries::held`].
    fn held_in_place(&self, undeformed: &[NodeMotion]) -> Option<Box<dyn Element>>;

    /// See [`super::Queries::is_turned_over`].
    fn turned_over(&self, at: &Local<'_>) -> bool;

    /// See [`super::Queries::end_axes`].
    fn axes_of_ends(&self, at: &Local<'_>) -> Option<[Matrix3<f64>; 2]>;
}

/// Unknowns along axes that are fixed in the model's frame, for vectors that turn with nodes.
pub trait FixedAxes {
    /// The vectors.
    fn vectors(&self) -> Vec<FixedVector>;
}

/// Numbers that an element stores at accepted steps.
pub trait Memory {
    /// Their number.
    fn size(&self) -> usize;

    /// Writes the initial memory of a run in time from a state.
    fn begin(&self, at: &Local<'_>, memory: &mut [f64]);

    /// Updates the memory after an accepted state: `memory` is the one with which the state was
    /// found, and becomes the one of the following steps. At the times at which it changes,
    /// [`Memory::next_change`] must have a corner.
    fn accept(&self, at: &Local<'_>, memory: &mut [f64]);

    /// The first time after `time` at which it may change \[s\]. The signals of the element have
    /// no corners of their own.
    fn next_change(&self, time: f64) -> f64;
}

/// Scalars of an element that Newton's method does not find from zero, as their equations have no slope
/// or a slope that changes far from their solution.
pub trait Settling {
    /// Replaces first guesses of these scalars, among the element's, by values near the ones at rest in
    /// the present motion.
    fn begin(&self, at: &Local<'_>, scalars: &mut [f64]);

    /// Replaces the values of these scalars, among the element's, by the ones at which their
    /// equations hold without rates in the present motion, with all other scalars as they are.
    fn settle(&self, at: &Local<'_>, scalars: &mut [f64]);
}

/// Energy of an element.
pub trait Energetic {
    /// See [`super::Queries::energy`].
    fn stored(&self, at: &Local<'_>) -> Energy;

    /// See [`super::Queries::exchange`].
    fn exchanged(&self) -> Exchange;

    /// See [`super::Queries::keeps_energy`].
    fn is_conservative(&self) -> bool;

    /// Source of the derivatives of its energy.
    fn slope(&self) -> EnergySlope;
}

/// Forces that grow with the proportional loads.
pub trait Growth {
    /// See [`super::Queries::by_factor`].
    fn add_by_factor(&self, at: &Local<'_>, out: &mut LocalResidual);

    /// See [`super::Queries::prestress`].
    fn add_prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian);
}

/// A part of the structure.
pub trait Structure {
    /// See [`super::Queries::reach`].
    fn arm(&self) -> f64;

    /// See [`super::Queries::joins_nodes`].
    fn is_joining(&self) -> bool;

    /// See [`super::Queries::motions`].
    fn free_motions(&self) -> Vec<Motion>;

    /// See [`super::Queries::winding`].
    fn loaded_turn(&self, at: &Local<'_>) -> Option<Vector3<f64>>;

    /// See [`super::Queries::without_value`].
    fn undefined(&self, at: &Local<'_>) -> Option<String>;
}

/// Reports of a state other than the forces on the nodes.
pub trait Reports {
    /// See [`super::Queries::observe`].
    fn report(&self, at: &Local<'_>, out: &mut Observations);

    /// See [`super::Queries::read`].
    fn reading(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64>;

    /// See [`super::Queries::charges`].
    fn report_charges(&self, at: &Local<'_>, out: &mut Charges);
}
