//! Invariances: the same section in other units, at another position, turned, or with its
//! nodes and cells in another order.
//!
//! All comparisons are relative to `sqrt(K_ii K_jj)`. The tolerance of 1e-10 is the
//! specified accuracy for any units; round-off is 1e-13.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use section_analyzer::material::{ElasticLaw, EngineeringConstants, Material};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::mesh::{SectionCell, SectionMesh};
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::SectionSolution;
use shared_geom::mesh::CellKind;
use shared_geom::section::InitialCurvature;
use shared_geom::wrench;

use crate::record;
use crate::sections::{isotropic, orthotropic, scaled_error, section_mesh, solved};

const TOLERANCE: f64 = 1e-10;

/// The source as named on the validation page.
const SELF: &str = "Invariance of the results";

const PLY: EngineeringConstants = EngineeringConstants {
    e1: 142.0,
    e2: 9.8,
    e3: 9.1,
    g12: 6.0,
    g13: 5.5,
    g23: 4.8,
    nu12: 0.3,
    nu13: 0.34,
    nu23: 0.42,
};

/// A bar 1 x 0.4: below the middle plies at angles that change from cell to cell,
/// above it a filler a hundred times softer.
fn bar() -> Section {
    let mesh = Rectangle {
        width: 1.0,
        height: 0.4,
        cells_y: 8,
        cells_z: 4,
        kind: CellKind::Quadrilateral8,
        name: "bar".into(),
    }
    .generate()
    .expect("sound measures");
    let mesh = section_mesh(&mesh);
    let cell = |index: usize| CellMaterial {
        material: usize::from(index >= mesh.cells.len() / 2),
        fiber_angle: 0.4 + 0.1 * (index % 5) as f64,
        plane_angle: 0.05 * (index % 7) as f64,
    };
    Section {
        name: "bar".into(),
        cells: (0..mesh.cells.len()).map(cell).collect(),
        materials: vec![orthotropic(PLY), isotropic(1.4, 0.3)],
        mesh,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

fn moved(section: &Section, position: impl Fn([f64; 2]) -> [f64; 2]) -> Section {
    let mut moved = section.clone();
    for node in &mut moved.mesh.nodes {
        *node = position(*node);
    }
    moved
}

/// The material with all moduli multiplied by `factor`.
fn stiffened(material: &Material, factor: f64) -> Material {
    Material {
        law: ElasticLaw::Full(factor * material.law.stiffness()),
        ..material.clone()
    }
}

/// Lengths from 1 mm to 10 m, moduli from 1 Pa to 1 TPa: forces scale with modulus
/// times length squared, moments with one length more.
#[test]
fn units_do_not_matter() {
    let section = bar();
    let plain = solved(&section);
    for length in [1e-3, 0.3, 10.0] {
        for modulus in [1e-2, 7e4, 1e10] {
            let mut scaled = moved(&section, |[y, z]| [length * y, length * z]);
            let materials = section.materials.iter();
            scaled.materials = materials.map(|m| stiffened(m, modulus)).collect();
            let found = solved(&scaled);

            let unit = Vector6::new(1.0, 1.0, 1.0, length, length, length);
            let unit = modulus * length * length * (unit * unit.transpose());
            let expected = plain.stiffness.component_mul(&unit);
            let error = scaled_error(&found.stiffness, &expected);
            println!("length {length}, modulus {modulus:e}: {error:.1e}");
            record::largest(SELF, "other units", "stiffness", error, TOLERANCE);
            assert!(
                error < TOLERANCE,
                "length {length}, modulus {modulus:e}: {error:e}"
            );
            let compliance = plain.compliance.component_mul(&unit.map(|u| 1.0 / u));
            assert!(scaled_error(&found.compliance, &compliance) < TOLERANCE);
            check_centers(&plain, &found, |[y, z]| [length * y, length * z], length);
        }
    }
}

fn check_centers(
    plain: &SectionSolution,
    found: &SectionSolution,
    position: impl Fn([f64; 2]) -> [f64; 2],
    size: f64,
) {
    let of = |s: &SectionSolution| {
        let mass = s.centers.mass.expect("has mass");
        [s.centers.tension, s.centers.shear, mass]
    };
    for (plain, found) in of(plain).into_iter().zip(of(found)) {
        let expected = position(plain);
        for axis in 0..2 {
            let error = (found[axis] - expected[axis]).abs() / size;
            assert!(error < TOLERANCE, "{found:?} against {expected:?}");
        }
    }
}

/// The mesh moved away by d: K and M transport exactly, `K' = U(-d) K U(-d)'`. At a
/// distance of a thousand sizes, coordinates keep 13 digits.
#[test]
fn position_does_not_matter() {
    let section = bar();
    let plain = solved(&section);
    for d in [[0.3, -0.2], [-7.0, 12.0], [1000.0, 500.0]] {
        let found = solved(&moved(&section, |[y, z]| [y + d[0], z + d[1]]));
        let back = -Vector3::new(0.0, d[0], d[1]);
        let error = scaled_error(&found.stiffness, &wrench::shift(&plain.stiffness, &back));
        println!("moved by {d:?}: {error:.1e}");
        record::largest(SELF, "another position", "stiffness", error, TOLERANCE);
        assert!(error < TOLERANCE, "moved by {d:?}: {error:e}");
        assert!(scaled_error(&found.mass, &wrench::shift(&plain.mass, &back)) < TOLERANCE);
        check_centers(&plain, &found, |[y, z]| [y + d[0], z + d[1]], 1.0);
        let (one, two) = (plain.principal_bending, found.principal_bending);
        assert!((one.angle - two.angle).abs() < TOLERANCE);
        assert!((one.first / two.first - 1.0).abs() < TOLERANCE);
    }
}

/// The section turned about x by phi, with its wall angles: K in turned axes. The pins are
/// then at other nodes.
#[test]
fn direction_does_not_matter() {
    let section = bar();
    let plain = solved(&section);
    for phi in [0.2_f64, 1.1, 2.9, -1.3] {
        let (s, c) = phi.sin_cos();
        let mut turned = moved(&section, |[y, z]| [c * y - s * z, s * y + c * z]);
        for cell in &mut turned.cells {
            cell.plane_angle += phi;
        }
        let found = solved(&turned);
        // old axes in the new ones: v' = Q' v with Q the inverse turn
        let q = Matrix3::new(1.0, 0.0, 0.0, 0.0, c, s, 0.0, -s, c);
        let expected: Matrix6<f64> = wrench::rotate(&plain.stiffness, &q);
        let error = scaled_error(&found.stiffness, &expected);
        println!("turned by {phi}: {error:.1e}");
        record::largest(SELF, "turned", "stiffness", error, TOLERANCE);
        assert!(error < TOLERANCE, "turned by {phi}: {error:e}");
        assert!(scaled_error(&found.mass, &wrench::rotate(&plain.mass, &q)) < TOLERANCE);
    }
}

/// Nodes and cells in another order.
#[test]
fn order_does_not_matter() {
    let section = bar();
    let mesh = &section.mesh;
    let n = mesh.nodes.len();
    // 7 has no factor in common with the numbers of nodes and cells of this mesh
    let new_node = |old: usize| (7 * old + 3) % n;
    let old_cell = |new: usize| (7 * new + 2) % mesh.cells.len();
    let mut nodes = vec![[0.0; 2]; n];
    let mut node_tags = vec![0; n];
    for old in 0..n {
        nodes[new_node(old)] = mesh.nodes[old];
        node_tags[new_node(old)] = mesh.node_tags[old];
    }
    let cells = (0..mesh.cells.len()).map(|new| {
        let cell = &mesh.cells[old_cell(new)];
        SectionCell::new(cell.tag, cell.kind, cell.group, |i| {
            new_node(cell.nodes()[i] as usize) as u32
        })
    });
    let shuffled = Section {
        name: "shuffled".into(),
        mesh: SectionMesh {
            nodes,
            node_tags,
            cells: cells.collect(),
            groups: mesh.groups.clone(),
            curves: Vec::new(),
        },
        cells: (0..mesh.cells.len())
            .map(|new| section.cells[old_cell(new)])
            .collect(),
        materials: section.materials.clone(),
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    };
    let (plain, found) = (solved(&section), solved(&shuffled));
    let error = scaled_error(&found.stiffness, &plain.stiffness);
    record::largest(SELF, "renumbered", "stiffness", error, TOLERANCE);
    assert!(error < TOLERANCE, "{error:e}");
    // the warping follows the nodes
    for old in 0..n {
        let one = plain.warping.rows(3 * old, 3);
        let two = found.warping.rows(3 * new_node(old), 3);
        assert!((one - two).amax() < TOLERANCE * plain.warping.amax());
    }
}

/// The same run twice gives the same bits.
#[test]
fn runs_repeat_to_the_last_bit() {
    let (one, two) = (solved(&bar()), solved(&bar()));
    assert_eq!(one.stiffness, two.stiffness);
    assert_eq!(one.warping, two.warping);
}
