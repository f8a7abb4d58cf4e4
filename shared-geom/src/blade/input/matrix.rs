//! The 6x6 matrices of a station, in declared units.

use nalgebra::Matrix6;

use super::columns::Measure;
use super::frame::Frame;
use super::problem::InputProblem;
use crate::document::{Document, Table};
use crate::units::Dimension;

/// A kind of 6x6 matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Stiffness,
    Mass,
}

impl Kind {
    /// The key of the whole matrix.
    pub fn key(self) -> &'static str {
        match self {
            Self::Stiffness => "stiffness",
            Self::Mass => "mass",
        }
    }

    /// The letter of its entries.
    fn letter(self) -> char {
        match self {
            Self::Stiffness => 'K',
            Self::Mass => 'M',
        }
    }

    /// The name of an entry: K11.
    pub fn entry(self, i: usize, j: usize) -> String {
        format!("{}{}{}", self.letter(), i + 1, j + 1)
    }

    /// Dimension of an entry: each moment adds a length.
    pub fn measure(self, document: &Document, frame: &Frame, i: usize, j: usize) -> Measure {
        let moments = usize::from(frame.is_moment(i)) + usize::from(frame.is_moment(j));
        let dimension = match (self, moments) {
            (Self::Stiffness, 0) => Dimension::FORCE,
            (Self::Stiffness, 1) => Dimension::MOMENT,
            (Self::Stiffness, _) => Dimension::BENDING_STIFFNESS,
            (Self::Mass, 0) => Dimension::MASS_PER_LENGTH,
            (Self::Mass, 1) => Dimension::MASS,
            (Self::Mass, _) => Dimension::INERTIA_PER_LENGTH,
        };
        // One unit for all entries, independent of the declared units.
        let base = match self {
            Self::Stiffness => document.factor(Dimension::FORCE),
            Self::Mass => document.factor(Dimension::MASS_PER_LENGTH),
        };
        let length = document.factor(Dimension::LENGTH);
        let factor = (0..moments).fold(base, |factor, _| factor * length);
        Measure { dimension, factor }
    }
}

/// The indices of an upper triangle, row by row.
pub(super) fn upper() -> impl Iterator<Item = (usize, usize)> {
    (0..6).flat_map(|i| (i..6).map(move |j| (i, j)))
}

/// Reads a matrix of a table: 6 rows of 6, or the 21 numbers of the upper triangle row
/// by row; in Helicoid's axes, SI.
pub(super) fn read(table: &Table<'_>, kind: Kind, frame: Option<&Frame>) -> Option<Matrix6<f64>> {
    let key = kind.key();
    let written = if table.is_nested(key) {
        let rows = table.rows(key, 6, 6)?;
        Matrix6::from_fn(|i, j| rows[i][j])
    } else {
        let numbers = table.quantities(key, Dimension::NUMBER)?;
        if numbers.len() != 21 {
            let problem = InputProblem::Count {
                key: key.to_owned(),
                found: numbers.len(),
                expected: "6 rows of 6 numbers, or the 21 of the upper triangle",
            };
            table.note(key, &problem);
            return None;
        }
        let mut matrix = Matrix6::zeros();
        for ((i, j), number) in upper().zip(numbers) {
            (matrix[(i, j)], matrix[(j, i)]) = (number, number);
        }
        matrix
    };
    let frame = frame?;
    let document = table.document();
    let in_si = |i, j| written[(i, j)] * kind.measure(document, frame, i, j).factor;
    Some(frame.matrix(&Matrix6::from_fn(in_si)))
}
