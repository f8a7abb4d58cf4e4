//! The scan on two modes whose roots are known in closed form.
//!
//! ```text
//! s_i(p) = g_i(p) + i w_i(p) ,     shapes: the columns of a rotation
//! ```

use beam_dynamics::analysis::stability::{Scan, ScanSettings, scan};
use beam_dynamics::result::{BoundaryKind, SeenFrequency, StabilityRoot, StableSide};
use nalgebra::Complex;

use crate::periodic::Random;

/// Growth and frequency of a mode over the parameter.
type Mode<'a> = &'a dyn Fn(f64) -> [f64; 2];

/// From 0 to 1 in 9 values.
fn settings(boundaries: bool) -> ScanSettings {
    ScanSettings {
        values: (0..9).map(|k| f64::from(k) / 8.0).collect(),
        boundaries,
        tolerance: 1e-10,
    }
}

/// The scan from 0 to 1 in 9 values of modes called "one" and "two".
fn scanned(modes: [Mode<'_>; 2], turn: f64) -> Scan {
    let (sin, cos) = turn.sin_cos();
    let shapes = [[cos, sin], [-sin, cos]];
    let settings = settings(true);
    let mut evaluate = |at: f64| {
        let roots = (0..2).map(|k| {
            let [growth, frequency] = modes[k](at);
            let shape = shapes[k].map(Complex::from).to_vec();
            StabilityRoot {
                shape: [shape.clone(), shape],
                name: ["one", "two"][k].to_owned(),
                ..StabilityRoot::new(Complex::new(growth, frequency))
            }
        });
        Ok(roots.collect())
    };
    scan(&settings, &mut evaluate)
}

/// Asserts values, names and stable sides of the boundaries.
fn assert_found(found: &Scan, expected: &mut [(f64, &str, StableSide)], within: f64) {
    expected.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert!(found.failures.is_empty(), "{:?}", found.failures);
    assert_eq!(
        found.boundaries.len(),
        expected.len(),
        "{expected:?} {:#?}",
        found.boundaries
    );
    let mut rest: Vec<_> = found.boundaries.iter().collect();
    for (at, name, side) in expected {
        let same = rest.iter().position(|own| {
            (own.at - *at).abs() < within && own.name == *name && own.stable == *side
        });
        let index = same.unwrap_or_else(|| panic!("{at} {name} {side:?}: {rest:#?}"));
        assert_eq!(rest.remove(index).kind, BoundaryKind::Flutter);
    }
}

fn side(slope: f64) -> StableSide {
    if slope > 0.0 {
        StableSide::Below
    } else {
        StableSide::Above
    }
}

// Each growth is a cubic with one zero at a random value; frequencies may cross.
#[test]
fn random_crossings() {
    let mut random = Random(7);
    for _ in 0..300 {
        let places = [0; 2].map(|_| 0.5 + 0.48 * random.next());
        let slopes = [0; 2].map(|_| random.next() + 0.3 * random.next().signum());
        let frequencies = [0; 2].map(|_| [4.0 + 2.0 * random.next(), 2.0 * random.next()]);
        let turn = 3.0 * random.next();
        let mode = |k: usize| {
            let (a, c, [w, v]) = (places[k], slopes[k], frequencies[k]);
            move |p: f64| [c * (p - a) * (1.0 + (p - a) * (p - a)), w + v * p]
        };
        if slopes.iter().any(|slope| slope.abs() < 0.05) {
            continue;
        }
        let found = scanned([&mode(0), &mode(1)], turn);
        let mut expected = [0, 1].map(|k| (places[k], ["one", "two"][k], side(slopes[k])));
        assert_found(&found, &mut expected, 1e-9);
    }
}

// Two motions nu_k in axes that turn at Omega are seen at |nu_k - Omega|, nu_k and nu_k + Omega, each
// with a shape of its own. The shares of the energy are random: at some values the largest is another
// one, but over all values it is always the same, at which each mode is then shown.
#[test]
fn random_shares_of_the_energy() {
    let mut random = Random(11);
    let mut changes = 0;
    for _ in 0..300 {
        let rates = [0; 2].map(|_| [1.5 + 0.4 * random.next(), 0.4 * random.next()]);
        let most = [0; 2].map(|_| ((1.5 * (1.0 + random.next())) as usize).min(2));
        let settings = settings(false);
        let seen_at = |k: usize, harmonic: usize, at: f64| {
            let [rate, slope] = rates[k];
            (rate + slope * at + (harmonic as f64 - 1.0) * (4.0 + 2.0 * at)).abs()
        };
        let mut evaluate = |at: f64| {
            let roots = (0..2).map(|k| {
                let mut seen: Vec<_> = (0..3)
                    .map(|harmonic| {
                        let middle = if harmonic == most[k] { 0.39 } else { 0.3 };
                        let mut shape = vec![Complex::new(0.0, 0.0); 6];
                        shape[3 * k + harmonic] = Complex::new(1.0, 0.0);
                        SeenFrequency {
                            frequency: seen_at(k, harmonic, at),
                            share: middle
                                + if harmonic == most[k] { 0.05 } else { 0.1 } * random.next(),
                            shape,
                        }
                    })
                    .collect();
                seen.sort_by(|a, b| b.share.total_cmp(&a.share));
                let first = seen.remove(0);
                changes += usize::from(first.frequency != seen_at(k, most[k], at));
                StabilityRoot {
                    shape: [first.shape.clone(), first.shape],
                    share: first.share,
                    fundamental: 4.0 + 2.0 * at,
                    others: seen,
                    ..StabilityRoot::new(Complex::new(-1.0, first.frequency))
                }
            });
            Ok(roots.collect())
        };
        let found = scan(&settings, &mut evaluate);
        assert_eq!(found.modes.len(), 2);
        let order = |k: usize| {
            let first = found.points[0].root_of(k).map(StabilityRoot::frequency);
            let is_it = |own: &usize| first == Some(seen_at(*own, most[*own], 0.0));
            (0..2).find(is_it)
        };
        for mode in 0..2 {
            let k = order(mode).unwrap_or_else(|| panic!("{most:?} {:#?}", found.points[0]));
            for point in &found.points {
                let shown = point.root_of(mode).map(StabilityRoot::frequency);
                assert_eq!(
                    shown,
                    Some(seen_at(k, most[k], point.at)),
                    "{rates:?} {most:?}"
                );
            }
        }
    }
    assert!(changes > 300, "{changes}");
}

// A growth with a narrow maximum or minimum beyond zero: both crossings lie between two values.
#[test]
fn random_double_crossings() {
    let mut random = Random(11);
    for _ in 0..200 {
        let (a, c) = (0.5 + 0.35 * random.next(), 2.0 + random.next());
        let half = 0.01 + 0.009 * random.next();
        let sign = random.next().signum();
        let one = |p: f64| [sign * c * (half * half - (p - a) * (p - a)), 5.0];
        let two = |p: f64| [-0.4 - 0.1 * p, 3.0 + p];
        let found = scanned([&one, &two], 1.0);
        let mut expected = [
            (a - half, "one", side(sign)),
            (a + half, "one", side(-sign)),
        ];
        assert_found(&found, &mut expected, 1e-8);
    }
}

// A growth that touches zero from below or above: the value at a maximum of round-off 1e-16 is known to
// its root, and values are added down to 1e-6 of the range.
#[test]
fn random_touching_growths() {
    let mut random = Random(13);
    for _ in 0..200 {
        let (a, c) = (0.5 + 0.35 * random.next(), 2.0 + random.next());
        let (sign, bend) = (random.next().signum(), 0.5 * random.next());
        let one = |p: f64| {
            let x = p - a;
            [-sign * c * x * x * (1.0 + bend * x), 5.0 + p]
        };
        let two = |p: f64| [-0.4 - 0.1 * p, 3.0];
        let found = scanned([&one, &two], 0.4);
        let touches = if sign > 0.0 {
            StableSide::Both
        } else {
            StableSide::None
        };
        assert_found(&found, &mut [(a, "one", touches)], 2e-5);
    }
}

// Two modes at the same value, in the same direction and in opposite ones.
#[test]
fn random_coincident_crossings() {
    let mut random = Random(17);
    for _ in 0..200 {
        let a = 0.5 + 0.4 * random.next();
        let slopes = [0; 2].map(|_| {
            let slope = random.next();
            slope + 0.2 * slope.signum()
        });
        let one = |p: f64| [slopes[0] * (p - a), 6.0 + p];
        let two = |p: f64| [slopes[1] * (p - a), 4.0 - p];
        let found = scanned([&one, &two], 2.0);
        let mut expected = [(a, "one", side(slopes[0])), (a, "two", side(slopes[1]))];
        assert_found(&found, &mut expected, 1e-8);
    }
}

// A value that fails is reported, and the boundary beside it is found nevertheless.
#[test]
fn a_failed_value_keeps_the_others() {
    let settings = ScanSettings {
        values: vec![3.0, 2.0, 1.0, 0.0],
        boundaries: true,
        tolerance: 1e-9,
    };
    let mut evaluate = |at: f64| match at {
        2.0 => Err(["no motion".to_owned(), "none".to_owned()]),
        at => Ok(vec![StabilityRoot::new(Complex::new(at - 1.25, 0.0))]),
    };
    let found = scan(&settings, &mut evaluate);
    assert_eq!(found.failures.len(), 1);
    assert_eq!(found.failures[0].0, 2.0);
    assert_eq!(
        found
            .points
            .iter()
            .filter(|point| point.is_requested)
            .count(),
        3
    );
    let [boundary] = &found.boundaries[..] else {
        panic!("{:?}", found.boundaries)
    };
    assert!((boundary.at - 1.25).abs() < 1e-9);
    assert_eq!(boundary.kind, BoundaryKind::Divergence);
}
