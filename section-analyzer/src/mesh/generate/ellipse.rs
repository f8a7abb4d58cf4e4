//! Full ellipses and disks.
//!
//! The unit disk is meshed by five blocks, a square core with bulged sides and
//! four blocks between its sides and the circle, then stretched by the semi-axes:
//!
//! ```text
//!         . - - - .
//!      . \         / .
//!     .   +-------+   .
//!     |   |       |   |
//!     |   |  core |   |
//!     .   +-------+   .
//!      . /         \ .
//!         ' - - - '
//! ```
//!
//! # Symbols
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | `u`, `v` | coordinates of the core, -1 to 1 | - |
//! | `t` | coordinate along the side of a block, -1 to 1, clockwise | - |
//! | `s` | coordinate from the core (0) to the circle (1) | - |
//! | `c` | `CORE`, half the side of the core, corner to corner | radius |
//! | `b` | `BULGE`, rise of the core's sides relative to `c` | - |

use std::f64::consts::FRAC_PI_4;

use shared_geom::mesh::{CellKind, Mesh};

use super::builder::{self, Quad, Shape, block, border, build, cells_per_quad};
use super::problem::{self, GenerateProblem};

/// Half the side of the core, relative to the radius: cells of the core and
/// around it then have about the same size.
const CORE: f64 = 0.42;
/// Rise of the core's sides: with tan(15 deg) / 2 the three blocks that meet at
/// a corner of the core share the angle there evenly, 120 deg each.
const BULGE: f64 = 0.133_974_596_215_561_35;
/// Number of quadrilaterals in the whole ellipse per quadrilateral in a quarter of the
/// core.
const QUADS: usize = 12;

/// A full ellipse (a disk, with equal semi-axes), centered at the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Ellipse {
    /// Semi-axis along y [unit of the mesh].
    pub semi_y: f64,
    /// Semi-axis along z [unit of the mesh].
    pub semi_z: f64,
    /// Cells along the sides of a quarter of the core, and as many from the core
    /// to the boundary: `n` gives 12 n^2 quadrilaterals, 8 n along the boundary.
    pub cells: usize,
    /// Kind of the cells.
    pub kind: CellKind,
    /// Whether the side middles of quadratic cells follow the smooth mapping, at the
    /// boundary the ellipse; otherwise all sides are straight, as for linear cells.
    pub curved: bool,
}

/// Indices and positions of the lattice points: first the core, row by row, then the
/// rings around it.
struct Lattice {
    /// Steps along a side of the core.
    side: usize,
    /// Steps from the core to the circle.
    rings: usize,
}

impl Ellipse {
    /// The mesh, with the physical surface `section` and the physical curve
    /// `boundary`, which runs clockwise.
    ///
    /// # Errors
    /// All invalid dimensions.
    pub fn generate(&self) -> Result<Mesh, Vec<GenerateProblem>> {
        self.check()?;
        let step = builder::step(self.kind);
        let lattice = Lattice {
            side: 2 * self.cells * step,
            rings: self.cells * step,
        };
        let stretch = |[y, z]: [f64; 2]| [self.semi_y * y, self.semi_z * z];
        let around = 8 * self.cells;
        let outermost = |i| lattice.ring_point(i, lattice.rings);
        let shape = Shape {
            points: lattice.points().map(stretch).collect(),
            quads: lattice.quads(self.cells, step),
            borders: vec![border("boundary", around, step, outermost)],
            surface: "section".into(),
        };
        Ok(build(shape, self.kind, self.curved))
    }

    fn check(&self) -> Result<(), Vec<GenerateProblem>> {
        let mut problems = Vec::new();
        problem::check_length("semi-axis along y", self.semi_y, &mut problems);
        problem::check_length("semi-axis along z", self.semi_z, &mut problems);
        problem::check_cells("cells of the core", self.cells, 1, &mut problems);
        let factors = [QUADS, self.cells, self.cells, cells_per_quad(self.kind)];
        problem::check_total(&factors, &mut problems);
        problem::outcome(problems)
    }
}

impl Lattice {
    /// Index of the point of the core in column `i` (along y) and row `j`.
    fn core_point(&self, i: usize, j: usize) -> usize {
        j * (self.side + 1) + i
    }

    /// Index of the point on ring `j` (0 is the border of the core), `i` steps clockwise
    /// from the upper left corner of the core.
    fn ring_point(&self, i: usize, j: usize) -> usize {
        let m = self.side;
        let i = i % (4 * m);
        if j > 0 {
            return (m + 1) * (m + 1) + (j - 1) * 4 * m + i;
        }
        let k = i % m;
        match i / m {
            0 => self.core_point(k, m),
            1 => self.core_point(m, m - k),
            2 => self.core_point(m - k, 0),
            _ => self.core_point(0, k),
        }
    }

    /// The points of the unit disk, in the order of their indices.
    fn points(&self) -> impl Iterator<Item = [f64; 2]> {
        let m = self.side;
        let along = move |i: usize| 2.0 * i as f64 / m as f64 - 1.0;
        let core =
            (0..=m).flat_map(move |j| (0..=m).map(move |i| core_position(along(i), along(j))));
        let rings = (1..=self.rings).flat_map(move |j| {
            let s = j as f64 / self.rings as f64;
            (0..4 * m).map(move |i| turned(i / m, block_position(along(i % m), s)))
        });
        core.chain(rings)
    }

    /// The quadrilaterals of the core and of the rings.
    fn quads(&self, cells: usize, step: usize) -> Vec<Quad> {
        let core = [2 * cells, 2 * cells];
        let mut quads = block(core, step, |i, j| self.core_point(i, j));
        quads.extend(block([8 * cells, cells], step, |i, j| {
            self.ring_point(i, j)
        }));
        quads
    }
}

/// Position in the core:
///
/// ```text
/// y = c u (1 + b (1 - v^2)),   z = c v (1 + b (1 - u^2))
/// ```
fn core_position(u: f64, v: f64) -> [f64; 2] {
    let rise = |across: f64| 1.0 + BULGE * (1.0 - across * across);
    [CORE * u * rise(v), CORE * v * rise(u)]
}

/// Position in the block above the core:
///
/// ```text
/// (y, z) = (1 - s) core(t, 1) + s (sin(pi t / 4), cos(pi t / 4))
/// ```
fn block_position(t: f64, s: f64) -> [f64; 2] {
    let [y, z] = core_position(t, 1.0);
    let (sine, cosine) = (FRAC_PI_4 * t).sin_cos();
    [y + s * (sine - y), z + s * (cosine - z)]
}

/// The position rotated by `quarters` quarter turns clockwise.
fn turned(quarters: usize, [y, z]: [f64; 2]) -> [f64; 2] {
    match quarters {
        0 => [y, z],
        1 => [z, -y],
        2 => [-y, -z],
        _ => [-z, y],
    }
}
