//! Sections of blades meshed by the generator: the active-twist blade against its table,
//! and a box-spar against the theory of thin walls.
//!
//! Sources: `tests/reference/theory/blade_table_13_3.json` (Masarati, Table 13.3, and an
//! independent program on its own mesh, of the same plies and materials); Bredt's theory of
//! thin-walled sections of several cells.

use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use nalgebra::{Matrix6, Vector6};
use section_analyzer::analysis::analyze;
use section_analyzer::input::{self, Input, blade};
use section_analyzer::material::{ElasticLaw, EngineeringConstants, section_stiffness};
use section_analyzer::mesh::generate::blade::{Blade, Contour, Cores, Ply, Sizes, Spar, SparPly};
use serde_json::Value;
use shared_geom::gmsh;

use crate::record;
use crate::sections::{isotropic, scaled_error, uniform};

const CASE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/cases/section/active_twist_section"
);
const REFERENCE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/tests/reference/theory/blade_table_13_3.json"
);
/// The meshes, coarsest first.
const MESHES: [&str; 3] = ["coarse", "medium", "active_twist_section"];
const POUND: f64 = 4.448_221_615_260_5;
const FOOT: f64 = 0.3048;

fn file(name: &str, ending: &str) -> PathBuf {
    Path::new(CASE).join(format!("{name}.{ending}"))
}

fn read(name: &str) -> Input {
    input::read(&file(name, "section.toml")).unwrap_or_else(|problems| panic!("{problems}"))
}

/// Stiffness on each mesh [lbf, lbf ft, lbf ft^2].
fn found() -> &'static [Matrix6<f64>; 3] {
    static FOUND: OnceLock<[Matrix6<f64>; 3]> = OnceLock::new();
    FOUND.get_or_init(|| {
        MESHES.map(|name| {
            let solution = analyze(&read(name).section).expect("a solution");
            let unit = |i: usize| if i > 2 { FOOT } else { 1.0 };
            Matrix6::from_fn(|i, j| solution.stiffness[(i, j)] / (POUND * unit(i) * unit(j)))
        })
    })
}

fn reference(model: &str, key: &str) -> Matrix6<f64> {
    let text = std::fs::read_to_string(REFERENCE).expect("the reference");
    let value: Value = serde_json::from_str(&text).expect("JSON");
    let entry = |i: usize, j: usize| value[model][key][i][j].as_f64().expect("a number");
    Matrix6::from_fn(|i, j| entry(i.min(j), i.max(j)))
}

/// The entries determined by the plies; 3 % is the required accuracy, as the meshes of the
/// thesis still change by 0.5 to 3 % in the last step. The differences of the other entries
/// are explained in the README of the case.
#[test]
fn active_twist_section_is_that_of_the_table() {
    let [.., fine] = found();
    let table = reference("thesis", "K_upper");
    for (quantity, i, j) in [
        ("axial stiffness [lbf]", 0, 0),
        ("bending stiffness out of plane [lbf ft^2]", 4, 4),
        ("bending stiffness in plane [lbf ft^2]", 5, 5),
        ("axial-bending coupling [lbf ft]", 0, 5),
    ] {
        let (found, expected) = (fine[(i, j)], table[(i, j)]);
        let error = (found / expected - 1.0).abs();
        let case = "active-twist section";
        let pair = [found, expected];
        record::value("Masarati, Table 13.3", case, quantity, pair, error, 0.03);
        assert!(error < 0.03, "{quantity}: {found:e}, expected {expected:e}");
    }
}

/// Both meshes have about 8000 nodes. Halving the cells of our mesh changes no entry by
/// more than 5e-4 of sqrt(Kii Kjj) (shear out of plane, see the figure of the case), and
/// the other mesh cannot be better: 1e-3.
#[test]
fn active_twist_section_is_that_of_an_independent_program() {
    let [.., fine] = found();
    let error = scaled_error(fine, &reference("prototype_pm", "K"));
    record::largest(
        "independent program, other mesh",
        "active-twist section",
        "stiffness, of sqrt(Kii Kjj)",
        error,
        1e-3,
    );
    assert!(error < 1e-3, "{error:e}");
}

/// Piezoelectric force per volt of the active plies on each mesh [lbf/V, lbf ft/V].
fn forces_per_volt() -> [Vector6<f64>; 3] {
    MESHES.map(|name| {
        let solution = analyze(&read(name).section).expect("a solution");
        let piezo = solution.piezo.expect("electrodes");
        let unit = |i: usize| if i > 2 { FOOT } else { 1.0 };
        Vector6::from_fn(|i, _| piezo.electrodes[0].coupling[i] / (POUND * unit(i)))
    })
}

/// Effective spacing of the fingers in the section files [in].
const SPACING: f64 = 0.01216;

/// The table has 0.186 lb ft/V, to which the spacing is calibrated: agreement to its
/// digits. The response of the plies to a field is a separate check: the independent
/// program gives 2.2618e-6 lb ft for 1 V/in and constants a thousand times smaller; the
/// results agree to the difference between the two meshes; its other forces are small, and
/// are compared relative to `sqrt(Kii/K44)` times the torque.
#[test]
fn active_plies_twist_as_in_the_table() {
    let [coarse, medium, fine] = forces_per_volt();
    let error = (fine[3] / 0.186 - 1.0).abs();
    let case = "active-twist section";
    let pair = [fine[3], 0.186];
    println!("{coarse} {medium} {fine} {error:e}");
    record::value(
        "Masarati, Table 13.3",
        case,
        "torque per volt [lbf ft/V]",
        pair,
        error,
        3e-3,
    );
    assert!(error < 1e-3, "{}", fine[3]);

    let text = std::fs::read_to_string(REFERENCE).expect("the reference");
    let value: Value = serde_json::from_str(&text).expect("JSON");
    let key = "piezo_per_unit_field_V_per_in_with_e_in_1e_minus_6";
    let known = &value["prototype_pm"][key];
    let known = Vector6::from_fn(|i, _| 1e3 * known[i].as_f64().expect("a number") / SPACING);
    let k = reference("prototype_pm", "K");
    for i in 0..6 {
        let scale = (k[(i, i)] / k[(3, 3)]).sqrt() * known[3];
        let error = (fine[i] - known[i]).abs() / scale;
        println!("{i} {:e} {:e} {error:e}", fine[i], known[i]);
        assert!(error < 1e-3, "{i}: {:e}, expected {:e}", fine[i], known[i]);
    }
    let error = (fine[3] / known[3] - 1.0).abs();
    let source = "independent program, other mesh";
    record::value(
        source,
        case,
        "torque per volt [lbf ft/V]",
        [fine[3], known[3]],
        error,
        1e-3,
    );
}

/// The entries that depend on the mesh converge to the entries of the finest mesh. With
/// cells of length 4, 2 and 1, the differences from the finest mesh have the ratio
/// (16 - 1) / (4 - 1) = 5 for second-order errors and (4 - 1) / (2 - 1) = 3 for first-order errors.
/// The singular stresses at the ends of plies reduce the ratio: more than 2.
#[test]
fn active_twist_section_converges() {
    let [coarse, medium, fine] = found();
    for (i, j) in [(1, 1), (2, 2), (3, 3), (2, 3)] {
        let off = |matrix: &Matrix6<f64>| (matrix[(i, j)] - fine[(i, j)]).abs();
        let ratio = off(coarse) / off(medium);
        assert!(ratio > 2.0, "K{}{}: {ratio}", i + 1, j + 1);
    }
}

/// The committed meshes equal the generated meshes of the committed files: the same cells,
/// nodes within the round-off of trigonometric functions on other machines.
#[test]
fn committed_meshes_are_those_of_their_files() {
    for name in MESHES {
        let committed = gmsh::read_file(&file(name, "msh")).unwrap_or_else(|p| panic!("{p}"));
        let made = blade::read(&file(name, "blade.toml")).unwrap_or_else(|p| panic!("{p}"));
        let made = gmsh::read(gmsh::write(&made.mesh).as_bytes(), "made").expect("a mesh");
        assert_eq!(made.nodes.len(), committed.nodes.len(), "{name}");
        for (a, b) in made.nodes.iter().zip(&committed.nodes) {
            assert!(
                (a.position - b.position).norm() < 1e-9,
                "{name}: node {}",
                a.tag
            );
        }
        assert!(
            made.cells == committed.cells && made.groups == committed.groups,
            "{name}"
        );
    }
}

/// "+-45" glass is half the sum of the laws at +45 and -45 degrees; the file contains it to
/// a tenth of a psi.
#[test]
fn glass_is_the_mean_of_its_two_directions() {
    let (c11, c12, c22, c66) = (2.15e6, 0.19e6, 1.98e6, 0.28e6);
    let ply = ElasticLaw::Orthotropic(EngineeringConstants {
        e1: c11 - c12 * c12 / c22,
        e2: c22 - c12 * c12 / c11,
        e3: 1.5e6,
        g12: c66,
        g13: c66,
        g23: c66,
        nu12: c12 / c22,
        nu13: c12 / c22,
        nu23: 0.2,
    })
    .stiffness();
    let at = |angle: f64| section_stiffness(&ply, angle, 0.0);
    let expected = 0.5 * (at(0.25 * PI) + at(-0.25 * PI));
    for name in MESHES {
        let input = read(name);
        let materials = input.section.materials.iter();
        let glass = materials.clone().find(|one| one.name == "glass_45");
        let law = glass.expect("glass_45").law.stiffness();
        let psi = POUND / (0.0254 * 0.0254);
        let found = section_stiffness(&law, 0.0, 0.0) / psi;
        assert!((found - expected).amax() < 0.1, "{found}{expected}");
    }
}

/// Half axes of an elliptic tube.
const AXES: [f64; 2] = [0.5, 0.2];
/// Thickness of its skin and of the plies of its spar.
const WALLS: [f64; 2] = [1e-3, 3e-3];

/// An ellipse from its rear end over the top.
fn ellipse() -> Vec<[f64; 2]> {
    const POINTS: usize = 200;
    let point = |i: usize| {
        let angle = TAU * i as f64 / POINTS as f64;
        [0.5 + AXES[0] * angle.cos(), AXES[1] * angle.sin()]
    };
    (0..=POINTS).map(point).collect()
}

/// Distance of the outer faces of the webs from the center.
const WEBS: f64 = 0.3;

/// Length of the upper middle surface at this depth, and area below it, between two
/// positions from the center: by many chords of the offset ellipse.
fn half_wall([from, to]: [f64; 2], depth: f64) -> [f64; 2] {
    let position = |angle: f64| {
        let [a, b] = AXES;
        let normal = [angle.cos() / a, angle.sin() / b];
        let size = normal[0].hypot(normal[1]);
        let at = |i: usize, axis: f64, x: f64| axis * x - depth * normal[i] / size;
        [at(0, a, angle.cos()), at(1, b, angle.sin())]
    };
    let (mut length, mut area) = (0.0, 0.0);
    const STEPS: usize = 20_000;
    for i in 0..STEPS {
        let [p, q] = [i, i + 1].map(|i| position(PI * i as f64 / STEPS as f64));
        let middle = 0.5 * (p[0] + q[0]);
        if middle > from && middle < to {
            length += (p[0] - q[0]).hypot(p[1] - q[1]);
            area += 0.5 * (p[1] + q[1]) * (p[0] - q[0]);
        }
    }
    [length, area]
}

/// Three cells with shear flows q, symmetric fore and aft:
///
/// ```text
/// nose:  q_n L_n / t_s + (q_n - q_s) h / t_w         = 2 A_n G k
/// spar:  q_s L_s / (t_s + t_w) + 2 (q_s - q_n) h/t_w = 2 A_s G k
/// GJ = 2 (2 q_n A_n + q_s A_s) / k  +  sum L t^3 G / 3
/// ```
/// of which this is GJ / G.
fn several_cells([skin, wall]: [f64; 2]) -> f64 {
    let both = skin + wall;
    let middle = WEBS - 0.5 * wall;
    let [l_n, a_n] = half_wall([middle, 1.0], 0.5 * skin).map(|x| 2.0 * x);
    let [l_s, a_s] = half_wall([-middle, middle], 0.5 * both).map(|x| 2.0 * x);
    let height = 2.0 * (AXES[1] * (1.0 - (middle / AXES[0]).powi(2)).sqrt() - 0.5 * both);
    let h = height / wall;
    let (n, s) = (l_n / skin + h, l_s / both + 2.0 * h);
    // n q_n - h q_s = 2 a_n,  -2 h q_n + s q_s = 2 a_s
    let determinant = n * s - 2.0 * h * h;
    let q_n = (2.0 * a_n * s + 2.0 * a_s * h) / determinant;
    let q_s = (2.0 * a_s * n + 4.0 * a_n * h) / determinant;
    let open = 2.0 * l_n * skin.powi(3) + l_s * both.powi(3) + 2.0 * height * wall.powi(3);
    2.0 * (2.0 * q_n * a_n + q_s * a_s) + open / 3.0
}

fn ply(name: &str, thickness: f64) -> Ply {
    Ply {
        name: name.into(),
        thickness,
        cells: 1,
        has_faces: false,
    }
}

/// Stiffness in torsion, for a shear modulus of one.
fn torsion(skin: f64, spar: Option<Spar>, size: f64) -> f64 {
    let blade = Blade {
        contour: Contour::new(&ellipse(), 1.0, 0.5, 1.0).expect("an ellipse"),
        skin: vec![ply("skin", skin)],
        is_closed: true,
        spar,
        cores: Cores::default(),
        sizes: Sizes::new(size),
    };
    let mesh = blade.generate().expect("a mesh");
    let section = uniform(&mesh, isotropic(2.6, 0.3), 0.0);
    analyze(&section).expect("a solution").stiffness[(3, 3)]
}

const BREDT: &str = "thin-walled cells, Bredt";

/// The error of thin-wall theory is of the order t^2/R^2, 1e-4 at the largest curvature of
/// the ellipse (R = 0.08), and the error of cells of 2 % of the chord is as large.
#[test]
fn torsion_of_a_skin_is_that_of_a_thin_walled_tube() {
    let [skin, _] = WALLS;
    let [length, area] = half_wall([-1.0, 1.0], 0.5 * skin).map(|x| 2.0 * x);
    let expected = 4.0 * area * area * skin / length + length * skin.powi(3) / 3.0;
    let found = torsion(skin, None, 0.02);
    let error = (found / expected - 1.0).abs();
    let pair = [found, expected];
    record::value(BREDT, "elliptic tube", "GJ", pair, error, 2e-4);
    assert!(error < 2e-4, "{found:e}, expected {expected:e}: {error:e}");
}

/// A box-spar of plies that turn into its webs has three cells. At joints of walls of
/// different thickness, the middle lines have errors of the order t/h, 1 %, and the first
/// cells errors in proportion to their length over h. Both are halved with thickness and
/// cells: `2 e(t/2) - e(t)` is free of them; the remaining errors are about (t/h)^2, 1e-4,
/// and three times the errors of the cells, 1e-4: 5e-4.
#[test]
fn torsion_of_a_box_spar_is_that_of_three_cells() {
    let all = Some([f64::NEG_INFINITY, f64::INFINITY]);
    let errors = [1.0, 0.5].map(|part| {
        let [skin, wall] = WALLS.map(|thickness| part * thickness);
        let spar = Spar {
            front_web: Some(0.5 - WEBS),
            rear_web: 0.5 + WEBS,
            plies: vec![SparPly {
                ply: ply("spar", wall),
                upper: all,
                lower: all,
                webs: [true; 2],
                filler: None,
            }],
        };
        torsion(skin, Some(spar), 0.005 * part) / several_cells([skin, wall]) - 1.0
    });
    let error = (2.0 * errors[1] - errors[0]).abs();
    let case = "elliptic tube with a box-spar";
    record::largest(BREDT, case, "GJ, for thickness to zero", error, 5e-4);
    assert!(errors[0].abs() < 0.01, "{errors:?}");
    assert!(error < 5e-4, "{errors:?}: {error:e}");
}
