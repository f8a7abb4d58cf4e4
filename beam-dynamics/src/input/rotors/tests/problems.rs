//! Wrong rotors, and the problems reported.

use crate::input::parse;

use super::{BLADE, STRIP, refused, text};

/// A period of another speed: the blades are not where they were.
#[test]
fn periods_are_whole_turns() {
    let periodic = |speed: &str| format!("[periodic]\nspeed = {speed}\n");
    let found = refused(&text("rigid", "speed = 1", &periodic("1.01")));
    assert!(
        found.contains("rotor \"r\" turns 0.99009901 times in the period"),
        "{found}"
    );
    for speed in ["1", "0.5"] {
        let sound = text("rigid", "speed = 1", &periodic(speed));
        parse(&sound, "r.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
    }
}

/// A rotor at rest gives no period, and is named.
#[test]
fn a_rotor_at_rest_has_no_period() {
    let found = refused(&text("rigid", "speed = 0", "[periodic]\nsteps = 16\n"));
    let expected = "the period is the one of rotor \"r\", whose speed is 0";
    assert!(found.contains(expected), "{found}");
    let given = text("rigid", "speed = 0", "[periodic]\nperiod = 1\nsteps = 16\n");
    parse(&given, "r.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
}

/// A first instant between whole turns: the model of the file is at azimuth zero.
#[test]
fn runs_begin_at_whole_turns() {
    for card in [
        "[periodic]\nspeed = 1\n",
        "[transient]\nto = 90\nstep = 0.1\n",
    ] {
        let of = |from: &str| text("rigid", "speed = 1", &format!("{card}from = {from}\n"));
        let found = refused(&of("0.5"));
        assert!(
            found.contains("rotor \"r\" has turned by 3 deg at the first instant")
                && found.contains("multiples of 60 s"),
            "{found}"
        );
        for from in ["0", "60", "-120"] {
            parse(&of(from), "r.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
        }
    }
}

/// Angles, forces and winds that are not the same a period later, at any phase and of any harmonic, in 200
/// cases; whole periods are.
#[test]
fn models_repeat_after_the_period() {
    let mass = "units = \"SI\"\n[[node]]\nname = \"mass\"\nposition = [0, 0, 0]\n[[body]]\nname = \"mass\"\n\
                node = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n[[spring]]\nname = \"spring\"\n\
                node = \"mass\"\nstiffness = [50, 50, 50]\nrotational_stiffness = [1, 1, 1]\n";
    for case in 0..200 {
        let (harmonic, phase) = (f64::from(case % 5 + 1), f64::from(case / 5) * 0.157);
        let of = |period: f64| {
            format!(
                "{mass}[[load]]\nnode = \"mass\"\nforce = [3, 0, 0]\n\
                 drive = \"= sin({harmonic:?}*t + {phase:?})\"\n[periodic]\nperiod = {period:?}\n"
            )
        };
        let sound = std::f64::consts::TAU;
        parse(&of(sound), "m.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
        let off = sound * (1.0 + 1e-3 * f64::from(case % 7 + 1));
        let found = refused(&of(off));
        assert!(
            found.contains("the force balance along x of node \"mass\" changes by"),
            "{case}: {found}"
        );
    }
    // Products with a sensed quantity, which is zero at rest.
    let sensed = |frequency: &str| {
        format!(
            "{mass}[sensors.x]\nquantity = \"position\"\nof = \"mass\"\ncomponent = \"x\"\n\
             [[load]]\nnode = \"mass\"\nforce = [3, 0, 0]\ndrive = \"= x*sin({frequency}*t)\"\n\
             [periodic]\nperiod = \"{:?} s\"\n",
            std::f64::consts::TAU
        )
    };
    parse(&sensed("2"), "m.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
    assert!(refused(&sensed("2.5")).contains("the force balance along x"));
    // Tables of one period, with and without values after it; one that ends elsewhere than it begins.
    let table = |last: f64, outside: &str| {
        format!(
            "{mass}[[load]]\nnode = \"mass\"\nforce = [3, 0, 0]\n\
             drive = {{ kind = \"table\", rows = [[0, 1], [0.4, 3], [1, {last:?}]]{outside} }}\n\
             [periodic]\nperiod = 1\n"
        )
    };
    for outside in ["", ", outside = \"hold\""] {
        let sound = table(1.0, outside);
        parse(&sound, "m.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}\n{sound}"));
        assert!(refused(&table(2.0, outside)).contains("the force balance along x"));
    }
    // The angle of a rotor.
    let angle = |period: &str| {
        let speed = format!("[periodic]\nspeed = {period}\n");
        text("rigid", "angle = \"= 6*t\"", &speed)
    };
    parse(&angle("1"), "r.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
    let found = refused(&angle("1.001"));
    assert!(
        found.contains("axes a of \"r/shaft\" changes by"),
        "{found}"
    );
}

const RUN: &str = "[transient]\nto = 0.1\nstep = 1e-3\n";

/// A flap hinge without spring.
const FLAP: &str = "speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n";

/// Kinds and keys of wrong rotors, and the problem of each.
const WRONG: &[(&str, &str, &str)] = &[
    (
        "rigid",
        "speed = 1\nazimuth = 400",
        "the azimuth of the first blade is",
    ),
    (
        "rigid",
        "",
        "rotor \"r\" has no drive, expected \"speed\", \"angle\" or \"torque\"",
    ),
    (
        "rigid",
        "angle = 1\ntorque = 2",
        "has \"angle\" and \"torque\"",
    ),
    (
        "articulated",
        "speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n[rotor.pitch_link]\nstiffness = 900\n\
         delta_3 = 120",
        "\"delta_3\" is 120 deg, expected from -80 to 80 deg",
    ),
    (
        "articulated",
        "speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n[rotor.swashplate]\n\
         [rotor.swashplate.plate]\nbelow = 0.3\nhorn = [0.1, 0.2]\n[rotor.swashplate.plate.actuators]\nbase_radius = 0.1\n\
         radius = 0.2\nbase_below = 0.6\nazimuths = [0, 360, 120]",
        "\"azimuths\" lists 3 actuators at 2 different azimuths, expected three",
    ),
    (
        "rigid",
        "sped = 1",
        "unknown key \"sped\" in [[rotor]] number 1",
    ),
    (
        "stiff",
        "speed = 1",
        "\"hub\" is \"stiff\", expected one of",
    ),
    (
        "rigid",
        FLAP,
        "a hub of the kind \"rigid\" has a flap or lag hinge",
    ),
    (
        "hingeless",
        FLAP,
        "has a flap hinge without \"stiffness\", expected the stiffness of the flexure that it represents \
         (0 if it turns freely)",
    ),
    ("articulated", "speed = 1", "has no flap hinge"),
    ("gimballed", "speed = 1", "has no \"link\""),
    (
        "rigid",
        "speed = 1\nundersling = 1",
        "the kind \"rigid\" has no \"undersling\"",
    ),
    (
        "rigid",
        "speed = 1\naft = [0, 0, 1]",
        "\"aft\" is along the axis",
    ),
    (
        "rigid",
        "speed = 1\naxis = [0, 0, 0]",
        "\"axis\" has no direction",
    ),
    (
        "rigid",
        "speed = 1\ninertia = [1, 1, 1]",
        "has \"inertia\" without \"mass\"",
    ),
    (
        "rigid",
        "speed = 1\n[rotor.inflow]\nkind = \"uniform\"",
        "has \"inflow\" without",
    ),
    (
        "rigid",
        "speed = 1\n[rotor.pitch_link]\nstiffness = 1",
        "has \"pitch_link\" without \"swashplate\"",
    ),
    (
        "articulated",
        "speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.3\n",
        "the flap hinge is at 0.3 m from the center of the hub, expected from 0 m to 0.2 m",
    ),
    (
        "rigid",
        "angle = \"a\"\n[rotor.swashplate]\nsine = 1",
        "the pitch depends on the azimuth, but \"angle\" is a drive by name",
    ),
    (
        "rigid",
        "torque = 1\n[rotor.swashplate]\nsine = 1",
        "the pitch of rotor \"r\" is prescribed at its bearing, but its azimuth is a result",
    ),
    (
        "teetering",
        "speed = 1\n[rotor.swashplate]\ncollective = 1",
        "but the hub tilts against the swashplate",
    ),
    (
        "rigid",
        "speed = 1\n[rotor.swashplate]\nindividual = [1, 2]",
        "\"individual\" lists 2, expected 3: one per blade",
    ),
    (
        "rigid",
        "speed = 1\n[rotor.swashplate]\nindividual = []",
        "\"individual\" is an array of 0, expected a list of drives, one per blade",
    ),
    (
        "articulated",
        "speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\noffset = -0.1\n",
        "the flap hinge is at -0.1 m from the center of the hub, expected from 0 m to 0.2 m",
    ),
    (
        "rigid",
        "speed = 1\n[rotor.lag_damper]\nhub = [0, 0.1, 0]\nblade = [0.3, 0.1, 0]\non = \"lag\"\n\
         damping = 1",
        "\"on\" of [rotor.lag_damper] is \"lag\", but rotor \"r\" has no lag hinge",
    ),
    (
        "rigid",
        "speed = 1\n[rotor.swashplate]\ncollective = 160\nplate = { below = 0.1, horn = [0, 0.1] }",
        "no position of the plate gives the pitch",
    ),
    (
        "rigid",
        "speed = 1\n[rotor.swashplate]\nplate = { below = 0.1, horn = [0.1, 0] }",
        "\"horn\" is on the pitch axis",
    ),
    (
        "teetering",
        "speed = 1\nundersling = 0.2\n[rotor.swashplate]\nplate = { below = 0.1, horn = [0.1, 0.1] }",
        "\"below\" is 0.1 m, expected more than 0.2 m",
    ),
    (
        "rigid",
        "speed = 1\n[rotor.swashplate]\ncollective = \"8 m\"",
        "\"collective\"",
    ),
    (
        "articulated",
        "speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\nstop = { stiffness = 1 }",
        "the stop has no angle",
    ),
    (
        "articulated",
        "speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\ndamper = { rates = [1, 0], moments = [1, 2] }",
        "the damper has 2 rates and 2 values under \"moments\"",
    ),
    (
        "articulated",
        "speed = 1\n[[rotor.hinge]]\nkind = \"lag\"\ndamper = { rates = [-1, 0, 1], moments = [-2, 0, -2] }",
        "value 3 under \"moments\" has the opposite sign of its rate",
    ),
];

#[test]
fn wrong_rotors_are_explained() {
    for (kind, keys, expected) in WRONG {
        let shown = refused(&text(
            kind,
            keys,
            &format!("{RUN}[drives.a]\nkind = \"ramp\"\nto = 1\nend = 1\n"),
        ));
        assert!(shown.contains(expected), "{kind} {keys}\n{shown}");
        let is_alone = shown.matches("error:").count() == 1;
        assert!(
            !expected.contains("azimuth of the first") || is_alone,
            "{shown}"
        );
        assert!(shown.contains("a.dynamics.toml:"), "{shown}");
    }
}

// A rotor that is refused has no parts: what uses them is not reported, all else is.
#[test]
fn refused_rotors_are_the_only_problem() {
    let cards = "[sensors.up]\nquantity = \"thrust\"\n[sensors.flap]\nquantity = \"joint_angle\"\n\
                 of = \"r 1/flap\"\n[[load]]\nnode = \"r 2/tip\"\nforce = [0, 0, 1]\n\
                 [[output.column]]\nname = \"hub\"\nquantity = \"reaction_force\"\nof = \"r/shaft\"\n\
                 [[output.column]]\nname = \"air\"\nquantity = \"power\"\nof = \"r\"\n";
    let sound = text("articulated", FLAP, &format!("{RUN}{cards}"));
    let shown = refused(&sound.replace("blades = 3\n", ""));
    let expected = "[[rotor]] number 1 has no \"blades\", expected a whole number of at least 1";
    assert!(shown.ends_with(expected), "{shown}");
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    let shown = refused(
        &sound
            .replace("blades = 3\n", "")
            .replace("\"r 2/tip\"", "\"q/tip\""),
    );
    assert!(shown.contains("unknown node \"q/tip\""), "{shown}");
    assert_eq!(shown.matches("error:").count(), 2, "{shown}");
}

/// Controls of an articulated rotor, the key and its text, and the problem that is reported there.
const CONTROLS: &[(&str, &str)] = &[
    (
        "collective = \"= 2*tt\"",
        "\"collective\": unknown name \"tt\" at letter 4 of \"2*tt\"\n  help: did you mean \"t\"?",
    ),
    (
        "sine = \"= 1 + \"",
        "\"sine\": letter 6 of \"1 +\" is the end, expected a number, a name or \"(\"",
    ),
    (
        "individual = [0, \"= rate*t\", 0]",
        "\"individual\": unknown name \"rate\" at letter 2 of \"rate*t\"\n  help: known names: t, height, pi, deg; [parameters] defines others",
    ),
    (
        "harmonic = [{ order = 2, cosine = \"none\" }]",
        "unknown signal \"none\" in \"cosine\"\n  help: a quantity of the model becomes a signal by \
         [sensors.NAME]; signals are \"height\", \"a\"",
    ),
    (
        "cosine = { kind = \"ramp\", to = 1 }",
        "the drive under \"cosine\" of [rotor.swashplate] has none of \"end\" and \"duration\", expected one",
    ),
    (
        "sine = \"= height\"",
        "\"sine\" follows \"height\", whose second derivative is not known\n  help: its value, or its \
         rate, may jump, which would be an impulse: add an [[actuator]] with this signal as its \
         \"command\", and use the actuator's name here",
    ),
    (
        "collective = \"height\"",
        "\"height\" measures a length, expected an angle\n  help: give it another \"unit\"; a drive or \
         an actuator without one is in the unit of each key",
    ),
];

// Each problem once, at the line where the control is written, and nothing else.
#[test]
fn wrong_controls_are_reported_where_they_are_written() {
    let keys = "speed = 300\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n";
    let cards = format!(
        "{RUN}[drives.a]\nkind = \"ramp\"\nto = 1\nend = 1\n[sensors.height]\nquantity = \"position\"\n\
         of = \"r/hub\"\ncomponent = \"z\"\n"
    );
    for (control, expected) in CONTROLS {
        let text = text(
            "articulated",
            &format!("{keys}[rotor.swashplate]\n{control}\n"),
            &cards,
        );
        let line = 1 + text.lines().position(|line| line == *control).unwrap();
        assert_eq!(
            refused(&text),
            format!("error: a.dynamics.toml:{line}: {expected}")
        );
    }
}

// A sum of drives cannot sense: neither a quantity, nor the azimuth of a shaft with a torque.
#[test]
fn drives_beside_sensed_quantities_are_reported_by_their_key() {
    const HINGE: &str = "[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\n[rotor.pitch_link]\n\
                         stiffness = 1\n[rotor.swashplate]\n";
    const CARDS: &str = "[drives.a]\nkind = \"ramp\"\nto = 1\nend = 1\n[sensors.height]\n\
                         quantity = \"position\"\nof = \"r/hub\"\ncomponent = \"z\"\n";
    for (drive, control, line) in [
        (
            "speed = 300",
            "collective = \"= 2*height\"",
            "cosine = \"a\"",
        ),
        ("torque = 1", "sine = 1", "collective = \"a\""),
    ] {
        let keys = format!("{drive}\n{HINGE}{control}\n{line}\n");
        let text = text("articulated", &keys, &format!("{RUN}{CARDS}"));
        let number = 1 + text.lines().position(|own| own == line).unwrap();
        let key = line.split(' ').next().unwrap();
        let expected = format!(
            "error: a.dynamics.toml:{number}: \"{key}\" is a drive by name or table, expected a number \
             or an expression of t\n  help: the lengths of actuators, and a pitch with a sensed \
             quantity or azimuth, are expressions: write the drive as one"
        );
        let shown = refused(&text);
        assert!(shown.contains(&expected), "{shown}");
    }
}

#[test]
fn wrong_files_are_explained() {
    let sound = text("rigid", "speed = 300", RUN);
    let rotor =
        format!("[[rotor]]\nname = \"r\"\nhub = \"rigid\"\nblades = 3\nspeed = 300\n{BLADE}");
    let nested = rotor
        .replace("[rotor", "[repeat.rotor")
        .replace("[[rotor", "[[repeat.rotor");
    for (text, expected) in [
        (format!("{sound}{rotor}"), "rotor \"r\" is already defined"),
        (
            sound.replace("name = \"r\"", "name = \"r 1\""),
            "\"r 1\" is no name of a rotor",
        ),
        (
            sound.replace("[rotor.blade]", "[rotor.blade]\ncount = 3"),
            "[rotor.blade] has \"count\", which follows from the rotor",
        ),
        (
            sound.replace("hub_radius", "hub_radus"),
            "unknown key \"hub_radus\"",
        ),
        (
            sound.replace(
                "step = 1e-3",
                "step = 1e-3\nstart = \"rotating\"\nspeed = 200",
            ),
            "rotor \"r\" turns at 300 rpm, but the run starts at 200 rpm",
        ),
        (
            sound.replace(RUN, "[hub]\naxis = [0, 1, 1]\n[modes]\nspeeds = [0, 300]\n"),
            "the model turns about the axis of [hub], and rotor \"r\" has another",
        ),
        (
            format!("units = \"SI\"\n{STRIP}[[repeat]]\ncount = 2\n{nested}{RUN}"),
            "[[repeat]] has a rotor",
        ),
    ] {
        let shown = refused(&text);
        assert!(shown.contains(expected), "{shown}");
    }
}

/// Rotors that use most tables.
const RICH: [(&str, &str); 2] = [
    (
        "teetering",
        "speed = 300\nundersling = 0.1\n[rotor.tilt]\nstiffness = 4\n[[rotor.hinge]]\nkind = \"flap\"\n\
         offset = 0.1\nstop = { lower = -1, stiffness = 3 }\n[rotor.swashplate]\ncollective = 4\n\
         sine = 2\n[rotor.swashplate.plate]\nbelow = 0.3\nhorn = [0.1, 0.1]\n",
    ),
    (
        "bearingless",
        "speed = 300\n[rotor.flexbeam]\noffset = 0.1\nproperties = \"strip\"\n\
         piece = [{ length = 0.1, elements = 1 }]\n[rotor.torque_tube]\nmass = 1\n[rotor.snubber]\n\
         to = \"flexbeam\"\ndamping = [0, 1, 0]\n[rotor.lag_damper]\nhub = [0.1, 0.1, 0]\n\
         blade = [0.2, 0.1, 0]\nstiffness = 4\nloss_factor = 0.2\nfrequency = 3\n\
         static_stiffness = 2\n[rotor.drive]\ninertia = 1\nstiffness = 3\nfree_wheel = true\n\
         governor = { proportional = 3, integral = 2 }\n",
    ),
];

// Files with lines removed, doubled, exchanged or with another word: read, or reported.
#[test]
fn files_of_any_content_are_read_or_reported() {
    const WORDS: [&str; 7] = ["-1", "0", "nan", "1e308", "\"= t\"", "[1, 2]", "\"x\""];
    let mut seed = 5_u64;
    let mut below = |end: usize| {
        seed = seed
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (seed >> 33) as usize % end.max(1)
    };
    let mut counts = [0; 2];
    for number in 0..500 {
        let (kind, keys) = RICH[number % 2];
        let text = text(kind, keys, RUN);
        let mut lines: Vec<_> = text.lines().map(str::to_owned).collect();
        for _ in 0..=below(2) {
            let at = 12 + below(lines.len() - 12);
            match below(4) {
                0 => drop(lines.remove(at)),
                1 => lines.insert(at, lines[at].clone()),
                2 => lines.swap(at, 12),
                _ => {
                    if let Some((key, _)) = lines[at].clone().split_once('=') {
                        lines[at] = format!("{key}= {}", WORDS[below(WORDS.len())]);
                    }
                }
            }
        }
        let text = lines.join("\n");
        match parse(&text, "a.dynamics.toml") {
            Ok(_) => counts[0] += 1,
            Err(problems) => {
                let shown = problems.to_string();
                assert!(!shown.contains("no reason was noted"), "{shown}\n{text}");
                counts[1] += 1;
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 20), "{counts:?}");
}

// A damper of no length, and a limit of stiffness: one message each, with key and remedy.
#[test]
fn dampers_without_length_and_beyond_all_digits_are_refused() {
    let damper = |keys: &str| {
        let hinge = "speed = 0\n[[rotor.hinge]]\nkind = \"lag\"\n";
        refused(&text("hingeless", &format!("{hinge}{keys}\n"), ""))
    };
    let ends = "[rotor.lag_damper]\nhub = [0.3, -0.08, 0]\nblade = [0.3, -0.08, 0]\ndamping = 100";
    let shown = damper(ends);
    let expected = "\"hub\" and \"blade\" of [rotor.lag_damper] are the same point, [0.3, -0.08, 0] m, \
                    expected the two ends of the damper\n  help: both are positions from the center of \
                    the hub along the undeformed blade";
    assert!(shown.contains(expected), "{shown}");
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    let stiff = "damper = { stiffness = 1e30, loss_factor = 0.4, frequency = 4 }";
    let shown = damper(stiff);
    let expected = "\"stiffness\" is 1e30 in SI units, expected at most 1e20\n  help: the stiffness of \
                    all other parts would be lost in round-off";
    assert!(shown.contains(expected), "{shown}");
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
}

/// A start that turns the whole model with a part that stands is refused at its line, in runs and in periodic
/// motion; a given start is not.
#[test]
fn rotating_starts_of_carried_rotors_are_refused_at_their_line() {
    let pylon = "[[node]]\nname = \"pylon\"\nposition = [0, 0, 0]\n[[body]]\nname = \"pylon\"\nnode = \"pylon\"\n\
                 mass = 30\ninertia = [1, 1, 1]\n[[spring]]\nname = \"gear\"\nnode = \"pylon\"\n\
                 stiffness = [1e5, 2e5, 1e6]\nrotational_stiffness = [1e5, 1e5, 1e5]\n";
    let tower = "[rotor.tower]\nheight = 5\nproperties = \"strip\"\n";
    for (keys, cards, node) in [
        ("speed = 1\nnode = \"pylon\"", pylon, "pylon"),
        ("speed = 1", tower, "r/nacelle"),
    ] {
        for run in [
            "[transient]\nto = 0.1\nstep = 1e-3\nspeed = 1\n",
            "[periodic]\nspeed = 1\n",
        ] {
            let of =
                |start: &str| text("rigid", keys, &format!("{cards}{run}start = \"{start}\"\n"));
            let wrong = of("rotating");
            let line = wrong
                .lines()
                .position(|line| line.starts_with("start"))
                .unwrap()
                + 1;
            let found = refused(&wrong);
            let expected = format!(
                "a.dynamics.toml:{line}: \"start\" is \"rotating\", which turns the whole model, but rotor \"r\" \
                 turns on node \"{node}\", which stands"
            );
            assert!(found.contains(&expected), "{found}");
            assert_eq!(found.matches("help:").count(), 1, "{found}");
            let given = of("given").replace("speed = 1\nstart", "start");
            if run.starts_with("[transient]") {
                parse(&given, "r.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
            }
        }
    }
}

/// The radius of the root, not the hinge that is beyond it; and hinges that turn about one axis.
#[test]
fn wrong_roots_and_doubled_hinges_are_named() {
    let flap = "speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\n";
    let negative = text("articulated", flap, RUN).replace("hub_radius = 0.2", "hub_radius = -0.2");
    let found = refused(&negative);
    assert!(
        found.contains("\"hub_radius\" is -0.2, expected a length, zero or more"),
        "{found}"
    );
    assert_eq!(
        found.matches("error").count() + found.matches("help:").count(),
        1,
        "{found}"
    );
    let two = format!("{flap}offset = 0.1\n[[rotor.hinge]]\nkind = \"flap\"\n");
    let found = refused(&text("articulated", &two, RUN));
    assert!(
        found.contains(
            "two flap hinges are at 0.1 m from the center of the hub, and neither has a stiffness"
        ),
        "{found}"
    );
    for sound in [
        format!("{two}stiffness = 5\n"),
        format!("{two}offset = 0.15\n"),
    ] {
        let sound = text("articulated", &sound, RUN);
        parse(&sound, "r.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
    }
}

/// A coupling with flapping that no hinge has.
#[test]
fn a_coupling_without_flap_hinges_is_refused() {
    let link = "speed = 1\n[rotor.swashplate]\ncollective = 1\n[rotor.pitch_link]\nstiffness = 9\ndelta_3 = 10\n";
    let found = refused(&text("hingeless", link, RUN));
    assert!(
        found.contains(
            "a hub of the kind \"hingeless\" has \"delta_3\" without a flap hinge inboard"
        ),
        "{found}"
    );
    let first = format!(
        "{link}[[rotor.hinge]]\nkind = \"pitch\"\noffset = 0.1\n[[rotor.hinge]]\nkind = \"flap\"\n"
    );
    assert!(refused(&text("articulated", &first, RUN)).contains("without a flap hinge inboard"));
}

/// A period with fewer digits than the speed of the rotor has the time of whole turns, with a remark; without
/// period and speed it is a turn of the first rotor. More than a millionth is an error.
#[test]
fn periods_follow_the_speed_of_the_rotor() {
    let speed = 7.0 * std::f64::consts::TAU / 60.0;
    let of = |card: &str| {
        let text = text("rigid", "speed = 7", &format!("[periodic]\n{card}\n"));
        let input = parse(&text, "r.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
        let input = input
            .repeating()
            .unwrap_or_else(|problems| panic!("{problems}"));
        (input.periodic.unwrap(), input.remarks)
    };
    for (card, turns, is_rounded) in [
        ("", 1.0, false),
        ("revolutions = 3", 3.0, false),
        ("speed = 7", 1.0, false),
        ("period = 8.5714286", 1.0, true),
        ("speed = 7.000001", 1.0, true),
        ("speed = 3.500001", 2.0, true),
    ] {
        let (settings, remarks) = of(card);
        let exact = turns * std::f64::consts::TAU / speed;
        assert!(
            (settings.period / exact - 1.0).abs() < 1e-14,
            "{card}: {}",
            settings.period
        );
        if let Some(own) = settings.speed {
            let whole = own * settings.period / std::f64::consts::TAU;
            assert!((whole - whole.round()).abs() < 1e-12, "{card}: {own}");
        }
        let found: Vec<_> = remarks
            .iter()
            .filter(|one| one.contains("the period of"))
            .collect();
        assert_eq!(found.len(), usize::from(is_rounded), "{card}: {remarks:?}");
        if is_rounded {
            assert!(
                found[0].contains("of rotor \"r\" at 7 rpm, in place of"),
                "{found:?}"
            );
        }
    }
    let off = text("rigid", "speed = 7", "[periodic]\nspeed = 7.0001\n");
    assert!(refused(&off).contains("rotor \"r\" turns 0.9999857"));
}

/// The period is checked by the analyses that use it only.
#[test]
fn other_analyses_do_not_check_the_period() {
    let both = text(
        "rigid",
        "speed = 7",
        "[periodic]\nspeed = 8\n[modes]\nspeeds = [7]\n",
    );
    let input = parse(&both, "r.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
    assert!(input.modes.is_some());
    let found = input.repeating().unwrap_err().to_string();
    assert!(found.contains("rotor \"r\" turns 0.875 times"), "{found}");
    assert_eq!(found.matches("help:").count(), 1, "{found}");
    // Beside other problems of the file all are shown.
    let found = refused(&both.replace("[modes]", "[[clamp]]\nnode = \"nod\"\n[modes]"));
    assert!(
        found.contains("\"nod\"") && found.contains("rotor \"r\" turns 0.875 times"),
        "{found}"
    );
}
