//! Cells of a web of a spar, between the columns at its corners.
//!
//! Layers that end at a corner have no thickness there, and all of it one cell away.

use super::super::super::distance;
use super::super::grid::Grid;
use super::cells::{Names, Row, knee_level};
use super::spar::{SparWall, WebWall};
use super::wall::Wall;

/// The ends of a web: nodes and depths below its outer face, by level.
struct End {
    nodes: Vec<u32>,
    depths: Vec<f64>,
}

/// Adds the cells of a web of a spar, `count` of a length along it; returns its nodes, by level from
/// the outside in, each from the suction to the pressure side.
pub(in super::super) fn add_spar_web(
    wall: &Wall,
    (spar, number): (&SparWall, usize),
    rows: &[Row],
    (names, count): (&Names<'_>, &dyn Fn(f64) -> usize),
    grid: &mut Grid,
) -> Vec<Vec<u32>> {
    let web = &spar.webs[number];
    // a corner that is no station of its own leaves the web out, which the checks find
    let ends = [0, 1].map(|side| end(wall, spar, (web, side), rows));
    let [Some(suction), Some(pressure)] = ends else {
        return Vec::new();
    };
    let lines = lines(wall, web, [&suction, &pressure], count, grid);
    let cells = web.layers.iter().flat_map(|layer| {
        let names = (names.web_cells)(number, *layer);
        std::iter::repeat_n(names, wall.stack.cells(*layer))
    });
    for (names, pair) in cells.zip(lines.windows(2)) {
        let [outer, inner] = [&pair[0], &pair[1]];
        grid.strip(
            if web.is_fore {
                [inner, outer]
            } else {
                [outer, inner]
            },
            &names,
        );
    }
    for (level, line) in lines.iter().enumerate() {
        let mut line = line.clone();
        if !web.is_fore {
            // clockwise around the spar
            line.reverse();
        }
        grid.curve(&line, &(names.web_lines)(number, level));
    }
    lines
}

/// The end of a web on a side: of both columns at the corner the one with the spar.
fn end(wall: &Wall, spar: &SparWall, (web, side): (&WebWall, usize), rows: &[Row]) -> Option<End> {
    let (stack, knee) = (&wall.stack, knee_level(wall, spar));
    let is_it = |row: &&Row| row.s == web.corners[side] && row.nodes.last() != row.nodes.get(knee);
    let row = rows.iter().find(is_it)?;
    let mut level = knee;
    let mut end = End {
        nodes: vec![row.nodes[knee]],
        depths: vec![0.0],
    };
    for (foot, layer) in web.feet[side].iter().zip(&web.layers) {
        for cell in 1..=stack.cells(*layer) {
            level = foot.map_or(level, |foot| stack.level(foot) + cell);
            end.nodes.push(*row.nodes.get(level)?);
            end.depths
                .push(row.column.depths[level] - row.column.depths[knee]);
        }
    }
    Some(end)
}

/// The nodes of a web by level.
fn lines(
    wall: &Wall,
    web: &WebWall,
    [suction, pressure]: [&End; 2],
    count: &dyn Fn(f64) -> usize,
    grid: &mut Grid,
) -> Vec<Vec<u32>> {
    let mut depths = vec![0.0];
    for layer in &web.layers {
        let (outer, cells) = (depths[depths.len() - 1], wall.stack.cells(*layer));
        let step = wall.stack.full(*layer) / cells as f64;
        depths.extend((1..=cells).map(|cell| outer + step * cell as f64));
    }
    let normal = web.inward();
    let levels = 0..suction.nodes.len();
    let ends = |level: usize| [suction, pressure].map(|end| grid.position(end.nodes[level]));
    let ends: Vec<[[f64; 2]; 2]> = levels.map(ends).collect();
    let longest = ends.iter().map(|[a, b]| distance(*a, *b));
    let count = count(longest.fold(0.0, f64::max));
    let mut lines = Vec::new();
    for (level, [a, b]) in ends.iter().enumerate() {
        let mut line = vec![suction.nodes[level]];
        for row in 1..count {
            let part = row as f64 / count as f64;
            let linear = |a: f64, b: f64| a + part * (b - a);
            let beyond = depths[level] - linear(suction.depths[level], pressure.depths[level]);
            let position = [0, 1].map(|i| linear(a[i], b[i]) + beyond * normal[i]);
            line.push(grid.node(position));
        }
        line.push(pressure.nodes[level]);
        lines.push(line);
    }
    lines
}
