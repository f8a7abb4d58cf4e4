//! The spar: plies inside of the skin that turn into one web or two.
//!
//! ```text
//!         upper                          upper
//!      *----------.                  *------------*
//!      |           \                 |            |
//!  rear web         nose         rear web     front web
//!      |           /                 |            |
//!      *----------'                  *------------*
//!         lower                          lower
//! ```

use super::Blade;
use super::columns::Columns;
use super::contour::{Half, Straight};
use super::fill::even_cells;
use super::grid::Grid;
use super::layers::{Content, Interval, Layer, Part, depths};
use super::problem::{BladePart, BladeProblem};
use super::skin::Skin;
use super::walls::{Shift, Station, Wall, moved, nodes, part_of};
use super::{Spar, SparPly};

/// Fraction of the surface of a spar that a web may use at its end.
const MOST: f64 = 0.45;
/// Fraction of the surface of a spar in which nodes may move with a corner.
const USABLE: f64 = 0.9;

/// Intersection of a web with the surfaces.
#[derive(Debug, Clone, Copy)]
pub(super) struct WebAt {
    pub web: BladePart,
    /// The outer face of the web.
    pub line: Straight,
    /// The column at its ends.
    pub column: usize,
}

/// Nodes of the inner face of the spar and of the outer faces of its webs.
#[derive(Debug)]
pub(super) struct Inside {
    /// Nodes of the inner face: upper and lower, from the rear web to the front.
    pub inner: [Vec<u32>; 2],
    /// Nodes of the inner faces of the rear and the front web, upward; without a front
    /// web the nose.
    pub webs: [Vec<u32>; 2],
    /// Nodes of the outer faces of the rear and the front web, upward.
    pub outer: [Vec<u32>; 2],
}

/// A position on the path around the spar.
#[derive(Debug, Clone, Copy)]
enum Stop {
    Wall(Half, usize),
    Corner(Half, usize),
    /// A web, and the fraction of the distance from its lower to its upper end.
    Web(usize, f64),
}

/// The spar during generation.
struct Making<'a> {
    blade: &'a Blade,
    spar: &'a Spar,
    columns: &'a Columns,
    layers: &'a [Layer],
    skin: &'a Skin,
    /// Thickness of the skin.
    depth: f64,
    webs: Vec<WebAt>,
    stops: Vec<Stop>,
    intervals: Vec<Interval>,
    depths: Vec<Vec<f64>>,
}

/// Makes the spar, whose rear and front web are `webs`.
pub(super) fn build(
    (blade, spar): (&Blade, &Spar),
    columns: &Columns,
    layers: &[Layer],
    (skin, depth): (&Skin, f64),
    webs: Vec<WebAt>,
    grid: &mut Grid,
) -> Result<Inside, Vec<BladeProblem>> {
    let mut making = Making {
        blade,
        spar,
        columns,
        layers,
        skin,
        depth,
        webs,
        stops: Vec::new(),
        intervals: Vec::new(),
        depths: Vec::new(),
    };
    making.go_around(grid);
    making.check_radii()?;
    let stations = making.stations(grid)?;
    making.lay(&stations, grid);
    Ok(making.inside(&stations))
}

impl Making<'_> {
    /// Sets the stops, the contents between them, and the depths of the levels at each.
    fn go_around(&mut self, grid: &Grid) {
        let rear = self.webs[0].column;
        let nose = self.columns.nose();
        let front = self.webs.get(1).map(|web| web.column);
        let cells = |column: usize| {
            let ends = [&self.skin.inner[0], &self.skin.inner[1]].map(|nodes| nodes[column]);
            let height = grid.position(ends[0])[1] - grid.position(ends[1])[1];
            even_cells(height, self.blade.sizes.size)
        };
        let web = |number: usize, column: usize| {
            let count = cells(column);
            (1..count).map(move |cell| Stop::Web(number, cell as f64 / count as f64))
        };
        let mut stops = vec![Stop::Corner(Half::Upper, 0)];
        match front {
            None => {
                stops.extend((rear + 1..=nose).map(|k| Stop::Wall(Half::Upper, k)));
                stops.extend((rear + 1..nose).rev().map(|k| Stop::Wall(Half::Lower, k)));
            }
            Some(front) => {
                stops.extend((rear + 1..front).map(|k| Stop::Wall(Half::Upper, k)));
                stops.push(Stop::Corner(Half::Upper, 1));
                stops.extend(web(1, front).rev());
                stops.push(Stop::Corner(Half::Lower, 1));
                stops.extend((rear + 1..front).rev().map(|k| Stop::Wall(Half::Lower, k)));
            }
        }
        stops.push(Stop::Corner(Half::Lower, 0));
        stops.extend(web(0, rear));
        let count = stops.len();
        self.intervals = (0..count)
            .map(|i| self.interval(stops[i], stops[(i + 1) % count]))
            .collect();
        self.depths = (0..count)
            .map(|i| {
                let before = &self.intervals[(i + count - 1) % count];
                depths(self.layers, before, &self.intervals[i])
            })
            .collect();
        self.stops = stops;
    }

    /// Contents between two stops.
    fn interval(&self, from: Stop, to: Stop) -> Interval {
        let contour = &self.blade.contour;
        let (part, at) = match (from, to) {
            (Stop::Web(web, _), _) | (_, Stop::Web(web, _)) => (self.web_part(web), 0.0),
            _ => {
                let half = match (self.position(from), self.position(to)) {
                    ((Half::Lower, _), _) | (_, (Half::Lower, _)) => Half::Lower,
                    _ => Half::Upper,
                };
                let u = [self.position(from).1, self.position(to).1];
                let middle = contour.position(0.5 * (u[0] + u[1]));
                (part_of(half), contour.chord_part(middle[0]))
            }
        };
        let content = |layer: &Layer| self.spar.plies[layer.ply].content(part, at);
        Interval {
            part,
            contents: self.layers.iter().map(content).collect(),
        }
    }

    fn web_part(&self, web: usize) -> Part {
        match self.webs[web].web {
            BladePart::FrontWeb => Part::FrontWeb,
            _ => Part::RearWeb,
        }
    }

    /// The surface of a stop, and its position on it; for a stop on a web, the lower end
    /// of the web.
    fn position(&self, stop: Stop) -> (Half, f64) {
        let (half, column) = match stop {
            Stop::Wall(half, column) => (half, column),
            Stop::Corner(half, web) => (half, self.webs[web].column),
            Stop::Web(web, _) => (Half::Lower, self.webs[web].column),
        };
        (half, self.columns.at(half, column))
    }

    /// Checks that no surface folds.
    fn check_radii(&self) -> Result<(), Vec<BladeProblem>> {
        let on_walls = self.stops.iter().zip(&self.depths);
        let positions = on_walls.filter_map(|(stop, depths)| match stop {
            Stop::Wall(half, _) => {
                let thickness = self.depth + depths[depths.len() - 1];
                Some((*half, self.position(*stop).1, thickness))
            }
            _ => None,
        });
        super::check_radii(&self.blade.contour, positions, BladePart::Spar)
    }

    fn stations(&self, grid: &mut Grid) -> Result<Vec<Station>, Vec<BladeProblem>> {
        let mut shifts: [Vec<Shift>; 2] = [Vec::new(), Vec::new()];
        let mut problems = Vec::new();
        for (stop, depths) in self.stops.iter().zip(&self.depths) {
            if let Stop::Corner(half, web) = *stop {
                match self.shift(half, web, depths) {
                    Ok(shift) => shifts[half as usize].push(shift),
                    Err(problem) => problems.push(problem),
                }
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        let mut stations = vec![Station::default(); self.stops.len()];
        for pass in 0..2 {
            for (index, stop) in self.stops.iter().enumerate() {
                match stop {
                    // needs the corners, which are made in the first pass
                    Stop::Web(web, part) if pass == 1 => {
                        let position = self.on_web(grid, &stations, index, (*web, *part));
                        stations[index] = position;
                    }
                    Stop::Wall(half, column) if pass == 0 => {
                        stations[index] = self.on_wall(grid, index, (*half, *column), &shifts);
                    }
                    Stop::Corner(half, web) if pass == 0 => {
                        let column = self.webs[*web].column;
                        stations[index] = self.on_wall(grid, index, (*half, column), &shifts);
                    }
                    _ => {}
                }
            }
        }
        Ok(stations)
    }

    /// Shift of the levels due to a corner.
    fn shift(&self, half: Half, web: usize, depths: &[f64]) -> Result<Shift, BladeProblem> {
        let contour = &self.blade.contour;
        let (own, columns) = (&self.webs[web], self.columns);
        if depths[depths.len() - 1] == 0.0 {
            return Err(BladeProblem::WebLoose {
                web: own.web,
                surface: half.name(),
            });
        }
        let at = columns.at(half, own.column);
        let other = self.webs.get(1 - web.min(1));
        let end = other.filter(|_| self.webs.len() > 1);
        let end = end.map_or(columns.nose(), |other| other.column);
        let space = (columns.at(half, end) - at).abs();
        let position = |depth: &f64| contour.meet(half, self.depth + depth, own.line, *depth);
        let positions: Option<Vec<f64>> = depths.iter().map(position).collect();
        let thick = |thickness: f64| BladeProblem::WebThick {
            web: own.web,
            surface: half.name(),
            thickness,
            space,
        };
        let Some(mut positions) = positions else {
            return Err(thick(depths[depths.len() - 1]));
        };
        // the outer face is the inner face of the skin
        positions[0] = at;
        let shift = Shift::new(at, &positions, USABLE * space);
        if shift.most() > MOST * space {
            Err(thick(shift.most()))
        } else {
            Ok(shift)
        }
    }

    fn on_wall(
        &self,
        grid: &mut Grid,
        index: usize,
        (half, column): (Half, usize),
        shifts: &[Vec<Shift>; 2],
    ) -> Station {
        let contour = &self.blade.contour;
        let depths = &self.depths[index];
        let u = self.columns.at(half, column);
        let own: Vec<&Shift> = shifts[half as usize].iter().collect();
        let at = moved(u, depths.len(), &own);
        let outer = self.skin.inner[half as usize][column];
        let nodes = nodes(grid, Some(outer), depths, |level| {
            contour.offset(at[level], self.depth + depths[level])
        });
        Station {
            nodes,
            depths: depths.clone(),
            before: at.clone(),
            behind: at,
        }
    }

    fn on_web(
        &self,
        grid: &mut Grid,
        stations: &[Station],
        index: usize,
        (web, part): (usize, f64),
    ) -> Station {
        let depths = &self.depths[index];
        let corner = |half: Half| {
            let is_it = |stop: &Stop| matches!(stop, Stop::Corner(h, w) if *h == half && *w == web);
            let found = self.stops.iter().position(is_it);
            found.map_or(&stations[index], |found| &stations[found])
        };
        let heights = [Half::Lower, Half::Upper].map(|half| {
            let height = |node: &u32| grid.position(*node)[1];
            corner(half).nodes.iter().map(height).collect::<Vec<f64>>()
        });
        let line = self.webs[web].line;
        let nodes = nodes(grid, None, depths, |level| {
            let height = (1.0 - part) * heights[0][level] + part * heights[1][level];
            [line.point[0] + depths[level] * line.inward[0], height]
        });
        Station {
            nodes,
            depths: depths.clone(),
            ..Station::default()
        }
    }

    fn lay(&self, stations: &[Station], grid: &mut Grid) {
        let is_box = self.webs.len() > 1;
        let wall = Wall {
            contour: &self.blade.contour,
            depth: self.depth,
            layers: self.layers,
            stations,
            intervals: &self.intervals,
            curve: "spar",
            group: &|ply, content| self.spar.plies[ply].named(content),
            part: &|part| match part {
                Part::Upper => "upper",
                Part::Lower => "lower",
                Part::FrontWeb => "front_web",
                _ if is_box => "rear_web",
                _ => "web",
            },
        };
        wall.build(grid);
    }

    fn inside(&self, stations: &[Station]) -> Inside {
        let last = self.layers.len();
        let of_web = |web: usize, level: usize| -> Vec<u32> {
            let mut found: Vec<(f64, u32)> = Vec::new();
            for (stop, station) in self.stops.iter().zip(stations) {
                let part = match stop {
                    Stop::Corner(Half::Lower, own) if *own == web => 0.0,
                    Stop::Corner(Half::Upper, own) if *own == web => 1.0,
                    Stop::Web(own, part) if *own == web => *part,
                    _ => continue,
                };
                found.push((part, station.nodes[level]));
            }
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            found.into_iter().map(|(_, node)| node).collect()
        };
        let on = |half: Half| -> Vec<u32> {
            let mut found: Vec<(usize, u32)> = Vec::new();
            for (stop, station) in self.stops.iter().zip(stations) {
                let column = match stop {
                    Stop::Wall(own, column) if *own == half => *column,
                    // the nose belongs to both
                    Stop::Wall(_, column) if *column == self.columns.nose() => *column,
                    Stop::Corner(own, web) if *own == half => self.webs[*web].column,
                    _ => continue,
                };
                found.push((column, station.nodes[last]));
            }
            found.sort_by_key(|(column, _)| *column);
            found.into_iter().map(|(_, node)| node).collect()
        };
        let inner = Half::BOTH.map(on);
        let front = if self.webs.len() > 1 {
            of_web(1, last)
        } else {
            inner[0].last().copied().into_iter().collect()
        };
        Inside {
            inner,
            webs: [of_web(0, last), front],
            outer: [of_web(0, 0), of_web(1, 0)],
        }
    }
}

impl SparPly {
    /// The name of the content of its layer, and whether its faces are curves.
    fn named(&self, content: Content) -> (String, bool) {
        match (content, &self.filler) {
            (Content::Filler, Some(filler)) => (filler.clone(), false),
            _ => (self.ply.name.clone(), self.ply.has_faces),
        }
    }
}
