//! A strip with a flap of tables: between the deflections of the table, and outside of them.

use std::sync::Arc;

use crate::airfoil::{Airfoil, AirfoilData, Curve, Interpolation, PlainFlap, Section, built_in};
use crate::wind::Atmosphere;

use super::{ActingAir, Flap, SectionModel, Strip, StripDesign};

const CHORD: f64 = 0.5;

fn strip(section: Section, word: &str) -> Strip {
    Strip::new(StripDesign {
        chord: CHORD,
        section,
        model: SectionModel::of_word(word).unwrap(),
        inflow: None,
        radial_drag: false,
    })
}

/// Coefficients at 3 deg in a flow of 50 m/s with a deflection.
fn coefficients(strip: &Strip, flap: f64) -> [f64; 3] {
    let (sin, cos) = 3_f64.to_radians().sin_cos();
    let flow = [
        50.0 * cos,
        -50.0 * sin,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        2.0,
        flap,
    ];
    let still = Atmosphere::default();
    let air = ActingAir {
        still: &still,
        part: 1.0,
    };
    strip.report(air, &flow, &[], &[]).coefficients
}

/// Lift, drag and moment of a table are linear between -10 deg, 0 and 10 deg, and constant outside;
/// the relative error is the one of the rounded speed, (0.01 / 50)^2 / 2.
#[test]
fn tables_are_linear_between_their_deflections() {
    let at = |degrees: f64, slope: f64, shift: f64| {
        let alpha: Vec<f64> = (-18..=18)
            .map(|k| (10.0 * f64::from(k)).to_radians())
            .collect();
        let flap = degrees.to_radians();
        Curve {
            flap: Some(flap),
            values: alpha
                .iter()
                .map(|a| slope * a.sin() + shift * flap)
                .collect(),
            alpha,
            ..Curve::default()
        }
    };
    let curves = |slope: f64, [below, above]: [f64; 2]| {
        vec![
            at(-10.0, slope, below),
            at(0.0, slope, 0.0),
            at(10.0, slope, above),
        ]
    };
    let data = AirfoilData {
        name: "flapped".to_owned(),
        lift: curves(1.5, [2.0, 3.0]),
        drag: curves(0.0, [-0.1, 0.2]),
        moment: curves(0.1, [-0.4, -0.6]),
        ..AirfoilData::default()
    };
    let airfoil = Airfoil::new(&data, Interpolation::Linear).unwrap();
    let ten = 10_f64.to_radians();
    assert_eq!(airfoil.flap_range(), Some([-ten, ten]));
    let bare = strip(Section::single(Arc::new(airfoil)), "quasi_steady");
    let strip = bare.clone().with_flap(Flap::OfTables);
    let [lift, _, moment] = coefficients(&strip, 0.0);
    for k in -30..=30 {
        let deflection = (0.5 * f64::from(k)).to_radians();
        let inside = deflection.clamp(-ten, ten);
        let [a, b, c] = if k < 0 {
            [2.0, -0.1, -0.4]
        } else {
            [3.0, 0.2, -0.6]
        };
        let expected = [lift + a * inside, b * inside, moment + c * inside];
        for (found, expected) in coefficients(&strip, deflection).iter().zip(expected) {
            assert!((found - expected).abs() < 1e-7, "{k}: {found} {expected}");
        }
        // Without a flap the number has no effect.
        assert_eq!(coefficients(&bare, deflection), coefficients(&bare, 0.0));
    }
}

/// The thin airfoil with a plain flap: `c_l = 2 pi atan(tan alpha + tau delta)`, and `c_m = -mu delta
/// cos^2 alpha`.
#[test]
fn a_plain_flap_on_a_thin_airfoil() {
    let section = Section::single(Arc::new(built_in("thin").unwrap()));
    let plain = PlainFlap::new(0.25).unwrap();
    let strip = strip(section, "quasi_steady").with_flap(Flap::Plain(plain));
    let alpha = 3_f64.to_radians();
    for k in -30..=30 {
        let deflection = f64::from(k).to_radians();
        let [lift, _, moment] = coefficients(&strip, deflection);
        let turned = (alpha.tan() + plain.effectiveness() * deflection).atan();
        assert!((lift - std::f64::consts::TAU * turned).abs() < 1e-7, "{k}");
        let expected = -plain.moment() * deflection * alpha.cos().powi(2);
        assert!((moment - expected).abs() < 1e-7, "{k}");
    }
}
