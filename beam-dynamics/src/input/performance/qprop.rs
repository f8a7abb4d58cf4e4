//! The polar of a QPROP propeller as an airfoil.
//!
//! ```text
//! cl = cl0 + cl_a alpha, from cl_min to cl_max
//! cd = (cd0 + k (cl - cl_cd0)^2) (Re / Re_ref)^n,  k above or below cl_cd0
//! ```
//!
//! (QPROP user guide, M. Drela 2006), with the Prandtl-Glauert factor on the lift up to Mach 0.8.
//! Beyond 90 degrees, where QPROP has no polar, the lift fades linearly to zero at 180 degrees.

use std::f64::consts::FRAC_PI_2;

use rotor_aero::airfoil::files::blade::QpropPolar;
use rotor_aero::airfoil::{Airfoil, AirfoilData, AirfoilProblem, Curve, Interpolation};

/// Reynolds numbers of the tables: decades, and tables in each.
const DECADES: [i32; 2] = [3, 8];
const PER_DECADE: i32 = 5;
/// Largest angle of the tables, and their step [deg].
const LARGEST: i32 = 180;
/// Mach number from which the factor of the lift is constant [-].
const MACH_LIMIT: f64 = 0.8;

/// The airfoil of a polar, under a name.
pub(super) fn airfoil(name: &str, polar: &QpropPolar) -> Result<Airfoil, Vec<AirfoilProblem>> {
    let angles: Vec<f64> = (-LARGEST..=LARGEST)
        .map(|degrees| f64::from(degrees).to_radians())
        .collect();
    let [low, high] = polar.lift_limits;
    let limited = |lift: f64| lift.min(high).max(low);
    let lift = angles.iter().map(|alpha| {
        let attached = limited(polar.lift_zero + polar.lift_slope * alpha);
        attached * (2.0 - alpha.abs() / FRAC_PI_2).clamp(0.0, 1.0)
    });
    let lift: Vec<f64> = lift.collect();
    let drag = |reynolds: f64| {
        let factor = (reynolds / polar.reynolds).powf(polar.exponent);
        let drag = lift.iter().map(|lift| {
            let over = lift - polar.lift_drag_zero;
            let quadratic = polar.drag_quadratic[usize::from(over < 0.0)];
            (polar.drag_zero + quadratic * over * over) * factor
        });
        Curve {
            reynolds: Some(reynolds),
            alpha: angles.clone(),
            values: drag.collect(),
            ..Curve::default()
        }
    };
    let steps = DECADES[0] * PER_DECADE..=DECADES[1] * PER_DECADE;
    let numbers = steps.map(|step| 10f64.powf(f64::from(step) / f64::from(PER_DECADE)));
    let data = AirfoilData {
        name: name.to_owned(),
        thickness: None,
        lift: vec![Curve {
            alpha: angles.clone(),
            values: lift.clone(),
            ..Curve::default()
        }],
        drag: numbers.map(drag).collect(),
        moment: Vec::new(),
    };
    Airfoil::new(
        &data.with_compressibility(MACH_LIMIT)?,
        Interpolation::Monotone,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use rotor_aero::airfoil::Flow;

    /// The numbers of cam6x3.def, the example of QPROP, by the formulas above.
    #[test]
    fn the_polar_is_its_formula() {
        let polar = QpropPolar {
            lift_zero: 0.5,
            lift_slope: 5.8,
            lift_limits: [-0.3, 1.2],
            drag_zero: 0.028,
            drag_quadratic: [0.05, 0.02],
            lift_drag_zero: 0.5,
            reynolds: 70_000.0,
            exponent: -0.7,
        };
        let airfoil = airfoil("cam", &polar).unwrap();
        let at = |degrees: f64, reynolds: f64| {
            airfoil.at(&Flow {
                alpha: degrees.to_radians(),
                mach: 0.0,
                reynolds,
                flap: 0.0,
            })
        };
        let lift = 0.5 + 5.8 * 4f64.to_radians();
        let found = at(4.0, 70_000.0);
        assert!((found.lift - lift).abs() < 1e-12);
        let drag = 0.028 + 0.05 * (lift - 0.5).powi(2);
        // A power is linear in the logarithm between tables five to a decade: at its middle the
        // error is (0.7 ln 10 / 5)^2 / 8 = 1.3 %.
        assert!((found.drag / drag - 1.0).abs() < 0.013);
        assert_eq!(at(30.0, 1e5).lift, 1.2);
        assert_eq!(at(-30.0, 1e5).lift, -0.3);
        // A table is at this number, and linear interpolation is exact there.
        let exact = drag * (1e5f64 / 70_000.0).powf(-0.7);
        assert!((at(4.0, 1e5).drag / exact - 1.0).abs() < 1e-9);
    }
}
