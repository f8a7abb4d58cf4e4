//! A rotor in steady rotation, step by step, in `cases/dynamics/rotor`.

use nalgebra::Vector3;

use crate::in_time::Run;
use crate::record;

const SPEED: f64 = 44.4;
/// Another program with the same elements takes 257 steps and 514 iterations with as many
/// Jacobians.
const STEPS: usize = 256;

/// A full revolution as in the case. The error of the scheme is a part of `(Omega h)^2`, 6e-4, in
/// the angle of a step and in the moment.
#[test]
fn blades_stay_on_their_circle() {
    let run = Run::new("rotor", "rotor.dynamics.toml", 8, |_| ());
    let effort = &run.outcome.effort;
    assert_eq!((effort.steps, effort.rejected), (STEPS, 0));
    assert!(effort.jacobians <= STEPS + 2, "{}", effort.jacobians);
    assert!(effort.iterations <= 4 * STEPS, "{}", effort.iterations);
    // Centrifugal stretch of a uniform blade from r to R.
    let (inner, outer) = (0.3_f64, 4.912_f64);
    let load = outer.powi(2) * (outer - inner) - (outer.powi(3) - inner.powi(3)) / 3.0;
    let stretch = 5.5 * SPEED.powi(2) / 2e8 * load;
    let mut errors = [0.0_f64; 3];
    for (time, state) in &run.instants {
        for blade in 0..4 {
            let tip = state.nodes[run.node(&format!("blade {}/tip", blade + 1))].position;
            let found = tip.norm() - outer;
            errors[0] = errors[0].max((found / stretch - 1.0).abs());
            let angle = SPEED * time + std::f64::consts::FRAC_PI_2 * f64::from(blade);
            let along = Vector3::new(angle.cos(), angle.sin(), 0.0);
            errors[1] = errors[1].max((tip.normalize() - along).norm());
        }
        let [_, moment] = run.reaction_in(state, *time, "drive", run.node("hub"));
        errors[2] = errors[2].max(moment.norm());
    }
    let source = "closed form, uniform blade in rotation";
    // The load grows with the stretch, by a part of it: strains of 1e-3.
    let rows = [
        ("stretch of the blades, relative", 2e-3),
        ("azimuth of the tips [rad]", 1e-4),
        ("moment of the drive, relative to inertia", 1e-4),
    ];
    // Four blades about the axis at the angular acceleration SPEED^2.
    errors[2] /= 4.0 * 5.5 * outer.powi(3) / 3.0 * SPEED.powi(2);
    for ((quantity, tolerance), error) in rows.into_iter().zip(errors) {
        record::largest(source, "rotor in time", quantity, error, tolerance);
        assert!(error < tolerance, "{quantity}: {error:e}");
    }
}
