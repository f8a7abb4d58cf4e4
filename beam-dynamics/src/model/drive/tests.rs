//! Tests of drives: derivatives, corners, statistics.

use std::sync::Arc;

use approx::assert_relative_eq;
use shared_geom::expression::{Expression, Names};

use super::{
    BandNoise, Doublet, Drive, DriveTable, Extrapolation, Formula, Harmonic, Interpolation, Ramp,
    Step, SteppedNoise, TableProblem,
};

fn formula(text: &str) -> Drive {
    let names = Names {
        variables: &["t"],
        constants: &[],
    };
    let expression = Expression::parse(text, &names).unwrap();
    Drive::Formula(Arc::new(Formula::new(expression, 1.0)))
}

fn table(rows: &[[f64; 2]], interpolation: Interpolation, extrapolation: Extrapolation) -> Drive {
    Drive::Table(Arc::new(
        DriveTable::new(rows, interpolation, extrapolation).unwrap(),
    ))
}

const ROWS: [[f64; 2]; 5] = [[0.0, 1.0], [0.4, -0.5], [1.0, 0.3], [1.3, 2.0], [2.0, 1.0]];

/// One drive of each kind, of unit size.
fn drives() -> Vec<Drive> {
    let ramp = |smooth| {
        Drive::Ramp(Ramp {
            from: -0.3,
            to: 1.2,
            start: 0.5,
            end: 1.5,
            smooth,
        })
    };
    let step = Drive::Step(Step {
        from: 0.2,
        to: -1.0,
        time: 0.7,
    });
    let harmonic = Drive::Harmonic(Harmonic {
        mean: 0.4,
        amplitude: 1.3,
        frequency: 0.8,
        phase: 0.6,
        start: 0.3,
        cycles: 1.25,
    });
    let doublet = Drive::Doublet(Doublet {
        amplitude: 0.7,
        start: 0.2,
        duration: 1.0,
    });
    let band = BandNoise::new([0.2, 0.6], [0.1, 1.5], 8, 7);
    let noise = Drive::Noise(SteppedNoise {
        mean: 0.1,
        deviation: 0.5,
        interval: 0.25,
        seed: 3,
    });
    let smooth = formula("0.3*t^2 + sin(2*t)*exp(-t/3) - tanh(t - 1) + atan2(t, 2)/(1 + t)");
    vec![
        Drive::Constant(0.4),
        ramp(false),
        ramp(true),
        step,
        harmonic.clone(),
        doublet,
        table(&ROWS, Interpolation::Linear, Extrapolation::Hold),
        table(&ROWS, Interpolation::Spline, Extrapolation::Hold),
        smooth.clone(),
        formula("abs(t - 0.9)*max(0.2, 1 - t) + if(t < 1.1, t, 2*t) + mod(t, 0.6)"),
        Drive::Band(Arc::new(band)),
        noise,
        Drive::Sum(Arc::new([harmonic.clone(), ramp(false)])),
        Drive::Product(Arc::new([harmonic, smooth, ramp(true)])),
        ramp(true).scaled(-2.5),
    ]
}

// Central differences of step 1e-5 of unit-sized functions: truncation h^2/6 times third
// derivatives of up to (2 pi 1.5)^3 is 2e-8, of the rates by as much more with fourth
// derivatives; round-off eps/h is 1e-11.
#[test]
fn derivatives_are_those_of_the_values() {
    const H: f64 = 1e-5;
    for drive in drives() {
        // Times at no corner of any drive.
        for i in 0..60 {
            let time = 0.0137 + 0.0331 * f64::from(i);
            if drive.next_corner(time - 2.0 * H) < time + 2.0 * H {
                continue;
            }
            let now = drive.at(time);
            let [before, after] = [drive.at(time - H), drive.at(time + H)];
            let rate = (after.value - before.value) / (2.0 * H);
            let acceleration = (after.rate - before.rate) / (2.0 * H);
            assert_relative_eq!(now.rate, rate, epsilon = 1e-6);
            assert_relative_eq!(now.acceleration, acceleration, epsilon = 1e-5);
        }
    }
}

// Between two corners neither value nor rate jumps: in steps of 1e-4 they change by less
// than 1e-4 times the next derivative, here below 150; a jump that is not a corner exceeds
// 0.02 in all drives here.
#[test]
fn every_jump_of_value_or_rate_is_a_corner() {
    const H: f64 = 1e-4;
    for drive in drives() {
        let mut jumps = 0;
        for i in 0..25_000 {
            let time = f64::from(i) * H;
            if drive.next_corner(time) <= time + H {
                jumps += 1;
                continue;
            }
            let [now, then] = [drive.at(time), drive.at(time + H)];
            assert!(
                (then.value - now.value).abs() < 0.015,
                "{drive:?} at {time}"
            );
            assert!((then.rate - now.rate).abs() < 0.015, "{drive:?} at {time}");
        }
        assert!(jumps <= 11, "{drive:?}: {jumps}");
    }
}

#[test]
fn corners_follow_each_other_and_end() {
    let corners = |drive: &Drive| {
        let mut all = vec![];
        let mut time = -1.0;
        while drive.next_corner(time) < 10.0 {
            time = drive.next_corner(time);
            all.push(time);
        }
        all
    };
    let doublet = Drive::Doublet(Doublet {
        amplitude: 1.0,
        start: 1.0,
        duration: 3.0,
    });
    assert_eq!(corners(&doublet), [1.0, 2.5, 4.0]);
    assert_eq!(
        [1.0, 2.5, 4.0].map(|time| doublet.at(time).value),
        [1.0, -1.0, 0.0]
    );
    assert_eq!(corners(&formula("abs(t - 2) + step(3*t - 12)")), [2.0, 4.0]);
    assert_eq!(corners(&formula("max(t, 1) + min(1, 6 - t)")), [1.0, 5.0]);
    assert!(corners(&formula("sin(t)")).is_empty());
    let noise = SteppedNoise {
        mean: 0.0,
        deviation: 1.0,
        interval: 0.1,
        seed: 1,
    };
    // -1 itself is a corner, and comes before.
    assert_eq!(corners(&Drive::Noise(noise)).len(), 109);
    assert_eq!(
        corners(&table(&ROWS, Interpolation::Linear, Extrapolation::Hold)),
        [0.0, 0.4, 1.0, 1.3, 2.0]
    );
    assert_eq!(
        corners(&table(&ROWS, Interpolation::Spline, Extrapolation::Hold)),
        [0.0, 2.0]
    );
}

/// Corners of a formula with its own unit of time, up to `end`.
fn corners_of(text: &str, unit: f64, end: f64) -> (Formula, Vec<f64>) {
    let names = Names {
        variables: &["t"],
        constants: &[],
    };
    let formula = Formula::new(Expression::parse(text, &names).unwrap(), unit);
    let mut all = vec![];
    let mut time = 0.0;
    while formula.next_corner(time) < end {
        time = formula.next_corner(time);
        all.push(time);
    }
    (formula, all)
}

// Numbers that are not exact in binary: the corner is the first time at which the new
// piece holds, to the last bit, in any unit of time of the formula.
#[test]
fn a_jump_is_between_its_corner_and_the_number_before() {
    let mut texts = vec![
        "step((t + 1000) - 1000.3)".to_string(),
        "floor(7*t + 0.1)".to_string(),
        "floor(0.1 - 7*t)".to_string(),
        "if(mod(t, 0.2) < 0.1, 1, 0)".to_string(),
        "if(mod(t, 0.3) < 0.15, 1, 0)".to_string(),
        "sign(0.7 - 3*t) + (t > 0.6)".to_string(),
    ];
    for a in [3, 7, 9, 11, 13] {
        texts.extend([0.1, 0.3, 0.7, 0.9].map(|c| format!("step({a}*t - {c})")));
        texts.extend([0.1, 0.3, 0.7, 0.9].map(|c| format!("step(t/{a} - {c}/{a})")));
    }
    for text in &texts {
        for unit in [1.0, 0.1, 1.0 / 3.0, 60.0] {
            let (formula, corners) = corners_of(text, unit, 0.97 * unit);
            assert!(!corners.is_empty(), "{text}");
            // mod and its comparison have corners of their own.
            assert!(corners.len() < 14, "{text}: {corners:?}");
            let mut before = formula.at(0.0).value;
            for corner in corners {
                assert_eq!(
                    formula.at(corner.next_down()).value,
                    before,
                    "{text} {unit}"
                );
                let behind = formula.at(corner).value;
                assert_ne!(behind, before, "{text} {unit} {corner}");
                before = behind;
            }
            assert_eq!(formula.at(0.97 * unit).value, before, "{text} {unit}");
        }
    }
}

// A natural spline through points of a cubic without curvature at its ends is this cubic:
// x^3 - 3 x^2 has y'' = 6 x - 6, zero at x = 1 only; (x - 1)^3 odd about 1 is not enough.
// It is exact for a straight line, and for its own points: here the known second
// derivatives of the spline through 0, 1, 0, 1, 0 at unit steps, from the 3x3 system 4 M1 +
// M2 = -12, M1 + 4 M2 + M3 = 12, M2 + 4 M3 = -12: M1 = M3 = -30/7, M2 = 36/7.
#[test]
fn the_spline_solves_its_equations() {
    let rows = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0], [4.0, 0.0]];
    let spline = table(&rows, Interpolation::Spline, Extrapolation::Error);
    let bends = [1.0, 2.0, 3.0].map(|time| spline.at(time).acceleration);
    for (found, expected) in bends
        .into_iter()
        .zip([-30.0 / 7.0, 36.0 / 7.0, -30.0 / 7.0])
    {
        assert_relative_eq!(found, expected, max_relative = 1e-14);
    }
    assert_eq!([0.0, 2.0, 4.0].map(|time| spline.at(time).value), [0.0; 3]);
}

#[test]
fn a_table_has_no_value_outside_unless_it_is_held() {
    let open = table(&ROWS, Interpolation::Linear, Extrapolation::Error);
    assert_eq!(open.domain(), [0.0, 2.0]);
    assert!(open.at(2.001).value.is_nan() && open.at(-1e-9).value.is_nan());
    assert_eq!(open.at(2.0).value, 1.0);
    let held = table(&ROWS, Interpolation::Linear, Extrapolation::Hold);
    assert_eq!(held.at(9.0).value, 1.0);
    let sum = Drive::Sum(Arc::new([held, open.scaled(2.0)]));
    assert_eq!(sum.domain(), [0.0, 2.0]);
    let bad = |rows: &[[f64; 2]]| {
        DriveTable::new(rows, Interpolation::Linear, Extrapolation::Hold).unwrap_err()
    };
    assert_eq!(bad(&ROWS[..1]), TableProblem::Few { found: 1 });
    assert_eq!(
        bad(&[[0.0, 1.0], [0.0, 2.0]]),
        TableProblem::NotRising { row: 1 }
    );
}

// Time means over T = 2000 s. Band 1 to 3 Hz of 64 sines: cross terms of the mean square
// decrease as 1/(T df) with df about 1/32 Hz: 2 %; the mean as 1/(2 pi f T).
#[test]
fn smooth_noise_has_the_stated_statistics() {
    let noise = Drive::Band(Arc::new(BandNoise::new([0.5, 2.0], [1.0, 3.0], 64, 42)));
    let count = 200_000;
    let values: Vec<_> = (0..count)
        .map(|i| noise.at(0.01 * f64::from(i)).value - 0.5)
        .collect();
    let mean = values.iter().sum::<f64>() / f64::from(count);
    let square = values.iter().map(|value| value * value).sum::<f64>() / f64::from(count);
    assert!(mean.abs() < 2e-3, "{mean}");
    assert!((square / 4.0 - 1.0).abs() < 0.04, "{square}");
    let same = BandNoise::new([0.5, 2.0], [1.0, 3.0], 64, 42);
    assert_eq!(Drive::Band(Arc::new(same)), noise);
    let other = BandNoise::new([0.5, 2.0], [1.0, 3.0], 64, 43);
    assert_ne!(Drive::Band(Arc::new(other)), noise);
}

// 40000 independent numbers: the mean has the deviation 1/200, the mean square the deviation
// sqrt(2)/200, neighbors have the correlation 1/200; four of these.
#[test]
fn stepped_noise_has_the_stated_statistics() {
    let noise = SteppedNoise {
        mean: 0.0,
        deviation: 1.0,
        interval: 0.5,
        seed: 5,
    };
    let count = 40_000;
    let value = |i: i32| Drive::Noise(noise).at(0.5 * f64::from(i - count / 2)).value;
    let values: Vec<_> = (0..count).map(value).collect();
    let mean = |numbers: &mut dyn Iterator<Item = f64>| numbers.sum::<f64>() / f64::from(count);
    assert!(mean(&mut values.iter().copied()).abs() < 0.02);
    assert!((mean(&mut values.iter().map(|v| v * v)) - 1.0).abs() < 0.03);
    assert!(mean(&mut values.windows(2).map(|v| v[0] * v[1])).abs() < 0.02);
}
