//! Laws of dampers: linear, curves over the rate, and elastomers.
//!
//! An elastomer has the stiffness K and the loss factor eta at the angular frequency w: its complex
//! stiffness is `K (1 + i eta)` there. Without a static stiffness it is a spring K with a damper
//! `eta K / w`, whose loss grows with the frequency. With the static stiffness k it is a spring k beside
//! a spring k_1 and a damper in series with the relaxation time tau:
//!
//! ```text
//! k + k_1 i w tau / (1 + i w tau) = K (1 + i eta)
//! w tau = (K - k) / (eta K)        k_1 = eta K (1 + (w tau)^2) / (w tau)
//! ```

/// A law of a damper: per radian for angles, per length for distances.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum DamperLaw {
    /// Stiffness and damping \[N m, N m s, or N/m, N s/m\].
    Linear([f64; 2]),
    /// Rates and moments or forces \[rad/s, N m, or m/s, N\].
    Curve(Vec<[f64; 2]>),
    /// A spring, and a spring in series with a damper.
    Relaxing {
        /// Stiffness at rest \[N m, or N/m\].
        rest: f64,
        /// Stiffness of the spring in series \[N m, or N/m\].
        series: f64,
        /// Relaxation time \[s\].
        time: f64,
    },
}

impl DamperLaw {
    /// The law of an elastomer of a stiffness and a loss factor at an angular frequency \[rad/s\], and
    /// of a static stiffness below the stiffness.
    pub fn elastomer(
        [stiffness, loss_factor]: [f64; 2],
        frequency: f64,
        rest: Option<f64>,
    ) -> Self {
        let loss = stiffness * loss_factor;
        let Some(rest) = rest else {
            return Self::Linear([stiffness, loss / frequency]);
        };
        let phase = (stiffness - rest) / loss;
        Self::Relaxing {
            rest,
            series: loss * (1.0 + phase * phase) / phase,
            time: phase / frequency,
        }
    }

    /// The largest stiffness or damping of its springs and dampers, other than of curves
    /// \[N m or N/m, and times s\].
    pub fn stiffest(&self) -> f64 {
        match self {
            Self::Linear([stiffness, damping]) => stiffness.max(*damping),
            Self::Curve(_) => 0.0,
            Self::Relaxing { rest, series, .. } => rest.max(*series),
        }
    }
}
