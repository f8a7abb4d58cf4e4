//! Elements, which act on nodes: the [`Element`] trait and its families.

use std::fmt::Debug;

use nalgebra::Vector3;

use crate::model::{Loading, NodeMotion, Scalar, Scalars, TurningFrame};

pub mod beams;
pub mod bodies;
pub mod circuits;
pub mod control;
pub mod joints;
pub mod laws;
pub mod loads;
pub mod springs;
pub mod strips;

mod adapted;
mod air_state;
mod capabilities;
mod carried;
mod charges;
mod constraint;
mod energy;
mod energy_rows;
mod euler;
mod exchange;
mod fixed_vector;
mod local;
mod motion;
mod observation;
mod queries;
mod reading;
mod rotor_air;
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
pub use air_state::{AirState, NO_INFLOW, RotorMotion, RotorSum, StripLocation, StripQuantity};
pub(crate) use capabilities::has;
pub use capabilities::{
    Constraints, Energetic, FixedAxes, Growth, Memory, Reports, Settling, Structure,
};
pub use charges::{Charges, CircuitState, ElectrodeState, Flow};
pub use constraint::{ConstraintRates, ConstraintWords, Level, PositionJump};
pub use energy::{Energy, EnergyPart, EnergySlope};
pub use exchange::Exchange;
pub use fixed_vector::FixedVector;
pub use local::{LocalJacobian, LocalResidual, LocalRun, LocalSize};
pub use motion::Motion;
pub use observation::{
    JointState, Observations, Reaction, ReactionAxes, SectionState, SpringState,
};
pub use queries::Queries;
pub use reading::{
    Axes, JointMotion, NodeQuantity, NodeVector, Part, Reading, ReadingRow, SpringVector,
};
pub use rotor_air::{Definition, RotorAir, RotorQuantity};
pub use sensor::{NodeReading, Sensor};
pub use signal::{Input, Instant, Signal, Smoothness};

/// Input of an element at a state: the motion of its nodes, its multipliers, its scalars, and the
/// frame.
#[derive(Debug, Clone, Copy)]
pub struct Local<'a> {
    /// Motion of the element's nodes, in the element's order.
    pub nodes: &'a [NodeMotion],
    /// The element's multipliers [N, N m].
    pub multipliers: &'a [f64],
    /// The element's scalars, in the element's order.
    pub scalars: Scalars<'a>,
    /// State stored at accepted steps, see [`Element::memory`] [unit of each].
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
pub struct SmallMotion<'a> {
    /// Displacement [m] and rotation [rad] of each node.
    pub nodes: &'a [[Vector3<f64>; 2]],
    /// Change of each multiplier [N, N m].
    pub multipliers: &'a [f64],
    /// Change of each of the element's scalars, in the element's order [unit of each].
    pub scalars: &'a [f64],
}

/// A part of the model that contributes to the equations of its nodes.
///
/// The residual of the system is the sum of the contributions; it vanishes in motion. Force and
/// moment rows contain the forces and moments *on* the node, momentum rows the momentum of the node
/// minus the momentum of its bodies. The Jacobian is exact, by the spatial variation of each
/// variable (see [`crate::model::Variable`]).
pub trait Element: Debug + Send + Sync {
    /// Name, for messages.
    fn label(&self) -> &str;

    /// Nodes on which the element acts.
    fn nodes(&self) -> &[usize];

    /// The scalar unknowns on which the element acts, or which act on it: its own ones, and shared
    /// ones.
    fn scalars(&self) -> &[Scalar] {
        &[]
    }

    /// Visits all quantities that are given to it from outside.
    fn each_signal<'a>(&'a self, _visit: &mut dyn FnMut(&'a Signal)) {}

    /// The first time after `time` at which its forces have a corner or a jump in time that is not
    /// one of its signals \[s\]: a gust that begins. Infinite if there is none.
    fn next_own_corner(&self, _time: f64) -> f64 {
        f64::INFINITY
    }

    /// Whether its forces may have a kink or a jump over the motion, by a law.
    fn has_kinks(&self) -> bool {
        false
    }

    /// Whether it acts on its nodes; a sensor does not.
    fn acts(&self) -> bool {
        true
    }

    /// Adds the residual, and its derivatives if a Jacobian takes them. The blocks written must be
    /// the same at every state, so that the pattern of the system is found once.
    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    );

    /// Its constraints, if it has any.
    fn constraints(&self) -> Option<&dyn Constraints> {
        None
    }

    /// Its memory of accepted steps, if it has one.
    fn memory(&self) -> Option<&dyn Memory> {
        None
    }

    /// Its unknowns along fixed axes, if it has any.
    fn fixed_axes(&self) -> Option<&dyn FixedAxes> {
        None
    }

    /// Its scalars that Newton's method does not find, if it has any.
    fn settling(&self) -> Option<&dyn Settling> {
        None
    }

    /// Its energy, if it stores, dissipates or exchanges any other than through its signals.
    fn energetic(&self) -> Option<&dyn Energetic> {
        None
    }

    /// Growth of its forces with the loads, if it has forces other than its multipliers.
    fn growth(&self) -> Option<&dyn Growth> {
        None
    }

    /// Its structural role, if it is a part of the structure.
    fn structure(&self) -> Option<&dyn Structure> {
        None
    }

    /// Its reports, if it has any.
    fn reports(&self) -> Option<&dyn Reports> {
        None
    }
}

/// Adds the growth of an element's Jacobian with its multipliers, which change `motion` a
/// small motion, at fixed geometry.
fn prestress_of_multipliers<E: Element + ?Sized>(
    element: &E,
    at: &Local<'_>,
    motion: &SmallMotion<'_>,
    out: &mut LocalJacobian,
) {
    if element.multipliers() == 0 {
        return;
    }
    let sums = at.multipliers.iter().zip(motion.multipliers);
    let multipliers: Vec<_> = sums.map(|(now, change)| now + change).collect();
    let later = Local {
        multipliers: &multipliers,
        ..*at
    };
    // A decorator may have more scalars.
    let size = out.size();
    let of = |at: &Local<'_>| {
        let mut jacobian = LocalJacobian::new(size);
        element.jacobian(at, &mut jacobian);
        jacobian
    };
    out.add_difference(&of(&later), &of(at));
}
