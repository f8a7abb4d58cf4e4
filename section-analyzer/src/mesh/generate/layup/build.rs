//! Nodes and cells of a wall and its webs.

use std::collections::HashMap;

use shared_geom::mesh::Mesh;

use super::super::super::distance;
use super::super::grid::Grid;
use super::KIND;
use super::butt::add_butt;
use super::column::Column;
use super::fill::add_fills;
use super::problem::LayupProblem;
use super::spar::SIDES;
use super::spar::SparWall;
use super::stations::{Station, Stations, stations};
use super::types::{LayupSection, MOST_CELLS};
use super::wall::Wall;
use super::webs::{Standing, stand};

/// Distance of the middle of a side from its chord, as a part of it, beyond which the
/// sides of a column of cells are straight.
const CURVED: f64 = 0.12;

/// A column with its nodes.
struct Row {
    s: f64,
    column: Column,
    nodes: Vec<u32>,
}

/// The mesh of a wall and its webs.
pub(super) fn mesh(section: &LayupSection, wall: &Wall) -> Result<Mesh, LayupProblem> {
    let webs = stand(section, wall)?;
    let stations = stations(wall, &webs);
    let cells: usize = (0..wall.stack.len())
        .map(|layer| wall.stack.cells(layer))
        .sum();
    let found = stations.all.len().saturating_mul(cells);
    if found > MOST_CELLS {
        return Err(LayupProblem::TooManyCells {
            found,
            most: MOST_CELLS,
        });
    }
    let mut grid = Grid::default();
    let rows = rows(wall, &stations, &mut grid);
    let names = names(wall);
    let curves = SIDES.map(|side| ["contour".to_owned(), format!("contour@{side}")]);
    for pair in rows.windows(2).filter(|pair| pair[0].s < pair[1].s) {
        middles(wall, pair, &mut grid);
        let middle = 0.5 * (pair[0].s + pair[1].s);
        let is_pressure = middle.rem_euclid(wall.outline.perimeter()) > wall.outline.nose();
        let side = usize::from(is_pressure);
        let names = &names[side];
        for (level, names) in names.iter().enumerate() {
            let [a, b] = [&pair[0].nodes, &pair[1].nodes];
            grid.cell([a[level], a[level + 1], b[level + 1], b[level]], names);
        }
        grid.line([pair[0].nodes[0], pair[1].nodes[0]], &curves[side]);
    }
    let mut lines = Vec::new();
    if let Some(spar) = &wall.spar {
        add_spar_web(wall, spar, &rows, &mut grid);
    }
    for web in webs.iter().filter(|web| !web.is_spar) {
        let nodes = add_web(wall, web, &rows, &mut grid);
        lines.extend(Some(nodes).filter(|_| web.plies.is_empty()));
    }
    if let (Some(web), [first, .., last]) = (section.at_edge().next(), &rows[..]) {
        add_butt(web, [&first.nodes, &last.nodes], wall.size, &mut grid);
    }
    add_fills(section, wall.size, &webs, &lines, &mut grid)?;
    Ok(grid.mesh(KIND))
}

/// Physical surfaces of the cells of each level, on both sides.
fn names(wall: &Wall) -> [Vec<[String; 2]>; 2] {
    SIDES.map(|side| {
        let layers = 0..wall.stack.len();
        let of = |layer: usize| {
            let name = wall.stack.name(layer);
            let names = [name.to_owned(), format!("{name}@{side}")];
            std::iter::repeat_n(names, wall.stack.cells(layer))
        };
        layers.flat_map(of).collect()
    })
}

/// The columns at all stations, with new nodes.
fn rows(wall: &Wall, stations: &Stations, grid: &mut Grid) -> Vec<Row> {
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
        if let Some((spar, side)) = corner {
            // the same column without the spar, behind it
            let behind = outside(wall, spar, &rows[rows.len() - 1]);
            rows.insert(rows.len() - 1 + side, behind);
        }
    }
    rows
}

/// Level of the bend of columns.
fn knee_level(wall: &Wall, spar: &SparWall) -> usize {
    (0..spar.first).map(|layer| wall.stack.cells(layer)).sum()
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

/// The web of a spar between the columns at its corners.
fn add_spar_web(wall: &Wall, spar: &SparWall, rows: &[Row], grid: &mut Grid) {
    let knee = knee_level(wall, spar);
    let nodes = |s: f64| {
        // of both rows at a corner the one with the spar
        let at = rows.iter().filter(|row| row.s == s);
        let nodes = at.map(|row| {
            let mut nodes = row.nodes[knee..].to_vec();
            nodes.dedup();
            nodes
        });
        nodes.max_by_key(Vec::len).unwrap_or_default()
    };
    let plies = spar.layers.iter().flat_map(|layer| {
        let name = wall.stack.name(*layer);
        let names = [name.to_owned(), format!("{name}@{}", spar.web)];
        std::iter::repeat_n(names, wall.stack.cells(*layer))
    });
    let plies: Vec<[String; 2]> = plies.collect();
    let corners = spar.corners.map(nodes);
    // a corner that is no station of its own leaves the web out, which the checks find
    if corners.iter().all(|nodes| nodes.len() == plies.len() + 1) {
        spar.add_web(corners, &plies, wall.size, grid);
    }
}

/// The column at a station, and the number of its pair if it ends at a contact.
fn column_at(wall: &Wall, stations: &Stations, station: Station) -> (Column, Option<usize>) {
    let Some(number) = station.pair else {
        return (wall.column(station.s), None);
    };
    let (pair, weight) = &stations.pairs[number];
    let side = usize::from(station.s > wall.outline.nose());
    let column = wall.leaned(pair, side, *weight);
    let contact = column.is_closed.then_some(number);
    (column, contact)
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
            between.at(0.5 * depth)
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

/// Nodes and cells of a web or line between its feet; returns the nodes of its fore face.
fn add_web(wall: &Wall, web: &Standing, rows: &[Row], grid: &mut Grid) -> Vec<u32> {
    let foot = |side: usize| -> Vec<u32> {
        let nearest = |s: &f64| {
            let mut best = 0;
            for (index, row) in rows.iter().enumerate() {
                if (row.s - s).abs() < (rows[best].s - s).abs() {
                    best = index;
                }
            }
            rows[best].nodes[rows[best].nodes.len() - 1]
        };
        web.stations[side].iter().map(nearest).collect()
    };
    let feet = [foot(0), foot(1)];
    let height = |j: usize| distance(grid.position(feet[0][j]), grid.position(feet[1][j]));
    let longest = (0..feet[0].len()).map(height).fold(0.0, f64::max);
    let count = (longest / wall.size).ceil().clamp(2.0, 2000.0) as usize;
    let mut lines: Vec<Vec<u32>> = Vec::new();
    for j in 0..feet[0].len() {
        let ends = [grid.position(feet[0][j]), grid.position(feet[1][j])];
        let mut line = vec![feet[0][j]];
        for row in 1..count {
            let part = row as f64 / count as f64;
            line.push(grid.node([0, 1].map(|i| ends[0][i] + part * (ends[1][i] - ends[0][i]))));
        }
        line.push(feet[1][j]);
        lines.push(line);
    }
    let name = &web.web.name;
    for (j, ply) in web.plies.iter().enumerate() {
        let ply = &web.web.plies[*ply].name;
        let names = [ply.clone(), format!("{ply}@{name}")];
        let (fore, aft) = (&lines[j], &lines[j + 1]);
        for row in 0..count {
            grid.cell([aft[row], aft[row + 1], fore[row + 1], fore[row]], &names);
        }
    }
    let fore = lines.swap_remove(0);
    if !web.plies.is_empty() {
        for pair in fore.windows(2).rev() {
            grid.line([pair[1], pair[0]], std::slice::from_ref(name));
        }
    }
    fore
}
