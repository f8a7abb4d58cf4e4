use shared_geom::error::Explain;
use shared_geom::mesh::{Cell, CellKind, Line, LineKind, Node, PhysicalGroup};

use super::*;

/// Name, lines and side of each curve.
type Curves<'a> = [(&'a str, &'a [&'a [u32]], Option<LaminaSide>)];

/// A mesh with these nodes; tags from one. Each curve is a list of lines: ends, and the
/// middle. Its laminate has two plies, together of thickness 0.2, on the given side.
fn mesh(positions: &[[f64; 2]], cells: &[&[u32]], curves: &Curves<'_>) -> (Mesh, Vec<Lamina>) {
    let mut mesh = Mesh::default();
    for (&[x, y], tag) in positions.iter().zip(1..) {
        let position = [x, y, 0.0].into();
        mesh.nodes.push(Node { tag, position });
    }
    for (nodes, tag) in cells.iter().zip(500..) {
        let kind = CellKind::Quadrilateral4;
        mesh.cells.push(Cell::new(tag, kind, 1, |i| nodes[i] - 1));
    }
    let group = |mesh: &mut Mesh, dimension, name: &str| {
        mesh.groups.push(PhysicalGroup {
            dimension,
            tag: mesh.groups.len() as i32 + 1,
            name: Some(name.to_owned()),
        });
        mesh.groups.len() - 1
    };
    let mut laminae = Vec::new();
    for (name, lines, side) in curves {
        let curve = group(&mut mesh, 1, name);
        for nodes in *lines {
            let kind = match nodes.len() {
                2 => LineKind::Line2,
                _ => LineKind::Line3,
            };
            let tag = mesh.lines.len() as u64 + 1;
            let mut line = Line::new(tag, kind, 1, |i| nodes[i] - 1);
            line.groups = curve.into();
            mesh.lines.push(line);
        }
        laminae.push(Lamina {
            curve,
            side: *side,
            thicknesses: vec![0.1, 0.1],
            groups: vec![group(&mut mesh, 2, "one"), group(&mut mesh, 2, "two")],
        });
    }
    (mesh, laminae)
}

fn refused(mut mesh: Mesh, laminae: &[Lamina]) -> Vec<String> {
    let problems = add_laminae(&mut mesh, laminae).expect_err("a problem");
    for (_, problem) in &problems {
        assert!(problem.help().is_some(), "{problem}");
    }
    problems
        .iter()
        .map(|(_, problem)| problem.to_string())
        .collect()
}

/// ```text
///   4---3---6     two squares, tags of the nodes
///   |   |   |
///   1---2---5
/// ```
const POSITIONS: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [1.0, 0.0],
    [1.0, 1.0],
    [0.0, 1.0],
    [2.0, 0.0],
    [2.0, 1.0],
];
const LEFT: &[u32] = &[1, 2, 3, 4];
const RIGHT: &[u32] = &[2, 5, 6, 3];

#[test]
fn a_border_gets_plies_on_its_free_side_and_keeps_its_nodes() {
    // opposite to the cell's direction, so that the free side is the left
    let (mut mesh, laminae) = mesh(&POSITIONS, &[LEFT], &[("skin", &[&[4, 3]], None)]);
    let found = add_laminae(&mut mesh, &laminae).expect("sound");
    assert_eq!(found.bare_nodes, 0);
    let plies: Vec<_> = found
        .cells
        .iter()
        .map(|cell| (cell.ply, cell.direction))
        .collect();
    assert_eq!(plies, [(0, 0.0), (1, 0.0)]);
    let inner = &mesh.cells[1];
    assert_eq!((inner.nodes(), inner.tag), (&[3, 2, 6, 8][..], 501));
    let outer = mesh.cells[2].nodes().iter();
    let outer: Vec<_> = outer.map(|&n| mesh.nodes[n as usize].position).collect();
    for (found, expected) in outer
        .iter()
        .zip([[0.0, 1.1], [1.0, 1.1], [1.0, 1.2], [0.0, 1.2]])
    {
        assert!((found.x - expected[0]).abs() + (found.y - expected[1]).abs() < 1e-15);
    }
    // in the other direction the free side is the right; plies are still listed outward
    let (mut mesh, laminae) = self::mesh(&POSITIONS, &[LEFT], &[("skin", &[&[3, 4]], None)]);
    let found = add_laminae(&mut mesh, &laminae).expect("sound");
    let plies: Vec<_> = found.cells.iter().map(|cell| cell.ply).collect();
    assert_eq!(plies, [1, 0]);
    assert!((found.cells[0].direction - std::f64::consts::PI).abs() < 1e-15);
}

#[test]
fn the_side_of_a_laminate_must_be_one_and_free() {
    let cells = [LEFT, RIGHT];
    let skin = |lines, side| mesh(&POSITIONS, &cells, &[("skin", lines, side)]);
    let reported = |(mesh, laminae): (Mesh, Vec<Lamina>)| refused(mesh, &laminae);
    assert_eq!(
        reported(skin(&[&[2, 3]], None)),
        [
            "line 1 of curve \"skin\" at (1, 0.5) lies between cells: a laminate must lie on the \
             border of cells, or away from cells"
        ]
    );
    assert_eq!(
        reported(skin(&[&[4, 3]], Some(LaminaSide::Right))),
        [
            "side = \"right\" puts the laminate of curve \"skin\" into the cells next to line 1 \
             at (0.5, 1)"
        ]
    );
    assert_eq!(
        reported(skin(&[&[4, 3]], Some(LaminaSide::Center))),
        [
            "side = \"center\" puts the laminate of curve \"skin\" into the cells next to line 1 \
             at (0.5, 1)"
        ]
    );
    assert_eq!(
        reported(skin(&[&[4, 3], &[6, 3]], None)),
        [
            "curve \"skin\" has cells on its left at line 2 at (1.5, 1) and on its right at line \
             1 at (0.5, 1): its laminate has no side"
        ]
    );
    let beyond = mesh(&POSITIONS, &[LEFT], &[("skin", &[&[4, 3], &[3, 6]], None)]);
    assert_eq!(
        reported(beyond),
        [
            "curve \"skin\" has cells next to line 1 at (0.5, 1) and none next to line 2 at (1.5, \
             1): the side of its laminate must be given"
        ]
    );
    let left = Some(LaminaSide::Left);
    let (mut mesh, laminae) = mesh(&POSITIONS, &[LEFT], &[("skin", &[&[4, 3], &[3, 6]], left)]);
    assert_eq!(
        add_laminae(&mut mesh, &laminae).expect("sound").cells.len(),
        4
    );
}

#[test]
fn lines_have_one_laminate_on_each_side_and_one_direction() {
    let reported = |curves: &Curves<'_>| {
        let (mesh, laminae) = mesh(&POSITIONS, &[], curves);
        refused(mesh, &laminae)
    };
    let (left, right) = (Some(LaminaSide::Left), Some(LaminaSide::Right));
    assert_eq!(
        reported(&[("a", &[&[1, 2]], left), ("b", &[&[2, 1]], right)]),
        ["curves \"a\" and \"b\" both have a laminate on one side of line 2 at (0.5, 0)"]
    );
    assert_eq!(
        reported(&[("a", &[&[1, 2], &[5, 2]], left)]),
        [
            "lines 1 and 2 of curve \"a\" have opposite directions at node 2 at (1, 0): left and \
             right change there"
        ]
    );
    assert_eq!(
        reported(&[("a", &[&[1, 2]], left), ("b", &[&[2, 5]], None)]),
        [
            "the laminates of curves \"a\" and \"b\" meet at node 2 at (1, 0), one centered on \
             its line and the other on one side of it"
        ]
    );
    let (mut mesh, laminae) = mesh(
        &POSITIONS,
        &[],
        &[("a", &[&[1, 2]], left), ("b", &[&[1, 2]], right)],
    );
    assert_eq!(
        add_laminae(&mut mesh, &laminae).expect("sound").cells.len(),
        4
    );
}

#[test]
fn corners_and_junctions_that_cannot_be_made_are_reported() {
    let positions = [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 0.1],
        [1.0, 1.0],
        [0.5, 1.0],
        [1.0, -1.0],
    ];
    let reported = |curves: &Curves<'_>| {
        let (mesh, laminae) = mesh(&positions, &[], curves);
        refused(mesh, &laminae)
    };
    assert_eq!(
        reported(&[("a", &[&[1, 2], &[2, 3]], None)]),
        [
            "the laminate of curve \"a\" turns by 174.289 deg at node 2 at (1, 0), expected at most \
             135 deg"
        ]
    );
    // four walls, and three without a continuous one
    assert_eq!(
        reported(&[("a", &[&[1, 2], &[2, 4]], None), ("b", &[&[2, 5]], None)]),
        ["3 lines with laminates meet at node 2 at (1, 0) (\"a\", \"b\")"]
    );
    assert_eq!(
        reported(&[
            ("a", &[&[6, 2], &[2, 4]], None),
            ("b", &[&[1, 2], &[2, 5]], None)
        ]),
        ["4 lines with laminates meet at node 2 at (1, 0) (\"a\", \"b\")"]
    );
    // a laminate of one ply at the corner of one of two
    let (mesh, mut laminae) = mesh(
        &positions,
        &[],
        &[("a", &[&[1, 2]], None), ("b", &[&[2, 4]], None)],
    );
    laminae[1].thicknesses = vec![0.1];
    assert_eq!(
        refused(mesh, &laminae),
        [
            "the laminates of curves \"a\" (2 layers) and \"b\" (1 layer) meet at a corner at \
             node 2 at (1, 0), where layers cannot be joined one by one"
        ]
    );
}

#[test]
fn where_a_corner_opens_both_laminates_end() {
    // a wedge of 6 degrees as one cell, its sides ordered to the right around the tip
    let positions = [[0.0, 0.0], [1.0, 0.0], [0.0, -0.1], [0.1, -0.05]];
    let left = Some(LaminaSide::Left);
    let skin: &Curves<'_> = &[("a", &[&[1, 2], &[2, 3]], left)];
    let (mut wedge, laminae) = mesh(&positions, &[&[1, 4, 3, 2]], skin);
    add_laminae(&mut wedge, &laminae).expect("sound");
    let [one, other] = [&wedge.cells[1], &wedge.cells[3]];
    assert_eq!((one.nodes()[1], other.nodes()[0]), (1, 1));
    assert_ne!(one.nodes()[2], other.nodes()[3]);
    // without the cell the node alone would connect the walls
    let (alone, laminae) = mesh(&positions, &[], skin);
    assert_eq!(
        refused(alone, &laminae),
        [
            "the laminate of curve \"a\" turns by 174.289 deg at node 2 at (1, 0), expected at \
             most 135 deg"
        ]
    );
}

/// Two walls in line, one to the left and one to the right of their lines: alone they
/// would be connected only by the node; with adjacent cells they are sound.
#[test]
fn walls_that_change_sides_are_reported() {
    let (left, right) = (Some(LaminaSide::Left), Some(LaminaSide::Right));
    let curves: &Curves<'_> = &[("a", &[&[1, 2]], left), ("b", &[&[2, 5]], right)];
    let (alone, laminae) = mesh(&POSITIONS, &[], curves);
    assert_eq!(
        refused(alone, &laminae),
        [
            "the laminates of curves \"a\" and \"b\" lie on different sides of their lines at \
             their common node 2 at (1, 0): they would touch in this node only"
        ]
    );
    // cells on the other side of each, joined elsewhere
    let positions = [
        POSITIONS[0],
        POSITIONS[1],
        POSITIONS[4],
        [0.0, -1.0],
        [1.0, -1.0],
    ];
    let positions = [&positions[..], &[[1.0, 1.0], [2.0, 1.0]]].concat();
    let cells: [&[u32]; 2] = [&[4, 5, 2, 1], &[2, 3, 7, 6]];
    let curves: &Curves<'_> = &[("a", &[&[1, 2]], left), ("b", &[&[2, 3]], right)];
    let (mut held, laminae) = mesh(&positions, &cells, curves);
    assert_eq!(
        add_laminae(&mut held, &laminae).expect("sound").cells.len(),
        4
    );
}

#[test]
fn lines_that_do_not_fit_the_cells_are_reported() {
    let left = Some(LaminaSide::Left);
    // nodes 7 to 10 on the top side of the left square, 11 above it
    let more = [[0.0, 1.0], [0.5, 1.0], [1.0, 1.0], [0.5, 1.004], [0.5, 1.1]];
    let positions = [&POSITIONS[..], &more].concat();
    let reported = |lines: &[&[u32]], side| {
        let (mesh, laminae) = mesh(&positions, &[LEFT, RIGHT], &[("skin", lines, side)]);
        refused(mesh, &laminae)
    };
    let along = "line 1 of curve \"skin\" at (0.25, 1) runs along the border of cells without \
                 being one of their sides, as do 1 more";
    assert_eq!(reported(&[&[7, 8], &[8, 9]], left), [along]);
    // twice as long as the sides, without the node between them
    let along = "line 1 of curve \"skin\" at (1, 1) runs along the border of cells without \
                 being one of their sides";
    assert_eq!(reported(&[&[4, 6]], left), [along]);
    // a line with a middle node on a cell without one
    let order = "line 1 of curve \"skin\" at (0.5, 1.004) has a node in its middle that the side \
                 of the cell there does not have";
    assert_eq!(reported(&[&[4, 3, 10]], left), [order]);
    // two lines between the same ends
    let ends = "lines 1 and 2 of curve \"skin\" have the same ends: the one at (0.5, 1.1) and the \
                other cannot be distinguished at joints of laminates";
    let (lens, laminae) = mesh(
        &positions,
        &[],
        &[("skin", &[&[4, 3, 8], &[3, 4, 11]], left)],
    );
    assert_eq!(refused(lens, &laminae), [ends]);
    // a wall that leaves the border by 15 degrees is not on it
    let mut away = POSITIONS.to_vec();
    away.push([2.0, 1.268]);
    let (mut leaving, laminae) = mesh(&away, &[LEFT], &[("skin", &[&[4, 3], &[3, 7]], left)]);
    assert_eq!(
        add_laminae(&mut leaving, &laminae)
            .expect("sound")
            .cells
            .len(),
        4
    );
}

/// Walls in line, of thickness 0.2 and 0.2 (1 + 1e-6): no sliver between them, and the
/// number of cells is as for equal walls. An intended difference is kept.
#[test]
fn levels_that_nearly_agree_are_one() {
    let left = Some(LaminaSide::Left);
    let curves: &Curves<'_> = &[("a", &[&[1, 2]], left), ("b", &[&[2, 5]], left)];
    for (part, cells) in [(1e-6, 4), (-1e-6, 4), (1e-2, 5)] {
        let (mut walls, mut laminae) = mesh(&POSITIONS, &[], curves);
        laminae[1].thicknesses[1] *= 1.0 + 2.0 * part;
        let found = add_laminae(&mut walls, &laminae).expect("sound");
        assert_eq!(found.cells.len(), cells, "{part}");
        // the nodes at the joint up to 0.2 are shared
        let [one, other] = [1, 3].map(|cell: usize| walls.cells[cell].nodes());
        assert_eq!(one[1], other[0]);
        assert_eq!(one[2], other[3]);
    }
}

/// The faces: one of a laminate on one side of its line, two of a centered one; none at
/// lines on which another wall ends.
#[test]
fn faces_are_the_free_sides_of_plies() {
    let positions = [[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let lines: &[&[u32]] = &[&[1, 2], &[2, 3]];
    let (mut tee, laminae) = mesh(
        &positions,
        &[],
        &[("a", lines, None), ("b", &[&[2, 4]], None)],
    );
    let found = add_laminae(&mut tee, &laminae).expect("sound");
    let count = |lamina, side| {
        let of = found.faces.iter();
        of.filter(|face| face.lamina == lamina && face.side == side)
            .count()
    };
    // four lines below; the two in the middle are under the web
    assert_eq!(count(0, LaminaSide::Right), 4);
    assert_eq!(count(0, LaminaSide::Left), 2);
    assert_eq!(count(1, LaminaSide::Left), 1);
    let (mut beside, laminae) = mesh(&POSITIONS, &[LEFT], &[("skin", &[&[4, 3]], None)]);
    let found = add_laminae(&mut beside, &laminae).expect("sound");
    let [face] = &found.faces[..] else {
        panic!("one face")
    };
    assert_eq!((face.side, face.line.tag), (LaminaSide::Left, 1));
    let heights = face
        .line
        .nodes()
        .iter()
        .map(|&n| beside.nodes[n as usize].position.y);
    assert!(heights.clone().count() == 2 && heights.into_iter().all(|y| (y - 1.2).abs() < 1e-15));
}

#[test]
fn laminates_that_fold_are_reported_with_the_radius() {
    // an arc of radius 0.125 in a laminate that extends 0.2 to its inner side
    let positions = [[0.0, 0.0], [0.2, 0.0], [0.1, -0.05]];
    let left = Some(LaminaSide::Left);
    let (bent, laminae) = mesh(&positions, &[], &[("a", &[&[1, 2, 3]], left)]);
    assert_eq!(
        refused(bent, &laminae),
        [
            "the laminate of curve \"a\" folds over itself at line 1 at (0.1, -0.05): it reaches \
             0.2 from the line, and the line of length 0.2 has a radius of curvature of 0.1"
        ]
    );
    // a short line at a corner
    let positions = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.15], [0.0, 0.15]];
    let lines: &[&[u32]] = &[&[1, 2], &[2, 3], &[3, 4]];
    let (corner, laminae) = mesh(&positions, &[], &[("a", lines, left)]);
    assert_eq!(
        refused(corner, &laminae),
        [
            "the laminate of curve \"a\" folds over itself at line 2 at (1, 0.075): it reaches \
             0.2 from the line, and the line is 0.15 long"
        ]
    );
    // a wall that ends on lines shorter than its thickness
    let positions = [[-0.12, 0.0], [0.0, 0.0], [0.12, 0.0], [0.0, 1.0]];
    let lines: &[&[u32]] = &[&[1, 2], &[2, 3]];
    let (tee, laminae) = mesh(
        &positions,
        &[],
        &[("a", lines, None), ("b", &[&[2, 4]], None)],
    );
    assert_eq!(
        refused(tee, &laminae),
        [
            "the laminate of curve \"b\" ends on the laminate of \"a\" at node 2 at (0, 0), where \
             line 1 of length 0.12 is too short: 0.1 of it are covered, expected at most three \
             quarters"
        ]
    );
}

/// A wall on another one: the areas of the walls are counted once, and the row has the
/// nodes of the wall that ends.
#[test]
fn a_wall_ends_on_the_face_of_another() {
    let positions = [[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.5, 1.0]];
    let lines: &[&[u32]] = &[&[1, 2], &[2, 3]];
    for web in [[2_u32, 4], [4, 2]] {
        let (mut mesh, laminae) =
            mesh(&positions, &[], &[("a", lines, None), ("b", &[&web], None)]);
        let found = add_laminae(&mut mesh, &laminae).expect("sound");
        // four layers of the wall, two of them short; two of the web
        assert_eq!(found.cells.len(), 2 * 4 + 2);
        let area = |cell: &Cell| {
            let point = |&node: &u32| {
                let position = mesh.nodes[node as usize].position;
                [position.x, position.y]
            };
            crate::mesh::polygon_area(cell.corners().iter().map(point))
        };
        let sum: f64 = mesh.cells.iter().map(area).sum();
        // the web begins at the face, 0.1 above the line; its end is cut at right angles
        let length = (1.25_f64).sqrt() * 0.9;
        assert!((sum - (2.0 * 0.2 + length * 0.2)).abs() < 1e-12, "{sum}");
        for cell in &mesh.cells {
            assert!(area(cell) > 0.0, "{cell:?}");
        }
        let (section, report) =
            crate::mesh::SectionMesh::checked(&mesh, 1.0, crate::mesh::DoubledNodes::Error)
                .expect("one part without overlaps");
        assert_eq!(section.cells.len(), 10);
        assert_eq!(report.unused_nodes, found.bare_nodes);
    }
}
