//! A spring at a state: its strain, force and moment, and their variations.

use nalgebra::{Matrix3, Matrix6x3, Vector3, Vector6};
use shared_geom::rotation::{skew, vector};

use crate::model::NodeMotion;

/// Derivatives of strains, or of their rates, by position and rotation of a and of b.
pub(in crate::elements::springs) type ByEnds = [[Matrix6x3<f64>; 2]; 2];

/// The spring at a state.
pub(in crate::elements::springs) struct State {
    /// Motion of the first end, at rest for the frame, and of the second.
    pub a: NodeMotion,
    pub b: NodeMotion,
    /// `E_a`.
    pub g: Matrix3<f64>,
    pub r: Vector3<f64>,
    pub f: Vector3<f64>,
    pub w: Vector3<f64>,
    pub omega: Vector3<f64>,
    pub inverse: Matrix3<f64>,
    pub strain: Vector6<f64>,
    pub rate: Vector6<f64>,
}

/// Force and moment, in model axes and in the axes of the first end.
pub(in crate::elements::springs) struct Wrench {
    pub force: Vector3<f64>,
    pub moment: Vector3<f64>,
    /// `m~` of the equations.
    pub inner: Vector3<f64>,
}

pub(in crate::elements::springs) fn six(first: &Vector3<f64>, last: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(first.x, first.y, first.z, last.x, last.y, last.z)
}

fn stacked(first: &Matrix3<f64>, last: &Matrix3<f64>) -> Matrix6x3<f64> {
    let mut both = Matrix6x3::zeros();
    both.fixed_view_mut::<3, 3>(0, 0).copy_from(first);
    both.fixed_view_mut::<3, 3>(3, 0).copy_from(last);
    both
}

impl State {
    pub fn psi(&self) -> Vector3<f64> {
        self.strain.fixed_rows::<3>(3).into_owned()
    }

    pub fn wrench(&self, section: &Vector6<f64>) -> Wrench {
        let inner = section.fixed_rows::<3>(3).into_owned();
        Wrench {
            force: self.g * section.fixed_rows::<3>(0),
            moment: self.g * (self.inverse.transpose() * inner),
            inner,
        }
    }

    /// Variation of the strains; also of their rates by the velocities.
    pub fn variation(&self) -> ByEnds {
        let gt = self.g.transpose();
        let turned = self.inverse * gt;
        let zero = Matrix3::zeros();
        [
            [
                stacked(&-gt, &zero),
                stacked(&(gt * skew(&self.r)), &-turned),
            ],
            [
                stacked(&gt, &zero),
                stacked(&(-gt * skew(&self.f)), &turned),
            ],
        ]
    }

    /// Variation of the rates of strain at fixed velocities.
    pub fn rate_variation(&self) -> ByEnds {
        let gt = self.g.transpose();
        let [omega_a, omega_b] = [&self.a, &self.b].map(|end| skew(&end.angular_velocity));
        let f = skew(&self.f);
        let turned = self.inverse * gt;
        let bent = vector::tangent_inverse_derivative(&self.psi(), &self.omega) * turned;
        let relative = turned * (omega_b - omega_a);
        let zero = Matrix3::zeros();
        [
            [
                stacked(&(gt * omega_a), &zero),
                stacked(&(gt * skew(&self.w)), &(relative - bent)),
            ],
            [
                stacked(&(-gt * omega_a), &zero),
                stacked(&(gt * (omega_a - omega_b) * f), &bent),
            ],
        ]
    }

    /// Variations of force and moment on a and on b, when the law's forces vary by `section` and,
    /// if a motion is given, end `j` is moved (`k` = 0) or turned (1), which varies the strains by
    /// `by`.
    pub fn varied(
        &self,
        wrench: &Wrench,
        section: &Matrix6x3<f64>,
        moved: Option<(usize, usize, &Matrix6x3<f64>)>,
    ) -> [[Matrix3<f64>; 2]; 2] {
        let f = skew(&self.f);
        let mut force = self.g * section.fixed_rows::<3>(0);
        let mut inner = self.inverse.transpose() * section.fixed_rows::<3>(3);
        let (mut arm_a, mut arm_b) = (Matrix3::zeros(), Matrix3::zeros());
        let mut turned = Matrix3::zeros();
        if let Some((j, k, by)) = moved {
            let bent = -vector::tangent_inverse_derivative(&-self.psi(), &wrench.inner);
            inner += bent * by.fixed_rows::<3>(3);
            arm_a = match (j, k) {
                (0, 0) => -Matrix3::identity(),
                (1, 0) => Matrix3::identity(),
                (1, _) => -f,
                _ => Matrix3::zeros(),
            };
            if (j, k) == (1, 1) {
                arm_b = -f;
            }
            if (j, k) == (0, 1) {
                force -= skew(&wrench.force);
                turned = skew(&wrench.moment);
            }
        }
        let moment = self.g * inner - turned;
        let lever = skew(&wrench.force);
        [
            [force, skew(&self.r) * force - lever * arm_a + moment],
            [-force, -(f * force - lever * arm_b) - moment],
        ]
    }
}
