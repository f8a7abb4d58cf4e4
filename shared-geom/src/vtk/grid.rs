//! An unstructured grid with named values, and its file.

use std::path::Path;

use vtkio::IOBuffer;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataSet, UnstructuredGridPiece, Version,
    VertexNumbers, Vtk,
};
use vtkio::xml::{Compressor, VTKFile};

use crate::files::{OutputProblem, write_text};
use crate::mesh::CellKind;

/// Values on points and cells, ready to be written as a file of VTK.
#[derive(Debug, Default)]
pub struct FieldFile {
    points: Vec<f64>,
    connectivity: Vec<u64>,
    offsets: Vec<u64>,
    types: Vec<CellType>,
    data: Attributes,
}

/// What a cell of a grid is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cell {
    /// A point.
    Vertex,
    /// A straight line between two points.
    Line,
    /// A cell of a section mesh.
    Section(CellKind),
}

impl FieldFile {
    /// A grid of these points \[m\], without cells.
    pub fn new(points: impl IntoIterator<Item = [f64; 3]>) -> Self {
        Self {
            points: points.into_iter().flatten().collect(),
            ..Self::default()
        }
    }

    /// Adds a cell with its points in the order of VTK: corners, middles of the sides,
    /// center.
    pub fn add_cell(&mut self, cell: Cell, points: impl IntoIterator<Item = u64>) {
        self.connectivity.extend(points);
        self.offsets.push(self.connectivity.len() as u64);
        self.types.push(cell.vtk());
    }

    /// Adds an array of `components` values a point.
    pub fn point_values(&mut self, name: &str, components: u32, values: Vec<f64>) {
        self.data.point.push(array(name, components, values.into()));
    }

    /// Adds an array of `components` values a cell.
    pub fn cell_values(&mut self, name: &str, components: u32, values: Vec<f64>) {
        self.data.cell.push(array(name, components, values.into()));
    }

    /// Adds whole numbers, one a cell.
    pub fn cell_numbers(&mut self, name: &str, values: Vec<i64>) {
        self.data.cell.push(array(name, 1, values.into()));
    }

    /// As [`FieldFile::point_values`], in single precision.
    pub fn point_values_short(&mut self, name: &str, components: u32, values: Vec<f32>) {
        self.data.point.push(array(name, components, values.into()));
    }

    /// As [`FieldFile::cell_values`], in single precision.
    pub fn cell_values_short(&mut self, name: &str, components: u32, values: Vec<f32>) {
        self.data.cell.push(array(name, components, values.into()));
    }

    /// Adds whole numbers, one a point.
    pub fn point_numbers(&mut self, name: &str, values: Vec<i64>) {
        self.data.point.push(array(name, 1, values.into()));
    }

    /// Writes the grid as XML, arrays in binary.
    ///
    /// # Errors
    /// [`OutputProblem::File`].
    pub fn write(self, path: &Path) -> Result<(), OutputProblem> {
        let grid = self.into_xml().map_err(|error| OutputProblem::File {
            file: path.display().to_string(),
            reason: error.to_string(),
        })?;
        write_text(path, &format!("<?xml version=\"1.0\"?>\n{grid}\n"))
    }

    /// The file as the elements of its XML.
    fn into_xml(self) -> Result<VTKFile, vtkio::xml::Error> {
        let cells = Cells {
            cell_verts: VertexNumbers::XML {
                connectivity: self.connectivity,
                offsets: self.offsets,
            },
            types: self.types,
        };
        let piece = UnstructuredGridPiece {
            points: self.points.into(),
            cells,
            data: self.data,
        };
        let grid = Vtk {
            version: Version::new_xml(1, 0),
            title: String::new(),
            byte_order: ByteOrder::LittleEndian,
            file_path: None,
            data: DataSet::inline(piece),
        };
        // Not compressed: that takes longer than writing, and the crate ends arrays of
        // whole blocks with an empty one, which the format does not have.
        grid.try_into_xml_format(Compressor::None, 0)
    }
}

fn array(name: &str, components: u32, values: IOBuffer) -> Attribute {
    Attribute::generic(name, components).with_data(values)
}

impl Cell {
    /// The cell of VTK with the same nodes in the same order.
    fn vtk(self) -> CellType {
        match self {
            Self::Vertex => CellType::Vertex,
            Self::Line => CellType::Line,
            Self::Section(CellKind::Triangle3) => CellType::Triangle,
            Self::Section(CellKind::Triangle6) => CellType::QuadraticTriangle,
            Self::Section(CellKind::Quadrilateral4) => CellType::Quad,
            Self::Section(CellKind::Quadrilateral8) => CellType::QuadraticQuad,
            Self::Section(CellKind::Quadrilateral9) => CellType::BiquadraticQuad,
        }
    }
}
