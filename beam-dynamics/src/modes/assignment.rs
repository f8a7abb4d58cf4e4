//! Roots of a system as the modes of a similar one.
//!
//! A root s with the shape x differs from the mode i w with the shape y by
//!
//! ```text
//! c = | |s| - w | / max(|s|, w) + 3 (1 - MAC)                                          (D-425)
//! ```
//!
//! The air damps a flapping motion, but hardly changes |s|, which is the root of its stiffness over its mass. Each root
//! is one mode at most, and each mode one root: the choice has the least sum of c, where a root that is no mode counts
//! as c = 3.

use pathfinding::kuhn_munkres::kuhn_munkres_min;
use pathfinding::matrix::Matrix;

/// Weight of the shape beside the size of the root [-].
const WEIGHT: f64 = 3.0;
/// c of a root that is no mode [-].
const NONE: f64 = 3.0;
/// Parts of c that are distinguished.
const STEPS: f64 = 1e9;

/// c of a root and a mode of the sizes |s| and w, in one unit, with the assurance MAC \[-\] (D-425).
pub fn unlikeness([root, mode]: [f64; 2], assurance: f64) -> f64 {
    let larger = root.max(mode).max(f64::MIN_POSITIVE);
    (root - mode).abs() / larger + WEIGHT * (1.0 - assurance)
}

/// The mode of each of `roots` roots among `modes` modes by `unlikeness` of the number of a root and of a mode; `None`
/// for roots that are no mode.
pub fn assign(
    [roots, modes]: [usize; 2],
    unlikeness: impl Fn(usize, usize) -> f64,
) -> Vec<Option<usize>> {
    // A column for each mode, and one for each root for no mode, which is better than a pair beyond its c.
    let cost = |(root, column): (usize, usize)| {
        let of_mode = (column < modes).then(|| unlikeness(root, column));
        let cost = of_mode.map_or(NONE, |own| if own < NONE { own } else { 2.0 * NONE });
        (cost * STEPS).round() as i64
    };
    if roots == 0 {
        return Vec::new();
    }
    let costs = Matrix::from_fn(roots, modes + roots, cost);
    let (_, columns) = kuhn_munkres_min(&costs);
    columns
        .into_iter()
        .map(|column| Some(column).filter(|own| *own < modes))
        .collect()
}
