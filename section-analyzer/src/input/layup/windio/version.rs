//! The version of a windIO file.

use std::f64::consts::PI;

use shared_geom::exchange::yaml::Node;

use super::Notes;

/// The version of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    One,
    Two,
}

impl Version {
    /// Its number.
    fn number(self) -> u8 {
        match self {
            Self::One => 1,
            Self::Two => 2,
        }
    }

    /// The names of the tables of the outer shape and of the structure.
    pub fn tables(self) -> [&'static str; 2] {
        match self {
            Self::One => ["outer_shape_bem", "internal_structure_2d_fem"],
            Self::Two => ["outer_shape", "structure"],
        }
    }

    /// The unit of angles \[rad\].
    pub fn angle(self) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Two => PI / 180.0,
        }
    }
}

/// The version by the tables of the blade, which has to be the one that the file names.
pub(super) fn read(root: &Node, blade: &Node, notes: &mut Notes) -> Option<Version> {
    let has = |version: Version| {
        version
            .tables()
            .iter()
            .any(|key| blade.entry(key).is_some())
    };
    let by_tables = match has(Version::One) {
        true => Version::One,
        false => Version::Two,
    };
    let Some(node) = root.entry("windIO_version") else {
        return Some(by_tables);
    };
    let text = node.text().unwrap_or_default().trim();
    let named = match text.trim_start_matches('v').split('.').next() {
        Some("1") => Version::One,
        Some("2") => Version::Two,
        _ => {
            let (expected, help) = ("1 or 2, as 2.0", "convert the file to one of them");
            notes.wrong(node.line, ["windIO_version", &node.kind(), expected, help]);
            return None;
        }
    };
    if named == by_tables || !has(by_tables) {
        return Some(named);
    }
    let tables = by_tables.tables().join(" and ");
    let expected = format!("{}, whose tables are {tables}", by_tables.number());
    let help = "angles are in rad in version 1, and in deg in version 2";
    notes.wrong(node.line, ["windIO_version", &node.kind(), &expected, help]);
    None
}
