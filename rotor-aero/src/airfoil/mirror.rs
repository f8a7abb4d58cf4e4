//! Simple changes of a table.
//!
//! The section upside down has
//!
//! ```text
//! c_l(a) -> -c_l(-a),   c_d(a) -> c_d(-a),   c_m(a) -> -c_m(-a),   flap -> -flap
//! ```

use super::data::{AirfoilData, Curve};

impl AirfoilData {
    /// The section upside down.
    pub fn mirrored(&self) -> Self {
        Self {
            lift: mirrored(&self.lift, -1.0),
            drag: mirrored(&self.drag, 1.0),
            moment: mirrored(&self.moment, -1.0),
            ..self.clone()
        }
    }

    /// The table with all lift coefficients multiplied by a factor, for studies of sensitivity.
    pub fn with_scaled_lift(&self, factor: f64) -> Self {
        let scaled = |curve: &Curve| Curve {
            values: curve.values.iter().map(|value| factor * value).collect(),
            ..curve.clone()
        };
        Self {
            lift: self.lift.iter().map(scaled).collect(),
            ..self.clone()
        }
    }
}

/// The curves over the opposite angles, with a sign.
fn mirrored(curves: &[Curve], sign: f64) -> Vec<Curve> {
    let mirror = |curve: &Curve| Curve {
        flap: curve.flap.map(|flap| -flap),
        alpha: curve.alpha.iter().rev().map(|angle| -angle).collect(),
        values: curve
            .values
            .iter()
            .rev()
            .map(|value| sign * value)
            .collect(),
        ..curve.clone()
    };
    curves.iter().map(mirror).collect()
}

#[cfg(test)]
mod tests {
    use crate::airfoil::{Airfoil, AirfoilData, Curve, Flow, Interpolation};

    fn cambered() -> AirfoilData {
        let curve = |flap: f64, values: [f64; 5]| Curve {
            flap: Some(flap),
            alpha: [-180.0, -20.0, 0.0, 10.0, 180.0_f64]
                .map(f64::to_radians)
                .to_vec(),
            values: values.to_vec(),
            ..Curve::default()
        };
        AirfoilData {
            name: "cambered".to_owned(),
            lift: vec![
                curve(0.0, [0.0, -0.8, 0.3, 1.2, 0.0]),
                curve(0.1, [0.1, -0.6, 0.5, 1.4, 0.1]),
            ],
            drag: vec![curve(0.0, [0.02, 0.1, 0.01, 0.03, 0.02])],
            moment: vec![curve(0.0, [0.0, 0.1, -0.05, -0.06, 0.0])],
            ..AirfoilData::default()
        }
    }

    #[test]
    fn a_section_upside_down_has_opposite_lift_at_opposite_angles() {
        let data = cambered();
        let [upright, mirrored] = [data.clone(), data.mirrored()]
            .map(|data| Airfoil::new(&data, Interpolation::Monotone).unwrap());
        for k in -20..20 {
            let (alpha, flap) = (f64::from(k) * 0.17, f64::from(k) * 0.005);
            let at = |airfoil: &Airfoil, sign: f64| {
                let (mach, reynolds) = (0.1, 1e6);
                airfoil.at(&Flow {
                    alpha: sign * alpha,
                    mach,
                    reynolds,
                    flap: sign * flap,
                })
            };
            let (a, b) = (at(&upright, 1.0), at(&mirrored, -1.0));
            assert!((a.lift + b.lift).abs() < 1e-12 && (a.drag - b.drag).abs() < 1e-12);
            assert!((a.moment + b.moment).abs() < 1e-12);
        }
        assert_eq!(data.mirrored().mirrored(), data);
    }

    #[test]
    fn scaled_lift_keeps_the_rest() {
        let data = cambered();
        let scaled = data.with_scaled_lift(1.1);
        assert_eq!((&scaled.drag, &scaled.moment), (&data.drag, &data.moment));
        assert!((scaled.lift[0].values[3] - 1.32).abs() < 1e-12);
    }
}
