//! A flap at a section.
//!
//! A table with deflections has the coefficients of the deflection delta. Of a plain flap
//! ([`PlainFlap`]) the mean line has the slope -delta, so that the velocity along the chord enters
//! the normal velocity at the three-quarter chord and the moment:
//!
//! ```text
//! w_34 <- w_34 + g v_x tau delta            M_f = -g mu delta (rho/2) v_x^2 c^2
//! ```
//!
//! The circulation of the flap lags as all circulation does; forces by the rate of the deflection
//! are left out. The gate g closes at large angles and in reverse flow.

use crate::airfoil::PlainFlap;
use crate::real::Real;

use super::local::Local;
use super::section::{SectionFlow, Strip};

/// A flap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Flap {
    /// Of the tables of the section.
    OfTables,
    /// Of thin-airfoil theory; the tables are taken without deflection.
    Plain(PlainFlap),
}

impl Flap {
    /// The flow at a section with the flap deflected \[rad\].
    pub fn deflected<T: Real>(&self, flow: &SectionFlow<T>, deflection: T) -> SectionFlow<T> {
        match self {
            Self::OfTables => SectionFlow {
                flap: deflection,
                ..*flow
            },
            Self::Plain(plain) => SectionFlow {
                camber: Local::of(flow).gate * flow.tangential * deflection * plain.effectiveness(),
                ..*flow
            },
        }
    }

    /// Moment per length of a plain flap, nose up \[N\]; tables contain theirs.
    pub fn moment<T: Real>(&self, strip: &Strip, flow: &SectionFlow<T>, deflection: T) -> T {
        match self {
            Self::OfTables => T::zero(),
            Self::Plain(plain) => {
                let square = flow.tangential * flow.tangential * Local::of(flow).gate;
                let scale = 0.5 * strip.density * strip.chord * strip.chord;
                square * deflection * (-plain.moment() * scale)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::airfoil::Flow;
    use crate::unsteady::tests::polars::Smooth;
    use crate::unsteady::{Model, Polar, SectionModel};

    const STRIP: Strip = Strip {
        chord: 0.4,
        density: 1.2,
    };

    /// In a steady flow all models have the static coefficients at `atan(tan alpha + tau delta)`,
    /// with the lift normal to the flow, for 400 flows of up to 35 deg: to the relative error of the
    /// rounded speed, (0.01 / 60)^2.
    #[test]
    fn plain_flaps_turn_the_angle_of_attack() {
        let plain = PlainFlap::new(0.3).unwrap();
        let flap = Flap::Plain(plain);
        for word in SectionModel::WORDS {
            let model = SectionModel::of_word(word).unwrap();
            let size = model.states().len();
            for k in 0..400 {
                let part = |factor: f64| (f64::from(k) * factor).fract() - 0.5;
                let (angle, delta) = (1.2 * part(0.754_877_67), 0.5 * part(0.569_840_29));
                let (sin, cos) = angle.sin_cos();
                let rigid = SectionFlow::rigid(60.0 * sin, 60.0 * cos, 0.0, STRIP.chord);
                let flow = flap.deflected(&rigid, delta);
                let (mut states, rates) = (vec![0.0; size], vec![0.0; size]);
                let mut rows = vec![0.0; size];
                model.start(&STRIP, &Smooth, &flow, &mut states).unwrap();
                let force = model.evaluate(&STRIP, &Smooth, &flow, &states, &rates, &mut rows);
                let force = force.unwrap();
                let it = Smooth.coefficients(&Flow {
                    alpha: (angle.tan() + plain.effectiveness() * delta).atan(),
                    mach: 0.0,
                    reynolds: 0.0,
                    flap: 0.0,
                });
                let load = 0.5 * 1.2 * 3600.0 * 0.4;
                let close = |found: f64, expected: f64| (found - expected).abs() < 1e-7 * load;
                assert!(
                    close(force.normal, load * (it.lift * cos + it.drag * sin)),
                    "{word}"
                );
                assert!(
                    close(force.along, load * (it.lift * sin - it.drag * cos)),
                    "{word}"
                );
                assert!(close(force.moment, load * 0.4 * it.moment), "{word}");
                let moment = flap.moment(&STRIP, &rigid, delta);
                let expected = -plain.moment() * delta * cos * cos * load * 0.4;
                assert!((moment - expected).abs() < 1e-12 * load);
            }
        }
    }

    /// In reverse flow, and above 50 deg, a plain flap has no effect; a flap of tables is one more
    /// number of the flow.
    #[test]
    fn flaps_without_effect() {
        let plain = Flap::Plain(PlainFlap::new(0.2).unwrap());
        for degrees in [52.0, 90.0, 150.0, 180.0, -120.0_f64] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let flow = SectionFlow::rigid(60.0 * sin, 60.0 * cos, 0.0, STRIP.chord);
            assert_eq!(plain.deflected(&flow, 0.3), flow);
            assert_eq!(plain.moment(&STRIP, &flow, 0.3), 0.0);
            let of_tables = Flap::OfTables.deflected(&flow, 0.3);
            assert_eq!(of_tables, SectionFlow { flap: 0.3, ..flow });
            assert_eq!(Flap::OfTables.moment(&STRIP, &flow, 0.3), 0.0);
        }
    }
}
