//! Columns of a wall with their nodes, and the cells between them.

use std::collections::HashMap;

use super::super::super::distance;
use super::super::grid::Grid;
use super::column::Column;
use super::spar::SparWall;
use super::stations::{Station, Stations};
use super::wall::Wall;

/// Distance of the middle of a side from its chord, as a part of it, beyond which the
/// sides of a column of cells are straight.
const CURVED: f64 = 0.12;

/// A column with its nodes.
#[derive(Debug, Clone)]
pub(in super::super) struct Row {
    /// Arc length.
    pub s: f64,
    pub column: Column,
    /// From the outside in, one for each level.
    pub nodes: Vec<u32>,
}

/// Names of the physical groups of a wall.
pub(in super::super) struct Names<'a> {
    /// Surfaces of the cells of a layer at an arc length.
    pub cells: &'a dyn Fn(usize, f64) -> Vec<String>,
    /// Curves of the sides of cells on a level at an arc length.
    pub lines: &'a dyn Fn(usize, f64) -> Vec<String>,
    /// Surfaces of the cells of a layer along a web of the spar.
    pub web_cells: &'a dyn Fn(usize, usize) -> Vec<String>,
    /// Curves of the sides of cells along a web of the spar, on a level of it.
    pub web_lines: &'a dyn Fn(usize, usize) -> Vec<String>,
}

/// The columns at all stations, with new nodes.
pub(in super::super) fn rows(wall: &Wall, stations: &Stations, grid: &mut Grid) -> Vec<Row> {
    let mut shared: HashMap<usize, u32> = HashMap::new();
    let mut rows: Vec<Row> = Vec::with_capacity(stations.all.len());
    let is_ring = wall.edge.is_ring();
    for (index, station) in stations.all.iter().enumerate() {
        let (column, contact) = column_at(wall, stations, *station);
        if is_ring && index + 1 == stations.all.len() {
            // the first column again
            let nodes = rows[0].nodes.clone();
            rows.push(Row {
                s: station.s,
                column,
                nodes,
            });
            break;
        }
        let last = column.depths[column.depths.len() - 1];
        let mut nodes = vec![grid.node(column.point)];
        for pair in column.depths.windows(2) {
            let outer = nodes[nodes.len() - 1];
            let node = if pair[1] <= pair[0] {
                outer
            } else if let Some(pair_number) = contact.filter(|_| pair[1] >= last) {
                *shared
                    .entry(pair_number)
                    .or_insert_with(|| grid.node(column.at(last)))
            } else {
                grid.node(column.at(pair[1]))
            };
            nodes.push(node);
        }
        rows.push(Row {
            s: station.s,
            column,
            nodes,
        });
        let spar = wall.spar.as_ref();
        let corner = spar.and_then(|spar| Some((spar, spar.corner_at(station.s)?)));
        if let Some((spar, (web, side))) = corner {
            // the same column without the spar, beyond it
            let beyond = outside(wall, spar, &rows[rows.len() - 1]);
            let is_before = (side == 0) != web.is_fore;
            rows.insert(rows.len() - usize::from(is_before), beyond);
        }
    }
    rows
}

/// Level of the bend of columns.
pub(in super::super) fn knee_level(wall: &Wall, spar: &SparWall) -> usize {
    wall.stack.level(spar.first)
}

/// The column at a corner of a spar without the layers inside of it.
fn outside(wall: &Wall, spar: &SparWall, row: &Row) -> Row {
    let knee = knee_level(wall, spar);
    let ended = |level: usize| level.min(knee);
    let levels = 0..row.nodes.len();
    Row {
        s: row.s,
        nodes: levels
            .clone()
            .map(|level| row.nodes[ended(level)])
            .collect(),
        column: Column {
            depths: levels
                .map(|level| row.column.depths[ended(level)])
                .collect(),
            ..row.column.clone()
        },
    }
}

/// The column at a station, and the number of its pair if it ends at a contact.
fn column_at(wall: &Wall, stations: &Stations, station: Station) -> (Column, Option<usize>) {
    let Some(number) = station.pair else {
        return (wall.column(station.s), None);
    };
    let (pair, lean) = &stations.pairs[number];
    let side = usize::from(station.s > wall.outline.nose());
    let column = wall.leaned(pair, side, *lean);
    // all columns of a fan end in one node
    let end = if pair.is_fan() { usize::MAX } else { number };
    let contact = column.is_closed.then_some(end);
    (column, contact)
}

/// The cells between columns, and their sides on curves.
pub(in super::super) fn lay(wall: &Wall, rows: &[Row], names: &Names<'_>, grid: &mut Grid) {
    let layers = 0..wall.stack.len();
    let levels = layers.flat_map(|layer| std::iter::repeat_n(layer, wall.stack.cells(layer)));
    let levels: Vec<usize> = levels.collect();
    for pair in rows.windows(2).filter(|pair| pair[0].s < pair[1].s) {
        middles(wall, pair, grid);
        let middle = (0.5 * (pair[0].s + pair[1].s)).rem_euclid(wall.outline.perimeter());
        let [a, b] = [&pair[0].nodes, &pair[1].nodes];
        for (level, layer) in levels.iter().enumerate() {
            let corners = [a[level], a[level + 1], b[level + 1], b[level]];
            grid.cell(corners, &(names.cells)(*layer, middle));
        }
        for level in 0..a.len() {
            grid.curve(&[a[level], b[level]], &(names.lines)(level, middle));
        }
    }
}

/// Middle nodes of the sides along the contour between two columns.
fn middles(wall: &Wall, rows: &[Row], grid: &mut Grid) {
    let [a, b] = [&rows[0], &rows[1]];
    let between = wall.column(0.5 * (a.s + b.s));
    let is_contact = a.column.is_closed && b.column.is_closed;
    let levels = a.nodes.len();
    let chord = |level: usize| {
        let ends = [a.nodes[level], b.nodes[level]].map(|node| grid.position(node));
        (
            [0, 1].map(|i| 0.5 * (ends[0][i] + ends[1][i])),
            distance(ends[0], ends[1]),
        )
    };
    let (outer, _) = chord(0);
    let bulge = [0, 1].map(|i| between.point[i] - outer[i]);
    let whole = a.column.depths[levels - 1] + b.column.depths[levels - 1];
    let mut middles = Vec::with_capacity(levels);
    for level in 0..levels {
        let depth = a.column.depths[level] + b.column.depths[level];
        let (middle, length) = chord(level);
        let position = if is_contact {
            let fade = 1.0 - depth / whole;
            [0, 1].map(|i| middle[i] + fade * bulge[i])
        } else {
            match &between.bend {
                None => between.at(0.5 * depth),
                Some(bend) => {
                    let off = [a, b].map(|row| {
                        let ends = [0, level].map(|level| grid.position(row.nodes[level]));
                        let along = |i: usize| (ends[1][i] - ends[0][i]) * bend.direction[i];
                        along(0) + along(1)
                    });
                    between.beside(0.5 * depth, 0.5 * (off[0] + off[1]))
                }
            }
        };
        if distance(position, middle) > CURVED * length {
            return;
        }
        middles.push(position);
    }
    for (level, position) in middles.into_iter().enumerate() {
        let is_shared = is_contact && a.column.depths[level] + b.column.depths[level] >= whole;
        if !is_shared {
            grid.middle(a.nodes[level], b.nodes[level], position);
        }
    }
}
