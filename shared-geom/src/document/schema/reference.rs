//! The description as a page of the book.

use std::fmt::Write;

use super::{KeySchema, Need, TableSchema, ValueKind};

/// The reference page of a file, in Markdown: the `opening`, then every table once.
pub fn reference(file: &'static TableSchema, opening: &str) -> String {
    let mut page = opening.to_owned();
    write_table(&mut page, file);
    page
}

/// A table, then the tables in it, each once.
fn write_table(page: &mut String, table: &'static TableSchema) {
    let heading = format!("\n## `{}`\n", table.title);
    if page.contains(&heading) {
        return;
    }
    page.push_str(&heading);
    // Writing to a text cannot fail.
    let _ = writeln!(page, "\n{}", table.meaning);
    if !table.keys.is_empty() {
        write_keys(page, table.keys);
    }
    if !table.families.is_empty() {
        let names: Vec<_> = table.families.iter().map(|family| family.name).collect();
        let _ = writeln!(page, "\nIt has the keys of one of: {}.", names.join(", "));
    }
    for family in table.families {
        let name = family.name;
        let _ = writeln!(page, "\n*{name}*: {}", family.meaning);
        write_keys(page, family.keys);
    }
    let kinds = table.all_keys().flat_map(|key| key.kinds);
    for inner in kinds.filter_map(ValueKind::inner_table) {
        write_table(page, inner);
    }
}

fn write_keys(page: &mut String, keys: &[KeySchema]) {
    page.push_str("\n| key | value | if absent | meaning | example |\n");
    page.push_str("| --- | --- | --- | --- | --- |\n");
    for key in keys {
        let kinds: Vec<_> = key.kinds.iter().map(words).collect();
        let absent = match key.need {
            Need::Required => "required",
            Need::Optional => "-",
            Need::Default(default) => default,
        };
        let example = match key.example {
            "" => "-".to_owned(),
            text => format!("`{text}`"),
        };
        let _ = writeln!(
            page,
            "| `{}` | {} | {absent} | {} | {example} |",
            key.name,
            kinds.join(", or "),
            key.meaning
        );
    }
}

/// A kind of value, as text.
fn words(kind: &ValueKind) -> String {
    match kind {
        ValueKind::Text => "text".to_owned(),
        ValueKind::Name => "name".to_owned(),
        ValueKind::Names => "name, or a list of names".to_owned(),
        ValueKind::Texts => "text, or a list of texts".to_owned(),
        ValueKind::Word(known) => quoted(known),
        ValueKind::Words(known) => format!("{}, or a list of these", quoted(known)),
        ValueKind::Boolean => "`true`, `false`".to_owned(),
        ValueKind::Unit(dimension) => format!("unit of {dimension}"),
        ValueKind::Quantity(dimension) => format!("quantity: {dimension}"),
        ValueKind::Positive(dimension) => format!("quantity: {dimension}, greater than zero"),
        ValueKind::NotNegative(dimension) => format!("quantity: {dimension}, zero or more"),
        ValueKind::Quantities(dimension) => {
            format!("quantity, or a list of quantities, each {dimension}")
        }
        ValueKind::Vector(count, dimension) => format!("{count} quantities, each {dimension}"),
        ValueKind::Vectors(count, dimension) => {
            format!("list of arrays of {count} quantities, each {dimension}")
        }
        ValueKind::Named(dimension) => format!("quantities by name, each {dimension}"),
        ValueKind::Free => "quantity".to_owned(),
        ValueKind::FreeMatrix => "quantity, list of quantities, or rows of numbers".to_owned(),
        ValueKind::Count(usize::MAX) => "whole number of at least 1".to_owned(),
        ValueKind::Count(most) => format!("whole number from 1 to {most}"),
        ValueKind::Numbers(most) => format!("1 to {most} numbers"),
        ValueKind::Rows(0, _) => "`[]`".to_owned(),
        ValueKind::Rows(rows, columns) => format!("{rows} rows of {columns} numbers"),
        ValueKind::Lines(0) => "rows of numbers".to_owned(),
        ValueKind::Lines(columns) => format!("rows of {columns} numbers"),
        ValueKind::Drive(dimension) => format!("drive: {dimension}"),
        ValueKind::Drives(dimension) => format!("list of drives, each {dimension}"),
        ValueKind::NamedDrives(dimension) => format!("drives by name, each {dimension}"),
        ValueKind::Table(table) => format!("table `{}`", table.title),
        ValueKind::NamedTables(table) => format!("tables `{}`", table.title),
        ValueKind::Tables(table) => format!("tables `{}`", table.title),
        ValueKind::Columns(table) => format!("names by key, or tables `{}`", table.title),
        ValueKind::Parameters(table) => format!("quantities by name, or tables `{}`", table.title),
        ValueKind::OtherTables => "tables".to_owned(),
    }
}

/// Words in quotes.
fn quoted(words: &[&str]) -> String {
    let quoted: Vec<_> = words.iter().map(|word| format!("`\"{word}\"`")).collect();
    quoted.join(", ")
}
