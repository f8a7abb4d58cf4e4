//! The keys of the blade file that people write.

use nalgebra::Vector3;

use super::values::{ArcCurvature, COMPONENTS, DIRECTIONS, FRAMES};
use crate::document::schema::ValueKind::{
    Columns, FreeMatrix, Positive, Quantities, Quantity, Table as OneTable, Tables, Text, Vector,
    Word, Words,
};
use crate::document::schema::{Description, Family, Numbers, TableSchema, UNITS};
use crate::document::{ByHand, Nested, NestedList};
use crate::keys;
use crate::units::Dimension;

/// Blade files that people write.
///
/// Their schema does not check names and dimensions of units, nor values that depend on other
/// keys; the reader does.
pub const BLADE: Description = Description {
    file: &BLADE_FILE,
    numbers: Numbers::Plain,
    opening: "\
# Blade file reference

Every key of a blade file, `NAME.blade.toml`.
Made by `beam-dynamics schema --of blade --format markdown`; do not edit.
The use of the keys is described in [Blade file](blade-file.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"0.25 in\"`.
",
};

/// The file.
pub(super) const BLADE_FILE: TableSchema = TableSchema {
    title: "NAME.blade.toml",
    meaning: "A blade: a reference line, and the properties of its sections at stations along it.",
    keys: &[
        NAME.schema,
        UNITS_KEY.schema,
        FRAME.schema,
        ORDER.schema,
        TWIST_POSITIVE.schema,
        REFERENCE_POINT.schema,
        INTERPOLATION.schema,
        LINE.schema,
        DAMPING.schema,
    ],
    families: &[
        Family {
            name: "station",
            meaning: "Stations in this file, from the root to the tip.",
            keys: &[STATION.schema],
        },
        Family {
            name: "stations",
            meaning: "Stations in a table of another file.",
            keys: &[STATIONS.schema],
        },
    ],
};

keys! {
    /// Name in messages and tables.
    pub(super) NAME: Option<String> = "name", [Text], or "NAME of the file", "\"demo\"";
    /// Units of plain numbers, SI or the units of the table.
    UNITS_KEY: ByHand = "units", [Word(&["SI"]), OneTable(&UNITS)], required, "\"SI\"";
    /// Axes of the numbers: the axes of a tool, or the directions of x, y and z.
    pub(super) FRAME: ByHand = "frame",
        [Word(&FRAMES), Words(&DIRECTIONS)],
        or "required, unless all stations are property files", "\"helicoid\"";
    /// Order of the six components, by forces along and moments about the axes of the frame.
    pub(super) ORDER: ByHand = "order", [Words(&COMPONENTS)],
        or "Fx, Fy, Fz, Mx, My, Mz for the axes of a tool, else required",
        "[\"Fx\", \"Fy\", \"Fz\", \"Mx\", \"My\", \"Mz\"]";
    /// Sense of positive twist.
    pub(super) TWIST_POSITIVE: Option<usize> = "twist_positive", [Word(&["nose up", "nose down"])],
        or "as the tool; nose up for directions", "\"nose up\"";
    /// Point to which stiffness and mass refer: the line, or two lengths from the line, along the
    /// two axes of the frame in the section.
    pub(super) REFERENCE_POINT: ByHand = "reference_point",
        [Word(&["line"]), Vector(2, Dimension::LENGTH)],
        or "required, unless all stations are property files", "\"line\"";
    /// Each entry between stations: linear in arc length, or constant from each station to the
    /// next.
    pub(super) INTERPOLATION: usize = "interpolation", [Word(&["linear", "constant"])],
        or "\"linear\"" = 0, "\"constant\"";
    /// The reference line.
    pub(super) LINE: Nested = "line", [OneTable(&LINE_TABLE)] as "the reference line", required, "";
    /// Damping of all sections.
    pub(super) DAMPING: Nested = "damping", [OneTable(&DAMPING_TABLE)], optional, "";
    /// The sections.
    pub(super) STATION: NestedList = "station", [Tables(&STATION_TABLE)], required, "";
    /// The sections in a table.
    pub(super) STATIONS: Nested = "stations", [OneTable(&STATIONS_TABLE)], required, "";
}

/// The table `[line]`, which `read_line` reads.
pub const LINE_TABLE: TableSchema = TableSchema {
    title: "[line]",
    meaning: "The reference line, in the root axes of the blade.",
    keys: &[],
    families: &[
        Family {
            name: "straight",
            meaning: "A straight line; twist at its ends, or of the whole.",
            keys: &[LENGTH.schema, TWIST.schema],
        },
        Family {
            name: "points by direction",
            meaning: "Lists of the same length; absent lists are zero.",
            keys: &[
                COURSE.schema,
                SPAN.schema,
                SWEEP.schema,
                PREBEND.schema,
                TWIST.schema,
                OFFSET_FORWARD.schema,
                OFFSET_UP.schema,
            ],
        },
        Family {
            name: "points by axes",
            meaning: "At least one of x, y, z; absent lists are zero.",
            keys: &[
                COURSE.schema,
                X.schema,
                Y.schema,
                Z.schema,
                TWIST.schema,
                OFFSET_FORWARD.schema,
                OFFSET_UP.schema,
            ],
        },
        Family {
            name: "points of a file",
            meaning: "The same lists as columns of a table.",
            keys: &[COURSE.schema, FILE.schema, COLUMNS.schema],
        },
        Family {
            name: "arcs",
            meaning: "A line by its curvature, from the root outward.",
            keys: &[ARC.schema, ROOT_TWIST.schema],
        },
    ],
};

keys! {
    /// Length of a straight line, or of an arc.
    pub(super) LENGTH: f64 = "length", [Positive(Dimension::LENGTH)], required, "10";
    /// Angles of twist, one for each point; of a straight line one, or those at root and tip.
    pub(super) TWIST: Vec<f64> = "twist", [Quantities(Dimension::ANGLE)], or "0" = vec![0.0],
        "[12, 6, 2, 0]";
    /// Twist at the root, where the line runs along x.
    pub(super) ROOT_TWIST: f64 = "twist", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "8";
    /// The line between the points: straight pieces with twist linear in arc length, or natural
    /// cubic splines over the span.
    pub(super) COURSE: usize = "course", [Word(&["polyline", "spline"])]
        as "\"polyline\" or \"spline\": the interpolation between the points of the line", required,
        "\"spline\"";
    /// Outward.
    SPAN: Vec<f64> = "span", [Quantities(Dimension::LENGTH)], required, "[0, 60, 100, 120]";
    /// Toward the trailing edge.
    SWEEP: Option<Vec<f64>> = "sweep", [Quantities(Dimension::LENGTH)], or "0", "[0, 0, 1.5, 6]";
    /// Toward the upper side.
    PREBEND: Option<Vec<f64>> = "prebend", [Quantities(Dimension::LENGTH)], or "0", "[0, 0, 0.4, 1]";
    /// Positions along x of the frame.
    X: Option<Vec<f64>> = "x", [Quantities(Dimension::LENGTH)], or "0", "[0, 60, 100, 120]";
    /// Positions along y of the frame.
    Y: Option<Vec<f64>> = "y", [Quantities(Dimension::LENGTH)], or "0", "[0, 0, -1.5, -6]";
    /// Positions along z of the frame.
    Z: Option<Vec<f64>> = "z", [Quantities(Dimension::LENGTH)], or "0", "[0, 0, 0.4, 1]";
    /// Offset of the line from the points toward the leading edge, in section axes.
    OFFSET_FORWARD: Option<Vec<f64>> = "offset_forward", [Quantities(Dimension::LENGTH)], or "0",
        "[0, 0.1, 0.1, 0.1]";
    /// Offset of the line from the points toward the upper side, in section axes.
    OFFSET_UP: Option<Vec<f64>> = "offset_up", [Quantities(Dimension::LENGTH)], or "0",
        "[0, 0, 0.1, 0.1]";
    /// File of comma-separated columns, from the folder of this file: lines that begin with # are
    /// comments, the first other line names the columns.
    pub(super) FILE: String = "file", [Text] as "the name of a table", required, "\"blade.csv\"";
    /// Columns of other names than their keys, by key.
    pub(super) COLUMNS: ByHand = "columns", [Columns(&COLUMN)], optional,
        "{ span = \"r_in\", twist = { value = 0 } }";
    /// Arcs.
    pub(super) ARC: NestedList = "arc", [Tables(&ARC_TABLE)], required, "";
}

const COLUMN: TableSchema = TableSchema {
    title: "columns = { KEY = { ... } }",
    meaning: "The numbers of a key.",
    keys: &[],
    families: &[
        Family {
            name: "column",
            meaning: "A column with its unit, times a factor.",
            keys: &[COLUMN_NAME.schema, COLUMN_UNIT.schema, FACTOR.schema],
        },
        Family {
            name: "value",
            meaning: "One value for all rows.",
            keys: &[COLUMN_VALUE.schema],
        },
    ],
};

keys! {
    /// Name of the column.
    pub(super) COLUMN_NAME: String = "column", [Text]
        as "the name of a column, or a value for all rows", required, "\"area_in2\"";
    /// Unit of its numbers.
    pub(super) COLUMN_UNIT: Option<String> = "unit", [Text], or "the declared unit", "\"psi*in^2\"";
    /// Factor of its numbers.
    pub(super) FACTOR: f64 = "factor", [Quantity(Dimension::NUMBER)], or "1" = 1.0, "1e7";
    /// The value.
    pub(super) COLUMN_VALUE: ByHand = "value", [Quantity(Dimension::NUMBER)], required, "0";
}

keys! {
    /// An arc of the line.
    ARC_TABLE = "[[line.arc]]";
    /// Curvature about the section axes: one over a radius, or as a text also an angle per length.
    pub(super) CURVATURE: ArcCurvature = "curvature", [Vector(3, Dimension::CURVATURE)],
        or "[0, 0, 0]" = ArcCurvature(Vector3::zeros()), "[0, 0.02, \"5 deg/m\"]";
    /// Twist per length, which adds to the first number of the curvature.
    pub(super) TWIST_RATE: f64 = "twist_rate", [Quantity(Dimension::CURVATURE)], or "0" = 0.0,
        "\"3 deg/m\"";
    with LENGTH.schema;
}

const DAMPING_TABLE: TableSchema = TableSchema {
    title: "[damping]",
    meaning: "Damping by the stiffness of the sections.",
    keys: &[],
    families: &[
        Family {
            name: "proportional",
            meaning: "One time for all components.",
            keys: &[PROPORTIONAL.schema],
        },
        Family {
            name: "times",
            meaning: "A time for each component.",
            keys: &[TIMES.schema],
        },
    ],
};

keys! {
    /// D = time K.
    pub(super) PROPORTIONAL: f64 = "proportional", [Quantity(Dimension::TIME)], required, "0.0005";
    /// D = diag(times) K: six times in the order of the frame.
    pub(super) TIMES: Vec<f64> = "times", [Quantities(Dimension::TIME)], required,
        "[1e-3, 2e-3, 2e-3, 4e-3, 5e-3, 5e-3]";
}

const STATION_TABLE: TableSchema = TableSchema {
    title: "[[station]]",
    meaning: "A section of the blade at arc_length or eta; two at one position are the two sides \
              of a jump.",
    keys: &[
        ARC_LENGTH.schema,
        ETA.schema,
        STATION_POINT.schema,
        ANGLE.schema,
    ],
    families: &[
        Family {
            name: "file",
            meaning: "The properties of a property file, about its own reference point.",
            keys: &[SECTION_FILE.schema],
        },
        Family {
            name: "properties",
            meaning: "Matrices, or engineering properties in the axes of Helicoid, in place of \
                      either or both of them.",
            keys: &[
                STIFFNESS.schema,
                MASS.schema,
                EA.schema,
                GAY.schema,
                GAZ.schema,
                GJ.schema,
                EIY.schema,
                EIZ.schema,
                M.schema,
                IY.schema,
                IZ.schema,
                TENSION_CENTER.schema,
                SHEAR_CENTER.schema,
                MASS_CENTER.schema,
                STIFFNESS_ANGLE.schema,
                INERTIA_ANGLE.schema,
            ],
        },
    ],
};

keys! {
    /// Position along the line, from the root.
    pub(super) ARC_LENGTH: Option<f64> = "arc_length", [Quantity(Dimension::LENGTH)], optional, "2.5";
    /// The same as a part of the length of the line.
    pub(super) ETA: Option<f64> = "eta", [Quantity(Dimension::NUMBER)], optional, "0.8";
    /// Reference point of this station.
    pub(super) STATION_POINT: ByHand = "reference_point", [Vector(2, Dimension::LENGTH)],
        or "of the file", "[0.1, 0]";
    /// Angle from the section axes of the line to the axes of the properties, in the sense of
    /// twist.
    pub(super) ANGLE: f64 = "angle", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "2";
    /// A property file, from the folder of this file.
    pub(super) SECTION_FILE: String = "file", [Text] as "the name of a property file", required,
        "\"tip.properties.json\"";
    /// 6 rows of 6, or the 21 numbers of the upper triangle row by row.
    STIFFNESS: ByHand = "stiffness", [FreeMatrix], or "from ea to eiz", "";
    /// The same for the mass.
    MASS: ByHand = "mass", [FreeMatrix], or "from m, iy, iz", "";
    /// Axial stiffness.
    EA: Option<f64> = "ea", [Quantity(Dimension::FORCE)], optional, "1.6e7";
    /// Shear stiffness along y.
    GAY: Option<f64> = "gay", [Quantity(Dimension::FORCE)], optional, "2e6";
    /// Shear stiffness along z.
    GAZ: Option<f64> = "gaz", [Quantity(Dimension::FORCE)], optional, "1.2e6";
    /// Torsional stiffness.
    GJ: Option<f64> = "gj", [Quantity(Dimension::BENDING_STIFFNESS)], optional, "3e6";
    /// Bending stiffness about the first principal axis.
    EIY: Option<f64> = "eiy", [Quantity(Dimension::BENDING_STIFFNESS)], optional, "2.4e6";
    /// Bending stiffness about the second principal axis.
    EIZ: Option<f64> = "eiz", [Quantity(Dimension::BENDING_STIFFNESS)], optional, "4e7";
    /// Mass per length.
    M: Option<f64> = "m", [Quantity(Dimension::MASS_PER_LENGTH)], optional, "0.62";
    /// Moment of inertia per length about the first principal axis through the mass center.
    IY: Option<f64> = "iy", [Quantity(Dimension::INERTIA_PER_LENGTH)], optional, "0.1";
    /// Moment of inertia per length about the second principal axis through the mass center.
    IZ: Option<f64> = "iz", [Quantity(Dimension::INERTIA_PER_LENGTH)], optional, "1.55";
    /// Tension center: y and z from the reference point.
    TENSION_CENTER: ByHand = "tension_center", [Vector(2, Dimension::LENGTH)], or "[0, 0]",
        "[0.35, 0]";
    /// Shear center.
    SHEAR_CENTER: ByHand = "shear_center", [Vector(2, Dimension::LENGTH)], or "[0, 0]", "[0.2, 0]";
    /// Mass center.
    MASS_CENTER: ByHand = "mass_center", [Vector(2, Dimension::LENGTH)], or "[0, 0]", "[0.1, 0.02]";
    /// Angle from y to the first principal axis of stiffness, nose up.
    STIFFNESS_ANGLE: ByHand = "stiffness_angle", [Quantity(Dimension::ANGLE)], or "0", "1.5";
    /// Angle from y to the first principal axis of inertia, nose up.
    INERTIA_ANGLE: ByHand = "inertia_angle", [Quantity(Dimension::ANGLE)], or "0", "1.5";
}

keys! {
    /// The sections of the blade in a table of a file.
    STATIONS_TABLE = "[stations]";
    /// Arc length in the table that corresponds to the root.
    pub(super) ROOT_AT: f64 = "root_at", [Quantity(Dimension::LENGTH)], or "0" = 0.0, "1.5";
    with FILE.schema, COLUMNS.schema;
}
