use super::*;
use crate::material::ElasticLaw;
use crate::section::samples::{CARBON, Random};
use approx::assert_relative_eq;
use nalgebra::{Vector3, Vector6};
use std::f64::consts::FRAC_PI_2;

/// A symmetric stiffness without any material symmetry.
fn anisotropic(random: &mut Random) -> Matrix6<f64> {
    let g = Matrix6::from_fn(|_, _| random.next());
    g * g.transpose() + Matrix6::identity()
}

/// The strain tensor of six components with engineering shears.
fn strain_tensor(order: &[(usize, usize); 6], strain: &Vector6<f64>) -> Matrix3<f64> {
    let mut tensor = Matrix3::zeros();
    for (value, &(i, j)) in strain.iter().zip(order) {
        let value = if i == j { *value } else { 0.5 * value };
        tensor[(i, j)] = value;
        tensor[(j, i)] = value;
    }
    tensor
}

/// Independent way: rotate the strain tensor to material axes, apply the law there,
/// rotate the stress tensor back. Round-off of a few products: 1e-13.
#[test]
fn stress_agrees_with_rotated_tensors_for_a_law_without_symmetry() {
    let mut random = Random(7);
    for _ in 0..20 {
        let c = anisotropic(&mut random);
        let (theta, alpha) = (4.0 * random.next(), 4.0 * random.next());
        let strain = Vector6::from_fn(|_, _| random.next());

        let q = material_axes(theta, alpha);
        let local = q.transpose() * strain_tensor(&SECTION_ORDER, &strain) * q;
        let local = Vector6::from_fn(|k, _| {
            let (i, j) = MATERIAL_ORDER[k];
            if i == j {
                local[(i, j)]
            } else {
                2.0 * local[(i, j)]
            }
        });
        let stress = c * local;
        let mut tensor = Matrix3::zeros();
        for (value, &(i, j)) in stress.iter().zip(&MATERIAL_ORDER) {
            tensor[(i, j)] = *value;
            tensor[(j, i)] = *value;
        }
        let tensor = q * tensor * q.transpose();
        let expected = Vector6::from_fn(|k, _| {
            let (i, j) = SECTION_ORDER[k];
            tensor[(i, j)]
        });

        let found = section_stiffness(&c, theta, alpha) * strain;
        assert_relative_eq!(found, expected, epsilon = 1e-13, max_relative = 1e-13);
    }
}

/// The axes by the conventions: s, n, f, g from their definitions.
#[test]
fn axes_are_fiber_transverse_normal() {
    let (theta, alpha) = (0.4_f64, 2.1_f64);
    let x = Vector3::x();
    let s = Vector3::new(0.0, alpha.cos(), alpha.sin());
    let q = material_axes(theta, alpha);
    assert_relative_eq!(
        q.column(0).into_owned(),
        theta.cos() * x + theta.sin() * s,
        epsilon = 1e-15
    );
    assert_relative_eq!(
        q.column(1).into_owned(),
        -theta.sin() * x + theta.cos() * s,
        epsilon = 1e-15
    );
    assert_relative_eq!(q.column(2).into_owned(), x.cross(&s), epsilon = 1e-15);
    assert_relative_eq!(q.determinant(), 1.0, epsilon = 1e-15);
}

/// Off-axis ply, closed forms of Lekhnitskii (1963) and Jones (1999, chapter 2):
/// S_xx = c^4/E1 + (1/G12 - 2 nu12/E1) s^2 c^2 + s^4/E2 and the extension-shear
/// term S_x,xy = (2/E1 + 2 nu12/E1 - 1/G12) s c^3 - (2/E2 + 2 nu12/E1 - 1/G12) s^3 c.
#[test]
fn off_axis_compliance_has_its_closed_form() {
    let k = CARBON;
    let c = ElasticLaw::Orthotropic(k).stiffness();
    for degrees in [0.0_f64, 15.0, 30.0, 45.0, 77.0, 90.0] {
        let theta = degrees.to_radians();
        let (sin, cos) = theta.sin_cos();
        let compliance = section_stiffness(&c, theta, 0.0)
            .try_inverse()
            .expect("positive definite");

        let coupling = 2.0 * k.nu12 / k.e1 - 1.0 / k.g12;
        let s11 = cos.powi(4) / k.e1 - coupling * (sin * cos).powi(2) + sin.powi(4) / k.e2;
        let s16 = (2.0 / k.e1 + coupling) * sin * cos.powi(3)
            - (2.0 / k.e2 + coupling) * sin.powi(3) * cos;

        // section order: 3 is xx, 4 is xy
        assert_relative_eq!(compliance[(3, 3)], s11, max_relative = 1e-12);
        assert_relative_eq!(compliance[(3, 4)], s16, epsilon = 1e-12 * s11);
    }
}

/// A wall at a right angle to y puts "transverse" along z and "normal" along -y.
#[test]
fn plane_angle_of_a_right_angle_swaps_the_section_axes() {
    let c = ElasticLaw::Orthotropic(CARBON).stiffness();
    let flat = section_stiffness(&c, 0.3, 0.0);
    let upright = section_stiffness(&c, 0.3, FRAC_PI_2);
    // order yz yy zz xx xy xz: y -> z, z -> -y
    let image = [0, 2, 1, 3, 5, 4];
    let sign = [-1.0, 1.0, 1.0, 1.0, 1.0, -1.0];
    for i in 0..6 {
        for j in 0..6 {
            assert_relative_eq!(
                upright[(image[i], image[j])],
                sign[i] * sign[j] * flat[(i, j)],
                epsilon = 1e-13 * CARBON.e1
            );
        }
    }
}

/// Expansion a1, a2, a3 of a ply at theta in a wall along y: along x and y
/// a1 cos^2 + a2 sin^2 and a1 sin^2 + a2 cos^2, an engineering shear of
/// 2 (a1 - a2) sin cos, and a3 through the thickness (Jones 1999, chapter 4).
#[test]
fn expansion_of_a_turned_ply_has_its_closed_form() {
    let (a1, a2, a3) = (-0.5e-6, 28e-6, 31e-6);
    let (sin, cos) = 0.6_f64.sin_cos();
    let found = section_strain(&Vector6::new(a1, a2, a3, 0.0, 0.0, 0.0), 0.6, 0.0);
    let expected = Vector6::new(
        0.0,
        a1 * sin * sin + a2 * cos * cos,
        a3,
        a1 * cos * cos + a2 * sin * sin,
        2.0 * (a1 - a2) * sin * cos,
        0.0,
    );
    assert_relative_eq!(found, expected, epsilon = 1e-20);
}

/// The work of a stress on a strain is the same in both axes, for all six components.
#[test]
fn strain_turns_with_the_law() {
    let mut random = Random(11);
    let c = anisotropic(&mut random);
    let strain = Vector6::from_fn(|_, _| random.next());
    let turned = section_strain(&strain, 0.7, -1.3);
    let work = turned.dot(&(section_stiffness(&c, 0.7, -1.3) * turned));
    assert_relative_eq!(work, strain.dot(&(c * strain)), max_relative = 1e-13);
}

/// An isotropic law does not depend on the angles.
#[test]
fn isotropic_law_is_the_same_in_all_axes() {
    let c = ElasticLaw::Isotropic {
        young: 70e9,
        poisson: 0.33,
    }
    .stiffness();
    let flat = section_stiffness(&c, 0.0, 0.0);
    let turned = section_stiffness(&c, 1.1, -0.6);
    assert_relative_eq!(turned, flat, epsilon = 1e-14 * 70e9 * 3.0);
}
