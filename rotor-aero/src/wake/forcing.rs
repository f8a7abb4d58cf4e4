//! The quasi-steady velocity that the filter of the wake follows, by two schools.

use crate::airfoil::Coefficients;
use crate::momentum::{Ambient, Annulus, LOSS_FLOOR, induced_flow, loss, quasi_steady, solve};

/// Origin of the quasi-steady velocities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Forcing {
    /// Loads with the lagged velocities, and momentum by the velocity form (Oye): explicit,
    /// smooth, finite. A change of the velocities changes the loads against it, so that the
    /// response is faster than the filter (thrust after a step of pitch: 6 s against 7.6 s).
    #[default]
    Lagged,
    /// Loads with the lagged velocities, and the induction factor by the thrust coefficient of the
    /// ring: the mass flow is the one of the quasi-steady state, and the response is faster still.
    /// For turbines: it has no meaning without wind.
    Thrust,
    /// The steady state at the present pitch and wind: exactly the filter (AeroDyn).
    Steady,
}

/// Quasi-steady velocities (u, v) of a ring \[m/s\] at the pitch of its section and the present
/// induced velocities. `section` gives the coefficients at an angle of attack.
///
/// With dual numbers use [`quasi_steady`], the form of [`Forcing::Lagged`].
pub fn forcing(
    school: Forcing,
    annulus: &Annulus,
    ambient: &Ambient<f64>,
    pitch: f64,
    induced: (f64, f64),
    section: impl Fn(f64) -> Coefficients<f64>,
) -> (f64, f64) {
    match school {
        Forcing::Lagged => {
            let flow = induced_flow(ambient, induced.0, induced.1);
            let coefficients = section(pitch - flow.phi);
            quasi_steady(annulus, ambient, induced.0, induced.1, coefficients)
        }
        Forcing::Thrust => {
            let flow = induced_flow(ambient, induced.0, induced.1);
            let coefficients = section(pitch - flow.phi);
            let lagged = quasi_steady(annulus, ambient, induced.0, induced.1, coefficients);
            let (normal, _) = annulus.induction_coefficients(flow.sin, flow.cos, coefficients);
            let loss = loss(annulus, flow.sin).max(LOSS_FLOOR);
            let wind = ambient.axial * ambient.axial.abs();
            let ct = -annulus.solidity() * flow.speed * flow.speed * normal / wind;
            if !ct.is_finite() {
                return lagged;
            }
            let a = annulus.options.high_induction.factor(ct, loss);
            (-a * ambient.axial, lagged.1)
        }
        Forcing::Steady => {
            let state = solve(annulus, pitch, ambient.axial, ambient.rotation, section);
            (state.axial, state.swirl)
        }
    }
}

/// Mean of a quantity over the disk, weighted by the radius, from (radius, value) of rings of equal
/// width; zero without rings.
pub fn disk_mean(rings: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let add =
        |sum: (f64, f64), (radius, value): (f64, f64)| (sum.0 + radius, sum.1 + radius * value);
    let (weight, sum) = rings.into_iter().fold((0.0, 0.0), add);
    if weight > 0.0 { sum / weight } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::momentum::Options;

    fn linear(alpha: f64) -> Coefficients<f64> {
        Coefficients {
            lift: 6.0 * alpha,
            drag: 0.01,
            moment: 0.0,
        }
    }

    /// Both schools have the same fixed point: equal up to the share of `e^2` in the mass flow.
    #[test]
    fn schools_have_the_same_steady_state() {
        let annulus = Annulus {
            radius: 0.7,
            hub_radius: 0.1,
            tip_radius: 1.0,
            blades: 2,
            chord: 0.08,
            options: Options::default(),
        };
        let ambient = Ambient {
            axial: 10.0,
            rotation: 60.0,
            skew: 0.0,
        };
        let by = |school: Forcing, induced: (f64, f64)| {
            forcing(school, &annulus, &ambient, 0.3, induced, linear)
        };
        let steady = by(Forcing::Steady, (0.0, 0.0));
        let lagged = by(Forcing::Lagged, steady);
        assert!(steady.0 > 1.0);
        assert!((steady.0 - lagged.0).abs() < 1e-7, "{steady:?} {lagged:?}");
        assert!((steady.1 - lagged.1).abs() < 1e-7);
        let thrust = by(Forcing::Thrust, steady);
        assert!((steady.0 - thrust.0).abs() < 1e-7, "{steady:?} {thrust:?}");
        assert!((by(Forcing::Lagged, (0.0, 0.0)).0 - steady.0).abs() > 0.1);
    }

    #[test]
    fn mean_over_the_disk() {
        assert_eq!(disk_mean([(1.0, 2.0), (3.0, 6.0)]), 5.0);
        assert_eq!(disk_mean([]), 0.0);
    }
}
