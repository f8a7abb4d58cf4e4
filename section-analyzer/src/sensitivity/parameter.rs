//! Parameters of derivatives.

use thiserror::Error;

use crate::material::{Constant, ElasticLaw};
use crate::section::Section;
use shared_geom::error::Explain;

/// A parameter of a derivative.
#[derive(Debug, Clone, PartialEq)]
pub enum Parameter {
    /// A constant of a material.
    Constant {
        /// Index into [`Section::materials`].
        material: usize,
        /// The constant of the material.
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
        /// The coordinate.
        axis: Axis,
    },
    /// A coordinate of a node of the mesh file, with all nodes and angles that depend on
    /// it; a unit is a meter.
    MeshNode(MeshNode),
    /// A change of shape.
    Motion(Motion),
}

/// A coordinate of a node of the mesh file, and the motion that depends on it.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshNode {
    /// Tag of the node in the mesh file.
    pub tag: u64,
    /// The coordinate.
    pub axis: Axis,
    /// Its value \[m\].
    pub value: f64,
    /// The motion of the node, if cells have it, of the nodes that laminates generate from
    /// it, and of the plane angles that follow it.
    pub motion: Motion,
}

/// A change of shape.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Motion {
    /// The nodes that move; all others are fixed.
    pub nodes: Vec<NodeVelocity>,
    /// The cells whose plane angles change; all other angles are constant.
    pub turns: Vec<CellTurn>,
}

impl Motion {
    /// A motion of nodes with constant angles.
    pub fn of_nodes(nodes: Vec<NodeVelocity>) -> Self {
        let turns = Vec::new();
        Self { nodes, turns }
    }
}

/// The change of the plane angle of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CellTurn {
    /// Index of the cell in the mesh.
    pub cell: usize,
    /// Change per unit of the parameter \[rad per unit of the parameter\].
    pub rate: f64,
}

/// Some cells of a section.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cells {
    /// The cells of a physical group, by its index in the mesh.
    Region(usize),
    /// A list of indices in the mesh.
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

/// The motion of a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeVelocity {
    /// Index of the node in the mesh.
    pub node: usize,
    /// Displacement along y per unit of the parameter \[m\].
    pub y: f64,
    /// Displacement along z per unit of the parameter \[m\].
    pub z: f64,
}

/// Reason why there are no derivatives.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SensitivityProblem {
    /// A material that the section does not have.
    #[error("material number {found}: the section has {count}")]
    NoMaterial {
        /// The requested index, from zero.
        found: usize,
        /// Number of materials.
        count: usize,
    },
    /// A constant that the law of the material does not have.
    #[error("constant \"{constant}\": material \"{material}\" has {known}")]
    NoConstant {
        /// Name of the requested constant.
        constant: String,
        /// Name of the material.
        material: String,
        /// Names of the constants that it has.
        known: String,
    },
    /// A region that the mesh does not have.
    #[error("region number {found}: the mesh has {count}")]
    NoRegion {
        /// The requested index, from zero.
        found: usize,
        /// Number of regions.
        count: usize,
    },
    /// A cell that the mesh does not have.
    #[error("cell number {found}: the mesh has {count}")]
    NoCell {
        /// The requested index, from zero.
        found: usize,
        /// Number of cells.
        count: usize,
    },
    /// A node that the mesh does not have, or that belongs to no cell.
    #[error("node number {found}: no cell of the section has it")]
    NoNode {
        /// The requested index, from zero.
        found: usize,
    },
    /// A motion that is not a number.
    #[error("the motion of node number {node} is not finite")]
    NotFinite {
        /// Index of the node.
        node: usize,
    },
    /// A change of an angle that is not a number.
    #[error("the change of the plane angle of cell number {cell} is not finite")]
    TurnNotFinite {
        /// Index of the cell.
        cell: usize,
    },
    /// Insufficient memory.
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

    /// Short text: `e1 of graphite`, `fiber angle of skin`, `y of node 12`.
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
                let tag = section.mesh.node_tags.get(*node).copied();
                name_of_node(tag.unwrap_or(*node as u64), *axis)
            }
            Self::MeshNode(MeshNode { tag, axis, .. }) => name_of_node(*tag, *axis),
            Self::Motion(motion) => format!("motion of {} nodes", motion.nodes.len()),
        }
    }

    /// Checks that the section has the object of the parameter.
    pub(super) fn check(&self, section: &Section) -> Result<(), SensitivityProblem> {
        match self {
            Self::Constant { material, constant } => check_constant(section, *material, *constant),
            Self::FiberAngle(cells) | Self::PlaneAngle(cells) => check_cells(section, cells),
            Self::Node { .. } | Self::MeshNode(_) | Self::Motion(_) => {
                self.motion().map_or(Ok(()), |motion| motion.check(section))
            }
        }
    }

    /// The change of shape, if the parameter is one.
    pub(super) fn motion(&self) -> Option<Motion> {
        match self {
            Self::Node { node, axis } => {
                let [y, z] = match axis {
                    Axis::Y => [1.0, 0.0],
                    Axis::Z => [0.0, 1.0],
                };
                Some(Motion::of_nodes(vec![NodeVelocity { node: *node, y, z }]))
            }
            Self::MeshNode(MeshNode { motion, .. }) | Self::Motion(motion) => Some(motion.clone()),
            _ => None,
        }
    }
}

fn name_of_node(tag: u64, axis: Axis) -> String {
    let axis = match axis {
        Axis::Y => "y",
        Axis::Z => "z",
    };
    format!("{axis} of node {tag}")
}

impl Motion {
    fn check(&self, section: &Section) -> Result<(), SensitivityProblem> {
        let is_finite = |at: &&NodeVelocity| at.y.is_finite() && at.z.is_finite();
        if let Some(at) = self.nodes.iter().find(|at| !is_finite(at)) {
            return Err(SensitivityProblem::NotFinite { node: at.node });
        }
        if let Some(turn) = self.turns.iter().find(|turn| !turn.rate.is_finite()) {
            return Err(SensitivityProblem::TurnNotFinite { cell: turn.cell });
        }
        let cells = self.turns.iter().map(|turn| turn.cell).collect();
        check_cells(section, &Cells::List(cells))
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
            if *group < count {
                Ok(())
            } else {
                Err(SensitivityProblem::NoRegion {
                    found: *group,
                    count,
                })
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
