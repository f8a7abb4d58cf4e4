//! Binary meshes of quadrilaterals, and of both shapes together, reach the
//! converged stiffness of the reference sections.
//!
//! Source: `tests/reference/gmsh/README.md` for the meshes (other cells and node positions
//! than the reference meshes), `tests/reference/sections` for the values: K extrapolated
//! from refined meshes, with the uncertainty of each entry; M of the reference mesh, which
//! has the same straight boundaries.

use std::path::PathBuf;

use nalgebra::Matrix6;
use shared_geom::gmsh;
use shared_geom::mesh::{CellKind, Mesh};

use crate::converged::{CONVERGED, record_nearest};
use crate::record;
use crate::reference_cases::{matrix, read_case, section};
use crate::sections::{scaled_error, solved};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/gmsh/sections");

/// Allowance for these meshes in addition to the uncertainty of the converged values,
/// relative to `sqrt(K_ii K_jj)`: on the reference meshes with 8 cells across the
/// rectangles the largest error is 1.1e-4, in torsion, and quadratic cells reduce it with
/// the fourth power; these have 14, (8/14)^4 = 0.107. The meshes of the channel and the box
/// are graded towards their corners, so that the uncertainty is larger than their error.
const ALLOWANCE: f64 = 1.2e-5;

/// The boundaries are equal to the sixteen digits of the files.
const MASS_TOLERANCE: f64 = 1e-12;

fn read(name: &str, file: &str) -> Mesh {
    let path: PathBuf = [FOLDER, &format!("{name}.{file}.msh")].iter().collect();
    let bytes = std::fs::read(path).expect("a mesh file");
    assert_eq!(&bytes[15..19], b" 1 8", "{name}.{file} is binary");
    gmsh::read(&bytes, file).unwrap_or_else(|problems| panic!("{problems}"))
}

fn check(name: &str) {
    let case = read_case(name);
    let expected = matrix(&case["converged"]["K"]);
    let uncertainty = matrix(&case["converged"]["uncertainty_abs"]);
    let mass = matrix(&case["on_this_mesh"]["M"]);
    for (file, kinds) in [
        ("quad8", &[CellKind::Quadrilateral8][..]),
        ("quad9", &[CellKind::Quadrilateral9]),
        ("mixed", &[CellKind::Triangle6, CellKind::Quadrilateral8]),
    ] {
        let mesh = read(name, file);
        for kind in CellKind::ALL {
            let found = mesh.cells.iter().any(|cell| cell.kind == kind);
            assert_eq!(found, kinds.contains(&kind), "{name}, {file}: {kind:?}");
        }
        let found = solved(&section(name, &case, &mesh));
        let scaled = |values: Matrix6<f64>| {
            let scale = |i: usize, j: usize| (expected[(i, i)] * expected[(j, j)]).sqrt();
            Matrix6::from_fn(|i, j| values[(i, j)] / scale(i, j))
        };
        let error = scaled((found.stiffness - expected).abs());
        let uncertainty = scaled(uncertainty);
        let worst = (error - uncertainty).max();
        let what = format!("{name}, binary gmsh mesh, {file}");
        record_nearest(&what, &error, &uncertainty.add_scalar(ALLOWANCE));
        println!("{name}, {file}: {worst:.1e} beyond the uncertainty");
        assert!(worst <= ALLOWANCE, "{name}, {file}: {worst:e}");
        let error = scaled_error(&found.mass, &mass);
        record::largest(CONVERGED, &what, "mass", error, MASS_TOLERANCE);
        assert!(error <= MASS_TOLERANCE, "{name}, {file}: mass {error:e}");
    }
}

/// Rectangle 2:1.
#[test]
fn iso_rect() {
    check("iso_rect");
}

/// Rectangle of steel and aluminum.
#[test]
fn bimat_rect() {
    check("bimat_rect");
}

/// Open channel.
#[test]
fn iso_channel() {
    check("iso_channel");
}

/// Box beam, plies at 45 and -45 degrees.
#[test]
fn box_cus_45_m45() {
    check("box_CUS_45_m45");
}
