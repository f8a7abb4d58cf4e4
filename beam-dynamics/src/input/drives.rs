//! Numbers that change with time: `[drives.NAME]`, and what may stand for one in a card.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::Arc;

use shared_geom::document::Table;
use shared_geom::expression::{Expression, Names, written};
use shared_geom::units::Dimension;

use super::problem::InputProblem;
use crate::model::{Drive, Formula};

/// The drives of an input by name; those that are wrong are `None`.
#[derive(Debug, Default)]
pub(super) struct Catalog {
    named: BTreeMap<String, Option<Drive>>,
    /// Drives by name that a card uses.
    used: RefCell<Vec<String>>,
}

/// Reads the drive under `key` of a card, in SI units of `dimension`: a number or a
/// quantity, an expression of time `"= ..."`, the name of a `[drives.NAME]`, or a table.
/// `None` when it is absent or wrong; what is wrong has been noted.
pub(super) fn read(
    table: &Table<'_>,
    key: &str,
    dimension: Dimension,
    catalog: &Catalog,
) -> Option<Drive> {
    if !table.has(key) {
        return None;
    }
    if !table.is_text(key) {
        return table.quantity(key, dimension).map(Drive::Constant);
    }
    let text = table.text(key)?;
    let document = table.document();
    if let Some(text) = written(&text) {
        let formula = formula(table, key, text)?;
        return Some(formula.scaled(document.factor(dimension)));
    }
    if let Some(drive) = catalog.named.get(text.trim()) {
        catalog.used.borrow_mut().push(text.trim().to_owned());
        return Some(drive.clone()?.scaled(document.factor(dimension)));
    }
    let is_quantity = text.trim().contains(' ') || text.starts_with(|c: char| c.is_ascii_digit());
    if is_quantity {
        return table.quantity(key, dimension).map(Drive::Constant);
    }
    let problem = InputProblem::UnknownName {
        kind: "drive",
        name: text,
        user: table.title().to_owned(),
        known: catalog.named.keys().cloned().collect(),
    };
    table.note(key, &problem);
    None
}

/// An expression of time, in declared units.
fn formula(table: &Table<'_>, key: &str, text: &str) -> Option<Drive> {
    let document = table.document();
    let constants = document.parameters();
    let names = Names {
        variables: &["t"],
        constants: &constants,
    };
    let expression = document.expression(key, table.line_of(key), text, &names)?;
    if !expression.uses(0) {
        return table_constant(&expression);
    }
    let formula = Formula::new(expression, document.factor(Dimension::TIME));
    Some(Drive::Formula(Arc::new(formula)))
}

fn table_constant(expression: &Expression) -> Option<Drive> {
    let value = expression.at(|_| Default::default()).value;
    Some(Drive::Constant(value))
}

/// Reads every `[drives.NAME]`.
pub(super) fn read_named(root: &Table<'_>) -> Catalog {
    let mut catalog = Catalog::default();
    for (name, table) in root.named_tables("drives") {
        let text = table.require_text("expression", "an expression of t");
        let drive = text.and_then(|text| {
            let text = written(&text).unwrap_or(&text).to_owned();
            formula(&table, "expression", &text)
        });
        table.finish();
        catalog.named.insert(name, drive);
    }
    catalog
}
