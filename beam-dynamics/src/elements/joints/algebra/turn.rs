//! Axes that a drive turns.
//!
//! A rotation vector phi(t) of length x in the axes E turns them to `E R(phi)`. With the
//! tangent T of `omega = T(phi) phi'` and its ratios `a = sin x/x`, `b = (1 - cos x)/x^2`,
//! `c = (x - sin x)/x^3`,
//!
//! ```text
//! w  = E T phi'                        e' = w x e                      at fixed E
//! w' = E (T phi'' + T' phi')           e'' = w' x e + w x (w x e)
//! T' phi' = (phi.phi') [p phi x phi' + q phi x (phi x phi')] + c phi' x (phi x phi')
//! p = (a - 2 b)/x^2,  q = (b - 3 c)/x^2
//! ```
//!
//! at any angle, full turns included.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

/// Turned axes, with their own motion at fixed E.
#[derive(Debug, Clone, Copy)]
pub(in crate::elements::joints) struct Turned {
    /// `E R(phi)` [-].
    pub axes: Matrix3<f64>,
    /// w, model axes [rad/s].
    pub omega: Vector3<f64>,
    /// w', model axes [rad/s^2].
    pub alpha: Vector3<f64>,
}

impl Turned {
    /// Axes without a drive.
    pub fn fixed(axes: &Matrix3<f64>) -> Self {
        Self {
            axes: *axes,
            omega: Vector3::zeros(),
            alpha: Vector3::zeros(),
        }
    }

    /// `axes` turned by the rotation vector `phi`, with its first and second derivative.
    pub fn by(axes: &Matrix3<f64>, [phi, first, second]: &[Vector3<f64>; 3]) -> Self {
        let tangent = vector::tangent(phi);
        Self {
            axes: axes * vector::to_rotation(phi),
            omega: axes * (tangent * first),
            alpha: axes * (tangent * second + tangent_rate(phi, first)),
        }
    }

    /// `e'` and `e''` of a direction `e`.
    pub fn derivatives(&self, e: &Vector3<f64>) -> [Vector3<f64>; 2] {
        let first = self.omega.cross(e);
        [first, self.alpha.cross(e) + self.omega.cross(&first)]
    }
}

/// `T' phi'`.
fn tangent_rate(phi: &Vector3<f64>, first: &Vector3<f64>) -> Vector3<f64> {
    let x = phi.norm();
    let [p, q, c] = ratios(x);
    let once = phi.cross(first);
    phi.dot(first) * (p * once + q * phi.cross(&once)) + c * first.cross(&once)
}

/// p, q and c; below one radian by their series, which do not cancel:
/// `sum (-1)^m 2 m x^(2m-2)/(2m+2)!`, the same over `(2m+3)!`, `sum (-1)^m x^2m/(2m+3)!`.
fn ratios(x: f64) -> [f64; 3] {
    if x > 1.0 {
        let (sine, cosine) = x.sin_cos();
        let (a, b) = (sine / x, (1.0 - cosine) / (x * x));
        let c = (1.0 - a) / (x * x);
        return [(a - 2.0 * b) / (x * x), (b - 3.0 * c) / (x * x), c];
    }
    // (-1)^m x^(2m-2)/(2m+2)!, from m = 1 on.
    let mut term = -1.0 / 24.0;
    let [mut p, mut q, mut c] = [0.0, 0.0, 1.0 / 6.0];
    for m in 1..10 {
        let n = 2.0 * f64::from(m);
        p += n * term;
        q += n * term / (n + 3.0);
        c += x * x * term / (n + 3.0);
        term *= -x * x / ((n + 3.0) * (n + 4.0));
    }
    [p, q, c]
}

#[cfg(test)]
mod tests {
    use super::*;

    // Central differences of the rotation over 1e-4 s: truncation 1e-8 times third derivatives,
    // round-off 1e-16/1e-8 for the second: 1e-6 has a margin to both.
    #[test]
    fn spins_are_the_derivatives_of_the_axes_at_any_angle() {
        let axes = vector::to_rotation(&Vector3::new(0.3, -0.8, 0.5));
        for size in [0.0, 0.01, 0.9, 1.1, 3.0, 6.5, 20.0] {
            let phi = |t: f64| {
                let start = size * Vector3::new(0.6, 0.0, 0.8);
                start + Vector3::new(0.4, 0.7, -0.2) * t + Vector3::new(-0.3, 0.5, 0.8) * t * t
            };
            let first = Vector3::new(0.4, 0.7, -0.2);
            let second = 2.0 * Vector3::new(-0.3, 0.5, 0.8);
            let turned = Turned::by(&axes, &[phi(0.0), first, second]);
            let h = 1e-4;
            let at = |t: f64| axes * vector::to_rotation(&phi(t));
            for i in 0..3 {
                let e = turned.axes.column(i).into_owned();
                let [rate, acceleration] = turned.derivatives(&e);
                let [before, now, after] = [-h, 0.0, h].map(|t| at(t).column(i).into_owned());
                assert!((rate - (after - before) / (2.0 * h)).amax() < 1e-6);
                let found = (after - 2.0 * now + before) / (h * h);
                assert!((acceleration - found).amax() < 1e-6, "{size}: {found}");
            }
        }
    }
}
