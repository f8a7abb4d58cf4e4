//! Problems of the requested output of a run in time.

use shared_geom::error::Explain;

use crate::input::number::short_number;

/// Bytes of a number as text and in binary.
const BYTES: f64 = 28.0;

/// A problem of `[output]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ColumnProblem {
    /// A name that files and programs cannot use.
    #[error("\"{name}\" is not a column name, expected letters, digits, \"_\", \".\" or \"-\"")]
    NoName {
        /// The name found.
        name: String,
    },
    /// A name that two columns have.
    #[error("column \"{name}\" is already defined on {line}, expected one of this name")]
    Doubled {
        /// The name.
        name: String,
        /// The line of the first, as text.
        line: String,
    },
    /// The name of the first column.
    #[error("\"time\" is the name of the first column, which every table has")]
    Time,
    /// Output of the air without blades in it.
    #[error("the model has no blades in the air, expected a [[blade]] with [blade.aerodynamics]")]
    NoAir,
    /// More rows than fit on a disk.
    #[error(
        "the run would write {} rows of {numbers} numbers, some {} GB",
        short_number(*.rows, 4),
        short_number(*.rows * *.numbers as f64 * BYTES / 1e9, 2)
    )]
    ManyRows {
        /// Number of rows [-].
        rows: f64,
        /// Number of values in each row.
        numbers: usize,
    },
    /// More field files than a folder should contain.
    #[error("the run would write {} field files", short_number(*.fields, 4))]
    ManyFields {
        /// Number of field files [-].
        fields: f64,
    },
}

impl Explain for ColumnProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::NoName { .. } => Some(
                "it becomes a name of Python and of a file: begin with a letter, as in \"tip_z\""
                    .to_owned(),
            ),
            Self::Doubled { .. } => Some(
                "several components of one vector get its name and \"_x\", \"_y\", \"_z\""
                    .to_owned(),
            ),
            Self::ManyRows { .. } => Some(
                "give [output] an \"every\": a number of steps, or a time, for instance \"1 ms\""
                    .to_owned(),
            ),
            Self::ManyFields { .. } => {
                Some("\"vtu\" is the number of rows per field file".to_owned())
            }
            Self::NoAir => {
                Some("remove \"air_revolutions\", or give a blade stations in the air".to_owned())
            }
            Self::Time => Some("time is always written".to_owned()),
        }
    }
}
