//! Area, second moments, topology and groups of the generated meshes.

use std::collections::{HashMap, HashSet};
use std::f64::consts::PI;

use shared_geom::gmsh;
use shared_geom::mesh::{Cell, CellKind, GroupSet, LineKind, Mesh};

use super::*;

/// Area, int y^2 dA, int z^2 dA, int y z dA by the rule of the cells.
fn moments(mesh: &Mesh) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for cell in &mesh.cells {
        for point in cell.kind.rule() {
            let ([y, z], jacobian) = map(mesh, cell, point.r, point.s);
            let weight = point.weight * jacobian;
            for (sum, value) in sum.iter_mut().zip([1.0, y * y, z * z, y * z]) {
                *sum += weight * value;
            }
        }
    }
    sum
}

/// Position and Jacobian determinant at (r, s) of a cell.
fn map(mesh: &Mesh, cell: &Cell, r: f64, s: f64) -> ([f64; 2], f64) {
    let shape = cell.kind.shape(r, s);
    let (mut position, mut dr, mut ds) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    for (i, &node) in cell.nodes().iter().enumerate() {
        for axis in 0..2 {
            let x = mesh.nodes[node as usize].position[axis];
            position[axis] += shape.n[i] * x;
            dr[axis] += shape.dr[i] * x;
            ds[axis] += shape.ds[i] * x;
        }
    }
    (position, dr[0] * ds[1] - dr[1] * ds[0])
}

fn rectangle(kind: CellKind) -> Mesh {
    let rectangle = Rectangle {
        width: 3.0,
        height: 0.5,
        cells_y: 5,
        cells_z: 2,
        kind,
        name: "plate 1".into(),
    };
    rectangle.generate().unwrap()
}

fn tube(kind: CellKind, curved: bool, [cells_around, cells_through]: [usize; 2]) -> Mesh {
    let tube = Tube {
        outer_radius: 2.0,
        thickness: 0.5,
        cells_around,
        cells_through,
        kind,
        curved,
    };
    tube.generate().unwrap()
}

fn ellipse(kind: CellKind, curved: bool, cells: usize) -> Mesh {
    let ellipse = Ellipse {
        semi_y: 2.0,
        semi_z: 0.8,
        cells,
        kind,
        curved,
    };
    ellipse.generate().unwrap()
}

/// One mesh of each shape, kind of cell and kind of sides, with the number of
/// its holes.
fn all() -> Vec<(Mesh, usize)> {
    let mut meshes = Vec::new();
    for kind in CellKind::ALL {
        meshes.push((rectangle(kind), 0));
        for curved in [false, true] {
            meshes.push((tube(kind, curved, [3, 1]), 1));
            meshes.push((tube(kind, curved, [7, 2]), 1));
            meshes.push((ellipse(kind, curved, 1), 0));
            meshes.push((ellipse(kind, curved, 3), 0));
        }
    }
    meshes
}

#[test]
fn rectangles_have_exact_moments() {
    // b h, h b^3/12, b h^3/12, 0; a sum of some hundred rounded terms
    let expected = [1.5, 0.5 * 27.0 / 12.0, 3.0 * 0.125 / 12.0, 0.0];
    for kind in CellKind::ALL {
        let found = moments(&rectangle(kind));
        // integration rules of linear cells are also exact for squares of a coordinate
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-14,
                "{kind:?} {found} {expected}"
            );
        }
    }
}

/// Relative errors of area and second moments.
fn errors(mesh: &Mesh, expected: [f64; 3]) -> [f64; 3] {
    let found = moments(mesh);
    // symmetric shapes: no product moment, to rounding
    assert!(found[3].abs() < 1e-13 * found[1], "{found:?}");
    std::array::from_fn(|i| (found[i] / expected[i] - 1.0).abs())
}

/// Checks that the errors decrease at least with this order if the cells are halved.
fn assert_order(coarse: [f64; 3], fine: [f64; 3], order: f64, what: &str) {
    for (coarse, fine) in coarse.iter().zip(fine) {
        let slope = (coarse / fine).log2();
        assert!(
            slope >= order,
            "{what}: order {slope}, errors {coarse:e} {fine:e}"
        );
    }
}

#[test]
fn curved_quadratic_tubes_converge_with_fourth_order() {
    // annulus: pi (a^2 - b^2), pi/4 (a^4 - b^4)
    let (a, b) = (2.0_f64, 1.5_f64);
    let second = PI / 4.0 * (a.powi(4) - b.powi(4));
    let expected = [PI * (a * a - b * b), second, second];
    for kind in CellKind::ALL {
        // even numbers: the diagonals then alternate all the way around
        let error = |curved, n| errors(&tube(kind, curved, [n, 2]), expected);
        if kind.is_quadratic() {
            assert_order(error(true, 16), error(true, 32), 3.8, kind.name());
        }
        // chords: second order for all kinds
        assert_order(error(false, 16), error(false, 32), 1.9, kind.name());
    }
}

#[test]
fn curved_quadratic_ellipses_converge_with_fourth_order() {
    // pi a b, pi a^3 b/4, pi a b^3/4
    let (a, b) = (2.0_f64, 0.8_f64);
    let expected = [
        PI * a * b,
        PI * a.powi(3) * b / 4.0,
        PI * a * b.powi(3) / 4.0,
    ];
    for kind in CellKind::ALL {
        let error = |curved, n| errors(&ellipse(kind, curved, n), expected);
        if kind.is_quadratic() {
            assert_order(error(true, 4), error(true, 8), 3.8, kind.name());
        }
        assert_order(error(false, 4), error(false, 8), 1.9, kind.name());
    }
}

#[test]
fn no_cell_is_inverted() {
    let mut meshes: Vec<Mesh> = all().into_iter().map(|(mesh, _)| mesh).collect();
    // a thin wall in few cells: the sagitta of the sides is far more than the thickness
    meshes.extend(CellKind::ALL.map(|kind| {
        let tube = Tube {
            outer_radius: 1.0,
            thickness: 1e-3,
            cells_around: 3,
            cells_through: 1,
            kind,
            curved: true,
        };
        tube.generate().unwrap()
    }));
    for mesh in meshes {
        for cell in &mesh.cells {
            let points = cell.kind.rule().iter().map(|point| [point.r, point.s]);
            let points = points.chain(cell.kind.reference_nodes().iter().copied());
            let jacobians: Vec<f64> = points.map(|[r, s]| map(&mesh, cell, r, s).1).collect();
            let mean = jacobians.iter().sum::<f64>() / jacobians.len() as f64;
            // a tenth of the mean: far from inverted
            let least = jacobians.iter().copied().fold(f64::INFINITY, f64::min);
            assert!(least > 0.1 * mean, "{:?} {least} {mean}", cell.kind);
        }
    }
}

#[test]
fn nodes_are_used_and_none_is_doubled() {
    for (mesh, _) in all() {
        let used: HashSet<u32> = mesh.cells.iter().flat_map(|c| c.nodes().to_vec()).collect();
        assert_eq!(used.len(), mesh.nodes.len());
        let on_lines = mesh.lines.iter().flat_map(|line| line.nodes().to_vec());
        assert!(on_lines.into_iter().all(|node| used.contains(&node)));
        // positions in millionths: the nodes are at least some hundredths apart
        let positions: HashSet<[i64; 2]> = mesh
            .nodes
            .iter()
            .map(|n| [n.position.x, n.position.y].map(|x| (x * 1e6).round() as i64))
            .collect();
        assert_eq!(positions.len(), mesh.nodes.len());
        let tags = mesh.nodes.iter().map(|node| node.tag);
        assert!(tags.eq(1..=mesh.nodes.len() as u64));
    }
}

#[test]
fn cells_close_the_surface() {
    for (mesh, holes) in all() {
        let mut sides: HashMap<[u32; 2], usize> = HashMap::new();
        let mut corners: HashSet<u32> = HashSet::new();
        for cell in &mesh.cells {
            corners.extend(cell.corners());
            for (mut key, _) in cell.kind.sides(cell.nodes()) {
                key.sort_unstable();
                *sides.entry(key).or_default() += 1;
            }
        }
        // Euler: vertices - edges + faces = 1 - holes
        assert_eq!(corners.len() + mesh.cells.len() + holes, sides.len() + 1);
        // sides of only one cell are the boundary, and the lines are exactly these
        let lines = mesh.lines.iter().map(|line| {
            let mut key = [line.nodes()[0], line.nodes()[1]];
            key.sort_unstable();
            key
        });
        let border = sides.iter().filter(|(_, count)| **count == 1);
        let border: HashSet<[u32; 2]> = border.map(|(key, _)| *key).collect();
        assert_eq!(lines.clone().collect::<HashSet<_>>(), border);
        assert_eq!(lines.count(), border.len());
    }
}

/// Twice the area that the lines of a curve group enclose, relative to the origin:
/// negative if they run clockwise; and the number of lines.
fn swept(mesh: &Mesh, name: &str) -> (f64, usize) {
    let group = mesh.group(1, name).unwrap_or_else(|| panic!("{name}"));
    let lines = mesh.lines.iter().filter(|line| line.groups.contains(group));
    let lines: Vec<_> = lines.collect();
    let sum = lines
        .iter()
        .map(|line| {
            let [a, b] = [0, 1].map(|i| mesh.nodes[line.nodes()[i] as usize].position);
            assert_eq!(line.kind.is_quadratic(), mesh.cells[0].kind.is_quadratic());
            a.x * b.y - a.y * b.x
        })
        .sum();
    (sum, lines.len())
}

#[test]
fn boundaries_run_clockwise_with_a_line_for_each_cell() {
    for kind in CellKind::ALL {
        let mesh = rectangle(kind);
        let surface = GroupSet::from(mesh.group(2, "plate 1").unwrap());
        assert!(mesh.cells.iter().all(|cell| cell.groups == surface));
        // each side of the 3 x 0.5 rectangle encloses a quarter of it
        for (name, count) in [("bottom", 5), ("right", 2), ("top", 5), ("left", 2)] {
            let (area, lines) = swept(&mesh, name);
            assert!((area + 0.75).abs() < 1e-14, "{name}: {area}");
            assert_eq!(lines, count);
        }
        let mesh = tube(kind, true, [7, 2]);
        assert!(mesh.group(2, "wall").is_some());
        for (name, radius) in [("inner", 1.5_f64), ("outer", 2.0)] {
            let (area, lines) = swept(&mesh, name);
            let polygon = 7.0 * radius * radius * (2.0 * PI / 7.0).sin();
            assert!((area + polygon).abs() < 1e-13, "{name}: {area}");
            assert_eq!(lines, 7);
        }
        let mesh = ellipse(kind, true, 3);
        let (area, lines) = swept(&mesh, "boundary");
        assert!(area < 0.0 && mesh.group(2, "section").is_some());
        assert_eq!(lines, 24);
    }
}

#[test]
fn side_middles_lie_on_the_circle_or_on_the_chord() {
    for (curved, expected) in [(true, 2.0), (false, 2.0 * (PI / 7.0).cos())] {
        let mesh = tube(CellKind::Quadrilateral8, curved, [7, 2]);
        let outer = GroupSet::from(mesh.group(1, "outer").unwrap());
        for line in mesh.lines.iter().filter(|line| line.groups == outer) {
            assert_eq!(line.kind, LineKind::Line3);
            let radius = mesh.nodes[line.nodes()[2] as usize].position.norm();
            assert!((radius - expected).abs() < 1e-14, "{radius} {expected}");
        }
    }
}

#[test]
fn meshes_are_written_and_read_back_unchanged() {
    for (mesh, _) in all() {
        assert_eq!(gmsh::read(&gmsh::write(&mesh), "mesh.msh").unwrap(), mesh);
    }
}

#[test]
fn measures_are_checked_all_at_once() {
    let rectangle = Rectangle {
        width: -1.0,
        height: f64::NAN,
        cells_y: 0,
        cells_z: 1,
        kind: CellKind::Triangle3,
        name: String::new(),
    };
    let messages = messages(rectangle.generate());
    assert_eq!(
        messages,
        [
            "width: expected a positive length, found -1",
            "height: expected a positive length, found NaN",
            "cells along y: expected at least 1, found 0",
        ]
    );
}

#[test]
fn a_tube_needs_a_hole_and_three_cells() {
    let tube = Tube {
        outer_radius: 1.0,
        thickness: 1.0,
        cells_around: 2,
        cells_through: 1,
        kind: CellKind::Quadrilateral9,
        curved: true,
    };
    let problems = tube.generate().unwrap_err();
    assert!(matches!(problems[0], GenerateProblem::NoHole { .. }));
    let help = shared_geom::error::Explain::help(&problems[0]).unwrap();
    assert!(help.contains("ellipse"), "{help}");
    assert_eq!(
        problems[1].to_string(),
        "cells around: expected at least 3, found 2"
    );
}

#[test]
fn the_number_of_cells_is_limited() {
    let ellipse = |cells, semi_y| Ellipse {
        semi_y,
        semi_z: 1.0,
        cells,
        kind: CellKind::Triangle6,
        curved: true,
    };
    assert_eq!(
        messages(ellipse(500, 1.0).generate()),
        ["expected at most 4000000 cells in all, found 6000000"]
    );
    assert_eq!(
        messages(ellipse(8, 1e308).generate()),
        ["semi-axis along y: expected 1e-15 to 1e15, found 1e308"]
    );
    assert_eq!(
        messages(ellipse(usize::MAX, f64::INFINITY).generate()),
        [
            "semi-axis along y: expected a positive length, found inf",
            "expected at most 4000000 cells in all, found far more",
        ]
    );
}

fn messages(result: Result<Mesh, Vec<GenerateProblem>>) -> Vec<String> {
    let problems = result.unwrap_err();
    problems.iter().map(GenerateProblem::to_string).collect()
}
