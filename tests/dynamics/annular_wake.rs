//! Thrust and torque of strips against the momentum of their wake, for the momentum of annuli.
//!
//! Each strip of one of B blades has a ring of the disk of its length dr. With the induced velocities u
//! and v at its radius r, the mass flow m and the loss F,
//!
//! ```text
//! T = sum 4 pi r rho F u m dr / B            Q = sum 4 pi r^2 rho F v m dr / B
//! ```

use std::f64::consts::{FRAC_2_PI, PI};

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::elements::{AirState, RotorAir};
use beam_dynamics::input;

use crate::in_time::Run;
use crate::record;

const BLADES: usize = 4;
const ROOT: f64 = 0.5;
const DENSITY: f64 = 1.2;
/// Velocity by which the mass flow is smooth at zero \[m/s\].
const SMOOTH: f64 = 1e-3;

/// The strips of four stiff blades at 300 rpm in a climb \[m/s\].
fn strips(wake: &str, climb: f64) -> Vec<AirState> {
    let text = format!(
        "units = \"SI\"\n[air]\ndensity = {DENSITY}\nwind = [0, 0, -{climb}]\n[[inflow]]\n\
         name = \"lift\"\nwake = \"{wake}\"\nhub_radius = {ROOT}\n\
         [properties.p]\nea = 1e9\ngay = 1e9\ngaz = 1e9\ngj = 1e9\neiy = 1e9\neiz = 1e9\n\
         m = 8\niy = 0.02\niz = 0.02\n[[blade]]\nname = \"b\"\ncount = {BLADES}\nhub_radius = {ROOT}\n\
         properties = \"p\"\n\
         piece = [{{ length = 4, elements = 2 }}]\n[blade.aerodynamics]\ninflow = \"lift\"\n\
         section = \"quasi_steady\"\nstrips = 4\nstations = [\n\
         {{ at = 0, chord = 0.3, twist = 14, airfoil = \"naca0012\" }},\n\
         {{ at = 4, chord = 0.25, twist = 8, airfoil = \"naca0012\" }},\n]\n[static]\nspeed = 300\n"
    );
    let input = input::parse(&text, "wake.dynamics.toml").unwrap_or_else(|all| panic!("{all}"));
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.result.steps[0].air.clone()
}

/// Prandtl's loss at both ends, at the distances of the quarter chord and of the tip from the shaft.
fn loss(strip: &AirState, tip: f64) -> f64 {
    let sine = strip.flow.inflow_angle.sin().abs();
    let factor = |distance: f64| {
        let exponent = 0.5 * BLADES as f64 * distance / sine;
        FRAC_2_PI * (-exponent).exp().acos()
    };
    factor((tip - strip.radius) / strip.radius) * factor((strip.radius - ROOT) / ROOT)
}

/// Thrust and torque of the wake of a strip \[N, N m\].
fn wake(strip: &AirState) -> [f64; 2] {
    let flow = &strip.flow;
    let motion = strip.rotor.as_ref().unwrap();
    // The force of a strip along the shaft over the one per length.
    let length = motion.axis.dot(&strip.force) / flow.along_shaft;
    let [u, v] = flow.induced;
    let through = flow.speed * flow.inflow_angle.sin();
    let mass = DENSITY * through.hypot(SMOOTH) * loss(strip, motion.tip_radius);
    let ring = 4.0 * PI * strip.radius * mass * length / BLADES as f64;
    [ring * u, ring * v * strip.radius]
}

/// The strips of an equilibrium, of a wake in equilibrium and of a lagged one at rest: equal to the
/// tolerance of the iteration. The blades bend by less than 1e-4 rad, of which the forces along the
/// shaft have the cosine, 1 - 5e-9.
#[test]
fn strips_have_the_thrust_and_the_torque_of_their_wake() {
    for kind in ["equilibrium", "dynamic", "hover"] {
        for climb in [0.0, 5.0] {
            let strips = strips(kind, climb);
            let air = RotorAir::of(&strips).unwrap();
            assert!(air.thrust > 5e3 && air.torque < -1e3, "{air:?}");
            let [thrust, torque] = strips
                .iter()
                .map(wake)
                .fold([0.0; 2], |sum, one| [sum[0] + one[0], sum[1] + one[1]]);
            for (name, found, expected) in [
                ("thrust [N]", air.thrust, thrust),
                ("torque [N m]", -air.torque, torque),
            ] {
                let error = (found / expected - 1.0).abs();
                let case = format!("rotor in a climb of {climb} m/s, {kind} wake");
                let source = "momentum of the annuli";
                record::value(source, &case, name, [found, expected], error, 1e-7);
                assert!(error < 1e-7, "{case}: {name} {found} {expected}");
            }
        }
    }
}

/// A vertical wind that changes its sign carries a rotor from climb through hover to descent and back:
/// each change is a kink of the wake at the outer strips, where the loss is small, and no jump. A law
/// that jumps there has no states between, and the steps end.
#[test]
fn a_rotor_in_hover_passes_a_wind_that_changes_its_sign() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/cases/dynamics/hover_rotor/hover_rotor.dynamics.toml"
    );
    let text = std::fs::read_to_string(path).unwrap();
    let wind = "density = 1.225\n[air.wind]\nspeed = \"= 0.3*cos(40*t)\"\ndirection = [0, 0, 1]\n\
                up = [1, 0, 0]\n";
    let changes = [
        ("density = 1.225\n", wind),
        ("elements = 6", "elements = 10"),
    ];
    let text = changes.iter().fold(text, |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replace(old, new)
    });
    let input = input::parse(&text, path).unwrap_or_else(|all| panic!("{all}"));
    let mut settings = input.transient.unwrap();
    settings.to = 0.1;
    let run = Run::of(input.model, &settings, 1);
    run.check_end();
    let thrust = run.instants.iter().map(|(time, state)| {
        let conditions = run.model.conditions_at(*time);
        let air = run.model.system.observe(state, &conditions).air;
        air.iter().map(|strip| strip.force.z).sum::<f64>()
    });
    let thrust: Vec<f64> = thrust.collect();
    let mean = thrust.iter().sum::<f64>() / thrust.len() as f64;
    // A wind of .3 m/s changes the angle of attack by .12 deg of about 3, on a part of its own wake.
    assert!((1.6e4..2e4).contains(&mean), "{mean}");
    assert!(
        thrust.iter().all(|own| (own / mean - 1.0).abs() < 0.05),
        "{thrust:?}"
    );
}
