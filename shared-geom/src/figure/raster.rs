//! Filled polygons on a grid of pixels.
//!
//! The rasterizer of plotters rounds corners to whole pixels and blends the ends of
//! spans with weights that can be negative, which leaves specks of the opposite
//! color along edges. This one fills the pixels whose centers are inside, so that
//! polygons with a common side neither overlap nor leave a gap.

/// A run of pixels of one row: the first, and the first after the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Span {
    pub row: i32,
    pub start: i32,
    pub end: i32,
}

/// Maximum number of corners of a polygon that is drawn without allocating.
const FEW: usize = 8;

/// Calls `draw` with the spans of pixels (x from the left, y down; the center of pixel
/// (0, 0) is at (1/2, 1/2)) inside a polygon by the even-odd rule, within `width` by
/// `height`, row by row.
pub(super) fn each_span(corners: &[[f64; 2]], width: u32, height: u32, draw: impl FnMut(Span)) {
    if corners.len() < 3 || !corners.as_flattened().iter().all(|value| value.is_finite()) {
        return;
    }
    // of few corners on the stack: most polygons are pieces of cells
    let size = (width, height);
    if holds_no_center(corners, size) {
        return;
    }
    match corners.len() {
        ..=FEW => {
            let buffers = (&mut [Side::default(); FEW][..], &mut [0.0; FEW][..]);
            each_row(corners, buffers, size, draw);
        }
        n => {
            let buffers = (&mut vec![Side::default(); n][..], &mut vec![0.0; n][..]);
            each_row(corners, buffers, size, draw);
        }
    }
}

/// Whether a polygon lies between the centers of pixels, as small cells do.
pub(super) fn holds_no_center(corners: &[[f64; 2]], (width, height): (u32, u32)) -> bool {
    let (mut low, mut high) = (corners[0], corners[0]);
    for [x, y] in &corners[1..] {
        (low[0], high[0]) = (low[0].min(*x), high[0].max(*x));
        (low[1], high[1]) = (low[1].min(*y), high[1].max(*y));
    }
    first_center(low[1], height) == first_center(high[1], height)
        || first_center(low[0], width) == first_center(high[0], width)
}

fn each_row(
    corners: &[[f64; 2]],
    (sides, crossings): (&mut [Side], &mut [f64]),
    (width, height): (u32, u32),
    mut draw: impl FnMut(Span),
) {
    let sides = &mut sides[..corners.len()];
    let mut a = corners[corners.len() - 1];
    let (mut low, mut high) = (a[1], a[1]);
    for (side, &b) in sides.iter_mut().zip(corners) {
        *side = Side::new(a, b);
        (low, high) = (low.min(b[1]), high.max(b[1]));
        a = b;
    }
    for row in first_center(low, height)..first_center(high, height) {
        let y = f64::from(row) + 0.5;
        let mut count = 0;
        for side in sides.iter().filter(|side| side.low <= y && y < side.high) {
            crossings[count] = side.x + (y - side.low) * side.slope;
            count += 1;
        }
        let found = &mut crossings[..count];
        match found {
            [a, b] if *a <= *b => {}
            _ => found.sort_unstable_by(f64::total_cmp),
        }
        for pair in found.chunks_exact(2) {
            let (start, end) = (first_center(pair[0], width), first_center(pair[1], width));
            if start < end {
                draw(Span { row, start, end });
            }
        }
    }
}

/// Calls `draw` with the spans of pixels inside the region that these straight pieces of its
/// border enclose, in any order, all with the region on the same side.
///
/// The pixels are the same as if each cell of the region is filled alone: borders between two
/// cells of one color need no drawing.
pub(super) fn each_span_within(
    border: &[[[f64; 2]; 2]],
    width: u32,
    height: u32,
    mut draw: impl FnMut(Span),
) {
    let rows = |side: &Side| first_center(side.low, height)..first_center(side.high, height);
    let mut crossings = Vec::with_capacity(2 * border.len());
    for &[a, b] in border {
        if ![a, b].as_flattened().iter().all(|value| value.is_finite()) {
            return;
        }
        let side = Side::new(a, b);
        let turn = if a[1] < b[1] { 1 } else { -1 };
        crossings.extend(rows(&side).map(|row| {
            let y = f64::from(row) + 0.5;
            (row, side.x + (y - side.low) * side.slope, turn)
        }));
    }
    crossings.sort_unstable_by(|(row, x, _), (other, y, _)| row.cmp(other).then(x.total_cmp(y)));
    let mut turns = 0;
    for pair in crossings.windows(2) {
        let [(row, left, turn), (_, right, _)] = [pair[0], pair[1]];
        turns += turn;
        // no crossing is left after the last one of a row
        if turns != 0 {
            let (start, end) = (first_center(left, width), first_center(right, width));
            if start < end {
                draw(Span { row, start, end });
            }
        }
    }
}

/// A side of a polygon, from its upper end.
#[derive(Debug, Clone, Copy, Default)]
struct Side {
    low: f64,
    high: f64,
    /// Position of the upper end.
    x: f64,
    /// Change of position with y.
    slope: f64,
}

impl Side {
    /// The same end comes first for both directions of a side, so that neighbors find exactly
    /// the same crossing.
    fn new(a: [f64; 2], b: [f64; 2]) -> Self {
        let (a, b) = if a[1] < b[1] { (a, b) } else { (b, a) };
        Self {
            low: a[1],
            high: b[1],
            x: a[0],
            slope: (b[0] - a[0]) / (b[1] - a[1]),
        }
    }
}

/// The first of `count` pixels whose center is at or after the position `position`.
fn first_center(position: f64, count: u32) -> i32 {
    let position = (position - 0.5).clamp(0.0, f64::from(count));
    let whole = position as i32;
    whole + i32::from(f64::from(whole) < position)
}

/// The corners of a line of `width` from `a` to `b`; empty for a line without length.
pub(super) fn stroke(a: [f64; 2], b: [f64; 2], width: f64) -> Vec<[f64; 2]> {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx.hypot(dy);
    if !length.is_normal() {
        return Vec::new();
    }
    let (nx, ny) = (-0.5 * width * dy / length, 0.5 * width * dx / length);
    vec![
        [a[0] + nx, a[1] + ny],
        [b[0] + nx, b[1] + ny],
        [b[0] - nx, b[1] - ny],
        [a[0] - nx, a[1] - ny],
    ]
}

/// The corners of a disc, with an accuracy suited to its size.
pub(super) fn disc(center: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let count = (4.0 * radius.max(1.0).sqrt()).ceil().clamp(6.0, 200.0) as u32 * 2;
    let angle = |k: u32| std::f64::consts::TAU * (f64::from(k) + 0.5) / f64::from(count);
    let corner = |k: u32| {
        [
            center[0] + radius * angle(k).cos(),
            center[1] + radius * angle(k).sin(),
        ]
    };
    (0..count).map(corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixels(corners: &[[f64; 2]]) -> usize {
        let mut count = 0;
        each_span(corners, 100, 100, |span| {
            count += (span.end - span.start) as usize;
        });
        count
    }

    #[test]
    fn rectangle_fills_its_pixels_and_is_cut_at_the_edge() {
        let rectangle =
            |x: f64, y: f64, w: f64, h: f64| [[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
        assert_eq!(pixels(&rectangle(2.0, 3.0, 10.0, 7.0)), 70);
        assert_eq!(pixels(&rectangle(-5.0, -5.0, 10.0, 10.0)), 25);
        assert_eq!(pixels(&rectangle(95.0, 95.0, 1e9, 1e9)), 25);
        assert_eq!(pixels(&rectangle(200.0, 0.0, 10.0, 10.0)), 0);
        assert_eq!(pixels(&[[0.0, 0.0], [f64::NAN, 1.0], [5.0, 5.0]]), 0);
    }

    /// Fans of triangles about a point divide the square: every pixel once.
    #[test]
    fn neighbors_neither_overlap_nor_leave_a_gap() {
        let corners = [[10.0, 10.0], [90.0, 10.0], [90.0, 90.0], [10.0, 90.0]];
        for center in [[50.0, 50.0], [33.3, 61.7], [12.1, 87.9]] {
            let fan = (0..4).map(|k| pixels(&[corners[k], corners[(k + 1) % 4], center]));
            assert_eq!(fan.sum::<usize>(), 80 * 80);
        }
    }

    /// Adjacent squares of a board: filled alone, and as one region with a hole, without the
    /// borders between squares.
    #[test]
    fn regions_have_the_pixels_of_their_cells() {
        let at = |i: usize, j: usize| {
            let (i, j) = (i as f64, j as f64);
            [8.3 + 7.1 * i + 0.9 * j, 11.7 + 6.3 * j - 1.3 * i]
        };
        let is_there = |i: usize, j: usize| (i, j) != (3, 4) && i + j != 2;
        let mut one_by_one = Vec::new();
        let mut border: Vec<[[f64; 2]; 2]> = Vec::new();
        for i in 0..8 {
            for j in (0..9).filter(|j| is_there(i, *j)) {
                let square = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                each_span(&square, 100, 100, |span| one_by_one.push(span));
                for k in 0..4 {
                    let side = [square[k], square[(k + 1) % 4]];
                    match border.iter().position(|&[a, b]| [b, a] == side) {
                        Some(known) => drop(border.swap_remove(known)),
                        None => border.push(side),
                    }
                }
            }
        }
        let sorted = |spans: Vec<Span>| {
            let pixels = spans
                .iter()
                .flat_map(|s| (s.start..s.end).map(|x| (s.row, x)));
            let mut pixels: Vec<_> = pixels.collect();
            pixels.sort_unstable();
            pixels
        };
        let mut together = Vec::new();
        each_span_within(&border, 100, 100, |span| together.push(span));
        assert!(together.len() < one_by_one.len() / 3);
        assert_eq!(sorted(together), sorted(one_by_one));
    }

    /// A disc has its area within the pixels of its rim.
    #[test]
    fn disc_and_stroke_have_their_area() {
        let area = pixels(&disc([50.0, 50.0], 30.0)) as f64;
        assert!(
            (area / (std::f64::consts::PI * 900.0) - 1.0).abs() < 0.01,
            "{area}"
        );
        let area = pixels(&stroke([20.0, 20.0], [80.0, 60.0], 5.0)) as f64;
        assert!(
            (area / (5.0 * 60_f64.hypot(40.0)) - 1.0).abs() < 0.05,
            "{area}"
        );
        assert!(stroke([1.0, 1.0], [1.0, 1.0], 5.0).is_empty());
    }
}
