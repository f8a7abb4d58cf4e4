//! Mesh files of gmsh: MSH 2.2 and 4.1, ascii and binary of either byte order.
//!
//! [`read`] reads the bytes of a file once, keeps the parts of a plane section mesh
//! (physical groups, nodes, points, lines, triangles, quadrilaterals) and skips unknown
//! sections. References between the parts are resolved at the end, so that all problems
//! of a file are reported together, each with its line, or in binary files its byte.
//! [`write()`] writes MSH 4.1, ascii.
//!
//! An element of an entity that is reversed in its physical group (negative tag) is
//! reversed on reading, as gmsh does itself when it writes MSH 2.2:
//! `Physical Curve("skin") = {-1, 2}` gives lines that run on through both curves.
//!
//! An element may be in several physical groups. MSH 4.1 lists them by entity; MSH 2.2
//! lists the element once for each of them, with a different tag each time, and these
//! become one element with the first tag. A line that runs along in one group and against
//! it in another is two lines in the mesh.
//!
//! With `Mesh.SaveAll = 1` MSH 4.1 has elements with and without groups, while
//! gmsh writes no group at all into MSH 2.2.
//!
//! # Example
//!
//! ```
//! use shared_geom::gmsh;
//!
//! let file = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
//!     $PhysicalNames\n1\n2 1 \"spar\"\n$EndPhysicalNames\n\
//!     $Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n\
//!     $Elements\n1\n1 3 2 1 1 1 2 3 4\n$EndElements\n";
//! let mesh = gmsh::read(&file.as_bytes(), "square.msh").expect("a sound mesh");
//! assert_eq!((mesh.nodes.len(), mesh.cells.len()), (4, 1));
//! // each problem of a file has its line
//! let problems = gmsh::read(&"$Nodes\n".as_bytes(), "cut.msh").expect_err("no mesh");
//! assert!(problems.to_string().contains("cut.msh"));
//! ```
//!
//! # References
//! - Gmsh reference manual, sections "MSH file format" (4.1) and
//!   "MSH file format version 2 (Legacy)" (2.2).

mod assemble;
mod build;
mod cursor;
mod element;
mod fields;
mod format;
mod merge;
mod names;
mod problem;
mod read22;
mod read41;
mod reader;
mod sections;
mod tags;
mod write41;

use std::path::Path;

use crate::error::{Diagnostics, SourceLocation};
use crate::mesh::Mesh;

use problem::ReadProblem;

pub use write41::write;

/// Reads the mesh in `content`, the bytes (or text) of a gmsh file of version 2.2 or
/// 4.1; `file` is the name for messages.
///
/// # Errors
/// All errors of the file (about the first twenty), each with its line or byte.
pub fn read<B>(content: &B, file: &str) -> Result<Mesh, Diagnostics>
where
    B: AsRef<[u8]> + ?Sized,
{
    sections::read(content.as_ref(), file)
}

/// Reads the mesh in the file at `path`; see [`read`].
///
/// # Errors
/// As [`read`]; also a file that cannot be read.
pub fn read_file(path: &Path) -> Result<Mesh, Diagnostics> {
    let file = path.display().to_string();
    match crate::files::read_bytes(path) {
        Ok(bytes) => read(&bytes, &file),
        Err(error) => {
            let problem = ReadProblem::Unreadable(error.to_string());
            Err(Diagnostics::one(SourceLocation::file(&file), &problem))
        }
    }
}

#[cfg(test)]
mod binary_tests;
#[cfg(test)]
mod malformed_tests;
#[cfg(test)]
mod read_tests;
#[cfg(test)]
mod write_tests;
