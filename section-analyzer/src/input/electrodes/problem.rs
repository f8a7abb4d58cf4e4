//! Problems of electrodes and of voltages of loads.

use shared_geom::error::{Explain, quoted};

use crate::input::problem::nearest_or_all;
use crate::mesh::{counted, short};

/// A problem of `[[electrode]]`, or of a reference to one.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ElectrodeProblem {
    /// Two electrodes of one name.
    #[error(
        "electrode \"{name}\" has the same name as the electrode on line {line}, expected \
         different names"
    )]
    NameTwice {
        /// The name.
        name: String,
        /// Line of the other one.
        line: usize,
    },
    /// An electrode without a location.
    #[error(
        "the electrode has no location, expected \"curve\", \"region\", \"point\" or \
         \"interdigitated\""
    )]
    NoLocation,
    /// An electrode that is of two kinds.
    #[error("the electrode has \"{first}\" and \"{second}\", expected one of them")]
    TwoLocations {
        /// A key.
        first: &'static str,
        /// Another key.
        second: &'static str,
    },
    /// A reversed region that the electrode does not have.
    #[error("reversed region \"{region}\" is not one of the regions {}", quoted(.regions))]
    ReversedElsewhere {
        /// The region.
        region: String,
        /// The regions of the electrode.
        regions: Vec<String>,
    },
    /// Electrodes without any electric material.
    #[error("the section has electrodes, but no region is of a material with an electric law")]
    NoElectricMaterial {
        /// Materials with an electric law that no region has.
        unused: Vec<String>,
    },
    /// A conductor that is not on a dielectric.
    #[error(
        "electrode \"{electrode}\" is on no dielectric: {} belongs to a cell with an electric \
         law{}",
        none_of(*.nodes), if *.is_fingered { " outside of interdigitated electrodes" } else { "" }
    )]
    OnNoDielectric {
        /// Name of the electrode.
        electrode: String,
        /// Number of its nodes.
        nodes: usize,
        /// Whether it is on cells between fingers.
        is_fingered: bool,
        /// The regions with an electric law.
        regions: Vec<String>,
    },
    /// Two conductors that touch.
    #[error(
        "electrodes \"{first}\" (line {line}) and \"{second}\" touch: both have node {node}, at \
         ({}, {}) m{}, expected separate conductors",
        short(.at[0]), short(.at[1]), more_nodes(*.count)
    )]
    Touching {
        /// Name of the electrode that comes first in the file.
        first: String,
        /// Its line.
        line: usize,
        /// Name of the other one.
        second: String,
        /// Tag of a node of both.
        node: u64,
        /// Its position (y, z) \[m\].
        at: [f64; 2],
        /// Number of such nodes.
        count: usize,
    },
    /// A dielectric without a reference for its voltages.
    #[error(
        "the dielectric of {} in {} (cell {cell} for example, at ({}, {}) m) has no ground: {}, \
         expected one with circuit = \"ground\"",
        counted(*.cells, "cell"), quoted(.regions), short(.at[0]), short(.at[1]),
        if .electrodes.is_empty() { "no electrode is on it".to_owned() }
        else { format!("on it are {}", .electrodes.join(", ")) }
    )]
    NoGround {
        /// Number of its cells.
        cells: usize,
        /// The regions of its cells.
        regions: Vec<String>,
        /// Tag of a cell.
        cell: u64,
        /// Its center (y, z) \[m\].
        at: [f64; 2],
        /// The electrodes on it, with their circuits.
        electrodes: Vec<String>,
    },
    /// Fingers in cells without electric law.
    #[error(
        "interdigitated electrode \"{electrode}\" is in region \"{region}\", whose material \
         \"{material}\" has no electric law"
    )]
    FingersNotElectric {
        /// Name of the electrode.
        electrode: String,
        /// The region.
        region: String,
        /// Its material.
        material: String,
    },
    /// Fingers whose field has no effect.
    #[error(
        "interdigitated electrode \"{electrode}\" has its field along axis {axis} of material \
         \"{material}\" in region \"{region}\", which couples {}",
        if .along.is_empty() { "nothing".to_owned() }
        else { format!("fields along {} only", .along.join(", ")) }
    )]
    FingersNotCoupled {
        /// Name of the electrode.
        electrode: String,
        /// The region.
        region: String,
        /// Its material.
        material: String,
        /// The axis, from one.
        axis: usize,
        /// Axes along which the field has an effect.
        along: Vec<String>,
    },
    /// Cells between the fingers of two electrodes.
    #[error(
        "region \"{region}\" is in the interdigitated electrodes \"{first}\" (line {line}) and \
         \"{second}\", expected one"
    )]
    FingersTwice {
        /// The region.
        region: String,
        /// Name of the electrode that comes first in the file.
        first: String,
        /// Its line.
        line: usize,
        /// Name of the other one.
        second: String,
    },
    /// A voltage of an unknown electrode.
    #[error("voltage for an unknown electrode \"{electrode}\" in load \"{load}\"")]
    UnknownElectrode {
        /// Name of the load.
        load: String,
        /// The name.
        electrode: String,
        /// The electrodes.
        known: Vec<String>,
    },
    /// A voltage of an electrode whose voltage is not prescribed.
    #[error(
        "load \"{load}\" has a voltage for electrode \"{electrode}\", whose circuit is \
         \"{circuit}\", expected a driven one"
    )]
    NotDriven {
        /// Name of the load.
        load: String,
        /// Name of the electrode.
        electrode: String,
        /// Its circuit.
        circuit: &'static str,
    },
    /// A request that is not known for sections with electrodes.
    #[error("\"{key}\" is not known for sections with electrodes")]
    NotWithElectrodes {
        /// The key.
        key: &'static str,
    },
}

fn none_of(nodes: usize) -> String {
    match nodes {
        0 => "it has no node that".to_owned(),
        1 => "its only node none".to_owned(),
        _ => format!("none of its {nodes} nodes"),
    }
}

fn more_nodes(count: usize) -> String {
    match count.saturating_sub(1) {
        0 => String::new(),
        more => format!(", and {more} more"),
    }
}

impl Explain for ElectrodeProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::UnknownElectrode {
                electrode, known, ..
            } => return Some(nearest_or_all(electrode, known, "electrodes of the file")),
            Self::OnNoDielectric { regions, .. } => {
                return Some(format!("regions with an electric law: {}", quoted(regions)));
            }
            Self::NoElectricMaterial { unused } if !unused.is_empty() => {
                let unused = quoted(unused);
                return Some(format!(
                    "materials with an electric law, of no region: {unused}"
                ));
            }
            Self::NoElectricMaterial { .. } => "add [material.NAME.electric] to the dielectric",
            Self::NoLocation | Self::TwoLocations { .. } => {
                "a conductor is on curves, fills regions or is at points of the mesh; fingers \
                 across the beam are \"interdigitated\" and in regions"
            }
            Self::ReversedElsewhere { .. } => "\"reversed\" names some of the \"regions\"",
            Self::Touching { .. } => {
                "shorten one of the curves so that dielectric is between them, or make both one \
                 electrode by a list of curves"
            }
            Self::NoGround { electrodes, .. } if electrodes.is_empty() => {
                "add a grounded electrode, put its regions between fingers, or use a material \
                 without [material.NAME.electric]"
            }
            Self::NoGround { .. } => {
                "voltages are differences: ground one of the electrodes on each piece of \
                 dielectric"
            }
            Self::FingersNotElectric { .. } => {
                "name the plies between the fingers only, NAME/1 and so on in a laminate"
            }
            Self::FingersNotCoupled { .. } => {
                "fibers are poled along the field: set \"poling\" in [material.NAME.electric], or \
                 \"axis\" of the electrode"
            }
            Self::NotDriven { .. } => {
                "a voltage belongs to circuit = \"driven\"; \"ground\" is at 0 V, and the voltage \
                 of a floating electrode follows"
            }
            Self::NotWithElectrodes { .. } => "remove it, or the electrodes",
            Self::NameTwice { .. } => {
                "upper and lower case are not distinguished: names are \
                 parts of file names"
            }
            Self::FingersTwice { .. } => return None,
        };
        Some(text.to_owned())
    }
}
