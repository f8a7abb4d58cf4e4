//! The steady state against closed forms, random sections and its own equations.

use super::*;
use crate::momentum::annulus::Options;
use crate::momentum::induction::HighInduction;
use crate::momentum::velocity::{Ambient, balance};

/// A small generator of numbers in 0..1 (linear congruence).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// A section with stall at all angles.
fn stalled(alpha: f64) -> Coefficients<f64> {
    let (sin, cos) = alpha.sin_cos();
    let attached = (-(sin / 0.3).powi(4)).exp();
    let lift = attached * 6.2 * sin * cos + (1.0 - attached) * 1.1 * (2.0 * alpha).sin();
    Coefficients {
        lift,
        drag: 0.01 + 1.3 * sin * sin,
        moment: 0.0,
    }
}

fn random_ring(random: &mut Random) -> Annulus {
    let radius = random.between(0.12, 0.98);
    Annulus {
        radius,
        hub_radius: 0.1,
        tip_radius: 1.0,
        blades: 2 + (random.next() * 3.0) as usize,
        chord: random.between(0.03, 0.25) * (1.2 - radius),
        options: Options {
            high_induction: match (random.next() * 3.0) as usize {
                0 => HighInduction::Buhl,
                1 => HighInduction::BuhlOutside,
                _ => HighInduction::Polynomial,
            },
            ..Options::default()
        },
    }
}

fn plain(radius: f64) -> Annulus {
    Annulus {
        radius,
        hub_radius: 0.0,
        tip_radius: 1.0,
        blades: 4,
        chord: 0.05,
        options: Options {
            tip_loss: false,
            hub_loss: false,
            axial_drag: false,
            tangential_drag: false,
            swirl: false,
            ..Options::default()
        },
    }
}

/// Hover without loss and swirl, with a constant slope: `lambda = (sigma a / 16)
/// (sqrt(1 + 32 theta r / (sigma a)) - 1)` for small angles (Gessow and Myers). The closed form
/// replaces sin and tan by the angle: 2 % at 8 degrees, 0.2 % at 2 degrees.
#[test]
fn hover_by_the_closed_form() {
    let lift = |alpha: f64| Coefficients {
        lift: 5.73 * alpha,
        drag: 0.0,
        moment: 0.0,
    };
    for (degrees, tolerance) in [(2.0f64, 0.002), (4.0, 0.006), (8.0, 0.022)] {
        for radius in [0.3, 0.5, 0.75, 0.9] {
            let ring = plain(radius);
            let theta = degrees.to_radians();
            let (omega, slope) = (100.0, 5.73 * 4.0 * 0.05 / PI);
            let closed = slope / 16.0 * ((1.0 + 32.0 * theta * radius / slope).sqrt() - 1.0);
            let found = solve(&ring, theta, 0.0, omega * radius, lift);
            assert_eq!(found.outcome, Outcome::Solved);
            let error = found.axial / omega / closed - 1.0;
            assert!(error.abs() < tolerance, "{degrees} {radius}: {error}");
        }
    }
}

/// Any section with lift has a solution, with both signs of Vx and Vy, and it satisfies momentum
/// in each direction.
#[test]
fn random_sections_have_solutions() {
    let mut random = Random(7);
    let mut failures = Vec::new();
    for case in 0..12_000 {
        let ring = random_ring(&mut random);
        let vy = 100.0 * ring.radius * if case % 4 > 1 { -1.0 } else { 1.0 };
        let vx = random.between(0.0, 1.0).powi(3) * 80.0 * if case % 2 > 0 { -1.0 } else { 1.0 };
        let pitch = random.between(-0.6, 1.0);
        let found = solve(&ring, pitch, vx, vy, stalled);
        if found.outcome != Outcome::Solved {
            failures.push((case, ring, pitch, vx, vy));
            continue;
        }
        check_momentum(&ring, vx, vy, &found);
    }
    assert!(
        failures.is_empty(),
        "{} {:?}",
        failures.len(),
        failures.first()
    );
}

/// Loads and momentum of a solution, by the definition of the coefficients.
fn check_momentum(ring: &Annulus, vx: f64, vy: f64, found: &Solution) {
    let flow = found.flow;
    let (cn, ct) = flow.load_coefficients(found.coefficients);
    let load = ring.solidity() * flow.speed * flow.speed / (4.0 * found.loss);
    if vx < LEAST_AXIAL * vy.abs() {
        let ambient = Ambient {
            axial: vx,
            rotation: vy,
            skew: 0.0,
        };
        let (axial, swirl) = balance(ring, &ambient, found.axial, found.swirl, found.coefficients);
        let size = load * (cn.abs() + ct.abs()) + vx * vx;
        assert!(axial.abs() < 1e-6 * size, "{ring:?} {found:?} {axial}");
        assert!(swirl.abs() < 1e-6 * size, "{ring:?} {found:?} {swirl}");
        return;
    }
    let through = (vx + found.axial).abs();
    let a = -found.axial / vx;
    let mass = match ring.options.high_induction {
        law if a > 0.4 && a < 1.0 => law.slope(a, found.loss) * vx.abs(),
        HighInduction::Polynomial if a < 1.0 => {
            HighInduction::Polynomial.slope(a, found.loss) * vx.abs()
        }
        _ => through,
    };
    let size = load * (cn.abs() + ct.abs()) + through * through;
    let (axial, swirl) = (
        found.axial * mass - load * cn,
        found.swirl * through - load * ct,
    );
    assert!(axial.abs() < 1e-6 * size, "{ring:?} {found:?} {axial}");
    assert!(swirl.abs() < 1e-6 * size, "{ring:?} {found:?} {swirl}");
    let angle = (found.flow.phi - flow.sin.atan2(flow.cos)).abs();
    assert!(angle < 1e-9);
}

#[test]
fn sections_without_lift_and_odd_inputs_have_an_outcome() {
    let drag = |_: f64| Coefficients {
        lift: 0.0,
        drag: 0.5,
        moment: 0.0,
    };
    let ring = plain(0.5);
    for value in [0.0, -0.0, 1e-300, 1e300, f64::NAN, f64::INFINITY, -3.0] {
        for other in [0.0, 50.0, -1e-200, f64::NAN, f64::NEG_INFINITY] {
            let found = solve(&ring, 0.1, value, other, drag);
            if value.is_nan() || other.is_nan() {
                assert_ne!(found.outcome, Outcome::Solved);
            }
            solve(&ring, value, other, 30.0, stalled);
        }
    }
    assert_eq!(solve(&ring, 0.1, 0.0, 0.0, drag).outcome, Outcome::AtRest);
    let mut tip = plain(1.0);
    tip.options.tip_loss = true;
    let end = solve(&tip, 0.1, 5.0, 50.0, drag);
    assert_eq!((end.outcome, end.coefficients.drag), (Outcome::End, 0.0));
    let mut empty = plain(0.5);
    empty.blades = 0;
    assert_eq!(solve(&empty, 0.1, 5.0, 50.0, stalled).axial, 0.0);
}

/// Without rotation the air meets the blade along the shaft, and the swirl balances its lift.
#[test]
fn rotor_at_rest_in_wind() {
    let found = solve(&plain(0.5), 0.3, 10.0, 0.0, stalled);
    assert_eq!(found.outcome, Outcome::Solved);
    assert!((found.flow.phi - FRAC_PI_2).abs() < 1e-5);
}
