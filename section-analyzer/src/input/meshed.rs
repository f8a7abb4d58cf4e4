//! The mesh of a section with its regions and laminates.

use std::path::PathBuf;

use shared_geom::document::Document;
use shared_geom::error::SourceLocation;
use shared_geom::mesh::Mesh;
use shared_geom::mesh_file;
use shared_geom::units::Dimension;

use super::files::Files;
use super::imposed::Rows;
use super::laminae::{self, Added};
use super::regions::Written;
use super::{WrittenSection, extent, groups};
use crate::mesh::{MeshReport, SectionMesh};

/// The mesh of a section with its laminates.
pub(super) struct Meshed {
    /// The mesh without its laminates, if there are any.
    pub bare: Option<Mesh>,
    pub mesh: Mesh,
    /// Region of each cell that is not part of a laminate, if it has one.
    pub region_of_cell: Vec<Option<usize>>,
    /// The laminates, whose cells come after the others.
    pub added: Added,
    /// The mesh in meters, if it is sound.
    pub checked: Option<(SectionMesh, MeshReport)>,
}

impl Meshed {
    /// Tags that rows of tables may use.
    pub fn rows(&self) -> Option<Rows> {
        let tags = self.mesh.cells.iter().map(|cell| cell.tag).collect();
        let lines = laminae::lines_of_cells(self.added.laminated()?);
        Some(Rows { tags, lines })
    }
}

impl WrittenSection {
    /// Reads the mesh, assigns regions to its cells, adds the laminates and checks it.
    pub fn meshed(&self, document: &Document, files: &mut Files<'_>) -> Option<Meshed> {
        let mesh_key = self.mesh.as_ref()?;
        let mut mesh = read_mesh(document, files, mesh_key)?;
        let region_of_cell = groups::region_of_cells(document, &mut mesh, mesh_key, &self.regions);
        let unit = document.factor(Dimension::LENGTH);
        let bare = (!self.laminae.is_empty()).then(|| mesh.clone());
        let added = laminae::add(document, &mut mesh, &self.laminae, unit);
        let location = SourceLocation::file(files.path(mesh_key).display().to_string());
        let how = (unit, self.doubled_nodes, &location);
        let checked = added.checked(document, &mesh, &self.laminae, how);
        let section_mesh = checked.as_ref().map(|(section_mesh, _)| section_mesh);
        if let Some(Err(problem)) = section_mesh.map(extent::check) {
            document.note(mesh_key.line, &problem);
        }
        Some(Meshed {
            bare,
            mesh,
            region_of_cell,
            added,
            checked,
        })
    }
}

/// The mesh file named under `key`.
fn read_mesh(document: &Document, files: &mut Files<'_>, key: &Written) -> Option<Mesh> {
    let path = files.path(key);
    let becas = mesh_file::becas_files(&path);
    if let Some(paths) = becas.filter(|paths| paths.iter().any(|path| path.exists())) {
        return read_becas(document, files, (key, paths));
    }
    let bytes = files.read("mesh", &path, key)?;
    document.keep(mesh_file::read(bytes, &path.display().to_string()))
}

/// The mesh of a model of BECAS, with a physical surface for each of its materials and fiber angles.
fn read_becas(
    document: &Document,
    files: &mut Files<'_>,
    (key, paths): (&Written, [PathBuf; 4]),
) -> Option<Mesh> {
    // all files are read before the first missing one ends the reading
    let texts = paths
        .each_ref()
        .map(|path| files.read_text("mesh", path, key));
    let names = paths.map(|path| path.display().to_string());
    let [nodes, elements, layups, materials] = texts;
    let texts = [nodes?, elements?, layups?, materials?];
    let pair = |number: usize| (names[number].as_str(), texts[number].as_str());
    let model = mesh_file::read_becas([0, 1, 2, 3].map(pair));
    document.keep(model).map(|model| model.mesh)
}
