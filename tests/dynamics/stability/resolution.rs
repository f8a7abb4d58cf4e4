//! Errors of multipliers by the steps of the period, and states of the air that are no motion.

use beam_dynamics::result::StabilityResult;

use super::analyzed;

/// Three stiff blades on flap hinges with springs and dampers, with further cards, at 30 rad/s.
fn blades([hinge, aerodynamics]: [&str; 2], periodic: &str) -> StabilityResult {
    analyzed(&format!(
        "[parameters]\np = 30\n[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e7\neiy = 2e9\n\
         eiz = 2e8\nm = 6\niy = 1e-2\niz = 1e-2\ndamping = {{ time = 1e-3 }}\n\
         [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nblades = 3\nspeed = \"= p\"\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\n{hinge}\n\
         [rotor.blade]\nhub_radius = 0.2\nproperties = \"spar\"\n\
         piece = [{{ length = 4.8, elements = 1 }}]\n{aerodynamics}\
         [periodic]\nspeed = \"= p\"\n{periodic}\n\
         [stability]\nby = \"Floquet\"\nparameter = \"p\"\nvalues = [30]\nboundaries = false\ncount = 6\n"
    ))
}

/// Growth of the least damped oscillation \[1/s\] with its estimated error, and whether its steps are remarked.
fn flap(periodic: &str) -> ([f64; 2], bool) {
    let result = blades(["stiffness = 1e6\ndamping = 200", ""], periodic);
    let roots = result.points[0].roots.iter();
    let root = roots
        .filter(|root| root.in_blades > 0.0)
        .max_by(|a, b| a.growth().total_cmp(&b.growth()))
        .unwrap();
    println!("{periodic}: {root:?} {:?}", result.remarks);
    let mut remarks = result.remarks.iter();
    let is_remarked = remarks.any(|text| text.contains("the steps of the period are too long"));
    ([root.growth(), root.error.unwrap()], is_remarked)
}

// Flap at 2.5 cycles in a revolution: 221 kg m^2 about the hinge, 1e6 N m/rad, 200 N m s/rad, so that the growth is
// -0.45 1/s. Twelve steps of two stages, which are 1.3 rad of the oscillation each, add -2 1/s. The estimate contains
// the error of the frequency too, and the form for constant axes: a factor of two is required.
#[test]
fn steps_that_are_too_long_are_remarked_with_their_error() {
    let ([exact, small], is_remarked) = flap("steps = 96");
    assert!(
        !is_remarked && small < 0.01 * exact.abs(),
        "{exact} {small}"
    );
    // Half of the damping over the moment of inertia about the hinge, to the mass of the elastic blade.
    assert!((exact + 0.452).abs() < 0.02, "{exact}");
    for steps in [12, 16] {
        let ([growth, error], is_remarked) = flap(&format!("steps = {steps}\nstages = \"two\""));
        let off = (growth - exact).abs();
        assert!(is_remarked, "{steps}: {growth} {error}");
        assert!(
            (0.5..2.0).contains(&(error / off)),
            "{steps}: {error} {off}"
        );
    }
}

// Induced velocities of a frozen wake are constants: as states their roots would be near -A/E, of 864000 s and A of 13
// with blades as lightly loaded as these, -1.5e-5 1/s. The flapping of the blades is damped by their lift.
#[test]
fn a_frozen_wake_has_no_roots() {
    let air = "[rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 2\nstations = [\n\
               { at = 0.6, chord = 0.3, airfoil = \"naca0012\" },\n\
               { at = 4.8, chord = 0.3, airfoil = \"naca0012\" } ]\n\
               [rotor.inflow]\nwake = \"frozen\"\n\
               [air]\ndensity = 1.225\nwind = [3, 0, 5]\n";
    let result = blades(["stiffness = 1e5", air], "steps = 16");
    let roots = &result.points[0].roots;
    assert!(!roots.is_empty());
    for root in roots {
        assert!(root.growth() < -1.0, "{root:?}");
    }
}
