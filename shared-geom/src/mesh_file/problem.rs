//! Problems of mesh files, and their list.

use crate::error::{Diagnostics, Explain, SourceLocation};

/// Problems of a file that are kept; more follow from the first ones.
const KEPT: usize = 200;

/// A problem of a mesh file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum FileProblem {
    #[error("the file is not text")]
    NotText,
    #[error("{what} \"{found}\" cannot be read, expected {expected}")]
    Field {
        what: &'static str,
        found: String,
        expected: &'static str,
    },
    #[error("the file ends before {0}")]
    CutOff(&'static str),
    #[error("{found} numbers in a row of {what}, expected {expected}")]
    Count {
        what: String,
        found: usize,
        expected: String,
    },
    #[error("more than {} nodes", u32::MAX)]
    TooManyNodes,
    #[error("node {0} is listed twice")]
    RepeatedNode(u64),
    #[error("element {0} is listed twice")]
    RepeatedElement(u64),
    #[error("element {element} refers to node {node}, which does not exist")]
    UnknownNode { element: u64, node: u64 },
    #[error("{who} refers to {what} {number}, which does not exist")]
    Unknown {
        who: String,
        what: &'static str,
        number: u64,
    },
    #[error("element {element} has {found} rows of its layup, expected one")]
    Layups { element: u64, found: usize },
    #[error("set \"{set}\" contains element {element}, which does not exist")]
    UnknownElement { set: String, element: u64 },
    #[error("set \"{set}\" contains \"{found}\", which is neither a number nor an earlier set")]
    UnknownSet { set: String, found: String },
    #[error("elements of type {0}, expected plane cells with 3, 4, 6, 8 or 9 nodes, or lines")]
    Unsupported(String),
    #[error("*{0} changes the mesh and is not read")]
    Keyword(&'static str),
    #[error("the instance is moved, expected the mesh of a part where it is")]
    Moved,
    #[error("{found}, expected {expected}")]
    Header {
        found: String,
        expected: &'static str,
    },
    #[error("{found} values of {what} follow, expected {expected}")]
    Length {
        what: &'static str,
        found: usize,
        expected: usize,
    },
    #[error("{} arrays of whole numbers by cell could be groups: {}", .0.len(), .0.join(", "))]
    Arrays(Vec<String>),
}

impl Explain for FileProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::NotText => "save the mesh as text (ASCII)",
            Self::CutOff(_) => "the file may have been cut off while it was written or copied",
            Self::Unsupported(_) => {
                "mesh the section as a plane surface: CPS, CPE, S or M3D elements of Abaqus, \
                 triangles and quadrilaterals of VTK"
            }
            Self::Keyword(_) => "write one file with all nodes in one system of axes",
            Self::Moved => "remove the translation of the instance, or apply it to the nodes",
            Self::Unknown { .. } | Self::UnknownNode { .. } | Self::UnknownElement { .. } => {
                "check the number, and that no row is missing"
            }
            Self::RepeatedNode(_) | Self::RepeatedElement(_) => "remove one of the rows",
            Self::Layups { .. } => "give each element one row with its material and angles",
            Self::Arrays(_) => "call the array with the groups \"group\"",
            Self::Header { found, .. } if found.contains("compressed by") => {
                "save without compression, or compressed with zlib"
            }
            Self::Header { found, .. } if found.contains("BINARY") => {
                "save the mesh as text (ASCII)"
            }
            _ => return None,
        };
        Some(help.to_owned())
    }
}

/// The problems found so far, each with its line.
#[derive(Debug, Default)]
pub(super) struct Problems {
    found: Vec<(usize, FileProblem)>,
}

impl Problems {
    /// Adds the problem of a line.
    pub(super) fn push(&mut self, line: usize, problem: FileProblem) {
        if self.found.len() < KEPT {
            self.found.push((line, problem));
        }
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// The value of a good result; the problem of a bad one is added.
    pub(super) fn keep<T>(&mut self, line: usize, result: Result<T, FileProblem>) -> Option<T> {
        result.map_err(|problem| self.push(line, problem)).ok()
    }

    /// Adds the problems of `other`, of the same file.
    pub(super) fn append(&mut self, other: Self) {
        self.found.extend(other.found);
        self.found.truncate(KEPT);
    }

    /// `value`, or all problems in the order of their lines.
    pub(super) fn into_result<T>(mut self, file: &str, value: T) -> Result<T, Diagnostics> {
        self.found.sort_by_key(|(line, _)| *line);
        let mut diagnostics = Diagnostics::new();
        for (line, problem) in &self.found {
            diagnostics.push(SourceLocation::line(file, *line), problem);
        }
        diagnostics.into_result(value)
    }
}

/// The text of a file.
pub(super) fn text<'a>(content: &'a [u8], file: &str) -> Result<&'a str, Diagnostics> {
    std::str::from_utf8(content).map_err(|error| {
        let before = &content[..error.valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        Diagnostics::one(SourceLocation::line(file, line), &FileProblem::NotText)
    })
}
