//! Changes of laws, densities and node positions per unit of a parameter, in the units of
//! the domain.

use std::collections::HashMap;

use super::parameter::{Cells, Motion, Parameter, SensitivityProblem};
use crate::assembly::{Domain, DomainCell};
use crate::material::{Constant, fiber_angle_rate, plane_angle_rate, section_stiffness};
use crate::section::{CellMaterial, Section};
use nalgebra::Matrix6;

/// The changes per unit of a parameter.
#[derive(Debug, Clone)]
pub(super) struct Change {
    /// The cells of the domain that it changes, ascending.
    pub cells: Vec<u32>,
    /// dD of the laws of these cells.
    laws: HashMap<u32, Matrix6<f64>>,
    /// dD of cells of the mesh with individual changes.
    of_cells: HashMap<u32, Matrix6<f64>>,
    /// Rate of the density of these cells \[kg/m^3 per unit of the parameter\].
    pub density: f64,
    /// Velocities of the nodes that move.
    nodes: HashMap<u32, [f64; 2]>,
}

impl Change {
    /// The changes of `parameters`.
    ///
    /// # Errors
    /// [`SensitivityProblem`] for the first parameter that the section does not have.
    pub fn of_parameters(
        section: &Section,
        domain: &Domain,
        parameters: &[Parameter],
    ) -> Result<Vec<Self>, SensitivityProblem> {
        let mut indices = DomainIndices::of(section, domain);
        let motions: Vec<_> = parameters.iter().map(Parameter::motion).collect();
        if motions.iter().any(Option::is_some) {
            indices.look_around(domain);
        }
        let changes = parameters.iter().zip(motions).map(|(parameter, motion)| {
            parameter.check(section)?;
            let at = (section, domain, &indices);
            match parameter {
                Parameter::Constant { material, constant } => {
                    Ok(Self::of_constant(at, *material, *constant))
                }
                Parameter::FiberAngle(cells) => {
                    Ok(Self::of_laws(at, &indices.of_cells(cells), |law, of| {
                        fiber_angle_rate(law, of.fiber_angle, of.plane_angle)
                    }))
                }
                Parameter::PlaneAngle(cells) => {
                    let cells = indices.of_cells(cells);
                    Ok(Self::of_laws(at, &cells, |law, _| plane_angle_rate(law)))
                }
                Parameter::Node { .. } | Parameter::MeshNode(_) | Parameter::Motion(_) => {
                    Self::of_motion(at, &motion.unwrap_or_default())
                }
            }
        });
        changes.collect()
    }

    /// dD of a cell of the domain.
    pub fn law(&self, cell: &DomainCell) -> Option<&Matrix6<f64>> {
        let of_law = self.laws.get(&cell.law);
        of_law.or_else(|| self.of_cells.get(&cell.mesh_cell))
    }

    /// Velocities of the nodes of a cell of the domain, if any node of the domain moves.
    pub fn velocities(&self, cell: &DomainCell) -> Option<[[f64; 2]; 9]> {
        if self.nodes.is_empty() {
            return None;
        }
        let mut velocities = [[0.0; 2]; 9];
        for (velocity, node) in velocities.iter_mut().zip(cell.nodes()) {
            *velocity = self.nodes.get(node).copied().unwrap_or_default();
        }
        Some(velocities)
    }

    fn of_constant(
        at: (&Section, &Domain, &DomainIndices),
        material: usize,
        constant: Constant,
    ) -> Self {
        let (section, domain, indices) = at;
        let cells = &indices.of_material[material];
        if constant == Constant::Density {
            return Self {
                cells: cells.clone(),
                laws: HashMap::new(),
                of_cells: HashMap::new(),
                density: 1.0,
                nodes: HashMap::new(),
            };
        }
        let rate = section.materials[material].law.derivative(constant) / domain.scaling.modulus;
        Self::of_laws(at, cells, |_, of| {
            section_stiffness(&rate, of.fiber_angle, of.plane_angle)
        })
    }

    /// The changes of the laws of `cells`, one per law.
    fn of_laws(
        (section, domain, _): (&Section, &Domain, &DomainIndices),
        cells: &[u32],
        rate: impl Fn(&Matrix6<f64>, &CellMaterial) -> Matrix6<f64>,
    ) -> Self {
        let mut laws = HashMap::new();
        for &cell in cells {
            let DomainCell { law, mesh_cell, .. } = domain.cells[cell as usize];
            laws.entry(law).or_insert_with(|| {
                rate(
                    &domain.laws[law as usize],
                    &section.cells[mesh_cell as usize],
                )
            });
        }
        Self {
            cells: cells.to_vec(),
            laws,
            of_cells: HashMap::new(),
            density: 0.0,
            nodes: HashMap::new(),
        }
    }

    fn of_motion(
        (_, domain, indices): (&Section, &Domain, &DomainIndices),
        motion: &Motion,
    ) -> Result<Self, SensitivityProblem> {
        let mut nodes: HashMap<u32, [f64; 2]> = HashMap::new();
        let mut cells = Vec::new();
        for at in &motion.nodes {
            let node = indices.of_node(at.node)?;
            let velocity = nodes.entry(node).or_default();
            velocity[0] += at.y / domain.scaling.length;
            velocity[1] += at.z / domain.scaling.length;
            cells.extend(indices.around(node));
        }
        let mut of_cells: HashMap<u32, Matrix6<f64>> = HashMap::new();
        for turn in &motion.turns {
            let index = indices.of_mesh_cell[turn.cell];
            let cell = &domain.cells[index as usize];
            let rate = turn.rate * plane_angle_rate(&domain.laws[cell.law as usize]);
            *of_cells.entry(cell.mesh_cell).or_default() += rate;
            cells.push(index);
        }
        cells.sort_unstable();
        cells.dedup();
        Ok(Self {
            cells,
            laws: HashMap::new(),
            of_cells,
            density: 0.0,
            nodes,
        })
    }
}

/// Indices of the cells and nodes of the mesh in the domain.
struct DomainIndices {
    of_material: Vec<Vec<u32>>,
    of_region: Vec<Vec<u32>>,
    /// Cells of the domain, by their index in the mesh.
    of_mesh_cell: Vec<u32>,
    /// Nodes of the domain, by their index in the mesh; empty until required.
    nodes: HashMap<u32, u32>,
    /// Cells around each node of the domain: pairs, ascending; empty until required.
    around: Vec<(u32, u32)>,
}

impl DomainIndices {
    fn of(section: &Section, domain: &Domain) -> Self {
        let mut indices = Self {
            of_material: vec![Vec::new(); section.materials.len()],
            of_region: vec![Vec::new(); section.mesh.groups.len()],
            of_mesh_cell: vec![0; domain.cells.len()],
            nodes: HashMap::new(),
            around: Vec::new(),
        };
        for (index, cell) in (0..).zip(&domain.cells) {
            let mesh_cell = cell.mesh_cell as usize;
            indices.of_material[section.cells[mesh_cell].material].push(index);
            indices.of_region[section.mesh.cells[mesh_cell].group].push(index);
            indices.of_mesh_cell[mesh_cell] = index;
        }
        indices
    }

    /// Finds the nodes, and the cells around them.
    fn look_around(&mut self, domain: &Domain) {
        self.nodes = domain.mesh_nodes.iter().copied().zip(0..).collect();
        for (index, cell) in (0..).zip(&domain.cells) {
            let pairs = cell.nodes().iter().map(|&node| (node, index));
            self.around.extend(pairs);
        }
        self.around.sort_unstable();
    }

    /// Cells of the domain, ascending, each once.
    fn of_cells(&self, cells: &Cells) -> Vec<u32> {
        match cells {
            Cells::Region(group) => self.of_region[*group].clone(),
            Cells::List(list) => {
                let mut found: Vec<_> = list.iter().map(|&cell| self.of_mesh_cell[cell]).collect();
                found.sort_unstable();
                found.dedup();
                found
            }
        }
    }

    fn of_node(&self, node: usize) -> Result<u32, SensitivityProblem> {
        let index = u32::try_from(node).ok();
        let found = index.and_then(|node| self.nodes.get(&node));
        found
            .copied()
            .ok_or(SensitivityProblem::NoNode { found: node })
    }

    fn around(&self, node: u32) -> impl Iterator<Item = u32> {
        let first = self.around.partition_point(|&(other, _)| other < node);
        let of_node = self.around[first..]
            .iter()
            .take_while(move |&&(other, _)| other == node);
        of_node.map(|&(_, cell)| cell)
    }
}
