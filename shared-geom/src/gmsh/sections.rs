//! The frame of a file: its sections, from `$Name` to `$EndName`.
//!
//! In a binary file these names, the physical names and the counts of version 2.2
//! are lines of text as well; the rest is numbers, whose records begin where the
//! one before ends. Where a record cannot be understood, reading goes on behind
//! the end of its section, which is searched for.

use super::build::MeshBuilder;
use super::cursor::Cursor;
use super::fields::{Fields, LineFields};
use super::format::{Version, format, not_text};
use super::problem::{END_OF_FILE, KNOWN_SECTIONS, Problems, ReadProblem, shortened};
use super::{names, read22, read41};
use crate::error::Diagnostics;
use crate::mesh::Mesh;

/// What the readers of the sections share.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    pub(super) cursor: Cursor<'a>,
    pub(super) mesh: MeshBuilder,
    pub(super) problems: Problems,
    /// Sections that have been read.
    seen: Vec<&'static str>,
}

/// How the reader of a section ended: an error is one after which the rest of
/// the section cannot be understood. It belongs to what was taken last.
pub(super) type Outcome = Result<(), ReadProblem>;

/// How far the reading of a section has come, for messages.
#[derive(Debug, Clone, Copy)]
pub(super) struct Progress {
    pub(super) what: &'static str,
    pub(super) announced: usize,
    pub(super) found: usize,
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

/// The record with the counts that opens a section.
pub(super) fn header<'r, 'a>(
    cursor: &'r mut Cursor<'a>,
    expected: &'static str,
) -> Result<Fields<'r, 'a>, ReadProblem> {
    let missing = ReadProblem::FieldCount { expected, found: 0 };
    record(cursor, expected).ok_or(missing)
}

/// The line with a count that opens a section, in binary files too.
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

impl Reader<'_> {
    /// Whether a section that is read has been read before, which is told. Without
    /// this a binary file could have the same bytes read in each of many sections.
    fn is_repeated(&mut self, section: &str) -> bool {
        let known = KNOWN_SECTIONS.into_iter().find(|known| *known == section);
        let Some(known) = known else {
            return false;
        };
        let repeated = self.seen.contains(&known);
        if repeated {
            let problem = ReadProblem::RepeatedSection(known);
            self.problems.push(self.cursor.place(), problem);
        } else {
            self.seen.push(known);
        }
        repeated
    }

    /// Keeps the problem of the current record, if there is one, and goes on.
    pub(super) fn keep<T>(&mut self, result: Result<T, ReadProblem>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(problem) => {
                self.problems.push(self.cursor.place(), problem);
                None
            }
        }
    }

    /// As [`Reader::keep`], but for problems that `is_last` takes, after which the
    /// rest of the section cannot be understood, and for the end of the file.
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

/// Reads a file of either version and encoding.
pub(super) fn read(bytes: &[u8], file: &str) -> Result<Mesh, Diagnostics> {
    let mut reader = Reader {
        cursor: Cursor::new(bytes),
        mesh: MeshBuilder::default(),
        problems: Problems::default(),
        seen: Vec::new(),
    };
    match format(&mut reader.cursor) {
        Ok(version) => match not_text(bytes, reader.cursor) {
            None => read_sections(&mut reader, version),
            Some(line) => reader.problems.push(line, ReadProblem::NotText),
        },
        Err(problem) => {
            let whole = matches!(problem, ReadProblem::Empty | ReadProblem::NotGmsh);
            match whole {
                true => reader.problems.push_whole(problem),
                false => reader.problems.push(reader.cursor.place(), problem),
            }
        }
    }
    let Reader {
        cursor,
        mesh,
        mut problems,
        ..
    } = reader;
    let mesh = mesh.finish(&mut problems);
    let diagnostics = problems.into_diagnostics(file, cursor.is_binary());
    diagnostics.into_result(mesh)
}

fn read_sections(reader: &mut Reader, version: Version) {
    let mut nodes_found = false;
    let mut elements_found = false;
    while let Some(line) = reader.cursor.line() {
        if let Some(problem) = not_a_section(line) {
            reader.problems.push(reader.cursor.place(), problem);
            while reader.cursor.content().is_some() {}
            continue;
        }
        nodes_found |= line == "$Nodes" || line == "$ParametricNodes";
        elements_found |= line == "$Elements";
        if !read_section(reader, version, line) {
            break;
        }
    }
    for (found, section) in [(nodes_found, "$Nodes"), (elements_found, "$Elements")] {
        if !found {
            reader
                .problems
                .push_whole(ReadProblem::MissingSection(section));
        }
    }
    if !nodes_found {
        reader.mesh.lose_nodes();
    }
}

/// Reads a section, whose first line has been taken; gives whether another one
/// may follow.
fn read_section(reader: &mut Reader, version: Version, section: &str) -> bool {
    let opened = reader.cursor;
    if reader.is_repeated(section) {
        return pass_section(reader, section, opened);
    }
    let outcome = match (section, version) {
        ("$PhysicalNames", _) => names::read(reader),
        ("$Nodes", Version::V22) => read22::read_nodes(reader, false),
        ("$ParametricNodes", Version::V22) => read22::read_nodes(reader, true),
        ("$Elements", Version::V22) => read22::read_elements(reader),
        ("$Entities", Version::V41) => read41::read_entities(reader),
        ("$Nodes", Version::V41) => read41::read_nodes(reader),
        ("$Elements", Version::V41) => read41::read_elements(reader),
        _ => {
            if section == "$PartitionedEntities" {
                let at = reader.cursor.place();
                reader.problems.push(at, ReadProblem::Partitioned);
                reader.mesh.lose_entities();
            }
            return pass_section(reader, section, opened);
        }
    };
    let complete = reader.keep(outcome).is_some();
    let (exhausted, goes_on) = match reader.cursor.is_binary() {
        true => close_binary(reader, section, complete, opened),
        false => (close_section(reader, section, complete), true),
    };
    match section {
        _ if exhausted => {}
        "$Entities" => reader.mesh.lose_entities(),
        "$Nodes" | "$ParametricNodes" => reader.mesh.lose_nodes(),
        _ => {}
    }
    goes_on
}

/// What is wrong with a line that should open a section.
fn not_a_section(line: &str) -> Option<ReadProblem> {
    if line.starts_with("$End") {
        return Some(ReadProblem::StrayEnd(shortened(line)));
    }
    (!line.starts_with('$')).then(|| ReadProblem::Outside(shortened(line)))
}

/// Goes behind the end of a section that is not read; gives whether another one may
/// follow.
fn pass_section<'a>(reader: &mut Reader<'a>, section: &str, opened: Cursor<'a>) -> bool {
    if !reader.cursor.is_binary() {
        skip_section(reader, section);
        return true;
    }
    reader.cursor = opened;
    let found = reader.cursor.pass_end(section);
    if !found {
        let problem = ReadProblem::NotClosed {
            section: shortened(section),
            found: END_OF_FILE.to_string(),
        };
        reader.problems.push(opened.place(), problem);
    }
    found
}

/// Expects the end of a section of a binary file, whose reader has come to an end;
/// gives whether the section holds what it announces, and whether it ends at all.
fn close_binary<'a>(
    reader: &mut Reader<'a>,
    section: &str,
    complete: bool,
    opened: Cursor<'a>,
) -> (bool, bool) {
    if complete {
        let line = reader.cursor.line().unwrap_or_default();
        if line.strip_prefix("$End") == section.strip_prefix('$') {
            return (true, true);
        }
        let problem = ReadProblem::EndNotFound {
            section: section.to_string(),
        };
        reader.problems.push(reader.cursor.place(), problem);
    }
    reader.cursor = opened;
    (false, reader.cursor.pass_end(section))
}

/// Passes over a section that is not read; its content may hold anything but
/// the beginning of a section that is read or the end of another one.
fn skip_section(reader: &mut Reader, section: &str) {
    let opened = reader.cursor.place();
    let mut before = reader.cursor;
    let mut found = END_OF_FILE.to_string();
    while let Some(line) = reader.cursor.line() {
        let end = line.strip_prefix("$End");
        if end.is_some() && end == section.strip_prefix('$') {
            return;
        }
        if end.is_some() || KNOWN_SECTIONS.contains(&line) {
            found = format!("\"{}\"", shortened(line));
            if end.is_none() {
                reader.cursor = before;
            }
            break;
        }
        before = reader.cursor;
    }
    let section = shortened(section);
    let problem = ReadProblem::NotClosed { section, found };
    reader.problems.push(opened, problem);
}

/// Expects the end of a section of a text, whose reader has come to an end;
/// `complete` tells whether it has read all that the section announces. Gives
/// whether that is all that the section holds.
fn close_section(reader: &mut Reader, section: &str, complete: bool) -> bool {
    let left = reader.cursor.content();
    let exhausted = complete && left.is_none();
    if let Some(left) = left {
        if complete {
            let problem = ReadProblem::ContentLeft {
                section: section.to_string(),
                found: shortened(left),
            };
            reader.problems.push(reader.cursor.place(), problem);
        }
        while reader.cursor.content().is_some() {}
    }
    let before = reader.cursor;
    let line = reader.cursor.line();
    if line.and_then(|line| line.strip_prefix("$End")) == section.strip_prefix('$') {
        return exhausted;
    }
    let found = match line {
        Some(line) => format!("\"{}\"", shortened(line)),
        None => END_OF_FILE.to_string(),
    };
    let problem = ReadProblem::NotClosed {
        section: section.to_string(),
        found,
    };
    reader.problems.push(reader.cursor.place(), problem);
    // a line that opens another section is read as such
    if line.is_some_and(|line| !line.starts_with("$End")) {
        reader.cursor = before;
    }
    exhausted
}

/// A dimension, at most `largest`.
pub(super) fn dimension_of(found: u64, largest: u8) -> Result<u8, ReadProblem> {
    u8::try_from(found)
        .ok()
        .filter(|&dimension| dimension <= largest)
        .ok_or(ReadProblem::Dimension(found))
}
