//! The plane mesh that the analysis uses, in section axes and meters.

use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::mesh::{Cell, CellKind, Line, Mesh};

use super::checks::check_cells;
use super::findings::{DoubledNodes, HangingNode, NarrowGap, Seam};
use super::plane::{PlaneMesh, check_plane, check_references};
use super::problem::MeshProblem;
use super::seams::Groups;

/// Label of the cells in no group.
const NO_GROUP: &str = "no group";

/// A section mesh: plane, in one part, all cells counterclockwise.
///
/// ```text
///     z (mesh y)
///     ^
///     |
///     +---> y (mesh x)        x, along the beam, toward the reader
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SectionMesh {
    /// Positions (y, z) of the nodes; each is used by a cell \[m\].
    pub nodes: Vec<[f64; 2]>,
    /// Tags of the nodes in the mesh file.
    pub node_tags: Vec<u64>,
    /// The cells.
    pub cells: Vec<SectionCell>,
    /// Labels of the physical surfaces that have cells: name, or tag without one.
    /// Cells in none come last, under `no group`.
    pub groups: Vec<String>,
    /// The physical curves that have lines.
    pub curves: Vec<Curve>,
}

/// A cell of a section mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SectionCell {
    /// Tag of the element in the mesh file.
    pub tag: u64,
    /// Shape.
    pub kind: CellKind,
    /// Physical surface: index in [`SectionMesh::groups`]. Of several it is the first in
    /// the mesh, in a section input the surface of the cell's region.
    pub group: usize,
    nodes: [u32; 9],
}

impl SectionCell {
    /// A cell whose `i`-th node (gmsh order, counterclockwise) is `node(i)`, an
    /// index in [`SectionMesh::nodes`].
    pub fn new(tag: u64, kind: CellKind, group: usize, node: impl Fn(usize) -> u32) -> Self {
        let count = kind.node_count();
        Self {
            tag,
            kind,
            group,
            nodes: std::array::from_fn(|i| if i < count { node(i) } else { 0 }),
        }
    }

    /// The nodes: indices in [`SectionMesh::nodes`], gmsh order.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.kind.node_count()]
    }

    /// The nodes at the corners, counterclockwise.
    pub fn corners(&self) -> &[u32] {
        &self.nodes[..self.kind.corner_count()]
    }
}

/// A physical curve: lines that define a direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Name of the physical group, or its tag without one.
    pub label: String,
    /// Its lines, in the order of the mesh file.
    pub lines: Vec<CurveLine>,
}

/// A line of a physical curve, in the direction of its nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurveLine {
    /// Tag of the element in the mesh file.
    pub tag: u64,
    /// Its first end (y, z) \[m\].
    pub first: [f64; 2],
    /// Its second end (y, z) \[m\].
    pub second: [f64; 2],
    /// Its middle node, for quadratic lines (y, z) \[m\].
    pub middle: Option<[f64; 2]>,
}

/// Corrections of the mesh, and warnings about it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshReport {
    /// Number of cells of clockwise surfaces, which were reversed.
    pub reversed_cells: usize,
    /// Number of unused nodes, which were removed.
    pub unused_nodes: usize,
    /// Tags of coincident nodes, although the section is in one part.
    pub coincident_nodes: Vec<[u64; 2]>,
    /// Cells that touch along sides without shared nodes: slits, which may be intended.
    pub seams: Vec<Seam>,
    /// Hanging nodes, if slits are allowed.
    pub hanging_nodes: Vec<HangingNode>,
    /// Sides that nearly touch.
    pub narrow_gaps: Vec<NarrowGap>,
    /// Tags of nodes that alone connect walls, without a shared side.
    pub pinched_nodes: Vec<u64>,
}

impl SectionMesh {
    /// Positions of the nodes of a cell \[m\].
    pub fn positions(&self, cell: &SectionCell) -> impl Iterator<Item = [f64; 2]> {
        cell.nodes().iter().map(|&node| self.nodes[node as usize])
    }

    /// Mean of the corners of a cell \[m\].
    pub fn middle(&self, cell: &SectionCell) -> [f64; 2] {
        let corners = cell.corners();
        [0, 1].map(|axis| {
            let positions = corners.iter().map(|&node| self.nodes[node as usize][axis]);
            positions.sum::<f64>() / corners.len() as f64
        })
    }

    /// Tag of a node, given its index; a mesh made without tags counts from one.
    pub fn node_tag(&self, node: usize) -> u64 {
        self.node_tags.get(node).copied().unwrap_or(node as u64 + 1)
    }

    /// The same cells with the node positions and curves of `mesh`, whose unit of length
    /// is `meters_per_unit`; `None` if its nodes and cells differ. Nothing is checked.
    pub fn with_positions_of(&self, mesh: &Mesh, meters_per_unit: f64) -> Option<Self> {
        check_references(mesh).ok()?;
        let plane = PlaneMesh::new(mesh);
        let sorted = |nodes: &[u32]| {
            let mut nodes = nodes.to_vec();
            nodes.sort_unstable();
            nodes
        };
        let mut cells = self.cells.iter().zip(&plane.cells);
        let is_same = self.node_tags == plane.node_tags
            && self.cells.len() == plane.cells.len()
            && cells.all(|(own, other)| sorted(own.nodes()) == sorted(other.nodes()));
        is_same.then(|| Self {
            nodes: positions(&plane, meters_per_unit),
            node_tags: self.node_tags.clone(),
            cells: self.cells.clone(),
            groups: self.groups.clone(),
            curves: curves(mesh, meters_per_unit),
        })
    }

    /// The section mesh of `mesh`, whose unit of length is `meters_per_unit`, with its
    /// report; `location` is the source of the mesh, for messages. Nodes doubled along the
    /// border of two surfaces are an error.
    ///
    /// # Errors
    /// All problems found: a mesh without cells or out of the plane z = constant,
    /// inverted or overlapping cells, cells that do not fit, a section in parts.
    pub fn from_mesh(
        mesh: &Mesh,
        meters_per_unit: f64,
        location: &SourceLocation,
    ) -> Result<(Self, MeshReport), Diagnostics> {
        Self::from_mesh_with(mesh, meters_per_unit, DoubledNodes::Error, location)
    }

    /// As [`SectionMesh::from_mesh`]; slits may be allowed.
    ///
    /// # Errors
    /// As [`SectionMesh::from_mesh`].
    pub fn from_mesh_with(
        mesh: &Mesh,
        meters_per_unit: f64,
        doubled_nodes: DoubledNodes,
        location: &SourceLocation,
    ) -> Result<(Self, MeshReport), Diagnostics> {
        Self::checked(mesh, meters_per_unit, doubled_nodes).map_err(|problems| {
            let mut diagnostics = Diagnostics::new();
            for problem in &problems {
                diagnostics.push(location.clone(), problem);
            }
            diagnostics
        })
    }

    /// As [`SectionMesh::from_mesh_with`], with typed problems.
    ///
    /// # Errors
    /// As [`SectionMesh::from_mesh`].
    pub fn checked(
        mesh: &Mesh,
        meters_per_unit: f64,
        doubled_nodes: DoubledNodes,
    ) -> Result<(Self, MeshReport), Vec<MeshProblem>> {
        check_whole(mesh, meters_per_unit)?;
        let (groups, group_of_cell) = surface_groups(mesh);
        let mut plane = PlaneMesh::new(mesh);
        let labels = Groups {
            labels: &groups,
            of_cell: &group_of_cell,
        };
        let cells = check_cells(&mut plane, labels, doubled_nodes)?;

        let tag = |node: u32| plane.node_tags[node as usize];
        let report = MeshReport {
            reversed_cells: cells.reversed,
            unused_nodes: mesh.nodes.len() - plane.nodes.len(),
            coincident_nodes: cells.coincident.iter().map(|pair| pair.map(tag)).collect(),
            seams: cells.seams,
            hanging_nodes: cells.hanging,
            narrow_gaps: cells.gaps,
            pinched_nodes: cells.pinches.into_iter().map(tag).collect(),
        };
        let cell = |(cell, &group): (&Cell, &usize)| {
            SectionCell::new(cell.tag, cell.kind, group, |i| cell.nodes()[i])
        };
        let section = Self {
            cells: plane.cells.iter().zip(&group_of_cell).map(cell).collect(),
            nodes: positions(&plane, meters_per_unit),
            node_tags: plane.node_tags,
            groups,
            curves: curves(mesh, meters_per_unit),
        };
        Ok((section, report))
    }
}

fn positions(plane: &PlaneMesh, meters_per_unit: f64) -> Vec<[f64; 2]> {
    let nodes = plane.nodes.iter();
    nodes.map(|p| p.map(|x| meters_per_unit * x)).collect()
}

fn outcome(problems: Vec<MeshProblem>) -> Result<(), Vec<MeshProblem>> {
    if problems.is_empty() {
        Ok(())
    } else {
        Err(problems)
    }
}

/// The problems that prevent all further checks.
fn check_whole(mesh: &Mesh, meters_per_unit: f64) -> Result<(), Vec<MeshProblem>> {
    let mut problems = Vec::new();
    if !(meters_per_unit > 0.0 && meters_per_unit.is_finite()) {
        problems.push(MeshProblem::LengthFactor {
            found: meters_per_unit,
        });
    }
    if mesh.cells.is_empty() {
        let has_lines = |group: &usize| mesh.lines.iter().any(|l| l.groups.contains(*group));
        let curves = (0..mesh.groups.len()).filter(has_lines);
        let curves = curves.map(|group| mesh.groups[group].label()).collect();
        problems.push(MeshProblem::NoCells {
            curves,
            form: mesh.group_form,
        });
    }
    let plane = check_references(mesh).and_then(|()| check_plane(mesh));
    problems.extend(plane.err());
    outcome(problems)
}

/// Labels of the physical surfaces that have cells, in the order of the mesh, and for
/// each cell the index of its surface.
fn surface_groups(mesh: &Mesh) -> (Vec<String>, Vec<usize>) {
    let groups = mesh.groups.len();
    // the last entry represents cells in no group
    let entry = |cell: &Cell| {
        let first = cell.groups.first();
        first.filter(|&group| group < groups).unwrap_or(groups)
    };
    let mut used = vec![false; groups + 1];
    for cell in &mesh.cells {
        used[entry(cell)] = true;
    }
    let mut labels: Vec<String> = Vec::new();
    let mut number = vec![0; groups + 1];
    for group in (0..=groups).filter(|&group| used[group]) {
        let label = mesh
            .groups
            .get(group)
            .map_or(NO_GROUP.into(), |group| group.label());
        // groups with the same name are combined
        number[group] = labels.iter().position(|l| *l == label).unwrap_or_else(|| {
            labels.push(label);
            labels.len() - 1
        });
    }
    let of_cell = mesh.cells.iter().map(|cell| number[entry(cell)]).collect();
    (labels, of_cell)
}

/// The physical curves, in the order of their first lines, in meters.
fn curves(mesh: &Mesh, meters_per_unit: f64) -> Vec<Curve> {
    let point = |node: u32| {
        let position = mesh.nodes[node as usize].position;
        [position.x, position.y].map(|x| meters_per_unit * x)
    };
    let placed = |line: &Line| {
        let nodes = line.nodes();
        CurveLine {
            tag: line.tag,
            first: point(nodes[0]),
            second: point(nodes[1]),
            middle: nodes.get(2).map(|&node| point(node)),
        }
    };
    let mut curves: Vec<Curve> = Vec::new();
    for line in &mesh.lines {
        for group in line
            .groups
            .iter()
            .filter_map(|group| mesh.groups.get(group))
        {
            let label = group.label();
            match curves.iter_mut().find(|curve| curve.label == label) {
                Some(curve) => curve.lines.push(placed(line)),
                None => curves.push(Curve {
                    label,
                    lines: vec![placed(line)],
                }),
            }
        }
    }
    curves
}

#[cfg(test)]
#[path = "section_mesh_tests.rs"]
mod tests;
