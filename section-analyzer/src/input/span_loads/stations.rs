//! The table of the stations of a solved blade.

use std::path::Path;

use shared_geom::error::Diagnostics;
use shared_geom::hash::sha256_of;

use super::super::column_table::{ColumnTable, Row};

/// The column of fingerprints.
const FINGERPRINT: &str = "fingerprint";
/// Digits of a fingerprint, and the text before them in a hash.
const DIGITS: usize = 16;
const BEFORE: &str = "sha256:";

/// The fingerprint of a section: of its file and its mesh.
pub fn section_fingerprint(section: &[u8], mesh: &[u8]) -> String {
    let hash = sha256_of(&[section, mesh]);
    let digits = hash.strip_prefix(BEFORE).unwrap_or(&hash);
    digits.chars().take(DIGITS).collect()
}

/// A section of a solved blade.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedStation {
    /// The name of its files.
    pub section: String,
    /// Position along the span [-].
    pub eta: f64,
    /// Arc length from the root \[m\].
    pub arc_length: f64,
    /// Fingerprint of its files; `None` in tables of earlier versions.
    pub fingerprint: Option<String>,
}

impl ListedStation {
    /// The mesh, beside the section file.
    fn mesh(&self) -> String {
        format!("{}.msh", self.section)
    }

    /// Whether the files of the section in `folder` are others than at the time of the table.
    /// Missing files are none.
    pub fn has_changed(&self, folder: &Path) -> bool {
        let content = |name: String| std::fs::read(folder.join(name)).ok();
        let section = content(format!("{}.section.toml", self.section));
        let found = section.zip(content(self.mesh()));
        let found = found.map(|(section, mesh)| section_fingerprint(&section, &mesh));
        found.is_some_and(|found| {
            self.fingerprint
                .as_ref()
                .is_some_and(|known| *known != found)
        })
    }

    /// The position for reports, with its side of a jump.
    pub fn label(&self) -> String {
        let sides = [("_inner", " inner"), ("_outer", " outer")];
        let side = sides.iter().find(|side| self.section.ends_with(side.0));
        format!(
            "{}{}",
            crate::mesh::short(self.eta),
            side.map_or("", |side| side.1)
        )
    }
}

/// Reads the table of stations that `blade` wrote.
///
/// # Errors
/// A file that cannot be read, a column that is missing, a cell without a number.
pub fn read_stations(path: &Path) -> Result<Vec<ListedStation>, Diagnostics> {
    const REMEDY: &str = "name the table NAME.span.csv that \"section-analyzer blade\" wrote";
    let table = ColumnTable::read(path, REMEDY)?;
    let [section, eta, arc] = table.require(["section", "eta", "arc_length"])?;
    let fingerprint = table.index(FINGERPRINT);
    let station = |row: &Row| {
        Ok(ListedStation {
            section: row.cells[section].clone(),
            eta: table.number(row, eta)?,
            arc_length: table.number(row, arc)?,
            fingerprint: fingerprint.map(|column| row.cells[column].clone()),
        })
    };
    table.rows.iter().map(station).collect()
}
