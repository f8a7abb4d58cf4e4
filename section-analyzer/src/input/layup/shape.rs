//! Contours of sections: airfoils, scaled and blended along the span.
//!
//! Airfoils are points at equal parts of the length of each side. Between two positions along the
//! span they are interpolated linearly; over their relative thicknesses t by monotone cubics, at
//! the thickness of the section.

use std::f64::consts::TAU;

use shared_geom::document::{Document, Table, read_text};

use super::super::blade::airfoil_points;
use super::course::{Course, monotone};
use super::keys::{
    AIRFOILS, AT_ETA, AT_THICKNESS, CHORD, CIRCLE, FILE, NACA, OFFSET, ORIGIN, POINTS,
    RELATIVE_THICKNESS,
};
use super::place::refuse_trailing_edge;
use super::problem::LayupFileProblem;
use crate::mesh::generate::blade::naca;
use crate::mesh::generate::layup::Outline;

/// Points of each side of a blended airfoil.
const STEPS: usize = 160;

/// Points (x/c, z/c), from the trailing edge over the suction side to the nose and back.
pub type Points = Vec<[f64; 2]>;

/// The contours along the span.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Chord \[m\].
    pub chord: Course,
    /// Position of the origin on the chord [-].
    pub origin: Course,
    /// Distance of the chord line from the origin, toward the suction side \[m\].
    pub offset: Course,
    /// Thickness over chord, if the airfoils are given by theirs [-].
    pub thickness: Option<Course>,
    /// In ascending order of their positions.
    airfoils: Vec<Airfoil>,
}

/// An airfoil.
#[derive(Debug, Clone, PartialEq)]
struct Airfoil {
    /// Its position along the span, or its relative thickness.
    at: f64,
    written: Points,
    /// At equal parts of the length of each side; as written if it is the only one.
    even: Points,
}

impl Shape {
    /// The contours of airfoils at positions along the span, or at thicknesses if there is a curve
    /// of the thickness.
    ///
    /// # Errors
    /// Points that are no airfoil, or positions that are not ascending.
    pub(super) fn new(
        [chord, origin, offset]: [Course; 3],
        thickness: Option<Course>,
        airfoils: Vec<(f64, Points)>,
    ) -> Result<Self, LayupFileProblem> {
        if airfoils.is_empty() {
            return Err(LayupFileProblem::Airfoil { found: 0 });
        }
        let is_in_order = airfoils.windows(2).all(|pair| pair[1].0 > pair[0].0);
        if !is_in_order || airfoils.iter().any(|one| !(0.0..=1.0).contains(&one.0)) {
            return Err(LayupFileProblem::AirfoilOrder);
        }
        let is_one = airfoils.len() == 1;
        let airfoil = |(at, written): (f64, Points)| {
            let even = if is_one {
                written.clone()
            } else {
                even(&written)?
            };
            Ok(Airfoil { at, written, even })
        };
        let airfoils: Result<_, LayupFileProblem> = airfoils.into_iter().map(airfoil).collect();
        Ok(Self {
            chord,
            origin,
            offset,
            thickness,
            airfoils: airfoils?,
        })
    }

    /// Reads `[shape]`.
    pub(super) fn read(document: &Document, table: &Table<'_>) -> Option<Self> {
        refuse_trailing_edge(table);
        let (chord, origin, offset) = (table.get(&CHORD), table.get(&ORIGIN), table.get(&OFFSET));
        let families = [NACA.name(), FILE.name(), POINTS.name(), AIRFOILS.name()];
        let found = families.iter().filter(|key| table.has(key)).count();
        if found != 1 {
            table.note("", &LayupFileProblem::Airfoil { found });
            return None;
        }
        if let Some(origin) = &origin
            && origin.positions().is_empty()
            && !(-1.0..=2.0).contains(&origin.at(0.0))
        {
            table.wrong(&ORIGIN, "a part of the chord from -1 to 2");
            return None;
        }
        let thickness = table.get(&RELATIVE_THICKNESS);
        let by_thickness = table.has(&RELATIVE_THICKNESS);
        let airfoils = if table.has(&AIRFOILS) {
            table.each(&AIRFOILS, |one| {
                let key = if by_thickness { &AT_THICKNESS } else { &AT_ETA };
                let at = one.require_item(key, "a number from 0 to 1");
                let at = at.and_then(|_| one.get(key)?);
                let points = points(document, one);
                Some((at?, points?))
            })
        } else {
            points(document, table).map(|points| vec![(0.0, points)])
        };
        let made = Self::new([chord?, origin?, offset?], thickness?, airfoils?);
        made.map_err(|problem| table.note(&AIRFOILS, &problem)).ok()
    }

    /// The contour at a position along the span: points (y, z) \[m\].
    pub fn contour(&self, eta: f64) -> Points {
        let (chord, origin) = (self.chord.at(eta), self.origin.at(eta));
        let offset = self.offset.at(eta);
        let place = |[x, z]: [f64; 2]| [(origin - x) * chord, z * chord + offset];
        let all = &self.airfoils;
        if all.len() == 1 {
            return all[0].even.iter().copied().map(place).collect();
        }
        let last = all.len() - 1;
        let by = self.thickness.as_ref().map_or(eta, |t| t.at(eta));
        let at = by.clamp(all[0].at, all[last].at);
        let positions: Vec<f64> = all.iter().map(|one| one.at).collect();
        let before = positions.partition_point(|one| *one <= at).clamp(1, last) - 1;
        let part = (at - positions[before]) / (positions[before + 1] - positions[before]);
        let blend = |i: usize, k: usize| match self.thickness {
            Some(_) => monotone(&positions, &|one| all[one].even[i][k], at),
            None => (1.0 - part) * all[before].even[i][k] + part * all[before + 1].even[i][k],
        };
        let point = |i: usize| place([blend(i, 0), blend(i, 1)]);
        (0..all[0].even.len()).map(point).collect()
    }

    /// The airfoils as written: position along the span, or relative thickness if it is
    /// given along the span, and points.
    pub fn airfoils(&self) -> impl Iterator<Item = (f64, &Points)> {
        self.airfoils.iter().map(|one| (one.at, &one.written))
    }

    /// The quantities along the span.
    pub(super) fn courses_mut(&mut self) -> Vec<&mut Course> {
        let mut all = vec![&mut self.chord, &mut self.origin, &mut self.offset];
        all.extend(&mut self.thickness);
        all
    }

    /// Positions of the airfoils and of the tables.
    pub fn positions(&self) -> Vec<f64> {
        let mut all: Vec<f64> = match (self.airfoils.len(), &self.thickness) {
            (1, _) => Vec::new(),
            (_, Some(thickness)) => thickness.positions().to_vec(),
            (_, None) => self.airfoils.iter().map(|one| one.at).collect(),
        };
        for course in [&self.chord, &self.origin, &self.offset] {
            all.extend(course.positions());
        }
        all
    }
}

/// The points of one airfoil.
fn points(document: &Document, table: &Table<'_>) -> Option<Points> {
    if table.has(&CIRCLE) {
        return table.get(&CIRCLE).map(|_| circle());
    }
    if table.has(&POINTS) && !table.has(&NACA) {
        let count = table.row_count(&POINTS).unwrap_or(1);
        let rows = table.rows(POINTS.name(), count, 2)?;
        return Some(rows.into_iter().map(|row| [row[0], row[1]]).collect());
    }
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
        let angle = TAU * i as f64 / STEPS as f64;
        [0.5 + 0.5 * angle.cos(), 0.5 * angle.sin()]
    };
    (0..=STEPS).map(at).collect()
}

/// An airfoil by points at equal parts of the length of each side.
fn even(points: &Points) -> Result<Points, LayupFileProblem> {
    let turned: Points = points.iter().map(|[x, z]| [-x, *z]).collect();
    let outline = Outline::new(&turned);
    let outline = outline.map_err(|problem| LayupFileProblem::Points(problem.to_string()))?;
    let ([from, to], nose) = (outline.corners(), outline.nose());
    let part = |i: usize| i as f64 / STEPS as f64;
    let suction = (0..STEPS).map(|i| from + (nose - from) * part(i));
    let pressure = (0..=STEPS).map(|i| nose + (to - nose) * part(i));
    let at = |s: f64| {
        let [y, z] = outline.position(s);
        [-y, z]
    };
    Ok(suction.chain(pressure).map(at).collect())
}
