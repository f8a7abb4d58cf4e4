//! Sections of blades: a skin around an airfoil, a spar of plies with one web or two, and
//! cores.
//!
//! Their plies are the layers of a layup, whose columns of cells are the walls. Here the columns of both
//! sides stand in pairs, so that cores are filled by lines between them, and the
//! mesh of a symmetric airfoil is symmetric.

use shared_geom::mesh::Mesh;

mod cavities;
mod check;
mod columns;
mod contour;
mod fill;
mod naca;
mod names;
mod problem;
mod retry;
mod shell;
mod types;

pub use contour::Contour;
pub use naca::naca;
pub use problem::{BladePart, BladeProblem};
pub use types::{Blade, Cores, Ply, Sizes, Spar, SparPly};

use super::grid::{self, Grid};
use super::layup::cells::{Row, knee_level, lay, rows};
use super::layup::spar_web::add_spar_web;
use super::layup::wall::Wall;
use cavities::inside;
use check::{apart, check_radii, outcome};
use columns::Columns;
use names::Named;
use shell::{Frame, Shell, WebAt};

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
        let depth: f64 = self.skin.iter().map(|ply| ply.thickness).sum();
        self.check(depth)?;
        let (columns, webs) = self.columns(depth)?;
        self.check_count(&columns)?;
        let on_side = |side: usize| columns.sides[side].iter().map(move |s| (side, *s, depth));
        let positions = (0..2).flat_map(on_side);
        check_radii(&self.contour, positions, BladePart::Skin)?;
        self.check_edge(depth, &columns, &webs)?;
        let aft_end = webs.first().map_or(columns.nose(), |web| web.column);
        self.check_open(depth, &columns, aft_end)?;
        let frame = Frame {
            blade: self,
            columns: &columns,
            webs: &webs,
        };
        let shell = frame.shell();
        outcome(frame.check_feet(&shell))?;
        let (wall, columns) = self.wall(&shell, columns, &webs)?;
        let mut grid = Grid::default();
        self.mesh_wall(&wall, &columns, (&shell, &webs), &mut grid)?;
        let mesh = grid.mesh(self.sizes.kind);
        match grid::folded(&mesh) {
            None => Ok(mesh),
            Some(folded) => Err(vec![BladeProblem::Folded {
                count: folded.centers.len(),
                part: self.contour.chord_part(folded.position[0]),
                position: folded.position,
                unfolded: None,
            }]),
        }
    }

    /// The columns of cells, and the columns of the webs.
    fn columns(&self, depth: f64) -> Result<(Columns, Vec<WebAt>), Vec<BladeProblem>> {
        let contour = &self.contour;
        let nose = contour.outline().nose();
        // the trailing edge on both surfaces, then the nose
        let mut marks = vec![contour.outline().corners(), [nose; 2]];
        let mut webs = Vec::new();
        for (web, part) in self.web_parts() {
            let (Some((line, ends)), Some(feet)) = (contour.across(part), self.feet(part, depth))
            else {
                return Err(vec![BladeProblem::WebOutside { web, part }]);
            };
            marks.push(feet);
            webs.push((web, line, ends, feet));
        }
        for part in self.inner_marks() {
            marks.extend(contour.across(part).map(|(_, ends)| ends));
        }
        marks.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let columns = Columns::new(contour, &marks, &self.sizes);
        let columns = columns.map_err(|problem| vec![problem])?;
        let webs = webs.into_iter().map(|(web, line, ends, feet)| WebAt {
            web,
            line,
            ends,
            column: columns.nearest(feet[0]),
        });
        let webs = webs.collect();
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

    /// The wall, and the columns with those at the corners of its spar.
    fn wall(
        &self,
        shell: &Shell<'_>,
        mut columns: Columns,
        webs: &[WebAt],
    ) -> Result<(Wall, Columns), Vec<BladeProblem>> {
        let outline = self.contour.outline();
        let parts = (&shell.layers[..], shell.spar.as_ref());
        let wall = Wall::apart(parts, outline, self.sizes.size, self.is_closed);
        let mut wall = wall.map_err(|one| vec![BladeProblem::Layup(one)])?;
        wall.stack
            .divide(shell.plies.iter().map(|of| of.ply.cells.max(1)));
        let of_spar = wall.spar.iter().flat_map(|spar| &spar.webs);
        for (web, at) in of_spar.zip(webs) {
            for side in 0..2 {
                columns.sides[side][at.column] = web.corners[side];
            }
        }
        let beside = |column: &usize| webs.iter().all(|web| web.column != *column);
        let inner = (0..=columns.nose()).filter(beside);
        let stack = &wall.stack;
        // the nose, of both sides, counts as above
        let on_side = |column: usize| [1, 0].map(|side| (side, columns.sides[side][column]));
        let positions = inner
            .flat_map(on_side)
            .filter(|(_, s)| !stack.is_beyond(*s));
        let positions = positions.map(|(side, s)| (side, s, stack.total(s)));
        check_radii(&self.contour, positions, BladePart::Spar)?;
        Ok((wall, columns))
    }

    /// Adds the cells of walls, webs and cores.
    fn mesh_wall(
        &self,
        wall: &Wall,
        columns: &Columns,
        (shell, webs): (&Shell<'_>, &[WebAt]),
        grid: &mut Grid,
    ) -> Result<(), Vec<BladeProblem>> {
        let size = self.sizes.size;
        let stations = columns.stations(&wall.outline, size, self.is_closed);
        let rows: Vec<Row> = rows(wall, &stations, grid);
        let named = Named {
            contour: &self.contour,
            wall,
            plies: &shell.plies,
            webs,
        };
        let count = |length: f64| fill::even_cells(length, size);
        let nodes = named.with(|names| {
            lay(wall, &rows, names, grid);
            let spar = wall.spar.iter();
            let webs = spar.flat_map(|spar| (0..spar.webs.len()).map(move |web| (spar, web)));
            let web = |web| add_spar_web(wall, web, &rows, (names, &count), grid);
            webs.map(web).collect()
        });
        let spar = wall.spar.as_ref();
        let knee = spar.map_or(wall.stack.level(wall.stack.len()), |spar| {
            knee_level(wall, spar)
        });
        let inside = inside(columns, &rows, (webs, nodes), (knee, self.is_closed));
        let aft_end = webs.first().map_or(columns.nose(), |web| web.column);
        let skin = inside.skin.each_ref().map(|side| &side[..=aft_end]);
        self.check_space(apart(grid, skin), BladePart::Skin)?;
        if spar.is_some() {
            let spar = inside.spar.each_ref().map(Vec::as_slice);
            self.check_space(apart(grid, spar), BladePart::Spar)?;
        }
        self.fill(grid, columns, webs, &inside);
        Ok(())
    }
}

#[cfg(test)]
mod tests;
