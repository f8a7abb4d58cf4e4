//! Fills of the spaces between shell and webs as written.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Declared, Table, Value};

use super::place::{BothSides, Place};

/// A material that fills spaces.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenFill {
    /// Its name.
    pub name: String,
    /// Name of its material.
    pub material: String,
    /// Angle of the fiber from x toward the second axis of the material \[rad\].
    pub fiber_angle: f64,
    /// Angle of the second axis of the material from y \[rad\].
    pub plane_angle: f64,
    /// Its aft and its fore bound: the parts that it is ahead of and aft of.
    pub bounds: [Option<FillBound>; 2],
    /// First and last position along the span [-].
    pub range: [f64; 2],
    /// Its line in the file.
    pub line: usize,
}

/// A bound of a fill as written.
#[derive(Debug, Clone, PartialEq)]
pub enum FillBound {
    /// A web by its name, and the line of the file.
    Web(String, usize),
    /// A plane by its places on the suction and the pressure side.
    Plane(Box<[Place; 2]>),
}

impl WrittenFill {
    /// The places of its planes.
    pub fn places(&self) -> impl Iterator<Item = &Place> {
        let bounds = self.bounds.iter().flatten();
        bounds.flat_map(|bound| match bound {
            FillBound::Web(..) => [].iter(),
            FillBound::Plane(places) => places.iter(),
        })
    }

    /// The places of its planes.
    pub(super) fn places_mut(&mut self) -> impl Iterator<Item = &mut Place> {
        let bounds = self.bounds.iter_mut().flatten();
        bounds.flat_map(|bound| match bound {
            FillBound::Web(..) => [].iter_mut(),
            FillBound::Plane(places) => places.iter_mut(),
        })
    }

    /// The webs that bound it, with the lines of the file.
    pub(super) fn webs(&self) -> impl Iterator<Item = (&str, usize)> {
        self.bounds
            .iter()
            .flatten()
            .filter_map(|bound| match bound {
                FillBound::Web(name, line) => Some((name.as_str(), *line)),
                FillBound::Plane(_) => None,
            })
    }
}

impl Declared for FillBound {}

impl Value for FillBound {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if table.is_text(key) {
            return Some(Self::Web(table.text(key.name)?, table.line_of(key)));
        }
        BothSides::read(table, key).map(|both| Self::Plane(Box::new(both.0)))
    }
}
