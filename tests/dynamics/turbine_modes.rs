//! Modes with air of a turbine rotor with three elastic blades: names and frequencies in the fixed frame,
//! damping against runs in time, the limit without air, and flap damping in closed form.

use std::f64::consts::TAU;

use beam_dynamics::analysis::identification::{IdentificationSettings, Record, identify};
use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input::{self, Input};
use beam_dynamics::result::{IdentificationMethod, StabilityResult, StabilityRoot};

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
pub const FILE: &str = "turbine.dynamics.toml";
/// Revolutions per second, and the speed of the rotor \[rad/s\].
const TURNS: f64 = 1.0;
pub const SPEED: f64 = TAU * TURNS;

pub fn text(wake: &str, section: &str) -> String {
    ROTOR.replace("WAKE", wake).replace("SECTION", section)
}

fn parsed(text: &str) -> Input {
    input::parse(text, FILE).unwrap_or_else(|problems| panic!("{problems}\n{text}"))
}

/// The stability of a file over the values of a parameter.
pub fn over(text: &str, parameter: &str, values: &str) -> StabilityResult {
    let text = format!(
        "{text}[stability]\nparameter = \"{parameter}\"\nvalues = {values}\nboundaries = false\n"
    );
    let input = parsed(&text);
    let read = |given: &[(String, f64)]| input::parse_with(&text, FILE, given);
    let result = stability("turbine", &input.stability.unwrap(), None, &read);
    assert!(result.failures.is_empty(), "{:#?}", result.failures);
    result
}

/// The root at the value `index` of a name, or of the first mode there that begins with the name.
pub fn root<'a>(result: &'a StabilityResult, index: usize, name: &str) -> &'a StabilityRoot {
    let fits = |exact: bool| {
        let modes = result.modes.iter().enumerate();
        let mut modes = modes.filter(move |(_, own)| match exact {
            true => *own == name,
            false => own.starts_with(name),
        });
        modes.find_map(|(mode, _)| result.points[index].root_of(mode))
    };
    let found = fits(true).or_else(|| fits(false));
    found.unwrap_or_else(|| panic!("no {name} among {:?}", result.modes))
}

// The blades of a whirl have one frequency f in turning axes, up to the small coupling by the wake, and the
// fixed frame shows f - n and f + n: n is the speed. A collective mode keeps its frequency. The pitch of the
// second wind follows from the schedule.
#[test]
fn whirls_are_named_and_shifted_by_the_speed() {
    let result = over(&text("dynamic", "separation_lag"), "wind", "[8, 12]");
    for index in 0..2 {
        let names = ["edge 1 backward", "edge 1 collective", "edge 1 forward"];
        let seen = names.map(|name| root(&result, index, name).frequency() / TAU);
        assert!((seen[2] - seen[0] - 2.0 * TURNS).abs() < 1e-3, "{seen:?}");
        assert!((seen[1] - seen[0] - TURNS).abs() < 1e-3, "{seen:?}");
    }
    // New modes are numbered by their frequency.
    let waves = |name: &str| root(&result, 0, name).waves;
    let expected = [Some(-1), Some(0), Some(1)];
    assert_eq!(
        ["flap 1 backward", "flap 1 collective", "flap 1 forward"].map(waves),
        expected
    );
}

// At 60 rpm and 8 m/s the ratio of the speeds of tips and wind is 8.6. Wind from the other side, a speed in rad/s that
// is read as rpm, one of rpm that is read in rad/s, and a pitch of 30 degrees in the wrong sense are remarked, and
// the rotor as it is has no remark.
#[test]
fn operating_points_of_no_turbine_are_remarked() {
    let remarks = |change: [&str; 2]| {
        let text = text("frozen", "quasi_steady");
        assert!(text.contains(change[0]), "{text}");
        let result = over(&text.replace(change[0], change[1]), "wind", "[8]");
        let remarks = result.remarks.into_iter();
        remarks
            .filter(|one| one.starts_with("rotor \"rotor\""))
            .collect::<Vec<_>>()
    };
    let speed = "speeds = [60]";
    assert_eq!(remarks([speed, speed]), Vec::<String>::new());
    for (from, to, expected) in [
        (
            "\"= wind\"]",
            "\"= -wind\"]",
            "is against the axis of rotation",
        ),
        (
            speed,
            "speeds = [3]",
            "expected more than 0.5: check the unit of the speed of rotation",
        ),
        (
            speed,
            "speeds = [\"20 rad/s\"]",
            "expected less than 20 of a turbine",
        ),
        ("\"= -feather\"", "\"= 30 + feather\"", "are beyond stall"),
        (
            "\"= -feather\"",
            "\"= 30 + feather\"",
            "kW from its shaft in a wind of 8 m/s",
        ),
    ] {
        let found = remarks([from, to]);
        assert!(
            found.iter().any(|one| one.contains(expected)),
            "{expected}: {found:#?}"
        );
        assert!(
            found[0].starts_with("rotor \"rotor\" at wind = 8: "),
            "{found:#?}"
        );
    }
}

// Light blades, whose first flap mode has three quarters of the critical damping: no system without lags has
// an oscillation near it (with a quasi-steady section it does not oscillate), and it is found from the mode
// without air. Numbers of flap modes count from it, at each wind. Two section models have the same lags
// of circulation; the other one has an added mass of a fifth of the mass of the blade, which at equal damping
// and stiffness changes the ratio by a tenth of itself, 0.07.
#[test]
fn modes_of_large_damping_are_not_lost() {
    let light = |section: &str| {
        let text = text("frozen", section).replace("count = 6", "count = 12");
        text.replace("m = 10\niy = 0.2\niz = 1", "m = 5\niy = 0.06\niz = 0.3")
    };
    let damping = |root: &StabilityRoot| -root.exponent.re / root.exponent.norm();
    let winds = "[6, 8, 10, 12]";
    let [lagged, other] = ["hgm", "lagged"].map(|word| over(&light(word), "wind", winds));
    for index in 0..4 {
        let [first, second] =
            ["flap 1 collective", "flap 2 collective"].map(|name| root(&lagged, index, name));
        let frequencies = [first, second].map(|root| root.frequency() / TAU);
        println!("{frequencies:?} Hz, {} {}", damping(first), damping(second));
        assert!((3.0..4.5).contains(&frequencies[0]), "{frequencies:?}");
        assert!((8.0..10.5).contains(&frequencies[1]), "{frequencies:?}");
        let difference = damping(first) - damping(root(&other, index, "flap 1 collective"));
        assert!(damping(first) > 0.6, "{}", damping(first));
        assert!(difference.abs() < 0.07, "{difference}");
    }
}

/// Displacement of the tip in the shape of a mode \[m\], and step of the run \[s\].
const AMPLITUDE: f64 = 0.02;
const STEP: f64 = 0.01;

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

// Equal motions of the three blades have no cosine part, so that the run shows the whirl alone. The decay is
// the growth of the mode to 3 %, the frequency in the fixed frame to 3e-3: 1.4 % and 2.2e-3 at this step, 0.1 %
// and 6e-4 at half of it.
#[test]
fn a_whirl_decays_in_time_as_its_eigenvalue_says() {
    let text = text("dynamic", "separation_lag");
    let name = "edge 1 forward";
    let result = over(&text, "wind", "[8, 8.5]");
    let expected = root(&result, 0, name);
    let input = parsed(&text);
    let table = modes(&input.model, &input.modes.unwrap()).table;
    let number = table.at_speed(0).iter().position(|own| own.0.name == name);
    let number = number.unwrap() + 1;
    let motion = multiblade(&format!(
        "{text}[transient]\nto = 4\nstep = {STEP}\nstart = \"rotating\"\nspeed = 60\n\
         shape = {{ mode = {number}, displacement = {AMPLITUDE} }}\n"
    ));
    let found = fitted(&motion, STEP, expected.frequency());
    let case = "edgewise forward whirl of three blades in the wind";
    let pairs = [
        ("decay in time [1/s]", [found[0], expected.growth()], 0.03),
        (
            "frequency in time [rad/s]",
            [found[1], expected.frequency()],
            3e-3,
        ),
    ];
    for (quantity, pair, within) in pairs {
        let error = (pair[0] / pair[1] - 1.0).abs();
        record::value("own modes", case, quantity, pair, error, within);
        assert!(error < within, "{quantity}: {pair:?}");
    }
    // The identification of records finds the same motion in the run.
    let times: Vec<_> = (0..motion.len()).map(|k| STEP * k as f64).collect();
    let settings = IdentificationSettings {
        count: 4,
        noise: 1e-6,
    };
    let (found, _) = identify(&Record::new(&times, &motion).unwrap(), &settings).unwrap();
    let of = |method| {
        let mut own = found.iter().filter(move |mode| mode.method == method);
        let largest = own.next();
        largest.unwrap_or_else(|| panic!("{method:?}: {found:?}"))
    };
    for (method, within) in [
        (IdentificationMethod::Prony, [0.03, 3e-3]),
        (IdentificationMethod::MovingBlock, [0.1, 5e-3]),
    ] {
        let own = of(method);
        let errors = [
            (own.growth / expected.growth() - 1.0).abs(),
            (own.frequency / expected.frequency() - 1.0).abs(),
        ];
        assert!(
            errors[0] < within[0] && errors[1] < within[1],
            "{method:?}: {errors:?}"
        );
    }
}

// Without air nothing is damped: the growth of a mode falls in proportion to the density. Whirls have the
// growth of their collective mode, and without air blades that do not act on each other have any waves. The
// least growth, of the edgewise modes, is some 1e-6 1/s, thirty times the round-off of the eigenvalues.
#[test]
fn the_damping_by_air_ends_with_the_air() {
    let result = over(
        &text("frozen", "quasi_steady"),
        "density",
        "[5e-5, 1e-4, 2e-4]",
    );
    for name in ["flap 1", "flap 2", "edge 1"] {
        let growth = [0, 1, 2].map(|index| root(&result, index, name).growth());
        assert!(growth[0] < 0.0 && growth[0] > -1e-3, "{name}: {growth:?}");
        for pair in growth.windows(2) {
            assert!((pair[1] / pair[0] - 2.0).abs() < 0.01, "{name}: {growth:?}");
        }
    }
}

// A blade that flaps with the shape w(r) in still air, without induced velocity, at small angles: lift per
// length -rho a c Omega r w_t / 2 on the mass m per length, so that
//     growth = -rho a c Omega int r w^2 dr / (4 m int w^2 dr) ,
// -gamma Omega / 16 of a rigid blade with its hinge at the axis. The ratio of the integrals and the frequency
// without air are of Ritz's method with six polynomials (r - 1)^2 to (r - 1)^7 for EI 3e5, m 10, 1 to 11 m,
// 60 rpm. The air changes the shape by the square of the damping ratio: 0.05 % of the growth, and 1 % of the
// frequency.
#[test]
fn flap_damping_has_its_closed_form() {
    let (density, slope, chord) = (0.4, 5.7, 0.6);
    let (radius, vacuum): (f64, f64) = (9.012235, 1.507995);
    let text = format!(
        "units = \"SI\"\n[properties.blade]\nea = 4e8\ngay = 1e9\ngaz = 1e9\ngj = 4e7\neiy = 3e5\n\
         eiz = 8e8\nm = 10\niy = 0.02\niz = 0.02\n[air]\ndensity = {density}\nwind = [0, 0, 0]\n\
         [airfoils.thin]\nslope = {slope}\n[[blade]]\nname = \"blade\"\ncount = 3\nhub_radius = 1\n\
         properties = \"blade\"\npiece = [{{ length = 10, elements = 5 }}]\n[blade.aerodynamics]\n\
         section = \"quasi_steady\"\nstations = [\n\
         {{ at = 0, chord = {chord}, airfoil = \"thin\" }},\n\
         {{ at = 10, chord = {chord}, airfoil = \"thin\" }},\n]\n\
         [modes]\nspeeds = [60]\ncount = 3\n"
    );
    let input = parsed(&text);
    let table = modes(&input.model, &input.modes.unwrap()).table;
    let growth = -density * slope * chord * SPEED * radius / (4.0 * 10.0);
    let damped = (vacuum * vacuum - (growth / TAU).powi(2)).sqrt();
    let points = table.at_speed(0);
    assert_eq!(points.len(), 3);
    for (branch, point) in points {
        assert!(branch.name.starts_with("flap 1 "), "{}", branch.name);
        for (quantity, pair, within) in [
            ("growth [1/s]", [point.growth, growth], 2e-3),
            ("frequency [Hz]", [point.frequency, damped], 0.01),
        ] {
            let error = (pair[0] / pair[1] - 1.0).abs();
            let case = format!("{} of a turbine blade in still air", branch.name);
            record::value("closed form", &case, quantity, pair, error, within);
            assert!(error < within, "{quantity}: {pair:?}");
        }
    }
}
