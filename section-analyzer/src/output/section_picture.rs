//! A section as the report page draws it: the corners of its cells, ordered by ply.

use std::collections::HashMap;

use nalgebra::Matrix6;
use serde::Serialize;

use super::cell_stress::CellStress;
use super::packed::packed;
use super::text::rows;
use crate::input::{Input, InputSummary, InputWarning};
use crate::material::{ElasticLaw, Material, MaterialLimits};
use crate::mesh::quality::ShapeMeasure;
use crate::properties::invert_symmetric;
use crate::section::Section;

/// Measures of the shapes of cells in the report.
const MEASURES: [ShapeMeasure; 4] = [
    ShapeMeasure::Aspect,
    ShapeMeasure::SmallestAngle,
    ShapeMeasure::LargestAngle,
    ShapeMeasure::Jacobian,
];

/// The worst value of a measure, angles in degrees.
fn shown_quality(summary: &InputSummary, measure: ShapeMeasure) -> Option<f64> {
    let worst = summary.quality.worst_value(measure)?;
    let is_angle = [ShapeMeasure::SmallestAngle, ShapeMeasure::LargestAngle].contains(&measure);
    Some(if is_angle { worst.to_degrees() } else { worst })
}

/// Steps of a coordinate from one end of a section to the other.
const STEPS: f64 = (1 << 22) as f64;

/// The cells of a section by their corners, and its plies.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SectionPicture {
    /// Lists of integers as one text: y and z of the corners, in steps from `origin`; four lists
    /// of the corners of all cells, counterclockwise, of triangles the last one twice; the wall
    /// direction of each cell, from the section axis y \[0.01 deg\].
    pub geometry: String,
    /// Number of corners.
    pub corners: usize,
    /// Smallest y and z of the corners \[m\].
    pub origin: [f64; 2],
    /// Step of the positions \[m\].
    pub step: f64,
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
    /// Worst aspect ratio, smallest and largest corner \[deg\], least over largest Jacobian [-].
    pub quality: [Option<f64>; 4],
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
        let (origin, step) = corners.frame();
        let angle = |&cell: &usize| hundredths(section.cells[cell].plane_angle);
        let mut lists = corners.steps(origin, step);
        lists.extend(corners.cells);
        lists.push(order.iter().map(angle).collect());
        let is_of_cells =
            |warning: &&InputWarning| matches!(warning, InputWarning::PoorCells { .. });
        let warnings = summary.warnings.iter().filter(|one| !is_of_cells(one));
        let no_stress = stress.as_ref().err();
        let by_ply = |stress: &Vec<Matrix6<f64>>| {
            let plies = of_plies(section, &order);
            CellStress::new(plies.map(|cells| cells.iter().map(|&cell| &stress[cell]).collect()))
        };
        Self {
            geometry: packed(&lists),
            corners: corners.positions.len(),
            origin,
            step,
            plies: plies(section, &order),
            stress: stress.as_ref().ok().map(by_ply),
            materials: materials(input),
            mesh_nodes: section.mesh.nodes.len(),
            mesh_cells: section.mesh.cells.len(),
            poor_cells: summary.quality.poor(),
            quality: MEASURES.map(|measure| shown_quality(summary, measure)),
            warnings: warnings
                .map(ToString::to_string)
                .chain(no_stress.map(|reason| format!("stresses are not shown: {reason}")))
                .collect(),
        }
    }
}

/// The corners of cells, without the other nodes of the mesh. They are in the order in which the
/// cells of a ply have them as their first corner, then as their second one and so on: neighbors
/// follow each other, so that lists are short.
#[derive(Default)]
struct Corners {
    positions: Vec<[f64; 2]>,
    /// A list for each of the four corners of the cells.
    cells: [Vec<i64>; 4],
}

impl Corners {
    /// The corners of cells that are ordered by ply.
    fn new(section: &Section, order: &[usize]) -> Self {
        let mesh = &section.mesh;
        let mut found = Self::default();
        let mut numbers: HashMap<u32, i64> = HashMap::new();
        for cells in of_plies(section, order) {
            for (i, list) in found.cells.iter_mut().enumerate() {
                list.extend(cells.iter().map(|&cell| {
                    let corners = mesh.cells[cell].corners();
                    let node = corners[i.min(corners.len() - 1)];
                    *numbers.entry(node).or_insert_with(|| {
                        found.positions.push(mesh.nodes[node as usize]);
                        found.positions.len() as i64 - 1
                    })
                }));
            }
        }
        found
    }

    /// The smallest coordinates, and the step for both.
    fn frame(&self) -> ([f64; 2], f64) {
        let ends = [0, 1].map(|i| {
            let values = || self.positions.iter().map(|position| position[i]);
            let least = values().fold(f64::INFINITY, f64::min);
            [least, values().fold(f64::NEG_INFINITY, f64::max) - least]
        });
        (
            ends.map(|[least, _]| least),
            ends[0][1].max(ends[1][1]) / STEPS,
        )
    }

    /// Coordinates from an origin, in steps.
    fn steps(&self, origin: [f64; 2], step: f64) -> Vec<Vec<i64>> {
        let number = |i: usize, x: f64| ((x - origin[i]) / step).round() as i64;
        let list = |i: usize| {
            let positions = self.positions.iter();
            positions.map(|position| number(i, position[i])).collect()
        };
        vec![list(0), list(1)]
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
fn hundredths(angle: f64) -> i64 {
    let turned = angle.to_degrees();
    ((turned - 360.0 * (turned / 360.0).round()) * 100.0).round() as i64
}
