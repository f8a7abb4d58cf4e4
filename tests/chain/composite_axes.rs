//! The axes of the table of prestress: the axes of a geometrically exact beam.
//!
//! A bent strip of +30 and -30 degree plies shears, so that its sections are inclined to
//! the line, and tables in axes of the section and along the tangent of the line differ.
//! In axes of the tangent, with `r = (0, -nu3, nu2)` of the linear solution p,
//!
//! ```text
//! second-order force   -1/2 T' p p ,  moments turned by - r x M
//! nu1 = nu1' - 1/2 (nu2^2 + nu3^2) ,  kappa = kappa' + r x kappa
//! ```
//!
//! # References
//! - `tests/reference/theory/prestress.json`: T' of the strip by an independent program, along
//!   the tangent.

use beam_dynamics::analysis::statics::statics;
use nalgebra::{Matrix4, Vector3, Vector4, Vector6};
use section_analyzer::analysis::analyze;
use section_analyzer::material::{ElasticLaw, EngineeringConstants, Material};
use section_analyzer::mesh::SectionMesh;
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::output::{add_prestress, properties};
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::ImposedSolutions;
use serde_json::Value;
use shared_geom::error::SourceLocation;
use shared_geom::mesh::CellKind;
use shared_geom::section::{
    self, CubicTable, InitialCurvature, PRESTRESS_COMPONENTS, SectionProperties, StrainMeasure,
    prestress_part,
};

use crate::record;

const SOURCE: &str = "Prototype of the cubic energy, in a bent beam";

/// The strip of the prototype: 10 x 1 m, +30 degrees above the middle and -30 below, in GPa.
fn strip() -> SectionProperties {
    let rectangle = Rectangle {
        width: 10.0,
        height: 1.0,
        cells_y: 24,
        cells_z: 4,
        kind: CellKind::Quadrilateral9,
        name: "strip".into(),
    };
    let mesh = rectangle.generate().unwrap();
    let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("test")).unwrap();
    let ply = EngineeringConstants {
        e1: 181.0,
        e2: 10.3,
        e3: 10.3,
        g12: 7.17,
        g13: 7.17,
        g23: 3.7,
        nu12: 0.28,
        nu13: 0.28,
        nu23: 0.4,
    };
    let of_cell = |cell| {
        let height: f64 = mesh.positions(cell).map(|position| position[1]).sum();
        CellMaterial {
            material: 0,
            fiber_angle: 30.0_f64.to_radians().copysign(height),
            plane_angle: 0.0,
        }
    };
    let section = Section {
        name: "strip".into(),
        cells: mesh.cells.iter().map(of_cell).collect(),
        mesh,
        materials: vec![Material {
            name: "ply".into(),
            law: ElasticLaw::Orthotropic(ply),
            density: 1.0,
            expansion: None,
            electric: None,
        }],
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    };
    let solution = analyze(&section).unwrap();
    let none = ImposedSolutions::default();
    let mut found = properties(&section, &solution, &none, "");
    add_prestress(&mut found, &section, &solution, &none, StrainMeasure::Green).unwrap();
    found
}

/// T' of the prototype.
fn along_tangent() -> CubicTable {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/theory/prestress.json"
    );
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let entries = &file["cases"]["antisymmetric 30/-30 strip green"]["T"];
    CubicTable::from_fn(|indices| {
        let [i, j, k] = indices.map(|index| PRESTRESS_COMPONENTS[index]);
        entries[format!("{i}{j}{k}")].as_f64().unwrap_or(0.0)
    })
}

/// Strain at the last evaluation point of a cantilever that a moment about y bends to an arc.
fn bent(section: &SectionProperties, moment: f64) -> Vector6<f64> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("strip.properties.json");
    std::fs::write(file, section::write(section)).unwrap();
    let text = format!(
        "units = \"SI\"\n[properties.strip]\nfile = \"strip.properties.json\"\nprestress = true\n\
         [[blade]]\nname = \"strip\"\nproperties = \"strip\"\n\
         [[blade.piece]]\nlength = 100\nelements = 8\n\
         [[load]]\nnode = \"strip/tip\"\nmoment = [0, {moment:e}, 0]\nfollower = true\n[static]\n"
    );
    let file = folder.path().join("strip.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    let input = beam_dynamics::input::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome
        .result
        .last()
        .unwrap()
        .sections
        .last()
        .unwrap()
        .strain
}

/// Axial strain and twist that are even in the moment: the terms of second order. The
/// rest is of fourth order, the square of a strain of 1e-4 at the faces, amplified by the
/// ratio of width to thickness: 1e-6; and Newton's tolerance over a part of 1e-4 of the
/// strain.
#[test]
fn a_bent_composite_strip_has_the_strains_of_the_prototype() {
    const TOLERANCE: f64 = 1e-5;
    let section = strip();
    let moment = 34.6 * 2e-4;
    let [up, down] = [moment, -moment].map(|moment| bent(&section, moment));
    let even = 0.5 * (up + down);

    let compliance = section.stiffness.try_inverse().unwrap();
    let linear: Vector6<f64> = compliance.column(4) * moment;
    let p = prestress_part(&linear);
    let r = Vector3::new(0.0, -linear[2], linear[1]);
    let force = -0.5 * along_tangent().along(&p) * p;
    let turned = -r.cross(&Vector3::new(0.0, moment, 0.0));
    let force = force + Vector4::new(0.0, turned.x, turned.y, turned.z);
    let pick = |i: usize, j: usize| compliance[(PRESTRESS_COMPONENTS[i], PRESTRESS_COMPONENTS[j])];
    let strain = Matrix4::from_fn(pick) * force;
    let curvature = r.cross(&Vector3::new(p[1], p[2], p[3]));
    let axial = strain[0] - 0.5 * (linear[1].powi(2) + linear[2].powi(2));
    let twist = strain[1] + curvature.x;
    // without the turn the axial strain is another
    assert!((strain[0] / even[0] - 1.0).abs() > 1e-2);
    for (quantity, found, expected) in [
        ("axial strain of second order [-]", even[0], axial),
        ("twist of second order [1/m]", even[3], twist),
    ] {
        let error = (found / expected - 1.0).abs();
        println!("{quantity}: {found:e} {expected:e} {error:e}");
        let case = "strip of +30 and -30 degrees, bent";
        record::value(SOURCE, case, quantity, [found, expected], error, TOLERANCE);
        assert!(error < TOLERANCE, "{quantity}: {found:e} {expected:e}");
    }
}
