//! Errors of a blade file that people write.

use crate::error::{Explain, nearest_name};

/// A problem of a blade file in TOML, or of a table that it names.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InputProblem {
    /// No frame.
    #[error("the file declares no \"frame\": the axes of its numbers")]
    FrameUndeclared,
    /// Axes by direction, without an order.
    #[error("the file declares axes by their directions and no \"order\" of the six components")]
    OrderUndeclared,
    /// No reference point.
    #[error("the file declares no \"reference_point\": the reference point of K and M")]
    PointUndeclared,
    /// Directions that do not form a frame.
    #[error("\"frame\" is [{}], expected three directions of a right-handed frame", .found.join(", "))]
    Directions {
        /// The words found.
        found: Vec<String>,
    },
    /// Words that do not form an order.
    #[error("\"order\" is [{}], expected each of Fx, Fy, Fz, Mx, My, Mz once", .found.join(", "))]
    Order {
        /// The words found.
        found: Vec<String>,
    },
    /// Two exclusive keys.
    #[error("{table} has both \"{one}\" and \"{other}\", expected one of them")]
    Both {
        /// The table as text.
        table: String,
        /// A key.
        one: String,
        /// Another key.
        other: String,
    },
    /// None of several alternatives.
    #[error("{table} has neither {}", .known.join(" nor "))]
    Neither {
        /// The table as text.
        table: String,
        /// The ways, as text.
        known: Vec<&'static str>,
    },
    /// Lists of different lengths.
    #[error("\"{key}\" lists {found}, and \"{other}\" lists {expected}")]
    Lists {
        /// The key.
        key: &'static str,
        /// Its entries.
        found: usize,
        /// The first of the two keys.
        other: &'static str,
        /// Its entries.
        expected: usize,
    },
    /// Another number of values.
    #[error("\"{key}\" lists {found}, expected {expected}")]
    Count {
        /// The key.
        key: String,
        /// The number found.
        found: usize,
        /// Expected values, as text.
        expected: &'static str,
    },
    /// A column that the table does not have.
    #[error("{file} has no column \"{column}\"{purpose}")]
    NoColumn {
        /// The file with the table.
        file: String,
        /// The column.
        column: String,
        /// Its purpose, as text.
        purpose: String,
        /// The columns that it has.
        known: Vec<String>,
    },
    /// A table without rows.
    #[error(
        "the table has {found}, expected a line with the names of the columns and rows of numbers"
    )]
    NoRows {
        /// Content, as text.
        found: &'static str,
    },
    /// A line with another number of columns.
    #[error("the line has {found} columns, expected {expected} as the names of the columns")]
    Columns {
        /// Columns of the line.
        found: usize,
        /// Columns of the table.
        expected: usize,
    },
    /// A line that cannot be read as part of a table.
    #[error("the line cannot be read as part of a table: {reason}")]
    Row {
        /// The reader's message.
        reason: String,
    },
    /// A cell that is not a number.
    #[error("column \"{column}\" has \"{found}\", expected a number")]
    Cell {
        /// The column.
        column: String,
        /// The cell.
        found: String,
    },
    /// Further cells that are not numbers.
    #[error("further cells of column \"{column}\" that are not numbers: {count}")]
    MoreCells {
        /// The column.
        column: String,
        /// Cells that are not reported one by one.
        count: usize,
    },
    /// A weight instead of a mass.
    #[error("\"{unit}\" measures a weight, expected a mass")]
    Weight {
        /// The unit.
        unit: String,
    },
    /// Engineering properties in foreign axes.
    #[error("{table} gives engineering properties (\"{key}\") in axes other than Helicoid's")]
    EngineeringFrame {
        /// The table as text.
        table: String,
        /// The first of the keys.
        key: &'static str,
    },
    /// Damping in the sections and for the whole blade.
    #[error("the file has [damping], and the property file \"{file}\" has damping of its own")]
    TwoDampings {
        /// The property file.
        file: String,
    },
}

impl Explain for InputProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::FrameUndeclared => {
                "frame = \"helicoid\" (x to the tip, y to the leading edge, z to the upper side), \
                 \"beamdyn\" (x to the suction side, y to the trailing edge, z to the tip), \
                 \"hawc2\" or \"anba4\" (x to the leading edge, y to the suction side, z to the \
                 tip), \"vabs\" or \"sonata\" (as helicoid), or three directions such as \
                 [\"upper\", \"trailing edge\", \"tip\"]"
            }
            Self::OrderUndeclared => {
                "order = [\"Fx\", \"Fy\", \"Fz\", \"Mx\", \"My\", \"Mz\"] is the order of the \
                 rows of K and M, by forces along and moments about these axes"
            }
            Self::PointUndeclared => {
                "reference_point = \"line\" if K and M are about the reference line, else \
                 the point in section axes as two lengths from the line"
            }
            Self::Directions { .. } => {
                "directions: \"tip\" or \"root\", \"leading edge\" or \"trailing edge\", \
                 \"upper\" or \"lower\""
            }
            Self::NoColumn { column, known, .. } => {
                let near = nearest_name(column, known.iter().map(String::as_str));
                return Some(match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("columns: {}", known.join(", ")),
                });
            }
            Self::Columns { .. } => "the file may have been cut short",
            Self::Weight { .. } => {
                "a weight in lbf is a mass in lb, one in N is a mass in kg times 9.80665: divide \
                 by it with factor = 0.10197162129779283 and unit = \"kg/m\""
            }
            Self::EngineeringFrame { .. } => {
                "EIy, EIz and the centers belong to y and z of frame = \"helicoid\": declare it, \
                 or give matrices"
            }
            _ => return None,
        };
        Some(help.to_owned())
    }
}
