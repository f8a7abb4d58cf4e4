//! Nodal forces of distributed loads, per length of the beam.
//!
//! ```text
//! f_j = sum over the parts of d^j q/dx^j int N' b J dA + d^j q/dx^j int N' t dS   (S-101)
//! ```
//!
//! b is a force per volume, t a force per area of the surface, dS as in (S-102); the sides
//! have the shape functions of their cells.

use super::domain::Domain;
use crate::element::{cell_points, side_points};
use crate::mesh::{Bank, CurveSide};
use crate::section::{Action, DistributedLoad, Section, Traction, VolumeForce};
use nalgebra::{DMatrix, Vector3};

/// f_0, f_1, ...: forces at the unknowns and their derivatives along the beam at x = 0,
/// n x 6 each, in the units of the domain of `section`; a column for each of up to six
/// `loads` \[-\].
pub fn distributed_forces(
    section: &Section,
    domain: &Domain,
    loads: &[&DistributedLoad],
) -> Vec<DMatrix<f64>> {
    let terms = loads.iter().map(|load| load.terms()).max().unwrap_or(0);
    let mut forces = vec![DMatrix::zeros(domain.unknowns(), 6); terms];
    let nodes = NodesOfMesh::new(section, domain);
    let length = domain.scaling.length;
    for (case, load) in loads.iter().enumerate().take(6) {
        for part in &load.parts {
            let unit = nodes.of_action(&part.action);
            for (order, forces) in forces.iter_mut().enumerate() {
                // x counts in the unit of length of the domain
                let factor = part.derivative(order) * length.powi(order as i32);
                for &(node, force) in &unit {
                    let mut at_node = forces.fixed_view_mut::<3, 1>(3 * node, case);
                    at_node += factor * force;
                }
            }
        }
    }
    forces
}

/// The section with the index of each mesh node in its domain.
struct NodesOfMesh<'a> {
    section: &'a Section,
    domain: &'a Domain,
    node_of_mesh: Vec<usize>,
}

/// Forces with the nodes of the domain that they act on.
type NodalForces = Vec<(usize, Vector3<f64>)>;

impl<'a> NodesOfMesh<'a> {
    fn new(section: &'a Section, domain: &'a Domain) -> Self {
        let mut node_of_mesh = vec![0; section.mesh.nodes.len()];
        for (node, &mesh_node) in domain.mesh_nodes.iter().enumerate() {
            node_of_mesh[mesh_node as usize] = node;
        }
        Self {
            section,
            domain,
            node_of_mesh,
        }
    }

    fn of_action(&self, action: &Action) -> NodalForces {
        match action {
            Action::Traction { sides, traction } => self.of_traction(sides, traction),
            Action::Volume { group, force } => self.of_volume(*group, force),
        }
    }

    /// The indices of the nodes in the domain, and their positions there.
    fn placed(&self, nodes: &[u32]) -> (Vec<usize>, Vec<[f64; 2]>) {
        let nodes = nodes.iter().map(|&node| self.node_of_mesh[node as usize]);
        let nodes: Vec<_> = nodes.collect();
        let positions = nodes.iter().map(|&node| self.domain.nodes[node]).collect();
        (nodes, positions)
    }

    fn of_traction(&self, sides: &[CurveSide], traction: &Traction) -> NodalForces {
        let line = &self.domain.line;
        let unit = 1.0 / self.domain.scaling.modulus;
        let mut forces = Vec::new();
        for side in sides {
            let (nodes, positions) = self.placed(side.nodes());
            for point in side_points(line, &positions) {
                let area = point.surface.norm();
                let force = match traction {
                    Traction::Force(force) => area * force,
                    Traction::Tangential(size) => area * *size * point.tangent,
                    Traction::Pressure(size) => match side.bank {
                        Bank::Left => -*size * point.surface,
                        Bank::Right => *size * point.surface,
                        // pressed from both sides
                        Bank::Both => Vector3::zeros(),
                    },
                };
                let shares = nodes.iter().zip(&point.n);
                forces.extend(shares.map(|(&node, n)| (node, unit * *n * force)));
            }
        }
        forces
    }

    fn of_volume(&self, group: Option<usize>, force: &VolumeForce) -> NodalForces {
        let Self {
            section, domain, ..
        } = self;
        let unit = domain.scaling.length / domain.scaling.modulus;
        let mut forces = Vec::new();
        for (cell, made_of) in section.mesh.cells.iter().zip(&section.cells) {
            if group.is_some_and(|group| group != cell.group) {
                continue;
            }
            let force = match force {
                VolumeForce::Force(force) => *force,
                VolumeForce::Acceleration(acceleration) => {
                    section.materials[made_of.material].density * acceleration
                }
            };
            let (nodes, positions) = self.placed(cell.nodes());
            for point in cell_points(cell.kind, &positions) {
                let volume = point.area * domain.line.metric(point.y, point.z).volume;
                let shares = nodes.iter().zip(&point.n);
                forces.extend(shares.map(|(&node, n)| (node, unit * volume * *n * force)));
            }
        }
        forces
    }
}
