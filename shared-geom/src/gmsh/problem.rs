//! Errors of a mesh file.

use crate::error::{Diagnostics, Explain, SourceLocation, nearest_name};

/// Number of problems of one file that are reported; the others are counted.
const LIMIT: usize = 20;

/// A problem of a mesh file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum ReadProblem {
    #[error("the file cannot be read: {0}")]
    Unreadable(String),
    #[error("the line holds bytes that are no UTF-8 text")]
    NotText,
    #[error("the file is empty, expected a mesh of gmsh, Abaqus, VTK or VABS")]
    Empty,
    #[error(
        "this is no mesh of gmsh (no section \"$MeshFormat\"), Abaqus (the name does not end in \
         \".inp\"), VTK or VABS"
    )]
    NotGmsh,
    #[error("file type \"{0}\" found, expected 0 (ascii) or 1 (binary)")]
    FileType(String),
    #[error("numbers of {0} bytes announced, expected 8")]
    NumberSize(u32),
    #[error("the binary file should begin with the integer 1, found {0} or its bytes reversed")]
    ByteOrder(i32),
    #[error("the file ends within {0}")]
    CutOff(&'static str),
    #[error("mesh format version \"{0}\" found, expected 2.2 or 4.1")]
    Version(String),
    #[error("section \"{0}\" is missing")]
    MissingSection(&'static str),
    #[error("section \"{section}\" is not closed: expected \"$End{}\", found {found}", &section[1..])]
    NotClosed { section: String, found: String },
    #[error("section \"{0}\" found again, expected it once")]
    RepeatedSection(&'static str),
    #[error("\"{0}\" found, but no such section is open")]
    StrayEnd(String),
    #[error("text outside of any section: \"{0}\"")]
    Outside(String),
    #[error("the mesh is partitioned (\"$PartitionedEntities\"), expected a mesh in one partition")]
    Partitioned,
    #[error("expected {expected}, found {}", fields(*found))]
    FieldCount {
        expected: &'static str,
        found: usize,
    },
    #[error("{what}: expected a whole number, found \"{found}\"")]
    NotANumber { what: &'static str, found: String },
    #[error("coordinate: expected a finite number, found \"{0}\"")]
    NotACoordinate(String),
    #[error("{count} {what} are announced, more than the rest of the file can hold")]
    CountTooLarge { what: &'static str, count: u64 },
    #[error("{announced} {what} are announced, found {found}")]
    CountMismatch {
        what: &'static str,
        announced: u64,
        found: u64,
    },
    #[error(
        "expected the end of section \"{section}\", since all announced records have been read, found \"{found}\""
    )]
    ContentLeft { section: String, found: String },
    #[error(
        "expected the end of section \"{section}\", \"$End{}\", since all announced records have \
         been read", &section[1..]
    )]
    EndNotFound { section: String },
    #[error("a block of {count} elements, expected 1 to {most}, as the section announces")]
    BlockSize { count: u64, most: usize },
    #[error(
        "the size of elements of gmsh type {0} is not known: the elements after them cannot be read"
    )]
    UnknownType(u64),
    #[error("expected the group's name in double quotes")]
    NoName,
    #[error("dimension {0} found, expected 0, 1, 2 or 3")]
    Dimension(u64),
    #[error("physical group {tag} of dimension {dimension} is named twice")]
    GroupNamedTwice { dimension: u8, tag: i32 },
    #[error("entity {tag} of dimension {dimension} is listed twice")]
    RepeatedEntity { dimension: u8, tag: i32 },
    #[error("more than {} nodes", u32::MAX)]
    TooManyNodes,
    #[error("node {0} is listed twice")]
    RepeatedNode(u64),
    #[error("element {0} is listed twice")]
    RepeatedElement(u64),
    #[error("element {element} refers to node {node}, which does not exist")]
    UnknownNode { element: u64, node: u64 },
    #[error(
        "elements of entity {tag} of dimension {dimension}, which section \"$Entities\" does not list"
    )]
    UnknownEntity { dimension: u8, tag: i32 },
    #[error("{name} in a block of dimension {found}")]
    BlockDimension { name: &'static str, found: u64 },
    #[error("{count} {} of type {name} found, expected {SUPPORTED}", if *count == 1 { "element" } else { "elements" })]
    UnsupportedElements {
        name: String,
        count: u64,
        volume: bool,
    },
    #[error("cells {first} and {cell} have the same corners")]
    RepeatedCell { cell: u64, first: u64 },
    #[error("and {0} more problems")]
    More(usize),
}

const SUPPORTED: &str = "points, lines with 2 or 3 nodes, triangles with 3 or 6 nodes, \
     quadrilaterals with 4, 8 or 9 nodes";

fn fields(count: usize) -> String {
    if count == 1 {
        "1 field".into()
    } else {
        format!("{count} fields")
    }
}

impl Explain for ReadProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::NotText => "save the file in UTF-8, or use plain letters in the group names",
            Self::NotGmsh => {
                "in gmsh, save it as \"Version 4 ASCII\": gmsh FILE -save -format msh41 -o NEW.msh; \
                 meshes of BECAS are given by their folder"
            }
            Self::FileType(_) | Self::NumberSize(_) | Self::ByteOrder(_) => {
                "save it again with gmsh: gmsh FILE -save -format msh41 -o NEW.msh"
            }
            Self::Version(_) => "save it in version 4.1: gmsh FILE -save -format msh41 -o NEW.msh",
            Self::Partitioned => "in gmsh, Mesh > Unpartition, then save the mesh again",
            Self::NotClosed { section, .. } if !KNOWN_SECTIONS.contains(&section.as_str()) => {
                let name = nearest_name(section, KNOWN_SECTIONS)?;
                return Some(format!("did you mean \"{name}\"?"));
            }
            Self::NotClosed { found, .. } if found == END_OF_FILE => {
                "the file may have been cut off while it was written or copied"
            }
            Self::CountTooLarge { .. } | Self::CutOff(_) | Self::EndNotFound { .. } => {
                "the file may have been cut off, or the count is wrong"
            }
            Self::GroupNamedTwice { .. } => "give each physical group one name",
            Self::RepeatedCell { .. } => {
                "remove one of them: in gmsh, Mesh > Remove duplicate elements"
            }
            Self::UnsupportedElements { volume: true, .. } => {
                "mesh the section as a plane surface (gmsh -2) and save no volume"
            }
            Self::UnsupportedElements { .. } => "mesh with Mesh.ElementOrder = 1 or 2",
            _ => return None,
        };
        Some(help.into())
    }
}

/// The sections that are read.
pub(super) const KNOWN_SECTIONS: [&str; 6] = [
    "$MeshFormat",
    "$PhysicalNames",
    "$Entities",
    "$Nodes",
    "$ParametricNodes",
    "$Elements",
];

/// Text of the end of the file in [`ReadProblem::NotClosed`].
pub(super) const END_OF_FILE: &str = "the end of the file";

/// The problems found so far, each with its line or byte if it has one.
#[derive(Debug, Default)]
pub(super) struct Problems {
    found: Vec<(Option<usize>, ReadProblem)>,
    hidden: usize,
}

impl Problems {
    /// Adds the problem of a line, or of a byte offset of a binary file.
    pub(super) fn push(&mut self, at: usize, problem: ReadProblem) {
        self.add(Some(at), problem);
    }

    /// Adds a problem of the whole file.
    pub(super) fn push_whole(&mut self, problem: ReadProblem) {
        self.add(None, problem);
    }

    fn add(&mut self, at: Option<usize>, problem: ReadProblem) {
        if self.found.len() < LIMIT {
            self.found.push((at, problem));
        } else {
            self.hidden += 1;
        }
    }

    /// The problems in the order of their locations, problems of the whole file last;
    /// locations are bytes of a binary file, lines of a text file.
    pub(super) fn into_diagnostics(mut self, file: &str, binary: bool) -> Diagnostics {
        self.found.sort_by_key(|(at, _)| at.unwrap_or(usize::MAX));
        if self.hidden > 0 {
            self.found.push((None, ReadProblem::More(self.hidden)));
        }
        let mut diagnostics = Diagnostics::new();
        for (at, problem) in &self.found {
            let location = match at {
                Some(byte) if binary => SourceLocation::byte(file, *byte),
                Some(line) => SourceLocation::line(file, *line),
                None => SourceLocation::file(file),
            };
            diagnostics.push(location, problem);
        }
        diagnostics
    }
}
