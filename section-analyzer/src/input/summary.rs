//! Summary of a section input, for its report.

use std::fmt;

use shared_geom::figure::tick_label;
use shared_geom::mesh::CellKind;

use super::electric::ElectricWarning;
use super::extent;
use super::plausible::{self, UnlikelyInput};
use crate::mesh::quality::{MeshQuality, NamedCell};
use crate::mesh::{HangingNode, MeshReport, NarrowGap, Seam, counted};
use crate::properties::AreaTable;
use crate::section::Section;

/// Number of seams, gaps and cells that are described; the others are counted.
const DESCRIBED: usize = 3;

/// Contents of the input, as numbers and text.
#[derive(Debug, Clone, PartialEq)]
pub struct InputSummary {
    /// The section file, as given.
    pub file: String,
    /// The mesh file, as named in the section file.
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
    /// Locations of the electrodes of the section, as text, parallel to them.
    pub electrodes: Vec<String>,
    /// Shapes of the cells.
    pub quality: MeshQuality,
    /// Warnings about the input.
    pub warnings: Vec<InputWarning>,
}

impl InputSummary {
    /// Measures the shapes of the cells, and warns of poor ones and of an unlikely size.
    pub(super) fn rate(&mut self, section: &Section) {
        let mesh = &section.mesh;
        let materials = section.cells.iter().map(|cell| cell.material);
        let mut materials = materials.filter_map(|index| section.materials.get(index));
        let has_walls = materials.any(plausible::forms_walls);
        let lengths = [extent::size(mesh), extent::thinnest(mesh)];
        let unit = (&*self.length_unit, self.length_factor);
        let unlikely = plausible::of_size(lengths, has_walls, unit);
        self.warnings.extend(unlikely.map(InputWarning::Unlikely));
        self.quality = MeshQuality::of(mesh);
        let count = self.quality.poor();
        let poor = self.quality.worst.iter().filter(|cell| cell.is_poor);
        let in_file_unit = |cell: &NamedCell| NamedCell {
            position: cell.position.map(|x| x / self.length_factor),
            ..cell.clone()
        };
        if count > 0 {
            let worst = poor.take(DESCRIBED).map(in_file_unit).collect();
            self.warnings.push(InputWarning::PoorCells { count, worst });
        }
    }
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

/// Source of the angles of a region.
#[derive(Debug, Clone, PartialEq)]
pub enum AngleSource {
    /// One angle for all its cells \[rad\].
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
                // Degrees to nine decimals, without the round-off of the conversion.
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

/// A warning about an input.
#[derive(Debug, Clone, PartialEq)]
pub enum InputWarning {
    /// An unused material.
    UnusedMaterial {
        /// Its name.
        material: String,
        /// The line of its table.
        line: usize,
    },
    /// A material without mass.
    NoDensity {
        /// Its name.
        material: String,
    },
    /// A material without expansion in a section in which others expand.
    NoExpansion {
        /// Its name.
        material: String,
    },
    /// A fiber angle of an isotropic material.
    IdleAngle {
        /// The region.
        region: String,
        /// Its material.
        material: String,
    },
    /// A warning about electric laws and electrodes.
    Electric(ElectricWarning),
    /// A number that is likely in another unit.
    Unlikely(UnlikelyInput),
    /// Cells that the mesh lists clockwise.
    ReversedCells {
        /// Their number.
        count: usize,
    },
    /// Unused nodes.
    UnusedNodes {
        /// Their number.
        count: usize,
    },
    /// Nodes at the same position, although their cells share no side.
    CoincidentNodes {
        /// Number of pairs.
        count: usize,
        /// Tags of the first pair.
        first: [u64; 2],
    },
    /// Walls that touch only in a node.
    PinchedNodes {
        /// Number of nodes.
        count: usize,
        /// Tag of the first.
        first: u64,
    },
    /// A slit: cells touch along sides that share no nodes.
    Slit(Seam),
    /// Hanging nodes, on sides of other cells.
    HangingNodes {
        /// Their number.
        count: usize,
        /// One of them.
        first: HangingNode,
    },
    /// Sides with a narrow gap.
    Gap(NarrowGap),
    /// Cells of poor shape.
    PoorCells {
        /// Their number.
        count: usize,
        /// The worst of them, positions in the unit of the mesh file.
        worst: Vec<NamedCell>,
    },
    /// A curvature or twist so large that it may be a mistake.
    StrongCurvature {
        /// Largest curvature times the distance of the farthest node from the reference
        /// line \[-\].
        strength: f64,
    },
    /// A reference line that is far from normal to its sections.
    Oblique {
        /// Angle between the line and the normal of the section \[deg\].
        angle: f64,
    },
    /// Further warnings of a kind.
    More {
        /// Their number.
        count: usize,
        /// Their kind.
        what: &'static str,
    },
}

impl InputWarning {
    /// Warnings of the checks of the mesh.
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
        let seams: Vec<[u64; 2]> = report.seams.iter().flat_map(|s| s.pairs.clone()).collect();
        let alone = |pair: &&[u64; 2]| {
            let [a, b] = **pair;
            !seams.contains(&[a, b]) && !seams.contains(&[b, a])
        };
        let alone: Vec<_> = report.coincident_nodes.iter().filter(alone).collect();
        if let Some(&&first) = alone.first() {
            let count = alone.len();
            warnings.push(Self::CoincidentNodes { count, first });
        }
        if let Some(&first) = report.pinched_nodes.first() {
            let count = report.pinched_nodes.len();
            warnings.push(Self::PinchedNodes { count, first });
        }
        let slits = report.seams.iter().cloned().map(Self::Slit);
        warnings.extend(limited(slits.collect(), "slits"));
        if let Some(first) = report.hanging_nodes.first().cloned() {
            let count = report.hanging_nodes.len();
            warnings.push(Self::HangingNodes { count, first });
        }
        let gaps = report.narrow_gaps.iter().cloned().map(Self::Gap);
        warnings.extend(limited(gaps.collect(), "narrow gaps"));
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
            Self::NoExpansion { material } => write!(
                f,
                "material \"{material}\" has no \"expansion\", and others have: it does not expand"
            ),
            Self::IdleAngle { region, material } => write!(
                f,
                "region \"{region}\" has a fiber angle, but its material \"{material}\" is \
                 isotropic: the angle does not change its stiffness"
            ),
            Self::Electric(warning) => warning.fmt(f),
            Self::Unlikely(input) => input.fmt(f),
            Self::ReversedCells { count } => write!(
                f,
                "{} listed clockwise in the mesh, as a whole surface: reversed",
                are(*count, "cell")
            ),
            Self::UnusedNodes { count } => {
                write!(f, "{} used by no cell: ignored", are(*count, "node"))
            }
            Self::CoincidentNodes {
                count,
                first: [a, b],
            } => write!(
                f,
                "{} at the same position, as nodes {a} and {b}, but not joined",
                are(*count, "node pair")
            ),
            Self::PinchedNodes { count, first } => write!(f, "{}", pinched(*count, *first)),
            Self::Slit(seam) => write!(f, "slit: {seam}"),
            Self::HangingNodes { count: 1, first } => write!(f, "slit: {first}"),
            Self::HangingNodes { count, first } => {
                write!(f, "slit: {first}; and {} more like it", count - 1)
            }
            Self::Gap(gap) => write!(f, "narrow gap: {gap}"),
            Self::PoorCells { count, worst } => write_poor_cells(f, *count, worst),
            Self::StrongCurvature { strength } => write_curvature(f, *strength),
            Self::Oblique { angle } => write_oblique(f, *angle),
            Self::More { count, what } => write!(f, "and {count} more {what}"),
        }
    }
}

fn write_curvature(f: &mut fmt::Formatter<'_>, strength: f64) -> fmt::Result {
    write!(
        f,
        "curvature times size is {}: more than blades and springs usually have; check the \
         unit (plain numbers are angles per length)",
        tick_label(strength, 0.0)
    )
}

fn write_oblique(f: &mut fmt::Formatter<'_>, angle: f64) -> fmt::Result {
    write!(
        f,
        "the reference line is {} deg off the normal of the section; check \"slope\", \
         whose first number is along the normal",
        tick_label(angle, 0.0)
    )
}

/// A line for each of the worst cells.
fn write_poor_cells(f: &mut fmt::Formatter<'_>, count: usize, worst: &[NamedCell]) -> fmt::Result {
    let have = if count == 1 { "has" } else { "have" };
    let cells = counted(count, "cell");
    write!(
        f,
        "{cells} {have} a poor shape: results nearby are less accurate"
    )?;
    for cell in worst {
        let [y, z] = cell.position.map(|x| tick_label(x, 0.0));
        let (tag, group, worst) = (cell.cell, &cell.group, cell.worst);
        write!(
            f,
            "\n      cell {tag} at ({y}, {z}) in \"{group}\": {worst}"
        )?;
    }
    match count.saturating_sub(worst.len()) {
        0 => Ok(()),
        more => write!(f, "\n      and {more} more"),
    }
}

/// The first warnings of a kind, and the number of further ones.
fn limited(mut warnings: Vec<InputWarning>, what: &'static str) -> Vec<InputWarning> {
    let count = warnings.len().saturating_sub(DESCRIBED);
    if count > 0 {
        warnings.truncate(DESCRIBED);
        warnings.push(InputWarning::More { count, what });
    }
    warnings
}

/// Nodes in which walls touch.
fn pinched(count: usize, first: u64) -> String {
    let others = match count {
        1 => String::new(),
        _ => format!(" and {} more", count - 1),
    };
    format!(
        "walls touch in a single node, {first}{others}: a point carries no shear flow, so that \
         stiffness and stresses there depend on the mesh"
    )
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
