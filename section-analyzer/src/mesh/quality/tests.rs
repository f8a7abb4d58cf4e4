//! The measures on cells whose values are known, and on both sides of each limit.

use super::*;
use crate::mesh::SectionCell;
use shared_geom::mesh::CellKind;

/// The mesh of one cell with these nodes.
fn one(kind: CellKind, nodes: &[[f64; 2]]) -> SectionMesh {
    SectionMesh {
        nodes: nodes.to_vec(),
        node_tags: (1..=nodes.len() as u64).collect(),
        cells: vec![SectionCell::new(7, kind, 0, |i| i as u32)],
        groups: vec!["skin".into()],
        curves: Vec::new(),
    }
}

fn quadrilateral(nodes: [[f64; 2]; 4]) -> MeshQuality {
    MeshQuality::of(&one(CellKind::Quadrilateral4, &nodes))
}

fn triangle(nodes: [[f64; 2]; 3]) -> MeshQuality {
    MeshQuality::of(&one(CellKind::Triangle3, &nodes))
}

/// A unit square; the middle node of its lower side is moved by (dx, dy).
fn moved_middle(dx: f64, dy: f64) -> MeshQuality {
    let mut nodes = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [0.5, 0.0],
        [1.0, 0.5],
        [0.5, 1.0],
        [0.0, 0.5],
    ];
    nodes[4][0] += dx;
    nodes[4][1] += dy;
    MeshQuality::of(&one(CellKind::Quadrilateral8, &nodes))
}

/// The worst values of the only region; the tolerance is rounding of a few operations.
fn has(quality: &MeshQuality, expected: [f64; 5]) {
    for (found, expected) in quality.regions[0].worst.iter().zip(expected) {
        assert!(
            (found - expected).abs() < 1e-12 * expected.max(1.0),
            "{quality:?}"
        );
    }
}

#[test]
fn square_and_equilateral_triangle_are_perfect() {
    let square = quadrilateral([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    has(&square, [1.0, 1.0, 0.5 * PI, 0.5 * PI, 0.0]);
    let equilateral = triangle([[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]]);
    has(&equilateral, [1.0, 1.0, PI / 3.0, PI / 3.0, 0.0]);
    has(&moved_middle(0.0, 0.0), [1.0, 1.0, 0.5 * PI, 0.5 * PI, 0.0]);
}

/// A trapezoid of sides 2 and 1 at distance 1 has J in the ratio of these sides; its
/// oblique side descends by 45 degrees, its area is 3/2, its longest side 2.
#[test]
fn trapezoid_has_its_closed_forms() {
    let trapezoid = quadrilateral([[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    has(&trapezoid, [0.5, 4.0 / 1.5, 0.25 * PI, 0.75 * PI, 0.0]);
}

/// With the middle node at 1/2 + d along a side the derivative along it varies from
/// 1 - 4 d to 1 + 4 d, at the opposite side it is 1: J is linear between these.
#[test]
fn a_middle_moved_along_its_side_lowers_the_jacobian() {
    let d = 0.15;
    let quality = moved_middle(d, 0.0);
    has(
        &quality,
        [
            (1.0 - 4.0 * d) / (1.0 + 4.0 * d),
            1.0,
            0.5 * PI,
            0.5 * PI,
            d,
        ],
    );
}

/// If it is moved inwards by h, the tangent at the corners is (1, 4 h): the corner angle
/// shrinks by atan(4 h).
#[test]
fn a_middle_moved_across_turns_the_tangents_at_the_corners() {
    let h = 0.1;
    let worst = moved_middle(0.0, h).regions[0].worst;
    assert!((worst[2] - (0.5 * PI - (4.0 * h).atan())).abs() < 1e-12);
    assert!((worst[3] - 0.5 * PI).abs() < 1e-12);
    let worst = moved_middle(0.0, -h).regions[0].worst;
    assert!((worst[3] - (0.5 * PI + (4.0 * h).atan())).abs() < 1e-12);
    assert!((worst[4] - h).abs() < 1e-12);
}

/// The worst value of the first cell as text, if it is poor.
fn complaint(quality: &MeshQuality) -> Option<String> {
    let worst = &quality.worst[0];
    assert_eq!(worst.is_poor, quality.poor() == 1);
    worst.is_poor.then(|| worst.worst.to_string())
}

#[test]
fn limit_of_the_jacobian() {
    // J of a trapezoid is in the ratio of its parallel sides; it is high enough for
    // corners of at most 135 degrees
    let trapezoid = |top: f64| quadrilateral([[-1.0, 0.0], [1.0, 0.0], [top, 1.0], [-top, 1.0]]);
    assert_eq!(complaint(&trapezoid(0.101)), None);
    assert_eq!(
        complaint(&trapezoid(0.08)).unwrap(),
        "least over largest Jacobian 0.08, poor below 0.1"
    );
}

#[test]
fn limit_of_the_aspect_ratio() {
    let strip = |length: f64| quadrilateral([[0.0, 0.0], [length, 0.0], [length, 1.0], [0.0, 1.0]]);
    assert_eq!(complaint(&strip(999.0)), None);
    assert_eq!(
        complaint(&strip(1001.0)).unwrap(),
        "aspect ratio 1001.0, poor above 1000"
    );
}

#[test]
fn limits_of_the_corner_angles() {
    // a narrow isosceles triangle: its aspect ratio stays below 1000
    let narrow = |degrees: f64| {
        let angle = degrees.to_radians();
        triangle([[0.0, 0.0], [1.0, 0.0], [angle.cos(), angle.sin()]])
    };
    assert_eq!(complaint(&narrow(1.01)), None);
    assert_eq!(
        complaint(&narrow(0.94)).unwrap(),
        "corner of 0.9 deg, poor below 1"
    );
    // a kite with one blunt corner; its opposite corner has 90 degrees
    let kite = |degrees: f64| {
        let half = 0.5 * degrees.to_radians();
        let depth = 1.0 / half.tan();
        quadrilateral([[0.0, -1.0], [1.0, 0.0], [0.0, depth], [-1.0, 0.0]])
    };
    let worst = kite(169.5).regions[0].worst;
    assert!((worst[3].to_degrees() - 169.5).abs() < 1e-9);
    assert_eq!(ShapeMeasure::LargestAngle.grade(worst[3]), Grade::Fair);
    let worst = kite(170.5).regions[0].worst;
    assert_eq!(ShapeMeasure::LargestAngle.grade(worst[3]), Grade::Poor);
}

#[test]
fn limit_of_the_middles() {
    assert_eq!(complaint(&moved_middle(0.0, 0.199)), None);
    assert_eq!(
        complaint(&moved_middle(0.0, 0.22)).unwrap(),
        "side middle off by 0.22 of the side, poor above 0.2"
    );
}

/// A corner of 12 degrees is fair, although farther from its limit of 1 degree, with a
/// ratio of 12, than a Jacobian of 1 from 0.1, with a ratio of 10: the cell is named for
/// its corner.
#[test]
fn a_cell_is_named_for_its_worst_grade() {
    let mut values = [1.0, 2.0, 12_f64.to_radians(), 0.5 * PI, 0.0];
    assert_eq!(worst_of(&values).1.measure, ShapeMeasure::SmallestAngle);
    values[2] = 0.5 * PI;
    assert_eq!(worst_of(&values).0, (0, 0.1));
}

#[test]
fn regions_are_counted_apart_and_the_worst_cells_named_in_order() {
    // eight strips of increasing length, alternating between two regions
    let mut mesh = one(CellKind::Quadrilateral4, &[]);
    mesh.groups.push("web".into());
    mesh.cells.clear();
    let lengths = [1.0, 20.0, 1500.0, 5.0, 3000.0, 1200.0, 2.0, 50.0];
    for (i, length) in lengths.into_iter().enumerate() {
        let low = 2.0 * i as f64;
        let corners = [[0.0, 0.0], [length, 0.0], [length, 1.0], [0.0, 1.0]];
        mesh.nodes.extend(corners.map(|[y, z]| [y, low + z]));
        let first = 4 * i as u32;
        let cell = SectionCell::new(10 + i as u64, CellKind::Quadrilateral4, i % 2, |n| {
            first + n as u32
        });
        mesh.cells.push(cell);
    }
    let quality = MeshQuality::of(&mesh);
    assert_eq!(quality.poor(), 3);
    let named: Vec<_> = quality
        .worst
        .iter()
        .map(|cell| (cell.cell, cell.is_poor))
        .collect();
    assert_eq!(
        named,
        [(14, true), (12, true), (15, true), (17, false), (11, false)]
    );
    assert_eq!(quality.worst[0].group, "skin");
    assert_eq!(quality.worst[0].position, [1500.0, 8.5]);
    let [skin, web] = &quality.regions[..] else {
        panic!("{quality:?}")
    };
    let aspect = ShapeMeasure::Aspect as usize;
    assert_eq!(
        (skin.cells, skin.poor, skin.grades[aspect]),
        (4, 2, [2, 0, 2])
    );
    assert_eq!((web.cells, web.poor, web.grades[aspect]), (4, 1, [1, 2, 1]));
    assert!((skin.worst[aspect] - 3000.0).abs() < 1e-9);
    assert!((skin.mean[aspect] - 4503.0 / 4.0).abs() < 1e-9);
    assert_eq!(
        quality.worst_value(ShapeMeasure::Aspect),
        Some(skin.worst[aspect])
    );
}
