//! Airfoils of windIO files as contours.

/// Part of the chord, from the trailing edge, within which a base is searched.
const BASE: f64 = 0.03;
/// A turn that is a corner \[rad\]: 40 degrees.
const CORNER: f64 = 0.7;
/// Farthest that points lie outside of the chord, as a part of it.
const OUTSIDE: f64 = 0.05;
/// Fewest points.
const LEAST: usize = 9;

/// The contour of an airfoil, from the trailing edge over the suction side to the nose and back,
/// without the points of a base behind it.
///
/// # Errors
/// Points that are no airfoil: found, expected, and the remedy.
pub(super) fn contour(x: &[f64], y: &[f64]) -> Result<Vec<[f64; 2]>, [String; 3]> {
    let problem = |found: String, expected: &str, help: &str| {
        Err([found, expected.to_owned(), help.to_owned()])
    };
    if x.len() != y.len() || x.len() < LEAST {
        let found = format!("{} values of x and {} of y", x.len(), y.len());
        let help = "the file may have been cut off";
        return problem(found, "as many of both, 9 or more", help);
    }
    let fold = |start: f64, pick: fn(f64, f64) -> f64| x.iter().copied().fold(start, pick);
    let range = [
        fold(f64::INFINITY, f64::min),
        fold(f64::NEG_INFINITY, f64::max),
    ];
    if range[0].abs() > OUTSIDE || (range[1] - 1.0).abs() > OUTSIDE {
        let found = format!("x from {} to {}", range[0], range[1]);
        return problem(
            found,
            "x from 0 to 1",
            "divide the coordinates by the chord",
        );
    }
    if x[0] < 1.0 - OUTSIDE {
        let found = format!("a first point at x = {}", x[0]);
        let help = "begin the points at the trailing edge";
        return problem(found, "the trailing edge, x = 1", help);
    }
    let mut points: Vec<[f64; 2]> = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
    points.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-9);
    let around = points.iter().zip(points.iter().cycle().skip(1));
    let area: f64 = around.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
    if area < 0.0 {
        points.reverse();
    }
    let first = corner(&points);
    points.reverse();
    let last = points.len() - 1 - corner(&points);
    points.reverse();
    if last < first + LEAST {
        let found = format!("corners at points {} and {}", first + 1, last + 1);
        return problem(found, "a smooth contour", "remove the points of the base");
    }
    Ok(points[first..=last].to_vec())
}

/// The last corner near the first point: the first point without one.
fn corner(points: &[[f64; 2]]) -> usize {
    let turn = |i: usize| {
        let [a, b] = [i, i + 1].map(|i| {
            let (from, to) = (points[i - 1], points[i]);
            [to[0] - from[0], to[1] - from[1]]
        });
        let (sine, cosine) = (a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        sine.atan2(cosine).abs()
    };
    let near = (1..points.len() / 3).take_while(|i| points[*i][0] > 1.0 - BASE);
    near.filter(|i| turn(*i) > CORNER).last().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::contour;

    /// An ellipse as thick as a sixth of its length, with `base` points of a flat base at its rear,
    /// where it turns by 55 deg.
    fn points(base: usize) -> [Vec<f64>; 2] {
        let at = |i: usize| {
            let angle = 0.2 + (std::f64::consts::TAU - 0.4) * i as f64 / 80.0;
            [0.5 + 0.5 * angle.cos(), angle.sin() / 12.0]
        };
        let rear = at(0);
        let up = (0..base).map(|i| [rear[0], rear[1] * i as f64 / base as f64]);
        let down = (0..base).map(|i| [rear[0], -rear[1] * (1.0 - (i + 1) as f64 / base as f64)]);
        let all: Vec<[f64; 2]> = up.chain((0..=80).map(at)).chain(down).collect();
        [0, 1].map(|k| all.iter().map(|p| p[k]).collect())
    }

    /// The points of the base are left out, and points in the other order are turned.
    #[test]
    fn a_base_is_left_out() {
        let [x, y] = points(0);
        let plain = contour(&x, &y).unwrap();
        assert_eq!(plain.len(), 81);
        let [x, y] = points(3);
        assert_eq!(contour(&x, &y).unwrap(), plain);
        let [x, y] = [x, y].map(|list| list.into_iter().rev().collect::<Vec<_>>());
        assert_eq!(contour(&x, &y).unwrap(), plain);
    }

    /// A circle has no corner, and stays closed.
    #[test]
    fn a_circle_stays_closed() {
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / 100.0;
        let x: Vec<f64> = (0..=100).map(|i| 0.5 + 0.5 * angle(i).cos()).collect();
        let y: Vec<f64> = (0..=100).map(|i| 0.5 * angle(i).sin()).collect();
        assert_eq!(contour(&x, &y).unwrap().len(), 101);
    }

    #[test]
    fn other_points_are_refused() {
        let [x, y] = points(0);
        let percent: Vec<f64> = x.iter().map(|x| 100.0 * x).collect();
        assert!(contour(&percent, &y).unwrap_err()[2].contains("chord"));
        assert!(contour(&x[1..], &y).unwrap_err()[0].contains("80 values"));
        assert!(contour(&x[30..], &y[30..]).unwrap_err()[2].contains("trailing"));
    }
}
