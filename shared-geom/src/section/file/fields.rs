//! The fields of a property file, as named in messages.

use crate::error::quoted;

/// A field of a table.
#[derive(Debug)]
pub(super) struct Field {
    pub name: &'static str,
    pub shape: Shape,
    pub is_needed: bool,
}

/// Content of a field.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    /// A number.
    Number,
    /// A whole number.
    Count,
    /// A text.
    Text,
    /// One of some words.
    Word(&'static [&'static str]),
    /// A list of texts.
    Texts,
    /// An array of this number of numbers.
    Row(usize),
    /// A square matrix by rows.
    Square(usize),
    /// Rows of numbers.
    Rows,
    /// Rows of three indices and a number.
    Entries,
    /// A table.
    Table(&'static [Field]),
    /// A table with one of some fields.
    Either(&'static [Field; 2]),
    /// A list of tables with this name.
    Tables(&'static str, &'static [Field]),
}

use Shape::{Count, Either, Entries, Number, Row, Rows, Square, Table, Tables, Text, Texts, Word};

/// Fields of a property file.
pub(super) const FILE: &[Field] = &[
    needed("format", Text),
    needed("version", Count),
    needed("name", Text),
    needed("units", Text),
    optional("convention", Text),
    needed("reference_point", Row(2)),
    needed("stiffness", Square(6)),
    needed("mass", Square(6)),
    optional("centers", Table(CENTERS)),
    optional("principal_axes", Table(AXES)),
    optional("initial_curvature", Table(CURVATURE)),
    optional("piezo", Table(PIEZO)),
    optional("thermal_force", Row(6)),
    optional("imposed", Tables("the imposed state", STATE)),
    optional("damping", Either(DAMPING)),
    optional("prestress", Table(PRESTRESS)),
    optional("provenance", Table(PROVENANCE)),
];
const CENTERS: &[Field] = &[
    needed("tension", Row(2)),
    needed("shear", Row(2)),
    needed("mass", Row(2)),
];
const AXES: &[Field] = &[
    needed("bending_angle", Number),
    needed("bending_stiffness", Row(2)),
    needed("inertia_angle", Number),
    needed("inertia", Row(2)),
];
const CURVATURE: &[Field] = &[needed("curvature", Row(3)), needed("slope", Row(3))];
const PIEZO: &[Field] = &[
    needed("electrodes", Texts),
    needed("coupling", Rows),
    needed("capacitance", Rows),
];
const STATE: &[Field] = &[
    needed("name", Text),
    needed("restrained_force", Row(6)),
    needed("free_strain", Row(6)),
    optional("stiffness_change", Square(4)),
];
const DAMPING: &[Field; 2] = &[
    optional("stiffness_proportional", Number),
    optional("viscous", Square(6)),
];
const PRESTRESS: &[Field] = &[
    needed("strain_measure", Word(&["biot", "green"])),
    needed("third_derivatives", Entries),
    optional("stiffness_per_kelvin", Square(4)),
];
const PROVENANCE: &[Field] = &[
    needed("program", Text),
    needed("version", Text),
    optional("input_hash", Text),
    optional("nodes", Count),
    optional("cells", Count),
    optional("history", Tables("the step", STEP)),
];
const STEP: &[Field] = &[
    optional("shift", Row(2)),
    optional("rotate", Number),
    needed("program", Text),
    needed("version", Text),
];

/// A row of a table of prestress, as text.
pub(super) const ENTRY: &str = "three whole numbers and a number, as in [1, 4, 4, 1462.1]";

const fn needed(name: &'static str, shape: Shape) -> Field {
    Field {
        name,
        shape,
        is_needed: true,
    }
}

const fn optional(name: &'static str, shape: Shape) -> Field {
    Field {
        name,
        shape,
        is_needed: false,
    }
}

/// Expected content of a field, as text.
pub(super) fn expected(shape: Shape) -> String {
    match shape {
        Number => "a number".to_owned(),
        Count => "a whole number".to_owned(),
        Text => "a text".to_owned(),
        Word(known) => format!("\"{}\"", known.join("\" or \"")),
        Texts => "a list of texts".to_owned(),
        Row(n) => format!("{n} numbers"),
        Square(n) => format!("{n} rows of {n} numbers"),
        Rows => "rows of numbers".to_owned(),
        Entries => "a list of rows".to_owned(),
        Table(known) => {
            let names = known.iter().filter(|field| field.is_needed);
            let names: Vec<_> = names.map(|field| field.name).collect();
            format!("a table with {}", quoted(&names))
        }
        Either([one, other]) => {
            format!("a table with either \"{}\" or \"{}\"", one.name, other.name)
        }
        Tables(..) => "a list of tables".to_owned(),
    }
}
