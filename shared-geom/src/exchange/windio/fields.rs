//! Fields of a windIO file: tables on a grid, and their problems.

use super::super::problem::{ExchangeProblem, Problems};
use super::super::text::{not_a_number, number};
pub(super) use crate::exchange::yaml::required;
use crate::exchange::yaml::{Node, Value};

/// Grid positions that differ by less are one [-].
pub(super) const SAME: f64 = 1e-12;

/// Values on a grid of parts of the length.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Ascending positions from 0 (root) to 1 (tip) [-].
    pub grid: Vec<f64>,
    /// The values there [unit of the quantity].
    pub values: Vec<f64>,
}

impl Column {
    /// The value at `part`, linear between the positions of the grid.
    pub fn at(&self, part: f64) -> f64 {
        let (i, v) = interval(&self.grid, part);
        let next = self.values.get(i + 1).copied();
        let value = self.values.get(i).copied().unwrap_or(0.0);
        match next {
            // Values at the positions of the grid are the file's, to the digit.
            Some(next) if v >= 1.0 => next,
            Some(next) if v > 0.0 => value + v * (next - value),
            _ => value,
        }
    }
}

/// The interval of `grid` that contains `part`, and the local coordinate (0 to 1).
pub(super) fn interval(grid: &[f64], part: f64) -> (usize, f64) {
    let last = grid.len().saturating_sub(2);
    let behind = grid.iter().position(|&position| position > part);
    let i = behind
        .map_or(last, |behind| behind.saturating_sub(1))
        .min(last);
    let (Some(&from), Some(&to)) = (grid.get(i), grid.get(i + 1)) else {
        return (i, 0.0);
    };
    let v = if to > from {
        (part - from) / (to - from)
    } else {
        1.0
    };
    (i, v.clamp(0.0, 1.0))
}

/// The numbers of a list; notes other values.
pub fn numbers(node: &Node, what: &str, problems: &mut Problems) -> Option<Vec<f64>> {
    let Value::List(items) = &node.value else {
        problems.push(node.line, &not_a_list(node, what));
        return None;
    };
    let value = |item: &std::rc::Rc<Node>| {
        let value = item.text().and_then(number);
        if value.is_none() {
            let found = item.text().map_or_else(|| item.kind(), str::to_owned);
            problems.push(item.line, &not_a_number(what, &found));
        }
        value
    };
    // All are read, so that all problems are reported.
    let values: Vec<_> = items.iter().map(value).collect();
    values.into_iter().collect()
}

/// The problem that `node` is not a list.
pub(super) fn not_a_list(node: &Node, what: &str) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: what.to_owned(),
        found: node.kind(),
        expected: "a list of numbers".to_owned(),
        help: "write [0.0, 0.5, 1.0]".to_owned(),
    }
}

/// The grid of the table `node`: increasing parts of the length.
pub(super) fn grid(node: &Node, what: &str, problems: &mut Problems) -> Option<Vec<f64>> {
    let at = required(node, what, "grid", problems)?;
    let of_grid = format!("grid of {what}");
    let grid = numbers(at, &of_grid, problems)?;
    let bad = |found: String, expected: &str| ExchangeProblem::Other {
        what: of_grid.clone(),
        found,
        expected: expected.to_owned(),
        help: "the grid runs from 0 (root) to 1 (tip) along the reference axis".to_owned(),
    };
    if grid.len() < 2 {
        let found = format!("{} positions", grid.len());
        problems.push(at.line, &bad(found, "at least two positions"));
        return None;
    }
    let outside = grid
        .iter()
        .find(|&&position| !(-SAME..=1.0 + SAME).contains(&position));
    if let Some(position) = outside {
        problems.push(at.line, &bad(position.to_string(), "positions from 0 to 1"));
        return None;
    }
    if let Some(two) = grid.windows(2).find(|two| two[1] <= two[0]) {
        let found = format!("{} after {}", two[1], two[0]);
        problems.push(at.line, &bad(found, "increasing positions"));
        return None;
    }
    Some(grid)
}

/// A table with `grid` and `values` of equal length; notes problems.
pub fn column(node: &Node, what: &str, problems: &mut Problems) -> Option<Column> {
    let grid = grid(node, what, problems);
    let at = required(node, what, "values", problems)?;
    let values = numbers(at, &format!("values of {what}"), problems)?;
    let grid = grid?;
    same_length(at.line, what, &grid, values.len(), problems)?;
    Some(Column { grid, values })
}

/// Notes a number of values that differs from the number of positions of the grid.
pub(super) fn same_length(
    line: usize,
    what: &str,
    grid: &[f64],
    found: usize,
    problems: &mut Problems,
) -> Option<()> {
    if grid.len() == found {
        return Some(());
    }
    problems.push(
        line,
        &ExchangeProblem::Other {
            what: what.to_owned(),
            found: format!("{found} values"),
            expected: format!("{}, one for each position of its grid", grid.len()),
            help: "the file may have been cut off, or a line of numbers is not complete".to_owned(),
        },
    );
    None
}

/// The columns x, y and z of a reference axis; notes problems.
pub fn axis(node: &Node, problems: &mut Problems) -> Option<[Column; 3]> {
    let columns = ["x", "y", "z"].map(|key| {
        let at = required(node, "reference_axis", key, problems)?;
        column(at, &format!("reference_axis.{key}"), problems)
    });
    let [x, y, z] = columns;
    Some([x?, y?, z?])
}
