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
