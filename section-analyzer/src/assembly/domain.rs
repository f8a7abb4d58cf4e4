//! The section in the solver's form: nodes that belong to a cell, coordinates from the area
//! centroid in units of the section's size, laws in section axes in units of the largest
//! stiffness.
//!
//! All matrices of the problem are then dimensionless and of order one, for any units,
//! size, position and moduli of the section: a section of 1 mm at 100 m from the origin and
//! one of 10 m around it are solved with the same digits. Units of length and modulus are
//! powers of two, so that scaling is exact.

use super::cell::DomainCell;
use super::electric::{Electric, electric, potential_unit};
use super::scaling::{Scaling, largest, power_of_two};
use crate::element::{Line, rule_points};
use crate::failure::Failure;
use crate::material::section_stiffness;
use crate::section::{CellMaterial, Section};
use nalgebra::Matrix6;

/// The section in the units of the solver.
#[derive(Debug, Clone)]
pub struct Domain {
    /// Positions (y, z) of the nodes from the area centroid, in units of length \[-\].
    pub nodes: Vec<[f64; 2]>,
    /// For each node its index in the mesh of the section.
    pub mesh_nodes: Vec<u32>,
    /// Cells, in the order of the mesh.
    pub cells: Vec<DomainCell>,
    /// Laws in section axes, order yz yy zz xx xy xz, in units of stress \[-\].
    pub laws: Vec<Matrix6<f64>>,
    /// The units.
    pub scaling: Scaling,
    /// The line of the beam through the origin of the domain, in its unit of length.
    pub line: Line,
    /// Potentials and electrodes.
    pub electric: Electric,
}

impl Domain {
    /// Prepares `section` for assembly.
    ///
    /// # Errors
    /// [`Failure`] when the section has no cells, a cell lacks its material, or coordinates
    /// and stiffness leave no finite, positive scale; or the curvature is so large that the
    /// material folds over itself.
    pub fn new(section: &Section) -> Result<Self, Failure> {
        check_lists(section)?;
        let (laws, law_of_cell) = laws_in_section_axes(section);
        let (mesh_nodes, node_of_mesh) = attached_nodes(section);
        let scaling = Scaling {
            origin: area_centroid(section)?,
            length: 1.0,
            potential: 1.0,
            modulus: power_of_two(laws.iter().flatten().map(|c| c.abs()).fold(0.0, largest))
                .ok_or(Failure::NoScale { what: "stiffness" })?,
        };
        let length = length_unit(section, &mesh_nodes, scaling.origin)?;
        let scaling = Scaling {
            length,
            potential: potential_unit(section, length, scaling.modulus),
            ..scaling
        };

        let position = |&node: &u32| {
            let [y, z] = section.mesh.nodes[node as usize];
            [
                (y - scaling.origin[0]) / scaling.length,
                (z - scaling.origin[1]) / scaling.length,
            ]
        };
        let cells = section
            .mesh
            .cells
            .iter()
            .zip(&section.cells)
            .zip(law_of_cell)
            .zip(0..);
        let cells = cells.map(|(((cell, made_of), law), mesh_cell)| DomainCell {
            tag: cell.tag,
            mesh_cell,
            kind: cell.kind,
            law,
            coupled: None,
            density: section.materials[made_of.material].density,
            nodes: renumbered(cell.nodes(), &node_of_mesh),
        });
        let mut cells: Vec<DomainCell> = cells.collect();
        let numbering = (&mesh_nodes[..], &node_of_mesh[..]);
        let electric = electric(section, &scaling, numbering, &mut cells);
        let domain = Self {
            nodes: mesh_nodes.iter().map(position).collect(),
            cells,
            electric,
            laws: laws.iter().map(|law| law / scaling.modulus).collect(),
            mesh_nodes,
            scaling,
            line: Line::through(&section.initial_curvature, scaling.origin, scaling.length),
        };
        domain.check_unfolded(section)?;
        Ok(domain)
    }

    /// Requires a positive J at the nodes and at the integration points of every cell.
    fn check_unfolded(&self, section: &Section) -> Result<(), Failure> {
        if self.line.is_straight() {
            return Ok(());
        }
        for cell in &self.cells {
            let positions = self.positions(cell);
            let positions = &positions[..cell.kind.node_count()];
            let points = rule_points(cell.kind).iter().map(|point| {
                let point = point.of_cell(positions);
                [point.y, point.z]
            });
            for [y, z] in points.chain(positions.iter().copied()) {
                let volume = self.line.metric(y, z).volume;
                let is_positive = volume > 0.0;
                if !is_positive {
                    let Scaling { origin, length, .. } = self.scaling;
                    return Err(Failure::Folded {
                        tag: cell.tag,
                        y: origin[0] + length * y,
                        z: origin[1] + length * z,
                        volume,
                        curvature: section.initial_curvature.curvature.into(),
                    });
                }
            }
        }
        Ok(())
    }

    /// The same domain with its nodes in another order, and the cells in the order of their
    /// nodes: `order` lists the present nodes, each once.
    pub fn renumbered(mut self, order: &[u32]) -> Self {
        let mut position = vec![0; order.len()];
        for (new, &old) in order.iter().enumerate() {
            position[old as usize] = new as u32;
        }
        let positions = order.iter().map(|&old| self.nodes[old as usize]);
        self.nodes = positions.collect();
        let mesh_nodes = order.iter().map(|&old| self.mesh_nodes[old as usize]);
        self.mesh_nodes = mesh_nodes.collect();
        self.electric = self.electric.renumbered(order, &position);
        for cell in &mut self.cells {
            let count = cell.kind.node_count();
            for node in &mut cell.nodes[..count] {
                *node = position[*node as usize];
            }
        }
        // cells in the order of their nodes: sums over cells access neighboring memory
        self.cells
            .sort_by_key(|cell| cell.nodes().iter().copied().min());
        self
    }

    /// Number of unknowns: ux, uy, uz of each node, in this order, then the potentials.
    pub fn unknowns(&self) -> usize {
        3 * self.nodes.len() + self.electric.potentials()
    }

    /// The unknown of the potential of `node`; `None` for a node without a dielectric cell.
    #[inline(always)]
    pub fn potential_unknown(&self, node: usize) -> Option<usize> {
        let potential = self.electric.potential(node)?;
        Some(3 * self.nodes.len() + potential)
    }

    /// Positions of the nodes of `cell`; only the first `cell.kind.node_count()` entries
    /// are used.
    pub fn positions(&self, cell: &DomainCell) -> [[f64; 2]; 9] {
        cell.nodes.map(|node| self.nodes[node as usize])
    }
}

/// Requires that the material and the nodes of every cell exist.
fn check_lists(section: &Section) -> Result<(), Failure> {
    let mesh = &section.mesh;
    if mesh.cells.is_empty() {
        return Err(Failure::NoCells);
    }
    if mesh.cells.len() != section.cells.len() {
        return Err(Failure::CellsWithoutMaterial {
            cells: mesh.cells.len(),
            materials: section.cells.len(),
        });
    }
    for (cell, made_of) in mesh.cells.iter().zip(&section.cells) {
        let node_exists = |&node: &u32| (node as usize) < mesh.nodes.len();
        if made_of.material >= section.materials.len() || !cell.nodes().iter().all(node_exists) {
            return Err(Failure::DanglingCell { tag: cell.tag });
        }
    }
    Ok(())
}

/// The law of each cell; neighbors in the list with the same material and
/// angles share one.
fn laws_in_section_axes(section: &Section) -> (Vec<Matrix6<f64>>, Vec<u32>) {
    let stiffness: Vec<Matrix6<f64>> = section
        .materials
        .iter()
        .map(|material| material.law.stiffness())
        .collect();
    let mut laws = Vec::new();
    let mut law_of_cell = Vec::with_capacity(section.cells.len());
    let mut last: Option<&CellMaterial> = None;
    for made_of in &section.cells {
        if last != Some(made_of) {
            laws.push(section_stiffness(
                &stiffness[made_of.material],
                made_of.fiber_angle,
                made_of.plane_angle,
            ));
            last = Some(made_of);
        }
        law_of_cell.push(laws.len() as u32 - 1);
    }
    (laws, law_of_cell)
}

/// Mesh nodes that belong to a cell, and for each mesh node its index in that list.
fn attached_nodes(section: &Section) -> (Vec<u32>, Vec<u32>) {
    let mut attached = vec![false; section.mesh.nodes.len()];
    for cell in &section.mesh.cells {
        for &node in cell.nodes() {
            attached[node as usize] = true;
        }
    }
    let mut node_of_mesh = vec![0; attached.len()];
    let mut mesh_nodes = Vec::new();
    for (mesh_node, attached) in attached.into_iter().enumerate() {
        if attached {
            node_of_mesh[mesh_node] = mesh_nodes.len() as u32;
            mesh_nodes.push(mesh_node as u32);
        }
    }
    (mesh_nodes, node_of_mesh)
}

fn renumbered(nodes: &[u32], node_of_mesh: &[u32]) -> [u32; 9] {
    let mut out = [0; 9];
    for (out, &node) in out.iter_mut().zip(nodes) {
        *out = node_of_mesh[node as usize];
    }
    out
}

/// Area centroid of the corner polygons: close enough to the true centroid for the choice
/// of the origin.
fn area_centroid(section: &Section) -> Result<[f64; 2], Failure> {
    let mut area = 0.0;
    let mut moment = [0.0; 2];
    // the first node as local origin keeps the digits of a mesh far from its origin
    let base = section.mesh.nodes[section.mesh.cells[0].nodes()[0] as usize];
    for cell in &section.mesh.cells {
        let corners = &cell.nodes()[..cell.kind.corner_count()];
        let corner = |i: usize| {
            let [y, z] = section.mesh.nodes[corners[i % corners.len()] as usize];
            [y - base[0], z - base[1]]
        };
        let first = corner(0);
        for i in 1..corners.len() - 1 {
            let (a, b) = (corner(i), corner(i + 1));
            let cross =
                (a[0] - first[0]) * (b[1] - first[1]) - (a[1] - first[1]) * (b[0] - first[0]);
            area += 0.5 * cross.abs();
            for axis in 0..2 {
                moment[axis] += 0.5 * cross.abs() * (first[axis] + a[axis] + b[axis]) / 3.0;
            }
        }
    }
    let centroid = [base[0] + moment[0] / area, base[1] + moment[1] / area];
    if centroid.iter().all(|value| value.is_finite()) {
        Ok(centroid)
    } else {
        Err(Failure::NoScale { what: "area" })
    }
}

/// The power of two nearest to the largest distance of a node from `origin` \[m\].
fn length_unit(section: &Section, nodes: &[u32], origin: [f64; 2]) -> Result<f64, Failure> {
    let distance = |&node: &u32| {
        let [y, z] = section.mesh.nodes[node as usize];
        (y - origin[0]).hypot(z - origin[1])
    };
    power_of_two(nodes.iter().map(distance).fold(0.0, largest))
        .ok_or(Failure::NoScale { what: "size" })
}
