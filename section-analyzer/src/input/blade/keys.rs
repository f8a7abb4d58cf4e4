//! The keys of the section of a blade to be meshed.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::schema::ValueKind::{
    Boolean, Count, Positive, Quantity, Table as OneTable, Tables, Text, Word, Words,
};
use shared_geom::document::schema::{Family, TableSchema, UNITS};
use shared_geom::document::{ByHand, Declared, Nested, NestedList, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::super::regions::Angle;
use crate::mesh::generate::blade::Sizes;

/// Largest number of cells through a ply.
const MOST_CELLS: usize = 50;
/// Largest turn of the surface along one cell \[deg\].
const TURNS: [f64; 2] = [0.5, 45.0];
/// Kinds of cells, in the order of their meaning in the reader.
const CELL_KINDS: [&str; 3] = ["quad9", "quad8", "quad4"];
/// Positions of a ply of the spar.
const POSITIONS: [&str; 5] = ["upper", "lower", "web", "front_web", "rear_web"];

keys! {
    /// The section of a blade to be meshed: a skin around an airfoil, a spar and cores.
    pub(in crate::input) BLADE_FILE = "NAME.blade.toml";
    /// Units of plain numbers, SI or the units of the table; the unit of length is also the unit of
    /// the mesh.
    UNITS_KEY: ByHand = "units", [Word(&["SI"]), OneTable(&UNITS)], required, "\"SI\"";
    /// The outer contour.
    pub(super) AIRFOIL: Nested = "airfoil", [OneTable(&AIRFOIL_TABLE)]
        as "a table [airfoil]", required, "";
    /// Plies all around; without them cores fill the section up to the contour.
    pub(super) SKIN: Nested = "skin", [OneTable(&SKIN_TABLE)], optional, "";
    /// Plies inside of the skin, which turn into the webs.
    pub(super) SPAR: Nested = "spar", [OneTable(&SPAR_TABLE)], optional, "";
    /// Fill of the spaces inside.
    pub(super) CORE: Nested = "core", [OneTable(&CORE_TABLE)], optional, "";
    /// Fill of the foremost space, instead of the core there.
    pub(super) NOSE_MASS: Nested = "nose_mass", [OneTable(&NOSE_MASS_TABLE)], optional, "";
    /// Sizes of the cells.
    pub(super) MESH: Nested = "mesh", [OneTable(&MESH_TABLE)]
        as "a table [mesh] with the \"size\" of cells", required, "";
}

const AIRFOIL_TABLE: TableSchema = TableSchema {
    title: "[airfoil]",
    meaning: "The outer contour of the section.",
    keys: &[CHORD.schema, ORIGIN.schema, END.schema],
    families: &[
        Family {
            name: "naca",
            meaning: "An airfoil of four digits.",
            keys: &[NACA.schema, TRAILING_EDGE.schema],
        },
        Family {
            name: "file",
            meaning: "Coordinates.",
            keys: &[FILE.schema],
        },
    ],
};

keys! {
    /// Length of the chord.
    pub(super) CHORD: f64 = "chord", [Positive(Dimension::LENGTH)], required, "300";
    /// Position of the origin of the section on the chord, 0 at the nose to 1 at the trailing
    /// edge.
    pub(super) ORIGIN: ChordPart = "origin", [Quantity(Dimension::NUMBER)], or "0.25" = ChordPart(0.25),
        "0.3";
    /// Part of the chord at which the airfoil is cut off, with a blunt edge.
    pub(super) END: ChordPart = "end", [Quantity(Dimension::NUMBER)], or "1" = ChordPart(1.0), "0.98";
    /// The four digits.
    pub(super) NACA: String = "naca", [Text], required, "\"4415\"";
    /// The trailing edge: blunt, as in the formula of the airfoil, or sharp, by another last
    /// coefficient.
    pub(super) TRAILING_EDGE: usize = "trailing_edge", [Word(&["blunt", "sharp"])],
        or "\"blunt\"" = 0, "\"sharp\"";
    /// File of x/c and z/c, from the folder of this file: from the trailing edge over the upper
    /// surface to the nose and back, or both surfaces from the nose on.
    pub(super) FILE: String = "file", [Text], required, "\"airfoil.dat\"";
}

keys! {
    /// Plies all around the section.
    SKIN_TABLE = "[skin]";
    /// The plies of the skin.
    pub(super) SKIN_PLIES: NestedList = "plies", [Tables(&PLY)] as "a list of plies", required, "";
    /// Whether a wall of the plies closes a blunt trailing edge; at a sharp one the plies of both
    /// surfaces then meet.
    pub(super) CLOSURE: usize = "closure", [Word(&["closed", "open"])], or "\"closed\"" = 0,
        "\"open\"";
    with ORDER.schema;
}

keys! {
    /// A spar: its plies lie on both surfaces, and turn into one web or two.
    SPAR_TABLE = "[spar]";
    /// Part of the chord at the rear face of the web, or of the rear one of two.
    pub(super) REAR_WEB: ChordPart = "rear_web", [Quantity(Dimension::NUMBER)]
        as "the part of the chord at its rear face", required, "0.45";
    /// Part of the chord at the front face of the front web; without it the spar goes around the
    /// nose.
    pub(super) FRONT_WEB: Option<ChordPart> = "front_web", [Quantity(Dimension::NUMBER)], optional,
        "0.12";
    /// The plies of the spar.
    pub(super) SPAR_PLIES: NestedList = "plies", [Tables(&SPAR_PLY)] as "a list of plies", required,
        "";
    with ORDER.schema;
}

keys! {
    /// Order of the plies.
    pub(super) ORDER: usize = "order", [Word(&["outside_in", "inside_out"])],
        or "\"outside_in\"" = 0, "\"inside_out\"";
    /// The physical surface of the cells; several may share one, if they are of the same material
    /// and angle.
    pub(super) NAME: Name = "name", [Text]
        as "the name of a physical surface, and of its material", required, "\"cap\"";
    /// The material in the section file.
    pub(super) MATERIAL: Option<Name> = "material", [Text], or "the name", "\"carbon\"";
    /// Angle of the fiber from x toward the wall direction, which runs clockwise.
    pub(super) FIBER_ANGLE: Angle = "fiber_angle", [Quantity(Dimension::ANGLE)],
        or "0" = Angle(0.0), "45";
    /// Thickness of one ply.
    pub(super) THICKNESS: f64 = "thickness", [Positive(Dimension::LENGTH)], required, "0.5";
    /// Number of such plies on each other, meshed as one layer.
    pub(super) COUNT: usize = "count", [Count(usize::MAX)], or "1" = 1, "3";
    /// Cells through that layer.
    pub(super) CELLS: usize = "cells", [Count(MOST_CELLS)]
        as "a whole number from 1 to 50", or "1" = 1, "2";
    /// Whether its faces become physical curves, NAME/outer and NAME/inner.
    pub(super) FACES: bool = "faces", [Boolean], or "false" = false, "true";
}

const PLY: TableSchema = TableSchema {
    title: "plies = [{ ... }] of the skin",
    meaning: "A ply of the skin, or several of a kind.",
    keys: &[
        NAME.schema,
        MATERIAL.schema,
        FIBER_ANGLE.schema,
        THICKNESS.schema,
        COUNT.schema,
        CELLS.schema,
        FACES.schema,
    ],
    families: &[],
};

keys! {
    /// A ply of the spar, or several of a kind; without a filler it ends with a taper.
    SPAR_PLY = "plies = [{ ... }] of the spar";
    /// Part of the chord at which it begins on the surfaces.
    pub(super) FROM: Option<ChordPart> = "from", [Quantity(Dimension::NUMBER)],
        or "the front end of the spar", "0.2";
    /// Part of the chord at which it ends on the surfaces.
    pub(super) TO: Option<ChordPart> = "to", [Quantity(Dimension::NUMBER)],
        or "the rear end of the spar", "0.35";
    /// Where it lies: on a surface, in a web, in both webs.
    pub(super) ON: Option<Vec<usize>> = "on", [Words(&POSITIONS)], or "everywhere",
        "[\"upper\", \"lower\"]";
    /// A ply of the same thickness that replaces it elsewhere.
    pub(super) FILLER: Nested = "filler", [OneTable(&FILLER_TABLE)], optional, "";
    with NAME.schema, MATERIAL.schema, FIBER_ANGLE.schema, THICKNESS.schema, COUNT.schema,
        CELLS.schema, FACES.schema;
}

/// Keys that restrict a ply of the spar.
pub(super) const LIMITS: [&str; 4] = [FROM.name(), TO.name(), ON.name(), FILLER.name()];

const FILLER_TABLE: TableSchema = TableSchema {
    title: "filler = { ... }",
    meaning: "A ply that replaces another one.",
    keys: &[NAME.schema, MATERIAL.schema, FIBER_ANGLE.schema],
    families: &[],
};

keys! {
    /// Fill of the spaces inside.
    CORE_TABLE = "[core]";
    /// The space ahead of the front web.
    pub(super) NOSE: Nested = "nose", [OneTable(&FILL)], optional, "";
    /// The space in the spar.
    pub(super) IN_SPAR: Nested = "spar", [OneTable(&FILL)], optional, "";
    /// The space behind the rear web; the whole section if there is no spar.
    pub(super) AFT: Nested = "aft", [OneTable(&FILL)], optional, "";
}

const FILL: TableSchema = TableSchema {
    title: "[core.SPACE]",
    meaning: "A core; several may have one name.",
    keys: &[NAME.schema, MATERIAL.schema],
    families: &[],
};

keys! {
    /// The foremost space, filled instead of the core there.
    NOSE_MASS_TABLE = "[nose_mass]";
    /// Part of the chord to which it extends from the nose.
    pub(super) NOSE_TO: ChordPart = "to", [Quantity(Dimension::NUMBER)]
        as "the part of the chord at which it ends", required, "0.03";
    with NAME.schema, MATERIAL.schema;
}

keys! {
    /// Sizes of the cells.
    MESH_TABLE = "[mesh]";
    /// Largest length of the cells along walls.
    pub(super) SIZE: f64 = "size", [Positive(Dimension::LENGTH)], required, "6";
    /// Largest height of the cells of cores.
    pub(super) CORE_SIZE: Option<f64> = "core_size", [Positive(Dimension::LENGTH)], or "the size",
        "8";
    /// Largest turn of the surface along one cell, 0.5 to 45 degrees: it makes the cells at the
    /// nose shorter.
    pub(super) TURN: Turn = "turn", [Quantity(Dimension::ANGLE)], or "\"12 deg\"" = Turn::default(),
        "10";
    /// Kind of the cells; triangles have 6 or 3 nodes with them.
    pub(super) CELL: usize = "cell", [Word(&CELL_KINDS)], or "\"quad9\"" = 0, "\"quad4\"";
}

/// A part of the chord from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ChordPart(pub f64);

impl Declared for ChordPart {}

impl Value for ChordPart {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let part = table.quantity(key.name, Dimension::NUMBER)?;
        if (0.0..=1.0).contains(&part) {
            return Some(Self(part));
        }
        table.wrong(
            key,
            "a part of the chord, 0 at the nose to 1 at the trailing edge",
        );
        None
    }
}

/// A name that is valid in meshes and section files.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input) struct Name(pub String);

impl Declared for Name {}

impl Value for Name {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let text = table.text(key.name)?;
        if text.is_empty() || text != text.trim() || text.contains(char::is_control) {
            let expected = "a name in one line, without blanks around it";
            table.wrong(key, expected);
            return None;
        }
        Some(Self(text))
    }
}

/// The largest turn of the surface along one cell \[rad\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Turn(pub f64);

impl Default for Turn {
    fn default() -> Self {
        Self(Sizes::new(1.0).turn)
    }
}

impl Declared for Turn {}

impl Value for Turn {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let turn = table.quantity(key.name, Dimension::ANGLE)?;
        let [least, most] = TURNS;
        if (least..=most).contains(&turn.to_degrees()) {
            return Some(Self(turn));
        }
        table.wrong(key, &format!("an angle from {least} to {most} degrees"));
        None
    }
}
