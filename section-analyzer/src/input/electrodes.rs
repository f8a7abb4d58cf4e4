//! Electrodes as written: `[[electrode]]`.

use shared_geom::document::{Document, Item, Table};
use shared_geom::units::Dimension;

use super::regions::Written;
use crate::section::{Circuit, Electrode};

mod checks;
mod on_mesh;
mod problem;

pub use problem::ElectrodeProblem;

pub(super) use on_mesh::Found;

/// Words of the circuits, parallel to [`CIRCUITS`].
pub(super) const CIRCUIT_WORDS: [&str; 3] = ["driven", "ground", "floating"];
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
    let tables = root.tables("electrode");
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
            table.note("name", &ElectrodeProblem::NameTwice { name, line });
        }
        electrodes.push(electrode);
    }
    let unknown = ["prestress", "end_effects"].into_iter();
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
    let circuit = match table.has("circuit") {
        true => table
            .word("circuit", &CIRCUIT_WORDS)
            .map(|word| CIRCUITS[word]),
        false => Some(Circuit::Driven),
    };
    table.finish();
    WrittenElectrode {
        line: table.line(),
        name,
        location,
        circuit,
    }
}

fn name(table: &Table<'_>) -> Option<Written> {
    let text = table.require_text("name", "a name of its own")?;
    let is_sound = !text.trim().is_empty() && !text.contains(char::is_control);
    if !is_sound || text.chars().count() > LONGEST_NAME {
        let expected = "a text of one line, without control characters, of 100 letters at most";
        table.wrong("name", expected);
        return None;
    }
    let line = table.line_of("name");
    Some(Written { text, line })
}

/// Largest number of letters of a name: names are parts of file names.
const LONGEST_NAME: usize = 100;

const LOCATION_KEYS: [&str; 4] = ["curve", "region", "point", "interdigitated"];

fn location(table: &Table<'_>) -> Option<WrittenLocation> {
    let found = LOCATION_KEYS.map(|key| (key, table.has(key)));
    let mut found = found.iter().filter(|(_, has)| *has).map(|(key, _)| *key);
    match (found.next(), found.next()) {
        (None, _) => {
            table.note("", &ElectrodeProblem::NoLocation);
            None
        }
        (Some(first), Some(second)) => {
            table.note(second, &ElectrodeProblem::TwoLocations { first, second });
            None
        }
        (Some("curve"), None) => {
            let expected = "the name of a physical curve, or a list of such names";
            names(table, "curve", expected).map(WrittenLocation::Curves)
        }
        (Some("region"), None) => {
            let expected = "the name of a physical surface, or a list of such names";
            names(table, "region", expected).map(WrittenLocation::Regions)
        }
        (Some("point"), None) => {
            let expected = "the name of a physical point, or a list of such names";
            names(table, "point", expected).map(WrittenLocation::Points)
        }
        (Some(key), None) => fingers(&table.table(key)?).map(WrittenLocation::Fingers),
    }
}

fn fingers(table: &Table<'_>) -> Option<WrittenFingers> {
    let expected = "the name of a region, or a list of such names";
    table.require_item("regions", expected);
    let axis = match table.has("axis") {
        true => table.count("axis").and_then(|axis| {
            if axis > 3 {
                table.wrong("axis", "1, 2 or 3, an axis of the material");
            }
            (axis <= 3).then(|| axis - 1)
        }),
        false => Some(0),
    };
    let fingers = WrittenFingers {
        regions: names(table, "regions", expected),
        reversed: match table.has("reversed") {
            true => names(table, "reversed", expected),
            false => Some(Vec::new()),
        },
        spacing: spacing(table),
        axis,
    };
    table.finish();
    Some(fingers)
}

/// The effective spacing of fingers \[m\].
fn spacing(table: &Table<'_>) -> Option<f64> {
    let spacing = table.require_positive("spacing", Dimension::LENGTH)?;
    let is_known = SPACINGS.contains(&spacing);
    if !is_known {
        table.wrong("spacing", "a length between 1 nm and 1 m");
    }
    is_known.then_some(spacing)
}

/// One name or a list of names; each may be a number that represents a name.
fn names(table: &Table<'_>, key: &str, expected: &str) -> Option<Vec<Written>> {
    let item = table.item(key)?;
    let items = item.list().unwrap_or_else(|| vec![item]);
    if items.is_empty() {
        table.wrong(key, expected);
        return None;
    }
    // All items are checked, so that each wrong one is noted.
    let read: Vec<_> = items.iter().map(|item| one_name(item, expected)).collect();
    read.into_iter().collect()
}

fn one_name(item: &Item<'_>, expected: &str) -> Option<Written> {
    let line = item.line();
    if let Some(text) = item.text() {
        let text = text.to_owned();
        return Some(Written { text, line });
    }
    match item.whole_number() {
        Some(number) => Some(Written {
            text: number.to_string(),
            line,
        }),
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

    /// The voltages under `key` of a load, by the names of the electrodes; `None` if one
    /// is wrong, which is noted.
    pub fn voltages(&self, load: &str, table: &Table<'_>, key: &str) -> Option<Vec<(String, f64)>> {
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
