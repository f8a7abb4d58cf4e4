//! Trim of equilibria.

use super::trimmed;
use crate::periodic::Random;

/// A mass on a radial guide of a hub, on a spring of 900 N/m that is relaxed at 1 m, and a force.
fn mass(cards: &str) -> String {
    format!(
        "[[node]]\nname = \"mass\"\nposition = [1, 0, 0]\n\
         [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n\
         [[joint]]\nname = \"guide\"\nkind = \"prismatic\"\nnodes = [\"mass\"]\naxis = [1, 0, 0]\n\
         [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [900, 0, 0]\n\
         [sensors.x]\nquantity = \"position\"\nof = \"mass\"\ncomponent = \"x\"\nunit = \"m\"\n\
         {cards}"
    )
}

const FORCE: &str = "[[load]]\nnode = \"mass\"\nforce = [1, 0, 0]\ndrive = \"= pull\"\n\
                     [[trim.control]]\nname = \"pull\"\nguess = 10\nscale = 100\n\
                     [[trim.target]]\nname = \"place\"\nsignal = \"= x\"\nvalue = 1.5\n";

// Closed form: F = k (x - 1) - m w^2 x, and with a cubic signal the root of x^3 = 8.
#[test]
fn a_force_that_holds_a_mass_in_its_place() {
    let turning = mass(&format!(
        "[trim]\nmethod = \"equilibrium\"\nspeed = 4\n{FORCE}"
    ));
    let points = trimmed(&turning);
    let expected = 900.0 * 0.5 - 2.0 * 16.0 * 1.5;
    assert!(
        (points[0].controls[0] - expected).abs() < 1e-8 * expected,
        "{points:?}"
    );
    let cubic = turning.replace(
        "signal = \"= x\"\nvalue = 1.5",
        "signal = \"= x^3\"\nvalue = 8",
    );
    let points = trimmed(&cubic);
    let expected = 900.0 - 2.0 * 16.0 * 2.0;
    assert!(
        (points[0].controls[0] - expected).abs() < 1e-8 * expected,
        "{points:?}"
    );
    assert!((points[0].targets[0][0] - 8.0).abs() < 1e-8);
}

// Random targets and speeds, 200 cases: the same closed form.
#[test]
fn random_places() {
    let mut random = Random(1);
    let mut next = || 0.5 * (random.next() + 1.0);
    for _ in 0..200 {
        let (place, speed) = (0.3 + 3.0 * next(), 15.0 * next());
        let text = mass(&format!(
            "[trim]\nmethod = \"equilibrium\"\nspeed = {speed:?}\n{}",
            FORCE.replace("value = 1.5", &format!("value = {place:?}"))
        ));
        let found = trimmed(&text)[0].controls[0];
        let expected = 900.0 * (place - 1.0) - 2.0 * speed * speed * place;
        assert!(
            (found - expected).abs() < 1e-6,
            "{place} {speed}: {found} {expected}"
        );
    }
}

// The speed of the rotor is a parameter of the file: w^2 = k (x - 1)/(m x). A second parameter with a
// target of its own is the stiffness, and a sweep over the place begins at each solution.
#[test]
fn the_speed_at_which_a_mass_is_in_its_place() {
    let speed = "[parameters]\nomega = 3\nplace = 1.5\n[trim]\nmethod = \"equilibrium\"\n\
                 speed = \"= omega\"\ntolerance = 1e-10\n\
                 [[trim.control]]\nname = \"omega\"\nlower = 0.1\nscale = 5\nstep = 3\n\
                 [[trim.target]]\nname = \"place\"\nsignal = \"= x\"\nvalue = \"= place\"\n\
                 [trim.sweep]\nparameter = \"place\"\nvalues = [1.5, 1.8, 2.5]\n";
    for (point, place) in trimmed(&mass(speed)).iter().zip([1.5_f64, 1.8, 2.5]) {
        let expected = (900.0 * (place - 1.0) / (2.0 * place)).sqrt();
        assert!(
            (point.controls[0] - expected).abs() < 1e-7,
            "{point:?} {expected}"
        );
        assert_eq!(point.at, Some(place));
    }
}

// Both kinds of controls together: at the speed that leaves 300 N of the spring to a force, of which the
// place is a target, and the centrifugal force m w^2 x another one.
#[test]
fn a_force_and_a_speed_together() {
    let both = format!(
        "[parameters]\nomega = 3\n[trim]\nmethod = \"equilibrium\"\nspeed = \"= omega\"\n\
         tolerance = 1e-10\n{FORCE}\
         [[trim.control]]\nname = \"omega\"\nlower = 0.1\n\
         [[trim.target]]\nname = \"centrifugal\"\nsignal = \"= 2*omega^2*x\"\nvalue = 150\nscale = 100\n"
    );
    let point = &trimmed(&mass(&both))[0];
    assert!((point.controls[0] - 300.0).abs() < 1e-6, "{point:?}");
    assert!(
        (point.controls[1] - 50.0_f64.sqrt()).abs() < 1e-7,
        "{point:?}"
    );
}

// The reaction of a guide as a target: the force across it is the one of the control.
#[test]
fn a_reaction_as_a_target() {
    let across = "[[load]]\nnode = \"mass\"\nforce = [0, 1, 0]\ndrive = \"= 2*side\"\n\
                  [sensors.held]\nquantity = \"reaction_force\"\nof = \"guide\"\nnode = \"mass\"\n\
                  component = \"y\"\nunit = \"N\"\n\
                  [trim]\nmethod = \"equilibrium\"\n\
                  [[trim.control]]\nname = \"side\"\n\
                  [[trim.target]]\nname = \"held\"\nsignal = \"held\"\nvalue = -50\n";
    let point = &trimmed(&mass(across))[0];
    assert!((point.controls[0] - 25.0).abs() < 1e-9, "{point:?}");
}
