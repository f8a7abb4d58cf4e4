//! Filled polygons on a grid of pixels.
//!
//! The rasterizer of plotters rounds corners to whole pixels and blends the ends of
//! spans with weights that can be negative, which leaves specks of the opposite
//! color along edges. This one fills the pixels whose centers lie inside, so that
//! polygons with a common side neither overlap nor leave a gap.

/// A run of pixels of one row: first, and first behind it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Span {
    pub row: i32,
    pub start: i32,
    pub end: i32,
}

/// Corners of a polygon that is drawn without taking memory.
const FEW: usize = 8;

/// Calls `draw` with the spans of pixels (x from the left, y down; the center of pixel
/// (0, 0) is at (1/2, 1/2)) inside a polygon by the even-odd rule, within `width` by
/// `height`, row by row.
pub(super) fn each_span(corners: &[[f64; 2]], width: u32, height: u32, mut draw: impl FnMut(Span)) {
    if corners.len() < 3 || !corners.as_flattened().iter().all(|value| value.is_finite()) {
        return;
    }
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for corner in corners {
        (low, high) = (low.min(corner[1]), high.max(corner[1]));
    }
    let (first, last) = (first_center(low, height), first_center(high, height));
    // of few corners on the stack: most polygons are pieces of cells
    let (mut few, mut many) = ([0.0; FEW], Vec::new());
    let crossings = match corners.len() {
        ..=FEW => &mut few[..],
        count => {
            many.resize(count, 0.0);
            &mut many[..]
        }
    };
    for row in first..last {
        let y = f64::from(row) + 0.5;
        let mut count = 0;
        let mut a = corners[corners.len() - 1];
        for &b in corners {
            if (a[1] <= y) != (b[1] <= y) {
                // Of both directions of a side the same end comes first, so that
                // neighbors find the same crossing to the last digit.
                let (a, b) = if a[1] < b[1] { (a, b) } else { (b, a) };
                crossings[count] = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                count += 1;
            }
            a = b;
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

/// The first of `count` pixels whose center lies at or behind `place`.
fn first_center(place: f64, count: u32) -> i32 {
    let place = (place - 0.5).clamp(0.0, f64::from(count));
    let whole = place as i32;
    whole + i32::from(f64::from(whole) < place)
}

/// The corners of a line of `width` from `a` to `b`; none for a line without length.
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

/// The corners of a disc, close enough for its size.
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

    /// Fans of triangles about a point part the square: every pixel once.
    #[test]
    fn neighbors_neither_overlap_nor_leave_a_gap() {
        let corners = [[10.0, 10.0], [90.0, 10.0], [90.0, 90.0], [10.0, 90.0]];
        for center in [[50.0, 50.0], [33.3, 61.7], [12.1, 87.9]] {
            let fan = (0..4).map(|k| pixels(&[corners[k], corners[(k + 1) % 4], center]));
            assert_eq!(fan.sum::<usize>(), 80 * 80);
        }
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
