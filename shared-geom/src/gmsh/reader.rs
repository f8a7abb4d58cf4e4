//! The records of a section, and the common state of the readers of all sections.

use super::build::MeshBuilder;
use super::cursor::Cursor;
use super::fields::{Fields, LineFields};
use super::problem::{KNOWN_SECTIONS, Problems, ReadProblem};

/// Common state of the readers of the sections.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    pub(super) cursor: Cursor<'a>,
    pub(super) mesh: MeshBuilder,
    pub(super) problems: Problems,
    /// Sections that have been read.
    seen: Vec<&'static str>,
}

/// End of the reading of a section: an error is one after which the rest of the section
/// cannot be read. Its location is the last item read.
pub(super) type Outcome = Result<(), ReadProblem>;

/// Progress of the reading of a section, for messages.
#[derive(Debug, Clone, Copy)]
pub(super) struct Progress {
    pub(super) what: &'static str,
    pub(super) announced: usize,
    pub(super) found: usize,
}

impl<'a> Reader<'a> {
    /// A reader at the beginning of `bytes`.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            cursor: Cursor::new(bytes),
            mesh: MeshBuilder::default(),
            problems: Problems::default(),
            seen: Vec::new(),
        }
    }

    /// Whether a section has been read before, which is reported. Without this a binary
    /// file could have the same bytes read in each of many sections.
    pub(super) fn is_repeated(&mut self, section: &str) -> bool {
        let known = KNOWN_SECTIONS.into_iter().find(|known| *known == section);
        let Some(known) = known else {
            return false;
        };
        let repeated = self.seen.contains(&known);
        if repeated {
            let problem = ReadProblem::RepeatedSection(known);
            self.problems.push(self.cursor.location(), problem);
        } else {
            self.seen.push(known);
        }
        repeated
    }

    /// Keeps the problem of the current record, if there is one, and continues.
    pub(super) fn keep<T>(&mut self, result: Result<T, ReadProblem>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(problem) => {
                self.problems.push(self.cursor.location(), problem);
                None
            }
        }
    }

    /// As [`Reader::keep`], but for problems that `is_last` accepts, after which the rest
    /// of the section cannot be read, and for the end of the file.
    pub(super) fn keep_unless<T>(
        &mut self,
        result: Result<T, ReadProblem>,
        is_last: impl Fn(&ReadProblem) -> bool,
    ) -> Result<Option<T>, ReadProblem> {
        match result {
            Err(problem) if is_last(&problem) || matches!(problem, ReadProblem::CutOff(_)) => {
                Err(problem)
            }
            result => Ok(self.keep(result)),
        }
    }
}

/// The next record of a section; in a text it may be missing.
pub(super) fn item<'r, 'a>(
    cursor: &'r mut Cursor<'a>,
    progress: Progress,
    expected: &'static str,
) -> Result<Fields<'r, 'a>, ReadProblem> {
    let missing = ReadProblem::CountMismatch {
        what: progress.what,
        announced: progress.announced as u64,
        found: progress.found as u64,
    };
    record(cursor, expected).ok_or(missing)
}

/// The record with the counts at the beginning of a section.
pub(super) fn header<'r, 'a>(
    cursor: &'r mut Cursor<'a>,
    expected: &'static str,
) -> Result<Fields<'r, 'a>, ReadProblem> {
    let missing = ReadProblem::FieldCount { expected, found: 0 };
    record(cursor, expected).ok_or(missing)
}

/// The line with a count at the beginning of a section, in binary files too.
pub(super) fn line_header<'a>(
    cursor: &mut Cursor<'a>,
    expected: &'static str,
) -> Result<LineFields<'a>, ReadProblem> {
    let missing = ReadProblem::FieldCount { expected, found: 0 };
    let line = cursor.content().ok_or(missing)?;
    Ok(LineFields::new(line, expected, cursor.remaining()))
}

fn record<'r, 'a>(cursor: &'r mut Cursor<'a>, expected: &'static str) -> Option<Fields<'r, 'a>> {
    if cursor.is_binary() {
        cursor.begin();
        return Some(Fields::Bytes { cursor, expected });
    }
    let line = cursor.content()?;
    let remaining = cursor.remaining();
    Some(Fields::Line(LineFields::new(line, expected, remaining)))
}

/// A dimension, at most `largest`.
pub(super) fn dimension_of(found: u64, largest: u8) -> Result<u8, ReadProblem> {
    u8::try_from(found)
        .ok()
        .filter(|&dimension| dimension <= largest)
        .ok_or(ReadProblem::Dimension(found))
}
