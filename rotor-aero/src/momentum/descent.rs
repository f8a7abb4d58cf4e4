//! The steady state of a ring in hover, and in descent, where the air comes against the induced velocity
//! of hover: by the relation of velocities, whose one branch leads from hover to the windmill.
//!
//! ```text
//! u m = (sigma / 4 F) W^2 cn,  v m = (sigma / 4 F) W^2 ct,  u = W sin phi - Vx,  v = Vy - W cos phi
//! ```
//!
//! At an angle `phi` of the flow the second equation gives the speed W, the first one is the residual
//! of the angle; `m` is the mass-flow speed of [`mass_flow`](super::velocity::mass_flow). The form by
//! the angle alone takes the swirl from the flow through the disk, which vanishes here: it has roots
//! at which the air turns with the blades.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::airfoil::Coefficients;
use crate::momentum::annulus::Annulus;
use crate::momentum::bracket::{FIRST, first_root, opposite, root};
use crate::momentum::loss::{LOSS_FLOOR, loss};
use crate::momentum::velocity::{Ambient, mass_flow};

/// Intervals of the search in a quarter of a turn: the second number if the first finds nothing.
const INTERVALS: [usize; 2] = [FIRST, 400];

/// Smallest sine of the angle from the shaft: the flow is not along it.
const EDGE: f64 = 1e-6;

/// Largest number of times that the bracket of the speed doubles, from the speed without induction.
const DOUBLINGS: usize = 3;

/// A trial of the angle of the flow.
struct Trial {
    residual: f64,
    /// Induced velocities through the disk and along the motion \[m/s\].
    induced: (f64, f64),
    /// Size of the terms of the residual.
    size: f64,
}

/// Induced velocities through the disk and along the motion at the velocities `vx` and `vy`
/// \[m/s\], and the angle of the flow \[rad\]. `None` if no angle is in balance.
pub(super) fn solve(
    annulus: &Annulus,
    pitch: f64,
    (vx, vy): (f64, f64),
    section: impl Fn(f64) -> Coefficients<f64>,
) -> Option<((f64, f64), f64)> {
    let ambient = Ambient {
        axial: vx,
        rotation: vy,
        skew: 0.0,
    };
    let at = |phi: f64| trial(annulus, &ambient, phi, section(pitch - phi));
    let residual = |phi: f64| at(phi).map_or(f64::NAN, |trial| trial.residual);
    first_root(residual, &quarters(vy), &INTERVALS, |phi| {
        let found = at(phi)?;
        let is_root = found.residual.abs() < 1e-9 * (1.0 + found.size);
        is_root.then_some((found.induced, phi))
    })
}

/// The trial of an angle; `None` if no speed balances the swirl.
fn trial(
    annulus: &Annulus,
    ambient: &Ambient<f64>,
    phi: f64,
    coefficients: Coefficients<f64>,
) -> Option<Trial> {
    let (sin, cos) = phi.sin_cos();
    let (normal, tangential) = annulus.induction_coefficients(sin, cos, coefficients);
    let (vx, vy) = (ambient.axial, ambient.rotation);
    let loss = loss(annulus, sin).max(LOSS_FLOOR);
    let load = 0.25 * annulus.solidity() / loss;
    let mass = |speed: f64| mass_flow(annulus, ambient, speed * sin - vx, loss);
    // of the sign of Vy at speed zero
    let swirl = |speed: f64| (vy - speed * cos) * mass(speed) - load * speed * speed * tangential;
    let at = |speed: f64| (speed, swirl(speed));
    let mut ends = [at(0.0), at(vx.hypot(vy))];
    for _ in 0..DOUBLINGS {
        if opposite(ends[0].1, ends[1].1) {
            break;
        }
        ends = [ends[1], at(2.0 * ends[1].0)];
    }
    let speed = root(swirl, ends[0], ends[1], 1e-15 * vy.abs())?;
    let u = speed * sin - vx;
    let (momentum, load) = (u * mass(speed), load * speed * speed * normal);
    let scale = speed * speed + vx * vx + vy * vy;
    Some(Trial {
        residual: (momentum - load) / scale,
        induced: (u, vy - speed * cos),
        size: (momentum.abs() + load.abs()) / scale,
    })
}

/// Quarters of the search, each from its start: the flow of hover first.
fn quarters(vy: f64) -> [(f64, f64); 4] {
    let small = 1e-9;
    let quarters = [
        (-small, FRAC_PI_2 - EDGE),
        (small, -FRAC_PI_2 + EDGE),
        (PI - small, FRAC_PI_2 + EDGE),
        (-PI + small, -FRAC_PI_2 - EDGE),
    ];
    if vy < 0.0 {
        [quarters[2], quarters[3], quarters[0], quarters[1]]
    } else {
        quarters
    }
}

#[cfg(test)]
#[path = "descent_tests.rs"]
mod tests;
