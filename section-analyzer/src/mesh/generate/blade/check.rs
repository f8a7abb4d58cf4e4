//! Obstacles to the mesh of a blade: in its input, in its walls before they are meshed, and in the
//! space between them.

use super::super::grid::Grid;
use super::super::layup::spar::foot;
use super::columns::Columns;
use super::contour::{Contour, SIDES};
use super::fill::even_cells;
use super::problem::{BladePart, BladeProblem, MOST_CELLS};
use super::shell::WebAt;
use super::{Blade, SAME};

/// Fraction of the radius of a surface that plies may fill.
const FULL: f64 = 0.95;
/// Least thickness of a trailing edge with a wall, in thicknesses of the skin.
const LEAST_EDGE: f64 = 2.2;
/// Fraction of the surface behind the rear web, or of the whole, that a mitre at the trailing edge may
/// use.
const MOST_OF_WAY: f64 = 0.3;

/// `Ok` if there are no problems.
pub(super) fn outcome(problems: Vec<BladeProblem>) -> Result<(), Vec<BladeProblem>> {
    if problems.is_empty() {
        Ok(())
    } else {
        Err(problems)
    }
}

impl Blade {
    /// Problems that are found without a mesh, of a skin of this thickness.
    pub(super) fn check(&self, depth: f64) -> Result<(), Vec<BladeProblem>> {
        let mut problems = Vec::new();
        let last = self.contour.last_part();
        if let Some(spar) = &self.spar {
            let from = spar.front_web.unwrap_or(0.0);
            if spar.front_web.is_some() && from >= spar.rear_web {
                problems.push(BladeProblem::WebOrder {
                    front: from,
                    rear: spar.rear_web,
                });
            }
            let within = [from.min(spar.rear_web), spar.rear_web];
            for (number, ply) in spar.plies.iter().enumerate() {
                let is_in = |range: &[f64; 2]| {
                    let [from, to] = [range[0].max(-1.0), range[1].min(2.0)];
                    let is_in = (from < 0.0 || from >= within[0] - SAME)
                        && (to > 1.0 || to <= within[1] + SAME);
                    is_in && range[0] < range[1]
                };
                let mut ranges = [ply.upper, ply.lower].into_iter().flatten();
                problems.extend(ranges.find(|range| !is_in(range)).map(|range| {
                    BladeProblem::PlyRange {
                        number,
                        ply: ply.ply.name.clone(),
                        range,
                        spar: within,
                    }
                }));
            }
        }
        if let Some((to, _)) = &self.cores.nose_mass {
            let spar = self.spar.as_ref();
            let most = spar.map_or(last, |spar| spar.front_web.unwrap_or(spar.rear_web));
            if !(*to > 0.0 && *to < most) {
                problems.push(BladeProblem::NoseMass { to: *to, most });
            }
        }
        for (web, part) in self.web_parts() {
            if !(part > 0.0 && part < last && self.feet(part, depth).is_some()) {
                problems.push(BladeProblem::WebOutside { web, part });
            }
        }
        outcome(problems)
    }

    /// The webs, the rear one first, and the fractions of the chord of their outer faces.
    pub(super) fn web_parts(&self) -> Vec<(BladePart, f64)> {
        let rear = self
            .spar
            .iter()
            .map(|spar| (BladePart::RearWeb, spar.rear_web));
        let front = self.spar.iter().filter_map(|spar| spar.front_web);
        let front = front.map(|part| (BladePart::FrontWeb, part));
        rear.chain(front).collect()
    }

    /// Arc lengths at which the inner face of a skin of a thickness meets the plane across the section at
    /// a fraction of the chord.
    pub(super) fn feet(&self, part: f64, depth: f64) -> Option<[f64; 2]> {
        let (line, ends) = self.contour.across(part)?;
        let foot = |side: usize| foot(&line, self.contour.outline(), |_| depth, (side, ends[side]));
        Some([foot(0)?, foot(1)?])
    }

    /// Whether the number of cells is too large, before they are made.
    pub(super) fn check_count(&self, columns: &Columns) -> Result<(), Vec<BladeProblem>> {
        let spar = self.spar.iter().flat_map(|spar| &spar.plies);
        let plies = self.skin.iter().chain(spar.map(|one| &one.ply));
        let layers: usize = plies.map(|ply| ply.cells.max(1)).sum();
        let walls = 3 * columns.nose() * layers;
        let across = even_cells(0.2 * self.contour.chord(), self.sizes.core);
        let found = walls.saturating_add(columns.nose().saturating_mul(across));
        if found > MOST_CELLS {
            return Err(vec![BladeProblem::TooManyCells { found }]);
        }
        Ok(())
    }

    /// Whether a skin of a thickness can be closed at the trailing edge.
    pub(super) fn check_edge(
        &self,
        thickness: f64,
        columns: &Columns,
        webs: &[WebAt],
    ) -> Result<(), Vec<BladeProblem>> {
        let outline = self.contour.outline();
        if !self.is_closed || outline.is_smooth() {
            return Ok(());
        }
        let edge = outline.base();
        let too_thick = || BladeProblem::EdgeThick {
            thickness,
            edge,
            ahead: self.contour.space_ahead(LEAST_EDGE * 1.1 * thickness),
        };
        if edge > 0.0 && edge < LEAST_EDGE * thickness {
            return Err(vec![too_thick()]);
        }
        let tangents = match edge > 0.0 {
            true => outline.rear_tangents(),
            false => [outline.rear_tangent(); 2],
        };
        let end = webs.first().map_or(columns.nose(), |web| web.column);
        let fits = |side: usize| {
            let way = columns.sides[side][end] - columns.sides[side][0];
            tangents[side] * thickness <= MOST_OF_WAY * way.abs()
        };
        if fits(0) && fits(1) {
            return Ok(());
        }
        Err(vec![match &self.spar {
            Some(spar) => BladeProblem::WebOutside {
                web: BladePart::RearWeb,
                part: spar.rear_web,
            },
            None => too_thick(),
        }])
    }

    /// Whether the points of columns on the upper side lie above those on the lower one.
    pub(super) fn check_space(
        &self,
        mut pairs: impl Iterator<Item = [[f64; 2]; 2]>,
        about: BladePart,
    ) -> Result<(), Vec<BladeProblem>> {
        let Some([above, below]) = pairs.find(|[above, below]| above[1] <= below[1]) else {
            return Ok(());
        };
        let part = self.contour.chord_part(0.5 * (above[0] + below[0]));
        let space = self.contour.thickness(part).unwrap_or(0.0);
        let thickness = space + below[1] - above[1];
        let ahead = match about {
            BladePart::Skin => self.contour.space_ahead(1.02 * thickness),
            _ => None,
        };
        Err(vec![BladeProblem::Collision {
            about,
            part,
            thickness,
            space,
            ahead,
        }])
    }

    /// Whether the inner faces of a skin of this thickness, which is open at the rear, are apart behind
    /// a column.
    pub(super) fn check_open(
        &self,
        thickness: f64,
        columns: &Columns,
        end: usize,
    ) -> Result<(), Vec<BladeProblem>> {
        let outline = self.contour.outline();
        let inner = |column: usize| {
            [0, 1].map(|side| {
                let s = columns.sides[side][column];
                let (p, n) = (outline.position(s), outline.inward(s));
                [0, 1].map(|i| p[i] + thickness * n[i])
            })
        };
        let behind = (0..end).filter(|_| !self.is_closed);
        self.check_space(behind.map(inner), BladePart::Skin)
    }
}

/// Points of the nodes of columns on both sides, without a node of both.
pub(super) fn apart<'a>(
    grid: &'a Grid,
    [upper, lower]: [&'a [u32]; 2],
) -> impl Iterator<Item = [[f64; 2]; 2]> + 'a {
    let pairs = upper.iter().zip(lower).filter(|(a, b)| a != b);
    pairs.map(|(a, b)| [grid.position(*a), grid.position(*b)])
}

/// Checks that plies, with a thickness at each arc length of a side, fit within the radius of the
/// surface there; reports the worst position.
pub(super) fn check_radii(
    contour: &Contour,
    positions: impl Iterator<Item = (usize, f64, f64)>,
    about: BladePart,
) -> Result<(), Vec<BladeProblem>> {
    let bent =
        positions.map(|(side, s, thickness)| (side, s, thickness, contour.outline().bend(s)));
    let fill = |position: &(usize, f64, f64, f64)| position.2 * position.3;
    let tightest = bent.max_by(|a, b| fill(a).total_cmp(&fill(b)));
    let Some((side, s, thickness, bend)) = tightest.filter(|position| fill(position) >= FULL)
    else {
        return Ok(());
    };
    Err(vec![BladeProblem::Tight {
        about,
        surface: SIDES[side],
        part: contour.part_at(s),
        thickness,
        radius: 1.0 / bend,
    }])
}
