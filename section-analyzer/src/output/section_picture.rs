//! A section as the report page draws it: the corners of its cells, ordered by ply.

use std::collections::BTreeMap;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use nalgebra::Matrix6;
use serde::Serialize;

use super::cell_stress::CellStress;
use super::text::rows;
use crate::input::{Input, InputWarning};
use crate::material::{ElasticLaw, Material, MaterialLimits};
use crate::mesh::SectionCell;
use crate::properties::invert_symmetric;
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
    /// Stresses of the cells per unit internal force, in the order of the plies.
    pub stress: Option<CellStress>,
    /// Nodes of the mesh.
    pub mesh_nodes: usize,
    /// Cells of the mesh.
    pub mesh_cells: usize,
    /// Cells of poor shape.
    pub poor_cells: usize,
    /// Warnings about the section, without the ones about poor cells.
    #[serde(skip)]
    pub warnings: Vec<String>,
    /// The materials of the section.
    #[serde(skip)]
    pub materials: Vec<MaterialPicture>,
}

/// A material, for failure indices.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MaterialPicture {
    /// Name.
    pub name: String,
    /// Strain per stress in material axes, order 11 22 33 23 13 12 with engineering shear
    /// strains; `None` without stiffness \[1/Pa\].
    pub compliance: Option<[[f64; 6]; 6]>,
    /// Strengths and strain limits.
    #[serde(flatten)]
    pub limits: MaterialLimits,
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
    /// Angle of the material axis 1 from the beam axis toward the wall direction \[deg\].
    pub axis_angle: f64,
    /// Number of its cells.
    pub cells: usize,
}

impl SectionPicture {
    /// The picture of a section, with the mean stress of each cell of the mesh per unit internal
    /// force (rows of stress in material axes, a column per force), or the reason for which it
    /// is absent.
    pub fn new(input: &Input, stress: &Result<Vec<Matrix6<f64>>, String>) -> Self {
        let (section, summary) = (&input.section, &input.summary);
        let mut order: Vec<usize> = (0..section.mesh.cells.len()).collect();
        order.sort_by_key(|&cell| section.mesh.cells[cell].group);
        let corners = Corners::new(section, &order);
        let angle = |&cell: &usize| hundredths(section.cells[cell].plane_angle).to_le_bytes();
        let is_of_cells =
            |warning: &&InputWarning| matches!(warning, InputWarning::PoorCells { .. });
        let warnings = summary.warnings.iter().filter(|one| !is_of_cells(one));
        let no_stress = stress.as_ref().err();
        let by_ply = |stress: &Vec<Matrix6<f64>>| {
            let plies = of_plies(section, &order);
            CellStress::new(plies.map(|cells| cells.iter().map(|&cell| &stress[cell]).collect()))
        };
        Self {
            nodes: STANDARD.encode(corners.nodes),
            cells: STANDARD.encode(corners.cells),
            index_bytes: corners.index_bytes,
            plane_angles: STANDARD.encode(order.iter().flat_map(angle).collect::<Vec<u8>>()),
            plies: plies(section, &order),
            stress: stress.as_ref().ok().map(by_ply),
            materials: materials(input),
            mesh_nodes: section.mesh.nodes.len(),
            mesh_cells: section.mesh.cells.len(),
            poor_cells: summary.quality.poor(),
            warnings: warnings
                .map(ToString::to_string)
                .chain(no_stress.map(|reason| format!("stresses are not shown: {reason}")))
                .collect(),
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

/// The cells of each ply, of cells that are ordered by ply.
fn of_plies<'a>(section: &Section, order: &'a [usize]) -> impl Iterator<Item = &'a [usize]> {
    let group = |cell: &usize| section.mesh.cells[*cell].group;
    order.chunk_by(move |a, b| group(a) == group(b))
}

/// The materials of a section with their limits.
fn materials(input: &Input) -> Vec<MaterialPicture> {
    let materials = input.section.materials.iter().zip(&input.limits);
    let picture = |(material, limits): (&Material, &MaterialLimits)| MaterialPicture {
        name: material.name.clone(),
        compliance: invert_symmetric(&material.law.stiffness())
            .as_ref()
            .map(rows),
        limits: *limits,
    };
    materials.map(picture).collect()
}

/// The plies of cells that are ordered by ply.
fn plies(section: &Section, order: &[usize]) -> Vec<PlyPicture> {
    let ply = |cells: &[usize]| {
        let cell = &section.cells[cells[0]];
        let material = &section.materials[cell.material];
        let is_isotropic = matches!(material.law, ElasticLaw::Isotropic { .. });
        // turned into radians and back, an angle has round-off in its last digit
        let angle = (cell.fiber_angle.to_degrees() * 1e9).round() / 1e9;
        PlyPicture {
            ply: section.mesh.groups[section.mesh.cells[cells[0]].group].clone(),
            material: material.name.clone(),
            density: material.density,
            fiber_angle: (!is_isotropic).then_some(angle),
            axis_angle: angle,
            cells: cells.len(),
        }
    };
    of_plies(section, order).map(ply).collect()
}

/// An angle from -180 to 180 deg \[0.01 deg\].
fn hundredths(angle: f64) -> i16 {
    let turned = angle.to_degrees();
    ((turned - 360.0 * (turned / 360.0).round()) * 100.0).round() as i16
}
