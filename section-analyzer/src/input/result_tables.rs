//! Tables of results that the report of a blade shows: reserve factors, and modes.

use std::path::Path;

use serde::Serialize;
use shared_geom::error::Diagnostics;

use super::column_table::{ColumnTable, Row};

/// The smallest reserve factor of a ply of a section over many loads.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ListedReserve {
    /// The section.
    pub section: String,
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
pub const RESERVES: [&str; 24] = [
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
];

/// The modes of a blade, as `beam-dynamics modes` lists them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModeTable {
    /// The name of the file.
    pub file: String,
    /// The columns, with their units.
    pub columns: Vec<String>,
    /// The rows as written, a cell for each column.
    pub rows: Vec<Vec<String>>,
    /// The name of the mode of each row.
    pub names: Vec<String>,
    /// The rotor speed of each row \[rpm\].
    pub speeds: Vec<f64>,
    /// The frequency of each row, `None` where the mode does not exist \[Hz\].
    pub frequencies: Vec<Option<f64>>,
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
    let mut modes = ModeTable {
        file: path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
        columns: table.headings(),
        rows: Vec::new(),
        names: Vec::new(),
        speeds: Vec::new(),
        frequencies: Vec::new(),
    };
    for row in &table.rows {
        modes.speeds.push(table.number_or_infinity(row, speed)?);
        modes.frequencies.push(if row.cells[frequency].is_empty() {
            None
        } else {
            Some(table.number_or_infinity(row, frequency)?)
        });
        modes.names.push(row.cells[name].clone());
        modes.rows.push(row.cells.clone());
    }
    Ok(modes)
}
