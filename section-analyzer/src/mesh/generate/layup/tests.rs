//! Contour, thicknesses and pairs against closed forms.

use std::f64::consts::{PI, TAU};

use super::outline::Outline;
use super::pairs::Pairs;
use super::stack::Stack;
use super::types::{Layer, LayupSection};

fn circle(count: usize) -> Vec<[f64; 2]> {
    let at = |i: usize| {
        let angle = TAU * i as f64 / count as f64;
        [-angle.cos(), angle.sin()]
    };
    (0..=count).map(at).collect()
}

/// A symmetric wedge with a base, 2 long, from 0.1 to 0.4 high, and a round nose.
fn wedge() -> Vec<[f64; 2]> {
    let part = |i: usize| i as f64 / 100.0;
    let upper = (0..100).map(|i| [2.0 * (part(i) - 1.0), 0.05 + 0.15 * part(i)]);
    let nose = (0..=100).map(|i| {
        let angle = PI * part(i);
        [0.2 * angle.sin(), 0.2 * angle.cos()]
    });
    let lower = (1..=100).map(|i| [-2.0 * part(i), -0.2 + 0.15 * part(i)]);
    upper.chain(nose).chain(lower).collect()
}

fn layer(thickness: f64, from: f64, to: f64) -> Layer {
    Layer {
        name: format!("{thickness} {from}"),
        thickness,
        from,
        to,
        taper: None,
        profile: Vec::new(),
    }
}

/// Length, normal and curvature of a circle; the spline is of the fourth order.
#[test]
fn arcs_of_a_circle() {
    let outline = Outline::new(&circle(200)).expect("a contour");
    assert!(outline.is_smooth());
    assert!((outline.perimeter() / TAU - 1.0).abs() < 1e-8);
    for i in 0..50 {
        let s = outline.perimeter() * (f64::from(i) + 0.3) / 50.0;
        let (p, n) = (outline.position(s), outline.inward(s));
        assert!((p[0] + s.cos()).hypot(p[1] - s.sin()) < 1e-7, "{p:?}");
        assert!((p[0] + n[0]).hypot(p[1] + n[1]) < 1e-5, "{n:?}");
        assert!((outline.bend(s) - 1.0).abs() < 1e-3);
    }
    assert!((outline.nose() - PI).abs() < 1e-3);
}

/// The base counts: arc 0 is in its middle.
#[test]
fn the_base_is_a_part_of_the_contour() {
    let outline = Outline::new(&wedge()).expect("a contour");
    assert!(!outline.is_smooth());
    assert!((outline.base() - 0.1).abs() < 1e-12);
    let exact = 2.0 * 2.0_f64.hypot(0.15) + 0.2 * PI + 0.1;
    assert!((outline.perimeter() / exact - 1.0).abs() < 1e-4);
    for s in [0.0, outline.perimeter()] {
        let p = outline.position(s);
        assert!((p[0] + 2.0).abs() < 1e-12 && p[1].abs() < 1e-12, "{p:?}");
    }
    let corner = outline.position(outline.corners()[0]);
    assert!((corner[0] + 2.0).abs() < 1e-12 && (corner[1] - 0.05).abs() < 1e-12);
    let s = outline.at_y(0, -1.0).expect("a point");
    assert!((outline.position(s)[0] + 1.0).abs() < 1e-9 && s < outline.nose());
}

/// Ramps are centered: the integral of the thickness is thickness times length, also through the
/// trailing edge of a ring, and two layers that abut have a constant sum.
#[test]
fn areas_of_layers_are_exact() {
    let layers = [
        layer(0.01, 0.1, 0.3),
        layer(0.01, 0.3, 0.6),
        layer(0.02, 0.0, 0.05),
    ];
    for is_ring in [true, false] {
        let stack = Stack::new((&layers, None), 10.0, 0.1, (is_ring, [0.0, 10.0], 1.0));
        let exact = [0.02, 0.03, 0.01];
        for (index, exact) in exact.into_iter().enumerate() {
            let count = 100_000;
            let at = |i: usize| stack.thickness(index, 10.0 * (i as f64 + 0.5) / count as f64);
            let area: f64 = (0..count).map(at).sum::<f64>() * 10.0 / count as f64;
            // a layer is absent below 3 % of its thickness: 1e-3 of these ramps
            assert!((area / exact - 1.0).abs() < 1e-3, "{index}: {area}");
        }
        for i in 0..20 {
            let s = 2.8 + 0.02 * f64::from(i);
            assert!((stack.total(s) - 0.01).abs() < 4e-4, "{s}");
        }
    }
}

/// In a symmetric wedge pairs lie opposite to each other, and the layers of both sides meet
/// where the height is the sum of their thicknesses.
#[test]
fn sides_meet_where_the_layers_fill_the_height() {
    let outline = Outline::new(&wedge()).expect("a contour");
    let pairs = Pairs::new(&outline, None, outline.corners());
    for i in 1..10 {
        let x = 0.2 + 0.08 * f64::from(i);
        let pair = pairs.pair(x);
        let [p, q] = pair.s.map(|s| outline.position(s));
        assert!(
            (p[0] - q[0]).abs() < 1e-6 && (p[1] + q[1]).abs() < 1e-6,
            "{x}"
        );
        assert!((pairs.x(0, pair.s[0]) - x).abs() < 1e-9);
    }
    let stack = Stack::new(
        (&[layer(0.1, 0.0, 1.0)], None),
        outline.perimeter(),
        0.05,
        (false, outline.corners(), 0.0),
    );
    let contacts = pairs.contacts(&stack, 0.05, [true, false], &|_| true);
    assert_eq!(contacts.len(), 1, "{contacts:?}");
    // height 0.4 to 0.1 over 2: 0.2 / cos at this distance behind the shoulder
    let cosine = 2.0 / 2.0_f64.hypot(0.15);
    let behind = 2.0 * (0.4 - 0.2 / cosine) / 0.3;
    let exact = (behind + 0.2) / 2.2;
    assert!(
        (contacts[0][0] - exact).abs() < 1e-4,
        "{contacts:?} {exact}"
    );
    assert!((contacts[0][1] - 1.0).abs() < 1e-12);
}

/// A box 2 by 1 with a wall of 0.05, whose points begin in the middle of a side, and with a corner
/// of 30 degrees and 1 at the foremost side: the area is exact for straight faces,
///
/// ```text
/// t P - t^2 sum tan(turn/2)
/// ```
#[test]
fn closed_contours_may_begin_anywhere() {
    let corners: [[f64; 2]; 5] = [
        [-1.0, 0.5],
        [1.0, 0.5],
        [1.2, 0.0],
        [1.0, -0.5],
        [-1.0, -0.5],
    ];
    let side = |i: usize| [corners[i % 5], corners[(i + 1) % 5]];
    let length = |[a, b]: [[f64; 2]; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
    let angle = |i: usize| {
        let [a, b] = [side(i), side(i + 1)].map(|[a, b]| [b[0] - a[0], b[1] - a[1]]);
        (a[1] * b[0] - a[0] * b[1]).atan2(a[0] * b[0] + a[1] * b[1])
    };
    let thickness: f64 = 0.05;
    let exact = (0..5).map(|i| thickness * length(side(i))).sum::<f64>()
        - (0..5)
            .map(|i| thickness * thickness * (0.5 * angle(i)).tan())
            .sum::<f64>();
    for (start, part) in [(4, 0.5), (4, 0.2), (0, 0.5), (3, 0.7)] {
        let mut points = Vec::new();
        for k in 0..=5 {
            let [a, b] = side(start + k);
            let range = match k {
                0 => part..=1.0,
                5 => 0.0..=part,
                _ => 0.0..=1.0,
            };
            for i in 0..=10 {
                let t = range.start() + (range.end() - range.start()) * f64::from(i) / 10.0;
                points.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
            }
        }
        let section = LayupSection {
            contour: points,
            layers: vec![layer(thickness, 0.0, 1.0)],
            webs: Vec::new(),
            spar: None,
            fills: Vec::new(),
            size: None,
        };
        let made = section.generate();
        let made = made.unwrap_or_else(|problem| panic!("{start} {part}: {problem}"));
        let error = made.areas[0].meshed / exact - 1.0;
        assert!(error.abs() < 1e-9, "{start} {part}: {error:e}");
        assert!((made.areas[0].nominal / exact - 1.0).abs() < 1e-9);
    }
}
