//! The outcome of the analysis of one section.

use std::path::PathBuf;

use shared_geom::section::SectionProperties;

use crate::cli::{DONE, NOT_REACHED, WRONG_INPUT};

/// Outcome of the analysis of a section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::cli) enum Status {
    /// Solved, and all files written.
    Solved,
    /// Nothing has changed since the files were written.
    Unchanged,
    /// The strengths of materials alone have changed: its files name the new input, and it is not solved again.
    Renewed,
    /// Its mesh is sound; it is not solved.
    Sound,
    /// No solution, or not all files could be written.
    NotReached,
    /// The input is wrong.
    WrongInput,
}

impl Status {
    /// The exit code.
    pub fn code(self) -> u8 {
        match self {
            Self::Solved | Self::Unchanged | Self::Renewed | Self::Sound => DONE,
            Self::NotReached => NOT_REACHED,
            Self::WrongInput => WRONG_INPUT,
        }
    }

    /// The status as text.
    pub fn name(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Unchanged => "unchanged",
            Self::Renewed => "renewed",
            Self::Sound => "sound",
            Self::NotReached => "failed",
            Self::WrongInput => "wrong input",
        }
    }

    /// The heading of the list of files.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Unchanged => "Unchanged since the last run (--force solves again)",
            Self::Renewed => {
                "Written without solving again: strengths of materials alone have changed"
            }
            _ => "Written",
        }
    }
}

/// Complete result of the analysis of a section.
#[derive(Debug)]
pub(in crate::cli) struct Outcome {
    pub status: Status,
    /// The report, if it is shown.
    pub report: String,
    /// The result files.
    pub files: Vec<PathBuf>,
    /// Results of an earlier run that this run removed.
    pub removed: Vec<PathBuf>,
    /// The reported problems.
    pub problems: Option<String>,
    /// Nodes of the mesh, if it could be read.
    pub nodes: Option<usize>,
    /// The result, if it exists.
    pub properties: Option<SectionProperties>,
    /// Warnings about the input, which the report contains too.
    pub warnings: Vec<String>,
}

impl Outcome {
    /// An outcome of which only the status is known.
    pub fn new(status: Status) -> Self {
        Self {
            status,
            report: String::new(),
            files: Vec::new(),
            removed: Vec::new(),
            problems: None,
            nodes: None,
            properties: None,
            warnings: Vec::new(),
        }
    }

    /// Whether warnings are listed after all sections: of reports, and of sections that are not solved.
    pub fn lists_warnings(&self) -> bool {
        !self.report.is_empty() || self.status == Status::Sound
    }

    /// The problems; the warnings too, about the section shown as `label`, if they are to be
    /// reported or are not listed.
    pub fn messages(&self, label: &str, with_warnings: bool) -> Option<String> {
        let warnings = self.warnings.iter();
        let warnings = warnings.filter(|_| with_warnings || !self.lists_warnings());
        let warnings = warnings.map(|text| format!("warning: {label}: {text}"));
        let texts: Vec<_> = self.problems.iter().cloned().chain(warnings).collect();
        (!texts.is_empty()).then(|| texts.join("\n"))
    }

    pub(super) fn wrong_input(problems: String) -> Self {
        Self {
            problems: Some(problems),
            ..Self::new(Status::WrongInput)
        }
    }
}
