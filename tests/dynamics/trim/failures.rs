//! Trims that fail name the reason, and wrong cards are reported with their remedy.

use beam_dynamics::analysis::trim::trim_watched;

use super::{attempt, reason};

/// Two forces on a mass on a spring, in the plane.
fn plate(first: &str, second: &str, settings: &str) -> String {
    format!(
        "[[node]]\nname = \"mass\"\nposition = [0, 0, 0]\n\
         [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n\
         [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [50, 50, 50]\n\
         rotational_stiffness = [1, 1, 1]\ndamping = [4, 4, 4]\nrotational_damping = [1, 1, 1]\n\
         [sensors.x]\nquantity = \"position\"\nof = \"mass\"\ncomponent = \"x\"\nunit = \"m\"\n\
         [sensors.y]\nquantity = \"position\"\nof = \"mass\"\ncomponent = \"y\"\nunit = \"m\"\n\
         [[load]]\nnode = \"mass\"\nforce = [1, 0, 0]\ndrive = \"= {first}\"\n\
         [[load]]\nnode = \"mass\"\nforce = [0, 1, 0]\ndrive = \"= {second}\"\n\
         {settings}\
         [[trim.control]]\nname = \"a\"\n[[trim.control]]\nname = \"b\"\nupper = 40\n\
         [[trim.target]]\nname = \"to the right\"\nsignal = \"x\"\nvalue = 0.3\n\
         [[trim.target]]\nname = \"ahead\"\nsignal = \"y\"\nvalue = 0.5\n"
    )
}

const METHODS: [&str; 3] = [
    "[periodic]\nperiod = 1\nsteps = 8\n[trim]\n",
    "[periodic]\nperiod = 1\nsteps = 8\nperiods = 400\n[trim]\nmethod = \"autopilot\"\n",
    "[trim]\nmethod = \"equilibrium\"\n",
];

// Targets that are met without determining the controls: one that no control changes and that has its value
// already, and one that is requested twice.
#[test]
fn targets_that_are_met_by_any_control_are_refused() {
    for method in METHODS {
        let still = plate("a + b", "0*a", method).replace("value = 0.5", "value = 0");
        let [reason_of_still, _] = reason(&still);
        assert!(
            reason_of_still.ends_with("no control has an effect on \"ahead\""),
            "{method}: {reason_of_still}"
        );
        let twice = plate("a + b", "b", method)
            .replace("signal = \"y\"\nvalue = 0.5", "signal = \"x\"\nvalue = 0.3");
        let [reason_of_twice, _] = reason(&twice);
        assert!(
            reason_of_twice.contains("\"to the right\" and \"ahead\" respond alike"),
            "{method}: {reason_of_twice}"
        );
    }
}

// All methods: a control without effect, two controls with the same effect, a target that no control
// reaches, and a bound, which is 40 of the 25 and 50 that are needed.
#[test]
fn reasons_are_named() {
    for method in METHODS {
        let [idle, _] = reason(&plate("a", "a + 0*b", method));
        assert!(
            idle.contains("\"b\" has no effect on any target"),
            "{method}: {idle}"
        );
        let [same, _] = reason(&plate("a + 2*b", "2*a + 4*b", method));
        assert!(
            same.contains("\"a\" and \"b\" have the same effect"),
            "{method}: {same}"
        );
        let [unreached, _] = reason(&plate("a + b", "0*a", method));
        assert!(
            unreached.contains("\"ahead\" is reached least"),
            "{method}: {unreached}"
        );
        let [bound, remedy] = reason(&plate("a", "b/2", method));
        assert!(
            bound.contains("the control \"b\"") && bound.contains("bound 40"),
            "{method}: {bound}"
        );
        assert!(remedy.contains("bound"), "{remedy}");
        // The values that are reached: 40/2 N on 50 N/m.
        let point = &attempt(&plate("a", "b/2", method)).result.points[0];
        // An equilibrium has its control beyond the bound.
        let expected = if method.contains("equilibrium") {
            0.5
        } else {
            0.4
        };
        let [found, required] = point.targets[1];
        assert!(
            (found - expected).abs() < 1e-3 && required == 0.5,
            "{point:?}"
        );
        let text = plate("a", "b", method);
        let point = &attempt(&text).result.points[0];
        assert_eq!(point.failure, None, "{method}");
        for (found, expected) in point.controls.iter().zip([15.0, 25.0]) {
            assert!((found - expected).abs() < 1e-3, "{method}: {point:?}");
        }
    }
}

// A force that has a largest value, and none beyond it: the step toward the target is halved, and then
// the target is named with the last control.
#[test]
fn targets_beyond_the_last_motion_are_named() {
    let [text, remedy] = reason(&plate("10 - sqrt(1 - a)", "b", METHODS[0]));
    let begin = "\"to the right\" is out of reach while all other targets are met: ";
    assert!(text.starts_with(begin), "{text}");
    assert!(
        text.contains("no motion nearer to the targets than with a = 0."),
        "{text}"
    );
    assert!(
        remedy.contains("targets that the model can reach"),
        "{remedy}"
    );
}

// A target out of reach, after whose search the one from the first guess is tried. The targets that are shown are the
// ones of the controls that are shown: means of the forces over 50 N/m, as the waves have no mean. The last step of the
// controls is halved many times, so that the state belongs to them up to the square of a small step.
#[test]
fn the_targets_of_a_failed_trim_are_the_ones_of_its_controls() {
    let settings = "[periodic]\nperiod = 1\nsteps = 8\n[trim]\n";
    let wave = "*(1 + cos(6.283185307179586*t)/3)";
    let text = plate(
        &format!("(10 - sqrt(1 - a)){wave}"),
        &format!("b{wave}"),
        settings,
    );
    let text = text.replace("name = \"b\"\n", "name = \"b\"\nguess = 20\n");
    let outcome = attempt(&text);
    let point = &outcome.result.points[0];
    assert!(point.failure.is_some(), "{point:?}");
    let [a, b] = point.controls[..] else {
        panic!("{point:?}");
    };
    let forces = [10.0 - (1.0 - a).sqrt(), b];
    for (force, [found, _]) in forces.into_iter().zip(&point.targets) {
        assert!((found - force / 50.0).abs() < 1e-3, "{point:?}");
    }
}

// A force of 10 N at most on 50 N/m, and 9 N with the guess: the first step on the way to 9 m needs 22 N, so that no
// motion is nearer to the target than the one of the guess.
#[test]
fn a_guess_that_is_the_end_is_named() {
    let text = plate("10 - a*a", "0", METHODS[0]).replace("value = 0.3", "value = 9");
    let text = text.replace("[[trim.control]]\nname = \"b\"\nupper = 40\n", "");
    let (text, _) = text
        .split_once("[[trim.target]]\nname = \"ahead\"")
        .unwrap();
    let [text, _] = reason(&text.replace("name = \"a\"", "name = \"a\"\nguess = 1"));
    let begin = "no motion is nearer to the targets than the one of the first guess, in which \"to the right\" is \
                 farthest from its value: \"to the right\" = 0.18 in place of 9";
    assert!(text.starts_with(begin), "{text}");
}

// Each iteration of each point is shown.
#[test]
fn the_progress_of_a_sweep_is_shown() {
    let settings = "[periodic]\nperiod = 1\nsteps = 8\n[parameters]\nmore = 1\n[trim]\n\
                    [trim.sweep]\nparameter = \"more\"\nvalues = [1, 1.2]\n";
    let text = plate("a", "b", settings).replace("value = 0.5", "value = \"= 0.3*more\"");
    let text = format!("units = \"SI\"\n{text}");
    let parsed = beam_dynamics::input::parse(&text, "x.dynamics.toml").unwrap();
    let read =
        |given: &[(String, f64)]| beam_dynamics::input::parse_with(&text, "x.dynamics.toml", given);
    let mut shown = Vec::new();
    let settings = parsed.trim.as_ref().unwrap();
    let outcome = trim_watched("x", settings, &read, &mut |at| shown.push(at));
    let points = &outcome.result.points;
    for (index, point) in points.iter().enumerate() {
        let own: Vec<_> = shown.iter().filter(|at| at.points[0] == index).collect();
        assert_eq!(own.len(), point.iterations + 1, "{own:?}");
        let last = own.last().unwrap();
        assert_eq!((last.at, last.points[1]), (point.at, 2));
        assert_eq!(last.residual, point.residual);
    }
}

// Names of wrong controls are known to expressions: one message each.
#[test]
fn a_wrong_control_is_one_problem() {
    for (from, to) in [
        ("name = \"a\"\n", "name = \"a\"\nguess = \"two\"\n"),
        ("method = \"equilibrium\"", "method = \"equilibrum\""),
    ] {
        let text = plate("a", "b", METHODS[2]).replace(from, to);
        let text = format!("units = \"SI\"\n{text}");
        let found = beam_dynamics::input::parse(&text, "x.dynamics.toml").unwrap_err();
        let found = found.to_string();
        assert_eq!(found.matches("error:").count(), 1, "{found}");
    }
}

// The last point of a sweep is beyond the bound: the points before are kept, and so is the last state.
#[test]
fn a_failed_point_keeps_the_others() {
    let settings = "[parameters]\nmore = 1\n[trim]\nmethod = \"equilibrium\"\n\
                    [trim.sweep]\nparameter = \"more\"\nvalues = [1, 2, 4, 5]\n";
    let text = plate("a", "b", settings).replace("value = 0.5", "value = \"= 0.3*more\"");
    let outcome = attempt(&text);
    let points = &outcome.result.points;
    assert_eq!((points.len(), outcome.result.requested), (3, 4));
    for (point, expected) in points.iter().zip([15.0, 30.0]) {
        assert!(point.failure.is_none() && (point.controls[1] - expected).abs() < 1e-9);
    }
    let [text, _] = points[2].failure.clone().unwrap();
    assert!(text.contains("\"b\" is 60"), "{text}");
    assert!(outcome.end.unwrap().state.is_some() || points[1].failure.is_none());
}

/// Changes of a sound file, and a part of the message.
const WRONG: &[(&str, &str, &str)] = &[
    (
        "[trim]\n",
        "[trim]\nfilter = 2\n",
        "\"filter\" has no effect",
    ),
    (
        "method = \"equilibrium\"",
        "speed = 3",
        "\"speed\" has no effect",
    ),
    (
        "method = \"equilibrium\"",
        "iterations = 9",
        "which needs [periodic]",
    ),
    ("upper = 40", "upper = -1", "expected at most its bound -1"),
    (
        "value = 0.5\n",
        "value = 0.5\nharmonic = 2\n",
        "harmonic 2 of an equilibrium",
    ),
    (
        "value = 0.5\n",
        "value = 0.5\npart = \"sine\"\n",
        "\"part\" without \"harmonic\": the target is the mean, which has no parts",
    ),
    (
        "name = \"ahead\"",
        "name = \"to the right\"",
        "to the right",
    ),
    ("name = \"a\"\n", "name = \"x\"\n", "x"),
    (
        "[trim]\n",
        "[modes]\nspeeds = [0]\n[trim]\n",
        "beside [modes]",
    ),
    (
        "[trim]\n",
        "[trim]\nsweep = { parameter = \"q\", values = [1] }\n",
        "not one of the [parameters]",
    ),
    (
        "[trim]\n",
        "[parameters]\nq = 1\n[trim]\nsweep = { parameter = \"q\" }\n",
        "given by nothing",
    ),
    (
        "[trim]\n",
        "[parameters]\nq = 1\n[trim]\nsweep = { parameter = \"q\", values = [1, 2] }\n",
        "no expression uses the parameter \"q\"",
    ),
    (
        "[trim]\n",
        "[parameters]\na = 1\n[trim]\nsweep = { parameter = \"a\", values = [1] }\n",
        "which is a control too",
    ),
    ("[trim]\n", "[trim]\nsped = 2\n", "sped"),
    (
        "drive = \"= b\"",
        "drive = \"= 2*a\"",
        "no expression uses the control \"b\"",
    ),
];

#[test]
fn wrong_cards_are_reported() {
    let sound = plate("a", "b", METHODS[2]);
    let problems = |from: &str, to: &str| {
        assert!(sound.contains(from), "{from}");
        let text = format!("units = \"SI\"\n{}", sound.replace(from, to));
        let found = beam_dynamics::input::parse(&text, "x.dynamics.toml");
        found.unwrap_err().to_string()
    };
    for (from, to, expected) in WRONG.iter().copied() {
        let found = problems(from, to);
        assert!(found.contains(expected), "{expected}: {found}");
    }
    let end = sound.rfind("[[trim.target]]").unwrap();
    let text = format!("units = \"SI\"\n{}", &sound[..end]);
    let found = beam_dynamics::input::parse(&text, "x.dynamics.toml")
        .unwrap_err()
        .to_string();
    assert!(found.contains("2 controls and 1 target,"), "{found}");
}
