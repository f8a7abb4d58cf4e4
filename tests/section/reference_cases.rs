//! Twenty sections with the results of two independent solvers.
//!
//! Source: `tests/reference/sections/README.md`. Each case is solved on the stored mesh
//! itself, so that the result is exact up to round-off: ANBA4 and a second solver agree to
//! 1e-9 relative to `sqrt(K_ii K_jj)` or better.
//!
//! Tolerances: 1e-8 for the stiffness and for the centers (of the section's size), which
//! allows for the round-off of the references (2e-11 observed); 1e-10 for the mass, a plain
//! sum.
//!
//! The files have x to the right, y up, z along the beam and the order shear x, shear y,
//! axial, bending x, bending y, torque: their rows and columns 2 0 1 5 3 4 are our order.

use std::collections::HashMap;
use std::path::PathBuf;

use nalgebra::Matrix6;
use section_analyzer::material::{ElasticLaw, EngineeringConstants, Material};
use section_analyzer::section::{CellMaterial, Section};
use section_analyzer::solution::SectionSolution;
use serde_json::Value;
use shared_geom::gmsh;
use shared_geom::mesh::{Cell, CellKind, Mesh};
use shared_geom::section::InitialCurvature;

use crate::record;
use crate::sections::{scaled_error, section_mesh, solved};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/sections");

const SOURCE: &str = "ANBA4 and a second solver, on the same mesh";

const STIFFNESS_TOLERANCE: f64 = 1e-8;
const MASS_TOLERANCE: f64 = 1e-10;
const CENTER_TOLERANCE: f64 = 1e-8;

/// Our components in terms of the rows and columns of the files.
const ORDER: [usize; 6] = [2, 0, 1, 5, 3, 4];

fn path(file: &str) -> PathBuf {
    [FOLDER, file].iter().collect()
}

pub fn read_case(name: &str) -> Value {
    let text = std::fs::read_to_string(path(&format!("{name}.json"))).expect("case file");
    serde_json::from_str(&text).expect("case in JSON")
}

pub fn read_mesh(name: &str, version: &str) -> Mesh {
    gmsh::read_file(&path(&format!("{name}.{version}.msh")))
        .unwrap_or_else(|problems| panic!("{problems}"))
}

pub fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("expected a number, found {value}"))
}

pub fn matrix(value: &Value) -> Matrix6<f64> {
    let matrix = Matrix6::from_fn(|i, j| number(&value[ORDER[i]][ORDER[j]]));
    0.5 * (matrix + matrix.transpose())
}

/// f is the fiber, g in-plane transverse, n through the thickness; the files call
/// them z, x, y.
pub fn material(value: &Value) -> Material {
    let constant = |key: &str| number(&value[key]);
    let law = match value["type"].as_str() {
        Some("iso") => ElasticLaw::Isotropic {
            young: constant("E"),
            poisson: constant("nu"),
        },
        _ => ElasticLaw::Orthotropic(EngineeringConstants {
            e1: constant("e_zz"),
            e2: constant("e_xx"),
            e3: constant("e_yy"),
            g12: constant("g_xz"),
            g13: constant("g_yz"),
            g23: constant("g_xy"),
            nu12: constant("nu_zx"),
            nu13: constant("nu_zy"),
            nu23: constant("nu_xy"),
        }),
    };
    Material {
        name: value["type"].to_string(),
        law,
        density: constant("rho"),
        expansion: None,
        electric: None,
    }
}

/// Plane angle of each cell by tag, if given by the case [rad].
fn plane_angles(case: &Value) -> HashMap<u64, f64> {
    let Some(elements) = case.get("elements") else {
        return HashMap::new();
    };
    let tags = elements["tag"].as_array().expect("tags");
    let angles = elements["plane_deg"].as_array().expect("angles");
    let pairs = tags.iter().zip(angles);
    pairs
        .map(|(tag, angle)| (tag.as_u64().expect("tag"), number(angle).to_radians()))
        .collect()
}

pub fn section(name: &str, case: &Value, mesh: &Mesh) -> Section {
    let angles = plane_angles(case);
    let section_mesh = section_mesh(mesh);
    let tag_of_label: HashMap<String, i32> = mesh
        .groups
        .iter()
        .filter(|group| group.dimension == 2)
        .map(|group| (group.label(), group.tag))
        .collect();
    let cells = section_mesh.cells.iter().map(|cell| {
        let tag = tag_of_label[&section_mesh.groups[cell.group]];
        let group = &case["groups"][tag.to_string()];
        CellMaterial {
            material: group["material"].as_u64().expect("index") as usize,
            fiber_angle: number(&group["fibre_deg"]).to_radians(),
            plane_angle: match group["plane_deg"].as_f64() {
                Some(degrees) => degrees.to_radians(),
                None => angles[&cell.tag],
            },
        }
    });
    let materials = case["materials"].as_array().expect("materials");
    Section {
        name: name.into(),
        cells: cells.collect(),
        materials: materials.iter().map(material).collect(),
        mesh: section_mesh,
        initial_curvature: InitialCurvature::STRAIGHT,
        electrodes: Vec::new(),
    }
}

/// The same mesh with only the corner nodes of its triangles.
pub fn with_corners_only(mesh: &Mesh) -> Mesh {
    let corners = |cell: &Cell| {
        let nodes = cell.corners();
        let mut linear = Cell::new(cell.tag, CellKind::Triangle3, cell.entity, |i| nodes[i]);
        linear.groups = cell.groups.clone();
        linear
    };
    Mesh {
        cells: mesh.cells.iter().map(corners).collect(),
        lines: Vec::new(),
        ..mesh.clone()
    }
}

fn check_matrices(name: &str, mesh: &str, found: &SectionSolution, expected: &Value) {
    let what = format!("{name}, {mesh}");
    let stiffness = scaled_error(&found.stiffness, &matrix(&expected["K"]));
    let mass = scaled_error(&found.mass, &matrix(&expected["M"]));
    println!("{what}: stiffness {stiffness:.1e}, mass {mass:.1e}");
    let cells = match mesh {
        "linear" => "3-node triangles",
        _ => "6-node triangles",
    };
    for (quantity, error, tolerance) in [
        ("stiffness", stiffness, STIFFNESS_TOLERANCE),
        ("mass", mass, MASS_TOLERANCE),
    ] {
        let quantity = format!("{quantity}, {cells}");
        record::largest(SOURCE, name, &quantity, error, tolerance);
    }
    assert!(
        stiffness <= STIFFNESS_TOLERANCE,
        "{what}: stiffness off by {stiffness:e}"
    );
    assert!(mass <= MASS_TOLERANCE, "{what}: mass off by {mass:e}");
}

fn check_centers(name: &str, section: &Section, found: &SectionSolution, expected: &Value) {
    let size = section
        .mesh
        .nodes
        .iter()
        .flatten()
        .fold(0.0_f64, |size, x| size.max(x.abs()));
    let centers = [
        ("tension_centre", Some(found.centers.tension)),
        ("shear_centre", Some(found.centers.shear)),
        ("mass_centre", found.centers.mass),
    ];
    for (key, found) in centers {
        let found = found.expect("a center");
        for axis in 0..2 {
            let error = (found[axis] - number(&expected[key][axis])).abs() / size;
            record::largest(SOURCE, name, "centers", error, CENTER_TOLERANCE);
            assert!(error <= CENTER_TOLERANCE, "{name}: {key} off by {error:e}");
        }
    }
}

/// Checks all results of a case: quadratic cells read from both versions of the mesh file,
/// and linear cells.
fn check(name: &str) {
    let case = read_case(name);
    for version in ["v22", "v41"] {
        let mesh = read_mesh(name, version);
        let section = section(name, &case, &mesh);
        let found = solved(&section);
        let expected = &case["on_this_mesh"];
        check_matrices(name, version, &found, expected);
        check_centers(name, &section, &found, expected);
    }

    let mesh = with_corners_only(&read_mesh(name, "v41"));
    let found = solved(&section(name, &case, &mesh));
    check_matrices(name, "linear", &found, &case["on_this_mesh_tri3"]);
}

/// Square of two isotropic halves.
#[test]
fn becas_s2() {
    check("becas_S2");
}

/// Square, orthotropic, fibers along the beam.
#[test]
fn becas_s3_0() {
    check("becas_S3_0");
}

/// Square, orthotropic, fibers across.
#[test]
fn becas_s3_90() {
    check("becas_S3_90");
}

/// Rectangle of steel and aluminum.
#[test]
fn bimat_rect() {
    check("bimat_rect");
}

/// Airfoil section of three materials, wall angle per cell.
#[test]
fn blade_naca() {
    check("blade_naca");
}

/// Box beam, circumferentially asymmetric lay-up at 15 degrees.
#[test]
fn box_cas_15() {
    check("box_CAS_15");
}

/// Box beam, circumferentially uniform lay-up at 15 degrees.
#[test]
fn box_cus_15() {
    check("box_CUS_15");
}

/// Box beam, plies at 45 and -45 degrees.
#[test]
fn box_cus_45_m45() {
    check("box_CUS_45_m45");
}

/// Open channel.
#[test]
fn iso_channel() {
    check("iso_channel");
}

/// Ellipse, a polygon in the mesh.
#[test]
fn iso_ellipse() {
    check("iso_ellipse");
}

/// Rectangle 2:1.
#[test]
fn iso_rect() {
    check("iso_rect");
}

/// Thin rectangle.
#[test]
fn iso_rect_thin() {
    check("iso_rect_thin");
}

/// Square.
#[test]
fn iso_square() {
    check("iso_square");
}

/// Thin tube.
#[test]
fn iso_tube() {
    check("iso_tube");
}

/// Thick tube.
#[test]
fn iso_tube_thick() {
    check("iso_tube_thick");
}

/// Rectangle, fibers along the beam.
#[test]
fn ortho_rect_0() {
    check("ortho_rect_0");
}

/// Rectangle, fibers at 15 degrees.
#[test]
fn ortho_rect_15() {
    check("ortho_rect_15");
}

/// Rectangle, fibers at 30 degrees.
#[test]
fn ortho_rect_30() {
    check("ortho_rect_30");
}

/// Box beam of the VABS literature, in pounds and inches.
#[test]
fn vabs_box_cus_15_psi() {
    check("vabs_box_cus_15_psi");
}

/// Channel of the VABS literature, Poisson's ratio 0.49.
#[test]
fn vabs_channel() {
    check("vabs_channel");
}
