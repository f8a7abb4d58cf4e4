//! Thicknesses of the layers over the arc length.
//!
//! The thickness of a layer is a trapezoid: constant, with a ramp at each end that is
//! centered on it, so that its area is exact and two layers that abut have a constant
//! total thickness. Layers that end at one place have one ramp.

use super::kinks::{Kink, NEAR};
use super::types::{Layer, Spar};

/// Part of the size of cells within which ends are one place.
const ONE_PLACE: f64 = 0.1;
/// Part of the width of a layer by which its ends move at most when they become one place with
/// others: its area changes by twice this part.
const MOVED: f64 = 1e-3;
/// Least length of a ramp if none is given, in sizes of cells.
const LEAST_RAMP: f64 = 0.15;
/// Least length of any ramp, in sizes of cells and in widths of the layer.
const SHORTEST: [f64; 2] = [1e-3, 0.1];
/// Distance of stations from the end of a ramp, in sizes of cells and in lengths of the ramp: in
/// the middle between both stations the thickness at the end is off by a quarter of the second,
/// and the area of the layer by 0.0005 of the ramp.
const BESIDE: [f64; 2] = [NEAR, 0.06];
/// Least distance of stations, in sizes of cells.
const APART: f64 = 1e-5;
/// Largest part of the width of a layer that one ramp takes.
const PART_OF_WIDTH: f64 = 0.35;
/// Parts of the contour and of the width of a layer within which it reaches the trailing edge.
const AT_EDGE: [f64; 2] = [1e-3, 5e-3];
/// Part of the contour within which ends are one.
const SAME: f64 = 1e-9;
/// Part of its thickness below which a layer is absent.
const ABSENT: f64 = 0.03;

/// The layers of a section.
#[derive(Debug, Clone)]
pub(in super::super) struct Stack {
    courses: Vec<Course>,
    perimeter: f64,
    is_ring: bool,
    /// Arc lengths of the corners of the webs of a spar, the aft web first.
    spar: Vec<[f64; 2]>,
    size: f64,
}

/// A layer over the arc length.
#[derive(Debug, Clone)]
struct Course {
    name: String,
    thickness: f64,
    /// Cells through it.
    cells: usize,
    /// Whether it is inside of a spar.
    is_inside: bool,
    /// Arc lengths and parts of its thickness; none if it has the whole one.
    profile: Vec<[f64; 2]>,
    /// Begin and end of the ramps at its start and its end; `None` at a trailing edge.
    ramps: [Option<[f64; 2]>; 2],
    /// Its width along the contour, and the arc length in its middle.
    width: f64,
    middle: f64,
}

/// An end of a layer.
#[derive(Debug, Clone, Copy)]
struct End {
    layer: usize,
    which: usize,
    at: f64,
    ramp: f64,
    /// Least and largest length of its ramp.
    limits: [f64; 2],
    /// The length by which it may be moved.
    moved: f64,
}

impl Stack {
    /// The layers on a contour of this length. On a `ring` layers run through the
    /// trailing edge, and ramps there are at most `seam` long; else both sides end at
    /// `edges`.
    pub fn new(
        (layers, spar): (&[Layer], Option<&Spar>),
        perimeter: f64,
        size: f64,
        (is_ring, edges, seam): (bool, [f64; 2], f64),
    ) -> Self {
        let course = |(number, layer): (usize, &Layer)| {
            let is_inside = spar.is_some_and(|spar| spar.has(number, layer));
            Course::new(layer, is_inside, [perimeter, size])
        };
        let mut courses: Vec<Course> = layers.iter().enumerate().map(course).collect();
        let mut ends: Vec<End> = Vec::new();
        for (index, layer) in layers.iter().enumerate() {
            let [from, to] = [layer.from, layer.to].map(|arc| arc * perimeter);
            let width = to - from;
            let margin = (AT_EDGE[0] * perimeter).min(AT_EDGE[1] * width);
            let [low, high] = if is_ring { [0.0, perimeter] } else { edges };
            let reaches = [from < low + margin, to > high - margin];
            if reaches == [true; 2] || width <= 0.0 {
                continue;
            }
            let usual = layer.thickness.clamp(LEAST_RAMP * size, size);
            let ramp = layer.taper.unwrap_or(usual);
            for (which, at) in [from, to].into_iter().enumerate() {
                let arc = [layer.from, layer.to][which];
                let at_web = spar.is_some_and(|spar| spar.ends_at(arc));
                let is_sharp = layer.ends_at_zero(which);
                let has_face = reaches[which] && !is_ring;
                if is_sharp || has_face || (at_web && courses[index].is_inside) {
                    continue;
                }
                let seam_at = [0.0, perimeter][which];
                let is_seam = reaches[which];
                let room = match (is_seam, is_ring) {
                    (true, _) => seam,
                    (false, true) => f64::INFINITY,
                    // a ramp that ends at the end of the side
                    (false, false) => 2.0 * (at - edges[0]).min(edges[1] - at),
                };
                let most = room.min(PART_OF_WIDTH * width);
                ends.push(End {
                    layer: index,
                    which,
                    at: if is_seam { seam_at } else { at },
                    ramp,
                    limits: [(SHORTEST[0] * size).min(SHORTEST[1] * width), most],
                    moved: (ONE_PLACE * size).min(MOVED * width).max(SAME * perimeter),
                });
            }
        }
        place(&mut courses, ends, perimeter, size);
        Self {
            courses,
            perimeter,
            is_ring,
            spar: Vec::new(),
            size,
        }
    }

    /// Sets the number of cells through each layer.
    pub fn divide(&mut self, cells: impl Iterator<Item = usize>) {
        for (course, cells) in self.courses.iter_mut().zip(cells) {
            course.cells = cells;
        }
    }

    /// Ends the layers inside of a spar at the corners of its webs, the aft web first.
    pub fn end_inside(&mut self, corners: Vec<[f64; 2]>) {
        self.spar = corners;
    }

    /// Whether an arc length is beyond the webs of the spar.
    pub fn is_beyond(&self, s: f64) -> bool {
        let mut webs = self.spar.iter().enumerate();
        webs.any(|(number, [suction, pressure])| match number {
            0 => s < *suction || s > *pressure,
            _ => s > *suction && s < *pressure,
        })
    }

    /// Whether an arc length is on the other side of a fore web of the spar than a layer.
    fn is_opposite(&self, course: &Course, s: f64) -> bool {
        let fore = self.spar.get(1);
        fore.is_some_and(|[suction, pressure]| {
            let nose = 0.5 * (suction + pressure);
            (s < nose) != (course.middle < nose)
        })
    }

    /// Whether a layer is inside of a spar.
    pub fn is_inside(&self, layer: usize) -> bool {
        self.courses[layer].is_inside
    }

    /// Thickness of the layers before one.
    pub fn before(&self, layer: usize, s: f64) -> f64 {
        (0..layer).map(|layer| self.thickness(layer, s)).sum()
    }

    /// Number of layers.
    pub fn len(&self) -> usize {
        self.courses.len()
    }

    /// Cells through a layer.
    pub fn cells(&self, layer: usize) -> usize {
        self.courses[layer].cells
    }

    /// Number of the cells through the layers before one: its outer level.
    pub fn level(&self, layer: usize) -> usize {
        (0..layer).map(|layer| self.cells(layer)).sum()
    }

    /// Given thickness of a layer.
    pub fn full(&self, layer: usize) -> f64 {
        self.courses[layer].thickness
    }

    /// Thickness of the cells of a layer at an arc length: a thin end has none.
    pub fn thickness(&self, layer: usize, s: f64) -> f64 {
        let given = self.given(layer, s);
        if given < ABSENT * self.courses[layer].thickness {
            0.0
        } else {
            given
        }
    }

    /// Thickness of a layer at an arc length as given.
    fn given(&self, layer: usize, s: f64) -> f64 {
        let course = &self.courses[layer];
        if course.is_inside && (self.is_beyond(s) || self.is_opposite(course, s)) {
            return 0.0;
        }
        let part = if self.is_ring && !course.is_inside {
            let turns = [s, s + self.perimeter, s - self.perimeter];
            turns
                .into_iter()
                .map(|s| course.part(s))
                .fold(0.0, f64::max)
        } else {
            course.part(s)
        };
        part * course.thickness
    }

    /// Depths of the inner faces of the layers at an arc length as given, the outermost first.
    pub fn given_depths(&self, s: f64) -> Vec<f64> {
        let mut depth = 0.0;
        let inner = |layer| {
            depth += self.given(layer, s);
            depth
        };
        (0..self.len()).map(inner).collect()
    }

    /// Depths of the inner faces of the layers at an arc length, the outermost first.
    pub fn depths(&self, s: f64) -> Vec<f64> {
        let mut depth = 0.0;
        let inner = |layer| {
            depth += self.thickness(layer, s);
            depth
        };
        (0..self.len()).map(inner).collect()
    }

    /// Thickness of all layers.
    pub fn total(&self, s: f64) -> f64 {
        (0..self.len()).map(|layer| self.thickness(layer, s)).sum()
    }

    /// Name of a layer.
    pub fn name(&self, layer: usize) -> &str {
        &self.courses[layer].name
    }

    /// Arc lengths at which a layer starts and ends.
    pub fn ends(&self, layer: usize) -> [f64; 2] {
        let Course { middle, width, .. } = &self.courses[layer];
        [middle - 0.5 * width, middle + 0.5 * width]
    }

    /// The thickest layer at an arc length, with all plies of its name, and its thickness.
    pub fn thickest(&self, s: f64) -> (String, f64) {
        let mut all: Vec<(&str, f64)> = Vec::new();
        for layer in 0..self.len() {
            // plies are called LAYER/NUMBER
            let name = self.name(layer).split('/').next().unwrap_or_default();
            let thickness = self.thickness(layer, s);
            match all.iter_mut().find(|known| known.0 == name) {
                Some(known) => known.1 += thickness,
                None => all.push((name, thickness)),
            }
        }
        let thickest = all.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
        thickest.map_or_else(Default::default, |(name, thickness)| {
            (name.to_owned(), thickness)
        })
    }

    /// The outermost layer that is present at an arc length.
    pub fn outermost(&self, s: f64) -> Option<usize> {
        (0..self.len()).find(|layer| self.thickness(*layer, s) > 0.0)
    }

    /// Name of the innermost layer that is present at an arc length.
    pub fn innermost_name(&self, s: f64) -> &str {
        self.name(self.innermost(s).unwrap_or(0))
    }

    /// The innermost layer that is present at an arc length.
    pub fn innermost(&self, s: f64) -> Option<usize> {
        let mut layers = (0..self.len()).rev();
        layers.find(|layer| self.thickness(*layer, s) > 0.0)
    }

    /// Ends of all ramps and corners of profiles, from 0 to the length of the contour, the
    /// nearest to their stations first.
    pub fn kinks(&self) -> Vec<Kink> {
        let all = self.courses.iter();
        let mut kinks: Vec<Kink> = all.flat_map(|course| course.kinks(self.size)).collect();
        if self.is_ring {
            for kink in &mut kinks {
                kink.s = kink.s.rem_euclid(self.perimeter);
            }
        }
        kinks.sort_by(|a, b| a.s.total_cmp(&b.s).then(a.near.total_cmp(&b.near)));
        kinks.dedup_by(|later, first| {
            let is_same = later.s - first.s < SAME * self.perimeter;
            first.near = if is_same {
                first.near.min(later.near)
            } else {
                first.near
            };
            is_same
        });
        // in one order for mirror images
        let off = |kink: &Kink| (kink.s - 0.5 * self.perimeter).abs();
        kinks.sort_by(|a, b| Kink::order((a.near, off(a)), (b.near, off(b))));
        kinks
    }
}

impl Course {
    /// A layer without ramps on a contour of this length, with this size of cells.
    fn new(layer: &Layer, is_inside: bool, [perimeter, size]: [f64; 2]) -> Self {
        Self {
            name: layer.name.clone(),
            thickness: layer.thickness,
            cells: (layer.thickness / (2.0 * size)).ceil().clamp(1.0, 50.0) as usize,
            is_inside,
            profile: profile(layer, perimeter),
            ramps: [None; 2],
            width: (layer.to - layer.from) * perimeter,
            middle: 0.5 * (layer.from + layer.to) * perimeter,
        }
    }

    /// The ends of its ramps and the corners of its profile.
    fn kinks(&self, size: f64) -> Vec<Kink> {
        let kink = |s: f64, length: f64| {
            let near = (BESIDE[0] * size).min(BESIDE[1] * length);
            let near = near.max(APART * size);
            Kink { s, near }
        };
        let ramps = self.ramps.into_iter().flatten();
        let mut all: Vec<Kink> = ramps
            .flat_map(|[low, high]| [low, high].map(|s| kink(s, high - low)))
            .collect();
        let steps = self.profile.windows(2).map(|pair| pair[1][0] - pair[0][0]);
        let shortest = steps.fold(f64::INFINITY, f64::min) * self.width;
        all.extend(self.profile.iter().map(|one| kink(one[0], shortest)));
        all
    }

    /// Part of the thickness at an arc length.
    fn part(&self, s: f64) -> f64 {
        if self.width <= 0.0 {
            return 0.0;
        }
        let up = self.ramps[0].map_or(1.0, |[low, high]| (s - low) / (high - low));
        let down = self.ramps[1].map_or(1.0, |[low, high]| (high - s) / (high - low));
        up.min(down).clamp(0.0, 1.0) * self.profile_at(s)
    }

    fn profile_at(&self, s: f64) -> f64 {
        let after = self.profile.partition_point(|one| one[0] <= s);
        match (
            after.checked_sub(1).map(|i| self.profile[i]),
            self.profile.get(after),
        ) {
            (None, None) => 1.0,
            (Some(end), None) => end[1],
            (None, Some(start)) => start[1],
            (Some([from, a]), Some([to, b])) => a + (b - a) * (s - from) / (to - from),
        }
    }
}

/// The profile of a layer over the arc length.
fn profile(layer: &Layer, perimeter: f64) -> Vec<[f64; 2]> {
    let at = |part: f64| (layer.from + part * (layer.to - layer.from)) * perimeter;
    let profile = layer.profile.iter();
    profile
        .map(|[part, thickness]| [at(*part), *thickness])
        .collect()
}

impl Layer {
    /// Whether its profile is zero at its start (0) or its end (1).
    fn ends_at_zero(&self, which: usize) -> bool {
        let ends = [self.profile.first(), self.profile.last()];
        ends[which].is_some_and(|end| end[1] < ABSENT)
    }
}

/// Groups ends into places, and gives all ends of a place one ramp.
fn place(courses: &mut [Course], mut ends: Vec<End>, perimeter: f64, size: f64) {
    // on a ring both ends of the contour are one place, on its own side each
    let seam = |end: &End| if end.at >= perimeter { 0.0 } else { end.at };
    ends.sort_by(|a, b| seam(a).total_cmp(&seam(b)));
    for group in groups(ends, seam) {
        let mean = group.iter().map(seam).sum::<f64>() / group.len() as f64;
        let of = |value: fn(&End) -> f64| group.iter().map(value);
        let longest = of(|end| end.ramp).fold(0.0, f64::max);
        let least = of(|end| end.limits[0]).fold(f64::INFINITY, f64::min);
        let most = of(|end| end.limits[1]).fold(f64::INFINITY, f64::min);
        // without a base a seam has no length
        let half = (0.5 * longest.max(least).min(most)).max(1e-6 * size);
        for end in group {
            let at = if end.at >= perimeter { perimeter } else { mean };
            courses[end.layer].ramps[end.which] = Some([at - half, at + half]);
        }
    }
}

/// The ends of each place, of ends in the order of their places: of neighbors the nearest ones join
/// first, as long as each end may be moved by the length of the group.
fn groups(ends: Vec<End>, at: impl Fn(&End) -> f64) -> Vec<Vec<End>> {
    let mut groups: Vec<Vec<End>> = ends.into_iter().map(|end| vec![end]).collect();
    let length = |groups: &[Vec<End>], i: usize| {
        let [first, next] = [&groups[i], &groups[i + 1]];
        let length = at(&next[next.len() - 1]) - at(&first[0]);
        let both = || first.iter().chain(next);
        let moved = both().map(|end| end.moved).fold(f64::INFINITY, f64::min);
        (length <= moved).then_some(length)
    };
    loop {
        let near = (1..groups.len()).filter_map(|i| Some((length(&groups, i - 1)?, i)));
        let Some((_, second)) = near.min_by(|a, b| a.0.total_cmp(&b.0)) else {
            return groups;
        };
        let joined = groups.remove(second);
        groups[second - 1].extend(joined);
    }
}
