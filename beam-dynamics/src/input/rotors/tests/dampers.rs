//! Dampers of hinges and between hub and blade against closed forms.

use nalgebra::{Complex, Vector2, Vector3};
use shared_geom::rotation::vector;
use std::f64::consts::{PI, TAU};

use super::{Run, read, refused, text};
use crate::analysis::modes::modes;
use crate::analysis::statics::statics;
use crate::input::rotors::damper_law::DamperLaw;

/// Moment of inertia of a blade of the tests about the lag hinge at its root [kg m^2].
const INERTIA: f64 = 2.0 / 3.0;

// The complex stiffness at the frequency is the given one, at rest the static stiffness.
#[test]
fn elastomers_have_their_complex_stiffness_at_the_frequency() {
    for (stiffness, loss, rest) in [(9e3, 0.5, 6e3), (4e5, 0.1, 0.0), (2.0, 1.5, 1.9)] {
        let frequency = 25.0;
        let expected = Complex::new(stiffness, loss * stiffness);
        let Some(DamperLaw::Relaxing {
            rest: found,
            series,
            time,
        }) = Some(DamperLaw::elastomer(
            [stiffness, loss],
            frequency,
            Some(rest),
        ))
        else {
            panic!("no relaxation");
        };
        let phase = Complex::new(0.0, frequency * time);
        let stiffness_there = phase * series / (phase + 1.0) + rest;
        assert!((stiffness_there - expected).norm() < 1e-12 * expected.norm());
        assert_eq!(found, rest);
        let kelvin = DamperLaw::elastomer([stiffness, loss], frequency, None);
        assert_eq!(
            kelvin,
            DamperLaw::Linear([stiffness, loss * stiffness / frequency])
        );
    }
}

/// A lag hinge with an elastomer, or with a further key.
fn hinge(more: &str) -> String {
    format!(
        "speed = 0\n[[rotor.hinge]]\nkind = \"lag\"\nstiffness = 20\ndamper = {{ stiffness = 400, \
         loss_factor = 0.4, frequency = 4{more} }}\n"
    )
}

// The eigenvalue s of a rigid blade on its lag hinge fulfils I s^2 + 20 + K(s) = 0, with K(s) the
// stiffness of the elastomer: 300 + k_1 s tau / (1 + s tau), or 400 + c s. The blade bends by 1e-5.
#[test]
fn elastomers_shift_frequency_and_damping() {
    for more in [", static_stiffness = 300", ""] {
        let input = read(&text(
            "hingeless",
            &hinge(more),
            "[modes]\nspeeds = [0]\ncount = 3\n",
        ));
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let points = outcome.table.at_speed(0).into_iter();
        let (_, lowest) = points
            .min_by(|a, b| a.1.frequency.total_cmp(&b.1.frequency))
            .unwrap();
        let s = Complex::new(lowest.growth, TAU * lowest.frequency);
        let rest = (!more.is_empty()).then_some(300.0);
        let complex = match DamperLaw::elastomer([400.0, 0.4], 4.0 * TAU, rest) {
            DamperLaw::Relaxing { rest, series, time } => {
                s * time * series / (s * time + 1.0) + rest
            }
            DamperLaw::Linear([stiffness, damping]) => s * damping + stiffness,
            DamperLaw::Curve(_) => panic!("a curve"),
        };
        let residual = (s * s * INERTIA + 20.0 + complex).norm();
        assert!(lowest.growth < -1.0 && residual < 0.02, "{s} {residual}");
    }
}

// A blade that is moved in lag with the amplitude A: in a cycle of the frequency of the elastomer its
// moment does the work pi K'' A^2, after the start has decayed: exp(-t/tau) with tau = 0.025 s.
// The trapezoidal rule is exact for harmonics.
#[test]
fn the_work_of_a_cycle_is_the_loss_stiffness() {
    const AMPLITUDE: f64 = 0.02;
    let keys = hinge(", static_stiffness = 300");
    let rest = format!(
        "[[joint]]\nkind = \"rotation\"\nnodes = [\"r/hub\", \"r 1/lag\"]\n\
         rotation = {{ z = \"= {}*sin(8*pi*t)*(1 - exp(-(20*t)^3))\" }}\n\
         [transient]\nto = 0.75\nstep = 1.25e-3\n",
        AMPLITUDE.to_degrees()
    );
    let run = Run::new(&text("hingeless", &keys, &rest).replace("blades = 3", "blades = 1"));
    let DamperLaw::Relaxing { series, time, .. } =
        DamperLaw::elastomer([400.0, 0.4], 4.0 * TAU, Some(300.0))
    else {
        panic!("no relaxation");
    };
    assert!((time - 0.0249).abs() < 1e-3, "{time}");
    let angle = |time: f64| AMPLITUDE * (8.0 * PI * time).sin();
    let cycle: Vec<_> = run
        .instants
        .iter()
        .filter(|(time, _)| *time > 0.5 - 1e-9)
        .collect();
    assert_eq!(cycle.len(), 201);
    // The scalars are the angle, the state and the moment of the spring in series.
    let count = cycle[0].1.scalars.len();
    let is = |index: usize, expected: &dyn Fn(f64, &[f64]) -> f64, scale: f64| {
        let off = |(time, state): &&&(f64, crate::model::State)| {
            (state.scalars[index] - expected(*time, &state.scalars)).abs()
        };
        cycle.iter().all(|instant| off(&instant) < 1e-6 * scale)
    };
    let sensed = (0..count)
        .find(|&index| is(index, &|time, _| angle(time), AMPLITUDE))
        .unwrap();
    let moment = (0..count).find(|&index| {
        (0..count).any(|state| {
            let law = |time: f64, all: &[f64]| series * (angle(time) - all[state]);
            state != sensed && is(index, &law, series * AMPLITUDE)
        })
    });
    let moment = moment.unwrap();
    let steps = cycle.windows(2).map(|pair| {
        let [[t0, m0], [t1, m1]] = [0, 1].map(|k| [pair[k].0, pair[k].1.scalars[moment]]);
        0.5 * (m0 + m1) * (angle(t1) - angle(t0))
    });
    let (work, expected) = (steps.sum::<f64>(), PI * 0.4 * 400.0 * AMPLITUDE * AMPLITUDE);
    assert!((work / expected - 1.0).abs() < 1e-3, "{work} {expected}");
}

/// Ends of a damper in the plane of the rotor [m].
const HUB: [f64; 2] = [0.05, -0.1];
const BLADE: [f64; 2] = [0.3, -0.08];

// A lag hinge at 0.1 m without a spring, and a spring of a line behind it: under the force F across
// the tip the blade turns until k (l - l_0) holds it, with exact geometry.
#[test]
fn a_damper_between_hub_and_blade_holds_by_its_lever() {
    let keys = format!(
        "speed = 0\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\nstiffness = 1e3\n\
         [[rotor.hinge]]\nkind = \"lag\"\n[rotor.lag_damper]\nhub = [{}, {}, 0]\n\
         blade = [{}, {}, 0]\nstiffness = 3e4\n",
        HUB[0], HUB[1], BLADE[0], BLADE[1]
    );
    let rest = "[[load]]\nnode = \"r 1/tip\"\nforce = [0, 40, 0]\nfollower = true\n[static]\n";
    let keys = keys.replace("kind = \"lag\"\n", "kind = \"lag\"\noffset = 0.1\n");
    let input = read(&text("articulated", &keys, rest));
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let nodes = input.model.system.nodes();
    let index = nodes.iter().position(|own| own.label == "r 1/lag").unwrap();
    let last = outcome.result.steps.last().unwrap();
    let turn = vector::from_rotation(&(last.rotations[index] * nodes[index].rotation.transpose()));
    let (sin, cos) = turn.z.sin_cos();
    let arm = Vector2::new(BLADE[0] - 0.1, BLADE[1]);
    let arm = Vector2::new(cos * arm.x - sin * arm.y, sin * arm.x + cos * arm.y);
    let line = arm + Vector2::new(0.1, 0.0) - Vector2::from(HUB);
    let free = (Vector2::from(BLADE) - Vector2::from(HUB)).norm();
    let tension = 3e4 * (line.norm() - free);
    let moment = tension * (arm.x * line.y - arm.y * line.x) / line.norm();
    assert!(turn.z > 0.01, "{turn}");
    assert!(
        (moment / (40.0 * 1.1) - 1.0).abs() < 1e-4,
        "{moment} {turn}"
    );
    assert!(Vector3::new(turn.x, turn.y, 0.0).norm() < 1e-9);
}

/// Wrong dampers of an articulated rotor, and the problem of each.
const WRONG: [(&str, &str); 5] = [
    (
        "damper = { stiffness = 4, loss_factor = 0.1, frequency = 3, static_stiffness = 5 }",
        "\"static_stiffness\" is 5, expected less than \"stiffness\"",
    ),
    (
        "damper = { stiffness = 4, loss_factor = 0.1 }",
        "[rotor.hinge.damper] has no \"frequency\", expected a frequency",
    ),
    (
        "[rotor.lag_damper]\nhub = [0, 0.1, 0]\nblade = [0.1, 0.1, 0]",
        "rotor \"r\" has \"lag_damper\" without \"damping\"",
    ),
    (
        "[rotor.lag_damper]\nhub = [0, 0.1, 0]\nblade = [0.1, 0.1, 0]\ndamping = 1\non = \"lag\"",
        "\"on\" of [rotor.lag_damper] is \"lag\", but rotor \"r\" has no lag hinge",
    ),
    (
        "[rotor.lag_damper]\nhub = [0, 0.1, 0]\nblade = [0.1, 0.1, 0]\nrates = [0, 1]\nforces = [1]",
        "the damper has 2 rates and 1 value under \"forces\", expected as many of each",
    ),
];

#[test]
fn wrong_dampers_are_explained() {
    for (keys, expected) in WRONG {
        let keys = format!("speed = 1\n[[rotor.hinge]]\nkind = \"flap\"\n{keys}\n");
        let shown = refused(&text(
            "articulated",
            &keys,
            "[transient]\nto = 0.1\nstep = 1e-3\n",
        ));
        assert!(shown.contains(expected), "{shown}");
    }
}

// Dampers c between neighboring blades on lag hinges at the distance e from the center: in the
// multiblade pattern h the ends of a damper, at the distance r along the blades and a behind and ahead of
// the blade axis, move along its line by `l (q_k - q_(k+1))` with the lever l of the line about the
// hinges, so that `I s^2 + k s^0 + 2 c l^2 (1 - cos(2 pi h / N)) s = 0`: the collective is not damped.
#[test]
fn dampers_between_blades_do_not_damp_the_collective_lag() {
    const HINGE: f64 = 0.05;
    const PLACE: f64 = 0.15;
    const DAMPING: f64 = 30.0;
    const STIFFNESS: f64 = 200.0;
    let keys = format!(
        "speed = 0\n[[rotor.hinge]]\nkind = \"lag\"\noffset = {HINGE}\nstiffness = {STIFFNESS}\n\
         [rotor.lag_damper]\nbetween = \"blades\"\nblade = [{PLACE}, 0, 0]\nnext = [{PLACE}, 0, 0]\n\
         damping = {DAMPING}\n"
    );
    let input = read(&text(
        "hingeless",
        &keys,
        "[modes]\nspeeds = [0]\ncount = 3\n",
    ));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    // The angle of the line against each blade is 30 degrees.
    let lever = (PLACE - HINGE) * (PI / 6.0).sin();
    // About the hinge: 2 kg/m from 0.15 m to 1.15 m behind it.
    let inertia = 2.0 / 3.0 * (1.15_f64.powi(3) - 0.15_f64.powi(3));
    let mut growths: Vec<_> = outcome
        .table
        .at_speed(0)
        .iter()
        .map(|(_, point)| point.growth)
        .collect();
    growths.sort_by(f64::total_cmp);
    let damped = -0.5 * 2.0 * DAMPING * lever * lever * 1.5 / inertia;
    for (found, expected) in growths.iter().zip([damped, damped, 0.0]) {
        assert!(
            (found - expected).abs() < 1e-3 * damped.abs(),
            "{growths:?} {damped}"
        );
    }
    let one = keys.replace("next = [0.15, 0, 0]\n", "");
    let shown = refused(&text("hingeless", &one, ""));
    assert!(
        shown.contains("rotor \"r\" has \"lag_damper\" without \"next\", expected both"),
        "{shown}"
    );
}
