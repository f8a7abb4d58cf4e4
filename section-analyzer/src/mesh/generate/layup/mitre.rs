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
pub(in super::super) struct Mitre {
    /// Its arc length.
    pub s: f64,
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
pub(in super::super) struct Fade {
    step: f64,
    /// M at equal steps; 0 at the last one.
    lean: Vec<f64>,
}

/// A corner: its arc length, the tangent of half its turn, and its place at the base if it is there.
type Corner = (f64, f64, Option<usize>);

/// The corners of an outline in their order; a trailing edge without a base has one if its sides
/// `are_joined`.
fn corners(outline: &Outline, are_joined: bool) -> Vec<Corner> {
    let ([first, last], [before, behind]) = (outline.corners(), outline.rear_tangents());
    let breaks = outline.breaks().iter();
    let breaks = breaks.map(|corner| (corner.s, corner.tangent, None));
    let (from, to) = match (outline.is_smooth(), are_joined && outline.base() == 0.0) {
        (true, _) => (None, None),
        (false, true) => (Some((first, outline.rear_tangent(), Some(0))), None),
        (false, false) => (
            Some((first, before, Some(0))),
            Some((last, behind, Some(1))),
        ),
    };
    from.into_iter().chain(breaks).chain(to).collect()
}

/// The mitres of an outline, also of its trailing edge if `has_rear`. Their leans fade before the
/// arc lengths `stops`.
pub(super) fn mitres(
    outline: &Outline,
    stack: &Stack,
    has_rear: bool,
    stops: &[f64],
) -> Vec<Mitre> {
    let corners = corners(outline, has_rear);
    let perimeter = outline.perimeter();
    let count = corners.len();
    let length = |i: usize| stack.total(corners[i].0) * corners[i].1;
    let mitre = |i: usize| {
        let (s, tangent, at_rear) = corners[i];
        let others = [(i + count - 1) % count, (i + 1) % count];
        let fades = [0, 1].map(|which| {
            let (other, sign) = (others[which], [-1.0, 1.0][which]);
            let way_to = |at: f64| (sign * (at - s)).rem_euclid(perimeter);
            // of a single corner all around
            let way = if other == i {
                perimeter
            } else {
                way_to(corners[other].0)
            };
            let nearest = stops.iter().map(|at| way_to(*at)).fold(way, f64::min);
            let others = if nearest < way {
                0.0
            } else {
                length(other).abs()
            };
            let room = room(nearest, length(i).abs(), others);
            let at = |x: f64| (s + sign * x).rem_euclid(perimeter);
            let thickness = |x: f64| stack.total(at(x)).max(stack.total(s));
            Fade::new([tangent, length(i)], room, |x| {
                (thickness(x), outline.bend(at(x)))
            })
        });
        Mitre {
            s,
            length: length(i),
            is_rear: at_rear.is_some(),
            is_last: at_rear == Some(1),
            perimeter,
            fades,
        }
    };
    let all = (0..count).map(mitre);
    all.filter(|one| has_rear || !one.is_rear).collect()
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
        if length == 0.0 {
            return Self {
                step: room,
                lean: vec![0.0; 2],
            };
        }
        // the steps end where the next corner begins
        let steps = (room * STEPS / length.abs()).ceil().clamp(1.0, MOST as f64);
        let step = (room / steps).min(length.abs() / STEPS);
        let part = (length.abs() / room.max(f64::MIN_POSITIVE)).max(FADE);
        let mut lean = vec![tangent];
        for i in 0..steps as usize {
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
