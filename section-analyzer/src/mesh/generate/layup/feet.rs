//! Layers of the shell that continue the layers along a web of a spar.

use super::super::super::short;
use super::problem::LayupProblem;
use super::stack::Stack;
use super::types::{SIDES, SparWeb};

/// Relative difference of thicknesses that are equal.
const SAME: f64 = 1e-6;

/// Numbers of the layers inside of a spar that continue each of the layers along a web at its corners,
/// whose columns are at these arc lengths: as given, or all of them in their order.
pub(super) fn feet(
    web: &SparWeb,
    first: usize,
    stack: &Stack,
    corners: [f64; 2],
) -> Result<[Vec<Option<usize>>; 2], LayupProblem> {
    if let Some(feet) = &web.feet {
        return Ok(feet.clone());
    }
    let [suction, pressure] = [0, 1].map(|side| in_order(web, first, stack, (side, corners[side])));
    Ok([suction?, pressure?])
}

/// The layers at a corner in their order, which have the thicknesses of those along the web; no other
/// layer reaches it from beyond.
fn in_order(
    web: &SparWeb,
    first: usize,
    stack: &Stack,
    (side, s): (usize, f64),
) -> Result<Vec<Option<usize>>, LayupProblem> {
    let present = (first..stack.len()).filter(|layer| stack.thickness(*layer, s) > 0.0);
    let present: Vec<usize> = present.collect();
    if let Some(layer) = present.iter().find(|layer| !stack.is_inside(**layer)) {
        return Err(LayupProblem::AtSpar {
            layer: stack.name(*layer).to_owned(),
            web: web.name.clone(),
        });
    }
    let thick =
        |layers: &[usize]| -> Vec<f64> { layers.iter().map(|layer| stack.full(*layer)).collect() };
    let (found, expected) = (thick(&present), thick(&web.layers));
    let is_full = present
        .iter()
        .all(|layer| (stack.thickness(*layer, s) / stack.full(*layer) - 1.0).abs() < SAME);
    let is_same = |(a, b): (&f64, &f64)| (a / b - 1.0).abs() < SAME;
    let are_same = found.len() == expected.len() && found.iter().zip(&expected).all(is_same);
    if are_same && is_full {
        return Ok(present.into_iter().map(Some).collect());
    }
    let text = |all: Vec<f64>| {
        let all: Vec<String> = all.into_iter().map(short).collect();
        all.join(", ")
    };
    Err(LayupProblem::SparPlies {
        web: web.name.clone(),
        side: SIDES[side],
        found: text(
            present
                .iter()
                .map(|layer| stack.thickness(*layer, s))
                .collect(),
        ),
        expected: text(expected),
    })
}
