//! Curves on one grid, for formats whose coefficients share their angles.

use super::super::data::{AirfoilData, Curve};
use super::notes::Notes;

/// Mach number, Reynolds number and deflection of a table.
pub(super) type Condition = [Option<f64>; 3];

/// Columns on the union of the angles of some curves.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Joint {
    /// Ascending [rad].
    pub alpha: Vec<f64>,
    /// One list per curve.
    pub columns: Vec<Vec<f64>>,
    /// Number of values that are interpolated, since their curve lacks the angle.
    pub added: usize,
}

impl Joint {
    /// The curves on the union of their angles; linear between the angles of a curve, constant
    /// beyond them.
    pub fn of(curves: &[&Curve]) -> Self {
        let mut alpha: Vec<f64> = curves
            .iter()
            .flat_map(|curve| curve.alpha.clone())
            .collect();
        alpha.sort_by(f64::total_cmp);
        alpha.dedup();
        let columns = curves.iter().map(|curve| {
            let values = alpha.iter().map(|&angle| at(curve, angle));
            values.collect()
        });
        let columns = columns.collect();
        let lacking = curves.iter().map(|curve| alpha.len() - curve.alpha.len());
        Self {
            columns,
            added: lacking.sum(),
            alpha,
        }
    }
}

/// The value of a curve at an angle, linear between its angles.
fn at(curve: &Curve, angle: f64) -> f64 {
    let behind = curve.alpha.partition_point(|&known| known <= angle);
    let value = |i: usize| curve.values.get(i).copied();
    let known = |i: usize| curve.alpha.get(i).copied();
    let Some(before) = behind.checked_sub(1) else {
        return value(0).unwrap_or(0.0);
    };
    let (Some(a), Some(from)) = (value(before), known(before)) else {
        return 0.0;
    };
    match (value(behind), known(behind)) {
        (Some(b), Some(to)) if angle > from => a + (angle - from) / (to - from) * (b - a),
        _ => a,
    }
}

/// The condition of a curve.
pub(super) fn condition(curve: &Curve) -> Condition {
    [curve.mach, curve.reynolds, curve.flap]
}

/// The conditions of all curves of an airfoil, each once, in their order.
pub(super) fn conditions(data: &AirfoilData) -> Vec<Condition> {
    let mut found: Vec<Condition> = Vec::new();
    for curve in data.lift.iter().chain(&data.drag).chain(&data.moment) {
        let condition = condition(curve);
        if !found.contains(&condition) {
            found.push(condition);
        }
    }
    found
}

/// The curve of a condition.
pub(super) fn find<'c>(curves: &'c [Curve], wanted: &Condition) -> Option<&'c Curve> {
    curves.iter().find(|curve| condition(curve) == *wanted)
}

/// Notes the faults of an airfoil that no format can carry; returns whether it has none.
pub(super) fn is_sound(data: &AirfoilData, notes: &mut Notes) -> bool {
    let name = &data.name;
    let mut sound = true;
    if data.lift.is_empty() || data.drag.is_empty() {
        let what = format!("airfoil \"{name}\": a curve of lift and one of drag");
        notes.missing(0, &what, "give both coefficients");
        sound = false;
    }
    for curve in data.lift.iter().chain(&data.drag).chain(&data.moment) {
        let is_ascending = curve.alpha.windows(2).all(|two| two[0] < two[1]);
        let all = curve.alpha.iter().chain(&curve.values);
        let is_full = !curve.alpha.is_empty() && curve.alpha.len() == curve.values.len();
        if !is_ascending || !is_full || !all.clone().all(|value| value.is_finite()) {
            let what = format!("a curve of airfoil \"{name}\"");
            let found = format!(
                "{} angles, {} values",
                curve.alpha.len(),
                curve.values.len()
            );
            let expected = "ascending angles and as many values, all finite";
            notes.wrong(0, [&what, &found, expected, "correct the curve"]);
            sound = false;
        }
    }
    sound
}
