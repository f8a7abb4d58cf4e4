//! Mesh files of several programs, by their content: gmsh, Abaqus, VTK (legacy and XML) and
//! VABS; models of VABS and BECAS with their materials.
//!
//! [`read`] gives the same mesh for all of them: cells, lines, and the groups that name
//! them. Unknown content is treated as a file of gmsh.

use std::path::{Path, PathBuf};

use crate::error::Diagnostics;
use crate::gmsh;
use crate::mesh::Mesh;

mod becas;
mod elements;
mod grid;
mod inp;
mod model;
mod parts;
mod problem;
mod rows;
mod vabs;
mod vtk;
mod vtu;
mod words;

pub use becas::{BECAS_FILES, read_becas};
pub use model::{Model, ModelCell, ModelLaw, ModelMaterial, ModelRegion};

/// Endings of the names of mesh files, in small letters: gmsh, Abaqus, VTK, VABS.
pub const ENDINGS: [&str; 5] = [".msh", INP, VTK, VTU, ".sg"];
const INP: &str = ".inp";
const VTK: &str = ".vtk";
const VTU: &str = ".vtu";

/// Whether the name of a file has the ending of a mesh.
pub fn has_ending(file: &str) -> bool {
    let file = file.to_lowercase();
    ENDINGS.iter().any(|ending| file.ends_with(ending))
}

/// The files of the BECAS model at `path`, which is its folder or one of its files, in the order of
/// [`BECAS_FILES`]; `None` for other files.
pub fn becas_files(path: &Path) -> Option<[PathBuf; 4]> {
    let folder = match path.is_dir() {
        true => path,
        false if BECAS_FILES.iter().any(|file| path.ends_with(file)) => path.parent()?,
        false => return None,
    };
    Some(BECAS_FILES.map(|name| folder.join(name)))
}

/// Reads an input file of VABS; `file` is the name for messages.
///
/// # Errors
/// All errors of the file, each with its line.
pub fn read_vabs(content: &[u8], file: &str) -> Result<Model, Diagnostics> {
    vabs::read(content, file)
}

/// Reads arrays of values at the points of a field file, `.vtu`, by their names; `file` is the
/// name for messages.
///
/// # Errors
/// All errors of these arrays, each with its line.
pub fn read_point_values(
    content: &[u8],
    file: &str,
    names: &[String],
) -> Result<Vec<Vec<f64>>, Diagnostics> {
    vtu::read_point_values(content, file, names)
}

/// Reads the mesh in `content`; `file` is the name for messages. A file whose name ends in
/// `.inp` is one of Abaqus; one that begins with `# vtk DataFile` or as XML is one of VTK;
/// rows of 2, 3 and 4 whole numbers begin one of VABS; others are files of gmsh.
///
/// # Errors
/// All errors of the file, each with its line or byte.
pub fn read(content: &[u8], file: &str) -> Result<Mesh, Diagnostics> {
    if file.to_lowercase().ends_with(INP) {
        return inp::read(content, file);
    }
    let is_vtk = content.starts_with(b"# vtk DataFile");
    if is_vtk || file.to_lowercase().ends_with(VTK) {
        return vtk::read(content, file);
    }
    if vtu::recognize(content, file) {
        return vtu::read(content, file);
    }
    if vabs::recognize(content) {
        return vabs::read(content, file).map(|model| model.mesh);
    }
    gmsh::read(content, file)
}

#[cfg(test)]
mod tests;
