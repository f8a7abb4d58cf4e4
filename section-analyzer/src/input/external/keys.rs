//! The keys of a section given by its matrices.

use shared_geom::document::schema::ValueKind::{Positive, Rows, Table as OneTable, Text, Word};
use shared_geom::document::schema::{Family, TableSchema, UNITS};
use shared_geom::document::{ByHand, Nested};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::super::curvature::BEAM;
use super::super::regions::Written;
use super::super::requests::END_EFFECTS;

/// The file.
pub(in crate::input) const MATRICES_FILE: TableSchema = TableSchema {
    title: "NAME.matrices.toml",
    meaning: "A section given by matrices of another finite-element program.",
    keys: &[
        NAME.schema,
        UNITS_KEY.schema,
        NODES.schema,
        MASS.schema,
        END_EFFECTS.schema,
    ],
    families: &[
        Family {
            name: "slice",
            meaning: "The stiffness of a slice of a straight beam, one layer of elements thick.",
            keys: &[SLICE.schema],
        },
        Family {
            name: "matrices",
            meaning: "The blocks of the section.",
            keys: &[MATRICES.schema, BEAM.schema],
        },
    ],
};

keys! {
    /// Name of the section in reports and property files.
    pub(super) NAME: Option<String> = "name", [Text], or "NAME of the file", "\"slice\"";
    /// Units of plain numbers and of the matrices, SI or the units of the table.
    UNITS_KEY: ByHand = "units", [Word(&["SI"]), OneTable(&UNITS)], required, "\"SI\"";
    /// CSV file with the header node,y,z and a row for each node, in the order of the unknowns.
    pub(super) NODES: Written = "nodes", [Text]
        as "the path of a node table, from this file's folder", required, "\"nodes.csv\"";
    /// Mass per length about the origin of the nodes, in the order of forces along and moments
    /// about x, y, z.
    pub(super) MASS: Option<[[f64; 6]; 6]> = "mass", [Rows(6, 6)], optional,
        "[[2, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, 0], [0, 0, 2, 0, 0, 0], [0, 0, 0, 3, 0, 0], \
         [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 2]]";
    /// A slice of the beam.
    pub(super) SLICE: Nested = "slice", [OneTable(&SLICE_TABLE)], required, "";
    /// The blocks of the section.
    pub(super) MATRICES: Nested = "matrices", [OneTable(&MATRICES_TABLE)], required, "";
}

keys! {
    /// Files in the format of Matrix Market. The unknowns of the face at the smaller x come first,
    /// then the unknowns of the other face: u_x, u_y, u_z of each node.
    SLICE_TABLE = "[slice]";
    /// Stiffness of the slice.
    pub(super) STIFFNESS: Written = "stiffness", [Text] as "the path of a Matrix Market file",
        required, "\"slice.mtx\"";
    /// Consistent mass matrix of the slice, instead of the mass of the section.
    pub(super) SLICE_MASS: Option<Written> = "mass", [Text], optional, "\"slice_mass.mtx\"";
    /// Thickness of the slice.
    pub(super) THICKNESS: f64 = "thickness", [Positive(Dimension::LENGTH)], required, "1";
    /// Displacements through the slice: linear with all strains integrated, or with strains in the
    /// middle only.
    pub(super) THROUGH: usize = "through", [Word(&["linear", "middle"])], or "\"linear\"" = 0,
        "\"middle\"";
}

keys! {
    /// Files in the format of Matrix Market. The unknowns are u_x, u_y, u_z of each node; L, R and
    /// A follow from M, C and E, and are compared if they are given.
    MATRICES_TABLE = "[matrices]";
    /// M: rows and columns of u'.
    pub(super) M: Written = "m", [Text] as "the path of a Matrix Market file", required,
        "\"m.mtx\"";
    /// C: rows of u', columns of u.
    pub(super) C: Written = "c", [Text] as "the path of a Matrix Market file", required,
        "\"c.mtx\"";
    /// E: rows and columns of u.
    pub(super) E: Written = "e", [Text] as "the path of a Matrix Market file", required,
        "\"e.mtx\"";
    /// L: rows of u', columns of the strains of the beam.
    pub(super) L: Option<Written> = "l", [Text], optional, "\"l.mtx\"";
    /// R: rows of u, columns of the strains of the beam.
    pub(super) R: Option<Written> = "r", [Text], optional, "\"r.mtx\"";
    /// A: rows and columns of the strains of the beam.
    pub(super) A: Option<Written> = "a", [Text], optional, "\"a.mtx\"";
}
