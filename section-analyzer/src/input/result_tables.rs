//! Tables of results that the report of a blade shows: reserve factors, and modes.

use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use serde::Serialize;
use shared_geom::error::Diagnostics;

use super::column_table::{ColumnTable, Row};
use super::span_loads::FINGERPRINT;

/// The smallest reserve factor of a ply of a section over many loads.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ListedReserve {
    /// The section.
    pub section: String,
    /// Fingerprint of its files at the time of the table.
    #[serde(skip)]
    pub fingerprint: String,
    /// The ply: a physical surface of the section.
    pub ply: String,
    /// The smallest reserve factor [-].
    pub reserve_factor: f64,
    /// The failure index there [-].
    pub failure_index: f64,
    /// The criterion.
    pub criterion: String,
    /// The mode of failure.
    pub mode: String,
    /// The instant.
    pub instant: String,
    /// Position (y, z) in the section \[m\].
    pub position: [f64; 2],
    /// Internal force at the instant, in the order of [`shared_geom::wrench::COMPONENTS`]
    /// \[N, N m\].
    pub force: [f64; 6],
}

/// The columns of the table of reserve factors `NAME.strength.csv`.
pub const RESERVES: [&str; 25] = [
    "eta [-]",
    "section",
    "ply",
    "material",
    "reserve_factor [-]",
    "failure_index [-]",
    "criterion",
    "mode",
    "instant",
    "y [m]",
    "z [m]",
    "axial [N]",
    "shear_y [N]",
    "shear_z [N]",
    "torsion [N m]",
    "bending_y [N m]",
    "bending_z [N m]",
    "stress_11 [Pa]",
    "stress_22 [Pa]",
    "stress_33 [Pa]",
    "stress_23 [Pa]",
    "stress_13 [Pa]",
    "stress_12 [Pa]",
    "reserve_factor_of_cell [-]",
    FINGERPRINT,
];

/// The modes of a blade, as `beam-dynamics modes` lists them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModeTable {
    /// The name of the file.
    pub file: String,
    /// The files of the blades with their fingerprints; `None` if the table does not have them.
    #[serde(skip)]
    pub blade_files: Option<String>,
    /// The columns that are shown, with their units.
    pub columns: Vec<String>,
    /// The rows as written, a cell for each column.
    pub rows: Vec<Vec<String>>,
    /// The name of the mode of each row.
    pub names: Vec<String>,
    /// The rotor speed of each row \[rpm\].
    pub speeds: Vec<f64>,
    /// The frequency of each row, `None` where the mode does not exist \[Hz\].
    pub frequencies: Vec<Option<f64>>,
    /// The figures of shapes beside the table, at the first and the last speed that have one.
    pub shapes: Vec<ShapeFigure>,
}

/// A figure of the shapes of modes, as `beam-dynamics modes` draws it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShapeFigure {
    /// The rotor speed, as text in rpm.
    pub speed: String,
    /// The SVG file in base64.
    pub image: String,
}

/// Reads the table `NAME.strength.csv` of `section-analyzer strength`.
///
/// # Errors
/// A file that cannot be read, a column that is missing, a row that does not fit, a cell without
/// a number.
pub fn read_reserves(path: &Path) -> Result<Vec<ListedReserve>, Diagnostics> {
    const REMEDY: &str = "name the table NAME.strength.csv of \"section-analyzer strength\"";
    let table = ColumnTable::read(path, REMEDY)?;
    // the stresses in the last columns are for the user
    let needed: [&str; 17] = std::array::from_fn(|i| RESERVES[i]);
    let columns = table.require(needed)?;
    let [fingerprint] = table.require([FINGERPRINT])?;
    let [
        _,
        section,
        ply,
        _,
        factor,
        index,
        criterion,
        mode,
        instant,
        y,
        z,
        components @ ..,
    ] = columns;
    let row = |row: &Row| {
        let text = |column: usize| row.cells[column].clone();
        let number = |column: usize| table.number_or_infinity(row, column);
        let mut force = [0.0; 6];
        for (value, column) in force.iter_mut().zip(components) {
            *value = number(column)?;
        }
        Ok(ListedReserve {
            section: text(section),
            fingerprint: text(fingerprint),
            ply: text(ply),
            reserve_factor: number(factor)?,
            failure_index: number(index)?,
            criterion: text(criterion),
            mode: text(mode),
            instant: text(instant),
            position: [number(y)?, number(z)?],
            force,
        })
    };
    table.rows.iter().map(row).collect()
}

/// Reads the table `NAME.modes.csv` or `NAME.frequencies.csv` of `beam-dynamics modes`.
///
/// # Errors
/// As [`read_reserves`].
pub fn read_modes(path: &Path) -> Result<ModeTable, Diagnostics> {
    const REMEDY: &str = "name the table NAME.modes.csv of \"beam-dynamics modes\"";
    let table = ColumnTable::read(path, REMEDY)?;
    let [speed, name, frequency] =
        table.require(["rotor_speed [rpm]", "name", "frequency [Hz]"])?;
    let files = table.index("blade_files");
    let shown = |cells: &[String]| -> Vec<String> {
        let cells = cells.iter().enumerate();
        let cells = cells.filter(|(column, _)| Some(*column) != files);
        cells.map(|(_, cell)| cell.clone()).collect()
    };
    // all rows have the same ones
    let blade_files = files.map(|column| table.rows[0].cells[column].clone());
    let mut modes = ModeTable {
        file: path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
        blade_files: blade_files.filter(|files| !files.is_empty()),
        columns: shown(&table.headings()),
        rows: Vec::new(),
        names: Vec::new(),
        speeds: Vec::new(),
        frequencies: Vec::new(),
        shapes: shapes_beside(path),
    };
    for row in &table.rows {
        modes.speeds.push(table.number_or_infinity(row, speed)?);
        modes.frequencies.push(if row.cells[frequency].is_empty() {
            None
        } else {
            Some(table.number_or_infinity(row, frequency)?)
        });
        modes.names.push(row.cells[name].clone());
        modes.rows.push(shown(&row.cells));
    }
    Ok(modes)
}

/// The figures `NAME.shapes_at_RPM_rpm.svg` beside the table of the same name: the ones of the first and of the
/// last speed. None if there are none, or if they cannot be read.
fn shapes_beside(table: &Path) -> Vec<ShapeFigure> {
    let file = table.file_name().unwrap_or_default().to_string_lossy();
    let name = [".modes.csv", ".frequencies.csv"]
        .iter()
        .find_map(|end| file.strip_suffix(end));
    let folder = table
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let entries = std::fs::read_dir(folder.unwrap_or(Path::new(".")));
    let (Some(name), Ok(entries)) = (name, entries) else {
        return Vec::new();
    };
    let begin = format!("{name}.shapes_at_");
    let files = entries.filter_map(|entry| {
        let path = entry.ok()?.path();
        let file = path.file_name()?.to_string_lossy().into_owned();
        let speed = file
            .strip_prefix(&begin)?
            .strip_suffix("_rpm.svg")?
            .to_owned();
        Some((speed.parse::<f64>().ok()?, speed, path))
    });
    let mut files: Vec<_> = files.collect();
    files.sort_by(|a, b| a.0.total_cmp(&b.0));
    let last = files.len().saturating_sub(1);
    let ends = files
        .into_iter()
        .enumerate()
        .filter(|(i, _)| [0, last].contains(i));
    let figure = |(_, (_, speed, path))| {
        let image = STANDARD.encode(std::fs::read::<std::path::PathBuf>(path).ok()?);
        Some(ShapeFigure { speed, image })
    };
    ends.filter_map(figure).collect()
}
