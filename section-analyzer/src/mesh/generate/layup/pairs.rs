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
//!
//! Ahead, if layers meet there, p and q are on one circle in the section (`front.rs`): the way
//! between them goes along both normals through its center, and both points have equal x.

use super::super::super::distance;
use super::super::bisect::bisect;
use super::front::{Circle, Front};
use super::outline::Outline;
use super::stack::Stack;

/// Least cosine of the angle between a pair and a normal.
const LEAST_COSINE: f64 = 0.2;
/// Foremost x at which pairs are used.
pub(super) const FOREMOST: f64 = 0.12;
/// Steps of the search for contacts.
const STEPS: usize = 600;
/// Steps of the search ahead of the foremost x, and in the fan.
const STEPS_AHEAD: [usize; 2] = [200, 24];
/// Part of the depth of the center of a fan that layers which do not meet may fill.
const FULL: f64 = 0.98;
/// Points of each side in the table of x.
const TABLE: usize = 300;
/// Contacts nearer to each other than this part of a cell are one.
pub(super) const JOINED: f64 = 0.5;
/// Contacts shorter than this part of a cell are left out, unless cells fail without them.
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
    /// The circles ahead, if layers meet there, the x of the end of their fan, and those between which
    /// they give way to lines.
    front: Option<(Front, f64, [f64; 2])>,
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
    /// Its circle, and the part that it has of the pair.
    circle: Option<(Circle, f64)>,
    /// Its points and the normals there.
    points: [[f64; 2]; 2],
    normals: [[f64; 2]; 2],
}

impl Pairs {
    /// The pairs ahead of `edges`; with circles ahead, whose nose is the nose of the outline, they go to
    /// the nose.
    pub fn new(outline: &Outline, front: Option<&Front>, edges: [f64; 2]) -> Self {
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
            front: None,
        };
        pairs.lengths = edges.map(|s| pairs.behind(s));
        pairs.front = front.map(|front| {
            let own = |side: usize, s: f64| pairs.behind(s) / pairs.lengths[side];
            let mean = |s: [f64; 2]| 0.5 * (own(0, s[0]) + own(1, s[1]));
            let end = mean(front.fan);
            (front.clone(), end, Front::fade([end, mean(front.last())]))
        });
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
        let own = self.behind(s) / self.lengths[side];
        let Some((front, end, fade)) = &self.front else {
            return own;
        };
        if front.is_fan(side, s) {
            return end * front.part_of_fan(side, s);
        }
        // both points of a circle have the mean of their distances
        let Some(partner) = front.partner(side, s) else {
            return own;
        };
        let other = self.behind(partner) / self.lengths[1 - side];
        let mean = 0.5 * (own + other);
        let part = Front::part(mean, *fade);
        part * mean + (1.0 - part) * own
    }

    /// The x of the end of the fan, if there is one.
    pub fn fan(&self) -> Option<f64> {
        self.front.as_ref().map(|(_, end, _)| *end)
    }

    /// Foremost x at which layers can meet.
    pub fn foremost(&self) -> f64 {
        self.front.as_ref().map_or(FOREMOST, |_| 0.0)
    }

    /// The direction to the center of the fan at an arc length of it, of unit component along the
    /// normal.
    pub fn to_center(&self, side: usize, s: f64) -> Option<[f64; 2]> {
        let (front, ..) = self.front.as_ref()?;
        let is_fan = front.is_fan(side, s);
        is_fan.then(|| {
            let circle = front.circle(&self.outline, front.fan);
            let p = self.outline.position(s);
            toward(circle.center, p, self.outline.inward(s))
        })
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
        let s = s.clamp(s0.min(s1), s0.max(s1));
        if self.front.is_some() && (x - self.x(side, s)).abs() > 1e-12 {
            // the slope changes at the end of the fan
            return bisect([s0, s1], true, |s| self.x(side, s) > x);
        }
        s
    }

    /// Length from the nose to the edges, x = 1.
    pub fn scale(&self) -> f64 {
        0.5 * (self.lengths[0] + self.lengths[1])
    }

    /// The pair at x.
    pub fn pair(&self, x: f64) -> Pair {
        self.between([0, 1].map(|side| self.at(side, x)))
    }

    /// The pair of two points.
    pub fn between(&self, s: [f64; 2]) -> Pair {
        let points = s.map(|s| self.outline.position(s));
        let normals = s.map(|s| self.outline.inward(s));
        let [p, q] = points;
        let length = distance(p, q).max(f64::MIN_POSITIVE);
        let along = [0, 1].map(|i| (q[i] - p[i]) / length);
        let cosine = |side: usize, sign: f64| (sign * dot(along, normals[side])).max(LEAST_COSINE);
        let circle = self.front.as_ref().map(|(front, _, fade)| {
            let part = Front::part(self.x(0, s[0]), *fade);
            (front.circle(&self.outline, s), part)
        });
        // beside a dent of the contour points may have no circle
        let is_one = |circle: &Circle| circle.radii.iter().all(|radius| radius.is_finite());
        Pair {
            s,
            along,
            cosines: [cosine(0, 1.0), cosine(1, -1.0)],
            length,
            circle: circle.filter(|(circle, part)| *part > 0.0 && is_one(circle)),
            points,
            normals,
        }
    }

    /// The x of the kinks of the thicknesses on both sides, behind the foremost x.
    fn kinks(&self, stack: &Stack) -> Vec<f64> {
        let side = |s: f64| usize::from(s > self.outline.nose());
        let kinks = stack.kinks().into_iter();
        let kinks = kinks.map(|kink| self.x(side(kink.s), kink.s));
        kinks.filter(|x| *x > FOREMOST && *x < 1.0).collect()
    }

    /// The x at which it is searched whether layers meet.
    fn searched(&self) -> Vec<f64> {
        let aft = |i: usize| FOREMOST + (1.0 - FOREMOST) * i as f64 / STEPS as f64;
        let end = self.fan().unwrap_or(FOREMOST).min(FOREMOST);
        let ahead = |i: usize| {
            let part = i as f64 / STEPS_AHEAD[0] as f64;
            end + (FOREMOST - end) * part * part
        };
        let ahead = (0..STEPS_AHEAD[0]).filter(|_| end < FOREMOST).map(ahead);
        ahead.chain((0..=STEPS).map(aft)).collect()
    }

    /// Whether layers are too thick for a fan that is open.
    fn fills_fan(&self, stack: &Stack) -> bool {
        let Some(end) = self.fan() else {
            return false;
        };
        let fills = |i: usize| {
            let pair = self.pair(end * i as f64 / STEPS_AHEAD[1] as f64);
            let radii = pair
                .circle
                .map_or([f64::INFINITY; 2], |(circle, _)| circle.radii);
            (0..2).any(|side| stack.total(pair.s[side]) > FULL * radii[side])
        };
        (0..=STEPS_AHEAD[1]).any(fills)
    }

    /// Where the layers meet: intervals of x, foremost first, in which `can_meet` is true of the
    /// pairs. Sides that end without a wall meet at x = 1 in any case if `closed`. Searched `closely`, also at
    /// the ends of ramps, intervals that are short for the cells are among them.
    pub fn contacts(
        &self,
        stack: &Stack,
        size: f64,
        [closed, closely]: [bool; 2],
        can_meet: &dyn Fn(&Pair) -> bool,
    ) -> Vec<[f64; 2]> {
        let meets = |x: f64| {
            let pair = self.pair(x);
            pair.gap(stack) < 0.0 && can_meet(&pair)
        };
        let mut at = self.searched();
        if closely {
            at.extend(self.kinks(stack));
            at.sort_by(f64::total_cmp);
        }
        let mut found: Vec<[f64; 2]> = Vec::new();
        let mut last = meets(at[0]);
        if self.fills_fan(stack) {
            found.push([0.0, at[0]]);
        } else if last {
            found.push([at[0], at[0]]);
        }
        for step in at.windows(2) {
            let next = meets(step[1]);
            if last != next {
                let fork = bisect([step[0], step[1]], last, meets);
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
        let length = self.scale();
        let mut joined: Vec<[f64; 2]> = Vec::new();
        for one in found {
            match joined
                .last_mut()
                .filter(|last| (one[0] - last[1]) * length < JOINED * size)
            {
                Some(last) => last[1] = one[1],
                None => joined.push(one),
            }
        }
        let is_fan = |one: &[f64; 2]| one[0] == 0.0;
        let is_long = |one: &[f64; 2]| (one[1] - one[0]) * length > SHORT * size;
        joined.retain(|one| closely || one[1] >= 1.0 || is_fan(one) || is_long(one));
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
                signs.push(pair.takes_more(side, stack));
            }
            signs
        };
        let steps = ((to - from) * STEPS as f64).ceil().max(1.0) as usize;
        let mut at: Vec<f64> = (0..=steps)
            .map(|i| from + (to - from) * i as f64 / steps as f64)
            .collect();
        if self.front.is_some() {
            at.extend(self.searched().into_iter().filter(|x| *x > from && *x < to));
            at.sort_by(f64::total_cmp);
        }
        let mut cuts = Vec::new();
        let mut last = signs(from);
        for step in at.windows(2) {
            let next = signs(step[1]);
            for k in (0..next.len()).filter(|k| next[*k] != last[*k]) {
                cuts.push(bisect([step[0], step[1]], last[k], |x| signs(x)[k]));
            }
            last = next;
        }
        cuts.sort_by(f64::total_cmp);
        cuts
    }
}

/// The direction from a point to another one, of unit component along the normal there.
fn toward(to: [f64; 2], from: [f64; 2], normal: [f64; 2]) -> [f64; 2] {
    let d = [0, 1].map(|i| to[i] - from[i]);
    let depth = dot(d, normal).max(f64::MIN_POSITIVE);
    d.map(|component| component / depth)
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The length that the first side has of both their halves, if they need these lengths: of its own
/// half, and of the half of the other one that is left.
fn share([a, b]: [f64; 2], halves: [f64; 2]) -> f64 {
    let length = halves[0] + halves[1];
    let gap = length - a - b;
    if gap >= 0.0 {
        a + 0.5 * gap
    } else if a <= halves[0] {
        a
    } else if b <= halves[1] {
        length - b
    } else {
        halves[0]
    }
}

impl Pair {
    /// Length of the line that the layers of a side need.
    pub fn need(&self, side: usize, stack: &Stack) -> f64 {
        stack.total(self.s[side]) / self.cosines[side]
    }

    /// Length of the line, or of both radii of the circle, that the layers leave.
    pub fn gap(&self, stack: &Stack) -> f64 {
        let line = self.length - self.need(0, stack) - self.need(1, stack);
        match &self.circle {
            None => line,
            Some((circle, part)) => {
                let taken: f64 = self.s.iter().map(|s| stack.total(*s)).sum();
                part * (circle.radii[0] + circle.radii[1] - taken) + (1.0 - part) * line
            }
        }
    }

    /// Whether the layers of a side need more than their half.
    fn takes_more(&self, side: usize, stack: &Stack) -> bool {
        match &self.circle {
            Some((circle, part)) if *part > 0.5 => stack.total(self.s[side]) > circle.radii[side],
            _ => self.need(side, stack) > 0.5 * self.length,
        }
    }

    /// Whether its columns are in the fan, and end in its center.
    pub fn is_fan(&self) -> bool {
        self.circle.is_some_and(|(circle, _)| circle.is_fan)
    }

    /// Length of the line that the suction side has.
    fn first(&self, stack: &Stack) -> f64 {
        let needs = [0, 1].map(|side| self.need(side, stack));
        share(needs, [0.5 * self.length; 2])
    }

    /// Distance from the center of the circle at which the columns of both sides end in a contact, along
    /// the normal of the suction side, or of the pressure side if it is negative: this side takes more,
    /// and keeps its normal, so that its columns do not cross; 0 without a circle.
    pub fn shift(&self, stack: &Stack) -> f64 {
        let Some((circle, _)) = self.circle.filter(|(circle, _)| !circle.is_fan) else {
            return 0.0;
        };
        // of the line between both points this part is along the normals
        let cosine = dot(self.along, self.normals[0]) - dot(self.along, self.normals[1]);
        let cosine = (0.5 * cosine).clamp(0.0, 1.0);
        let most = 0.5 * (circle.radii[0] + circle.radii[1]) * cosine * cosine;
        let needs = self.s.map(|s| stack.total(s));
        (share(needs, circle.radii) - circle.radii[0]).clamp(-most, most)
    }

    /// The point at a distance from the center of the circle, as of [`Pair::shift`].
    fn shifted(&self, shift: f64, stack: &Stack, (circle, part): &(Circle, f64)) -> [f64; 2] {
        let normal = self.normals[usize::from(shift < 0.0)];
        let first = self.first(stack);
        let of_line = |i: usize| self.points[0][i] + first * self.along[i];
        let of_circle = |i: usize| circle.center[i] + shift.abs() * normal[i];
        [0, 1].map(|i| part * of_circle(i) + (1.0 - part) * of_line(i))
    }

    /// The direction from a side to the other one in a contact, of unit component along the normal;
    /// beside a contact ahead with the shift at its end, so that columns turn slowly.
    pub fn direction(&self, side: usize, stack: &Stack, shift: Option<f64>) -> [f64; 2] {
        match &self.circle {
            Some(circle) => {
                let shift = shift.unwrap_or_else(|| self.shift(stack));
                let to = self.shifted(shift, stack, circle);
                toward(to, self.points[side], self.normals[side])
            }
            None => {
                let sign = [1.0, -1.0][side] / self.cosines[side];
                self.along.map(|component| sign * component)
            }
        }
    }

    /// Depth of the contact below a side.
    pub fn limit(&self, side: usize, stack: &Stack) -> f64 {
        if let Some(circle) = &self.circle {
            let to = self.shifted(self.shift(stack), stack, circle);
            let d = [0, 1].map(|i| to[i] - self.points[side][i]);
            return dot(d, self.normals[side]);
        }
        let first = self.first(stack);
        let share = if side == 0 {
            first
        } else {
            self.length - first
        };
        share * self.cosines[side]
    }
}
