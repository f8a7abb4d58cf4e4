//! Names of the same modes by eigenvalues of the turning frame, by averaged coefficients and by multipliers.

use beam_dynamics::result::StabilityResult;
use nalgebra::Complex;

use super::analyzed;
use crate::periodic::Random;

/// Names and exponents of the roots at the first value.
type Named = Vec<(String, Complex<f64>)>;

/// Four blades on lag and flap hinges with dampers, in hover with a wind along the shaft of p.
const ARTICULATED: &str = "[parameters]\np = 4\n[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\n\
    gj = 3e6\neiy = 2e6\neiz = 4e6\nm = 6\niy = 1e-3\niz = 1e-2\ndamping = { time = 2e-3 }\n\
    [air]\ndensity = 1.225\nwind = [0, 0, \"= -p\"]\n\
    [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nblades = 4\nspeed = 30\n\
    [[rotor.hinge]]\nkind = \"lag\"\noffset = 0.2\ndamping = 900\n\
    [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\n\
    [rotor.swashplate]\ncollective = 0.1\n\
    [rotor.blade]\nhub_radius = 0.2\nproperties = \"spar\"\n\
    piece = [{ length = 4.8, elements = 1 }]\n\
    [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 2\nstations = [\n\
    { at = 0.6, chord = 0.3, airfoil = \"naca0012\" },\n\
    { at = 4.8, chord = 0.3, airfoil = \"naca0012\" } ]\n\
    [periodic]\nspeed = 30\nsteps = 48\n[periodic.floquet]\nerror_estimate = false\n\
    [modes]\nspeeds = [30]\ncount = 12\n";

/// Three elastic blades in the wind p along the shaft.
const TURBINE: &str = "[parameters]\np = 8\n[properties.spar]\nea = 4e8\ngay = 1e8\ngaz = 1e8\n\
    gj = 4e5\neiy = 3e5\neiz = 8e5\nm = 10\niy = 0.2\niz = 1\ndamping = { time = 2e-3 }\n\
    [air]\ndensity = 1.225\nwind = [0, 0, \"= p\"]\n\
    [[rotor]]\nname = \"r\"\nhub = \"rigid\"\nblades = 3\nspeed = 6\n\
    [rotor.blade]\nhub_radius = 1\nproperties = \"spar\"\n\
    piece = [{ length = 10, elements = 1 }]\n\
    [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 4\nstations = [\n\
    { at = 0, chord = 1, twist = -0.07, airfoil = \"naca0012\" },\n\
    { at = 10, chord = 1, airfoil = \"naca0012\" } ]\n\
    [periodic]\nspeed = 6\nsteps = 96\n[periodic.floquet]\nerror_estimate = false\n\
    [modes]\nspeeds = [6]\ncount = 9\nwords = \"wind\"\n";

/// Names and exponents by a method.
fn named(model: &str, by: &str, count: usize) -> Named {
    let result = analyzed(&format!(
        "{model}[stability]\nby = \"{by}\"\nparameter = \"p\"\nvalues = {}\nboundaries = false\n\
         count = {count}\n",
        values(model)
    ));
    first(&result)
}

/// The value of the parameter and another one.
fn values(model: &str) -> String {
    let (_, rest) = model.split_once("p = ").unwrap();
    let value: f64 = rest.lines().next().unwrap().parse().unwrap();
    format!("[{value:?}, {:?}]", 1.1 * value)
}

fn first(result: &StabilityResult) -> Named {
    let point = &result.points[0];
    let roots = point.roots.iter().zip(&point.modes);
    roots
        .map(|(root, mode)| (result.modes[*mode].clone(), root.exponent))
        .collect()
}

/// Asserts that all modes of a list are in another one with the same name and exponent.
fn assert_same(modes: &Named, others: &Named, within: f64) {
    for (name, exponent) in modes {
        let other = others.iter().find(|other| other.0 == *name);
        let (_, other) =
            other.unwrap_or_else(|| panic!("no {name} {exponent} in\n{others:#?}\n{modes:#?}"));
        let off = (other - exponent).norm();
        assert!(
            off < within * exponent.norm().max(1.0),
            "{name}: {exponent} {other}"
        );
    }
}

// Eigenvalues of the turning frame and of the averaged equations are of the same equations, in other
// coordinates: 1e-6 are the convergence of the motion. Multipliers have the error of their steps. The blades
// do not act on each other, so that all patterns have one multiplier, which is parted by patterns. The lag
// mode has less than one oscillation in a revolution: the regressive one is seen to run forward in the fixed
// frame.
#[test]
fn an_articulated_rotor_in_hover() {
    let averaged = named(ARTICULATED, "averaged", 16);
    assert_eq!(averaged.len(), 8);
    for kind in ["lag", "flap"] {
        for pattern in ["collective", "progressive", "regressive", "differential"] {
            let name = format!("{kind} 1 {pattern}");
            assert!(
                averaged.iter().any(|own| own.0 == name),
                "{name} {averaged:#?}"
            );
        }
    }
    assert_same(&averaged, &named(ARTICULATED, "modes", 24), 1e-6);
    assert_same(&named(ARTICULATED, "Floquet", 16), &averaged, 1e-4);
}

// The same of a turbine, in the words of wind energy. The first flapping motion of its light blades does not
// oscillate, and is not among the least damped roots.
#[test]
fn a_turbine_in_axial_flow() {
    let averaged = named(TURBINE, "averaged", 18);
    for name in ["flap 2 backward", "flap 2 collective", "edge 1 forward"] {
        assert!(
            averaged.iter().any(|own| own.0 == name),
            "{name} {averaged:#?}"
        );
    }
    assert_same(&averaged, &named(TURBINE, "modes", 24), 1e-6);
    assert_same(&named(TURBINE, "Floquet", 18), &averaged, 1e-4);
}

/// Two rotors of three blades that turn in opposite senses on a wing that is held by springs, of which p is
/// the one in roll.
const TILTROTOR: &str = "[parameters]\np = 2e6\n[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\n\
    gj = 3e6\neiy = 2e6\neiz = 2e6\nm = 8\niy = 1e-2\niz = 1e-2\ndamping = { time = 1e-3 }\n\
    [[node]]\nname = \"wing\"\nposition = [0, 0, 0]\n\
    [[body]]\nnode = \"wing\"\nmass = 2000\ninertia = [2e4, 8e3, 2e4]\n\
    [[spring]]\nname = \"mount\"\nnode = \"wing\"\nstiffness = [3e6, 4e6, 5e6]\ndamping = [3e3, 4e3, 5e3]\n\
    rotational_stiffness = [\"= p\", 1.5e6, 4e6]\nrotational_damping = [4e3, 3e3, 8e3]\n";

/// A rotor beside the wing, with its sense.
fn beside(name: &str, side: f64) -> String {
    format!(
        "[[rotor]]\nname = \"{name}\"\nhub = \"articulated\"\nnode = \"wing\"\ncenter = [0, {:?}, 0.8]\n\
         axis = [0, 0, {side:?}]\naft = [1, 0, 0]\nblades = 3\nspeed = 24\nmass = 40\n\
         [[rotor.hinge]]\nkind = \"lag\"\noffset = 0.35\nstiffness = 2e4\ndamping = 400\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.35\ndamping = 900\n\
         [rotor.blade]\nhub_radius = 0.4\nproperties = \"spar\"\n\
         piece = [{{ length = 3.6, elements = 1 }}]\n",
        5.0 * side
    )
}

// Each rotor has its own coordinates, in which two rotors in opposite senses on one wing have constant
// coefficients without air: averaged equations are exact, to the error of the multipliers. Symmetric and
// antisymmetric motions have the same pattern on both rotors, and numbers.
#[test]
fn two_rotors_on_a_wing() {
    let model = format!(
        "{TILTROTOR}{}{}[periodic]\nspeed = 24\nsteps = 32\n[periodic.floquet]\nerror_estimate = false\n",
        beside("left", -1.0),
        beside("right", 1.0)
    );
    let averaged = named(&model, "averaged", 40);
    for name in [
        "lag 1 regressive",
        "lag 2 regressive",
        "lag 1 progressive",
        "flap 2 collective",
    ] {
        assert!(
            averaged.iter().any(|own| own.0 == name),
            "{name} {averaged:#?}"
        );
    }
    let multipliers = named(&model, "Floquet", 36);
    assert_same(&multipliers, &averaged, 1e-5);
}

/// Names and exponents of all points, by value.
fn all(result: &StabilityResult) -> Vec<(f64, Named)> {
    let points = result.points.iter().filter(|point| point.is_requested);
    let named = points.map(|point| {
        let roots = point.roots.iter().zip(&point.modes);
        let named = roots.map(|(root, mode)| (result.modes[*mode].clone(), root.exponent));
        (point.at, named.collect())
    });
    named.collect()
}

/// The rotor of `TURBINE` in the wind p with another wake and section, and the keys of its `[stability]`.
fn in_wind(wake: &str, section: &str, values: &str) -> String {
    let model = TURBINE
        .replace(
            "[[rotor]]",
            &format!("[[inflow]]\nname = \"i\"\nwake = \"{wake}\"\nblades = 3\n[[rotor]]"),
        )
        .replace(
            "section = \"quasi_steady\"",
            &format!("inflow = \"i\"\nsection = \"{section}\""),
        );
    format!("{model}[stability]\nparameter = \"p\"\nvalues = {values}\nboundaries = false\n")
}

/// Asserts that a sweep over ascending values has the names and the exponents of the sweep over its values in
/// the other order, and of each value by itself.
fn assert_names_of_values(text: &dyn Fn(&str) -> String, values: &[f64], within: f64) {
    let listed = |values: &[f64]| format!("{values:?}");
    let descending: Vec<_> = values.iter().rev().copied().collect();
    let up = all(&analyzed(&text(&listed(values))));
    let down = all(&analyzed(&text(&listed(&descending))));
    let single = values.iter().flat_map(|value| {
        let pair = [*value, value + 1e-9];
        all(&analyzed(&text(&listed(&pair))))
            .into_iter()
            .take(1)
            .collect::<Vec<_>>()
    });
    let single: Vec<_> = single.collect();
    assert_eq!(up.len(), values.len());
    for other in [&down, &single] {
        for ((at, own), (same, other)) in up.iter().zip(other) {
            assert!((at - same).abs() < 1e-12);
            // A root that no search finds at its value is continued from the others of a sweep; without one of
            // nearly equal frequency another may have no single pattern.
            let is_pure = |name: &str| name.split(' ').count() > 2;
            let has = |name: &str| is_pure(name) && own.iter().any(|own| own.0 == name);
            let common = other.iter().filter(|other| has(&other.0)).cloned();
            let common: Named = common.collect();
            assert_same(&common, own, within);
            let found = common.len();
            assert!(
                3 * found >= 2 * own.len().min(other.len()),
                "{at}: {own:#?} {other:#?}"
            );
        }
    }
}

// The dynamic wake and the lags of the sections have roots of their own, which are named after the air and do not
// count among the modes of the blades: these have the numbers of the modes without air at every wind.
#[test]
fn names_do_not_depend_on_the_other_values_of_a_sweep() {
    for (wake, section) in [
        ("frozen", "quasi_steady"),
        ("dynamic", "quasi_steady"),
        ("dynamic", "hgm"),
    ] {
        let text = |values: &str| in_wind(wake, section, values);
        assert_names_of_values(&text, &[5.0, 8.0, 11.0], 1e-6);
    }
}

// Random articulated rotors over the speed of the climb, with an inflow that has states, by modes and by averaged
// equations.
#[test]
fn names_of_articulated_rotors_do_not_depend_on_the_sweep() {
    let mut random = Random(5);
    let mut between = |low: f64, high: f64| low + 0.5 * (high - low) * (1.0 + random.next());
    for case in 0..crate::effort::cases(1) {
        let model = ARTICULATED
            .replace("blades = 4", &format!("blades = {}", 3 + case % 3))
            .replace(
                "offset = 0.2\ndamping = 900",
                &format!("offset = 0.2\ndamping = {}", between(100.0, 2e3)),
            )
            .replace(
                "collective = 0.1",
                &format!("collective = {}", between(0.05, 0.15)),
            )
            .replace("eiy = 2e6", &format!("eiy = {}", between(2e4, 2e5)))
            .replace(
                "[[rotor]]",
                "[[inflow]]\nname = \"i\"\nkind = \"uniform\"\n[[rotor]]",
            )
            .replace(
                "section = \"quasi_steady\"",
                "inflow = \"i\"\nsection = \"quasi_steady\"",
            );
        let by = if case % 2 == 0 { "modes" } else { "averaged" };
        let text = |values: &str| {
            format!(
                "{model}[stability]\nparameter = \"p\"\nvalues = {values}\nboundaries = false\nby = \"{by}\"\n"
            )
        };
        assert_names_of_values(&text, &[2.0, 3.0, 5.0], 1e-5);
    }
}
