//! Mesh files of several programs, by their content: gmsh, Abaqus and the legacy format of
//! VTK.
//!
//! [`read`] gives the same mesh for all of them: cells, lines, and the groups that name
//! them. Unknown content is treated as a file of gmsh.

use crate::error::Diagnostics;
use crate::gmsh;
use crate::mesh::Mesh;

mod inp;
mod parts;
mod problem;
mod vtk;
mod words;

/// Reads the mesh in `content`; `file` is the name for messages. A file whose name ends in
/// `.inp` is one of Abaqus; one that begins with `# vtk DataFile` is one of VTK; others are
/// files of gmsh.
///
/// # Errors
/// All errors of the file, each with its line or byte.
pub fn read(content: &[u8], file: &str) -> Result<Mesh, Diagnostics> {
    if file.to_lowercase().ends_with(".inp") {
        return inp::read(content, file);
    }
    let is_vtk = content.starts_with(b"# vtk DataFile");
    if is_vtk || file.to_lowercase().ends_with(".vtk") {
        return vtk::read(content, file);
    }
    gmsh::read(content, file)
}

#[cfg(test)]
mod tests;
