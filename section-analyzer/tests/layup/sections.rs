//! Sections of public blades, as in `tests/reference/layups`.

use std::path::PathBuf;

use nalgebra::Matrix6;
use section_analyzer::analysis::analyze;
use section_analyzer::material::{ElasticLaw, EngineeringConstants, Material};
use section_analyzer::mesh::generate::layup::{Layer, LayupSection, MeshedLayup, Web, WebPly};
use section_analyzer::mesh::{SectionCell, SectionMesh};
use section_analyzer::properties::Centers;
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::SectionSolution;
use serde_json::Value;
use shared_geom::error::SourceLocation;
use shared_geom::section::InitialCurvature;

/// A reference file.
pub fn reference(name: &str) -> Value {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/reference/layups");
    let text = std::fs::read_to_string(folder.join(name)).expect("the reference");
    serde_json::from_str(&text).expect("JSON")
}

/// Checks a number with a relative tolerance.
pub fn close(found: f64, expected: f64, tolerance: f64, of: &str) {
    let error = found - expected;
    assert!(
        error.abs() <= tolerance * expected.abs(),
        "{of}: {found}, expected {expected}"
    );
}

pub fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn text(value: &Value) -> String {
    value.as_str().expect("a text").to_owned()
}

fn list(value: &Value) -> &Vec<Value> {
    value.as_array().expect("a list")
}

/// A section with the material of each layer and web ply.
#[derive(Clone)]
pub struct Case {
    pub name: String,
    pub section: LayupSection,
    /// Names of layers and plies, and of their materials.
    pub materials: Vec<(String, String)>,
    pub laws: Vec<Material>,
}

/// The sections of the reference.
pub fn cases() -> Vec<Case> {
    let file = reference("sections.json");
    list(&file["sections"]).iter().map(case).collect()
}

fn case(value: &Value) -> Case {
    let mut materials = Vec::new();
    let mut ply = |row: &Value| {
        materials.push((text(&row[0]), text(&row[1])));
        (text(&row[0]), number(&row[2]))
    };
    let layer = |row: &Value| {
        let (name, thickness) = ply(row);
        Layer {
            name,
            thickness,
            from: number(&row[3]),
            to: number(&row[4]),
            taper: None,
            profile: Vec::new(),
        }
    };
    let layers = list(&value["layers"]).iter().map(layer).collect();
    let web = |row: &Value| Web {
        name: text(&row[0]),
        arcs: [number(&row[1]), number(&row[2])],
        plies: list(&row[3])
            .iter()
            .map(|row| {
                let (name, thickness) = ply(row);
                WebPly { name, thickness }
            })
            .collect(),
    };
    let webs = list(&value["webs"]).iter().map(web).collect();
    let point = |row: &Value| [number(&row[0]), number(&row[1])];
    let laws = value["materials"].as_object().expect("materials");
    Case {
        name: format!("{} at {}", text(&value["blade"]), number(&value["eta"])),
        section: LayupSection {
            contour: list(&value["contour"]).iter().map(point).collect(),
            layers,
            webs,
            spar: None,
            fills: Vec::new(),
            size: None,
        },
        laws: laws.iter().map(|(name, law)| material(name, law)).collect(),
        materials,
    }
}

/// A material of the reference. IEA-10 has incompressible ones and a law that no material can
/// have; the reference results are of Poisson's ratios of 0.49, and of 0.85 times the given ones
/// through the thickness.
fn material(name: &str, law: &Value) -> Material {
    let three = |key: &str| [0, 1, 2].map(|i| number(&law[key][i]));
    let law_of = if law["E"].is_array() {
        let ([e1, e2, e3], [g12, g13, g23], [nu12, nu13, nu23]) =
            (three("E"), three("G"), three("nu"));
        let through = if nu12 == nu13 && nu13 == nu23 && e1 == e3 {
            0.85
        } else {
            1.0
        };
        let (nu13, nu23) = (through * nu13, through * nu23);
        ElasticLaw::Orthotropic(EngineeringConstants {
            e1,
            e2,
            e3,
            g12,
            g13,
            g23,
            nu12,
            nu13,
            nu23,
        })
    } else {
        ElasticLaw::Isotropic {
            young: number(&law["E"]),
            poisson: number(&law["nu"]).min(0.49),
        }
    };
    Material {
        name: name.to_owned(),
        law: law_of,
        density: number(&law["rho"]),
        expansion: None,
        electric: None,
    }
}

/// The section with its materials; plane angles follow the sides of the cells that run
/// along the wall or the web.
pub fn model(case: &Case, meshed: &MeshedLayup) -> Section {
    let place = SourceLocation::file("layup");
    let (mesh, _) = SectionMesh::from_mesh(&meshed.mesh, 1.0, &place).expect("a sound mesh");
    let cells = mesh.cells.iter().map(|cell| {
        let name = &mesh.groups[cell.group];
        let (_, material) = case
            .materials
            .iter()
            .find(|one| one.0 == *name)
            .expect("a layer");
        let index = case
            .laws
            .iter()
            .position(|law| law.name == *material)
            .expect("a material");
        CellMaterial {
            material: index,
            fiber_angle: 0.0,
            plane_angle: plane_angle(&mesh, cell, case),
        }
    });
    Section {
        name: case.name.clone(),
        cells: cells.collect(),
        materials: case.laws.clone(),
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
        mesh,
    }
}

/// Direction of the wall at a cell: along the contour, and in webs from the pressure to the
/// suction side.
fn plane_angle(mesh: &SectionMesh, cell: &SectionCell, case: &Case) -> f64 {
    let name = &mesh.groups[cell.group];
    let web = case
        .section
        .webs
        .iter()
        .find(|web| web.plies.iter().any(|ply| ply.name == *name));
    let (from, to) = match web {
        Some(web) => {
            let [suction, pressure] = arc_points(&case.section.contour, web.arcs);
            (pressure, suction)
        }
        None => nearest_line(&case.section.contour, mesh.middle(cell)),
    };
    (to[1] - from[1]).atan2(to[0] - from[0])
}

fn arc_points(contour: &[[f64; 2]], arcs: [f64; 2]) -> [[f64; 2]; 2] {
    let length = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
    let base = length(contour[0], contour[contour.len() - 1]);
    let whole: f64 = base
        + contour
            .windows(2)
            .map(|pair| length(pair[0], pair[1]))
            .sum::<f64>();
    arcs.map(|arc| {
        let mut rest = arc * whole - 0.5 * base;
        for pair in contour.windows(2) {
            let step = length(pair[0], pair[1]);
            if rest <= step {
                return [0, 1].map(|i| pair[0][i] + rest / step * (pair[1][i] - pair[0][i]));
            }
            rest -= step;
        }
        contour[contour.len() - 1]
    })
}

/// The line of the contour, base included, that is nearest to a point.
fn nearest_line(contour: &[[f64; 2]], point: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let around = contour.iter().zip(contour.iter().cycle().skip(1));
    let off = |(a, b): &(&[f64; 2], &[f64; 2])| {
        let d = [b[0] - a[0], b[1] - a[1]];
        let length = d[0] * d[0] + d[1] * d[1];
        let part = ((point[0] - a[0]) * d[0] + (point[1] - a[1]) * d[1]) / length.max(1e-300);
        let part = part.clamp(0.0, 1.0);
        (a[0] + part * d[0] - point[0]).hypot(a[1] + part * d[1] - point[1])
    };
    let (a, b) = around
        .min_by(|a, b| off(a).total_cmp(&off(b)))
        .expect("lines");
    (*a, *b)
}

/// Measures without a reference point: m, EA, flap and edge EI, GJ.
pub fn measures(solution: &SectionSolution) -> [f64; 5] {
    let stiffness: Matrix6<f64> = solution.stiffness;
    let compliance = stiffness.try_inverse().expect("a regular matrix");
    let bending = nalgebra::Matrix2::new(
        compliance[(4, 4)],
        compliance[(4, 5)],
        compliance[(5, 4)],
        compliance[(5, 5)],
    );
    let values = bending.symmetric_eigenvalues();
    let [low, high] = [values.min(), values.max()];
    [
        solution.mass[(0, 0)],
        stiffness[(0, 0)],
        1.0 / high,
        1.0 / low,
        1.0 / compliance[(3, 3)],
    ]
}

/// Solves a case.
pub fn solved(case: &Case, meshed: &MeshedLayup) -> [f64; 5] {
    measures(&analyze(&model(case, meshed)).expect("a solution"))
}

/// Solves a case; also its tension center from the compliance.
pub fn solved_with_center(case: &Case, meshed: &MeshedLayup) -> ([f64; 5], [f64; 2]) {
    let solution = analyze(&model(case, meshed)).expect("a solution");
    let stiffness: Matrix6<f64> = solution.stiffness;
    let compliance = stiffness.try_inverse().expect("a regular matrix");
    let centers = Centers::new(&compliance, &solution.mass);
    (measures(&solution), centers.tension)
}
