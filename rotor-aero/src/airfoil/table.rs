//! A coefficient over all variables of a table.
//!
//! Over angle of attack and Mach number it is a [`Surface`]. Between Reynolds numbers it is linear
//! in the logarithm, and between deflections linear; it is constant outside both ranges. Its
//! derivatives by these two therefore jump at the tables: the coefficients vary little with the
//! Reynolds number, and a limited slope would need the values at four of them.

use super::cubic::{self, Interpolation};
use super::data::{Curve, Flow};
use super::surface::Surface;
use crate::real::Real;

/// One coefficient of an airfoil.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Table {
    flaps: Interpolated<Interpolated<Surface>>,
}

impl Table {
    /// The table of checked curves; `None` without curves.
    pub(super) fn new(curves: &[Curve], interpolation: Interpolation) -> Option<Self> {
        let by_flap = grouped(curves, |curve| curve.flap.unwrap_or(0.0));
        let by_reynolds = |group: &Vec<Curve>| {
            let groups = grouped(group, |curve| curve.reynolds.map_or(0.0, f64::ln));
            Interpolated::new(&groups, |curves| {
                Surface::new(&ascending(curves), interpolation)
            })
        };
        let has_curves = !by_flap.is_empty();
        has_curves.then(|| Self {
            flaps: Interpolated::new(&by_flap, by_reynolds),
        })
    }

    /// The coefficient in a flow.
    pub(super) fn at<T: Real>(&self, flow: &Flow<T>) -> T {
        self.flaps.at(
            || flow.flap,
            |by_reynolds| {
                by_reynolds.at(
                    || logarithm(flow.reynolds),
                    |surface| surface.at(flow.alpha, flow.mach),
                )
            },
        )
    }
}

/// A coefficient and its derivatives by angle of attack, Mach number, Reynolds number and deflection.
pub(super) type Slopes = [f64; 5];

impl Table {
    /// The coefficient in a flow with its derivatives: the same as [`Self::at`] in plain numbers.
    pub(super) fn slopes(&self, flow: &Flow<f64>) -> Slopes {
        let of_reynolds = |by_reynolds: &Interpolated<Surface>| {
            let of_surface = |surface: &Surface| {
                let [value, by_alpha, by_mach] = surface.slopes(flow.alpha, flow.mach);
                [value, by_alpha, by_mach, 0.0, 0.0]
            };
            let x = || logarithm(flow.reynolds);
            let mut found = by_reynolds.slopes(x, 3, of_surface);
            if found[3] != 0.0 {
                found[3] /= flow.reynolds;
            }
            found
        };
        self.flaps.slopes(|| flow.flap, 4, of_reynolds)
    }
}

/// The logarithm; numbers without one count as the smallest positive number.
fn logarithm<T: Real>(x: T) -> T {
    if x.re() <= 0.0 {
        T::from(f64::MIN_POSITIVE.ln())
    } else {
        x.ln()
    }
}

/// Items at ascending abscissas, linear between them and constant outside.
#[derive(Debug, Clone, PartialEq)]
struct Interpolated<C> {
    knots: Vec<f64>,
    items: Vec<C>,
}

impl<C> Interpolated<C> {
    fn new(groups: &[(f64, Vec<Curve>)], item: impl Fn(&Vec<Curve>) -> C) -> Self {
        Self {
            knots: groups.iter().map(|(knot, _)| *knot).collect(),
            items: groups.iter().map(|(_, curves)| item(curves)).collect(),
        }
    }

    /// The value at `x`, which is evaluated only if there are several items.
    fn at<T: Real>(&self, x: impl Fn() -> T, value: impl Fn(&C) -> T) -> T {
        let last = self.items.len() - 1;
        if last == 0 {
            return value(&self.items[0]);
        }
        let x = x();
        if x.re() <= self.knots[0] {
            return value(&self.items[0]);
        }
        if x.re() >= self.knots[last] {
            return value(&self.items[last]);
        }
        let i = cubic::interval(&self.knots, x.re());
        let t = (x - self.knots[i]) / (self.knots[i + 1] - self.knots[i]);
        let low = value(&self.items[i]);
        low + t * (value(&self.items[i + 1]) - low)
    }
}

impl<C> Interpolated<C> {
    /// The value at `x` with its derivatives, the one by `x` at `index`.
    fn slopes(&self, x: impl Fn() -> f64, index: usize, value: impl Fn(&C) -> Slopes) -> Slopes {
        let last = self.items.len() - 1;
        if last == 0 {
            return value(&self.items[0]);
        }
        let x = x();
        if x <= self.knots[0] {
            return value(&self.items[0]);
        }
        if x >= self.knots[last] {
            return value(&self.items[last]);
        }
        let i = cubic::interval(&self.knots, x);
        let h = self.knots[i + 1] - self.knots[i];
        let t = (x - self.knots[i]) / h;
        let (low, high) = (value(&self.items[i]), value(&self.items[i + 1]));
        let mut found: Slopes = std::array::from_fn(|k| low[k] + t * (high[k] - low[k]));
        found[index] = (high[0] - low[0]) / h;
        found
    }
}

/// Curves with the same key together, keys ascending.
fn grouped(curves: &[Curve], key: impl Fn(&Curve) -> f64) -> Vec<(f64, Vec<Curve>)> {
    let mut groups: Vec<(f64, Vec<Curve>)> = Vec::new();
    for curve in curves {
        let key = key(curve);
        match groups.iter_mut().find(|(other, _)| *other == key) {
            Some((_, group)) => group.push(curve.clone()),
            None => groups.push((key, vec![curve.clone()])),
        }
    }
    groups.sort_by(|a, b| a.0.total_cmp(&b.0));
    groups
}

/// Curves in the order of their Mach numbers.
fn ascending(curves: &[Curve]) -> Vec<Curve> {
    let mut sorted = curves.to_vec();
    let mach = |curve: &Curve| curve.mach.unwrap_or(0.0);
    sorted.sort_by(|a, b| mach(a).total_cmp(&mach(b)));
    sorted
}
