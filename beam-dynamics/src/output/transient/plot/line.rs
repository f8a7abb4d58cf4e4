//! Lines of curves: their strokes, and the reduced points of a long curve.

use shared_geom::figure::{BLACK, CATEGORIES, Color, Stroke, WHITE};

/// Width of a curve \[figure pixels\].
const WIDTH: f64 = 3.5;
/// Colors before dashes begin: without the last one, a yellow that is faint on white.
pub(super) const COLORS: usize = CATEGORIES.len() - 1;
/// Number of runs that tone and dashes can distinguish.
pub(super) const TONES: usize = 4;
/// Color of lines that represent a run, not a column.
const NO_COLUMN: Color = Color(120, 120, 120);

/// Line of one of several columns: colors first, then dashes.
pub(super) fn of_column(number: usize) -> Stroke {
    Stroke::new(WIDTH, CATEGORIES[number % COLORS]).dashed(number / COLORS)
}

/// Line of run `run` of `runs`, distinguished by colors: earlier ones are broader, and the last one is
/// dashed, so that they remain visible below a later run that covers them.
pub(super) fn of_run(run: usize, runs: usize) -> Stroke {
    let above = if runs <= TONES {
        runs - 1 - run.min(runs - 1)
    } else {
        0
    };
    let width = WIDTH + 1.5 * above as f64;
    let is_last = run > 0 && run + 1 == runs && runs <= TONES;
    let stroke = of_column(run);
    Stroke {
        width,
        pattern: if is_last { 1 } else { stroke.pattern },
        ..stroke
    }
}

/// The line of a column for run `run` if colors distinguish the columns: the first run is broad
/// and pale, so that later ones on top of it are visible, and later ones are darker and dashed.
pub(super) fn toned(stroke: Stroke, run: usize) -> Stroke {
    let (part, toward, width, pattern) = match run {
        0 => (0.55, WHITE, 2.4 * WIDTH, 0),
        1 => (0.0, BLACK, 0.8 * WIDTH, 0),
        2 => (0.45, BLACK, WIDTH, 1),
        _ => (0.75, BLACK, WIDTH, 2),
    };
    Stroke {
        color: stroke.color.mixed(toward, part),
        width,
        pattern,
    }
}

/// Line of run `run`, for any column.
pub(super) fn of_tone(run: usize) -> Stroke {
    toned(Stroke::new(WIDTH, NO_COLUMN), run)
}

/// Points of a curve that show all of it if the range `x` is `pixels` wide.
///
/// Over an increasing quantity, these are the first, the least, the largest and the last point of
/// each pixel, so that no peak is lost and no wave appears longer; for a path, the points at a
/// distance of half a pixel from the one before.
pub(super) fn thinned(points: &[[f64; 2]], x: [f64; 2], pixels: f64) -> Vec<[f64; 2]> {
    if points.len() as f64 <= pixels {
        return points.to_vec();
    }
    let scale = pixels / (x[1] - x[0]);
    if points.windows(2).all(|pair| pair[0][0] <= pair[1][0]) {
        let pixel = |point: &[f64; 2]| ((point[0] - x[0]) * scale).floor();
        let parts = points.chunk_by(|a, b| pixel(a) == pixel(b));
        parts.flat_map(extremes).collect()
    } else {
        spaced(points, 0.5 / scale, pixels)
    }
}

/// The first, the least, the largest and the last point, in their order.
fn extremes(part: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    let by_value = |a: &usize, b: &usize| part[*a][1].total_cmp(&part[*b][1]);
    let least = (0..part.len()).min_by(by_value).unwrap_or(0);
    let largest = (0..part.len()).max_by(by_value).unwrap_or(0);
    let mut positions = vec![0, least, largest, part.len() - 1];
    positions.sort_unstable();
    positions.dedup();
    positions.into_iter().map(|position| part[position])
}

/// Points of a path that are `across` from the one before, or the same part of its height.
fn spaced(points: &[[f64; 2]], across: f64, pixels: f64) -> Vec<[f64; 2]> {
    let values = || points.iter().map(|point| point[1]);
    let height = values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min);
    let up = 0.5 * height / pixels;
    let mut kept = vec![points[0]];
    for point in &points[1..] {
        let last = kept[kept.len() - 1];
        if (point[0] - last[0]).abs() >= across || (point[1] - last[1]).abs() >= up {
            kept.push(*point);
        }
    }
    kept.push(points[points.len() - 1]);
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_of_equal_runs_shows_the_others_between_its_dashes() {
        let patterns = |runs| [0, 1, 2, 3].map(|run| of_run(run, runs).pattern);
        assert_eq!(patterns(4), [0, 0, 0, 1]);
        assert_eq!(of_run(0, 1).pattern, 0);
        let widths = [0, 1].map(|run| of_run(run, 2).width);
        assert!(widths[0] > widths[1], "{widths:?}");
    }

    // 20 000 waves on 100 pixels: every pixel shows the whole height, and a single peak
    // stays, where every hundredth point would show neither.
    #[test]
    fn waves_and_peaks_stay_where_points_are_left_out() {
        let points: Vec<_> = (0..400_000)
            .map(|k| {
                let time = f64::from(k);
                let peak = if k == 123_457 { 5.0 } else { 0.0 };
                [time, (0.1 * std::f64::consts::PI * time).sin() + peak]
            })
            .collect();
        let kept = thinned(&points, [0.0, 400_000.0], 100.0);
        assert!(kept.len() <= 400, "{}", kept.len());
        for pixel in kept.chunk_by(|a, b| (a[0] / 4e3).floor() == (b[0] / 4e3).floor()) {
            let low = pixel.iter().map(|point| point[1]).fold(1.0, f64::min);
            let high = pixel.iter().map(|point| point[1]).fold(-1.0, f64::max);
            assert!(low < -0.999 && high > 0.999, "{low} to {high}");
        }
        assert!(kept.iter().any(|point| point[1] > 4.0));
        let gapless = [[0.0, 1.0], [1.0, 2.0]];
        assert_eq!(thinned(&gapless, [0.0, 1.0], 100.0), gapless);
    }

    // A circle run through many times: no part of it is lost, to a pixel.
    #[test]
    fn paths_keep_their_shape() {
        let circle = |k: i32| {
            let angle = 1e-3 * f64::from(k);
            [angle.cos(), angle.sin()]
        };
        let points: Vec<_> = (0..63_000).map(circle).collect();
        let kept = thinned(&points, [-1.0, 1.0], 1000.0);
        assert!(kept.len() < points.len());
        for pair in kept.windows(2) {
            let distance = (pair[0][0] - pair[1][0]).hypot(pair[0][1] - pair[1][1]);
            assert!(distance < 3.0 / 1000.0, "{distance}");
        }
    }
}
