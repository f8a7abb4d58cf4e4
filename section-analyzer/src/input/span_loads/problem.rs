//! Problems of tables of loads.

use shared_geom::error::{Explain, nearest_name, quoted};

use super::super::column_table::plain;

/// A problem of the beams in a table of loads.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SpanLoadProblem {
    /// Several beams in one table.
    #[error("the table has the members {}, expected one of them", quoted(.members))]
    Members {
        /// Their names.
        members: Vec<String>,
    },
    /// No loads of the wanted beam.
    #[error("the table has no rows of member \"{wanted}\", expected one of {}", quoted(.members))]
    NoMember {
        /// The beam.
        wanted: String,
        /// The beams of the table.
        members: Vec<String>,
    },
    /// A beam is wanted, and the table does not name any.
    #[error("the table has no column \"member\", and member \"{wanted}\" is requested")]
    NoMemberColumn {
        /// The beam.
        wanted: String,
    },
    /// No column of positions.
    #[error(
        "the table has no positions along the blade, expected a column \"eta\" or \"arc_length [m]\""
    )]
    NoPosition {
        /// The columns.
        columns: Vec<String>,
    },
    /// Several columns of positions.
    #[error("the table has the positions {}, expected one of them", quoted(.columns))]
    Positions {
        /// The columns.
        columns: Vec<String>,
    },
    /// A position that is not on the blade.
    #[error(
        "column \"{column}\": found \"{found}\", which is eta {eta}, expected 0 at the root to 1 at \
         the tip"
    )]
    Outside {
        /// The column.
        column: String,
        /// The cell.
        found: String,
        /// The position [-].
        eta: f64,
    },
    /// Two groups of columns for one position.
    #[error(
        "the columns of \"{first}\" and \"{second}\" are both at eta {eta}, expected one of them"
    )]
    Places {
        /// The name of a group.
        first: String,
        /// The name of another one.
        second: String,
        /// The position [-].
        eta: f64,
    },
    /// Two rows for one instant, of a table with a row for each time.
    #[error("the second row for {instant}, expected one for each time of a case")]
    Times {
        /// The instant.
        instant: String,
    },
    /// Two rows for one position and instant.
    #[error(
        "the second row for eta {eta} of {instant}, expected one for each position and instant"
    )]
    Rows {
        /// The position [-].
        eta: f64,
        /// The instant.
        instant: String,
    },
    /// A column that an envelope cannot have.
    #[error(
        "column \"{column}\" beside columns of largest and smallest values, expected an envelope"
    )]
    Envelope {
        /// The column.
        column: String,
    },
    /// A largest value that is less than the smallest.
    #[error("the largest value of {component} is less than the smallest")]
    Ends {
        /// The component.
        component: &'static str,
    },
    /// A force or moment that is none of the components, beside absent components.
    #[error("column \"{column}\" is no component of the internal force, expected {}", quoted(.absent))]
    NoComponent {
        /// The column.
        column: String,
        /// The components that have no column.
        absent: Vec<String>,
    },
}

impl Explain for SpanLoadProblem {
    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Members { .. } | Self::NoMember { .. } => "name it with --member".to_owned(),
            Self::Rows { .. } => {
                "number the instants in a column time or step, and name load cases in a column case"
                    .to_owned()
            }
            Self::NoMemberColumn { .. } => "omit --member".to_owned(),
            Self::NoPosition { columns } => format!(
                "it has {}; positions of tables over time are given by --at NAME=ETA, for columns \
                 NAME_axial, NAME_shear_y and so on",
                quoted(columns)
            ),
            Self::Positions { .. } => "remove the others".to_owned(),
            Self::Outside { .. } => {
                "eta is the part of the length, or in percent with the heading \
                                     \"eta [%]\"; arc is the length from the root, as \"arc [m]\""
                    .to_owned()
            }
            Self::Places { .. } => "give --at once for each position".to_owned(),
            Self::Times { .. } => "name load cases in a column case".to_owned(),
            Self::Envelope { .. } => {
                "an envelope has no times: remove the column, or the columns of the envelope"
                    .to_owned()
            }
            Self::Ends { .. } => "exchange both".to_owned(),
            Self::NoComponent { column, absent } => {
                let near = nearest_name(&plain(column), absent.iter().map(String::as_str));
                match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => "rename or remove it: absent components are zero".to_owned(),
                }
            }
        })
    }
}
