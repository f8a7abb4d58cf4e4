//! Tests of the tables of `[air]`: the wind that they give, their problems, and their checks with
//! the rest of a model.

mod conditions;

use std::f64::consts::TAU;

use nalgebra::Vector3;
use rotor_aero::wind::{IecTurbine, TurbulenceCategory, WindClass, WindField};
use shared_geom::document::Document;

use crate::elements::strips::Air;
use crate::input::drives;
use crate::input::schema::DYNAMICS_FILE;
use crate::input::test_files::{STRIP, read_beside, reported};
use crate::model::{Conditions, State};

/// Boxes of the crate of the wind: 20 planes of 5 x 7 points, 40 m wide, 48 m high.
const BOXES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/aero/boxes");

/// The air of a text, which is in the folder of the boxes; the problems as they are shown.
fn read(text: &str) -> Result<Air, String> {
    let file = format!("{BOXES}/a.toml");
    let document = Document::parse(&format!("units = \"SI\"\n{text}"), &file).unwrap();
    let air = {
        let root = document.root_of(&DYNAMICS_FILE);
        document.declare_units(&root);
        let drives = drives::read_named(&root, &[]);
        super::read(&root, &Vector3::new(0.0, 0.0, -9.81), &drives)
    };
    document
        .finish(air)
        .map_err(|problems| problems.to_string().replace(&format!("{BOXES}/"), ""))
}

#[track_caller]
fn air(text: &str) -> Air {
    read(text).unwrap_or_else(|problems| panic!("{problems}"))
}

#[track_caller]
fn velocity(air: &Air, at: [f64; 3], time: f64) -> [f64; 3] {
    let sample = air.wind().sample(&Vector3::from(at), time).unwrap();
    sample.0.into()
}

#[track_caller]
fn assert_near(found: [f64; 3], expected: [f64; 3]) {
    let pairs = found.iter().zip(&expected);
    let is_near = pairs.clone().all(|(a, b)| (a - b).abs() < 1e-12);
    assert!(is_near, "{found:?} {expected:?}");
}

/// Each text is refused with a message that has all the given words.
#[track_caller]
fn assert_refused(cases: &[(&str, &[&str])]) {
    for (text, words) in cases {
        let found = match read(text) {
            Err(found) => found,
            Ok(_) => panic!("accepted: {text}"),
        };
        for word in *words {
            assert!(found.contains(word), "{text}\n{word}\n{found}");
        }
    }
}

#[test]
fn the_atmosphere_is_standard_unless_given() {
    // ISO 2533 at 5000 m, to the digits of its tables
    let high = air("[air]\naltitude = 5000\nviscosity = 2e-5\n").atmosphere;
    assert!((high.density / 0.736_116 - 1.0).abs() < 1e-5);
    assert!((high.sound_speed / 320.529 - 1.0).abs() < 3e-6);
    assert_eq!(high.viscosity, 2e-5);
    let hot = air("[air]\ntemperature_offset = 20\n").atmosphere;
    let cold = air("").atmosphere;
    assert!((hot.density / cold.density - 288.15 / 308.15).abs() < 1e-12);
    assert_eq!(
        air("[air]\ndensity = 1\nspeed_of_sound = 300\n")
            .atmosphere
            .density,
        1.0
    );
    assert_refused(&[
        (
            "[air]\naltitude = 30000\n",
            &["a.toml:3", "altitude", "20000 m"],
        ),
        (
            "[air]\ntemperature_offset = -400\n",
            &["a.toml:3", "temperature"],
        ),
        (
            "[air]\ndensity = 0\n",
            &["a.toml:3", "\"density\"", "greater than zero"],
        ),
        (
            "[air]\nwinds = [1, 0, 0]\n",
            &["unknown key \"winds\"", "\"wind\"?"],
        ),
        ("[air]\nwind = 8\n", &["\"wind\""]),
    ]);
}

#[test]
fn a_velocity_is_the_wind_everywhere() {
    for velocity in [[8.0, 0.0, 0.0], [1.0, -2.0, 3.0], [0.0, 0.0, -4.0]] {
        let air = air(&format!("[air]\nwind = {velocity:?}\n"));
        assert_near(air.constant().unwrap().into(), velocity);
    }
    assert_eq!(air("").constant(), Some(Vector3::zeros()));
}

#[test]
fn laws_of_the_height_in_any_axes() {
    let text = "[air.wind]\nspeed = 10\ndirection = [0, -2, 0]\nground = [0, 0, -90]\n\
                reference_height = 90\nexponent = 0.5\n";
    let power = air(text);
    assert_near(velocity(&power, [3.0, 4.0, 0.0], 1.0), [0.0, -10.0, 0.0]);
    assert_near(velocity(&power, [3.0, 4.0, -67.5], 1.0), [0.0, -5.0, 0.0]);
    assert_eq!(power.constant(), None);
    let text = "[air.wind]\nspeed = 10\ndirection = [0, 0, 1]\nup = [3, 0, 0]\n\
                reference_height = 100\nroughness = 0.01\nupflow = 90\nvertical = 2\n";
    // at 1 m: half the speed, since ln 100 is half of ln 10^4; turned upward, and vertical backward
    assert_near(velocity(&air(text), [1.0, 0.0, 0.0], 0.0), [5.0, 0.0, -2.0]);
    let text = "[air.wind]\nspeed = 10\nreference_height = 80\nreference_length = 100\n\
                horizontal_shear = 0.3\nvertical_shear = 0.2\nveer = 3\n";
    let speed = 10.0 * (1.0 + 0.3 * 0.2 + 0.2 * 0.1);
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let found = velocity(&air(text), [0.0, 20.0, 90.0], 0.0);
    assert_near(found, [speed * cos, -speed * sin, 0.0]);
}

#[test]
fn wrong_mean_winds() {
    assert_refused(&[
        (
            "[air.wind]\nspeed = -1\ndirection = [0, 0, 2]\n",
            &[
                "a.toml:3",
                "zero or more",
                "a.toml:4",
                "along the vertical [0, 0, 1]",
            ],
        ),
        (
            "[air.wind]\nspeed = 9\ndirection = [1, 0, 1]\n",
            &["a.toml:4", "45", "expected a level direction", "upflow"],
        ),
        (
            "[air.wind]\nspeed = 9\nexponent = 0.2\nhorizontal_shear = 0.1\n",
            &[
                "\"reference_height\" is missing",
                "\"reference_length\" is missing",
            ],
        ),
        (
            "[air.wind]\nspeed = 9\nveer = 0.1\n",
            &["\"reference_height\" is missing"],
        ),
        (
            "[air.wind]\nexponent = 0.2\nroughness = 0.1\n",
            &["a.toml:4", "\"roughness\" has no effect", "remove"],
        ),
        (
            "[air.wind]\nreference_height = 1\nroughness = 2\n",
            &[
                "a.toml:4",
                "2 m",
                "less than the reference height, 1 m",
                "grass",
            ],
        ),
        (
            "[air.wind]\ntable = \"none.wnd\"\nspeed = 8\n",
            &[
                "a.toml:4",
                "\"speed\" has no effect",
                "\"reference_height\" is missing",
                "none.wnd",
            ],
        ),
    ]);
}

#[test]
fn a_table_over_time() {
    let rows = "! a ramp\n0 8 0 0 0 0 0 0\n10 12 90 0 0 0 0 1\n";
    let text = "units = \"SI\"\n[air.wind]\ntable = \"a.wnd\"\nreference_height = 90\n\
                reference_length = 126\n";
    let model = |rows: &str| {
        let text = format!("{text}{}[transient]\nto = 1\nstep = 0.1\n", blade(""));
        read_beside(&text, &[("a.wnd", rows)])
    };
    let input = model(rows).unwrap_or_else(|problems| panic!("{problems}"));
    assert_eq!(input.model.next_corner(1.0), 10.0);
    let shown = reported(model("0 8 0 0 0 0 0\n1 x 0 0 0 0 0 0\n"));
    for words in ["a.wnd:1", "columns", "a.wnd:2", "\"table\" of [air.wind]"] {
        assert!(shown.contains(words), "{shown}");
    }
}

/// Speed, turn, upflow and vertical wind by drives: `V (cos e cos d, -cos e sin d, sin e)`, plus the
/// vertical wind normal to it, at 200 random times.
#[test]
fn a_wind_by_drives() {
    let text = "[drives.ramp]\nkind = \"ramp\"\nfrom = 8\nto = 12\nstart = 1\nend = 3\n[air.wind]\n\
                speed = \"ramp\"\nturn = \"= 30*sin(t)\"\nupflow = \"= 2*t\"\nvertical = \"= cos(t)\"\n";
    let driven = air(text);
    assert_eq!(driven.constant(), None);
    let mut seed = 1_u64;
    for _ in 0..200 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let time = 5.0 * (seed >> 11) as f64 / (1_u64 << 53) as f64;
        let speed = 8.0 + 4.0 * ((time - 1.0) / 2.0).clamp(0.0, 1.0);
        let (sin, cos) = (30_f64.to_radians() * time.sin()).sin_cos();
        let (rise, level) = (2.0 * time).to_radians().sin_cos();
        let along = speed * level - time.cos() * rise;
        let expected = [along * cos, -along * sin, speed * rise + time.cos() * level];
        assert_near(velocity(&driven, [3.0, 7.0, -2.0], time), expected);
    }
    let corner = |time| driven.wind().next_corner(&Vector3::zeros(), time);
    assert_eq!([0.0, 1.0, 3.0].map(corner), [1.0, 3.0, f64::INFINITY]);
    // drives that do not change are a constant wind
    let constant = air("[air.wind]\nspeed = \"= 2*3\"\ndirection = [0, 0, 1]\nup = [1, 0, 0]\n");
    assert_near(constant.constant().unwrap().into(), [0.0, 0.0, 6.0]);
    assert_refused(&[
        (
            "[air.wind]\nspeed = \"none\"\n",
            &["a.toml:3", "unknown drive \"none\""],
        ),
        (
            "[air.wind]\nspeed = \"= 3*t\"\nexponent = 0.2\n",
            &["\"reference_height\" is missing"],
        ),
        (
            "[air]\nwind = { turn = \"= t\", speed = 0 }\n[air.turbulence]\nfile = \"own.bts\"\n",
            &["a number that changes", "no mean wind"],
        ),
    ]);
}

/// The corners of the drives end the steps of a run; sensors and drives that end too early are
/// refused. Steady states of a rotor have the wind of the start, which must be along the axis.
#[test]
fn drives_of_the_wind_in_a_model() {
    let run = "[transient]\nto = 1\nstep = 0.1\n";
    let ramp = "[drives.d]\nkind = \"ramp\"\nfrom = 0\nto = 1\nstart = 4\nend = 9\n";
    let wind = "[air.wind]\nspeed = \"d\"\n";
    let input = model(&format!("{ramp}{wind}"), run);
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    assert_eq!(input.model.next_corner(1.0), 4.0);
    let modes = "[modes]\nspeeds = [12]\n";
    let along = "[air.wind]\nspeed = \"= 8 + t\"\ndirection = [0, 0, 1]\nup = [1, 0, 0]\n";
    assert!(model(along, modes).is_ok());
    let shown = reported(model(&format!("{along}turn = \"= 30*cos(t)\"\n"), modes));
    assert!(shown.contains("4 m/s across the axis"), "{shown}");
    let sheared = format!("{along}reference_height = 9\nexponent = 0.2\n");
    let shown = reported(model(&sheared, modes));
    assert!(shown.contains("shear or veer"), "{shown}");
    let short = "[drives.d]\nkind = \"table\"\nrows = [[0, 3], [0.5, 4]]\n";
    let shown = reported(model(&format!("{short}{wind}"), run));
    assert!(shown.contains("\"speed\""), "{shown}");
    let sensed = "[sensors.s]\nquantity = \"kinetic_energy\"\n\
                  [air.wind]\nspeed = \"= s\"\n";
    let shown = reported(model(sensed, run));
    assert!(
        shown.contains("\"speed\"") && shown.contains("\"s\""),
        "{shown}"
    );
}

/// A turning rotor of quasi-steady sections whose wind follows a ramp and turns: its residual at
/// 200 random times is the one of the constant wind of that time, to round-off.
#[test]
fn a_rotor_in_a_wind_by_drives_has_the_constant_wind_of_each_moment() {
    let run = "[transient]\nto = 1\nstep = 0.1\n";
    let ramp = "[drives.d]\nkind = \"ramp\"\nfrom = 6\nto = 14\nstart = 0.2\nend = 0.9\n";
    let driven = format!("{ramp}[air.wind]\nspeed = \"d\"\nturn = \"= 40*t\"\n");
    let driven = model(&driven, run).unwrap_or_else(|problems| panic!("{problems}"));
    let residual = |input: &crate::input::Input, time: f64| {
        let system = &input.model.system;
        let state = State::at_rest(system.nodes(), system.numbering());
        let mut conditions = input.model.conditions(3.0, 1.0, 0.0);
        conditions.loading.time = time;
        system.residual(&state, &conditions).values
    };
    let mut seed = 3_u64;
    for _ in 0..200 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let time = (seed >> 11) as f64 / (1_u64 << 53) as f64;
        let speed = 6.0 + 8.0 * ((time - 0.2) / 0.7).clamp(0.0, 1.0);
        let (sin, cos) = (40.0 * time).to_radians().sin_cos();
        let [x, y] = [speed * cos, -speed * sin];
        let fixed = model(&format!("[air]\nwind = [{x:e}, {y:e}, 0]\n"), run).unwrap();
        let [found, expected] = [residual(&driven, time), residual(&fixed, 0.0)];
        let largest = expected.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-12 * largest, "{time}");
        }
    }
}

#[test]
fn gusts_begin_at_their_point_and_time() {
    let text = "[air]\nwind = [20, 0, 0]\n[[air.gust]]\nshape = \"one minus cosine\"\n\
                velocity = [0, 0, 5]\nlength = 40\nstart = 3\nat = [10, 0, 0]\n";
    let gust = air(text);
    assert_near(velocity(&gust, [10.0, 7.0, 0.0], 3.0), [20.0, 0.0, 0.0]);
    assert_near(velocity(&gust, [10.0, 7.0, 0.0], 4.0), [20.0, 0.0, 5.0]);
    assert_near(velocity(&gust, [30.0, 7.0, 0.0], 5.0), [20.0, 0.0, 5.0]);
    assert_eq!(gust.wind().next_corner(&Vector3::zeros(), 0.0), 2.5);
    let text = "[air]\nwind = [0, 0, 2]\n[[air.gust]]\nshape = \"sharp edge\"\n\
                velocity = [1, 0, 0]\ndirection = [0, 3, 0]\nspeed = 10\n\
                [[air.gust]]\nshape = \"harmonic\"\nvelocity = [0, 4, 0]\n\
                direction = [0, 0, -1]\nspeed = 5\nlength = 20\nstart = 1\n";
    let two = air(text);
    assert_near(velocity(&two, [0.0, 20.0, -9.0], 1.9), [0.0, 0.0, 2.0]);
    assert_near(velocity(&two, [0.0, 20.0, -9.0], 2.1), [1.0, 0.0, 2.0]);
    let behind = 5.0 * (2.0 - 1.0) - 2.0;
    let sine = 4.0 * (TAU * behind / 20.0).sin();
    assert_near(velocity(&two, [0.0, 90.0, -2.0], 2.0), [0.0, sine, 2.0]);
    assert_refused(&[
        (
            "[[air.gust]]\nshape = \"sharp edge\"\nvelocity = [0, 1, 0]\n",
            &[
                "\"speed\" is missing, which a gust where the mean wind is zero at time zero needs",
                "a.toml:3",
            ],
        ),
        (
            "[[air.gust]]\nshape = \"harmonic\"\n",
            &["\"velocity\"", "[[air.gust]] number 1"],
        ),
        (
            "[[air.gust]]\nshape = \"harmonic\"\nvelocity = [0, 1, 0]\n",
            &["\"length\" is missing, which a gust of this shape needs"],
        ),
        (
            "[[air.gust]]\nshape = \"step\"\nvelocity = [0, 1, 0]\nlength = 0\n",
            &["a.toml:3", "\"sharp edge\"", "a.toml:5"],
        ),
        (
            "[[air.gust]]\nshape = \"sharp edge\"\nvelocity = [0, 1, 0]\ndirection = [0, 0, 0]\nspeed = 1\n",
            &["a.toml:5", "not zero"],
        ),
    ]);
}

#[test]
fn gusts_go_with_the_wind_by_default() {
    // By default with the wind, also where it blows along the vertical: 8 m a second.
    for wind in [
        [0.0, 0.0, 8.0],
        [0.0, 0.0, -8.0],
        [0.0, 8.0, 0.0],
        [4.8, 0.0, 6.4],
    ] {
        let axial = air(&format!(
            "[air]\nwind = {wind:?}\n[[air.gust]]\nshape = \"sharp edge\"\nvelocity = [1, 0, 0]\n"
        ));
        let [before, behind] = [15.9, 16.1].map(|along| wind.map(|w| w * along / 8.0));
        assert_near(velocity(&axial, behind, 2.0), wind);
        assert_near(
            velocity(&axial, before, 2.0),
            [wind[0] + 1.0, wind[1], wind[2]],
        );
    }
}

#[test]
fn events_are_scaled_by_the_speed_at_the_hub() {
    let turbine = IecTurbine {
        class: WindClass::Two,
        category: TurbulenceCategory::B,
        hub_height: 90.0,
        diameter: 126.0,
    };
    let of = |kind: &str, more: &str| {
        air(&format!(
            "[air.wind]\nspeed = 12.5\nreference_height = 90\nexponent = 0.2\n[air.event]\n\
             kind = \"{kind}\"\nclass = \"II\"\ncategory = \"B\"\nhub_height = 90\n\
             diameter = 126\nstart = 5\n{more}"
        ))
    };
    let shapes = [
        ("EOG", turbine.operating_gust(12.5)),
        ("EDC", turbine.direction_change(12.5, 1.0)),
        ("ECD", turbine.coherent_gust(12.5, 1.0)),
        ("EWS vertical", turbine.vertical_shear(12.5, 1.0)),
        ("EWS horizontal", turbine.horizontal_shear(12.5, 1.0)),
    ];
    for (kind, shape) in shapes {
        let air = of(kind, "");
        assert_eq!(air.wind().events[0].shape, shape, "{kind}");
        assert_eq!(air.wind().events[0].start, 5.0);
    }
    let reversed = of("EDC", "reversed = true\n");
    let shape = turbine.direction_change(12.5, -1.0);
    assert_eq!(reversed.wind().events[0].shape, shape);
    let event = "kind = \"EOG\"\nhub_height = 90\ndiameter = 126\n";
    let wind = "[air]\nwind = [9, 0, 0]\n";
    assert_refused(&[
        (
            &format!("[air.event]\n{event}class = \"I\"\ncategory = \"A\"\n"),
            &["\"speed\" is 0 m/s at the hub", "positive"],
        ),
        (
            &format!("{wind}[air.event]\n{event}class = \"S\"\ncategory = \"S\"\n"),
            &["\"reference_speed\" is missing", "\"intensity\" is missing"],
        ),
        (
            &format!(
                "{wind}[air.event]\n{event}class = \"I\"\ncategory = \"A\"\nintensity = 0.2\n"
            ),
            &["\"intensity\" has no effect"],
        ),
        (
            &format!("{wind}[air.event]\n{event}"),
            &["\"class\"", "\"category\""],
        ),
    ]);
}

#[test]
fn boxes_of_all_formats() {
    // The files have the same numbers; the tests of their readers compare the values.
    let bts = air("[air.turbulence]\nfile = \"own.bts\"\nshift = 24\n");
    let box_of = |air: &Air| *air.wind().boxes[0].grid();
    let grid = box_of(&bts);
    assert_eq!((grid.planes, grid.lateral, grid.vertical), (20, 5, 7));
    assert_eq!(bts.wind().boxes[0].shift(), 24.0);
    let wnd = air("[air.turbulence]\nfile = \"own.wnd\"\nhub_height = 84\nperiodic = true\n");
    assert_eq!(box_of(&wnd).bottom, 60.0);
    assert!(box_of(&wnd).periodic);
    let mann = air("[air]\nwind = [6, 0, 0]\n[air.turbulence]\n\
                    files = [\"own_20x5x7.u\", \"own_20x5x7.u\", \"own_20x5x7.u\"]\n\
                    points = [20, 5, 7]\nspacing = [3, 10, 8]\nhub_height = 84\ncache = 4\n");
    assert_eq!((box_of(&mann).speed, box_of(&mann).time_step), (6.0, 0.5));
    let [u, v, _] = velocity(&mann, [0.0, 0.0, 84.0], 1.0);
    assert!(
        (u - v - 6.0).abs() < 1e-12,
        "the mean wind is added: {u} {v}"
    );
    let extended = air("[air.turbulence]\nfile = \"own.bts\"\noutside = \"extend\"\n");
    let high = Vector3::new(0.0, 0.0, 900.0);
    assert!(extended.wind().sample(&high, 0.0).is_ok());
    assert!(bts.wind().sample(&high, 0.0).is_err());
}

#[test]
fn wrong_boxes() {
    assert_refused(&[
        (
            "[air.turbulence]\ncache = 5\n",
            &["\"file\" is missing", "\"files\""],
        ),
        (
            "[air.turbulence]\nfile = \"none.bts\"\n",
            &["a.toml:3", "none.bts", "own.bts"],
        ),
        (
            "[air.turbulence]\nfile = \"expected.json\"\n",
            &[".bts or .wnd"],
        ),
        (
            "[air.turbulence]\nfile = \"own.bts\"\nfiles = [\"own.wnd\"]\n",
            &["\"files\" has no effect"],
        ),
        (
            "[air.turbulence]\nfile = \"own.bts\"\npoints = [1, 2, 3]\nsigma = [1, 1, 1]\n",
            &["\"points\" has no effect", "\"sigma\" has no effect"],
        ),
        (
            "[air.turbulence]\nfile = \"own.bts\"\nhub_height = 9\n",
            &["\"hub_height\" has no effect"],
        ),
        (
            "[air]\nwind = [9, 0, 0]\n[air.turbulence]\nfile = \"own.bts\"\n",
            &[
                "\"speed\" is 9 m/s in the wind of [air]",
                "the file contains it",
            ],
        ),
        (
            "[air]\nwind = [9, 0, 0]\n[air.turbulence]\nfiles = [\"own_20x5x7.u\"]\n",
            &[
                "three files",
                "\"points\" is missing",
                "\"hub_height\" is missing",
            ],
        ),
        (
            "[air]\nwind = [9, 0, 0]\n[air.turbulence]\npoints = [20, 5.5, 7]\n\
             spacing = [1, 1, 1]\nhub_height = 50\nperiodic = true\n\
             files = [\"own_20x5x7.u\", \"own_20x5x7.u\", \"own_20x5x7.u\"]\n",
            &["three whole numbers", "\"periodic\" has no effect"],
        ),
        (
            "[air]\nwind = [9, 0, 0]\n[air.turbulence]\npoints = [20, 5, 8]\n\
             spacing = [1, 1, 1]\nhub_height = 50\n\
             files = [\"own_20x5x7.u\", \"own_20x5x7.u\", \"own_20x5x7.u\"]\n",
            &["2800 bytes", "\"files\" of [air.turbulence]"],
        ),
        (
            "[air.turbulence]\nfile = \"own.wnd\"\nsummary = \"none.sum\"\n",
            &["none.sum"],
        ),
    ]);
}

#[test]
fn towers_change_the_wind_around_them() {
    let text = "[air.wind]\nspeed = 10\nground = [5, 0, -80]\n[[air.tower]]\n\
                heights = [0, 80]\ndiameters = [8, 4]\n";
    let tower = air(text);
    // stagnation at the surface upwind, twice the speed beside
    assert_near(velocity(&tower, [1.0, 0.0, -80.0], 0.0), [0.0; 3]);
    assert_near(velocity(&tower, [5.0, 4.0, -80.0], 0.0), [20.0, 0.0, 0.0]);
    let moved = air(&format!(
        "{text}foot = [7, 0, 33]\nshadow = \"Powles\"\ndrag = 0.5\n"
    ));
    assert_near(velocity(&moved, [3.0, 0.0, -80.0], 0.0), [0.0; 3]);
    let tables = "[[air.tower]]\nheights = [0, 80]\ndiameters = [4, 4]\n";
    assert_refused(&[
        (
            "[[air.tower]]\nheights = [0, 80]\ndiameters = [8]\n",
            &["a.toml:4", "a list of 1", "2, one for each height"],
        ),
        (
            "[[air.tower]]\nheights = [0, 0]\ndiameters = [8, -2]\n",
            &["ascending heights", "radius of the tower"],
        ),
        (
            &format!("{tables}shadow = \"Eames\"\n"),
            &["\"drag\" is missing", "\"intensity\" is missing"],
        ),
        (
            &format!("{tables}potential = \"Bak\"\n"),
            &["\"drag\" is missing"],
        ),
    ]);
}

/// A blade of 20 m in the air.
fn blade(more: &str) -> String {
    let station = |at: f64| format!("{{ at = {at}, chord = 1, airfoil = \"thin\" }}");
    format!(
        "{STRIP}[hub]\ncenter = [0, 0, 84]\n[[blade]]\nname = \"b\"\nproperties = \"strip\"\n\
         piece = [{{ length = 20, elements = 2 }}]\n{more}[blade.aerodynamics]\n\
         section = \"quasi_steady\"\nstations = [{}, {}]\n",
        station(0.0),
        station(20.0)
    )
}

fn model(air: &str, analyses: &str) -> Result<crate::input::Input, String> {
    let text = format!("units = \"SI\"\n{air}{}{analyses}", blade(""));
    read_beside(&text, &[])
}

#[test]
fn rotors_have_no_steady_state_in_a_wind_that_varies() {
    let [modes, at_rest] = ["[modes]\nspeeds = [0, 12]\n", "[modes]\nspeeds = [0]\n"];
    let shear = "[air.wind]\nspeed = 8\nreference_height = 84\nexponent = 0.2\n";
    let across = "[air]\nwind = [3, 0, -8]\n";
    for (wind, words) in [
        (
            shear,
            &["a.dynamics.toml:2", "shear or veer", "up to 12 rpm"][..],
        ),
        (
            across,
            &["a.dynamics.toml:3", "3 m/s across the axis", "[transient]"],
        ),
    ] {
        let shown = reported(model(wind, modes));
        assert!(words.iter().all(|word| shown.contains(word)), "{shown}");
        assert!(model(wind, at_rest).is_ok());
        assert!(model(wind, "[transient]\nto = 1\nstep = 0.1\n").is_ok());
    }
    assert!(model("[air]\nwind = [0, 0, -8]\n", modes).is_ok());
    // without strips the wind has no effect
    let vacuum = format!(
        "units = \"SI\"\n{across}{STRIP}[[blade]]\nname = \"b\"\nproperties = \"strip\"\n\
         piece = [{{ length = 20, elements = 2 }}]\n{modes}"
    );
    assert!(read_beside(&vacuum, &[]).is_ok());
}

#[test]
fn a_box_must_be_as_large_as_the_rotor() {
    let run = "[transient]\nto = 1\nstep = 0.1\n";
    let file = |name: &str| format!("[air.turbulence]\nfile = \"{BOXES}/{name}\"\n");
    // half width 20 m, 60 m to 108 m, a duration of 4.75 s
    let input = model(&format!("{}shift = 24\n", file("own.bts")), run);
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    let system = &input.model.system;
    let state = State::at_rest(system.nodes(), system.numbering());
    let mut conditions = Conditions::at_rest();
    conditions.loading.air = 1.0;
    assert!(system.first_without_value(&state, &conditions).is_none());
    conditions.loading.time = 10.0;
    let (element, why) = system.first_without_value(&state, &conditions).unwrap();
    assert!(element.label().contains("strip 1"));
    assert!(
        why.contains("no turbulence") && why.contains("longer box"),
        "{why}"
    );
    assert!(system.without_value(&state, &conditions).is_some());
    let shown = reported(model(&file("own.bts"), "[transient]\nto = 9\nstep = 0.1\n"));
    assert!(
        shown.contains("a.dynamics.toml:3: turbulence box")
            && shown.contains("the duration is 4.75 s, expected at least")
            && shown.contains("longer box"),
        "{shown}"
    );
    let low = format!("{}hub_height = 100\nperiodic = true\n", file("own.wnd"));
    let shown = reported(model(&low, run));
    assert!(
        shown.contains("the bottom is 76 m, expected at most 64 m"),
        "{shown}"
    );
    assert!(model(&format!("{low}outside = \"extend\"\n"), run).is_ok());
}
