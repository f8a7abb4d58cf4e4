//! The shift of the inversion: a part of the lowest frequency that is above round-off.
//!
//! The zero eigenvalues of motions without stiffness are double, and round-off splits them: to
//! the frequency (D-284) of the motion, and with a shift to a small part of the shift. A rough
//! computation distinguishes them by their motions from the lowest of the other eigenvalues,
//! for light and heavy bodies alike. If they are close to the shift, the matrix is singular to
//! round-off and gives no eigenvalues, so that the next shift is above them.

use faer::c64;

use super::inverse::Inverse;
use super::round_off::RoundOff;

/// The shift of the inversion, in parts of the lowest frequency.
pub(super) const SHIFT: f64 = 0.3;
/// The shift over the frequency of round-off, at least.
const ABOVE: f64 = 3.0;
/// Frequencies up to this multiple of the frequency of round-off of their motion are treated
/// as zero: round-off adds up over many terms.
const LOST: f64 = 10.0;
/// Part of the shift below which values are round-off of the inversion.
const INVERTED: f64 = 1e-6;
/// Part of the lowest value below which other values are zero, if some are zero.
const BESIDE: f64 = 0.02;
/// Part of the shift below which a value is computed again with a closer shift.
const FAR: f64 = 0.1;
/// Parts of itself in which a value is seen again from a shift beside it, where a split zero
/// has moved toward zero with the shift.
const STAYS: std::ops::Range<f64> = 0.7..1.5;
/// Error of a rough pair, relative, up to which it is one.
const SEEN: f64 = 0.1;
/// Factor to the next shift where a matrix is singular.
const NEXT: f64 = 30.0;
/// Looks at most.
pub(super) const LOOKS: usize = 8;

/// Bounds of the eigenvalues near zero, and the next shift.
#[derive(Debug, Clone, Copy)]
pub(super) struct Search {
    /// Where to look from [1/s].
    pub shift: f64,
    /// The highest frequency of a node [1/s].
    highest: f64,
    /// Magnitude up to which a value is zero in any case [1/s].
    zero: f64,
    /// The largest value that is zero by its motion, with its round-off [1/s].
    rounded: f64,
    /// The lowest that is none [1/s].
    lowest: f64,
    /// One that was seen from far above, and from where [1/s].
    doubted: Option<(f64, f64)>,
}

/// Use of the eigenvalues found from one shift.
pub(super) struct Look {
    /// Whether the shift it was taken from serves.
    pub is_near: bool,
    /// Whether the next shift serves, without a look from there.
    pub is_certain: bool,
}

impl Search {
    /// Begins at a shift below all frequencies.
    pub fn new(shift: f64, highest: f64, zero: f64) -> Self {
        Self {
            shift,
            highest,
            zero,
            rounded: 0.0,
            lowest: highest,
            doubted: None,
        }
    }

    /// The next shift where the matrix at this one is singular.
    pub fn singular(&mut self) {
        self.shift *= NEXT;
    }

    /// Takes a look from the shift, and sets the next one.
    pub fn look(&mut self, inverse: &Inverse, round_off: &RoundOff) -> Look {
        let from = self.shift;
        self.rounded = 0.0;
        let (mut lowest, mut poor) = (None, None);
        for (s, vector) in inverse.coarse() {
            let size = s.norm();
            if size > self.zero.max(INVERTED * from) {
                let product = inverse.product(&vector);
                let own = LOST * round_off.frequency(&product);
                if !(size.is_finite() && own.is_finite()) {
                    continue;
                }
                if size > own {
                    if inverse.error(s, vector.as_ref(), product.as_ref()) <= SEEN {
                        lowest = Some(s);
                        break;
                    }
                    poor = poor.or(Some(s));
                    continue;
                }
                self.rounded = self.rounded.max(own.min(self.highest));
            }
            self.rounded = self.rounded.max(size);
        }
        // A shift among the zeros resolves no other value.
        self.judge(lowest.or(poor.filter(|_| self.rounded < FAR * from)))
    }

    fn judge(&mut self, lowest: Option<c64>) -> Look {
        let from = self.shift;
        let seen = lowest.map_or(self.highest, |s| s.norm());
        if let Some((doubted, above)) = self.doubted.take() {
            let is_confirmed = STAYS.contains(&(seen / doubted)) && self.rounded < from;
            if !is_confirmed {
                (self.shift, self.zero) = (above, self.zero.max(FAR * above));
                return Look {
                    is_near: false,
                    is_certain: false,
                };
            }
        }
        self.lowest = seen;
        self.shift = match lowest {
            None if self.rounded > 0.0 => (NEXT * from.max(self.rounded)).min(SHIFT * seen),
            _ => (SHIFT * seen).max(ABOVE * self.rounded / LOST),
        };
        let is_near = (0.1 * self.shift..10.0 * self.shift).contains(&from);
        if seen < FAR * from {
            self.doubted = Some((seen, from));
        }
        let is_certain = lowest.is_some() && self.doubted.is_none() && self.rounded < from;
        Look {
            is_near,
            is_certain,
        }
    }

    /// Magnitude below which an eigenvalue is zero, and magnitude of the lowest other one [1/s].
    pub fn zero_and_lowest(&self) -> (f64, f64) {
        // The lowest nonzero eigenvalue is known: values far below it are zero.
        let split = if self.rounded > 0.0 {
            BESIDE * self.lowest
        } else {
            0.0
        };
        (self.zero.max(split), self.lowest)
    }
}
