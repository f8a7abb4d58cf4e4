//! The keys of the section file.

use shared_geom::section::StrainMeasure;
use shared_geom::units::Dimension;

use super::distributed::END_EFFECTS;
use super::electric::ELECTRODE;
use super::imposed::{INITIAL_STRAIN, TEMPERATURE};
use super::laminae::LAMINA;
use super::loads::LOAD;
use super::materials::MATERIAL;
use super::{Family, KeySchema, Need, TableSchema, UNITS, ValueKind, key};

use Need::{Default, Optional, Required};

const TEXT: &[ValueKind] = &[ValueKind::Text];
const GROUP: &[ValueKind] = &[ValueKind::Name];

/// The whole file.
pub const SECTION_FILE: TableSchema = TableSchema {
    title: "NAME.section.toml",
    meaning: "A section: its mesh, its materials, and the material of each region of the mesh.",
    keys: &[
        key(
            "name",
            TEXT,
            Default("NAME of the file"),
            "\"spar\"",
            "Name of the section in reports and property files.",
        ),
        key(
            "mesh",
            TEXT,
            Required,
            "\"spar.msh\"",
            "Mesh file of gmsh; a relative path is relative to the folder of this file.",
        ),
        key(
            "doubled_nodes",
            &[ValueKind::Word(&["error", "allow"])],
            Default("\"error\""),
            "\"allow\"",
            "Doubled nodes along the border of two regions: an error, or allowed if slits are \
             intended.",
        ),
        key(
            "units",
            &[ValueKind::Word(&["SI"]), ValueKind::Table(&UNITS)],
            Required,
            "\"SI\"",
            "Units of numbers without a unit: SI, or the units of the table.",
        ),
        key(
            "material",
            &[ValueKind::NamedTables(&MATERIAL)],
            Required,
            "",
            "The materials, by name.",
        ),
        key(
            "region",
            &[ValueKind::Tables(&REGION)],
            Optional,
            "",
            "Material and angles of each physical surface of the mesh; every surface needs a \
             region.",
        ),
        key(
            "lamina",
            &[ValueKind::Tables(&LAMINA)],
            Optional,
            "",
            "Laminates along physical curves of the mesh, next to cells or without.",
        ),
        key(
            "electrode",
            &[ValueKind::Tables(&ELECTRODE)],
            Optional,
            "",
            "Electrodes on piezoelectric materials and other dielectrics.",
        ),
        key(
            "initial_curvature",
            &[ValueKind::Table(&INITIAL_CURVATURE)],
            Optional,
            "",
            "Curvature and twist of the undeformed beam.",
        ),
        key(
            "temperature",
            &[ValueKind::NamedTables(&TEMPERATURE)],
            Optional,
            "",
            "Rises of temperature, by name.",
        ),
        key(
            "initial_strain",
            &[ValueKind::NamedTables(&INITIAL_STRAIN)],
            Optional,
            "",
            "Initial strains, by name.",
        ),
        key(
            "load",
            &[ValueKind::NamedTables(&LOAD)],
            Optional,
            "",
            "Internal forces, imposed states and distributed loads for which stresses are \
             recovered, by name.",
        ),
        END_EFFECTS,
        key(
            "prestress",
            &[ValueKind::Word(&StrainMeasure::NAMES)],
            Optional,
            "\"biot\"",
            "Requests the change of the stiffness with the internal forces, by a strain to second \
             order: biot is the usual one, green is 1/2 (F'F - 1).",
        ),
    ],
    families: &[],
};

const REGION: TableSchema = TableSchema {
    title: "[[region]]",
    meaning: "A physical surface of the mesh and its material.",
    keys: &[
        key(
            "group",
            GROUP,
            Required,
            "\"skin\"",
            "The physical surface, by its name or its tag.",
        ),
        key(
            "material",
            GROUP,
            Required,
            "\"glass\"",
            "The material, by its name.",
        ),
        key(
            "fiber_angle",
            &[
                ValueKind::Quantity(Dimension::ANGLE),
                ValueKind::Table(&FIBER_ANGLE),
            ],
            Default("0"),
            "45",
            "Angle of the fiber from x toward the wall direction, in the wall.",
        ),
        key(
            "plane_angle",
            &[
                ValueKind::Quantity(Dimension::ANGLE),
                ValueKind::Table(&PLANE_ANGLE),
            ],
            Default("0"),
            "\"90 deg\"",
            "Angle of the wall direction from +y.",
        ),
    ],
    families: &[],
};

const ANGLES: KeySchema = key(
    "table",
    TEXT,
    Required,
    "\"angles.csv\"",
    "CSV file with the header cell,angle and a row for each cell of the region, \
     by its tag in the mesh; angles in the declared unit.",
);

const FIBER_ANGLE: TableSchema = TableSchema {
    title: "fiber_angle = { ... }",
    meaning: "The fiber angle cell by cell.",
    keys: &[ANGLES],
    families: &[],
};

const PLANE_ANGLE: TableSchema = TableSchema {
    title: "plane_angle = { ... }",
    meaning: "The plane angle cell by cell, or along a curve.",
    keys: &[],
    families: &[
        Family {
            name: "table",
            meaning: "Cell by cell.",
            keys: &[ANGLES],
        },
        Family {
            name: "follow",
            meaning: "The direction of a curve of the mesh, at its point nearest to the \
                      centroid of each cell.",
            keys: &[
                key(
                    "follow",
                    GROUP,
                    Required,
                    "\"outer\"",
                    "The physical curve, by its name or its tag.",
                ),
                key(
                    "reverse",
                    &[ValueKind::Boolean],
                    Default("false"),
                    "true",
                    "Whether to take the opposite direction.",
                ),
            ],
        },
    ],
};

const INITIAL_CURVATURE: TableSchema = TableSchema {
    title: "[initial_curvature]",
    meaning: "Twist and curvature of the undeformed beam at this section, constant along it, in \
              the axes of the section: all matrices are then for this beam, per length of its \
              reference line, which goes through the origin of the mesh.",
    keys: &[
        key(
            "curvature",
            &[ValueKind::Vector(3, Dimension::CURVATURE)],
            Required,
            "[\"5 deg/m\", 0, 0]",
            "Twist about x and curvature about y and z, k1, k2, k3: rotation of the section per \
             length of the reference line. Twist is positive from y toward z; k2 > 0 bends the \
             beam toward -z, k3 > 0 toward +y.",
        ),
        key(
            "slope",
            &[ValueKind::Vector(3, Dimension::NUMBER)],
            Default("[1, 0, 0]"),
            "[0.99, 0.1, 0]",
            "Direction of the reference line, of any length, the first number greater than zero; \
             [1, 0, 0] if the line is normal to the section.",
        ),
    ],
    families: &[],
};
