//! Problems of the mesh of a section.
//!
//! Coordinates in messages are in the unit of the mesh file, so that the position can be
//! found in the mesh generator.

use std::fmt;

use shared_geom::error::Explain;
use shared_geom::mesh::{CellKind, GroupForm};

use super::findings::{CellOverlap, HangingNode, NarrowGap, Seam};
use super::words::{coordinates, counted, short};

/// A problem of the mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshProblem {
    /// A mesh that has no triangles or quadrilaterals.
    #[error("the mesh has no triangles or quadrilaterals, expected at least one")]
    NoCells {
        /// Labels of the curves that have lines.
        curves: Vec<String>,
        /// The form in which the file has groups.
        form: GroupForm,
    },
    /// An element of a mesh made by hand with a node that does not exist.
    #[error("element {element} refers to a node that the mesh does not have")]
    MissingNode {
        /// Tag of the element.
        element: u64,
    },
    /// An invalid unit of length.
    #[error("length of the mesh unit: expected a positive number of meters, found {found}")]
    LengthFactor {
        /// Meters in a unit of the mesh.
        found: f64,
    },
    /// A mesh in another plane.
    #[error(
        "the mesh lies in the plane {}, expected a plane z = constant", plane(*.normal, *.offset)
    )]
    OtherPlane {
        /// Unit normal of the plane \[-\].
        normal: [f64; 3],
        /// Distance from the origin along the normal [file unit].
        offset: f64,
    },
    /// A mesh out of the plane z = constant.
    #[error(
        "the mesh is not plane: node {node} has z = {}, expected {} as for most nodes, \
         within {}", short(*.found), short(*.expected), short(*.tolerance)
    )]
    NotPlane {
        /// The node farthest from the plane.
        node: u64,
        /// Its z [file unit].
        found: f64,
        /// The z of the plane: half of the nodes lie on either side [file unit].
        expected: f64,
        /// Allowed deviation [file unit].
        tolerance: f64,
    },
    /// A cell whose mapping folds.
    #[error("cell {cell} at {} {reason}", coordinates(*.center))]
    InvertedCell {
        /// Tag of the cell.
        cell: u64,
        /// Mean of its corners [file unit].
        center: [f64; 2],
        /// The likely reason.
        reason: Inversion,
    },
    /// A cell listed in the other direction than its neighbors.
    #[error(
        "cell {cell} at {} is inverted: its nodes run in the opposite direction to the {} of its \
         surface{}",
        coordinates(*.center),
        counted(*.others, "other cell"),
        if *.entity > 0 { format!(", entity {entity}") } else { String::new() }
    )]
    TurnedCell {
        /// Tag of the cell.
        cell: u64,
        /// Mean of its corners [file unit].
        center: [f64; 2],
        /// Surface entity of gmsh; 0 in other files.
        entity: i32,
        /// Number of cells of the entity with the usual direction.
        others: usize,
    },
    /// Cells that overlap at a side.
    #[error(
        "cells {} and {} overlap: both lie on the same side of the line from node {} to node {}",
        .cells[0], .cells[1], .nodes[0], .nodes[1]
    )]
    Overlap {
        /// Tags of the cells.
        cells: [u64; 2],
        /// Tags of the ends of their common side.
        nodes: [u64; 2],
    },
    /// A middle node of a side that only one of the adjacent cells has, or that is a
    /// corner of the other.
    #[error("{}", hanging(*.node, *.at, .side, .cells, *.corner))]
    HangingNode {
        /// Tag of the node.
        node: u64,
        /// Its position [file unit].
        at: [f64; 2],
        /// Tags of the ends of the side.
        side: [u64; 2],
        /// Tag and shape of the cell that has the node in its side, and of the other
        /// cell.
        cells: [(u64, CellKind); 2],
        /// Whether the node is a corner of the other cell.
        corner: bool,
    },
    /// Quadratic cells that meet at a side with two different middle nodes.
    #[error(
        "cells {} and {} share the side from node {} to node {} at {}, but not the node in its \
         middle", .cells[0], .cells[1], .nodes[0], .nodes[1], coordinates(*.at)
    )]
    SideMiddle {
        /// Tags of the cells.
        cells: [u64; 2],
        /// Tags of the ends of the side.
        nodes: [u64; 2],
        /// Midpoint between them [file unit].
        at: [f64; 2],
    },
    /// A section in several parts.
    #[error("{}", disconnected(.parts, .touching, .coincident, .gaps))]
    Disconnected {
        /// The parts, the one with the most cells first.
        parts: Vec<Part>,
        /// Tags of the nodes at which parts touch.
        touching: Vec<u64>,
        /// Tags of coincident nodes of different parts.
        coincident: Vec<[u64; 2]>,
        /// Narrow gaps anywhere in the section.
        gaps: Vec<NarrowGap>,
    },
    /// Cells that overlap.
    #[error("{0}")]
    DoubleCover(CellOverlap),
    /// Cells that touch along sides without shared nodes.
    #[error("{seam}")]
    DoubledNodes {
        /// The seam.
        seam: Seam,
        /// Whether slits are allowed; the section is in separate parts all the same.
        allowed: bool,
    },
    /// A corner on the side of another cell.
    #[error("{node}{}", likewise(*.more))]
    Hanging {
        /// One of the nodes between two surfaces.
        node: HangingNode,
        /// Number of further nodes.
        more: usize,
        /// Whether slits are allowed; the section is in separate parts all the same.
        allowed: bool,
    },
    /// Further problems of a kind, which are not reported one by one.
    #[error("and {count} more {what}")]
    More {
        /// Their number.
        count: usize,
        /// Their kind.
        what: &'static str,
    },
}

/// Reason for which a cell is inverted.
#[derive(Debug, Clone, PartialEq)]
pub enum Inversion {
    /// It lists a node more than once.
    Repeated {
        /// Tag of the node.
        node: u64,
    },
    /// Its corners lie on a line, or coincide.
    NoArea,
    /// A corner of more than 180 degrees, or crossed sides.
    Corner {
        /// Tag of the node at the corner.
        node: u64,
    },
    /// A middle node of a side or of the cell too far from its usual position.
    Middle {
        /// Tag of the node.
        node: u64,
        /// Distance from its usual position, relative to the length of the side, or of
        /// the longest side \[-\].
        distance: f64,
    },
}

impl fmt::Display for Inversion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Repeated { node } => {
                write!(f, "has no inside: it lists node {node} more than once")
            }
            Self::NoArea => write!(f, "has no area: its corners lie on one line, or nearly"),
            Self::Corner { node } => write!(
                f,
                "is inverted: the corner at node {node} is not less than 180 degrees, or its sides cross"
            ),
            Self::Middle { node, distance } => write!(
                f,
                "is inverted: it is folded, node {node} lies {distance:.2} side lengths off the middle"
            ),
        }
    }
}

/// A part of a section that shares no side with the others.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Number of cells.
    pub cells: usize,
    /// Centroid of the cells, with straight sides [file unit].
    pub centroid: [f64; 2],
    /// Smallest coordinates of the corners [file unit].
    pub low: [f64; 2],
    /// Largest coordinates of the corners [file unit].
    pub high: [f64; 2],
    /// Labels of the physical surfaces.
    pub groups: Vec<String>,
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let groups: Vec<String> = self.groups.iter().map(|g| format!("\"{g}\"")).collect();
        write!(
            f,
            "{} at {}, between {} and {}, in {}",
            counted(self.cells, "cell"),
            coordinates(self.centroid),
            coordinates(self.low),
            coordinates(self.high),
            groups.join(", ")
        )
    }
}

fn hanging(
    node: u64,
    at: [f64; 2],
    side: &[u64; 2],
    cells: &[(u64, CellKind); 2],
    corner: bool,
) -> String {
    let [(with, with_kind), (other, other_kind)] = *cells;
    format!(
        "node {node} at {} hangs in the middle of the side from node {} to node {}: cell {with} \
         ({}) has it there, cell {other} ({}) {}",
        coordinates(at),
        side[0],
        side[1],
        with_kind.name(),
        other_kind.name(),
        if corner {
            "has a corner there"
        } else {
            "does not"
        }
    )
}

/// Number of parts, nodes and pairs listed in a message.
const LISTED: usize = 8;

fn disconnected(
    parts: &[Part],
    touching: &[u64],
    coincident: &[[u64; 2]],
    gaps: &[NarrowGap],
) -> String {
    let mut text = format!(
        "the section falls into {} parts that share no side, expected one",
        parts.len()
    );
    for (part, number) in parts.iter().zip(1..).take(LISTED) {
        text.push_str(&format!("\n    part {number}: {part}"));
    }
    if let Some(more) = parts.len().checked_sub(LISTED + 1) {
        text.push_str(&format!("\n    and {} more", more + 1));
    }
    if !touching.is_empty() {
        let nodes: Vec<String> = touching.iter().map(u64::to_string).collect();
        text.push_str(&format!(
            "\n    parts touch only at {}",
            listed("node", &nodes)
        ));
    }
    if let Some([first, second]) = coincident.first() {
        text.push_str(&format!(
            "\n    {} with nodes of another part, as {first} with {second}",
            match coincident.len() {
                1 => "1 node coincides".into(),
                count => format!("{count} nodes coincide"),
            }
        ));
    }
    for gap in gaps.iter().take(LISTED) {
        text.push_str(&format!("\n    {gap}"));
    }
    text
}

fn likewise(more: usize) -> String {
    match more {
        0 => String::new(),
        _ => format!(
            "; likewise {} between these surfaces",
            counted(more, "node")
        ),
    }
}

/// `node 3` or `nodes 3, 4, 5 and 7 more`.
fn listed(what: &str, names: &[String]) -> String {
    let plural = if names.len() == 1 { "" } else { "s" };
    let shown = &names[..names.len().min(LISTED)];
    let more = match names.len() - shown.len() {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!("{what}{plural} {}{more}", shown.join(", "))
}

/// `y = 3`, or `0.6 x + 0.8 z = 2` for a tilted plane.
fn plane(normal: [f64; 3], offset: f64) -> String {
    let mut text = String::new();
    for (factor, axis) in normal.into_iter().zip(['x', 'y', 'z']) {
        let sign = match (text.is_empty(), factor < 0.0) {
            _ if factor == 0.0 => continue,
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let factor = short(factor.abs());
        text.push_str(sign);
        if factor != "1" {
            text.push_str(&format!("{factor} "));
        }
        text.push(axis);
    }
    format!("{text} = {}", short(offset))
}

impl Explain for MeshProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::NoCells { curves, form } => return Some(give_cells(curves, *form)),
            Self::OtherPlane { normal, .. } => {
                let turn = match normal {
                    [1.0, 0.0, 0.0] => "rotate it by -120 degrees about the direction (1, 1, 1)",
                    [0.0, 1.0, 0.0] => "rotate it by -90 degrees about the mesh axis x",
                    _ => "turn it",
                };
                return Some(format!(
                    "{turn} into the x-y plane (in gmsh, Rotate), where x is the section axis y \
                     and y is the section axis z"
                ));
            }
            Self::NotPlane { .. } => {
                "the section must lie in one plane z = constant of the mesh file"
            }
            Self::InvertedCell {
                reason: Inversion::Middle { .. },
                ..
            } => {
                "use smaller cells where the boundary is curved, or in gmsh \
                 Mesh.HighOrderOptimize = 1, or straight sides (Mesh.SecondOrderLinear = 1)"
            }
            Self::TurnedCell { .. } => "reverse the order of its nodes, or mesh this part again",
            Self::InvertedCell { .. } | Self::Overlap { .. } => {
                "mesh this part again; in a structured mesh, check the order of the points and \
                 the numbers of cells on facing curves"
            }
            Self::HangingNode { corner: false, .. } => {
                "use cells of one order throughout: in gmsh, Mesh.ElementOrder for the whole mesh"
            }
            Self::HangingNode { corner: true, .. } => {
                "neighboring cells must share whole sides: mesh this part again, or use cells of \
                 one order throughout (in gmsh, Mesh.ElementOrder)"
            }
            Self::SideMiddle { .. } => "in gmsh, Mesh > Remove duplicate nodes",
            Self::DoubleCover(_) => {
                "a surface meshed twice, or surfaces that reach into each other: in gmsh, \
                 \"Coherence;\" (built-in geometry) or BooleanFragments (OpenCASCADE) before \
                 meshing, and delete copies"
            }
            Self::DoubledNodes { allowed, .. } => return Some(join("", *allowed)),
            Self::Hanging { allowed, .. } => {
                return Some(join(
                    "both cells need the same nodes on the line where they meet; ",
                    *allowed,
                ));
            }
            Self::Disconnected {
                gaps, coincident, ..
            } => connect(!gaps.is_empty(), !coincident.is_empty()),
            Self::MissingNode { .. } | Self::LengthFactor { .. } | Self::More { .. } => {
                return None;
            }
        };
        Some(help.into())
    }
}

/// Remedy for a mesh without cells; `curves` are its curves with lines.
fn give_cells(curves: &[String], form: GroupForm) -> String {
    if form != GroupForm::Physical {
        return "give the surfaces of the section triangles or quadrilaterals".to_owned();
    }
    if curves.is_empty() {
        return "mesh the surfaces (gmsh -2); if the file has physical groups, gmsh saves only \
                their contents, so put the surfaces in a physical surface"
            .to_owned();
    }
    let names: Vec<_> = curves.iter().map(|name| format!("\"{name}\"")).collect();
    format!(
        "mesh the surfaces (gmsh -2) and put them in a physical surface; or, for thin walls along \
         the curves {}, give their plies by [[lamina]]",
        names.join(", ")
    )
}

/// Remedy for a section in separate parts.
fn connect(has_gaps: bool, has_coincident: bool) -> &'static str {
    match (has_gaps, has_coincident) {
        (true, _) => {
            "close the gap: move the points of one side onto the other, or in gmsh raise \
             Geometry.Tolerance before \"Coherence;\" or BooleanFragments"
        }
        (_, true) => {
            "merge the nodes: in gmsh, \"Coherence;\" in the geometry before meshing, or \
             Mesh > Remove duplicate nodes"
        }
        _ => "parts must share whole sides of cells: join them, or analyze each alone",
    }
}

/// Remedy for surfaces that are not joined; for a possible slit, the way to allow it.
fn join(lead: &str, allowed: bool) -> String {
    let remedy = format!(
        "{lead}let the surfaces share their common curve and mesh again: in gmsh \"Coherence;\" \
         (built-in geometry) or BooleanFragments (OpenCASCADE) before meshing, with a larger \
         Geometry.Tolerance if points nearly meet"
    );
    if allowed {
        format!("{remedy}; doubled_nodes = \"allow\" does not join parts")
    } else {
        format!(
            "{remedy}; or, if a slit is intended, write doubled_nodes = \"allow\" at the head of \
             the section file"
        )
    }
}

/// Number of problems per kind that are reported one by one.
const LIMIT: usize = 20;

/// The problems of one kind, the first reported and the others counted.
pub(super) fn limited(problems: Vec<MeshProblem>, what: &'static str) -> Vec<MeshProblem> {
    limited_to(LIMIT, problems, what)
}

/// The problems of one kind, the first `limit` reported and the others counted.
pub(super) fn limited_to(
    limit: usize,
    mut problems: Vec<MeshProblem>,
    what: &'static str,
) -> Vec<MeshProblem> {
    if let Some(count) = problems.len().checked_sub(limit)
        && count > 0
    {
        problems.truncate(limit);
        problems.push(MeshProblem::More { count, what });
    }
    problems
}
