//! A body on a hinge across a turning shaft that is free: torque to the angle of the hinge and to the
//! vertical reaction of the joint.
//!
//! With the moments of inertia A, B, C about the hinge's point, S of the shaft, its drag c, the angle q
//! from the shaft and `I(q) = A sin(q)^2 + C cos(q)^2`, small motions fulfill
//!
//! ```text
//! ( B s^2 - I'' W^2/2 + m g l cos q ) dq = I' W dW
//! ( (S + I) s + c ) dW + I' W s dq = t,     dR = m l sin q s^2 dq
//! ```

use nalgebra::Complex;

use super::{linear, response};
use crate::trim::{numbers, reference};

const SPEED: f64 = 5.0;

/// The hoop of `hoop.json` with the drag of its shaft on a drive of constant speed, the turning frame:
/// there is no torque in the equilibrium.
fn hoop(drag: f64) -> String {
    let (s, c) = 0.95_f64.sin_cos();
    let spring = if drag > 0.0 {
        format!(
            "[[spring]]\nname = \"drag\"\nnode = \"shaft\"\n\
             rotational_damping = [0, 0, {drag:?}]\n"
        )
    } else {
        String::new()
    };
    format!(
        "[[node]]\nname = \"shaft\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"arm\"\nposition = [{:?}, 0, {:?}]\norientation = [0, -0.95, 0]\n\
         [[body]]\nname = \"shaft\"\nnode = \"shaft\"\nmass = 1\ninertia = [1, 1, 2]\n\
         [[body]]\nname = \"arm\"\nnode = \"arm\"\nmass = 1.5\ninertia = [0.14, 0.24, 0.2]\n\
         [[joint]]\nname = \"hinge\"\nkind = \"revolute\"\nnodes = [\"shaft\", \"arm\"]\n\
         at = [0, 0, 0]\naxis = [0, 1, 0]\n\
         [[joint]]\nname = \"bearing\"\nkind = \"revolute\"\nnodes = [\"shaft\"]\n\
         axis = [0, 0, 1]\n{spring}\
         [[load]]\nnode = \"shaft\"\nmoment = [0, 0, 1]\ndrive = \"torque\"\n\
         [drives.torque]\nkind = \"constant\"\nvalue = 0\n\
         [sensors.angle]\nquantity = \"joint_angle\"\nof = \"hinge\"\n\
         [[output.column]]\nname = \"reaction\"\nquantity = \"reaction_force\"\nof = \"hinge\"\n\
         node = \"arm\"\n\
         [gravity]\nacceleration = [0, 0, -9.81]\n",
        0.8 * s,
        -0.8 * c,
    )
}

/// Angle and reaction for a torque of one.
fn exact(drag: f64, s: Complex<f64>) -> [Complex<f64>; 2] {
    let cosine = 1.5 * 9.81 * 0.8 / (SPEED * SPEED * 0.9);
    let sine = f64::sqrt(1.0 - cosine * cosine);
    let whole = 2.0 + 1.1 * sine * sine + 0.2 * cosine * cosine;
    let [first, second] = [
        2.0 * 0.9 * sine * cosine,
        2.0 * 0.9 * (2.0 * cosine * cosine - 1.0),
    ];
    let stiffness = -0.5 * second * SPEED * SPEED + 1.5 * 9.81 * 0.8 * cosine;
    let shaft = s * whole + drag;
    let coupling = first * SPEED;
    let angle = coupling / ((s * s * 1.2 + stiffness) * shaft + s * coupling * coupling);
    [angle, s * s * angle * 1.5 * 0.8 * sine]
}

// To 1e-9; the angle of the joint turns the other way. The vertical reaction does not feel the torque at
// once: D is zero, and the one of the moment that the hinge transmits is not.
#[test]
fn torque_to_angle_and_reaction() {
    for drag in [0.0, 0.3] {
        let model = linear(&hoop(drag), (&["torque"], &["angle", "reaction_z"], SPEED));
        assert_eq!(model.states.len(), 4);
        for frequency in [0.5, 3.0, 6.0, 20.0] {
            let s = Complex::new(0.0, frequency);
            let found = response(&model, s);
            let [angle, reaction] = exact(drag, s);
            for (found, expected) in [(found[0], -angle), (found[1], reaction)] {
                let off = (found - expected).norm() / expected.norm();
                assert!(off < 1e-9, "{drag} {frequency}: {found} {expected}");
            }
        }
        assert!(model.d[1].abs() < 1e-12);
        assert_eq!(model.inputs[0].value, Some(0.0));
        // The weight.
        assert!((model.outputs[1].value.unwrap() - 1.5 * 9.81).abs() < 1e-8);
        assert_eq!(model.outputs[1].unit, "N");
    }
}

// Eigenvalues of the reduction in `stability.json`, a prototype with differences: to 1e-6.
#[test]
fn eigenvalues_of_the_reference() {
    let model = linear(&hoop(0.3), (&["torque"], &["angle"], SPEED));
    let rows = reference("theory-periodic/stability.json")["reduction"]["hoop_eigenvalues"].clone();
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), model.eigenvalues.len());
    for row in rows.iter().map(numbers) {
        let expected = Complex::new(row[0], row[1]);
        let distances = model
            .eigenvalues
            .iter()
            .map(|found| (found - expected).norm());
        let off = distances.fold(f64::INFINITY, f64::min);
        assert!(off < 1e-6, "{expected}: {:?}", model.eigenvalues);
    }
}
