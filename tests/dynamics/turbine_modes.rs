//! Modes with air of a turbine rotor with three elastic blades: names and frequencies in the fixed frame,
//! damping against runs in time, the limit without air, and flap damping in closed form.

use std::f64::consts::TAU;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input::{self, Input};
use beam_dynamics::result::{StabilityResult, StabilityRoot};

use crate::in_time::Run;
use crate::record;
use crate::rotating_in_time::fitted;

/// A rotor at 60 rpm: a schedule of pitch over the wind, in the words of wind energy.
const ROTOR: &str = r#"units = "SI"
[parameters]
wind = 8
density = 1.225
feather = { of = "wind", rows = [[0, 1], [8, 1], [12, 5]] }
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
density = "= density"
wind = [0, 0, "= wind"]
[[inflow]]
name = "rotor"
wake = "WAKE"
[hub]
axis = [0, 0, 1]
mass = 10
inertia = [1, 1, 1]
support = { torsion = 0 }
[[joint]]
name = "drive"
kind = "spin"
nodes = ["hub"]
axis = [0, 0, 1]
angle = "= 360 * t"
[[blade]]
name = "blade"
count = 3
hub_radius = 1
pitch = "= -feather"
properties = "blade"
piece = [{ length = 10, elements = 3 }]
[blade.aerodynamics]
inflow = "rotor"
section = "SECTION"
stations = [
  { at = 0, chord = 1, twist = -4, airfoil = "naca0012" },
  { at = 10, chord = 1, airfoil = "naca0012" },
]
[modes]
speeds = [60]
count = 6
words = "wind"
"#;
const FILE: &str = "turbine.dynamics.toml";
/// Revolutions per second, and the speed of the rotor \[rad/s\].
const TURNS: f64 = 1.0;
const SPEED: f64 = TAU * TURNS;

fn text(wake: &str, section: &str) -> String {
    ROTOR.replace("WAKE", wake).replace("SECTION", section)
}

fn parsed(text: &str) -> Input {
    input::parse(text, FILE).unwrap_or_else(|problems| panic!("{problems}\n{text}"))
}

/// The stability of a file over the values of a parameter.
fn over(text: &str, parameter: &str, values: &str) -> StabilityResult {
    let text = format!(
        "{text}[stability]\nparameter = \"{parameter}\"\nvalues = {values}\nboundaries = false\n"
    );
    let input = parsed(&text);
    let read = |given: &[(String, f64)]| input::parse_with(&text, FILE, given);
    let result = stability("turbine", &input.stability.unwrap(), None, &read);
    assert!(result.failures.is_empty(), "{:#?}", result.failures);
    result
}

/// The root of a name at the value `index`.
fn root<'a>(result: &'a StabilityResult, index: usize, name: &str) -> &'a StabilityRoot {
    let mode = result.modes.iter().position(|own| own == name);
    let mode = mode.unwrap_or_else(|| panic!("no {name} among {:?}", result.modes));
    result.points[index].root_of(mode).unwrap()
}

// The blades of a whirl have one frequency f in turning axes, up to the small couplings by hub and wake, and
// the fixed frame shows f - n and f + n: n is the speed. A collective mode keeps its frequency.
#[test]
fn whirls_are_named_and_shifted_by_the_speed() {
    let result = over(&text("frozen", "quasi_steady"), "wind", "[6, 8, 12]");
    let names = ["edge 1 backward", "edge 1 collective", "edge 1 forward"];
    for index in 0..3 {
        let seen = names.map(|name| root(&result, index, name).frequency() / TAU);
        assert!((seen[2] - seen[0] - 2.0 * TURNS).abs() < 0.02, "{seen:?}");
        assert!((seen[1] - seen[0] - TURNS).abs() < 0.05, "{seen:?}");
    }
    // Of each kind all three patterns, and no other name.
    let mut kinds: Vec<_> = result
        .modes
        .iter()
        .map(|name| name.split(' ').next())
        .collect();
    kinds.sort_unstable();
    let expected = ["edge", "edge", "edge", "flap", "flap", "flap"].map(Some);
    assert_eq!(kinds, expected, "{:?}", result.modes);
}

/// Displacement of the tip in the shape of a mode \[m\], step of the runs \[s\], and steps until the states
/// of the air have settled.
const AMPLITUDE: f64 = 0.02;
const STEP: f64 = 0.01;
const SETTLED: usize = 100;

/// The cosine part of the edgewise motion of three blades in the fixed frame, step by step \[m\]:
/// 2/3 sum u_k cos psi_k.
fn multiblade(text: &str) -> Vec<f64> {
    let input = parsed(text);
    let run = Run::of_any(input.model, &input.transient.unwrap(), 1);
    run.check_end();
    let tips = [1, 2, 3].map(|k| run.node(&format!("blade {k}/tip")));
    let instants = run.instants.iter().map(|(time, state)| {
        let of_blade = |k: usize| {
            let azimuth = SPEED * time + TAU * k as f64 / 3.0;
            let (sin, cos) = azimuth.sin_cos();
            let at = state.nodes[tips[k]].position;
            (cos * at.y - sin * at.x) * cos
        };
        2.0 / 3.0 * (0..3).map(of_blade).sum::<f64>()
    });
    instants.collect()
}

// Half the difference of two runs that start to both sides is free of the equilibrium. The decay is the
// growth of the mode to 2 %, the frequency in the fixed frame to 5e-3, of which 3e-3 is the error of the
// steps.
#[test]
fn a_whirl_decays_in_time_as_its_eigenvalue_says() {
    let text = text("dynamic", "separation_lag");
    let result = over(&text, "wind", "[8, 9]");
    let expected = root(&result, 0, "edge 1 backward");
    let found = {
        let input = parsed(&text);
        let table = modes(&input.model, &input.modes.unwrap()).table;
        let points = table.at_speed(0);
        let number = points
            .iter()
            .position(|own| own.0.name == "edge 1 backward");
        let number = number.unwrap() + 1;
        let run = |size: f64| {
            multiblade(&format!(
                "{text}[transient]\nto = 4\nstep = {STEP}\nstart = \"rotating\"\nspeed = 60\n\
                 shape = {{ mode = {number}, displacement = {size:?} }}\n"
            ))
        };
        let [one, other] = [AMPLITUDE, -AMPLITUDE].map(run);
        let pairs = one.iter().zip(&other).skip(SETTLED);
        let motion: Vec<_> = pairs.map(|(a, b)| 0.5 * (a - b)).collect();
        fitted(&motion, STEP, expected.frequency())
    };
    let case = "edgewise backward whirl of three blades in the wind";
    let pairs = [
        ("decay in time [1/s]", [found[0], expected.growth()], 0.02),
        (
            "frequency in time [rad/s]",
            [found[1], expected.frequency()],
            5e-3,
        ),
    ];
    for (quantity, pair, within) in pairs {
        let error = (pair[0] / pair[1] - 1.0).abs();
        record::value("own modes", case, quantity, pair, error, within);
        assert!(error < within, "{quantity}: {pair:?}");
    }
}

// Without air nothing is damped: the growth of every mode falls in proportion to the density.
#[test]
fn the_damping_by_air_ends_with_the_air() {
    let result = over(
        &text("frozen", "quasi_steady"),
        "density",
        "[2e-5, 1e-5, 5e-6]",
    );
    for (mode, name) in result.modes.iter().enumerate() {
        let growth = [0, 1, 2].map(|index| result.points[index].root_of(mode).unwrap().growth());
        assert!(growth[2] < 0.0 && growth[2] > -1e-4, "{name}: {growth:?}");
        for pair in growth.windows(2) {
            assert!((pair[1] / pair[0] - 2.0).abs() < 0.01, "{name}: {growth:?}");
        }
    }
}

// A blade that flaps with the shape w(r) in still air, without induced velocity, at small angles: lift per
// length -rho a c Omega r w_t / 2 on the mass m per length, so that
//     growth = -rho a c Omega int r w^2 dr / (4 m int w^2 dr) ,
// -gamma Omega / 16 of a rigid blade with its hinge at the axis. Motion along the shaft alone is damped; the
// blade is stiff in the plane and in torsion. The shape is of the mode with air, whose damping of 8 % changes
// it by its square; tables of thin sections have the slope a at zero angle.
#[test]
fn flap_damping_has_its_closed_form() {
    let (density, slope, chord) = (0.4, 5.7, 0.6);
    let text = format!(
        "units = \"SI\"\n[properties.blade]\nea = 4e8\ngay = 1e9\ngaz = 1e9\ngj = 4e7\neiy = 3e5\n\
         eiz = 8e8\nm = 10\niy = 0.02\niz = 0.02\n[air]\ndensity = {density}\nwind = [0, 0, 0]\n\
         [airfoils.thin]\nslope = {slope}\n[[blade]]\nname = \"blade\"\ncount = 3\nhub_radius = 1\n\
         properties = \"blade\"\npiece = [{{ length = 10, elements = 5 }}]\n[blade.aerodynamics]\n\
         section = \"quasi_steady\"\nstations = [\n\
         {{ at = 0, chord = {chord}, airfoil = \"thin\" }},\n\
         {{ at = 10, chord = {chord}, airfoil = \"thin\" }},\n]\n\
         [modes]\nspeeds = [60]\ncount = 3\nshapes = true\n"
    );
    let input = parsed(&text);
    let outcome = modes(&input.model, &input.modes.unwrap());
    let table = outcome.table;
    let points = table.at_speed(0);
    let (_, point) = points
        .iter()
        .find(|own| own.0.name.starts_with("flap 1"))
        .unwrap();
    let shape = point.shape.as_ref().unwrap();
    let positions = &table.equilibria[0].positions;
    let mut nodes: Vec<_> = input.model.blades[0].nodes.clone();
    nodes.sort_by(|a, b| positions[*a][0].total_cmp(&positions[*b][0]));
    let values = nodes.iter().map(|node| {
        let [r, w] = [positions[*node][0], shape.displacements[*node][2].norm()];
        [r, w * w, r * w * w]
    });
    let values: Vec<_> = values.collect();
    // Simpson's rule over each element of three nodes.
    let integral = |k: usize| -> f64 {
        let elements = values.windows(3).step_by(2);
        let terms =
            elements.map(|e| (e[2][0] - e[0][0]) / 6.0 * (e[0][k] + 4.0 * e[1][k] + e[2][k]));
        terms.sum()
    };
    let expected = -density * slope * chord * SPEED * integral(2) / (4.0 * 10.0 * integral(1));
    let error = (point.growth / expected - 1.0).abs();
    let (case, pair) = (
        "flap mode of a turbine blade in still air",
        [point.growth, expected],
    );
    record::value("closed form", case, "growth [1/s]", pair, error, 0.02);
    assert!(error < 0.02, "{pair:?} {}", point.damping_ratio);
}
