//! The binary table of a run, read only by the published grammar of the format.
//!
//! # References
//! - Unidata, "NetCDF file format specifications": classic and 64-bit offset formats.

use std::collections::BTreeMap;

use super::Folder;

/// The bytes of a file and the position of reading.
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take(&mut self, count: usize) -> &'a [u8] {
        let (taken, rest) = self.0.split_at(count);
        self.0 = rest;
        taken
    }

    fn number(&mut self) -> u32 {
        u32::from_be_bytes(self.take(4).try_into().unwrap())
    }

    /// A number of eight bytes, like the offsets of this format.
    fn offset(&mut self) -> usize {
        u64::from_be_bytes(self.take(8).try_into().unwrap()) as usize
    }

    /// A text with its length, filled up to four bytes with zeros.
    fn text(&mut self) -> String {
        let length = self.number() as usize;
        let text = String::from_utf8(self.take(length).to_vec()).unwrap();
        let rest = self.take(length.next_multiple_of(4) - length);
        assert!(rest.iter().all(|byte| *byte == 0));
        text
    }

    /// The head of a list: its tag, or twice zero for an empty one; the number of entries.
    fn list(&mut self, tag: u32) -> usize {
        let (found, count) = (self.number(), self.number());
        assert!(found == tag || (found, count) == (0, 0), "tag {found}");
        count as usize
    }

    /// Attributes, all of them texts.
    fn attributes(&mut self) -> BTreeMap<String, String> {
        let count = self.list(0x0C);
        let mut found = BTreeMap::new();
        for _ in 0..count {
            let name = self.text();
            assert_eq!(self.number(), 2, "{name}: expected NC_CHAR");
            found.insert(name, self.text());
        }
        found
    }
}

/// A variable over the unlimited dimension.
struct Variable {
    name: String,
    attributes: BTreeMap<String, String>,
    values: Vec<f64>,
}

/// Attributes of the file, and its variables.
fn read(file: &[u8]) -> (BTreeMap<String, String>, Vec<Variable>) {
    let mut bytes = Bytes(file);
    assert_eq!(bytes.take(4), b"CDF\x02");
    let records = bytes.number() as usize;
    assert_eq!(bytes.list(0x0A), 1);
    assert_eq!((bytes.text().as_str(), bytes.number()), ("time", 0));
    let attributes = bytes.attributes();
    let count = bytes.list(0x0B);
    let mut heads = Vec::new();
    for _ in 0..count {
        let name = bytes.text();
        assert_eq!(
            (bytes.number(), bytes.number()),
            (1, 0),
            "{name}: dimensions"
        );
        let attributes = bytes.attributes();
        assert_eq!(bytes.number(), 6, "{name}: expected NC_DOUBLE");
        assert_eq!(bytes.number(), 8, "{name}: bytes of a record");
        heads.push((name, attributes, bytes.offset()));
    }
    let value = |index: usize| f64::from_be_bytes(file[index..index + 8].try_into().unwrap());
    let variables = heads.into_iter().map(|(name, attributes, begin)| Variable {
        name,
        attributes,
        values: (0..records).map(|k| value(begin + 8 * count * k)).collect(),
    });
    (attributes, variables.collect())
}

const MODEL: &str = "\
name = \"swinging mass\"
units = \"SI\"
[[node]]
name = \"mass\"
position = [1, 0, 0]
[[body]]
node = \"mass\"
mass = 2
inertia = [1, 1, 1]
[[rod]]
name = \"rod\"
nodes = [\"mass\"]
at = [0, 0, 0]
law = { kind = \"linear\", stiffness = 1e4 }
[gravity]
acceleration = [0, -9.81, 0]
[transient]
to = 0.1
step = 0.01
[[output.column]]
name = \"mass\"
quantity = \"position\"
of = \"mass\"
unit = \"mm\"
component = [\"x\", \"y\"]
[[output.column]]
name = \"tension\"
quantity = \"spring_force\"
of = \"rod\"
component = \"x\"
[[output.column]]
name = \"effort\"
quantity = \"iterations\"
";

#[test]
fn a_table_in_binary_reports_what_it_holds_to_any_reader() {
    let folder = Folder::new();
    folder.write("m.dynamics.toml", MODEL);
    let run = folder.run(&["transient", "m.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let file = std::fs::read(folder.path("results/m.transient.nc")).unwrap();
    let (about, variables) = read(&file);
    assert_eq!(about["title"], "swinging mass");
    assert!(about["source"].starts_with("beam-dynamics "));
    assert!(about["comment"].contains("axes of the model"));
    let reported: Vec<_> = variables
        .iter()
        .map(|variable| {
            let of = |name: &str| variable.attributes[name].as_str();
            (variable.name.as_str(), of("units"), of("long_name"))
        })
        .collect();
    let expected = [
        ("time", "s", "time"),
        ("mass_x", "mm", "position x of mass"),
        ("mass_y", "mm", "position y of mass"),
        ("tension", "N", "spring force x of rod in its own axes"),
        ("effort", "1", "iterations"),
    ];
    assert_eq!(reported, expected);
    assert_eq!(variables[0].attributes["axis"], "T");

    // The numbers equal the numbers of the text, to the last bit.
    let text = folder.read("results/m.transient.csv");
    for (row, line) in text.lines().skip(1).enumerate() {
        for (value, variable) in line.split(',').zip(&variables) {
            let value: f64 = value.parse().unwrap();
            assert_eq!(value.to_bits(), variable.values[row].to_bits(), "{line}");
        }
    }
    assert_eq!(text.lines().count() - 1, variables[0].values.len());
}
