//! Differences of two blades at common positions.
//!
//! Positions are parts of the lengths of both lines. Differences of the line are relative
//! to the length of A, of twist to one radian, of masses and lengths to A, and of entries
//! of matrices to the diagonal of A at the position, `sqrt(Aii Ajj)`.

use nalgebra::Matrix6;

use super::Blade;
use crate::line::{Curve, Side};
use crate::wrench::COMPONENTS;

/// Parts of the length that are one position [-].
const SAME: f64 = 1e-9;
/// Distance from a jump at which both blades are evaluated, since files move jumps by
/// their ramps, as part of the length [-].
const ASIDE: f64 = 1e-6;

/// A quantity of two blades at the position of its largest difference.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeDifference {
    /// The quantity.
    pub name: String,
    /// Its unit; angles are in radians.
    pub unit: &'static str,
    /// Value of A, in `unit` [mixed].
    pub a: f64,
    /// Value of B, in `unit` [mixed].
    pub b: f64,
    /// Absolute difference over its reference [-].
    pub relative: f64,
    /// Arc length along A; `None` for quantities of the whole blade [m].
    pub at: Option<f64>,
}

/// The reference of a difference of an entry of two matrices.
fn scale(a: &Matrix6<f64>, b: &Matrix6<f64>, i: usize, j: usize) -> f64 {
    let own = |m: &Matrix6<f64>| (m[(i, i)] * m[(j, j)]).abs().sqrt();
    if own(a) > 0.0 { own(a) } else { own(b) }
}

/// A difference over its reference; without a reference one, unless it is zero.
fn over(difference: f64, reference: f64) -> f64 {
    match difference == 0.0 {
        true => 0.0,
        false if reference > 0.0 => difference.abs() / reference,
        false => 1.0,
    }
}

impl Blade {
    /// The differences of the blade `other` (B) from this one (A): line, twist, masses,
    /// and each entry of stiffness, mass and damping that is not zero in both.
    pub fn compare(&self, other: &Self) -> Vec<BladeDifference> {
        let whole = |name: &str, unit, a: f64, b: f64| BladeDifference {
            name: name.to_owned(),
            unit,
            a,
            b,
            relative: over(b - a, a.abs()),
            at: None,
        };
        let mut all = vec![
            whole("length", "m", self.length(), other.length()),
            whole("mass", "kg", self.mass(), other.mass()),
        ];
        let parts = self.common_parts(other);
        all.extend(self.compare_lines(other, &parts));
        let pairs = parts
            .iter()
            .map(|part| (*part, self.at_part(*part), other.at_part(*part)));
        let pairs: Vec<_> = pairs.collect();
        for (kind, name, units) in KINDS
            .iter()
            .enumerate()
            .map(|(i, kind)| (i, kind.0, kind.1))
        {
            let of = |part: &(f64, [Matrix6<f64>; 3], [Matrix6<f64>; 3])| {
                (part.0 * self.length(), part.1[kind], part.2[kind])
            };
            let matrices: Vec<_> = pairs.iter().map(of).collect();
            all.extend(compare_matrices(name, units, &matrices));
        }
        all
    }

    /// Parts of the length at which both blades are compared: the stations and points of
    /// both, and next to jumps.
    fn common_parts(&self, other: &Self) -> Vec<f64> {
        let part = |blade: &Self, positions: Vec<f64>| {
            let length = blade.length();
            positions.into_iter().map(move |s| s / length)
        };
        let jumps: Vec<_> = [self, other]
            .into_iter()
            .flat_map(|blade| part(blade, blade.jumps()))
            .collect();
        let mut parts: Vec<_> = [self, other]
            .into_iter()
            .flat_map(|blade| {
                let points = blade.line.arc_lengths();
                part(blade, blade.positions()).chain(part(blade, points))
            })
            .flat_map(|part| {
                if jumps.iter().any(|jump| (jump - part).abs() < ASIDE) {
                    vec![part - ASIDE, part + ASIDE]
                } else {
                    vec![part]
                }
            })
            .filter(|part| part.is_finite())
            .map(|part| part.clamp(0.0, 1.0))
            .collect();
        parts.sort_by(f64::total_cmp);
        parts.dedup_by(|a, b| (*a - *b).abs() < SAME);
        parts
    }

    /// Stiffness, mass and damping at a part of the length.
    fn at_part(&self, part: f64) -> [Matrix6<f64>; 3] {
        let s = part * self.length();
        let (stiffness, mass) = self.at(s, Side::Inner);
        let damping = self.damping_at(s, Side::Inner).unwrap_or_default();
        [stiffness, mass, damping]
    }

    /// Differences of position and twist.
    fn compare_lines(&self, other: &Self, parts: &[f64]) -> Vec<BladeDifference> {
        let (a, b) = (self.line.curve(), other.line.curve());
        let length = self.length();
        let values = |curve: &Curve, part: f64| {
            let placed = curve.at(part * curve.length());
            let [x, y, z] = placed.position.into();
            [x, y, z, placed.twist]
        };
        let names = [
            ("line x", "m", length),
            ("line y", "m", length),
            ("line z", "m", length),
            ("twist", "rad", 1.0),
        ];
        let rows = names
            .into_iter()
            .enumerate()
            .filter_map(|(i, (name, unit, reference))| {
                let rows = parts.iter().map(|&part| {
                    let (a, b) = (values(&a, part)[i], values(&b, part)[i]);
                    (part * length, a, b, over(b - a, reference))
                });
                largest(name, unit, rows)
            });
        rows.collect()
    }
}

/// Matrices in the order of [`Blade::at_part`], with the units of entries of two forces,
/// of a force and a moment, and of two moments.
const KINDS: [(&str, [&str; 3]); 3] = [
    ("stiffness", ["N", "N m", "N m^2"]),
    ("mass", ["kg/m", "kg", "kg m"]),
    ("damping", ["N s", "N m s", "N m^2 s"]),
];

/// The largest difference of each entry of the matrices of A and B at arc lengths [m].
fn compare_matrices(
    kind: &str,
    units: [&'static str; 3],
    matrices: &[(f64, Matrix6<f64>, Matrix6<f64>)],
) -> Vec<BladeDifference> {
    let pairs = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
    let rows = pairs.filter_map(|(i, j)| {
        let name = if i == j {
            format!("{kind} {}", COMPONENTS[i])
        } else {
            format!("{kind} {}, {}", COMPONENTS[i], COMPONENTS[j])
        };
        let unit = units[usize::from(i > 2) + usize::from(j > 2)];
        let rows = matrices.iter().map(|(s, a, b)| {
            let (x, y) = (a[(i, j)], b[(i, j)]);
            (*s, x, y, over(y - x, scale(a, b, i, j)))
        });
        largest(&name, unit, rows)
    });
    rows.collect()
}

/// The row of arc length [m], A, B and relative difference with the largest difference;
/// `None` if A and B are zero in all rows.
fn largest(
    name: &str,
    unit: &'static str,
    rows: impl Iterator<Item = (f64, f64, f64, f64)>,
) -> Option<BladeDifference> {
    let rows = rows.filter(|(_, a, b, _)| *a != 0.0 || *b != 0.0);
    // Of equal differences, the first.
    let most = rows.reduce(|most, row| if row.3 > most.3 { row } else { most });
    most.map(|(at, a, b, relative)| BladeDifference {
        name: name.to_owned(),
        unit,
        a,
        b,
        relative,
        at: Some(at),
    })
}
