//! A section as the report page draws it: the corners of its cells, ordered by ply.

use std::collections::BTreeMap;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

use crate::input::{Input, InputWarning};
use crate::material::ElasticLaw;
use crate::mesh::SectionCell;
use crate::section::Section;

/// The cells of a section by their corners, and its plies. Arrays are little-endian, in base64.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SectionPicture {
    /// Positions (y, z) of the corners, floats of 32 bits \[m\].
    pub nodes: String,
    /// Four corners of each cell, counterclockwise; triangles have the last one twice. Unsigned
    /// integers of `index_bytes` bytes.
    pub cells: String,
    /// Bytes of a corner in `cells`: 2, or 4 if there are more than 65536 corners.
    pub index_bytes: usize,
    /// Wall direction of each cell, from the section axis y, signed integers of 16 bits
    /// \[0.01 deg\].
    pub plane_angles: String,
    /// The plies, in the order of their cells.
    pub plies: Vec<PlyPicture>,
    /// Nodes of the mesh.
    pub mesh_nodes: usize,
    /// Cells of the mesh.
    pub mesh_cells: usize,
    /// Cells of poor shape.
    pub poor_cells: usize,
    /// Warnings about the section, without the ones about poor cells.
    #[serde(skip)]
    pub warnings: Vec<String>,
}

/// A ply of a section: a physical surface of its mesh.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlyPicture {
    /// The physical surface.
    pub ply: String,
    /// Its material.
    pub material: String,
    /// Density of the material \[kg/m^3\].
    pub density: f64,
    /// Fiber angle, from the beam axis toward the wall direction; `None` if the material is
    /// isotropic \[deg\].
    pub fiber_angle: Option<f64>,
    /// Number of its cells.
    pub cells: usize,
}

impl SectionPicture {
    /// The picture of a section.
    pub fn new(input: &Input) -> Self {
        let (section, summary) = (&input.section, &input.summary);
        let mut order: Vec<usize> = (0..section.mesh.cells.len()).collect();
        order.sort_by_key(|&cell| section.mesh.cells[cell].group);
        let corners = Corners::new(section, &order);
        let angle = |&cell: &usize| hundredths(section.cells[cell].plane_angle).to_le_bytes();
        let is_of_cells =
            |warning: &&InputWarning| matches!(warning, InputWarning::PoorCells { .. });
        let warnings = summary.warnings.iter().filter(|one| !is_of_cells(one));
        Self {
            nodes: STANDARD.encode(corners.nodes),
            cells: STANDARD.encode(corners.cells),
            index_bytes: corners.index_bytes,
            plane_angles: STANDARD.encode(order.iter().flat_map(angle).collect::<Vec<u8>>()),
            plies: plies(section, &order),
            mesh_nodes: section.mesh.nodes.len(),
            mesh_cells: section.mesh.cells.len(),
            poor_cells: summary.quality.poor(),
            warnings: warnings.map(ToString::to_string).collect(),
        }
    }
}

/// The corners of cells, without the other nodes of the mesh.
struct Corners {
    /// Positions, floats of 32 bits.
    nodes: Vec<u8>,
    /// Four corners of each cell.
    cells: Vec<u8>,
    index_bytes: usize,
}

impl Corners {
    /// The corners of cells in an order.
    fn new(section: &Section, order: &[usize]) -> Self {
        let mesh = &section.mesh;
        let used = mesh.cells.iter().flat_map(SectionCell::corners);
        let mut numbers: BTreeMap<u32, u32> = used.map(|&node| (node, 0)).collect();
        for (number, corner) in numbers.values_mut().zip(0..) {
            *number = corner;
        }
        let positions = numbers.keys().flat_map(|&node| mesh.nodes[node as usize]);
        let nodes = positions.flat_map(|x| (x as f32).to_le_bytes()).collect();
        let index_bytes = if numbers.len() > 1 << 16 { 4 } else { 2 };
        let mut cells = Vec::with_capacity(4 * index_bytes * order.len());
        for &cell in order {
            let corners = mesh.cells[cell].corners();
            for i in 0..4 {
                let node = corners[i.min(corners.len() - 1)];
                cells.extend_from_slice(&numbers[&node].to_le_bytes()[..index_bytes]);
            }
        }
        Self {
            nodes,
            cells,
            index_bytes,
        }
    }
}

/// The plies of cells that are ordered by ply.
fn plies(section: &Section, order: &[usize]) -> Vec<PlyPicture> {
    let group = |cell: &usize| section.mesh.cells[*cell].group;
    let same = order.chunk_by(|a, b| group(a) == group(b));
    let ply = |cells: &[usize]| {
        let cell = &section.cells[cells[0]];
        let material = &section.materials[cell.material];
        let is_isotropic = matches!(material.law, ElasticLaw::Isotropic { .. });
        // turned into radians and back, an angle has round-off in its last digit
        let angle = (cell.fiber_angle.to_degrees() * 1e9).round() / 1e9;
        PlyPicture {
            ply: section.mesh.groups[group(&cells[0])].clone(),
            material: material.name.clone(),
            density: material.density,
            fiber_angle: (!is_isotropic).then_some(angle),
            cells: cells.len(),
        }
    };
    same.map(ply).collect()
}

/// An angle from -180 to 180 deg \[0.01 deg\].
fn hundredths(angle: f64) -> i16 {
    let turned = angle.to_degrees();
    ((turned - 360.0 * (turned / 360.0).round()) * 100.0).round() as i16
}
