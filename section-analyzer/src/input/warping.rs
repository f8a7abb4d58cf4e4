//! Reads the warping of a section from the field file of its analysis.

use std::path::Path;

use nalgebra::DMatrix;
use shared_geom::document::read_text;
use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::mesh_file::read_point_values;
use shared_geom::wrench::COMPONENTS;

/// Arrays of different lengths.
#[derive(Debug, thiserror::Error)]
#[error("the six arrays of the warping have {0:?} values, expected equal numbers")]
struct Lengths(Vec<usize>);

impl Explain for Lengths {
    fn help(&self) -> Option<String> {
        Some("analyze the section again".to_owned())
    }
}

/// The warping per unit internal force that `analyze` wrote to `NAME.warping.vtu`: n x 6, rows
/// ux, uy, uz of each node of the mesh, with all digits \[m/N, 1/N\].
///
/// # Errors
/// A file that cannot be read, arrays that are missing or differ in their length.
pub fn read_warping(path: &Path) -> Result<DMatrix<f64>, Diagnostics> {
    let text = read_text(path)?;
    let file = path.display().to_string();
    let names = COMPONENTS.map(|component| format!("warping_{}", component.replace(' ', "_")));
    let columns = read_point_values(text.as_bytes(), &file, &names)?;
    let lengths: Vec<usize> = columns.iter().map(Vec::len).collect();
    if lengths.iter().any(|length| *length != lengths[0]) {
        return Err(Diagnostics::one(
            SourceLocation::file(file),
            &Lengths(lengths),
        ));
    }
    Ok(DMatrix::from_vec(lengths[0], 6, columns.concat()))
}
