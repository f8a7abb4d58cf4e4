//! Tables of materials that readers of other tools' files write, and their check.

use std::path::PathBuf;

use shared_geom::document::Document;
use shared_geom::exchange::problem::Problems;

use super::super::materials;

/// Name of the text of the materials in messages, which are rewritten.
const TEXT: &str = "materials of the file";

/// A file and a line.
pub(super) type Origin = (PathBuf, usize);

/// A text of units and materials whose constants are possible; notes the problems of others at
/// the origins of its lines, with the `help` for a row of the text in addition.
pub(super) fn checked(
    text: String,
    origins: &[Option<Origin>],
    help: fn(&str) -> Option<&str>,
    problems: &mut Problems,
) -> Option<String> {
    let found = Document::parse(&text, TEXT).and_then(|document| {
        let root = document.root();
        document.declare_units(&root);
        let _ = materials::read(&root);
        document.finish(Some(()))
    });
    let rewritten = found.map_err(|problems| {
        problems.rewritten(TEXT, |problem| {
            let row = problem.location.line.map(|line| line - 1);
            let origin = row.and_then(|row| origins.get(row));
            let origin = origin.or(origins.last()).cloned().flatten();
            let more = row.and_then(|row| text.lines().nth(row)).and_then(help);
            problem.location.line = origin.as_ref().map(|origin| origin.1);
            if let Some((file, _)) = origin {
                problem.location.file = file.display().to_string();
            }
            problem.help = match (problem.help.take(), more) {
                (Some(own), Some(more)) => Some(format!("{own}; {more}")),
                (own, more) => own.or(more.map(str::to_owned)),
            };
        })
    });
    problems.keep(rewritten).map(|()| text)
}

/// The lines of the tables of units and materials, and of a word of units at the top; without comments
/// and blank lines, but for one before each table, so that they do not change fingerprints.
pub(super) fn constants(text: &str) -> String {
    let mut kept = String::new();
    let (mut is_kept, mut is_top) = (false, true);
    for line in text.lines().map(str::trim) {
        let name = table_name(line);
        if let Some(name) = name {
            is_top = false;
            is_kept = name.starts_with("material") || name.starts_with("units");
        }
        let is_empty = line.is_empty() || line.starts_with('#');
        if !is_empty && (is_kept || (is_top && line.starts_with("units"))) {
            if name.is_some() && !kept.is_empty() {
                kept.push('\n');
            }
            kept.push_str(line);
            kept.push('\n');
        }
    }
    kept
}

/// The name in the head of a table; `None` for other lines, such as the rows of a matrix.
pub fn table_name(line: &str) -> Option<&str> {
    let name = line.trim_start().strip_prefix('[')?;
    let name = name.trim_start_matches('[').trim_start();
    name.starts_with(|letter: char| letter.is_ascii_alphabetic())
        .then_some(name)
}
