//! The skin: plies all around, from the contour inward.

use super::super::super::distance;
use super::Blade;
use super::columns::Columns;
use super::contour::{Edge, Half, Straight};
use super::fill::even_cells;
use super::grid::Grid;
use super::layers::{Content, Interval, Layer, Part};
use super::problem::{BladePart, BladeProblem};
use super::walls::{Shift, Station, Wall, moved, nodes, part_of};

/// Fraction of the surface behind the rear web in which nodes move with a corner at the
/// trailing edge.
const MOST: f64 = 0.5;
/// Fraction of this length that the corner itself may use.
const FULL: f64 = 0.6;
/// Least thickness of a trailing edge with a wall, in thicknesses of the skin.
const LEAST_EDGE: f64 = 2.2;

/// The inner face of the skin.
#[derive(Debug)]
pub(super) struct Skin {
    /// Nodes of the columns: on the upper and the lower surface.
    pub inner: [Vec<u32>; 2],
    /// Nodes of the line that closes the section at the rear, upward.
    pub edge: Vec<u32>,
}

/// Makes the skin.
pub(super) fn build(
    blade: &Blade,
    columns: &Columns,
    layers: &[Layer],
    grid: &mut Grid,
) -> Result<Skin, Vec<BladeProblem>> {
    let levels = layers.len() + 1;
    let mut depths = vec![0.0];
    for layer in layers {
        depths.push(depths[depths.len() - 1] + layer.thickness);
    }
    let contour = &blade.contour;
    let closing = closing(blade, columns, &depths)?;
    let nose = columns.nose();
    let mut stations = stations(blade, columns, &depths, &closing, grid);
    let is_joined = blade.is_closed && contour.edge() != Edge::Blunt;
    if is_joined {
        let last = closing[1].by.iter().map(|by| columns.lower[0] + by);
        stations[0].before = last.collect();
    } else {
        let way = (blade, columns, &depths[..]);
        stations.push(station(way, &closing, (Half::Lower, 0), grid));
    }
    let inner = |station: &Station| station.nodes[levels - 1];
    let upper: Vec<u32> = stations[..=nose].iter().map(inner).collect();
    let mut lower: Vec<u32> = stations[nose..].iter().map(inner).collect();
    if is_joined {
        lower.push(upper[0]);
    }
    lower.reverse();
    let mut edge = vec![lower[0], upper[0]];
    let along = |part: Part| Interval {
        part,
        contents: vec![Content::Ply; layers.len()],
    };
    let mut intervals = vec![along(part_of(Half::Upper)); nose];
    intervals.extend(vec![along(part_of(Half::Lower)); nose]);
    if blade.is_closed && contour.edge() == Edge::Blunt {
        edge = close(grid, &mut stations, &depths, blade);
        intervals.extend(vec![along(Part::Edge); edge.len() - 1]);
    } else if is_joined {
        edge = vec![upper[0]];
    }
    let wall = Wall {
        contour,
        depth: 0.0,
        layers,
        stations: &stations,
        intervals: &intervals,
        curve: "contour",
        group: &|ply, _| (blade.skin[ply].name.clone(), blade.skin[ply].has_faces),
        part: &part_name,
    };
    wall.build(grid);
    let inner = [upper, lower];
    Ok(Skin { inner, edge })
}

fn part_name(part: Part) -> &'static str {
    match part {
        Part::Upper => "upper",
        Part::Lower => "lower",
        _ => "edge",
    }
}

/// The stations of both surfaces, except the last one of the lower surface.
fn stations(
    blade: &Blade,
    columns: &Columns,
    depths: &[f64],
    closing: &[Shift; 2],
    grid: &mut Grid,
) -> Vec<Station> {
    let nose = columns.nose();
    let upper = (0..=nose).map(|column| (Half::Upper, column));
    let lower = (1..nose).rev().map(|column| (Half::Lower, column));
    let way = (blade, columns, depths);
    let all = upper.chain(lower);
    all.map(|at| station(way, closing, at, grid)).collect()
}

fn station(
    (blade, columns, depths): (&Blade, &Columns, &[f64]),
    closing: &[Shift; 2],
    (half, column): (Half, usize),
    grid: &mut Grid,
) -> Station {
    let u = columns.at(half, column);
    let at = moved(u, depths.len(), &[&closing[half as usize]]);
    let nodes = nodes(grid, None, depths, |level| {
        blade.contour.offset(at[level], depths[level])
    });
    Station {
        nodes,
        depths: depths.to_vec(),
        before: at.clone(),
        behind: at,
    }
}

/// The stations of the wall at a blunt trailing edge, after the stations of the surfaces;
/// returns its inner nodes, upward.
fn close(grid: &mut Grid, stations: &mut Vec<Station>, depths: &[f64], blade: &Blade) -> Vec<u32> {
    let last = depths.len() - 1;
    let (from, to) = (stations[stations.len() - 1].clone(), stations[0].clone());
    let corners = [&from, &to].map(|station| {
        let position = |node: &u32| grid.position(*node);
        station.nodes.iter().map(position).collect::<Vec<_>>()
    });
    let count = even_cells(distance(corners[0][0], corners[1][0]), blade.sizes.size);
    let mut inner = vec![from.nodes[last]];
    for cell in 1..count {
        let part = cell as f64 / count as f64;
        let nodes = nodes(grid, None, depths, |level| {
            [0, 1].map(|i| (1.0 - part) * corners[0][level][i] + part * corners[1][level][i])
        });
        inner.push(nodes[last]);
        stations.push(Station {
            nodes,
            depths: depths.to_vec(),
            ..Station::default()
        });
    }
    inner.push(to.nodes[last]);
    inner
}

/// Shifts of the two surfaces due to the trailing edge.
fn closing(
    blade: &Blade,
    columns: &Columns,
    depths: &[f64],
) -> Result<[Shift; 2], Vec<BladeProblem>> {
    let contour = &blade.contour;
    let at = [columns.upper[0], columns.lower[0]];
    let rest = |half: usize| Shift::new(at[half], &vec![at[half]; depths.len()], 0.0);
    if !blade.is_closed || contour.edge() == Edge::None {
        return Ok([rest(0), rest(1)]);
    }
    let whole = depths[depths.len() - 1];
    let [upper, lower] = at.map(|u| contour.position(u));
    let width = distance(upper, lower);
    let is_blunt = contour.edge() == Edge::Blunt;
    let too_thick = || {
        vec![BladeProblem::EdgeThick {
            thickness: whole,
            edge: width,
            ahead: blade.space_ahead(LEAST_EDGE * 1.1 * whole),
        }]
    };
    if is_blunt && width < LEAST_EDGE * whole {
        return Err(too_thick());
    }
    let line = Straight {
        point: lower,
        // right of the upward direction
        inward: [(upper[1] - lower[1]) / width, (lower[0] - upper[0]) / width],
    };
    let spots = depths.iter().map(|&depth| {
        if is_blunt {
            Some([
                contour.meet(Half::Upper, depth, line, depth)?,
                contour.meet(Half::Lower, depth, line, depth)?,
            ])
        } else {
            contour.meet_other(depth)
        }
    });
    let spots: Option<Vec<[f64; 2]>> = spots.collect();
    let spots = spots.ok_or_else(too_thick)?;
    let end = columns.landmarks.get(1).copied().unwrap_or(columns.nose());
    let shifts = Half::BOTH.map(|half| {
        let space = MOST * (columns.at(half, end) - columns.at(half, 0)).abs();
        let own: Vec<f64> = spots.iter().map(|spot| spot[half as usize]).collect();
        (Shift::new(at[half as usize], &own, space), space)
    });
    let fits = |(shift, space): &(Shift, f64)| shift.most() <= FULL * space;
    if shifts.iter().all(fits) {
        return Ok(shifts.map(|(shift, _)| shift));
    }
    Err(match &blade.spar {
        Some(spar) => vec![BladeProblem::WebOutside {
            web: BladePart::RearWeb,
            part: spar.rear_web,
        }],
        None => too_thick(),
    })
}

impl Blade {
    /// The chordwise position ahead of which the airfoil is thicker than `needed`.
    pub(super) fn space_ahead(&self, needed: f64) -> Option<f64> {
        let last = self.contour.last_part();
        let parts = (1..500).map(|i| last * (1.0 - i as f64 / 500.0));
        let mut fitting = parts.filter(|part| {
            let space = self.contour.thickness(*part);
            space.is_some_and(|space| space > needed)
        });
        fitting.next().filter(|part| *part > 0.3 * last)
    }
}
