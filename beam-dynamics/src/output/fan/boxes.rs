//! Positions for labels that cover nothing: boxes, and obstacles.

/// Distance that labels keep from lines, so that marks on these stay free as well
/// \[figure pixels\].
const CLEARANCE: f64 = 8.0;

/// Cost of covering a line; no label has more lines than this nearby.
const COVERS: usize = 1000;

/// A rectangle parallel to the edges of the canvas \[figure pixels\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Box2 {
    pub low: [f64; 2],
    pub high: [f64; 2],
}

impl Box2 {
    /// The box of a text of `width` in letters of `size` around `center`.
    pub fn around(center: [f64; 2], width: f64, size: f64) -> Self {
        let half = [0.5 * width + 0.2 * size, 0.5 * size];
        Self {
            low: [center[0] - half[0], center[1] - half[1]],
            high: [center[0] + half[0], center[1] + half[1]],
        }
    }

    /// The middle.
    pub fn center(&self) -> [f64; 2] {
        [0, 1].map(|i| 0.5 * (self.low[i] + self.high[i]))
    }

    /// The four corners in order.
    pub fn corners(&self) -> [[f64; 2]; 4] {
        let Self { low, high } = *self;
        [low, [high[0], low[1]], high, [low[0], high[1]]]
    }

    /// The same, reaching to the height `y`.
    pub fn with_height(&self, y: f64) -> Self {
        let mut reaching = *self;
        reaching.low[1] = reaching.low[1].min(y);
        reaching.high[1] = reaching.high[1].max(y);
        reaching
    }

    fn grown(&self, by: f64) -> Self {
        Self {
            low: self.low.map(|x| x - by),
            high: self.high.map(|x| x + by),
        }
    }

    fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|i| self.low[i] < other.high[i] && other.low[i] < self.high[i])
    }

    /// Whether it lies within `other`.
    pub fn is_within(&self, other: &Self) -> bool {
        (0..2).all(|i| other.low[i] <= self.low[i] && self.high[i] <= other.high[i])
    }

    /// Whether the straight line from `a` to `b` passes through it: the part of the
    /// line within both pairs of edges is not empty.
    fn meets(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for i in 0..2 {
            let way = b[i] - a[i];
            if way == 0.0 {
                if a[i] < self.low[i] || a[i] > self.high[i] {
                    return false;
                }
                continue;
            }
            let ends = [(self.low[i] - a[i]) / way, (self.high[i] - a[i]) / way];
            first = first.max(ends[0].min(ends[1]));
            last = last.min(ends[0].max(ends[1]));
        }
        first <= last
    }
}

/// Obstacles for labels.
#[derive(Debug, Clone, Default)]
pub(super) struct Obstacles {
    lines: Vec<[[f64; 2]; 2]>,
    boxes: Vec<Box2>,
}

impl Obstacles {
    /// The line through these points.
    pub fn add_line(&mut self, points: &[[f64; 2]]) {
        self.lines
            .extend(points.windows(2).map(|pair| [pair[0], pair[1]]));
    }

    /// A mark around a point.
    pub fn add_disc(&mut self, [x, y]: [f64; 2], radius: f64) {
        let (low, high) = ([x - radius, y - radius], [x + radius, y + radius]);
        self.boxes.push(Box2 { low, high });
    }

    /// A placed label.
    pub fn add_box(&mut self, taken: Box2) {
        self.boxes.push(taken);
    }

    /// The first of the candidates of least cost.
    pub fn best(&self, candidates: impl IntoIterator<Item = Box2>) -> Option<Box2> {
        candidates
            .into_iter()
            .min_by_key(|position| self.covered(position))
    }

    /// Whether a box covers nothing.
    pub fn is_free(&self, position: &Box2) -> bool {
        self.covered(position) < COVERS
    }

    /// Cost of a box: a covered line costs [`COVERS`], a mark or label ten times that, a line that
    /// is only near costs one.
    pub fn covered(&self, position: &Box2) -> usize {
        let wide = position.grown(CLEARANCE);
        let near = self.lines.iter().filter(|[a, b]| wide.meets(*a, *b));
        let lines = near.map(|[a, b]| if position.meets(*a, *b) { COVERS } else { 1 });
        let boxes = self
            .boxes
            .iter()
            .filter(|other| position.overlaps(other))
            .count();
        lines.sum::<usize>() + 10 * COVERS * boxes
    }
}

/// Ascending positions at least `gap` apart between `low` and `high`, as near as possible to the
/// wanted ones, which ascend.
///
/// Least squares: with `v_i = wanted_i - i gap` this is the ascending sequence nearest to v, found
/// by averaging descending neighbors.
pub(super) fn spread(wanted: &[f64], gap: f64, [low, high]: [f64; 2]) -> Vec<f64> {
    // Sum and number of each run of equal values.
    let mut runs: Vec<(f64, usize)> = Vec::new();
    for (i, position) in wanted.iter().enumerate() {
        let mut run = (position - i as f64 * gap, 1);
        while let Some(before) = runs.pop() {
            if before.0 / before.1 as f64 <= run.0 / run.1 as f64 {
                runs.push(before);
                break;
            }
            run = (run.0 + before.0, run.1 + before.1);
        }
        runs.push(run);
    }
    let last = high - wanted.len().saturating_sub(1) as f64 * gap;
    let values = runs
        .iter()
        .flat_map(|&(sum, count)| vec![sum / count as f64; count]);
    values
        .enumerate()
        .map(|(i, value)| value.min(last).max(low) + i as f64 * gap)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_boxes_are_met_where_they_cross() {
        let unit = Box2 {
            low: [0.0, 0.0],
            high: [1.0, 1.0],
        };
        for (a, b, meets) in [
            ([-1.0, 0.5], [2.0, 0.5], true),
            ([-1.0, 2.0], [2.0, 2.0], false),
            ([-1.0, 0.9], [0.1, 2.0], false),
            ([-1.0, 0.0], [0.1, 1.05], true),
            ([0.2, 0.2], [0.3, 0.3], true),
            ([2.0, 0.5], [3.0, 0.5], false),
            ([0.5, -1.0], [0.5, 3.0], true),
        ] {
            assert_eq!(unit.meets(a, b), meets, "{a:?} {b:?}");
        }
        assert!(unit.overlaps(&Box2 {
            low: [0.9, 0.9],
            high: [3.0, 3.0]
        }));
        assert!(!unit.overlaps(&Box2 {
            low: [1.1, 0.0],
            high: [3.0, 3.0]
        }));
    }

    #[test]
    fn the_first_free_candidate_is_taken() {
        let mut obstacles = Obstacles::default();
        obstacles.add_line(&[[0.0, 0.0], [100.0, 0.0]]);
        obstacles.add_disc([50.0, 50.0], 5.0);
        let at = |y: f64| Box2::around([50.0, y], 20.0, 10.0);
        assert_eq!(
            obstacles.best([at(0.0), at(50.0), at(25.0), at(80.0)]),
            Some(at(25.0))
        );
        assert_eq!(
            obstacles.best([at(50.0), at(0.0), at(10.0)]),
            Some(at(10.0))
        );
        assert_eq!(obstacles.best([]), None);
        assert!(obstacles.is_free(&at(10.0)) && !obstacles.is_free(&at(0.0)));
        assert!(!obstacles.is_free(&at(10.0).with_height(-1.0)));
    }

    // Two positions that are too close move apart about their mean; others stay.
    #[test]
    fn labels_spread_as_little_as_possible() {
        assert_eq!(
            spread(&[10.0, 12.0, 50.0], 10.0, [0.0, 100.0]),
            [6.0, 16.0, 50.0]
        );
        assert_eq!(spread(&[1.0, 2.0], 10.0, [0.0, 100.0]), [0.0, 10.0]);
        assert_eq!(spread(&[99.0, 100.0], 10.0, [0.0, 100.0]), [90.0, 100.0]);
        assert_eq!(spread(&[], 10.0, [0.0, 100.0]), [0.0; 0]);
    }
}
