//! Maxima of the growth near zero between values, and growths that touch zero.
//!
//! ```text
//! x = x_1 - ((x_1 - x_0)^2 (y_1 - y_2) - (x_1 - x_2)^2 (y_1 - y_0))
//!           / (2 ((x_1 - x_0) (y_1 - y_2) - (x_1 - x_2) (y_1 - y_0)))                (D-332)
//! ```

use super::follow::{links, size};
use super::request::ScanSettings;
use crate::result::{StabilityBoundary, StabilityPoint, StabilityRoot, StableSide};

/// Part of the drop beside a maximum by which its parabola may be wrong.
const WRONG: f64 = 0.1;
/// Least distance of two values as a part of the range, where a maximum is searched.
const APART: f64 = 1e-6;
/// Distance as a part of the range within which a growth that touches zero must leave it.
const BESIDE: f64 = 1e-3;
/// Growth relative to the mean magnitude of the exponents that touches zero.
const ZERO: f64 = 1e-8;

/// The top of the parabola through three points; `None` if they have no maximum between them.
fn parabola([p, q, r]: [[f64; 2]; 3]) -> Option<[f64; 2]> {
    let (left, right) = (q[0] - p[0], q[0] - r[0]);
    let (fall, rise) = (q[1] - r[1], q[1] - p[1]);
    let below = left * fall - right * rise;
    let above = left * left * fall - right * right * rise;
    let x = q[0] - 0.5 * above / below;
    let is_inside = x > p[0] && x < r[0];
    if !is_inside || fall < 0.0 || rise < 0.0 {
        return None;
    }
    // Newton's form of the parabola.
    let first = rise / left;
    let second = ((r[1] - q[1]) / (r[0] - q[0]) - first) / (r[0] - p[0]);
    let y = p[1] + (x - p[0]) * (first + (x - q[0]) * second);
    Some([x, y])
}

/// Growth up to which one counts as zero.
fn doubt(roots: [&StabilityRoot; 3], size: f64) -> f64 {
    roots
        .iter()
        .fold(ZERO * size, |most, root| most.max(root.doubt))
}

/// A value at which the growth of a mode may have a maximum near zero, or a minimum of growing ones,
/// away from known values.
pub(super) fn next_maximum(settings: &ScanSettings, points: &[StabilityPoint]) -> Option<f64> {
    let apart = f64::max(settings.tolerance, APART * settings.range());
    let is_new = |at: f64| points.iter().all(|point| (point.at - at).abs() > apart);
    points.windows(3).find_map(|three| {
        let [p, q, r] = [&three[0], &three[1], &three[2]];
        let size = size(three.iter().flat_map(|point| &point.roots));
        let after = links(&q.roots, &r.roots);
        let before = links(&p.roots, &q.roots);
        before.iter().enumerate().find_map(|(i, link)| {
            let j = (*link)?.to;
            let k = after[j]?.to;
            let roots = [&p.roots[i], &q.roots[j], &r.roots[k]];
            let at = maximum([p.at, q.at, r.at], roots, size)?;
            is_new(at).then_some(at)
        })
    })
}

/// The parameter at a maximum near zero of three roots that all decay, or of a minimum if all grow.
fn maximum(at: [f64; 3], roots: [&StabilityRoot; 3], size: f64) -> Option<f64> {
    let zero = doubt(roots, size);
    let grow = roots.map(StabilityRoot::is_unstable);
    if roots.iter().any(|root| root.is_neutral) || grow != [grow[0]; 3] {
        return None;
    }
    let sign = if grow[0] { -1.0 } else { 1.0 };
    let y = roots.map(|root| sign * root.growth());
    let drop = y[1] - y[0].min(y[2]);
    if drop <= 10.0 * zero {
        return None;
    }
    let [x, top] = parabola([0, 1, 2].map(|k| [at[k], y[k]]))?;
    (top > -(3.0 * zero + WRONG * drop)).then_some(x)
}

/// The values at which the growth of a mode touches zero: its largest value that is not above zero,
/// between smaller ones.
pub(super) fn touching(
    settings: &ScanSettings,
    points: &[StabilityPoint],
    modes: &[String],
) -> Vec<StabilityBoundary> {
    let beside = BESIDE * settings.range();
    let mut found = Vec::new();
    for (mode, name) in modes.iter().enumerate() {
        let curve: Vec<_> = points
            .iter()
            .filter_map(|point| Some((point, point.root_of(mode)?)))
            .collect();
        let size = size(curve.iter().map(|own| own.1));
        let mut last = f64::NEG_INFINITY;
        for (index, (point, root)) in curve.iter().enumerate() {
            let zero = doubt([root; 3], size);
            if root.growth().abs() > zero || root.is_neutral || point.at - last <= beside {
                continue;
            }
            let left = curve[..index]
                .iter()
                .rev()
                .find(|own| point.at - own.0.at > beside);
            let right = curve[index..]
                .iter()
                .find(|own| own.0.at - point.at > beside);
            let Some((left, right)) = left.zip(right) else {
                continue;
            };
            let ends = [left.1.growth(), right.1.growth()];
            let decays = !root.is_unstable() && ends.iter().all(|end| *end < -10.0 * zero);
            let grows = root.is_unstable() && ends.iter().all(|end| *end > 10.0 * zero);
            if !decays && !grows {
                continue;
            }
            // Several values may be as near to zero.
            let near = curve[index..]
                .iter()
                .take_while(|own| own.0.at - point.at <= beside);
            let nearest = near.min_by(|a, b| a.1.growth().abs().total_cmp(&b.1.growth().abs()));
            let (point, root) = nearest.unwrap_or(&curve[index]);
            last = point.at;
            found.push(StabilityBoundary {
                at: point.at,
                kind: root.kind,
                frequency: root.frequency(),
                growth: root.growth(),
                name: name.clone(),
                stable: if decays {
                    StableSide::Both
                } else {
                    StableSide::None
                },
                unstable: [left.0.unstable(), right.0.unstable()],
            });
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    // y = 3 - 2 (x - 0.7)^2, exactly a parabola; and points without a maximum between them.
    #[test]
    fn the_top_of_a_parabola() {
        let y = |x: f64| [x, 3.0 - 2.0 * (x - 0.7) * (x - 0.7)];
        let [x, top] = parabola([0.1, 0.5, 1.9].map(y)).unwrap();
        assert!((x - 0.7).abs() < 1e-14 && (top - 3.0).abs() < 1e-14);
        assert_eq!(parabola([0.8, 0.9, 1.9].map(y)), None);
        assert_eq!(parabola([[0.0, 1.0], [1.0, 1.0], [2.0, 1.0]]), None);
    }
}
