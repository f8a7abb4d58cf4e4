use std::f64::consts::TAU;

use nalgebra::Complex;

use super::*;

/// A motion of a hundred times the frequency is gone after the filter, not folded.
#[test]
fn long_records_are_filtered_before_they_are_thinned() {
    let times: Vec<_> = (0..20_000).map(|k| 1e-3 * f64::from(k)).collect();
    let values: Vec<_> = times.iter().map(|time| (TAU * 1.5 * time).cos()).collect();
    let record = Record::new(&times, &values).unwrap();
    let thin = record.thinned(SAMPLES);
    assert!(thin.record.values.len() <= SAMPLES);
    let response = thin.response(Complex::new(0.0, TAU * 151.0));
    assert!(response.norm() < 1e-3, "{response}");
}
