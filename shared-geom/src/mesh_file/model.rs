//! Section models of other tools: mesh, materials, and the orientation of each cell.
//!
//! All tools that are read here define material axes as Helicoid does: the wall turns by the
//! plane angle about the axis of the beam, the fiber by the fiber angle about the normal of
//! the wall.

use std::collections::{BTreeMap, HashMap};

use super::elements::Elements;
use super::parts::Parts;
use super::problem::{FileProblem, Problems};
use crate::mesh::Mesh;

/// Fiber angles of a material that become one region each; more are left to a table.
const FEW: usize = 20;

/// A section model.
#[derive(Debug, Clone, Default)]
pub struct Model {
    /// The mesh in the section axes y, z (x, y of the file), with a surface for each region.
    pub mesh: Mesh,
    /// Materials.
    pub materials: Vec<ModelMaterial>,
    /// Regions, in the order of the groups of the mesh.
    pub regions: Vec<ModelRegion>,
    /// Orientation of each cell, in the order of the file.
    pub cells: Vec<ModelCell>,
    /// Twist and the two curvatures of the undeformed beam \[rad per unit of length\].
    pub curvature: Option<[f64; 3]>,
    /// Direction of the reference line in section axes \[-\], if it is not normal.
    pub slope: Option<[f64; 3]>,
    /// Changes by the conversion, as text.
    pub notes: Vec<String>,
}

/// A material, in a consistent system of units.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelMaterial {
    /// Name.
    pub name: String,
    /// Elastic constants \[stress\].
    pub law: ModelLaw,
    /// Density \[kg/m^3\], if the model is in SI units.
    pub density: f64,
}

/// Elastic constants in material axes: 1 along the fiber, 2 across it in the wall, 3 through
/// the wall.
#[derive(Debug, Clone, PartialEq)]
pub enum ModelLaw {
    /// Young's modulus \[stress\] and Poisson's ratio \[-\].
    Isotropic([f64; 2]),
    /// E1, E2, E3, G12, G13, G23 \[stress\], nu12, nu13, nu23 \[-\].
    Orthotropic([f64; 9]),
    /// Stiffness \[stress\], order 11, 22, 33, 23, 13, 12, engineering shear strains.
    Full(Box<[[f64; 6]; 6]>),
}

/// Cells of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelRegion {
    /// Name of its surface.
    pub group: String,
    /// Index of its material.
    pub material: usize,
    /// Fiber angle \[deg\]; `None` if the cells have different ones.
    pub fiber_angle: Option<f64>,
    /// Plane angle \[deg\]; `None` if the cells have different ones.
    pub plane_angle: Option<f64>,
}

/// Orientation of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelCell {
    /// Number of the cell.
    pub tag: u64,
    /// Index of its region.
    pub region: usize,
    /// Fiber angle \[deg\].
    pub fiber_angle: f64,
    /// Plane angle \[deg\].
    pub plane_angle: f64,
}

/// Layup of an element as a file gives it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Layup {
    /// Line of its row.
    pub line: usize,
    pub element: u64,
    /// Number of the material in the file.
    pub material: u64,
    pub fiber_angle: f64,
    pub plane_angle: f64,
}

/// The content of a file.
#[derive(Debug, Default)]
pub(super) struct Raw {
    pub elements: Elements,
    /// Materials by their number in the file.
    pub materials: BTreeMap<u64, ModelMaterial>,
    pub layups: Vec<Layup>,
    pub notes: Vec<String>,
}

impl Raw {
    /// The model; problems of elements and of layups are noted, which may be in two files.
    pub(super) fn finish(mut self, elements: &mut Problems, layups: &mut Problems) -> Model {
        let mut model = Model::default();
        let mut parts = self.elements.parts(elements, &mut self.notes);
        let index_of: HashMap<u64, usize> = self.materials.keys().copied().zip(0..).collect();
        let of_layup = |layup: &Layup| index_of.get(&layup.material).copied();
        let mut angles: Vec<Vec<u64>> = vec![Vec::new(); index_of.len()];
        for layup in &mut self.layups {
            // one zero: -0.0 is no further angle
            layup.fiber_angle += 0.0;
            if let Some(known) = of_layup(layup).and_then(|index| angles.get_mut(index)) {
                let bits = layup.fiber_angle.to_bits();
                if known.len() <= FEW && !known.contains(&bits) {
                    known.push(bits);
                }
            }
        }
        model.materials = self.materials.into_values().collect();
        let mut regions = Regions::default();
        for layup in &self.layups {
            let Some(material) = of_layup(layup) else {
                let problem = FileProblem::Unknown {
                    who: format!("the layup of element {}", layup.element),
                    what: "material",
                    number: layup.material,
                };
                layups.push(layup.line, problem);
                continue;
            };
            let are_few = angles.get(material).is_none_or(|known| known.len() <= FEW);
            let name = model
                .materials
                .get(material)
                .map(|material| &*material.name);
            let set = regions.of(&mut parts, (material, name.unwrap_or("")), layup, are_few);
            if !parts.assign(layup.element, set) {
                let problem = FileProblem::Unknown {
                    who: "a layup".to_owned(),
                    what: "element",
                    number: layup.element,
                };
                layups.push(layup.line, problem);
            }
        }
        model.regions = regions.regions;
        model.cells = regions.cells;
        model.mesh = parts.finish(elements);
        for cell in &model.mesh.cells {
            let found = cell.groups.as_slice().len();
            if found != 1 {
                let element = cell.tag;
                layups.push(1, FileProblem::Layups { element, found });
            }
        }
        model.notes = self.notes;
        model
    }
}

/// The regions so far.
#[derive(Debug, Default)]
struct Regions {
    /// By material and the bits of the fiber angle, if it has few of them.
    index: HashMap<(usize, Option<u64>), (usize, usize)>,
    regions: Vec<ModelRegion>,
    cells: Vec<ModelCell>,
}

impl Regions {
    /// The set of the region of a layup, which is made if it does not exist.
    fn of(
        &mut self,
        parts: &mut Parts,
        (material, name): (usize, &str),
        layup: &Layup,
        are_few: bool,
    ) -> usize {
        let (fiber_angle, plane_angle) = (layup.fiber_angle, layup.plane_angle);
        let key = (material, are_few.then(|| fiber_angle.to_bits()));
        let (region, set) = *self.index.entry(key).or_insert_with(|| {
            let group = if are_few {
                format!("{name} at {fiber_angle} deg")
            } else {
                name.to_owned()
            };
            self.regions.push(ModelRegion {
                group: group.clone(),
                material,
                fiber_angle: Some(fiber_angle),
                plane_angle: Some(plane_angle),
            });
            (self.regions.len() - 1, parts.set(Some(group), None))
        });
        if let Some(known) = self.regions.get_mut(region) {
            known.fiber_angle = known.fiber_angle.filter(|angle| *angle == fiber_angle);
            known.plane_angle = known.plane_angle.filter(|angle| *angle == plane_angle);
        }
        self.cells.push(ModelCell {
            tag: layup.element,
            region,
            fiber_angle,
            plane_angle,
        });
        set
    }
}
