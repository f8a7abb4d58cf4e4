//! Turbulence boxes that are too small for a rotor.

use shared_geom::error::Explain;

use super::problem::short;
use super::turbulence::TurbulenceBox;

/// Part of a cell by which a rotor may be outside: grids of files are in single precision.
const SLACK: f64 = 1e-5;

/// A side at which a box is too small.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "turbulence box \"{name}\": {what} is {} {unit}, expected at {} {} {unit} for the rotor",
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
    /// The remedy.
    pub remedy: &'static str,
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
    remedy: "shift the box downwind by the radius, or start later",
};

impl Explain for TooSmall {
    fn help(&self) -> Option<String> {
        Some(self.remedy.to_owned())
    }
}

impl TurbulenceBox {
    /// The sides at which the box does not cover a rotor of a `radius` \[m\] at a `hub_height` \[m\]
    /// during `duration` \[s\], in any yaw.
    pub fn uncovered(&self, radius: f64, hub_height: f64, duration: f64) -> Vec<TooSmall> {
        let g = self.grid();
        let slack = SLACK * g.lateral_step.max(g.vertical_step);
        let bottom = if g.tower > 0 { 0.0 } else { g.bottom };
        let mut sides = vec![
            (WIDTH, [g.half_width(), radius]),
            (TOP, [g.top(), hub_height + radius]),
            (BOTTOM, [bottom, hub_height - radius]),
        ];
        if !g.periodic {
            let needed = duration + (self.shift() + radius) / g.speed;
            sides.push((DURATION, [g.duration(), needed]));
            sides.push((FIRST, [self.shift(), radius]));
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
                remedy: side.remedy,
            })
        };
        sides.into_iter().filter_map(small).collect()
    }
}
