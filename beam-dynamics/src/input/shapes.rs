//! Which shapes of modes are animated, and at which speeds.

use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::problem::InputProblem;
use super::speeds::{RPM, SAME_SPEED};

/// Reads `shapes` and `shape_speeds` of `[modes]`: whether shapes are animated, and the
/// speeds chosen for shapes, of `speeds`; none chosen is an empty list.
pub(super) fn read(table: &Table<'_>, speeds: Option<&[f64]>) -> Option<(bool, Vec<f64>)> {
    let animate = match table.has("shapes") {
        true => table.boolean("shapes"),
        false => Some(false),
    };
    let chosen = match table.has("shape_speeds") {
        true => chosen(table, speeds),
        false => Some(Vec::new()),
    };
    Some((animate?, chosen?))
}

/// The speeds of the analysis that `shape_speeds` names; each one that is none of them
/// is noted.
fn chosen(table: &Table<'_>, speeds: Option<&[f64]>) -> Option<Vec<f64>> {
    const KEY: &str = "shape_speeds";
    let wanted = table.quantities(KEY, Dimension::ROTATION_SPEED)?;
    let speeds = speeds?;
    let nearest = |wanted: f64| {
        let distance = |speed: f64| (speed - wanted).abs();
        speeds
            .iter()
            .copied()
            .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
    };
    let mut found = Vec::with_capacity(wanted.len());
    for &wanted in &wanted {
        let nearest = nearest(wanted)?;
        if (nearest - wanted).abs() <= SAME_SPEED * nearest.abs() {
            found.push(nearest);
            continue;
        }
        let [rpm, nearest] = [wanted, nearest].map(|speed| speed / RPM);
        table.note(KEY, &InputProblem::ShapeSpeed { rpm, nearest });
    }
    (found.len() == wanted.len()).then_some(found)
}
