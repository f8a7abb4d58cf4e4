//! Section models of VABS and BECAS, which become section files.

use std::path::Path;

use shared_geom::document::read_text;
use shared_geom::error::Diagnostics;
use shared_geom::file_kind::FileKind;
use shared_geom::mesh_file::{Model, becas_files, read_becas, read_vabs};

/// Reads the section model at `path`: a folder of BECAS, or an input file of VABS.
///
/// # Errors
/// All problems of its files, each with its line.
pub fn read(path: &Path) -> Result<Model, Diagnostics> {
    let Some(files) = becas_files(path) else {
        let text = read_text(path)?;
        FileKind::Model.require(path, &text)?;
        return read_vabs(text.as_bytes(), &path.display().to_string());
    };
    let mut problems = Diagnostics::new();
    let files = files.map(|file| {
        let text = problems.keep(read_text(&file)).unwrap_or_default();
        (file.display().to_string(), text)
    });
    let read = problems.into_result(());
    read?;
    read_becas(
        files
            .each_ref()
            .map(|(file, text)| (file.as_str(), text.as_str())),
    )
}
