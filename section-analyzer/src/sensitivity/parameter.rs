//! What derivatives are taken with respect to.

use thiserror::Error;

use crate::material::{Constant, ElasticLaw};
use crate::section::Section;
use shared_geom::error::Explain;

/// What a derivative is taken with respect to.
#[derive(Debug, Clone, PartialEq)]
pub enum Parameter {
    /// A constant of a material.
    Constant {
        /// Index into [`Section::materials`].
        material: usize,
        /// Which of its constants.
        constant: Constant,
    },
    /// The fiber angles of cells, all by the same amount; a unit is a radian.
    FiberAngle(Cells),
    /// The plane angles of cells, all by the same amount; a unit is a radian.
    PlaneAngle(Cells),
    /// A coordinate of a node; a unit is a meter.
    Node {
        /// Index of the node in the mesh.
        node: usize,
        /// Which coordinate.
        axis: Axis,
    },
    /// A motion of nodes, as a change of shape: all others stand still.
    Motion(Vec<NodeVelocity>),
}

/// Some cells of a section.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cells {
    /// Those of a physical group, by its index in the mesh.
    Region(usize),
    /// Those of a list of indices in the mesh.
    List(Vec<usize>),
}

/// A coordinate in the section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// y.
    Y,
    /// z.
    Z,
}

/// How a node moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeVelocity {
    /// Index of the node in the mesh.
    pub node: usize,
    /// Displacement along y per unit of the parameter \[m\].
    pub y: f64,
    /// Displacement along z per unit of the parameter \[m\].
    pub z: f64,
}

/// Why there are no derivatives.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SensitivityProblem {
    /// A material that the section does not have.
    #[error("material number {found}: the section has {count}")]
    NoMaterial {
        /// The index asked for, from zero.
        found: usize,
        /// Number of materials.
        count: usize,
    },
    /// A constant that the law of the material does not have.
    #[error("constant \"{constant}\": material \"{material}\" has {known}")]
    NoConstant {
        /// Name of the constant asked for.
        constant: String,
        /// Name of the material.
        material: String,
        /// Names of the constants that it has.
        known: String,
    },
    /// A region that the mesh does not have.
    #[error("region number {found}: the mesh has {count}")]
    NoRegion {
        /// The index asked for, from zero.
        found: usize,
        /// Number of regions.
        count: usize,
    },
    /// A cell that the mesh does not have.
    #[error("cell number {found}: the mesh has {count}")]
    NoCell {
        /// The index asked for, from zero.
        found: usize,
        /// Number of cells.
        count: usize,
    },
    /// A node that the mesh does not have, or that belongs to no cell.
    #[error("node number {found}: no cell of the section has it")]
    NoNode {
        /// The index asked for, from zero.
        found: usize,
    },
    /// A motion that is not a number.
    #[error("the motion of node number {node} is not finite")]
    NotFinite {
        /// Index of the node.
        node: usize,
    },
    /// No memory.
    #[error("out of memory with {unknowns} unknowns")]
    OutOfMemory {
        /// Number of warping unknowns.
        unknowns: usize,
    },
}

impl Explain for SensitivityProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::NoNode { .. } => "give a node at a corner or a side of a cell",
            Self::OutOfMemory { .. } => "use a coarser mesh",
            _ => return None,
        };
        Some(help.to_owned())
    }
}

impl Parameter {
    /// The constants of all materials that have cells, then the fiber and the plane
    /// angle of every region whose material has directions.
    pub fn of_section(section: &Section) -> Vec<Self> {
        let materials = section.materials.iter().enumerate();
        let is_used = |index: usize| section.cells.iter().any(|cell| cell.material == index);
        let constants =
            materials
                .filter(|(index, _)| is_used(*index))
                .flat_map(|(material, of)| {
                    let constants = of.constants().into_iter();
                    constants.map(move |constant| Self::Constant { material, constant })
                });
        let regions = (0..section.mesh.groups.len()).filter(|&group| has_direction(section, group));
        let angles = regions.flat_map(|group| {
            [
                Self::FiberAngle(Cells::Region(group)),
                Self::PlaneAngle(Cells::Region(group)),
            ]
        });
        constants.chain(angles).collect()
    }

    /// A few words: `e1 of graphite`, `fiber angle of skin`, `y of node 12`.
    pub fn name(&self, section: &Section) -> String {
        let of_cells = |cells: &Cells| match cells {
            Cells::Region(group) => section.mesh.groups.get(*group).cloned().unwrap_or_default(),
            Cells::List(list) => format!("{} cells", list.len()),
        };
        match self {
            Self::Constant { material, constant } => {
                let material = section.materials.get(*material);
                let material = material.map_or("", |material| &material.name);
                format!("{} of {material}", constant.name())
            }
            Self::FiberAngle(cells) => format!("fiber angle of {}", of_cells(cells)),
            Self::PlaneAngle(cells) => format!("plane angle of {}", of_cells(cells)),
            Self::Node { node, axis } => {
                let axis = match axis {
                    Axis::Y => "y",
                    Axis::Z => "z",
                };
                let tag = section.mesh.node_tags.get(*node);
                format!("{axis} of node {}", tag.copied().unwrap_or(*node as u64))
            }
            Self::Motion(nodes) => format!("motion of {} nodes", nodes.len()),
        }
    }

    /// Whether the section has what the parameter speaks of.
    pub(super) fn check(&self, section: &Section) -> Result<(), SensitivityProblem> {
        match self {
            Self::Constant { material, constant } => check_constant(section, *material, *constant),
            Self::FiberAngle(cells) | Self::PlaneAngle(cells) => check_cells(section, cells),
            Self::Node { .. } | Self::Motion(_) => {
                let bad = self.motion().into_iter().find(|at| {
                    let is_finite = at.y.is_finite() && at.z.is_finite();
                    !is_finite
                });
                bad.map_or(Ok(()), |at| {
                    Err(SensitivityProblem::NotFinite { node: at.node })
                })
            }
        }
    }

    /// How the nodes move.
    pub(super) fn motion(&self) -> Vec<NodeVelocity> {
        match self {
            Self::Node { node, axis } => {
                let [y, z] = match axis {
                    Axis::Y => [1.0, 0.0],
                    Axis::Z => [0.0, 1.0],
                };
                vec![NodeVelocity { node: *node, y, z }]
            }
            Self::Motion(nodes) => nodes.clone(),
            _ => Vec::new(),
        }
    }
}

/// Whether the material of a cell of the region is not isotropic.
fn has_direction(section: &Section, group: usize) -> bool {
    let mut cells = section.mesh.cells.iter().zip(&section.cells);
    cells.any(|(cell, of)| {
        let law = &section.materials[of.material].law;
        let isotropic = matches!(law, ElasticLaw::Isotropic { .. });
        cell.group == group && !isotropic
    })
}

fn check_constant(
    section: &Section,
    material: usize,
    constant: Constant,
) -> Result<(), SensitivityProblem> {
    let count = section.materials.len();
    let Some(of) = section.materials.get(material) else {
        return Err(SensitivityProblem::NoMaterial {
            found: material,
            count,
        });
    };
    match of.value(constant) {
        Some(_) => Ok(()),
        None => {
            let known: Vec<_> = of.constants().into_iter().map(Constant::name).collect();
            Err(SensitivityProblem::NoConstant {
                constant: constant.name(),
                material: of.name.clone(),
                known: known.join(", "),
            })
        }
    }
}

fn check_cells(section: &Section, cells: &Cells) -> Result<(), SensitivityProblem> {
    match cells {
        Cells::Region(group) => {
            let count = section.mesh.groups.len();
            match *group < count {
                true => Ok(()),
                false => Err(SensitivityProblem::NoRegion {
                    found: *group,
                    count,
                }),
            }
        }
        Cells::List(list) => {
            let count = section.mesh.cells.len();
            let missing = list.iter().find(|&&cell| cell >= count);
            missing.map_or(Ok(()), |&found| {
                Err(SensitivityProblem::NoCell { found, count })
            })
        }
    }
}
