//! Readers and writers on random airfoils and on texts with random faults.

use std::f64::consts::PI;
use std::path::Path;

use super::samples::{Random, mutated, text};
use super::*;
use crate::airfoil::Curve;

/// A curve over random ascending angles, perhaps over the whole turn.
fn curve(random: &mut Random, condition: [Option<f64>; 3], count: usize) -> Curve {
    let [mach, reynolds, flap] = condition;
    let mut alpha: Vec<f64> = (0..count).map(|_| random.between(-PI, PI)).collect();
    if random.unit() < 0.5 {
        (alpha[0], alpha[count - 1]) = (-PI, PI);
    }
    alpha.sort_by(f64::total_cmp);
    alpha.dedup();
    let values = alpha.iter().map(|_| random.between(-2.0, 2.0)).collect();
    Curve {
        mach,
        reynolds,
        flap,
        alpha,
        values,
    }
}

/// An airfoil with a list of conditions; each coefficient has its own grid if `is_free`.
fn airfoil(random: &mut Random, conditions: &[[Option<f64>; 3]], is_free: bool) -> ReadAirfoil {
    let mut airfoil = ReadAirfoil::default();
    let data = &mut airfoil.data;
    data.name = format!("airfoil {}", random.below(1000));
    let lists = [&mut data.lift, &mut data.drag, &mut data.moment];
    let count = 2 + random.below(60);
    let first = curve(random, conditions[0], count);
    for list in lists {
        for condition in conditions {
            let mut new = curve(random, *condition, count);
            if !is_free {
                new.alpha.clone_from(&first.alpha);
                new.values = first
                    .alpha
                    .iter()
                    .map(|_| random.between(-2.0, 2.0))
                    .collect();
            }
            list.push(new);
        }
    }
    airfoil
}

/// Numbers are written with all digits; an angle is rounded once from rad to deg and once back,
/// and a Reynolds number or thickness once to millions or per cent: 4 units of the last digit.
fn agree(found: &[Curve], expected: &[Curve]) {
    assert_eq!(found.len(), expected.len());
    let near = |a: f64, b: f64| (a - b).abs() <= 4.0 * f64::EPSILON * b.abs();
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(found.values, expected.values);
        assert!(
            found
                .alpha
                .iter()
                .zip(&expected.alpha)
                .all(|(a, b)| near(*a, *b))
        );
        for (a, b) in [
            (found.mach, expected.mach),
            (found.reynolds, expected.reynolds),
            (found.flap, expected.flap),
        ] {
            assert!(a == b || near(a.unwrap(), b.unwrap()), "{a:?} {b:?}");
        }
    }
}

fn round_trip(airfoils: &[ReadAirfoil], format: Format, name: &str) -> Reading {
    let writing = write(airfoils, format, name).unwrap_or_else(|problems| panic!("{problems}"));
    assert!(writing.lost.is_empty(), "{:?}", writing.lost);
    let reading = parse(&writing.text, Path::new(name), &Options::default());
    let reading = reading.unwrap_or_else(|problems| panic!("{problems}\n{}", writing.text));
    assert_eq!(reading.format, format);
    reading
}

fn agree_all(found: &Reading, expected: &[ReadAirfoil]) {
    assert_eq!(found.airfoils.len(), expected.len());
    for (found, expected) in found.airfoils.iter().zip(expected) {
        agree(&found.data.lift, &expected.data.lift);
        agree(&found.data.drag, &expected.data.drag);
        agree(&found.data.moment, &expected.data.moment);
    }
}

#[test]
fn columns_return_as_they_were() {
    let mut random = Random(1);
    for case in 0..300 {
        let mach = |i: usize| (i > 0).then_some(i as f64 * 0.1);
        let conditions: Vec<_> = (0..=random.below(3))
            .map(|i| {
                [
                    mach(i),
                    Some(1e5 * (i + 1) as f64),
                    (case % 2 == 0).then_some(0.1 * i as f64),
                ]
            })
            .collect();
        let mut airfoils = vec![
            airfoil(&mut random, &conditions, true),
            airfoil(&mut random, &conditions, false),
        ];
        airfoils[0].data.name = "first, with a comma".to_owned();
        airfoils[1].data.thickness = Some(random.unit());
        let reading = round_trip(&airfoils, Format::Csv, "a.csv");
        agree_all(&reading, &airfoils);
        assert_eq!(reading.airfoils[0].data.name, airfoils[0].data.name);
        assert_eq!(
            reading.airfoils[1].data.thickness,
            airfoils[1].data.thickness
        );
    }
}

#[test]
fn aerodyn_polars_return_as_they_were() {
    let mut random = Random(2);
    for case in 0..300 {
        let flap = |i: usize| (case % 3 == 0).then_some(0.1 * (i + 1) as f64);
        let conditions: Vec<_> = (0..=random.below(3))
            .map(|i| [None, Some(random.between(1e4, 1e7)), flap(i)])
            .collect();
        let mut airfoil = airfoil(&mut random, &conditions, false);
        if case % 2 == 0 {
            let values = vec![
                ("alpha0".to_owned(), Some(random.between(-5.0, 0.0))),
                ("T_f0".to_owned(), None),
            ];
            let control = Some(conditions[0][2].unwrap_or(0.0).to_degrees());
            airfoil.unsteady.push(UnsteadyConstants {
                reynolds: conditions[0][1],
                control,
                values,
            });
        }
        let reading = round_trip(std::slice::from_ref(&airfoil), Format::AeroDyn15, "a.dat");
        agree_all(&reading, std::slice::from_ref(&airfoil));
        assert_eq!(reading.airfoils[0].unsteady.len(), airfoil.unsteady.len());
        let constants =
            |airfoil: &ReadAirfoil| airfoil.unsteady.first().map(|it| it.values.clone());
        assert_eq!(constants(&reading.airfoils[0]), constants(&airfoil));
    }
}

#[test]
fn profiles_return_as_they_were() {
    let mut random = Random(3);
    for _ in 0..300 {
        let mut airfoils: Vec<_> = (0..=random.below(5))
            .map(|_| airfoil(&mut random, &[[None; 3]], false))
            .collect();
        for (i, airfoil) in airfoils.iter_mut().enumerate() {
            airfoil.data.thickness = Some(0.1 + 0.1 * i as f64);
            airfoil.set = Some(1 + i / 3);
        }
        let reading = round_trip(&airfoils, Format::Hawc2Pc, "pc.dat");
        agree_all(&reading, &airfoils);
        for (found, expected) in reading.airfoils.iter().zip(&airfoils) {
            assert_eq!(found.set, expected.set);
            let difference = found.data.thickness.unwrap() - expected.data.thickness.unwrap();
            assert!(difference.abs() <= 1e-15);
        }
    }
}

/// Six characters keep at least three decimals of the coefficients (below 10 in magnitude,
/// "-1.008"), and one of the angles ("-179.3"): half of the last one. The written text is kept
/// exactly.
#[test]
fn c81_tables_return_in_six_characters() {
    let mut random = Random(4);
    let mut count = 0;
    for _ in 0..400 {
        let conditions: Vec<_> = (0..1 + random.below(14))
            .map(|i| [Some(0.05 * (i + 1) as f64), None, None])
            .collect();
        let airfoils = [airfoil(&mut random, &conditions, false)];
        // Angles that are equal in six characters are refused.
        let Ok(writing) = write(&airfoils, Format::C81, "a.c81") else {
            continue;
        };
        count += 1;
        let reading = parse(&writing.text, Path::new("a.dat"), &Options::default())
            .unwrap_or_else(|problems| panic!("{problems}"));
        assert_eq!(
            write(&reading.airfoils, Format::C81, "a.c81").unwrap().text,
            writing.text
        );
        for (found, expected) in reading.airfoils[0]
            .data
            .lift
            .iter()
            .zip(&airfoils[0].data.lift)
        {
            assert_eq!(
                found.mach,
                expected.mach.map(|mach| (mach * 1e5).round() / 1e5)
            );
            let pairs = found.values.iter().zip(&expected.values);
            assert!(pairs.clone().all(|(a, b)| (a - b).abs() <= 5.001e-4));
            let pairs = found.alpha.iter().zip(&expected.alpha);
            assert!(
                pairs
                    .clone()
                    .all(|(a, b)| (a - b).to_degrees().abs() <= 0.05001)
            );
        }
    }
    assert!(count > 200, "{count}");
}

#[test]
fn texts_with_faults_are_read_or_reported() {
    let files = [
        "theory-rotor/naca0012_eq.c81",
        "aero/iea15/AeroDyn15_Polar_20.dat",
        "aero/nrel5mw/DU21_A17_aerodyn_v12.dat",
        "aero/iea15/hawc2_pc.dat",
        "aero/propellers/CLARK_Y_AIRFOIL_T1_Re0.030_M0.00_N7.0.txt",
        "aero/nrel5mw/polar_DU25_A17.csv",
    ];
    let mut texts: Vec<_> = files.iter().map(|file| text(file)).collect();
    texts.extend([super::tests::VERSION_1, super::tests::VERSION_2].map(str::to_owned));
    let mut random = Random(5);
    for text in &texts {
        let mut refused = 0;
        for _ in 0..300 {
            let text = mutated(text, &mut random);
            match parse(&text, Path::new("a.dat"), &Options::default()) {
                Ok(reading) => {
                    let is_full = |curves: &[Curve]| {
                        !curves.is_empty() && curves.iter().all(|curve| !curve.alpha.is_empty())
                    };
                    assert!(!reading.airfoils.is_empty());
                    let mut data = reading.airfoils.iter().map(|airfoil| &airfoil.data);
                    assert!(data.all(|data| is_full(&data.lift) && is_full(&data.drag)));
                }
                Err(problems) => {
                    assert!(
                        !problems.is_empty() && !problems.to_string().contains("no reason"),
                        "{problems}"
                    );
                    refused += 1;
                }
            }
        }
        assert!(refused > 50, "{refused}");
    }
}
