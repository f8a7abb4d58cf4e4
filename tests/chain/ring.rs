//! A thick ring: the section of a curved beam on its line, against elasticity.
//!
//! A quarter ring of rectangular section, R/h = 2, clamped, with a radial force P at its
//! end. By Golovin's solution of plane stress, exact without a Poisson's ratio, the end
//! moves along the force by
//!
//! ```text
//! delta = pi P (a^2 + b^2) / (E w N) ,   N = (a^2 + b^2) ln(b/a) - (b^2 - a^2)
//! ```
//!
//! # References
//! - Timoshenko, Goodier, *Theory of Elasticity*, 3rd ed. 1970, article 33: a curved bar
//!   loaded at its end.

use std::f64::consts::PI;
use std::path::Path;

use beam_dynamics::analysis::statics::statics;
use nalgebra::Vector3;
use section_analyzer::analysis::analyze;
use section_analyzer::material::{ElasticLaw, Material};
use section_analyzer::mesh::SectionMesh;
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::output::properties;
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::ImposedSolutions;
use shared_geom::error::SourceLocation;
use shared_geom::mesh::CellKind;
use shared_geom::section::{self, InitialCurvature, SectionProperties};

use crate::record;
use crate::swept_tip::copy;

const SOURCE: &str = "Quarter ring with a radial force, Golovin";
const CASE: &str = "cases/chain/ring";

const RADIUS: f64 = 2.0;
/// Of the square section [m].
const SIDE: f64 = 1.0;
const YOUNG: f64 = 210e9;
const FORCE: f64 = 100.0;

/// 24 cells of degree 2 over the depth leave 1e-7, the position of the end, 2 m, has
/// round-off of 1e-8 of its displacement, and the strains are of order 1e-8.
const TOLERANCE: f64 = 1e-6;

/// Displacement of the end along the force \[m\].
fn golovin() -> f64 {
    let (a, b) = (RADIUS - 0.5 * SIDE, RADIUS + 0.5 * SIDE);
    let (sum, difference) = (a * a + b * b, b * b - a * a);
    let n = sum * (b / a).ln() - difference;
    PI * FORCE * sum / (YOUNG * SIDE * n)
}

/// Displacement of the tip of a model \[m\].
fn tip(file: &Path) -> Vector3<f64> {
    let input = beam_dynamics::input::read(file).unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let (first, last) = (
        outcome.result.nodes.last().unwrap(),
        outcome.result.last().unwrap(),
    );
    last.positions.last().unwrap() - first.position
}

/// The case as on its page: the section of the ring gives Golovin's displacement, the
/// section of a straight beam is too soft by more than 3 %.
#[test]
fn a_curved_section_makes_an_exact_ring() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().unwrap();
    for part in [CASE, "meshes/thick_bar"] {
        copy(&root.join(part), &folder.path().join(part));
    }
    let [ring, straight] = ["ring", "straight"].map(|name| {
        let file = |kind: &str| folder.path().join(CASE).join(format!("{name}.{kind}.toml"));
        let words = [
            "section-analyzer".into(),
            "analyze".into(),
            file("section").into(),
        ];
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let code = section_analyzer::cli::run(words, &mut out, &mut err);
        assert_eq!(code, 0, "{}", String::from_utf8_lossy(&err));
        -tip(&file("dynamics")).x
    });
    let exact = golovin();
    let error = (ring / exact - 1.0).abs();
    println!("{ring:e} {exact:e} {error:e}, straight {straight:e}");
    let quantity = "displacement of the end along the force [m]";
    record::value(SOURCE, "ring", quantity, [ring, exact], error, TOLERANCE);
    assert!(error < TOLERANCE, "{ring:e} {exact:e}");
    let off = straight / exact - 1.0;
    assert!(off > 0.03, "{straight:e} {exact:e}");
    let quantity = "excess of the displacement with the section of a straight beam, least";
    record::order(SOURCE, "ring", quantity, off, 0.03);
}

/// The section solved for a beam curved by k2 and k3 \[1/m\], with many cells across the
/// curvature.
fn solved([k2, k3]: [f64; 2]) -> SectionProperties {
    let cells = if k2 == 0.0 { [24, 2] } else { [2, 24] };
    let mesh = Rectangle {
        width: SIDE,
        height: SIDE,
        cells_y: cells[0],
        cells_z: cells[1],
        kind: CellKind::Quadrilateral9,
        name: "bar".into(),
    };
    let mesh = mesh.generate().unwrap();
    let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("bar")).unwrap();
    let cell = CellMaterial {
        material: 0,
        fiber_angle: 0.0,
        plane_angle: 0.0,
    };
    let steel = Material {
        name: "steel".into(),
        law: ElasticLaw::Isotropic {
            young: YOUNG,
            poisson: 0.0,
        },
        density: 7850.0,
        expansion: None,
        electric: None,
    };
    let section = Section {
        name: "bar".into(),
        cells: vec![cell; mesh.cells.len()],
        mesh,
        materials: vec![steel],
        initial_curvature: InitialCurvature {
            curvature: Vector3::new(0.0, k2, k3),
            ..InitialCurvature::STRAIGHT
        },
        electrodes: Vec::new(),
    };
    let solution = analyze(&section).unwrap_or_else(|failure| panic!("{failure}"));
    properties(&section, &solution, &ImposedSolutions::default(), "")
}

/// The quarter ring curved by k2 and k3 \[1/m\], with the section that was solved for it:
/// displacement of its end under a force along -x.
fn curved([k2, k3]: [f64; 2]) -> Vector3<f64> {
    let properties = solved([k2, k3]);
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    write("bar.properties.json", section::write(&properties));
    let station = "file = \"bar.properties.json\"";
    write(
        "a.blade.toml",
        format!(
            "units = \"SI\"\nframe = \"helicoid\"\nreference_point = \"line\"\n[[line.arc]]\n\
             length = {:?}\ncurvature = [0, {k2:?}, {k3:?}]\n[[station]]\neta = 0\n{station}\n\
             [[station]]\neta = 1\n{station}\n",
            0.5 * PI * RADIUS
        ),
    );
    write(
        "a.dynamics.toml",
        format!(
            "units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"a.blade.toml\"\n\
             elements = 20\n[[load]]\nnode = \"b/tip\"\nforce = [{:?}, 0, 0]\n[static]\n",
            -FORCE
        ),
    );
    tip(&folder.path().join("a.dynamics.toml"))
}

/// The ring in each of the four directions: k3 > 0 bends it toward +y, k2 > 0 toward -z.
/// The end moves along the force by Golovin's displacement, across it equally toward the
/// center in all four, and not out of the plane.
#[test]
fn the_ring_bends_to_all_sides() {
    let k = 1.0 / RADIUS;
    let toward = [
        ([0.0, k], Vector3::y()),
        ([0.0, -k], -Vector3::y()),
        ([-k, 0.0], Vector3::z()),
        ([k, 0.0], -Vector3::z()),
    ];
    let exact = golovin();
    let mut across = Vec::new();
    for (curvature, center) in toward {
        let moved = curved(curvature);
        let error = (-moved.x / exact - 1.0).abs();
        let case = format!("ring, k2 = {}, k3 = {} 1/m", curvature[0], curvature[1]);
        println!("{case}: {moved:?} {error:e}");
        let quantity = "displacement of the end along the force [m]";
        record::value(SOURCE, &case, quantity, [-moved.x, exact], error, TOLERANCE);
        assert!(error < TOLERANCE, "{case}: {moved:?}");
        let out_of_plane = moved.dot(&Vector3::x().cross(&center));
        assert!(out_of_plane.abs() < 1e-12 * exact, "{case}: {moved:?}");
        across.push(moved.dot(&center));
    }
    for other in &across {
        assert!((other / across[0] - 1.0).abs() < TOLERANCE, "{across:?}");
    }
}
