//! Cores: cells between an upper and a lower wall.
//!
//! Lines from the lower to the upper node of each column have an even number of cells,
//! determined by their length, so that each line has a node in its middle. Between two
//! lines with equal numbers of cells are quadrilaterals, otherwise triangles, mirrored
//! about the middle:
//!
//! ```text
//!      *---*---*           *---*---*--.
//!      |   |   |           |   | / | \ \
//!      *---*---*           *---*---*---*   the nose, a line without length
//!      |   |   |           |   | \ | / /
//!      *---*---*           *---*---*--'
//! ```

use super::super::super::distance;
use super::super::grid::Grid;

/// Largest height of a cell, in widths.
const SQUARE: f64 = 2.0;

/// An even number of cells of about this size along a length.
pub(super) fn even_cells(length: f64, size: f64) -> usize {
    2 * ((0.5 * length / size).round().clamp(1.0, 1e6) as usize)
}

/// The nodes of lines between two walls, from the rear to the front, each upward.
///
/// `walls` are the nodes of the columns on the upper and on the lower wall; `ends` the
/// existing lines at the first and the last column.
pub(super) fn lines(
    grid: &mut Grid,
    walls: [&[u32]; 2],
    ends: [Vec<u32>; 2],
    size: f64,
) -> Vec<Vec<u32>> {
    let [upper, lower] = walls;
    let last = upper.len() - 1;
    let [first_line, last_line] = ends;
    let counts = [&first_line, &last_line].map(|line| line.len() - 1);
    let mut lines = vec![first_line];
    for column in 1..last {
        let (from, to) = (grid.position(lower[column]), grid.position(upper[column]));
        // toward an end the number decreases to the number of the end
        let near = (counts[0] + 2 * column).min(counts[1] + 2 * (last - column));
        let size = size.min(SQUARE * width(grid, walls, column));
        let count = even_cells(distance(from, to), size).min(near.max(2));
        let line = grid.divided([lower[column], upper[column]], count);
        lines.push(line);
    }
    lines.push(last_line);
    lines
}

/// Mean distance from a column to its neighbors.
fn width(grid: &Grid, walls: [&[u32]; 2], column: usize) -> f64 {
    let middle = |column: usize| {
        let ends = walls.map(|wall| grid.position(wall[column])[0]);
        0.5 * (ends[0] + ends[1])
    };
    0.5 * (middle(column + 1) - middle(column - 1)).abs()
}

/// The cells between two lines; the second lies ahead.
pub(super) fn strip(grid: &mut Grid, behind: &[u32], ahead: &[u32], name: &[String]) {
    if behind.len() == ahead.len() {
        return grid.strip([ahead, behind], name);
    }
    let middles = [behind, ahead].map(|line| line.len() / 2);
    let below = [&behind[..=middles[0]], &ahead[..=middles[1]]];
    for [a, b, c] in triangles(below) {
        grid.cell([a, b, c, c], name);
    }
    let above = [&behind[middles[0]..], &ahead[middles[1]..]]
        .map(|line| line.iter().rev().copied().collect::<Vec<u32>>());
    for [a, b, c] in triangles([&above[0], &above[1]]) {
        grid.cell([a, c, b, b], name);
    }
}

/// Triangles between two lines that start at the same end, using the next node of each in
/// turn; counterclockwise if the second line lies to the right.
fn triangles([behind, ahead]: [&[u32]; 2]) -> Vec<[u32; 3]> {
    let cells = [behind.len() - 1, ahead.len() - 1];
    let (mut i, mut j) = (0, 0);
    let mut found = Vec::with_capacity(cells[0] + cells[1]);
    while i < cells[0] || j < cells[1] {
        let takes_behind = (2 * i + 1) * cells[1] <= (2 * j + 1) * cells[0];
        if j == cells[1] || (i < cells[0] && takes_behind) {
            found.push([behind[i], ahead[j], behind[i + 1]]);
            i += 1;
        } else {
            found.push([behind[i], ahead[j], ahead[j + 1]]);
            j += 1;
        }
    }
    found
}
