//! What acts on nodes: the [`Element`] trait and its families.

use std::fmt::Debug;

use nalgebra::{Matrix3, Vector3};

use crate::model::{Drive, Loading, NodeMotion, Scalar, Scalars, TurningFrame};

pub mod beams;
pub mod bodies;
pub mod circuits;
pub mod control;
pub mod joints;
pub mod laws;
pub mod loads;
pub mod springs;

mod adapted;
mod charges;
mod constraint;
mod euler;
mod exchange;
mod local;
mod motion;
mod observation;
mod reading;
mod sensor;
mod signal;

#[cfg(test)]
mod energy_tests;
#[cfg(test)]
mod jacobian_tests;
#[cfg(test)]
mod rates_tests;
#[cfg(test)]
mod symmetry_tests;

pub use adapted::Adapted;
pub use charges::{Charges, CircuitState, ElectrodeState, Flow};
pub use constraint::{ConstraintRates, ConstraintWords, Energy, Level, PlaceJump};
pub use exchange::Exchange;
pub use local::{LocalJacobian, LocalResidual, LocalSize};
pub use motion::Motion;
pub use observation::{
    JointState, Observations, Reaction, ReactionAxes, SectionState, SpringState,
};
pub use reading::{
    Axes, JointMotion, NodeQuantity, NodeVector, Part, Reading, ReadingRow, SpringVector,
};
pub use sensor::{NodeReading, Sensor};
pub use signal::{Input, Instant, Signal, Smoothness};

/// What an element sees: the motion of its nodes, its multipliers, its scalars, and the frame.
#[derive(Debug, Clone, Copy)]
pub struct Local<'a> {
    /// Motion of the element's nodes, in its own order.
    pub nodes: &'a [NodeMotion],
    /// The element's multipliers [N, N m].
    pub multipliers: &'a [f64],
    /// The element's scalars, in its own order.
    pub scalars: Scalars<'a>,
    /// What the element remembers of accepted steps, see [`Element::memory`] [unit of each].
    pub memory: &'a [f64],
    /// The frame of the model.
    pub frame: &'a TurningFrame,
    /// Gravity and the factors of the loads.
    pub loading: &'a Loading,
}

impl<'a> Local<'a> {
    /// The instant at which signals of the element are evaluated.
    pub fn instant(&self) -> Instant<'a> {
        Instant {
            time: self.loading.time,
            scalars: self.scalars,
        }
    }
}

/// A small motion of an element's nodes, and the change of its multipliers.
#[derive(Debug, Clone, Copy)]
pub struct Along<'a> {
    /// Displacement [m] and rotation [rad] of each node.
    pub nodes: &'a [[Vector3<f64>; 2]],
    /// Change of each multiplier [N, N m].
    pub multipliers: &'a [f64],
    /// Change of each of the element's scalars, in its own order [unit of each].
    pub scalars: &'a [f64],
}

/// A part of the model that contributes to the equations of its nodes.
///
/// The residual of the system is the sum of the contributions; it vanishes in
/// motion. Force and moment rows hold what acts *on* the node, momentum rows the
/// momentum of the node minus that of the bodies. The Jacobian is exact, by the
/// spatial variation of each variable (see [`crate::model::Variable`]).
pub trait Element: Debug + Send + Sync {
    /// Name, for messages.
    fn label(&self) -> &str;

    /// Nodes on which the element acts.
    fn nodes(&self) -> &[usize];

    /// Number of multipliers (constraint equations) that the element brings.
    fn multipliers(&self) -> usize {
        0
    }

    /// The scalar unknowns on which the element acts, or which act on it: its own, and those
    /// that it shares with others.
    fn scalars(&self) -> &[Scalar] {
        &[]
    }

    /// What is differentiated how often to stand in the constraint number `constraint`.
    fn level(&self, _constraint: usize) -> Level {
        Level::Position
    }

    /// What the constraint number `constraint` holds, and what its multiplier is.
    fn constraint_words(&self, constraint: usize) -> ConstraintWords {
        ConstraintWords::numbered(constraint)
    }

    /// Tells how the constraints change by themselves: what start-up needs to find
    /// velocities and accelerations that agree with them. `false` when the element
    /// does not know.
    fn constraint_rates(&self, _at: &Local<'_>, _out: &mut ConstraintRates<'_>) -> bool {
        self.multipliers() == 0
    }

    /// Number of what it remembers of accepted steps.
    fn memory(&self) -> usize {
        0
    }

    /// Writes the memory with which a run in time begins from a state.
    fn begin(&self, _at: &Local<'_>, _memory: &mut [f64]) {}

    /// Takes notice of an accepted state: `memory` is that from which it was found, and becomes
    /// that of the steps from here on. At the times at which it changes,
    /// [`Element::next_corner`] must have a corner.
    fn accept(&self, _at: &Local<'_>, _memory: &mut [f64]) {}

    /// The longest arm from a node to a point at which the element acts in the undeformed
    /// model, or distance between two such points \[m\].
    fn reach(&self) -> f64 {
        0.0
    }

    /// Visits all that it is given from outside.
    fn each_signal<'a>(&'a self, _visit: &mut dyn FnMut(&'a Signal)) {}

    /// All that it is given over time alone.
    fn drives(&self) -> Vec<&Drive> {
        let mut drives = Vec::new();
        self.each_signal(&mut |signal| drives.extend(signal.drive()));
        drives
    }

    /// The first time after `time` at which time alone makes a corner or a jump in a signal of
    /// the element \[s\]; infinite when there is none.
    fn next_corner(&self, time: f64) -> f64 {
        let mut first = f64::INFINITY;
        self.each_signal(&mut |signal| first = first.min(signal.next_corner(time)));
        first
    }

    /// The first and the last time at which all drives of the element have a value \[s\].
    fn domain(&self) -> [f64; 2] {
        Drive::common_domain(self.drives().into_iter())
    }

    /// Whether it acts on its nodes; a sensor does not.
    fn acts(&self) -> bool {
        true
    }

    /// Whether a signal with which it acts depends on scalars.
    fn senses(&self) -> bool {
        let mut senses = false;
        self.each_signal(&mut |signal| senses |= signal.senses());
        senses
    }

    /// What its signals hold in place and jumps between two instants, at the same scalars: no
    /// motion follows that.
    fn jump(&self, _between: [&Loading; 2], _scalars: Scalars<'_>) -> Option<PlaceJump> {
        None
    }

    /// The element with what it drives by velocities held in the place that it has in the
    /// undeformed model, by as many constraints; `None` when it drives nothing so. Equilibria
    /// are found with it: a velocity says nothing of a state at rest.
    fn held(&self, _undeformed: &[NodeMotion]) -> Option<Box<dyn Element>> {
        None
    }

    /// The rotation by which it is loaded, from where that is relaxed if it counts from there,
    /// and which is known up to whole turns only, where there is one \[rad\]: it must not pass
    /// half a turn.
    fn winding(&self, _at: &Local<'_>) -> Option<Vector3<f64>> {
        None
    }

    /// Why it has no value at a state and a time, in words, where it can tell.
    fn without_value(&self, _at: &Local<'_>) -> Option<String> {
        None
    }

    /// Whether a rotation that it drives is held half a turn off: its constraints are
    /// fulfilled there too.
    fn is_turned_over(&self, _at: &Local<'_>) -> bool {
        false
    }

    /// Energy of the element.
    fn energy(&self, _at: &Local<'_>) -> Energy {
        Energy::default()
    }

    /// How it exchanges energy with what is outside of the model. Gravity does not count, the
    /// power of which is told by the momenta.
    fn exchange(&self) -> Exchange {
        let drives = self.drives();
        let has_rates = (0..self.multipliers()).any(|i| self.level(i) == Level::Velocity);
        let changes = drives.iter().any(|drive| drive.constant().is_none());
        let is_driven = changes || self.senses() || (has_rates && !drives.is_empty());
        Exchange::of(false, is_driven)
    }

    /// Whether its forces without rates are the derivatives of its energy.
    fn keeps_energy(&self) -> bool {
        true
    }

    /// Adds the residual, and where a Jacobian takes them the derivatives of it. The blocks that
    /// are added to that must be the same at every state, so that the pattern of the system is
    /// found once.
    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    );

    /// Adds the residual alone, see [`Element::evaluate`].
    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.evaluate(at, out, None);
    }

    /// Adds the derivatives alone, see [`Element::evaluate`].
    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        self.evaluate(at, &mut LocalResidual::ignored(), Some(out));
    }

    /// Whether it resists every relative motion of its nodes without constraints, as a beam
    /// does.
    fn joins_nodes(&self) -> bool {
        false
    }

    /// Relative motions of its nodes at the undeformed state that the element, beside its
    /// constraints, resists by springs or leaves free on purpose.
    fn motions(&self) -> Vec<Motion> {
        Vec::new()
    }

    /// Adds the derivative of the residual by the factor of the proportional loads.
    fn by_factor(&self, _at: &Local<'_>, _out: &mut LocalResidual) {}

    /// Adds the growth of the Jacobian with the factor of the proportional loads at
    /// fixed geometry: with the internal forces and multipliers that change `along` a
    /// small motion, and with the loads themselves. For an element whose forces are
    /// linear in its multipliers and that has no others, this is what stands here.
    fn prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        prestress_of_multipliers(self, at, along, out);
    }

    /// Tells what the element knows of a state beside its forces on the nodes: strains
    /// and internal forces of sections, reactions of joints.
    fn observe(&self, _at: &Local<'_>, _out: &mut Observations) {}

    /// The axes (columns) of a joint that turn with its first end and with its second, in the
    /// model's axes; `None` for what is no joint.
    fn end_axes(&self, _at: &Local<'_>) -> Option<[Matrix3<f64>; 2]> {
        None
    }

    /// A reading other than a reaction, in SI units, with its derivatives where `row` takes
    /// them; `None` where the element reports nothing of the kind.
    fn read(
        &self,
        _reading: &Reading,
        _at: &Local<'_>,
        _row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        None
    }

    /// Tells what it knows of charges and voltages of electrodes.
    fn charges(&self, _at: &Local<'_>, _out: &mut Charges) {}
}

/// Adds the growth of an element's Jacobian with its multipliers, which change `along` a
/// small motion, at fixed geometry.
fn prestress_of_multipliers<E: Element + ?Sized>(
    element: &E,
    at: &Local<'_>,
    along: &Along<'_>,
    out: &mut LocalJacobian,
) {
    if element.multipliers() == 0 {
        return;
    }
    let sums = at.multipliers.iter().zip(along.multipliers);
    let multipliers: Vec<_> = sums.map(|(now, change)| now + change).collect();
    let later = Local {
        multipliers: &multipliers,
        ..*at
    };
    let of = |at: &Local<'_>| {
        let mut jacobian = LocalJacobian::new(LocalSize::of(element));
        element.jacobian(at, &mut jacobian);
        jacobian
    };
    out.add_difference(&of(&later), &of(at));
}
