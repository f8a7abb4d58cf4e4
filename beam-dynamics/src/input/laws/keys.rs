//! The keys of laws, by their kinds, for each kind of components.

use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{
    Drive, FreeMatrix, Lines, NotNegative, Table, Text, Texts, Word,
};
use shared_geom::document::schema::{Family, KeySchema, Need, TableSchema, key};
use shared_geom::units::Dimension;
use shared_geom::{choice, keys};

/// The key that distinguishes the families, and its meaning.
pub(super) const KIND: [&str; 2] = ["kind", "Kind of the law."];

/// A law for some components: its title and their meaning, its keys of points and of
/// expressions, and kinds that only it has.
macro_rules! law {
    ($TABLE:ident, $title:literal, $meaning:literal, $points:expr, $force:expr $(, $more:expr)?) => {
        #[doc = $meaning]
        pub(in crate::input) const $TABLE: TableSchema = TableSchema {
            title: $title,
            meaning: $meaning,
            keys: &[
                PRESTRESS.schema,
                PRESTRESS_DRIVE.schema,
                PRESTRAIN.schema,
                PRESTRAIN_DRIVE.schema,
            ],
            families: &[
                LINEAR,
                VISCOUS,
                VISCOELASTIC,
                CUBIC_TERM,
                BILINEAR,
                Family {
                    name: "table",
                    meaning: "A force for each strain.",
                    keys: &[choice!(KIND, "table"), $points, INTERPOLATION.schema, OUTSIDE.schema],
                },
                Family {
                    name: "expression",
                    meaning: "Expressions of the strains, their rates `..._rate`, the time `t` \
                              and parameters.",
                    keys: &[choice!(KIND, "expression"), $force],
                },
                $($more)?
            ],
        };
    };
}

law!(
    ROD,
    "law of [[rod]]",
    "Law of a rod, whose component is called `e`: a term, or a list of terms that are added.",
    POINTS.schema,
    FORCE.schema
);
law!(
    DISPLACEMENT,
    "law of [[spring]]",
    "Law of a displacement or of a rotation, with the components `x`, `y`, `z`: a term, or a \
     list of terms that are added.",
    points(&[Table(&POINTS_OF_THREE)]),
    forces(&[Table(&FORCES_OF_THREE)])
);
law!(
    BOTH,
    "coupled_law of [[spring]]",
    "Law of displacement and rotation together, with the components `x`, `y`, `z`, `turn_x`, \
     `turn_y`, `turn_z`: a term, or a list of terms that are added.",
    points(&[Table(&POINTS_OF_BOTH)]),
    forces(&[Table(&FORCES_OF_BOTH)])
);
law!(
    SECTION,
    "law of [properties.NAME] and [[beam]]",
    "Law of a section, with the components `axial`, `shear_y`, `shear_z`, `torsion`, \
     `bending_y`, `bending_z`: a term, or a list of terms that are added.",
    points(&[Table(&POINTS_OF_SECTION)]),
    forces(&[Table(&FORCES_OF_SECTION)]),
    Family {
        name: "section",
        meaning: "The stiffness of the properties.",
        keys: &[choice!(KIND, "section")],
    }
);

const LINEAR: Family = Family {
    name: "linear",
    meaning: "A stiffness.",
    keys: &[choice!(KIND, "linear"), STIFFNESS.schema],
};
const VISCOUS: Family = Family {
    name: "viscous",
    meaning: "A viscosity.",
    keys: &[choice!(KIND, "viscous"), VISCOSITY.schema],
};
const VISCOELASTIC: Family = Family {
    name: "viscoelastic",
    meaning: "A stiffness, and either a viscosity or a time.",
    keys: &[
        choice!(KIND, "viscoelastic"),
        STIFFNESS.schema,
        VISCOSITY_OR_TIME.schema,
        TIME.schema,
    ],
};
const CUBIC_TERM: Family = Family {
    name: "cubic",
    meaning: "A cubic of each strain, with at least one coefficient; negative ones soften.",
    keys: &[
        choice!(KIND, "cubic"),
        COEFFICIENT.schema,
        QUADRATIC.schema,
        CUBIC.schema,
    ],
};
const BILINEAR: Family = Family {
    name: "bilinear",
    meaning: "Two stiffnesses of each strain.",
    keys: &[
        choice!(KIND, "bilinear"),
        FIRST_STIFFNESS.schema,
        SECOND_STIFFNESS.schema,
        LIMIT.schema,
    ],
};

keys! {
    /// Constant force added to the law.
    pub(super) PRESTRESS: ByHand = "prestress", [FreeMatrix], or "zero", "100";
    /// Factor of the prestress.
    pub(super) PRESTRESS_DRIVE: ByHand = "prestress_drive", [Drive(Dimension::NUMBER)], or "1",
        "\"= 1 - exp(-t)\"";
    /// Strain without force.
    pub(super) PRESTRAIN: ByHand = "prestrain", [FreeMatrix], or "zero", "0.001";
    /// Factor of the prestrain.
    pub(super) PRESTRAIN_DRIVE: ByHand = "prestrain_drive", [Drive(Dimension::NUMBER)], or "1",
        "\"= 1 - exp(-t)\"";
    /// Symmetric stiffness without negative eigenvalue: one number for all components, a list, or
    /// rows.
    pub(super) STIFFNESS: ByHand = "stiffness", [FreeMatrix], required, "4e6";
    /// Symmetric viscosity without negative eigenvalue, in the same form.
    pub(super) VISCOSITY: ByHand = "viscosity", [FreeMatrix], required, "300";
    /// Viscosity, in the same form; either this or `time`.
    VISCOSITY_OR_TIME: ByHand = "viscosity", [FreeMatrix], optional, "300";
    /// Ratio of viscosity to stiffness.
    pub(super) TIME: Option<f64> = "time", [NotNegative(Dimension::TIME)], optional, "1e-3";
    /// Coefficients of the strains.
    pub(super) COEFFICIENT: ByHand = "stiffness", [FreeMatrix], or "0", "4e6";
    /// Coefficients of the strains times their absolute values.
    pub(super) QUADRATIC: ByHand = "quadratic", [FreeMatrix], or "0", "-1e5";
    /// Coefficients of the third powers of the strains.
    pub(super) CUBIC: ByHand = "cubic", [FreeMatrix], or "0", "1e7";
    /// Stiffness up to the limit.
    pub(super) FIRST_STIFFNESS: ByHand = "stiffness", [FreeMatrix], required, "4e6";
    /// Stiffness beyond the limit.
    pub(super) SECOND_STIFFNESS: ByHand = "second_stiffness", [FreeMatrix], required, "1e6";
    /// Strain at which the stiffness changes, greater than zero.
    pub(super) LIMIT: ByHand = "limit", [FreeMatrix], required, "0.01";
    /// Rows of a strain and a force by increasing strain, or two columns of a CSV file.
    POINTS: ByHand = "points", [Lines(2), Table(&POINTS_FILE)], required, "[[0, 0], [0.1, 50]]";
    /// Expression of `e`, `e_rate`, `t` and parameters.
    FORCE: ByHand = "force", [Text], required, "\"= 2e4*e + 30*e_rate\"";
    /// Interpolation between the points.
    pub(super) INTERPOLATION: usize = "interpolation", [Word(&["linear", "spline"])],
        or "\"linear\"" = 0, "\"spline\"";
    /// Beyond the points: their last slope, the last force, or no solution, at which a run fails.
    pub(super) OUTSIDE: usize = "outside", [Word(&["extend", "hold", "error"])],
        or "\"extend\"" = 0, "\"hold\"";
}

keys! {
    /// Two columns of a CSV file with a heading.
    POINTS_FILE = "points = { ... }";
    /// The CSV file.
    pub(super) FILE: String = "file", [Text] as "the name of a CSV file", required, "\"curve.csv\"";
    /// Columns of the strains and of the forces.
    pub(super) COLUMNS: Option<Vec<String>> = "columns", [Texts], or "the first two", "[\"strain\", \"force\"]";
}

/// The points of several components.
const fn points(kinds: &'static [shared_geom::document::schema::ValueKind]) -> KeySchema {
    let meaning = "The points of each component that has a force.";
    key("points", kinds, Need::Required, "", meaning)
}

/// The expressions of several components.
const fn forces(kinds: &'static [shared_geom::document::schema::ValueKind]) -> KeySchema {
    let meaning = "The expression of each component that has a force.";
    key("force", kinds, Need::Required, "", meaning)
}

/// The points or the expression of one component.
macro_rules! components {
    ($POINTS:ident, $FORCES:ident, $of:literal, $rate:literal, [$($name:literal),+]) => {
        const $POINTS: TableSchema = TableSchema {
            title: concat!("points = { ... } of a ", $of),
            meaning: "Rows of a strain and a force by increasing strain, or two columns of a \
                      CSV file, at least for one component.",
            keys: &[$(key(
                $name,
                &[Lines(2), Table(&POINTS_FILE)],
                Need::Default("no force"),
                "[[0, 0], [0.1, 50]]",
                concat!("Points of the component `", $name, "`."),
            )),+],
            families: &[],
        };
        const $FORCES: TableSchema = TableSchema {
            title: concat!("force = { ... } of a ", $of),
            meaning: "Expressions of the components, their rates, `t` and parameters, at least \
                      one.",
            keys: &[$(key(
                $name,
                &[Text],
                Need::Default("no force"),
                concat!("\"= 2e4*", $rate, " + 30*", $rate, "_rate\""),
                concat!("Force of the component `", $name, "`."),
            )),+],
            families: &[],
        };
    };
}

components!(
    POINTS_OF_THREE,
    FORCES_OF_THREE,
    "spring",
    "x",
    ["x", "y", "z"]
);
components!(
    POINTS_OF_BOTH,
    FORCES_OF_BOTH,
    "coupled spring",
    "turn_x",
    ["x", "y", "z", "turn_x", "turn_y", "turn_z"]
);
components!(
    POINTS_OF_SECTION,
    FORCES_OF_SECTION,
    "section",
    "torsion",
    [
        "axial",
        "shear_y",
        "shear_z",
        "torsion",
        "bending_y",
        "bending_z"
    ]
);
