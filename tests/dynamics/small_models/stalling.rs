//! Dynamic stall of a section in a model: loops of a pitching body against the equations of the
//! section alone, steady states against the table, and modes.

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector, Vector3};
use rotor_aero::airfoil::{Flow, Section, built_in};
use rotor_aero::strip::{
    ActingAir, FLOW, LOADS, STATES, SectionModel, Strip, StripDesign, StripJacobian,
};
use rotor_aero::wind::Atmosphere;

use super::models::run;
use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::input::{self, Input};

const SPEED: f64 = 50.0;
const CHORD: f64 = 1.0;
const SPAN: f64 = 2.0;
/// Mean angle and amplitude [rad].
const MEAN: f64 = 10.0 / 360.0 * TAU;
const AMPLITUDE: f64 = 8.0 / 360.0 * TAU;
/// Reduced frequency of 0.1: `k V / (c/2)` [rad/s].
const OMEGA: f64 = 0.1 * SPEED / (0.5 * CHORD);
const STEP: f64 = TAU / OMEGA / 400.0;
/// Two cycles.
const STEPS: usize = 800;

/// A wing along -y with its quarter chord at a node, in a wind against x.
fn wing(node: &str, twist: f64) -> String {
    format!(
        "[air]\nwind = [-{SPEED}, 0, 0]\n[[strip]]\nname = \"wing\"\nnode = \"{node}\"\n\
         from = [0, 1, 0]\nto = [0, -1, 0]\nforward = [1, 0, 0]\nsection = \"dynamic_stall\"\n\
         strips = 1\nstations = [\n\
         {{ at = 0, chord = {CHORD}, twist = {twist}, airfoil = \"naca0012\" }},\n\
         {{ at = {SPAN}, chord = {CHORD}, twist = {twist}, airfoil = \"naca0012\" }}]\n"
    )
}

/// A body that pitches about the y axis, nose up about -y, by a driven joint. It has hardly any
/// inertia: the reactions of the joint are the loads of the air.
fn pitching() -> Input {
    let angle = format!("= {}*sin({OMEGA}*t)", AMPLITUDE.to_degrees());
    let text = format!(
        "units = \"SI\"\n[[node]]\nname = \"body\"\nposition = [0, 0, 0]\n\
         [[body]]\nnode = \"body\"\nmass = 1e-3\ninertia = [1e-6, 1e-6, 1e-6]\n\
         [[joint]]\nname = \"drive\"\nkind = \"revolute\"\nnodes = [\"body\"]\n\
         axis = [0, -1, 0]\nangle = \"{angle}\"\n{}\
         [transient]\nto = {:e}\nstep = {STEP:e}\n",
        wing("body", MEAN.to_degrees()),
        STEPS as f64 * STEP
    );
    input::parse(&text, "stall.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"))
}

fn strip() -> Strip {
    Strip::new(StripDesign {
        chord: CHORD,
        section: Section::single(Arc::new(built_in("naca0012").unwrap())),
        model: SectionModel::of_word("dynamic_stall").unwrap(),
        inflow: None,
        radial_drag: false,
    })
}

/// The flow at a time.
fn flow(time: f64) -> [f64; FLOW] {
    let (sin, cos) = (MEAN + AMPLITUDE * (OMEGA * time).sin()).sin_cos();
    let rate = AMPLITUDE * OMEGA * (OMEGA * time).cos();
    let mut numbers = [0.0; FLOW];
    numbers[..4].copy_from_slice(&[SPEED * cos, -SPEED * sin, 0.0, rate]);
    numbers[5] = 1.0;
    numbers
}

/// Loads per length over time of the section alone, by two-step backward differences with `parts`
/// steps in each step of the run, from the steady flow at the mean angle.
fn alone(parts: usize) -> Vec<[f64; LOADS]> {
    let still = Atmosphere::default();
    let air = ActingAir {
        still: &still,
        part: 1.0,
    };
    let strip = strip();
    let size = strip.states().len();
    let step = STEP / parts as f64;
    let mut start = vec![0.0; size];
    strip.settle(air, &flow(0.0), &mut start);
    let mut past = [DVector::from_vec(start.clone()), DVector::from_vec(start)];
    let mut loads = Vec::new();
    for i in 1..=STEPS * parts {
        let at = flow(i as f64 * step);
        let base = (&past[0] * 4.0 - &past[1]) / 3.0;
        let mut states = past[0].clone();
        let mut found = StripJacobian::of_values([0.0; LOADS + STATES]);
        for _ in 0..30 {
            let rates = (&states - &base) * (1.5 / step);
            found = strip.linearize(air, &at, states.as_slice(), rates.as_slice());
            let rows = DVector::from_fn(size, |row, _| found.values[LOADS + row]);
            let matrix = DMatrix::from_fn(size, size, |row, k| {
                let by = &found.by[LOADS + row];
                by[FLOW + k] + by[FLOW + STATES + k] * 1.5 / step
            });
            let change = matrix.lu().solve(&rows).unwrap();
            states -= &change;
            if change.amax() < 1e-11 * (1.0 + states.amax()) {
                break;
            }
        }
        past = [states, past[0].clone()];
        if i % parts == 0 {
            loads.push(std::array::from_fn(|k| found.values[k]));
        }
    }
    loads
}

/// Lift and moment of the run are the ones of the section alone. The momenta of the added mass jump
/// at the start, where the body begins to turn: the first 20 steps are left out. The step of the run
/// is 1/400 of a cycle, at which the vortex is shed within some ten steps: 0.3 % of the largest lift
/// and moment.
#[test]
fn a_pitching_body_has_the_loop_of_its_section() {
    let input = pitching();
    let (kept, outcome) = run(&input.model, &input.transient.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let expected = alone(4);
    let mut largest = [0.0_f64; 2];
    let mut errors = [0.0_f64; 2];
    let instants = kept.times.iter().zip(&kept.states);
    for (i, (time, state)) in instants.enumerate().skip(20) {
        let conditions = input.model.conditions_at(*time);
        let observed = input.model.system.observe(state, &conditions);
        let reaction = &observed.reactions[0];
        let (sin, cos) = (MEAN + AMPLITUDE * (OMEGA * time).sin()).sin_cos();
        let loads = expected[i - 1];
        let [along, normal] = [loads[0], loads[1]].map(|load| SPAN * load);
        // Airfoil axes: x forward, y up.
        let lift = along * sin + normal * cos;
        let pairs = [
            (-reaction.force.z, lift),
            (reaction.moment.y, SPAN * loads[3]),
        ];
        for (k, (found, expected)) in pairs.into_iter().enumerate() {
            largest[k] = largest[k].max(expected.abs());
            errors[k] = errors[k].max((found - expected).abs());
        }
    }
    for k in 0..2 {
        assert!(errors[k] < 0.003 * largest[k], "{errors:?} {largest:?}");
    }
    // It stalls: the vortex lifts more than the largest static lift.
    let load = 0.5 * Atmosphere::default().density * SPEED * SPEED * CHORD * SPAN;
    assert!(largest[0] > 1.5 * load, "{}", largest[0] / load);
}

/// A body of a hinge about y with a stiffness [N m/rad] on the ground.
fn on_a_spring(stiffness: f64, air: &str) -> String {
    format!(
        "units = \"SI\"\n[[node]]\nname = \"ground\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"body\"\nposition = [0, 0, 0]\n\
         [[clamp]]\nnode = \"ground\"\n[[body]]\nnode = \"body\"\nmass = 20\n\
         inertia = [3, 3, 3]\n[[hinge]]\nname = \"pivot\"\nnodes = [\"ground\", \"body\"]\n\
         axis = [0, 1, 0]\nstiffness = {stiffness:e}\n{air}"
    )
}

/// Steady states from attached flow to deep stall, where the vortex is on the way all the time, and
/// in reverse flow have the loads of the table, to the error of the rounded speed.
#[test]
fn steady_states_have_the_loads_of_the_table() {
    let still = Atmosphere::default();
    let airfoil = built_in("naca0012").unwrap();
    let load = 0.5 * still.density * SPEED * SPEED * CHORD * SPAN;
    for k in 0..=24 {
        let degrees = 7.5 * f64::from(k);
        let text = on_a_spring(1e11, &wing("body", degrees)) + "[static]\n";
        let input = input::parse(&text, "stall.dynamics.toml").unwrap();
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(
            outcome.failure.is_none(),
            "{degrees}: {:?}",
            outcome.failure
        );
        // The reactions of the hinge on both nodes cancel.
        let reactions = outcome.result.steps[0].reactions.iter();
        let sum = reactions.map(|one| [one.force, one.moment]);
        let [force, moment] = sum.fold([Vector3::zeros(); 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
        let it = airfoil.at(&Flow {
            alpha: degrees.to_radians(),
            mach: SPEED / still.sound_speed,
            reynolds: SPEED * CHORD * still.density / still.viscosity,
            flap: 0.0,
        });
        let expected = Vector3::new(-it.drag, 0.0, it.lift) * load;
        let error = (force + expected).norm() / load;
        assert!(error < 1e-6, "{degrees}: {error}");
        let moment = (moment.y - it.moment * load * CHORD).abs();
        assert!(moment < 1e-6 * load, "{degrees}: {moment}");
    }
}

/// A body on a spring in pitch with the section in light and deep stall: an equilibrium and modes.
/// Where the flow is attached the mode is the one of `lagged`, to the stiffness of separated flow,
/// below 1e-3.
#[test]
fn modes_of_a_body_on_a_spring() {
    let of = |section: &str, twist: f64| {
        let air = wing("body", twist).replace("dynamic_stall", section);
        let text = on_a_spring(2e4, &air) + "[modes]\nspeeds = [0]\ncount = 1\n";
        let input = input::parse(&text, "stall.dynamics.toml").unwrap();
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none(), "{twist}: {:?}", outcome.failure);
        let point = outcome.table.at_speed(0)[0].1;
        [point.growth, TAU * point.frequency]
    };
    for twist in [12.0, 16.0, 25.0] {
        let [growth, frequency] = of("dynamic_stall", twist);
        assert!(
            growth.is_finite() && frequency > 10.0,
            "{twist}: {growth} {frequency}"
        );
    }
    let (found, expected) = (of("dynamic_stall", 2.0), of("lagged", 2.0));
    for (found, expected) in found.iter().zip(expected) {
        assert!(
            (found - expected).abs() < 1e-3 * expected.abs(),
            "{found} {expected}"
        );
    }
}
