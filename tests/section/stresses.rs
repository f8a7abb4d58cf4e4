//! Recovered stresses against independent results and closed forms.
//!
//! # References
//! - [anba4] `tests/reference/sections/README.md`, key `stress_on_this_mesh`: stresses
//!   under each unit load at four points, in the element that contains the point and as its
//!   mean, by an independent solver on the same mesh.
//! - [saint-venant] Timoshenko, Goodier, *Theory of Elasticity*, 3rd ed. 1970, sections
//!   109 (torsion of rectangles) and 122 (flexure of rectangles).

use std::f64::consts::PI;

use nalgebra::{Matrix3, Vector6};
use section_analyzer::material::{DirectionalLimits, MaterialLimits, Strength};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::recovery::{
    LoadCase, Recoverer, Recovery, Tensors, recover, region_failures,
};
use section_analyzer::section::Section;
use section_analyzer::solution::SectionSolution;
use serde_json::Value;
use shared_geom::mesh::CellKind;
use shared_geom::wrench;

use crate::closed_forms::cells_of;
use crate::record;
use crate::reference_cases::{number, read_case, read_mesh, section};
use crate::sections::{isotropic, relative_error, solved, uniform};

const SAINT_VENANT: &str = "Saint-Venant's solutions";

fn load(force: Vector6<f64>) -> LoadCase {
    LoadCase::at_point("load", &force, [0.0; 2])
}

fn unit_load(component: usize) -> LoadCase {
    load(Vector6::ith(component, 1.0))
}

fn recovered(section: &Section, solution: &SectionSolution, load: &LoadCase) -> Recovery {
    recover(section, solution, load).unwrap_or_else(|failure| panic!("{failure}"))
}

/// Our component of the internal force for each component of the files (shear x, shear y,
/// axial, bending x, bending y, torque).
const OUR_LOAD: [usize; 6] = [1, 2, 0, 4, 5, 3];

/// Index in the files for each of our stress components, in the order 11 22 33 23 13 12 in
/// both. Axes 1, 2, 3 of the files are our y, z, x in section axes and our 2, 3, 1 in
/// material axes.
const THEIR_STRESS: [usize; 6] = [2, 0, 1, 5, 3, 4];

fn stress_of(value: &Value) -> Vector6<f64> {
    Vector6::from_fn(|i, _| number(&value[THEIR_STRESS[i]]))
}

/// Checks all stresses of a case that has them. The result on the stored mesh is exact up
/// to round-off: 1e-8 of the largest stress of the load, as for the stiffness.
fn check(name: &str) {
    let case = read_case(name);
    let section = section(name, &case, &read_mesh(name, "v41"));
    let solution = solved(&section);
    let recoverer = Recoverer::new(&section, &solution);
    let stored = &case["stress_on_this_mesh"];
    let positions = stored["points"].as_array().expect("points");
    for (theirs, ours) in OUR_LOAD.into_iter().enumerate() {
        let load = unit_load(ours);
        let recovery = recoverer.recover(&load).expect("a recovery");
        let mut compared = Vec::new();
        for (axes, is_material) in [("global", false), ("local", true)] {
            let expected = &stored["res"][format!("{axes}_{theirs}")];
            let stress = |tensors: &Tensors| {
                if is_material {
                    tensors.material_stress
                } else {
                    tensors.stress
                }
            };
            for (i, position) in positions.iter().enumerate() {
                let position = [number(&position[0]), number(&position[1])];
                let (cell, at) = recoverer.at(&load, position).expect("a point inside");
                let mean = &recovery.cells[cell].tensors;
                compared.push((stress(&at), stress_of(&expected["point"][i])));
                compared.push((stress(mean), stress_of(&expected["element_mean"][i])));
            }
        }
        assert_eq!(compared.len(), 16);
        let largest = compared.iter().fold(0.0_f64, |l, (_, e)| l.max(e.amax()));
        for (found, expected) in compared {
            let error = (found - expected).amax() / largest;
            let source = "ANBA4 and a second solver, on the same mesh";
            let quantity = "stresses under unit loads, both axes, points and cell means";
            record::largest(source, name, quantity, error, 1e-8);
            assert!(error < 1e-8, "{name}, load {ours}: off by {error:e}");
        }
    }
}

/// [anba4] Rectangle 2:1.
#[test]
fn iso_rect_at_the_stored_points() {
    check("iso_rect");
}

/// [anba4] Steel over aluminum.
#[test]
fn bimat_rect_at_the_stored_points() {
    check("bimat_rect");
}

/// [anba4] Fibers at 30 degrees: the material axes differ from the axes of the section.
#[test]
fn ortho_rect_30_at_the_stored_points() {
    check("ortho_rect_30");
}

/// Thin laminated walls and a blade under each unit load: their resultant is the load.
/// About ten thousand points lose at most three digits of the sixteen.
#[test]
fn resultants_are_the_load() {
    for name in ["box_CUS_45_m45", "blade_naca", "vabs_channel", "iso_tube"] {
        let section = section(name, &read_case(name), &read_mesh(name, "v41"));
        let solution = solved(&section);
        let recoverer = Recoverer::new(&section, &solution);
        for component in 0..6 {
            let recovery = recoverer
                .recover(&unit_load(component))
                .expect("a recovery");
            let error = recovery.resultant_error;
            println!("{name}, load {component}: {error:.1e}");
            let source = "Equilibrium of the recovered stresses";
            record::largest(source, name, "resultants under unit loads", error, 1e-12);
            assert!(error < 1e-12, "{name}, load {component}: {error:e}");
        }
    }
}

/// The same section turned by 40 degrees with its plies, under the same force turned:
/// stresses in material axes do not change. Round-off of the solution, 1e-13, and of the
/// turned mesh.
#[test]
fn material_axes_turn_with_the_section() {
    let name = "ortho_rect_30";
    let section = section(name, &read_case(name), &read_mesh(name, "v41"));
    let angle = 40_f64.to_radians();
    let (s, c) = angle.sin_cos();
    let mut turned = section.clone();
    for [y, z] in &mut turned.mesh.nodes {
        (*y, *z) = (c * *y - s * *z, s * *y + c * *z);
    }
    for cell in &mut turned.cells {
        cell.plane_angle += angle;
    }
    let force = Vector6::new(3.0, 1.0, -2.0, 0.2, 0.5, -0.3);
    let axes = Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c);
    let turned_load = load(wrench::rotation_matrix(&axes) * force);
    let here = recovered(&section, &solved(&section), &load(force));
    let there = recovered(&turned, &solved(&turned), &turned_load);
    let largest = here.points.iter().map(|p| p.tensors.stress.amax());
    let largest = largest.fold(0.0, f64::max);
    for (a, b) in here.points.iter().zip(&there.points) {
        let (a, b) = (&a.tensors, &b.tensors);
        let error = (a.material_stress - b.material_stress).amax() / largest;
        let source = "Invariance of the results";
        record::largest(source, "turned", "stresses in material axes", error, 1e-10);
        assert!(error < 1e-10, "{error:e}");
        assert!((a.stress - b.stress).amax() > 1e-3 * a.stress.amax());
    }
}

fn rectangle(width: f64, height: f64, cells: [usize; 2], kind: CellKind, nu: f64) -> Section {
    let mesh = Rectangle {
        width,
        height,
        cells_y: cells[0],
        cells_z: cells[1],
        kind,
        name: "section".into(),
    }
    .generate()
    .expect("sound measures");
    uniform(&mesh, isotropic(1.0, nu), 0.0)
}

/// `sigma_xx = F/A + M_y z/I_y - M_z y/I_z` and no other stress: linear, so that every
/// quadratic cell reproduces it at its points, in its mean and at its nodes to round-off,
/// as does a linear cell without Poisson's ratio.
#[test]
fn bending_is_exact() {
    let (width, height) = (2.0, 0.5);
    let area = width * height;
    let (iy, iz) = (area * height * height / 12.0, area * width * width / 12.0);
    let (axial, my, mz) = (0.3, 0.05, -0.4);
    let load = load(Vector6::new(axial, 0.0, 0.0, 0.0, my, mz));
    let kinds = CellKind::ALL.map(|kind| (kind, if kind.is_quadratic() { 0.3 } else { 0.0 }));
    for (kind, nu) in kinds {
        let section = rectangle(width, height, [6, 3], kind, nu);
        let recovery = recovered(&section, &solved(&section), &load);
        let largest = axial / area + my * height / 2.0 / iy + mz.abs() * width / 2.0 / iz;
        let check = |tensors: &Tensors, [y, z]: [f64; 2]| {
            let xx = axial / area + my * z / iy - mz * y / iz;
            let exact = Vector6::new(xx, 0.0, 0.0, 0.0, 0.0, 0.0);
            let error = (tensors.stress - exact).amax() / largest;
            let quantity = "stresses under extension and bending, all cells";
            record::largest(SAINT_VENANT, "rectangle", quantity, error, 1e-11);
            assert!(error < 1e-11, "{kind:?} {error:e}");
        };
        for point in &recovery.points {
            check(&point.tensors, point.position);
        }
        for cell in &recovery.cells {
            check(&cell.tensors, cell.centroid);
        }
        for node in &recovery.nodes {
            check(&node.tensors, section.mesh.nodes[node.node]);
        }
    }
}

/// [saint-venant] Shear V along z without Poisson's ratio: `tau = 3/2 V/A (1 - 4 z^2/h^2)`,
/// from a warping that is cubic in z only.
///
/// A quadratic cell cannot represent the cubic, so that the parabola is not exact: the
/// discrete tau is its projection on functions linear in each cell. It equals the parabola
/// at the two Gauss points across the cell and in the mean of the cell, both to round-off,
/// and is above it by `V/A (1/n)^2` at the borders of n cells: at the nodes in the middle
/// of the height tau is `3/2 V/A (1 + 2/3 (1/n)^2)`.
#[test]
fn shear_of_a_rectangle_is_the_projected_parabola() {
    let (width, height, cells) = (0.7, 2.0, 4);
    let mean = 1.0 / (width * height);
    let parabola = |z: f64| 1.5 * mean * (1.0 - 4.0 * z * z / (height * height));
    let step = height / cells as f64;
    for kind in [CellKind::Quadrilateral8, CellKind::Quadrilateral9] {
        let section = rectangle(width, height, [3, cells], kind, 0.0);
        let solution = solved(&section);
        let recoverer = Recoverer::new(&section, &solution);
        let load = unit_load(2);
        let recovery = recoverer.recover(&load).expect("a recovery");
        let near = |found: f64, exact: f64, what: &str| {
            let error = (found - exact).abs() / mean;
            let quantity = format!("projected parabola of shear stress, {what}");
            record::largest(SAINT_VENANT, "rectangle", &quantity, error, 1e-11);
            assert!(error < 1e-11, "{kind:?}, {what}: {error:e}");
        };
        for cell in &recovery.cells {
            let [y, z] = cell.centroid;
            // the mean of z^2 over the cell
            let of_mean = parabola((z * z + step * step / 12.0).sqrt());
            near(cell.tensors.stress[4], of_mean, "mean");
            for side in [-1.0, 1.0] {
                let position = [y + 0.1 * step, z + side * step / 12f64.sqrt()];
                let (_, at) = recoverer.at(&load, position).expect("a point inside");
                near(at.stress[4], parabola(position[1]), "Gauss point");
            }
        }
        let middle = recovery.nodes.iter().filter(|node| {
            let [_, z] = section.mesh.nodes[node.node];
            z.abs() < 1e-9
        });
        let above = mean * (1.0 / cells as f64).powi(2);
        let middle: Vec<_> = middle.collect();
        assert!(middle.len() >= 4);
        for node in middle {
            near(node.tensors.stress[4], 1.5 * mean + above, "middle");
        }
    }
}

/// [saint-venant] Largest shear stress of a square of side a under the torque T, in the
/// middle of a side: `tau = k/J T/a^3` with
///
/// ```text
/// k = 1 - 8/pi^2 sum 1/(n^2 cosh(n pi/2))
/// J = 1/3 (1 - 192/pi^5 sum tanh(n pi/2)/n^5)          n = 1, 3, 5 ..
/// ```
///
/// 0.675314/0.140577 = 4.80388. The stress of quadratic cells is of the second order in the
/// cell size, also in the middle of a side, at the boundary. In square cells the order is
/// four: the fit drops equal parts of the second derivatives of tau along y and along z,
/// which cancel, since tau is harmonic.
#[test]
fn torsion_of_a_square() {
    let odd = (0..40).map(|i| f64::from(2 * i + 1));
    let cosh = odd.clone().map(|n| 1.0 / (n * n * (0.5 * n * PI).cosh()));
    let tanh = odd.map(|n| (0.5 * n * PI).tanh() / n.powi(5));
    let k = 1.0 - 8.0 / PI.powi(2) * cosh.sum::<f64>();
    let j = (1.0 - 192.0 / PI.powi(5) * tanh.sum::<f64>()) / 3.0;
    let exact = k / j;
    assert!((exact - 4.80388).abs() < 5e-6, "{exact}");
    // least order, and largest error of 32 cells a side: (1/32)^2 and (1/32)^4 are 1e-3
    // and 1e-6, before factors of the order of one
    for (kind, least_order, largest) in [
        (CellKind::Triangle6, 1.9, 1e-3),
        (CellKind::Quadrilateral8, 3.8, 1e-5),
        (CellKind::Quadrilateral9, 3.8, 1e-5),
    ] {
        let found = [8, 16, 32].map(|cells| {
            let section = rectangle(1.0, 1.0, [cells, cells], kind, 0.3);
            let recovery = recovered(&section, &solved(&section), &unit_load(3));
            let node = recovery.nodes.iter().find(|node| {
                let [y, z] = section.mesh.nodes[node.node];
                (y - 0.5).abs() < 1e-9 && z.abs() < 1e-9
            });
            let tensors = node.expect("a node in the middle of the side").tensors;
            tensors.stress[4]
        });
        let errors = found.map(|tau| relative_error(tau, exact));
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            let quantity = format!(
                "largest shear stress of torsion, order of {}",
                cells_of(kind)
            );
            record::order(SAINT_VENANT, "square", &quantity, order, least_order);
            assert!(order > least_order, "{kind:?}: order {order}");
        }
        let quantity = format!("largest shear stress a^3/T of torsion, {}", cells_of(kind));
        let compared = [found[2], exact];
        record::value(
            SAINT_VENANT,
            "square",
            &quantity,
            compared,
            errors[2],
            largest,
        );
        assert!(errors[2] < largest, "{kind:?}: {:e}", errors[2]);
        // a stored numerical result, with its own tolerance
        let stored = stored_square_torsion();
        let error = relative_error(found[2], stored[0]);
        let compared = [found[2], stored[0]];
        let source = "A stored numerical solution of square torsion, 0.1 % above the series";
        record::value(source, "square", &quantity, compared, error, stored[1]);
        assert!(error < stored[1], "{kind:?}");
    }
}

/// Largest shear stress per torque of a unit square, and its tolerance.
fn stored_square_torsion() -> [f64; 2] {
    let file = "tests/reference/theory/straight_isotropic.json";
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let text = std::fs::read_to_string(path).expect("the reference file");
    let stored: Value = serde_json::from_str(&text).expect("reference in JSON");
    let square = &stored["square_torsion"];
    [
        number(&square["tau_max_per_unit_torque"]),
        number(&square["tolerance"]),
    ]
}

/// A load times the reserve factor of a section is the load at which its governing index is
/// one; `Tsai-Wu` is not linear in it. Round-off of the recovery.
#[test]
fn reserve_factor_is_that_of_the_load() {
    let name = "ortho_rect_30";
    let section = section(name, &read_case(name), &read_mesh(name, "v41"));
    let solution = solved(&section);
    let limits = [MaterialLimits {
        strength: Some(Strength::Ply {
            limits: DirectionalLimits {
                tension: [1500e6, 50e6, 50e6],
                compression: [1200e6, 200e6, 200e6],
                shear: [100e6, 70e6, 70e6],
            },
            interaction: [-0.5; 3],
        }),
        ..MaterialLimits::default()
    }];
    let force = Vector6::new(2e3, 500.0, -300.0, 20.0, 60.0, -40.0);
    let worst = region_failures(
        &section,
        &limits,
        &recovered(&section, &solution, &load(force)),
    );
    assert_eq!(worst.len(), 3);
    for failure in worst {
        let factor = failure.worst.reserve_factor;
        let recovery = recovered(&section, &solution, &load(factor * force));
        let again = region_failures(&section, &limits, &recovery);
        let same = again
            .iter()
            .find(|f| f.worst.criterion == failure.worst.criterion);
        let index = same.expect("the same criterion").worst.index;
        let criterion = format!("{:?}: index at the reserve factor", failure.worst.criterion);
        let error = (index - 1.0).abs();
        let source = "Definition of the reserve factor";
        record::value(source, name, &criterion, [index, 1.0], error, 1e-10);
        assert!(error < 1e-10, "{:?} {index}", failure.worst);
    }
}
