//! Contours of sections: airfoils, scaled and blended along the span.

use std::f64::consts::TAU;

use shared_geom::document::{Document, Table, read_text};

use super::super::blade::airfoil_points;
use super::course::Course;
use super::keys::{AIRFOILS, AT_ETA, CHORD, CIRCLE, FILE, NACA, ORIGIN};
use super::problem::LayupFileProblem;
use crate::mesh::generate::blade::naca;
use crate::mesh::generate::layup::Outline;

/// Points of each side of a blended airfoil.
const POINTS: usize = 160;

/// Points (x/c, z/c), from the trailing edge over the suction side to the nose and back.
type Points = Vec<[f64; 2]>;

/// The contours along the span.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Chord \[m\].
    pub chord: Course,
    /// Position of the origin on the chord [-].
    pub origin: Course,
    airfoils: Vec<(f64, Points)>,
}

impl Shape {
    /// Reads `[shape]`.
    pub(super) fn read(document: &Document, table: &Table<'_>) -> Option<Self> {
        let (chord, origin) = (table.get(&CHORD), table.get(&ORIGIN));
        let given = [table.has(&NACA), table.has(&FILE), table.has(&AIRFOILS)];
        let found = given.into_iter().filter(|is| *is).count();
        if found != 1 {
            table.note("", &LayupFileProblem::Airfoil { found });
            return None;
        }
        let airfoils = match given[2] {
            false => points(document, table).map(|points| vec![(0.0, points)]),
            true => table.each(&AIRFOILS, |one| {
                let eta = one.get(&AT_ETA);
                let points = match one.has(&CIRCLE) {
                    true => one.get(&CIRCLE).map(|_| circle()),
                    false => points(document, one),
                };
                Some((eta?, points?))
            }),
        };
        let airfoils = airfoils?;
        let is_in_order = airfoils.windows(2).all(|pair| pair[1].0 > pair[0].0);
        if !is_in_order || airfoils.iter().any(|one| !(0.0..=1.0).contains(&one.0)) {
            table.note(&AIRFOILS, &LayupFileProblem::AirfoilOrder);
            return None;
        }
        if airfoils.is_empty() {
            table.note("", &LayupFileProblem::Airfoil { found: 0 });
            return None;
        }
        Some(Self {
            chord: chord?,
            origin: origin?,
            airfoils: resampled(airfoils, table)?,
        })
    }

    /// The contour at a position along the span: points (y, z) \[m\].
    pub fn contour(&self, eta: f64) -> Vec<[f64; 2]> {
        let (chord, origin) = (self.chord.at(eta), self.origin.at(eta));
        let place = |[x, z]: [f64; 2]| [(origin - x) * chord, z * chord];
        let after = self.airfoils.partition_point(|one| one.0 <= eta);
        let last = self.airfoils.len() - 1;
        let (before, after) = (after.max(1) - 1, after.min(last));
        let ((from, a), (to, b)) = (&self.airfoils[before], &self.airfoils[after]);
        let part = if to > from {
            ((eta - from) / (to - from)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let blend = |(a, b): (&[f64; 2], &[f64; 2])| {
            place([0, 1].map(|i| (1.0 - part) * a[i] + part * b[i]))
        };
        a.iter().zip(b).map(blend).collect()
    }

    /// Positions of the airfoils and of the tables.
    pub fn positions(&self) -> Vec<f64> {
        let mut all: Vec<f64> = match self.airfoils.len() {
            1 => Vec::new(),
            _ => self.airfoils.iter().map(|one| one.0).collect(),
        };
        all.extend(self.chord.positions());
        all.extend(self.origin.positions());
        all
    }
}

/// The points of one airfoil.
fn points(document: &Document, table: &Table<'_>) -> Option<Points> {
    if table.has(&FILE) && !table.has(&NACA) {
        let path = table.existing(&FILE, &table.get(&FILE)?)?;
        let text = document.keep(read_text(&path))?;
        return document.keep(airfoil_points(&text, &path.display().to_string()));
    }
    let made = naca(&table.get(&NACA)?, false);
    let note = |problem: crate::mesh::generate::blade::BladeProblem| {
        table.note(&NACA, &LayupFileProblem::Points(problem.to_string()));
    };
    made.map_err(note).ok()
}

fn circle() -> Points {
    let at = |i: usize| {
        let angle = TAU * i as f64 / POINTS as f64;
        [0.5 + 0.5 * angle.cos(), 0.5 * angle.sin()]
    };
    (0..=POINTS).map(at).collect()
}

/// Several airfoils with the same number of points, at equal parts of the length of each
/// side.
fn resampled(airfoils: Vec<(f64, Points)>, table: &Table<'_>) -> Option<Vec<(f64, Points)>> {
    if airfoils.len() < 2 {
        return Some(airfoils);
    }
    let one = |(eta, points): (f64, Points)| {
        let turned: Vec<[f64; 2]> = points.iter().map(|[x, z]| [-x, *z]).collect();
        let outline = Outline::new(&turned);
        let note = |problem: crate::mesh::generate::layup::LayupProblem| {
            table.note(&AIRFOILS, &LayupFileProblem::Points(problem.to_string()));
        };
        let outline = outline.map_err(note).ok()?;
        let ([from, to], nose) = (outline.corners(), outline.nose());
        let part = |i: usize| i as f64 / POINTS as f64;
        let suction = (0..POINTS).map(|i| from + (nose - from) * part(i));
        let pressure = (0..=POINTS).map(|i| nose + (to - nose) * part(i));
        let at = |s: f64| {
            let [y, z] = outline.position(s);
            [-y, z]
        };
        Some((eta, suction.chain(pressure).map(at).collect()))
    };
    airfoils.into_iter().map(one).collect()
}
