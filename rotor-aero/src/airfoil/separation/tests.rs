use num_dual::Dual64;
use serde_json::Value;

use super::{Kirchhoff, Separation};
use crate::airfoil::{Airfoil, Flow, LinearLift, built_in};

fn naca() -> Airfoil {
    built_in("naca0012").unwrap()
}

fn lift(airfoil: &Airfoil, alpha: f64, mach: f64) -> f64 {
    let (reynolds, flap) = (6e6, 0.0);
    let flow = Flow {
        alpha,
        mach,
        reynolds,
        flap,
    };
    airfoil.at(&flow).lift
}

/// Angles from -180 to 180 deg in steps that miss the samples.
fn circle() -> impl Iterator<Item = f64> {
    (-600..600).map(|k| (f64::from(k) * 0.3 + 0.11).to_radians())
}

/// Ladson measures slopes of 0.1080 to 0.1092 per degree.
#[test]
fn slope_of_naca0012_is_the_measured_one() {
    let separation = Separation::of(&naca(), 0.15, 6e6);
    let per_degree = separation.slope.to_radians();
    assert!((0.108..0.11).contains(&per_degree), "{per_degree}");
    assert!(separation.zero_lift.abs() < 1e-9);
}

/// Attached and separated lift give the table again, up to the limit of f to one at a slope that
/// is fitted (0.0047 at Mach 0.6, less below), and to the interpolation between samples, which is
/// 0.023 in the degree of the break from 1.62 to 1.08.
#[test]
fn the_split_gives_the_static_lift() {
    for mach in [0.15, 0.35, 0.6] {
        let airfoil = naca();
        let separation = Separation::of(&airfoil, mach, 6e6);
        for alpha in circle() {
            let error = (separation.static_lift(alpha) - lift(&airfoil, alpha, mach)).abs();
            let is_attached = alpha.abs() < 0.25;
            assert!(
                error < if is_attached { 0.005 } else { 0.025 },
                "{mach} {alpha} {error}"
            );
        }
    }
}

#[test]
fn attached_flow_ends_and_does_not_return() {
    let separation = Separation::of(&naca(), 0.3, 6e6);
    let at = |deg: f64| separation.attached(deg.to_radians());
    assert!(at(0.0) > 0.98 && at(5.0) > 0.97 && at(15.0) < 0.9);
    let mut before = 1.0;
    for k in 12..180 {
        let part = at(f64::from(k));
        assert!((0.0..=before + 1e-12).contains(&part) && at(-f64::from(k)) >= 0.0);
        before = part;
    }
    assert_eq!(
        (at(46.0), at(-90.0), at(180.0), at(-170.0)),
        (0.0, 0.0, 0.0, 0.0)
    );
}

/// The separated lift of the Kirchhoff law is half the lift at f = 1, and the lift at f = 0.
#[test]
fn separated_lift_has_its_limits() {
    let thin = Airfoil::linear(LinearLift::default());
    let separation = Separation::of(&thin, 0.1, 1e6);
    assert!((separation.slope - std::f64::consts::TAU).abs() < 1e-12);
    for alpha in [-0.3, 0.1, 0.5_f64] {
        assert!((separation.attached(alpha) - 1.0).abs() < 1e-12);
        let half = 0.5 * std::f64::consts::TAU * alpha;
        // Interpolation of a straight line.
        assert!((separation.separated_lift(alpha) - half).abs() < 1e-12);
    }
    let naca = Separation::of(&naca(), 0.15, 6e6);
    let stalled = 50_f64.to_radians();
    assert!((naca.separated_lift(stalled) - 1.02).abs() < 1e-12);
}

/// Linear lift is attached up to its own fade, which begins at 60 deg: the split is the one at small angles,
/// and beyond gives the lift again, to the interpolation between samples: of steps of 2.5 deg and second
/// derivatives up to 300, 0.07. A flat plate has f of about 0.15 at 40 deg, and none from 45 deg.
#[test]
fn linear_lift_has_no_stall_before_its_fade() {
    let thin = Airfoil::linear(LinearLift {
        slope: 5.7,
        zero_lift: -0.05,
        ..LinearLift::default()
    });
    let separation = Separation::of(&thin, 0.1, 1e6);
    for deg in [-57.0, -46.0, -42.3, 41.2, 44.9, 52.0, 57.0_f64] {
        let alpha = deg.to_radians();
        assert!((separation.attached(alpha) - 1.0).abs() < 1e-9, "{deg}");
        let half = 0.5 * 5.7 * (alpha + 0.05);
        assert!((separation.separated_lift(alpha) - half).abs() < 1e-9);
    }
    assert_eq!(separation.attached(1.58), 0.0);
    for alpha in circle() {
        let error = (separation.static_lift(alpha) - lift(&thin, alpha, 0.1)).abs();
        assert!(error < 0.07, "{alpha} {error}");
    }
    let plate = Separation::of(&built_in("flat_plate").unwrap(), 0.1, 1e6);
    let part = |deg: f64| plate.attached(deg.to_radians());
    assert!(part(39.9) > 0.1 && part(43.0) < 0.1 && part(46.0) == 0.0);
}

#[test]
fn a_section_without_lift_has_no_attached_flow() {
    let none = Airfoil::linear(LinearLift {
        slope: 0.0,
        ..LinearLift::default()
    });
    let separation = Separation::of(&none, 0.1, 1e6);
    for alpha in circle() {
        assert_eq!(
            (separation.attached(alpha), separation.separated_lift(alpha)),
            (0.0, 0.0)
        );
    }
}

/// Constants and formula of the reference file, away from the rounded breaks.
#[test]
fn formula_has_the_published_constants() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/theory-rotor/naca0012_separation_constants.json"
    );
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let number = |key: &str, i: usize| file[key][i].as_f64().unwrap();
    for i in 0..7 {
        let law = Kirchhoff::naca0012(number("Mach", i));
        let [a1, s1, s2] = ["alpha1_deg", "S1_deg", "S2_deg"].map(|key| number(key, i));
        for size in [0.05, 0.3, 0.9, 1.5, 3.0].map(|factor| factor * a1) {
            if (size - a1).abs() < s2 / 10.0 {
                continue;
            }
            let below = 1.0 - 0.3 * ((size - a1) / s1).exp();
            let beyond = 0.04 + 0.66 * ((a1 - size) / s2).exp();
            let expected = if size <= a1 { below } else { beyond };
            for sign in [1.0, -1.0] {
                let found = law.attached((sign * size).to_radians());
                assert!((found - expected).abs() < 1e-12);
            }
        }
        // The rounding at the break changes the part by a fortieth of the difference of slopes
        // times S_2.
        let found = law.attached(a1.to_radians());
        assert!((found - 0.7).abs() < 0.66 / 40.0, "{found}");
    }
}

/// The table of NACA 0012 at Mach 0.3 and above was made from the same formula: the part that
/// follows from its lift agrees with it. The formula is for the normal force, and the slope is
/// fitted, which change f by up to 0.05.
#[test]
fn part_from_the_table_agrees_with_the_formula() {
    let law = Separation::kirchhoff(Kirchhoff::naca0012(0.3), 6.42, 0.0);
    let table = Separation::of(&naca(), 0.3, 6e6);
    for deg in [2.0, 5.0, 10.0, 14.0, 16.0, 18.0_f64] {
        let alpha = deg.to_radians();
        let difference = (law.attached(alpha) - table.attached(alpha)).abs();
        assert!(difference < 0.055, "{deg} {difference}");
    }
}

/// Dual numbers against central differences with a step of 1e-6 rad: second derivatives are
/// below 1e3, so that a step over a knot errs by less than 1e-3.
#[test]
fn derivatives_are_exact() {
    let formula = Separation::kirchhoff(Kirchhoff::naca0012(0.4), 6.2, 0.01);
    let plate = Separation::of(&built_in("flat_plate").unwrap(), 0.1, 1e6);
    for separation in [Separation::of(&naca(), 0.3, 6e6), formula, plate] {
        let dual = |alpha: f64| {
            let alpha = Dual64::new(alpha, 1.0);
            let values = [separation.attached(alpha), separation.separated_lift(alpha)];
            values.map(|value| value.eps)
        };
        let plain = |alpha: f64| [separation.attached(alpha), separation.separated_lift(alpha)];
        for alpha in circle().chain([7.0, -9.0, 0.0, 0.2662]) {
            let (high, low, exact) = (plain(alpha + 1e-6), plain(alpha - 1e-6), dual(alpha));
            for i in 0..2 {
                let error = ((high[i] - low[i]) / 2e-6 - exact[i]).abs();
                assert!(error < 1e-3, "{alpha} {i} {error}");
            }
        }
    }
}

#[test]
fn no_input_panics() {
    for x in [f64::NAN, f64::INFINITY, 0.0, -1.0, 1e300] {
        let law = Kirchhoff {
            break_angle: x,
            scale_before: x,
            scale_beyond: x,
        };
        for separation in [
            Separation::of(&naca(), x, x),
            Separation::of_line(&naca(), [x, x], [x, x]),
            Separation::kirchhoff(law, x, x),
            Separation::kirchhoff(Kirchhoff::naca0012(x), x, x),
        ] {
            for alpha in [x, 0.1, -3.0] {
                let _ = (separation.attached(alpha), separation.separated_lift(alpha));
            }
        }
    }
}
