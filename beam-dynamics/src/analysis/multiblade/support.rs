//! Names of modes of which parts other than the blades have most of the energy: the part, and the
//! direction of its motion.
//!
//! ```text
//! turbine, axis n of the rotor nearly level, u up:  fore-aft   along n - (n . u) u, and about the third axis
//!                                                   side-side  along u x n, and about the first axis
//!                                                   vertical   along u          yaw   about u
//! other rotors, axes of the model:                  x, y, z    along the axis; x and y also about the other
//!                                                   about z
//! ```

use nalgebra::{Complex, Vector3};

use super::coordinates::Coordinates;
use crate::case::Model;
use crate::model::NODE_UNKNOWNS;
use crate::modes::ModeMotion;

/// Least part of the energy outside the blades for a name of their own.
const MOST: f64 = 0.5;
/// Largest part of the axis along the vertical for which the axis is level.
const LEVEL: f64 = 0.7;
/// Unknowns of motion of a node.
const SIX: usize = 6;
/// Parts that carry a rotor with all that is on them.
const CARRIERS: [&str; 2] = ["tower", "wing"];

/// The name, or `None` if the blades have too much of the energy.
pub(super) fn support(
    model: &Model,
    coordinates: &Coordinates,
    motion: &ModeMotion,
) -> Option<String> {
    let (axes, words) = directions(model, coordinates);
    let [q, p] = motion.parts();
    let [mut whole, mut outside, mut largest] = [0.0; 3];
    let mut of_words = [0.0; 4];
    let mut part = None;
    for (node, label) in model
        .system
        .nodes()
        .iter()
        .map(|node| &node.label)
        .enumerate()
    {
        let mut own = 0.0;
        for half in 0..2 {
            let at = |values: &[Complex<f64>]| {
                let first = SIX * node + 3 * half;
                Vector3::new(values[first], values[first + 1], values[first + 2])
            };
            for (axis, direction) in axes.iter().enumerate() {
                let along = |values: &[Complex<f64>]| direction.map(Complex::from).dot(&at(values));
                let energy = (along(q).conj() * along(p)).re;
                own += energy;
                // A turn about one level axis belongs to the displacement along the other.
                let word = [[0, 1, 2], [1, 0, 3]][half][axis];
                if is_outside(coordinates, node) {
                    of_words[word] += energy;
                }
            }
        }
        whole += own;
        if is_outside(coordinates, node) {
            outside += own;
            if own > largest {
                (largest, part) = (own, Some(label));
            }
        }
    }
    let place = (0..4).max_by(|a, b| of_words[*a].total_cmp(&of_words[*b]))?;
    let is_support = whole > 0.0 && outside >= MOST * whole;
    let named = part
        .filter(|_| is_support)
        .map(|label| carrier(model, label));
    named.map(|part| format!("{part} {}", words[place]))
}

fn is_outside(coordinates: &Coordinates, node: usize) -> bool {
    let slot = coordinates.slot_of[NODE_UNKNOWNS * node];
    coordinates.slots[slot].of_blade.is_none()
}

/// Directions and the words of motion along the first, the second and the third, and about the third.
fn directions(model: &Model, coordinates: &Coordinates) -> ([Vector3<f64>; 3], [&'static str; 4]) {
    let up = (-model.gravity).try_normalize(0.0);
    let up = up.unwrap_or_else(Vector3::z);
    let first = coordinates.rotors.first();
    let axis = first.map_or_else(Vector3::z, |rotor| rotor.axis);
    let level = axis - up * axis.dot(&up);
    match level.try_normalize(0.0) {
        Some(fore) if axis.dot(&up).abs() < LEVEL => (
            [fore, up.cross(&fore), up],
            ["fore-aft", "side-side", "vertical", "yaw"],
        ),
        _ => (
            [Vector3::x(), Vector3::y(), Vector3::z()],
            ["x", "y", "z", "about z"],
        ),
    }
}

/// The part of a node, without numbers: the tower or the wing, if the parts of the same rotor stand on one.
fn carrier(model: &Model, label: &str) -> String {
    let owner = label.split_once('/').map(|(owner, _)| owner);
    let is_of = |word: &str| {
        let mut nodes = model.system.nodes().iter();
        let stands = |label: &str| {
            let mut parts = label.split('/');
            parts.next() == owner && parts.any(|part| part.starts_with(word))
        };
        nodes.any(|node| stands(&node.label))
    };
    if let Some(word) = CARRIERS.into_iter().find(|word| is_of(word)) {
        return word.to_owned();
    }
    let is_number = |c: char| c.is_ascii_digit() || c.is_whitespace();
    let parts = label
        .rsplit('/')
        .map(|part| part.trim_end_matches(is_number));
    let mut named = parts.filter(|part| !part.is_empty());
    named.next().unwrap_or(label).to_owned()
}
