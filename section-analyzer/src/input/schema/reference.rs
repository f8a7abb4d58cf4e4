//! The description as a page of the book.

use std::fmt::Write;

use super::{KeySchema, Need, SECTION_FILE, TableSchema, ValueKind};

const OPENING: &str = "\
# Section input reference

Every key of a section file, `NAME.section.toml`.
Made by `section-analyzer schema --format markdown`; do not edit.
The use of the keys is described in [Section input](section-input.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"73.1 GPa\"`.
A *name* is a text, or a whole number that represents one: the tag of a physical group.
";

/// The reference page of the section file, in Markdown.
pub fn reference() -> String {
    let mut page = OPENING.to_owned();
    write_table(&mut page, &SECTION_FILE);
    page
}

/// A table, then the tables in it, each once.
fn write_table(page: &mut String, table: &TableSchema) {
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
    let own = table.families.iter().flat_map(|family| family.keys);
    let kinds = table.keys.iter().chain(own).flat_map(|key| key.kinds);
    for inner in kinds.filter_map(ValueKind::table) {
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
        ValueKind::Word(known) => {
            let quoted: Vec<_> = known.iter().map(|word| format!("`\"{word}\"`")).collect();
            quoted.join(", ")
        }
        ValueKind::Boolean => "`true`, `false`".to_owned(),
        ValueKind::Unit(dimension) => format!("unit of {dimension}"),
        ValueKind::Quantity(dimension) => format!("quantity: {dimension}"),
        ValueKind::Vector(count, dimension) => format!("{count} quantities, each {dimension}"),
        ValueKind::Named(dimension) => format!("quantities by name, each {dimension}"),
        ValueKind::Count(most) => format!("whole number from 1 to {most}"),
        ValueKind::Numbers(most) => format!("1 to {most} numbers"),
        ValueKind::Rows(rows, columns) => format!("{rows} rows of {columns} numbers"),
        ValueKind::Table(table) => format!("table `{}`", table.title),
        ValueKind::NamedTables(table) => format!("tables `{}`", table.title),
        ValueKind::Tables(table) => format!("tables `{}`", table.title),
    }
}
