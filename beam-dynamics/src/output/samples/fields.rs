//! Field files read back.

use shared_geom::vtk::FieldFile;
use vtkio::model::{Attribute, DataSet, Piece, UnstructuredGridPiece, Vtk};
use vtkio::xml::VTKFile;

/// The grid of a file, after it has been written and parsed again.
pub fn read_back(file: FieldFile) -> UnstructuredGridPiece {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.vtu");
    file.write(&path).expect("a file that is written");
    let text = std::fs::read(&path).expect("a file that is read");
    let grid = VTKFile::parse(&text[..]).expect("XML of VTK");
    let grid: Vtk = grid.try_into().expect("a grid");
    let DataSet::UnstructuredGrid { mut pieces, .. } = grid.data else {
        panic!("no unstructured grid");
    };
    match pieces.remove(0) {
        Piece::Inline(piece) => *piece,
        other => panic!("{other:?}"),
    }
}

/// The number of components and the values of an array.
pub fn values(attributes: &[Attribute], name: &str) -> (usize, Vec<f64>) {
    let found = attributes.iter().find_map(|attribute| match attribute {
        Attribute::DataArray(array) if array.name == name => Some(array),
        _ => None,
    });
    let array = found.unwrap_or_else(|| panic!("no array {name}"));
    (
        array.num_comp(),
        array.data.clone().cast_into().expect("numbers"),
    )
}
