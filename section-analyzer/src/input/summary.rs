//! What went into a section, for its report.

use std::fmt;

use shared_geom::mesh::CellKind;

use crate::mesh::MeshReport;
use crate::properties::AreaTable;

/// What was read, in numbers and words.
#[derive(Debug, Clone, PartialEq)]
pub struct InputSummary {
    /// The section file, as it was given.
    pub file: String,
    /// The mesh file, as the section file names it.
    pub mesh_file: String,
    /// SHA-256 of the section file, the mesh and all tables.
    pub input_hash: String,
    /// Name of the declared unit of length, in which plots are drawn.
    pub length_unit: String,
    /// That unit \[m per unit\].
    pub length_factor: f64,
    /// Number of cells of each kind that the mesh has.
    pub kinds: Vec<(CellKind, usize)>,
    /// The regions, in the order of the file.
    pub regions: Vec<RegionSummary>,
    /// Areas, moments of area, perimeters and masses, parallel to `regions`.
    pub areas: AreaTable,
    /// What is odd but not wrong.
    pub warnings: Vec<InputWarning>,
}

/// One region.
#[derive(Debug, Clone, PartialEq)]
pub struct RegionSummary {
    /// Its physical group.
    pub group: String,
    /// Name of its material.
    pub material: String,
    /// Angle of the fiber from the beam axis.
    pub fiber_angle: AngleSource,
    /// Angle of the wall direction from the section axis y.
    pub plane_angle: AngleSource,
}

/// Where the angles of a region come from.
#[derive(Debug, Clone, PartialEq)]
pub enum AngleSource {
    /// The same for all its cells \[rad\].
    Constant(f64),
    /// A table by cell.
    Table(String),
    /// The direction of a curve.
    Curve {
        /// Name of the curve.
        name: String,
        /// Whether the direction is the opposite one.
        reverse: bool,
    },
}

impl fmt::Display for AngleSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant(angle) => {
                // Degrees to nine decimals, free of the noise of the conversion.
                let degrees = (angle.to_degrees() * 1e9).round() / 1e9;
                write!(f, "{} deg", degrees + 0.0)
            }
            Self::Table(file) => write!(f, "table {file}"),
            Self::Curve {
                name,
                reverse: false,
            } => write!(f, "along {name}"),
            Self::Curve {
                name,
                reverse: true,
            } => write!(f, "against {name}"),
        }
    }
}

/// What is odd about an input, but not wrong.
#[derive(Debug, Clone, PartialEq)]
pub enum InputWarning {
    /// A material of no region.
    UnusedMaterial {
        /// Its name.
        material: String,
        /// The line on which it stands.
        line: usize,
    },
    /// A material without mass.
    NoDensity {
        /// Its name.
        material: String,
    },
    /// Cells that the mesh lists clockwise.
    ReversedCells {
        /// Their number.
        count: usize,
    },
    /// Nodes of no cell.
    UnusedNodes {
        /// Their number.
        count: usize,
    },
    /// Nodes that lie on each other.
    CoincidentNodes {
        /// Number of pairs.
        count: usize,
        /// Tags of the first pair.
        first: [u64; 2],
    },
}

impl InputWarning {
    /// What the checks of the mesh have to say.
    pub(super) fn of_mesh(report: &MeshReport) -> Vec<Self> {
        let mut warnings = Vec::new();
        if report.reversed_cells > 0 {
            let count = report.reversed_cells;
            warnings.push(Self::ReversedCells { count });
        }
        if report.unused_nodes > 0 {
            let count = report.unused_nodes;
            warnings.push(Self::UnusedNodes { count });
        }
        if let Some(&first) = report.coincident_nodes.first() {
            let count = report.coincident_nodes.len();
            warnings.push(Self::CoincidentNodes { count, first });
        }
        warnings
    }
}

impl fmt::Display for InputWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnusedMaterial { material, line } => {
                write!(
                    f,
                    "material \"{material}\" (line {line}) is used by no region"
                )
            }
            Self::NoDensity { material } => {
                write!(
                    f,
                    "material \"{material}\" has density 0: its cells have no mass"
                )
            }
            Self::ReversedCells { count } => write!(
                f,
                "{} listed clockwise in the mesh, as a whole surface: turned round",
                are(*count, "cell")
            ),
            Self::UnusedNodes { count } => {
                write!(f, "{} used by no cell: left out", are(*count, "node"))
            }
            Self::CoincidentNodes {
                count,
                first: [a, b],
            } => write!(
                f,
                "{} at the same place, as nodes {a} and {b}: the section has a slit there",
                are(*count, "node pair")
            ),
        }
    }
}

fn are(count: usize, what: &str) -> String {
    match count {
        1 => format!("1 {what} is"),
        _ => format!("{count} {what}s are"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_shown_in_plain_degrees() {
        let degrees = |angle: f64| AngleSource::Constant(angle.to_radians()).to_string();
        assert_eq!(degrees(15.0), "15 deg");
        assert_eq!(degrees(-62.5), "-62.5 deg");
        assert_eq!(degrees(-0.0), "0 deg");
        let curve = AngleSource::Curve {
            name: "outer".into(),
            reverse: true,
        };
        assert_eq!(curve.to_string(), "against outer");
    }
}
