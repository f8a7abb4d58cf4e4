//! The reference sections with other cells than their meshes: 8- and 9-node quadrilaterals,
//! and both with 6-node triangles in one mesh, against the converged values.
//!
//! Source: `converged` in `tests/reference/sections`, extrapolated from refinements of
//! 6-node triangles by an independent program, with an uncertainty for each entry.
//! The meshes are made here; only materials, angles and results are read.

use nalgebra::Matrix6;
use section_analyzer::mesh::generate::{Ellipse, Tube};
use section_analyzer::section::{CellMaterial, Section};
use serde_json::Value;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::InitialCurvature;

use crate::closed_forms::cells_of;
use crate::quads::{Quads, graded, joined, steps};
use crate::record;
use crate::reference_cases::{material, matrix, number, read_case};
use crate::sections::{section_mesh, solved};

pub const CONVERGED: &str = "Converged values of an independent program, from other meshes";

/// Records the entry of the stiffness nearest to its bound.
pub fn record_nearest(what: &str, error: &Matrix6<f64>, bound: &Matrix6<f64>) {
    let ratio = error.component_div(bound);
    // round-off does not choose between entries that symmetry makes equal
    let nearest = ratio.iter().position(|&r| r >= 0.99 * ratio.max());
    let nearest = nearest.expect("a largest entry");
    record::largest(CONVERGED, what, "stiffness", error[nearest], bound[nearest]);
}

/// The cells of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Cells {
    Eight,
    Nine,
    Mixed,
}

const ALL: [Cells; 3] = [Cells::Eight, Cells::Nine, Cells::Mixed];

impl Cells {
    fn name(self) -> &'static str {
        match self {
            Self::Eight => "8-node quadrilaterals",
            Self::Nine => "9-node quadrilaterals",
            Self::Mixed => "mixed cells",
        }
    }

    fn kind(self, index: usize) -> CellKind {
        let mixed = [
            CellKind::Triangle6,
            CellKind::Quadrilateral8,
            CellKind::Quadrilateral9,
        ];
        match self {
            Self::Eight => CellKind::Quadrilateral8,
            Self::Nine => CellKind::Quadrilateral9,
            // 7 and 3 have no common factor: kinds change from row to row
            Self::Mixed => mixed[(index + index / 7) % 3],
        }
    }
}

/// The section of a case on `mesh`, whose group g is group number `tag(g)` of the case.
fn section(case: &Value, mesh: &Mesh, tag: impl Fn(usize) -> usize) -> Section {
    let mesh = section_mesh(mesh);
    let cells = mesh.cells.iter().map(|cell| {
        let group = &case["groups"][tag(cell.group).to_string()];
        CellMaterial {
            material: group["material"].as_u64().expect("index") as usize,
            fiber_angle: number(&group["fibre_deg"]).to_radians(),
            plane_angle: number(&group["plane_deg"]).to_radians(),
        }
    });
    let materials = case["materials"].as_array().expect("materials");
    Section {
        name: case["case"].to_string(),
        cells: cells.collect(),
        materials: materials.iter().map(material).collect(),
        mesh,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

/// Checks the stiffness of a case: each entry within its uncertainty and `tolerance`
/// of `sqrt(K_ii K_jj)`.
fn check(name: &str, shape: &Quads, tag: impl Fn(usize) -> usize, tolerance: f64) {
    let case = read_case(name);
    for cells in ALL {
        let mesh = shape.mesh(|index| cells.kind(index));
        let section = section(&case, &mesh, &tag);
        check_stiffness(
            &format!("{name}, {}", cells.name()),
            &section,
            &case,
            tolerance,
        );
    }
}

fn check_stiffness(what: &str, section: &Section, case: &Value, tolerance: f64) {
    let solution = solved(section);
    check_shear_center(
        what,
        section,
        case,
        solution.centers.shear,
        10.0 * tolerance,
    );
    let found = solution.stiffness;
    let expected = matrix(&case["converged"]["K"]);
    let uncertainty = matrix(&case["converged"]["uncertainty_abs"]);
    let scaled =
        |i: usize, j: usize, value: f64| value / (expected[(i, i)] * expected[(j, j)]).sqrt();
    let difference = (found - expected).abs();
    let beyond = Matrix6::from_fn(|i, j| scaled(i, j, difference[(i, j)] - uncertainty[(i, j)]));
    let error = Matrix6::from_fn(|i, j| scaled(i, j, difference[(i, j)]));
    println!(
        "{what}: {} cells, off by {:.1e}, beyond the uncertainty by {:.1e}",
        section.mesh.cells.len(),
        error.max(),
        beyond.max()
    );
    let bound = Matrix6::from_fn(|i, j| scaled(i, j, uncertainty[(i, j)]) + tolerance);
    record_nearest(what, &error, &bound);
    assert!(
        beyond.max() <= tolerance,
        "{what}: {:.2e} beyond",
        beyond.max()
    );
}

/// The shear center of the converged solution, within `limit` of the size of the section: a
/// ratio of two uncertain entries, without an uncertainty in the reference.
fn check_shear_center(what: &str, section: &Section, case: &Value, found: [f64; 2], limit: f64) {
    let positions = section.mesh.nodes.iter().flatten();
    let size = positions.fold(0.0_f64, |size, x| size.max(x.abs()));
    for axis in 0..2 {
        let expected = number(&case["converged"]["shear_centre"][axis]);
        let error = (found[axis] - expected).abs() / size;
        record::largest(CONVERGED, what, "shear center", error, limit);
        assert!(error < limit, "{what}: shear center off by {error:e}");
    }
}

/// Allowance in addition to the uncertainty: the uncertainty is an estimate from two or
/// three meshes, and a mixed mesh has small couplings that are zero by symmetry (with zero
/// uncertainty).
const SMOOTH: f64 = 2e-6;

/// The same for boxes, whose entries have an uncertainty of 1e-3 to 6e-3 due to the corners
/// of their plies, and for which these meshes have errors of 5e-4.
const LAMINATED: f64 = 1e-4;

fn rectangle(name: &str, [width, height]: [f64; 2], cells: [usize; 2]) {
    let lines = |size: f64, count| steps(-size / 2.0, size / 2.0, count);
    let shape = Quads::lattice(&lines(width, cells[0]), &lines(height, cells[1]), |_| {
        Some(0)
    });
    check(name, &shape, |_| 1, SMOOTH);
}

#[test]
fn isotropic_rectangles() {
    rectangle("iso_rect", [0.2, 0.1], [24, 16]);
    rectangle("iso_rect_thin", [0.2, 0.02], [80, 12]);
    rectangle("iso_square", [0.1, 0.1], [16, 16]);
}

#[test]
fn orthotropic_rectangles() {
    for name in ["ortho_rect_0", "ortho_rect_15", "ortho_rect_30"] {
        rectangle(name, [0.1, 0.04], [32, 16]);
    }
    for name in ["becas_S3_0", "becas_S3_90"] {
        rectangle(name, [0.1, 0.1], [16, 16]);
    }
}

/// Two materials, whose border ends in singular corners at the outline: lines are
/// graded towards the border.
#[test]
fn rectangles_of_two_materials() {
    let halves = |size: f64, cells| joined(&[graded(-size, 0.0, cells), graded(0.0, size, cells)]);
    let y = graded(-0.05, 0.05, 24);
    let shape = Quads::lattice(&y, &halves(0.1, 24), |[_, z]| Some(usize::from(z > 0.0)));
    check("bimat_rect", &shape, |group| group + 1, SMOOTH);
    let shape = Quads::lattice(&halves(0.05, 24), &y, |[y, _]| Some(usize::from(y > 0.0)));
    check("becas_S2", &shape, |group| group + 1, SMOOTH);
}

/// Channels with singular re-entrant corners: lines are graded towards them.
#[test]
fn channels() {
    let (t, b, h) = (0.004, 0.05, 0.05);
    let y = joined(&[graded(0.0, t, 6), graded(t, b, 24)]);
    let flange = |from| graded(from, from + t, 6);
    let z = joined(&[flange(-h), graded(-h + t, h - t, 30), flange(h - t)]);
    let shape = Quads::lattice(&y, &z, |[y, z]| (y < t || z.abs() > h - t).then_some(0));
    check("iso_channel", &shape, |_| 1, SMOOTH);

    // the upper flange is half as long as the lower one
    let (t, b, h) = (0.001524, 0.0254, 0.0127);
    let y = joined(&[
        graded(0.0, t, 6),
        graded(t, b / 2.0, 12),
        graded(b / 2.0, b, 12),
    ]);
    let flange = |from| graded(from, from + t, 6);
    let z = joined(&[flange(-h), graded(-h + t, h - t, 24), flange(h - t)]);
    let shape = Quads::lattice(&y, &z, |[y, z]| {
        (y < t || z < -h + t || (z > h - t && y < b / 2.0)).then_some(0)
    });
    check("vabs_channel", &shape, |_| 1, SMOOTH);
}

/// Cells through each ply of a box, and along its walls.
const PER_PLY: usize = 2;
const ALONG: [usize; 2] = [48, 32];

/// Boxes of six plies with mitred corners; half sizes of the outline and thickness of
/// all plies in meters or inches. The groups are ten times the wall (top, left, bottom,
/// right) and the ply from the outside.
fn check_box(name: &str, outline: [f64; 2], inner: [f64; 2]) {
    let plies = 6;
    let through = PER_PLY * plies;
    let line = |k: usize| {
        [0, 1].map(|axis| outline[axis] + (inner[axis] - outline[axis]) * k as f64 / through as f64)
    };
    let lines: Vec<_> = (0..=through).map(line).collect();
    let shape = Quads::rings(&lines, ALONG);
    let tag = |group: usize| 10 * (group % 4 + 1) + group / 4 / PER_PLY;
    check(name, &shape, tag, LAMINATED);
}

#[test]
fn boxes() {
    let (outline, inner) = ([0.0121031, 0.006731], [0.0113411, 0.005969]);
    for name in ["box_CUS_15", "box_CAS_15", "box_CUS_45_m45"] {
        check_box(name, outline, inner);
    }
    check_box("vabs_box_cus_15_psi", [0.4765, 0.265], [0.4465, 0.235]);
}

/// Curved outlines, which are polygons in the stored meshes: here parabolas.
#[test]
fn round_sections() {
    for kind in [CellKind::Quadrilateral8, CellKind::Quadrilateral9] {
        let ellipse = Ellipse {
            semi_y: 0.1,
            semi_z: 0.05,
            cells: 12,
            kind,
            curved: true,
        };
        let tube = |outer_radius, thickness| Tube {
            outer_radius,
            thickness,
            cells_around: 64,
            cells_through: 6,
            kind,
            curved: true,
        };
        let meshes = [
            ("iso_ellipse", ellipse.generate()),
            ("iso_tube", tube(0.1, 0.01).generate()),
            ("iso_tube_thick", tube(0.3, 0.2).generate()),
        ];
        for (name, mesh) in meshes {
            let case = read_case(name);
            let section = section(&case, &mesh.expect("sound measures"), |_| 1);
            check_stiffness(
                &format!("{name}, {}", cells_of(kind)),
                &section,
                &case,
                SMOOTH,
            );
        }
    }
}
