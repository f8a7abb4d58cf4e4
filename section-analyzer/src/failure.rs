//! Reasons for which an analysis ends without a result.
//!
//! The input stage refuses errors that are visible in the input. The failures of this
//! module are numerical, each with its location and a remedy.

use shared_geom::error::Explain;

/// Failure of an analysis.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Failure {
    /// The section is empty.
    #[error("the section has no cells")]
    NoCells,
    /// The lists of cells and of their materials differ in length.
    #[error("{materials} of {cells} cells have a material, expected all")]
    CellsWithoutMaterial {
        /// Number of cells in the mesh.
        cells: usize,
        /// Number of entries that have a material.
        materials: usize,
    },
    /// A cell refers to a material or node that does not exist.
    #[error("cell {tag} refers to a material or a node that does not exist")]
    DanglingCell {
        /// Number of the cell in its file.
        tag: u64,
    },
    /// Size, area or stiffness is zero, infinite or not a number.
    #[error("the {what} of the section is zero or not finite")]
    NoScale {
        /// `size`, `area`, `stiffness` or `mass`.
        what: &'static str,
    },
    /// A cell is inverted, or flat, or folded.
    #[error("cell {tag} has no positive area at one of its integration points")]
    CellWithoutArea {
        /// Number of the cell in its file.
        tag: u64,
    },
    /// The beam is curved more than the section allows.
    #[error(
        "cell {tag} folds over itself at y = {y:.4e} m, z = {z:.4e} m: with the initial curvature {curvature:?} 1/m its volume per area and length is {volume:.3e} there, expected more than zero"
    )]
    Folded {
        /// Number of the cell in its file.
        tag: u64,
        /// Its y coordinate \[m\].
        y: f64,
        /// Its z coordinate \[m\].
        z: f64,
        /// J at this point, (S-71) \[-\].
        volume: f64,
        /// Initial curvature, in section axes \[1/m\].
        curvature: [f64; 3],
    },
    /// The cells are not connected.
    #[error(
        "the section is in {parts} parts that share no node; one of them holds node {node}, another node {other}"
    )]
    Disconnected {
        /// Number of parts.
        parts: usize,
        /// Tag of a node of the first part.
        node: u64,
        /// Tag of a node of the second part.
        other: u64,
    },
    /// All nodes lie on one line.
    #[error("all nodes of the section lie on one line")]
    NodesOnOneLine,
    /// The matrix of the in-plane problem is singular to working accuracy.
    #[error(
        "the section is loose at node {node} (y = {y:.4e} m, z = {z:.4e} m): its stiffness against warping there is {ratio:.0e} of the stiffness of its cells, expected more than {limit:.0e}"
    )]
    Loose {
        /// Tag of the node where the factorization broke down.
        node: u64,
        /// Its y coordinate \[m\].
        y: f64,
        /// Its z coordinate \[m\].
        z: f64,
        /// Pivot relative to the diagonal entry \[-\].
        ratio: f64,
        /// Smallest ratio that leaves accurate digits in the result \[-\].
        limit: f64,
    },
    /// A section matrix violates a rigid-body identity.
    #[error(
        "rigid-body identity {identity} is violated by {error:.1e}, expected less than {limit:.0e}"
    )]
    Identity {
        /// The identity.
        identity: &'static str,
        /// Its relative error \[-\].
        error: f64,
        /// The limit \[-\].
        limit: f64,
    },
    /// Matrices from another program are inconsistent with each other.
    #[error(
        "the matrices do not belong to one section: {}, expected less than {limit:.0e}",
        reported(.broken)
    )]
    Matrices {
        /// Each violated identity, with its relative error.
        broken: Vec<(&'static str, f64)>,
        /// Whether the matrices are of a slice.
        of_slice: bool,
        /// The limit \[-\].
        limit: f64,
    },
    /// A given matrix is zero or not finite.
    #[error("{what} is zero or not finite, expected finite values of a section")]
    NoSize {
        /// Which: a matrix, or the coordinates of the nodes.
        what: &'static str,
    },
    /// A given matrix has negative energy for a motion of its nodes.
    #[error(
        "{matrix} is not positive: a motion of node {node} (y = {y:.4e} m, z = {z:.4e} m) and its neighbors has zero or negative energy"
    )]
    NotPositive {
        /// M or E, with its description.
        matrix: &'static str,
        /// Number of the node in its table.
        node: u64,
        /// Its y coordinate \[m\].
        y: f64,
        /// Its z coordinate \[m\].
        z: f64,
    },
    /// A generalized strain has no energy in the given matrices.
    #[error("the energy of one of the generalized strains is zero or negative with these matrices")]
    NoStiffness,
    /// The given matrices have too few digits for the section.
    #[error(
        "the result would have an error of about {error:.1e}, expected less than {limit:.0e}: the matrices violate the identities of rigid motions by {identity:.1e}, and the condition number of the section, {condition:.1e}, magnifies this error"
    )]
    Digits {
        /// Estimate of the relative error of the result \[-\].
        error: f64,
        /// The limit \[-\].
        limit: f64,
        /// Error of the identities \[-\].
        identity: f64,
        /// Condition number \[-\].
        condition: f64,
    },
    /// The solution fails one of its own checks.
    #[error(
        "{check} is off by {error:.1e}, expected less than {limit:.0e}; the weakest point is node {node} (y = {y:.4e} m, z = {z:.4e} m)"
    )]
    Inaccurate {
        /// The check.
        check: &'static str,
        /// Its relative error \[-\].
        error: f64,
        /// The limit \[-\].
        limit: f64,
        /// Tag of the node with the smallest pivot.
        node: u64,
        /// Its y coordinate \[m\].
        y: f64,
        /// Its z coordinate \[m\].
        z: f64,
    },
    /// The generalized strains have no unique solution.
    #[error(
        "the section has no stiffness against one of the generalized strains, to working accuracy"
    )]
    ComplianceNotPositive,
    /// The recovered stress does not integrate to the internal force.
    #[error(
        "load \"{load}\": the resultants of the recovered stress are off by {error:.1e}, expected less than {limit:.0e}"
    )]
    Resultant {
        /// Name of the load case.
        load: String,
        /// Its relative error \[-\].
        error: f64,
        /// The limit \[-\].
        limit: f64,
    },
    /// A load under an imposed state that was not solved.
    #[error("load \"{load}\" acts with \"{state}\", which is not an imposed state of the section")]
    UnknownState {
        /// Name of the load case.
        load: String,
        /// Name of the state.
        state: String,
    },
    /// A load with a voltage for an electrode that the section does not have.
    #[error(
        "load \"{load}\" has a voltage for \"{electrode}\", which is not an electrode of the section"
    )]
    UnknownElectrode {
        /// Name of the load case.
        load: String,
        /// The unknown name.
        electrode: String,
        /// Name of a similar electrode.
        nearest: Option<String>,
    },
    /// A load with a voltage for an electrode that is grounded or open.
    #[error("load \"{load}\" has a voltage for electrode \"{electrode}\", which is not driven")]
    NotDriven {
        /// Name of the load case.
        load: String,
        /// Name of the electrode.
        electrode: String,
    },
    /// Open electrodes whose voltages are undetermined.
    #[error("the voltages of the open electrodes {} are not determined", .electrodes.join(", "))]
    Undetermined {
        /// Names of the open electrodes.
        electrodes: Vec<String>,
    },
    /// Open electrodes under a load for which their charge is not known.
    #[error(
        "load \"{load}\": the voltages of open electrodes are not known under imposed strains and loads along the beam"
    )]
    FloatingUnder {
        /// Name of the load case.
        load: String,
    },
    /// The search for end effects ended before their decay rates converged.
    #[error(
        "the rates of decay of end effects still change by {change:.1e} with {vectors} vectors"
    )]
    EndEffects {
        /// The largest relative change \[-\].
        change: f64,
        /// Number of vectors in the search.
        vectors: usize,
    },
    /// The factorization does not fit in memory.
    #[error("a factorization for {unknowns} unknowns does not fit in memory")]
    OutOfMemory {
        /// Number of unknowns.
        unknowns: usize,
    },
}

/// Error of identities below which rounding is the cause: a wrong order of nodes or
/// unknowns, wrong axes or units give errors of 0.01 and more.
const ROUNDING: f64 = 1e-3;

const DIGITS: &str = "the files have too few digits, or the slice is too thin for them: write the matrices with 15 digits or more, or make the slice about as thick as its elements are wide";

/// Whether rounding is the cause of the violated identities: the errors are small, and
/// among them are the identities of E, which lose the most digits. Data given twice may
/// differ as much for other reasons.
fn are_digits(broken: &[(&str, f64)]) -> bool {
    let of_e = ["E H = R T", "R' H = A T"];
    let of_given = ["M H = L", "C' H = R", "L' H = A"];
    broken.iter().all(|(_, error)| *error < ROUNDING)
        && broken.iter().any(|(name, _)| of_e.contains(name))
        && !broken.iter().any(|(name, _)| of_given.contains(name))
}

/// Identities with their errors.
fn reported(broken: &[(&str, f64)]) -> String {
    let each = broken
        .iter()
        .map(|(identity, error)| format!("{identity} is violated by {error:.1e}"));
    each.collect::<Vec<_>>().join(", ")
}

/// Remedy for given matrices that are inconsistent: of blocks, or of a slice.
const GIVEN: [&str; 2] = [
    "H are the rigid motions of the nodes: check the order of nodes and unknowns (ux, uy, uz of each), the axes (x along the beam), the unit of length of the node table, whether the rows of C belong to u', and [initial_curvature], which a curved beam needs: plain numbers of \"curvature\" are degrees per length (\"2.5 rad/m\" is with a unit), and \"slope\" is the slope of the line at the reference point",
    "check \"thickness\" and its unit, the order of the two faces (first the face at the smaller x), the order of nodes and unknowns (ux, uy, uz of each), the axes (x along the beam), and the unit of length of the node table",
];

impl Explain for Failure {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::NoCells => "put every cell of the mesh in a group that has a material",
            Self::CellWithoutArea { .. } => {
                "list the nodes of the cell counterclockwise, and move mid-side nodes near the middle of their side"
            }
            Self::Folded { .. } => {
                "the center of curvature must lie outside of the section: check the unit and the sign of the curvature, and the reference point, at which the slope is given"
            }
            Self::Disconnected { .. } => {
                "merge coincident nodes along the seam (in gmsh: \"Coherence Mesh\"), or fill the gap with a soft material"
            }
            Self::Loose { .. } => {
                "look for parts joined at a single node, seams of doubled nodes, moduli many orders of magnitude apart, and walls thousands of times longer than thick, which need square cells"
            }
            Self::Matrices { broken, .. } if are_digits(broken) => DIGITS,
            Self::Matrices { of_slice, .. } => GIVEN[usize::from(*of_slice)],
            Self::Digits { .. } => DIGITS,
            Self::NoSize { .. } => "check the files and the units",
            Self::NotPositive { matrix, .. } if matrix.starts_with('M') => {
                "for a slice, check \"through\" (elements with one point through the slice are \"middle\"), the thickness and its unit; for blocks, whether m and e are exchanged; and the signs"
            }
            Self::NotPositive { .. } => {
                "check the signs, and look for nodes without elements and parts joined at a single node"
            }
            Self::NoStiffness => {
                "check whether m, c and e belong to the same section, their units, and \"through\""
            }
            Self::Identity { .. } => {
                "look for mid-side nodes that do not belong to their cell and for cells of extreme aspect ratio"
            }
            Self::Inaccurate { .. } | Self::Resultant { .. } => {
                "look for nearly detached parts, walls thousands of times longer than thick, cells of extreme aspect ratio, moduli many orders of magnitude apart, and a Poisson's ratio next to 0.5"
            }
            Self::ComplianceNotPositive => {
                "look for moduli many orders of magnitude apart, a shear modulus of nearly zero, and an origin of the mesh far from the section"
            }
            Self::NodesOnOneLine => "a section needs an area: give the wall a thickness",
            Self::UnknownElectrode { nearest, .. } => {
                return nearest
                    .as_ref()
                    .map(|name| format!("did you mean \"{name}\"?"));
            }
            Self::NotDriven { .. } => {
                "only driven electrodes have a prescribed voltage: check its circuit"
            }
            Self::Undetermined { .. } => "ground or drive one electrode of each dielectric",
            Self::FloatingUnder { .. } => {
                "ground or drive these electrodes, or remove the imposed strains and distributed loads"
            }
            Self::EndEffects { .. } => "request fewer \"end_effects\"",
            Self::OutOfMemory { .. } => "coarsen the mesh, or use a machine with more memory",
            Self::CellsWithoutMaterial { .. }
            | Self::DanglingCell { .. }
            | Self::NoScale { .. }
            | Self::UnknownState { .. } => return None,
        };
        Some(text.to_owned())
    }
}
