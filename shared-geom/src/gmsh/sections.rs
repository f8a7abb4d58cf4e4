//! The frame of a file: format line, sections from `$Name` to `$EndName`.

use super::build::MeshBuilder;
use super::cursor::{Fields, LineCursor};
use super::problem::{END_OF_FILE, KNOWN_SECTIONS, Problems, ReadProblem};
use super::{read22, read41};
use crate::error::Diagnostics;
use crate::mesh::{Mesh, PhysicalGroup};

/// A version of the format that is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    V22,
    V41,
}

/// What the readers of the sections share.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    pub(super) cursor: LineCursor<'a>,
    pub(super) mesh: MeshBuilder,
    pub(super) problems: Problems,
}

/// How the reader of a section ended: an error is one after which the rest of
/// the section cannot be understood. It belongs to the line taken last.
pub(super) type Outcome = Result<(), ReadProblem>;

impl<'a> Reader<'a> {
    /// The next line of a section that announces `announced` of `what` and has
    /// given `found` so far.
    pub(super) fn item(
        &mut self,
        what: &'static str,
        announced: usize,
        found: usize,
    ) -> Result<&'a str, ReadProblem> {
        self.cursor.content().ok_or(ReadProblem::CountMismatch {
            what,
            announced: announced as u64,
            found: found as u64,
        })
    }

    /// The line with the counts that opens a section.
    pub(super) fn header(&mut self, expected: &'static str) -> Result<Fields<'a>, ReadProblem> {
        let line = self
            .cursor
            .content()
            .ok_or(ReadProblem::FieldCount { expected, found: 0 })?;
        Ok(Fields::new(line, expected))
    }

    /// A count of things that take at least `least_bytes` each: never more than
    /// the rest of the file can hold, so that room can be made for them.
    pub(super) fn count(
        &self,
        fields: &mut Fields,
        what: &'static str,
        least_bytes: usize,
    ) -> Result<usize, ReadProblem> {
        let count: u64 = fields.number(what)?;
        match usize::try_from(count) {
            Ok(fitting) if fitting <= self.cursor.remaining() / least_bytes => Ok(fitting),
            _ => Err(ReadProblem::CountTooLarge { what, count }),
        }
    }

    /// Keeps the problem of the current line, if there is one, and goes on.
    pub(super) fn keep<T>(&mut self, result: Result<T, ReadProblem>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(problem) => {
                self.problems.push(self.cursor.number(), problem);
                None
            }
        }
    }
}

/// Reads a file of either version.
pub(super) fn read(text: &str, file: &str) -> Result<Mesh, Diagnostics> {
    let mut reader = Reader {
        cursor: LineCursor::new(text),
        mesh: MeshBuilder::default(),
        problems: Problems::default(),
    };
    match format(text) {
        Ok(version) => read_sections(&mut reader, version),
        Err((0, problem)) => reader.problems.push_whole(problem),
        Err((line, problem)) => reader.problems.push(line, problem),
    }
    let mesh = reader.mesh.finish(&mut reader.problems);
    reader.problems.into_diagnostics(file).into_result(mesh)
}

/// The version of a file; else the problem and its line, 0 for the whole file.
pub(super) fn format(text: &str) -> Result<Version, (usize, ReadProblem)> {
    let mut cursor = LineCursor::new(text);
    if cursor.remaining() == 0 {
        return Err((0, ReadProblem::Empty));
    }
    while let Some(line) = cursor.line() {
        if line == "$MeshFormat" {
            let line = cursor.content().unwrap_or("");
            return format_line(line).map_err(|problem| (cursor.number(), problem));
        }
    }
    Err((0, ReadProblem::NotGmsh))
}

/// Reads `4.1 0 8`: version, file type (0 ascii, 1 binary), bytes of a number.
fn format_line(line: &str) -> Result<Version, ReadProblem> {
    let mut fields = Fields::new(line, "version, file type and number size, as \"4.1 0 8\"");
    let version = fields.text()?;
    let file_type = fields.text()?;
    let _size: u32 = fields.number("number size")?;
    fields.end()?;
    match (version, file_type) {
        (_, "1") => Err(ReadProblem::Binary),
        ("2.2", "0") => Ok(Version::V22),
        ("4.1", "0") => Ok(Version::V41),
        (_, "0") => Err(ReadProblem::Version(version.to_string())),
        _ => Err(ReadProblem::FileType(file_type.to_string())),
    }
}

fn read_sections(reader: &mut Reader, version: Version) {
    let mut nodes_found = false;
    let mut elements_found = false;
    while let Some(line) = reader.cursor.line() {
        if let Some(problem) = not_a_section(line) {
            reader.problems.push(reader.cursor.number(), problem);
            while reader.cursor.content().is_some() {}
            continue;
        }
        nodes_found |= line == "$Nodes" || line == "$ParametricNodes";
        elements_found |= line == "$Elements";
        let outcome = match (line, version) {
            ("$PhysicalNames", _) => read_physical_names(reader),
            ("$Nodes", Version::V22) => read22::read_nodes(reader, false),
            ("$ParametricNodes", Version::V22) => read22::read_nodes(reader, true),
            ("$Elements", Version::V22) => read22::read_elements(reader),
            ("$Entities", Version::V41) => read41::read_entities(reader),
            ("$Nodes", Version::V41) => read41::read_nodes(reader),
            ("$Elements", Version::V41) => read41::read_elements(reader),
            _ => {
                if line == "$PartitionedEntities" {
                    let at = reader.cursor.number();
                    reader.problems.push(at, ReadProblem::Partitioned);
                    reader.mesh.lose_entities();
                }
                skip_section(reader, line);
                continue;
            }
        };
        let complete = reader.keep(outcome).is_some();
        let exhausted = close_section(reader, line, complete);
        match line {
            _ if exhausted => {}
            "$Entities" => reader.mesh.lose_entities(),
            "$Nodes" | "$ParametricNodes" => reader.mesh.lose_nodes(),
            _ => {}
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

/// What is wrong with a line that should open a section.
fn not_a_section(line: &str) -> Option<ReadProblem> {
    if line.starts_with("$End") {
        return Some(ReadProblem::StrayEnd(shortened(line)));
    }
    (!line.starts_with('$')).then(|| ReadProblem::Outside(shortened(line)))
}

/// Passes over a section that is not read; its content may hold anything but
/// the beginning of a section that is read or the end of another one.
fn skip_section(reader: &mut Reader, section: &str) {
    let opened = reader.cursor.number();
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

/// Expects the end of a section whose reader has come to an end; `complete`
/// tells whether it has read all that the section announces. Gives whether that
/// is all that the section holds.
fn close_section(reader: &mut Reader, section: &str, complete: bool) -> bool {
    let left = reader.cursor.content();
    let exhausted = complete && left.is_none();
    if let Some(left) = left {
        if complete {
            let problem = ReadProblem::ContentLeft {
                section: section.to_string(),
                found: shortened(left),
            };
            reader.problems.push(reader.cursor.number(), problem);
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
    reader.problems.push(reader.cursor.number(), problem);
    // a line that opens another section is read as such
    if line.is_some_and(|line| !line.starts_with("$End")) {
        reader.cursor = before;
    }
    exhausted
}

/// The beginning of a line, for messages.
fn shortened(line: &str) -> String {
    const LETTERS: usize = 40;
    match line.char_indices().nth(LETTERS) {
        Some((end, _)) => format!("{}...", &line[..end]),
        None => line.to_string(),
    }
}

/// Reads the names: a count, then a line `dimension tag "name"` each.
fn read_physical_names(reader: &mut Reader) -> Outcome {
    const LEAST_BYTES: usize = 7;
    let mut fields = reader.header("the number of physical names")?;
    let count = reader.count(&mut fields, "physical names", LEAST_BYTES)?;
    fields.end()?;
    for found in 0..count {
        let line = reader.item("physical names", count, found)?;
        let group = physical_name(line).and_then(|group| reader.mesh.named_group(group));
        reader.keep(group);
    }
    Ok(())
}

/// Reads `2 1 "skin of the spar"`.
fn physical_name(line: &str) -> Result<PhysicalGroup, ReadProblem> {
    let (before, quoted) = line.split_once('"').ok_or(ReadProblem::NoName)?;
    let name = quoted.strip_suffix('"').ok_or(ReadProblem::NoName)?;
    let mut fields = Fields::new(before, "dimension, tag and the name in double quotes");
    let dimension: u32 = fields.number("dimension")?;
    let tag: i32 = fields.number("physical tag")?;
    fields.end()?;
    Ok(PhysicalGroup {
        dimension: dimension_of(dimension, 3)?,
        tag: tag.saturating_abs(),
        name: Some(name.to_string()),
    })
}

/// A dimension, at most `largest`.
pub(super) fn dimension_of(found: u32, largest: u8) -> Result<u8, ReadProblem> {
    u8::try_from(found)
        .ok()
        .filter(|&dimension| dimension <= largest)
        .ok_or(ReadProblem::Dimension(found))
}
