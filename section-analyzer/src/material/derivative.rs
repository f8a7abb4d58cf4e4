//! Derivatives of laws with respect to their constants and to the angles of a ply.
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `S`, `C` | compliance and stiffness in material axes, order 11 22 33 23 13 12 | 1/Pa, Pa | 6x6 |
//! | `D` | law in section axes, order yz yy zz xx xy xz | Pa | 6x6 |
//! | `w` | axis about which an increasing angle rotates the material | - | 3 |
//! | `G` | rate of the six stresses under rotation about w | - | 6x6 |
//!
//! ```text
//! dC = -C dS C                                       engineering constants   (S-118)
//! G s = [w x] s + s [w x]'      dD = G D + D G'      angles                  (S-119)
//! ```
//!
//! An increasing fiber angle rotates the material about the normal of the ply, an
//! increasing plane angle about the axis of the beam.

use super::elastic::{ElasticLaw, EngineeringConstants, Material};
use super::orientation::{SECTION_ORDER, material_axes};
use nalgebra::{Matrix3, Matrix6, Vector3};
use shared_geom::rotation::skew;

/// A constant of a material, with its name in the section file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Constant {
    /// Young's modulus of an isotropic material.
    Young,
    /// Poisson's ratio of an isotropic material.
    Poisson,
    /// A constant of an orthotropic material, by its name: one of
    /// [`Constant::ORTHOTROPIC`].
    Engineering(&'static str),
    /// The entries (i, j) and (j, i) of a full matrix, counted from zero.
    Stiffness(usize, usize),
    /// Density.
    Density,
}

impl Constant {
    /// Names of the constants of an orthotropic material.
    pub const ORTHOTROPIC: [&'static str; 9] = [
        "e1", "e2", "e3", "g12", "g13", "g23", "nu12", "nu13", "nu23",
    ];

    /// The name in the section file; entries of a full matrix with row and column from
    /// one.
    pub fn name(self) -> String {
        match self {
            Self::Young => "young".to_owned(),
            Self::Poisson => "poisson".to_owned(),
            Self::Engineering(name) => name.to_owned(),
            Self::Stiffness(i, j) => format!("stiffness[{},{}]", i + 1, j + 1),
            Self::Density => "density".to_owned(),
        }
    }

    /// Its unit in SI.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Poisson => "-",
            Self::Engineering(name) if name.starts_with("nu") => "-",
            Self::Density => "kg/m^3",
            _ => "Pa",
        }
    }
}

impl Material {
    /// Its constants, in the order of the section file, density last.
    pub fn constants(&self) -> Vec<Constant> {
        let mut constants = match &self.law {
            ElasticLaw::Isotropic { .. } => vec![Constant::Young, Constant::Poisson],
            ElasticLaw::Orthotropic(_) => Constant::ORTHOTROPIC.map(Constant::Engineering).to_vec(),
            ElasticLaw::Full(_) => (0..6)
                .flat_map(|i| (i..6).map(move |j| Constant::Stiffness(i, j)))
                .collect(),
            ElasticLaw::Absent => Vec::new(),
        };
        constants.push(Constant::Density);
        constants
    }

    /// The value of a constant in SI; `None` if the material does not have it.
    pub fn value(&self, constant: Constant) -> Option<f64> {
        match (constant, &self.law) {
            (Constant::Density, _) => Some(self.density),
            (Constant::Young, ElasticLaw::Isotropic { young, .. }) => Some(*young),
            (Constant::Poisson, ElasticLaw::Isotropic { poisson, .. }) => Some(*poisson),
            (Constant::Engineering(name), ElasticLaw::Orthotropic(k)) => engineering(k, name),
            (Constant::Stiffness(i, j), ElasticLaw::Full(c)) => c.get((i, j)).copied(),
            _ => None,
        }
    }
}

impl ElasticLaw {
    /// Derivative of the stiffness in material axes, order 11 22 33 23 13 12, with
    /// respect to `constant` in SI; zero for a constant that the law does not have,
    /// including density.
    pub fn derivative(&self, constant: Constant) -> Matrix6<f64> {
        let from_compliance = |rate: &Matrix6<f64>| {
            let c = self.stiffness();
            -(c * rate * c)
        };
        match (constant, self) {
            (Constant::Young, Self::Isotropic { young, .. }) => self.stiffness() / *young,
            (Constant::Poisson, Self::Isotropic { young, .. }) => {
                from_compliance(&isotropic_compliance_rate(*young))
            }
            (Constant::Engineering(name), Self::Orthotropic(k)) => {
                from_compliance(&compliance_rate(k, name))
            }
            (Constant::Stiffness(i, j), Self::Full(_)) if i < 6 && j < 6 => symmetric(i, j, 1.0),
            _ => Matrix6::zeros(),
        }
    }
}

fn engineering(k: &EngineeringConstants, name: &str) -> Option<f64> {
    let values = [
        k.e1, k.e2, k.e3, k.g12, k.g13, k.g23, k.nu12, k.nu13, k.nu23,
    ];
    let at = Constant::ORTHOTROPIC
        .iter()
        .position(|known| *known == name)?;
    Some(values[at])
}

/// The matrix with `value` at (i, j) and (j, i), else zero.
fn symmetric(i: usize, j: usize, value: f64) -> Matrix6<f64> {
    let mut matrix = Matrix6::zeros();
    matrix[(i, j)] = value;
    matrix[(j, i)] = value;
    matrix
}

/// dS/dnu: `S_ij = -nu/E` off the diagonal of the normal part, `2 (1 + nu)/E` on the
/// shears.
fn isotropic_compliance_rate(young: f64) -> Matrix6<f64> {
    let normal = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| symmetric(i, j, -1.0 / young));
    let shear = [3, 4, 5].map(|i| symmetric(i, i, 2.0 / young));
    normal.iter().chain(&shear).sum()
}

/// dS of the compliance (S-7) with respect to the engineering constant `name`.
fn compliance_rate(k: &EngineeringConstants, name: &str) -> Matrix6<f64> {
    // 1/e and nu/e, by e
    let inverse = |e: f64| -1.0 / (e * e);
    let ratio = |nu: f64, e: f64| nu / (e * e);
    match name {
        "e1" => {
            symmetric(0, 0, inverse(k.e1))
                + symmetric(0, 1, ratio(k.nu12, k.e1))
                + symmetric(0, 2, ratio(k.nu13, k.e1))
        }
        "e2" => symmetric(1, 1, inverse(k.e2)) + symmetric(1, 2, ratio(k.nu23, k.e2)),
        "e3" => symmetric(2, 2, inverse(k.e3)),
        "g23" => symmetric(3, 3, inverse(k.g23)),
        "g13" => symmetric(4, 4, inverse(k.g13)),
        "g12" => symmetric(5, 5, inverse(k.g12)),
        "nu12" => symmetric(0, 1, -1.0 / k.e1),
        "nu13" => symmetric(0, 2, -1.0 / k.e1),
        "nu23" => symmetric(1, 2, -1.0 / k.e2),
        _ => Matrix6::zeros(),
    }
}

/// Derivative of the law `d` in section axes, order yz yy zz xx xy xz, with respect to
/// the fiber angle \[Pa/rad\]; angles in radians.
pub fn fiber_angle_rate(d: &Matrix6<f64>, fiber_angle: f64, plane_angle: f64) -> Matrix6<f64> {
    let axes = material_axes(fiber_angle, plane_angle);
    turning_rate(d, &axes.column(2).into_owned())
}

/// Derivative of the law `d` in section axes, order yz yy zz xx xy xz, with respect to
/// the plane angle \[Pa/rad\].
pub fn plane_angle_rate(d: &Matrix6<f64>) -> Matrix6<f64> {
    turning_rate(d, &Vector3::x())
}

/// Derivative of a law with respect to a rotation of the material about `axis` \[per rad\] (S-119).
fn turning_rate(d: &Matrix6<f64>, axis: &Vector3<f64>) -> Matrix6<f64> {
    let turn = skew(axis);
    let mut rate = Matrix6::zeros();
    for (column, &(i, j)) in SECTION_ORDER.iter().enumerate() {
        let mut stress: Matrix3<f64> = Matrix3::zeros();
        stress[(i, j)] = 1.0;
        stress[(j, i)] = 1.0;
        let turned = turn * stress + stress * turn.transpose();
        for (row, &(k, l)) in SECTION_ORDER.iter().enumerate() {
            rate[(row, column)] = turned[(k, l)];
        }
    }
    let half = rate * d;
    half + half.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::section_stiffness;
    use crate::section::samples::CARBON;
    use approx::assert_relative_eq;

    /// Central differences with a step of 1e-5 of the value: their error is 1e-10, and
    /// round-off 1e-11.
    fn checked(law: ElasticLaw) {
        let material = Material {
            name: "m".into(),
            law,
            density: 1.0,
            expansion: None,
            electric: None,
        };
        for constant in material.constants() {
            let value = material.value(constant).expect("its own constant");
            let step = 1e-5 * value.abs().max(1e-3);
            let at = |value: f64| changed(&material.law, constant, value).stiffness();
            let difference = (at(value + step) - at(value - step)) / (2.0 * step);
            let exact = material.law.derivative(constant);
            let scale = material.law.stiffness().amax() / value.abs();
            assert!(
                (exact - difference).amax() < 1e-8 * scale,
                "{constant:?}: {exact} {difference}"
            );
            if constant != Constant::Density {
                assert!(exact.amax() > 0.0, "{constant:?}");
            }
        }
    }

    fn changed(law: &ElasticLaw, constant: Constant, value: f64) -> ElasticLaw {
        let mut law = law.clone();
        match (&mut law, constant) {
            (ElasticLaw::Isotropic { young, .. }, Constant::Young) => *young = value,
            (ElasticLaw::Isotropic { poisson, .. }, Constant::Poisson) => *poisson = value,
            (ElasticLaw::Orthotropic(k), Constant::Engineering(name)) => {
                let positions = [
                    &mut k.e1,
                    &mut k.e2,
                    &mut k.e3,
                    &mut k.g12,
                    &mut k.g13,
                    &mut k.g23,
                    &mut k.nu12,
                    &mut k.nu13,
                    &mut k.nu23,
                ];
                for (position, known) in positions.into_iter().zip(Constant::ORTHOTROPIC) {
                    if known == name {
                        *position = value;
                    }
                }
            }
            (ElasticLaw::Full(c), Constant::Stiffness(i, j)) => {
                c[(i, j)] = value;
                c[(j, i)] = value;
            }
            _ => {}
        }
        law
    }

    #[test]
    fn constants_of_each_law() {
        checked(ElasticLaw::Isotropic {
            young: 70e9,
            poisson: 0.3,
        });
        checked(ElasticLaw::Orthotropic(CARBON));
        let full = ElasticLaw::Orthotropic(CARBON).stiffness();
        let full = Matrix6::from_fn(|i, j| full[(i, j)] + 1e8 * (1 + i + j) as f64);
        checked(ElasticLaw::Full(full));
    }

    /// Central differences of the rotated tensor with a step of 1e-4 rad: their error is
    /// 16/6 1e-8 times the fourth harmonic.
    #[test]
    fn angles() {
        let c = ElasticLaw::Orthotropic(CARBON).stiffness();
        let (fiber, plane) = (0.4, -1.1);
        let d = section_stiffness(&c, fiber, plane);
        let h = 1e-4;
        let at = |fiber: f64, plane: f64| section_stiffness(&c, fiber, plane);
        let by_fiber = (at(fiber + h, plane) - at(fiber - h, plane)) / (2.0 * h);
        let by_plane = (at(fiber, plane + h) - at(fiber, plane - h)) / (2.0 * h);
        let tolerance = 1e-7 * c.amax();
        assert_relative_eq!(
            fiber_angle_rate(&d, fiber, plane),
            by_fiber,
            epsilon = tolerance
        );
        assert_relative_eq!(plane_angle_rate(&d), by_plane, epsilon = tolerance);
    }

    #[test]
    fn constants_that_a_material_does_not_have() {
        let law = ElasticLaw::Orthotropic(CARBON);
        assert_eq!(law.derivative(Constant::Young), Matrix6::zeros());
        assert_eq!(
            law.derivative(Constant::Engineering("e4")),
            Matrix6::zeros()
        );
        let material = Material {
            name: "m".into(),
            law,
            density: 2.0,
            expansion: None,
            electric: None,
        };
        assert_eq!(material.value(Constant::Poisson), None);
        assert_eq!(material.value(Constant::Density), Some(2.0));
        assert_eq!(Constant::Stiffness(0, 5).name(), "stiffness[1,6]");
    }
}
