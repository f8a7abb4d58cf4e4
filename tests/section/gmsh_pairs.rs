//! The reference meshes, written by gmsh in both versions of its format.
//!
//! Source: output of gmsh for the `.geo` file next to each mesh; the two files of a pair
//! contain the same mesh, so that reading them must give equal nodes, cells and groups, to
//! the last bit.

use std::path::{Path, PathBuf};

use shared_geom::gmsh;
use shared_geom::mesh::{CellKind, Mesh};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/sections");

const NAMES: [&str; 20] = [
    "becas_S2",
    "becas_S3_0",
    "becas_S3_90",
    "bimat_rect",
    "blade_naca",
    "box_CAS_15",
    "box_CUS_15",
    "box_CUS_45_m45",
    "iso_channel",
    "iso_ellipse",
    "iso_rect",
    "iso_rect_thin",
    "iso_square",
    "iso_tube",
    "iso_tube_thick",
    "ortho_rect_0",
    "ortho_rect_15",
    "ortho_rect_30",
    "vabs_box_cus_15_psi",
    "vabs_channel",
];

fn mesh(path: &Path) -> Mesh {
    gmsh::read_file(path).unwrap_or_else(|problems| panic!("{problems}"))
}

fn pair(name: &str) -> [Mesh; 2] {
    let path = |version| -> PathBuf { [FOLDER, &format!("{name}.{version}.msh")].iter().collect() };
    ["v22", "v41"].map(|version| mesh(&path(version)))
}

#[test]
fn both_versions_of_a_mesh_are_equal() {
    for name in NAMES {
        let [old, new] = pair(name);
        assert_eq!(old.nodes, new.nodes, "{name}: nodes");
        assert_eq!(old.cells, new.cells, "{name}: cells");
        assert_eq!(old.groups, new.groups, "{name}: groups");
        assert_eq!(old, new, "{name}");
    }
}

#[test]
fn every_cell_is_a_quadratic_triangle_in_a_named_group() {
    // the README of the reference meshes: 6-node triangles
    for name in NAMES {
        let [mesh, _] = pair(name);
        assert!(!mesh.cells.is_empty(), "{name}");
        for cell in &mesh.cells {
            assert_eq!(cell.kind, CellKind::Triangle6, "{name}");
            assert_eq!(cell.groups.as_slice().len(), 1, "{name}");
            let group = cell.groups.first().map(|group| &mesh.groups[group]);
            assert!(
                group.is_some_and(|group| group.dimension == 2 && group.name.is_some()),
                "{name}: cell {}",
                cell.tag
            );
        }
    }
}

#[test]
fn writing_and_reading_again_changes_nothing() {
    for name in NAMES {
        let [_, mesh] = pair(name);
        let again = gmsh::read(&gmsh::write(&mesh), name);
        assert_eq!(again.unwrap(), mesh, "{name}");
    }
}
