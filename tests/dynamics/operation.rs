//! Remarks on operating points that are plausible for no rotor, in statics and in runs in time.

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::analysis::transient::transient;
use beam_dynamics::input::{self, Input};
use beam_dynamics::result::{AcceptedStep, Recorder};

/// A recorder that keeps nothing.
struct Nothing;

impl Recorder for Nothing {
    fn record(&mut self, _accepted: &AcceptedStep<'_>) -> bool {
        true
    }
}

/// A turbine of 20 m with the axis along x, in a wind along x, with other cards.
fn turbine(wind: f64, rotor: &str, cards: &str) -> Input {
    let text = format!(
        "[units]\nangle = \"deg\"\n\
         [properties.spar]\nea = 7e9\ngay = 2e9\ngaz = 2e9\ngj = 3e8\neiy = 2e9\neiz = 4e9\nm = 60\n\
         iy = 1\niz = 10\n\
         [air]\ndensity = 1.225\nwind = [{wind:?}, 0, 0]\n\
         [[rotor]]\nname = \"r\"\nhub = \"rigid\"\nblades = 3\nmass = 100\ninertia = [9, 9, 9]\n{rotor}\
         [rotor.inflow]\nkind = \"uniform\"\n\
         [rotor.blade]\nhub_radius = 1\nproperties = \"spar\"\n\
         piece = [{{ length = 19, elements = 1 }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 3\nstations = [\n\
         {{ at = 1, chord = 2, twist = -12, airfoil = \"naca0012\" }},\n\
         {{ at = 19, chord = 1, airfoil = \"naca0012\" }} ]\n{cards}"
    );
    let parsed = input::parse(&text, "turbine.dynamics.toml");
    parsed.unwrap_or_else(|problems| panic!("{problems}\n{text}"))
}

const HUB: &str = "axis = [1, 0, 0]\naft = [0, 0, 1]\nspeed = \"30 rpm\"\n";

/// The remarks of a static analysis.
fn in_statics(wind: f64, cards: &str) -> Vec<String> {
    let input = turbine(wind, HUB, &format!("[static]\nspeed = \"30 rpm\"\n{cards}"));
    let outcome = statics(&input.model, input.statics.as_ref().unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.result.remarks
}

/// The remarks of a run in time of a rotor.
fn in_time(wind: f64, rotor: &str, keys: &str) -> Vec<String> {
    let run = "to = 0.2\nstep = 0.02\n";
    let input = turbine(wind, rotor, &format!("[transient]\n{run}{keys}"));
    let settings = input.transient.as_ref().unwrap();
    let outcome = transient(&input.model, settings, None, &mut Nothing, &|| 0.0);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.remarks
}

/// Words of turbines.
const WIND: &str = "[modes]\nwords = \"wind\"\nspeeds = [\"30 rpm\"]\n";
/// A shaft at a constant speed, and one that a torque starts, both on a nacelle.
const MOUNTED: &str = "speed = \"30 rpm\"\n[rotor.nacelle]\noverhang = 2\n";
const STARTED: &str = "torque = 1e5\n[rotor.nacelle]\noverhang = 2\n";
const STEADY: &str = "start = \"rotating\"\nspeed = \"30 rpm\"\n";

/// Checks that there is one remark with a text.
fn one(remarks: &[String], expected: &str) {
    assert!(
        remarks.len() == 1 && remarks[0].contains(expected),
        "{expected}: {remarks:?}"
    );
}

// The tips move at 62.8 m/s: ratios of 6.3 to the wind of a turbine, 0.31, and 63, which is no remark without the
// words of turbines.
#[test]
fn wrong_wind_is_remarked_in_statics_and_in_time() {
    let all = |wind: f64| {
        [
            in_statics(wind, WIND),
            in_time(wind, HUB, STEADY),
            in_time(wind, MOUNTED, ""),
        ]
    };
    for remarks in all(10.0) {
        assert_eq!(remarks, Vec::<String>::new());
    }
    for remarks in all(-10.0) {
        one(&remarks, "is against the axis of rotation");
    }
    for remarks in all(200.0) {
        one(&remarks, "m/s in air of 200 m/s, a ratio of 0.314");
    }
    let [fast, without_words, mounted] = all(1.0);
    one(&fast, "expected less than 20 of a turbine");
    assert_eq!(without_words, Vec::<String>::new());
    one(
        &mounted,
        "at 2 of 2 points, first at t = 0 s: the tips move",
    );
}

// A start-up begins at rest: its slow tips are no wrong unit.
#[test]
fn a_start_up_has_no_remark() {
    assert_eq!(in_time(10.0, STARTED, ""), Vec::<String>::new());
}
