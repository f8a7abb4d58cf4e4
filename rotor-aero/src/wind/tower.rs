//! Influence of a tower on the air around it.
//!
//! Lengths in tower radii at the height of the point, x downwind along the local horizontal
//! wind, y lateral; fractions of the local horizontal speed:
//!
//! ```text
//! potential: u = (y^2 - x^2)/q^2,  v = -2 x y/q^2,   q = max(x^2 + y^2, 1)
//! Bak:       the same at x + 0.1, plus Cd/(2 pi q) (x, y)
//! Powles:    x > 0, |y| < s:  u = -(Cd/s) cos^2(pi y/(2 s)),  s = (x^2 + y^2)^(1/4)
//! Eames:     x > 0:  u = -Cd/(TI x sqrt(2 pi)) exp(-y^2/(2 TI^2 x^2))
//! ```
//!
//! The deficit of a shadow is at most 0.5. The models are the ones of AeroDyn: potential flow with
//! the correction of Bak, Madsen and Johansen (2001), the shadows of Powles (1983) and of Eames et
//! al. Above the top the influence fades within one radius.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::problem::WindProblem;
use crate::real::Real;

/// Largest deficit of a shadow \[-\].
const DEFICIT: f64 = 0.5;

/// Flow around the tower, upwind and beside it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TowerPotential {
    /// None.
    None,
    /// Potential flow around a cylinder.
    #[default]
    Cylinder,
    /// The same with the correction by Bak.
    Bak,
}

/// Flow behind the tower.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum TowerShadow {
    /// None.
    #[default]
    None,
    /// Powles.
    Powles,
    /// Eames.
    Eames {
        /// Turbulence intensity around the tower \[-\].
        intensity: f64,
    },
}

/// A vertical tower, in the axes of the wind.
#[derive(Debug, Clone, PartialEq)]
pub struct Tower {
    foot: [f64; 2],
    /// Heights and radii.
    radii: Vec<[f64; 2]>,
    drag: f64,
    potential: TowerPotential,
    shadow: TowerShadow,
}

impl Tower {
    /// A tower at `foot` (x, y) \[m\] with radii over ascending heights, rows (height \[m\], radius
    /// \[m\]), the drag coefficient `drag` \[-\], and its models.
    ///
    /// # Errors
    /// All values that are not usable.
    pub fn new(
        foot: [f64; 2],
        radii: Vec<[f64; 2]>,
        drag: f64,
        potential: TowerPotential,
        shadow: TowerShadow,
    ) -> Result<Self, Vec<WindProblem>> {
        let tower = Self {
            foot,
            radii,
            drag,
            potential,
            shadow,
        };
        let problems = tower.problems();
        if problems.is_empty() {
            Ok(tower)
        } else {
            Err(problems)
        }
    }

    fn problems(&self) -> Vec<WindProblem> {
        const HELP: &str = "describe the tower from the ground to its top, in meters";
        let mut problems = Vec::new();
        let mut wrong = |what: &str, found: f64, expected: &str| {
            problems.push(WindProblem::value(what, found, expected, HELP));
        };
        if self.radii.len() < 2 {
            let found = self.radii.len() as f64;
            wrong("number of heights of the tower", found, "at least 2");
        }
        for pair in self.radii.windows(2) {
            if pair[1][0] <= pair[0][0] {
                wrong("height of the tower", pair[1][0], "ascending heights");
            }
        }
        for [height, radius] in &self.radii {
            if !height.is_finite() {
                wrong("height of the tower", *height, "a number");
            }
            if !(*radius > 0.0 && radius.is_finite()) {
                wrong("radius of the tower", *radius, "a positive number");
            }
        }
        if !(self.drag >= 0.0 && self.drag.is_finite()) {
            wrong("drag coefficient of the tower", self.drag, "zero or more");
        }
        for foot in self.foot.iter().filter(|foot| !foot.is_finite()) {
            wrong("foot of the tower", *foot, "a number");
        }
        if let TowerShadow::Eames { intensity } = self.shadow
            && !(intensity > 0.0 && intensity.is_finite())
        {
            let what = "turbulence intensity around the tower";
            wrong(what, intensity, "a positive number");
        }
        problems
    }

    /// The velocity `wind` at a point, changed by the tower; in the axes of the wind \[m/s\].
    pub fn changed<T: Real>(&self, at: &[T; 3], wind: &[T; 3]) -> [T; 3] {
        let square = wind[0] * wind[0] + wind[1] * wind[1];
        let Some((radius, fade)) = self.radius(at[2]) else {
            return *wind;
        };
        if square.re().is_nan() || square.re() <= 1e-12 {
            return *wind;
        }
        let speed = square.sqrt();
        let [ex, ey] = [wind[0] / speed, wind[1] / speed];
        let [dx, dy] = [
            (at[0] - self.foot[0]) / radius,
            (at[1] - self.foot[1]) / radius,
        ];
        let [x, y] = [dx * ex + dy * ey, dy * ex - dx * ey];
        let [u, v] = self.fractions(x, y);
        let [u, v] = [u * fade * speed, v * fade * speed];
        [
            wind[0] + u * ex - v * ey,
            wind[1] + u * ey + v * ex,
            wind[2],
        ]
    }

    /// Changes of the velocity along and across the wind, as fractions of its speed, at a point
    /// `x` downwind and `y` beside the axis, in radii.
    pub fn fractions<T: Real>(&self, x: T, y: T) -> [T; 2] {
        let [u, v] = self.potential_part(x, y);
        let deficit = self.deficit(x, y);
        let deficit = if deficit.re() > DEFICIT {
            T::from(DEFICIT)
        } else {
            deficit
        };
        [u - deficit, v]
    }

    fn potential_part<T: Real>(&self, x: T, y: T) -> [T; 2] {
        match self.potential {
            TowerPotential::None => [T::from(0.0); 2],
            TowerPotential::Cylinder => doublet(x, y),
            TowerPotential::Bak => {
                let x = x + 0.1;
                let [u, v] = doublet(x, y);
                let source = at_least_one(x * x + y * y).recip() * (self.drag / TAU);
                [u + source * x, v + source * y]
            }
        }
    }

    /// Deficit behind the tower, without its limit.
    fn deficit<T: Real>(&self, x: T, y: T) -> T {
        if x.re().is_nan() || x.re() <= 0.0 {
            return T::from(0.0);
        }
        match self.shadow {
            TowerShadow::None => T::from(0.0),
            TowerShadow::Powles => {
                let s = at_least_one(x * x + y * y).sqrt().sqrt();
                if y.re().abs() >= s.re() {
                    return T::from(0.0);
                }
                let cos = (y / s * FRAC_PI_2).cos();
                cos * cos / s * self.drag
            }
            TowerShadow::Eames { intensity } => {
                // the limit of the deficit is reached long before
                let x = if x.re() < 1e-3 { T::from(1e-3) } else { x };
                let width = x * intensity;
                let ratio = y / width;
                (ratio * ratio * -0.5).exp() / width * (self.drag / TAU.sqrt())
            }
        }
    }

    /// Radius at a height, and the fade of the influence: 1 up to the top, 0 one radius above;
    /// `None` where there is no influence.
    fn radius<T: Real>(&self, z: T) -> Option<(T, T)> {
        let [first, last] = [self.radii.first()?, self.radii.last()?];
        if z.re().is_nan() || z.re() < first[0] || z.re() >= last[0] + last[1] {
            return None;
        }
        if z.re() >= last[0] {
            let above = (z - last[0]) / last[1];
            let rest = -(above * above) + 1.0;
            return Some((T::from(last[1]), rest * rest));
        }
        let next = self.radii.partition_point(|row| row[0] <= z.re());
        let (a, b) = (self.radii[next - 1], self.radii[next]);
        let slope = (b[1] - a[1]) / (b[0] - a[0]);
        Some(((z - a[0]) * slope + a[1], T::from(1.0)))
    }
}

/// Potential flow around the unit cylinder, without its stream.
fn doublet<T: Real>(x: T, y: T) -> [T; 2] {
    let q = at_least_one(x * x + y * y);
    let square = (q * q).recip();
    [(y * y - x * x) * square, x * y * square * -2.0]
}

fn at_least_one<T: Real>(q: T) -> T {
    if q.re() < 1.0 { T::from(1.0) } else { q }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tower(potential: TowerPotential, shadow: TowerShadow) -> Tower {
        let radii = vec![[0.0, 4.0], [80.0, 2.0]];
        Tower::new([0.0, 0.0], radii, 0.5, potential, shadow).unwrap()
    }

    /// Stagnation upwind, twice the speed beside: the classic values of the cylinder.
    #[test]
    fn potential_flow_around_a_cylinder() {
        let tower = tower(TowerPotential::Cylinder, TowerShadow::None);
        let at = |at: [f64; 3]| tower.changed(&at, &[10.0, 0.0, 1.0]);
        assert_eq!(at([-4.0, 0.0, 0.0]), [0.0, 0.0, 1.0]);
        assert_eq!(at([0.0, 4.0, 0.0])[0], 20.0);
        // radius 3 at half the height: (x, y) = (-2, 0) radii
        assert!((at([-6.0, 0.0, 40.0])[0] - 7.5).abs() < 1e-14);
        // no flow through the surface
        let [x, y] = [-0.6_f64, 0.8];
        let [u, v, _] = at([4.0 * x, 4.0 * y, 0.0]);
        assert!((u * x + v * y).abs() < 1e-14);
        // the same when the wind turns by a quarter
        let turned = tower.changed(&[-4.0 * y, 4.0 * x, 0.0], &[0.0, 10.0, 1.0]);
        assert!((turned[0] + v).abs() < 1e-14 && (turned[1] - u).abs() < 1e-14);
        // inside the tower nothing grows without limit
        assert!(at([0.01, 0.0, 0.0]).iter().all(|u| u.abs() < 20.0));
    }

    #[test]
    fn shadows_and_their_limit() {
        let powles = tower(TowerPotential::None, TowerShadow::Powles);
        // x = 16 radii, s = 4: deficit Cd/4
        assert!(f64::abs(powles.fractions(16.0, 0.0)[0] + 0.125) < 1e-15);
        assert_eq!(powles.fractions(-16.0, 0.0)[0], 0.0);
        assert_eq!(powles.fractions(9.0, 4.0)[0], 0.0);
        let eames = tower(TowerPotential::None, TowerShadow::Eames { intensity: 0.1 });
        assert_eq!(eames.fractions(1e-9, 0.0)[0], -0.5);
        let expected = 0.5 / (10.0 * 0.1 * TAU.sqrt()) * (-0.5_f64).exp();
        assert!((eames.fractions(10.0, 1.0)[0] + expected).abs() < 1e-15);
    }

    #[test]
    fn bak_adds_a_source() {
        let bak = tower(TowerPotential::Bak, TowerShadow::None);
        let [u, v] = bak.fractions(1.9, 0.0);
        assert!((u - (-0.25 + 0.5 / TAU / 2.0)).abs() < 1e-15 && v == 0.0);
    }

    #[test]
    fn the_influence_ends_above_the_top() {
        let tower = tower(TowerPotential::Cylinder, TowerShadow::None);
        let wind = [10.0, 0.0, 0.0];
        assert_eq!(tower.changed(&[-3.0, 0.0, 82.0], &wind), wind);
        assert_eq!(tower.changed(&[-3.0, 0.0, -1.0], &wind), wind);
        let [below, top] = [80.0 - 1e-9, 80.0].map(|z| tower.changed(&[-3.0, 0.0, z], &wind)[0]);
        assert!(f64::abs(below - top) < 1e-8);
        assert_eq!(tower.changed(&[-3.0, 0.0, 5.0], &[0.0; 3]), [0.0; 3]);
    }

    #[test]
    fn all_problems_of_a_tower_are_reported() {
        let radii = vec![[10.0, 0.0], [5.0, f64::NAN]];
        let shadow = TowerShadow::Eames { intensity: 0.0 };
        let found = Tower::new([f64::NAN, 0.0], radii, -1.0, TowerPotential::None, shadow);
        assert_eq!(found.unwrap_err().len(), 6);
    }
}
