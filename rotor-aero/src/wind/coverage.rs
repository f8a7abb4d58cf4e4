//! Turbulence boxes that are too small for the points in them.

use shared_geom::error::Explain;

use super::problem::short;
use super::turbulence::TurbulenceBox;

/// Part of a cell by which a rotor may be outside: grids of files are in single precision.
const SLACK: f64 = 1e-5;

/// A side at which a box is too small.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "turbulence box \"{name}\": {what} is {} {unit}, expected at {} {} {unit} for {user}",
    short(*.found),
    if *.is_least { "least" } else { "most" },
    short(*.limit)
)]
pub struct TooSmall {
    /// The box.
    pub name: String,
    /// The size, as text.
    pub what: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The size found [unit].
    pub found: f64,
    /// The size needed [unit].
    pub limit: f64,
    /// Whether it is the least size, else the largest.
    pub is_least: bool,
    /// The points that it does not cover, as text.
    pub user: String,
    /// The remedy.
    pub remedy: &'static str,
}

/// A part of the space that a box must cover, in the axes of the wind.
#[derive(Debug, Clone, PartialEq)]
pub struct Extent {
    /// The points, as text.
    pub user: String,
    /// Least coordinates: downwind, lateral, above the ground \[m\].
    pub low: [f64; 3],
    /// Largest coordinates \[m\].
    pub high: [f64; 3],
}

impl Extent {
    /// Of a rotor in any attitude: a ball about its center, with the radius of its tips \[m\].
    pub fn ball(user: &str, center: [f64; 3], radius: f64) -> Self {
        Self {
            user: user.to_owned(),
            low: center.map(|at| at - radius),
            high: center.map(|at| at + radius),
        }
    }

    /// Of points; `None` without any.
    pub fn of_points(user: &str, points: impl Iterator<Item = [f64; 3]>) -> Option<Self> {
        let of_one = |at| Self::ball(user, at, 0.0);
        points.map(of_one).reduce(|mut found, one| {
            for axis in 0..3 {
                found.low[axis] = found.low[axis].min(one.low[axis]);
                found.high[axis] = found.high[axis].max(one.high[axis]);
            }
            found
        })
    }
}

/// A side of a box.
#[derive(Clone, Copy)]
struct Side {
    what: &'static str,
    unit: &'static str,
    remedy: &'static str,
}

const WIDTH: Side = Side {
    what: "half the width",
    unit: "m",
    remedy: "make the box wider, or extend it to points outside",
};
const TOP: Side = Side {
    what: "the top",
    unit: "m",
    remedy: "make the box higher or raise it, or extend it to points outside",
};
const BOTTOM: Side = Side {
    what: "the bottom",
    unit: "m",
    remedy: "make the box higher or lower it, add tower points, or extend it to points outside",
};
const DURATION: Side = Side {
    what: "the duration",
    unit: "s",
    remedy: "make a longer box, or one that is periodic",
};
const FIRST: Side = Side {
    what: "the position of the first plane",
    unit: "m",
    remedy: "shift the box downwind, or start later",
};

impl Explain for TooSmall {
    fn help(&self) -> Option<String> {
        Some(self.remedy.to_owned())
    }
}

impl TurbulenceBox {
    /// The sides at which the box does not cover an extent during `duration` \[s\].
    pub fn uncovered(&self, extent: &Extent, duration: f64) -> Vec<TooSmall> {
        let g = self.grid();
        let slack = SLACK * g.lateral_step.max(g.vertical_step);
        let bottom = if g.tower > 0 { 0.0 } else { g.bottom };
        let Extent { low, high, .. } = extent;
        let mut sides = vec![
            (WIDTH, [g.half_width(), high[1].max(-low[1])]),
            (TOP, [g.top(), high[2]]),
            (BOTTOM, [bottom, low[2]]),
        ];
        if !g.periodic {
            let needed = duration + (self.shift() - low[0]) / g.speed;
            sides.push((DURATION, [g.duration(), needed]));
            sides.push((FIRST, [self.shift(), high[0]]));
        }
        let small = |(side, [found, limit]): (Side, [f64; 2])| {
            let is_least = side.what != BOTTOM.what;
            let missing = if is_least {
                limit - found
            } else {
                found - limit
            };
            let is_small = missing.is_nan() || missing > slack;
            is_small.then(|| TooSmall {
                name: self.name().to_owned(),
                what: side.what,
                unit: side.unit,
                found,
                limit,
                is_least,
                user: extent.user.clone(),
                remedy: side.remedy,
            })
        };
        sides.into_iter().filter_map(small).collect()
    }
}
