//! The keys of layup files.

use shared_geom::document::schema::ValueKind::{
    Boolean, FreeMatrix, Lines, NamedTables, NotNegative, Numbers, Positive, Quantities, Quantity,
    Table as OneTable, Tables, Text, Word,
};
use shared_geom::document::schema::{Family, TableSchema, UNITS, ValueKind};
use shared_geom::document::{ByHand, Nested, NestedByName, NestedList};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::super::blade::Name;
use super::super::materials::MATERIALS;
use super::TOWARDS;
use super::angle::Angle;
use super::course::{COURSE, Course};
use super::fills::FillBound;
use super::line::LINE_OF_LAYUP;
use super::place::{AT_EDGE, BOTH, BothSides, PLACE, Place};
use super::taper::{Profile, Taper};

/// An empty list of tables.
const NONE: ValueKind = ValueKind::Rows(0, 0);

keys! {
    /// The layup of a blade, or of one section: its shape, layers, webs and materials.
    pub(in crate::input) LAYUP_FILE = "NAME.layup.toml";
    /// Units of plain numbers, SI or the units of the table; the unit of length is also the unit of
    /// the mesh.
    UNITS_KEY: ByHand = "units", [Word(&["SI"]), OneTable(&UNITS)], required, "\"SI\"";
    /// Name of the blade; the name of the file without it.
    pub(super) BLADE_NAME: Option<String> = "name", [Text], optional, "\"demo61\"";
    /// The outer contour.
    pub(super) SHAPE: Nested = "shape", [OneTable(&SHAPE_TABLE)] as "a table [shape]", required, "";
    /// The layers of the shell, from the outside in.
    pub(super) LAYERS: NestedList = "layer", [Tables(&LAYER)] as "one [[layer]] or more", required,
        "";
    /// Places on the contour by name, for `from`, `to` and webs.
    pub(super) PLACES: NestedByName = "place", [NamedTables(&PLACE)], optional, "";
    /// The webs.
    pub(super) WEBS: NestedList = "web", [Tables(&WEB), NONE], optional, "";
    /// Materials that fill the spaces between shell and webs.
    pub(super) FILLS: NestedList = "fill", [Tables(&FILL), NONE], optional, "";
    /// Adhesive between both sides at the trailing edge.
    pub(super) EDGE: Nested = "trailing_edge", [OneTable(&EDGE_TABLE)], optional, "";
    /// The reference line of the blade, on which the origins of the sections are; its length is the
    /// length of the blade.
    pub(super) LINE: Nested = "line", [OneTable(&LINE_OF_LAYUP)], optional, "";
    /// Positions along the span of the sections that `blade` solves, as parts of the length of the
    /// line; it chooses them without this key.
    pub(super) STATIONS: ByHand = "stations", [Quantities(Dimension::NUMBER)], optional,
        "[0, 0.25, 1]";
    /// Sizes of the cells.
    pub(super) MESH: Nested = "mesh", [OneTable(&MESH_TABLE)], optional, "";
    with MATERIALS.schema;
}

const SHAPE_TABLE: TableSchema = TableSchema {
    title: "[shape]",
    meaning: "The outer contour of the sections.",
    keys: &[CHORD.schema, ORIGIN.schema, OFFSET.schema],
    families: &[
        Family {
            name: "naca",
            meaning: "An airfoil of four digits.",
            keys: &[NACA.schema],
        },
        Family {
            name: "file",
            meaning: "Coordinates.",
            keys: &[FILE.schema],
        },
        Family {
            name: "points",
            meaning: "Coordinates in this file.",
            keys: &[POINTS.schema],
        },
        Family {
            name: "airfoils",
            meaning: "Airfoils along the span; between two of them each side is interpolated at \
                      equal parts of its length, linearly along the span, or by monotone cubics \
                      over their relative thicknesses if `thickness` is given.",
            keys: &[AIRFOILS.schema, RELATIVE_THICKNESS.schema],
        },
    ],
};

const AIRFOIL: TableSchema = TableSchema {
    title: "[[shape.airfoils]]",
    meaning: "An airfoil at a position along the span, or at a relative thickness.",
    keys: &[AT_ETA.schema, AT_THICKNESS.schema],
    families: &[
        Family {
            name: "naca",
            meaning: "An airfoil of four digits.",
            keys: &[NACA.schema],
        },
        Family {
            name: "file",
            meaning: "Coordinates.",
            keys: &[FILE.schema],
        },
        Family {
            name: "points",
            meaning: "Coordinates in this file.",
            keys: &[POINTS.schema],
        },
        Family {
            name: "circle",
            meaning: "A circle with the chord as diameter.",
            keys: &[CIRCLE.schema],
        },
    ],
};

keys! {
    /// Length of the chord.
    pub(super) CHORD: Course = "chord", [Positive(Dimension::LENGTH), OneTable(&COURSE)], required,
        "5.7";
    /// Position of the origin of the section on the chord, 0 at the nose to 1 at the trailing edge;
    /// -1 to 2.
    pub(super) ORIGIN: Course = "origin", [Quantity(Dimension::NUMBER), OneTable(&COURSE)],
        or "0.25" = Course::constant(0.25), "0.4";
    /// Distance of the chord line from the origin, toward the suction side.
    pub(super) OFFSET: Course = "offset", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "\"20 mm\"";
    /// Thickness over chord along the span, for airfoils by their `thickness`.
    pub(super) RELATIVE_THICKNESS: Option<Course> = "thickness",
        [Positive(Dimension::NUMBER), OneTable(&COURSE)], optional,
        "{ eta = [0, 0.2, 1], value = [1, 0.4, 0.21] }";
    /// The four digits.
    pub(super) NACA: String = "naca", [Text], required, "\"4415\"";
    /// File of x/c and z/c, from the folder of this file, suction side first.
    pub(super) FILE: String = "file", [Text], required, "\"airfoil.dat\"";
    /// Rows of x/c and z/c, from the trailing edge over the suction side to the nose and back; a
    /// point given twice is a corner.
    pub(super) POINTS: ByHand = "points", [FreeMatrix], required, "[[1, 0], [0.3, 0.06]]";
    /// Airfoils along the span, in its order, or of ascending thickness.
    pub(super) AIRFOILS: NestedList = "airfoils", [Tables(&AIRFOIL)], required, "";
    /// Position along the span, 0 at the root to 1 at the tip.
    pub(super) AT_ETA: Option<f64> = "eta", [Quantity(Dimension::NUMBER)], optional, "0.25";
    /// Thickness over chord, in the place of `eta` if [shape] has a `thickness`.
    pub(super) AT_THICKNESS: Option<f64> = "thickness", [Quantity(Dimension::NUMBER)], optional,
        "0.36";
    /// True for a circle.
    pub(super) CIRCLE: bool = "circle", [Boolean], required, "true";
}

const LAYER: TableSchema = TableSchema {
    title: "[[layer]]",
    meaning: "A layer of the shell.",
    keys: &[
        NAME.schema,
        MATERIAL.schema,
        FROM.schema,
        TO.schema,
        WIDTH.schema,
        TAPER.schema,
        PROFILE.schema,
        WEB_OF_LAYER.schema,
        AROUND.schema,
    ],
    families: &[
        Family {
            name: "thickness",
            meaning: "By its thickness.",
            keys: &[THICKNESS.schema, FIBER_ANGLE.schema, TOWARD.schema],
        },
        Family {
            name: "count",
            meaning: "By its number of plies of the `ply_thickness` of the material.",
            keys: &[
                COUNT.schema,
                ROUND.schema,
                FIBER_ANGLE.schema,
                TOWARD.schema,
            ],
        },
        Family {
            name: "plies",
            meaning: "By the angles of its plies of the `ply_thickness` of the material.",
            keys: &[ANGLES.schema, TOWARD.schema],
        },
    ],
};

keys! {
    /// Its name, and the physical surface of its cells.
    pub(super) NAME: Name = "name", [Text] as "a name", required, "\"cap_suction\"";
    /// Its material.
    pub(super) MATERIAL: String = "material", [Text], required, "\"carbon\"";
    /// Its thickness; below 1e-6 m it is absent.
    pub(super) THICKNESS: Course = "thickness", [NotNegative(Dimension::LENGTH), OneTable(&COURSE)],
        required, "\"3 mm\"";
    /// Its number of plies.
    pub(super) COUNT: Course = "count", [NotNegative(Dimension::NUMBER), OneTable(&COURSE)],
        required, "{ eta = [0, 0.3, 1], value = [40, 4, 2] }";
    /// Whether `count` is rounded to whole plies, so that the thickness jumps along the span.
    pub(super) ROUND: bool = "round", [Boolean], or "true" = true, "false";
    /// The angles of the fibers of its plies, from the outside in; they are the layers NAME/1, NAME/2
    /// and so on.
    pub(super) ANGLES: ByHand = "plies", [Quantities(Dimension::ANGLE)], required, "[45, -45]";
    /// Angle of the fiber from x, toward the leading edge on both sides; in webs toward the suction
    /// side.
    pub(super) FIBER_ANGLE: Course = "fiber_angle", [Quantity(Dimension::ANGLE), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "45";
    /// Direction toward which the angle of the fiber is positive: the leading edge, on both sides,
    /// or the contour from the trailing edge over the suction side.
    pub(super) TOWARD: usize = "toward", [Word(&TOWARDS)], or "\"leading_edge\"" = 0,
        "\"contour\"";
    /// Where it starts.
    pub(super) FROM: Place = "from", [Quantity(Dimension::NUMBER), Text, OneTable(&PLACE), OneTable(&COURSE)],
        or "0" = Place::arc(0.0), "0.31";
    /// Where it ends.
    pub(super) TO: Place = "to", [Quantity(Dimension::NUMBER), Text, OneTable(&PLACE), OneTable(&COURSE)],
        or "1" = Place::arc(1.0), "\"cap_suction.start\"";
    /// Its width along the contour, in the place of `to`, or of `from`.
    pub(super) WIDTH: Option<Course> = "width", [Positive(Dimension::LENGTH), OneTable(&COURSE)], optional,
        "\"0.8 m\"";
    /// Rows of a part of its width, ascending from 0 to 1, and a part of its thickness, with straight
    /// lines between them.
    pub(super) PROFILE: Option<Profile> = "profile", [Lines(2)], optional,
        "[[0, 0], [0.2, 1], [1, 1]]";
    /// The web without plies of its own along which it continues, with mitres at both ends: a spar
    /// around the nose. `from` and `to` are then the places of the web, if not given.
    pub(super) WEB_OF_LAYER: Option<String> = "web", [Text], optional, "\"rear\"";
    /// The side of its `web` on which the layer is, which a reader of the file sees.
    pub(super) AROUND: Option<usize> = "around", [Word(&["nose"])], optional, "\"nose\"";
    /// Length over which its thickness drops to zero at its ends, or its thickness over this
    /// length; about the thickness without it.
    pub(super) TAPER: Option<Taper> = "taper", [Positive(Dimension::LENGTH), Text], optional,
        "\"1:20\"";
}

const WEB: TableSchema = TableSchema {
    title: "[[web]]",
    meaning: "A web between both sides.",
    keys: &[WEB_NAME.schema, RANGE.schema, PLIES.schema, FOOT.schema],
    families: &[
        Family {
            name: "places",
            meaning: "By its places on both sides.",
            keys: &[SUCTION.schema, PRESSURE.schema],
        },
        Family {
            name: "plane",
            meaning: "By its plane.",
            keys: &[PLANE_OF_WEB.schema],
        },
    ],
};

keys! {
    /// Its name.
    pub(super) WEB_NAME: Name = "name", [Text] as "a name", required, "\"front_web\"";
    /// Its place on the suction side.
    pub(super) SUCTION: Place = "suction", [Quantity(Dimension::NUMBER), Text, OneTable(&PLACE), OneTable(&COURSE)],
        required, "0.31";
    /// Its place on the pressure side.
    pub(super) PRESSURE: Place = "pressure", [Quantity(Dimension::NUMBER), Text, OneTable(&PLACE), OneTable(&COURSE)],
        required, "0.68";
    /// Its plane, or the trailing edge: the web lies behind the flat base there, and the layers of
    /// both sides end on it.
    pub(super) PLANE_OF_WEB: BothSides = "at", [OneTable(&BOTH), Word(&[AT_EDGE])], required,
        "{ x = 0.3 }";
    /// First and last position along the span.
    pub(super) RANGE: ByHand = "eta", [Numbers(2)], or "[0, 1]", "[0.08, 0.95]";
    /// Its plies, from the leading edge aft; each is a layer without places. None for the web of a spar.
    pub(super) PLIES: NestedList = "plies", [Tables(&PLY), NONE] as "a list of plies", required, "";
    /// Flanges and bond lines on both sides: layers inside of all others.
    pub(super) FOOT: Nested = "foot", [OneTable(&FOOT_TABLE)], optional, "";
}

keys! {
    /// A material that fills the spaces between the inner faces of shell and webs, of those in its
    /// bounds the ones that the fills before it leave.
    FILL = "[[fill]]";
    /// The web, or the plane, behind it; without it it goes to the trailing edge.
    pub(super) AHEAD_OF: Option<FillBound> = "ahead_of", [Text, OneTable(&BOTH)], optional,
        "{ x = 0.03 }";
    /// The web, or the plane, ahead of it; without it it goes to the nose.
    pub(super) AFT_OF: Option<FillBound> = "aft_of", [Text, OneTable(&BOTH)], optional, "\"rear\"";
    /// Angle of the fiber from x toward the second axis of the material.
    pub(super) FILL_FIBER_ANGLE: Angle = "fiber_angle", [Quantity(Dimension::ANGLE)],
        or "0" = Angle(0.0), "45";
    /// Angle of the second axis of the material from y, which points to the leading edge, toward z.
    pub(super) PLANE_ANGLE: Angle = "plane_angle", [Quantity(Dimension::ANGLE)],
        or "0" = Angle(0.0), "90";
    with NAME.schema, MATERIAL.schema, RANGE.schema;
}

/// A ply of a web.
const PLY: TableSchema = TableSchema {
    title: "plies",
    meaning: "A ply of a web.",
    keys: &[NAME.schema, MATERIAL.schema, FIBER_ANGLE.schema],
    families: &[
        Family {
            name: "thickness",
            meaning: "By its thickness.",
            keys: &[THICKNESS.schema],
        },
        Family {
            name: "count",
            meaning: "By its number of plies of the `ply_thickness` of the material.",
            keys: &[COUNT.schema, ROUND.schema],
        },
    ],
};

keys! {
    /// Sizes of the cells.
    MESH_TABLE = "[mesh]";
    /// Largest length of the cells along the contour; 1/120 of its length without it.
    pub(super) SIZE: Option<f64> = "size", [Positive(Dimension::LENGTH)], optional, "\"80 mm\"";
}

keys! {
    /// The trailing edge, which the layers of the shell close, or an adhesive.
    EDGE_TABLE = "[trailing_edge]";
    /// Whether layers alone close it, or the adhesive `bond` too.
    pub(super) CLOSE: usize = "close", [Word(&["auto", "bond"])], or "\"auto\"" = 0, "\"auto\"";
    /// The adhesive.
    pub(super) EDGE_BOND: Nested = "bond", [OneTable(&EDGE_BOND_TABLE)], optional, "";
}

keys! {
    /// An adhesive from the trailing edge to a line between both sides: the first fill, by the name
    /// `trailing_edge_bond`; absent where the layers leave no space for it.
    EDGE_BOND_TABLE = "bond";
    /// The line at which it ends.
    pub(super) TO_LINE: BothSides = "to", [OneTable(&BOTH)], required, "{ distance = \"0.1 m\" }";
    with MATERIAL.schema, RANGE.schema;
}

/// Sides of a web to which its foot extends.
pub(super) const WAYS: [&str; 3] = ["fore", "aft", "both"];

keys! {
    /// Flanges and bond lines on both sides of a web.
    FOOT_TABLE = "foot";
    /// Length along the contour beyond the faces of the web.
    pub(super) REACH: Course = "width", [NotNegative(Dimension::LENGTH), OneTable(&COURSE)], required,
        "\"80 mm\"";
    /// The sides of the web to which the foot extends.
    pub(super) WAY: usize = "side", [Word(&WAYS)], or "\"both\"" = 2, "\"aft\"";
    /// The plies that turn into flanges: the outermost ply of the web on each of these sides, the layer
    /// `WEB_flange_SIDE`.
    pub(super) TURNED: Option<usize> = "plies", [Word(&["outer"])], optional, "\"outer\"";
    /// The bond line below, the layer `WEB_bond_SIDE`.
    pub(super) FOOT_BOND: Nested = "bond", [OneTable(&FOOT_BOND_TABLE)], optional, "";
}

keys! {
    /// A bond line.
    FOOT_BOND_TABLE = "bond";
    /// Its thickness.
    pub(super) BOND_THICKNESS: Course = "thickness", [Positive(Dimension::LENGTH), OneTable(&COURSE)],
        required, "\"5 mm\"";
    with MATERIAL.schema;
}
