//! Grid of a turbulence box: planes across the wind, one per time step.

use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::exchange::problem::ExchangeProblem;

/// Grid of a turbulence box.
///
/// A plane has the points `[z][y][3]`, y from the negative to the positive side, z from the
/// bottom up, the components u, v, w fastest; then the points of the tower `[k][3]`, the first at
/// the bottom of the grid, the next ones below it by `vertical_step` each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoxGrid {
    /// Number of planes, or time steps.
    pub planes: usize,
    /// Number of points along y.
    pub lateral: usize,
    /// Number of points along z.
    pub vertical: usize,
    /// Number of tower points.
    pub tower: usize,
    /// Time between planes \[s\].
    pub time_step: f64,
    /// Distance of points along y \[m\].
    pub lateral_step: f64,
    /// Distance of points along z \[m\].
    pub vertical_step: f64,
    /// Speed at which the planes are carried downwind \[m/s\].
    pub speed: f64,
    /// Height of the lowest points above the ground \[m\].
    pub bottom: f64,
    /// Height of the hub for which the box was made \[m\].
    pub hub_height: f64,
    /// Whether the first plane follows the last.
    pub periodic: bool,
}

/// A whole box in memory.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxValues {
    /// Its grid.
    pub grid: BoxGrid,
    /// Velocities of each plane, in the order of the grid \[m/s\].
    pub planes: Vec<Vec<f64>>,
}

impl BoxGrid {
    /// Number of values of a plane, three per point.
    pub fn values(&self) -> usize {
        3 * (self.lateral * self.vertical + self.tower)
    }

    /// Index of the first component at a point of a plane.
    pub fn index(&self, y: usize, z: usize) -> usize {
        3 * (z * self.lateral + y)
    }

    /// Index of the first component at a tower point.
    pub fn tower_index(&self, k: usize) -> usize {
        3 * (self.lateral * self.vertical + k)
    }

    /// Half the width \[m\].
    pub fn half_width(&self) -> f64 {
        0.5 * self.lateral_step * self.lateral.saturating_sub(1) as f64
    }

    /// Height of the highest points \[m\].
    pub fn top(&self) -> f64 {
        self.bottom + self.vertical_step * self.vertical.saturating_sub(1) as f64
    }

    /// Duration: of a periodic box its period, else from the first to the last plane \[s\].
    pub fn duration(&self) -> f64 {
        let steps = self.planes.saturating_sub(usize::from(!self.periodic));
        self.time_step * steps as f64
    }

    /// Problems of the grid, for messages.
    pub(super) fn problems(&self) -> Vec<ExchangeProblem> {
        let counts = [
            ("number of planes", self.planes),
            ("number of points along y", self.lateral),
            ("number of points along z", self.vertical),
        ];
        let counts = counts.into_iter().filter(|(_, count)| *count == 0);
        let mut problems: Vec<ExchangeProblem> = counts
            .map(|(what, count)| wrong(what, count as f64, "at least 1"))
            .collect();
        let steps = [
            ("time between planes [s]", self.time_step),
            ("distance of points along y [m]", self.lateral_step),
            ("distance of points along z [m]", self.vertical_step),
            ("mean speed of the box [m/s]", self.speed),
        ];
        for (what, value) in steps {
            if !(value > 0.0 && value.is_finite()) {
                problems.push(wrong(what, value, "a positive number"));
            }
        }
        for (what, value) in [("bottom", self.bottom), ("hub height", self.hub_height)] {
            if !value.is_finite() {
                problems.push(wrong(what, value, "a finite number of meters"));
            }
        }
        problems
    }
}

impl BoxValues {
    /// Checks grid, number and values of the planes; `name` is shown in messages.
    ///
    /// # Errors
    /// All problems of the grid; another number of planes or values; values that are not finite.
    pub fn check(&self, name: &str) -> Result<(), Diagnostics> {
        let mut problems = self.grid.problems();
        let (found, expected) = (self.planes.len(), self.grid.planes);
        if found != expected {
            let expected = expected.to_string();
            problems.push(wrong(
                "number of planes of the box",
                found as f64,
                &expected,
            ));
        }
        let size = self.grid.values();
        let lengths = self.planes.iter().map(Vec::len);
        if let Some(found) = lengths.clone().find(|found| *found != size) {
            let what = "number of values of a plane";
            problems.push(wrong(what, found as f64, &size.to_string()));
        }
        let all = self.planes.iter().flatten();
        if let Some(value) = all.clone().find(|value| !value.is_finite()) {
            problems.push(wrong(
                "a velocity of the box [m/s]",
                *value,
                "a finite number",
            ));
        }
        report(name, &problems)
    }
}

/// The problem of a number of a box.
pub(super) fn wrong(what: &str, found: f64, expected: &str) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: what.to_owned(),
        found: found.to_string(),
        expected: expected.to_owned(),
        help: "check that the file is complete and has this format".to_owned(),
    }
}

/// All problems of a file, or none.
pub(super) fn report(name: &str, problems: &[ExchangeProblem]) -> Result<(), Diagnostics> {
    let mut all = Diagnostics::new();
    for problem in problems {
        all.push(SourceLocation::file(name), problem);
    }
    all.into_result(())
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A grid of a few points.
    pub fn small(planes: usize, periodic: bool) -> BoxGrid {
        BoxGrid {
            planes,
            lateral: 5,
            vertical: 4,
            tower: 3,
            time_step: 0.25,
            lateral_step: 10.0,
            vertical_step: 8.0,
            speed: 12.0,
            bottom: 60.0,
            hub_height: 72.0,
            periodic,
        }
    }

    /// Numbers from 0 to 1, the same in every test (Knuth's constants).
    pub struct Lcg(pub u64);

    impl Lcg {
        pub fn next(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        }

        pub fn between(&mut self, low: f64, high: f64) -> f64 {
            low + (high - low) * self.next()
        }
    }

    /// A box of random velocities about the mean speed.
    pub fn random(grid: BoxGrid, seed: u64) -> BoxValues {
        let mut lcg = Lcg(seed);
        let mut plane = || -> Vec<f64> {
            let value = |i: usize, lcg: &mut Lcg| {
                lcg.between(-2.0, 2.0) + if i.is_multiple_of(3) { grid.speed } else { 0.0 }
            };
            (0..grid.values()).map(|i| value(i, &mut lcg)).collect()
        };
        let planes = (0..grid.planes).map(|_| plane()).collect();
        BoxValues { grid, planes }
    }

    #[test]
    fn sizes_of_the_grid() {
        let grid = small(6, true);
        assert_eq!((grid.half_width(), grid.top()), (20.0, 84.0));
        assert_eq!(grid.duration(), 1.5);
        assert_eq!(small(6, false).duration(), 1.25);
        assert_eq!(grid.tower_index(0), grid.index(0, 4));
    }

    #[test]
    fn all_problems_of_a_box_are_reported() {
        let mut values = random(small(6, true), 1);
        assert!(values.check("box").is_ok());
        values.planes[3][7] = f64::NAN;
        values.planes.pop();
        values.planes[0].pop();
        values.grid.time_step = 0.0;
        values.grid.bottom = f64::INFINITY;
        assert_eq!(values.check("box").unwrap_err().iter().count(), 5);
    }
}
