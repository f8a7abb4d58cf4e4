//! Tests of the steady and turbulent conditions of `[air.event]`.
//!
//! Numbers of IEC 61400-1 ed. 3, 6.3.1.3, 6.3.2.1 and 6.3.2.3, by hand for class II B at 12.5 m/s, a
//! hub at 90 m: NTM sigma `0.14 (0.75 12.5 + 5.6)`, ETM sigma
//! `2 0.14 (0.072 (8.5/2 + 3) (12.5/2 - 4) + 10)`, EWM `1.4 42.5 (z/90)^0.11`.

use super::*;

/// A condition of a turbine of class II B, in a wind.
fn of(wind: &str, kind: &str, more: &str) -> String {
    format!(
        "{wind}[air.event]\nkind = \"{kind}\"\nclass = \"II\"\ncategory = \"B\"\nhub_height = 90\n\
         diameter = 126\n{more}"
    )
}

const WIND: &str = "[air.wind]\nspeed = 12.5\nreference_height = 90\nexponent = 0.2\n";
const SMALL: &str = "points = 3\nduration = 64\ntime_step = 0.5\n";

#[test]
fn extreme_winds_have_speed_and_shear() {
    for (kind, speed) in [("EWM 50", 1.4 * 42.5), ("EWM 1", 0.8 * 1.4 * 42.5)] {
        let steady = air(&of(
            "[air.wind]\nturn = 90\nground = [0, 0, -90]\n",
            kind,
            "",
        ));
        assert_near(velocity(&steady, [0.0; 3], 7.0), [0.0, -speed, 0.0]);
        let low = speed * 0.5_f64.powf(0.11);
        assert_near(velocity(&steady, [0.0, 0.0, -45.0], 7.0), [0.0, -low, 0.0]);
        assert!(air(&of("", kind, "")).constant().is_none());
    }
    assert_refused(&[
        (
            &of(WIND, "EWM 1", ""),
            &["a.toml:7", "\"wind\" is a speed, a law", "directions alone"],
        ),
        (
            &of("[air.wind]\nspeed = 48\n", "EOG", ""),
            &[
                "48 m/s at the hub, expected less than the extreme speed",
                "47.6 m/s",
            ],
        ),
        (
            &of("", "EWM 1", "start = 5\nseed = 3\n"),
            &[
                "\"start\" has no effect: it belongs to events",
                "\"seed\" has no effect: it belongs to NTM and ETM",
            ],
        ),
    ]);
}

#[test]
fn turbulence_has_the_deviation_of_the_class() {
    let ntm = 0.14 * (0.75 * 12.5 + 5.6);
    let etm = 2.0 * 0.14 * (0.072 * (8.5 / 2.0 + 3.0) * (12.5 / 2.0 - 4.0) + 10.0);
    for (kind, sigma) in [("NTM", ntm), ("ETM", etm)] {
        let found = air(&of(WIND, kind, SMALL));
        let one = &found.wind().boxes[0];
        let statistics = one.statistics().unwrap();
        assert!((statistics.hub_sigma - sigma).abs() < 1e-12, "{kind}");
        // the mean wind is not part of the box
        assert!(statistics.hub_speed.abs() < 1e-12);
        let grid = one.grid();
        assert_eq!((grid.planes, grid.speed, grid.lateral), (128, 12.5, 3));
        assert!((grid.half_width() - 0.6 * 126.0).abs() < 1e-12);
        let [u, _, _] = velocity(&found, [0.0, 0.0, 90.0], 0.0);
        assert!((u - 12.5 - one.plane(0).unwrap()[grid.index(1, 1)]).abs() < 1e-12);
    }
    let again = |seed: &str| {
        let found = air(&of(WIND, "NTM", &format!("{SMALL}{seed}")));
        found.wind().boxes[0].plane(9).unwrap()
    };
    assert_eq!(again(""), again("seed = 1\n"));
    assert_ne!(again(""), again("seed = 2\n"));
}

/// The box of the file has a mean of its own; after scaling it has the same mean.
#[test]
fn a_box_of_a_file_is_scaled() {
    let file = "[air.turbulence]\nfile = \"own.bts\"\n";
    let own = air(file).wind().boxes[0].statistics().unwrap();
    let scaled = air(&of(file, "NTM", ""));
    let found = scaled.wind().boxes[0].statistics().unwrap();
    let sigma = 0.14 * (0.75 * own.hub_speed + 5.6);
    assert!((found.hub_sigma - sigma).abs() < 1e-12);
    assert!((found.hub_speed - own.hub_speed).abs() < 1e-12);
}

/// Of keys that would have no effect, or another one than expected, each is reported.
#[test]
fn turbulence_is_along_the_direction() {
    let file = "[air.turbulence]\nfile = \"own.bts\"\n";
    let keys = [
        ("turn", "90"),
        ("upflow", "8"),
        ("veer", "0.1\nreference_height = 90"),
        ("exponent", "0.2\nreference_height = 90"),
        (
            "vertical_shear",
            "0.2\nreference_length = 126\nreference_height = 90",
        ),
        ("horizontal_shear", "0.2\nreference_length = 126"),
    ];
    for (key, value) in keys {
        let words = format!("\"{key}\" is in the wind of [air], expected no such key");
        assert_refused(&[(&format!("[air.wind]\n{key} = {value}\n{file}"), &[&words])]);
    }
    let of_mann = |wind: &str| of(&format!("[air.wind]\nspeed = 12.5\n{wind}"), "NTM", SMALL);
    assert_refused(&[
        (
            &of_mann("turn = 30\n"),
            &[
                "\"turn\" is 30 degrees, expected zero",
                "turn \"direction\"",
            ],
        ),
        (
            &of_mann("upflow = 8\n"),
            &["\"upflow\" is 8 degrees", "incline \"up\""],
        ),
    ]);
    // Turned by its direction the wind has the same numbers along and across.
    let straight = air(&of_mann(""));
    let turned = air(&of_mann("direction = [0, 1, 0]\n"));
    for at in [[0.0, 5.0, 95.0], [3.0, -20.0, 80.0]] {
        let [x, y, z] = velocity(&straight, at, 3.0);
        let found = velocity(&turned, [-at[1], at[0], at[2]], 3.0);
        assert_near(found, [-y, x, z]);
    }
}

#[test]
fn wrong_turbulence() {
    let mann = "[air]\nwind = [6, 0, 0]\n[air.turbulence]\nsigma = [1, 1, 1]\n\
                files = [\"own_20x5x7.u\", \"own_20x5x7.u\", \"own_20x5x7.u\"]\n\
                points = [20, 5, 7]\nspacing = [3, 10, 8]\nhub_height = 84\n";
    assert_refused(&[
        (
            &of("[air]\nwind = [0, 0, 0]\n", "ETM", SMALL),
            &[
                "a.toml:5",
                "\"speed\" is 0 m/s at the hub",
                "\"speed\" in [air.wind]",
            ],
        ),
        (
            &of(WIND, "NTM", "width = 200\n"),
            &["a.toml:12", "\"width\" is 200 m, expected less than 180 m"],
        ),
        (
            &of(WIND, "NTM", "duration = 0.5\n"),
            &["\"duration\" is 2 times \"time_step\", expected 4 to 1000000 planes"],
        ),
        (
            &of(WIND, "NTM", "points = 8\n"),
            &["\"points\" is 8, expected an odd number: the hub is at a point"],
        ),
        (
            &of(
                WIND,
                "NTM",
                "points = 33\nduration = 600\ntime_step = 0.1\n",
            ),
            &["\"points\" is 33, expected at most 17 with 6000 planes"],
        ),
        (
            &mann.replace("wind = [6, 0, 0]", "altitude = 0"),
            &["a.toml:6: \"speed\" is 0 m/s at the hub, expected the speed by which"],
        ),
        (
            &of(WIND, "NTM", "reversed = true\n"),
            &["\"reversed\" has no effect: it belongs to events"],
        ),
        (
            &of(mann, "NTM", "seed = 4\n"),
            &["\"seed\" has no effect: it belongs to NTM and ETM without [air.turbulence]"],
        ),
        (
            &of(mann, "NTM", ""),
            &[
                "a.toml:5",
                "\"sigma\" has no effect: the condition of [air.event] scales the box",
            ],
        ),
    ]);
}

#[test]
fn a_generated_box_must_be_as_large_as_the_rotor() {
    let run = "[transient]\nto = 1\nstep = 0.1\n";
    let of = |width: f64| {
        format!(
            "[air.wind]\nspeed = 8\n[air.event]\nkind = \"NTM\"\nclass = \"I\"\ncategory = \"A\"\n\
             hub_height = 84\ndiameter = 40\n{SMALL}width = {width}\n"
        )
    };
    assert!(model(&of(40.0), run).is_ok());
    let shown = reported(model(&of(30.0), run));
    for words in [
        "a.dynamics.toml:5",
        "half the width is 15 m, expected at least 20 m",
        "the top is 99 m, expected at least 104 m",
        "the bottom is 69 m, expected at most 64 m",
        "give a larger \"width\"",
    ] {
        assert!(shown.contains(words), "{words}\n{shown}");
    }
}

/// At the height of the ground the profile of EWM has no speed.
#[test]
fn a_rotor_at_the_ground_has_no_wind() {
    let run = "[transient]\nto = 1\nstep = 0.1\n";
    let of = |ground: f64| {
        format!(
            "[air.wind]\nground = [0, 0, {ground}]\n[air.event]\nkind = \"EWM 50\"\nclass = \"I\"\n\
             category = \"A\"\nhub_height = 84\ndiameter = 40\n"
        )
    };
    assert!(model(&of(0.0), run).is_ok());
    let shown = reported(model(&of(85.0), run));
    for words in [
        "\"ground\" is -1 m below the center of the rotor, expected a point below it",
        "give a point on the ground as \"ground\" of [air.wind]",
    ] {
        assert!(shown.contains(words), "{words}\n{shown}");
    }
}

/// A wind along the default vertical.
#[test]
fn a_wind_along_the_vertical_names_the_keys() {
    assert_refused(&[
        (
            "[air.wind]\nspeed = 8\ndirection = [0, 0, 2]\n",
            &[
                "a.toml:4",
                "\"direction\" is [0, 0, 2], along the vertical [0, 0, 1], expected a level direction",
                "by \"up\"",
                "by \"ground\"",
            ],
        ),
        (
            "[air.wind]\nspeed = 8\nup = [0, 0, 0]\n",
            &["a.toml:4", "\"up\"", "not zero"],
        ),
    ]);
}

/// A wing of a body at 100 m whose last strip is 20.6 m beside the middle of a box of 40 m.
#[test]
fn strips_outside_a_box_are_found_on_reading() {
    let of = |side: f64| {
        format!(
            "units = \"SI\"\n[air.turbulence]\nfile = \"{BOXES}/own.bts\"\nshift = 24\n\
             [[node]]\nname = \"wing\"\nposition = [0, {side}, 100]\n[[body]]\nnode = \"wing\"\nmass = 1\n\
             inertia = [1, 1, 1]\n[[strip]]\nname = \"tail\"\nnode = \"wing\"\nfrom = [0, -1, 0]\n\
             to = [0, 1, 0]\nforward = [-1, 0, 0]\nstrips = 1\n\
             stations = [{{ at = 0, chord = 1, airfoil = \"naca0012\" }}, {{ at = 2, chord = 1, airfoil = \"naca0012\" }}]\n\
             [transient]\nto = 1\nstep = 0.1\n"
        )
    };
    let found = read_beside(&of(19.4), &[]);
    assert!(found.is_ok(), "{:?}", found.err());
    let shown = reported(read_beside(&of(20.6), &[]));
    for words in [
        "a.dynamics.toml:3: turbulence box",
        "own.bts\": half the width is 20 m, expected at least 20.6 m for strip \"tail\"",
        "make the box wider, or extend it to points outside",
    ] {
        assert!(shown.contains(words), "{words}\n{shown}");
    }
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
}
