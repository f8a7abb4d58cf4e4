//! Internal damping of beams in time: the oscillation of a mass on a bar decays by its damping, for
//! both ways of input.

use nalgebra::Vector3;

use crate::joint_runs::{Mechanism, check_order, off};

/// EA = 1000 N, 2 m long, nearly massless, and 10 kg at its end.
const BAR: &str = "
[properties.bar]
ea = 1000
gay = 400
gaz = 400
gj = 30
eiy = 40
eiz = 50
m = 1e-6
iy = 1e-9
iz = 1e-9
DAMPING
[[node]]
name = \"root\"
position = [0, 0, 0]
[[node]]
name = \"mid\"
position = [1, 0, 0]
velocity = [0.005, 0, 0]
[[node]]
name = \"tip\"
position = [2, 0, 0]
velocity = [0.01, 0, 0]
[[clamp]]
node = \"root\"
[[body]]
name = \"mass\"
node = \"tip\"
mass = 10
inertia = [1, 1, 1]
";

/// The bar.
const BEAM: &str = "[[beam]]\nnodes = [\"root\", \"mid\", \"tip\"]\nproperties = \"bar\"\n";

// x = v/w_d exp(-zeta w t) sin(w_d t), with w^2 = EA/(l m) and zeta = tau w / 2. Second order: the
// error of the phase is (w h)^2/12 of the angle, 14 rad, hence 1e-3 of the amplitude at w h = 0.035
// and a few times this with the damping of the scheme.
#[test]
fn a_mass_on_a_bar_swings_out_with_the_ratio_of_its_damping() {
    const TIME: f64 = 0.02;
    let frequency = (1000.0_f64 / (2.0 * 10.0)).sqrt();
    let ratio = 0.5 * TIME * frequency;
    let damped = frequency * (1.0 - ratio * ratio).sqrt();
    let position = |t: f64| {
        let size = 0.01 / damped * (-ratio * frequency * t).exp();
        Vector3::new(2.0 + size * (damped * t).sin(), 0.0, 0.0)
    };
    let law = "law = [{ kind = \"section\" }, \
               { kind = \"viscous\", viscosity = [20, 8, 8, 0.6, 0.8, 1] }]";
    for (words, damping) in [("time", "damping = { time = 0.02 }"), ("law", law)] {
        let cards = BAR.replace("DAMPING", damping) + BEAM;
        let errors = [0.01, 0.005].map(|step| {
            let run = Mechanism::new(&cards, 2.0, step).run;
            let tip = run.node("tip");
            let apart = |(t, state): &(f64, beam_dynamics::model::State)| {
                off(state.nodes[tip].position, position(*t))
            };
            run.instants.iter().map(apart).fold(0.0, f64::max)
        });
        let case = format!("bar with a mass, damping by its {words}");
        check_order(&case, "position, of 1.4 mm [m]", errors, 1e-5);
    }
}
