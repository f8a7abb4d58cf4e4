use super::*;
use crate::assembly::{Domain, mass_per_length};
use crate::material::{ElasticLaw, Material};
use crate::mesh::generate::{Rectangle, Tube};
use crate::mesh::{SectionCell, SectionMesh};
use crate::section::CellMaterial;
use crate::section::samples::of_quadrilaterals;
use approx::assert_relative_eq;
use nalgebra::Vector3;
use shared_geom::error::SourceLocation;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::quadrature;
use shared_geom::section::InitialCurvature;
use std::f64::consts::PI;

/// The section of a mesh in which the cells with a center that `is_second` accepts are a
/// second region of a second material; densities 2 and 5.
fn section(mesh: &Mesh, is_second: impl Fn([f64; 2]) -> bool) -> Section {
    let (mut mesh, _) =
        SectionMesh::from_mesh(mesh, 1.0, &SourceLocation::file("test")).expect("sound");
    let material = |density: f64| Material {
        name: density.to_string(),
        law: ElasticLaw::Isotropic {
            young: 1.0,
            poisson: 0.3,
        },
        density,
        expansion: None,
        electric: None,
    };
    mesh.groups = vec!["first".into(), "second".into()];
    let middles: Vec<_> = mesh.cells.iter().map(|cell| mesh.middle(cell)).collect();
    for (cell, middle) in mesh.cells.iter_mut().zip(middles) {
        cell.group = usize::from(is_second(middle));
    }
    let cells = mesh.cells.iter().map(|cell| CellMaterial {
        material: cell.group,
        fiber_angle: 0.0,
        plane_angle: 0.0,
    });
    Section {
        name: "sample".into(),
        cells: cells.collect(),
        materials: vec![material(2.0), material(5.0)],
        mesh,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

fn rectangle(width: f64, height: f64, kind: CellKind) -> Mesh {
    Rectangle {
        width,
        height,
        cells_y: 4,
        cells_z: 4,
        kind,
        name: "bar".into(),
    }
    .generate()
    .expect("sound measures")
}

fn assert_moments(found: SecondMoments, [yy, zz, yz]: [f64; 3], tolerance: f64) {
    assert_relative_eq!(found.yy, yy, max_relative = tolerance);
    assert_relative_eq!(found.zz, zz, max_relative = tolerance);
    assert_relative_eq!(found.yz, yz, epsilon = tolerance * yy.max(zz));
}

/// A rectangle a x b at (p, q): I = b h^3/12 about its centroid, and the theorem of
/// parallel axes. Its upper half is a separate region. Round-off only.
#[test]
fn rectangles_have_their_closed_forms_with_all_kinds_of_cells() {
    let (a, b, p, q) = (0.6, 0.4, 2.0, -3.0);
    for kind in CellKind::ALL {
        let mut section = section(&rectangle(a, b, kind), |[_, z]| z > 0.0);
        for [y, z] in &mut section.mesh.nodes {
            (*y, *z) = (*y + p, *z + q);
        }
        let table = AreaTable::by_group(&section);
        let total = &table.total;
        let area = a * b;
        assert_relative_eq!(total.area, area, max_relative = 1e-14);
        assert_relative_eq!(total.centroid[0], p, max_relative = 1e-14);
        assert_relative_eq!(total.centroid[1], q, max_relative = 1e-14);
        assert_relative_eq!(total.first[0], area * p, max_relative = 1e-14);
        assert_relative_eq!(total.first[1], area * q, max_relative = 1e-14);
        let [yy, zz] = [a * b.powi(3) / 12.0, a.powi(3) * b / 12.0];
        assert_moments(total.central, [yy, zz, 0.0], 1e-13);
        let about = [yy + area * q * q, zz + area * p * p, area * p * q];
        assert_moments(total.second, about, 1e-13);
        assert_eq!(total.perimeter.outer.len(), 1);
        assert_relative_eq!(
            total.perimeter.length(),
            2.0 * (a + b),
            max_relative = 1e-14
        );

        let [lower, upper] = &table.regions[..] else {
            panic!("two regions")
        };
        assert_eq!(
            (lower.name.as_str(), upper.name.as_str()),
            ("first", "second")
        );
        assert_eq!(lower.cells + upper.cells, total.cells);
        assert_relative_eq!(upper.centroid[1], q + b / 4.0, max_relative = 1e-14);
        assert_moments(upper.central, [yy / 8.0, zz / 2.0, 0.0], 1e-13);
        assert_relative_eq!(upper.perimeter.length(), 2.0 * a + b, max_relative = 1e-14);
        assert_relative_eq!(lower.mass, area / 2.0 * 2.0, max_relative = 1e-14);
        assert_relative_eq!(upper.mass, area / 2.0 * 5.0, max_relative = 1e-14);
        assert_relative_eq!(total.mass, lower.mass + upper.mass, max_relative = 1e-14);
    }
}

/// A tube whose sides are parabolas through points of the circles. Compared with an arc of
/// angle 2 h (here 2 pi/48) a parabola lacks h^5/30 of r^2: h^4/30 of the area, h^4/15 of
/// second moments, less of lengths. Halves are without a hole.
#[test]
fn tubes_have_an_outline_and_a_hole() {
    let (outer, inner) = (1.0, 0.8);
    let tolerance = (PI / 48.0).powi(4) / 12.0;
    let tube = Tube {
        outer_radius: outer,
        thickness: outer - inner,
        cells_around: 48,
        cells_through: 2,
        kind: CellKind::Quadrilateral8,
        curved: true,
    };
    let table = AreaTable::by_group(&section(&tube.generate().unwrap(), |[_, z]| z > 0.0));
    let total = &table.total;
    let ring = |power: i32| PI * (f64::powi(outer, power) - f64::powi(inner, power));
    assert_relative_eq!(total.area, ring(2), max_relative = tolerance);
    assert_moments(
        total.central,
        [ring(4) / 4.0, ring(4) / 4.0, 0.0],
        tolerance,
    );
    assert_eq!(
        (total.perimeter.outer.len(), total.perimeter.holes.len()),
        (1, 1)
    );
    assert_relative_eq!(
        total.perimeter.outer_length(),
        2.0 * PI * outer,
        max_relative = tolerance
    );
    assert_relative_eq!(
        total.perimeter.hole_length(),
        2.0 * PI * inner,
        max_relative = tolerance
    );

    let upper = &table.regions[1];
    let height = 2.0 / 3.0 * (outer.powi(3) - inner.powi(3)) / (ring(2) / 2.0);
    assert_relative_eq!(upper.centroid[1], height, max_relative = tolerance);
    assert!(upper.perimeter.holes.is_empty());
    let around = PI * (outer + inner) + 2.0 * (outer - inner);
    assert_relative_eq!(upper.perimeter.length(), around, max_relative = tolerance);
}

fn one_cell(kind: CellKind, nodes: &[[f64; 2]]) -> (SectionMesh, SectionCell) {
    let cell = SectionCell::new(1, kind, 0, |i| i as u32);
    let mesh = SectionMesh {
        nodes: nodes.to_vec(),
        cells: vec![cell],
        ..SectionMesh::default()
    };
    (mesh, cell)
}

/// A triangle (0,0), (2,0), (1,1) whose lower side is the parabola z = -h (2 y - y^2):
/// the moments of the triangle and of the part below it, integrated by hand.
#[test]
fn a_curved_triangle_is_exact() {
    let h = 0.3;
    let nodes = [
        [0.0, 0.0],
        [2.0, 0.0],
        [1.0, 1.0],
        [1.0, -h],
        [1.5, 0.5],
        [0.5, 0.5],
    ];
    let (mesh, cell) = one_cell(CellKind::Triangle6, &nodes);
    let found = AreaMoments::of_cell(&mesh, &cell, [0.0; 2]);
    let area = 1.0 + 4.0 * h / 3.0;
    assert_relative_eq!(found.area, area, max_relative = 1e-14);
    assert_relative_eq!(found.first[0], area, max_relative = 1e-14);
    assert_relative_eq!(
        found.first[1],
        1.0 / 3.0 - 8.0 * h * h / 15.0,
        max_relative = 1e-14
    );
    let yy = 1.0 / 6.0 + 32.0 * h.powi(3) / 105.0;
    let zz = 7.0 / 6.0 + 1.6 * h;
    assert_moments(found.second, [yy, zz, found.first[1]], 1e-14);
    // length of z = -h (2 y - y^2): with u = 2 h, u/2 sqrt(1 + u^2) + asinh(u)/2 for
    // each half, over h
    let u: f64 = 2.0 * h;
    let curve = (0.5 * u * (1.0 + u * u).sqrt() + 0.5 * u.asinh()) / h;
    let perimeter = Perimeter::of(&mesh, &(0..mesh.cells.len()).collect::<Vec<_>>());
    assert_relative_eq!(
        perimeter.length(),
        curve + 2.0 * 2f64.sqrt(),
        max_relative = 1e-14
    );
}

/// A quadrilateral with four curved sides against a rule of four by four points, exact
/// for it: second moments have degree seven in each coordinate.
#[test]
fn a_curved_quadrilateral_is_exact() {
    let nodes: Vec<[f64; 2]> = CellKind::Quadrilateral9
        .reference_nodes()
        .iter()
        .enumerate()
        .map(|(i, &[r, s])| {
            let turn = 1.7 * i as f64;
            [
                3.0 + r + 0.2 * turn.sin(),
                -1.0 + 0.8 * s + 0.2 * turn.cos(),
            ]
        })
        .collect();
    let (mesh, cell) = one_cell(CellKind::Quadrilateral9, &nodes);
    let found = AreaMoments::of_cell(&mesh, &cell, [0.0; 2]);
    let mut sums = [0.0; 6];
    for point in quadrature::quadrilateral(4) {
        let at = crate::element::CellPoint::at(cell.kind, &nodes, point.r, point.s, point.weight);
        let (y, z) = (at.y, at.z);
        for (sum, f) in sums.iter_mut().zip([1.0, y, z, z * z, y * y, y * z]) {
            *sum += at.area * f;
        }
    }
    let second = [found.second.yy, found.second.zz, found.second.yz];
    let all = [found.area, found.first[0], found.first[1]];
    for (found, expected) in all.into_iter().chain(second).zip(sums) {
        assert_relative_eq!(found, expected, max_relative = 1e-13);
    }
}

/// A ply of 1e-4 at 1 from the reference point: its moment about its centroid is 1e-9 of
/// the moment about that point, and keeps the digits of its coordinates (1e-16/1e-4 each,
/// three times).
#[test]
fn a_thin_region_keeps_its_digits() {
    let t = 1e-4;
    let mut section = section(
        &rectangle(1.0, 2.0 * t, CellKind::Quadrilateral4),
        |[_, z]| z > 0.0,
    );
    for [_, z] in &mut section.mesh.nodes {
        *z += 1.0;
    }
    let ply = &AreaTable::by_group(&section).regions[1];
    assert_relative_eq!(ply.central.yy, t.powi(3) / 12.0, max_relative = 1e-11);
}

/// Nine squares in a frame: the middle one left out is a hole; with a corner left out too,
/// the hole touches the outline at a node and belongs to the outline. Two opposite corners
/// left out alone are no holes.
#[test]
fn holes_are_distinguished_from_the_outline() {
    let node = |i: usize, j: usize| (4 * j + i) as u32;
    let nodes: Vec<_> = (0..16).map(|n| [(n % 4) as f64, (n / 4) as f64]).collect();
    let without = |left_out: &[[usize; 2]]| {
        let all = (0..9).map(|n| [n % 3, n / 3]);
        let kept = all.filter(|position| !left_out.contains(position));
        let cells: Vec<_> = kept
            .map(|[i, j]| {
                [
                    node(i, j),
                    node(i + 1, j),
                    node(i + 1, j + 1),
                    node(i, j + 1),
                ]
            })
            .collect();
        AreaTable::by_group(&of_quadrilaterals(&nodes, &cells))
            .total
            .perimeter
    };
    let lines = |outer: &[f64], holes: &[f64]| (outer.to_vec(), holes.to_vec());
    let rounded = |perimeter: Perimeter| {
        let round = |lengths: Vec<f64>| lengths.iter().map(|x| x.round()).collect::<Vec<_>>();
        (round(perimeter.outer), round(perimeter.holes))
    };
    assert_eq!(rounded(without(&[])), lines(&[12.0], &[]));
    assert_eq!(rounded(without(&[[1, 1]])), lines(&[12.0], &[4.0]));
    assert_eq!(rounded(without(&[[1, 1], [2, 2]])), lines(&[16.0], &[]));
    assert_eq!(rounded(without(&[[0, 0], [2, 2]])), lines(&[12.0], &[]));
    assert_eq!(rounded(without(&[[1, 0]])), lines(&[14.0], &[]));
}

/// On a curved beam the mass is per length of the reference line, as in the mass matrix:
/// `rho (A l1 + k2 int z dA - k3 int y dA)` for rectangles off their center.
#[test]
fn mass_is_that_of_the_reference_line() {
    let mut mesh = rectangle(2.0, 1.0, CellKind::Quadrilateral8);
    for node in &mut mesh.nodes {
        node.position[0] -= 1.0;
        node.position[1] += 0.3;
    }
    let mut section = section(&mesh, |[y, _]| y > -1.0);
    section.initial_curvature = InitialCurvature {
        curvature: Vector3::new(0.4, 0.05, 0.25),
        slope: Vector3::new(0.9, 0.1, 0.2),
    };
    let table = AreaTable::by_group(&section);
    // densities 2 and 5, areas of one, centers at y = -1.5 and -0.5, z = 0.3
    for (region, density, y) in [(0, 2.0, -1.5), (1, 5.0, -0.5)] {
        let expected = density * (0.9 + 0.05 * 0.3 - 0.25 * y);
        assert_relative_eq!(table.regions[region].mass, expected, max_relative = 1e-14);
    }
    let domain = Domain::new(&section).expect("sound");
    let matrix = mass_per_length(&domain);
    assert_relative_eq!(table.total.mass, matrix[(0, 0)], max_relative = 1e-13);
}
