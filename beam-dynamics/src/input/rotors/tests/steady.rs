//! Speeds that do not agree, and pitch that analyses without time hold.

use super::{BLADE, STRIP, read, refused, text};

/// A rigid rotor with pitch, keys of the rotor, and cards after it.
fn pitched(keys: &str, pitch: &str, cards: &str) -> String {
    let keys = format!("{keys}\n[rotor.swashplate]\n{pitch}\n");
    text("rigid", &keys, cards)
}

/// The remark of a text that contains a word, if there is one.
fn remark(text: &str, word: &str) -> Option<String> {
    let remarks = read(text).remarks;
    remarks.into_iter().find(|remark| remark.contains(word))
}

// Blade k of three has the azimuth 120 (k - 1) deg at the time zero: 5 + 2 cos psi + 3 sin psi deg.
#[test]
fn equilibria_and_modes_teach_the_pitch_that_they_hold() {
    let cyclic = "collective = 5\ncosine = 2\nsine = 3";
    let cards = "[static]\nspeed = 1\n[modes]\nspeeds = [1]\n";
    assert_eq!(
        remark(&pitched("speed = 1", cyclic, cards), "the pitch of rotor").unwrap(),
        "the pitch of rotor \"r\" changes with azimuth or time by \"cosine\" and \"sine\": [modes] and \
         [static] have it as it is at the time zero (7, 6.5981, 1.4019 deg of blade 1, 2, ...); \
         [periodic] has the motion with it"
    );
    // The pitch of the blades is no other drive that changes.
    let held = pitched("speed = 1", cyclic, "[static]\nspeed = 1\n");
    assert_eq!(remark(&held, "the value at the time zero"), None);
    let of_time = pitched(
        "speed = 1",
        "collective = \"= 4 + 2*t\"",
        "[static]\nspeed = 1\n",
    );
    let found = remark(&of_time, "the pitch of rotor").unwrap();
    assert!(
        found.contains("by \"collective\": [static] has it as it is at the time zero (4 deg);"),
        "{found}"
    );
    // Constant pitch, cyclic pitch of zero, a rotor at rest, and runs in time.
    for (pitch, cards) in [
        ("collective = 5", "[static]\nspeed = 1\n"),
        ("cosine = 0", "[static]\nspeed = 1\n"),
        ("cosine = 2", "[static]\n"),
        ("cosine = 2", "[periodic]\nspeed = 1\n"),
    ] {
        let found = remark(&pitched("speed = 1", pitch, cards), "the pitch of rotor");
        assert_eq!(found, None, "{pitch} {cards}");
    }
}

#[test]
fn a_trim_of_an_equilibrium_finds_no_cyclic_pitch() {
    let trim = "[trim]\nmethod = \"equilibrium\"\nspeed = 1\n[[trim.control]]\nname = \"c\"\n\
                [[trim.target]]\nname = \"t\"\nsignal = \"f\"\nvalue = 0\n\
                [sensors.f]\nquantity = \"reaction_force\"\nof = \"r/shaft\"\nnode = \"r/hub\"\ncomponent = \"z\"\n";
    let found = refused(&pitched("speed = 1", "sine = \"= 2*c\"", trim));
    assert!(
        found.contains(
            "\"c\" of [trim] is cyclic pitch of rotor \"r\", which changes over the azimuth"
        ),
        "{found}"
    );
    let still = trim.replace("speed = 1\n", "");
    let found = refused(&pitched("speed = 1", "collective = \"= 2*c\"", &still));
    assert!(
        found.contains("rotor \"r\" turns at 1 rpm, but [trim] has no \"speed\""),
        "{found}"
    );
}

#[test]
fn drives_that_equilibria_hold_are_remarked() {
    let load = "[[load]]\nnode = \"r/hub\"\nforce = [0, 0, 1]\ndrive = \"= 3*cos(t)\"\n[static]\nspeed = 1\n";
    let found = remark(
        &text("rigid", "speed = 1\nmass = 1", load),
        "changes with time",
    )
    .unwrap();
    assert!(
        found.contains("\"drive\" in line") && found.contains("here 3 in SI units"),
        "{found}"
    );
    let constant = load.replace("3*cos(t)", "3");
    let found = remark(
        &text("rigid", "speed = 1\nmass = 1", &constant),
        "changes with time",
    );
    assert_eq!(found, None);
}

/// Strips of a blade in air.
const AIR: &str = "[rotor.blade.aerodynamics]\nstrips = 1\nstations = [\n\
    { at = 0, chord = 0.1, airfoil = \"flat\" }, { at = 1, chord = 0.1, airfoil = \"flat\" } ]\n\
    [air]\ndensity = 1.2\nwind = [0, 0, 0]\n[airfoils.flat]\nslope = 6\ndrag = 0.01\n";

// A blade without air and a shaft that a torque turns may turn both ways.
#[test]
fn rotors_turn_in_the_sense_of_their_airfoils() {
    let rotor = |keys: &str, cards: &str| {
        format!(
            "units = \"SI\"\n{STRIP}[[rotor]]\nname = \"r\"\nhub = \"rigid\"\nblades = 2\nmass = 1\n\
             inertia = [1, 1, 1]\n{keys}\n{BLADE}{cards}"
        )
    };
    let run = "[transient]\nto = 0.1\nstep = 1e-3\n";
    let found = refused(&rotor("speed = -3", &format!("{AIR}{run}")));
    assert!(
        found.contains("rotor \"r\" turns at -3 rpm, so that its airfoils move backward"),
        "{found}"
    );
    let drive = "speed = -3\n[rotor.drive]\nstiffness = 9\nfree_wheel = true\n";
    let found = refused(&rotor(drive, run));
    assert!(
        found.contains("turns at -3 rpm, but its free wheel drives in the sense of \"axis\" only"),
        "{found}"
    );
    for (keys, cards) in [
        ("speed = -3", run.to_owned()),
        ("speed = 3", format!("{AIR}{run}")),
        ("speed = -3\ntorque = 1", format!("{AIR}{run}")),
    ] {
        read(&rotor(keys, &cards));
    }
}

#[test]
fn two_speeds_of_a_rotor_are_named() {
    // 900 deg/s are 150 rpm.
    let found = refused(&text(
        "rigid",
        "speed = 300\nangle = \"= 900*t\"",
        "[modes]\nspeeds = [1]\n",
    ));
    assert!(
        found.contains("has the \"speed\" 300 rpm, but its \"angle\" begins with 150 rpm"),
        "{found}"
    );
    read(&text(
        "rigid",
        "speed = 150\nangle = \"= 900*t\"",
        "[modes]\nspeeds = [1]\n",
    ));
    let remarked = |cards: &str| remark(&text("rigid", "speed = 300", cards), "rotor \"r\" turns");
    assert_eq!(
        remarked("[static]\nspeed = 200\n").unwrap(),
        "rotor \"r\" turns at 300 rpm, but [static] has 200 rpm: there the model turns at the speed of \
         [static]"
    );
    let at_rest = remarked("[modes]\nspeeds = [0]\n").unwrap();
    assert!(
        at_rest.contains("[modes] has the model at rest") && at_rest.contains("[stability]"),
        "{at_rest}"
    );
    assert!(remarked("[modes]\nspeeds = [100, 400]\n").is_none());
    assert!(remarked("[static]\nspeed = 300\n").is_none());
}

// The tower does not turn, so that the modes of the rotor on it are multipliers.
#[test]
fn modes_of_a_rotor_on_a_tower_are_where_the_help_says() {
    let tower = "speed = 300\n[rotor.tower]\nheight = 5\nproperties = \"strip\"\n";
    let found = refused(&text("rigid", tower, "[modes]\nspeeds = [300]\n"));
    assert!(
        found.contains("rotor \"r\" turns on a part that does not")
            && found.contains("[periodic.floquet]")
            && found.contains("[stability] with by = \"Floquet\", or by = \"averaged\" for three"),
        "{found}"
    );
}

/// A rotor on a node of the file is not turned with its support by analyses without time, also if the node
/// is on its axis; in time it may be.
#[test]
fn carriers_on_the_axis_do_not_turn_with_the_rotor() {
    let pylon = "[[node]]\nname = \"pylon\"\nposition = [0, 0, 0]\n[[body]]\nname = \"pylon\"\nnode = \"pylon\"\n\
                 mass = 30\ninertia = [1, 1, 1]\n[[spring]]\nname = \"gear\"\nnode = \"pylon\"\n\
                 stiffness = [1e5, 2e5, 1e6]\nrotational_stiffness = [1e5, 1e5, 1e5]\n";
    let keys = "speed = 1\nnode = \"pylon\"";
    for analysis in ["[modes]\nspeeds = [1]\n", "[static]\nspeed = 1\n"] {
        let found = refused(&text("rigid", keys, &format!("{pylon}{analysis}")));
        assert!(
            found.contains("rotor \"r\" turns on a part that does not"),
            "{found}"
        );
    }
    read(&text(
        "rigid",
        keys,
        &format!("{pylon}[periodic]\nspeed = 1\n"),
    ));
}

/// The damping of a file has three forms.
#[test]
fn forms_of_damping_are_named() {
    let of = |damping: &str| {
        let tower = format!(
            "speed = 1\n[rotor.tower]\nheight = 5\nfile = \"absent.dat\"\ndamping = {damping}\n"
        );
        refused(&text("rigid", &tower, "[static]\n"))
    };
    let one = "one of \"time\", \"times\" and \"matrix\"";
    for wrong in ["{}", "{ time = 1, times = [0, 0, 0, 0, 0, 0] }", "3"] {
        let found = of(wrong);
        assert!(found.contains(one), "{found}");
    }
    assert!(!of("{ time = 1 }").contains(one));
}

/// Tolerances below round-off are refused, and few steps are remarked.
#[test]
fn settings_of_periods_are_attainable() {
    let of = |keys: &str| {
        text(
            "rigid",
            "speed = 1",
            &format!("[periodic]\nspeed = 1\n{keys}\n"),
        )
    };
    let found = refused(&of("tolerance = 1e-16"));
    assert!(
        found.contains("expected at least 1e-13: round-off"),
        "{found}"
    );
    for (keys, expected) in [("tolerance = 1e-13\nsteps = 8", 0), ("steps = 4", 1)] {
        let found = read(&of(keys));
        let few = |remark: &&String| remark.contains("\"steps\" = 4 of [periodic] are few");
        assert_eq!(found.remarks.iter().filter(few).count(), expected);
    }
}
