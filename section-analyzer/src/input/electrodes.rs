//! Electrodes as written: `[[electrode]]`.

use shared_geom::document::schema::ValueKind::{
    Count, Names, Positive, Table as OneTable, Tables, Text, Word,
};
use shared_geom::document::schema::{Family, KeySchema, TableSchema};
use shared_geom::document::{
    ByHand, Declared, Document, Item, Key, Nested, NestedList, Table, Value,
};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::regions::Written;
use super::requests::{END_EFFECTS, PRESTRESS};
use crate::section::{Circuit, Electrode};

mod checks;
mod on_mesh;
mod problem;

pub use problem::ElectrodeProblem;

pub(super) use on_mesh::Found;

keys! {
    /// Electrodes on piezoelectric materials and other dielectrics.
    pub(super) ELECTRODES: NestedList = "electrode", [Tables(&ELECTRODE)], optional, "";
    /// Its name in loads and results.
    NAME: Written = "name", [Text] as "a name of its own", required, "\"top\"";
    /// Its connection: a prescribed voltage, the ground (0 V), or none, so that its charge stays
    /// zero.
    CIRCUIT: usize = "circuit", [Word(&CIRCUIT_WORDS)], or "\"driven\"" = 0, "\"driven\"";
    /// The name of a physical curve, or its tag, or several; NAME/outer is the face of a lamina.
    CURVE: WrittenNames = "curve", [Names], required, "\"upper\"";
    /// The name of a physical surface, or its tag, or several, or a lamina by its name, for all
    /// its plies.
    REGION: WrittenNames = "region", [Names], required, "\"shim\"";
    /// The name of a physical point, or its tag, or several.
    POINT: WrittenNames = "point", [Names], required, "\"wire\"";
    /// Regions of the fingers, and their spacing.
    INTERDIGITATED: Nested = "interdigitated", [OneTable(&FINGERS)], required, "";
}

/// An electrode.
const ELECTRODE: TableSchema = TableSchema {
    title: "[[electrode]]",
    meaning: "A part with one voltage: a conductor on curves, in regions or at points of the \
              mesh, or fingers across the beam.",
    keys: &[NAME.schema, CIRCUIT.schema],
    families: &[
        Family {
            name: "curve",
            meaning: "A conductor along curves.",
            keys: &[CURVE.schema],
        },
        Family {
            name: "region",
            meaning: "A conductor that fills regions, such as a metal sheet.",
            keys: &[REGION.schema],
        },
        Family {
            name: "point",
            meaning: "A conductor at points.",
            keys: &[POINT.schema],
        },
        Family {
            name: "interdigitated",
            meaning: "Fingers of alternate sign across the beam, whose field is along the fibers.",
            keys: &[INTERDIGITATED.schema],
        },
    ],
};

keys! {
    /// Cells between fingers: their field is the voltage over an effective spacing, equal in all
    /// cells, and they have no unknown potential.
    FINGERS = "interdigitated = { ... }";
    /// The regions, or a lamina by its name, for all its plies.
    REGIONS: WrittenNames = "regions", [Names] as "the name of a region, or a list of such names",
        required, "[\"skin/2\", \"skin/4\"]";
    /// Effective spacing of the fingers: voltage over mean field.
    SPACING: f64 = "spacing", [Positive(Dimension::LENGTH)], required, "\"0.31 mm\"";
    /// Those regions whose field has the opposite direction.
    REVERSED: Option<WrittenNames> = "reversed", [Names]
        as "the name of a region, or a list of such names", optional, "\"skin/4\"";
    /// Material axis of the field.
    AXIS: usize = "axis", [Count(3)] as "1, 2 or 3, an axis of the material", or "1" = 1, "1";
}

/// Words of the circuits, parallel to [`CIRCUITS`].
const CIRCUIT_WORDS: [&str; 3] = ["driven", "ground", "floating"];
const CIRCUITS: [Circuit; 3] = [Circuit::Driven, Circuit::Ground, Circuit::Floating];

/// Largest voltage \[V\], far beyond the strength of any dielectric.
const LARGEST_VOLTAGE: f64 = 1e12;

/// Allowed spacings of fingers \[m\].
const SPACINGS: std::ops::RangeInclusive<f64> = 1e-9..=1.0;

/// The circuit as a word of the input.
pub fn circuit_word(circuit: Circuit) -> &'static str {
    let index = CIRCUITS.iter().position(|known| *known == circuit);
    CIRCUIT_WORDS[index.unwrap_or(0)]
}

/// All electrodes, as far as they could be read.
#[derive(Debug, Clone)]
pub(super) struct WrittenElectrodes {
    all: Vec<WrittenElectrode>,
    /// Requests that are not known with electrodes: keys and their lines.
    unknown: Vec<(&'static str, usize)>,
}

/// `[[electrode]]` as far as it could be read.
#[derive(Debug, Clone)]
struct WrittenElectrode {
    line: usize,
    name: Option<Written>,
    location: Option<WrittenLocation>,
    circuit: Option<Circuit>,
}

/// Location of an electrode.
#[derive(Debug, Clone)]
enum WrittenLocation {
    /// On physical curves.
    Curves(Vec<Written>),
    /// All of some regions.
    Regions(Vec<Written>),
    /// Physical points.
    Points(Vec<Written>),
    /// Fingers across the beam.
    Fingers(WrittenFingers),
}

/// `interdigitated = { ... }`.
#[derive(Debug, Clone)]
struct WrittenFingers {
    regions: Option<Vec<Written>>,
    /// Those regions whose field has the opposite direction.
    reversed: Option<Vec<Written>>,
    /// Positive \[m\].
    spacing: Option<f64>,
    /// Material axis along which the field is, from zero.
    axis: Option<usize>,
}

/// An electrode on the mesh, and its location as text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Placed {
    pub electrode: Electrode,
    pub location: String,
}

/// Reads every `[[electrode]]`.
pub(super) fn read(root: &Table<'_>) -> WrittenElectrodes {
    let tables = root.tables(&ELECTRODES);
    let mut electrodes: Vec<WrittenElectrode> = Vec::with_capacity(tables.len());
    for table in &tables {
        let electrode = read_one(table);
        let is_same = |other: &&WrittenElectrode| {
            // figures are files with their names, and some file systems ignore case
            let names = [&other.name, &electrode.name]
                .map(|name| name.as_ref().map(|written| written.text.to_lowercase()));
            names[0].is_some() && names[0] == names[1]
        };
        if let Some(other) = electrodes.iter().find(is_same) {
            let name = electrode
                .name
                .as_ref()
                .map_or_else(String::new, |n| n.text.clone());
            let line = other.line;
            table.note(&NAME, &ElectrodeProblem::NameTwice { name, line });
        }
        electrodes.push(electrode);
    }
    let unknown = [PRESTRESS.name(), END_EFFECTS.name()].into_iter();
    let unknown = unknown.filter(|key| root.has(key));
    WrittenElectrodes {
        all: electrodes,
        unknown: unknown.map(|key| (key, root.line_of(key))).collect(),
    }
}

fn read_one(table: &Table<'_>) -> WrittenElectrode {
    // All keys are read before the first wrong one ends the reading.
    let name = name(table);
    let location = location(table);
    let circuit = table.get(&CIRCUIT).map(|word| CIRCUITS[word]);
    table.finish();
    WrittenElectrode {
        line: table.line(),
        name,
        location,
        circuit,
    }
}

fn name(table: &Table<'_>) -> Option<Written> {
    table.get_if(
        &NAME,
        |name| name.is_line() && name.text.chars().count() <= LONGEST_NAME,
        "a text of one line, without control characters, of 100 letters at most",
    )
}

/// Largest number of letters of a name: names are parts of file names.
const LONGEST_NAME: usize = 100;

fn location(table: &Table<'_>) -> Option<WrittenLocation> {
    let keys = ELECTRODE.families.iter().flat_map(|family| family.keys);
    let found: Vec<_> = keys
        .filter(|key| table.has(key))
        .map(|key| key.name)
        .collect();
    match found[..] {
        [] => {
            table.note("", &ElectrodeProblem::NoLocation);
            return None;
        }
        [first, second, ..] => {
            table.note(second, &ElectrodeProblem::TwoLocations { first, second });
            return None;
        }
        [_] => {}
    }
    let names = |key: &Key<WrittenNames>, location: fn(Vec<Written>) -> WrittenLocation| {
        table.given(key).map(|names| location(names.0))
    };
    names(&CURVE, WrittenLocation::Curves)
        .or_else(|| names(&REGION, WrittenLocation::Regions))
        .or_else(|| names(&POINT, WrittenLocation::Points))
        .or_else(|| fingers(&table.table(&INTERDIGITATED)?).map(WrittenLocation::Fingers))
}

fn fingers(table: &Table<'_>) -> Option<WrittenFingers> {
    let reversed = table.get(&REVERSED);
    let fingers = WrittenFingers {
        regions: table.get(&REGIONS).map(|names| names.0),
        reversed: reversed.map(|names| names.map_or_else(Vec::new, |names| names.0)),
        spacing: spacing(table),
        axis: table.get(&AXIS).map(|axis| axis - 1),
    };
    table.finish();
    Some(fingers)
}

/// The effective spacing of fingers \[m\].
fn spacing(table: &Table<'_>) -> Option<f64> {
    let is_known = |spacing: &f64| SPACINGS.contains(spacing);
    table.get_if(&SPACING, is_known, "a length between 1 nm and 1 m")
}

/// One name or a list of names; each may be a number that represents a name.
#[derive(Debug)]
struct WrittenNames(Vec<Written>);

impl Declared for WrittenNames {}

impl Value for WrittenNames {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let item = table.item(key)?;
        let items = item.list().unwrap_or_else(|| vec![item]);
        let expected = key.expected();
        if items.is_empty() {
            table.wrong(key, &expected);
            return None;
        }
        // All items are checked, so that each wrong one is noted.
        let read: Vec<_> = items.iter().map(|item| one_name(item, &expected)).collect();
        read.into_iter().collect::<Option<_>>().map(Self)
    }
}

fn one_name(item: &Item<'_>, expected: &str) -> Option<Written> {
    let line = item.line();
    let text = item.text().map(str::to_owned);
    let text = text.or_else(|| item.whole_number().map(|number| number.to_string()));
    match text {
        Some(text) => Some(Written { text, line }),
        None => item.wrong(expected),
    }
}

impl WrittenElectrodes {
    /// Whether the section has no electrodes.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Notes requests that are not known for sections with electrodes.
    fn note_unknown(&self, document: &Document) {
        for &(key, line) in self.unknown.iter().filter(|_| !self.is_empty()) {
            document.note(line, &ElectrodeProblem::NotWithElectrodes { key });
        }
    }

    /// The voltages under a key of a load, by the names of the electrodes; `None` if one
    /// is wrong, which is noted.
    pub fn voltages(
        &self,
        load: &str,
        table: &Table<'_>,
        key: &Key<ByHand>,
    ) -> Option<Vec<(String, f64)>> {
        if !table.has(key) {
            return Some(Vec::new());
        }
        let table = table.table(key)?;
        let read = table.keys().into_iter().map(|name| {
            let voltage = self.voltage(load, &table, &name);
            voltage.map(|voltage| (name, voltage))
        });
        let read: Vec<_> = read.collect();
        read.into_iter().collect()
    }

    fn voltage(&self, load: &str, table: &Table<'_>, name: &str) -> Option<f64> {
        let voltage = table.quantity(name, Dimension::VOLTAGE)?;
        if voltage.abs() > LARGEST_VOLTAGE {
            table.wrong(name, &format!("a voltage of at most {LARGEST_VOLTAGE:e} V"));
            return None;
        }
        let named = |electrode: &&WrittenElectrode| {
            electrode
                .name
                .as_ref()
                .is_some_and(|known| known.text == name)
        };
        let found = self.all.iter().find(named);
        let load = load.to_owned();
        let electrode = name.to_owned();
        match found.map(|found| found.circuit) {
            Some(Some(Circuit::Driven)) => Some(voltage),
            Some(Some(circuit)) => {
                let circuit = circuit_word(circuit);
                let problem = ElectrodeProblem::NotDriven {
                    load,
                    electrode,
                    circuit,
                };
                table.note(name, &problem);
                None
            }
            // its circuit, or its name, has been reported as wrong
            Some(None) => None,
            None if self.all.iter().any(|electrode| electrode.name.is_none()) => None,
            None => {
                let names = self
                    .all
                    .iter()
                    .filter_map(|electrode| electrode.name.as_ref());
                let problem = ElectrodeProblem::UnknownElectrode {
                    load,
                    electrode,
                    known: names.map(|name| name.text.clone()).collect(),
                };
                table.note(name, &problem);
                None
            }
        }
    }
}
