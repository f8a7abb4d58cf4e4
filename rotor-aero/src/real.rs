//! Numbers with derivatives.

use num_dual::{DualNum, DualNumCopy};

/// A number, or a number with its derivatives by some variables (`num_dual`).
///
/// A kernel that is generic over it gives values for `f64`, and exact derivatives for dual
/// numbers. Branches compare values alone: `x.re()`.
pub trait Real: DualNumCopy + DualNum<Primitive = f64> {}

impl<T: DualNumCopy + DualNum<Primitive = f64>> Real for T {}

/// The angle of the direction (x, y) from x, between -pi and pi, with its derivatives on the axes
/// too; without derivatives at the origin \[rad\].
pub fn angle<T: Real>(y: T, x: T) -> T {
    let value = y.re().atan2(x.re());
    // The quotient that is finite.
    let angle = match y.re().abs() > x.re().abs() {
        true => -(x / y).atan(),
        false if x.re() == 0.0 => return T::from(value),
        false => (y / x).atan(),
    };
    angle + (value - angle.re())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use num_dual::DualSVec64;

    use super::*;

    /// `d angle = (x dy - y dx)/(x^2 + y^2)` all around, on the axes too.
    #[test]
    fn angles_have_derivatives_everywhere() {
        for step in 0..360u16 {
            let direction = TAU * f64::from(step) / 360.0;
            let exact = [(0.0, 2.0), (2.0, 0.0), (0.0, -2.0), (-2.0, 0.0)];
            let (y, x) = match step % 90 {
                0 => exact[usize::from(step / 90)],
                _ => (2.0 * direction.sin(), 2.0 * direction.cos()),
            };
            let of = |value: f64, index| DualSVec64::<2>::from_re(value).derivative(index);
            let found = angle(of(y, 0), of(x, 1));
            assert!((found.re - y.atan2(x)).abs() < 1e-15);
            let slopes = found.eps.unwrap_generic(nalgebra::Const, nalgebra::Const);
            assert!((slopes[0] - x / 4.0).abs() < 1e-15, "{step}");
            assert!((slopes[1] + y / 4.0).abs() < 1e-15, "{step}");
        }
        assert_eq!(angle(0.0, 0.0), 0.0);
    }
}
