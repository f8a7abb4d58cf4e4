//! Nodes and cells of a wall and its webs.

use shared_geom::mesh::Mesh;

use super::super::super::distance;
use super::super::grid::Grid;
use super::KIND;
use super::butt::add_butt;
use super::cells::{Names, Row, lay, rows};
use super::fill::add_fills;
use super::problem::LayupProblem;
use super::spar_web::add_spar_web;
use super::stations::stations;
use super::types::{LayupSection, MOST_CELLS, SIDES};
use super::wall::Wall;
use super::webs::{Standing, stand};

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
    lay_named(wall, &rows, &mut grid);
    let mut lines = Vec::new();
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

/// Adds the cells of the layers and of the webs of the spar, with their names by side and web.
fn lay_named(wall: &Wall, rows: &[Row], grid: &mut Grid) {
    let side = |s: f64| SIDES[usize::from(s > wall.outline.nose())];
    let of = |layer: usize, part: &str| {
        let name = wall.stack.name(layer);
        vec![name.to_owned(), format!("{name}@{part}")]
    };
    let webs = || wall.spar.iter().flat_map(|spar| &spar.webs);
    let web = |number: usize| webs().nth(number);
    let levels = |number: usize| -> usize {
        let layers = web(number).into_iter().flat_map(|web| &web.layers);
        layers.map(|layer| wall.stack.cells(*layer)).sum()
    };
    let names = Names {
        cells: &|layer, s| of(layer, side(s)),
        lines: &|level, s| match level {
            0 => vec!["contour".to_owned(), format!("contour@{}", side(s))],
            _ => Vec::new(),
        },
        web_cells: &|number, layer| of(layer, web(number).map_or("", |web| &web.name)),
        web_lines: &|number, level| {
            let is_inner = level == levels(number);
            let name = web(number).filter(|_| is_inner).map(|web| web.name.clone());
            name.into_iter().collect()
        },
    };
    lay(wall, rows, &names, grid);
    let count = |length: f64| (length / wall.size).ceil().clamp(2.0, 2000.0) as usize;
    if let Some(spar) = &wall.spar {
        for number in 0..spar.webs.len() {
            add_spar_web(wall, (spar, number), rows, (&names, &count), grid);
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
    let pairs = feet[0].iter().zip(&feet[1]);
    let lines = pairs.map(|(a, b)| grid.divided([*a, *b], count));
    let mut lines: Vec<Vec<u32>> = lines.collect();
    let name = &web.web.name;
    for (pair, ply) in lines.windows(2).zip(&web.plies) {
        let ply = &web.web.plies[*ply].name;
        let names = [ply.clone(), format!("{ply}@{name}")];
        grid.strip([&pair[1], &pair[0]], &names);
    }
    let fore = lines.swap_remove(0);
    if !web.plies.is_empty() {
        let upward: Vec<u32> = fore.iter().rev().copied().collect();
        grid.curve(&upward, std::slice::from_ref(name));
    }
    fore
}
