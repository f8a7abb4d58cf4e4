//! Descent: its limits in hover and as a windmill, and its mirror image, a turbine.

use super::*;
use crate::momentum::annulus::Options;
use crate::momentum::induction::HighInduction;
use crate::momentum::steady::{Outcome, solve as steady};

/// A section that stalls by its sine.
fn section(alpha: f64) -> Coefficients<f64> {
    let (sin, cos) = alpha.sin_cos();
    Coefficients {
        lift: 5.5 * sin * cos,
        drag: 0.01 + 1.2 * sin * sin,
        moment: 0.0,
    }
}

fn ring(radius: f64, law: HighInduction) -> Annulus {
    Annulus {
        radius,
        hub_radius: 0.1,
        tip_radius: 1.0,
        blades: 3,
        chord: 0.06,
        options: Options {
            high_induction: law,
            ..Options::default()
        },
    }
}

/// From climb through hover to descent the induced velocity has no jump: 300 rings, by a law that is
/// continuous in hover. A step changes it by about half of the step.
#[test]
fn hover_is_the_limit_of_descent() {
    for case in 0..300 {
        let radius = 0.2 + 0.0025 * f64::from(case);
        let ring = ring(radius, HighInduction::BuhlOutside);
        let pitch = 0.05 + 0.2 * f64::from(case % 7) / 7.0;
        let vy = 100.0 * radius;
        let at = |vx: f64| {
            let found = steady(&ring, pitch, vx, vy, section);
            assert_eq!(found.outcome, Outcome::Solved);
            found.axial
        };
        let hover = at(0.0);
        for vx in [1e-9, -1e-9, -1e-5, 1e-3 * vy, -1e-3 * vy] {
            let most = vx.abs() + 1e-6 * vy;
            assert!((at(vx) - hover).abs() < most, "{radius} {vx}");
        }
        // The form by the angle follows where it begins.
        let ends = [1.0 - 1e-9, 1.0 + 1e-9].map(|part| at(1e-3 * part * vy));
        assert!((ends[0] - ends[1]).abs() < 1e-6 * vy, "{radius} {ends:?}");
        // Down to 12 m/s in steps of .05: no jump of more than ten times the step.
        let mut last = at(-0.01);
        for step in 1..=240 {
            let next = at(-0.05 * f64::from(step));
            assert!((next - last).abs() < 0.5, "{radius} {step}: {last} {next}");
            last = next;
        }
    }
}

/// A windmill in descent is a turbine in the mirror: airfoils upside down, climb for descent. Where the
/// induction factor is below .4 the form of turbines by the angle gives the same state.
#[test]
fn a_windmill_is_a_turbine_in_the_mirror() {
    let upside_down = |alpha: f64| {
        let found = section(-alpha);
        Coefficients {
            lift: -found.lift,
            ..found
        }
    };
    let mut compared = 0;
    for case in 0..400 {
        let radius = 0.2 + 0.0018 * f64::from(case);
        let ring = ring(radius, HighInduction::Buhl);
        let (vx, vy) = (8.0 + f64::from(case % 13), 60.0 * radius);
        let pitch = -0.1 + 0.02 * f64::from(case % 11);
        let turbine = steady(&ring, -pitch, vx, vy, upside_down);
        if -turbine.axial / vx > 0.39 {
            continue;
        }
        let descent = steady(&ring, pitch, -vx, vy, section);
        assert_eq!(descent.outcome, Outcome::Solved);
        let size = 1e-5 * (1.0 + turbine.axial.abs());
        assert!((descent.axial + turbine.axial).abs() < size, "{radius}");
        assert!((descent.swirl - turbine.swirl).abs() < size, "{radius}");
        compared += 1;
    }
    assert!(compared > 200, "{compared}");
}
