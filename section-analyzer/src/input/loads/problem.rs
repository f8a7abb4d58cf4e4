//! Problems of load cases, except their numbers.

use shared_geom::error::Explain;

/// A problem of a load case.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LoadProblem {
    /// A point without a force or moment.
    #[error("load \"{load}\" has a \"point\", but no force or moment")]
    PointAlone {
        /// Name of the load case.
        load: String,
    },
    /// Two loads whose files would be the same on file systems that ignore case.
    #[error(
        "load \"{load}\" differs from load \"{other}\" on line {line} only in upper and lower \
         case, expected different names"
    )]
    SameFile {
        /// Name of the load case.
        load: String,
        /// Name of the previous load case.
        other: String,
        /// Its line.
        line: usize,
    },
}

impl Explain for LoadProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::PointAlone { .. } => "give a force or a moment, or remove \"point\"",
            Self::SameFile { .. } => {
                "the name becomes part of file names, and some systems ignore case"
            }
        };
        Some(text.to_owned())
    }
}
