//! The estimate of the discretization error against true errors: how far the estimate is from
//! the error, as the ratio of both (the effectivity).
//!
//! True values: the series of the torsion of a rectangle; for the composite box a mesh that is
//! sixteen times finer; for the others the same section refined two or three times more,
//! extrapolated by an eighth to a fourth of the last change, which is less than a tenth of the
//! errors.
//!
//! The ratio is `f (1 - 1/q)` with f = 4/3 and an error that the second analysis divides by q:
//! from 2.5 (plies that end at a corner) to infinity, 0.8 to 1.33, for a stiffness near its limit.
//! Observed are 0.74 to 1.46; the bound is a factor of two.

use std::f64::consts::LN_2;

use nalgebra::{Matrix6, Vector3};
use section_analyzer::analysis::discretization_error;
use section_analyzer::mesh::refined;
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::DiscretizationError;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::InitialCurvature;

use crate::closed_forms::{cells_of, ellipse, rectangle, torsion_constant};
use crate::quads::Quads;
use crate::record;
use crate::reference_cases::{material, number, read_case, read_mesh, section, with_corners_only};
use crate::sections::{isotropic, section_mesh, solved, uniform};

const SOURCE: &str = "Estimate of the discretization error, against errors of the same meshes";

/// Errors relative to `sqrt(Kii Kjj)` that are not compared: round-off of both stiffnesses and
/// of the true values.
const ROUND_OFF: f64 = 1e-9;

/// Fraction of `sqrt(eii ejj)`, e the errors, within which the estimate is accepted for any
/// error of a coupling: it passes through zero on some mesh, and no factor holds there.
const CANCELED: f64 = 0.2;

/// Checks the estimate for `section`, whose exact stiffness is `exact`: within a factor of two
/// of each entry's error, and for weak couplings not less than half of it. The number of
/// entries that were compared.
fn check(case: &str, section: &Section, exact: &Matrix6<f64>) -> usize {
    let found = solved(section).stiffness;
    let estimate = discretization_error(section, &found).expect("a second analysis");
    let errors = found - exact;
    let mut compared = 0;
    for i in 0..6 {
        for j in i..6 {
            let error = errors[(i, j)];
            let root = (exact[(i, i)] * exact[(j, j)]).sqrt();
            if error.abs() <= ROUND_OFF * root {
                assert!(estimate.stiffness[(i, j)].abs() < 10.0 * ROUND_OFF * root);
                continue;
            }
            let size = (errors[(i, i)] * errors[(j, j)]).abs().sqrt();
            let difference = (estimate.stiffness[(i, j)] - error).abs();
            let is_canceled = i != j && difference < CANCELED * size;
            let ratio = estimate.stiffness[(i, j)] / error;
            let cells = section.mesh.cells.len();
            let what = format!("{case}, {cells} cells: K{}{}: {ratio:.2}", i + 1, j + 1);
            if !DiscretizationError::is_of_entry(exact, (i, j)) {
                assert!(ratio.abs() > 0.5 || is_canceled, "{what}");
                continue;
            }
            compared += 1;
            let distance = ratio.ln().abs();
            println!("{what}, error {:.1e}", error / exact[(i, j)]);
            if distance < LN_2 || !is_canceled {
                record::largest(SOURCE, case, "logarithm of the ratio", distance, LN_2);
                assert!(distance < LN_2, "{what}");
            }
        }
    }
    compared
}

/// The section on the refined mesh.
fn finer(section: &Section) -> Section {
    let refined = refined(&section.mesh);
    let cells = refined.originals.iter();
    Section {
        cells: cells.map(|&original| section.cells[original]).collect(),
        mesh: refined.mesh,
        ..section.clone()
    }
}

/// The exact stiffness of a section on its outline: of a mesh refined until its cells are
/// quadratic and then `times` more, plus `part` of the last change.
fn limit(section: &Section, times: usize, part: f64) -> Matrix6<f64> {
    let mut fine = section.clone();
    if !section.mesh.cells[0].kind.is_quadratic() {
        fine = finer(&fine);
    }
    for _ in 1..times {
        fine = finer(&fine);
    }
    let before = solved(&fine).stiffness;
    let last = solved(&finer(&fine)).stiffness;
    last + part * (last - before)
}

/// Smooth solutions but for the corners in torsion, whose exact value is the series; straight,
/// and curved.
#[test]
fn rectangles() {
    let curved = InitialCurvature {
        curvature: Vector3::new(0.2, -0.15, 0.1),
        slope: Vector3::new(0.95, 0.1, -0.05),
    };
    for kind in CellKind::ALL {
        for n in [2, 4] {
            let mesh = rectangle(2.0, 1.0, [2 * n, n], kind);
            let straight = uniform(&mesh, isotropic(1.0, 0.3), 0.0);
            let mut exact = limit(&straight, 2, 1.0 / 15.0);
            exact[(3, 3)] = torsion_constant(2.0, 1.0) / 2.6;
            let case = format!("rectangle, {}", cells_of(kind));
            assert!(check(&case, &straight, &exact) >= 3);
            if n < 4 {
                continue;
            }
            let section = Section {
                initial_curvature: curved,
                ..straight
            };
            let exact = limit(&section, 2, 1.0 / 15.0);
            let case = format!("rectangle of a curved beam, {}", cells_of(kind));
            assert!(check(&case, &section, &exact) >= 12);
        }
    }
}

/// A rectangle without Poisson's ratio has the shear stiffness 5/6 G A exactly, in both directions
/// (Timoshenko & Goodier: parabolic stress over the height, constant over the width). Estimate over
/// error, with one, two and four cells through the height:
///
/// - 1.26, 1.26, 1.32 for the quadrilaterals of 4 nodes, about the same for triangles of 3 (one
///   linear cell through the height is as stiff as a quadratic one, see `discretization_error`),
/// - 1.24 to 1.27 for the quadratic cells.
///
/// The factor f is 4/3; the bounds are an eighth less and a twentieth more, for a second analysis
/// that still has an eighth of the error.
#[test]
fn shear_of_rectangles_with_few_cells_through_the_height() {
    for kind in CellKind::ALL {
        for n in [1, 2, 4] {
            let mesh = rectangle(2.0, 1.0, [2 * n, n], kind);
            let section = uniform(&mesh, isotropic(1.0, 0.0), 0.0);
            let found = solved(&section).stiffness;
            let estimate = discretization_error(&section, &found).expect("a second analysis");
            for i in [1, 2] {
                let exact = 2.0 * 0.5 * 5.0 / 6.0;
                let error = found[(i, i)] - exact;
                let ratio = estimate.stiffness[(i, i)] / error;
                println!("{kind:?}, {n}: K{0}{0}, {error:.1e}, {ratio:.3}", i + 1);
                assert!(ratio > 1.15 && ratio < 1.4, "{kind:?}, {n}, {i}: {ratio}");
            }
        }
    }
}

/// An outline that stays as it is: of parabolas, or of straight sides with linear cells.
#[test]
fn ellipses() {
    for kind in CellKind::ALL {
        let section = uniform(&ellipse(2.0, 1.0, 3, kind), isotropic(1.0, 0.3), 0.0);
        let exact = limit(&section, 2, 1.0 / 8.0);
        let case = format!("ellipse, {}", cells_of(kind));
        assert!(check(&case, &section, &exact) >= 4);
    }
}

/// A box of six plies at 45 and -45 deg, mitred at the corners, with `per_ply` cells through
/// each ply: strong couplings, and singular stresses at the ends of the plies.
fn composite_box(per_ply: usize, along: [usize; 2], kind: CellKind) -> Section {
    let case = read_case("box_CUS_45_m45");
    let (outline, inner) = ([0.0121031, 0.006731], [0.0113411, 0.005969]);
    let through = 6 * per_ply;
    let line = |k: usize| {
        [0, 1].map(|axis| outline[axis] + (inner[axis] - outline[axis]) * k as f64 / through as f64)
    };
    let lines: Vec<_> = (0..=through).map(line).collect();
    let mesh = section_mesh(&Quads::rings(&lines, along).mesh(|_| kind));
    let made_of = |group: usize| {
        let tag = 10 * (group % 4 + 1) + group / 4 / per_ply;
        let group = &case["groups"][tag.to_string()];
        CellMaterial {
            material: group["material"].as_u64().expect("index") as usize,
            fiber_angle: number(&group["fibre_deg"]).to_radians(),
            plane_angle: number(&group["plane_deg"]).to_radians(),
        }
    };
    let materials = case["materials"].as_array().expect("materials");
    Section {
        name: "box".into(),
        cells: mesh.cells.iter().map(|cell| made_of(cell.group)).collect(),
        materials: materials.iter().map(material).collect(),
        mesh,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

#[test]
fn composite_boxes() {
    let fine = |per_ply, along| {
        let section = composite_box(per_ply, along, CellKind::Quadrilateral9);
        solved(&section).stiffness
    };
    let (before, last) = (fine(2, [32, 24]), fine(4, [64, 48]));
    let exact = last + 0.5 * (last - before);
    for kind in CellKind::ALL {
        for along in [[8, 6], [16, 12]] {
            let section = composite_box(1, along, kind);
            let case = format!("box_CUS_45_m45, {}", cells_of(kind));
            assert!(check(&case, &section, &exact) >= 9);
        }
    }
}

/// A blade with a web, of quadratic triangles and of linear ones of the same corners.
fn blade(mesh: &Mesh, cells: &str) {
    let section = section("blade_naca", &read_case("blade_naca"), mesh);
    let exact = limit(&section, 2, 1.0 / 4.0);
    assert!(check(&format!("blade_naca, {cells}"), &section, &exact) >= 13);
}

#[test]
fn blades() {
    let mesh = read_mesh("blade_naca", "v22");
    blade(&mesh, "6-node triangles");
    blade(&with_corners_only(&mesh), "3-node triangles");
}
