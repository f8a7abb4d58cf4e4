//! Centers from stiffness and mass.
//!
//! ```text
//! tension center: [z; -y] = -inv(Cs[56,56]) Cs[56,1]                      (S-26)
//! shear center:   y = -Cs[4,3] / Cs[4,4] ,  z = Cs[4,2] / Cs[4,4]         (S-27)
//! mass center:    y = M[3,4] / m ,          z = -M[2,4] / m               (S-30)
//! ```

use nalgebra::{Matrix6, Vector2};

use super::Centers;

impl Centers {
    /// The centers of a section, relative to the reference point of its matrices; `None`
    /// if a center does not exist: a singular stiffness, no mass.
    pub fn of(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> Option<Self> {
        let compliance = stiffness.try_inverse()?;
        let bending = compliance.fixed_view::<2, 2>(4, 4).into_owned();
        let by_force = compliance.fixed_view::<2, 1>(4, 0).into_owned();
        let tension = -(bending.try_inverse()? * by_force);
        let twist = compliance[(3, 3)];
        let centers = Self {
            tension: Vector2::new(-tension.y, tension.x),
            shear: Vector2::new(-compliance[(3, 2)], compliance[(3, 1)]) / twist,
            mass: Vector2::new(mass[(2, 3)], -mass[(1, 3)]) / mass[(0, 0)],
        };
        let all = [centers.tension, centers.shear, centers.mass];
        let finite = all.iter().flatten().all(|value| value.is_finite());
        finite.then_some(centers)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::Engineering;

    // Stiffness and mass assembled about known centers yield these centers; entries up to
    // 1e6 and back through an inverse: some 1e-10 of a meter.
    #[test]
    fn centers_that_were_put_in_come_back() {
        let known = Centers {
            tension: Vector2::new(0.03, -0.01),
            shear: Vector2::new(-0.05, 0.02),
            mass: Vector2::new(0.07, 0.04),
        };
        let engineering = Engineering {
            stiffness: [1e6, 2e5, 1e5, 3e2, 5e2, 7e3],
            mass: [2.0, 0.01, 0.2],
            centers: known,
            stiffness_angle: 0.3,
            inertia_angle: 0.2,
        };
        let found = Centers::of(&engineering.stiffness_matrix(), &engineering.mass_matrix());
        let found = found.unwrap();
        assert!((found.tension - known.tension).norm() < 1e-10);
        assert!((found.shear - known.shear).norm() < 1e-10);
        assert!((found.mass - known.mass).norm() < 1e-10);
        assert_eq!(Centers::of(&Matrix6::zeros(), &Matrix6::zeros()), None);
    }
}
