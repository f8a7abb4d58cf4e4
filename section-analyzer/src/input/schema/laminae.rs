//! The keys of laminates along curves.

use shared_geom::units::Dimension;

use super::{Family, KeySchema, Need, TableSchema, ValueKind, key};

use Need::{Default, Required};

const TEXT: &[ValueKind] = &[ValueKind::Text];
const GROUP: &[ValueKind] = &[ValueKind::Name];
const LENGTH: &[ValueKind] = &[ValueKind::Quantity(Dimension::LENGTH)];
const ANGLE: &[ValueKind] = &[ValueKind::Quantity(Dimension::ANGLE)];

/// The keys of a ply.
const PLY_KEYS: &[KeySchema] = &[
    key(
        "material",
        GROUP,
        Required,
        "\"glass\"",
        "The material, by its name.",
    ),
    key(
        "thickness",
        LENGTH,
        Required,
        "\"0.2 mm\"",
        "Thickness of the ply.",
    ),
    key(
        "fiber_angle",
        ANGLE,
        Default("0"),
        "45",
        "Angle of the fiber from x toward the direction of the line.",
    ),
];

pub(super) const LAMINA: TableSchema = TableSchema {
    title: "[[lamina]]",
    meaning: "Plies along a physical curve of the mesh: each line becomes cells with the \
              thickness of a ply.",
    keys: &[
        key(
            "curve",
            GROUP,
            Required,
            "\"outer\"",
            "The physical curve, by its name or its tag.",
        ),
        key(
            "name",
            TEXT,
            Default("name of the curve"),
            "\"skin\"",
            "Name in reports and tables; several plies are NAME/1, NAME/2 and so on.",
        ),
        key(
            "side",
            &[ValueKind::Word(&["left", "right", "center"])],
            Default("the side without cells; \"center\" if no cells are adjacent"),
            "\"left\"",
            "Side of the line on which the plies lie, seen along it.",
        ),
    ],
    families: &[
        Family {
            name: "plies",
            meaning: "A list of plies.",
            keys: &[key(
                "plies",
                &[ValueKind::Tables(&PLY)],
                Required,
                "",
                "The plies from the line outward; with side = \"center\" from right to left.",
            )],
        },
        Family {
            name: "one ply",
            meaning: "A single ply.",
            keys: PLY_KEYS,
        },
    ],
};

const PLY: TableSchema = TableSchema {
    title: "plies = [{ ... }]",
    meaning: "A ply of a laminate.",
    keys: PLY_KEYS,
    families: &[],
};
