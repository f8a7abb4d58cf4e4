//! Problems of the files of a run in time.

use shared_geom::error::{Explain, counted, nearest_name};
use shared_geom::files::OutputProblem;

/// A problem of the files of a run in time.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RunFileProblem {
    /// A file that cannot be read.
    #[error("\"{file}\" cannot be read: {reason}")]
    Unreadable {
        /// The file.
        file: String,
        /// The reason, as text.
        reason: String,
        /// The remedy.
        remedy: &'static str,
    },
    /// A table of another run.
    #[error("\"{file}\" has other columns than this run")]
    OtherColumns {
        /// The file.
        file: String,
    },
    /// A name without a column.
    #[error("unknown column \"{name}\" of \"{file}\"")]
    NoColumn {
        /// The name found.
        name: String,
        /// The file.
        file: String,
        /// The names of its columns.
        known: Vec<String>,
    },
    /// A table without time.
    #[error("\"{file}\" is not a table of a run: it has no column \"time\"")]
    NoTime {
        /// The file.
        file: String,
    },
    /// A table without rows to draw.
    #[error("\"{file}\" has {}, expected at least two to draw a line", counted(*.rows, "row"))]
    NoRows {
        /// The file.
        file: String,
        /// Their number.
        rows: usize,
    },
    /// Tables that cannot be drawn over the same column.
    #[error("column \"{name}\" of \"{file}\" is in {}, and of another table in {}", units[1], units[0])]
    OtherUnit {
        /// The column.
        name: String,
        /// The file.
        file: String,
        /// Units of the first table and of this one.
        units: [String; 2],
    },
    /// Too many panels for one figure.
    #[error("{curves} curves in {panels} panels are more than one figure can hold")]
    ManyPanels {
        /// Number of curves.
        curves: usize,
        /// Number of panels.
        panels: usize,
    },
    /// A file that cannot be written.
    #[error(transparent)]
    Output(#[from] OutputProblem),
}

impl Explain for RunFileProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Unreadable { remedy, .. } => Some((*remedy).to_owned()),
            Self::OtherColumns { .. } => Some(
                "continue with the [output] of the first part, or use another folder with --out"
                    .to_owned(),
            ),
            Self::NoColumn { name, known, .. } => Some(nearest_column(name, known)),
            Self::NoTime { .. } => Some(
                "name a table that \"beam-dynamics transient\" wrote, NAME.transient.csv or \
                 NAME.transient.nc"
                    .to_owned(),
            ),
            Self::NoRows { .. } => Some(
                "rows are written each \"every\" of [output], here between --from and --to"
                    .to_owned(),
            ),
            Self::OtherUnit { .. } => Some(
                "give the column the same \"unit\" in both files, or draw two figures".to_owned(),
            ),
            Self::ManyPanels { .. } => {
                Some("choose columns with --columns, as in --columns 'tip*'".to_owned())
            }
            Self::Output(problem) => problem.help(),
        }
    }
}

fn nearest_column(name: &str, known: &[String]) -> String {
    const SHOWN: usize = 24;
    if let Some(near) = nearest_name(name, known.iter().map(String::as_str)) {
        return format!("did you mean \"{near}\"?");
    }
    let shown: Vec<_> = known.iter().take(SHOWN).map(String::as_str).collect();
    let more = if known.len() > SHOWN {
        format!(" and {} more", known.len() - SHOWN)
    } else {
        String::new()
    };
    format!("columns: {}{more}", shown.join(", "))
}
