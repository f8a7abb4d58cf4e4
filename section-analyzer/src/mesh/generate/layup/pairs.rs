//! Pairs of points of both sides, and the intervals in which their layers meet.
//!
//! With x the distance from the nose, 0 to 1 at the corner of each side, the points p of
//! the suction side and q of the pressure side at one x are a pair; their layers take
//!
//! ```text
//! a = T_p / cos_p,    b = T_q / cos_q,    g = L - a - b
//! ```
//!
//! of the line between them, of length L, where cos is the cosine of the angle between line and
//! normal. They meet where g < 0, and before a wall only where the layers of a side are thicker
//! than the radius of its inscribed circle (lines between steep sides are no measure): each side owns half of the
//! line, and the rest of the other half that the layers there leave.

use super::super::super::distance;
use super::super::bisect::bisect;
use super::outline::Outline;
use super::stack::Stack;

/// Least cosine of the angle between a pair and a normal.
const LEAST_COSINE: f64 = 0.2;
/// Foremost x at which pairs are used.
pub(super) const FOREMOST: f64 = 0.12;
/// Steps of the search for contacts.
const STEPS: usize = 600;
/// Points of each side in the table of x.
const TABLE: usize = 300;
/// Contacts shorter than this part of a cell are dropped.
const SHORT: f64 = 0.05;

/// Pairs of points of a contour whose sides end at `edges`.
#[derive(Debug, Clone)]
pub(in super::super) struct Pairs {
    outline: Outline,
    edges: [f64; 2],
    aft: [f64; 2],
    nose: [f64; 2],
    /// Distances of the edges from the nose.
    lengths: [f64; 2],
    /// Arc length and x of points of each side, from the edge to the nose.
    table: [Vec<[f64; 2]>; 2],
}

/// A pair.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Pair {
    /// Arc lengths on the suction and the pressure side.
    pub s: [f64; 2],
    /// Unit vector from the suction to the pressure side.
    pub along: [f64; 2],
    /// Cosines of its angles with the normals.
    pub cosines: [f64; 2],
    /// Length of the line.
    pub length: f64,
}

impl Pairs {
    /// The pairs ahead of `edges`.
    pub fn new(outline: &Outline, edges: [f64; 2]) -> Self {
        let (nose, middle) = (outline.position(outline.nose()), outline.middle());
        let chord = distance(nose, middle);
        let aft = [0, 1].map(|i| (middle[i] - nose[i]) / chord);
        let mut pairs = Self {
            outline: outline.clone(),
            edges,
            aft,
            nose,
            lengths: [1.0; 2],
            table: [Vec::new(), Vec::new()],
        };
        pairs.lengths = edges.map(|s| pairs.behind(s));
        pairs.table = [0, 1].map(|side| {
            let (from, to) = (edges[side], outline.nose());
            let s = |i: usize| from + (to - from) * i as f64 / TABLE as f64;
            (0..=TABLE).map(|i| [s(i), pairs.x(side, s(i))]).collect()
        });
        pairs
    }

    /// Distance behind the nose.
    fn behind(&self, s: f64) -> f64 {
        let (nose, p) = (self.nose, self.outline.position(s));
        (p[0] - nose[0]) * self.aft[0] + (p[1] - nose[1]) * self.aft[1]
    }

    /// The x of a point; its side is 0 or 1.
    pub fn x(&self, side: usize, s: f64) -> f64 {
        self.behind(s) / self.lengths[side]
    }

    /// The point of a side at x.
    pub fn at(&self, side: usize, x: f64) -> f64 {
        if x >= 1.0 {
            return self.edges[side];
        }
        let table = &self.table[side];
        let after = table.partition_point(|point| point[1] > x).clamp(1, TABLE);
        let [[s0, x0], [s1, x1]] = [table[after - 1], table[after]];
        let slope = (s1 - s0) / (x1 - x0);
        let mut s = s0 + (x - x0) * slope;
        // the secant of the table is good enough for a simple iteration
        for _ in 0..20 {
            let off = x - self.x(side, s);
            s += off * slope;
            if off.abs() < 1e-14 {
                break;
            }
        }
        s.clamp(s0.min(s1), s0.max(s1))
    }

    /// Length from the nose to the edge of the suction side, x = 1.
    pub fn scale(&self) -> f64 {
        self.lengths[0]
    }

    /// The pair at x.
    pub fn pair(&self, x: f64) -> Pair {
        self.between([0, 1].map(|side| self.at(side, x)))
    }

    /// The pair of two points.
    pub fn between(&self, s: [f64; 2]) -> Pair {
        let [p, q] = s.map(|s| self.outline.position(s));
        let length = distance(p, q).max(f64::MIN_POSITIVE);
        let along = [0, 1].map(|i| (q[i] - p[i]) / length);
        let cosine = |side: usize, sign: f64| {
            let n = self.outline.inward(s[side]);
            (sign * (along[0] * n[0] + along[1] * n[1])).max(LEAST_COSINE)
        };
        Pair {
            s,
            along,
            cosines: [cosine(0, 1.0), cosine(1, -1.0)],
            length,
        }
    }

    /// Where the layers meet: intervals of x, foremost first, in which `can_meet` is true of the
    /// pairs. Sides that end without a wall meet at x = 1 in any case if `closed`.
    pub fn contacts(
        &self,
        stack: &Stack,
        size: f64,
        closed: bool,
        can_meet: &dyn Fn(&Pair) -> bool,
    ) -> Vec<[f64; 2]> {
        let meets = |x: f64| {
            let pair = self.pair(x);
            pair.gap(stack) < 0.0 && can_meet(&pair)
        };
        let at = |i: usize| FOREMOST + (1.0 - FOREMOST) * i as f64 / STEPS as f64;
        let mut found: Vec<[f64; 2]> = Vec::new();
        let mut last = meets(at(0));
        if last {
            found.push([at(0), at(0)]);
        }
        for i in 1..=STEPS {
            let next = meets(at(i));
            if last != next {
                let fork = bisect([at(i - 1), at(i)], last, meets);
                if next {
                    found.push([fork, fork])
                } else {
                    found.last_mut().into_iter().for_each(|one| one[1] = fork)
                }
            }
            last = next;
        }
        if let Some(one) = found.last_mut().filter(|_| last) {
            one[1] = 1.0;
        } else if closed {
            found.push([1.0, 1.0]);
        }
        let length = self.lengths[0];
        let mut joined: Vec<[f64; 2]> = Vec::new();
        for one in found {
            match joined
                .last_mut()
                .filter(|last| (one[0] - last[1]) * length < 0.5 * size)
            {
                Some(last) => last[1] = one[1],
                None => joined.push(one),
            }
        }
        joined.retain(|one| one[1] >= 1.0 || (one[1] - one[0]) * length > SHORT * size);
        joined
    }

    /// Places within a contact at which the share of a side or a layer ends.
    pub fn cuts(&self, stack: &Stack, [from, to]: [f64; 2]) -> Vec<f64> {
        let signs = |x: f64| {
            let pair = self.pair(x);
            let mut signs = Vec::new();
            for side in 0..2 {
                let limit = pair.limit(side, stack);
                let depths = stack.depths(pair.s[side]);
                signs.extend(depths.into_iter().map(|depth| depth > limit * (1.0 + 1e-9)));
                signs.push(pair.need(side, stack) > 0.5 * pair.length);
            }
            signs
        };
        let steps = ((to - from) * STEPS as f64).ceil().max(1.0) as usize;
        let at = |i: usize| from + (to - from) * i as f64 / steps as f64;
        let mut cuts = Vec::new();
        let mut last = signs(at(0));
        for i in 1..=steps {
            let next = signs(at(i));
            for k in (0..next.len()).filter(|k| next[*k] != last[*k]) {
                cuts.push(bisect([at(i - 1), at(i)], last[k], |x| signs(x)[k]));
            }
            last = next;
        }
        cuts
    }
}

impl Pair {
    /// Length of the line that the layers of a side need.
    pub fn need(&self, side: usize, stack: &Stack) -> f64 {
        stack.total(self.s[side]) / self.cosines[side]
    }

    /// Length of the line that the layers leave.
    pub fn gap(&self, stack: &Stack) -> f64 {
        self.length - self.need(0, stack) - self.need(1, stack)
    }

    /// Depth of the contact below a side.
    pub fn limit(&self, side: usize, stack: &Stack) -> f64 {
        let [a, b] = [0, 1].map(|side| self.need(side, stack));
        let gap = self.length - a - b;
        let first = if gap >= 0.0 {
            a + 0.5 * gap
        } else if a <= 0.5 * self.length {
            a
        } else if b <= 0.5 * self.length {
            self.length - b
        } else {
            0.5 * self.length
        };
        let share = if side == 0 {
            first
        } else {
            self.length - first
        };
        share * self.cosines[side]
    }
}
