//! Contours of sections: airfoils, scaled and blended along the span.
//!
//! Airfoils are points at equal parts of the length of each side. Between two positions along the
//! span they are interpolated linearly; over their relative thicknesses t by monotone cubics, at
//! the thickness of the section.

use std::f64::consts::TAU;

use shared_geom::document::{Document, Key, Table, read_text};
use shared_geom::units::rounded;

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

/// Positions of the origin on the chord [-].
const ORIGINS: [f64; 2] = [-1.0, 2.0];
/// Thickness of a section over the one of the thickest or thinnest airfoil within which that airfoil is
/// its shape [-].
const BEYOND: f64 = 1.1;
/// Least and largest x/c of the points of an airfoil, and the least distance of both.
const ENDS: [f64; 2] = [-0.5, 1.5];
const EXTENT: f64 = 0.3;
/// Part of the chord at its edges within which sides begin and end.
const EDGE: f64 = 0.1;

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
        let outside = airfoils.iter().find(|one| !(0.0..=1.0).contains(&one.0));
        let outside = outside.map(|one| one.0.to_string());
        let mut pairs = airfoils.windows(2);
        let turned = pairs.find(|pair| pair[1].0 <= pair[0].0);
        let turned = turned.map(|pair| format!("{} after {}", pair[1].0, pair[0].0));
        if let Some(found) = outside.or(turned) {
            return Err(LayupFileProblem::AirfoilOrder { found });
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

    /// The shape, if a blade can have its quantities.
    ///
    /// # Errors
    /// [`LayupFileProblem::Shape`]: a chord that is not positive, an origin far off the chord, a thickness
    /// that none of the airfoils is near to.
    pub(super) fn checked(self) -> Result<Self, LayupFileProblem> {
        let least = f64::MIN_POSITIVE;
        check(
            "chord",
            &self.chord,
            [least, f64::INFINITY],
            "a positive length",
        )?;
        let expected = format!("a part of the chord from {} to {}", ORIGINS[0], ORIGINS[1]);
        check("origin", &self.origin, ORIGINS, &expected)?;
        match self.airfoils.len() {
            1 => Ok(self),
            _ => self.near_airfoils(),
        }
    }

    /// The shape, if its thickness is near to the one of an airfoil, also of a single one.
    ///
    /// # Errors
    /// [`LayupFileProblem::Shape`]: a thickness that none of the airfoils is near to.
    pub(super) fn near_airfoils(self) -> Result<Self, LayupFileProblem> {
        let ends = self.airfoils.first().zip(self.airfoils.last());
        if let (Some(thickness), Some((first, last))) = (&self.thickness, ends) {
            let expected = match first.at == last.at {
                true => format!("about {}, as the airfoil has", first.at),
                false => format!("about {} to {}, as the airfoils have", first.at, last.at),
            };
            let range = [first.at / BEYOND, last.at * BEYOND];
            check("thickness", thickness, range, &expected)?;
        }
        Ok(self)
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
        let thickness = table.get(&RELATIVE_THICKNESS);
        let by_thickness = table.has(&RELATIVE_THICKNESS);
        if by_thickness && !table.has(&AIRFOILS) {
            table.wrong(
                &RELATIVE_THICKNESS,
                "[[shape.airfoils]] by their thicknesses",
            );
            return None;
        }
        let airfoils = if table.has(&AIRFOILS) {
            table.each(&AIRFOILS, |one| {
                let key = place_of_airfoil(one, by_thickness);
                let at = one.require_item(key, "a number from 0 to 1");
                let at = at.and_then(|_| one.get(key)?);
                let points = points(document, one);
                Some((at?, points?))
            })
        } else {
            points(document, table).map(|points| vec![(0.0, points)])
        };
        let made = Self::new([chord?, origin?, offset?], thickness?, airfoils?);
        made.and_then(Self::checked)
            .map_err(|problem| {
                let key = match &problem {
                    LayupFileProblem::Shape { key, .. } => key,
                    _ => AIRFOILS.name(),
                };
                table.note(key, &problem);
            })
            .ok()
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

/// The key of the place of an airfoil; the other one is noted.
fn place_of_airfoil(table: &Table<'_>, by_thickness: bool) -> &'static Key<Option<f64>> {
    let (key, other, reason, remedy) = if by_thickness {
        (
            &AT_THICKNESS,
            &AT_ETA,
            "[shape] has \"thickness\", by which airfoils are placed",
            "remove it, or remove \"thickness\" of [shape]",
        )
    } else {
        (
            &AT_ETA,
            &AT_THICKNESS,
            "[shape] has no \"thickness\", and airfoils are placed by \"eta\"",
            "remove it, or add to [shape] thickness = { eta = [0, 1], value = [1, 0.2] }",
        )
    };
    if table.has(other) {
        let key = other.name();
        table.note(
            other,
            &LayupFileProblem::IdlePlace {
                key,
                reason,
                remedy,
            },
        );
    }
    key
}

/// The points of one airfoil.
fn points(document: &Document, table: &Table<'_>) -> Option<Points> {
    if table.has(&CIRCLE) {
        let is_circle = table.get(&CIRCLE)?;
        if !is_circle {
            table.wrong(&CIRCLE, "true, or another airfoil in its place");
        }
        return is_circle.then(circle);
    }
    if table.has(&POINTS) && !table.has(&NACA) {
        let count = table.row_count(&POINTS).unwrap_or(1);
        let rows = table.rows(POINTS.name(), count, 2)?;
        let found: Points = rows.into_iter().map(|row| [row[0], row[1]]).collect();
        return scaled(found, table, POINTS.name());
    }
    if table.has(&FILE) && !table.has(&NACA) {
        let path = table.existing(&FILE, &table.get(&FILE)?)?;
        let text = document.keep(read_text(&path))?;
        let found = document.keep(airfoil_points(&text, &path.display().to_string()))?;
        return scaled(found, table, FILE.name());
    }
    let made = naca(&table.get(&NACA)?, false);
    let note = |problem: crate::mesh::generate::blade::BladeProblem| {
        table.note(&NACA, &LayupFileProblem::Points(problem.to_string()));
    };
    made.map_err(note).ok()
}

/// Points whose x is a part of the chord.
fn scaled(points: Points, table: &Table<'_>, key: &str) -> Option<Points> {
    let ends = points
        .iter()
        .fold([f64::INFINITY, -f64::INFINITY], |ends, [x, _]| {
            [ends[0].min(*x), ends[1].max(*x)]
        });
    let is_scaled = ends[0] >= ENDS[0] && ends[1] <= ENDS[1] && ends[1] - ends[0] >= EXTENT;
    if !is_scaled {
        let [from, to] = ends.map(rounded);
        let found =
            format!("points from x/c = {from} to {to}, expected parts of the chord, 0 to 1");
        table.note(key, &LayupFileProblem::Points(found));
    }
    let begins_again = points.windows(2).position(|pair| {
        let part = |x: f64| (x - ends[0]) / (ends[1] - ends[0]);
        part(pair[0][0]) > 1.0 - EDGE && part(pair[1][0]) < EDGE
    });
    let starts_ahead = points.first().is_some_and(|first| first[0] < EDGE);
    if let Some(row) = begins_again.filter(|_| is_scaled && starts_ahead) {
        table.note(key, &LayupFileProblem::NoseFirst { row: row + 2 });
        return None;
    }
    is_scaled.then_some(points)
}

/// Checks that all values of a quantity are in a range.
fn check(
    key: &'static str,
    course: &Course,
    [from, to]: [f64; 2],
    expected: &str,
) -> Result<(), LayupFileProblem> {
    match course
        .points()
        .find(|(_, value)| !(from..=to).contains(value))
    {
        None => Ok(()),
        Some((at, found)) => Err(LayupFileProblem::Shape {
            key,
            found,
            at,
            expected: expected.to_owned(),
        }),
    }
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
