//! Problems of section inputs, in addition to the problems of any input file.

use shared_geom::error::Explain;
use shared_geom::figure::tick_label;
use shared_geom::files::nearest_file;
use shared_geom::mesh::GroupKind;
use shared_geom::wrench::COMPONENTS;

use crate::material::{MaterialProblem, StrengthProblem};
use crate::mesh::counted;
use crate::properties::NoPrestress;

mod words;

pub(super) use words::nearest_or_all;
use words::{across_fiber, grouping, known_groups, listed, strength_keys};

/// A problem of a section input, of its tables, or of its references to the mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InputProblem {
    /// A file named in the input cannot be read.
    #[error("{what} \"{file}\" cannot be read: {reason}")]
    Unreadable {
        /// Description of the file.
        what: &'static str,
        /// The path of the file.
        file: String,
        /// The reason, as text.
        reason: String,
        /// Files in its folder, if it does not exist.
        known: Vec<String>,
    },
    /// The effect of prestress is requested but not known.
    #[error("\"prestress\": {reason}")]
    Prestress {
        /// The reason.
        reason: NoPrestress,
    },
    /// A material with keys of two kinds of law.
    #[error(
        "material \"{material}\" has \"{first}\" and \"{second}\", which belong to two kinds of \
         material, expected one kind"
    )]
    MixedLaw {
        /// Name of the material.
        material: String,
        /// A key of one kind.
        first: &'static str,
        /// A key of another kind.
        second: &'static str,
    },
    /// A material with no key of any law.
    #[error(
        "material \"{material}\" has no elastic constants, expected \"young\" and \"poisson\", \
         \"e1\" to \"nu23\", or \"stiffness\""
    )]
    NoLaw {
        /// Name of the material.
        material: String,
    },
    /// A transversely isotropic material without a constant across the fiber, or with both.
    #[error("material \"{material}\" has {}", across_fiber(*.has_both))]
    AcrossFiber {
        /// Name of the material.
        material: String,
        /// Whether it has both constants.
        has_both: bool,
    },
    /// A material that cannot exist.
    #[error("material \"{material}\": {problem}")]
    Inadmissible {
        /// Name of the material.
        material: String,
        /// The bound that it violates.
        problem: MaterialProblem,
    },
    /// An empty table of strengths.
    #[error("[material.{material}.{table}] is empty, expected {}", strength_keys(.table))]
    NoStrength {
        /// Name of the material.
        material: String,
        /// `strength` or `strain_limit`.
        table: &'static str,
    },
    /// A table with strengths of two kinds.
    #[error(
        "[material.{material}.{table}] has \"{first}\" and \"{second}\", which belong to two \
         kinds of strength, expected one kind"
    )]
    MixedStrength {
        /// Name of the material.
        material: String,
        /// `strength` or `strain_limit`.
        table: &'static str,
        /// A key of one kind.
        first: &'static str,
        /// A key of another kind.
        second: &'static str,
    },
    /// Strengths that do not suit the law of their material.
    #[error(
        "[material.{material}.{table}] has \"{key}\", but the material is {}",
        if *.is_isotropic { "isotropic" } else { "not isotropic" }
    )]
    StrengthOfOtherLaw {
        /// Name of the material.
        material: String,
        /// `strength` or `strain_limit`.
        table: &'static str,
        /// The key.
        key: &'static str,
        /// Whether the material is isotropic.
        is_isotropic: bool,
    },
    /// An impossible strength.
    #[error("material \"{material}\": {problem}")]
    Strength {
        /// Name of the material.
        material: String,
        /// The bound that it violates.
        problem: StrengthProblem,
    },
    /// A load case without any load.
    #[error(
        "load \"{load}\" is zero, expected at least one of \"axial\", \"shear_y\", \"shear_z\", \
         \"torsion\", \"bending_y\", \"bending_z\", \"temperature\", \"initial_strain\", \
         \"traction\", \"volume\", \"voltages\""
    )]
    ZeroLoad {
        /// Name of the load case.
        load: String,
    },
    /// A section beyond all structures.
    #[error("the section is {size:e} m across, expected {smallest:e} m to {largest:e} m")]
    Size {
        /// Its diagonal \[m\].
        size: f64,
        /// Smallest one \[m\].
        smallest: f64,
        /// Largest one \[m\].
        largest: f64,
    },
    /// A section so far from the origin that its results have no accurate digits.
    #[error(
        "the section lies {distance:.3e} m from the origin of the mesh, {ratio:.1e} times its \
         size, expected at most {limit:e} times: torsion about the origin would have no accurate \
         digits"
    )]
    Far {
        /// Distance of its center \[m\].
        distance: f64,
        /// Distance over size \[-\].
        ratio: f64,
        /// Largest ratio \[-\].
        limit: f64,
    },
    /// A section that reaches the center of curvature of its beam.
    #[error(
        "the beam is curved by {} deg/m, and the section reaches its center of curvature: at node \
         {node} of cell {cell}, ({}, {}) in the mesh, J = l1 + k2 z - k3 y is {}, expected more \
         than 0 everywhere, which requires less than {} deg/m",
        label(*.curvature), label(.position[0]), label(.position[1]), label(*.length), label(*.largest)
    )]
    Folded {
        /// Tag of a cell there.
        cell: u64,
        /// Tag of the node with the least J.
        node: u64,
        /// Its position (y, z) \[unit of length of the file\].
        position: [f64; 2],
        /// J at this node \[-\].
        length: f64,
        /// Curvature about y and z together \[deg/m\].
        curvature: f64,
        /// The curvature for which the least J is zero \[deg/m\].
        largest: f64,
        /// Degrees per meter in a plain number of the file \[deg/m\].
        factor: f64,
        /// Distance of the farthest node from the origin \[unit of length of the file\].
        far: f64,
    },
    /// A load beyond all structures, whose stresses would not be finite.
    #[error(
        "load \"{load}\" has {} of {value:e} about the origin of the mesh, expected at most \
         {limit:e}",
        COMPONENTS[*.component]
    )]
    HugeLoad {
        /// Name of the load case.
        load: String,
        /// Index of the component.
        component: usize,
        /// Value found \[N, N m\].
        value: f64,
        /// Largest size \[N, N m\].
        limit: f64,
    },
    /// A name that cannot be part of a file name.
    #[error("load \"{load}\": expected a name of letters, digits, \"-\" and \"_\"")]
    LoadName {
        /// Name of the load case.
        load: String,
    },
    /// A region of a material that the file does not have.
    #[error("unknown material \"{material}\" in region \"{region}\"")]
    UnknownMaterial {
        /// The name found.
        material: String,
        /// Physical group of the region.
        region: String,
        /// The materials of the file.
        known: Vec<String>,
    },
    /// A group of cells or lines that the mesh does not have.
    #[error("the mesh has no {kind} \"{group}\"")]
    UnknownGroup {
        /// The kind of group.
        kind: GroupKind,
        /// The name found.
        group: String,
        /// The groups of this kind in the mesh.
        known: Vec<String>,
        /// Whether a group of the other kind has this name.
        is_other: bool,
    },
    /// A group without elements.
    #[error("{kind} \"{group}\" has no {content} in the mesh, expected at least one")]
    EmptyGroup {
        /// The kind of group.
        kind: GroupKind,
        /// Its name.
        group: String,
        /// `cells` or `lines`.
        content: &'static str,
    },
    /// Two regions for one group.
    #[error("{kind} \"{group}\" already has a region on line {line}, expected one")]
    GroupInTwoRegions {
        /// The kind of group.
        kind: GroupKind,
        /// The group.
        group: String,
        /// Line of its first region.
        line: usize,
    },
    /// Cells that are in the groups of two regions.
    #[error(
        "regions \"{first}\" (line {line}) and \"{second}\" both contain {} (cell {example} for \
         example), expected every cell in one region",
        counted(*.cells, "cell")
    )]
    CellInTwoRegions {
        /// Group of the region that comes first in the file.
        first: String,
        /// Its line.
        line: usize,
        /// Group of the other region.
        second: String,
        /// Number of such cells.
        cells: usize,
        /// Tag of one of them.
        example: u64,
    },
    /// Cells without material.
    #[error("{kind} \"{group}\" ({}) has no region", counted(*.cells, "cell"))]
    GroupWithoutRegion {
        /// The kind of group.
        kind: GroupKind,
        /// The group.
        group: String,
        /// Number of its cells.
        cells: usize,
    },
    /// Cells in no group.
    #[error(
        "mesh \"{mesh}\" has {} in no {kind} (cell {example} for example), expected \
         every cell in one",
        counted(*.cells, "cell")
    )]
    CellsWithoutGroup {
        /// The kind of group.
        kind: GroupKind,
        /// The mesh as written in the input.
        mesh: String,
        /// Number of such cells.
        cells: usize,
        /// Tag of one of them.
        example: u64,
    },
    /// A laminate with a list of plies and the keys of a single ply.
    #[error("a lamina has \"plies\" and \"{key}\", expected one of them")]
    PliesAndPly {
        /// A key of a ply.
        key: &'static str,
    },
    /// A laminate without plies.
    #[error("a lamina has no plies")]
    NoPlies,
    /// A laminate whose name is in use.
    #[error("the name \"{name}\" of a lamina is already the name of a surface or another lamina")]
    LaminaName {
        /// The name.
        name: String,
    },
    /// An angle given in two ways, or in an unknown way.
    #[error("\"{key}\" has both \"table\" and \"follow\", expected one of them")]
    TableAndFollow {
        /// `fiber_angle` or `plane_angle`.
        key: &'static str,
    },
    /// An angle that is neither a number nor a table with the right keys.
    #[error("\"{key}\" has no {expected}")]
    NoAngle {
        /// `fiber_angle` or `plane_angle`.
        key: &'static str,
        /// The keys expected, as text.
        expected: &'static str,
    },
    /// A table by cells without the expected heading.
    #[error("the columns are {found}, expected \"cell,{column}\"")]
    TableHeading {
        /// The heading found, in quotes, or "missing".
        found: String,
        /// Heading of the second column.
        column: &'static str,
    },
    /// A row of a table by cells that cannot be read.
    #[error("row \"{found}\" cannot be read, expected {expected}")]
    TableRow {
        /// The row as written.
        found: String,
        /// Description of the expected row.
        expected: String,
    },
    /// A cell with two values.
    #[error("cell {cell} has {value} on line {line} already, expected one row for each cell")]
    TableRepeats {
        /// Tag of the cell.
        cell: u64,
        /// Description of the values of the table.
        value: &'static str,
        /// Line of its first value.
        line: usize,
    },
    /// Further rows with problems.
    #[error("{} with problems of this kind follow", counted(*.count, "more row"))]
    TableMore {
        /// Their number.
        count: usize,
    },
    /// A table with missing or unknown rows.
    #[error(
        "{column} table \"{table}\" has {}, expected {expected}, one for each cell of {users}{}{}",
        counted(*.found, "row"), listed(&format!("; no {column} for"), *.has_lines, .missing),
        listed("; unknown", *.has_lines, .unknown)
    )]
    TableCells {
        /// Heading of the column of values.
        column: &'static str,
        /// The table as written in the input.
        table: String,
        /// Rows found.
        found: usize,
        /// Rows expected.
        expected: usize,
        /// Users of the table: groups, or the mesh.
        users: String,
        /// Whether rows may be for lines too.
        has_lines: bool,
        /// Cells without a value.
        missing: Box<[u64]>,
        /// Cells that do not use the table.
        unknown: Box<[u64]>,
    },
}

impl Explain for InputProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Unreadable { file, known, .. } if !known.is_empty() => {
                Some(nearest_file(file, known))
            }
            Self::UnknownMaterial {
                material, known, ..
            } => Some(nearest_or_all(material, known, "materials of the file")),
            Self::UnknownGroup {
                kind,
                group,
                known,
                is_other,
            } => Some(known_groups(*kind, group, known, *is_other)),
            Self::GroupWithoutRegion { group, .. } => Some(format!(
                "add [[region]] with group = \"{group}\" and its material"
            )),
            Self::CellsWithoutGroup { kind, .. } => Some(grouping(kind.form).to_owned()),
            Self::CellInTwoRegions { .. } => Some(
                "a cell has one material: name groups that share no cell, or remove the surface \
                 from one of them"
                    .to_owned(),
            ),
            Self::Inadmissible { problem, .. } => problem.help(),
            Self::Strength { problem, .. } => problem.help(),
            Self::StrengthOfOtherLaw {
                table,
                is_isotropic,
                ..
            } => Some(match (*is_isotropic, *table) {
                (true, "strength") => {
                    "give \"yield\", or \"tension\", \"compression\" and \"shear\"".to_owned()
                }
                (true, _) => "give \"tension\", \"compression\" and \"shear\"".to_owned(),
                (false, _) => "give \"xt\", \"xc\", \"yt\", \"yc\" and \"s12\"".to_owned(),
            }),
            Self::Size { .. } => Some("check \"length\" in [units]".to_owned()),
            Self::Far { .. } => Some(
                "move the mesh to its origin (in gmsh, Translate): results are about the origin"
                    .to_owned(),
            ),
            Self::Folded { factor, far, .. } => Some(folded_help(*factor, *far)),
            _ => self.further_help().map(str::to_owned),
        }
    }
}

fn label(value: f64) -> String {
    tick_label(value, 0.0)
}

/// Remedy for a curvature whose plain numbers are in units of `factor` deg/m, of a
/// section whose farthest node is `far` from the origin of the mesh.
fn folded_help(factor: f64, far: f64) -> String {
    format!(
        "a plain number is in units of {} deg/m here: check the unit (as in \"5 deg/m\"; 1/R in \
         1/m is in \"rad/m\"), the signs (k3 > 0 bends the beam toward +y, k2 > 0 toward -z), and \
         that the origin of the mesh is on the reference line (the farthest node is {} away)",
        label(factor),
        label(far)
    )
}

impl InputProblem {
    fn further_help(&self) -> Option<&'static str> {
        match self {
            Self::NoPlies => Some(
                "give \"material\" and \"thickness\", or plies = [{ material = ..., thickness = \
                 ... }, ...]",
            ),
            Self::LaminaName { .. } => {
                Some("tables and reports use it: give the lamina its own \"name\"")
            }
            Self::Prestress { .. } => Some("remove \"prestress\" or [initial_curvature]"),
            Self::HugeLoad { .. } => {
                Some("this is in SI units; check the unit and the \"point\" where the load acts")
            }
            Self::LoadName { .. } => Some("the name becomes part of file names"),
            _ => None,
        }
    }
}
