//! Forward flight: trims with a voltage twice per revolution, and the vibration at the hub, four times
//! per revolution, over the phase of the voltage.
//!
//! The voltage `V cos(2 psi + phi)` is a sum of two waves, so that to first order in V
//!
//! ```text
//! z(phi) = z_0 + (z(0) - z_0) cos phi + (z(90 deg) - z_0) sin phi
//! ```
//!
//! for the factors z of the cosines and sines of the vibration.

use std::path::Path;

use super::Result;
use super::motion::{Motion, motion};

/// Harmonic of the vibration: the number of blades.
pub const BLADES: usize = 4;
/// Columns of the moments about x and y at the hub.
pub const MOMENTS: [&str; 2] = ["hub_moment_x", "hub_moment_y"];
/// Columns of all vibrations.
const LOADS: [&str; 5] = [
    "hub_moment_x",
    "hub_moment_y",
    "hub_force_x",
    "hub_force_y",
    "hub_force_z",
];

/// A condition of forward flight: advance ratio, voltage \[V\], and phase of the thesis \[deg\].
#[derive(Debug, Clone, Copy)]
pub struct Condition {
    /// Speed over the speed of the tips \[-\].
    pub advance: f64,
    /// Amplitude of the voltage \[V\].
    pub volts: f64,
    /// Phase of the voltage in the thesis, whose zero it does not state \[deg\].
    pub phase: f64,
}

/// The conditions of figures 13.7 to 13.9.
pub const CONDITIONS: [Condition; 3] = [
    Condition {
        advance: 0.2,
        volts: 100.0,
        phase: 131.0,
    },
    Condition {
        advance: 0.25,
        volts: 137.5,
        phase: 128.0,
    },
    Condition {
        advance: 0.3,
        volts: 187.5,
        phase: 127.0,
    },
];

/// The vibration over the phase of a voltage.
#[derive(Debug, Clone, Copy)]
pub struct Vibration {
    /// Factors of cosine and sine, of each load: without voltage, and the changes by the waves of
    /// phase 0 and 90 degrees [lbf ft, lbf].
    parts: [[[f64; 2]; LOADS.len()]; 3],
}

/// Sizes of the vibration at a phase.
#[derive(Debug, Clone, Copy)]
pub struct Sizes {
    /// Of the moment in the plane of the disk, both components together [lbf ft].
    pub moment: f64,
    /// Of the force in this plane, in the same way \[lbf\].
    pub in_plane: f64,
    /// Of the force along the shaft \[lbf\].
    pub vertical: f64,
}

fn waves(of: &Motion) -> [[f64; 2]; LOADS.len()] {
    LOADS.map(|name| of.wave(name, BLADES))
}

fn sizes(waves: &[[f64; 2]; LOADS.len()]) -> Sizes {
    let size = |rows: &[[f64; 2]]| rows.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
    Sizes {
        moment: size(&waves[..2]),
        in_plane: size(&waves[2..4]),
        vertical: size(&waves[4..]),
    }
}

impl Vibration {
    /// From the motions without voltage, and with it at the phases 0 and 90 degrees.
    pub fn of([without, zero, quarter]: [&Motion; 3]) -> Self {
        let base = waves(without);
        let change = |of: &Motion| {
            let with = waves(of);
            std::array::from_fn(|i| [0, 1].map(|k| with[i][k] - base[i][k]))
        };
        Self {
            parts: [base, change(zero), change(quarter)],
        }
    }

    /// Without voltage.
    pub fn without(&self) -> Sizes {
        sizes(&self.parts[0])
    }

    /// To first order at a phase \[deg\].
    pub fn at(&self, phase: f64) -> Sizes {
        self.with(1.0, phase)
    }

    /// To first order with a part of the voltage \[-\] at a phase \[deg\].
    pub fn with(&self, part: f64, phase: f64) -> Sizes {
        let (sin, cos) = phase.to_radians().sin_cos();
        let (sin, cos) = (part * sin, part * cos);
        let [base, zero, quarter] = &self.parts;
        let sum = |i: usize, k: usize| base[i][k] + cos * zero[i][k] + sin * quarter[i][k];
        sizes(&std::array::from_fn(|i| [sum(i, 0), sum(i, 1)]))
    }

    /// The part of the voltage \[-\] and the phase \[deg\] of the smallest moment, by least squares:
    ///
    /// ```text
    /// min |z_0 + (z(0) - z_0) a + (z(90 deg) - z_0) b| ,     a = part cos phi, b = part sin phi
    /// ```
    pub fn optimum(&self) -> [f64; 2] {
        let of_moment = |rows: &[[f64; 2]; LOADS.len()]| [rows[0], rows[1]].concat();
        let [base, zero, quarter] = self.parts.each_ref().map(of_moment);
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let (zz, zq, qq) = (
            product(&zero, &zero),
            product(&zero, &quarter),
            product(&quarter, &quarter),
        );
        let right = [-product(&zero, &base), -product(&quarter, &base)];
        let size = zz * qq - zq * zq;
        let a = (qq * right[0] - zq * right[1]) / size;
        let b = (zz * right[1] - zq * right[0]) / size;
        [a.hypot(b), b.atan2(a).to_degrees().rem_euclid(360.0)]
    }

    /// The whole phase at which the moment is smallest \[deg\].
    pub fn best(&self) -> f64 {
        let phases = (0..360).map(f64::from);
        let size = |phase: &f64| self.at(*phase).moment;
        phases
            .min_by(|a, b| size(a).total_cmp(&size(b)))
            .unwrap_or(0.0)
    }
}

/// Sizes of the vibration of a motion.
pub fn vibration(of: &Motion) -> Sizes {
    sizes(&waves(of))
}

/// The motions of a condition.
#[derive(Debug)]
pub struct Flight {
    /// The condition.
    pub condition: Condition,
    /// Without voltage.
    pub without: Motion,
    /// With the voltage at the best phase.
    pub controlled: Motion,
    /// Over the phase.
    pub vibration: Vibration,
}

/// Further parameters of a model.
type Given<'a> = &'a [(&'a str, f64)];

fn fly(
    case: &Path,
    given: Given<'_>,
    Condition {
        advance,
        volts,
        phase,
    }: Condition,
    from: Option<&Motion>,
) -> Result<Motion> {
    let file = case.join("forward.dynamics.toml");
    let own = [("advance", advance), ("volts", volts), ("phase", phase)];
    let all: Vec<_> = own.into_iter().chain(given.iter().copied()).collect();
    motion(&file, "coupled", &all, from.map(|motion| &motion.state))
}

/// The trim at an advance ratio without voltage, from another trim if one is given; `given` are further
/// parameters.
///
/// # Errors
/// A trim that is not found.
pub fn trimmed(
    case: &Path,
    given: Given<'_>,
    advance: f64,
    from: Option<&Motion>,
) -> Result<Motion> {
    let condition = Condition {
        advance,
        volts: 0.0,
        phase: 0.0,
    };
    fly(case, given, condition, from)
}

/// The trim of a condition without voltage, in the same way, and its vibration over the phase.
///
/// # Errors
/// A trim that is not found.
pub fn over_phase(
    case: &Path,
    given: Given<'_>,
    condition: Condition,
    from: Option<&Motion>,
) -> Result<(Motion, Vibration)> {
    let without = trimmed(case, given, condition.advance, from)?;
    let at = |phase: f64| {
        fly(
            case,
            given,
            Condition { phase, ..condition },
            Some(&without),
        )
    };
    let (zero, quarter) = std::thread::scope(|scope| {
        let quarter = scope.spawn(|| at(90.0));
        let zero = at(0.0);
        (zero, quarter.join())
    });
    let quarter = quarter.unwrap_or_else(|_| Err("a trim ended".to_owned()));
    let vibration = Vibration::of([&without, &zero?, &quarter?]);
    Ok((without, vibration))
}

/// The motions of a condition, in the same way.
///
/// # Errors
/// A trim that is not found.
pub fn flight(
    case: &Path,
    given: Given<'_>,
    condition: Condition,
    from: Option<&Motion>,
) -> Result<Flight> {
    let (without, vibration) = over_phase(case, given, condition, from)?;
    let best = Condition {
        phase: vibration.best(),
        ..condition
    };
    let controlled = fly(case, given, best, Some(&without))?;
    Ok(Flight {
        condition,
        without,
        controlled,
        vibration,
    })
}
