//! The description of the section file: the list of its keys.
//!
//! Each table declares its keys next to its reader; the unknown keys of a file, the JSON
//! schema for editors ([`json_schema`]) and the reference of the book ([`reference`]) follow
//! from these declarations. A new table needs one line here.

use serde_json::Value;
use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{Table, Text, Word};
use shared_geom::document::schema::{self, UNITS};
use shared_geom::keys;

pub use shared_geom::document::schema::{Family, KeySchema, Need, TableSchema, ValueKind};

use super::regions::{self, Written};
use super::{curvature, electrodes, imposed, laminae, loads, materials, requests};

keys! {
    /// A section: its mesh, its materials, and the material of each region of the mesh.
    pub SECTION_FILE = "NAME.section.toml";
    /// Name of the section in reports and property files.
    pub(super) NAME: Option<Written> = "name", [Text], or "NAME of the file", "\"spar\"";
    /// Mesh file of gmsh; a relative path is relative to the folder of this file.
    pub(super) MESH: Written = "mesh", [Text]
        as "the path of a gmsh file, from this file's folder", required, "\"spar.msh\"";
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

/// The opening of the reference page.
const OPENING: &str = "\
# Section input reference

Every key of a section file, `NAME.section.toml`.
Made by `section-analyzer schema --format markdown`; do not edit.
The use of the keys is described in [Section input](section-input.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"73.1 GPa\"`.
A *name* is a text, or a whole number that represents one: the tag of a physical group.
";

/// The JSON schema of a section file, draft 2020-12.
///
/// It does not check the names of groups, the dimensions of units and the admissibility of
/// laws; `section-analyzer check` does.
pub fn json_schema() -> Value {
    schema::json_schema(&SECTION_FILE, schema::Numbers::Plain)
}

/// The reference page of the section file, in Markdown.
pub fn reference() -> String {
    schema::reference(&SECTION_FILE, OPENING)
}
