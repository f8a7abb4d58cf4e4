//! Hand calculations for each criterion and mode, with round strengths; comparisons are to
//! a few roundings, 1e-14.

use super::*;
use crate::material::{DEFAULT_INTERACTION, DirectionalLimits, Fatigue, UniformLimits};
use approx::assert_relative_eq;
use nalgebra::Vector6;

/// Xt = 1500, Yt = 50, Zt = 40, Xc = 1200, Yc = 200, Zc = 160, S23 = 80, S13 = 60,
/// S12 = 70.
const LIMITS: DirectionalLimits = DirectionalLimits {
    tension: [1500.0, 50.0, 40.0],
    compression: [1200.0, 200.0, 160.0],
    shear: [80.0, 60.0, 70.0],
};

const PLY: MaterialLimits = MaterialLimits {
    strength: Some(Strength::Ply {
        limits: LIMITS,
        interaction: [DEFAULT_INTERACTION; 3],
    }),
    strain: Some(StrainLimit::Ply(LIMITS)),
    fatigue: Fatigue {
        stress: None,
        strain: None,
    },
};

fn of(limits: &MaterialLimits, criterion: Criterion, stress: [f64; 6]) -> FailureIndex {
    let stress = Vector6::from(stress);
    let tensors = Tensors {
        stress,
        strain: stress,
        material_strain: stress,
        material_stress: stress,
    };
    let found = failure_indices(limits, &tensors);
    *found.iter().find(|i| i.criterion == criterion).unwrap()
}

fn check(criterion: Criterion, stress: [f64; 6], index: f64, mode: Mode) {
    let found = of(&PLY, criterion, stress);
    assert_relative_eq!(found.index, index, max_relative = 1e-14);
    assert_eq!(found.mode, mode, "{stress:?}");
}

#[test]
fn maximum_stress_and_strain() {
    for criterion in [Criterion::MaxStress, Criterion::MaxStrain] {
        let stress = [750.0, 10.0, -16.0, 8.0, 0.0, -7.0];
        check(criterion, stress, 0.5, Mode::Tension(0));
        let stress = [-600.0, -120.0, 4.0, 8.0, 30.0, 7.0];
        check(criterion, stress, 0.6, Mode::Compression(1));
        let stress = [1.0, 1.0, 1.0, 8.0, -48.0, 7.0];
        check(criterion, stress, 0.8, Mode::Shear(1));
        assert_relative_eq!(of(&PLY, criterion, stress).reserve_factor, 1.25);
    }
}

/// s1 = 300: F1 s1 = (1/1500 - 1/1200) 300 = -0.05, F11 s1^2 = 300^2/1.8e6 = 0.05:
/// index 0. With s2 = 20: F2 s2 = (1/50 - 1/200) 20 = 0.3, F22 s2^2 = 400/1e4 = 0.04,
/// 2 F12 s1 s2 = -300 20/sqrt(1.8e6 1e4) = -sqrt(0.05 0.04). With s12 = 35: 0.25.
#[test]
fn tsai_wu_polynomial() {
    let coupling = (0.05_f64 * 0.04).sqrt();
    let index = 0.3 + 0.04 - coupling + 0.25;
    let stress = [300.0, 20.0, 0.0, 0.0, 0.0, 35.0];
    check(Criterion::TsaiWu, stress, index, Mode::Tension(1));
    // a = 0.05 + 0.04 + 0.25 - coupling, b = -0.05 + 0.3: a t^2 + b t = 1
    let (a, b) = (0.34 - coupling, 0.25);
    let root = (-b + (b * b + 4.0 * a).sqrt()) / (2.0 * a);
    let found = of(&PLY, Criterion::TsaiWu, stress).reserve_factor;
    assert_relative_eq!(found, root, max_relative = 1e-14);
    // the thickness: F3 s3 = (1/40 - 1/160)(-32) = -0.6, F33 s3^2 = 1024/6400 = 0.16
    check(
        Criterion::TsaiWu,
        [0.0, 0.0, -32.0, 60.0, 0.0, 0.0],
        -0.6 + 0.16 + 0.5625,
        Mode::Shear(0),
    );
}

/// At each strength alone the polynomial is one.
#[test]
fn tsai_wu_is_one_at_each_strength() {
    for axis in 0..3 {
        let mut stress = [0.0; 6];
        stress[axis] = LIMITS.tension[axis];
        check(Criterion::TsaiWu, stress, 1.0, Mode::Tension(axis));
        stress[axis] = -LIMITS.compression[axis];
        check(Criterion::TsaiWu, stress, 1.0, Mode::Compression(axis));
        stress[axis] = 0.0;
        stress[3 + axis] = -LIMITS.shear[axis];
        check(Criterion::TsaiWu, stress, 1.0, Mode::Shear(axis));
    }
}

/// Equal strengths in tension and compression and S = X/sqrt 3, with the default
/// interaction: the index is (von Mises stress / X)^2.
#[test]
fn tsai_wu_contains_von_mises() {
    let limits = MaterialLimits {
        strength: Some(Strength::Ply {
            limits: DirectionalLimits {
                tension: [200.0; 3],
                compression: [200.0; 3],
                shear: [200.0 / 3f64.sqrt(); 3],
            },
            interaction: [DEFAULT_INTERACTION; 3],
        }),
        ..MaterialLimits::default()
    };
    let stress = [120.0, -40.0, 65.0, 20.0, -35.0, 50.0];
    let tensors = Tensors {
        stress: Vector6::from(stress),
        ..Tensors::default()
    };
    let found = of(&limits, Criterion::TsaiWu, stress);
    let expected = tensors.von_mises() / 200.0;
    assert_relative_eq!(found.index, expected * expected, max_relative = 1e-14);
    assert_relative_eq!(found.reserve_factor, 1.0 / expected, max_relative = 1e-14);
}

#[test]
fn hashin_modes() {
    let hashin = |stress, index, mode| check(Criterion::Hashin, stress, index, mode);
    // (750/1500)^2 + (35/70)^2 + (30/60)^2
    let stress = [750.0, 1.0, 0.0, 0.0, 30.0, 35.0];
    // the matrix: (1/50)^2 + 0.5 = 0.5004 is less than 0.75
    hashin(stress, 0.75, Mode::FiberTension);
    // (600/1200)^2, without shear
    let stress = [-600.0, 0.0, 0.0, 0.0, 0.0, 7.0];
    hashin(stress, 0.25, Mode::FiberCompression);
    // (30 + 10)^2/2500 + (40^2 - 300)/6400 + (7/70)^2
    let stress = [0.0, 30.0, 10.0, 40.0, 0.0, 7.0];
    let index = 0.64 + 1300.0 / 6400.0 + 0.01;
    hashin(stress, index, Mode::MatrixTension);
    // [(200/160)^2 - 1](-120)/200 + 120^2/25600 + (24^2 - 2000)/6400 + (14/70)^2
    let stress = [0.0, -100.0, -20.0, 24.0, 0.0, 14.0];
    let index = -0.3375 + 0.5625 - 1424.0 / 6400.0 + 0.04;
    hashin(stress, index, Mode::MatrixCompression);
    // at Yc alone the last mode is one: (1.5625 - 1)(-1) + 200^2/25600 = 1
    let stress = [0.0, -200.0, 0.0, 0.0, 0.0, 0.0];
    hashin(stress, 1.0, Mode::MatrixCompression);
}

/// The matrix in compression above is `a t^2 + b t` with b = -0.3375.
#[test]
fn hashin_reserve_of_matrix_compression() {
    let (a, b): (f64, f64) = (0.5625 - 1424.0 / 6400.0 + 0.04, -0.3375);
    let root = (-b + (b * b + 4.0 * a).sqrt()) / (2.0 * a);
    let found = of(
        &PLY,
        Criterion::Hashin,
        [0.0, -100.0, -20.0, 24.0, 0.0, 14.0],
    );
    assert_relative_eq!(found.reserve_factor, root, max_relative = 1e-14);
}

/// With strengths 200, 400, 90 the principal stresses 100 +- 50 sqrt 2 of (150, 50,
/// s12 = 50) govern in tension, the principal stresses of (60, -60, s12 = 0) in shear, and -300
/// in compression. In strains the shear is twice as large.
#[test]
fn principal_values_of_uniform_materials() {
    let uniform = UniformLimits {
        tension: 200.0,
        compression: 400.0,
        shear: 90.0,
    };
    let limits = MaterialLimits {
        strength: Some(Strength::Uniform(uniform)),
        strain: Some(StrainLimit::Uniform(uniform)),
        ..MaterialLimits::default()
    };
    let check = |criterion, stress, index: f64, mode| {
        let found = of(&limits, criterion, stress);
        // eigenvalues to 1e-15 of the largest
        assert_relative_eq!(found.index, index, max_relative = 1e-13);
        assert_eq!(found.mode, mode);
        assert_relative_eq!(found.reserve_factor, 1.0 / index, max_relative = 1e-13);
    };
    let high = 100.0 + 50.0 * 2f64.sqrt();
    let bar = [150.0, 50.0, 100.0, 0.0, 0.0, 50.0];
    check(
        Criterion::MaxStress,
        bar,
        high / 200.0,
        Mode::PrincipalTension,
    );
    let shear = [60.0, -60.0, 0.0, 0.0, 0.0, 0.0];
    check(Criterion::MaxStress, shear, 60.0 / 90.0, Mode::LargestShear);
    check(
        Criterion::MaxStrain,
        shear,
        120.0 / 90.0,
        Mode::LargestShear,
    );
    let pressed = [-300.0, -280.0, -300.0, 0.0, 0.0, 0.0];
    check(
        Criterion::MaxStress,
        pressed,
        0.75,
        Mode::PrincipalCompression,
    );
}

#[test]
fn yielding() {
    let limits = MaterialLimits {
        strength: Some(Strength::Yield(250.0)),
        ..MaterialLimits::default()
    };
    let found = of(
        &limits,
        Criterion::VonMises,
        [0.0, 0.0, 0.0, 0.0, 50.0, 0.0],
    );
    assert_relative_eq!(
        found.index,
        50.0 * 3f64.sqrt() / 250.0,
        max_relative = 1e-15
    );
    assert_relative_eq!(found.reserve_factor * found.index, 1.0);
}

/// The index of the load times its reserve factor is one, for every criterion and many
/// stresses: a golden-ratio sequence over all signs.
#[test]
fn index_at_the_reserve_factor_is_one() {
    let mut seed = 0.5;
    let mut next = || {
        seed = (seed + 0.618_033_988_749_895) % 1.0;
        2.0 * seed - 1.0
    };
    let scale = [900.0, 90.0, 70.0, 60.0, 50.0, 60.0];
    for _ in 0..500 {
        let stress = scale.map(|size| size * next());
        for criterion in [
            Criterion::MaxStress,
            Criterion::MaxStrain,
            Criterion::TsaiWu,
            Criterion::Hashin,
        ] {
            let found = of(&PLY, criterion, stress);
            let at = of(&PLY, criterion, stress.map(|s| s * found.reserve_factor));
            // a few roundings of terms of order ten
            assert!((at.index - 1.0).abs() < 1e-12, "{criterion:?} {}", at.index);
            assert_eq!(found.index <= 1.0, found.reserve_factor >= 1.0);
        }
    }
}

/// No stress: index zero and infinite reserve; the reserve is also infinite if a linear
/// term keeps the polynomial below one for any factor.
#[test]
fn reserve_may_be_infinite() {
    for found in failure_indices(&PLY, &Tensors::default()) {
        assert_eq!((found.index, found.reserve_factor), (0.0, f64::INFINITY));
    }
    assert_eq!(quadratic_reserve(0.0, -1.0), f64::INFINITY);
    assert_eq!(quadratic_reserve(0.0, 2.0), 0.5);
    assert!(quadratic_reserve(f64::NAN, 0.0).is_nan());
}
