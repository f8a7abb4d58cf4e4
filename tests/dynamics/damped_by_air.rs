//! The damping of an edgewise mode by the air: eigenvalues of `[modes]` against the decay of runs in
//! time that start in the shape of the mode.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::input;
use beam_dynamics::result::{ModeBranch, ModePoint};

use crate::in_time::Run;
use crate::record;
use crate::rotating_in_time::fitted;

/// An elastic blade of a turbine, its hub driven at 60 rpm in a wind of 8 m/s.
const BLADE: &str = r#"units = "SI"
[properties.blade]
ea = 4e8
gay = 1e8
gaz = 1e8
gj = 4e5
eiy = 3e5
eiz = 8e5
m = 10
iy = 0.2
iz = 1
[air]
density = 1.225
wind = [0, 0, 8]
[[inflow]]
name = "rotor"
blades = 3
wake = "WAKE"
[hub]
axis = [0, 0, 1]
mass = 10
inertia = [1, 1, 1]
support = { torsion = 0 }
[[blade]]
name = "blade"
hub_radius = 1
pitch = -1
properties = "blade"
piece = [{ length = 10, elements = 4 }]
[blade.aerodynamics]
inflow = "rotor"
section = "SECTION"
stations = [
  { at = 1, chord = 1, twist = -4, airfoil = "naca0012" },
  { at = 10, chord = 1, airfoil = "naca0012" },
]
[[joint]]
name = "drive"
kind = "spin"
nodes = ["hub"]
axis = [0, 0, 1]
angle = "= 360 * t"
[modes]
speeds = [60]
count = 2
[transient]
to = 6
step = 0.01
start = "rotating"
speed = 60
shape = { mode = NUMBER, displacement = AMPLITUDE }
"#;
/// Displacement of the tip \[m\].
const AMPLITUDE: f64 = 0.02;
/// Step of the runs \[s\].
const STEP: f64 = 0.01;
/// Speed of the rotor \[rad/s\].
const SPEED: f64 = std::f64::consts::TAU;

/// Growth [1/s] and frequency [rad/s] of the first edgewise mode, and its number.
fn mode(text: &str) -> ([f64; 2], usize) {
    let text = text.replace("AMPLITUDE", "0").replace("NUMBER", "1");
    let input = input::parse(&text, "edge.dynamics.toml").unwrap();
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let points = outcome.table.at_speed(0);
    let edgewise = |(branch, _): &(&ModeBranch, &ModePoint)| branch.name == "lag 1";
    let number = points.iter().position(edgewise).unwrap();
    let point = points[number].1;
    let frequency = std::f64::consts::TAU * point.frequency;
    ([point.growth, frequency], number + 1)
}

/// Edgewise position of the tip in turning axes, step by step \[m\].
fn edgewise(text: &str) -> Vec<f64> {
    let input = input::parse(text, "edge.dynamics.toml").unwrap();
    let run = Run::of_any(input.model, &input.transient.unwrap(), 1);
    run.check_end();
    let tip = run.node("blade/tip");
    let along = |(time, state): &(f64, beam_dynamics::model::State)| {
        let (sin, cos) = (SPEED * time).sin_cos();
        let at = state.nodes[tip].position;
        cos * at.y - sin * at.x
    };
    run.instants.iter().map(along).collect()
}

/// The states of the wake and of the section are in equilibrium at the start; they take
/// part after some of their time constants, of at most a second here.
const SETTLED: usize = 200;

/// Half the difference of two runs with displacements to both sides is free of the equilibrium and
/// of the squares of the amplitude.
fn decay(text: &str, near: f64) -> [f64; 2] {
    let runs =
        [AMPLITUDE, -AMPLITUDE].map(|size| edgewise(&text.replace("AMPLITUDE", &size.to_string())));
    let pairs = runs[0].iter().zip(&runs[1]).skip(SETTLED);
    let motion: Vec<_> = pairs.map(|(a, b)| 0.5 * (a - b)).collect();
    // Differences in time are free of the slow motion of the wake.
    let changes: Vec<_> = motion.windows(2).map(|pair| pair[1] - pair[0]).collect();
    fitted(&changes, STEP, near)
}

/// The decay of the runs is the growth of the mode to 1 %, and the frequency to 4e-3, the error of
/// the scheme: 3.3e-3 at this step, 8e-4 at half of it.
fn compare(wake: &str, section: &str) -> f64 {
    let text = BLADE.replace("WAKE", wake).replace("SECTION", section);
    let ([growth, frequency], number) = mode(&text);
    let text = text.replace("NUMBER", &number.to_string());
    let [found, rate] = decay(&text, frequency);
    let case = format!("edgewise mode in air, wake {wake}, section {section}");
    let error = (found / growth - 1.0).abs();
    record::value(
        "own modes",
        &case,
        "decay in time [1/s]",
        [found, growth],
        error,
        0.01,
    );
    assert!(error < 0.01, "{case}: {found} {growth}");
    assert!((rate / frequency - 1.0).abs() < 4e-3, "{rate} {frequency}");
    growth
}

#[test]
fn an_edgewise_mode_decays_in_a_frozen_wake_as_its_eigenvalue_says() {
    compare("frozen", "quasi_steady");
}

#[test]
fn an_edgewise_mode_decays_in_a_dynamic_wake_as_its_eigenvalue_says() {
    compare("dynamic", "separation_lag");
}

/// Short motions do not change the wake: the dynamic wake is nearer to the frozen one than the wake
/// in equilibrium.
#[test]
fn a_dynamic_wake_damps_edgewise_modes_between_the_frozen_wake_and_equilibrium() {
    let growth = |wake: &str| {
        let text = BLADE.replace("WAKE", wake);
        mode(&text.replace("SECTION", "quasi_steady")).0[0]
    };
    let [frozen, dynamic, equilibrium] = ["frozen", "dynamic", "equilibrium"].map(growth);
    assert!((dynamic - frozen).abs() < 0.5 * (equilibrium - frozen).abs());
}
