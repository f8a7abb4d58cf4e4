//! The card of a run in time, and the initial motion of nodes.

#![allow(clippy::unwrap_used, reason = "tests end when a file cannot be read")]

use nalgebra::Vector3;

use super::TransientProblem;
use crate::case::{Start, StartAccelerations};
use crate::input::{Input, checked};
use crate::integrator::{Jacobians, Scheme, Stepping};

const BODY: &str = "units = \"SI\"\n[[node]]\nname = \"a\"\nposition = [1, 0, 0]\n\
                    velocity = [0, 2, 0]\nangular_velocity = [0, 0, 60]\n\
                    [[body]]\nnode = \"a\"\nmass = 2\ninertia = [1, 1, 1]\n";

fn read(cards: &str) -> Result<Input, String> {
    checked(cards, ("a.dynamics.toml", "a"), (&[], None)).map_err(|problems| problems.to_string())
}

fn refused(card: &str) -> String {
    match read(&format!("{BODY}[transient]\n{card}\n")) {
        Ok(_) => panic!("accepted"),
        Err(text) => text,
    }
}

#[test]
fn a_body_that_flies_is_a_model_in_time() {
    let input = read(&format!("{BODY}[transient]\nto = 2\nstep = 0.01\n")).unwrap();
    let settings = input.transient.unwrap();
    assert_eq!((settings.from, settings.to), (0.0, 2.0));
    assert_eq!(settings.stepping, Stepping::Constant { step: 0.01 });
    assert_eq!(settings.scheme, Scheme::TwoStep { radius: 0.6 });
    assert_eq!(settings.start, Start::Given);
    let initial = input.model.initial[0];
    assert_eq!(initial.velocity, Some(2.0 * Vector3::y()));
    // 60 rpm.
    let spin = initial.angular_velocity.unwrap();
    assert!((spin.z - 2.0 * std::f64::consts::PI).abs() < 1e-14);
}

/// Without constraints the stages at Gauss' points determine all unknowns; with them they do not.
#[test]
fn a_scheme_that_cannot_enforce_constraints_is_refused_with_them() {
    let run = "[transient]\nto = 1\nscheme = \"gauss\"\nstep = 0.1\n";
    assert!(read(&format!("{BODY}{run}")).is_ok());
    let rod = "[[joint]]\nname = \"rod\"\nkind = \"distance\"\nnodes = [\"a\"]\n\
               from = [0, 0, 0]\nlength = 1\n";
    let held = format!("{BODY}{rod}{run}");
    let text = read(&held).err().unwrap();
    let line = held.lines().position(|line| line.contains("gauss"));
    let start = format!(
        "a.dynamics.toml:{}: \"scheme\" is \"gauss\"",
        line.unwrap() + 1
    );
    assert!(text.contains(&start), "{text}");
    assert!(text.contains("one equation of constraint"), "{text}");
    assert!(text.contains("\"two-step\" or \"radau-iia\""), "{text}");
    assert!(read(&held.replace("gauss", "radau-iia")).is_ok());
}

#[test]
fn every_key_of_the_card_is_read() {
    let card = "from = 1\nto = \"3000 ms\"\nscheme = \"cubic\"\nradius = 0.3\n\
                step = { first = 1e-3, least = 1e-6, most = 0.01, tolerance = 1e-5 }\n\
                jacobian = \"simplified\"\nstart = \"equilibrium\"\n\
                start_accelerations = \"dummy\"\nredundant = \"remove\"\n\
                newton = { method = \"modified\", iterations = 7, tolerance = 1e-6 }\n";
    let settings = read(&format!("{BODY}[transient]\n{card}")).unwrap();
    let settings = settings.transient.unwrap();
    assert_eq!((settings.from, settings.to), (1.0, 3.0));
    let Stepping::Variable(control) = settings.stepping else {
        panic!("{:?}", settings.stepping)
    };
    let limits = [
        control.first,
        control.least,
        control.most,
        control.tolerance,
    ];
    assert_eq!(limits, [1e-3, 1e-6, 0.01, 1e-5]);
    assert_eq!(settings.scheme, Scheme::Cubic { radius: 0.3 });
    assert!(settings.simplified_jacobian);
    assert_eq!(settings.start, Start::Equilibrium);
    assert_eq!(settings.start_accelerations, StartAccelerations::Dummy);
    let newton = settings.newton;
    assert_eq!((newton.iterations, newton.correction), (7, 1e-6));
    assert_eq!(newton.jacobians, Jacobians::Modified);
}

/// Air without strips does not change a run: Jacobians are not kept unless the file states it.
#[test]
fn jacobians_are_not_kept_without_strips() {
    let air = "[air]\ndensity = 1.2\n";
    for (card, newton, expected) in [
        ("", "", Jacobians::Full),
        (air, "newton = { tolerance = 1e-8 }\n", Jacobians::Full),
        (
            "",
            "newton = { method = \"modified\" }\n",
            Jacobians::Modified,
        ),
    ] {
        let run = format!("[transient]\nto = 1\nstep = 0.1\n{newton}");
        let settings = read(&format!("{BODY}{card}{run}")).unwrap().transient;
        assert_eq!(
            settings.unwrap().newton.jacobians,
            expected,
            "{card}{newton}"
        );
    }
}

#[test]
fn every_word_for_the_first_accelerations_is_known() {
    for (word, expected) in [
        ("consistent", StartAccelerations::Consistent),
        ("zero", StartAccelerations::Zero),
        ("dummy", StartAccelerations::Dummy),
        ("at-rest", StartAccelerations::AtRest),
    ] {
        let card = format!("to = 1\nstep = 0.1\nstart_accelerations = \"{word}\"\n");
        let input = read(&format!("{BODY}[transient]\n{card}")).unwrap();
        assert_eq!(input.transient.unwrap().start_accelerations, expected);
    }
}

#[test]
fn what_is_wrong_is_reported_at_once_with_its_line() {
    let text = refused("from = 2\nto = 1\nstep = -1\nscheme = \"bdf3\"\nzeta = 1\nradios = 1");
    for part in [
        "a.dynamics.toml:13: \"to\" is 1 s, expected later than \"from\", which is 2 s",
        "a.dynamics.toml:14: ",
        "a.dynamics.toml:15: ",
        "did you mean \"bdf2\"?",
        "a.dynamics.toml:16: \"zeta\" is 1, expected a number above -1 and below 0",
        "a.dynamics.toml:17: ",
        "did you mean \"radius\"?",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

#[test]
fn keys_that_do_not_fit_together_are_reported() {
    for (card, expected) in [
        (
            "to = 1\nstep = 2",
            "\"step\" is 2 s, but the whole run lasts 1 s",
        ),
        ("to = 1\nstep = 1e-12", "the run would take"),
        (
            "to = 1\nstep = 0.1\nscheme = \"bdf2\"\nradius = 0.3",
            "the scheme \"bdf2\" has no \"radius\"",
        ),
        (
            "to = 1\nstep = 0.1\nradius = 0.995",
            "\"radius\" of \"two-step\" is 0.995, expected at most 0.99, or 1",
        ),
        (
            "to = 1\nstep = 0.1\nspeed = 3",
            "\"start\" is not \"rotating\"",
        ),
        ("to = 1\nstep = 0.1\nstart = \"rotating\"", "\"speed\""),
        (
            "to = 1\nstep = { first = 1e-3, least = 1e-2 }",
            "\"least\" is 0.01 s, more than \"first\", which is 0.001 s",
        ),
        ("step = 0.1", "\"to\""),
    ] {
        let text = refused(card);
        assert!(text.contains(expected), "{expected}\n{text}");
    }
}

/// A start in rotation needs a hub that can turn, and a joint that turns it.
#[test]
fn held_blades_that_start_in_rotation_are_refused() {
    let strip = "[properties.s]\nea = 3e6\ngay = 1e6\ngaz = 1e6\ngj = 30\neiy = 40\neiz = 400\nm = 0.3\n\
                 iy = 1e-5\niz = 1e-4\n";
    let blades = "[[blade]]\nname = \"b\"\nhub_radius = 0.1\ncount = 2\nproperties = \"s\"\n\
                  [[blade.piece]]\nlength = 1\nelements = 2\n";
    let run = "[transient]\nto = 0.1\nstep = 1e-3\nstart = \"rotating\"\nspeed = 300\n";
    let file = |hub: &str| format!("units = \"SI\"\n{strip}{hub}{blades}{run}");
    let text = match read(&file("[hub]\naxis = [0, 0, 1]\n")) {
        Ok(_) => panic!("accepted"),
        Err(text) => text,
    };
    assert_eq!(
        text,
        "error: a.dynamics.toml:14: node \"b 1/root\" is clamped to the ground, and the start \
         rotates at 300 rpm: it cannot turn\n  help: give [hub] support = { torsion = 0 }, so that \
         it is the node \"hub\", which carries the blades, and add the joint that turns it: \
         [[joint]] with name = \"shaft\", kind = \"spin\", nodes = [\"hub\"], axis = [0, 0, 1], \
         speed = \"300 rpm\""
    );
    let held = "[hub]\nsupport = { axial = 1e6 }\nmass = 1\ninertia = [1, 1, 1]\n";
    let text = read(&file(held)).err().unwrap_or_default();
    assert!(
        text.contains("a.dynamics.toml:12: the support of the hub holds its rotation"),
        "{text}"
    );
    // The help, as it is written, is right.
    let free = "[hub]\nsupport = { torsion = 0 }\nmass = 1\ninertia = [1, 1, 1]\n[[joint]]\n\
                name = \"shaft\"\nkind = \"spin\"\nnodes = [\"hub\"]\naxis = [0, 0, 1]\n\
                speed = \"300 rpm\"\n";
    assert_eq!(read(&file(free)).err(), None);
}

#[test]
fn velocities_without_a_run_and_loose_nodes_are_reported() {
    let text = match read(&format!("{BODY}[static]\nspeed = 0\n")) {
        Ok(_) => panic!("accepted"),
        Err(text) => text,
    };
    assert!(text.contains("node \"a\" has \"velocity\", but there is no [transient]"));
    let loose = BODY.replace(
        "[[body]]",
        "[[node]]\nname = \"b\"\nposition = [0, 0, 0]\n[[body]]",
    );
    let loose = loose.replace("inertia = [1, 1, 1]\n", "");
    let text = match read(&format!("{loose}[transient]\nto = 1\nstep = 0.1\n")) {
        Ok(_) => panic!("accepted"),
        Err(text) => text,
    };
    assert!(text.contains("node \"b\""), "{text}");
    // A point mass whose rotation is not held.
    let point = BODY.replace("inertia = [1, 1, 1]\n", "");
    let text = match read(&format!("{point}[transient]\nto = 1\nstep = 0.1\n")) {
        Ok(_) => panic!("accepted"),
        Err(text) => text,
    };
    assert!(text.contains(
        "a.dynamics.toml:3: node \"a\" has no inertia, and nothing holds it: rotation about x"
    ));
    assert!(
        text.contains("help: give the node mass and inertia by a [[body]]"),
        "{text}"
    );
    // Every problem has a remedy, or needs none.
    let idle = TransientProblem::IdleSpeed;
    assert!(shared_geom::error::Explain::help(&idle).is_some());
}

/// A crank and a spring, with ten errors.
const TEN: &str = "units = \"SI\"
include = \"part.toml\"
[parameters]
length = 2
[drives.push]
kind = \"ramp\"
to = 5
duration = 1
[[frame]]
name = \"tilted\"
orientation = [0, 10, 0]
[[node]]
name = \"crank\"
position = [\"= lenght\", 0, 0]
[[node]]
name = \"slider\"
position = [\"4 inn\", 0, 0]
[[node]]
name = \"post\"
in = \"tiltet\"
position = [0, 1, 0]
[[body]]
node = \"slider\"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = \"pin\"
kind = \"revolut\"
nodes = [\"crank\"]
axis = [0, 0, 1]
[[joint]]
name = \"guide\"
kind = \"spherical\"
nodes = [\"crank\", \"slidder\"]
[[load]]
node = \"slider\"
force = [1, 0, 0]
drive = \"pusch\"
[[spring]]
name = \"mount\"
nodes = [\"crank\", \"slider\"]
law = { kind = \"cubik\", cubic = 3 }
[transient]
to = 1
step = 0.01
scheme = \"bdf3\"
[[output.column]]
name = \"turn\"
quantity = \"joint_angel\"
of = \"pin\"
";

#[test]
fn ten_slips_are_reported_at_once_each_with_its_line_and_the_nearest_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dynamics.toml");
    std::fs::write(&path, TEN).unwrap();
    std::fs::write(folder.path().join("parts.toml"), "").unwrap();
    let prefix = format!("{}/", folder.path().display());
    let reported = crate::input::read(&path).unwrap_err().to_string();
    let reported = reported.replace(&prefix, "");
    let expected = [
        ("2", "no file \"part.toml\"", "parts.toml"),
        ("14", "\"lenght\"", "length"),
        ("17", "\"inn\"", "in"),
        ("20", "unknown frame \"tiltet\"", "tilted"),
        ("28", "\"revolut\"", "revolute"),
        ("34", "unknown node \"slidder\"", "slider"),
        ("38", "unknown drive \"pusch\"", "push"),
        ("42", "\"cubik\"", "cubic"),
        ("46", "\"bdf3\"", "bdf2"),
        ("49", "\"joint_angel\"", "joint_angle"),
    ];
    for (line, slip, near) in expected {
        let begin = format!("error: a.dynamics.toml:{line}: ");
        let found = reported
            .split("error: ")
            .find(|one| format!("error: {one}").starts_with(&begin) && one.contains(slip));
        let found = found.unwrap_or_else(|| panic!("{begin}{slip}\n---\n{reported}"));
        let help = format!("did you mean \"{near}\"?");
        assert!(found.contains(&help), "{help}\n---\n{found}");
    }
    // No other problems are reported.
    assert_eq!(
        reported.matches("error: ").count(),
        expected.len(),
        "{reported}"
    );
}

#[test]
fn what_is_not_finite_at_the_start_is_reported_and_does_not_hang() {
    let run = "[transient]\nto = 1\nstep = 0.1\n";
    for force in [
        "sqrt(x)",
        "1/x",
        "x^0.5",
        "abs(x)^0.5",
        "sqrt(abs(x))*sign(x)",
    ] {
        let law = format!("law = {{ kind = \"expression\", force = {{ x = \"= {force}\" }} }}");
        let text = read(&format!("{BODY}[[spring]]\nnode = \"a\"\n{law}\n{run}"));
        let text = text.map(|_| ()).unwrap_err();
        assert!(text.contains("a.dynamics.toml:13: "), "{text}");
        assert!(text.contains("at zero strain"), "{force}: {text}");
    }
    let loaded = |drive: &str| {
        let load = format!("[[load]]\nnode = \"a\"\nforce = [1, 0, 0]\ndrive = \"= {drive}\"\n");
        read(&format!("{BODY}{load}{run}")).map(|_| ())
    };
    let text = loaded("ln(t)").unwrap_err();
    let expected = "a.dynamics.toml:14: \"drive\" has the value -inf at 0 s";
    assert!(text.contains(expected), "{text}");
    // A force may change steeply, a prescribed motion may not.
    loaded("sqrt(t)").unwrap();
    let turned = |drive: &str| {
        let joint = format!(
            "[[joint]]\nkind = \"revolute\"\nnodes = [\"a\"]\nat = [1, 0, 0]\naxis = [0, 0, 1]\nangle = \"= {drive}\"\n"
        );
        read(&format!("{BODY}{joint}{run}")).map(|_| ())
    };
    for drive in ["1/t", "ln(t)", "1e20/(t+1e-300)", "sqrt(t)"] {
        let text = turned(drive).unwrap_err();
        assert!(text.contains("\"angle\" has the "), "{drive}: {text}");
    }
    let refused = |random: &str| {
        let load = format!("[[load]]\nnode = \"a\"\nforce = [1, 0, 0]\ndrive = {random}\n");
        read(&format!("{BODY}{load}{run}")).map(|_| ()).unwrap_err()
    };
    let text = refused("{ kind = \"random\", deviation = -1, seed = 1, interval = 0.1 }");
    assert!(text.contains("\"deviation\""), "{text}");
}

#[test]
fn drives_with_corners_without_end_are_refused() {
    let loaded = |drive: &str| {
        let load = format!("[[load]]\nnode = \"a\"\nforce = [1, 0, 0]\ndrive = {drive}\n");
        let run = "[transient]\nto = 0.1\nstep = 0.01\n";
        read(&format!("{BODY}{load}{run}")).map(|_| ())
    };
    let random = |interval: &str| {
        format!("{{ kind = \"random\", deviation = 1, seed = 1, interval = {interval} }}")
    };
    for drive in ["\"= floor(1e9*t)\"", "\"= mod(t, 1e-7)\"", &random("1e-9")] {
        let text = loaded(drive).unwrap_err();
        let expected = "\"drive\" has more than 500000 corners";
        assert!(text.contains(expected), "{drive}: {text}");
        assert!(text.contains("a.dynamics.toml:14: "), "{drive}: {text}");
    }
    loaded(&random("1e-5")).unwrap();
    loaded("\"= mod(t, 1e-4)\"").unwrap();
}
