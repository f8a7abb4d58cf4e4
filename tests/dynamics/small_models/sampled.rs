//! Systems that sample, against exact samples; runs of them that are continued.
//!
//! Sources: `theory-control/sensors_sampling.json`, a second program from the equations: an
//! oscillator (m 1, c 0.2, k 40, gains 15 and 2.5, T = 0.05 s) by its exact map from sample to
//! sample, and a pendulum as an index-3 problem under a held force (T = 0.1 s). The errors listed
//! there are errors of the trapezoid rule with new rates at samples; the bound is 20 % larger.

use nalgebra::{DMatrix, Matrix3, Vector3};
use shared_geom::expression::{Expression, Names};

use super::models::{Kept, body, node, revolute_about_z, run};
use beam_dynamics::analysis::transient::transient;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::elements::control::{Limits, Matrices, Sampled, Sampling, StateSpace};
use beam_dynamics::elements::laws::Law;
use beam_dynamics::elements::loads::{LoadFactor, NodalForce, NodalLoad, Turning};
use beam_dynamics::elements::springs::{Spring, SpringLaw};
use beam_dynamics::elements::{
    Axes, Element, Input, NodeQuantity, NodeReading, NodeVector, Part, Sensor, Signal,
};
use beam_dynamics::integrator::{Scheme, StepControl, Stepping};
use beam_dynamics::model::{Drive, Formula, Node, Quantity, Scalar};

const OSCILLATOR: [f64; 11] = [
    1.0,
    0.932_047_327_4,
    0.745_368_514_7,
    0.478_802_173_9,
    0.177_606_333_9,
    -0.113_412_589_9,
    -0.355_927_670_4,
    -0.522_554_28,
    -0.599_320_427_5,
    -0.586_036_178_9,
    -0.494_751_112_4,
];
const DELAYED: [f64; 11] = [
    1.0,
    0.950_579_874_5,
    0.789_320_240_9,
    0.521_736_262_8,
    0.192_870_763_7,
    -0.143_273_020_5,
    -0.434_920_812_9,
    -0.640_542_733_8,
    -0.734_533_688_7,
    -0.710_054_425_2,
    -0.578_813_455_1,
];
const PENDULUM: [f64; 11] = [
    0.5,
    0.476_652_828_2,
    0.435_140_222_1,
    0.392_755_299_3,
    0.309_555_333_3,
    0.198_432_146_9,
    0.122_489_604,
    0.056_161_851_16,
    -0.031_802_822_87,
    -0.082_197_523_83,
    -0.079_976_977_51,
];

/// A force along x on node 0, times a signal.
fn force(nodes: &[Node], size: f64, signal: Signal) -> Box<dyn Element> {
    let force = NodalForce {
        force: size * Vector3::x(),
        moment: Vector3::zeros(),
        offset: Vector3::zeros(),
        turning: Turning::Dead,
        factor: LoadFactor::Constant,
    };
    Box::new(NodalLoad::new("force", 0, &nodes[0], force).driven(signal))
}

fn input(scalar: &Scalar) -> Input {
    Input {
        scalar: scalar.clone(),
        unit: 1.0,
    }
}

/// A sensor of the component along x of a vector of node 0.
pub(super) fn sensor(label: &str, vector: NodeVector, nodes: &[Node]) -> (Scalar, Sensor) {
    let quantity = NodeQuantity {
        node: 0,
        vector,
        part: Part::Component(0),
        against: None,
        axes: Axes::Model,
    };
    let scalar = Sensor::output(label, Quantity::new(label, "-", 1.0));
    let reading = NodeReading::new(&quantity, nodes);
    (scalar.clone(), Sensor::new(label, scalar, reading))
}

/// The expression of time and of the scalars `a`, `b`, as many as there are.
pub(super) fn signal(text: &str, scalars: &[&Scalar]) -> Signal {
    let names = &["t", "a", "b"][..=scalars.len()];
    let names = Names {
        variables: names,
        constants: &[],
    };
    let expression = Expression::parse(text, &names).unwrap();
    let inputs = scalars.iter().map(|scalar| input(scalar)).collect();
    Signal::sensing(expression, inputs, [1.0, 1.0])
}

/// A law without states that samples, with its output.
fn law(
    gains: &[f64],
    inputs: Vec<Signal>,
    sampling: Sampling,
    limits: Limits,
) -> (Scalar, Sampled) {
    let output = StateSpace::output("law", "y");
    let gain = Matrices::gain(DMatrix::from_row_slice(1, gains.len(), gains));
    let outputs = vec![(output.clone(), limits)];
    let sampled = Sampled::new("law", (gain, sampling), inputs, outputs, Vec::new());
    (output, sampled)
}

/// The oscillator, which begins at its undeformed position with the displacement one: the spring
/// has the displacement x - 1, and a load of -40 N compensates its offset.
fn oscillator(delay: usize, limits: Limits) -> Model {
    let nodes = vec![node("mass", Vector3::x(), Matrix3::identity())];
    let sensors = [
        sensor("place", NodeVector::Position, &nodes),
        sensor("speed", NodeVector::Velocity, &nodes),
    ];
    let sampling = Sampling {
        period: 0.05,
        offset: 0.0,
        delay,
    };
    let inputs = sensors.each_ref().map(|(scalar, _)| signal("a", &[scalar]));
    let (output, sampled) = law(&[-15.0, -2.5], inputs.into(), sampling, limits);
    let spring = SpringLaw::of_displacement(Law::linear(40.0 * Matrix3::identity()));
    let spring = Spring::new(
        "spring",
        (&[0], &nodes),
        &Vector3::x(),
        &Matrix3::identity(),
        spring,
    );
    let speed = signal("-0.2*a - 40", &[&sensors[1].0]);
    let mut elements = vec![
        body(0, 1.0, Vector3::zeros(), [1.0; 3]),
        Box::new(spring) as Box<dyn Element>,
        force(&nodes, 1.0, speed),
        force(&nodes, 1.0, signal("a", &[&output])),
        Box::new(sampled),
    ];
    elements.extend(sensors.map(|(_, sensor)| Box::new(sensor) as Box<dyn Element>));
    Model::new("oscillator", System::new(nodes, elements))
}

fn pendulum() -> Model {
    let position = Vector3::new(0.5_f64.sin(), -0.5_f64.cos(), 0.0);
    let nodes = vec![node("bob", position, Matrix3::identity())];
    let sampling = Sampling {
        period: 0.1,
        offset: 0.0,
        delay: 0,
    };
    let text = "4*sin(17*t) + 2*mod(floor(10*t + 0.5), 3)";
    let names = Names {
        variables: &["t"],
        constants: &[],
    };
    let formula = Formula::new(Expression::parse(text, &names).unwrap(), 1.0);
    let inputs = vec![Signal::Drive(Drive::Formula(std::sync::Arc::new(formula)))];
    let (output, sampled) = law(&[1.0], inputs, sampling, Limits::default());
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [0.0; 3]),
        revolute_about_z(&nodes, 0),
        force(&nodes, 1.0, signal("a", &[&output])),
        Box::new(sampled),
    ];
    let mut model = Model::new("pendulum", System::new(nodes, elements));
    model.gravity = -9.81 * Vector3::y();
    model
}

fn constant(scheme: Scheme, to: f64, step: f64) -> TransientSettings {
    TransientSettings {
        scheme,
        ..TransientSettings::new(to, step)
    }
}

/// The largest error of `found` of a state at the samples of `period`.
fn error(
    model: &Model,
    settings: &TransientSettings,
    (period, exact): (f64, &[f64]),
    found: impl Fn(&beam_dynamics::model::State) -> f64,
) -> f64 {
    let (Kept { times, states, .. }, outcome) = run(model, settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let errors = exact.iter().enumerate().map(|(k, exact)| {
        let time = k as f64 * period;
        let index = times.iter().position(|own| (own - time).abs() < 1e-9);
        (found(&states[index.unwrap()]) - exact).abs()
    });
    errors.fold(0.0, f64::max)
}

// Second order, since rates are computed again after each sample.
#[test]
fn a_sampled_law_is_followed_to_second_order() {
    let of_position = |state: &beam_dynamics::model::State| state.nodes[0].position.x;
    let model = oscillator(0, Limits::default());
    for scheme in [Scheme::CrankNicolson, Scheme::TwoStep { radius: 0.6 }] {
        let mut before = None;
        for (steps, listed) in [
            (5.0, 9.1e-4),
            (10.0, 2.3e-4),
            (20.0, 5.8e-5),
            (40.0, 1.45e-5),
        ] {
            let settings = constant(scheme, 0.5, 0.05 / steps);
            let found = error(&model, &settings, (0.05, &OSCILLATOR), of_position);
            assert!(
                found < 1.2 * listed,
                "{scheme:?} {steps}: {found:e} {listed:e}"
            );
            if let Some(before) = before.replace(found) {
                let order = (before / found).log2();
                assert!(order > 1.8, "{scheme:?} {steps}: {order}");
            }
        }
    }
    let settings = constant(Scheme::CrankNicolson, 0.5, 0.05 / 20.0);
    let model = oscillator(1, Limits::default());
    let found = error(&model, &settings, (0.05, &DELAYED), of_position);
    assert!(found < 1.2 * 1.07e-4, "{found:e}");
}

// Index 3: the constraint force jumps with the held force.
#[test]
fn a_held_force_on_a_constrained_mass_is_followed_to_second_order() {
    let angle = |state: &beam_dynamics::model::State| {
        let position = &state.nodes[0].position;
        position.x.atan2(-position.y)
    };
    for (steps, listed) in [
        (5.0, 5.72e-4),
        (10.0, 1.45e-4),
        (20.0, 3.64e-5),
        (40.0, 9.12e-6),
    ] {
        let settings = constant(Scheme::CrankNicolson, 1.0, 0.1 / steps);
        let found = error(&pendulum(), &settings, (0.1, &PENDULUM), angle);
        assert!(found < 1.2 * listed, "{steps}: {found:e} {listed:e}");
    }
}

// Steps that would pass over samples end at them.
#[test]
fn variable_steps_land_on_samples() {
    let of_position = |state: &beam_dynamics::model::State| state.nodes[0].position.x;
    for scheme in [
        Scheme::TwoStep { radius: 0.6 },
        Scheme::Parabolic { zeta: -2.0 / 3.0 },
    ] {
        let control = StepControl {
            first: 1e-3,
            least: 1e-9,
            most: 0.2,
            tolerance: 1e-6,
        };
        let settings = TransientSettings {
            scheme,
            stepping: Stepping::Variable(control),
            ..TransientSettings::new(0.5, 1e-3)
        };
        let model = oscillator(0, Limits::default());
        let found = error(&model, &settings, (0.05, &OSCILLATOR), of_position);
        // About a hundred steps of the tolerance.
        assert!(found < 1e-4, "{scheme:?} {found:e}");
    }
}

// The requested output jumps to -15 and to -6.5: the output falls by 60/s, 3 per sample, to -4.
#[test]
fn outputs_are_limited_in_position_and_rate() {
    let limits = Limits {
        range: [-4.0, 5.0],
        rate: 60.0,
    };
    let (kept, _) = run(
        &oscillator(0, limits),
        &constant(Scheme::CrankNicolson, 0.3, 0.01),
    );
    let outputs = |time: f64| {
        let index = kept.times.iter().position(|own| (own - time).abs() < 1e-9);
        kept.states[index.unwrap()].scalars.clone()
    };
    for (time, expected) in [(0.01, -3.0), (0.05, -3.0), (0.06, -4.0), (0.10, -4.0)] {
        let all = outputs(time);
        let is_there = all.iter().any(|value| (value - expected).abs() < 1e-12);
        assert!(is_there, "{time}: {all:?} {expected}");
    }
}

// Stopped after any of the first thirty steps, samples among them, and continued.
#[test]
fn a_run_with_samples_is_continued_bit_for_bit() {
    let variable = Stepping::Variable(StepControl {
        first: 1e-3,
        least: 1e-9,
        most: 0.02,
        tolerance: 1e-5,
    });
    for (model, stepping) in [
        (
            oscillator(0, Limits::default()),
            Stepping::Constant { step: 0.01 },
        ),
        (oscillator(2, Limits::default()), variable),
        (pendulum(), Stepping::Constant { step: 0.02 }),
    ] {
        for wanted in 1..30 {
            let settings = TransientSettings {
                stepping,
                ..TransientSettings::new(0.8, 0.01)
            };
            let mut whole = Kept {
                wanted: Some(wanted),
                ..Kept::default()
            };
            let outcome = transient(&model, &settings, None, &mut whole, &|| 0.0);
            assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
            let mut rest = Kept::default();
            transient(
                &model,
                &settings,
                whole.snapshot.as_ref(),
                &mut rest,
                &|| 0.0,
            );
            assert!(rest.states[..] == whole.states[wanted + 1..], "{wanted}");
        }
    }
}
