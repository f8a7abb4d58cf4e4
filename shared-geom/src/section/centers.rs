//! Centers and principal axes from stiffness and mass.
//!
//! ```text
//! tension center: [z; -y] = -inv(Cs[56,56]) Cs[56,1]                      (S-26)
//! shear center:   y = -Cs[4,3] / Cs[4,4] ,  z = Cs[4,2] / Cs[4,4]         (S-27)
//! mass center:    y = M[3,4] / m ,          z = -M[2,4] / m               (S-30)
//! ```

use nalgebra::{Matrix2, Matrix6, Vector2, Vector3};

use super::{Centers, PrincipalAxes, SectionProperties};
use crate::wrench;

/// Relative difference of two principal values below which all directions are principal.
const EQUAL: f64 = 1e-9;

/// Distance of given centers from the ones of the matrices, relative to the radius of gyration,
/// and difference of principal values, relative to the larger, above which they differ: numbers
/// written with three digits do not.
const ROUNDED: f64 = 5e-3;

impl SectionProperties {
    /// The given centers and principal axes that do not follow from stiffness and mass, one
    /// sentence each: the matrices are used by beams, the others by a change of point or axes.
    pub fn disagreements(&self) -> Vec<String> {
        let (stiffness, mass) = (&self.stiffness, &self.mass);
        let Some(axes) = PrincipalAxes::of(stiffness, mass) else {
            return Vec::new();
        };
        let own = Centers::or_origin(stiffness, mass);
        let about = wrench::shift(stiffness, &Vector3::new(0.0, own.tension.x, own.tension.y));
        let radius = (axes.bending_stiffness.iter().sum::<f64>() / about[(0, 0)]).sqrt();
        let given = &self.centers;
        let is_massive = mass[(0, 0)] > 0.0;
        let centers = [
            ("tension center", given.tension, own.tension, true),
            ("shear center", given.shear, own.shear, true),
            ("center of mass", given.mass, own.mass, is_massive),
        ];
        let moved = centers.into_iter().filter(|(_, given, own, exists)| {
            let distance = (given - own).norm();
            *exists && distance > ROUNDED * radius
        });
        let moved = moved.map(|(name, given, own, _)| {
            let [y, z] = [own.x, own.y];
            let from = if name == "center of mass" { "mass" } else { "stiffness" };
            format!(
                "the {name} is given at ({:.4e}, {:.4e}) m, and follows from the {from} at ({y:.4e}, {z:.4e}) m",
                given.x, given.y
            )
        });
        let given = &self.principal_axes;
        let of_axes = [
            ("bending", given.bending(), axes.bending(), true),
            (
                "inertia",
                given.rotary_inertia(),
                axes.rotary_inertia(),
                is_massive,
            ),
        ];
        let turned = of_axes.into_iter().filter(|(_, given, own, exists)| {
            *exists && (given - own).amax() > ROUNDED * own.amax()
        });
        let turned = turned.map(|(name, ..)| {
            let from = if name == "inertia" {
                "mass"
            } else {
                "stiffness"
            };
            format!("the given principal axes of {name} do not follow from the {from}")
        });
        moved.chain(turned).collect()
    }
}

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

    /// As [`Centers::of`], with the reference point in place of a center that does not
    /// exist.
    pub(super) fn or_origin(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> Self {
        let origin = Vector2::zeros();
        let massless = || {
            let centers = Self::of(stiffness, &Matrix6::identity())?;
            Some(Self {
                mass: origin,
                ..centers
            })
        };
        Self::of(stiffness, mass).or_else(massless).unwrap_or(Self {
            tension: origin,
            shear: origin,
            mass: origin,
        })
    }
}

impl PrincipalAxes {
    /// The tensor of bending stiffness over (y, z) at the tension center [N m^2].
    fn bending(&self) -> Matrix2<f64> {
        tensor(self.bending_angle, self.bending_stiffness)
    }

    /// The tensor of inertia over (y, z) at the mass center [kg m].
    fn rotary_inertia(&self) -> Matrix2<f64> {
        tensor(self.inertia_angle, self.inertia)
    }

    /// The principal axes of bending, free of other internal forces, and of rotary inertia
    /// about the mass center, which is zero without mass; `None` for a singular stiffness.
    pub(super) fn of(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> Option<Self> {
        let compliance = stiffness.try_inverse()?;
        let bending = compliance.fixed_view::<2, 2>(4, 4).try_inverse()?;
        let (bending_angle, bending_stiffness) = principal(&bending);
        let center = Centers::or_origin(stiffness, mass).mass;
        let about = wrench::shift(mass, &Vector3::new(0.0, center.x, center.y));
        let about = about.fixed_view::<2, 2>(4, 4).into_owned();
        let (inertia_angle, inertia) = principal(&about);
        Some(Self {
            bending_angle,
            bending_stiffness,
            inertia_angle,
            inertia,
        })
    }
}

/// The symmetric tensor with these principal values, the first about the axis at `angle`
/// from +y [rad].
fn tensor(angle: f64, [first, second]: [f64; 2]) -> Matrix2<f64> {
    let (s, c) = angle.sin_cos();
    let turn = Matrix2::new(c, -s, s, c);
    turn * Matrix2::new(first, 0.0, 0.0, second) * turn.transpose()
}

/// The angle from +y to the nearest principal axis of a symmetric tensor over (y, z) [rad],
/// and the values about it and about the other axis.
///
/// ```text
/// angle = 1/2 atan(2 t_yz / (t_yy - t_zz))
/// first, second = (t_yy + t_zz)/2 +- sign(t_yy - t_zz) sqrt(((t_yy - t_zz)/2)^2 + t_yz^2)
/// ```
fn principal(tensor: &Matrix2<f64>) -> (f64, [f64; 2]) {
    let mean = 0.5 * (tensor[(0, 0)] + tensor[(1, 1)]);
    let half = 0.5 * (tensor[(0, 0)] - tensor[(1, 1)]);
    let mixed = 0.5 * (tensor[(0, 1)] + tensor[(1, 0)]);
    let radius = half.hypot(mixed);
    if radius <= EQUAL * mean.abs() {
        return (0.0, [tensor[(0, 0)], tensor[(1, 1)]]);
    }
    let sign = if half < 0.0 { -1.0 } else { 1.0 };
    let angle = 0.5 * (sign * mixed).atan2(sign * half);
    (angle, [mean + sign * radius, mean - sign * radius])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::{Engineering, Provenance, parse, write};

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

    /// A section whose centers and axes are all different.
    fn turned() -> Engineering {
        Engineering {
            stiffness: [1e6, 2e5, 1e5, 3e2, 5e2, 7e3],
            mass: [2.0, 0.01, 0.2],
            centers: Centers {
                tension: Vector2::new(0.03, -0.01),
                shear: Vector2::new(-0.05, 0.02),
                mass: Vector2::new(0.07, 0.04),
            },
            stiffness_angle: 0.3,
            inertia_angle: -0.2,
        }
    }

    // Centers and axes of the matrices agree, however the axes are named; others are reported
    // one by one, and centers of mass only with mass.
    #[test]
    fn numbers_that_do_not_follow_from_the_matrices_are_found() {
        let right = turned().section("a", Provenance::default());
        assert_eq!(right.disagreements(), [""; 0]);
        let mut named = right.clone();
        let axes = &mut named.principal_axes;
        axes.bending_angle += std::f64::consts::FRAC_PI_2;
        axes.bending_stiffness.reverse();
        named.centers.tension.x += 1e-5;
        assert_eq!(named.disagreements(), [""; 0]);

        let mut wrong = right;
        wrong.centers.shear.x = 0.05;
        wrong.centers.mass.y = 0.0;
        wrong.principal_axes.bending_angle = -0.3;
        let found = wrong.disagreements();
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(found[0].starts_with("the shear center is given at (5.0000e-2, 2.0000e-2) m, and"));
        assert!(found[1].starts_with("the center of mass is given at (7.0000e-2, 0.0000e0) m"));
        assert!(found[2].contains("principal axes of bending"));
        wrong.mass.fill(0.0);
        assert_eq!(wrong.disagreements().len(), 2);
    }

    // A file of another program without the numbers that follow from the matrices has the
    // same content as one with them; entries up to 1e6 and back through an inverse.
    #[test]
    fn a_file_needs_no_numbers_that_follow_from_the_matrices() {
        let whole = turned().section("a", Provenance::default());
        let mut file: serde_json::Value = serde_json::from_str(&write(&whole)).unwrap();
        let fields = file.as_object_mut().unwrap();
        for field in ["centers", "principal_axes", "provenance"] {
            assert!(fields.remove(field).is_some(), "{field}");
        }
        let found = parse(&file.to_string(), "a.json").unwrap();
        let (of, to) = (&found.centers, &whole.centers);
        assert!((of.tension - to.tension).norm() < 1e-10);
        assert!((of.shear - to.shear).norm() < 1e-10);
        assert!((of.mass - to.mass).norm() < 1e-10);
        let (of, to) = (&found.principal_axes, &whole.principal_axes);
        assert!((of.bending_angle - to.bending_angle).abs() < 1e-10);
        assert!((of.inertia_angle - to.inertia_angle).abs() < 1e-10);
        for i in 0..2 {
            assert!((of.bending_stiffness[i] / to.bending_stiffness[i] - 1.0).abs() < 1e-10);
            assert!((of.inertia[i] / to.inertia[i] - 1.0).abs() < 1e-10);
        }
        assert_eq!(found.provenance, Provenance::default());
    }
}
