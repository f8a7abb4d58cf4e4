//! Properties of a blade at an arc length.
//!
//! Between two stations at `s_a` and `s_b`, entry by entry,
//!
//! ```text
//! K(s) = (1 - v) K_a + v K_b        v = (s - s_a)/(s_b - s_a)
//! ```
//!
//! or `K(s) = K_a` with constant interpolation; M and D likewise. Inside the first and
//! outside the last station, the properties of that station apply.

use nalgebra::{Matrix6, Vector3};

use super::{Blade, BladeDamping, Interpolation, Side};
use crate::wrench;

/// Two stations and the weight of the second.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Between {
    inner: usize,
    outer: usize,
    part: f64,
}

impl Blade {
    /// Length along the reference line [m].
    pub fn length(&self) -> f64 {
        self.line.length()
    }

    /// Mass: the integral of the interpolated mass per length along the line, which is
    /// exact [kg].
    pub fn mass(&self) -> f64 {
        let length = self.length();
        let mut positions = vec![0.0];
        let inside = |s: &f64| *s > 0.0 && *s < length;
        positions.extend(self.positions().into_iter().filter(inside));
        positions.push(length);
        let of_piece = |ends: &[f64]| {
            let at = |s, side| self.mix(s, side, |station| self.stations[station].mass)[(0, 0)];
            let sum = at(ends[0], Side::Outer) + at(ends[1], Side::Inner);
            0.5 * (ends[1] - ends[0]) * sum
        };
        positions.windows(2).map(of_piece).sum()
    }

    /// Stiffness and mass per length about the line at arc length `s` [m], at a jump on
    /// `side`. Units as of a [`super::Station`]; zero without stations.
    pub fn at(&self, s: f64, side: Side) -> (Matrix6<f64>, Matrix6<f64>) {
        let stiffness = self.mix(s, side, |station| self.stations[station].stiffness);
        let mass = self.mix(s, side, |station| self.stations[station].mass);
        (self.about_line(&stiffness), self.about_line(&mass))
    }

    /// Damping about the line at arc length `s` [m], at a jump on `side`
    /// [N s, N m s, N m^2 s]. `None` for a blade without damping.
    pub fn damping_at(&self, s: f64, side: Side) -> Option<Matrix6<f64>> {
        let damping = self.damping.as_ref()?;
        let of_station = |station| self.station_damping(damping, station);
        Some(self.about_line(&self.mix(s, side, of_station)))
    }

    /// Damping of a station at the reference point; zero if none is given.
    pub(super) fn station_damping(&self, damping: &BladeDamping, station: usize) -> Matrix6<f64> {
        let stiffness = &self.stations[station].stiffness;
        match damping {
            BladeDamping::Proportional(time) => stiffness * *time,
            BladeDamping::Times(times) => Matrix6::from_fn(|i, j| times[i] * stiffness[(i, j)]),
            BladeDamping::Viscous(all) => all.get(station).copied().unwrap_or_default(),
        }
    }

    /// Arc lengths of the stations, each once [m].
    pub fn positions(&self) -> Vec<f64> {
        let mut positions: Vec<_> = self.stations.iter().map(|s| s.arc_length).collect();
        positions.dedup();
        positions
    }

    /// Arc lengths at which the properties jump: of two stations at one arc length; with
    /// constant interpolation, of all stations between the ends [m].
    pub fn jumps(&self) -> Vec<f64> {
        let mut jumps: Vec<_> = match self.interpolation {
            Interpolation::Constant => self.positions().into_iter().skip(1).collect(),
            Interpolation::Linear => {
                let pairs = self.stations.windows(2);
                let doubled = pairs.filter(|pair| pair[0].arc_length == pair[1].arc_length);
                doubled.map(|pair| pair[0].arc_length).collect()
            }
        };
        let length = self.length();
        jumps.retain(|s| *s > 0.0 && *s < length);
        jumps
    }

    /// A matrix of the stations at `s`.
    fn mix(&self, s: f64, side: Side, of: impl Fn(usize) -> Matrix6<f64>) -> Matrix6<f64> {
        match self.between(s, side) {
            Some(Between {
                inner, part: 0.0, ..
            }) => of(inner),
            Some(Between { inner, outer, part }) => of(inner) * (1.0 - part) + of(outer) * part,
            None => Matrix6::zeros(),
        }
    }

    fn between(&self, s: f64, side: Side) -> Option<Between> {
        let behind = match side {
            Side::Inner => self.stations.partition_point(|at| at.arc_length < s),
            Side::Outer => self.stations.partition_point(|at| at.arc_length <= s),
        };
        let last = self.stations.len().checked_sub(1)?;
        let alone = |station| Between {
            inner: station,
            outer: station,
            part: 0.0,
        };
        if behind == 0 {
            return Some(alone(0));
        }
        if behind > last || self.interpolation == Interpolation::Constant {
            return Some(alone(behind - 1));
        }
        let ends = [behind - 1, behind].map(|station| self.stations[station].arc_length);
        Some(Between {
            inner: behind - 1,
            outer: behind,
            part: (s - ends[0]) / (ends[1] - ends[0]),
        })
    }

    fn about_line(&self, matrix: &Matrix6<f64>) -> Matrix6<f64> {
        match self.reference_point {
            point if point == nalgebra::Vector2::zeros() => *matrix,
            point => wrench::shift(matrix, &-Vector3::new(0.0, point.x, point.y)),
        }
    }
}
