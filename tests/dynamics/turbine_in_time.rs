//! The NREL 5 MW turbine in time, in the complete model: a step of the pitch with a dynamic wake, and the
//! control of pitch and torque in constant wind. One stiff blade represents three.

use std::fmt::Write as _;

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::elements::RotorAir;
use beam_dynamics::input;

use crate::air_output::rows;
use crate::record;
use crate::trim::reference as json;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/aero/nrel5mw");

/// The turbine in a wind [m/s] with lines of its inflow and of its blade; the blade has a mass [kg/m].
fn turbine((wind, mass): (f64, f64), inflow: &str, blade: &str) -> String {
    let table = std::fs::read_to_string(format!("{FOLDER}/blade.csv")).unwrap();
    let lines = table.lines().filter(|line| !line.starts_with('#')).skip(1);
    let stations: Vec<(f64, f64, f64, &str)> = lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |i: usize| cells[i].parse().unwrap();
            (number(0), number(1), number(2), cells[3])
        })
        .collect();
    // The blade from the hub to the tip.
    let ends = [(1.5, stations[0]), (63.0, stations[stations.len() - 1])];
    let [first, last] = ends.map(|(radius, (_, chord, twist, name))| (radius, chord, twist, name));
    let all = std::iter::once(first).chain(stations).chain([last]);
    let (mut airfoils, mut list, mut known) = (String::new(), String::new(), Vec::new());
    for (radius, chord, twist, name) in all {
        let at = radius - 1.5;
        let _ = writeln!(
            list,
            "{{ at = {at}, chord = {chord}, twist = {:?}, airfoil = \"{name}\" }},",
            -twist
        );
        if !known.contains(&name) {
            known.push(name);
            let _ = writeln!(
                airfoils,
                "[airfoils.{name}]\nfile = \"{FOLDER}/polar_{name}.csv\""
            );
        }
    }
    let half = 0.5 * mass;
    format!(
        "units = \"SI\"\n{airfoils}[air]\ndensity = 1.225\nwind = [0, 0, {wind}]\n[properties.p]\nea = 1e11\n\
         gay = 1e11\ngaz = 1e11\ngj = 1e11\neiy = 1e11\neiz = 1e11\nm = {mass}\niy = {half}\niz = {half}\n\
         [[inflow]]\nname = \"rotor\"\nblades = 3\nhub_radius = 1.5\n{inflow}\n[[blade]]\n\
         name = \"b\"\nhub_radius = 1.5\nproperties = \"p\"\n{blade}\n\
         piece = [{{ length = 61.5, elements = 1 }}]\n[blade.aerodynamics]\ninflow = \"rotor\"\n\
         section = \"quasi_steady\"\nstrips = 1\nstations = [\n{list}]\n"
    )
}

/// The turbine at 8 m/s, turned at 9.156 rpm.
fn driven(inflow: &str, blade: &str) -> String {
    turbine((8.0, 200.0), inflow, blade)
        + "[hub]\naxis = [0, 0, 1]\nmass = 1000\ninertia = [1000, 1000, 1000]\n\
           support = { torsion = 0 }\n[[joint]]\nname = \"drive\"\nkind = \"spin\"\nnodes = [\"hub\"]\n\
           axis = [0, 0, 1]\nangle = \"= 54.936 * t\"\n"
}

/// Thrust of the steady state at a pitch, nose up [deg] \[N\].
fn steady(inflow: &str, pitch: f64) -> f64 {
    let text = driven(inflow, &format!("pitch = {pitch}")) + "[static]\nspeed = 9.156\n";
    let input = input::parse(&text, "step.dynamics.toml").unwrap_or_else(|all| panic!("{all}"));
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    3.0 * RotorAir::of(&outcome.result.steps[0].air).unwrap().thrust
}

/// Time from the middle of the step of the pitch, .1 s long, until 1/e of the overshoot of the thrust is
/// left \[s\]. The overshoot is the listed one: thrusts during the step contain the turning of the blade.
fn recovery(inflow: &str, [before, dip, after]: [f64; 3]) -> f64 {
    const STEP: f64 = 0.1;
    let hinge = "hinges = [{ kind = \"pitch\", offset = 1.5, stiffness = 1e9, damping = 5e6, \
                 angle = \"= -3.7 * min(max(t - 0.2, 0) / 0.1, 1)\" }]";
    let text = driven(inflow, hinge)
        + &format!(
            "[transient]\nto = 9\nstep = {STEP}\nstart = \"rotating\"\nspeed = 9.156\n\
             [[output.column]]\nname = \"T\"\nquantity = \"thrust\"\n"
        );
    let input = input::parse(&text, "step.dynamics.toml").unwrap_or_else(|all| panic!("{all}"));
    let thrust: Vec<f64> = rows(input)
        .iter()
        .map(|row| 3.0 * row[row.len() - 1])
        .collect();
    // It begins in the steady state: the hinge yields by a hundredth of a degree.
    assert!(
        (thrust[0] / before - 1.0).abs() < 2e-3,
        "{thrust:?} {before}"
    );
    let level = after + (dip - after) / std::f64::consts::E;
    let settled = 5;
    let past = settled
        + thrust[settled..]
            .iter()
            .position(|value| *value > level)
            .unwrap();
    let share = (level - thrust[past - 1]) / (thrust[past] - thrust[past - 1]);
    (past as f64 - 1.0 + share) * STEP - 0.25
}

/// Steady thrusts are sums over Gauss points between stations; the script's trapezoidal rule over the
/// stations has 1.5 % less, and the same quotient within .3 %. The times are the ones of the two schools in
/// `rotor-aero` (6.05 s) and of the script (7.55 s for the steady one), in which time constants follow the
/// mean induction of the rotor; here each annulus has its own: 5 % are granted (found: 2 and 4.3 %).
#[test]
fn the_thrust_recovers_by_the_forcing_of_the_wake() {
    let it = json("aero/theory/dynamic_inflow.json");
    let listed = ["before", "just_after", "after"];
    let listed = listed.map(|key| 1e3 * it["pitch_step"]["T_kN"][key].as_f64().unwrap());
    let source = "independent script (dynamic_inflow.json)";
    let mut states = Vec::new();
    for (forcing, expected) in [("lagged", 6.05), ("steady", 7.55)] {
        let inflow = format!("wake = \"dynamic\"\nforcing = \"{forcing}\"");
        let [before, after] = [0.0, -3.7].map(|pitch| steady(&inflow, pitch));
        states.push([before, after]);
        let case = format!("step of the pitch in the complete model, forcing {forcing}");
        for (name, found, expected, within) in [
            ("thrust before [N]", before, listed[0], 0.02),
            (
                "thrust after over before [-]",
                after / before,
                listed[2] / listed[0],
                3e-3,
            ),
        ] {
            let error = (found / expected - 1.0).abs();
            record::value(source, &case, name, [found, expected], error, within);
            assert!(error < within, "{case}: {name} {found} {expected}");
        }
        let dip = before * listed[1] / listed[0];
        let time = recovery(&inflow, [before, dip, after]);
        let error = (time / expected - 1.0).abs();
        record::value(
            source,
            &case,
            "time to 1/e [s]",
            [time, expected],
            error,
            0.05,
        );
        assert!(error < 0.05, "{case}: {time} {expected}");
    }
    // The same steady states.
    for (lagged, steady) in states[0].iter().zip(&states[1]) {
        assert!((lagged / steady - 1.0).abs() < 1e-8, "{states:?}");
    }
}

/// The control of `aero/nrel5mw/controller.json` above rated wind, by systems of states: the speed of the
/// generator through a filter, its deviation and the integral of it with gains that fall with the pitch,
/// and a torque of constant power. From 8 degrees of pitch the turbine settles at 15 m/s with the rated
/// speed and the published pitch; after 25 s .2 % and .2 deg are granted.
///
/// The pitch in the gains is the one of a servo with a lag of .1 s; the limits of the controller are not
/// reached. The inertia about the shaft is the one of rotor and generator, a third of it here.
#[test]
fn pitch_control_settles_at_the_rated_speed() {
    let it = json("aero/nrel5mw/controller.json");
    let number = |key: &str| it[key].as_f64().unwrap();
    let [ratio, gain, integral, scale] = ["gearbox_ratio", "PC_KP", "PC_KI", "PC_KK"].map(number);
    let [rated, corner, power] = ["PC_ref", "filter_corner_rad_s", "P_rated_mech"].map(number);
    let train = &it["drivetrain"];
    let [rotor, generator] =
        ["J_rotor_axis_approx", "J_gen_hss"].map(|key| train[key].as_f64().unwrap());
    let (mass, start) = (20.0, 8f64.to_radians());
    let inertia =
        (rotor + ratio * ratio * generator) / 3.0 - mass * (63f64.powi(3) - 1.5f64.powi(3)) / 3.0;
    let speed = rated / ratio;
    let blade = format!(
        "hinges = [{{ kind = \"pitch\", offset = 1.5, stiffness = 1e9, damping = 5e6, \
         angle = \"= 8 - p*180/pi\" }}]\npitch = -8\nangular_velocity = [0, 0, \"{speed:?} rad/s\"]\n"
    );
    let text = turbine((15.0, mass), "", &blade)
        + &format!(
            "[hub]\naxis = [0, 0, 1]\nmass = 1000\ninertia = [{inertia:?}, {inertia:?}, {inertia:?}]\n\
             support = {{ torsion = 0 }}\n[sensors.w]\nquantity = \"angular_velocity\"\nof = \"hub\"\n\
             component = \"z\"\nunit = \"rad/s\"\n[[state_space]]\nname = \"filter\"\n\
             inputs = [\"= {ratio}*w\"]\noutputs = [\"wf\"]\nnumerator = [{corner}]\n\
             denominator = [1, {corner}]\nstart = [{rated}]\n[[state_space]]\nname = \"integral\"\n\
             inputs = [\"= wf - {rated}\"]\noutputs = [\"e\"]\na = [[0]]\nb = [[1]]\nc = [[1]]\n\
             start = [{:?}]\n[[state_space]]\nname = \"pitch\"\n\
             inputs = [\"= ({gain}*(wf - {rated}) + {integral}*e)/(1 + p/{scale})\"]\noutputs = [\"p\"]\n\
             numerator = [10]\ndenominator = [1, 10]\nstart = [{start:?}]\n[[load]]\nnode = \"hub\"\n\
             moment = [0, 0, -1]\nconstant = true\ndrive = \"= {:?}/w\"\n[transient]\nto = 25\nstep = 0.1\n\
             [[output.column]]\nname = \"w\"\nquantity = \"signal\"\nof = \"w\"\n\
             [[output.column]]\nname = \"p\"\nquantity = \"signal\"\nof = \"= p*180/pi\"\n",
            start * (1.0 + start / scale) / integral,
            power / 3.0,
        );
    let input = input::parse(&text, "control.dynamics.toml").unwrap_or_else(|all| panic!("{all}"));
    let rows = rows(input);
    let published = it["pitch_for_rated"].as_array().unwrap().iter();
    let published = published.clone().find(|row| row["V"] == 15).unwrap();
    let published = published["published_deg"].as_f64().unwrap();
    // The turbine speeds up before the pitch follows.
    let largest = rows.iter().map(|row| row[0]).fold(0.0, f64::max);
    assert!((1.03..1.06).contains(&(largest / speed)), "{largest}");
    let [found, pitch] = [rows[rows.len() - 1][0], rows[rows.len() - 1][1]];
    let error = (found / speed - 1.0).abs();
    let case = "NREL 5 MW with its pitch control, 15 m/s after 25 s";
    let source = "NREL/TP-500-38060";
    record::value(source, case, "speed [rad/s]", [found, speed], error, 2e-3);
    assert!(error < 2e-3, "{found} {speed}");
    let error = (pitch - published).abs();
    record::value(source, case, "pitch [deg]", [pitch, published], error, 0.2);
    assert!(error < 0.2, "{pitch} {published}");
}
