//! `[[output.column]]`: names, units and quantities of columns.

use shared_geom::document::Table;
use shared_geom::document::schema::TableSchema;
use shared_geom::document::schema::ValueKind::Text;
use shared_geom::keys;

use super::problem::ColumnProblem;
use crate::case::Column;
use crate::input::builder::ModelBuilder;
use crate::input::readings::{self, Reading};

/// A quantity of the tables.
pub(super) const CARD: TableSchema = TableSchema {
    title: "[[output.column]]",
    meaning: "A quantity of the tables; one column for each of its components.",
    keys: &[NAME.schema, UNIT.schema],
    families: &readings::OF_COLUMNS,
};

keys! {
    /// The name of the column: letters, digits, `_`, `.` and `-`, beginning with a letter. Names of
    /// several components end in `_x` and so on.
    NAME: String = "name", [Text], required, "\"tip\"";
    /// Unit of the numbers; energies may be in J, kJ or MJ.
    UNIT: Option<String> = "unit", [Text], optional, "\"mm\"";
}

/// Reads every `[[output.column]]`; a card of several components is several columns.
pub(super) fn read(output: &Table<'_>, builder: &ModelBuilder) -> Option<Vec<Column>> {
    let mut complete = true;
    let mut columns: Vec<Column> = Vec::new();
    let mut lines: Vec<usize> = Vec::new();
    for table in output.tables("column") {
        let found = card(&table, builder);
        if readings::is_known(&table) {
            table.finish();
        }
        complete &= found.is_some();
        for column in found.into_iter().flatten() {
            let name = &column.name;
            let first = columns.iter().position(|other| other.name == *name);
            if let Some(line) = first.map(|first| lines[first]) {
                let (name, line) = (name.clone(), table.document().line_words(line));
                table.note("name", &ColumnProblem::Doubled { name, line });
                complete = false;
                continue;
            }
            lines.push(table.line_of("name"));
            columns.push(column);
        }
    }
    complete.then_some(columns)
}

/// Whether Python, tables and NetCDF accept it as a name.
pub(super) fn is_name(name: &str) -> bool {
    let mut letters = name.chars();
    let first = letters.next();
    first.is_some_and(|c| c.is_ascii_alphabetic() || c == '_')
        && letters.all(|c| c.is_ascii_alphanumeric() || "_.-".contains(c))
}

fn card(table: &Table<'_>, builder: &ModelBuilder) -> Option<Vec<Column>> {
    let name = name(table);
    let kind = readings::kind(table);
    let user = match &name {
        Some(name) => format!("column \"{name}\""),
        None => "a column".to_owned(),
    };
    let reading = Reading {
        table,
        builder,
        user: &user,
    };
    let parts = reading.parts(kind?);
    let unit = table.get(&UNIT);
    let (name, parts, unit) = (name?, parts?, unit?);
    let is_alone = parts.len() == 1;
    let columns = parts.into_iter().map(|part| {
        let (unit, factor) = match &unit {
            Some(unit) => {
                let factor = readings::unit(table, unit, part.dimension)?.factor;
                (unit.clone(), factor)
            }
            None => {
                // All units of the quantities are known.
                let factor = readings::unit_of(part.unit, part.dimension).ok()?.factor;
                (part.unit.to_owned(), factor)
            }
        };
        Some(Column {
            name: if is_alone {
                name.clone()
            } else {
                format!("{name}_{}", part.word)
            },
            unit,
            factor,
            words: part.words,
            quantity: part.quantity,
        })
    });
    columns.collect()
}

fn name(table: &Table<'_>) -> Option<String> {
    let name = table.get(&NAME)?;
    let problem = match name.as_str() {
        "time" => ColumnProblem::Time,
        _ if !is_name(&name) => ColumnProblem::NoName { name },
        _ => return Some(name),
    };
    table.note("name", &problem);
    None
}
