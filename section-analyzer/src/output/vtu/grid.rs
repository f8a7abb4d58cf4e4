//! An unstructured grid with named values, and its file.

use std::path::Path;

use shared_geom::files::{OutputProblem, write_text};
use shared_geom::mesh::CellKind;
use vtkio::IOBuffer;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataSet, UnstructuredGridPiece, Version,
    VertexNumbers, Vtk,
};
use vtkio::xml::{Compressor, VTKFile};

use crate::material::material_axes;
use crate::section::{CellMaterial, Section};

/// Values on the mesh of a section, ready to be written as a file of VTK.
#[derive(Debug)]
pub struct FieldFile {
    points: Vec<f64>,
    connectivity: Vec<u64>,
    offsets: Vec<u64>,
    types: Vec<CellType>,
    data: Attributes,
}

impl FieldFile {
    /// A grid of the cells of `section` on `points` (y, z); each cell has the points
    /// that `cell_points` gives, in the order of its nodes.
    pub(super) fn new(
        section: &Section,
        points: impl Iterator<Item = [f64; 2]>,
        cell_points: impl Fn(usize) -> Vec<u32>,
    ) -> Self {
        let mut file = Self {
            points: points.flat_map(|[y, z]| [0.0, y, z]).collect(),
            connectivity: Vec::new(),
            offsets: Vec::new(),
            types: Vec::new(),
            data: Attributes::default(),
        };
        for (index, cell) in section.mesh.cells.iter().enumerate() {
            let points = cell_points(index);
            file.connectivity.extend(points.into_iter().map(u64::from));
            file.offsets.push(file.connectivity.len() as u64);
            file.types.push(cell_type(cell.kind));
        }
        file.add_cell_values(section);
        file
    }

    /// What the cells are made of.
    fn add_cell_values(&mut self, section: &Section) {
        let cells = || section.mesh.cells.iter().zip(&section.cells);
        let regions = cells().map(|(cell, _)| cell.group as i64);
        self.cell_numbers("region", regions.collect());
        let materials = cells().map(|(_, made)| made.material as i64);
        self.cell_numbers("material", materials.collect());
        self.cell_numbers("tag", cells().map(|(cell, _)| cell.tag as i64).collect());

        let density = |material: usize| section.materials.get(material).map_or(0.0, |m| m.density);
        let densities = cells().map(|(_, made)| density(made.material));
        self.cell_values("density", 1, densities.collect());
        let fiber = |made: &CellMaterial| {
            let axes = material_axes(made.fiber_angle, made.plane_angle);
            [0, 1, 2].map(|axis| axes[(axis, 0)])
        };
        let fibers = section.cells.iter().flat_map(fiber);
        self.cell_values("fiber_direction", 3, fibers.collect());
        let plane = |made: &CellMaterial| [0.0, made.plane_angle.cos(), made.plane_angle.sin()];
        let planes = section.cells.iter().flat_map(plane);
        self.cell_values("plane_direction", 3, planes.collect());
    }

    /// Adds an array of `components` values a point.
    pub(super) fn point_values(&mut self, name: &str, components: u32, values: Vec<f64>) {
        self.data.point.push(array(name, components, values.into()));
    }

    /// Adds an array of `components` values a cell.
    pub(super) fn cell_values(&mut self, name: &str, components: u32, values: Vec<f64>) {
        self.data.cell.push(array(name, components, values.into()));
    }

    fn cell_numbers(&mut self, name: &str, values: Vec<i64>) {
        self.data.cell.push(array(name, 1, values.into()));
    }

    /// As [`FieldFile::point_values`], in single precision.
    pub(super) fn point_values_short(&mut self, name: &str, components: u32, values: Vec<f32>) {
        self.data.point.push(array(name, components, values.into()));
    }

    /// As [`FieldFile::cell_values`], in single precision.
    pub(super) fn cell_values_short(&mut self, name: &str, components: u32, values: Vec<f32>) {
        self.data.cell.push(array(name, components, values.into()));
    }

    /// Adds whole numbers, one a point.
    pub(super) fn point_numbers(&mut self, name: &str, values: Vec<i64>) {
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
    pub(super) fn into_xml(self) -> Result<VTKFile, vtkio::xml::Error> {
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

/// The cell of VTK with the same nodes in the same order: corners, middles of the
/// sides, center.
fn cell_type(kind: CellKind) -> CellType {
    match kind {
        CellKind::Triangle3 => CellType::Triangle,
        CellKind::Triangle6 => CellType::QuadraticTriangle,
        CellKind::Quadrilateral4 => CellType::Quad,
        CellKind::Quadrilateral8 => CellType::QuadraticQuad,
        CellKind::Quadrilateral9 => CellType::BiquadraticQuad,
    }
}
