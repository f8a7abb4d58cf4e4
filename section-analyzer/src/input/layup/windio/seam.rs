//! Layers that go through the trailing edge, where arcs begin and end: two layers.

use shared_geom::exchange::yaml::Node;

use super::super::course::Course;
use super::super::place::{Place, PlaceForm, SIDES};
use super::super::resolve::ABSENT;
use super::super::{Layup, WrittenLayer};
use super::places::{MIDDLE, ROUND_OFF, is_padding};

/// Largest part of the contour of a layer that goes through the trailing edge although its file does
/// not state its middle.
const WIDEST: f64 = 0.25;

/// Whether the middle of a layer is given as the trailing edge.
pub(super) fn is_middle_at_edge(item: &Node) -> bool {
    let is_edge = |node: &Node| {
        let fixed = node.entry("fixed").and_then(Node::text);
        fixed == Some("TE") || is_padding(node)
    };
    item.entry(MIDDLE).is_some_and(is_edge)
}

/// Whether a layer starts on the pressure side and ends on the suction side wherever it has a
/// thickness, and thus goes through the trailing edge.
fn is_through(layer: &WrittenLayer, at_edge: bool) -> bool {
    let (PlaceForm::Arc(from), PlaceForm::Arc(to)) = (&layer.from.form, &layer.to.form) else {
        return false;
    };
    let positions = |course: &Course| course.points().map(|(eta, _)| eta).collect::<Vec<f64>>();
    let mut there = [from, to, &layer.thickness].map(positions).concat();
    there.retain(|eta| layer.thickness_at(*eta) > ABSENT);
    let crosses = |eta: &f64| {
        let (from, to) = (from.at(*eta), to.at(*eta));
        from > to && (at_edge || (from > 0.5 && to < 0.5 && 1.0 - from + to < WIDEST))
    };
    // A width beside a middle is a shift of the ends.
    let is_shifted = !layer.from.shift.is_zero();
    let has_width = |eta: &f64| is_shifted || 1.0 - from.at(*eta) + to.at(*eta) > ROUND_OFF;
    there.iter().all(crosses) && there.iter().any(has_width)
}

/// A layer, or both parts of one through the trailing edge, the part of the suction side first, with
/// a remark and the places of the whole layer by their names.
pub(super) fn divided(
    layer: WrittenLayer,
    item: &Node,
    (places, remarks): (&mut Vec<(String, Place)>, &mut Vec<String>),
) -> Vec<WrittenLayer> {
    if !is_through(&layer, is_middle_at_edge(item)) {
        return vec![layer];
    }
    let names = SIDES.map(|side| format!("{}_{side}", layer.name));
    remarks.push(format!(
        "line {}: layer \"{}\" goes through the trailing edge: it is layers \"{}\" and \"{}\"",
        layer.line, layer.name, names[0], names[1]
    ));
    for (end, place) in [("start", &layer.from), ("end", &layer.to)] {
        places.push((format!("{}.{end}", layer.name), place.clone()));
    }
    let [suction, pressure] = names;
    let part = |name: String, from: Place, to: Place| WrittenLayer {
        name,
        from,
        to,
        ..layer.clone()
    };
    vec![
        part(suction, Place::arc(0.0), layer.to.clone()),
        part(pressure, layer.from.clone(), Place::arc(1.0)),
    ]
}

/// Without the names of places that nothing refers to.
pub(super) fn with_used_places(mut layup: Layup) -> Layup {
    let used: Vec<String> = layup.place_names().map(str::to_owned).collect();
    layup.places.retain(|(name, _)| used.contains(name));
    layup
}
