//! Kaimal spectra [Kaimal1972] and exponential coherence of IEC 61400-1 ed. 3, annex B.2.
//!
//! ```text
//! f S_k(f)/sigma_k^2 = 4 f L_k/V / (1 + 6 f L_k/V)^(5/3)
//! sigma = (1, 0.8, 0.5) sigma_1,   L = (8.1, 2.7, 0.66) Lambda,   Lambda = 0.7 z_hub, at most 42 m
//! Coh(r, f) = exp[-12 sqrt((f r/V)^2 + (0.12 r/L_1)^2)]          (of u)
//! ```

/// The spectra at a hub.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kaimal {
    /// Mean speed at the hub \[m/s\].
    pub speed: f64,
    /// Standard deviation of u \[m/s\].
    pub sigma: f64,
    /// Longitudinal scale of turbulence `Lambda` \[m\].
    pub scale: f64,
}

const RATIOS: [f64; 3] = [1.0, 0.8, 0.5];
const LENGTHS: [f64; 3] = [8.1, 2.7, 0.66];

impl Kaimal {
    /// Standard deviations of u, v, w \[m/s\].
    pub fn sigmas(&self) -> [f64; 3] {
        RATIOS.map(|ratio| ratio * self.sigma)
    }

    /// One-sided spectrum of a component (0, 1, 2 for u, v, w) at a frequency \[Hz\]; its integral
    /// is the variance \[m^2/s\].
    pub fn spectrum(&self, component: usize, frequency: f64) -> f64 {
        let Some((ratio, length)) = RATIOS.get(component).zip(LENGTHS.get(component)) else {
            return 0.0;
        };
        let time = length * self.scale / self.speed;
        let sigma = ratio * self.sigma;
        sigma * sigma * 4.0 * time / (1.0 + 6.0 * frequency * time).powf(5.0 / 3.0)
    }

    /// Coherence of u at two points at a distance \[m\]: the modulus of the cross spectrum over the
    /// spectrum \[-\].
    pub fn coherence(&self, distance: f64, frequency: f64) -> f64 {
        let wave = frequency * distance / self.speed;
        let length = 0.12 * distance / (LENGTHS[0] * self.scale);
        (-12.0 * wave.hypot(length)).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KAIMAL: Kaimal = Kaimal {
        speed: 12.0,
        sigma: 2.0,
        scale: 42.0,
    };

    /// The integral over all frequencies is the variance: `int 4/(1 + 6 x)^(5/3) dx = 1`.
    #[test]
    fn the_spectra_have_their_variances() {
        for c in 0..3 {
            // trapezoid over ln f from 1e-7 Hz; beyond 1e5 Hz the rest is below 1e-4
            let (steps, low, high) = (40_000, 1e-7_f64.ln(), 1e5_f64.ln());
            let h = (high - low) / f64::from(steps);
            let at = |i: i32| {
                let f = (low + h * f64::from(i)).exp();
                f * KAIMAL.spectrum(c, f)
            };
            let sum: f64 = (0..=steps).map(at).sum::<f64>() * h;
            let variance = KAIMAL.sigmas()[c].powi(2);
            assert!((sum / variance - 1.0).abs() < 2e-4, "{c}: {sum} {variance}");
        }
        assert_eq!(KAIMAL.spectrum(3, 1.0), 0.0);
    }

    #[test]
    fn the_coherence_decays() {
        assert_eq!(KAIMAL.coherence(0.0, 1.0), 1.0);
        let expected = (-12.0 * (0.1_f64.powi(2) + (1.44 / 340.2_f64).powi(2)).sqrt()).exp();
        assert!((KAIMAL.coherence(12.0, 0.1) - expected).abs() < 1e-12);
    }
}
