//! Field files read back, and the text of a series.

use vtkio::model::{Attribute, DataSet, Piece, UnstructuredGridPiece, Vtk};
use vtkio::xml::VTKFile;

use super::*;

fn read_back(file: FieldFile) -> UnstructuredGridPiece {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vtu");
    file.write(&path).unwrap();
    let text = std::fs::read(&path).unwrap();
    let grid: Vtk = VTKFile::parse(&text[..]).unwrap().try_into().unwrap();
    let DataSet::UnstructuredGrid { mut pieces, .. } = grid.data else {
        panic!("no unstructured grid");
    };
    match pieces.remove(0) {
        Piece::Inline(piece) => *piece,
        other => panic!("{other:?}"),
    }
}

#[test]
fn points_cells_and_values_are_read_as_they_were_written() {
    let mut file = FieldFile::new([[0.0, 0.0, 0.0], [1.0, 0.5, 0.1], [2.0, 0.0, 0.3]]);
    file.add_cell(Cell::Line, [0, 2]);
    file.add_cell(Cell::Vertex, [1]);
    file.point_values("moved", 3, (0..9).map(f64::from).collect());
    file.cell_numbers("beam", vec![7, -1]);
    let grid = read_back(file);
    let points: Vec<f64> = grid.points.cast_into().unwrap();
    assert_eq!(points, [0.0, 0.0, 0.0, 1.0, 0.5, 0.1, 2.0, 0.0, 0.3]);
    // Numbers of VTK: vtkCellType.h.
    let types: Vec<_> = grid.cells.types.iter().map(|found| *found as u8).collect();
    assert_eq!(types, [3, 1]);
    assert_eq!(
        grid.cells.cell_verts.into_xml(),
        (vec![0, 2, 1], vec![2, 3])
    );
    let values = |attributes: &[Attribute]| match &attributes[0] {
        Attribute::DataArray(array) => (
            array.num_comp(),
            array.data.clone().cast_into::<f64>().unwrap(),
        ),
        other => panic!("{other:?}"),
    };
    let moved = (0..9).map(f64::from).collect::<Vec<_>>();
    assert_eq!(values(&grid.data.point), (3, moved));
    assert_eq!(values(&grid.data.cell), (1, vec![7.0, -1.0]));
}

#[test]
fn a_series_names_its_grids_with_their_values() {
    let mut series = Series::default();
    series.add(0.0, "a/0.vtu");
    series.add(0.25, "a & b/\"1\".vtu");
    let expected = "\
<?xml version=\"1.0\"?>
<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">
  <Collection>
    <DataSet timestep=\"0\" group=\"\" part=\"0\" file=\"a/0.vtu\"/>
    <DataSet timestep=\"0.25\" group=\"\" part=\"0\" file=\"a &amp; b/&quot;1&quot;.vtu\"/>
  </Collection>
</VTKFile>
";
    assert_eq!(series.text(), expected);
}
