//! Kinds of input files by name or content, and the program that reads each kind.

use std::path::Path;

use crate::error::{Diagnostics, Explain, SourceLocation};
use crate::mesh_file;

/// A kind of input file of the two programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// A cross-section: mesh and materials.
    Section,
    /// A cross-section by matrices of another program.
    Matrices,
    /// A layup of a blade or of one section.
    Layup,
    /// A mesh.
    Mesh,
    /// A cross-section of VABS or BECAS, which no name shows.
    Model,
    /// A model of the dynamics.
    Dynamics,
    /// A blade: sections along a line.
    Blade,
    /// A rigid rotor and its operating points.
    Rotor,
    /// Properties of a solved section.
    Properties,
    /// The state at the end of a run in time.
    Restart,
}

/// The ending of layup files.
pub const LAYUP_ENDING: &str = ".layup.toml";

/// Kinds by the ending of the file name.
const ENDINGS: [(&str, FileKind); 9] = [
    (".section.toml", FileKind::Section),
    (".matrices.toml", FileKind::Matrices),
    (LAYUP_ENDING, FileKind::Layup),
    (".dynamics.toml", FileKind::Dynamics),
    (".rotor.toml", FileKind::Rotor),
    (".blade.toml", FileKind::Blade),
    (".blade.json", FileKind::Blade),
    (".properties.json", FileKind::Properties),
    (".restart.json", FileKind::Restart),
];
/// The ending of meshes that files of BeamDyn have too.
const SHARED_ENDING: &str = ".inp";
/// Kinds by the first line of the text.
const HEADS: [(&str, FileKind); 2] = [
    ("$MeshFormat", FileKind::Mesh),
    ("# vtk DataFile", FileKind::Mesh),
];
/// Kinds of a JSON file with another name by the value of its key `format`.
const FORMATS: [(&str, FileKind); 2] = [
    ("\"helicoid section properties\"", FileKind::Properties),
    ("\"helicoid blade\"", FileKind::Blade),
];
/// Letters at the beginning of a JSON file that hold its key `format`.
const HEAD: usize = 200;
/// Kinds of a TOML file with another name by the start of a line; a key without a table is at
/// the top of the file.
const LINES: [(&str, FileKind); 5] = [
    ("frame =", FileKind::Blade),
    ("reference_point =", FileKind::Blade),
    ("[[station]]", FileKind::Blade),
    ("[stations]", FileKind::Blade),
    ("[[region]]", FileKind::Section),
];

impl FileKind {
    /// The kind of the file at `path` with the content `text`; `None` if neither its name nor
    /// its content shows it.
    pub fn of(path: &Path, text: &str) -> Option<Self> {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let by_name = || first(&ENDINGS, |ending| name.ends_with(ending));
        let by_line = || {
            if name.ends_with(".toml") {
                first(&LINES, |mark| has_line(text, mark))
            } else {
                None
            }
        };
        let by_format = || {
            let head: String = text.chars().take(HEAD).collect();
            if name.ends_with(".json") {
                first(&FORMATS, |format| head.contains(format))
            } else {
                None
            }
        };
        let is_shared = || name.to_lowercase().ends_with(SHARED_ENDING);
        let by_mesh = || (mesh_file::has_ending(&name) && !is_shared()).then_some(Self::Mesh);
        first(&HEADS, |head| text.starts_with(head))
            .or_else(by_name)
            .or_else(by_mesh)
            .or_else(by_line)
            .or_else(by_format)
    }

    /// Checks that the file at `path` with the content `text` is not of another kind than
    /// `self`.
    ///
    /// # Errors
    /// A file of another kind, with the program that reads it.
    pub fn require(self, path: &Path, text: &str) -> Result<(), Diagnostics> {
        match Self::of(path, text) {
            Some(found) if !self.accepts(found, text) => {
                let location = SourceLocation::file(path.display().to_string());
                let problem = OtherKind {
                    found,
                    expected: self,
                };
                Err(Diagnostics::one(location, &problem))
            }
            _ => Ok(()),
        }
    }

    /// Whether a reader of this kind reads a file of another one with the content `text` too: a
    /// property file is a uniform blade, and models have endings of meshes.
    fn accepts(self, other: Self, text: &str) -> bool {
        match (self, other) {
            (Self::Blade, Self::Properties) => true,
            (Self::Model, Self::Mesh) => first(&HEADS, |head| text.starts_with(head)).is_none(),
            _ => self == other,
        }
    }

    /// The kind with its article.
    pub fn words(self) -> &'static str {
        match self {
            Self::Section => "a section file",
            Self::Matrices => "a matrices file",
            Self::Layup => "a layup",
            Self::Mesh => "a mesh",
            Self::Model => "a section of VABS or BECAS",
            Self::Dynamics => "a dynamics file",
            Self::Blade => "a blade file",
            Self::Rotor => "a rotor file",
            Self::Properties => "a property file of a section",
            Self::Restart => "a restart file",
        }
    }
}

/// The kind of the first mark that a file has.
fn first(kinds: &[(&str, FileKind)], has: impl Fn(&str) -> bool) -> Option<FileKind> {
    let found = kinds.iter().find(|(mark, _)| has(mark));
    found.map(|found| found.1)
}

/// Whether a line of a TOML file starts with `mark`: anywhere if it is the head of a table,
/// else before the first table.
fn has_line(text: &str, mark: &str) -> bool {
    let lines = text.lines().map(str::trim_start);
    let is_head = |line: &&str| line.starts_with('[');
    if is_head(&mark) {
        lines.filter(is_head).any(|line| line.starts_with(mark))
    } else {
        let squeezed = |line: &str| line.replace(' ', "");
        let mut top = lines.take_while(|line| !is_head(line));
        top.any(|line| squeezed(line).starts_with(&squeezed(mark)))
    }
}

/// A file of another kind.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("this is {}, expected {}", .found.words(), .expected.words())]
struct OtherKind {
    found: FileKind,
    expected: FileKind,
}

impl Explain for OtherKind {
    fn help(&self) -> Option<String> {
        let text = match (self.found, self.expected) {
            (FileKind::Section, _) => "use \"section-analyzer analyze\"",
            (FileKind::Matrices, _) => "use \"section-analyzer matrices\"",
            (FileKind::Layup, _) => {
                "use \"section-analyzer blade\", or \"section-analyzer mesh layup\" for one section"
            }
            (FileKind::Model, _) => "use \"section-analyzer convert\"",
            (FileKind::Mesh, _) => {
                "name the mesh in a section file, NAME.section.toml, for section-analyzer"
            }
            (FileKind::Dynamics, FileKind::Blade) => {
                "use \"beam-dynamics check\", \"modes\", \"static\" or \"transient\""
            }
            (FileKind::Dynamics, _) => "use \"beam-dynamics\"",
            (FileKind::Rotor, _) => "use \"beam-dynamics performance\"",
            (FileKind::Properties, _) => {
                "name it in [properties.NAME] of a dynamics file, or as a station of a blade file"
            }
            (FileKind::Restart, _) => "use \"beam-dynamics transient\" with --restart",
            (FileKind::Blade, FileKind::Dynamics) => {
                "call it NAME.blade.toml: \"beam-dynamics modes\" then reads it, and so does \
                 [[blade]] of a dynamics file"
            }
            (FileKind::Blade, _) => {
                "use \"beam-dynamics\", or \"section-analyzer mesh blade\" for the shape of a \
                 section"
            }
        };
        Some(text.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_found_by_name_and_content() {
        for (name, text, kind) in [
            ("a/x.section.toml", "", Some(FileKind::Section)),
            ("x.matrices.toml", "", Some(FileKind::Matrices)),
            ("x.blade.json", "{", Some(FileKind::Blade)),
            (
                "x.json",
                "{\n  \"format\": \"helicoid section properties\",",
                Some(FileKind::Properties),
            ),
            ("x.restart.json", "{", Some(FileKind::Restart)),
            ("x.dat", "$MeshFormat\n4.1 0 8\n", Some(FileKind::Mesh)),
            (
                "x.toml",
                "units = \"SI\"\nframe=\"helicoid\"\n",
                Some(FileKind::Blade),
            ),
            (
                "x.toml",
                "units = \"SI\"\n[[station]]\n",
                Some(FileKind::Blade),
            ),
            (
                "x.toml",
                "[[region]]\ngroup = \"a\"\n",
                Some(FileKind::Section),
            ),
            // a key of another table, and a comment
            ("x.toml", "[[node]]\nframe = \"hub\"\n", None),
            ("x.toml", "# [[station]]\n[[blade]]\n", None),
            ("x.dat", "[[station]]\n", None),
        ] {
            assert_eq!(FileKind::of(Path::new(name), text), kind, "{name}: {text}");
        }
    }

    #[test]
    fn the_right_program_is_named() {
        let shown = |expected: FileKind, name: &str, text: &str| {
            let result = expected.require(Path::new(name), text);
            result.unwrap_err().to_string()
        };
        let shown_model = |name: &str, text: &str| {
            let result = FileKind::Model.require(Path::new(name), text);
            result.err().map(|problem| problem.to_string())
        };
        assert_eq!(
            shown(FileKind::Dynamics, "r.section.toml", ""),
            "error: r.section.toml: this is a section file, expected a dynamics file\n  \
             help: use \"section-analyzer analyze\""
        );
        assert_eq!(
            shown(FileKind::Section, "b.blade.toml", ""),
            "error: b.blade.toml: this is a blade file, expected a section file\n  \
             help: use \"beam-dynamics\", or \"section-analyzer mesh blade\" for the shape of a \
             section"
        );
        assert_eq!(shown_model("x.sg", "1 0 0\n"), None);
        let shown = shown_model("x.msh", "$MeshFormat\n").unwrap();
        assert!(
            shown.contains("this is a mesh, expected a section of VABS"),
            "{shown}"
        );
        let kinds = [
            FileKind::Section,
            FileKind::Matrices,
            FileKind::Layup,
            FileKind::Dynamics,
            FileKind::Blade,
            FileKind::Rotor,
            FileKind::Properties,
            FileKind::Restart,
        ];
        let meshes = mesh_file::ENDINGS
            .into_iter()
            .filter(|ending| *ending != SHARED_ENDING);
        let meshes = meshes.map(|ending| (ending, FileKind::Mesh));
        for (ending, own) in ENDINGS.into_iter().chain(meshes) {
            for kind in kinds {
                let accepted = kind.require(Path::new(&format!("x{ending}")), "");
                assert_eq!(
                    accepted.is_ok(),
                    kind.accepts(own, ""),
                    "{ending}: {kind:?}"
                );
            }
        }
    }
}
