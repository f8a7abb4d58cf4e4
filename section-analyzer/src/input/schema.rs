//! The descriptions of the input files: the lists of their keys.
//!
//! Each table declares its keys next to its reader; the unknown keys of a file, the JSON
//! schema for editors and the reference of the book follow from these declarations. A new
//! table needs one line here.

use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{Table, Text, Word};
use shared_geom::document::schema::{Numbers, UNITS};
use shared_geom::keys;

pub use shared_geom::document::schema::{
    Description, Family, KeySchema, Need, TableSchema, ValueKind,
};

use super::regions::{self, Written};
use super::{
    blade, curvature, electrodes, external, imposed, laminae, layup, loads, materials, requests,
};

keys! {
    /// A section: its mesh, its materials, and the material of each region of the mesh.
    pub SECTION_FILE = "NAME.section.toml";
    /// Name of the section in reports and property files.
    pub(super) NAME: Option<Written> = "name", [Text], or "NAME of the file", "\"spar\"";
    /// Mesh file of gmsh; a relative path is relative to the folder of this file.
    pub(super) MESH: Written = "mesh", [Text]
        as "the path of a mesh (gmsh, Abaqus, VTK, VABS, BECAS), from this file's folder", required, "\"spar.msh\"";
    /// Doubled nodes along the border of two regions: an error, or allowed if slits are intended.
    pub(super) DOUBLED_NODES: usize = "doubled_nodes", [Word(&["error", "allow"])],
        or "\"error\"" = 0, "\"allow\"";
    /// Units of numbers without a unit: SI, or the units of the table.
    pub(super) UNITS_KEY: ByHand = "units", [Word(&["SI"]), Table(&UNITS)], required, "\"SI\"";
    with materials::MATERIALS.schema, regions::REGIONS.schema, laminae::LAMINAE.schema,
        electrodes::ELECTRODES.schema, curvature::BEAM.schema, imposed::TEMPERATURES.schema,
        imposed::STRAINS.schema, loads::LOADS.schema, requests::END_EFFECTS.schema,
        requests::PRESTRESS.schema;
}

/// Section files.
///
/// Their schema does not check the names of groups, the dimensions of units and the
/// admissibility of laws; `section-analyzer check` does.
pub const SECTION: Description = Description {
    file: &SECTION_FILE,
    numbers: Numbers::Plain,
    opening: "\
# Section input reference

Every key of a section file, `NAME.section.toml`.
Made by `section-analyzer schema --format markdown`; do not edit.
The use of the keys is described in [Section input](section-input.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"73.1 GPa\"`.
A *name* is a text, or a whole number that represents one: the tag of a physical group.
",
};

/// Files of sections of blades to be meshed.
pub const BLADE: Description = Description {
    file: &blade::BLADE_FILE,
    numbers: Numbers::Plain,
    opening: "\
# Blade mesh reference

Every key of a file for `section-analyzer mesh blade`.
Made by `section-analyzer schema --of blade --format markdown`; do not edit.
The use of the keys is described in [Meshes of blades](blade-mesh.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"0.25 in\"`.
",
};

/// Files of layups.
pub const LAYUP: Description = Description {
    file: &layup::LAYUP_FILE,
    numbers: Numbers::Plain,
    opening: "\
# Layup reference

Every key of a layup file, `NAME.layup.toml`.
Made by `section-analyzer schema --of layup --format markdown`; do not edit.
The use of the keys is described in [Layups](layup.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"80 mm\"`; many may change along the span, `{ eta = [...], value = [...] }`.
",
};

/// Files of sections given by their matrices.
pub const MATRICES: Description = Description {
    file: &external::MATRICES_FILE,
    numbers: Numbers::Plain,
    opening: "\
# Matrices reference

Every key of a matrices file, `NAME.matrices.toml`.
Made by `section-analyzer schema --of matrices --format markdown`; do not edit.
The use of the keys is described in [Matrices of other programs](matrices-input.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"25 mm\"`.
",
};
