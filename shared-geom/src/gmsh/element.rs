//! Element types of gmsh: the supported ones, and the names of the others.

use crate::mesh::{CellKind, LineKind};

/// An element type that is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ElementShape {
    Point,
    Line(LineKind),
    Cell(CellKind),
}

impl ElementShape {
    /// The shape with this number in gmsh files; `None` for types that are not read.
    pub(super) fn from_gmsh(number: u64) -> Option<Self> {
        let line = [LineKind::Line2, LineKind::Line3]
            .into_iter()
            .find(|kind| u64::from(kind.gmsh_type()) == number)
            .map(Self::Line);
        let cell = CellKind::ALL
            .into_iter()
            .find(|kind| u64::from(kind.gmsh_type()) == number)
            .map(Self::Cell);
        let point = (number == u64::from(POINT_TYPE)).then_some(Self::Point);
        line.or(cell).or(point)
    }

    pub(super) fn node_count(self) -> usize {
        match self {
            Self::Point => 1,
            Self::Line(kind) => kind.node_count(),
            Self::Cell(kind) => kind.node_count(),
        }
    }

    /// Dimension of the entities that hold these elements.
    pub(super) fn dimension(self) -> u8 {
        match self {
            Self::Point => 0,
            Self::Line(_) => 1,
            Self::Cell(_) => 2,
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Line(kind) => kind.name(),
            Self::Cell(kind) => kind.name(),
        }
    }
}

/// Number of the element type "point with one node".
pub(super) const POINT_TYPE: u32 = 15;

/// Element types that are not read: number, shape, number of nodes.
const OTHERS: [(u64, &str, usize); 27] = [
    (4, "tetrahedron", 4),
    (5, "hexahedron", 8),
    (6, "prism", 6),
    (7, "pyramid", 5),
    (11, "tetrahedron", 10),
    (12, "hexahedron", 27),
    (13, "prism", 18),
    (14, "pyramid", 14),
    (17, "hexahedron", 20),
    (18, "prism", 15),
    (19, "pyramid", 13),
    (20, "triangle", 9),
    (21, "triangle", 10),
    (22, "triangle", 12),
    (23, "triangle", 15),
    (24, "triangle", 15),
    (25, "triangle", 21),
    (26, "line", 4),
    (27, "line", 5),
    (28, "line", 6),
    (29, "tetrahedron", 20),
    (30, "tetrahedron", 35),
    (31, "tetrahedron", 56),
    (36, "quadrilateral", 16),
    (37, "quadrilateral", 25),
    (38, "quadrilateral", 36),
    (92, "hexahedron", 64),
];

/// Name of a type that is not read, and whether it is a volume element.
pub(super) fn other_type(number: u64) -> (String, bool) {
    match OTHERS.iter().find(|(other, ..)| *other == number) {
        Some((_, shape, nodes)) => (
            format!("\"{shape} with {nodes} nodes\" (gmsh type {number})"),
            !matches!(*shape, "triangle" | "line" | "quadrilateral"),
        ),
        None => (format!("\"gmsh type {number}\""), false),
    }
}

/// Number of nodes of a type that is not read, if known.
pub(super) fn other_node_count(number: u64) -> Option<usize> {
    let found = OTHERS.iter().find(|(other, ..)| *other == number);
    found.map(|&(.., nodes)| nodes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_type_is_either_read_or_named_as_another() {
        let read = (1..=140).filter(|&number| ElementShape::from_gmsh(number).is_some());
        assert_eq!(read.collect::<Vec<_>>(), [1, 2, 3, 8, 9, 10, 15, 16]);
        for (number, ..) in OTHERS {
            assert!(ElementShape::from_gmsh(number).is_none());
        }
        let (name, volume) = other_type(4);
        assert!(name.contains("tetrahedron with 4 nodes") && volume);
        assert!(!other_type(21).1 && !other_type(999).1);
    }
}
