//! The stations of a solved blade: of the blade file, or of the table of stations.

use std::path::{Path, PathBuf};

use shared_geom::blade;
use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::hash::{fingerprint, sha256_of};
use shared_geom::units::rounded;

use super::super::column_table::{ColumnTable, Row};

/// Endings of blade files, and of the tables of stations beside them.
const BLADE: &str = ".blade.json";
const TABLE: &str = ".span.csv";
/// The folder of the sections, beside both.
pub const SECTIONS: &str = "sections";
/// The ending of section files.
const SECTION: &str = ".section.toml";
/// The column of fingerprints.
pub const FINGERPRINT: &str = "fingerprint";

/// The fingerprint of a section: of its file and its mesh.
pub fn section_fingerprint(section: &[u8], mesh: &[u8]) -> String {
    fingerprint(&sha256_of(&[section, mesh])).to_owned()
}

/// A section of a solved blade.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedStation {
    /// The name of its files.
    pub section: String,
    /// The folder of its files.
    pub folder: PathBuf,
    /// Position along the span [-].
    pub eta: f64,
    /// Arc length from the root \[m\].
    pub arc_length: f64,
    /// Fingerprint of its files; `None` in tables of earlier versions.
    pub fingerprint: Option<String>,
}

impl ListedStation {
    /// The section file.
    pub fn file(&self) -> PathBuf {
        self.folder.join(section_file_name(&self.section))
    }

    /// Fingerprint of the files of the section as they are now; `None` if one is missing.
    pub fn present_fingerprint(&self) -> Option<String> {
        let section = std::fs::read(self.file()).ok()?;
        // the mesh is beside the section file
        let mesh = self.folder.join(format!("{}.msh", self.section));
        let mesh = std::fs::read(mesh).ok()?;
        Some(section_fingerprint(&section, &mesh))
    }

    /// Whether the files of the section are others than at the time of the table. Missing files are
    /// none.
    pub fn has_changed(&self) -> bool {
        let both = self.present_fingerprint().zip(self.fingerprint.as_ref());
        both.is_some_and(|(found, known)| found != *known)
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

/// A blade file that does not name its sections.
#[derive(Debug, thiserror::Error)]
#[error("the blade does not name the files of its sections, and \"{table}\" is not beside it")]
struct NoSections {
    table: String,
}

impl Explain for NoSections {
    fn help(&self) -> Option<String> {
        let text = "name the blade NAME.blade.json that \"section-analyzer blade\" wrote; a converted one \
                    does not have them";
        Some(text.to_owned())
    }
}

/// The name of the file of a section.
pub fn section_file_name(section: &str) -> String {
    format!("{section}{SECTION}")
}

/// The name of a blade: of its file, or of the table of its stations.
pub fn blade_name(path: &Path) -> String {
    let whole = path.file_name().unwrap_or_default().to_string_lossy();
    let name = [BLADE, TABLE]
        .iter()
        .find_map(|ending| whole.strip_suffix(ending));
    name.unwrap_or(&whole).to_owned()
}

/// Whether a path is the one of a blade file.
pub fn is_blade(path: &Path) -> bool {
    path.file_name()
        .is_some_and(|name| name.to_string_lossy().ends_with(BLADE))
}

/// Reads the stations of a blade: of the file that `blade` wrote, which names the files of its sections,
/// or of its table of stations, which is also used if the file does not name them.
///
/// # Errors
/// A file that cannot be read; in the table a column that is missing, a cell without a number.
pub fn read_stations(path: &Path) -> Result<Vec<ListedStation>, Diagnostics> {
    if !is_blade(path) {
        return of_table(path);
    }
    let blade = blade::read(path)?.blade;
    if blade.provenance.sections.is_empty() {
        let table = path.with_file_name(format!("{}{TABLE}", blade_name(path)));
        if !table.exists() {
            let table = table.display().to_string();
            let location = SourceLocation::file(path.display().to_string());
            return Err(Diagnostics::one(location, &NoSections { table }));
        }
        return of_table(&table);
    }
    let length = blade.line.length();
    let stations = blade.stations.iter().zip(blade.provenance.sections);
    let station = |(station, section): (&blade::Station, shared_geom::section::SectionFile)| {
        let file = path.parent().unwrap_or(Path::new("")).join(&section.file);
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        ListedStation {
            section: name.strip_suffix(SECTION).unwrap_or(&name).to_owned(),
            folder: file.parent().unwrap_or(Path::new("")).to_owned(),
            eta: rounded(station.arc_length / length),
            arc_length: station.arc_length,
            fingerprint: Some(section.fingerprint),
        }
    };
    Ok(stations.map(station).collect())
}

fn of_table(path: &Path) -> Result<Vec<ListedStation>, Diagnostics> {
    const REMEDY: &str = "name the table NAME.span.csv that \"section-analyzer blade\" wrote";
    let table = ColumnTable::read(path, REMEDY)?;
    let [section, eta, arc] = table.require(["section", "eta", "arc_length"])?;
    let fingerprint = table.index(FINGERPRINT);
    let folder = path.parent().unwrap_or(Path::new("")).join(SECTIONS);
    let station = |row: &Row| {
        Ok(ListedStation {
            section: row.cells[section].clone(),
            folder: folder.clone(),
            eta: table.number(row, eta)?,
            arc_length: table.number(row, arc)?,
            fingerprint: fingerprint.map(|column| row.cells[column].clone()),
        })
    };
    table.rows.iter().map(station).collect()
}
