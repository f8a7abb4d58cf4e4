//! The keys of imposed states: temperatures and initial strains.

use shared_geom::units::Dimension;

use super::{Family, KeySchema, Need, TableSchema, ValueKind, key};

use Need::{Default, Optional, Required};

/// Thermal expansion of a material.
pub(super) const EXPANSION: KeySchema = key(
    "expansion",
    &[
        ValueKind::Quantity(Dimension::EXPANSION),
        ValueKind::Vector(3, Dimension::EXPANSION),
    ],
    Optional,
    "[1e-7, 2.8e-5, 2.8e-5]",
    "Strain per rise of temperature, plain numbers per declared unit of it: one for all directions, or along the material axes \
     1, 2, 3; without it the material does not expand.",
);

const RISE: &[ValueKind] = &[ValueKind::Quantity(Dimension::TEMPERATURE)];

/// A temperature.
pub(super) const TEMPERATURE: TableSchema = TableSchema {
    title: "[temperature.NAME]",
    meaning: "A rise of temperature above the state without stress. NAME is made of letters, \
              digits, - and _.",
    keys: &[],
    families: &[
        Family {
            name: "uniform",
            meaning: "Constant in the section.",
            keys: &[key("rise", RISE, Required, "50", "Rise of temperature.")],
        },
        Family {
            name: "gradient",
            meaning: "Linear in the section.",
            keys: &[
                key(
                    "gradient",
                    &[ValueKind::Vector(2, Dimension::TEMPERATURE_GRADIENT)],
                    Required,
                    "[0, \"3 K/mm\"]",
                    "Change of the rise per length along y and along z.",
                ),
                key(
                    "rise",
                    RISE,
                    Default("0"),
                    "20",
                    "Rise at the origin of the mesh.",
                ),
            ],
        },
        Family {
            name: "table",
            meaning: "Cell by cell.",
            keys: &[key(
                "table",
                &[ValueKind::Text],
                Required,
                "\"rises.csv\"",
                "CSV file with the header cell,rise and a row for each cell of the mesh, by its \
                 tag, and for each line with plies; rises in the declared unit.",
            )],
        },
    ],
};

/// An initial strain.
pub(super) const INITIAL_STRAIN: TableSchema = TableSchema {
    title: "[initial_strain.NAME]",
    meaning: "Strain that the material would have without any stress, as from cure or swelling. \
              NAME is made of letters, digits, - and _, and differs from the names of \
              temperatures.",
    keys: &[key(
        "region",
        &[ValueKind::Tables(&REGION)],
        Required,
        "",
        "The strained regions; the others have no initial strain.",
    )],
    families: &[],
};

const REGION: TableSchema = TableSchema {
    title: "[[initial_strain.NAME.region]]",
    meaning: "A region and its initial strain.",
    keys: &[
        key(
            "group",
            &[ValueKind::Name],
            Required,
            "\"skin\"",
            "The region, by its \"group\", or a lamina by its name, for all its plies.",
        ),
        key(
            "strain",
            &[ValueKind::Vector(6, Dimension::NUMBER)],
            Required,
            "[-2e-4, -4e-3, -4e-3, 0, 0, 0]",
            "Strain in material axes, order 11, 22, 33, 23, 13, 12 with engineering shear \
             strains.",
        ),
    ],
    families: &[],
};
