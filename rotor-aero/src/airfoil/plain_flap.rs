//! A plain flap of a thin airfoil: shares of its deflection in the angle of attack and the moment.
//!
//! The mean line has the slope `-delta` behind the hinge at `x = c (1 - E)`, where E is the part of
//! the chord that is the flap. With `x = c/2 (1 - cos theta)`, thin-airfoil theory gives
//!
//! ```text
//! cos theta_h = 2 E - 1
//! A_0 = alpha + delta (pi - theta_h)/pi                 A_n = 2 delta sin(n theta_h)/(n pi)
//! c_l = 2 pi (A_0 + A_1/2) = 2 pi (alpha + tau delta)   tau = 1 - (theta_h - sin theta_h)/pi
//! c_m = -pi/4 (A_1 - A_2) = -mu delta                   mu = sin theta_h (1 - cos theta_h)/2
//! ```
//!
//! with the moment about the quarter chord, nose up. References: [Glauert1927].

use std::f64::consts::PI;

/// A plain flap, whose deflection is positive with the trailing edge down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlainFlap {
    effectiveness: f64,
    moment: f64,
}

impl PlainFlap {
    /// The flap that is a part of the chord behind its hinge \[-\]; `None` unless the part is above
    /// zero and at most one.
    pub fn new(part: f64) -> Option<Self> {
        if !(part > 0.0 && part <= 1.0) {
            return None;
        }
        let hinge = (2.0 * part - 1.0).acos();
        Some(Self {
            effectiveness: 1.0 - (hinge - hinge.sin()) / PI,
            moment: 0.5 * hinge.sin() * (1.0 - hinge.cos()),
        })
    }

    /// Change of the angle of attack over the deflection, tau \[-\].
    pub fn effectiveness(&self) -> f64 {
        self.effectiveness
    }

    /// Change of the moment coefficient about the quarter chord over the deflection, nose down
    /// positive, mu \[1/rad\].
    pub fn moment(&self) -> f64 {
        self.moment
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half of the chord: `tau = 1/2 + 1/pi`, `mu = 1/2`. All of it: the deflection is the angle of
    /// attack. The limit of small flaps is `tau = 4 sqrt(E)/pi`, `mu = 2 sqrt(E)`, to the first order
    /// of E.
    #[test]
    fn special_flaps() {
        let half = PlainFlap::new(0.5).unwrap();
        assert!((half.effectiveness() - (0.5 + 1.0 / PI)).abs() < 1e-15);
        assert!((half.moment() - 0.5).abs() < 1e-15);
        let all = PlainFlap::new(1.0).unwrap();
        assert_eq!([all.effectiveness(), all.moment()], [1.0, 0.0]);
        let part: f64 = 1e-6;
        let small = PlainFlap::new(part).unwrap();
        let root = part.sqrt();
        assert!((small.effectiveness() / (4.0 * root / PI) - 1.0).abs() < 2.0 * part);
        assert!((small.moment() / (2.0 * root) - 1.0).abs() < 2.0 * part);
        for part in [0.0, -0.1, 1.1, f64::NAN] {
            assert_eq!(PlainFlap::new(part), None);
        }
    }

    /// Flat panels with a vortex at their quarter and no flow through their three-quarter points are
    /// another discretization of thin-airfoil theory, exact for flat plates and of first order at a
    /// kink: errors for 20 flaps below the part of a panel, 1/400.
    #[test]
    fn a_chain_of_vortices_has_the_same_lift_and_moment() {
        const PANELS: usize = 400;
        let size = 1.0 / PANELS as f64;
        let point = |i: usize, part: f64| (i as f64 + part) * size;
        // Downwash of a vortex of unit strength ahead of the point: 1/(2 pi (x - x_v)).
        let matrix = nalgebra::DMatrix::from_fn(PANELS, PANELS, |i, j| {
            1.0 / (2.0 * PI * (point(i, 0.75) - point(j, 0.25)))
        });
        let factors = matrix.lu();
        for k in 1..=20 {
            let flapped = k * PANELS / 21;
            let slope = |i: usize| f64::from(u8::from(i >= PANELS - flapped));
            let normal = nalgebra::DVector::from_fn(PANELS, |i, _| slope(i));
            let vortices = factors.solve(&normal).unwrap();
            let lift = 2.0 * vortices.sum();
            let arms = vortices.iter().enumerate();
            let moment: f64 = arms.map(|(i, g)| -2.0 * g * (point(i, 0.25) - 0.25)).sum();
            let flap = PlainFlap::new(flapped as f64 * size).unwrap();
            assert!((lift / (2.0 * PI) - flap.effectiveness()).abs() < size);
            assert!((-moment - flap.moment()).abs() < size, "{k}");
        }
    }

    /// The integrals of thin-airfoil theory by the midpoint rule over the flap, for 300 flaps: error
    /// of the rule `h^2/24` of the slopes' change, below 1e-6.
    #[test]
    fn the_integrals_of_the_mean_line() {
        const POINTS: usize = 2000;
        for k in 1..=300 {
            let part = f64::from(k) / 300.0;
            let hinge = (2.0 * part - 1.0).acos();
            let step = (PI - hinge) / POINTS as f64;
            let sum = |of: &dyn Fn(f64) -> f64| {
                let angle = |i: usize| hinge + (i as f64 + 0.5) * step;
                (0..POINTS).map(|i| of(angle(i)) * step).sum::<f64>()
            };
            let a0 = sum(&|_| 1.0) / PI;
            let [a1, a2] = [1.0, 2.0].map(|n: f64| -2.0 / PI * sum(&|angle| (n * angle).cos()));
            let flap = PlainFlap::new(part).unwrap();
            assert!((a0 + 0.5 * a1 - flap.effectiveness()).abs() < 1e-6);
            assert!((0.25 * PI * (a1 - a2) - flap.moment()).abs() < 1e-6);
        }
    }
}
