//! The frame of a file: its sections, from `$Name` to `$EndName`.
//!
//! In a binary file these names, the physical names and the counts of version 2.2 are
//! lines of text as well; the rest is numbers, whose records follow each other without
//! gaps. If a record cannot be read, reading continues after the end of its section,
//! which is searched.

use super::cursor::Cursor;
use super::format::{Version, format, not_text};
use super::problem::{END_OF_FILE, KNOWN_SECTIONS, ReadProblem};
use super::reader::Reader;
use super::{names, read22, read41};
use crate::error::{Diagnostics, shortened};
use crate::mesh::Mesh;

/// Reads a file of either version and encoding.
pub(super) fn read(bytes: &[u8], file: &str) -> Result<Mesh, Diagnostics> {
    let mut reader = Reader::new(bytes);
    match format(&mut reader.cursor) {
        Ok(version) => match not_text(bytes, reader.cursor) {
            None => read_sections(&mut reader, version),
            Some(line) => reader.problems.push(line, ReadProblem::NotText),
        },
        Err(problem) => {
            let whole = matches!(problem, ReadProblem::Empty | ReadProblem::NotGmsh);
            if whole {
                reader.problems.push_whole(problem)
            } else {
                reader.problems.push(reader.cursor.location(), problem)
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
            reader.problems.push(reader.cursor.location(), problem);
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

/// Reads a section, whose first line has been read; returns whether another one may
/// follow.
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
                let at = reader.cursor.location();
                reader.problems.push(at, ReadProblem::Partitioned);
                reader.mesh.lose_entities();
            }
            return pass_section(reader, section, opened);
        }
    };
    let complete = reader.keep(outcome).is_some();
    let (exhausted, goes_on) = if reader.cursor.is_binary() {
        close_binary(reader, section, complete, opened)
    } else {
        (close_section(reader, section, complete), true)
    };
    match section {
        _ if exhausted => {}
        "$Entities" => reader.mesh.lose_entities(),
        "$Nodes" | "$ParametricNodes" => reader.mesh.lose_nodes(),
        _ => {}
    }
    goes_on
}

/// The problem of a line that should open a section.
fn not_a_section(line: &str) -> Option<ReadProblem> {
    if line.starts_with("$End") {
        return Some(ReadProblem::StrayEnd(shortened(line)));
    }
    (!line.starts_with('$')).then(|| ReadProblem::Outside(shortened(line)))
}

/// Moves to the end of a section that is not read; returns whether another one may
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
        reader.problems.push(opened.location(), problem);
    }
    found
}

/// Expects the end of a section of a binary file, whose reader has finished; returns
/// whether the section has the announced content, and whether it ends at all.
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
        reader.problems.push(reader.cursor.location(), problem);
    }
    reader.cursor = opened;
    (false, reader.cursor.pass_end(section))
}

/// Skips a section that is not read; its content may be anything except the beginning of
/// a section that is read or the end of another one.
fn skip_section(reader: &mut Reader, section: &str) {
    let opened = reader.cursor.location();
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

/// Expects the end of a section of a text, whose reader has finished; `complete` is
/// whether it has read all announced records. Returns whether the section has no further
/// content.
fn close_section(reader: &mut Reader, section: &str, complete: bool) -> bool {
    let left = reader.cursor.content();
    let exhausted = complete && left.is_none();
    if let Some(left) = left {
        if complete {
            let problem = ReadProblem::ContentLeft {
                section: section.to_string(),
                found: shortened(left),
            };
            reader.problems.push(reader.cursor.location(), problem);
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
    reader.problems.push(reader.cursor.location(), problem);
    // a line that opens another section is read as its beginning
    if line.is_some_and(|line| !line.starts_with("$End")) {
        reader.cursor = before;
    }
    exhausted
}
