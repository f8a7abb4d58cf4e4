//! The units of a domain.

use nalgebra::Vector6;

/// Units and origin of a [`Domain`](super::Domain), in section axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaling {
    /// Position of the domain's origin, the area centroid: y, z \[m\].
    pub origin: [f64; 2],
    /// Unit of length \[m\].
    pub length: f64,
    /// Unit of stress \[Pa\].
    pub modulus: f64,
    /// Unit of electric potential \[V\].
    pub potential: f64,
}

impl Scaling {
    /// Units of the generalized strain: 1 for the first three, 1/length for the
    /// curvatures \[-, 1/m\].
    pub fn strain(&self) -> Vector6<f64> {
        let curvature = 1.0 / self.length;
        Vector6::new(1.0, 1.0, 1.0, curvature, curvature, curvature)
    }

    /// Units of the internal force \[N, N m\].
    pub fn force(&self) -> Vector6<f64> {
        let force = self.modulus * self.length * self.length;
        let moment = force * self.length;
        Vector6::new(force, force, force, moment, moment, moment)
    }
}

/// The larger of two, NaN when one of them is; for use in a fold.
pub(crate) fn largest(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// The power of two nearest to `value` on a logarithmic scale; `None` when
/// `value` is not finite and positive.
pub(super) fn power_of_two(value: f64) -> Option<f64> {
    let normal = value.is_normal() && value > 0.0;
    normal.then(|| 2f64.powi(value.log2().round() as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_powers_of_two() {
        assert_eq!(power_of_two(1.0), Some(1.0));
        assert_eq!(power_of_two(210e9), Some(2f64.powi(38)));
        assert_eq!(power_of_two(1e-3), Some(2f64.powi(-10)));
        assert_eq!(power_of_two(0.0), None);
        assert_eq!(power_of_two(f64::NAN), None);
        assert_eq!(power_of_two(f64::INFINITY), None);
    }

    #[test]
    fn not_a_number_is_not_lost_in_a_maximum() {
        assert!([1.0, f64::NAN, 2.0].into_iter().fold(0.0, largest).is_nan());
        assert!([1.0, f64::NAN].into_iter().fold(0.0, largest).is_nan());
        assert_eq!([1.0, 3.0, 2.0].into_iter().fold(0.0, largest), 3.0);
    }
}
