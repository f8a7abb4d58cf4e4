//! Each formula against the exponential map or central differences.
//!
//! Tolerances: angles up to 2.5 rad give |g| < 6.1, so algebraic identities carry
//! roundings 1e-16 times products of up to 1 + g.g/4 = 10: some 1e-14. Central
//! differences with h = 1e-6 carry 1e-16/h = 1e-10 of rounding times a few terms of order
//! one, and a truncation h^2/6 times third derivatives of order one, which is below
//! 1e-12: 1e-9 covers both.

use super::*;
use crate::rotation::samples::Samples;
use crate::rotation::{axial, is_rotation, vector};
use std::f64::consts::PI;

const CASES: usize = 200;
const LARGEST_ANGLE: f64 = 2.5;
const STEP: f64 = 1e-6;
const ROUNDING: f64 = 2e-14;
const DIFFERENCE: f64 = 1e-9;

/// Central difference of `f` at `x` along `direction`.
fn difference<const R: usize, const C: usize>(
    f: impl Fn(&Vector3<f64>) -> nalgebra::SMatrix<f64, R, C>,
    x: &Vector3<f64>,
    direction: &Vector3<f64>,
) -> nalgebra::SMatrix<f64, R, C> {
    let step = direction * STEP;
    (f(&(x + step)) - f(&(x - step))) / (2.0 * STEP)
}

fn attitude(samples: &mut Samples) -> Attitude {
    Attitude {
        rotation: samples.rotation(PI),
        angular_velocity: samples.vector(),
    }
}

fn increment(samples: &mut Samples) -> Increment {
    Increment {
        parameters: samples.parameters(LARGEST_ANGLE),
        rate: samples.vector(),
    }
}

// g = 2 tan(phi/2) n against exp(phi n), which is independent of the formula.
#[test]
fn rotation_is_the_exponential_of_the_same_axis_and_angle() {
    let mut samples = Samples::new(20);
    for _ in 0..CASES {
        let phi = samples.rotation_vector(LARGEST_ANGLE);
        let g = phi.normalize() * (2.0 * (0.5 * phi.norm()).tan());
        assert!((to_rotation(&g) - vector::to_rotation(&phi)).amax() < 3e-15);
        assert!((to_rotation(&g) - skew(&phi).exp()).amax() < 5e-15);
        assert!(is_rotation(&to_rotation(&g), 3e-15));
    }
}

// dg/dphi grows as 1 + g.g/4, and roundings of R with it.
#[test]
fn parameters_come_back_from_the_rotation() {
    let mut samples = Samples::new(21);
    for limit in [3.1, 1e-3, 1e-8] {
        for _ in 0..CASES {
            let g = samples.parameters(limit);
            let back = from_rotation(&to_rotation(&g));
            assert!((back - g).amax() < 2e-15 * (1.0 + 0.25 * g.norm_squared()));
        }
    }
}

// The printed formula, g = 4 ax(R)/(1 + tr R). With 1 + tr R = 4/(1 + g.g/4) the
// roundings of the trace grow as 1 + g.g/4.
#[test]
fn inverse_map_agrees_with_the_trace_formula() {
    let mut samples = Samples::new(22);
    for _ in 0..CASES {
        let r = samples.rotation(LARGEST_ANGLE);
        let g = axial(&r) * (4.0 / (1.0 + r.trace()));
        assert!((from_rotation(&r) - g).amax() < 5e-15 * (1.0 + 0.25 * g.norm_squared()));
    }
}

#[test]
fn half_a_turn_is_singular_without_a_panic() {
    let half_turn = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
    let g = from_rotation(&half_turn);
    assert!(g.norm() > 1e15 || !g.norm().is_finite());
    // Just below it the parameters are large but right: R is recovered.
    let r = vector::to_rotation(&(Vector3::new(0.6, 0.0, 0.8) * (PI - 1e-6)));
    assert!((to_rotation(&from_rotation(&r)) - r).amax() < 5e-15);
}

#[test]
fn tangent_gives_the_angular_velocity() {
    let mut samples = Samples::new(23);
    for _ in 0..CASES {
        let Increment {
            parameters: g,
            rate,
        } = increment(&mut samples);
        let r = to_rotation(&g);
        let spin = difference(to_rotation, &g, &rate) * r.transpose();
        assert!((tangent(&g) * rate - axial(&spin)).amax() < DIFFERENCE);
        // Spin is antisymmetric: dR = [G dg]x R is complete.
        assert!((spin + spin.transpose()).amax() < DIFFERENCE);
    }
}

#[test]
fn tangent_has_its_inverse_determinant_and_material_form() {
    let mut samples = Samples::new(24);
    for _ in 0..CASES {
        let g = samples.parameters(LARGEST_ANGLE);
        let t = tangent(&g);
        assert!((t * tangent_inverse(&g) - Matrix3::identity()).amax() < ROUNDING);
        assert!((t.determinant() - scale(&g).powi(2)).abs() < 1e-15);
        assert!((to_rotation(&g).transpose() * t - t.transpose()).amax() < 2e-15);
    }
}

// Also with products of more than half a turn: R(c) is still right there. Cases within
// 0.1 of the singularity are omitted, since c loses digits as 1/(4 - a.b).
#[test]
fn composition_is_the_product_of_rotations() {
    let mut samples = Samples::new(25);
    let mut compared = 0;
    for _ in 0..CASES {
        let a = samples.parameters(LARGEST_ANGLE);
        let b = samples.parameters(LARGEST_ANGLE);
        if (4.0 - a.dot(&b)).abs() > 0.1 {
            let product = to_rotation(&a) * to_rotation(&b);
            assert!((to_rotation(&compose(&a, &b)) - product).amax() < ROUNDING);
            compared += 1;
        }
    }
    assert!(compared > 150);
}

#[test]
fn tangent_derivatives_agree_with_finite_differences() {
    let mut samples = Samples::new(26);
    for _ in 0..CASES {
        let g = samples.parameters(LARGEST_ANGLE);
        let (v, direction) = (samples.vector(), samples.vector());
        let numeric = difference(|g| tangent(g) * v, &g, &direction);
        assert!((tangent_derivative(&g, &v) * direction - numeric).amax() < DIFFERENCE);
        let numeric = difference(|g| tangent(g).transpose() * v, &g, &direction);
        assert!((tangent_transpose_derivative(&g, &v) * direction - numeric).amax() < DIFFERENCE);
    }
}

#[test]
fn history_is_zero_at_the_last_rotation_and_gives_the_one_before_back() {
    let mut samples = Samples::new(27);
    for _ in 0..CASES {
        let last = attitude(&mut samples);
        let here = relative(&last, &last.rotation);
        assert!(here.parameters.amax() < 2e-15);
        assert!((here.rate - last.angular_velocity).amax() < 4e-15);

        let before = Attitude {
            rotation: samples.rotation(LARGEST_ANGLE) * last.rotation,
            angular_velocity: samples.vector(),
        };
        let still = Attitude {
            angular_velocity: Vector3::zeros(),
            ..last
        };
        let back = corrected(&relative(&before, &last.rotation), &still);
        assert!((back.rotation - before.rotation).amax() < ROUNDING);
        assert!((back.angular_velocity - before.angular_velocity).amax() < ROUNDING);
    }
}

// The rate of the history is the time derivative of its parameters while the
// rotation turns with its angular velocity. dg/dt amplifies roundings by up to
// 1 + g.g/4 = 10, and third derivatives of tan reach 1e3: 1e-8.
#[test]
fn rate_of_the_history_is_the_derivative_of_its_parameters() {
    let mut samples = Samples::new(28);
    for _ in 0..CASES {
        let origin = samples.rotation(PI);
        let before = Attitude {
            rotation: samples.rotation(LARGEST_ANGLE) * origin,
            angular_velocity: samples.vector(),
        };
        let parameters = |turn: &Vector3<f64>| {
            from_rotation(&(vector::to_rotation(turn) * before.rotation * origin.transpose()))
        };
        let numeric = difference(parameters, &Vector3::zeros(), &before.angular_velocity);
        assert!((relative(&before, &origin).rate - numeric).amax() < 10.0 * DIFFERENCE);
    }
}

// In time: the base turns as exp(w0 t) R0, the parameters as g + gdot t.
#[test]
fn corrected_angular_velocity_is_that_of_the_corrected_rotation() {
    let mut samples = Samples::new(29);
    for _ in 0..CASES {
        let (step, base) = (increment(&mut samples), attitude(&mut samples));
        let rotation = |time: f64| {
            to_rotation(&(step.parameters + step.rate * time))
                * vector::to_rotation(&(base.angular_velocity * time))
                * base.rotation
        };
        let now = corrected(&step, &base);
        let spin = (rotation(STEP) - rotation(-STEP)) / (2.0 * STEP) * now.rotation.transpose();
        assert!((now.rotation - rotation(0.0)).amax() < 2e-15);
        assert!((now.angular_velocity - axial(&spin)).amax() < DIFFERENCE);
    }
}

#[test]
fn linearization_agrees_with_finite_differences() {
    let mut samples = Samples::new(30);
    for _ in 0..CASES {
        let (step, base) = (increment(&mut samples), attitude(&mut samples));
        let (dg, drate) = (samples.vector(), samples.vector());
        let at = |parameters: &Vector3<f64>, rate: &Vector3<f64>| {
            let (parameters, rate) = (*parameters, *rate);
            corrected(&Increment { parameters, rate }, &base)
        };
        let (g, rate) = (&step.parameters, &step.rate);
        let exact = linearized(&step, &base);

        let spin = difference(|g| at(g, rate).rotation, g, &dg)
            * corrected(&step, &base).rotation.transpose();
        assert!((exact.rotation * dg - axial(&spin)).amax() < DIFFERENCE);
        let numeric = difference(|g| at(g, rate).angular_velocity, g, &dg);
        assert!((exact.velocity * dg - numeric).amax() < DIFFERENCE);
        let numeric = difference(|rate| at(g, rate).angular_velocity, rate, &drate);
        assert!((exact.velocity_by_rate * drate - numeric).amax() < DIFFERENCE);
    }
}

// At g = 0, gdot = 0: theta = dg, d omega = d gdot - omega x dg, exactly.
#[test]
fn linearization_starts_from_the_simplified_one() {
    let zero = Increment {
        parameters: Vector3::zeros(),
        rate: Vector3::zeros(),
    };
    let base = attitude(&mut Samples::new(31));
    let exact = linearized(&zero, &base);
    assert_eq!(exact.rotation, Matrix3::identity());
    assert_eq!(exact.velocity_by_rate, Matrix3::identity());
    assert!((exact.velocity + skew(&base.angular_velocity)).amax() < 1e-16);
}
