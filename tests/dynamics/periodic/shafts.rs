//! A body on a hinge across a turning shaft: the hoop, against closed forms and the rows of `hoop.json`.
//!
//! With the moments of inertia A, B, C about the hinge's point, B about the hinge and C along the
//! body, and the angle q from the shaft,
//!
//! ```text
//! cos q = m g l / ( W^2 (A - C) )        w^2 = W^2 (A - C) sin(q)^2 / B
//! ```

use std::f64::consts::TAU;

use nalgebra::Complex;
use serde_json::Value;

use super::{analyzed, farthest, modes, multipliers};
use crate::trim::{numbers, reference};

const SPEED: f64 = 5.0;

/// The body at 0.95 rad from the shaft, and the cards of the shaft.
fn hoop(shaft: &str, settings: &str) -> String {
    let (s, c) = 0.95_f64.sin_cos();
    let period = TAU / SPEED;
    format!(
        "[[node]]\nname = \"shaft\"\nposition = [0, 0, 0]\nangular_velocity = [0, 0, {SPEED:?}]\n\
         [[node]]\nname = \"arm\"\nposition = [{:?}, 0, {:?}]\norientation = [0, -0.95, 0]\n\
         velocity = [0, {:?}, 0]\nangular_velocity = [0, 0, {SPEED:?}]\n\
         [[body]]\nname = \"shaft\"\nnode = \"shaft\"\nmass = 1\ninertia = [1, 1, 2]\n\
         [[body]]\nname = \"arm\"\nnode = \"arm\"\nmass = 1.5\ninertia = [0.14, 0.24, 0.2]\n\
         [[joint]]\nname = \"hinge\"\nkind = \"revolute\"\nnodes = [\"shaft\", \"arm\"]\n\
         at = [0, 0, 0]\naxis = [0, 1, 0]\n\
         [[joint]]\nname = \"bearing\"\nkind = \"revolute\"\nnodes = [\"shaft\"]\n\
         axis = [0, 0, 1]\n{shaft}\
         [gravity]\nacceleration = [0, 0, -9.81]\n\
         [periodic]\nperiod = {period:?}\n{settings}\n",
        0.8 * s,
        -0.8 * c,
        0.8 * s * SPEED,
    )
}

/// The row of `hoop.json` with a shaft and a drag, and its multipliers that are neither neutral nor
/// round-off.
fn row(shaft: &str, drag: f64) -> (Value, Vec<Complex<f64>>) {
    let rows = reference("theory-periodic/hoop.json")["rows"].clone();
    let mut rows = rows.as_array().unwrap().iter();
    let row = rows.find(|row| row["shaft"] == shaft && row["drag"] == drag);
    let row = row.unwrap().clone();
    let all = row["multipliers"].as_array().unwrap().iter().map(numbers);
    let all = all.map(|mu| Complex::new(mu[0], mu[1]));
    let is_damped = |mu: &Complex<f64>| mu.norm() > 1e-9 && (mu - 1.0).norm() > 1e-5;
    let own = all.filter(is_damped).collect();
    (row, own)
}

fn exact() -> [f64; 2] {
    let cosine = 1.5 * 9.81 * 0.8 / (SPEED * SPEED * 0.9);
    let frequency = SPEED * (0.9 * (1.0 - cosine * cosine) / 1.2).sqrt();
    [cosine, frequency]
}

#[test]
fn a_shaft_of_prescribed_speed() {
    let angle = format!("angle = \"= {SPEED:?}*t\"\n");
    let settings = "[periodic.floquet]\nerror_estimate = false";
    let (outcome, kept) = analyzed(&hoop(&angle, settings));
    let [cosine, frequency] = exact();
    let found = -kept.0[0].1.nodes[1].position.z / 0.8;
    assert!((found - cosine).abs() < 1e-8, "{found} {cosine}");
    // The ground sees the shaft's turning beside the motion of the hinge.
    let angle = modes(&outcome)[0].multiplier.arg().abs();
    let expected = frequency * TAU / SPEED;
    let off = (angle - expected).abs().min((TAU - angle - expected).abs());
    assert!(off < 1e-8, "{angle} {expected}");
    // The numbers of the reference, whose multipliers have the error of its own steps, 1e-9.
    let (row, own) = row("prescribed", 0.0);
    assert!((row["theta_exact_deg"].as_f64().unwrap() - cosine.acos().to_degrees()).abs() < 1e-9);
    assert!((row["omega_exact"].as_f64().unwrap() - frequency).abs() < 1e-9);
    let off = farthest(&multipliers(&outcome), &own);
    assert!(own.len() == 2 && off < 5e-8, "{off:e}");
}

// A free shaft, without drag and with one of 0.3 N m s: the azimuth is free, and the torque 0 and 1.5 N m.
// The torque is a control, and the target fixes the azimuth: the mean of 2 e_x . y cos(W t) is its sine.
#[test]
fn the_torque_of_a_free_shaft() {
    for drag in [0.0, 0.3] {
        let spring = if drag > 0.0 {
            format!(
                "[[spring]]\nname = \"drag\"\nnode = \"shaft\"\n\
                 rotational_damping = [0, 0, {drag:?}]\n"
            )
        } else {
            String::new()
        };
        let shaft = format!(
            "{spring}[[load]]\nnode = \"shaft\"\nmoment = [0, 0, 1]\ndrive = \"= torque\"\n\
             [sensors.side]\nquantity = \"position\"\nof = \"arm\"\ncomponent = \"y\"\n\
             unit = \"m\"\n"
        );
        let settings = format!(
            "settle = 1\n[periodic.floquet]\ncount = 4\n\
             [[trim.control]]\nname = \"torque\"\nguess = 1\n\
             [[trim.target]]\nname = \"azimuth\"\nsignal = \"= 2*side*cos({SPEED:?}*t)\"\n\
             value = 0\n"
        );
        let (outcome, kept) = analyzed(&hoop(&shaft, &settings));
        let [cosine, _] = exact();
        let found = -kept.0[0].1.nodes[1].position.z / 0.8;
        assert!((found - cosine).abs() < 1e-8, "{found} {cosine}");
        let (row, own) = row("free", drag);
        let (name, torque) = &outcome.result.controls[0];
        assert_eq!(name, "torque");
        let expected = row["torque_exact"].as_f64().unwrap();
        assert!((torque - expected).abs() < 1e-8, "{torque}");
        let off = farthest(&multipliers(&outcome), &own);
        assert!(off < 5e-8, "{drag}: {off:e}");
        // One multiplier is the free azimuth; without drag there are two, as the speed is free, too.
        let neutral = modes(&outcome)
            .iter()
            .filter(|mode| mode.stability().word() == "azimuth");
        if drag > 0.0 {
            assert_eq!((neutral.count(), own.len()), (1, 3));
        }
    }
}
