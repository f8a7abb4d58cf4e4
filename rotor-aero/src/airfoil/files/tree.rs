//! Values of windIO files: tables on a grid, numbers and texts, with their problems.

use std::rc::Rc;

use shared_geom::exchange::text::number;
use shared_geom::exchange::yaml::{self, Node, Value};

use super::notes::Notes;

/// The root of a YAML text; notes its problem.
pub(super) fn root(text: &str, notes: &mut Notes) -> Option<Node> {
    match yaml::parse(text) {
        Ok(root) => Some(root),
        Err((line, problem)) => {
            notes.problems.push(line, &problem);
            None
        }
    }
}

/// The value of `key` in the table `node`, which is called `parent`; notes a missing key.
pub(super) fn required<'n>(
    node: &'n Node,
    parent: &str,
    key: &str,
    notes: &mut Notes,
) -> Option<&'n Node> {
    yaml::required(node, parent, key, &mut notes.problems)
}

/// The items of a list; notes another kind of value.
pub(super) fn list<'n>(node: &'n Node, what: &str, notes: &mut Notes) -> Option<&'n [Rc<Node>]> {
    match &node.value {
        Value::List(items) => Some(items),
        _ => {
            notes.wrong(
                node.line,
                [what, &node.kind(), "a list", "begin the items with \"-\""],
            );
            None
        }
    }
}

/// The number of a value; notes another one.
pub(super) fn scalar(node: &Node, what: &str, notes: &mut Notes) -> Option<f64> {
    let value = node.text().and_then(number);
    if value.is_none() {
        notes.wrong(
            node.line,
            [what, &node.kind(), "a finite number", "write a number"],
        );
    }
    value
}

/// The number of an optional key.
pub(super) fn optional(node: &Node, key: &str, notes: &mut Notes) -> Option<f64> {
    let found = node.entry(key)?;
    scalar(found, key, notes)
}

/// The text of an entry.
pub(super) fn word<'n>(node: &'n Node, key: &str) -> Option<&'n str> {
    node.entry(key).and_then(Node::text)
}

/// The numbers of a list; notes other values.
pub(super) fn numbers(node: &Node, what: &str, notes: &mut Notes) -> Option<Vec<f64>> {
    let items = list(node, what, notes)?;
    let values: Vec<_> = items.iter().map(|item| scalar(item, what, notes)).collect();
    values.into_iter().collect()
}

/// Values on a grid.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Column {
    pub line: usize,
    pub grid: Vec<f64>,
    pub values: Vec<f64>,
}

/// A table with `grid` and `values` of equal length; notes problems.
pub(super) fn column(node: &Node, what: &str, notes: &mut Notes) -> Option<Column> {
    let grid = required(node, what, "grid", notes)
        .and_then(|at| numbers(at, &format!("grid of {what}"), notes));
    let values = required(node, what, "values", notes)
        .and_then(|at| numbers(at, &format!("values of {what}"), notes));
    let (grid, values) = (grid?, values?);
    if grid.len() != values.len() || grid.is_empty() {
        let found = format!("{} positions and {} values", grid.len(), values.len());
        let help = "the file may have been cut off, or a line of numbers is not complete";
        notes.wrong(
            node.line,
            [
                what,
                &found,
                "as many values as positions, at least one",
                help,
            ],
        );
        return None;
    }
    Some(Column {
        line: node.line,
        grid,
        values,
    })
}

impl Column {
    /// The value at a position, linear between the positions of the grid, constant beyond.
    pub fn at(&self, position: f64) -> f64 {
        let behind = self.grid.partition_point(|&known| known <= position);
        let value = |i: usize| self.values.get(i).copied();
        let known = |i: usize| self.grid.get(i).copied();
        let Some(before) = behind.checked_sub(1) else {
            return value(0).unwrap_or(0.0);
        };
        match (value(before), value(behind), known(before), known(behind)) {
            (Some(a), Some(b), Some(from), Some(to)) => {
                a + (position - from) / (to - from) * (b - a)
            }
            (Some(a), ..) => a,
            _ => 0.0,
        }
    }

    /// Notes a grid that is not strictly ascending; returns whether it is.
    pub fn is_ascending(&self, what: &str, notes: &mut Notes) -> bool {
        let falling = self.grid.windows(2).find(|two| two[1] <= two[0]);
        if let Some(two) = falling {
            let found = format!("{} after {}", two[1], two[0]);
            let help = "the grid runs from the root to the tip";
            notes.wrong(
                self.line,
                [
                    &format!("grid of {what}"),
                    &found,
                    "increasing positions",
                    help,
                ],
            );
        }
        falling.is_none()
    }
}
