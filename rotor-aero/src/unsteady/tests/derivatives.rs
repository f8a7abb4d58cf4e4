//! Exact derivatives of all models against central differences.

use num_dual::Dual64;

use super::polars::Smooth;
use crate::real::Real;
use crate::unsteady::{Model, SectionFlow, SectionModel, Strip};

const STRIP: Strip = Strip {
    chord: 0.4,
    density: 1.2,
};
/// Points of each regime and model.
const POINTS: usize = 300;

/// A linear congruential generator.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Speed and angle of attack of a regime.
struct Regime {
    name: &'static str,
    speed: [f64; 2],
    angle: [f64; 2],
}

const REGIMES: [Regime; 6] = [
    Regime {
        name: "attached",
        speed: [5.0, 200.0],
        angle: [-0.2, 0.2],
    },
    Regime {
        name: "stalled",
        speed: [5.0, 200.0],
        angle: [0.2, 0.65],
    },
    Regime {
        name: "blended",
        speed: [5.0, 200.0],
        angle: [0.65, 0.95],
    },
    Regime {
        name: "reverse flow",
        speed: [5.0, 200.0],
        angle: [2.0, 4.2],
    },
    Regime {
        name: "slow",
        speed: [0.0, 0.1],
        angle: [-3.1, 3.1],
    },
    Regime {
        name: "no flow",
        speed: [0.0, 0.0],
        angle: [0.0, 0.0],
    },
];

/// A number of a range, or half of the time of a narrow range about a gate of the vortex.
fn near(random: &mut Random, range: [f64; 2], gate: f64, width: f64) -> f64 {
    if random.between(0.0, 1.0) < 0.5 {
        return random.between(range[0], range[1]);
    }
    random.between(gate - width, gate + width)
}

/// All inputs of a model as one list: flow, states, rates.
fn point(random: &mut Random, regime: &Regime, model: &SectionModel) -> Vec<f64> {
    let speed = random.between(regime.speed[0], regime.speed[1]);
    let angle = random.between(regime.angle[0], regime.angle[1]);
    let spin = random.between(-0.3, 0.3) * speed;
    let normal = speed * angle.sin();
    let mut list = vec![
        normal + spin * 0.2,
        normal + spin * 0.1,
        speed * angle.cos(),
        spin,
        random.between(0.0, 1.1),
        random.between(1e5, 1e6),
        random.between(-0.1, 0.1),
        normal * random.between(-0.3, 0.3),
    ];
    for state in model.states() {
        list.push(match state.name {
            "slow lag of the normal velocity" => 0.165 * normal * random.between(0.5, 1.5),
            "fast lag of the normal velocity" => 0.335 * normal * random.between(0.5, 1.5),
            "attached part of the chord" => random.between(0.02, 1.0),
            "normal coefficient of delayed pressure" => near(random, [-2.5, 2.5], 1.45, 0.08),
            "semichords travelled since shedding" => near(random, [0.0, 15.0], 7.0, 1.0),
            _ => random.between(-2.0, 2.0),
        });
    }
    for _ in model.states() {
        list.push(random.between(-3.0, 3.0));
    }
    list
}

fn evaluate<T: Real>(model: &SectionModel, list: &[T]) -> Vec<T> {
    let size = model.states().len();
    let flow = SectionFlow {
        normal: list[0],
        normal_mid: list[1],
        tangential: list[2],
        pitch_rate: list[3],
        mach: list[4],
        reynolds: list[5],
        flap: list[6],
        camber: list[7],
    };
    let mut rows = vec![T::zero(); size];
    let (states, rates) = list[8..].split_at(size);
    let force = model
        .evaluate(&STRIP, &Smooth, &flow, states, rates, &mut rows)
        .unwrap();
    rows.extend([force.along, force.normal, force.moment]);
    rows
}

/// Compares all derivatives by one input.
fn compare(model: &SectionModel, list: &[f64], input: usize, name: &str, slow: bool) {
    let mut duals: Vec<Dual64> = list.iter().map(|&it| it.into()).collect();
    duals[input].eps = 1.0;
    let exact = evaluate(model, &duals);
    let step = if slow {
        1e-6
    } else {
        1e-6 * (1.0 + list[input].abs())
    };
    let moved = |sign: f64, size: f64| {
        let mut list = list.to_vec();
        list[input] += sign * size;
        evaluate(model, &list)
    };
    let (up, down) = (moved(1.0, step), moved(-1.0, step));
    for i in 0..exact.len() {
        let difference = (up[i] - down[i]) / (2.0 * step);
        // Central differences: truncation with the square of the step, and rounding of the value
        // over the step.
        let rounding = 1e-14 * up[i].abs() / step;
        let bound = 2e-5 * (1.0 + difference.abs().max(exact[i].eps.abs())) + 10.0 * rounding;
        let error = (exact[i].eps - difference).abs();
        assert!(
            error < bound,
            "{} {name}, output {i} by input {input}: {} instead of {difference}, at {list:?}",
            model.word(),
            exact[i].eps
        );
        assert!((exact[i].re - evaluate(model, list)[i]).abs() <= 1e-9 * (1.0 + exact[i].re.abs()));
    }
}

#[test]
fn derivatives_agree_with_central_differences() {
    let mut random = Random(7);
    for word in SectionModel::WORDS {
        let model = SectionModel::of_word(word).unwrap();
        for regime in &REGIMES {
            for _ in 0..POINTS {
                let list = point(&mut random, regime, &model);
                let slow = regime.speed[1] < 1.0;
                (0..list.len()).for_each(|i| compare(&model, &list, i, regime.name, slow));
            }
        }
    }
}
