//! The numbers of all section properties, compared one by one.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Matrix6, Vector6};
use shared_geom::section::{SectionProperties, half_turn};

use super::{Entry, Part, pair};

/// The comparisons so far.
#[derive(Debug)]
pub(super) struct Entries {
    pub found: Vec<Entry>,
    pub unlike: Vec<String>,
    /// Scale of differences of positions \[m\].
    pub length: f64,
}

impl Entries {
    pub fn new(length: f64) -> Self {
        Self {
            found: Vec::new(),
            unlike: Vec::new(),
            length,
        }
    }

    /// Compares two numbers relative to `scale`; the difference of equal numbers is zero,
    /// also for a zero scale.
    pub fn add(
        &mut self,
        part: Part,
        name: String,
        [a, b]: [f64; 2],
        unit: &'static str,
        scale: f64,
    ) {
        let relative = if a == b { 0.0 } else { (b - a) / scale };
        self.found.push(Entry {
            part,
            name,
            a,
            b,
            unit,
            relative,
        });
    }

    /// Records a value that only one of the two has; returns both if both have it.
    pub fn both<T>(&mut self, what: &str, a: Option<T>, b: Option<T>) -> Option<(T, T)> {
        match (a, b) {
            (Some(a), Some(b)) => return Some((a, b)),
            (Some(_), None) => self.unlike.push(format!("only A has {what}")),
            (None, Some(_)) => self.unlike.push(format!("only B has {what}")),
            (None, None) => {}
        }
        None
    }

    /// Compares the upper triangles of two symmetric matrices; returns all relative
    /// differences.
    ///
    /// ```text
    /// (B - A)_ij / sqrt(s_i s_j)      s_i = A_ii, or B_ii where A_ii is zero
    /// ```
    pub fn matrix(&mut self, part: Part, a: &Matrix6<f64>, b: &Matrix6<f64>) -> Matrix6<f64> {
        let scale = a.diagonal().zip_map(&b.diagonal(), |a, b| {
            if a > 0.0 { a.sqrt() } else { b.abs().sqrt() }
        });
        let first = self.found.len();
        for i in 0..6 {
            for j in i..6 {
                let values = [a[(i, j)], b[(i, j)]];
                self.add(
                    part,
                    pair(i, j),
                    values,
                    unit(part, i, j),
                    scale[i] * scale[j],
                );
            }
        }
        let mut relative = Matrix6::zeros();
        let mut entries = self.found[first..].iter();
        for i in 0..6 {
            for j in i..6 {
                let value = entries.next().map_or(0.0, |entry| entry.relative);
                relative[(i, j)] = value;
                relative[(j, i)] = value;
            }
        }
        relative
    }

    /// Compares the centers; the mass center only if both have mass.
    pub fn centers(&mut self, a: &SectionProperties, b: &SectionProperties) {
        let massive = [a, b].map(|section| section.mass[(0, 0)] > 0.0);
        let mass = |massive: bool| massive.then_some(());
        let both_massive = self.both("mass", mass(massive[0]), mass(massive[1]));
        let mut centers = vec![
            ("tension", a.centers.tension, b.centers.tension),
            ("shear", a.centers.shear, b.centers.shear),
        ];
        if both_massive.is_some() {
            centers.push(("mass", a.centers.mass, b.centers.mass));
        }
        for (name, a, b) in centers {
            for (axis, letter) in ["y", "z"].into_iter().enumerate() {
                let name = format!("{name} {letter}");
                self.add(Part::Center, name, [a[axis], b[axis]], "m", self.length);
            }
        }
    }

    /// Compares principal values and angles; of inertia only if both have mass.
    pub fn principal_axes(&mut self, a: &SectionProperties, b: &SectionProperties) {
        let massive = a.mass[(0, 0)] > 0.0 && b.mass[(0, 0)] > 0.0;
        let (a, b) = (&a.principal_axes, &b.principal_axes);
        let bending = [
            (a.bending_angle, a.bending_stiffness),
            (b.bending_angle, b.bending_stiffness),
        ];
        self.axes("bending", bending, "N m^2");
        if massive {
            let inertia = [(a.inertia_angle, a.inertia), (b.inertia_angle, b.inertia)];
            self.axes("inertia", inertia, "kg m");
        }
    }

    fn axes(&mut self, name: &str, [a, b]: [(f64, [f64; 2]); 2], unit: &'static str) {
        let (angle_a, a) = a;
        let (angle_b, b) = nearest(angle_a, b);
        for (axis, word) in ["first", "second"].into_iter().enumerate() {
            let scale = a[axis].abs().max(b[axis].abs());
            let name = format!("{name}, {word} axis");
            self.add(Part::Principal, name, [a[axis], b[axis]], unit, scale);
        }
        let largest = a[0].abs().max(a[1].abs());
        let anisotropy = if largest > 0.0 {
            (a[0] - a[1]).abs() / largest
        } else {
            0.0
        };
        self.found.push(Entry {
            part: Part::Principal,
            name: format!("{name}, angle"),
            a: angle_a,
            b: angle_b,
            unit: "rad",
            relative: (angle_b - angle_a) * anisotropy,
        });
    }
}

/// The axes in the order that brings the angle nearest to `reference`: each quarter turn
/// exchanges first and second.
fn nearest(reference: f64, (angle, values): (f64, [f64; 2])) -> (f64, [f64; 2]) {
    let quarters = ((angle - reference) / FRAC_PI_2).round();
    let exchanged = quarters.rem_euclid(2.0) == 1.0;
    // Computed from the direction, since a sum of quarter turns has round-off.
    let angle = if exchanged {
        reference + half_turn(angle - FRAC_PI_2 - reference)
    } else {
        reference + half_turn(angle - reference)
    };
    let values = if exchanged {
        [values[1], values[0]]
    } else {
        values
    };
    (angle, values)
}

/// Unit of an entry.
fn unit(part: Part, i: usize, j: usize) -> &'static str {
    let units = match part {
        Part::Mass => ["kg/m", "kg", "kg m"],
        Part::Damping => ["N s", "N m s", "N m^2 s"],
        _ => ["N", "N m", "N m^2"],
    };
    units[usize::from(i > 2) + usize::from(j > 2)]
}

/// The largest of six forces in terms of the stiffness, `max_j |a_j| / sqrt(K_jj)`.
pub(super) fn largest_force(root: &Vector6<f64>, forces: &[f64]) -> f64 {
    let relative = forces
        .iter()
        .zip(root)
        .map(|(force, root)| force.abs() / root);
    relative.fold(0.0, f64::max)
}
