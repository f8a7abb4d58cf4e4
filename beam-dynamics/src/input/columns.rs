//! `[output]`: output of a run in time, and the columns of its tables.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::schema::ValueKind::{Boolean, Count, Positive, Tables};
use shared_geom::document::{ByHand, Declared, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::analyses::Analyses;
use super::builder::ModelBuilder;
use super::misplaced_keys::OF_OUTPUT;
use crate::case::{Every, OutputSettings};
use crate::integrator::Stepping;

mod column;
mod preset;
mod problem;

#[cfg(test)]
mod tests;

pub use problem::ColumnProblem;

keys! {
    /// Files that a run in time writes.
    pub(super) CARD = "[output]";
    /// Interval of the rows: a number of steps, or a time with its unit. The last state is always
    /// written.
    EVERY: Every = "every", [Count(usize::MAX), Positive(Dimension::TIME)]
        as "a time above zero with its unit, or a number of steps", or "1" = Every::Steps(1), "10";
    /// Whether to write the CSV table.
    CSV: bool = "csv", [Boolean], or "true" = true, "false";
    /// Whether to write the NetCDF table.
    NETCDF: bool = "netcdf", [Boolean], or "true" = true, "false";
    /// A field file every this number of rows.
    VTU: Option<usize> = "vtu", [Count(usize::MAX)], optional, "5";
    /// Write the air at all strips for this number of the last revolutions, with maps of the disk.
    AIR: Option<usize> = "air_revolutions", [Count(100)], optional, "1";
    /// Write the internal forces along each blade and line of beams at every row, and their envelope.
    SPAN_FORCES: bool = "span_forces", [Boolean], or "false" = false, "true";
    /// Interval of the saved states: a number of steps, or a time with its unit.
    RESTART_EVERY: Option<Every> = "restart_every", [Count(usize::MAX), Positive(Dimension::TIME)]
        as "a time above zero with its unit, or a number of steps",
        or "only the last state", "\"0.5 s\"";
    /// Columns of the tables.
    COLUMN: ByHand = "column", [Tables(&column::CARD)],
        or "positions of the nodes, electric quantities, thrust, torque and power of rotors, and energies", "";
}

/// Largest number of values in a table: some thirty gigabytes of text and binary.
const MOST_NUMBERS: f64 = 1e9;
/// Numbers of a beam in a row of forces: time, position and six components at two points.
const NUMBERS_OF_BEAM: usize = 16;
/// Largest number of field files.
const MOST_FIELDS: f64 = 1e5;

/// Reads `[output]`; without it, and without columns in it, default columns are written.
pub(super) fn read(root: &Table<'_>, builder: &ModelBuilder) -> Option<OutputSettings> {
    let mut settings = if root.has("output") {
        card(&root.table("output")?, builder)?
    } else {
        OutputSettings::default()
    };
    if settings.columns.is_empty() {
        settings.columns = preset::columns(builder);
    }
    Some(settings)
}

/// Notes output of a run that is too large for a disk.
/// `beams` is the number of beams of the model.
pub(super) fn check(
    root: &Table<'_>,
    output: &OutputSettings,
    (analyses, beams): (Option<&Analyses>, usize),
) {
    let Some(run) = analyses.and_then(|analyses| analyses.transient.as_ref()) else {
        return;
    };
    let longest = match run.stepping {
        Stepping::Constant { step } => step,
        Stepping::Variable(control) => control.most,
    };
    let rows = match output.every {
        Every::Steps(steps) => (run.to - run.from) / (longest * steps as f64),
        Every::Time(time) => (run.to - run.from) / time.max(longest),
    };
    let note = |key: &str, problem: ColumnProblem| match root
        .table("output")
        .filter(|_| root.has("output"))
    {
        Some(table) => table.note(key, &problem),
        None => root.note("transient", &problem),
    };
    let of_columns = match output.csv || output.netcdf {
        true => output.columns.len() + 1,
        false => 0,
    };
    let of_forces = match output.span_forces {
        true => NUMBERS_OF_BEAM * beams,
        false => 0,
    };
    let numbers = of_columns + of_forces;
    if rows * numbers as f64 > MOST_NUMBERS {
        note("every", ColumnProblem::ManyRows { rows, numbers });
    }
    let Some(one_of) = output.vtu else { return };
    let fields = rows / one_of as f64;
    if fields > MOST_FIELDS {
        note("vtu", ColumnProblem::ManyFields { fields });
    }
}

fn card(table: &Table<'_>, builder: &ModelBuilder) -> Option<OutputSettings> {
    let (rows, restart) = (table.get(&EVERY), table.get(&RESTART_EVERY));
    let (csv, netcdf, vtu) = (table.get(&CSV), table.get(&NETCDF), table.get(&VTU));
    let (air, span_forces) = (table.get(&AIR), table.get(&SPAN_FORCES));
    if air.flatten().is_some()
        && builder
            .air_blades()
            .iter()
            .all(|blade| blade.rotor.is_none())
    {
        table.note(&AIR, &ColumnProblem::NoAir);
    }
    let columns = column::read(table, builder);
    table.finish_beside(&OF_OUTPUT);
    Some(OutputSettings {
        columns: columns?,
        every: rows?,
        csv: csv?,
        netcdf: netcdf?,
        vtu: vtu?,
        air: air?,
        span_forces: span_forces?,
        restart: restart?,
    })
}

impl Declared for Every {}

/// Steps as a whole number, or a time with its unit.
impl Value for Every {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if !table.is_text(key) {
            return table.count_or(key, &key.expected()).map(Self::Steps);
        }
        let time = table.quantity(key.name, Dimension::TIME)?;
        if time > 0.0 {
            return Some(Self::Time(time));
        }
        table.wrong(key, &key.expected());
        None
    }
}
