//! Relative differences of two sets of section properties, entry by entry.

use crate::assembly::largest;
use nalgebra::{Matrix6, Vector2, Vector3};
use shared_geom::section::{Change, SectionProperties};
use shared_geom::wrench::{self, COMPONENTS};

mod entries;
mod options;
mod prestress;

use entries::Entries;

/// Distance of two reference points that is treated as zero, relative to the larger of
/// their coordinates and the radius of gyration: a few roundings.
const ROUND_OFF: f64 = 1e-14;

/// The differences of the properties B from the properties A.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// `(B - A)_ij / sqrt(A_ii A_jj)` of the stiffness \[-\].
    pub stiffness: Matrix6<f64>,
    /// The same of the mass \[-\]; if A has no mass, relative to the mass of B.
    pub mass: Matrix6<f64>,
    /// Radius of gyration of the stiffness of A, `sqrt((EIy + EIz) / EA)` about its tension
    /// center; the scale of differences of positions \[m\].
    pub length: f64,
    /// Changes made to B before the comparison, in this order.
    pub brought: Vec<Change>,
    /// All compared numbers.
    pub entries: Vec<Entry>,
    /// Data that only one of the two has, or has of another kind, as text.
    pub unlike: Vec<String>,
}

/// Two numbers and their relative difference.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The part that contains the number.
    pub part: Part,
    /// Name of the number: `axial-bending z`, `tension y`.
    pub name: String,
    /// Value of A \[mixed\].
    pub a: f64,
    /// Value of B \[mixed\].
    pub b: f64,
    /// Unit of both values.
    pub unit: &'static str,
    /// Their difference, relative to the scale of the part \[-\].
    pub relative: f64,
}

/// The parts of section properties.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The stiffness matrix.
    Stiffness,
    /// The mass matrix.
    Mass,
    /// The centers.
    Center,
    /// The principal axes.
    Principal,
    /// Initial curvature and slope.
    Curvature,
    /// Coupling and capacitance of electrodes.
    Piezo,
    /// The thermal force, and the forces of imposed states.
    Thermal,
    /// The effect of prestress.
    Prestress,
    /// The damping matrix.
    Damping,
}

impl Difference {
    /// The differences of `b` from `a`.
    ///
    /// ```text
    /// stiffness, mass, damping   (B - A)_ij / sqrt(A_ii A_jj)
    /// centers                    (b - a) / sqrt((EIy + EIz) / EA)
    /// principal values           (b - a) / max(|a|, |b|)
    /// principal angle            (b - a) |first - second| / max(first, second)
    /// ```
    ///
    /// The factor of an angle measures the coupling that the angle causes: an angle has no
    /// meaning if all directions are principal.
    ///
    /// Unless `as_given`, `b` is first brought to the axes and the reference point of `a`,
    /// as far as the files contain them: turned by the difference of the turns in their
    /// histories, then shifted by the difference of their reference points.
    pub fn between(a: &SectionProperties, b: &SectionProperties, as_given: bool) -> Self {
        let brought = if as_given { Vec::new() } else { changes(a, b) };
        let b = brought.iter().fold(b.clone(), |b, change| match change {
            Change::Shift(by) => b.shift(*by),
            Change::Rotate(angle) => b.rotate(*angle),
        });
        let length = radius_of_gyration(a);
        let mut entries = Entries::new(length);
        let stiffness = entries.matrix(Part::Stiffness, &a.stiffness, &b.stiffness);
        let mass = entries.matrix(Part::Mass, &a.mass, &b.mass);
        entries.centers(a, &b);
        entries.principal_axes(a, &b);
        options::compare(a, &b, &mut entries);
        Self {
            stiffness,
            mass,
            length,
            brought,
            entries: entries.found,
            unlike: entries.unlike,
        }
    }

    /// The entries whose relative difference is more than `tolerance`, largest first.
    pub fn beyond(&self, tolerance: f64) -> Vec<&Entry> {
        // NaN exceeds every tolerance.
        let is_beyond =
            |entry: &&Entry| entry.relative.is_nan() || entry.relative.abs() > tolerance;
        let mut found: Vec<_> = self.entries.iter().filter(is_beyond).collect();
        found.sort_by(|a, b| b.relative.abs().total_cmp(&a.relative.abs()));
        found
    }

    /// The largest relative difference \[-\]; NaN when one of them is.
    pub fn largest(&self) -> f64 {
        let relative = self.entries.iter().map(|entry| entry.relative.abs());
        relative.fold(0.0, largest)
    }
}

/// The changes that bring `b` to the axes and the reference point of `a`.
fn changes(a: &SectionProperties, b: &SectionProperties) -> Vec<Change> {
    let angle = turn(a) - turn(b);
    let mut changes = Vec::new();
    let mut point = b.reference_point;
    if angle != 0.0 {
        changes.push(Change::Rotate(angle));
        point = b.rotate(angle).reference_point;
    }
    let by: Vector2<f64> = a.reference_point - point;
    // Moving there and back leaves round-off in a point that is the same.
    let size = a.reference_point.amax().max(radius_of_gyration(a));
    if by.amax() > ROUND_OFF * size {
        changes.push(Change::Shift(by));
    }
    changes
}

/// The angle by which the axes were turned since the section was computed \[rad\].
fn turn(properties: &SectionProperties) -> f64 {
    let turns = properties
        .provenance
        .history
        .iter()
        .map(|step| match step.change {
            Change::Rotate(angle) => angle,
            Change::Shift(_) => 0.0,
        });
    turns.sum()
}

/// `sqrt((EIy + EIz) / EA)` about the tension center \[m\]: the size of a section, from its
/// stiffness.
pub fn radius_of_gyration(properties: &SectionProperties) -> f64 {
    let center = properties.centers.tension;
    let d = Vector3::new(0.0, center.x, center.y);
    let k = wrench::shift(&properties.stiffness, &d);
    ((k[(4, 4)] + k[(5, 5)]) / k[(0, 0)]).sqrt()
}

/// The name of an entry of a matrix: `axial-bending z`, `torsion` on the diagonal.
fn pair(i: usize, j: usize) -> String {
    if i == j {
        COMPONENTS[i].to_owned()
    } else {
        format!("{}-{}", COMPONENTS[i], COMPONENTS[j])
    }
}

#[cfg(test)]
mod tests;
