//! Problems of laminates along curves.
//!
//! Positions are in the unit of the mesh file.

use shared_geom::error::{Explain, quoted};

use super::super::words::{coordinates as at, counted, short};
use super::LaminaSide;
use super::words::{Wall, both, fold, more, order, position_count, twice};

/// A problem of a laminate on its lines.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LaminaProblem {
    /// A line between cells.
    #[error(
        "line {line} of curve \"{curve}\" at {} lies between cells{}: a laminate must lie on the \
         border of cells, or away from cells", at(*.position), more(*.count)
    )]
    Inside {
        /// The curve.
        curve: String,
        /// Tag of one of the lines.
        line: u64,
        /// Its midpoint [mesh unit].
        position: [f64; 2],
        /// Number of these lines.
        count: usize,
    },
    /// A laminate on the side of the cells.
    #[error(
        "side = \"{}\" puts the laminate of curve \"{curve}\" into the cells next to line {line} \
         at {}", .side.name(), at(*.position)
    )]
    IntoCells {
        /// The curve.
        curve: String,
        /// The side as given.
        side: LaminaSide,
        /// The side without cells.
        free: LaminaSide,
        /// Tag of one of the lines.
        line: u64,
        /// Its midpoint [mesh unit].
        position: [f64; 2],
    },
    /// A curve with cells first on one side and then on the other.
    #[error(
        "curve \"{curve}\" has cells on its left at line {} at {} and on its right at line {} \
         at {}: its laminate has no side",
        .lines[0], at(.positions[0]), .lines[1], at(.positions[1])
    )]
    SideChanges {
        /// The curve.
        curve: String,
        /// Tags of a line of each kind.
        lines: [u64; 2],
        /// Their midpoints [mesh unit].
        positions: [[f64; 2]; 2],
    },
    /// A curve that runs along cells and beyond them.
    #[error(
        "curve \"{curve}\" has cells next to line {} at {} and none next to line {} at {}: the \
         side of its laminate must be given",
        .lines[0], at(.positions[0]), .lines[1], at(.positions[1])
    )]
    Mixed {
        /// The curve.
        curve: String,
        /// The side without cells.
        free: LaminaSide,
        /// Tags of a line of each kind.
        lines: [u64; 2],
        /// Their midpoints [mesh unit].
        positions: [[f64; 2]; 2],
    },
    /// Two laminates at one position.
    #[error(
        "{} on one side of line {line} at {}", twice(.curves), at(*.position)
    )]
    Twice {
        /// Their curves.
        curves: [String; 2],
        /// Tag of a line that has both.
        line: u64,
        /// Its midpoint [mesh unit].
        position: [f64; 2],
    },
    /// Lines that share both ends, but not their middle node.
    #[error(
        "lines {} and {} of {} have the same ends: the one at {} and the other cannot be \
         distinguished at joints of laminates", .lines[0], .lines[1], both(.curves), at(*.position)
    )]
    SameEnds {
        /// Their curves.
        curves: [String; 2],
        /// Tags of the lines.
        lines: [u64; 2],
        /// Midpoint of the second [mesh unit].
        position: [f64; 2],
    },
    /// A line on the border of cells whose nodes differ from the side there.
    #[error(
        "line {line} of curve \"{curve}\" at {} {}{}", at(*.position), order(*.has_middle),
        more(*.count)
    )]
    OtherOrder {
        /// The curve.
        curve: String,
        /// Tag of one of the lines.
        line: u64,
        /// Its midpoint [mesh unit].
        position: [f64; 2],
        /// Whether the line has a middle node.
        has_middle: bool,
        /// Number of these lines.
        count: usize,
    },
    /// A line on the border of cells that is not one of their sides.
    #[error(
        "line {line} of curve \"{curve}\" at {} runs along the border of cells without being one \
         of their sides{}", at(*.position), more(*.count)
    )]
    NoSide {
        /// The curve.
        curve: String,
        /// Tag of the line.
        line: u64,
        /// Its midpoint [mesh unit].
        position: [f64; 2],
        /// Number of these lines.
        count: usize,
    },
    /// A line of zero length.
    #[error("line {line} of curve \"{curve}\" at {} has no length", at(*.position))]
    NoLength {
        /// The curve.
        curve: String,
        /// Tag of the line.
        line: u64,
        /// Its position [mesh unit].
        position: [f64; 2],
    },
    /// Lines of one curve in opposite directions.
    #[error(
        "lines {} and {} of curve \"{curve}\" have opposite directions at node {node} at {}: left \
         and right change there", .lines[0], .lines[1], at(*.position)
    )]
    AgainstEachOther {
        /// The curve.
        curve: String,
        /// Tags of the lines.
        lines: [u64; 2],
        /// Tag of the node.
        node: u64,
        /// Its position [mesh unit].
        position: [f64; 2],
    },
    /// More than two lines with laminates at a node.
    #[error(
        "{lines} lines with laminates meet at node {node} at {} ({})", at(*.position),
        quoted(.curves)
    )]
    Branch {
        /// Tag of the node.
        node: u64,
        /// Its position [mesh unit].
        position: [f64; 2],
        /// Number of lines.
        lines: usize,
        /// Their curves, each once.
        curves: Vec<String>,
    },
    /// A wall that ends on another one whose lines are too short.
    #[error(
        "the laminate of curve \"{}\" ends on the laminate of \"{}\" at node {node} at {}, where \
         line {line} of length {} is too short: {} of it are covered, expected at most three \
         quarters",
        .curves[0], .curves[1], at(*.position), short(*.length), short(*.taken)
    )]
    Crowded {
        /// The curve that ends, and the curve that continues.
        curves: [String; 2],
        /// Tag of the node.
        node: u64,
        /// Its position [mesh unit].
        position: [f64; 2],
        /// Tag of the line.
        line: u64,
        /// Its length [mesh unit].
        length: f64,
        /// The length of it that the other wall covers [mesh unit].
        taken: f64,
    },
    /// A corner that cannot be mitred.
    #[error(
        "the laminate of curve \"{curve}\" turns by {} deg at node {node} at {}, expected at \
         most {:.0} deg", short(.turn.to_degrees()), at(*.position), .limit.to_degrees()
    )]
    Sharp {
        /// The curve.
        curve: String,
        /// Tag of the node.
        node: u64,
        /// Its position [mesh unit].
        position: [f64; 2],
        /// Change of the direction \[rad\].
        turn: f64,
        /// Largest allowed change \[rad\].
        limit: f64,
    },
    /// Laminates that cannot be joined.
    #[error(
        "the laminates of curves \"{}\" ({}) and \"{}\" ({}) meet at a corner at node {node} \
         at {}, where layers cannot be joined one by one",
        .curves[0], counted(.layers[0], "layer"), .curves[1], counted(.layers[1], "layer"),
        at(*.position)
    )]
    Differ {
        /// Their curves.
        curves: [String; 2],
        /// Number of layers of each.
        layers: [usize; 2],
        /// Tag of the node.
        node: u64,
        /// Its position [mesh unit].
        position: [f64; 2],
    },
    /// A centered laminate and one on a side of its line.
    #[error(
        "the laminates of curves \"{}\" and \"{}\" meet at node {node} at {}, one centered on its \
         line and the other on one side of it", .curves[0], .curves[1], at(*.position)
    )]
    OffCenter {
        /// Their curves.
        curves: [String; 2],
        /// Tag of the node.
        node: u64,
        /// Its position [mesh unit].
        position: [f64; 2],
    },
    /// Laminates on different sides, which only a node would connect.
    #[error(
        "the laminates of curves \"{}\" and \"{}\" lie on different sides of their lines at their \
         common node {node} at {}: they would touch in this node only",
        .curves[0], .curves[1], at(*.position)
    )]
    OtherSide {
        /// Their curves.
        curves: [String; 2],
        /// Tag of the node.
        node: u64,
        /// Its position [mesh unit].
        position: [f64; 2],
    },
    /// A laminate that folds over itself.
    #[error(
        "the laminate of curve \"{curve}\" folds over itself at line {line} at {}: it reaches \
         {} from the line, {}", at(*.position), short(*.reach), fold(*.length, *.radius)
    )]
    Folded {
        /// The curve.
        curve: String,
        /// Tag of the line.
        line: u64,
        /// Its midpoint [mesh unit].
        position: [f64; 2],
        /// Distance of the laminate's farther face from the line [mesh unit].
        reach: f64,
        /// Length of the line [mesh unit].
        length: f64,
        /// Its radius of curvature, unless it is straight [mesh unit].
        radius: Option<f64>,
    },
    /// A laminate without space for its plies.
    #[error(
        "the plies of curve \"{curve}\" are crossed or folded at line {line}, around {}{}: together \
         they are {} thick", at(*.position), position_count(*.count), short(*.thickness)
    )]
    Misshapen {
        /// The curve.
        curve: String,
        /// Tag of the line.
        line: u64,
        /// Center of the ply [mesh unit].
        position: [f64; 2],
        /// Thickness of the laminate [mesh unit].
        thickness: f64,
        /// Number of cells.
        count: usize,
    },
    /// A laminate that overlaps another part.
    #[error(
        "{} overlaps {} at {}{}", .walls[0], .walls[1].as_other(&.walls[0]), at(*.position),
        position_count(*.count)
    )]
    Overlaps {
        /// The two parts, at least one of them a laminate.
        walls: [Wall; 2],
        /// A position in both [mesh unit].
        position: [f64; 2],
        /// Number of pairs of cells.
        count: usize,
    },
    /// A laminate that touches another part without being joined to it.
    #[error(
        "{} touches {} at {}{} without being joined to it", .walls[0],
        .walls[1].as_other(&.walls[0]), at(*.position), position_count(*.count)
    )]
    Unjoined {
        /// The two parts, at least one of them a laminate.
        walls: [Wall; 2],
        /// Position [mesh unit].
        position: [f64; 2],
        /// Number of positions.
        count: usize,
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

impl Explain for LaminaProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::Inside { .. } => {
                "mesh a layer between cells by cells, or name a curve on the border"
            }
            Self::IntoCells { free, .. } | Self::Mixed { free, .. } => {
                return Some(format!(
                    "give side = \"{}\", the one without cells",
                    free.name()
                ));
            }
            Self::SideChanges { .. } => {
                "in gmsh, give the lines one direction along the border (Physical Curve with a \
                 minus sign reverses one), or name two curves"
            }
            Self::Twice { .. } => "one [[lamina]] lists all its plies",
            Self::NoLength { .. } => "mesh this curve again",
            Self::SameEnds { .. } => "use shorter lines: at least three around a closed curve",
            Self::OtherOrder { .. } => {
                "mesh curves and surfaces in one order (in gmsh, Mesh.ElementOrder), from the same \
                 geometry"
            }
            Self::NoSide { .. } => {
                "lines and cells must share their nodes: in gmsh, make the physical curve of the \
                 curves that bound the surfaces, and mesh both together"
            }
            Self::AgainstEachOther { .. } => {
                "in gmsh, give all lines of the curve one direction: in Physical Curve(...) = {1, \
                 -2} the minus sign reverses curve 2"
            }
            Self::Branch { .. } => {
                "one wall may end on another one that continues smoothly and has one laminate and \
                 no cells next to it; mesh other junctions as cells, with laminates on their \
                 border"
            }
            Self::Crowded { .. } => {
                "use longer lines there, or mesh the junction as cells, with laminates on their \
                 border"
            }
            Self::Sharp { .. } => {
                "walls that meet at a sharper corner would overlap, or touch in one node only: mesh \
                 the corner as cells, with the laminates on their border"
            }
            Self::Differ { .. } => {
                "give both equal numbers of plies (one ply may be written as two), or mesh the \
                 corner as cells"
            }
            Self::OffCenter { .. } => "give both the same \"side\"",
            Self::OtherSide { .. } => {
                "give both the same \"side\"; or opposite ones, if the curves have opposite \
                 directions"
            }
            Self::Folded { .. } => {
                "lines must be longer than the laminate is thick where they meet at an angle, \
                 and radii larger on its inner side"
            }
            _ => return self.help_with_cells(),
        };
        Some(help.to_owned())
    }
}

impl LaminaProblem {
    /// The remedy for cells that do not fit, if there is one.
    fn help_with_cells(&self) -> Option<String> {
        let help = match self {
            Self::Misshapen { .. } => {
                "lines must be longer than the laminate is thick where they meet at an angle, and \
                 radii larger on its inner side; check the unit of \"thickness\""
            }
            Self::Overlaps { .. } => {
                "the plies extend from their line to its \"side\" by their thickness: check both, \
                 or leave space between the curves; walls that cross or end on another need a \
                 common node (in gmsh, BooleanFragments divides the lines there)"
            }
            Self::Unjoined { .. } => {
                "a laminate is joined to cells along whole sides, lines that share their nodes with \
                 them, and to another laminate at the ends of their lines: let the curves meet \
                 there, or mesh the joint as cells"
            }
            _ => return None,
        };
        Some(help.to_owned())
    }
}

/// Number of problems per kind that are reported one by one.
const LIMIT: usize = 5;

/// The first problems of a kind, and the number of further ones.
pub(super) fn limited(
    mut problems: Vec<(usize, LaminaProblem)>,
    what: &'static str,
) -> Vec<(usize, LaminaProblem)> {
    if let Some(&(lamina, _)) = problems.get(LIMIT) {
        let count = problems.len() - LIMIT;
        problems.truncate(LIMIT);
        problems.push((lamina, LaminaProblem::More { count, what }));
    }
    problems
}
