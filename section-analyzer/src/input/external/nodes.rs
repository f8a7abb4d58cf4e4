//! The node table of a section given by its matrices.

use std::collections::BTreeMap;

use shared_geom::error::{Diagnostics, SourceLocation};

use super::problem::MatrixProblem;
use crate::solve::Pins;

/// Nodes in their order, which is the order of the unknowns.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct NodeTable {
    /// Numbers.
    pub tags: Vec<u64>,
    /// Positions (y, z) \[m\].
    pub positions: Vec<[f64; 2]>,
}

impl NodeTable {
    /// Reads `text`, the content of `file`: the heading `node,y,z`, then one row per
    /// node, positions in units of `unit` \[m\]. Empty lines and lines that begin with
    /// `#` are ignored.
    ///
    /// # Errors
    /// All wrong rows.
    pub fn parse(text: &str, file: &str, unit: f64) -> Result<Self, Diagnostics> {
        let mut problems = Diagnostics::new();
        let lines = (1..).zip(text.trim_start_matches('\u{feff}').lines());
        let mut rows = lines.filter(|(_, row)| !row.trim().is_empty() && !row.starts_with('#'));
        let heading = rows.next();
        if heading.map(|(_, row)| fields(row)) != Some(vec!["node", "y", "z"]) {
            let (line, found) = heading.map_or((1, ""), |(line, row)| (line, row.trim()));
            let found = found.to_owned();
            let problem = MatrixProblem::NodeHeading { found };
            return Err(Diagnostics::one(SourceLocation::line(file, line), &problem));
        }
        let mut table = Self::default();
        let mut line_of = BTreeMap::new();
        for (line, row) in rows {
            let Some((tag, position)) = node(row) else {
                let found = row.trim().to_owned();
                problems.push(
                    SourceLocation::line(file, line),
                    &MatrixProblem::NodeRow { found },
                );
                continue;
            };
            if let Some(&first) = line_of.get(&tag) {
                let problem = MatrixProblem::NodeTwice {
                    node: tag,
                    line: first,
                };
                problems.push(SourceLocation::line(file, line), &problem);
            }
            line_of.insert(tag, line);
            table.tags.push(tag);
            table.positions.push(position.map(|value| unit * value));
        }
        let found = table.tags.len();
        if found < 3 && problems.is_empty() {
            problems.push(
                SourceLocation::file(file),
                &MatrixProblem::FewNodes { found },
            );
        }
        if found >= 3 && problems.is_empty() && Pins::choose(&table.positions).is_err() {
            problems.push(SourceLocation::file(file), &MatrixProblem::OneLine);
        }
        problems.into_result(table)
    }
}

fn fields(row: &str) -> Vec<&str> {
    let fields = row.split(',').map(str::trim);
    fields.map(|field| field.trim_matches('"')).collect()
}

fn node(row: &str) -> Option<(u64, [f64; 2])> {
    let [tag, y, z] = fields(row)[..] else {
        return None;
    };
    let number = |text: &str| text.parse::<f64>().ok().filter(|value| value.is_finite());
    Some((tag.parse().ok()?, [number(y)?, number(z)?]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_nodes_in_their_order() {
        let text = "# from a slice\nnode, y, z\n7, 1, 2\n\n3, -1.5, 0\n5,0,1e1\n";
        let table = NodeTable::parse(text, "n.csv", 1e-3).expect("sound");
        assert_eq!(table.tags, [7, 3, 5]);
        assert_eq!(table.positions, [[1e-3, 2e-3], [-1.5e-3, 0.0], [0.0, 1e-2]]);
    }

    #[test]
    fn wrong_rows_are_all_reported() {
        let problems = NodeTable::parse("node,y,z\n1,0\n2,x,0\n3,0,0\n3,1,0\n", "n.csv", 1.0);
        let problems = problems.expect_err("wrong rows").to_string();
        for words in ["n.csv:2", "n.csv:3", "n.csv:5", "first in line 4"] {
            assert!(problems.contains(words), "{words}: {problems}");
        }
        for text in ["", "a,b\n"] {
            let problems = NodeTable::parse(text, "n.csv", 1.0).expect_err(text);
            assert!(problems.to_string().contains("node,y,z"));
        }
        for rows in ["1,0,0\n2,1,1\n3,2,2\n", "1,1,1\n2,1,1\n3,1,1\n"] {
            let problems = NodeTable::parse(&format!("node,y,z\n{rows}"), "n.csv", 1.0);
            let reported = problems.expect_err(rows).to_string();
            assert!(reported.contains("lie on one line"), "{reported}");
        }
        let problems = NodeTable::parse("node,y,z\n1,0,0\n", "n.csv", 1.0);
        assert!(problems.expect_err("one").to_string().contains("three"));
    }
}
