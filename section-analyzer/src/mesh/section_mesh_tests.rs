//! Results of sound meshes, and messages about the others.

use nalgebra::{Rotation3, Vector3};
use shared_geom::error::Explain;
use shared_geom::mesh::{GroupSet, LineKind, Node, PhysicalGroup};

use super::super::generate::{Ellipse, Rectangle, Tube};
use super::super::problem::Inversion;
use super::*;

/// The kind of cell with this number of nodes.
fn kind(nodes: usize) -> CellKind {
    let mut kinds = CellKind::ALL.into_iter();
    kinds.find(|kind| kind.node_count() == nodes).unwrap()
}

/// A mesh of nodes (tags 101, 102, ...) and cells (tags 1, 2, ...; nodes by tag minus
/// 101), all in entity 5 and group "a".
fn mesh(nodes: &[[f64; 2]], cells: &[&[u32]]) -> Mesh {
    let node = |(i, &[x, y]): (usize, &[f64; 2])| Node {
        tag: 101 + i as u64,
        position: Vector3::new(x, y, 0.0),
    };
    let cell = |(i, nodes): (usize, &&[u32])| {
        let mut cell = Cell::new(i as u64 + 1, kind(nodes.len()), 5, |n| nodes[n]);
        cell.groups = 0.into();
        cell
    };
    Mesh {
        nodes: nodes.iter().enumerate().map(node).collect(),
        cells: cells.iter().enumerate().map(cell).collect(),
        groups: vec![group(2, 1, Some("a")), group(2, 2, Some("b"))],
        ..Mesh::default()
    }
}

fn group(dimension: u8, tag: i32, name: Option<&str>) -> PhysicalGroup {
    PhysicalGroup {
        dimension,
        tag,
        name: name.map(String::from),
    }
}

/// Two adjacent unit squares:
///
/// ```text
/// 3---4---5
/// |   |   |
/// 0---1---2
/// ```
const LADDER: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [1.0, 0.0],
    [2.0, 0.0],
    [0.0, 1.0],
    [1.0, 1.0],
    [2.0, 1.0],
];
const LEFT: &[u32] = &[0, 1, 4, 3];
const RIGHT: &[u32] = &[1, 2, 5, 4];

fn accepted(mesh: &Mesh) -> (SectionMesh, MeshReport) {
    let location = SourceLocation::file("test.msh");
    SectionMesh::from_mesh(mesh, 1.0, &location).unwrap_or_else(|problems| panic!("{problems}"))
}

fn refused(mesh: &Mesh) -> Vec<MeshProblem> {
    SectionMesh::checked(mesh, 1.0, DoubledNodes::Error).expect_err("the mesh has a problem")
}

/// The message of the only problem.
fn message(mesh: &Mesh) -> String {
    let problems = refused(mesh);
    assert_eq!(problems.len(), 1, "{problems:?}");
    problems[0].to_string()
}

#[test]
fn a_sound_mesh_comes_out_in_meters_without_unused_nodes() {
    let mut nodes = LADDER.to_vec();
    nodes.insert(0, [9.0, 9.0]);
    let mut mesh = mesh(&nodes, &[&[1, 2, 5, 4], &[2, 3, 6, 5]]);
    mesh.cells[0].groups = 1.into();
    let location = SourceLocation::file("test.msh");
    let (section, report) = SectionMesh::from_mesh(&mesh, 0.5, &location).unwrap();
    assert_eq!(section.nodes, LADDER.map(|p| p.map(|x| 0.5 * x)));
    assert_eq!(section.node_tags, [102, 103, 104, 105, 106, 107]);
    let found: Vec<_> = section.cells.iter().map(|c| (c.tag, c.nodes())).collect();
    assert_eq!(found, [(1, LEFT), (2, RIGHT)]);
    assert_eq!(section.groups, ["a", "b"]);
    assert_eq!([section.cells[0].group, section.cells[1].group], [1, 0]);
    let expected = MeshReport {
        unused_nodes: 1,
        ..MeshReport::default()
    };
    assert_eq!(report, expected);
}

/// ```text
/// 12--13--14--15
/// |   |   |   |
/// 8---9---10--11     squares except at 0 and at 5: their two neighbors touch
/// |   |   |   |      in node 5, and are joined around it
/// 4---5---6---7
///     |   |   |
///     1---2---3
/// ```
#[test]
fn walls_that_touch_in_a_node_are_reported() {
    let nodes: Vec<[f64; 2]> = (0..16)
        .map(|i| [f64::from(i % 4), f64::from(i / 4)])
        .collect();
    let square = |i: u32| [i, i + 1, i + 5, i + 4];
    let whole: Vec<_> = [0, 1, 2, 4, 5, 6, 8, 9, 10].map(square).into();
    let cells = |without: &[usize]| {
        let kept = whole
            .iter()
            .enumerate()
            .filter(|(i, _)| !without.contains(i));
        let kept: Vec<&[u32]> = kept.map(|(_, cell)| &cell[..]).collect();
        accepted(&mesh(&nodes, &kept)).1.pinched_nodes
    };
    assert_eq!(cells(&[0, 4]), [106]);
    // a hole, and no hole
    assert_eq!(cells(&[4]), [0_u64; 0]);
    assert_eq!(cells(&[]), [0_u64; 0]);
}

#[test]
fn groups_are_those_with_cells() {
    let mut mesh = mesh(&LADDER, &[LEFT, RIGHT]);
    mesh.groups[1].name = None;
    mesh.cells[1].groups = 1.into();
    assert_eq!(accepted(&mesh).0.groups, ["a", "2"]);
    mesh.cells[0].groups = GroupSet::default();
    let (section, _) = accepted(&mesh);
    assert_eq!(section.groups, ["2", "no group"]);
    assert_eq!([section.cells[0].group, section.cells[1].group], [1, 0]);
}

#[test]
fn physical_curves_keep_their_lines_and_directions() {
    let mut mesh = mesh(&LADDER, &[LEFT, RIGHT]);
    mesh.groups.push(group(1, 1, Some("rail")));
    mesh.groups.push(group(1, 2, None));
    let lines: [(&[u32], Option<usize>); 4] = [
        (&[4, 3], Some(2)),
        (&[5, 4], Some(2)),
        (&[0, 2, 1], Some(3)),
        (&[0, 1], None),
    ];
    for (tag, (nodes, group)) in (10..).zip(lines) {
        let kind = if nodes.len() == 2 {
            LineKind::Line2
        } else {
            LineKind::Line3
        };
        let mut line = Line::new(tag, kind, 1, |i| nodes[i]);
        line.groups = group.into_iter().collect();
        mesh.lines.push(line);
    }
    let (section, _) = accepted(&mesh);
    let line = |tag, first, second, middle| CurveLine {
        tag,
        first,
        second,
        middle,
    };
    let expected = [
        Curve {
            label: "rail".into(),
            lines: vec![
                line(10, [1.0, 1.0], [0.0, 1.0], None),
                line(11, [2.0, 1.0], [1.0, 1.0], None),
            ],
        },
        Curve {
            label: "2".into(),
            lines: vec![line(12, [0.0, 0.0], [2.0, 0.0], Some([1.0, 0.0]))],
        },
    ];
    assert_eq!(section.curves, expected);
}

#[test]
fn generated_meshes_are_sound_and_so_are_their_mirror_images() {
    for kind in CellKind::ALL {
        let rectangle = Rectangle {
            width: 2.0,
            height: 1.0,
            cells_y: 3,
            cells_z: 2,
            kind,
            name: "section".into(),
        };
        let tube = Tube {
            outer_radius: 1.0,
            thickness: 1e-3,
            cells_around: 5,
            cells_through: 1,
            kind,
            curved: true,
        };
        let ellipse = Ellipse {
            semi_y: 1.0,
            semi_z: 0.1,
            cells: 2,
            kind,
            curved: true,
        };
        let meshes = [rectangle.generate(), tube.generate(), ellipse.generate()];
        for mut mesh in meshes.map(Result::unwrap) {
            let (section, report) = accepted(&mesh);
            assert_eq!(report, MeshReport::default());
            assert_eq!(section.nodes.len(), mesh.nodes.len());

            // seen from the rear, all cells are clockwise: they are reversed
            for node in &mut mesh.nodes {
                node.position.x = -node.position.x;
            }
            let (mirrored, report) = accepted(&mesh);
            assert_eq!(report.reversed_cells, mesh.cells.len());
            let turned = mesh.cells.iter().map(Cell::reversed);
            assert!(
                turned
                    .zip(&mirrored.cells)
                    .all(|(a, b)| a.nodes() == b.nodes())
            );
        }
    }
}

#[test]
fn a_clockwise_surface_beside_another_is_turned_and_counted() {
    let mut mesh = mesh(&LADDER, &[LEFT, &[1, 4, 5, 2]]);
    mesh.cells[1].entity = 6;
    let (section, report) = accepted(&mesh);
    assert_eq!(report.reversed_cells, 1);
    assert_eq!(section.cells[1].nodes(), RIGHT);
}

#[test]
fn a_mesh_needs_cells_and_a_unit() {
    let empty = mesh(&LADDER, &[]);
    let problems = SectionMesh::checked(&empty, f64::NAN, DoubledNodes::Error).unwrap_err();
    let messages: Vec<String> = problems.iter().map(MeshProblem::to_string).collect();
    assert_eq!(
        messages,
        [
            "length of the mesh unit: expected a positive number of meters, found NaN",
            "the mesh has no triangles or quadrilaterals, expected at least one",
        ]
    );
    assert!(problems[1].help().unwrap().contains("physical surface"));
    let astray = mesh(&LADDER, &[LEFT, &[1, 2, 99]]);
    assert_eq!(
        message(&astray),
        "element 2 refers to a node that the mesh does not have"
    );
}

#[test]
fn a_node_out_of_the_plane_is_named() {
    let mut mesh = mesh(&LADDER, &[LEFT, RIGHT]);
    for node in &mut mesh.nodes {
        node.position.z = 3.0;
    }
    mesh.nodes[3].position.z += 1e-9;
    accepted(&mesh);
    mesh.nodes[3].position.z -= 2e-8;
    mesh.nodes[4].position.z += 1e-5;
    assert_eq!(
        message(&mesh),
        "the mesh is not plane: node 105 has z = 3.00001, expected 3 as for most nodes, \
         within 2e-9"
    );
    assert!(
        refused(&mesh)[0]
            .help()
            .unwrap()
            .contains("one plane z = constant")
    );
}

#[test]
fn a_mesh_in_another_coordinate_plane_is_recognized() {
    let mut mesh = mesh(&LADDER, &[LEFT, RIGHT]);
    for node in &mut mesh.nodes {
        let [x, y] = [node.position.x, node.position.y];
        node.position = Vector3::new(0.25, x, y);
    }
    let problems = refused(&mesh);
    assert_eq!(
        problems[0].to_string(),
        "the mesh lies in the plane x = 0.25, expected a plane z = constant"
    );
    let help = problems[0].help().unwrap();
    assert!(
        help.contains("by -120 degrees about the direction (1, 1, 1)"),
        "{help}"
    );
    // in no coordinate plane
    let tilt = Rotation3::from_euler_angles(0.3, 0.4, 0.5);
    for node in &mut mesh.nodes {
        node.position = tilt * node.position;
    }
    let [MeshProblem::OtherPlane { normal, offset }] = refused(&mesh)[..] else {
        panic!("a tilted plane");
    };
    let expected = tilt * Vector3::x();
    assert!((Vector3::from(normal) - expected).norm() < 1e-14);
    assert!((offset - 0.25).abs() < 1e-14, "{offset}");
    // in no plane
    mesh.nodes[4].position.z += 0.1;
    assert!(matches!(refused(&mesh)[..], [MeshProblem::NotPlane { .. }]));
}

#[test]
fn a_cell_that_lists_a_node_twice_is_reported_once() {
    let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    assert_eq!(
        message(&mesh(&nodes, &[&[0, 1, 2, 2]])),
        "cell 1 at (0.75, 0.5) has no inside: it lists node 103 more than once"
    );
    assert_eq!(
        message(&mesh(&nodes, &[&[1, 1, 1, 1]])),
        "cell 1 at (1, 0) has no inside: it lists node 102 more than once"
    );
}

#[test]
fn cells_without_area_and_folded_corners_are_inverted() {
    // the triangle's corners lie on a line
    let nodes = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 1.0]];
    let problems = refused(&mesh(&nodes, &[&[0, 1, 3], &[0, 1, 2]]));
    assert_eq!(
        problems[0].to_string(),
        "cell 2 at (1, 0) has no area: its corners lie on one line, or nearly"
    );
    // corner 2 is pushed through the diagonal between its neighbors
    let nodes = [[0.0, 0.0], [1.0, 0.0], [0.3, 0.3], [0.0, 1.0]];
    assert_eq!(
        message(&mesh(&nodes, &[&[0, 1, 2, 3]])),
        "cell 1 at (0.325, 0.325) is inverted: the corner at node 103 is not less than 180 \
         degrees, or its sides cross"
    );
    // sides 1-2 and 3-0 cross
    let crossed = mesh(&LADDER, &[&[0, 1, 3, 4]]);
    let reason = |problems: &[MeshProblem]| match &problems[0] {
        MeshProblem::InvertedCell { reason, .. } => reason.clone(),
        other => panic!("{other}"),
    };
    assert!(matches!(
        reason(&refused(&crossed)),
        Inversion::Corner { .. } | Inversion::NoArea
    ));
    // two coincident corners
    let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    assert!(matches!(
        reason(&refused(&mesh(&nodes, &[&[0, 1, 2, 3]]))),
        Inversion::Corner { .. }
    ));
}

#[test]
fn a_middle_node_too_far_is_named() {
    // a unit square; the middle node of its lower side is moved, along it and across.
    // With the node at x = 1/2 + d the Jacobian at a corner is proportional to 1 - 4 d:
    // it vanishes at the quarter point
    let nodes = |x: f64, y: f64| {
        [
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
            [x, y],
            [1.0, 0.5],
            [0.5, 1.0],
            [0.0, 0.5],
        ]
    };
    let cell: &[u32] = &[0, 1, 2, 3, 4, 5, 6, 7];
    accepted(&mesh(&nodes(0.74, 0.0), &[cell]));
    assert_eq!(
        message(&mesh(&nodes(0.8, 0.0), &[cell])),
        "cell 1 at (0.5, 0.5) is inverted: it is folded, node 105 lies 0.30 side lengths off \
         the middle"
    );
    let problems = refused(&mesh(&nodes(0.5, 1.1), &[cell]));
    assert!(problems[0].help().unwrap().contains("HighOrderOptimize"));
    // the center of a biquadratic cell
    let mut nine = nodes(0.5, 0.0).to_vec();
    nine.push([0.9, 0.5]);
    let problems = refused(&mesh(&nine, &[&[0, 1, 2, 3, 4, 5, 6, 7, 8]]));
    assert!(matches!(
        problems[0],
        MeshProblem::InvertedCell {
            reason: Inversion::Middle { node: 109, .. },
            ..
        }
    ));
}

#[test]
fn a_cell_that_runs_against_its_surface_is_inverted() {
    let nodes = [LADDER.as_slice(), &[[3.0, 0.0], [3.0, 1.0]]].concat();
    let problems = refused(&mesh(&nodes, &[LEFT, RIGHT, &[2, 5, 7, 6]]));
    assert_eq!(
        problems[0].to_string(),
        "cell 3 at (2.5, 0.5) is inverted: its nodes run in the opposite direction to the 2 other \
         cells of its surface, entity 5"
    );
}

#[test]
fn many_problems_of_a_kind_are_counted() {
    let nodes = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]];
    let cells: Vec<&[u32]> = vec![&[0, 1, 2]; 25];
    let problems = refused(&mesh(&nodes, &cells));
    assert!(problems.contains(&MeshProblem::More {
        count: 5,
        what: "inverted cells"
    }));
}

#[test]
fn overlapping_cells_are_reported() {
    // three cells on one side
    let nodes = [LADDER.as_slice(), &[[0.0, 2.0]]].concat();
    let problems = refused(&mesh(&nodes, &[LEFT, RIGHT, &[1, 4, 6]]));
    assert_eq!(
        problems[0].to_string(),
        "cells 1 and 3 overlap: both lie on the same side of the line from node 102 to node 105"
    );
    // two cells on the same side of their common side
    let problems = refused(&mesh(&nodes, &[LEFT, &[0, 1, 5]]));
    assert!(matches!(
        problems[..],
        [MeshProblem::Overlap { cells: [1, 2], .. }]
    ));
}

#[test]
fn sides_must_have_a_common_middle() {
    let nodes = [
        LADDER.as_slice(),
        &[[1.5, 0.0], [2.0, 0.5], [1.5, 1.0], [1.0, 0.5]],
    ]
    .concat();
    assert_eq!(
        message(&mesh(&nodes, &[LEFT, &[1, 2, 5, 4, 6, 7, 8, 9]])),
        "node 110 at (1, 0.5) hangs in the middle of the side from node 102 to node 105: cell 2 \
         (quadrilateral with 8 nodes) has it there, cell 1 (quadrilateral with 4 nodes) does not"
    );
}

#[test]
fn parts_are_described() {
    let nodes = [LADDER.as_slice(), &[[4.0, 0.0], [5.0, 0.0], [4.0, 3.0]]].concat();
    let mut mesh = mesh(&nodes, &[&[6, 7, 8], LEFT, RIGHT]);
    mesh.cells[0].groups = 1.into();
    assert_eq!(
        message(&mesh),
        "the section falls into 2 parts that share no side, expected one\
         \n    part 1: 2 cells at (1, 0.5), between (0, 0) and (2, 1), in \"a\"\
         \n    part 2: 1 cell at (4.33333, 1), between (4, 0) and (5, 3), in \"b\""
    );
    assert!(
        refused(&mesh)[0]
            .help()
            .unwrap()
            .contains("share whole sides")
    );
}

#[test]
fn parts_that_touch_at_a_node_are_reported() {
    let nodes = [LADDER.as_slice(), &[[2.0, 2.0], [1.0, 2.0]]].concat();
    let text = message(&mesh(&nodes, &[LEFT, &[4, 5, 6, 7]]));
    assert!(
        text.ends_with("\n    parts touch only at node 105"),
        "{text}"
    );
}

#[test]
fn a_slit_in_one_part_is_reported_but_no_error() {
    // a ring of four squares around a hole, open between the last and the first
    let corner = |angle: usize, radius: f64| {
        let (sine, cosine) = (std::f64::consts::FRAC_PI_2 * angle as f64).sin_cos();
        [radius * cosine, radius * sine]
    };
    let nodes: Vec<[f64; 2]> = (0..=4)
        .flat_map(|i| [corner(i, 1.0), corner(i, 2.0)])
        .collect();
    let cells: Vec<[u32; 4]> = (0..4).map(|i| [0, 1, 3, 2].map(|n| 2 * i + n)).collect();
    let cells: Vec<&[u32]> = cells.iter().map(|cell| cell.as_slice()).collect();
    let (_, report) = accepted(&mesh(&nodes, &cells));
    assert_eq!(report.coincident_nodes, [[101, 109], [102, 110]]);
}

#[test]
fn many_parts_are_reported_in_a_short_message_and_a_short_time() {
    // 20000 separate triangles: a search of all pairs would take minutes
    let count = 20_000;
    let nodes: Vec<[f64; 2]> = (0..count)
        .flat_map(|i| {
            let (x, y) = (f64::from(i % 100), f64::from(i / 100));
            [[x, y], [x + 0.5, y], [x, y + 0.5]]
        })
        .collect();
    let cells: Vec<[u32; 3]> = (0..count as u32)
        .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
        .collect();
    let cells: Vec<&[u32]> = cells.iter().map(|cell| cell.as_slice()).collect();
    let text = message(&mesh(&nodes, &cells));
    assert!(text.starts_with("the section falls into 20000 parts"));
    assert!(text.ends_with("and 19992 more"), "{text}");
}
