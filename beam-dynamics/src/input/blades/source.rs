//! Sources of the layout of a blade: pieces of its card, or a blade file.

use nalgebra::Vector3;
use shared_geom::document::Table;

use super::layout::BladeLayout;
use super::pieces::{self, Pieces};
use super::problem::BladeProblem;
use super::stations::{self, StationLine};
use crate::input::builder::ModelBuilder;

/// Keys of a blade of pieces.
const PIECE_KEYS: [&str; 2] = ["piece", "properties"];

/// Line and properties of a blade, in its own axes.
#[derive(Debug)]
pub(super) enum Source {
    /// Straight pieces.
    Pieces(Pieces),
    /// Stations along a line.
    Stations(Box<StationLine>),
}

/// Reads the pieces of the card, or its file.
pub(super) fn read(table: &Table<'_>, builder: &mut ModelBuilder, name: &str) -> Option<Source> {
    if !table.has("file") {
        return pieces::read(table, builder, name).map(Source::Pieces);
    }
    let mut sound = true;
    for key in PIECE_KEYS.into_iter().filter(|key| table.has(key)) {
        let blade = name.to_owned();
        table.note(key, &BladeProblem::FileAndPieces { blade, key });
        sound = false;
    }
    let stations = stations::read(table, builder)?;
    sound.then(|| Source::Stations(Box::new(stations)))
}

impl Source {
    /// Arc length of the tip \[m\].
    pub fn length(&self) -> f64 {
        match self {
            Self::Pieces(pieces) => pieces.line.length(),
            Self::Stations(stations) => stations.length(),
        }
    }

    /// The file, with its fingerprint.
    pub fn file(&self) -> Option<&str> {
        match self {
            Self::Pieces(_) => None,
            Self::Stations(stations) => Some(stations.file()),
        }
    }

    /// Position on the line at an arc length \[m\].
    pub fn position(&self, arc_length: f64) -> Vector3<f64> {
        match self {
            Self::Pieces(pieces) => pieces.line.position(arc_length),
            Self::Stations(stations) => stations.position(arc_length),
        }
    }

    /// Nodes and beams. A blade of stations has element ends at `masses`; the elements of a
    /// blade of pieces are given by the pieces.
    pub fn lay(&self, masses: &[f64], table: &Table<'_>) -> Option<BladeLayout> {
        match self {
            Self::Pieces(pieces) => Some(pieces.lay()),
            Self::Stations(stations) => stations.lay(masses, table),
        }
    }
}
