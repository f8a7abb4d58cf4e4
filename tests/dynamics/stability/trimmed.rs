//! Multipliers about a trim: the controls are found by shooting in one file, and the motion with these controls by
//! marching in another one.

use beam_dynamics::result::StabilityPoint;

use super::analyzed;

/// Three blades on flap hinges with springs in a wind of p times the speed of the tips across the shaft, with a
/// collective and two cyclic controls.
fn rotor(controls: [&str; 3], periodic: &str) -> String {
    let [collective, cosine, sine] = controls;
    format!(
        "[parameters]\np = 0.1\n[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e6\neiy = 2e6\n\
         eiz = 4e6\nm = 6\niy = 1e-3\niz = 1e-2\ndamping = {{ time = 1e-2 }}\n\
         [air]\ndensity = 1.225\nwind = [\"= p*150\", 0, 0]\n\
         [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nblades = 3\nspeed = 30\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\nstiffness = 1e5\n\
         [rotor.swashplate]\ncollective = {collective}\ncosine = {cosine}\nsine = {sine}\n\
         [rotor.blade]\nhub_radius = 0.2\nproperties = \"spar\"\n\
         piece = [{{ length = 4.8, elements = 1 }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 2\nstations = [\n\
         {{ at = 0.6, chord = 0.3, airfoil = \"naca0012\" }},\n\
         {{ at = 4.8, chord = 0.3, airfoil = \"naca0012\" }} ]\n\
         [periodic]\nspeed = 30\nsteps = 16\ntolerance = 1e-10\n{periodic}\n\
         [periodic.floquet]\nerror_estimate = false\n\
         [stability]\nby = \"Floquet\"\nparameter = \"p\"\nvalues = [0.1, 0.2]\nboundaries = false\ncount = 6\n"
    )
}

/// Thrust, and moments that tilt the shaft, as targets of the controls.
fn trim() -> String {
    let mut text = "[trim]\n".to_owned();
    for (name, guess) in [("collective", 0.1), ("cosine", 0.0), ("sine", -0.02)] {
        text += &format!("[[trim.control]]\nname = \"{name}\"\nguess = {guess:?}\nscale = 0.1\n");
    }
    for (name, quantity, axis, value, scale) in [
        ("thrust", "force", "z", 9e3, 1e4),
        ("roll", "moment", "x", 0.0, 2e4),
        ("pitch", "moment", "y", 0.0, 2e4),
    ] {
        text += &format!(
            "[sensors.{name}]\nquantity = \"reaction_{quantity}\"\nof = \"r/shaft\"\nnode = \"r/hub\"\n\
             component = \"{axis}\"\n[[trim.target]]\nname = \"{name}\"\nsignal = \"= {name}\"\n\
             value = {value:?}\nscale = {scale:?}\n"
        );
    }
    text
}

// Controls are held in the small motions about a trim: the multipliers are the ones of the motion with the numbers
// of the trim, by a march of a hundred periods or less, to the tolerances of both searches times the condition of
// the exponents.
#[test]
fn multipliers_of_a_trim_are_those_of_its_controls() {
    let trimmed =
        analyzed(&(rotor(["\"= collective\"", "\"= cosine\"", "\"= sine\""], "") + &trim()));
    for (number, point) in trimmed.points.iter().enumerate() {
        assert_eq!(point.controls.len(), 3, "{point:?}");
        let controls: Vec<_> = point
            .controls
            .iter()
            .map(|own| format!("{own:?}"))
            .collect();
        let controls = [&controls[0], &controls[1], &controls[2]].map(String::as_str);
        let marched = analyzed(&rotor(controls, "method = \"march\"\nperiods = 100"));
        let own = |point: &StabilityPoint| {
            let roots = point.roots.iter();
            roots.map(|root| root.exponent).collect::<Vec<_>>()
        };
        let (found, expected) = (own(point), own(&marched.points[number]));
        assert!(found.len() >= 3, "{found:?}");
        for root in &found {
            let distances = expected.iter().map(|other| (other - root).norm());
            let off = distances.fold(f64::INFINITY, f64::min);
            assert!(off < 1e-6 * root.norm(), "{root} {off:e} {expected:?}");
        }
    }
    // Another speed has other controls.
    let [slow, fast] = [0, 1].map(|number: usize| &trimmed.points[number].controls);
    assert!((slow[2] - fast[2]).abs() > 1e-3, "{slow:?} {fast:?}");
}

/// The same blades in hover at the speed `rate`, trimmed to a thrust by the equilibrium.
fn hovering(rate: f64, collective: &str, trim: &str) -> String {
    format!(
        "[parameters]\nrate = {rate}\n[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e6\neiy = 2e6\n\
         eiz = 4e6\nm = 6\niy = 1e-3\niz = 1e-2\n[air]\ndensity = 1.225\n\
         [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nblades = 3\nspeed = \"= rate\"\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\n\
         [rotor.swashplate]\ncollective = {collective}\n\
         [rotor.blade]\nhub_radius = 0.2\nproperties = \"spar\"\n\
         piece = [{{ length = 4.8, elements = 1 }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 2\nstations = [\n\
         {{ at = 0.6, chord = 0.3, airfoil = \"naca0012\" }},\n\
         {{ at = 4.8, chord = 0.3, airfoil = \"naca0012\" }} ]\n\
         [modes]\nspeeds = \"= rate\"\n[sensors.thrust]\nquantity = \"thrust\"\n{trim}\
         [stability]\nby = \"modes\"\nparameter = \"rate\"\nvalues = [24, 30]\nboundaries = false\ncount = 6\n"
    )
}

// The speed of a trim belongs to the value that is analyzed: the roots are the ones of the model whose collective
// is the trimmed number, whatever value the file itself has. To the tolerances of the trims, 1e-9, times the
// condition of the roots.
#[test]
fn the_speed_of_a_value_is_the_speed_of_its_trim() {
    let trim = "[trim]\nmethod = \"equilibrium\"\nspeed = \"= rate\"\n\
        [[trim.control]]\nname = \"collective\"\nguess = 0.1\nscale = 0.1\n\
        [[trim.target]]\nname = \"thrust\"\nsignal = \"= thrust\"\nvalue = 8e3\nscale = 1e4\n";
    let trimmed = analyzed(&hovering(30.0, "\"= collective\"", trim));
    for (number, point) in trimmed.points.iter().enumerate() {
        let collective = format!("{:?}", point.controls[0]);
        for result in [
            analyzed(&hovering(24.0, "\"= collective\"", trim)),
            analyzed(&hovering(30.0, &collective, "")),
        ] {
            let expected = &result.points[number].roots;
            assert!(!expected.is_empty() && expected.len() == point.roots.len());
            for (root, other) in point.roots.iter().zip(expected) {
                let off = (root.exponent - other.exponent).norm();
                assert!(
                    off < 1e-6 * other.exponent.norm(),
                    "{number} {root:?} {other:?}"
                );
            }
        }
    }
}
