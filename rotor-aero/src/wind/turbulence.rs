//! A turbulence box that is carried downwind without change (Taylor's hypothesis).
//!
//! ```text
//! step   T = (t + (x0 - x)/U)/dt
//! u(x, y, z, t) = trilinear in T, (y + W/2)/dy, (z - bottom)/dz
//! ```
//!
//! Symbols: U mean speed of the box, W its width, x0 shift of the first plane. The gradient is the
//! one of the interpolant, which jumps from cell to cell.

use std::fmt;

use shared_geom::error::Diagnostics;

use super::grid::{BoxGrid, BoxValues};
use super::planes::{CacheCount, Plane, Planes};
use super::problem::WindProblem;
use super::scale::Scale;
use crate::real::Real;

/// Part of a cell by which a point may be outside: grids of files are in single precision.
const SLACK: f64 = 1e-5;

/// Wind at points beside, below and above a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum OutsideGrid {
    /// Such points are an error.
    #[default]
    Refuse,
    /// They have the wind of the nearest point of the box.
    Extend,
}

/// A turbulence box.
pub struct TurbulenceBox {
    name: String,
    grid: BoxGrid,
    planes: Planes,
    /// Whether the last plane of the file comes first.
    reversed: bool,
    shift: f64,
    outside: OutsideGrid,
}

/// A position along one axis: two neighbors and the fraction between them.
#[derive(Clone, Copy)]
struct Between<T> {
    low: usize,
    high: usize,
    fraction: T,
}

/// All that determines its velocities: the text is the same wherever its files are.
impl fmt::Debug for TurbulenceBox {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TurbulenceBox")
            .field("grid", &self.grid)
            .field("planes", &self.planes)
            .field("reversed", &self.reversed)
            .field("shift", &self.shift)
            .field("outside", &self.outside)
            .finish()
    }
}

impl TurbulenceBox {
    /// A box in memory; `name` is shown in messages.
    ///
    /// # Errors
    /// As [`BoxValues::check`].
    pub fn from_values(name: &str, values: BoxValues) -> Result<Self, Diagnostics> {
        values.check(name)?;
        Ok(Self::new(name, values.grid, Planes::memory(values.planes)))
    }

    /// A box of checked parts. A box that is not periodic begins half its width upwind, so that
    /// the whole turned rotor is inside at the start.
    pub(super) fn new(name: &str, grid: BoxGrid, planes: Planes) -> Self {
        let shift = if grid.periodic {
            0.0
        } else {
            grid.half_width()
        };
        Self {
            name: name.to_owned(),
            grid,
            planes,
            reversed: false,
            shift,
            outside: OutsideGrid::Refuse,
        }
    }

    /// The same box with the last plane of the file first.
    pub(super) fn reversed(mut self, reversed: bool) -> Self {
        self.reversed = reversed;
        self
    }

    /// The same box with another downwind position `x0` of its first plane at the time 0 \[m\].
    pub fn with_shift(mut self, shift: f64) -> Self {
        self.shift = shift;
        self
    }

    /// The same box with another wind at points outside.
    pub fn with_outside(mut self, outside: OutsideGrid) -> Self {
        self.outside = outside;
        self
    }

    /// The same box with scaled deviations.
    pub(super) fn with_scale(mut self, scale: Scale) -> Self {
        self.planes = self.planes.scaled(scale);
        self
    }

    /// Its name in messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Wind at points outside.
    pub fn outside_grid(&self) -> OutsideGrid {
        self.outside
    }

    /// Its grid.
    pub fn grid(&self) -> &BoxGrid {
        &self.grid
    }

    /// Downwind position of the first plane at the time 0 \[m\].
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// Numbers of its cache.
    pub fn cache(&self) -> CacheCount {
        self.planes.count()
    }

    /// Velocities of a plane, in the order of the grid; the plane 0 arrives first \[m/s\].
    ///
    /// # Errors
    /// The file can no longer be read.
    pub fn plane(&self, index: usize) -> Result<std::sync::Arc<[f64]>, WindProblem> {
        if self.reversed {
            let last = self.grid.planes.saturating_sub(1);
            return self.planes.plane(last.saturating_sub(index));
        }
        self.planes.plane(index)
    }

    /// Velocity at a point, in the axes of the wind \[m/s\].
    ///
    /// # Errors
    /// A time or point that the box does not cover; a file that can no longer be read.
    pub fn velocity<T: Real>(&self, at: &[T; 3], time: f64) -> Result<[T; 3], WindProblem> {
        let step = self.step(at, time)?;
        let [first, second] = [self.plane(step.low)?, self.plane(step.high)?];
        let g = &self.grid;
        let z = (at[2] - g.bottom) / g.vertical_step;
        if g.tower > 0 && z.re() < -SLACK {
            let below = self.below(at, z)?;
            return Ok(mixed(step.fraction, [&first, &second].map(below)));
        }
        let outside = || self.outside(at);
        let y = (at[1] + g.half_width()) / g.lateral_step;
        let y = self.within(y, g.lateral).ok_or_else(outside)?;
        let z = self.within(z, g.vertical).ok_or_else(outside)?;
        let corner = |plane: &Plane, y: usize, z: usize| vector(plane, g.index(y, z));
        let across = |plane: &Plane| {
            let row = |z| mixed(y.fraction, [y.low, y.high].map(|y| corner(plane, y, z)));
            mixed(z.fraction, [z.low, z.high].map(row))
        };
        Ok(mixed(step.fraction, [&first, &second].map(across)))
    }

    /// The two planes at a point.
    fn step<T: Real>(&self, at: &[T; 3], time: f64) -> Result<Between<T>, WindProblem> {
        let g = &self.grid;
        let step = ((-at[0] + self.shift) / g.speed + time) / g.time_step;
        let value = step.re();
        let last = g.planes.saturating_sub(1);
        if g.periodic && value.is_finite() {
            let count = g.planes as f64;
            let turns = (value / count).floor() * count;
            let step = step - turns;
            // rounding may give the period itself
            let low = (step.re().floor().max(0.0) as usize).min(last);
            return Ok(Between {
                low,
                high: if low == last { 0 } else { low + 1 },
                fraction: step - low as f64,
            });
        }
        between(step, g.planes, false).ok_or_else(|| WindProblem::Time {
            name: self.name.clone(),
            x: at[0].re(),
            time,
            last,
            step: value,
        })
    }

    fn within<T: Real>(&self, position: T, count: usize) -> Option<Between<T>> {
        between(position, count, self.outside == OutsideGrid::Extend)
    }

    fn outside<T: Real>(&self, at: &[T; 3]) -> WindProblem {
        WindProblem::Outside {
            name: self.name.clone(),
            y: at[1].re(),
            z: at[2].re(),
            half: self.grid.half_width(),
            bottom: self.grid.bottom,
            top: self.grid.top(),
        }
    }

    /// Wind of a plane below the grid, from the tower points: the first is at the bottom of the
    /// grid, the wind decreases linearly from the last one to 0 at the ground.
    fn below<T: Real>(
        &self,
        at: &[T; 3],
        z: T,
    ) -> Result<impl Fn(&Plane) -> [T; 3] + use<T>, WindProblem> {
        let g = self.grid;
        let last = g.tower - 1;
        let lowest = g.bottom - g.vertical_step * last as f64;
        if at[2].re() < 0.0 && lowest > 0.0 && self.outside == OutsideGrid::Refuse {
            return Err(self.outside(at));
        }
        let factor = if at[2].re() < 0.0 {
            T::from(0.0)
        } else if at[2].re() < lowest {
            at[2] / lowest
        } else {
            T::from(1.0)
        };
        let k = between(-z, g.tower, true).ok_or_else(|| self.outside(at))?;
        Ok(move |plane: &Plane| {
            let ends = [k.low, k.high].map(|k| vector(plane, g.tower_index(k)));
            mixed(k.fraction, ends).map(|u| u * factor)
        })
    }
}

/// The neighbors of a position in cells, among `count` points; `None` outside, unless the
/// position is `extended` to the nearest point.
fn between<T: Real>(position: T, count: usize, extended: bool) -> Option<Between<T>> {
    let last = count.checked_sub(1)?;
    let value = position.re();
    let end = last as f64;
    if value.is_nan() || (!extended && !(-SLACK..=end + SLACK).contains(&value)) {
        return None;
    }
    let at_end = |low: usize| Between {
        low,
        high: low,
        fraction: T::from(0.0),
    };
    if value < 0.0 {
        return Some(at_end(0));
    }
    if value > end || last == 0 {
        return Some(at_end(last));
    }
    let low = (value.floor() as usize).min(last - 1);
    Some(Between {
        low,
        high: low + 1,
        fraction: position - low as f64,
    })
}

fn vector<T: Real>(plane: &Plane, index: usize) -> [T; 3] {
    [0, 1, 2].map(|c| T::from(plane[index + c]))
}

fn mixed<T: Real>(fraction: T, [a, b]: [[T; 3]; 2]) -> [T; 3] {
    [0, 1, 2].map(|c| a[c] + (b[c] - a[c]) * fraction)
}

#[cfg(test)]
#[path = "turbulence_tests.rs"]
mod tests;
