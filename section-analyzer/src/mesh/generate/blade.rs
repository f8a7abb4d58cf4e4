//! Sections of blades: a skin around an airfoil, a spar of plies with one web or two, and
//! cores.
//!
//! Plies have their given thickness everywhere, also at corners: the depth of each level
//! is measured from the contour and from the outer faces of the webs, and corners are
//! mitred. All nodes of walls lie on the faces of plies, at their depth below the
//! airfoil.

use shared_geom::mesh::Mesh;

mod columns;
mod contour;
mod fill;

mod layers;
mod naca;
mod problem;
mod retry;
mod skin;
mod spar;
mod types;
mod walls;

pub use contour::Contour;
pub use naca::naca;
pub use problem::{BladePart, BladeProblem};
pub use types::{Blade, Cores, Ply, Sizes, Spar, SparPly};

use super::grid::{self, Grid};
use columns::Columns;
use contour::{Half, Straight};
use layers::{layers, thickness};
use spar::WebAt;

/// Fraction of the radius of a surface that plies may fill.
const FULL: f64 = 0.95;
/// Chordwise positions that differ by less are treated as equal.
const SAME: f64 = 1e-6;

impl Blade {
    /// The mesh. Physical surfaces: one for each name of a ply, a filler or a core, and
    /// for plies and fillers one for each part, `NAME/upper`, `NAME/lower`, `NAME/web`
    /// (`NAME/front_web`, `NAME/rear_web` if there are two), `NAME/edge`. Physical
    /// curves, clockwise: `contour`, the outer surface; `spar`, its outer face with the
    /// webs; the faces of plies that have them.
    ///
    /// # Errors
    /// All problems that prevent a mesh.
    pub fn generate(&self) -> Result<Mesh, Vec<BladeProblem>> {
        self.generate_at_size().map_err(|mut problems| {
            for problem in &mut problems {
                if let BladeProblem::Folded { unfolded, .. } = problem {
                    *unfolded = retry::unfolded_size(self, Self::generate_at_size);
                }
            }
            problems
        })
    }

    /// The mesh with the requested size of cells.
    fn generate_at_size(&self) -> Result<Mesh, Vec<BladeProblem>> {
        let skin_layers = layers(self.skin.iter());
        let depth = thickness(&skin_layers);
        self.check(depth)?;
        let (columns, webs) = self.columns(depth)?;
        self.check_count(&columns, skin_layers.len())?;
        self.check_skin(&columns, depth)?;
        let mut grid = Grid::default();
        let skin = skin::build(self, &columns, &skin_layers, &mut grid)?;
        let aft_end = webs.first().map_or(columns.nose(), |web| web.column);
        self.check_space(&grid, &skin.inner, [0, aft_end], BladePart::Skin)?;
        let inside = match &self.spar {
            None => None,
            Some(spar) => {
                let spar_layers = layers(spar.plies.iter().map(|one| &one.ply));
                let (webs, skin) = (webs.clone(), (&skin, depth));
                let spar = (self, spar);
                Some(spar::build(
                    spar,
                    &columns,
                    &spar_layers,
                    skin,
                    webs,
                    &mut grid,
                )?)
            }
        };
        if let Some(inside) = &inside {
            let last = inside.inner[0].len() - 1;
            // at the nose both surfaces share one node
            let end = if webs.len() > 1 { last } else { last - 1 };
            self.check_space(&grid, &inside.inner, [0, end], BladePart::Spar)?;
        }
        self.fill(&mut grid, &columns, &skin, inside.as_ref(), &webs);
        let mesh = grid.mesh(self.sizes.kind);
        match grid::folded(&mesh) {
            None => Ok(mesh),
            Some(folded) => Err(vec![BladeProblem::Folded {
                count: folded.count,
                part: self.contour.chord_part(folded.position[0]),
                position: folded.position,
                unfolded: None,
            }]),
        }
    }

    /// Problems that are found without a mesh.
    fn check(&self, depth: f64) -> Result<(), Vec<BladeProblem>> {
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
                for range in [ply.upper, ply.lower].into_iter().flatten() {
                    let [from, to] = [range[0].max(-1.0), range[1].min(2.0)];
                    let is_in = (from < 0.0 || from >= within[0] - SAME)
                        && (to > 1.0 || to <= within[1] + SAME);
                    if !is_in || range[0] >= range[1] {
                        problems.push(BladeProblem::PlyRange {
                            number,
                            ply: ply.ply.name.clone(),
                            range,
                            spar: within,
                        });
                        break;
                    }
                }
            }
        }
        if let Some((to, _)) = &self.cores.nose_mass {
            let spar = self.spar.as_ref();
            let most = spar.map_or(last, |spar| spar.front_web.unwrap_or(spar.rear_web));
            if !(*to > 0.0 && *to < most) {
                problems.push(BladeProblem::NoseMass { to: *to, most });
            }
        }
        problems.extend(
            self.web_lines()
                .into_iter()
                .filter_map(|(web, part, line)| {
                    let corners = Half::BOTH.map(|half| self.contour.meet(half, depth, line, 0.0));
                    let is_there = part > 0.0 && part < last && corners.iter().all(Option::is_some);
                    (!is_there).then_some(BladeProblem::WebOutside { web, part })
                }),
        );
        if problems.is_empty() {
            Ok(())
        } else {
            Err(problems)
        }
    }

    /// The outer faces of the webs, the rear one first.
    fn web_lines(&self) -> Vec<(BladePart, f64, Straight)> {
        let Some(spar) = &self.spar else {
            return Vec::new();
        };
        let line = |part: f64, forward: f64| Straight {
            point: [self.contour.at_part(part), 0.0],
            inward: [forward, 0.0],
        };
        let rear = (BladePart::RearWeb, spar.rear_web, line(spar.rear_web, 1.0));
        let front = spar.front_web;
        let front = front.map(|part| (BladePart::FrontWeb, part, line(part, -1.0)));
        std::iter::once(rear).chain(front).collect()
    }

    /// The columns of cells, and the columns of the webs.
    fn columns(&self, depth: f64) -> Result<(Columns, Vec<WebAt>), Vec<BladeProblem>> {
        let contour = &self.contour;
        let ends = |i: usize| Half::BOTH.map(|half| contour.range(half)[i]);
        // the trailing edge on both surfaces, then the nose
        let edge = [ends(0)[0], ends(1)[1]];
        let mut marks = vec![edge, [ends(1)[0]; 2]];
        let mut webs = Vec::new();
        for (web, part, line) in self.web_lines() {
            let corner = |half| contour.meet(half, depth, line, 0.0);
            let (Some(upper), Some(lower)) = (corner(Half::Upper), corner(Half::Lower)) else {
                return Err(vec![BladeProblem::WebOutside { web, part }]);
            };
            marks.push([upper, lower]);
            webs.push((web, line, upper));
        }
        for part in self.inner_marks() {
            let at = |half| contour.at_chord(half, part);
            if let (Some(upper), Some(lower)) = (at(Half::Upper), at(Half::Lower)) {
                marks.push([upper, lower]);
            }
        }
        marks.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let columns = Columns::new(contour, &marks, &self.sizes);
        let columns = columns.map_err(|problem| vec![problem])?;
        let of_web = |(web, line, upper): (BladePart, Straight, f64)| {
            let mark = marks.iter().position(|mark| mark[0] == upper);
            WebAt {
                web,
                line,
                column: columns.landmarks[mark.unwrap_or(0)],
            }
        };
        let webs = webs.into_iter().map(of_web).collect();
        Ok((columns, webs))
    }

    /// Chordwise positions, other than webs, at which a part begins or ends.
    fn inner_marks(&self) -> Vec<f64> {
        let mut parts: Vec<f64> = Vec::new();
        if let Some(spar) = &self.spar {
            let ends = [spar.front_web.unwrap_or(0.0), spar.rear_web];
            let ranges = spar.plies.iter().flat_map(|ply| [ply.upper, ply.lower]);
            let inner = ranges.flatten().flatten();
            parts.extend(inner.filter(|part| *part > ends[0] + SAME && *part < ends[1] - SAME));
        }
        parts.extend(self.cores.nose_mass.iter().map(|(to, _)| *to));
        parts.sort_by(f64::total_cmp);
        parts.dedup_by(|a, b| (*a - *b).abs() < SAME);
        parts
    }

    /// Whether the number of cells is too large, before they are made.
    fn check_count(&self, columns: &Columns, skin: usize) -> Result<(), Vec<BladeProblem>> {
        let spar = self.spar.iter().flat_map(|spar| &spar.plies);
        let layers = skin + spar.map(|one| one.ply.cells).sum::<usize>();
        let walls = 3 * columns.nose() * layers;
        let across = fill::even_cells(0.2 * self.contour.chord(), self.sizes.core);
        let found = walls.saturating_add(columns.nose().saturating_mul(across));
        if found > problem::MOST_CELLS {
            Err(vec![BladeProblem::TooManyCells { found }])
        } else {
            Ok(())
        }
    }

    fn check_skin(&self, columns: &Columns, depth: f64) -> Result<(), Vec<BladeProblem>> {
        let on = |half: Half| {
            let at = (0..=columns.nose()).map(move |column| columns.at(half, column));
            at.map(move |u| (half, u, depth))
        };
        check_radii(
            &self.contour,
            Half::BOTH.into_iter().flat_map(on),
            BladePart::Skin,
        )
    }

    /// Whether the upper nodes of columns lie above the lower ones.
    fn check_space(
        &self,
        grid: &Grid,
        inner: &[Vec<u32>; 2],
        [from, to]: [usize; 2],
        about: BladePart,
    ) -> Result<(), Vec<BladeProblem>> {
        for column in from..=to {
            let [upper, lower] = [0, 1].map(|half| grid.position(inner[half][column]));
            let is_one = inner[0][column] == inner[1][column];
            if is_one || upper[1] > lower[1] {
                continue;
            }
            let part = self.contour.chord_part(0.5 * (upper[0] + lower[0]));
            let space = self.contour.thickness(part).unwrap_or(0.0);
            let thickness = space + lower[1] - upper[1];
            let ahead = match about {
                BladePart::Skin => self.space_ahead(1.02 * thickness),
                _ => None,
            };
            return Err(vec![BladeProblem::Collision {
                about,
                part,
                thickness,
                space,
                ahead,
            }]);
        }
        Ok(())
    }

    /// Fills the cavities with their cores and the nose mass.
    fn fill(
        &self,
        grid: &mut Grid,
        columns: &Columns,
        skin: &skin::Skin,
        inside: Option<&spar::Inside>,
        webs: &[WebAt],
    ) {
        let nose = columns.nose();
        let nose_node = vec![skin.inner[0][nose]];
        let mark = self.nose_mass_column(columns);
        let cores = &self.cores;
        let (Some(inside), Some(rear)) = (inside, webs.first()) else {
            let cavity = Cavity {
                walls: [&skin.inner[0], &skin.inner[1]],
                first: 0,
                ends: [skin.edge.clone(), nose_node],
            };
            return self.fill_cavity(grid, cavity, cores.aft.as_ref(), mark);
        };
        let aft = Cavity {
            walls: [0, 1].map(|half| &skin.inner[half][..=rear.column]),
            first: 0,
            ends: [skin.edge.clone(), inside.outer[0].clone()],
        };
        self.fill_cavity(grid, aft, cores.aft.as_ref(), None);
        let front = webs.get(1);
        let spar = Cavity {
            walls: [&inside.inner[0], &inside.inner[1]],
            first: rear.column,
            ends: inside.webs.clone(),
        };
        self.fill_cavity(
            grid,
            spar,
            cores.spar.as_ref(),
            mark.filter(|_| front.is_none()),
        );
        if let Some(front) = front {
            let nose = Cavity {
                walls: [0, 1].map(|half| &skin.inner[half][front.column..]),
                first: front.column,
                ends: [inside.outer[1].clone(), nose_node],
            };
            self.fill_cavity(grid, nose, cores.nose.as_ref(), mark);
        }
    }

    /// The column at which the mass in the nose ends.
    fn nose_mass_column(&self, columns: &Columns) -> Option<usize> {
        let (to, _) = self.cores.nose_mass.as_ref()?;
        let at = self.contour.at_chord(Half::Upper, *to)?;
        let distance = |column: &usize| (columns.upper[*column] - at).abs();
        (0..=columns.nose()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// Fills a cavity with its core, and from the column `mark` on with the mass.
    fn fill_cavity(
        &self,
        grid: &mut Grid,
        cavity: Cavity<'_>,
        core: Option<&String>,
        mark: Option<usize>,
    ) {
        if core.is_none() && mark.is_none() {
            return;
        }
        let mass = self.cores.nose_mass.as_ref().map(|(_, name)| name);
        let lines = fill::lines(grid, cavity.walls, cavity.ends, self.sizes.core);
        for (index, pair) in lines.windows(2).enumerate() {
            let is_mass = mark.is_some_and(|mark| cavity.first + index >= mark);
            let name = if is_mass { mass } else { core };
            if let Some(name) = name {
                fill::strip(grid, &pair[0], &pair[1], std::slice::from_ref(name));
            }
        }
    }
}

/// The space between an upper and a lower wall.
struct Cavity<'a> {
    /// Nodes of its columns, upper and lower.
    walls: [&'a [u32]; 2],
    /// The column of the first of them.
    first: usize,
    /// The lines at its rear and its front end, upward.
    ends: [Vec<u32>; 2],
}

/// Checks that plies, with a thickness at each position, fit within the radius of the
/// surface there; reports the worst position.
fn check_radii(
    contour: &Contour,
    positions: impl Iterator<Item = (Half, f64, f64)>,
    about: BladePart,
) -> Result<(), Vec<BladeProblem>> {
    let fill = |position: &(Half, f64, f64)| position.2 * contour.bend(position.1);
    let tightest = positions.max_by(|a, b| fill(a).total_cmp(&fill(b)));
    let Some((half, u, thickness)) = tightest.filter(|position| fill(position) >= FULL) else {
        return Ok(());
    };
    Err(vec![BladeProblem::Tight {
        about,
        surface: half.name(),
        part: contour.chord_part(contour.position(u)[0]),
        thickness,
        radius: 1.0 / contour.bend(u),
    }])
}

#[cfg(test)]
mod tests;
