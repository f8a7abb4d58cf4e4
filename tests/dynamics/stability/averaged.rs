//! Multiblade coefficients averaged over a period, beside the multipliers of the period.

use beam_dynamics::analysis::linear::{LinearFailure, linearize};
use beam_dynamics::input::{self, LinearChoice, LinearRequest};
use beam_dynamics::result::LinearModel;
use nalgebra::Complex;

use super::{analyzed, attempt};

/// Exponents of the roots at each value, by a method.
fn exponents(model: &str, by: &str, values: &str, count: usize) -> Vec<Vec<Complex<f64>>> {
    let card = format!(
        "[stability]\nby = \"{by}\"\nparameter = \"p\"\nvalues = {values}\nboundaries = false\n\
         count = {count}\n"
    );
    let result = analyzed(&format!("{model}{card}"));
    let roots = result.points.into_iter().map(|point| {
        let roots = point.roots.into_iter();
        roots.map(|root| root.exponent).collect()
    });
    roots.collect()
}

/// The averaged exponent nearest to one of a multiplier, which is known up to multiples of the speed
/// and its sign, and the distance.
fn nearest(of: Complex<f64>, among: &[Complex<f64>], speed: f64) -> f64 {
    let off = |other: &Complex<f64>| {
        let along = |sign: f64| {
            let turns = (sign * other.im - of.im) / speed;
            (turns - turns.round()) * speed
        };
        let both = [along(1.0), along(-1.0)].map(f64::abs);
        (other.re - of.re).hypot(both[0].min(both[1]))
    };
    among.iter().map(off).fold(f64::INFINITY, f64::min)
}

/// Three blades on lag and flap hinges with dampers, on a mast with springs that differ along x and y.
fn on_a_mast(speed: f64) -> String {
    format!(
        "[parameters]\np = 2e6\n[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e6\neiy = 2e6\n\
         eiz = 2e6\nm = 8\niy = 1e-2\niz = 1e-2\ndamping = {{ time = 1e-2 }}\n\
         [[node]]\nname = \"mast\"\nposition = [0, 0, 0]\n[[body]]\nnode = \"mast\"\nmass = 3200\n\
         inertia = [9, 9, 9]\n[[joint]]\nname = \"support\"\nkind = \"total\"\nnodes = [\"mast\"]\n\
         locked = [\"z\", \"about x\", \"about y\", \"about z\"]\n\
         [[spring]]\nname = \"tower\"\nnode = \"mast\"\n\n\
         stiffness = [1.1e6, \"= p\", 0]\ndamping = [3000, 3800, 0]\n\
         [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nnode = \"mast\"\nblades = 3\nspeed = {speed:?}\n\
         [[rotor.hinge]]\nkind = \"lag\"\noffset = 0.35\nstiffness = 2e4\ndamping = 400\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.35\ndamping = 300\n\
         [rotor.blade]\nhub_radius = 0.4\nproperties = \"spar\"\n\
         piece = [{{ length = 4.8, elements = 1 }}]\n\
         [periodic]\nspeed = {speed:?}\nsteps = 24\n[periodic.floquet]\nerror_estimate = false\n"
    )
}

// Without gravity and wind the coefficients of equal blades are constant in multiblade coordinates, also
// on an anisotropic support: the averaged equations are exact, to the error of the multipliers, which is
// below 8e-6 with 24 steps and decreases with their fifth power. The least damped roots belong to lag,
// flap and the mast.
#[test]
fn constant_coefficients_are_exact() {
    const SPEED: f64 = 24.0;
    let model = on_a_mast(SPEED);
    let averaged = exponents(&model, "averaged", "[1.6e6, 2e6]", 40);
    let multipliers = exponents(&model, "Floquet", "[1.6e6, 2e6]", 10);
    for (averaged, multipliers) in averaged.iter().zip(&multipliers) {
        assert!(multipliers.len() >= 5, "{multipliers:?}");
        for root in multipliers {
            let off = nearest(*root, averaged, SPEED);
            assert!(off < 2e-5, "{root} {off:e}\n{averaged:#?}");
        }
    }
}

// Without [periodic.floquet] the roots of requested values have estimated errors, which are of the size of
// the differences from the exact averaged exponents: at most ten times below them, by the multipliers of
// half the steps. All growths are larger; a growth below twice its error is not resolved.
#[test]
fn multipliers_have_estimated_errors() {
    const SPEED: f64 = 24.0;
    let card = "[stability]\nby = \"Floquet\"\nparameter = \"p\"\nvalues = [1.6e6, 2e6]\n\
                boundaries = false\ncount = 10\n";
    let model = on_a_mast(SPEED).replace("[periodic.floquet]\nerror_estimate = false\n", "");
    let exact = exponents(&on_a_mast(SPEED), "averaged", "[1.6e6, 2e6]", 40);
    let result = analyzed(&format!("{model}{card}"));
    for (point, exact) in result.points.iter().zip(&exact) {
        for root in &point.roots {
            let error = root.error.unwrap();
            let off = nearest(root.exponent, exact, SPEED);
            assert!(off < 10.0 * error && error < 1e-3, "{root:?} {off:e}");
            assert!(root.is_resolved(), "{root:?}");
        }
    }
    let mut weak = result.points[0].roots[0].clone();
    weak.exponent.re = 1.9 * weak.error.unwrap();
    assert!(!weak.is_resolved());
    weak.exponent.re = -2.1 * weak.error.unwrap();
    assert!(weak.is_resolved());
}

/// Three flapping blades on hinges with springs in a wind across the shaft, of p times the speed of the
/// tips.
const IN_WIND: &str = "[parameters]\np = 0.1\n[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\n\
    gj = 3e6\neiy = 2e6\neiz = 4e6\nm = 6\niy = 1e-3\niz = 1e-2\ndamping = { time = 1e-2 }\n\
    [air]\ndensity = 1.225\nwind = [\"= p*150\", 0, 0]\n\
    [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nblades = 3\nspeed = 30\n\
    [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\nstiffness = 1e5\n\
    [rotor.swashplate]\ncollective = 0.05\n\
    [rotor.blade]\nhub_radius = 0.2\nproperties = \"spar\"\n\
    piece = [{ length = 4.8, elements = 1 }]\n\
    [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 2\nstations = [\n\
    { at = 0.6, chord = 0.3, airfoil = \"naca0012\" },\n\
    { at = 4.8, chord = 0.3, airfoil = \"naca0012\" } ]\n\
    [periodic]\nspeed = 30\nsteps = 16\ntolerance = 1e-9\n[periodic.floquet]\nerror_estimate = false\n";

// In axial flow the averaged equations are exact, to the error of the multipliers, 1.3e-4 with 16 steps and
// 1.7e-5 with 24. Across the shaft they leave out terms of the second order in the advance ratio: four
// times as much at the double ratio. All three multipliers of flap are one; each of the three averaged
// motions is compared with it. The hinge has a spring, so that the flap frequency is not near a multiple
// of the speed, where parametric resonance would make the difference of another order.
#[test]
fn the_difference_grows_with_the_square_of_the_advance_ratio() {
    const SPEED: f64 = 30.0;
    let values = "[0, 0.1, 0.2]";
    let averaged = exponents(IN_WIND, "averaged", values, 20);
    let multipliers = exponents(IN_WIND, "Floquet", values, 3);
    let pairs = averaged.iter().zip(&multipliers);
    let off = pairs.map(|(averaged, multipliers)| {
        let flap = averaged.iter().filter(|root| root.re > -20.0);
        let flap: Vec<_> = flap.collect();
        assert_eq!(flap.len(), 3, "{averaged:?}");
        let off = flap
            .into_iter()
            .map(|root| nearest(*root, multipliers, SPEED));
        off.fold(0.0, f64::max)
    });
    let off: Vec<_> = off.collect();
    assert!(off[0] < 5e-4, "{off:?}");
    for pair in off[1..].windows(2) {
        let ratio = pair[1] / pair[0];
        assert!((3.8..4.6).contains(&ratio), "{off:?}");
    }
    assert!(off[2] < 0.02 * SPEED, "{off:?}");
}

// Each of several rotors needs three blades, which the file shows: one problem at the line of `by`.
#[test]
fn rotors_of_two_blades_are_refused() {
    let card = "[stability]\nparameter = \"p\"\nvalues = [1.6e6, 2e6]\nby = \"averaged\"\n";
    let other = "[[rotor]]\nname = \"s\"\nhub = \"rigid\"\nblades = 2\nspeed = 24\ncenter = [9, 0, 0]\n\
                 axis = [0, 1, 0]\n[rotor.blade]\nhub_radius = 0.4\nproperties = \"spar\"\n\
                 piece = [{ length = 1, elements = 1 }]\n";
    let three = on_a_mast(24.0);
    let two = three.replace("blades = 3", "blades = 2");
    for (model, rotor) in [(two, "r"), (format!("{three}{other}"), "s")] {
        let text = format!("units = \"SI\"\n{model}{card}");
        let line = text.lines().count();
        let problems = input::parse(&text, "a.dynamics.toml").unwrap_err();
        let shown = problems.to_string();
        let expected = format!(
            "error: a.dynamics.toml:{line}: \"by\" is \"averaged\", but rotor \"{rotor}\" has 2 blades, \
             expected at least three\n  help: write by = \"Floquet\""
        );
        assert!(shown.starts_with(&expected), "{shown}");
        assert_eq!(shown.matches("error").count(), 1, "{shown}");
    }
}

// A damper or a mass on one blade makes coefficients that are periodic also in hover, whose means are other
// equations: an inoperative damper may be unstable where they are stable. On all blades it is as before.
#[test]
fn blades_that_differ_are_refused() {
    let card = "[stability]\nby = \"averaged\"\nparameter = \"p\"\nvalues = [1.6e6, 2e6]\n\
                boundaries = false\ncount = 10\n";
    let damper = |blade: usize| {
        format!(
            "[[spring]]\nname = \"d{blade}\"\nnodes = [\"r/hub\", \"r {blade}/lag\"]\n\
             rotational_damping = [0, 0, 40]\n"
        )
    };
    let mass =
        "[[body]]\nname = \"tip\"\nnode = \"r 2/tip\"\nmass = 0.2\ninertia = [1e-4, 1e-4, 1e-4]\n";
    let all = [1, 2, 3].map(damper).concat();
    for (more, is_equal) in [(damper(2), false), (mass.to_owned(), false), (all, true)] {
        let result = attempt(&format!("{}{more}{card}", on_a_mast(24.0)));
        assert_eq!(
            result.failures.is_empty(),
            is_equal,
            "{more} {:?}",
            result.failures
        );
        for (_, [reason, remedy]) in &result.failures {
            assert!(
                reason.starts_with("the blades differ, mostly in"),
                "{reason}"
            );
            assert!(remedy.contains("by = \"Floquet\""), "{remedy}");
        }
    }
}

// Stiff blades with dampers between them: infinite values of constraints become ones near the shift by
// round-off, which no vector confirms and which took the places of lag and the mast. All multipliers are
// among the averaged roots, to the error of the multipliers with 32 steps.
#[test]
fn values_without_a_vector_take_no_places() {
    const SPEED: f64 = 30.4;
    let model = on_a_mast(SPEED)
        .replace("ea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e6\neiy = 2e6\n", "ea = 7e9\ngay = 2e9\ngaz = 2e9\ngj = 9e7\neiy = 4e7\n")
        .replace("eiz = 2e6", "eiz = 2e8")
        .replace("mass = 3200", "mass = 900")
        .replace("[1.1e6, \"= p\", 0]", "[4e5, \"= p\", 0]")
        .replace("steps = 24", "steps = 32")
        .replace(
            "[rotor.blade]\n",
            "[rotor.lag_damper]\nbetween = \"blades\"\nblade = [0.7, 0.1, 0]\nnext = [0.7, -0.05, 0]\n\
             damping = 30\n[rotor.blade]\n",
        );
    let averaged = exponents(&model, "averaged", "[8e5, 9e5]", 20);
    let multipliers = exponents(&model, "Floquet", "[8e5, 9e5]", 8);
    for (averaged, multipliers) in averaged.iter().zip(&multipliers) {
        for root in multipliers {
            let off = nearest(*root, averaged, SPEED);
            assert!(off < 1e-4, "{root} {off:e}\n{averaged:#?}");
        }
    }
}

/// The linear model of the rotor on a mast, by averaged coefficients.
fn linear_on_a_mast(speed: f64) -> LinearModel {
    linear(&on_a_mast(speed)).unwrap_or_else(|failure| panic!("{failure}"))
}

/// The linear model of a rotor on a mast, by averaged coefficients.
fn linear(model: &str) -> Result<LinearModel, LinearFailure> {
    let cards = format!(
        "{model}[[load]]\nnode = \"mast\"\nforce = [1, 0, 0]\ndrive = \"shaker\"\n\
         [drives.shaker]\nkind = \"constant\"\nvalue = 0\n\
         [sensors.place]\nquantity = \"displacement\"\nof = \"mast\"\ncomponent = \"x\"\n"
    );
    let text = format!("[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n{cards}");
    let request = LinearRequest {
        inputs: vec!["shaker".to_owned()],
        outputs: vec!["place".to_owned()],
        speed: None,
        about: Some(LinearChoice::Periodic),
    };
    let read = |given: &[(String, f64)]| {
        input::parse_linear(&text, "model.dynamics.toml", &request, given)
    };
    let parsed = read(&[]).unwrap_or_else(|problems| panic!("{problems}"));
    linearize(&parsed, &read)
}

// All eigenvalues of the minimal form of the averaged equations, by a dense solver, are the reference: the
// roots without `count` begin with its least damped ones, although internal damping of 0.01 s gives 32
// overdamped pairs below them in size. Names and numbers of a mode are the same for any number of roots,
// and motions of the mast have its name. Dense values are known to 1e-16 of the largest, 1.3e6 1/s.
#[test]
fn the_least_damped_roots_are_complete_and_named_alike() {
    const SPEED: f64 = 24.0;
    let mut dense = linear_on_a_mast(SPEED).eigenvalues;
    dense.retain(|own| own.im >= 0.0 && own.re > -SPEED);
    dense.sort_by(|a, b| b.re.total_cmp(&a.re));
    let roots = |count: &str, words: &str| {
        let card = format!(
            "[stability]\nby = \"averaged\"\nparameter = \"p\"\nvalues = [1.9e6, 2e6]\n\
             boundaries = false\n{count}{words}"
        );
        let result = analyzed(&format!("{}{card}", on_a_mast(SPEED)));
        let point = &result.points[1];
        let named = point.roots.iter().zip(&point.modes);
        let named = named.map(|(root, mode)| (result.modes[*mode].clone(), root.exponent));
        (named.collect::<Vec<_>>(), result.remarks)
    };
    let (found, _) = roots("", "");
    assert!(dense.len() >= 8, "{dense:?}");
    assert_eq!(found.len(), dense.len(), "{found:?}\n{dense:?}");
    for ((name, root), expected) in found.iter().zip(&dense) {
        let is_same = |other: &Complex<f64>| (root - other).norm() < 1e-7 * root.norm();
        assert!(dense.iter().any(is_same), "{name} {root}");
        assert!(
            (root.re - expected.re).abs() < 1e-7 * root.norm(),
            "{name} {root} {expected}"
        );
    }
    let names: Vec<_> = found.iter().map(|(name, _)| name.as_str()).collect();
    for expected in [
        "mast x 1",
        "mast y 1",
        "flap 1 collective",
        "lag 1 regressive",
    ] {
        assert!(names.contains(&expected), "{names:?}");
    }
    for count in [6, 12, 40] {
        let (others, _) = roots(&format!("count = {count}\n"), "");
        for (name, root) in &others {
            let alike = found.iter().find(|own| (own.1 - root).norm() < 1e-6);
            assert!(alike.is_none_or(|own| own.0 == *name), "{name} {alike:?}");
            assert!(alike.is_some() || root.re < -SPEED, "{name} {root}");
        }
    }
    let (wind, _) = roots("", "words = \"wind\"\n");
    let has = |name: &str| wind.iter().any(|own| own.0 == name);
    assert!(
        has("edge 1 backward") && has("edge 1 collective"),
        "{wind:?}"
    );
}

// The linear model has the eigenvalues of the modes, states in multiblade coordinates, and the gain of a
// constant force on the mast, 1/k: turning blades do not resist a displacement.
#[test]
fn linear_models_have_multiblade_states() {
    const SPEED: f64 = 24.0;
    let model = linear_on_a_mast(SPEED);
    assert_eq!(
        model.about,
        "the periodic motion at 229.183 rpm, in multiblade coordinates averaged over it"
    );
    for word in ["collective of", "cosine of", "sine of"] {
        let has = |own: &beam_dynamics::result::LinearVariable| own.name.starts_with(word);
        assert!(model.states.iter().any(has), "{:#?}", model.states);
    }
    let modes = exponents(&on_a_mast(SPEED), "averaged", "[1.9e6, 2e6]", 12);
    for mode in &modes[1] {
        let distances = model.eigenvalues.iter().map(|own| (own - mode).norm());
        let off = distances.fold(f64::INFINITY, f64::min);
        assert!(off < 1e-7 * mode.norm(), "{mode} {off:e}");
    }
    let states = (-&model.a).lu().solve(&model.b).unwrap();
    let gain = (&model.c * states + &model.d)[(0, 0)];
    assert!((gain * 1.1e6 - 1.0).abs() < 1e-6, "{gain}");
}

// Sections with a small moment of inertia have fast states, up to 1e5 times faster than the modes: the linear model
// has the modes of the same equations by inversion, and the ones of sections without it as the limit: moments of
// inertia of 1e-6 kg m change modes of a blade of 295 kg m^2 by less than 1e-6.
#[test]
fn slender_sections_have_a_linear_model() {
    let with = |inertia: &str| {
        on_a_mast(24.0).replace(
            "iy = 1e-2\niz = 1e-2",
            &format!("iy = {inertia}\niz = {inertia}"),
        )
    };
    let limit = linear(&with("0")).unwrap_or_else(|failure| panic!("{failure}"));
    let distance = |eigenvalues: &[Complex<f64>], mode: Complex<f64>| {
        let distances = eigenvalues.iter().map(|own| (own - mode).norm());
        distances.fold(f64::INFINITY, f64::min) / mode.norm()
    };
    for inertia in ["1e-3", "1e-4", "1e-5", "1e-6"] {
        let found = linear(&with(inertia));
        let found = found.unwrap_or_else(|failure| panic!("{inertia} {failure}"));
        let modes = exponents(&with(inertia), "averaged", "[1.9e6, 2e6]", 10);
        for mode in &modes[1] {
            let off = distance(&found.eigenvalues, *mode);
            let from_limit = distance(&limit.eigenvalues, *mode);
            assert!(off < 1e-8, "{inertia} {mode} {off:e}");
            assert!(
                inertia != "1e-6" || from_limit < 1e-6,
                "{inertia} {mode} {from_limit:e}"
            );
        }
    }
}

// Three blades with lags of the sections in a dynamic wake, in axial flow: the averaged equations are the ones in
// turning axes, so that all modes with a name in both have one growth and frequency. The states of the air are far
// more than the modes, whose shapes without air have fewer coefficients. The motion rests in
// turning axes, so that steps have no error: 1e-8 of the root, 1e-10 are found. (At 4 m/s the strip at the tip has two
// states of rest.)
#[test]
fn averaged_modes_in_axial_flow_are_the_ones_of_turning_axes() {
    const MODEL: &str = "[parameters]\nwind = 8\n[properties.spar]\nea = 7e7\ngay = 2e7\ngaz = 2e7\n\
        gj = 9e4\neiy = 4e4\neiz = 2e5\nm = 6\niy = 1e-3\niz = 1e-2\n[air]\ndensity = 1.225\n\
        wind = [0, 0, \"= wind\"]\n[[rotor]]\nname = \"r\"\nhub = \"rigid\"\nblades = 3\nspeed = 6.283185307179586\n\
        mass = 80\n[rotor.inflow]\nwake = \"dynamic\"\n[rotor.blade]\nhub_radius = 0.4\n\
        properties = \"spar\"\npiece = [{ length = 5, elements = 4 }]\n[rotor.blade.aerodynamics]\n\
        section = \"hgm\"\nstations = [{ at = 0.5, chord = 0.35, airfoil = \"naca0012\" }, \
        { at = 5, chord = 0.35, airfoil = \"naca0012\" }]\n";
    const STABILITY: &str = "[stability]\nparameter = \"wind\"\nvalues = [3, 3.05]\nboundaries = false\nwords = \"wind\"\n";
    let averaged = analyzed(&format!(
        "{MODEL}[periodic]\nspeed = 6.283185307179586\nsteps = 12\n{STABILITY}by = \"averaged\"\n"
    ));
    let turning = analyzed(&format!(
        "{MODEL}[modes]\nspeeds = [6.283185307179586]\ncount = 9\n{STABILITY}"
    ));
    let mut worst = 0.0_f64;
    let mut common = Vec::new();
    for (mode, name) in turning.modes.iter().enumerate() {
        let Some(other) = averaged.modes.iter().position(|own| own == name) else {
            continue;
        };
        common.push(name.as_str());
        for (a, b) in turning.points.iter().zip(&averaged.points) {
            let both = a.root_of(mode).zip(b.root_of(other));
            let (a, b) = both.unwrap_or_else(|| panic!("{name} is missing"));
            worst = worst.max((a.exponent - b.exponent).norm() / a.exponent.norm());
        }
    }
    for name in ["flap 1", "edge 1", "flap 2"] {
        for pattern in ["backward", "collective", "forward"] {
            let name = format!("{name} {pattern}");
            assert!(common.contains(&name.as_str()), "{name}: {common:?}");
        }
    }
    println!("{worst:e}");
    assert!(worst < 1e-8, "{worst:e}");
}
