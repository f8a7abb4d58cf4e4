//! Operating points in balance: pitch for a power, speed of rotation for a torque.

use crate::airfoil::Profile;
use crate::momentum::bracketed_root;
use crate::rotor::blade::RigidRotor;
use crate::rotor::operating::OperatingPoint;
use crate::rotor::performance::Performance;

/// Intervals of the search for a bracket.
const INTERVALS: usize = 24;

/// The result of a search for an operating point.
#[derive(Debug, Clone, PartialEq)]
pub enum BalanceOutcome {
    /// The operating point, with its performance.
    Found(Box<Performance>),
    /// No bracket between the limits: the excess of power \[W\] or torque \[N m\] at both.
    NotBracketed {
        /// Excess at the lower limit, in the unit of the balance \[-\].
        low: f64,
        /// Excess at the upper limit, in the unit of the balance \[-\].
        high: f64,
    },
}

impl BalanceOutcome {
    /// The performance, if the point is found.
    pub fn found(&self) -> Option<&Performance> {
        match self {
            Self::Found(performance) => Some(performance),
            Self::NotBracketed { .. } => None,
        }
    }
}

/// The pitch between the limits \[rad\] at which the rotor has a power \[W\]. If there are several,
/// the one at the upper end of the power curve: of turbines the pitch to feather, not to stall.
pub fn pitch_for_power<S: Profile>(
    rotor: &RigidRotor<S>,
    operating: &OperatingPoint,
    power: f64,
    limits: (f64, f64),
) -> BalanceOutcome {
    let at = |pitch: f64| {
        rotor.performance(&OperatingPoint {
            pitch,
            ..*operating
        })
    };
    let excess = |pitch: f64| at(pitch).power - power;
    // from the upper limit down
    let found = first_root(excess, (limits.1, limits.0));
    outcome(found, at)
}

/// The speed of rotation between the limits \[rad/s\] at which the torque of the rotor \[N m\] is
/// `load(omega)`, for example of a generator. If there are several, the largest: it is stable if
/// the load grows faster than the torque.
pub fn balanced_speed<S: Profile>(
    rotor: &RigidRotor<S>,
    operating: &OperatingPoint,
    load: impl Fn(f64) -> f64,
    limits: (f64, f64),
) -> BalanceOutcome {
    let at = |omega: f64| {
        rotor.performance(&OperatingPoint {
            omega,
            ..*operating
        })
    };
    let excess = |omega: f64| at(omega).torque - load(omega);
    let found = first_root(excess, (limits.1, limits.0));
    outcome(found, at)
}

/// The performance at the value found from the upper limit down.
fn outcome(found: Result<f64, (f64, f64)>, at: impl Fn(f64) -> Performance) -> BalanceOutcome {
    match found {
        Ok(value) => BalanceOutcome::Found(Box::new(at(value))),
        Err((high, low)) => BalanceOutcome::NotBracketed { low, high },
    }
}

/// The first root from `start` to `end`, or the values at both.
fn first_root(function: impl Fn(f64) -> f64, (start, end): (f64, f64)) -> Result<f64, (f64, f64)> {
    let first = (start, function(start));
    let mut last = first;
    for interval in 1..=INTERVALS {
        let x = start + (end - start) * interval as f64 / INTERVALS as f64;
        let next = (x, function(x));
        if let Some(root) = bracketed_root(&function, last, next, 1e-10) {
            return Ok(root);
        }
        last = next;
    }
    Err((first.1, last.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_nearest_to_the_start() {
        let cubic = |x: f64| (x - 0.2) * (x - 0.5) * (x - 0.9);
        let found = first_root(cubic, (1.0, 0.0)).expect("a root");
        assert!((found - 0.9).abs() < 1e-9);
        let found = first_root(cubic, (0.0, 1.0)).expect("a root");
        assert!((found - 0.2).abs() < 1e-9);
        assert_eq!(first_root(|x| x + 1.0, (0.0, 1.0)), Err((1.0, 2.0)));
    }
}
