//! Flaps of rigid wings against closed forms, and problems of flaps.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use rotor_aero::airfoil::PlainFlap;

use crate::input::Input;
use crate::input::test_files::{read_beside, reported};
use crate::model::{Equation, NODE_UNKNOWNS};

const SPEED: f64 = 40.0;
const CHORD: f64 = 0.8;
const SPAN: f64 = 3.0;

/// A wing along y from its root at the node, in a wind against x that rises by 3 deg: span along y,
/// forward x, so that `y x x = -z` is the upper surface; therefore it goes to -y.
fn wing(airfoil: &str, flaps: &str, more: &str) -> Result<Input, String> {
    let (sin, cos) = 3_f64.to_radians().sin_cos();
    let text = format!(
        "units = \"SI\"\n{more}[air]\ndensity = 1.2\n\
         wind = [{:e}, 0, {:e}]\n[[node]]\nname = \"wing\"\nposition = [0, 0, 0]\n[[body]]\nnode = \"wing\"\nmass = 1\n\
         inertia = [1, 1, 1]\n\
         [[strip]]\nnode = \"wing\"\nfrom = [0, 0, 0]\nto = [0, -{SPAN}, 0]\nforward = [1, 0, 0]\n\
         section = \"quasi_steady\"\n{flaps}\
         stations = [{{ at = 0, chord = {CHORD}, airfoil = \"{airfoil}\" }}, \
         {{ at = {SPAN}, chord = {CHORD}, airfoil = \"{airfoil}\" }}]\n\
         [transient]\nto = 5\nstep = 0.1\n",
        -SPEED * cos,
        SPEED * sin
    );
    read_beside(&text, &[("flapped.csv", TABLE)])
}

/// A table of two deflections: lift `3 sin a + 2 delta` at -180, -20, 3 and 180 deg, and the
/// moment -0.5 delta.
const TABLE: &str = "\
airfoil,flap [deg],alpha [deg],cl [-],cd [-],cm [-]
f,-10,-180,-0.349065850398866,0.01,0.0872664625997165
f,-10,-20,-1.3751262803758721,0.01,0.0872664625997165
f,-10,3,-0.192057981670034,0.01,0.0872664625997165
f,-10,180,-0.349065850398866,0.01,0.0872664625997165
f,10,-180,0.349065850398866,0.01,-0.0872664625997165
f,10,-20,-0.6769945795781402,0.01,-0.0872664625997165
f,10,3,0.506073719127698,0.01,-0.0872664625997165
f,10,180,0.349065850398866,0.01,-0.0872664625997165
";

/// Force and moment of the air on the node at rest at a time [N, N m].
fn loads(input: &Input, time: f64) -> [Vector3<f64>; 2] {
    let system = &input.model.system;
    let mut conditions = input.model.conditions(0.0, 0.0, 0.0);
    conditions.loading.time = time;
    let residual = system.residual(&system.rest(), &conditions).values;
    let node = &residual[..NODE_UNKNOWNS];
    [Equation::Force, Equation::Moment].map(|kind| {
        let row = kind.row();
        Vector3::from_row_slice(&node[row..row + 3])
    })
}

/// Loads of a part of the wing with coefficients of lift, drag and moment: lift is normal to the
/// wind, at the quarter chord, which is the line; nose up is about -y.
fn part([from, to]: [f64; 2], [lift, drag, moment]: [f64; 3]) -> [Vector3<f64>; 2] {
    let (sin, cos) = 3_f64.to_radians().sin_cos();
    let load = 0.5 * 1.2 * SPEED * SPEED * CHORD * (to - from);
    let force = load * (lift * Vector3::new(sin, 0.0, cos) + drag * Vector3::new(-cos, 0.0, sin));
    let arm = Vector3::new(0.0, -0.5 * (from + to), 0.0);
    [
        force,
        arm.cross(&force) - Vector3::y() * (load * CHORD * moment),
    ]
}

/// The relative error is the one of the rounded speed, (0.01 / 40)^2 / 2 = 3e-8.
#[track_caller]
fn assert_loads(found: [Vector3<f64>; 2], parts: &[[Vector3<f64>; 2]]) {
    for (k, found) in found.iter().enumerate() {
        let expected: Vector3<f64> = parts.iter().map(|part| part[k]).sum();
        assert!(
            (found - expected).norm() < 1e-6 * expected.norm(),
            "{found} {expected}"
        );
    }
}

/// A thin rigid wing with a plain flap on a part of its span that follows a ramp: at 100 times
/// `c_l = 2 pi atan(tan alpha + tau delta)` and `c_m = -mu delta cos^2 alpha` there, the thin airfoil
/// elsewhere.
#[test]
fn a_plain_flap_of_a_rigid_wing() {
    let ramp = "[drives.d]\nkind = \"ramp\"\nfrom = -10\nto = 15\nstart = 1\nend = 4\n";
    let flaps = "flaps = [{ from = 0.5, to = 1.7, deflection = \"d\", chord = 0.25 }]\n";
    let input = wing("thin", flaps, ramp).unwrap_or_else(|problems| panic!("{problems}"));
    let plain = PlainFlap::new(0.25).unwrap();
    let alpha = 3_f64.to_radians();
    for k in 0..100 {
        let time = 0.05 * f64::from(k);
        let degrees = -10.0 + 25.0 * ((time - 1.0) / 3.0).clamp(0.0, 1.0);
        let delta = degrees.to_radians();
        let turned = (alpha.tan() + plain.effectiveness() * delta).atan();
        let moment = -plain.moment() * delta * alpha.cos().powi(2);
        assert_loads(
            loads(&input, time),
            &[
                part([0.0, 0.5], [TAU * alpha, 0.0, 0.0]),
                part([0.5, 1.7], [TAU * turned, 0.0, moment]),
                part([1.7, SPAN], [TAU * alpha, 0.0, 0.0]),
            ],
        );
    }
    assert_eq!(input.model.next_corner(0.0), 1.0);
}

/// A table with deflections of -10 and 10 deg, linear between them; two flaps.
#[test]
fn flaps_of_tables() {
    let table = "[airfoils.f]\nfile = \"flapped.csv\"\n";
    let flaps = "flaps = [{ from = 0, to = 1, deflection = \"= 4*t\" }, \
                 { from = 1, to = 3, deflection = -2 }]\n";
    let input = wing("f", flaps, table).unwrap_or_else(|problems| panic!("{problems}"));
    let lift = 3.0 * 3_f64.to_radians().sin();
    for k in 0..=20 {
        let time = 0.1 * f64::from(k);
        let [first, second] = [4.0 * time, -2.0].map(f64::to_radians);
        let coefficients = |delta: f64| [lift + 2.0 * delta, 0.01, -0.5 * delta];
        assert_loads(
            loads(&input, time),
            &[
                part([0.0, 1.0], coefficients(first)),
                part([1.0, SPAN], coefficients(second)),
            ],
        );
    }
}

#[test]
fn wrong_flaps_are_reported() {
    let table = "[airfoils.f]\nfile = \"flapped.csv\"\n";
    let flap = |keys: &str| format!("flaps = [{{ {keys} }}]\n");
    for (airfoil, flaps, words) in [
        (
            "thin",
            flap("from = 1, to = 4, deflection = 2, chord = 0.2"),
            ["from 1 m to 4 m", "0 m to 3 m"],
        ),
        (
            "thin",
            flap("from = 2, to = 1, deflection = 2, chord = 0.2"),
            ["from 2 m to 1 m", "after the beginning"],
        ),
        (
            "thin",
            flap("from = 1, to = 2, deflection = 2, chord = 1.2"),
            ["1.2 of the chord", "at most 1"],
        ),
        (
            "thin",
            flap("from = 1, to = 2, deflection = 2, chord = -0.2"),
            ["\"chord\"", "-0.2"],
        ),
        (
            "thin",
            flap("from = 1, to = 2, deflection = 2"),
            ["linear lift", "chord = PART"],
        ),
        (
            "thin",
            flap("from = 1, to = 2, chord = 0.2, deflection = \"none\""),
            ["unknown drive \"none\"", "deflection"],
        ),
        (
            "thin",
            flap("from = 1, to = 2, chord = 0.2"),
            ["has no \"deflection\"", "an angle"],
        ),
        (
            "f",
            flap("from = 1, to = 2, deflection = 12"),
            ["12 deg", "-10 to 10 deg"],
        ),
        (
            "thin",
            "flaps = [{ from = 0, to = 2, deflection = 1, chord = 0.2 }, \
             { from = 1, to = 3, deflection = 1, chord = 0.2 }]\n"
                .to_owned(),
            ["begins at 1 m", "2 m, the end of the flap before it"],
        ),
    ] {
        let shown = reported(wing(airfoil, &flaps, table));
        assert!(
            words.iter().all(|word| shown.contains(word)) && shown.contains("a.dynamics.toml:"),
            "{flaps}: {shown}"
        );
    }
}
