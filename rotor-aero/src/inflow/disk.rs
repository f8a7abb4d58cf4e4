//! The inflow of a rotor in velocities and loads, in axes that do not turn with the rotor.
//!
//! With n along the shaft, e_1 across it, `e_2 = n x e_1`, and the velocity p of the air against the
//! hub in the disk, V against n, and the rotor speed Omega about n:
//!
//! ```text
//! aft = p/|p|              advancing = sign(Omega) n x aft         v_R = sqrt((Omega R)^2 + e^2)
//! mu = |p|/v_R             mu_z = V/v_R                            speed = v_R/R
//! CT = T/(rho pi R^2 v_R^2)      (CL, CM) = (advancing, aft) . M/(rho pi R^3 v_R^2)
//! u = v_R l(advancing . b/R, aft . b/R)
//! ```
//!
//! for the thrust `T = sum F . n` and the moments `M_i = sum F . n b_i` of forces F at the positions b
//! in the disk. States are velocities: of a model with gradients, the pair along e_1 and e_2 at the
//! radius R. The rows of a model do not depend on the velocity v_R of reference, but for the
//! distribution over the disk, so that its rounding e changes nothing at rest.

use std::f64::consts::PI;

use crate::momentum::skew_factor;
use crate::real::{Real, angle};
use crate::unsteady::StateName;

use super::ground::{ground_effect, ground_effect_of_thrust};
use super::model::InflowModel;
use super::rotor::{Inflow, RotorFlow, RotorLoads, linear};

/// Tip speed below which velocities are not measured by it [m/s].
const SLOWEST: f64 = 0.1;
/// Velocity in the disk that gives a direction to a flow without one [m/s].
const REST: f64 = 1e-6;
/// Part of the induced velocity of an annulus that turns its wake \[-\].
const WAKE: f64 = 0.6;
/// Part of the velocity across the shaft that rounds the velocity along it \[-\].
const ROUNDING: f64 = 0.02;
/// Most states of a model.
const MOST: usize = 3;

/// A disk with its model of the inflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disk {
    /// The model.
    pub model: InflowModel,
    /// Radius R [m].
    pub radius: f64,
}

/// Flow at the hub of a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiskFlow<T> {
    /// Velocity of the air against the hub along e_1 and e_2, p [m/s].
    pub in_plane: [T; 2],
    /// The same against the shaft, V: positive in climb [m/s].
    pub axial: T,
    /// Rotor speed about the shaft, Omega [rad/s].
    pub speed: T,
}

/// Loads of the air on a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiskLoads<T> {
    /// Force along the shaft, T \[N\].
    pub thrust: T,
    /// Sums of the forces along the shaft times their positions along e_1 and e_2 [N m].
    pub moments: [T; 2],
}

/// The axes of the wind, and the flow over the velocity of reference.
struct WindAxes<T> {
    reference: T,
    flow: RotorFlow<T>,
    aft: [T; 2],
    advancing: [T; 2],
}

impl<T: Real> WindAxes<T> {
    fn new(disk: &Disk, of: &DiskFlow<T>) -> Self {
        let tip = of.speed * disk.radius;
        let reference = (tip * tip + SLOWEST * SLOWEST).sqrt();
        let [p, q] = of.in_plane;
        let shifted = p + REST;
        let length = (shifted * shifted + q * q).sqrt();
        let aft = [shifted / length, q / length];
        let sense = if of.speed.re() < 0.0 { -1.0 } else { 1.0 };
        Self {
            flow: RotorFlow {
                advance: length / reference,
                axial: of.axial / reference,
                speed: reference / disk.radius,
            },
            reference,
            aft,
            advancing: [-aft[1] * sense, aft[0] * sense],
        }
    }

    /// The components toward the advancing side and aft.
    fn components(&self, of: &[T; 2]) -> [T; 2] {
        [&self.advancing, &self.aft].map(|axis| axis[0] * of[0] + axis[1] * of[1])
    }

    /// The components along e_1 and e_2 from those.
    fn back(&self, [advancing, aft]: [T; 2]) -> [T; 2] {
        [0, 1].map(|i| self.advancing[i] * advancing + self.aft[i] * aft)
    }
}

impl Disk {
    /// Names and units of the states [m/s]; rows have the unit m/s^2.
    pub fn states(&self) -> &'static [StateName] {
        self.model.states()
    }

    /// States in the axes of the wind, over the velocity of reference.
    fn turned<T: Real>(&self, axes: &WindAxes<T>, states: &[T]) -> Option<[T; MOST]> {
        let mut turned = [T::from(0.0); MOST];
        turned.get_mut(..states.len())?.copy_from_slice(states);
        if let Some([sine, cosine]) = self.model.gradients() {
            [turned[sine], turned[cosine]] = axes.components(&[turned[sine], turned[cosine]]);
        }
        Some(turned.map(|state| state / axes.reference))
    }

    /// Writes the rows of the states in air of a density [kg/m^3] [m/s^2].
    ///
    /// Rates are those in space. Returns `None`, and writes nothing, unless all slices have the length
    /// of the list of states.
    pub fn rows<T: Real>(
        &self,
        (flow, density): (&DiskFlow<T>, f64),
        loads: &DiskLoads<T>,
        (states, rates): (&[T], &[T]),
        rows: &mut [T],
    ) -> Option<()> {
        let axes = WindAxes::new(self, flow);
        let area = PI * self.radius * self.radius;
        let size = axes.reference * axes.reference * (density * area);
        let [sine, cosine] = axes.components(&loads.moments);
        let loads = RotorLoads {
            thrust: loads.thrust / size,
            sine: sine / (size * self.radius),
            cosine: cosine / (size * self.radius),
        };
        let count = states.len();
        let (own, speeds) = (self.turned(&axes, states)?, self.turned(&axes, rates)?);
        let (own, speeds) = (own.get(..count)?, speeds.get(..rates.len())?);
        self.model.rows(&axes.flow, &loads, own, speeds, rows)?;
        if let Some([sine, cosine]) = self.model.gradients() {
            [rows[sine], rows[cosine]] = axes.back([rows[sine], rows[cosine]]);
        }
        for row in rows {
            *row *= axes.reference;
        }
        Some(())
    }

    /// The induced velocity against the shaft at a position in the disk along e_1 and e_2 [m] [m/s];
    /// `None` unless `states` has the length of the list of states.
    pub fn induced<T: Real>(
        &self,
        flow: &DiskFlow<T>,
        states: &[T],
        position: &[T; 2],
    ) -> Option<T> {
        if self.model.gradients().is_some() {
            // The product of gradients and position is the same in all axes.
            return linear(&self.model, states, &position.map(|of| of / self.radius));
        }
        let axes = WindAxes::new(self, flow);
        let own = self.turned(&axes, states)?;
        let position = axes.components(position).map(|of| of / self.radius);
        let own = own.get(..states.len())?;
        let induced = self.model.induced(&axes.flow, own, &position)?;
        Some(induced * axes.reference)
    }

    /// The induced velocity at a position in the disk along e_1 and e_2 \[m\] of an annulus with a
    /// `mean` velocity u, by the skew of the wake ([`crate::momentum::skew_factor`] without loss) [m/s].
    ///
    /// ```text
    /// tan chi = |p| / |V + .6 u|
    /// ```
    ///
    /// is `(1 + .6 a) chi_0` of [`crate::momentum::wake_skew`] for small angles, with `a = -u/V`, and
    /// zero in hover.
    pub fn skewed<T: Real>(&self, flow: &DiskFlow<T>, mean: T, position: &[T; 2]) -> T {
        let axes = WindAxes::new(self, flow);
        let [_, aft] = axes.components(position);
        let across = axes.flow.advance;
        let through = axes.flow.axial + mean / axes.reference * WAKE;
        let through = (through * through + across * across * (ROUNDING * ROUNDING)).sqrt();
        let amplitude = skew_factor(angle(across, through), 1.0, T::from(0.0), None) - 1.0;
        mean * (amplitude * aft / self.radius + 1.0)
    }

    /// The factor of the ground on the induced velocity at a height of the hub above the ground [m], by
    /// the mean velocity of the model, or without states by the thrust, in air of a density
    /// [kg/m^3] \[-\].
    pub fn ground_factor<T: Real>(
        &self,
        (flow, density): (&DiskFlow<T>, f64),
        (states, thrust): (&[T], T),
        height: T,
    ) -> T {
        let axes = WindAxes::new(self, flow);
        let (height, advance) = (height / self.radius, axes.flow.advance);
        match states.first() {
            Some(mean) => ground_effect(height, advance, *mean / axes.reference),
            None => {
                let area = PI * self.radius * self.radius;
                let size = axes.reference * axes.reference * (density * area);
                ground_effect_of_thrust(height, advance, thrust / size)
            }
        }
    }

    /// The states of steady flow for a thrust \[N\] without moments, in air of a density [kg/m^3].
    pub fn steady(&self, flow: &DiskFlow<f64>, thrust: f64, density: f64) -> Vec<f64> {
        let axes = WindAxes::new(self, flow);
        let area = PI * self.radius * self.radius;
        let coefficient = thrust / (density * area * axes.reference * axes.reference);
        let mut states = vec![0.0; self.states().len()];
        // The slice has the length of the list.
        let _found = self.model.start(&axes.flow, coefficient, &mut states);
        if let Some([sine, cosine]) = self.model.gradients() {
            [states[sine], states[cosine]] = axes.back([states[sine], states[cosine]]);
        }
        states.iter().map(|state| state * axes.reference).collect()
    }
}
