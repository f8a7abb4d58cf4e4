//! Derivatives with respect to nodes of the mesh file, including laminates and plane
//! angles that follow a curve, compared with differences of complete analyses of moved
//! files.

use std::path::Path;

use nalgebra::Matrix6;
use section_analyzer::analysis::{Analysis, analyze};
use section_analyzer::input::{self, Input, NodeProblem};
use section_analyzer::mesh::generate::Tube;
use section_analyzer::sensitivity::{Axis, Parameter};
use section_analyzer::solution::SectionSolution;
use shared_geom::gmsh;
use shared_geom::mesh::{CellKind, Line, LineKind, Mesh, Node, PhysicalGroup};

const MATERIALS: &str = "\
mesh = \"a.msh\"
[units]
length = \"mm\"
[material.al]
young = \"70 GPa\"
poisson = 0.33
density = \"2700 kg/m^3\"
[material.ply]
e1 = \"130 GPa\"
e2 = \"9 GPa\"
e3 = \"10 GPa\"
g12 = \"5 GPa\"
g13 = \"4.5 GPa\"
g23 = \"3.4 GPa\"
nu12 = 0.3
nu13 = 0.28
nu23 = 0.45
density = \"1600 kg/m^3\"
";

/// Both materials on both sides: the wall follows the laminate.
const TUBE: &str = "\
[[region]]
group = \"wall\"
material = \"ply\"
fiber_angle = 20
plane_angle = { follow = \"outer\", reverse = true }
[[lamina]]
curve = \"outer\"
plies = [
  { material = \"ply\", thickness = 1.2, fiber_angle = 30 },
  { material = \"al\", thickness = 0.7 },
]
";

const BOX: &str = "\
[[lamina]]
curve = \"skin\"
plies = [
  { material = \"ply\", thickness = 1.2, fiber_angle = 30 },
  { material = \"al\", thickness = 0.7 },
]
[[lamina]]
curve = \"web\"
material = \"ply\"
thickness = 1.5
fiber_angle = -25
";

fn written(folder: &Path, mesh: &Mesh, text: &str) -> Input {
    std::fs::write(folder.join("a.msh"), gmsh::write(mesh)).unwrap();
    let file = folder.join("a.section.toml");
    std::fs::write(&file, format!("{MATERIALS}{text}")).unwrap();
    input::read(&file).unwrap_or_else(|problems| panic!("{problems}"))
}

/// Largest entry relative to `sqrt(of_ii of_jj)`.
fn largest(matrix: &Matrix6<f64>, of: &Matrix6<f64>) -> f64 {
    let down = of.diagonal().map(|value| 1.0 / value.sqrt());
    matrix.component_mul(&(down * down.transpose())).amax()
}

fn centers(solution: &SectionSolution) -> [f64; 6] {
    let c = &solution.centers;
    let ([a, b], [c, d], [e, f]) = (c.tension, c.shear, c.mass.unwrap());
    [a, b, c, d, e, f]
}

/// K, M and the centers, relative to the largest of their derivatives. Differences of
/// four analyses with steps of 2e-3 of a line have errors of 1e-11 times a fifth
/// derivative, and of round-off, 1e-13 over the change of a step (1e-5): 1e-6 leaves a
/// margin.
fn moves(mesh: &Mesh, text: &str, tags: &[u64], line: f64) {
    let folder = tempfile::tempdir().unwrap();
    let input = written(folder.path(), mesh, text);
    let analysis = Analysis::new(&input.section).unwrap();
    for &tag in tags {
        for (i, axis) in [Axis::Y, Axis::Z].into_iter().enumerate() {
            let at = input.source.coordinate(&input.section, "a.msh", tag, axis);
            let parameter = Parameter::MeshNode(at.unwrap_or_else(|problem| panic!("{problem}")));
            let name = parameter.name(&input.section);
            let found = analysis.sensitivities(&[parameter]).unwrap().remove(0);

            let step = 2e-3 * line;
            let around = [-2.0, -1.0, 1.0, 2.0].map(|steps| {
                let mut mesh = mesh.clone();
                let node = mesh.nodes.iter_mut().find(|node| node.tag == tag).unwrap();
                node.position[i] += steps * step;
                analyze(&written(folder.path(), &mesh, text).section).unwrap()
            });
            let per = 12.0 * 1e-3 * step;
            let rate = |of: fn(&SectionSolution) -> Matrix6<f64>| {
                let [far, near, next, last] = around.each_ref().map(of);
                (8.0 * (next - near) - (last - far)) / per
            };
            let solution = analysis.solution();
            for (what, found, expected, of) in [
                (
                    "dK",
                    found.stiffness,
                    rate(|s| s.stiffness),
                    solution.stiffness,
                ),
                ("dM", found.mass, rate(|s| s.mass), solution.mass),
            ] {
                let error = largest(&(found - expected), &of) / largest(&expected, &of);
                assert!(error < 1e-6, "{name}: {what} {error:e}");
            }
            let [far, near, next, last] = around.each_ref().map(centers);
            let expected: [f64; 6] =
                std::array::from_fn(|i| (8.0 * (next[i] - near[i]) - (last[i] - far[i])) / per);
            let size = expected.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let found = [found.tension, found.shear, found.mass_center.unwrap()];
            for (found, expected) in found.iter().flatten().zip(expected) {
                let error = (found - expected).abs() / size;
                assert!(error < 1e-6, "{name}: centers {error:e}");
            }
        }
    }
}

fn tube(kind: CellKind) -> Mesh {
    let tube = Tube {
        outer_radius: 50.0,
        thickness: 5.0,
        cells_around: 12,
        cells_through: 1,
        kind,
        curved: true,
    };
    let mut mesh = tube.generate().unwrap();
    // off its center and not circular, so that nothing is zero by symmetry
    for node in &mut mesh.nodes {
        let [y, z] = [node.position.x, node.position.y];
        (node.position.x, node.position.y) = (1.3 * y + 20.0, 0.8 * z + 0.1 * y - 7.0);
    }
    mesh
}

/// Tags of a node of the first line of "outer", of an inner one, and of its middle node,
/// if it has one.
fn of_tube(mesh: &Mesh) -> Vec<u64> {
    let of = |name: &str| {
        let group = mesh.group(1, name).unwrap();
        let line = mesh.lines.iter().find(|line| line.groups.contains(group));
        line.unwrap().nodes().to_vec()
    };
    let (outer, inner) = (of("outer"), of("inner"));
    let nodes = [Some(outer[0]), Some(inner[1]), outer.get(2).copied()];
    let tag = |node: u32| mesh.nodes[node as usize].tag;
    nodes.into_iter().flatten().map(tag).collect()
}

#[test]
fn nodes_of_a_tube_with_plies_that_follow_it() {
    let mesh = tube(CellKind::Quadrilateral4);
    moves(&mesh, TUBE, &of_tube(&mesh), 30.0);
    // the face of the plies, which the mesh does not have
    let text = TUBE.replacen("follow = \"outer\"", "follow = \"outer/outer\"", 1);
    moves(&mesh, &text, &of_tube(&mesh)[..1], 30.0);
}

#[test]
fn nodes_of_a_tube_of_quadratic_cells() {
    let mesh = tube(CellKind::Quadrilateral8);
    moves(&mesh, TUBE, &of_tube(&mesh), 15.0);
}

/// A box of lines with a web between two of its sides; its corners are nodes 1, 3, 5, 7.
fn box_of_lines() -> Mesh {
    let mut mesh = Mesh::default();
    let positions = [
        [0.0, 0.0],
        [30.0, -2.0],
        [70.0, 2.0],
        [68.0, 20.0],
        [66.0, 43.0],
        [34.0, 40.0],
        [-2.0, 35.0],
        [1.0, 18.0],
        [31.0, 15.0],
    ];
    for (tag, [x, y]) in (1..).zip(positions) {
        let position = [x, y, 0.0].into();
        mesh.nodes.push(Node { tag, position });
    }
    let around = (0..8).map(|i| ([i, (i + 1) % 8], 0));
    for (tag, (nodes, group)) in (1..).zip(around.chain([([1, 8], 1), ([8, 5], 1)])) {
        let mut line = Line::new(tag, LineKind::Line2, 1 + group as i32, |i| nodes[i]);
        line.groups = group.into();
        mesh.lines.push(line);
    }
    for (tag, name) in [(1, "skin"), (2, "web")] {
        let name = Some(name.to_owned());
        mesh.groups.push(PhysicalGroup {
            dimension: 1,
            tag,
            name,
        });
    }
    mesh
}

/// Mitred corners, a smooth side, a web that ends on a wall, and a node inside the web.
#[test]
fn nodes_of_lines_alone() {
    moves(&box_of_lines(), BOX, &[1, 2, 4, 9], 20.0);
}

fn problem(input: &Input, tag: u64) -> NodeProblem {
    let found = input
        .source
        .coordinate(&input.section, "a.msh", tag, Axis::Y);
    found.expect_err("no derivative")
}

#[test]
fn nodes_that_are_no_parameters() {
    let folder = tempfile::tempdir().unwrap();
    let mut mesh = box_of_lines();
    mesh.nodes.push(Node {
        tag: 20,
        position: [5.0, 5.0, 0.0].into(),
    });
    let input = written(folder.path(), &mesh, BOX);
    let made = input.section.mesh.node_tags.iter().max().unwrap();
    for (tag, words) in [
        (
            *made,
            "is not in the mesh \"a.msh\": a laminate has made it",
        ),
        (99, "the mesh \"a.msh\" has no node 99"),
        (
            20,
            "node 20 of the mesh \"a.msh\" belongs to no cell and to no line",
        ),
    ] {
        let reported = problem(&input, tag).to_string();
        assert!(reported.contains(words), "{reported}");
    }
}

/// The center of a square cell is equally near to its right side and to its bottom: the
/// side that its plane angle follows is undetermined as soon as a corner moves.
#[test]
fn angles_that_jump() {
    let mut mesh = Mesh::default();
    for (tag, [x, y]) in (1..).zip([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]) {
        let position = [x, y, 0.0].into();
        mesh.nodes.push(Node { tag, position });
    }
    let mut cell = shared_geom::mesh::Cell::new(1, CellKind::Quadrilateral4, 1, |i| i as u32);
    cell.groups = 0.into();
    mesh.cells.push(cell);
    for (tag, nodes) in [(2, [0, 1]), (3, [1, 2])] {
        let mut line = Line::new(tag, LineKind::Line2, 1, |i| nodes[i]);
        line.groups = 1.into();
        mesh.lines.push(line);
    }
    for (dimension, name) in [(2, "cell"), (1, "edge")] {
        let name = Some(name.to_owned());
        mesh.groups.push(PhysicalGroup {
            dimension,
            tag: 1,
            name,
        });
    }
    let text = "[[region]]\ngroup = \"cell\"\nmaterial = \"ply\"\n\
                plane_angle = { follow = \"edge\" }\n";
    let folder = tempfile::tempdir().unwrap();
    let input = written(folder.path(), &mesh, text);
    let reported = problem(&input, 4).to_string();
    let words = "as node 4 moves, the plane angle of the cell at y = 5.000000e-4 m";
    assert!(reported.contains(words), "{reported}");
}
