//! An unstructured grid with named values, and its file.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use super::array::{Array, Values};
use super::escape::escaped;
use crate::files::{OutputProblem, unwritable};
use crate::mesh::CellKind;

/// Values on points and cells, ready to be written as a file of VTK.
#[derive(Debug, Default)]
pub struct FieldFile {
    points: Vec<f64>,
    connectivity: Vec<u64>,
    offsets: Vec<u64>,
    types: Vec<u8>,
    /// Numbers by their names, of the grid as a whole.
    of_all: Vec<(String, i64)>,
    of_points: Vec<Array>,
    of_cells: Vec<Array>,
}

/// Kind of a cell of a grid.
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
        self.types.push(cell.number());
    }

    /// Adds an array of `components` values per point.
    pub fn point_values(&mut self, name: &str, components: u32, values: Vec<f64>) {
        let array = Array::new(name, components, Values::Double(values));
        self.of_points.push(array);
    }

    /// Adds an array of `components` values per cell.
    pub fn cell_values(&mut self, name: &str, components: u32, values: Vec<f64>) {
        let array = Array::new(name, components, Values::Double(values));
        self.of_cells.push(array);
    }

    /// Adds whole numbers, one per cell.
    pub fn cell_numbers(&mut self, name: &str, values: Vec<i64>) {
        let array = Array::new(name, 1, Values::Whole(values));
        self.of_cells.push(array);
    }

    /// As [`FieldFile::point_values`], in single precision.
    pub fn point_values_short(&mut self, name: &str, components: u32, values: Vec<f32>) {
        let array = Array::new(name, components, Values::Single(values));
        self.of_points.push(array);
    }

    /// As [`FieldFile::cell_values`], in single precision.
    pub fn cell_values_short(&mut self, name: &str, components: u32, values: Vec<f32>) {
        let array = Array::new(name, components, Values::Single(values));
        self.of_cells.push(array);
    }

    /// Adds whole numbers, one per point.
    pub fn point_numbers(&mut self, name: &str, values: Vec<i64>) {
        let array = Array::new(name, 1, Values::Whole(values));
        self.of_points.push(array);
    }

    /// Adds a number with a name to the grid as a whole, such as the number that represents the
    /// name in an array of its cells.
    pub fn field_number(&mut self, name: &str, number: i64) {
        self.of_all.push((name.to_owned(), number));
    }

    /// Writes the grid as XML, arrays in binary.
    ///
    /// # Errors
    /// [`OutputProblem::File`].
    pub fn write(self, path: &Path) -> Result<(), OutputProblem> {
        let written = File::create(path).and_then(|file| {
            let mut out = BufWriter::new(file);
            self.write_to(&mut out)?;
            out.flush()
        });
        written.map_err(|error| unwritable(path, &error))
    }

    /// Array by array, so that the text is never in memory as a whole. Not compressed:
    /// compression takes longer than writing.
    fn write_to(self, out: &mut impl Write) -> io::Result<()> {
        let (points, cells) = (self.points.len() / 3, self.types.len());
        write!(
            out,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
             byte_order=\"LittleEndian\" header_type=\"UInt64\"><UnstructuredGrid>"
        )?;
        write_fields(out, &self.of_all)?;
        write!(
            out,
            "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"
        )?;
        write_arrays(out, "PointData", &self.of_points)?;
        write_arrays(out, "CellData", &self.of_cells)?;
        let points = Array::new("Points", 3, Values::Double(self.points));
        write_arrays(out, "Points", &[points])?;
        let of_cells = [
            Array::new("connectivity", 1, Values::Natural(self.connectivity)),
            Array::new("offsets", 1, Values::Natural(self.offsets)),
            Array::new("types", 1, Values::Byte(self.types)),
        ];
        write_arrays(out, "Cells", &of_cells)?;
        writeln!(out, "</Piece></UnstructuredGrid></VTKFile>")
    }
}

/// Writes numbers with names, where there are any.
fn write_fields(out: &mut impl Write, fields: &[(String, i64)]) -> io::Result<()> {
    if fields.is_empty() {
        return Ok(());
    }
    write!(out, "<FieldData>")?;
    for (name, number) in fields {
        let name = escaped(name);
        write!(
            out,
            "<DataArray type=\"Int64\" Name=\"{name}\" NumberOfTuples=\"1\" \
             format=\"ascii\">{number}</DataArray>"
        )?;
    }
    write!(out, "</FieldData>")
}

/// Writes arrays as the content of an element.
fn write_arrays(out: &mut impl Write, element: &str, arrays: &[Array]) -> io::Result<()> {
    write!(out, "<{element}>")?;
    arrays.iter().try_for_each(|array| array.write(out))?;
    write!(out, "</{element}>")
}

impl Cell {
    /// The number of the cell of VTK with the same nodes in the same order.
    fn number(self) -> u8 {
        match self {
            Self::Vertex => 1,
            Self::Line => 3,
            Self::Section(CellKind::Triangle3) => 5,
            Self::Section(CellKind::Quadrilateral4) => 9,
            Self::Section(CellKind::Triangle6) => 22,
            Self::Section(CellKind::Quadrilateral8) => 23,
            Self::Section(CellKind::Quadrilateral9) => 28,
        }
    }
}
