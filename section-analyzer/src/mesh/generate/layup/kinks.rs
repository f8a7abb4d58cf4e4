//! Kinks of thicknesses along the contour, and the stations near them.
//!
//! A layer whose kinks are stations has its area in the mesh. A station that must stand near a
//! kink is not moved: a second one stands on the other side of the kink.

/// Part of the size of cells within which boundaries of cells are one.
pub(super) const NEAR: f64 = 0.03;

/// A place at which the slope of the thickness of a layer changes.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Kink {
    /// Arc length.
    pub s: f64,
    /// Distance within which stations on both of its sides may replace a station on it.
    pub near: f64,
}

impl Kink {
    /// The order in which kinks get their stations, the same for mirror images: the nearest to their
    /// stations first, lengths that are equal but for round-off by their distances from a place.
    pub fn order(a: (f64, f64), b: (f64, f64)) -> std::cmp::Ordering {
        let rounded = |near: f64| (near.ln() * 1e6).round();
        let by_length = rounded(a.0).total_cmp(&rounded(b.0));
        by_length.then(a.1.total_cmp(&b.1))
    }
}

/// Place of a new station for a kink of a thickness at 0, with the places of the known ones: at
/// the kink, or, if a known one is nearer than `near`, beyond the kink at this distance from the
/// known one. None if a known one is `same`, or if there is one near on both sides.
pub(super) fn beside(known: impl Iterator<Item = f64>, near: f64, same: f64) -> Option<f64> {
    let (mut before, mut behind) = (f64::NEG_INFINITY, f64::INFINITY);
    for place in known {
        if place.abs() <= same {
            return None;
        }
        if place < 0.0 {
            before = before.max(place);
        } else {
            behind = behind.min(place);
        }
    }
    // so that both new cells are at least half of `near` long
    let far = 1.5 * near;
    match (before >= -near, behind <= near) {
        (false, false) => Some(0.0),
        (true, false) => Some(before + near).filter(|_| behind > far),
        (false, true) => Some(behind - near).filter(|_| before < -far),
        (true, true) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::beside;

    /// Stations at 0, or on both sides of it within one and a half of the distance.
    #[test]
    fn a_kink_has_stations_on_it_or_on_both_sides() {
        let known = [
            (vec![-5.0, 5.0], Some(0.0)),
            (vec![-0.4, 5.0], Some(0.6)),
            (vec![0.4], Some(-0.6)),
            (vec![-0.4, 1.2], None),
            (vec![-0.4, 0.1], None),
            (vec![3.0, 1e-12], None),
        ];
        for (places, expected) in known {
            let found = beside(places.iter().copied(), 1.0, 1e-9);
            let is_equal = match (found, expected) {
                (Some(a), Some(b)) => f64::abs(a - b) < 1e-15,
                (a, b) => a == b,
            };
            assert!(is_equal, "{places:?}: {found:?}");
        }
    }
}
