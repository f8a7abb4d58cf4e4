//! Exact derivatives of rows and induced velocities against central differences.

use num_dual::Dual64;

use super::polar;
use crate::inflow::{Inflow, InflowModel, MassFlow, RotorFlow, RotorLoads};
use crate::real::Real;

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

/// Ranges of advance ratio, axial speed and mean inflow: climb and forward flight, hover,
/// descent through vortex ring and turbulent wake, windmill.
const REGIMES: [[[f64; 2]; 3]; 5] = [
    [[0.05, 0.4], [-0.02, 0.1], [0.005, 0.08]],
    [[0.0, 0.0], [0.0, 0.0], [0.01, 0.08]],
    [[0.0, 0.05], [-0.06, -0.02], [0.03, 0.12]],
    [[0.0, 0.1], [-0.2, -0.1], [0.01, 0.06]],
    [[0.0, 0.1], [0.1, 0.2], [-0.1, -0.01]],
];

fn evaluate<T: Real>(model: &InflowModel, list: &[T]) -> Vec<T> {
    let size = model.states().len();
    let flow = RotorFlow {
        advance: list[0],
        axial: list[1],
        speed: list[2],
    };
    let loads = RotorLoads {
        thrust: list[3],
        sine: list[4],
        cosine: list[5],
    };
    let (states, rates) = list[8..].split_at(size);
    let mut rows = vec![T::zero(); size];
    model.rows(&flow, &loads, states, rates, &mut rows).unwrap();
    let position = polar(list[6], list[7]);
    rows.push(model.induced(&flow, states, &position).unwrap());
    rows
}

fn point(random: &mut Random, regime: &[[f64; 2]; 3], size: usize) -> Vec<f64> {
    let [advance, axial, mean] = regime.map(|[low, high]| random.between(low, high));
    let mut list = vec![advance, axial, random.between(5.0, 50.0)];
    list.extend([0; 3].map(|_| random.between(-0.01, 0.01)));
    list.extend([random.between(0.1, 0.99), random.between(0.0, 6.0)]);
    list.extend((0..size).map(|i| {
        if i == 0 {
            mean
        } else {
            random.between(-0.05, 0.05)
        }
    }));
    list.extend((0..size).map(|_| random.between(-1.0, 1.0)));
    list
}

#[test]
fn derivatives_agree_with_central_differences() {
    let mut random = Random(3);
    for word in InflowModel::WORDS {
        let model = InflowModel::of_word(word).unwrap();
        for regime in &REGIMES {
            for _ in 0..300 {
                let list = point(&mut random, regime, model.states().len());
                (0..list.len()).for_each(|i| compare(&model, &list, i));
            }
        }
    }
}

fn compare(model: &InflowModel, list: &[f64], input: usize) {
    let mut duals: Vec<Dual64> = list.iter().map(|&it| it.into()).collect();
    duals[input].eps = 1.0;
    let exact = evaluate(model, &duals);
    let step = 1e-7;
    let moved = |size: f64| {
        let mut list = list.to_vec();
        list[input] += size;
        evaluate(model, &list)
    };
    let (up, down) = (moved(step), moved(-step));
    for i in 0..exact.len() {
        let difference = (up[i] - down[i]) / (2.0 * step);
        // Rounding of values of order 1 over the step, and truncation over small speeds.
        let bound = 1e-6 * (1.0 + exact[i].eps.abs()) * (1.0 + list[2]);
        assert!(
            (exact[i].eps - difference).abs() < bound,
            "{} output {i} by {input}: {} instead of {difference} at {list:?}",
            model.word(),
            exact[i].eps
        );
    }
}

#[test]
fn the_change_of_the_mass_flow_is_its_derivative() {
    let mut random = Random(5);
    for regime in &REGIMES {
        for _ in 0..300 {
            let [advance, axial, mean] = regime.map(|[low, high]| random.between(low, high));
            let dual = Dual64::new(mean, 1.0);
            let air = MassFlow::of(advance.into(), axial.into(), dual);
            let product = dual * air.total;
            // The same formula by hand and by dual numbers: rounding.
            let error = (air.change.re - product.eps).abs();
            assert!(error < 1e-12, "{advance} {axial} {mean}: {error}");
        }
    }
}
