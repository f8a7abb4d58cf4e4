//! The derivatives with respect to the unknowns of a scheme, against differences.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::models::{bipendulum, top};
use crate::analysis::transient::multibody::Multibody;
use crate::analysis::transient::start::start;
use crate::assembly::{Combination, Residual, Sparse};
use crate::case::{BladeNodes, Model, TransientSettings};
use crate::integrator::Dae;

/// Deterministic numbers from -1 to 1.
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Largest difference from central differences, relative to the largest entry.
fn error(model: &Model) -> f64 {
    const STEP: f64 = 1e-6;
    let state = start(model, &TransientSettings::new(1.0, 0.1))
        .unwrap()
        .state;
    let mut dae = Multibody::new(model, [state.clone(), state], (1, false));
    let count = dae.pattern().size();
    let mut random = Random(7);
    let mut numbers = |size: f64| {
        (0..count)
            .map(|_| size * random.number())
            .collect::<Vec<_>>()
    };
    let (y, rates) = (numbers(0.3), numbers(1.0));
    dae.predict(0, [0.1; 2], &y, &rates);
    let (y, rates) = (numbers(0.2), numbers(0.7));
    let (a, b) = (0.4, 0.9);
    let mut matrix = Sparse::zero(Arc::clone(dae.pattern()));
    dae.correct(0, &y, &rates);
    let sum = Combination {
        by_unknowns: a,
        by_rates: b,
        by_algebraic: 1.0,
        matrix: &mut matrix,
    };
    dae.jacobian(0, &mut [sum], None);
    let largest = matrix.values().iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let mut worst = 0.0_f64;
    for column in 0..count {
        let [by_unknown, by_rate] = if dae.algebraic()[column] {
            [1.0, 0.0]
        } else {
            [a, b]
        };
        let mut at = |step: f64| {
            let (mut y, mut rates) = (y.clone(), rates.clone());
            y[column] += step * by_unknown;
            rates[column] += step * by_rate;
            dae.correct(0, &y, &rates);
            let mut residual = Residual::default();
            dae.residual(0, &mut residual);
            residual.values
        };
        let pairs = at(STEP).into_iter().zip(at(-STEP)).enumerate();
        for (row, (later, before)) in pairs {
            let difference = (later - before) / (2.0 * STEP);
            worst = worst.max((difference - matrix.entry(row, column)).abs());
        }
    }
    worst / largest
}

// Central differences: truncation of 1e-12 times third derivatives of order ten, round-off
// of 1e-16 over 1e-6 times terms of order 30.
#[test]
fn derivatives_are_exact_for_slender_and_other_bodies() {
    for model in [bipendulum(), top(Vector3::new(0.3, 0.9, 7.5))] {
        let error = error(&model);
        assert!(error < 2e-8, "{}: {error:e}", model.name);
    }
}

// The same in axes that turn with a part, here by 0.78 rad.
#[test]
fn derivatives_are_exact_in_turning_axes() {
    let mut model = top(Vector3::new(0.3, 0.9, 7.5));
    let nodes = (0..model.system.nodes().len()).collect();
    model.blades.push(BladeNodes {
        name: "top".to_owned(),
        azimuth: 0.0,
        nodes,
        axes: Matrix3::identity(),
        file: None,
    });
    let error = error(&model);
    assert!(error < 2e-8, "{error:e}");
}
