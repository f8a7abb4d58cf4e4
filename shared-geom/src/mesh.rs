//! Meshes: nodes, plane cells, boundary lines and the physical groups that name them.
//!
//! [`crate::gmsh`] reads and writes them. Node, cell and line tags are the file's, in the
//! file's order and possibly sparse; all references to a node are its index in
//! [`Mesh::nodes`].
//!
//! Node order of the cells (corners, sides, middle) is gmsh's:
//!
//! ```text
//!   2              3---6---2        s
//!   | \            |       |        |
//!   5   4          7   8   5        +--- r
//!   |     \        |       |
//!   0---3---1      0---4---1
//! ```
//!
//! # References
//! - C. Geuzaine, J.-F. Remacle, "Gmsh: A 3-D finite element mesh generator with
//!   built-in pre- and post-processing facilities", Int. J. Numer. Meth. Eng. 79
//!   (2009) 1309-1331; node ordering: reference manual, "Node ordering".

use nalgebra::Vector3;

use crate::lagrange::{self, LineValues, ShapeValues};
use crate::quadrature::{self, PlanePoint};

mod group_kind;
mod groups;

pub use group_kind::{GroupForm, GroupKind};
pub use groups::{GroupSet, PhysicalGroup};

/// Shape of a plane cell, with its number of nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CellKind {
    /// Linear triangle.
    Triangle3,
    /// Quadratic triangle: corners, then side middles.
    Triangle6,
    /// Bilinear quadrilateral.
    Quadrilateral4,
    /// Serendipity quadrilateral: corners, then side middles.
    Quadrilateral8,
    /// Biquadratic quadrilateral: corners, side middles, center.
    Quadrilateral9,
}

const TRIANGLE_NODES: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [1.0, 0.0],
    [0.0, 1.0],
    [0.5, 0.0],
    [0.5, 0.5],
    [0.0, 0.5],
];

const QUADRILATERAL_NODES: [[f64; 2]; 9] = [
    [-1.0, -1.0],
    [1.0, -1.0],
    [1.0, 1.0],
    [-1.0, 1.0],
    [0.0, -1.0],
    [1.0, 0.0],
    [0.0, 1.0],
    [-1.0, 0.0],
    [0.0, 0.0],
];

impl CellKind {
    /// Every kind of cell.
    pub const ALL: [Self; 5] = [
        Self::Triangle3,
        Self::Triangle6,
        Self::Quadrilateral4,
        Self::Quadrilateral8,
        Self::Quadrilateral9,
    ];

    /// Number of nodes.
    pub fn node_count(self) -> usize {
        match self {
            Self::Triangle3 => 3,
            Self::Triangle6 => 6,
            Self::Quadrilateral4 => 4,
            Self::Quadrilateral8 => 8,
            Self::Quadrilateral9 => 9,
        }
    }

    /// Number of corners, which is also the number of sides.
    pub fn corner_count(self) -> usize {
        match self {
            Self::Triangle3 | Self::Triangle6 => 3,
            _ => 4,
        }
    }

    /// Whether the sides have a middle node.
    pub fn is_quadratic(self) -> bool {
        !matches!(self, Self::Triangle3 | Self::Quadrilateral4)
    }

    /// Name for messages, as `triangle with 3 nodes`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Triangle3 => "triangle with 3 nodes",
            Self::Triangle6 => "triangle with 6 nodes",
            Self::Quadrilateral4 => "quadrilateral with 4 nodes",
            Self::Quadrilateral8 => "quadrilateral with 8 nodes",
            Self::Quadrilateral9 => "quadrilateral with 9 nodes",
        }
    }

    /// Number of this element type in gmsh files.
    pub fn gmsh_type(self) -> u32 {
        match self {
            Self::Triangle3 => 2,
            Self::Triangle6 => 9,
            Self::Quadrilateral4 => 3,
            Self::Quadrilateral8 => 16,
            Self::Quadrilateral9 => 10,
        }
    }

    /// Kind of the lines that bound the cell.
    pub fn side_kind(self) -> LineKind {
        if self.is_quadratic() {
            LineKind::Line3
        } else {
            LineKind::Line2
        }
    }

    /// Local node numbers of side `side`: first corner, second corner, and the middle
    /// node for quadratic kinds. Sides follow the corners and run counterclockwise;
    /// `side` counts modulo the number of sides.
    pub fn side(self, side: usize) -> (usize, usize, Option<usize>) {
        let corners = self.corner_count();
        let first = side % corners;
        let middle = self.is_quadratic().then_some(corners + first);
        (first, (first + 1) % corners, middle)
    }

    /// The sides of a cell with these nodes, in their order: ends, and the middle node
    /// for quadratic kinds.
    pub fn sides(self, nodes: &[u32]) -> impl Iterator<Item = ([u32; 2], Option<u32>)> + '_ {
        (0..self.corner_count()).map(move |side| {
            let (first, second, middle) = self.side(side);
            let ends = [first, second].map(|local| nodes[local]);
            (ends, middle.map(|local| nodes[local]))
        })
    }

    /// Coordinates (r, s) of the nodes on the reference cell: the triangle (0,0), (1,0),
    /// (0,1) or the square [-1, 1] x [-1, 1] [-].
    pub fn reference_nodes(self) -> &'static [[f64; 2]] {
        match self {
            Self::Triangle3 | Self::Triangle6 => &TRIANGLE_NODES[..self.node_count()],
            _ => &QUADRILATERAL_NODES[..self.node_count()],
        }
    }

    /// Shape functions and their derivatives at (r, s) of the reference cell.
    pub fn shape(self, r: f64, s: f64) -> ShapeValues {
        match self {
            Self::Triangle3 => lagrange::triangle3(r, s),
            Self::Triangle6 => lagrange::triangle6(r, s),
            Self::Quadrilateral4 => lagrange::quadrilateral4(r, s),
            Self::Quadrilateral8 => lagrange::quadrilateral8(r, s),
            Self::Quadrilateral9 => lagrange::quadrilateral9(r, s),
        }
    }

    /// Integration rule that is exact for products of two shape functions or of
    /// their derivatives on straight-sided cells (parallelograms, for the
    /// quadrilaterals).
    pub fn rule(self) -> &'static [PlanePoint] {
        match self {
            Self::Triangle3 => quadrature::triangle(2),
            Self::Triangle6 => quadrature::triangle(4),
            Self::Quadrilateral4 => quadrature::quadrilateral(2),
            Self::Quadrilateral8 | Self::Quadrilateral9 => quadrature::quadrilateral(3),
        }
    }

    /// For each local node, the local node that replaces it when the cell is listed the
    /// other way round: the first corner stays.
    pub fn reversed_order(self) -> &'static [usize] {
        match self {
            Self::Triangle3 => &[0, 2, 1],
            Self::Triangle6 => &[0, 2, 1, 5, 4, 3],
            Self::Quadrilateral4 => &[0, 3, 2, 1],
            Self::Quadrilateral8 => &[0, 3, 2, 1, 7, 6, 5, 4],
            Self::Quadrilateral9 => &[0, 3, 2, 1, 7, 6, 5, 4, 8],
        }
    }
}

/// Shape of a line, with its number of nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LineKind {
    /// Straight line.
    Line2,
    /// Quadratic line: ends, then middle.
    Line3,
}

impl LineKind {
    /// Number of nodes.
    pub fn node_count(self) -> usize {
        match self {
            Self::Line2 => 2,
            Self::Line3 => 3,
        }
    }

    /// Whether the line has a middle node.
    pub fn is_quadratic(self) -> bool {
        self == Self::Line3
    }

    /// Name for messages, as `line with 2 nodes`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Line2 => "line with 2 nodes",
            Self::Line3 => "line with 3 nodes",
        }
    }

    /// Number of this element type in gmsh files.
    pub fn gmsh_type(self) -> u32 {
        match self {
            Self::Line2 => 1,
            Self::Line3 => 8,
        }
    }

    /// Shape functions and their derivatives at `xi` in [-1, 1].
    pub fn shape(self, xi: f64) -> LineValues {
        match self {
            Self::Line2 => lagrange::line2(xi),
            Self::Line3 => lagrange::line3(xi),
        }
    }
}

/// A point of the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Number of the node in the file.
    pub tag: u64,
    /// Coordinates x, y, z of the file [file unit].
    pub position: Vector3<f64>,
}

/// A plane cell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cell {
    /// Number of the element in the file.
    pub tag: u64,
    /// Shape.
    pub kind: CellKind,
    /// Surface entity of gmsh that the cell belongs to; 0 if the file has none.
    pub entity: i32,
    /// Physical surfaces that the cell belongs to.
    pub groups: GroupSet,
    // entries after the node count are zero, so that equality compares the nodes
    nodes: [u32; 9],
}

impl Cell {
    /// A cell in no group, whose `i`-th node (gmsh order) is `node(i)`, an index in
    /// [`Mesh::nodes`]; `node` is called for `kind.node_count()` nodes.
    pub fn new(tag: u64, kind: CellKind, entity: i32, node: impl FnMut(usize) -> u32) -> Self {
        Self {
            tag,
            kind,
            entity,
            groups: GroupSet::default(),
            nodes: first_nodes(kind.node_count(), node),
        }
    }

    /// The nodes: indices in [`Mesh::nodes`], gmsh order.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.kind.node_count()]
    }

    /// The corner nodes: indices in [`Mesh::nodes`], gmsh order.
    pub fn corners(&self) -> &[u32] {
        &self.nodes[..self.kind.corner_count()]
    }

    /// The same cell, its nodes listed the other way round.
    pub fn reversed(&self) -> Self {
        let order = self.kind.reversed_order();
        Self {
            nodes: first_nodes(order.len(), |i| self.nodes[order[i]]),
            ..self.clone()
        }
    }
}

/// A line, usually a part of a boundary between surfaces.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// Number of the element in the file.
    pub tag: u64,
    /// Shape.
    pub kind: LineKind,
    /// Curve entity of gmsh that the line belongs to; 0 if the file has none.
    pub entity: i32,
    /// Physical curves that the line belongs to in this direction. One that
    /// belongs to others against it is listed twice, with one tag.
    pub groups: GroupSet,
    nodes: [u32; 3],
}

impl Line {
    /// A line in no group, whose `i`-th node (ends, middle) is `node(i)`, an
    /// index in [`Mesh::nodes`].
    pub fn new(tag: u64, kind: LineKind, entity: i32, node: impl FnMut(usize) -> u32) -> Self {
        Self {
            tag,
            kind,
            entity,
            groups: GroupSet::default(),
            nodes: first_nodes(kind.node_count(), node),
        }
    }

    /// The nodes: indices in [`Mesh::nodes`]; ends, then middle.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.kind.node_count()]
    }

    /// The same line, run the other way.
    pub fn reversed(&self) -> Self {
        let [first, second, middle] = self.nodes;
        Self {
            nodes: [second, first, middle],
            ..self.clone()
        }
    }
}

/// A marked node.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Point {
    /// Number of the element in the file.
    pub tag: u64,
    /// The node: index in [`Mesh::nodes`].
    pub node: u32,
    /// Point entity of gmsh; 0 if the file has none.
    pub entity: i32,
    /// Physical points that the node belongs to.
    pub groups: GroupSet,
}

/// A mesh as in a file, in the unit of the file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Nodes, in the order of the file; some may be unused.
    pub nodes: Vec<Node>,
    /// Triangles and quadrilaterals.
    pub cells: Vec<Cell>,
    /// Lines.
    pub lines: Vec<Line>,
    /// Marked nodes.
    pub points: Vec<Point>,
    /// Physical groups: the named ones in the order of the file, then those
    /// that are used without a name.
    pub groups: Vec<PhysicalGroup>,
    /// The form in which the file has the groups.
    pub group_form: GroupForm,
}

impl Mesh {
    /// Index in [`Mesh::groups`] of the group with this dimension and label.
    pub fn group(&self, dimension: u8, label: &str) -> Option<usize> {
        self.groups
            .iter()
            .position(|group| group.dimension == dimension && group.label() == label)
    }
}

/// The array whose first `count` entries are `node(i)`, the others zero.
fn first_nodes<const N: usize>(count: usize, mut node: impl FnMut(usize) -> u32) -> [u32; N] {
    std::array::from_fn(|i| if i < count { node(i) } else { 0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_are_one_at_their_own_node_and_zero_at_the_others() {
        // pins the node order: a Kronecker delta up to the rounding of a few products
        for kind in CellKind::ALL {
            assert_eq!(kind.reference_nodes().len(), kind.node_count());
            for (i, &[r, s]) in kind.reference_nodes().iter().enumerate() {
                let shape = kind.shape(r, s);
                assert_eq!(shape.count, kind.node_count());
                for j in 0..shape.count {
                    let expected = if i == j { 1.0 } else { 0.0 };
                    assert!((shape.n[j] - expected).abs() < 1e-15, "{kind:?} {i} {j}");
                }
            }
        }
    }

    #[test]
    fn rules_measure_the_reference_cell() {
        for kind in CellKind::ALL {
            let area: f64 = kind.rule().iter().map(|point| point.weight).sum();
            let expected = if kind.corner_count() == 3 { 0.5 } else { 4.0 };
            assert!((area - expected).abs() < 1e-14, "{kind:?} {area}");
        }
    }

    #[test]
    fn side_middles_lie_between_the_ends_of_their_side() {
        for kind in CellKind::ALL {
            let nodes = kind.reference_nodes();
            for side in 0..kind.corner_count() {
                let (a, b, middle) = kind.side(side);
                assert_eq!(middle.is_some(), kind.is_quadratic());
                if let Some(m) = middle {
                    for axis in 0..2 {
                        let mean = 0.5 * (nodes[a][axis] + nodes[b][axis]);
                        assert_eq!(nodes[m][axis], mean, "{kind:?} side {side}");
                    }
                }
            }
        }
    }

    #[test]
    fn reversal_mirrors_the_reference_cell_and_undoes_itself() {
        for kind in CellKind::ALL {
            // the mirror that keeps the first corner swaps r and s
            for (&from, node) in kind.reversed_order().iter().zip(kind.reference_nodes()) {
                let [r, s] = kind.reference_nodes()[from];
                assert_eq!([s, r], *node, "{kind:?}");
            }
            let cell = Cell::new(7, kind, 1, |i| 10 + i as u32);
            assert_ne!(cell.reversed(), cell);
            assert_eq!(cell.reversed().reversed(), cell);
        }
        let line = Line::new(1, LineKind::Line3, 1, |i| i as u32);
        assert_eq!(line.reversed().nodes(), [1, 0, 2]);
    }

    #[test]
    fn groups_are_found_by_dimension_and_label() {
        let group = |dimension, tag, name: Option<&str>| PhysicalGroup {
            dimension,
            tag,
            name: name.map(String::from),
        };
        let mesh = Mesh {
            groups: vec![group(1, 4, Some("skin")), group(2, 4, None)],
            ..Mesh::default()
        };
        assert_eq!(mesh.group(1, "skin"), Some(0));
        assert_eq!(mesh.group(2, "4"), Some(1));
        assert_eq!(mesh.group(2, "skin"), None);
    }
}
