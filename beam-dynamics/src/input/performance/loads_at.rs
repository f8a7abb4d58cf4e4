//! The points at which loads along the blade are reported.

use shared_geom::document::Table;

use super::problem::PerformanceProblem;
use super::sweeps::LOADS_AT;
use crate::case::{Abscissa, PerformancePart, PerformanceRequest};

/// Relative difference up to which a value is one of a point [-].
const SAME: f64 = 1e-6;

/// Notes each value that no point has; found values become the ones of the points. `radius` of the
/// disk \[m\].
pub(super) fn check(table: &Table<'_>, part: &mut PerformancePart, radius: f64) {
    let values: Vec<f64> = match (&part.request, part.abscissa) {
        (PerformanceRequest::Settings(settings), axis) => {
            settings.iter().map(|at| axis.of(at, radius)).collect()
        }
        (PerformanceRequest::PowerCurve(curve), _) => curve.speeds.clone(),
    };
    let axis: Abscissa = part.abscissa;
    for found in &mut part.loads_at {
        let distance = |value: &f64| (value - *found).abs();
        let nearest = values.iter().copied();
        let nearest = nearest.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some(nearest) = nearest.filter(|value| value.is_finite()) else {
            continue;
        };
        if distance(&nearest) <= SAME * nearest.abs().max(1.0) {
            *found = nearest;
            continue;
        }
        let (found, axis) = (*found, axis.title());
        let problem = PerformanceProblem::NoSuchPoint {
            found,
            nearest,
            axis,
        };
        table.note(&LOADS_AT, &problem);
    }
}
