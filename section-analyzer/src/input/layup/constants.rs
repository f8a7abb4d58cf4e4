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
/// the origins of its lines, with `help` in addition.
pub(super) fn checked(
    text: String,
    origins: &[Option<Origin>],
    help: &str,
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
            let line = problem.location.line.and_then(|line| origins.get(line - 1));
            let origin = line.or(origins.last()).cloned().flatten();
            problem.location.line = origin.as_ref().map(|origin| origin.1);
            if let Some((file, _)) = origin {
                problem.location.file = file.display().to_string();
            }
            problem.help = Some(match problem.help.take() {
                Some(own) => format!("{own}; {help}"),
                None => help.to_owned(),
            });
        })
    });
    problems.keep(rewritten).map(|()| text)
}
