//! Beams of constant initial curvature and twist.
//!
//! # References
//! - [golovin] Timoshenko, Goodier, *Theory of Elasticity*, 3rd ed. 1970, articles 29
//!   and 33: pure bending of a curved bar and a curved bar loaded at its end, both of
//!   rectangular section, in plane stress (Golovin 1881).
//! - [Borri1992]: the central solutions.
//! - The first-order coupling of a pretwisted isotropic bar, `K14 = E k1 (Ip - J)`, by
//!   perturbation: `E int (z w,y - y w,z) dA` with w the warping of torsion.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use section_analyzer::analysis::analyze;
use section_analyzer::failure::Failure;
use section_analyzer::material::EngineeringConstants;
use section_analyzer::mesh::generate::{Ellipse, Rectangle, Tube};
use section_analyzer::recovery::{LoadCase, Recoverer};
use section_analyzer::section::Section;
use section_analyzer::solution::SectionSolution;
use serde::Deserialize;
use shared_geom::mesh::{CellKind, Mesh};
use shared_geom::section::InitialCurvature;
use shared_geom::wrench;

use crate::record;
use crate::sections::{isotropic, orthotropic, relative_error, scaled_error, solved, uniform};

// The sources as named on the validation page.
const GOLOVIN: &str = "Golovin's curved bar";
const PRETWIST: &str = "Pretwisted bars, first order";
const FRAME: &str = "The same beam in another frame";

const FILE: &str = "tests/reference/theory/curved_twisted.json";

/// The section with other initial curvature and slope.
pub fn along(section: &Section, curvature: [f64; 3], slope: [f64; 3]) -> Section {
    Section {
        initial_curvature: InitialCurvature {
            curvature: curvature.into(),
            slope: slope.into(),
        },
        ..section.clone()
    }
}

pub fn curved(section: &Section, curvature: [f64; 3]) -> Section {
    along(section, curvature, [1.0, 0.0, 0.0])
}

pub fn rectangle(width: f64, height: f64, cells: [usize; 2]) -> Mesh {
    Rectangle {
        width,
        height,
        cells_y: cells[0],
        cells_z: cells[1],
        kind: CellKind::Quadrilateral9,
        name: "bar".into(),
    }
    .generate()
    .expect("sound measures")
}

/// A solution whose checks are at round-off: the identities, the symmetry of the strains
/// and their equality with the energy.
pub fn sound(section: &Section) -> SectionSolution {
    let solution = solved(section);
    let checks = &solution.checks;
    for error in checks.identities {
        assert!(error < 1e-12, "{checks:?}");
    }
    for error in [checks.equilibrium, checks.asymmetry, checks.decoupling] {
        assert!(error < 1e-11, "{checks:?}");
    }
    solution
}

#[derive(Deserialize)]
struct Ring {
    #[serde(rename = "R")]
    radius: f64,
    h_y: f64,
    w_z: f64,
    #[serde(rename = "exact_C22")]
    shear: f64,
    #[serde(rename = "exact_C11_plus_R2C66_minus_2RC16")]
    through_center: f64,
}

#[derive(Deserialize)]
struct Reference {
    #[serde(rename = "rings_nu0_k3_eq_1_over_R")]
    rings: Vec<Ring>,
}

fn reference() -> Reference {
    let text = std::fs::read_to_string(FILE).expect("the reference file");
    serde_json::from_str(&text).expect("its fields")
}

/// Rotation per length of a ring of rectangular section under a unit moment, [golovin]:
/// `C66 = 8 (b^2 - a^2) / (E w R N)`, `N = (b^2 - a^2)^2 - 4 a^2 b^2 ln(b/a)^2`.
fn golovin_bending(ring: &Ring) -> f64 {
    let (a, b) = (ring.radius - 0.5 * ring.h_y, ring.radius + 0.5 * ring.h_y);
    let difference = b * b - a * a;
    let n = difference.powi(2) - (2.0 * a * b * (b / a).ln()).powi(2);
    8.0 * difference / (ring.w_z * ring.radius * n)
}

/// Rings with R/h = 5, 2, 1 and no Poisson's ratio, so that plane stress is exact: pure
/// bending, a shear force, a force through the center of curvature.
///
/// 32 cells of degree 2 across the section: errors decrease as h^4, from 1e-9 (R/h = 5) to
/// 1e-7 (R/h = 1) in bending, and are about twenty times larger with shear. The required
/// accuracy is the accuracy of the prototype of the theory with half the number of cells.
#[test]
fn rings_are_those_of_golovin() {
    let reference = reference();
    for (ring, tolerance) in reference.rings.iter().zip([4e-8, 3e-7, 5e-6]) {
        let mesh = rectangle(ring.h_y, ring.w_z, [32, 2]);
        let section = uniform(&mesh, isotropic(1.0, 0.0), 0.0);
        let r = ring.radius;
        let c = sound(&curved(&section, [0.0, 0.0, 1.0 / r])).compliance;
        let case = format!("ring, R/h = {}", r / ring.h_y);
        let entries = [
            ("C66", c[(5, 5)], golovin_bending(ring), tolerance),
            ("C22", c[(1, 1)], ring.shear, 9e-6),
            (
                "C11 + R^2 C66 - 2 R C16",
                c[(0, 0)] + r * r * c[(5, 5)] - 2.0 * r * c[(0, 5)],
                ring.through_center,
                tolerance,
            ),
        ];
        for (name, found, expected, tolerance) in entries {
            let error = relative_error(found, expected);
            println!("{case} {name}: {error:.1e}");
            record::value(GOLOVIN, &case, name, [found, expected], error, tolerance);
            assert!(error < tolerance, "{case} {name}: {found} {expected}");
        }
        // a ring that opens towards +y: a tension moves the line in, not out
        let k = solved(&curved(&section, [0.0, 0.0, 1.0 / r])).stiffness;
        assert!(k[(0, 5)] < 0.0);
    }
}

/// Recovered stresses of a ring of R/h = 1 in pure bending, [golovin]: along it
///
/// ```text
/// s = 4 M/(w N) (b^2 - a^2 + b^2 ln(r/b) + a^2 ln(a/r) - (a b/r)^2 ln(b/a))
/// ```
///
/// with r = R - y, from the middle of the section to its faces; their resultants are the
/// load. Stresses on 32 cells of degree 2 are of second order at any point: errors are
/// about 1e-4 of the largest stress, which is 1.5 times the stress of a straight bar.
#[test]
fn stresses_of_a_ring_are_those_of_golovin() {
    let (radius, h, w) = (1.0, 1.0, 0.5);
    let (a, b) = (radius - 0.5 * h, radius + 0.5 * h);
    let log = f64::ln(b / a);
    let n = f64::powi(b * b - a * a, 2) - f64::powi(2.0 * a * b * log, 2);
    let golovin = |y: f64| {
        let r = radius - y;
        let logs = b * b * (r / b).ln() + a * a * (a / r).ln() - (a * b / r).powi(2) * log;
        4.0 / (w * n) * (b * b - a * a + logs)
    };
    let section = uniform(&rectangle(h, w, [32, 2]), isotropic(1.0, 0.0), 0.0);
    let section = curved(&section, [0.0, 0.0, 1.0 / radius]);
    let solution = sound(&section);
    let recoverer = Recoverer::new(&section, &solution);
    let bend = LoadCase {
        name: "bend".into(),
        force: Vector6::ith(5, 1.0),
        imposed: Vec::new(),
        voltages: Vec::new(),
    };
    let recovery = recoverer.recover(&bend).expect("stresses that add up");
    assert!(recovery.resultant_error < 1e-12);
    let largest = golovin(0.5).abs();
    let mut worst = 0.0_f64;
    for i in 0..=20 {
        let y = -0.5 + f64::from(i) / 20.0;
        let (_, tensors) = recoverer.at(&bend, [y, 0.1]).expect("inside");
        worst = worst.max((tensors.stress[0] - golovin(y)).abs() / largest);
    }
    println!("ring stresses: {worst:.1e}");
    record::largest(GOLOVIN, "ring, R/h = 1", "stresses in bending", worst, 1e-3);
    assert!(worst < 1e-3, "{worst:e}");
    // general loads on a general curve
    let section = curved(&ply_bar([6, 8]), [0.2, -0.15, 0.1]);
    let solution = sound(&section);
    let recoverer = Recoverer::new(&section, &solution);
    for component in 0..6 {
        let load = LoadCase {
            name: "unit".into(),
            force: Vector6::ith(component, 1.0),
            imposed: Vec::new(),
            voltages: Vec::new(),
        };
        let recovery = recoverer.recover(&load).expect("stresses that add up");
        assert!(recovery.resultant_error < 1e-12, "{component}");
    }
}

/// `K14 = E k1 (Ip - J)` to first order in k1, for any isotropic section and any Poisson's
/// ratio. Ip - J in closed form for the ellipse, by the straight analysis of the same mesh
/// for the strip: the difference decreases with k1^2.
#[test]
fn pretwist_couples_extension_and_twist() {
    let (a, b) = (2.0_f64, 1.0_f64);
    let ellipse = Ellipse {
        semi_y: a,
        semi_z: b,
        cells: 8,
        kind: CellKind::Quadrilateral9,
        curved: true,
    };
    let ellipse = ellipse.generate().expect("sound measures");
    let strip = rectangle(2.0, 0.2, [24, 4]);
    for nu in [0.0, 0.3] {
        let polar = PI * a * b * (a * a + b * b) / 4.0;
        let torsion = PI * (a * b).powi(3) / (a * a + b * b);
        let section = uniform(&ellipse, isotropic(1.0, nu), 0.0);
        // J of the mesh is accurate to 1e-5 of Ip
        check_pretwist("ellipse 2:1", nu, &section, polar - torsion, 2e-5);

        let section = uniform(&strip, isotropic(1.0, nu), 0.0);
        let straight = solved(&section).stiffness;
        let torsion = 2.0 * (1.0 + nu) * straight[(3, 3)];
        let polar = 2.0 * 0.2 * (4.0 + 0.04) / 12.0;
        check_pretwist("strip 10:1", nu, &section, polar - torsion, 1e-5);
    }
}

fn check_pretwist(name: &str, nu: f64, section: &Section, arm: f64, tolerance: f64) {
    let ratio = |k1: f64| sound(&curved(section, [k1, 0.0, 0.0])).stiffness[(0, 3)] / (k1 * arm);
    let found = ratio(1e-3);
    let error = (found - 1.0).abs();
    let case = format!("{name}, nu = {nu}");
    println!("{case}: {error:.1e}");
    record::value(
        PRETWIST,
        &case,
        "K14 / (E k1 (Ip - J))",
        [found, 1.0],
        error,
        tolerance,
    );
    assert!(error < tolerance, "{case}: {found}");
    // the difference decreases with the square of the twist: by a factor of four from 0.02
    // to 0.01; higher terms and the error of the mesh are a tenth
    let (one, two) = (ratio(0.01) - ratio(1e-4), ratio(0.02) - ratio(1e-4));
    assert!((two / one - 4.0).abs() < 0.4, "{case}: {}", two / one);
}

/// A round isotropic tube has no orientation: its stiffness is the same in a frame that
/// turns along it; and so is the stiffness of the moved tube along a helix.
///
/// The error is due to the mesh, whose 64 sides turn with the frame: at k1 = 1e-6 only
/// round-off remains.
#[test]
fn a_tube_does_not_know_that_its_frame_turns() {
    let tube = Tube {
        outer_radius: 1.0,
        thickness: 0.2,
        cells_around: 64,
        cells_through: 2,
        kind: CellKind::Quadrilateral9,
        curved: true,
    };
    let section = uniform(&tube.generate().expect("sound"), isotropic(1.0, 0.3), 0.0);
    let straight = solved(&section).stiffness;
    let t = Vector3::new(0.0, 0.4, -0.3);
    let translated = wrench::shift(&straight, &t);
    for (k1, tolerance) in [(1e-6, 1e-14), (0.01, 5e-11), (0.2, 2e-8), (1.0, 5e-7)] {
        let found = sound(&curved(&section, [k1, 0.0, 0.0])).stiffness;
        let error = scaled_error(&found, &straight);
        // a straight line through t: l = e1 - k x t in the frame
        let slope = Vector3::x() - Vector3::new(k1, 0.0, 0.0).cross(&-t);
        let mut moved = along(&section, [k1, 0.0, 0.0], slope.into());
        for node in &mut moved.mesh.nodes {
            *node = [node[0] - t.y, node[1] - t.z];
        }
        let helix = scaled_error(&sound(&moved).stiffness, &translated);
        println!("tube k1 = {k1}: {error:.1e}, helix {helix:.1e}");
        let case = format!("tube, frame twisting with k1 R = {k1}");
        record::largest(FRAME, &case, "stiffness", error, tolerance);
        assert!(
            error < tolerance && helix < tolerance,
            "{error:e} {helix:e}"
        );
    }
}

pub const PLY: EngineeringConstants = EngineeringConstants {
    e1: 142.0,
    e2: 9.8,
    e3: 9.8,
    g12: 6.0,
    g13: 6.0,
    g23: 4.8,
    nu12: 0.42,
    nu13: 0.42,
    nu23: 0.5,
};

/// A rectangle 1 x 2 of plies at 20 degrees: every coupling if the beam is curved.
pub fn ply_bar(cells: [usize; 2]) -> Section {
    uniform(
        &rectangle(1.0, 2.0, cells),
        orthotropic(PLY),
        20_f64.to_radians(),
    )
}

/// The reference point moved by t0 along a line that is then oblique, `l = e1 + k x t0`:
/// the stiffness translates exactly, to round-off.
#[test]
fn stiffness_moves_with_the_reference_point() {
    let k = [0.2, -0.15, 0.1];
    let section = ply_bar([6, 8]);
    let t0 = Vector3::new(0.0, 0.4, -0.3);
    let slope = Vector3::x() + Vector3::from(k).cross(&t0);
    let mut moved = along(&section, k, slope.into());
    for node in &mut moved.mesh.nodes {
        *node = [node[0] - t0.y, node[1] - t0.z];
    }
    let (plain, found) = (sound(&curved(&section, k)), sound(&moved));
    for (name, found, plain) in [
        ("stiffness", found.stiffness, plain.stiffness),
        ("mass", found.mass, plain.mass),
    ] {
        let error = scaled_error(&found, &wrench::shift(&plain, &t0));
        println!("moved {name}: {error:.1e}");
        record::largest(FRAME, "reference point moved", name, error, 1e-13);
        assert!(error < 1e-13, "{name}: {error:e}");
    }
}

/// As k tends to zero, the difference of the stiffness from the straight beam tends to zero
/// in proportion: there is no noise floor above round-off (1e-13) down to |k| = 1e-10.
#[test]
fn curvature_goes_to_zero_in_proportion() {
    let section = ply_bar([6, 8]);
    let straight = solved(&section).stiffness;
    let change = |k: f64| {
        let found = sound(&curved(&section, [2.0 * k, -1.5 * k, k])).stiffness;
        (found - straight) / k
    };
    let slope = change(1e-5);
    let scale = slope.amax();
    for k in [1e-6, 1e-8, 1e-10] {
        let error = (change(k) - slope).amax() / scale;
        // second order, 1e-5 times a few; and round-off of K over k times its slope
        let tolerance = 1e-3_f64.max(1e-12 / k);
        println!("k = {k:e}: {error:.1e}");
        record::largest(FRAME, &format!("k = {k:e}"), "slope of K", error, tolerance);
        assert!(error < tolerance, "k = {k:e}: {error:e}");
    }
}

/// A straight prism cut obliquely is the same prism: its generators run along l, and the
/// section normal to them is the projection of the oblique section along l.
///
/// With Q the axes of the normal section, compliances per length of the line agree for
/// tension along l, torsion and bending, the internal forces that are constant along the
/// beam: `C_oblique = |l| Q C_normal Q'` on these. (The energy of a shear force between two
/// cuts depends on the ends, `T G + G T'` with a symmetric G, which vanishes there.) The
/// two meshes are affine images of each other, so that they differ only by round-off.
#[test]
fn an_oblique_cut_shows_the_same_prism() {
    let l = Vector3::new(1.0, 0.4, -0.3);
    let oblique = along(&ply_bar([6, 8]), [0.0; 3], l.into());
    let tangent = l.normalize();
    // axes of the normal section: tangent, and two normal to it
    let second = Vector3::new(-tangent.y, tangent.x, 0.0).normalize();
    let q = Matrix3::from_columns(&[tangent, second, tangent.cross(&second)]);
    let mut normal = ply_bar([6, 8]);
    let law = normal.materials[0].law.stiffness();
    normal.materials[0].law = section_analyzer::material::ElasticLaw::Full(turned(&law, &q));
    for cell in &mut normal.cells {
        cell.fiber_angle = 0.0;
    }
    for node in &mut normal.mesh.nodes {
        let p = Vector3::new(0.0, node[0], node[1]);
        let on_normal = q.transpose() * (p - l * (p.dot(&l) / l.norm_squared()));
        *node = [on_normal.y, on_normal.z];
    }
    let found = sound(&oblique).compliance;
    let turn = wrench::rotation_matrix(&q);
    let expected = l.norm() * turn * solved(&normal).compliance * turn.transpose();
    // internal forces that are constant along the beam: a force along l, and the moments
    let mut constant = nalgebra::Matrix6x4::zeros();
    constant.fixed_view_mut::<3, 1>(0, 0).copy_from(&tangent);
    constant.fixed_view_mut::<3, 3>(3, 1).fill_with_identity();
    let of_constant = |c: &Matrix6<f64>| constant.transpose() * c * constant;
    let (found, expected) = (of_constant(&found), of_constant(&expected));
    let scale = expected.diagonal().map(f64::sqrt);
    let error = (found - expected)
        .component_div(&(scale * scale.transpose()))
        .amax();
    println!("oblique: {error:.1e}");
    record::largest(FRAME, "prism cut obliquely", "compliance", error, 1e-10);
    assert!(error < 1e-10, "{error:e}");
}

/// The law of plies at 20 degrees in the axes q, order xx yy zz yz xz xy.
fn turned(law: &Matrix6<f64>, q: &Matrix3<f64>) -> Matrix6<f64> {
    let (s, c) = 20_f64.to_radians().sin_cos();
    // material axes in section axes (fiber, wall, normal), then in the axes q
    let ply = Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
    let axes = q.transpose() * ply;
    let pairs = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
    let index = |i: usize, j: usize| match (i, j) {
        (i, j) if i == j => i,
        _ => 6 - i - j,
    };
    // index of a pair of different axes: 12 -> 3, 02 -> 4, 01 -> 5
    Matrix6::from_fn(|row, column| {
        let ((a, b), (m, n)) = (pairs[row], pairs[column]);
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..3 {
                for k in 0..3 {
                    for l in 0..3 {
                        sum += axes[(a, i)]
                            * axes[(b, j)]
                            * axes[(m, k)]
                            * axes[(n, l)]
                            * law[(index(i, j), index(k, l))];
                    }
                }
            }
        }
        sum
    })
}

/// The mass per length of a ring is the mass of its volume: `int rho J dA`, and the moments
/// accordingly, in closed form for a rectangle of density one curved about z:
/// `J = 1 - k3 y`, `m = h w`, `int rho y J = -k3 w h^3/12`.
#[test]
fn mass_is_that_of_the_volume() {
    let (h, w, k3) = (1.0, 0.5, 0.4);
    let mut material = isotropic(1.0, 0.3);
    material.density = 3.0;
    let section = uniform(&rectangle(h, w, [3, 2]), material, 0.0);
    let mass = sound(&curved(&section, [0.0, 0.0, k3])).mass;
    let (iz, iy) = (w * f64::powi(h, 3) / 12.0, h * f64::powi(w, 3) / 12.0);
    let close = |found: f64, expected: f64| {
        assert!((found - 3.0 * expected).abs() < 1e-14, "{found} {expected}");
    };
    close(mass[(0, 0)], h * w);
    // M26 = -m y_m
    close(mass[(0, 5)], k3 * iz);
    // the cubic term of y vanishes over a centered rectangle
    close(mass[(4, 4)], iy);
    close(mass[(5, 5)], iz);
}

/// A curvature whose center lies in the section folds a cell over itself; the error names
/// the cell.
#[test]
fn curvature_too_large_is_refused() {
    let section = uniform(&rectangle(2.0, 1.0, [4, 2]), isotropic(1.0, 0.3), 0.0);
    let failure = analyze(&curved(&section, [0.0, 0.0, 1.2])).expect_err("folded");
    // J = 1 - 1.2 y is negative beyond y = 0.83: in the last column of cells
    match &failure {
        Failure::Folded { y, volume, .. } => {
            assert!(*y > 0.83 && *y <= 1.0, "{y}");
            assert!((volume - (1.0 - 1.2 * y)).abs() < 1e-12);
        }
        other => panic!("{other}"),
    }
    assert!(analyze(&curved(&section, [0.0, 0.0, 0.9])).is_ok());
    assert!(failure.to_string().contains("folds over itself"));
}
