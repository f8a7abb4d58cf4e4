//! Layers of the shell: equal layers of segments side by side are one layer.
//!
//! The layers of all segments are merged into one list that has the layers of each segment in
//! their order, as a shortest common supersequence, segment by segment.

use super::super::course::Course;
use super::super::place::Place;
use super::super::{Toward, WrittenLayer};
use super::components::Segment;
use super::contour::Piece;
use super::layups::Ply;

/// Relative difference of thicknesses, and difference of angles \[deg\], of equal layers.
const SAME: f64 = 1e-9;
/// Part of the contour within which a layer ends at the trailing edge.
const EDGE: f64 = 1e-7;

/// The layers of the pieces of a contour, from the outside in.
pub(super) fn layers(segments: &[&Segment<'_>], pieces: &[Piece]) -> Vec<WrittenLayer> {
    let plies: Vec<Vec<Ply>> = pieces.iter().map(|piece| turned(segments, piece)).collect();
    let rows = merged(&plies);
    let mut layers = Vec::new();
    for row in rows {
        for (first, last) in runs(&row) {
            let (number, piece) = (row[first].unwrap_or(0), pieces[first]);
            let segment = segments[piece.segment];
            let layer = Named {
                name: format!("{}_{}", segment.name, number + 1),
                ply: &plies[first][number],
                line: segment.element.line(),
            };
            let is_all = row.iter().all(Option::is_some);
            let arcs = if is_all {
                [0.0, 1.0]
            } else {
                [piece.arcs[0], pieces[last].arcs[1]]
            };
            layers.extend(layer.written(arcs));
        }
    }
    layers
}

/// The layers of a segment with their angles along the contour.
fn turned(segments: &[&Segment<'_>], piece: &Piece) -> Vec<Ply> {
    let sign = if piece.is_along { 1.0 } else { -1.0 };
    let mut plies = segments[piece.segment].plies.clone();
    plies.iter_mut().for_each(|ply| ply.angle *= sign);
    plies
}

/// A layer before its places.
struct Named<'a> {
    name: String,
    ply: &'a Ply,
    line: usize,
}

impl Named<'_> {
    /// The layer between two arcs; two layers if it runs through the trailing edge.
    fn written(&self, [from, to]: [f64; 2]) -> Vec<WrittenLayer> {
        let from = if from > 1.0 - EDGE { 0.0 } else { from };
        let to = if to < EDGE { 1.0 } else { to };
        if from < to {
            return vec![self.layer(&self.name, [from, to])];
        }
        let names = ["first", "last"].map(|end| format!("{}_{end}", self.name));
        vec![
            self.layer(&names[0], [0.0, to]),
            self.layer(&names[1], [from, 1.0]),
        ]
    }

    fn layer(&self, name: &str, arcs: [f64; 2]) -> WrittenLayer {
        let named = (name.to_owned(), self.ply.material.clone());
        let thickness = Course::constant(self.ply.thickness);
        WrittenLayer {
            fiber_angle: Course::constant(self.ply.angle.to_radians()),
            toward: Toward::Contour,
            ..WrittenLayer::plain(named, thickness, arcs.map(Place::arc), self.line)
        }
    }
}

/// Whether two layers are equal.
fn is_same(a: &Ply, b: &Ply) -> bool {
    a.material == b.material
        && (a.thickness - b.thickness).abs() <= SAME * a.thickness
        && (a.angle - b.angle).abs() <= SAME
}

/// A layer of some pieces: the depth of its middle, and its number in each of them.
struct Row {
    ply: Ply,
    depth: f64,
    numbers: Vec<Option<usize>>,
}

/// Rows of layers: for each piece the number of its layer, or none. Between common layers they
/// are in the order of their depths, so that walls of other layers meet at equal depths.
fn merged(plies: &[Vec<Ply>]) -> Vec<Vec<Option<usize>>> {
    let mut all: Vec<Row> = Vec::new();
    for (piece, own) in plies.iter().enumerate() {
        let known: Vec<&Ply> = all.iter().map(|one| &one.ply).collect();
        let common = common(&known, own);
        let mut next: Vec<Row> = Vec::with_capacity(all.len() + own.len());
        let mut depth = 0.0;
        let mut old = all.into_iter().enumerate().peekable();
        for (number, ply) in own.iter().enumerate() {
            let middle = depth + 0.5 * ply.thickness;
            depth += ply.thickness;
            let partner = common
                .iter()
                .find(|pair| pair.1 == number)
                .map(|pair| pair.0);
            // rows before the next common one may precede this layer
            let end = common
                .iter()
                .find(|pair| pair.1 >= number)
                .map_or(usize::MAX, |pair| pair.0);
            let is_before =
                |(i, row): &(usize, Row)| *i < end && (partner.is_some() || row.depth <= middle);
            while let Some((_, row)) = old.next_if(is_before) {
                next.push(row);
            }
            let mut row = match partner.and_then(|_| old.next()) {
                Some((_, row)) => row,
                None => Row {
                    ply: ply.clone(),
                    depth: middle,
                    numbers: vec![None; plies.len()],
                },
            };
            row.numbers[piece] = Some(number);
            next.push(row);
        }
        next.extend(old.map(|one| one.1));
        all = next;
    }
    all.into_iter().map(|one| one.numbers).collect()
}

/// The longest common sequence of two lists: pairs of numbers.
fn common(known: &[&Ply], own: &[Ply]) -> Vec<(usize, usize)> {
    let mut longest = vec![vec![0_u32; own.len() + 1]; known.len() + 1];
    for i in (0..known.len()).rev() {
        for j in (0..own.len()).rev() {
            longest[i][j] = if is_same(known[i], &own[j]) {
                longest[i + 1][j + 1] + 1
            } else {
                longest[i + 1][j].max(longest[i][j + 1])
            };
        }
    }
    let (mut i, mut j) = (0, 0);
    let mut pairs = Vec::new();
    while i < known.len() && j < own.len() {
        if is_same(known[i], &own[j]) {
            pairs.push((i, j));
            (i, j) = (i + 1, j + 1);
        } else if longest[i + 1][j] >= longest[i][j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    pairs
}

/// Intervals of pieces side by side that have a layer, around the contour: first and last piece.
fn runs(row: &[Option<usize>]) -> Vec<(usize, usize)> {
    let count = row.len();
    let has = |i: usize| row[i % count].is_some();
    let Some(gap) = (0..count).find(|i| !has(*i)) else {
        return vec![(0, count - 1)];
    };
    let mut runs: Vec<(usize, usize)> = Vec::new();
    let mut is_open = false;
    for i in gap + 1..gap + count {
        match (has(i), is_open) {
            (true, true) => runs
                .last_mut()
                .into_iter()
                .for_each(|run| run.1 = i % count),
            (true, false) => runs.push((i % count, i % count)),
            (false, _) => {}
        }
        is_open = has(i);
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::{Ply, merged, runs};

    fn plies(angles: &[f64]) -> Vec<Ply> {
        let ply = |angle: &f64| Ply {
            material: "glass".into(),
            thickness: 1.0,
            angle: *angle,
        };
        angles.iter().map(ply).collect()
    }

    /// Each list is a part of the rows in its own order, and equal layers share a row.
    #[test]
    fn lists_are_merged() {
        let lists = [
            [1.0, 2.0, 3.0].as_slice(),
            &[1.0, 3.0],
            &[1.0, 4.0, 3.0],
            &[5.0],
        ];
        let rows = merged(&lists.map(plies));
        assert_eq!(rows.len(), 5, "{rows:?}");
        for (piece, list) in lists.iter().enumerate() {
            let own: Vec<usize> = rows.iter().filter_map(|row| row[piece]).collect();
            assert_eq!(own, (0..list.len()).collect::<Vec<_>>());
        }
    }

    /// Random lists of few kinds of layers: each is found in its order.
    #[test]
    fn random_lists_are_merged() {
        let mut state = 1_u64;
        let mut next = |count: u64| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) % count
        };
        for _ in 0..300 {
            let mut list = || (0..next(6)).map(|_| next(4) as f64).collect::<Vec<f64>>();
            let lists: Vec<Vec<f64>> = (0..4).map(|_| list()).collect();
            let rows = merged(&lists.iter().map(|one| plies(one)).collect::<Vec<_>>());
            for (piece, list) in lists.iter().enumerate() {
                let own: Vec<usize> = rows.iter().filter_map(|row| row[piece]).collect();
                assert_eq!(own, (0..list.len()).collect::<Vec<_>>(), "{lists:?}");
            }
            for row in &rows {
                let angles: Vec<f64> = (0..4).filter_map(|k| row[k].map(|j| lists[k][j])).collect();
                assert!(
                    angles.windows(2).all(|pair| pair[0] == pair[1]),
                    "{lists:?}"
                );
            }
        }
    }

    #[test]
    fn runs_go_around() {
        let row = |text: &str| -> Vec<Option<usize>> {
            text.chars().map(|one| (one == 'x').then_some(0)).collect()
        };
        assert_eq!(runs(&row("xxx")), [(0, 2)]);
        assert_eq!(runs(&row("x.xx")), [(2, 0)]);
        assert_eq!(runs(&row(".xx.x")), [(1, 2), (4, 4)]);
        assert!(runs(&row("...")).is_empty());
    }
}
