//! Triangles of a space between fixed boundary nodes.
//!
//! A constrained Delaunay triangulation of the polygon, refined by nodes in the centers of circles
//! of triangles that are too large or have a small angle; the sides of the polygon are not divided.

use spade::{
    AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation,
};

type Point = [f64; 2];

/// Least angle of triangles that do not touch the sides \[deg\].
const LEAST_ANGLE: f64 = 28.0;
/// Largest and least area of triangles that are divided, in squares of the size of cells; 0.43 is
/// an equilateral triangle. Triangles between the shortest sides have more than the least one.
const AREAS: [f64; 2] = [0.5, 1e-6];

/// The triangles of a polygon, counterclockwise: nodes in addition to its corners, at most `most`,
/// and corners of the triangles, numbered through both. `None` if its sides touch each other.
pub(super) fn triangulate(
    polygon: &[Point],
    size: f64,
    most: usize,
) -> Option<(Vec<Point>, Vec<[usize; 3]>)> {
    // coordinates are away from zero, where the triangulation refuses the smallest numbers
    let least = |i: usize| polygon.iter().map(|p| p[i]).fold(f64::INFINITY, f64::min);
    let origin = [least(0) - size, least(1) - size];
    let count = polygon.len();
    let mut space = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
    let mut corners = Vec::with_capacity(count);
    for p in polygon {
        let [x, y] = [0, 1].map(|i| (p[i] - origin[i]) / size);
        corners.push(space.insert(Point2::new(x, y)).ok()?);
    }
    if space.num_vertices() != count {
        return None;
    }
    for i in 0..count {
        let [a, b] = [corners[i], corners[(i + 1) % count]];
        let is_side = space.can_add_constraint(a, b) && space.add_constraint(a, b);
        // a side through another corner becomes two
        if !is_side || !space.exists_constraint(a, b) {
            return None;
        }
    }
    let parameters = RefinementParameters::new()
        .exclude_outer_faces(true)
        .keep_constraint_edges()
        .with_angle_limit(AngleLimit::from_deg(LEAST_ANGLE))
        .with_max_allowed_area(AREAS[0])
        .with_min_required_area(AREAS[1])
        .with_max_additional_vertices(most);
    let mut outside = vec![false; space.num_all_faces()];
    let excluded = space.refine(parameters).excluded_faces;
    outside.resize(space.num_all_faces(), false);
    excluded
        .iter()
        .for_each(|face| outside[face.index()] = true);
    let mut numbers: Vec<Option<usize>> = vec![None; space.num_vertices()];
    for (number, corner) in corners.iter().enumerate() {
        numbers[corner.index()] = Some(number);
    }
    let mut added = Vec::new();
    let mut triangles = Vec::new();
    for face in space.inner_faces().filter(|face| !outside[face.index()]) {
        triangles.push(face.vertices().map(|vertex| {
            *numbers[vertex.index()].get_or_insert_with(|| {
                let p = vertex.position();
                added.push([origin[0] + size * p.x, origin[1] + size * p.y]);
                count + added.len() - 1
            })
        }));
    }
    Some((added, triangles))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::samples::Random;
    use std::collections::HashMap;

    fn area([a, b, c]: [Point; 3]) -> f64 {
        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    }

    /// The least angle of a triangle \[deg\].
    fn least_angle(p: [Point; 3]) -> f64 {
        let angle = |i: usize| {
            let [a, b, c] = [0, 1, 2].map(|k| p[(i + k) % 3]);
            let [u, v] = [b, c].map(|q| [q[0] - a[0], q[1] - a[1]]);
            (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
        };
        (0..3).map(angle).fold(f64::INFINITY, f64::min).to_degrees()
    }

    /// A polygon with sides divided to this length.
    fn divided(corners: &[Point], length: f64) -> Vec<Point> {
        let next = corners.iter().cycle().skip(1);
        let sides = corners.iter().zip(next).flat_map(|(a, b)| {
            let count = ((b[0] - a[0]).hypot(b[1] - a[1]) / length).ceil();
            let at = move |i: usize| {
                let t = i as f64 / count;
                [0, 1].map(|k| a[k] + t * (b[k] - a[k]))
            };
            (0..count as usize).map(at)
        });
        sides.collect()
    }

    /// Checks that triangles between the sides of a polygon cover it with their nodes once; returns
    /// the least angle \[deg\] and the largest area of those that have no node on its sides.
    fn checked(polygon: &[Point]) -> [f64; 2] {
        let (added, triangles) = triangulate(polygon, SIZE, 50_000).expect("triangles");
        let points: Vec<Point> = polygon.iter().copied().chain(added).collect();
        let count = polygon.len();
        // Euler
        assert_eq!(triangles.len(), 2 * points.len() - count - 2);
        let next = polygon.iter().cycle().skip(1);
        let whole = polygon
            .iter()
            .zip(next)
            .map(|(a, b)| area([[0.0; 2], *a, *b]));
        let areas = triangles.iter().map(|nodes| area(nodes.map(|n| points[n])));
        let (whole, found): (f64, f64) = (whole.sum(), areas.sum());
        assert!((found / whole - 1.0).abs() < 1e-12, "{found} {whole}");
        let mut edges: HashMap<[usize; 2], usize> = HashMap::new();
        let mut worst = [f64::INFINITY, 0.0];
        for nodes in &triangles {
            let corners = nodes.map(|n| points[n]);
            assert!(area(corners) > 0.0);
            for side in 0..3 {
                *edges
                    .entry([nodes[side], nodes[(side + 1) % 3]])
                    .or_default() += 1;
            }
            if nodes.iter().all(|node| *node >= count) {
                worst = [
                    worst[0].min(least_angle(corners)),
                    worst[1].max(area(corners)),
                ];
            }
        }
        assert!(edges.values().all(|uses| *uses == 1));
        assert!((0..count).all(|i| edges.contains_key(&[i, (i + 1) % count])));
        worst
    }

    const SIZE: f64 = 0.15;

    /// A square, an L, a disk, and a wedge of 3 degrees with sides of about the size: angles above
    /// 25 degrees (centers near sides are left out, so that the limit is not reached beside the
    /// triangles there) and areas below half a square of the size.
    #[test]
    fn triangles_have_good_shapes() {
        let disk = |i: usize| [(0.1 * i as f64).cos(), (0.1 * i as f64).sin()];
        let disk: Vec<Point> = (0..62).map(disk).collect();
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let l = [
            [0.0, 0.0],
            [2.0, 0.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [0.0, 2.0],
        ];
        let wedge = [[0.0, 0.0], [9.0, -0.25], [9.0, 0.25]];
        for corners in [&square[..], &l, &disk, &wedge] {
            let [angle, area] = checked(&divided(corners, SIZE));
            println!("{angle} {area}");
            assert!(angle > 25.0, "{angle}");
            assert!(area <= AREAS[0] * SIZE * SIZE * (1.0 + 1e-9), "{area}");
        }
    }

    /// Sides of any length: a wedge of 3 degrees, a comb of thin teeth and 60 random stars.
    #[test]
    fn spaces_of_any_shape_are_filled() {
        let mut random = Random(4);
        let mut spaces: Vec<Vec<Point>> =
            vec![vec![[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 0.05]]];
        let teeth = (0..40).map(|i| [f64::from(i), [0.0, 5.0, 5.0, 0.0][i as usize % 4] + 0.1]);
        let mut comb: Vec<Point> = teeth.collect();
        comb.extend([[39.5, -3.0], [-0.5, -3.0]]);
        comb.reverse();
        spaces.push(comb);
        spaces.extend((0..60).map(|_| {
            let at = |i: usize| {
                let (sine, cosine) = (i as f64 * 0.1).sin_cos();
                let radius = 1.2 + random.next();
                [radius * cosine, radius * sine]
            };
            (0..62).map(at).collect()
        }));
        for polygon in spaces {
            checked(&polygon);
        }
    }

    #[test]
    fn sides_that_touch_are_refused() {
        for wrong in [
            vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]],
            vec![[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 0.0], [0.0, 1.0]],
            vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [0.0, 1.0]],
        ] {
            assert_eq!(triangulate(&wrong, 0.3, 1000), None);
        }
    }
}
