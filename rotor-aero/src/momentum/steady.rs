//! The steady state of a ring by one unknown, the angle of the flow.
//!
//! ```text
//! k = sigma cn / (4 F sin^2 phi),  k' = sigma ct / (4 F sin phi cos phi)
//! k -> -k, k' -> -k' if phi < 0
//! a = k / (1 - k) for k >= -2/3, else a law of high induction;  a' = k' / (1 + k')
//! R(phi) = sin phi / (1 + a) - (Vx / Vy) cos phi / (1 - a') = 0,  u = a Vx,  v = a' Vy
//! ```
//!
//! Ning, Wind Energy 17 (2014) 1327; Ning, Structural and Multidisciplinary Optimization 64
//! (2021) 1227, for the general form, in which the sign of `k'` follows Vx. Here it follows phi: the
//! air that passes the disk, in either direction, takes swirl in the direction of the torque. The
//! forms differ only where the flow through the disk is against Vx. A root is bracketed in one of
//! the four quadrants. In hover and descent, `Vx < .001 |Vy|`, the state is the one of [`descent`].

use std::f64::consts::{FRAC_PI_2, PI};

use crate::airfoil::Coefficients;
use crate::momentum::annulus::{Annulus, SectionFlow};
use crate::momentum::bracket::{FIRST, first_root};
use crate::momentum::descent;
use crate::momentum::loss::loss;

/// Distance of the brackets from the axes \[rad\].
const EDGE: f64 = 1e-6;

/// Vx / Vy of climb below which the state is the one of hover and descent, by velocities: the form by
/// the angle has induction factors, which are infinite in hover.
const LEAST_AXIAL: f64 = 1e-3;

/// Smallest |Vy / Vx|.
const LEAST_IN_PLANE: f64 = 1e-6;

/// Intervals of the search in a quadrant: the second number if the first finds nothing.
const INTERVALS: [usize; 2] = [FIRST, 200];

/// Outcome of a steady state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// A state in balance.
    Solved,
    /// No state in balance: the induced velocities are zero. Sections without lift have none in
    /// hover.
    Unsolved,
    /// The air is at rest relative to the section.
    AtRest,
    /// The station is not between hub and tip: the coefficients are zero.
    End,
}

/// The steady state of a section in its ring, with signs of propellers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution {
    /// Outcome.
    pub outcome: Outcome,
    /// Induced velocity through the disk, along the free stream of climb \[m/s\].
    pub axial: f64,
    /// Induced velocity along the motion (swirl) \[m/s\].
    pub swirl: f64,
    /// The flow at the section.
    pub flow: SectionFlow<f64>,
    /// Angle of attack \[rad\].
    pub alpha: f64,
    /// Factor of loss \[-\].
    pub loss: f64,
    /// Coefficients of the section.
    pub coefficients: Coefficients<f64>,
}

/// Steady state of a ring at the pitch of its section, the axial velocity `vx` and the velocity of
/// rotation `vy`, both without induction and of any sign. `section` gives the coefficients at an
/// angle of attack. Every input has a result: see [`Outcome`].
///
/// # Examples
///
/// ```
/// use rotor_aero::airfoil::Coefficients;
/// use rotor_aero::momentum::{Annulus, Options, Outcome, solve};
///
/// let annulus = Annulus {
///     radius: 0.8,
///     hub_radius: 0.1,
///     tip_radius: 1.0,
///     blades: 2,
///     chord: 0.08,
///     options: Options::default(),
/// };
/// let section = |alpha: f64| Coefficients { lift: 6.0 * alpha, drag: 0.01, moment: 0.0 };
/// let hover = solve(&annulus, 0.15, 0.0, 100.0, section);
/// assert_eq!(hover.outcome, Outcome::Solved);
/// assert!(hover.axial > 3.0 && hover.swirl > 0.0);
/// ```
pub fn solve(
    annulus: &Annulus,
    pitch: f64,
    vx: f64,
    vy: f64,
    section: impl Fn(f64) -> Coefficients<f64>,
) -> Solution {
    let ring = Ring::new(annulus, pitch, vx, vy, section);
    if !annulus.is_interior() {
        return ring.without_induction(Outcome::End);
    }
    if vx == 0.0 && vy == 0.0 {
        return ring.without_induction(Outcome::AtRest);
    }
    if !(vx.is_finite() && vy.is_finite()) {
        return ring.without_induction(Outcome::Unsolved);
    }
    let found = if vy != 0.0 && vx < LEAST_AXIAL * vy.abs() {
        let found = descent::solve(annulus, pitch, (vx, ring.vy), &ring.section);
        found.map(|((axial, swirl), phi)| ring.solution(phi, axial, swirl))
    } else {
        ring.angle().map(|phi| {
            let Trial { axial, swirl, .. } = ring.trial(phi);
            ring.solution(phi, axial, swirl)
        })
    };
    found.unwrap_or_else(|| ring.without_induction(Outcome::Unsolved))
}

/// A section in its ring, and the air that meets it.
struct Ring<'a, S> {
    annulus: &'a Annulus,
    pitch: f64,
    given: (f64, f64),
    vx: f64,
    vy: f64,
    solidity: f64,
    section: S,
}

/// Induction at an angle of the flow.
struct Trial {
    residual: f64,
    axial: f64,
    swirl: f64,
}

impl<'a, S: Fn(f64) -> Coefficients<f64>> Ring<'a, S> {
    fn new(annulus: &'a Annulus, pitch: f64, vx: f64, vy: f64, section: S) -> Self {
        Self {
            annulus,
            pitch,
            given: (vx, vy),
            vx,
            vy: at_least(vy, LEAST_IN_PLANE * vx.abs()),
            solidity: annulus.solidity(),
            section,
        }
    }

    /// A root of the residual, where it is no pole.
    fn angle(&self) -> Option<f64> {
        let residual = |phi: f64| self.trial(phi).residual;
        let accepted = |phi: f64| self.is_root(phi).then_some(phi);
        let quadrants = quadrants(self.vx, self.vy);
        first_root(residual, &quadrants, &INTERVALS, accepted)
    }

    /// Whether the residual is zero there, and not infinite, and the flow with induction has this
    /// angle: the residual is zero for the opposite flow too.
    fn is_root(&self, phi: f64) -> bool {
        let trial = self.trial(phi);
        let (sin, cos) = phi.sin_cos();
        let along = (self.vx + trial.axial) * sin + (self.vy - trial.swirl) * cos;
        trial.residual.abs() < 1e-6 * (1.0 + (self.vx / self.vy).abs()) && along >= 0.0
    }

    fn trial(&self, phi: f64) -> Trial {
        let (sin, cos) = phi.sin_cos();
        let coefficients = (self.section)(self.pitch - phi);
        let loss = loss(self.annulus, sin);
        let (normal, tangential) = self.annulus.induction_coefficients(sin, cos, coefficients);
        let scale = self.solidity / (4.0 * loss * sin);
        let scale = scale * if phi < 0.0 { -1.0 } else { 1.0 };
        let (k, swirl) = (normal * scale / sin, tangential * scale / cos);
        // poles of the induction: any residual but zero
        if (k - 1.0).abs() < 1e-6 || (swirl + 1.0).abs() < 1e-6 {
            return Trial {
                residual: 1.0,
                axial: 0.0,
                swirl: 0.0,
            };
        }
        let law = self.annulus.options.high_induction;
        let a = -law.factor_by(-k, loss, phi * self.vx > 0.0);
        let ratio = self.vx / self.vy;
        Trial {
            // 1 / (1 - a') = 1 + k'
            residual: sin / (1.0 + a) - ratio * cos * (1.0 + swirl),
            axial: a * self.vx,
            swirl: swirl / (1.0 + swirl) * self.vy,
        }
    }

    fn solution(&self, phi: f64, axial: f64, swirl: f64) -> Solution {
        let flow = SectionFlow::of(self.vx + axial, self.vy - swirl);
        let alpha = self.pitch - phi;
        Solution {
            outcome: Outcome::Solved,
            axial,
            swirl,
            flow,
            alpha,
            loss: loss(self.annulus, flow.sin),
            coefficients: (self.section)(alpha),
        }
    }

    fn without_induction(&self, outcome: Outcome) -> Solution {
        let flow = SectionFlow::of(self.given.0, self.given.1);
        let alpha = self.pitch - flow.phi;
        let loaded = outcome != Outcome::End;
        let zero = Coefficients {
            lift: 0.0,
            drag: 0.0,
            moment: 0.0,
        };
        Solution {
            outcome,
            axial: 0.0,
            swirl: 0.0,
            flow,
            alpha,
            loss: if loaded {
                loss(self.annulus, flow.sin)
            } else {
                0.0
            },
            coefficients: if loaded { (self.section)(alpha) } else { zero },
        }
    }
}

/// The value, with a size of at least `least`; zero is positive.
fn at_least(value: f64, least: f64) -> f64 {
    if value.abs() >= least {
        value
    } else if value < 0.0 {
        -least
    } else {
        least
    }
}

/// Brackets in the order of the search, each from its start: the windmill and climb first.
fn quadrants(vx: f64, vy: f64) -> [(f64, f64); 4] {
    let q1 = (EDGE, FRAC_PI_2);
    let q2 = (-EDGE, -FRAC_PI_2);
    let q3 = (FRAC_PI_2, PI - EDGE);
    let q4 = (-FRAC_PI_2, -PI + EDGE);
    match (vx > 0.0, vy > 0.0) {
        (true, true) => [q1, q2, q3, q4],
        (true, false) => [q3, q4, q1, q2],
        // at rest in descent; all other descents are in another file
        (false, _) => [q2, q1, q4, q3],
    }
}

#[cfg(test)]
#[path = "steady_tests.rs"]
mod tests;
