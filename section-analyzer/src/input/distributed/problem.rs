//! Problems of distributed loads.

use shared_geom::error::Explain;

use crate::mesh::short;

/// A problem of a traction or of a volume force.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DistributedProblem {
    /// A part of a load without a force.
    #[error("the {part} has no {expected}, expected one of them")]
    NoForce {
        /// `traction` or `volume force`.
        part: &'static str,
        /// The keys, as text.
        expected: &'static str,
    },
    /// A part of a load with two kinds of force.
    #[error("the {part} has \"{first}\" and \"{second}\", expected one of them")]
    TwoForces {
        /// `traction` or `volume force`.
        part: &'static str,
        /// A key.
        first: &'static str,
        /// Another key.
        second: &'static str,
    },
    /// A part of a load that is zero.
    #[error("the {part} is zero, expected a nonzero number")]
    Zero {
        /// `traction` or `volume force`.
        part: &'static str,
    },
    /// A number beyond all structures.
    #[error("{}\"{key}\" is {value:e} in SI units, expected at most {limit:e}",
        .entry.map_or_else(String::new, |entry| format!("number {entry} of ")))]
    Large {
        /// The key.
        key: String,
        /// Index among several numbers, from 1.
        entry: Option<usize>,
        /// The number \[SI\].
        value: f64,
        /// The largest allowed \[SI\].
        limit: f64,
    },
    /// A curve whose lines belong to no cell.
    #[error(
        "line {line} of curve \"{curve}\", at ({}, {}) m, is not a side of a cell, \
         expected a curve along sides of cells",
        short(.at[0]), short(.at[1])
    )]
    NoSide {
        /// Name of the curve.
        curve: String,
        /// Tag of the line.
        line: u64,
        /// Its midpoint (y, z) \[m\].
        at: [f64; 2],
        /// Faces of the laminates on the curve.
        faces: Vec<String>,
    },
    /// A pressure on a curve that has cells on both sides.
    #[error(
        "curve \"{curve}\" has cells on both sides of line {line}, expected a pressure \
         on a surface"
    )]
    Inside {
        /// Name of the curve.
        curve: String,
        /// Tag of the line.
        line: u64,
        /// Faces of the laminates on the curve.
        faces: Vec<String>,
    },
    /// A region that has no cells.
    #[error("group \"{group}\" is not a region of the section")]
    NoRegion {
        /// The name found.
        group: String,
        /// The regions of the section.
        known: Vec<String>,
    },
}

impl Explain for DistributedProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::NoSide { faces, .. } | Self::Inside { faces, .. } if !faces.is_empty() => {
                let names: Vec<_> = faces.iter().map(|name| format!("\"{name}\"")).collect();
                Some(format!(
                    "the curve has a laminate: give its {}, {}",
                    if names.len() == 1 { "face" } else { "faces" },
                    names.join(" or ")
                ))
            }
            Self::NoSide { .. } => Some(
                "in gmsh, make the physical curve of curves that bound surfaces of the section"
                    .to_owned(),
            ),
            Self::Inside { .. } => Some(
                "the direction of the pressure is undetermined: give \"force\" in section axes, \
                 or name a curve on the outline or around a hole"
                    .to_owned(),
            ),
            Self::NoRegion { known, .. } => {
                let names: Vec<_> = known.iter().map(|name| format!("\"{name}\"")).collect();
                Some(format!("regions of the section: {}", names.join(", ")))
            }
            Self::NoForce { .. }
            | Self::TwoForces { .. }
            | Self::Zero { .. }
            | Self::Large { .. } => None,
        }
    }
}
