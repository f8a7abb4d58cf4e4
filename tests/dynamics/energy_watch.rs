//! Energy input of a run in time, and unexplained gain of energy.

use std::fs;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::case::TransientSettings;

use crate::effort::cases;
use crate::in_time::{Run, gain};
use crate::record;

const UNITS: &str =
    r#"units = { length = "m", force = "N", angle = "rad", rotation_speed = "rad/s" }"#;

/// A run of cards, which include its settings.
fn run(cards: &str, change: impl FnOnce(&mut TransientSettings)) -> Run {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("watched.dynamics.toml");
    fs::write(&path, format!("{UNITS}\n{cards}")).unwrap();
    let input = beam_dynamics::input::read(&path).unwrap_or_else(|problems| panic!("{problems}"));
    let mut settings = input.transient.unwrap();
    change(&mut settings);
    Run::of_any(input.model, &settings, usize::MAX)
}

/// An aluminum strip of 40 x 10 x 400 mm, pushed at its tip for a millisecond.
const STRIP: &str = r#"
[properties.p]
ea = 2.8e7
gay = 8.974e6
gaz = 8.974e6
gj = 302.4
eiy = 233.3
eiz = 3733
m = 1.08
iy = 9e-6
iz = 1.44e-4
[[blade]]
name = "b"
properties = "p"
FORMULATION
[[blade.piece]]
length = 0.4
elements = 4
[[load]]
node = "b/tip"
force = [0, 50, 500]
drive = "= if(t<0.001,1,0)"
"#;

/// A soft beam, pushed at its tip for a fiftieth of a second.
const SOFT: &str = r#"
[properties.p]
ea = 1e6
gay = 1e5
gaz = 1.2e5
gj = 10
eiy = 11
eiz = 30
m = 1.1
iy = 1e-3
iz = 2e-3
[[blade]]
name = "soft"
properties = "p"
FORMULATION
[[blade.piece]]
length = 0.8
elements = 4
[[load]]
node = "soft/tip"
force = [0, 0, 8]
drive = "= if(t<0.02,1,0)"
"#;

const FINITE_VOLUME: &str = "formulation = \"finite-volume\"";

/// Finite volumes gain energy, 0.096 J to more than 1000 J here: time, input, location and cause
/// are reported. The variational beam conserves the input.
#[test]
fn energy_that_a_formulation_makes_is_reported() {
    let time = "[transient]\nto = 0.2\nstep = 2e-5\n";
    let text = |formulation: &str| SOFT.replace("FORMULATION", formulation) + time;
    let outcome = run(&text(FINITE_VOLUME), |_| {}).outcome;
    let reported = gain(&outcome).unwrap();
    println!("{reported}\n{:?}", outcome.energy);
    assert!(outcome.failure.is_none());
    assert!(
        reported.contains("in the beams of blade \"soft\""),
        "{reported}"
    );
    assert!(
        reported.contains("use formulation = \"variational\""),
        "{reported}"
    );
    assert!(outcome.energy.growth > 100.0 && outcome.energy.put_in < 0.2);
    let kept = run(&text(""), |_| {}).outcome;
    println!("{:?}", kept.energy);
    assert_eq!(gain(&kept), None);
    let off = (kept.energy.growth / kept.energy.put_in - 1.0).abs();
    let case = "soft beam after a push";
    record::largest(
        "closed form",
        case,
        "energy, relative to the input",
        off,
        0.01,
    );
    assert!(off < 0.01, "{:?}", kept.energy);
}

/// The growing modes of the strip are beyond the ten listed ones: a remark reports them, their
/// damping, and the cause; the variational strip has none.
#[test]
fn modes_with_negative_damping_are_reported_beyond_those_listed() {
    let remarks = |formulation: &str, count: usize| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("strip.dynamics.toml");
        let cards = STRIP.replace("FORMULATION", formulation);
        let requested = format!("[modes]\nspeeds = 0\ncount = {count}\n");
        fs::write(&path, format!("{UNITS}\n{cards}{requested}")).unwrap();
        let input = beam_dynamics::input::read(&path).unwrap();
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none());
        let remarks = outcome.table.remarks.into_iter();
        remarks
            .filter(|remark| remark.contains("negative damping"))
            .collect::<Vec<_>>()
    };
    for (count, position) in [
        (10, "negative damping beyond the listed ones"),
        (48, "2 modes have negative"),
    ] {
        let found = remarks(FINITE_VOLUME, count);
        assert_eq!(found.len(), 1, "{found:?}");
        for words in [
            position,
            "the damping ratio is -2.50e-2",
            "\"finite-volume\"",
        ] {
            assert!(found[0].contains(words), "{found:?}");
        }
        assert!(remarks("", count).is_empty());
    }
}

/// The strip in four elements gains 1e10 J from 2 J until the run ends, and the likely cause is not
/// a locked mechanism. A remark reports it before.
#[test]
fn energy_that_a_formulation_makes_is_the_cause_of_a_failure() {
    let strip = |formulation: &str, [to, step]: [f64; 2]| {
        let time = format!("[transient]\nto = {to}\nstep = {step:e}\n");
        run(&(STRIP.replace("FORMULATION", formulation) + &time), |_| {}).outcome
    };
    let outcome = strip(FINITE_VOLUME, [0.0027, 2e-6]);
    assert!(outcome.failure.is_none());
    let reported = gain(&outcome).unwrap();
    println!("{reported}\n{:?}", outcome.energy);
    assert!(
        reported.contains("in the beams of blade \"b\""),
        "{reported}"
    );
    assert!(
        reported.contains("use formulation = \"variational\""),
        "{reported}"
    );
    let outcome = strip(FINITE_VOLUME, [0.01, 4e-6]);
    let failure = outcome.failure.as_ref().unwrap();
    let (text, remedy) = (failure.to_string(), failure.remedy());
    println!("{text}\n{remedy}");
    let cause = text.split_once("likely cause: ").unwrap().1;
    assert!(cause.starts_with("from t = "), "{text}");
    assert!(cause.contains("negative damping"), "{text}");
    assert!(remedy.contains("variational"), "{remedy}");
    let mut remarks = outcome.remarks.iter();
    assert!(!remarks.any(|remark| remark.contains("the energy grows")));
    let kept = strip("", [0.0015, 2e-6]);
    println!("{:?}", kept.energy);
    assert_eq!(gain(&kept), None);
    assert!(kept.failure.is_none());
    let off = (kept.energy.growth / kept.energy.put_in - 1.0).abs();
    let case = "strip after a push";
    record::largest(
        "closed form",
        case,
        "energy, relative to the input",
        off,
        0.01,
    );
    assert!(off < 0.01, "{:?}", kept.energy);
}

/// A pendulum of 1 m, released level.
const PENDULUM: &str = r#"
[[node]]
name = "bob"
position = [1, 0, 0]
[[body]]
node = "bob"
mass = 1
inertia = [0.01, 0.01, 0.01]
[[joint]]
kind = "revolute"
nodes = ["bob"]
at = [0, 0, 0]
axis = [0, 0, 1]
[gravity]
acceleration = [0, -9.81, 0]
[transient]
"#;

/// The energy of a scheme without damping alternates, since it does not damp errors of reactions;
/// an amplitude of 9 % of the 9.81 J of the swing is reported. With the radius 0.6 the energy stays.
#[test]
fn small_gains_of_schemes_without_damping_are_reported() {
    let reported = |radius: f64| {
        let time = format!("to = 5.12\nstep = 0.01\nradius = {radius}\n");
        let outcome = run(&(PENDULUM.to_owned() + &time), |_| {}).outcome;
        assert!(outcome.failure.is_none());
        gain(&outcome)
    };
    let text = reported(1.0).unwrap();
    for words in ["until 5.11 s by 0.90", "this scheme has no damping"] {
        assert!(text.contains(words), "{text}");
    }
    assert_eq!(reported(0.6), None);
}

const BODY: &str = r#"
[[node]]
name = "a"
position = [1, 0, 0]
velocity = [0, 0.3, 0]
[[body]]
node = "a"
mass = 2
inertia = [0.3, 0.4, 0.5]
"#;

const SPRUNG: &str = r#"
[[spring]]
node = "a"
stiffness = [40, 60, 80]
rotational_stiffness = [5, 6, 7]
"#;

/// Elements that supply or absorb energy, one by one.
const EXCHANGES: [(&str, &str); 11] = [
    (
        "forced and damped oscillator",
        "[[spring]]\nnode = \"a\"\nstiffness = [40, 60, 80]\ndamping = [1, 2, 3]\n\
         rotational_stiffness = [5, 6, 7]\nrotational_damping = [0.2, 0.3, 0.1]\n\
         [[load]]\nnode = \"a\"\nforce = [3, 4, -2]\nmoment = [0.5, 0, 0.2]\n\
         drive = \"= sin(5*t)\"",
    ),
    (
        "dead load",
        "SPRUNG[[load]]\nnode = \"a\"\nforce = [3, 4, -2]\noffset = [0.1, 0.2, 0]",
    ),
    (
        "follower load",
        "SPRUNG[[load]]\nnode = \"a\"\nforce = [3, 4, -2]\nmoment = [0.3, 1, 0.4]\n\
         offset = [0.1, 0.2, 0]\nfollower = true",
    ),
    (
        "load that is switched",
        "SPRUNG[[load]]\nnode = \"a\"\nforce = [3, 4, -2]\ndrive = \"= if(t < 0.4, 1, -0.5)\"",
    ),
    (
        "driven joint",
        "[gravity]\nacceleration = [0, -9.81, 0]\n\
         [[joint]]\nkind = \"revolute\"\nnodes = [\"a\"]\nat = [0, 0, 0]\naxis = [0, 0, 1]\n\
         angle = \"= 0.3*t + 0.2*sin(3*t)\"",
    ),
    (
        "joint whose speed jumps",
        "[[joint]]\nkind = \"revolute\"\nnodes = [\"a\"]\nat = [0, 0, 0]\naxis = [0, 0, 1]\n\
         angle = \"= 0.3*t + 2*max(0, t - 0.5)\"",
    ),
    (
        "rod of driven length",
        "[[rod]]\nnodes = [\"a\"]\nat = [0, 0, 0]\nlength = \"= 0.8 + 0.1*sin(4*t)\"\n\
         law = [{ kind = \"linear\", stiffness = 50 }, { kind = \"viscous\", viscosity = 1 }]",
    ),
    (
        "law by an expression",
        "[[spring]]\nnode = \"a\"\n\
         law = { kind = \"expression\", force = { x = \"= 40*x + 9*x^3 + x_rate\", y = \"= 50*y\", z = \"= 30*z*(1 + t)\" } }\n\
         rotational_stiffness = [5, 6, 7]",
    ),
    (
        "gravity that is switched on",
        "SPRUNG[gravity]\nacceleration = [0, -4, -9.81]\ndrive = \"= if(t < 0.3, 0.2, 1 + sin(2*t))\"",
    ),
    (
        "constant gravity",
        "SPRUNG[gravity]\nacceleration = [0, -4, -9.81]",
    ),
    ("nothing", "SPRUNG"),
];

/// The growth of the energy is the input less the output, up to the square of the step: half the
/// step gives a quarter of the difference.
#[test]
fn the_energy_grows_by_what_is_put_in() {
    for (case, cards) in EXCHANGES {
        let cards = BODY.to_owned() + &cards.replace("SPRUNG", SPRUNG);
        let balance = |step: f64| {
            let time = format!("\n[transient]\nto = 1\nstep = {step}\nnewton.tolerance = 1e-12\n");
            let outcome = run(&(cards.clone() + &time), |_| {}).outcome;
            assert!(
                outcome.failure.is_none(),
                "{case}: {}",
                outcome.failure.unwrap()
            );
            assert_eq!(gain(&outcome), None, "{case}");
            outcome.energy
        };
        let balances = [4e-3, 2e-3, 1e-3].map(balance);
        let apart = balances.map(|b| b.growth - b.put_in + b.taken_out);
        println!("{case}: {apart:?} {:?}", balances[2]);
        let size = balances[2].put_in.max(balances[2].taken_out).max(0.1);
        let off = apart[2].abs() / size;
        record::largest("closed form", "balance of energy", case, off, 1e-4);
        assert!(off < 1e-4, "{case}: {apart:?}");
        let order = (apart[1] / apart[2]).log2();
        let is_round_off = apart[2].abs() < 1e-9 * size;
        assert!(order > 1.7 || is_round_off, "{case}: order {order}");
    }
}

/// A blade on a flap hinge that a force lifts, and a pitch link with `delta_3`.
const COUPLED: &str = r#"
[properties.spar]
ea = 7e8
gay = 2e8
gaz = 2e8
gj = 3e6
eiy = 2e6
eiz = 4e6
m = 6
iy = 1e-2
iz = 1e-1
[[rotor]]
name = "r"
hub = "articulated"
blades = 1
speed = 30
[[rotor.hinge]]
kind = "flap"
offset = 0.2
[rotor.swashplate]
collective = "= 0.1"
[rotor.pitch_link]
stiffness = 2e4
delta_3 = 0.6
[rotor.blade]
hub_radius = 0.5
properties = "spar"
piece = [{ length = 4.8, elements = 1 }]
[[load]]
node = "r 1/tip"
force = [0, 0, 1]
drive = "= 4e4*sin(30*t)"
"#;

/// The moments of a pitch-flap coupling are sensed, and their work is in the balance. The elastic energy of the
/// link without its coupling is `k (tan(delta_3) beta)^2 / 2`, to which the work is nearly opposite: the balance is
/// off by less than 1 % of it, the energy that the scheme takes from fast motions, which falls with the step.
#[test]
fn the_work_of_a_coupling_is_in_the_balance() {
    let ends = [400, 800].map(|steps| {
        let step = 0.08 / f64::from(steps);
        let text = format!("{UNITS}\n{COUPLED}[transient]\nto = 0.08\nstep = {step}\n");
        let input = beam_dynamics::input::parse(&text, "coupled.dynamics.toml");
        let input = input.unwrap_or_else(|problems| panic!("{problems}"));
        let run = Run::of_any(input.model, &input.transient.unwrap(), steps as usize);
        assert!(run.outcome.failure.is_none(), "{:?}", run.outcome.failure);
        let nodes = run.model.system.nodes();
        let tip = nodes.iter().position(|node| node.label == "r 1/tip");
        let (_, end) = run.instants.last().unwrap();
        let sine = end.nodes[tip.unwrap()].position.z / 5.1;
        let link = 0.5 * 2e4 * (0.6_f64.tan() * sine.asin()).powi(2);
        let balance = run.outcome.energy;
        let apart = balance.growth - balance.put_in + balance.taken_out;
        println!("{step}: {apart} of {link} J, {balance:?}");
        [apart, link]
    });
    let [[coarse, _], [fine, link]] = ends;
    assert!(fine.abs() < 0.01 * link, "{ends:?}");
    assert!(fine.abs() < 0.6 * coarse.abs(), "{ends:?}");
}

/// Numbers between zero and one, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Between `from` and `to`, logarithmically uniform.
    fn between(&mut self, from: f64, to: f64) -> f64 {
        from * (to / from).powf(self.next())
    }

    fn one_of<'a>(&mut self, of: &[&'a str]) -> &'a str {
        of[(self.next() * of.len() as f64) as usize]
    }
}

/// A blade on a clamp or a damped hinge with a body at its tip, loads, optional weight and damping,
/// and steps that resolve few or many of its waves.
fn random_beam(numbers: &mut Numbers) -> String {
    let [ei, width, elements] = [0; 3].map(|_| numbers.next());
    let (ei, elements) = (10.0 * 100.0_f64.powf(ei), 1 + (4.0 * elements) as usize);
    let (ea, mass) = (numbers.between(1e3, 1e5) * ei, numbers.between(0.1, 3.0));
    let eiz = ei * (1.0 + 5.0 * width);
    let damping = numbers.one_of(&["", "damping = { time = 1e-3 }", "damping = { time = 1e-5 }"]);
    let inertia = numbers.one_of(&["consistent", "lumped"]);
    let root = numbers.one_of(&[
        "",
        "hinges = [{ kind = \"flap\", offset = 0.1, stiffness = 20, damping = 0.5 }]",
        "hinges = [{ kind = \"flap\", offset = 0.1 }, { kind = \"lag\", damping = 2 }]",
    ]);
    let [force, frequency] = [numbers.between(0.1, 20.0), numbers.between(3.0, 300.0)];
    let drive = match numbers.one_of(&["sine", "push", "steady"]) {
        "sine" => format!("drive = \"= sin({frequency}*t)\""),
        "push" => format!("drive = \"= if(t < {}, 1, 0)\"", 3.0 / frequency),
        _ => String::new(),
    };
    let follower = numbers.one_of(&["true", "false"]);
    let weight = numbers.one_of(&["", "[gravity]\nacceleration = [0, 3, -9.81]\n"]);
    let step = numbers.between(2e-5, 5e-3);
    let to = 200.0 * step;
    let scheme = numbers.one_of(&[
        "two-step",
        "two-step",
        "bdf2",
        "radau-iia",
        "implicit-euler",
    ]);
    format!(
        "[properties.p]\nea = {ea}\ngay = {}\ngaz = {}\ngj = {ei}\neiy = {ei}\neiz = {eiz}\n\
         m = {mass}\niy = {}\niz = {}\n{damping}\n\
         [[blade]]\nname = \"b\"\nproperties = \"p\"\ninertia = \"{inertia}\"\nhub_radius = 0.1\n{root}\n\
         [[blade.piece]]\nlength = 0.8\nelements = {elements}\n\
         [[body]]\nnode = \"b/tip\"\nmass = 0.2\ninertia = [0.01, 0.02, 0.02]\n\
         [[load]]\nnode = \"b/tip\"\nforce = [1, {force}, {force}]\nfollower = {follower}\n{drive}\n\
         {weight}[transient]\nto = {to}\nstep = {step}\nscheme = \"{scheme}\"\n",
        0.3 * ea,
        0.4 * ea,
        1e-4 * mass,
        2e-4 * mass,
    )
}

/// No gain is reported for fifty beams whose steps resolve some of their waves.
#[test]
fn no_beam_is_said_to_gain_energy() {
    let mut numbers = Numbers(7);
    let mut ended = 0;
    for i in 0..cases(50) {
        let cards = random_beam(&mut numbers);
        let outcome = run(&cards, |_| {}).outcome;
        assert_eq!(
            gain(&outcome),
            None,
            "beam {i}\n{cards}\n{:?}",
            outcome.energy
        );
        ended += usize::from(outcome.failure.is_none());
    }
    println!("{ended} ran to their end");
    assert!(ended > cases(46), "{ended}");
}
