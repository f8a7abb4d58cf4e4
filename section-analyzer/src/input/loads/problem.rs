//! What can be wrong with a load case besides its numbers.

use shared_geom::error::Explain;

/// A problem of a load case.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LoadProblem {
    /// A point where nothing acts.
    #[error("load \"{load}\" has a \"point\", but no force or moment that acts there")]
    PointAlone {
        /// Name of the load case.
        load: String,
    },
    /// Two loads whose files are one where letters of both cases are the same in names.
    #[error(
        "load \"{load}\" differs from load \"{other}\" on line {line} in upper and lower case \
         only, expected a name of its own"
    )]
    SameFile {
        /// Name of the load case.
        load: String,
        /// Name of the one before.
        other: String,
        /// Its line.
        line: usize,
    },
}

impl Explain for LoadProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::PointAlone { .. } => "give a force or a moment, or leave \"point\" out",
            Self::SameFile { .. } => {
                "the name becomes part of file names, which some systems do not tell apart"
            }
        };
        Some(text.to_owned())
    }
}
