//! Mitres at the corners of the contour that are not at its rear.
//!
//! Columns lean along the contour t, away from the corner,
//!
//! ```text
//! v = n -+ t tan(turn/2) (1 - x/R),
//! ```
//!
//! at the distance x < R from it, before and behind it.

use super::outline::{Corner, Outline};
use super::stack::Stack;

/// Length over which the direction fades behind a mitred corner, in `T tan(turn/2)`.
pub(super) const FADE: f64 = 2.5;

/// A mitred corner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mitre {
    s: f64,
    tangent: f64,
    /// Lengths before and behind it over which the direction fades.
    reach: [f64; 2],
}

/// The mitres at the corners of an outline; each reaches half of the way to the next corner at
/// most.
pub(super) fn mitres(outline: &Outline, stack: &Stack) -> Vec<Mitre> {
    let [first, last] = outline.corners();
    let all = outline.breaks();
    let mitre = |(i, corner): (usize, &Corner)| {
        let before = if i == 0 { first } else { all[i - 1].s };
        let after = all.get(i + 1).map_or(last, |next| next.s);
        let whole = FADE * stack.total(corner.s) * corner.tangent.abs();
        Mitre {
            s: corner.s,
            tangent: corner.tangent,
            reach: [corner.s - before, after - corner.s].map(|room| whole.min(0.5 * room)),
        }
    };
    all.iter().enumerate().map(mitre).collect()
}

impl Mitre {
    /// The lean of a column at an arc length, along the contour; `None` out of its reach.
    pub fn part(&self, s: f64) -> Option<f64> {
        let x = s - self.s;
        let (reach, sign) = match x < 0.0 {
            true => (self.reach[0], -1.0),
            false => (self.reach[1], 1.0),
        };
        let fade = 1.0 - x.abs() / reach;
        (fade > 0.0).then_some(sign * self.tangent * fade)
    }
}
