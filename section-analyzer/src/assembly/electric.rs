//! The electric part of a domain: nodes with a potential, and electrodes.
//!
//! A node of a dielectric cell has a potential in addition to its three displacements.
//! Unknowns are the displacements of all nodes, node by node, followed by the potentials in
//! the order of their nodes.

use super::cell::DomainCell;
use super::scaling::{Scaling, largest, power_of_two};
use crate::material::{CoupledLaw, coupled_law, material_axes, turned_coupling};
use crate::section::{CellMaterial, ElectrodeShape, FingeredCell, Section};
use nalgebra::Vector6;

/// No potential.
const NONE: u32 = u32::MAX;

/// The electric part of a domain; empty without conductors.
#[derive(Debug, Clone, Default)]
pub struct Electric {
    /// For each node the number of its potential.
    potential_of_node: Vec<u32>,
    /// Number of potentials.
    count: usize,
    /// Whether each node is part of a cell with stiffness; empty if all nodes are.
    is_structural: Vec<bool>,
    /// Laws of dielectric cells in section axes, in units of stress \[-\].
    pub laws: Vec<CoupledLaw>,
    /// The electrodes of the section, in its order.
    pub electrodes: Vec<DomainElectrode>,
}

/// An electrode in a domain.
#[derive(Debug, Clone, Default)]
pub struct DomainElectrode {
    /// Nodes of a conductor.
    pub nodes: Vec<u32>,
    /// Cells between fingers.
    pub fingered: Vec<Fingered>,
}

/// A cell between fingers in a domain, per volt of its electrode.
#[derive(Debug, Clone, Copy)]
pub struct Fingered {
    /// Index of the cell in the mesh.
    pub mesh_cell: u32,
    /// e' E: stress that the field subtracts, order yz yy zz xx xy xz \[-\].
    pub stress: Vector6<f64>,
    /// E' epsS E: charge per volume and volt at zero strain \[-\].
    pub charge: f64,
}

impl Electric {
    /// Number of potentials.
    pub fn potentials(&self) -> usize {
        self.count
    }

    /// The number of the potential of `node`; `None` for a node without a dielectric cell.
    pub fn potential(&self, node: usize) -> Option<usize> {
        match self.potential_of_node.get(node) {
            None | Some(&NONE) => None,
            Some(&potential) => Some(potential as usize),
        }
    }

    /// Whether every node is part of a cell with stiffness.
    pub fn is_all_structural(&self) -> bool {
        self.is_structural.is_empty()
    }

    /// Whether `node` is part of a cell with stiffness.
    pub fn is_structural(&self, node: usize) -> bool {
        self.is_structural.get(node).copied().unwrap_or(true)
    }

    /// The same with the nodes in another order: `order` lists the present nodes.
    pub(super) fn renumbered(mut self, order: &[u32], index: &[u32]) -> Self {
        let has_potential = |&old: &u32| self.potential(old as usize).is_some();
        let has: Vec<bool> = order.iter().map(has_potential).collect();
        self.potential_of_node = numbered(&has);
        if !self.is_structural.is_empty() {
            let in_order = order.iter().map(|&old| self.is_structural[old as usize]);
            self.is_structural = in_order.collect();
        }
        for electrode in &mut self.electrodes {
            for node in &mut electrode.nodes {
                *node = index[*node as usize];
            }
        }
        self
    }
}

/// Numbers for the nodes that have a potential; empty if no node has one.
fn numbered(has: &[bool]) -> Vec<u32> {
    if !has.contains(&true) {
        return Vec::new();
    }
    let mut next = 0;
    let number = |&has: &bool| {
        if !has {
            return NONE;
        }
        next += 1;
        next - 1
    };
    has.iter().map(number).collect()
}

/// For each cell of the mesh whether it is a dielectric of the electric problem: cells with
/// an electric law that are not between fingers, if there are conductors.
pub fn dielectric_cells(section: &Section) -> Vec<bool> {
    let mut is_dielectric: Vec<bool> = section
        .cells
        .iter()
        .map(|made_of| section.materials[made_of.material].electric.is_some())
        .collect();
    let mut has_conductor = false;
    for electrode in &section.electrodes {
        match &electrode.shape {
            ElectrodeShape::Conductor { .. } => has_conductor = true,
            ElectrodeShape::Interdigitated { cells } => {
                for fingered in cells {
                    is_dielectric[fingered.cell as usize] = false;
                }
            }
        }
    }
    if !has_conductor {
        is_dielectric.fill(false);
    }
    is_dielectric
}

/// The unit of potential that gives stiffness and permittivity the same size, a power of
/// two \[V\]: `V0 = length sqrt(modulus / permittivity)`, one without dielectrics.
pub(super) fn potential_unit(section: &Section, length: f64, modulus: f64) -> f64 {
    let electric = section.materials.iter().filter_map(|m| m.electric.as_ref());
    let entries = electric.flat_map(|law| law.permittivity.iter());
    let permittivity = entries.map(|entry| entry.abs()).fold(0.0, largest);
    power_of_two(length * (modulus / permittivity).sqrt()).unwrap_or(1.0)
}

/// The electric part of `section`: `numbering` lists the mesh nodes of the domain, and for each
/// mesh node its index in that list. Sets the coupled laws of the cells of the domain, which are in
/// the order of the mesh.
pub(super) fn electric(
    section: &Section,
    scaling: &Scaling,
    numbering: (&[u32], &[u32]),
    cells: &mut [DomainCell],
) -> Electric {
    let mut electric = Electric::default();
    let is_dielectric = dielectric_cells(section);
    let nodes = numbering.0.len();
    let (mut has_potential, mut is_structural) = (vec![false; nodes], vec![false; nodes]);
    let mut last: Option<&CellMaterial> = None;
    for ((cell, made_of), is_dielectric) in cells.iter_mut().zip(&section.cells).zip(is_dielectric)
    {
        let material = &section.materials[made_of.material];
        if material.law.has_stiffness() {
            (cell.nodes().iter()).for_each(|&node| is_structural[node as usize] = true);
        }
        let (true, Some(law)) = (is_dielectric, &material.electric) else {
            continue;
        };
        (cell.nodes().iter()).for_each(|&node| has_potential[node as usize] = true);
        if last != Some(made_of) {
            let CellMaterial {
                fiber_angle,
                plane_angle,
                ..
            } = *made_of;
            let law = coupled_law(&material.law.stiffness(), law, fiber_angle, plane_angle);
            electric.laws.push(scaled(law, scaling));
            last = Some(made_of);
        }
        cell.coupled = Some(electric.laws.len() as u32 - 1);
    }
    electric.count = has_potential.iter().filter(|&&has| has).count();
    electric.potential_of_node = numbered(&has_potential);
    if is_structural.contains(&false) {
        electric.is_structural = is_structural;
    }
    let electrodes = section.electrodes.iter();
    let in_domain =
        electrodes.map(|electrode| shape(section, scaling, numbering, &electrode.shape));
    electric.electrodes = in_domain.collect();
    electric
}

/// A coupled law in the units of `scaling`.
fn scaled(mut law: CoupledLaw, scaling: &Scaling) -> CoupledLaw {
    let gradient = scaling.potential / scaling.length;
    for i in 0..9 {
        for j in 0..9 {
            let unit = |k: usize| if k < 6 { 1.0 } else { gradient };
            law[(i, j)] *= unit(i) * unit(j) / scaling.modulus;
        }
    }
    law
}

/// Nodes or cells of an electrode in the domain.
fn shape(
    section: &Section,
    scaling: &Scaling,
    (mesh_nodes, node_of_mesh): (&[u32], &[u32]),
    shape: &ElectrodeShape,
) -> DomainElectrode {
    match shape {
        ElectrodeShape::Conductor { nodes } => {
            let placed = nodes
                .iter()
                .map(|&node| (node, node_of_mesh[node as usize]));
            // nodes without a cell are not part of the domain
            let attached = placed.filter(|&(node, index)| mesh_nodes[index as usize] == node);
            let nodes = attached.map(|(_, index)| index);
            DomainElectrode {
                nodes: nodes.collect(),
                ..DomainElectrode::default()
            }
        }
        ElectrodeShape::Interdigitated { cells } => {
            let cells = cells.iter();
            DomainElectrode {
                fingered: cells
                    .filter_map(|cell| fingered(section, scaling, cell))
                    .collect(),
                ..DomainElectrode::default()
            }
        }
    }
}

/// A cell between fingers in the units of `scaling`; `None` for a cell without electric
/// law.
fn fingered(section: &Section, scaling: &Scaling, cell: &FingeredCell) -> Option<Fingered> {
    let CellMaterial {
        material,
        fiber_angle,
        plane_angle,
    } = *section.cells.get(cell.cell as usize)?;
    let law = section.materials[material].electric.as_ref()?;
    let coupling = turned_coupling(&law.coupling, fiber_angle, plane_angle);
    let axes = material_axes(fiber_angle, plane_angle);
    let stress = coupling.transpose() * (axes * cell.field);
    let charge = cell.field.dot(&(law.permittivity * cell.field));
    let volt = scaling.potential;
    Some(Fingered {
        mesh_cell: cell.cell,
        stress: volt / scaling.modulus * stress,
        charge: volt * volt / scaling.modulus * charge,
    })
}
