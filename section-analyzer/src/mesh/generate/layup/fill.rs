//! Spaces inside of the wall, filled with triangles between their nodes.
//!
//! A space is a hole of the mesh of shell and webs: a closed chain of edges with cells, or the bound
//! of a fill, on one side. Webs and bounds cross the section, so that a space is on one side of each.

use super::super::grid::Grid;
use super::problem::LayupProblem;
use super::triangles::triangulate;
use super::types::{Bound, Fill, LayupSection, MOST_CELLS};
use super::webs::Standing;

/// Adds the cells of all fills, of at most this size. Each one takes the spaces in its bounds that
/// those before it leave; `lines` are the nodes of the bounds.
pub(super) fn add_fills(
    section: &LayupSection,
    size: f64,
    standing: &[Standing],
    lines: &[Vec<u32>],
    grid: &mut Grid,
) -> Result<(), LayupProblem> {
    if section.fills.is_empty() {
        return Ok(());
    }
    let mut spaces = grid.holes(lines);
    for fill in &section.fills {
        let is_within = |space: &[u32]| {
            let sides = [(&fill.aft_of, -1.0), (&fill.ahead_of, 1.0)];
            sides.into_iter().all(|(bound, sign)| {
                let bound = bound.as_ref().and_then(|bound| of(bound, standing));
                bound.is_none_or(|bound| sign * mean(space, bound, grid) > 0.0)
            })
        };
        let (own, others) = spaces.into_iter().partition(|space| is_within(space));
        let own: Vec<Vec<u32>> = own;
        spaces = others;
        if own.is_empty() {
            return Err(LayupProblem::NoSpace {
                fill: fill.name.clone(),
            });
        }
        for space in own {
            add(fill, size, &space, grid)?;
        }
    }
    Ok(())
}

/// The web or line of a bound.
fn of<'a>(bound: &Bound, standing: &'a [Standing]) -> Option<&'a Standing> {
    standing.iter().find(|one| match bound {
        Bound::Web(name) => one.is_web() && one.web.name == *name,
        Bound::Line(arcs) => !one.is_web() && one.web.arcs == *arcs,
    })
}

/// Mean distance of the nodes of a space from a line, positive ahead of it.
fn mean(space: &[u32], line: &Standing, grid: &Grid) -> f64 {
    let offsets = space.iter().map(|node| line.offset(grid.position(*node)));
    offsets.sum::<f64>() / space.len() as f64
}

/// Adds the cells of a fill in a space, whose nodes are counterclockwise.
fn add(fill: &Fill, size: f64, space: &[u32], grid: &mut Grid) -> Result<(), LayupProblem> {
    let found = (2.0 * grid.area(space).abs() / (size * size)) as usize;
    if found > MOST_CELLS {
        let most = MOST_CELLS;
        return Err(LayupProblem::TooManyCells { found, most });
    }
    let polygon: Vec<[f64; 2]> = space.iter().map(|node| grid.position(*node)).collect();
    let Some((added, triangles)) = triangulate(&polygon, size, MOST_CELLS) else {
        return Err(LayupProblem::SpaceShape {
            fill: fill.name.clone(),
            position: polygon[0],
        });
    };
    let mut nodes = space.to_vec();
    nodes.extend(added.into_iter().map(|position| grid.node(position)));
    let name = std::slice::from_ref(&fill.name);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| nodes[corner]);
        grid.cell([a, b, c, c], name);
    }
    Ok(())
}
