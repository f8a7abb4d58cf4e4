//! Numbers that stand for a whole stress.

use nalgebra::Vector6;

/// Von Mises stress of `stress`, order xx yy zz yz xz xy [Pa].
///
/// ```text
/// s^2 = 1/2 ((sxx - syy)^2 + (syy - szz)^2 + (szz - sxx)^2) + 3 (syz^2 + sxz^2 + sxy^2)
/// ```
pub(super) fn von_mises(stress: &Vector6<f64>) -> f64 {
    let [xx, yy, zz, yz, xz, xy] = (*stress).into();
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    let shear = yz * yz + xz * xz + xy * xy;
    (0.5 * normal + 3.0 * shear).sqrt()
}

/// Magnitude of the shear stress on the section, of which `stress` is the whole,
/// order xx yy zz yz xz xy [Pa].
pub(super) fn shear_resultant(stress: &Vector6<f64>) -> f64 {
    stress[4].hypot(stress[5])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uniaxial stress gives itself, pure shear sqrt(3) of it, pressure nothing.
    #[test]
    fn von_mises_of_simple_states() {
        let near = |stress: [f64; 6], expected: f64| {
            let found = von_mises(&stress.into());
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        };
        near([0.0, -2.0, 0.0, 0.0, 0.0, 0.0], 2.0);
        for shear in 3..6 {
            let mut stress = [0.0; 6];
            stress[shear] = 1.0;
            near(stress, 3_f64.sqrt());
        }
        near([4.0, 4.0, 4.0, 0.0, 0.0, 0.0], 0.0);
    }

    #[test]
    fn shear_on_the_section_is_that_of_xz_and_xy() {
        let stress = Vector6::new(9.0, 9.0, 9.0, 9.0, 3.0, -4.0);
        assert_eq!(shear_resultant(&stress), 5.0);
    }
}
