//! A rotor and its expanded text are the same model, and the model that a user would write.

use crate::analysis::modes::modes;

use super::{STRIP, expanded, read, refused, text};

/// Keys of rotors of each kind that use all of their parts.
const KINDS: [(&str, &str); 12] = [
    (
        "rigid",
        "speed = 300\n[rotor.swashplate]\ncollective = 8\nsine = \"= -2*t\"\n",
    ),
    (
        "hingeless",
        "angle = \"= 90*t^2\"\nmass = 3\ninertia = [1, 1, 1]\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n\
         stiffness = 300\n[rotor.swashplate]\ncollective = \"ramp\"\ncosine = 2\n\
         individual = [0, 1, \"= sin(t)\"]\nharmonic = [{ order = 2, sine = 0.5 }]\n",
    ),
    (
        "articulated",
        "speed = 300\naxis = [0.1, 0, 1]\ncenter = [1, 2, 3]\nazimuth = 20\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\nstop = { lower = -4, upper = 20, stiffness = 9e3, damping = 5 }\n\
         [[rotor.hinge]]\nkind = \"lag\"\ndamping = 3\ndamper = { rates = [-10, 0, 10], moments = [-5, 0, 5] }\n\
         [rotor.swashplate]\ncollective = 8\ncosine = 1\n[rotor.pitch_link]\nstiffness = 900\n\
         damping = 1\ndelta_3 = 20\n",
    ),
    (
        "articulated",
        "torque = \"= 5*t\"\nspeed = 100\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n\
         [[rotor.hinge]]\nkind = \"pitch\"\nstiffness = 10\n[rotor.swashplate]\nsine = 8\n\
         [rotor.pitch_link]\nstiffness = 900\n",
    ),
    (
        "articulated",
        "speed = 300\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n[rotor.swashplate]\n\
         collective = 8\ncosine = 1\nsine = -3\n[rotor.swashplate.plate]\nbelow = 0.15\n\
         horn = [0.05, 0.19]\nactuators = { radius = 0.2, base_radius = 0.2, base_below = 0.3 }\n",
    ),
    (
        "articulated",
        "torque = 3\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n[rotor.swashplate]\n\
         collective = \"= 8*t\"\ncosine = 1\nsine = -3\n[rotor.swashplate.plate]\nbelow = 0.15\n\
         horn = [0.05, -0.19]\nstiffness = 2e5\ndamping = 10\n",
    ),
    (
        "teetering",
        "speed = 300\nundersling = 0.05\n[rotor.tilt]\nstiffness = 30\ndamping = 1\n\
         stop = { lower = -8, upper = 8, stiffness = 4e3 }\n[rotor.yoke]\nmass = 2\ninertia = [1, 1, 1]\n\
         [rotor.swashplate]\ncollective = 4\n[rotor.pitch_link]\nstiffness = 900\n",
    ),
    (
        "gimballed",
        "speed = 300\nlink = 0.1\n[rotor.tilt]\nstiffness = 30\nstop = { upper = 8, stiffness = 4e3 }\n\
         [rotor.swashplate]\ncollective = 4\nsine = 1\n[rotor.pitch_link]\nstiffness = 900\ndelta_3 = -15\n",
    ),
    (
        "bearingless",
        "speed = 300\nazimuth = 20\n[rotor.flexbeam]\noffset = 0.05\nproperties = \"strip\"\n\
         piece = [{ length = 0.1, elements = 1 }]\n[rotor.torque_tube]\nmass = 1\ncenter = 0.1\n\
         inertia = [1e-3, 1e-2, 1e-2]\n[rotor.snubber]\noffset = 0.1\nto = \"flexbeam\"\nstiffness = [0, 1e4, 1e6]\n\
         damping = [0, 10, 0]\n[rotor.swashplate]\ncollective = 4\nsine = \"= -2*t\"\n",
    ),
    (
        "bearingless",
        "torque = 3\n[rotor.flexbeam]\noffset = 0.05\nproperties = \"strip\"\n\
         piece = [{ length = 0.15, elements = 1 }]\n[rotor.torque_tube]\noffset = 0.1\n\
         properties = \"strip\"\npiece = [{ length = 0.1, elements = 1 }]\n[rotor.snubber]\n\
         [rotor.swashplate]\ncollective = \"= 8*t\"\n[rotor.swashplate.plate]\nbelow = 0.15\n\
         horn = [0.1, 0.1]\n",
    ),
    (
        "articulated",
        "speed = 300\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n[[rotor.hinge]]\nkind = \"lag\"\n\
         damper = { stiffness = 40, loss_factor = 0.3, frequency = 3, static_stiffness = 30 }\n\
         [rotor.lag_damper]\nhub = [0.05, 0.1, 0]\nblade = [0.2, 0.1, 0.01]\nstiffness = 4e3\n\
         loss_factor = 0.3\nfrequency = 3\nstatic_stiffness = 3e3\n",
    ),
    (
        "rigid",
        "speed = 300\n[rotor.drive]\ninertia = 0.1\ngear = 5\nstiffness = 4e3\ndamping = 3\n\
         free_wheel = true\ngovernor = { proportional = \"40 N*m*s\", integral = 30, largest = 900 }\n\
         [rotor.swashplate]\nsine = 2\n[rotor.pitch_link]\nstiffness = 900\n",
    ),
];

const REST: &str = "
# the run
[drives.ramp]
kind = \"ramp\"
to = 5
end = 1
[transient]
to = 0.1
step = 1e-3
";

// The fingerprint covers nodes and elements with all their numbers, to the last bit.
#[test]
fn a_rotor_and_its_expanded_text_are_the_same_model() {
    for (kind, keys) in KINDS {
        let text = text(kind, keys, REST);
        let expanded = expanded(&text);
        assert!(!expanded.contains("[[rotor]]"), "{expanded}");
        assert!(expanded.contains("# the run\n"), "{expanded}");
        let [one, other] = [&text, &expanded].map(|text| read(text));
        assert_eq!(
            one.model.fingerprint(),
            other.model.fingerprint(),
            "{expanded}"
        );
        assert_eq!(one.model.initial, other.model.initial);
        assert_eq!(one.model.frame_rotation, other.model.frame_rotation);
    }
}

/// Frequencies of all modes at all speeds.
fn frequencies(text: &str) -> Vec<f64> {
    let input = read(text);
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let speeds = 0..outcome.table.speeds.len();
    let points = speeds.flat_map(|speed| outcome.table.at_speed(speed).into_iter());
    points.map(|(_, point)| point.frequency).collect()
}

// The blades of a rotor against the blades of a `[[blade]]` on the frame.
#[test]
fn rotors_are_the_rotors_of_blade_cards() {
    const MODES: &str = "[modes]\nspeeds = [0, 300]\ncount = 9\n";
    let blade = "hub_radius = 0.2\nproperties = \"strip\"\npiece = [{ length = 1, elements = 2 }]\n\
                 precone = 2\npitch = 6\n";
    let flap = "kind = \"flap\"\noffset = 0.1\nstiffness = 500\n";
    let lag = "kind = \"lag\"\noffset = 0.15\nstiffness = 900\ndamping = 2\n";
    for (kind, listed, tables) in [
        ("rigid", String::new(), String::new()),
        (
            "hingeless",
            format!(
                "hinges = [{{ {} }}, {{ {} }}]\n",
                flap.trim().replace('\n', ", "),
                lag.trim().replace('\n', ", ")
            ),
            format!("[[rotor.hinge]]\n{flap}[[rotor.hinge]]\n{lag}"),
        ),
    ] {
        let by_hand = format!(
            "units = \"SI\"\n{STRIP}[[blade]]\nname = \"b\"\ncount = 3\n{listed}{blade}{MODES}"
        );
        let keys = format!("speed = 300\n{tables}");
        let rotor = text(kind, &keys, MODES)
            .replace("[rotor.blade]\n", "[rotor.blade]\nprecone = 2\npitch = 6\n");
        let [expected, found] = [by_hand, rotor].map(|text| frequencies(&text));
        assert_eq!(expected.len(), found.len());
        for (found, expected) in found.iter().zip(&expected) {
            assert!(
                (found - expected).abs() < 1e-7 * expected.max(1.0),
                "{kind}: {found} {expected}"
            );
        }
    }
}

// The rotor of an included file: the text has the content of both files, and is the same model.
#[test]
fn a_rotor_of_an_included_file_is_expanded() {
    let folder = tempfile::tempdir().unwrap();
    let whole = text("articulated", KINDS[2].1, "[parameters]\nsoft = 3\n");
    std::fs::write(
        folder.path().join("rotor.toml"),
        whole.replacen("units = \"SI\"\n", "", 1),
    )
    .unwrap();
    let main = "units = \"SI\"\ninclude = \"rotor.toml\"\n[parameters]\nhard = \"= 2*soft\"\n\
                [modes]\nspeeds = 300\n";
    let path = folder.path().join("main.dynamics.toml");
    std::fs::write(&path, main).unwrap();
    let found = crate::input::expanded(&path).unwrap_or_else(|problems| panic!("{problems}"));
    assert!(
        !found.contains("[[rotor]]") && !found.contains("include"),
        "{found}"
    );
    assert!(
        found.contains("[parameters]\nhard = \"= 2*soft\"\nsoft = 3\n"),
        "{found}"
    );
    let there = crate::input::read(&path).unwrap();
    let here = read(&found);
    let nodes = [&there, &here].map(|input| {
        let nodes = input.model.system.nodes().iter();
        nodes
            .map(|node| (node.label.clone(), node.position))
            .collect::<Vec<_>>()
    });
    assert_eq!(nodes[0], nodes[1]);
    assert_eq!(there.summary, here.summary);
}

/// A speed and a collective by parameters: the comment names the one that is a number in the cards; signals
/// and expressions of time keep their names, and so do values outside rotors.
#[test]
fn parameters_that_are_numbers_in_the_cards_are_named() {
    let rotor = |speed: &str| {
        let gravity = "[gravity]\nacceleration = [0, 0, \"= -g\"]\n";
        let cards = text("rigid", &format!("speed = {speed}\n"), gravity);
        let parameters = "units = \"SI\"\n[parameters]\nrpm = 300\ng = 9.81\n";
        expanded(&cards.replacen("units = \"SI\"\n", parameters, 1))
    };
    let fixed = rotor("\"= rpm\"");
    let comment = "# Cards of rotors have values of \"rpm\" of [parameters] as numbers";
    assert!(fixed.starts_with(comment), "{fixed}");
    assert!(!rotor("300").contains("# Cards of rotors"));
}

// The period of the first rotor stays the one of the file, which has no rotor any more.
#[test]
fn an_expanded_file_has_the_period_of_its_rotor() {
    for speed in ["30", "-17.3"] {
        let text = text(
            "hingeless",
            &format!("speed = {speed}"),
            "[periodic]\nsteps = 16\n",
        );
        let [own, found] = [read(&text), read(&expanded(&text))].map(|it| it.periodic.unwrap());
        assert_eq!((own.period, own.speed), (found.period, found.speed));
    }
}

// The speed is in a rotor that cannot be read: nothing but this is reported.
#[test]
fn a_wrong_rotor_is_no_missing_period() {
    let text = text("hingeless", "speed = 30", "[periodic]\nsteps = 16\n");
    let problems = refused(&text.replace("hub_radius", "hub_radus"));
    assert!(problems.contains("hub_radus"), "{problems}");
    assert!(!problems.contains("the period"), "{problems}");
}
