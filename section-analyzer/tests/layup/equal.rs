//! Sections of the generator of `mesh blade`, as layups: equal within the errors of both meshes.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

use nalgebra::Matrix6;
use section_analyzer::analysis::{analyze, discretization_error};
use section_analyzer::input::{self, layup};
use section_analyzer::material::{ElasticLaw, Material};
use section_analyzer::mesh::SectionMesh;
use section_analyzer::mesh::generate::blade::{Blade, Contour, Cores, Ply, Sizes, Spar, SparPly};
use section_analyzer::mesh::generate::layup::{Layer, LayupSection, Web, WebPly};
use section_analyzer::section::{CellMaterial, Section};
use shared_geom::error::SourceLocation;
use shared_geom::mesh::Mesh;
use shared_geom::section::InitialCurvature;

use crate::files::section;

/// Stiffness of a section, and the estimate of its error.
fn solved(section: &Section) -> [Matrix6<f64>; 2] {
    let stiffness = analyze(section).expect("a solution").stiffness;
    let error = discretization_error(section, &stiffness).expect("an estimate");
    [stiffness, error.stiffness]
}

/// The largest difference of two stiffnesses, and the largest sum of both errors, of sqrt(Kii Kjj).
fn compare([a, error_a]: [Matrix6<f64>; 2], [b, error_b]: [Matrix6<f64>; 2]) -> [f64; 2] {
    let largest = |m: Matrix6<f64>| {
        let scaled = Matrix6::from_fn(|i, j| m[(i, j)] / (b[(i, i)] * b[(j, j)]).sqrt());
        scaled.amax()
    };
    [largest(a - b), largest(error_a.abs() + error_b.abs())]
}

fn uniform(mesh: &Mesh) -> Section {
    let place = SourceLocation::file("test");
    let (mesh, _) = SectionMesh::from_mesh(mesh, 1.0, &place).expect("a sound mesh");
    let cell = CellMaterial {
        material: 0,
        fiber_angle: 0.0,
        plane_angle: 0.0,
    };
    Section {
        name: "uniform".into(),
        cells: vec![cell; mesh.cells.len()],
        mesh,
        materials: vec![Material {
            name: "metal".into(),
            law: ElasticLaw::Isotropic {
                young: 2.6,
                poisson: 0.3,
            },
            density: 1.0,
            expansion: None,
            electric: None,
        }],
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

/// Half axes, thickness of the skin and of the plies of the spar, outer faces of the webs.
const AXES: [f64; 2] = [0.5, 0.2];
const WALLS: [f64; 2] = [1e-3, 3e-3];
const WEBS: f64 = 0.3;
const SIZE: f64 = 0.01;

fn ellipse(i: usize) -> [f64; 2] {
    let angle = TAU * i as f64 / 200.0;
    [AXES[0] * angle.cos(), AXES[1] * angle.sin()]
}

/// An elliptic tube with a box-spar, whose torsion `tests/section` compares with Bredt's theory.
fn of_blade() -> Section {
    let [skin, wall] = WALLS;
    let points: Vec<[f64; 2]> = (0..=200).map(ellipse).map(|[x, z]| [0.5 + x, z]).collect();
    let ply = |name: &str, thickness: f64| Ply {
        name: name.into(),
        thickness,
        cells: 1,
        has_faces: false,
    };
    let all = Some([f64::NEG_INFINITY, f64::INFINITY]);
    let blade = Blade {
        contour: Contour::new(&points, 1.0, 0.5, 1.0).expect("an ellipse"),
        skin: vec![ply("skin", skin)],
        is_closed: true,
        spar: Some(Spar {
            front_web: Some(0.5 - WEBS),
            rear_web: 0.5 + WEBS,
            plies: vec![SparPly {
                ply: ply("spar", wall),
                upper: all,
                lower: all,
                webs: [true; 2],
                filler: None,
            }],
        }),
        cores: Cores::default(),
        sizes: Sizes::new(SIZE),
    };
    uniform(&blade.generate().expect("a mesh"))
}

/// The same as a layup.
fn of_layup() -> Section {
    let [skin, wall] = WALLS;
    let contour: Vec<[f64; 2]> = (0..=200).map(ellipse).map(|[x, z]| [-x, z]).collect();
    // arcs of the positions of the webs, by many chords
    let arc = |y: f64| {
        const STEPS: usize = 200_000;
        let at = |i: usize| {
            let angle = TAU * i as f64 / STEPS as f64;
            [-AXES[0] * angle.cos(), AXES[1] * angle.sin()]
        };
        let (mut sum, mut found) = (0.0, 0.0);
        for i in 0..STEPS {
            let [p, q] = [at(i), at(i + 1)];
            if i < STEPS / 2 && q[0] < y {
                found = sum;
            }
            sum += (p[0] - q[0]).hypot(p[1] - q[1]);
        }
        found / sum
    };
    let layer = |name: &str, thickness: f64, [from, to]: [f64; 2]| Layer {
        name: name.into(),
        thickness,
        from,
        to,
        taper: Some(0.1 * thickness),
        profile: Vec::new(),
    };
    let ends = [arc(-WEBS), arc(WEBS)];
    let web = |name: &str, y: f64| Web {
        name: name.into(),
        arcs: [arc(y), 1.0 - arc(y)],
        plies: vec![WebPly {
            name: format!("{name}_ply"),
            thickness: wall,
        }],
    };
    let layup = LayupSection {
        contour,
        layers: vec![
            layer("skin", skin, [0.0, 1.0]),
            layer("upper", wall, ends),
            layer("lower", wall, [1.0 - ends[1], 1.0 - ends[0]]),
        ],
        webs: vec![
            web("fore", WEBS - 0.5 * wall),
            web("aft", -WEBS + 0.5 * wall),
        ],
        spar: None,
        fills: Vec::new(),
        size: Some(SIZE),
    };
    uniform(&layup.generate().expect("a mesh").mesh)
}

#[test]
fn a_box_spar_is_the_same_by_both_generators() {
    let [difference, error] = compare(solved(&of_layup()), solved(&of_blade()));
    println!("box-spar: difference {difference:e}, errors {error:e}");
    assert!(difference < error, "{difference:e} {error:e}");
}

/// A folder of the case of the active-twist blade.
fn active_twist(file: &str) -> PathBuf {
    let folder =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../cases/section/active_twist_section");
    folder.join(file)
}

/// The section of the active-twist blade as a layup with cells of this length [in]: a skin, and a
/// spar to 40 % of the chord, from the outside in six active plies from 5 % of the chord to the web,
/// which a filler replaces elsewhere, each on a ply of glass, then carbon and glass.
fn active_twist_layup(size: f64) -> String {
    let file = std::fs::read_to_string(active_twist("active_twist_section.section.toml"));
    let file = file.expect("a section file");
    let [from, to] = ["[units]", "[[region]]"].map(|word| file.find(word).expect("a table"));
    let mut text = file[from..to].to_owned();
    text += "[shape]\nnaca = \"0012\"\nchord = 16.3968\norigin = 0.25\n";
    text += &format!("[mesh]\nsize = {size}\n");
    let mut layer = |name: &str, material: &str, thickness: f64, rest: &str| {
        text += &format!(
            "[[layer]]\nname = {name:?}\nmaterial = {material:?}\nthickness = {thickness}\n{rest}\n"
        );
    };
    const GLASS: f64 = 0.0051;
    let web = "web = \"rear\"";
    let end = |key: &str, side: &str| format!("{key} = {{ x = 0.05, side = {side:?} }}");
    layer("skin", "glass_45", GLASS, "");
    for i in 0..6 {
        let angle = format!("fiber_angle = {}\ntoward = \"contour\"", [-45, 45][i % 2]);
        let above = format!("{angle}\nfrom = \"rear.suction\"\n{}", end("to", "suction"));
        let below = format!(
            "{angle}\n{}\nto = \"rear.pressure\"",
            end("from", "pressure")
        );
        let filler = format!(
            "{web}\n{}\n{}",
            end("from", "suction"),
            end("to", "pressure")
        );
        layer(&format!("filler{i}"), "glass_45", 0.0055, &filler);
        layer(&format!("upper{i}"), "afc", 0.0055, &above);
        layer(&format!("lower{i}"), "afc", 0.0055, &below);
        layer(&format!("glass{i}"), "glass_45", GLASS, web);
    }
    layer("carbon", "t300", 9.0 * 0.00492, web);
    layer("inner", "glass_45", GLASS, web);
    text + "[[web]]\nname = \"rear\"\nat = { x = 0.4 }\nplies = []\n"
}

/// The spar of the active-twist blade, mitred at its web: 7.3e-4 of sqrt(Kii Kjj) with these cells.
/// Plies of the web that stand on the surfaces, without mitres, make a difference of 9.2e-3 with
/// cells of any size.
#[test]
fn the_active_twist_section_is_the_same_by_both_generators() {
    let before = input::read(&active_twist("medium.section.toml"));
    let before = before.unwrap_or_else(|problems| panic!("{problems}"));
    let layup = layup::parse(&active_twist_layup(0.28), Path::new("a.layup.toml"));
    let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
    let now = section(&layup, 0.0);
    println!(
        "{} {} nodes",
        before.section.mesh.nodes.len(),
        now.section.mesh.nodes.len()
    );
    let [difference, error] = compare(solved(&now.section), solved(&before.section));
    println!("active twist: difference {difference:e}, errors {error:e}");
    assert!(difference < error, "{difference:e} {error:e}");
}
