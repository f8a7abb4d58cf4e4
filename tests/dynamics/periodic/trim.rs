//! Controls that are found so that means have given values.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::{analyzed, attempt};

/// A damped oscillator with a constant force, and cosine and sine of another one as controls; of which
/// mean and first harmonic are given.
fn oscillator(force: &str) -> String {
    format!(
        "[[node]]\nname = \"mass\"\nposition = [0, 0, 0]\n\
         [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n\
         [[joint]]\nname = \"guide\"\nkind = \"prismatic\"\nnodes = [\"mass\"]\n\
         axis = [1, 0, 0]\n\
         [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [50, 0, 0]\n\
         damping = [4, 0, 0]\n\
         [sensors.x]\nquantity = \"position\"\nof = \"mass\"\ncomponent = \"x\"\nunit = \"m\"\n\
         [[load]]\nnode = \"mass\"\nforce = [1, 0, 0]\ndrive = \"= {force}\"\n\
         [periodic]\nperiod = {:?}\n\
         [[trim.control]]\nname = \"steady\"\n\
         [[trim.control]]\nname = \"cosine\"\n\
         [[trim.control]]\nname = \"sine\"\n\
         [[trim.target]]\nname = \"mean\"\nsignal = \"= x\"\nvalue = 0.3\nscale = 0.1\n\
         [[trim.target]]\nname = \"first cosine\"\nsignal = \"= 2*x*cos(4*t)\"\nvalue = 0.1\n\
         scale = 0.1\n\
         [[trim.target]]\nname = \"first sine\"\nsignal = \"= 2*x*sin(4*t)\"\nvalue = -0.05\n\
         scale = 0.1\n",
        TAU / 4.0
    )
}

// Closed form: the force is k x + c x' + m x'' of the required motion. Means of the integrals are of
// fifth order in steps of 0.065 of a radian.
#[test]
fn forces_of_a_required_motion() {
    let (outcome, _) = analyzed(&oscillator("steady + cosine*cos(4*t) + sine*sin(4*t)"));
    let x = Complex::new(0.1, 0.05);
    let force = x * Complex::new(50.0 - 2.0 * 16.0, 16.0);
    let expected = [15.0, force.re, -force.im];
    for ((name, found), expected) in outcome.result.controls.iter().zip(expected) {
        assert!(
            (found - expected).abs() < 1e-6,
            "{name}: {found} {expected}"
        );
    }
    assert!(
        outcome.result.passes.len() <= 4,
        "{:#?}",
        outcome.result.passes
    );
}

// The force does not depend on one of the controls: it is named.
#[test]
fn a_control_that_does_not_act_is_named() {
    let (outcome, _) = attempt(&oscillator("steady + cosine*cos(4*t) + 0*sine"));
    let text = outcome.failure.unwrap().to_string();
    assert!(text.contains("\"sine\" acts least"), "{text}");
}

#[test]
fn wrong_cards_are_reported_with_their_remedy() {
    let missing = oscillator("steady").replace("[periodic]\nperiod", "[periodic]\nperiods");
    let problems = beam_dynamics::input::parse(&missing, "x.dynamics.toml")
        .unwrap_err()
        .to_string();
    assert!(
        problems.contains("the period is given by nothing"),
        "{problems}"
    );
    let few = oscillator("steady");
    let end = few.rfind("[[trim.target]]").unwrap();
    let problems = beam_dynamics::input::parse(&few[..end], "x.dynamics.toml").unwrap_err();
    assert!(
        problems.to_string().contains("3 controls and 2 targets"),
        "{problems}"
    );
    let beside = oscillator("steady") + "[modes]\nspeeds = [0]\n";
    let problems = beam_dynamics::input::parse(&beside, "x.dynamics.toml").unwrap_err();
    assert!(
        problems
            .to_string()
            .contains("beside [modes], which does not find"),
        "{problems}"
    );
    let start = oscillator("steady").replace("[periodic]", "[periodic]\nstart = \"rotating\"");
    let problems = beam_dynamics::input::parse(&start, "x.dynamics.toml").unwrap_err();
    assert!(
        problems.to_string().contains("there is no \"speed\""),
        "{problems}"
    );
}
