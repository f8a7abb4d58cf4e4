//! Plane coordinates of the mesh of a file: checks that the mesh is plane, and keeps the
//! nodes that cells use.

use nalgebra::Vector3;
use shared_geom::mesh::{Cell, Mesh, Node};

use super::problem::MeshProblem;

/// Allowed deviation from the plane, relative to the size of the mesh: rounding of
/// coordinates written with nine digits or more.
const FLATNESS: f64 = 1e-9;

/// The cells of a mesh on the nodes that they use, in the unit of the file.
#[derive(Debug, Clone)]
pub(super) struct PlaneMesh {
    pub(super) nodes: Vec<[f64; 2]>,
    pub(super) node_tags: Vec<u64>,
    /// Cells whose nodes are indices in `nodes`.
    pub(super) cells: Vec<Cell>,
}

impl PlaneMesh {
    /// The cells of `mesh`.
    pub(super) fn new(mesh: &Mesh) -> Self {
        let mut used = vec![false; mesh.nodes.len()];
        for cell in &mesh.cells {
            for &node in cell.nodes() {
                used[node as usize] = true;
            }
        }
        let mut position = vec![0; mesh.nodes.len()];
        let (mut nodes, mut node_tags) = (Vec::new(), Vec::new());
        for (i, node) in mesh.nodes.iter().enumerate().filter(|&(i, _)| used[i]) {
            position[i] = nodes.len() as u32;
            nodes.push([node.position.x, node.position.y]);
            node_tags.push(node.tag);
        }
        let cells = mesh.cells.iter().map(|cell| {
            let node = |i: usize| position[cell.nodes()[i] as usize];
            let mut moved = Cell::new(cell.tag, cell.kind, cell.entity, node);
            moved.groups = cell.groups.clone();
            moved
        });
        let cells = cells.collect();
        Self {
            nodes,
            node_tags,
            cells,
        }
    }

    /// Positions of the corners of a cell.
    pub(super) fn corners(&self, cell: &Cell) -> impl Iterator<Item = [f64; 2]> {
        cell.corners().iter().map(|&node| self.nodes[node as usize])
    }

    /// Mean of the corners of a cell.
    pub(super) fn center(&self, cell: &Cell) -> [f64; 2] {
        let count = cell.corners().len() as f64;
        [0, 1].map(|axis| self.corners(cell).map(|p| p[axis]).sum::<f64>() / count)
    }

    /// Lengths of the straightened sides of a cell.
    pub(super) fn sides(&self, cell: &Cell) -> impl Iterator<Item = f64> {
        let sides = cell.kind.sides(cell.nodes());
        sides.map(|(ends, _)| {
            let [a, b] = ends.map(|node| self.nodes[node as usize]);
            distance(a, b)
        })
    }

    /// Length of the longest straightened side of a cell.
    pub(super) fn longest_side(&self, cell: &Cell) -> f64 {
        self.sides(cell).fold(0.0, f64::max)
    }
}

pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Area of a polygon, positive counterclockwise.
///
/// ```text
/// area = 1/2 sum (y_i z_i+1 - y_i+1 z_i)      about the first corner
/// ```
pub(crate) fn polygon_area(corners: impl IntoIterator<Item = [f64; 2]>) -> f64 {
    let mut corners = corners.into_iter();
    let Some(origin) = corners.next() else {
        return 0.0;
    };
    let mut before = [0.0; 2];
    let mut twice = 0.0;
    for corner in corners {
        let now = [corner[0] - origin[0], corner[1] - origin[1]];
        twice += before[0] * now[1] - before[1] * now[0];
        before = now;
    }
    0.5 * twice
}

/// Checks that cells and lines refer to nodes of the mesh.
pub(super) fn check_references(mesh: &Mesh) -> Result<(), MeshProblem> {
    let exist = |nodes: &[u32]| nodes.iter().all(|&node| (node as usize) < mesh.nodes.len());
    let cells = mesh.cells.iter().map(|cell| (cell.tag, cell.nodes()));
    let lines = mesh.lines.iter().map(|line| (line.tag, line.nodes()));
    match cells.chain(lines).find(|(_, nodes)| !exist(nodes)) {
        Some((element, _)) => Err(MeshProblem::MissingNode { element }),
        None => Ok(()),
    }
}

/// Checks that all nodes used by a cell or by a line of a physical curve lie in one plane
/// z = constant.
pub(super) fn check_plane(mesh: &Mesh) -> Result<(), MeshProblem> {
    let mut used = vec![false; mesh.nodes.len()];
    let of_cells = mesh.cells.iter().flat_map(|cell| cell.nodes());
    let lines = mesh.lines.iter().filter(|line| !line.groups.is_empty());
    for &node in of_cells.chain(lines.flat_map(|line| line.nodes())) {
        used[node as usize] = true;
    }
    let nodes = mesh.nodes.iter().zip(used).filter(|(_, used)| *used);
    let nodes: Vec<&Node> = nodes.map(|(node, _)| node).collect();
    let positions = || nodes.iter().map(|node| node.position);
    let low = positions().fold(Vector3::repeat(f64::INFINITY), |low, p| low.inf(&p));
    let high = positions().fold(Vector3::repeat(f64::NEG_INFINITY), |high, p| high.sup(&p));
    let extent = high - low;
    let tolerance = FLATNESS * extent.max();
    if nodes.is_empty() || extent.z <= tolerance {
        return Ok(());
    }
    Err(match normal(&nodes, tolerance) {
        Some((normal, offset)) => MeshProblem::OtherPlane {
            normal: normal.into(),
            offset,
        },
        None => farthest(&nodes, tolerance),
    })
}

/// Unit normal and offset of the plane in which all nodes lie, if there is one.
fn normal(nodes: &[&Node], tolerance: f64) -> Option<(Vector3<f64>, f64)> {
    let positions = || nodes.iter().map(|node| node.position);
    let origin = positions().next()?;
    let by = |size: fn(&Vector3<f64>) -> f64| {
        move |a: &Vector3<f64>, b: &Vector3<f64>| size(a).total_cmp(&size(b))
    };
    // the plane of the two directions that span the largest area with the first node
    let along = positions()
        .map(|p| p - origin)
        .max_by(by(Vector3::norm_squared))?;
    let across = positions()
        .map(|p| along.cross(&(p - origin)))
        .max_by(by(Vector3::norm_squared))?;
    let mut normal = across.try_normalize(tolerance * along.norm())?;
    // remove rounding of a coordinate plane
    normal.apply(|x| *x = if x.abs() <= FLATNESS { 0.0 } else { *x });
    normal.normalize_mut();
    if normal.iter().find(|x| **x != 0.0).is_some_and(|x| *x < 0.0) {
        normal = -normal;
    }
    let in_plane = positions().all(|p| normal.dot(&(p - origin)).abs() <= tolerance);
    in_plane.then(|| (normal, normal.dot(&origin)))
}

/// The node farthest from the height of most nodes.
fn farthest(nodes: &[&Node], tolerance: f64) -> MeshProblem {
    let mut heights: Vec<f64> = nodes.iter().map(|node| node.position.z).collect();
    let middle = heights.len() / 2;
    let (_, &mut expected, _) = heights.select_nth_unstable_by(middle, f64::total_cmp);
    let off = |node: &Node| (node.position.z - expected).abs();
    let worst = nodes.iter().max_by(|a, b| off(a).total_cmp(&off(b)));
    MeshProblem::NotPlane {
        node: worst.map_or(0, |node| node.tag),
        found: worst.map_or(expected, |node| node.position.z),
        expected,
        tolerance,
    }
}
