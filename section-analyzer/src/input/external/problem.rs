//! Problems of the matrices of a section.

use shared_geom::error::Explain;

/// A problem of a matrix file, of a node table, or of their combination.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MatrixProblem {
    /// An unknown first line of a matrix file.
    #[error(
        "the file begins with \"{found}\", expected \"%%MatrixMarket matrix\", then \"coordinate\" or \"array\", \"real\" or \"integer\", and \"general\", \"symmetric\" or \"skew-symmetric\""
    )]
    Heading {
        /// The line.
        found: String,
    },
    /// An invalid line of sizes.
    #[error("the sizes are \"{found}\", expected {} whole numbers from 1 to 100000000: {}", if *.expected == 2 { "two" } else { "three" }, if *.expected == 2 { "rows and columns" } else { "rows, columns and entries" })]
    Sizes {
        /// The line.
        found: String,
        /// Expected number of values.
        expected: usize,
    },
    /// An invalid entry.
    #[error("\"{found}\" is not an entry, expected row, column and a finite number")]
    Entry {
        /// The line.
        found: String,
    },
    /// An invalid value.
    #[error("\"{found}\" is not a value, expected a finite number")]
    Value {
        /// The line.
        found: String,
    },
    /// An entry outside of the matrix.
    #[error("an entry at row {row}, column {column} of a matrix of {rows} x {columns}")]
    Index {
        /// Row, from one.
        row: usize,
        /// Column, from one.
        column: usize,
        /// Rows of the matrix.
        rows: usize,
        /// Columns of the matrix.
        columns: usize,
    },
    /// Too few or too many lines.
    #[error("the file has {found} lines of values, expected {expected}")]
    Count {
        /// Lines found.
        found: usize,
        /// Lines announced.
        expected: usize,
    },
    /// A matrix that does not fit the nodes.
    #[error("{what} is {found}, expected {expected}: {why}")]
    Size {
        /// Description of the matrix.
        what: String,
        /// Its size.
        found: String,
        /// The size that fits.
        expected: String,
        /// Origin of this size.
        why: String,
    },
    /// A wrong heading of the node table.
    #[error("the node table begins with \"{found}\", expected \"node,y,z\"")]
    NodeHeading {
        /// The line.
        found: String,
    },
    /// An invalid row of the node table.
    #[error("\"{found}\" is not a node, expected its number and its position y, z")]
    NodeRow {
        /// The line.
        found: String,
    },
    /// A node that is listed twice.
    #[error("node {node} is listed again, first in line {line}")]
    NodeTwice {
        /// Its number.
        node: u64,
        /// The line of the first.
        line: usize,
    },
    /// Too few nodes.
    #[error("the node table has {found} nodes, expected three or more that are not on one line")]
    FewNodes {
        /// Nodes found.
        found: usize,
    },
    /// All nodes on one line.
    #[error("all nodes of the table lie on one line, expected three or more nodes not on a line")]
    OneLine,
    /// Further wrong lines, which are not reported one by one.
    #[error("and {count} more lines are wrong")]
    More {
        /// Their number.
        count: usize,
    },
    /// A symmetric file with both triangles.
    #[error(
        "an entry at row {row}, column {column} and previous entries are on opposite sides of the diagonal: a file declared symmetric in its first line lists one triangle"
    )]
    BothTriangles {
        /// Row, from one.
        row: usize,
        /// Column, from one.
        column: usize,
    },
    /// A matrix of a slice that is not symmetric.
    #[error(
        "the matrix has {upper:e} at row {row}, column {column} and {lower:e} at row {column}, column {row}, expected a symmetric matrix"
    )]
    Asymmetric {
        /// Row, from one.
        row: usize,
        /// Column, from one.
        column: usize,
        /// The entry, in SI \[N/m, kg\].
        upper: f64,
        /// Its mirror image, in SI \[N/m, kg\].
        lower: f64,
    },
    /// A slice of a curved beam.
    #[error("[initial_curvature] with [slice]: a slice is from a straight beam")]
    CurvedSlice,
    /// None or both of two alternatives are given.
    #[error("{found}, expected one of them")]
    Form {
        /// Description of the given data.
        found: &'static str,
    },
}

impl Explain for MatrixProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Size { .. } => {
                "three unknowns per node, ux, uy, uz, in the order of the node table; for a slice first the nodes of the face at x = 0, then the nodes of the other face"
            }
            Self::Index { row, column, .. } if *row == 0 || *column == 0 => {
                "rows and columns count from one"
            }
            Self::BothTriangles { .. } => {
                "write \"general\" in the first line, or remove the entries of one side"
            }
            Self::Asymmetric { lower, upper, .. } if *lower == 0.0 || *upper == 0.0 => {
                "a file with one triangle needs \"symmetric\" in its first line"
            }
            Self::CurvedSlice => "give the blocks of the curved beam as [matrices]",
            Self::Form { found } if found.contains("mass") => return None,
            Self::Form { .. } => {
                "[matrices] names the blocks m, c, e; [slice] the stiffness matrix of a slice of the beam"
            }
            Self::Count { .. } => "the file may have been cut off",
            _ => return None,
        };
        Some(text.to_owned())
    }
}
