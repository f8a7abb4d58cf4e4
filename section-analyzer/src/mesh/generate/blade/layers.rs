//! Plies as layers of cells, along a closed path of intervals around a laminate.

use super::{Ply, SparPly};

/// A part of the path around a laminate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Upper,
    Lower,
    FrontWeb,
    RearWeb,
    /// The wall that closes a blunt trailing edge.
    Edge,
}

/// Cells of one thickness that belong to a ply.
#[derive(Debug, Clone)]
pub(super) struct Layer {
    /// The ply: index in the list of plies, outermost first.
    pub ply: usize,
    /// Thickness [unit of the mesh].
    pub thickness: f64,
    /// Whether its outer and its inner face are faces of the ply.
    pub faces: [bool; 2],
}

/// The layers of plies, from the outside in.
pub(super) fn layers<'a>(plies: impl Iterator<Item = &'a Ply>) -> Vec<Layer> {
    let of_ply = |(index, ply): (usize, &Ply)| {
        let cells = ply.cells.max(1);
        let thickness = ply.thickness / cells as f64;
        (0..cells).map(move |cell| Layer {
            ply: index,
            thickness,
            faces: [cell == 0, cell + 1 == cells],
        })
    };
    plies.enumerate().flat_map(of_ply).collect()
}

/// Thickness of all layers [unit of the mesh].
pub(super) fn thickness(layers: &[Layer]) -> f64 {
    layers.iter().map(|layer| layer.thickness).sum()
}

/// Content of a layer in an interval of the path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Content {
    /// The ply itself.
    Ply,
    /// The filler that replaces it.
    Filler,
    /// Nothing: the layer has no thickness.
    Nothing,
}

impl SparPly {
    /// Content of its layer on a part of the spar, at a chordwise position.
    pub(super) fn content(&self, part: Part, at: f64) -> Content {
        let is_within = |range: [f64; 2]| range[0] < at && at < range[1];
        let is_there = match part {
            Part::Upper => self.upper.is_some_and(is_within),
            Part::Lower => self.lower.is_some_and(is_within),
            Part::FrontWeb => self.webs[0],
            Part::RearWeb | Part::Edge => self.webs[1],
        };
        match (is_there, &self.filler) {
            (true, _) => Content::Ply,
            (false, Some(_)) => Content::Filler,
            (false, None) => Content::Nothing,
        }
    }
}

/// An interval of the path around a laminate.
#[derive(Debug, Clone)]
pub(super) struct Interval {
    pub part: Part,
    /// By layer.
    pub contents: Vec<Content>,
}

/// Depths of the levels at a station between two intervals [unit of the mesh]: a layer
/// that is missing in one of them has zero thickness at the station.
pub(super) fn depths(layers: &[Layer], before: &Interval, behind: &Interval) -> Vec<f64> {
    let mut depths = vec![0.0];
    let mut depth = 0.0;
    for (index, layer) in layers.iter().enumerate() {
        let is_in = |interval: &Interval| interval.contents[index] != Content::Nothing;
        if is_in(before) && is_in(behind) {
            depth += layer.thickness;
        }
        depths.push(depth);
    }
    depths
}
