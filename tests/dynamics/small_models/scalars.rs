//! Scalar unknowns in time: circuits and lags that are faster than the first step, nonlinear laws,
//! and their start.

use nalgebra::{DMatrix, Matrix3, Matrix6, Vector3, Vector6};

use super::models::{Kept, Random, node, run, states};
use beam_dynamics::analysis::transient::TransientFailure;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::elements::beams::{Beam, BeamElectrode, BeamGeometry, BeamNode, Potential};
use beam_dynamics::elements::circuits::{Circuit, Electrode};
use beam_dynamics::elements::control::{Matrices, StateSpace};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::elements::{Element, Local, LocalJacobian, LocalResidual, Signal};
use beam_dynamics::integrator::{Scheme, StepControl, Stepping};
use beam_dynamics::model::{Drive, Quantity, Scalar, ScalarSpec, ScalarStart, Step};

const SCHEMES: [Scheme; 6] = [
    Scheme::CrankNicolson,
    Scheme::Bdf2,
    Scheme::TwoStep { radius: 0.6 },
    Scheme::Cubic { radius: 0.6 },
    Scheme::Parabolic { zeta: -0.8 },
    Scheme::Parabolic { zeta: -2.0 / 3.0 },
];

fn settings(scheme: Scheme, to: f64, tolerance: f64) -> TransientSettings {
    let control = StepControl {
        first: 1e-3,
        least: 1e-12,
        most: 0.1 * to,
        tolerance,
    };
    TransientSettings {
        scheme,
        stepping: Stepping::Variable(control),
        ..TransientSettings::new(to, 1e-3)
    }
}

/// A beam whose nodes are clamped, with an electrode of 1 uF in `circuit`.
fn capacitor(circuit: Circuit) -> Model {
    let nodes = (0..3).map(|i| {
        let position = Vector3::new(0.5 * f64::from(i), 0.0, 0.0);
        node(&format!("n{i}"), position, Matrix3::identity())
    });
    let nodes: Vec<_> = nodes.collect();
    let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
    let ends = [&nodes[0], &nodes[1], &nodes[2]];
    let beam = Beam::elastic("beam", [0, 1, 2], geometry, ends, [Matrix6::identity(); 2]);
    let scalars = circuit.scalars("electrode", 1e-6);
    let electrode = BeamElectrode {
        number: 0,
        potential: Potential::Free(scalars[0].clone()),
        coupling: [Vector6::zeros(); 2],
        capacitance: 1e-6,
    };
    let per_length = DMatrix::from_element(1, 1, 1e-6);
    let beam = beam.with_electrodes(vec![electrode], [per_length.clone(), per_length]);
    let mut elements: Vec<Box<dyn Element>> = vec![
        Box::new(beam),
        Box::new(Electrode::new("electrode", 0, circuit, scalars, 1e-6)),
    ];
    for (i, own) in nodes.iter().enumerate() {
        elements.push(Box::new(clamped(&own.label, i, own)));
    }
    Model::new("capacitor", System::new(nodes, elements))
}

// 10 V through 100 Ohm: V = E (1 - exp(-t / RC)), RC = 0.1 ms, a tenth of the first step. The error
// of the charge per step is at most the tolerance times 10 V; about a hundred steps lie within the
// time in which errors decay. Previously, the charge was integrated with the step of 1 ms.
#[test]
fn a_quick_circuit_is_resolved_from_the_first_step_on() {
    let source = Drive::Step(Step {
        from: 0.0,
        to: 10.0,
        time: 0.01,
    });
    let model = capacitor(Circuit::Shunt {
        source: source.into(),
        resistance: 100.0,
        inductance: 0.0,
    });
    for scheme in SCHEMES {
        for tolerance in [1e-4, 1e-6] {
            let (Kept { times, states, .. }, outcome) =
                run(&model, &settings(scheme, 0.02, tolerance));
            assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
            let off = times.iter().zip(&states).map(|(time, state)| {
                let since = (time - 0.01).max(0.0);
                let exact = 1e-5 * (1.0 - (-since / 1e-4).exp());
                (state.scalars[1] - exact).abs() / 1e-5
            });
            let off = off.fold(0.0, f64::max);
            let early = times.iter().filter(|time| (0.01..0.0101).contains(*time));
            assert!(off < 100.0 * tolerance, "{scheme:?} {tolerance:e}: {off:e}");
            assert!(early.count() > 3, "{scheme:?} {tolerance:e}");
        }
    }
}

/// `x' + rate ( law(x) - law(rest) ) = 0`, with `law(x) = x + cubic x^3`; without rate, the
/// rest alone.
#[derive(Debug)]
struct Lag {
    scalars: [Scalar; 1],
    rate: f64,
    cubic: f64,
    rest: f64,
}

impl Lag {
    fn new(start: ScalarStart, has_rate: bool, rate: f64) -> Self {
        let scalar = Scalar::new(ScalarSpec {
            owner: "lag".to_owned(),
            unknown: Quantity::new("state", "-", 1.0),
            equation: Quantity::new("balance", "1/s", rate),
            has_rate,
            rate: None,
            start,
        });
        Self {
            scalars: [scalar],
            rate,
            cubic: 0.0,
            rest: 0.0,
        }
    }

    fn law(&self, x: f64) -> f64 {
        x + self.cubic * x.powi(3)
    }
}

impl Element for Lag {
    fn label(&self) -> &str {
        "lag"
    }

    fn nodes(&self) -> &[usize] {
        &[]
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        out.add_scalar(0, self.rate * self.law(at.scalars.values[0]));
        out.add_scalar(0, -self.rate * self.law(self.rest));
        if self.scalars[0].has_rate {
            out.add_scalar(0, at.scalars.rates[0]);
        }
        let Some(out) = jacobian else { return };
        let slope = 1.0 + 3.0 * self.cubic * at.scalars.values[0].powi(2);
        out.add_scalar(0, 0, self.rate * slope, false);
        if self.scalars[0].has_rate {
            out.add_scalar(0, 0, 1.0, true);
        }
    }
}

fn alone(element: impl Element + 'static) -> Model {
    let nodes = vec![node("fixed", Vector3::zeros(), Matrix3::identity())];
    let clamp = clamped("fixed", 0, &nodes[0]);
    let elements: Vec<Box<dyn Element>> = vec![Box::new(clamp), Box::new(element)];
    Model::new("alone", System::new(nodes, elements))
}

// x = exp(-1e4 t) from the start of a run on, where no corner requires a short step.
#[test]
fn a_quick_state_is_resolved_from_its_start_value_on() {
    for scheme in SCHEMES {
        let model = alone(Lag::new(ScalarStart::Value(1.0), true, 1e4));
        let (Kept { times, states, .. }, _) = run(&model, &settings(scheme, 0.01, 1e-5));
        assert_eq!(states[0].scalars, [1.0]);
        assert_eq!(states[0].scalar_rates, [-1e4]);
        for (time, state) in times.iter().zip(&states) {
            let off = state.scalars[0] - (-1e4 * time).exp();
            assert!(off.abs() < 1e-3, "{scheme:?} {time}: {off:e}");
        }
    }
}

// x + 3 x^3 = 2 + 24, from a first guess of zero; and a lag that begins at its rest.
#[test]
fn scalars_settle_by_newtons_method() {
    for (start, has_rate) in [
        (ScalarStart::Settled, false),
        (ScalarStart::Value(0.1), false),
        (ScalarStart::Settled, true),
    ] {
        let mut lag = Lag::new(start, has_rate, 50.0);
        (lag.cubic, lag.rest) = (3.0, 2.0);
        let model = alone(lag);
        let found = states(&model, &TransientSettings::new(0.01, 1e-3));
        for state in [&found[0], &found[found.len() - 1]] {
            assert!((state.scalars[0] - 2.0).abs() < 1e-9, "{:?}", state.scalars);
            assert!(state.scalar_rates[0].abs() < 1e-6);
        }
    }
}

// An equation without its own unknown.
#[test]
fn a_scalar_that_nothing_determines_is_named() {
    let model = alone(Lag::new(ScalarStart::Settled, false, 0.0));
    let (_, outcome) = run(&model, &TransientSettings::new(0.01, 1e-3));
    let failure = outcome.failure.unwrap();
    assert!(matches!(failure, TransientFailure::Scalars(_)), "{failure}");
    assert!(
        failure.to_string().contains("balance of \"lag\""),
        "{failure}"
    );
}

/// `w^2 / (s^2 + 2 z w s + w^2)` of a step of two at 0.01 s, w = 60 rad/s, z = 0.3.
fn filter() -> Model {
    let matrices = Matrices::transfer(&[3600.0], &[1.0, 36.0, 3600.0]).unwrap();
    let step = Drive::Step(Step {
        from: 0.0,
        to: 2.0,
        time: 0.01,
    });
    let outputs = vec![StateSpace::output("filter", "y")];
    let start = [ScalarStart::Value(0.0); 2];
    let input = vec![Signal::Drive(step)];
    alone(StateSpace::new("filter", matrices, input, outputs, &start))
}

/// Its response.
fn answer(time: f64) -> f64 {
    let since = (time - 0.01).max(0.0);
    let (decay, omega) = (18.0, 60.0 * (1.0_f64 - 0.09).sqrt());
    let part = (omega * since).cos() + decay / omega * (omega * since).sin();
    2.0 * (1.0 - (-decay * since).exp() * part)
}

/// The largest error of the output in a run.
fn filter_error(settings: &TransientSettings) -> f64 {
    let (Kept { times, states, .. }, outcome) = run(&filter(), settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let off = times.iter().zip(&states);
    let off = off.map(|(time, state)| (state.scalars[2] - answer(*time)).abs());
    off.fold(0.0, f64::max)
}

// Second order: a quarter of the error at half the step.
#[test]
fn a_filter_answers_a_step_to_second_order() {
    for scheme in [SCHEMES[0], SCHEMES[1], SCHEMES[2]] {
        let error = |step: f64| {
            filter_error(&TransientSettings {
                scheme,
                ..TransientSettings::new(0.2, step)
            })
        };
        let (coarse, fine) = (error(1e-3), error(5e-4));
        assert!(coarse < 5e-3, "{scheme:?} {coarse:e}");
        assert!(
            (coarse / fine).log2() > 1.8,
            "{scheme:?} {coarse:e} {fine:e}"
        );
    }
}

// The error per step is at most the tolerance of the largest value, 2.7; up to two hundred steps
// lie within the time in which errors of the filter decay.
#[test]
fn a_filter_answers_a_step_to_the_tolerance() {
    for scheme in SCHEMES {
        for tolerance in [1e-4, 1e-6] {
            let off = filter_error(&settings(scheme, 0.2, tolerance));
            assert!(off < 500.0 * tolerance, "{scheme:?} {tolerance:e}: {off:e}");
        }
    }
}

fn matrix(random: &mut Random, rows: usize, columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |_, _| random.number())
}

// x = exp(A t) x_0 + int exp(A s) B u ds for constant inputs, by the exponential of both; two
// hundred systems of up to five states, three inputs and three outputs. Entries of A are up to 4:
// the error of the trapezoid rule is (4 n h)^2 t / 12 of values of up to exp(4 n t), and the bound
// is for the worst case; most are a thousand times better.
#[test]
fn random_systems_of_states_are_those_of_the_exponential() {
    let mut random = Random(7);
    for _ in 0..200 {
        let [order, inputs, outputs] =
            [5.0, 3.0, 3.0].map(|most: f64| 1 + ((random.number() + 1.0) / 2.0 * most) as usize);
        let matrices = Matrices {
            a: 4.0 * matrix(&mut random, order, order),
            b: matrix(&mut random, order, inputs),
            c: matrix(&mut random, outputs, order),
            d: matrix(&mut random, outputs, inputs),
        };
        let u = matrix(&mut random, inputs, 1);
        let start = matrix(&mut random, order, 1);
        let mut whole = DMatrix::zeros(order + 1, order + 1);
        whole
            .view_mut((0, 0), (order, order))
            .copy_from(&matrices.a);
        let driven = &matrices.b * &u;
        whole.view_mut((0, order), (order, 1)).copy_from(&driven);
        let flow = (whole * 0.5).exp();
        let free = flow.view((0, 0), (order, order)) * &start;
        let exact = free + flow.view((0, order), (order, 1));
        let expected = &matrices.c * &exact + &matrices.d * &u;

        let signals = u.iter().map(|u| Signal::Drive(Drive::Constant(*u)));
        let names = (0..outputs).map(|i| StateSpace::output("law", &format!("y{i}")));
        let starts: Vec<_> = start.iter().map(|x| ScalarStart::Value(*x)).collect();
        let law = StateSpace::new("law", matrices, signals.collect(), names.collect(), &starts);
        let settings = TransientSettings {
            scheme: Scheme::CrankNicolson,
            ..TransientSettings::new(0.5, 1e-3)
        };
        let found = states(&alone(law), &settings);
        let last = &found[found.len() - 1].scalars;
        let scale = exact.amax().max(1.0);
        for (found, exact) in last.iter().zip(exact.iter().chain(expected.iter())) {
            assert!(
                (found - exact).abs() < 1e-4 * scale,
                "{found} {exact} {scale}"
            );
        }
    }
}
