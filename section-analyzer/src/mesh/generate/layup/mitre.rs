//! Mitres at the corners of the contour, also of a base that is a wall.
//!
//! Beside a corner columns lean along the contour, by M at the distance x from it, with e the
//! direction away from the corner:
//!
//! ```text
//! v = n + M e,    M(0) = tan(turn/2)
//! ```
//!
//! Two columns do not cross within the thickness T of the layers on a contour of curvature k if
//!
//! ```text
//! f = q + T dM/dx > 0,    q = 1 - k T (1 + M^2)
//! ```
//!
//! since f is the cross product of the distance of their inner ends and v, per length. The lean
//! fades by `dM/dx = -c q / T`, which leaves the part 1 - c of q; where q is not positive, M grows
//! until f is. On straight sides it fades linearly over `T tan(turn/2) / c`.

use super::outline::Outline;
use super::stack::Stack;

/// Part of the length for columns that the fade of the lean takes, if it is long enough.
const FADE: f64 = 0.4;
/// Largest part of the way to the next corner that the mitres of both take.
pub(super) const MOST_OF_WAY: f64 = 1.0 / 1.1;
/// Steps of the table of the lean in a length `T tan(turn/2)`.
const STEPS: f64 = 40.0;
/// Largest number of steps.
const MOST: usize = 2000;

/// A mitred corner.
#[derive(Debug, Clone)]
pub(super) struct Mitre {
    /// Its arc length.
    pub s: f64,
    /// Tangent of half the turn, positive if the section is convex [-].
    pub tangent: f64,
    /// Length that it takes of the surfaces: `T tan(turn/2)`.
    pub length: f64,
    /// Whether it is at the base.
    pub is_rear: bool,
    /// Whether the normal at the corner itself is the one before it.
    is_last: bool,
    /// Length of the contour.
    perimeter: f64,
    /// The lean before and behind it.
    fades: [Fade; 2],
}

/// The lean over the distance from a corner.
#[derive(Debug, Clone)]
pub(super) struct Fade {
    step: f64,
    /// M at equal steps; 0 at the last one.
    lean: Vec<f64>,
}

/// The mitres of an outline, also of its base if `has_base`.
pub(super) fn mitres(outline: &Outline, stack: &Stack, has_base: bool) -> Vec<Mitre> {
    let ([first, last], tangents) = (outline.corners(), outline.rear_tangents());
    let breaks = outline.breaks().iter();
    let has_rear = !outline.is_smooth();
    let rear = |which: usize| has_rear.then_some(([first, last][which], tangents[which]));
    let breaks = breaks.map(|corner| (corner.s, corner.tangent));
    let corners: Vec<(f64, f64)> = rear(0).into_iter().chain(breaks).chain(rear(1)).collect();
    let perimeter = outline.perimeter();
    let length = |i: usize| stack.total(corners[i].0) * corners[i].1;
    let at = |i: usize| {
        let (s, tangent) = corners[i];
        let count = corners.len();
        let fades = [(i + count - 1) % count, (i + 1) % count];
        let fades = [0, 1].map(|which| {
            let (other, sign) = (fades[which], [-1.0, 1.0][which]);
            let way = (sign * (corners[other].0 - s)).rem_euclid(perimeter);
            // of a single corner all around
            let way = if other == i { perimeter } else { way };
            let [own, others] = [i, other].map(|i| length(i).abs());
            let room = room(way, own, others);
            let at = |x: f64| (s + sign * x).rem_euclid(perimeter);
            let thickness = |x: f64| stack.total(at(x)).max(stack.total(s));
            Fade::new([tangent, length(i)], room, |x| {
                (thickness(x), outline.bend(at(x)))
            })
        });
        Mitre {
            s,
            tangent,
            length: length(i),
            is_rear: has_rear && (i == 0 || i + 1 == count),
            is_last: has_rear && i + 1 == count,
            perimeter,
            fades,
        }
    };
    let all = (0..corners.len()).map(at);
    all.filter(|one| has_base || !one.is_rear).collect()
}

/// The part of the way to the next corner that is of a corner: half of it, or in proportion to the
/// lengths that both take if half is too little for one.
fn room(way: f64, own: f64, other: f64) -> f64 {
    if own.max(other) <= 0.5 * MOST_OF_WAY * way {
        0.5 * way
    } else {
        way * own / (own + other).max(f64::MIN_POSITIVE)
    }
}

impl Fade {
    /// The fade in a `room` of the lean `tangent` of layers that take this length of the surface,
    /// of surfaces with a thickness and a curvature at each distance.
    pub fn new(
        [tangent, length]: [f64; 2],
        room: f64,
        surface: impl Fn(f64) -> (f64, f64),
    ) -> Self {
        let step = length.abs() / STEPS;
        let part = (length.abs() / room.max(f64::MIN_POSITIVE)).max(FADE);
        let mut lean = vec![tangent];
        let steps = (room / step.max(f64::MIN_POSITIVE)).ceil().min(MOST as f64) as usize;
        for i in 0..steps {
            let (last, x) = (lean[i], step * (i as f64 + 0.5));
            let (thickness, bend) = surface(x);
            // leans toward the corner spread when they fade
            let q = if tangent > 0.0 {
                1.0 - bend * thickness * (1.0 + last * last)
            } else {
                1.0
            };
            let rate = if q > 0.0 { part * q } else { (2.0 - part) * q };
            let next = last.abs() - rate * step / thickness.max(1e-9 * step);
            lean.push(next.max(0.0).copysign(tangent));
            if next <= 0.0 {
                break;
            }
        }
        // if the length is too short the rest fades linearly
        let (count, rest) = (lean.len().max(2) - 1, lean[lean.len() - 1]);
        for (i, lean) in lean.iter_mut().enumerate() {
            *lean -= rest * i as f64 / count as f64;
        }
        Self { step, lean }
    }

    /// The lean at a distance; `None` beyond its reach.
    pub fn at(&self, x: f64) -> Option<f64> {
        let place = x / self.step;
        let i = place as usize;
        let [a, b] = [self.lean.get(i)?, self.lean.get(i + 1)?];
        Some(a + (b - a) * (place - i as f64))
    }

    /// Its length.
    fn reach(&self) -> f64 {
        self.step * (self.lean.len() - 1) as f64
    }
}

impl Mitre {
    /// The lean of a column at an arc length, in the direction of the contour; `None` out of its
    /// reach.
    pub fn part(&self, s: f64) -> Option<f64> {
        let turned = s - self.s;
        let x = turned - self.perimeter * (turned / self.perimeter).round();
        if x < 0.0 || (x == 0.0 && self.is_last) {
            self.fades[0].at(-x).map(|lean| -lean)
        } else {
            self.fades[1].at(x)
        }
    }

    /// Length over which the direction fades.
    pub fn reach(&self) -> f64 {
        self.fades[0].reach().max(self.fades[1].reach())
    }
}
