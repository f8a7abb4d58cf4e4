//! Frequencies of bodies by nodal weights and of consistent inertia.

use std::f64::consts::PI;

use beam_dynamics::analysis::modes::modes;
use nalgebra::Vector6;

use super::{numbers, row};
use crate::record;
use crate::uniform_beam::{Inertia, UniformBeam};

const SOURCE: &str = "independent program, acceptance.json";

/// Angular frequencies of a uniform cantilever in ascending order.
fn frequencies(elements: usize, inertia: Inertia, count: usize) -> Vec<f64> {
    let mut beam = UniformBeam::slender(elements, inertia);
    beam.stiffness = Vector6::new(1e4, 4e3, 4e3, 0.8, 1.0, 4.0);
    beam.mass = Vector6::new(1.0, 1.0, 1.0, 5e-4, 1e-4, 4e-4);
    let (model, settings) = beam.case(&[0.0], count);
    let outcome = modes(&model, &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let points = outcome.table.at_speed(0).into_iter();
    let mut found: Vec<_> = points
        .map(|(_, point)| 2.0 * PI * point.frequency)
        .collect();
    found.sort_by(f64::total_cmp);
    found
}

/// Relative errors of six modes as listed, to 1 %, or to the digits of the reference frequencies if
/// they are smaller.
#[test]
fn frequencies_of_a_cantilever() {
    for (inertia, key) in [(Inertia::Lumped, "lobatto"), (Inertia::Consistent, "var")] {
        let listed = row(&format!("cantilever frequencies {key}"), "relative errors");
        let exact = numbers(&listed["note"]["ref"]);
        for (index, elements) in [1, 2, 4, 8].into_iter().enumerate() {
            let found = frequencies(elements, inertia, 6);
            let errors = numbers(&listed["value"][index]);
            // With one element the sixth mode differs.
            let count = if elements == 1 { 5 } else { 6 };
            for mode in 0..count {
                let error = found[mode] / exact[mode] - 1.0;
                let case = format!("cantilever, {key}, {elements} elements, mode {}", mode + 1);
                let off = (error.abs() - errors[mode].abs()).abs();
                let tolerance = 1e-2 * errors[mode].abs() + 2e-8;
                record::value(
                    SOURCE,
                    &case,
                    "error",
                    [error, errors[mode]],
                    off,
                    tolerance,
                );
                assert!(off < tolerance, "{case}: {error:e} {:e}", errors[mode]);
            }
        }
    }
}
