//! The flow of a rotor, its loads, and the interface of the inflow models.

use crate::real::Real;
use crate::unsteady::StateName;

/// The flow of a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorFlow<T> {
    /// Advance ratio: speed of the air in the plane of the disk over the tip speed, not
    /// negative \[-\].
    pub advance: T,
    /// Axial speed of the free stream over the tip speed, positive down through the disk: in
    /// climb \[-\].
    pub axial: T,
    /// Rotor speed, positive \[rad/s\].
    pub speed: T,
}

/// Loads of a rotor over `rho pi R^2 (Omega R)^2`, and moments over this times R.
///
/// The moments are sums over the blades of the thrust of each element, times its radius and the
/// sine or cosine of its azimuth: positive with thrust on the advancing side, and aft. They are
/// opposite to the roll and pitch moments that the rotor exerts by the usual axes of a hub.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorLoads<T> {
    /// Thrust coefficient, C_T \[-\].
    pub thrust: T,
    /// Moment toward the advancing side, C_L \[-\].
    pub sine: T,
    /// Moment toward the tail, C_M \[-\].
    pub cosine: T,
}

/// A model of the inflow.
pub trait Inflow {
    /// Names and units of the states, in their order; rows have the unit 1/s.
    fn states(&self) -> &'static [StateName];

    /// Indices of the states that are the gradients toward the advancing side and toward the tail, if
    /// the model has them.
    fn gradients(&self) -> Option<[usize; 2]> {
        None
    }

    /// Writes the states of steady flow for loads, without moments.
    ///
    /// Returns `None`, and writes nothing, unless `states` has the length of the list of states.
    fn start(&self, flow: &RotorFlow<f64>, thrust: f64, states: &mut [f64]) -> Option<()>;

    /// Writes the rows of the states.
    ///
    /// Returns `None`, and writes nothing, unless all slices have the length of the list of
    /// states.
    fn rows<T: Real>(
        &self,
        flow: &RotorFlow<T>,
        loads: &RotorLoads<T>,
        states: &[T],
        rates: &[T],
        rows: &mut [T],
    ) -> Option<()>;

    /// The induced velocity over the tip speed, positive down through the disk, at a position toward
    /// the advancing side and toward the tail, `(r sin psi, r cos psi)`, over R; `None` unless `states`
    /// has the length of the list of states. Of a model with gradients it is linear over the disk, with
    /// the first state as its mean.
    fn induced<T: Real>(&self, _flow: &RotorFlow<T>, states: &[T], position: &[T; 2]) -> Option<T> {
        linear(self, states, position)
    }
}

/// The induced velocity of a model with gradients, in any axes and units that these and the position
/// share; `None` unless `states` has the length of the list of states.
pub(super) fn linear<T: Real>(
    model: &(impl Inflow + ?Sized),
    states: &[T],
    position: &[T; 2],
) -> Option<T> {
    if states.len() != model.states().len() {
        return None;
    }
    let [one, other] = model.gradients()?.map(|index| states.get(index));
    Some(*states.first()? + *one? * position[0] + *other? * position[1])
}
