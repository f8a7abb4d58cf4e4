//! Named properties of beams: from property files, or given in the card.

use shared_geom::document::schema::ValueKind::{Boolean, Table as OneTable, Tables, Text};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::keys;
use std::path::Path;

use shared_geom::blade::{section_remark, written_section_remark};
use shared_geom::document::{ByHand, Table};
use shared_geom::files::names_beside;
use shared_geom::section::{self, CubicTable, SectionProperties};
use shared_geom::units::Dimension;

use super::beam_section::{Properties, usable};
use super::curved::Curved;
use super::heat;
use super::inline_properties;
use super::laws::{self, LawProblem};
use super::problem::InputProblem;
use super::{damping, drives};

/// Properties of beams.
pub(super) const CARD: TableSchema = TableSchema {
    title: "[properties.NAME]",
    meaning: "Section properties of beams, by a property file or by numbers.",
    keys: &[
        damping::KEY.schema,
        LAW.schema,
        heat::HEAT[0],
        heat::HEAT[1],
    ],
    families: &[
        Family {
            name: "file",
            meaning: "From a property file.",
            keys: &[FILE.schema, PRESTRESS.schema],
        },
        inline_properties::NUMBERS,
    ],
};

keys! {
    /// The property file, relative to this file.
    FILE: String = "file", [Text], required, "\"strip.properties.json\"";
    /// Whether the internal forces change the stiffness, by the table of the file.
    PRESTRESS: bool = "prestress", [Boolean], or "false" = false, "true";
    /// Law of the section in place of stiffness and damping.
    LAW: ByHand = "law", [OneTable(&laws::SECTION), Tables(&laws::SECTION)], optional, "";
}

/// Ending of the names of property files.
const PROPERTY_FILE: &str = ".properties.json";

/// Remark on properties whose table of prestress is not used.
const UNUSED_TABLE: &str = "torsional and torsional-flexural buckling are left out, as the \
    table of prestress of the property file is not used: add prestress = true";
/// Remark on property files without a table of prestress.
const NO_TABLE: &str = "torsional and torsional-flexural buckling are left out, as the property \
    file has no table of prestress: analyze the section with prestress = \"biot\", and add \
    prestress = true here";

/// The properties of an input by name; wrong properties are `None`.
#[derive(Debug, Clone, Default)]
pub(super) struct Catalog {
    named: Vec<(String, Option<Properties>)>,
    /// Remarks on probable mistakes.
    pub remarks: Vec<String>,
}

/// Reads every `[properties.NAME]`.
pub(super) fn read(root: &Table<'_>, drives: &drives::Catalog) -> Catalog {
    let tables = root.named_tables("properties");
    let mut catalog = Catalog::default();
    for (name, table) in tables {
        let is_file = table.has(&FILE);
        let properties = if is_file {
            from_file(&name, &table)
        } else {
            note_inline_prestress(&name, &table);
            inline_properties::read(&name, &table)
        };
        let properties = with_law(&name, properties, &table, drives);
        let words = format!("properties \"{name}\"");
        let properties = heat::read(&table, properties, drives, &words);
        table.finish();
        let remark = if is_file || !is_si(&table) {
            section_remark
        } else {
            written_section_remark
        };
        let remark = properties
            .as_ref()
            .and_then(|found| remark(&found.stiffness, &found.mass));
        let curved = properties.as_ref().and_then(|found| found.curved.as_ref());
        let heated = properties.as_ref().and_then(unknown_heat);
        let remarks = [remark, curved.and_then(Curved::conversion), heated];
        let remarks = remarks.into_iter().flatten();
        let remarks = remarks.map(|remark| format!("properties \"{name}\": {remark}"));
        catalog.remarks.extend(remarks);
        catalog.named.push((name, properties));
    }
    catalog
}

/// A remark on a probable mistake if a table of prestress is used with heat.
fn unknown_heat(properties: &Properties) -> Option<String> {
    let names = properties.heat.without_stiffness();
    (properties.prestress.is_some() && !names.is_empty()).then(|| {
        format!(
            "the property file does not contain the effect of {} on the stiffness: with it \
             \"prestress\" ignores the stresses within the free section; analyze the \
             section again",
            names.join(", ")
        )
    })
}

/// Whether plain numbers of stiffness and mass are in SI units.
fn is_si(table: &Table<'_>) -> bool {
    let dimensions = [Dimension::LENGTH, Dimension::FORCE, Dimension::MASS];
    let factor = |dimension: &Dimension| table.document().factor(*dimension);
    dimensions.iter().map(factor).all(|factor| factor == 1.0)
}

impl Catalog {
    /// Remarks for users of critical loads.
    pub fn of_buckling(&self) -> Vec<String> {
        let named = self.named.iter();
        let remark = |(name, found): &(String, Option<Properties>)| {
            let why = found.as_ref()?.torsional_buckling?;
            Some(format!("properties \"{name}\": {why}"))
        };
        named.filter_map(remark).collect()
    }

    /// The properties `name`, as named under a key of a table, described by `user`;
    /// `None` if they are wrong, or unknown, which is noted.
    pub fn find(
        &self,
        name: &str,
        (table, key): (&Table<'_>, &str),
        user: &str,
    ) -> Option<Properties> {
        let found = self.named.iter().find(|named| named.0 == name);
        if found.is_none() {
            let problem = InputProblem::UnknownName {
                kind: "properties",
                name: name.to_owned(),
                user: user.to_owned(),
                known: self.named.iter().map(|named| named.0.clone()).collect(),
            };
            table.note(key, &problem);
        }
        found?.1.clone()
    }
}

/// The properties with the law of their table, if it has one.
fn with_law(
    name: &str,
    properties: Option<Properties>,
    table: &Table<'_>,
    drives: &drives::Catalog,
) -> Option<Properties> {
    if !table.has(&LAW) {
        return properties;
    }
    if table.has(&damping::KEY) {
        let (first, second) = (LAW.name(), damping::KEY.name());
        table.note(second, &LawProblem::Twice { first, second });
        return None;
    }
    let words = format!("properties \"{name}\"");
    if let Some(Properties {
        prestress: Some(_), ..
    }) = properties
    {
        table.note(&PRESTRESS, &LawProblem::LawAndPrestress { beam: words });
        return None;
    }
    let properties = properties?;
    let law = laws::of_section(table, drives, &words, Some(&properties))?;
    Some(Properties {
        law: Some(law),
        ..properties
    })
}

fn from_file(name: &str, table: &Table<'_>) -> Option<Properties> {
    let mut numbers = inline_properties::NUMBERS.keys.iter().map(|key| key.name);
    if let Some(key) = numbers.find(|key| table.has(key)) {
        let table_words = table.title().to_owned();
        table.note(
            key,
            &InputProblem::FileAndNumbers {
                table: table_words,
                key,
            },
        );
        // The others are keys of such a table too.
        for key in numbers {
            let _ = table.has(key);
        }
        return None;
    }
    let written = table.get(&FILE)?;
    let path = table.path(&FILE, &written);
    if !path.exists() && table.is_in_missing_folder(&FILE, &written, &path) {
        return None;
    }
    if !path.is_file() {
        let problem = InputProblem::NoPropertyFile {
            name: name.to_owned(),
            file: path.display().to_string(),
            known: property_files_beside(&path),
        };
        table.note(&FILE, &problem);
        return None;
    }
    let damping = damping::read(table);
    let is_prestressed = table.get(&PRESTRESS);
    let found = table.keep_file("file", section::read(&path))?;
    let mut properties = found.per_arc_length();
    // The damping of the card replaces the damping of the file.
    if let Some(damping) = damping? {
        properties.damping = Some(damping);
    }
    let prestress = if is_prestressed? {
        Some(third_of(name, table, &properties, &path)?)
    } else {
        None
    };
    let usable = usable(name, table, FILE.name(), &properties)?;
    Some(Properties {
        torsional_buckling: match (&prestress, &properties.prestress) {
            (Some(_), _) => None,
            (None, Some(_)) => Some(UNUSED_TABLE),
            (None, None) => Some(NO_TABLE),
        },
        prestress,
        curved: Curved::of(name, &found),
        ..usable
    })
}

/// The table of prestress of a file, if it is requested.
fn third_of(
    name: &str,
    table: &Table<'_>,
    properties: &SectionProperties,
    path: &Path,
) -> Option<CubicTable> {
    if properties.prestress.is_none() {
        let problem = InputProblem::NoPrestress {
            name: name.to_owned(),
            file: path.display().to_string(),
        };
        table.note("prestress", &problem);
    }
    properties.prestress.map(|prestress| prestress.third)
}

/// Notes a request for prestress by properties in the card, which have no table of it.
fn note_inline_prestress(name: &str, table: &Table<'_>) {
    if table.has("prestress") {
        let name = name.to_owned();
        table.note("prestress", &InputProblem::InlinePrestress { name });
    }
}

/// Names of the property files in the folder of `path`, in order.
fn property_files_beside(path: &Path) -> Vec<String> {
    let mut names = names_beside(path);
    names.retain(|name| name.ends_with(PROPERTY_FILE));
    names
}
