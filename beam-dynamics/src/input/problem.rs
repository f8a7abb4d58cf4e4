//! Problems that only a dynamics input can have.

use shared_geom::document::DocumentProblem;
use shared_geom::error::{Explain, nearest_name};
use shared_geom::section::{CurvatureMismatch, PropertyProblem};

use super::number::short_number;

/// A problem of a dynamics input or of the table of measurements that it names.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InputProblem {
    /// An unknown name.
    #[error("unknown {kind} \"{name}\" in {user}")]
    UnknownName {
        /// `node` or `properties`.
        kind: &'static str,
        /// The name.
        name: String,
        /// The user of the name, as text.
        user: String,
        /// The names of this kind.
        known: Vec<String>,
    },
    /// A name that two things of a kind have.
    #[error("{kind} \"{name}\" is already defined on {line}, expected one of this name")]
    DoubledName {
        /// `node`, `beam` or the like.
        kind: &'static str,
        /// The name.
        name: String,
        /// Line of the first, as text.
        line: String,
    },
    /// No beam and no body at all.
    #[error("the model is empty, expected [[blade]], or [[node]] with [[beam]] or [[body]]")]
    EmptyModel,
    /// Bodies that nothing holds, without a motion in time.
    #[error("nothing holds the bodies, expected [transient], or [[beam]], [[joint]] or [[spring]]")]
    FreeBodies,
    /// No mass, or mass only on clamped nodes.
    #[error("the model has no mass that can move, expected a mass per length or a body")]
    NoMass,
    /// A node to which nothing is attached.
    #[error("nothing is attached to node \"{node}\", expected a beam, a body or a joint")]
    UnusedNode {
        /// Name of the node.
        node: String,
    },
    /// A file of properties that cannot be opened.
    #[error("properties \"{name}\": no property file at \"{file}\"")]
    NoPropertyFile {
        /// Name of the properties.
        name: String,
        /// Location where the file was searched.
        file: String,
        /// Files of this kind in the same folder.
        known: Vec<String>,
    },
    /// Properties given in two ways.
    #[error("{table} has \"file\" and \"{key}\", expected a file or numbers in the card")]
    FileAndNumbers {
        /// The table, as text.
        table: String,
        /// The first key of properties in the card.
        key: &'static str,
    },
    /// Properties that are invalid for a beam.
    #[error("properties \"{name}\": {problem}")]
    Unsound {
        /// Name of the properties.
        name: String,
        /// The problem.
        problem: PropertyProblem,
    },
    /// Properties that were solved for a beam of another curvature.
    #[error("{user}, properties \"{name}\": {mismatch}; {}", .mismatch.size())]
    OtherCurvature {
        /// The user and the position, as text.
        user: String,
        /// Name of the properties.
        name: String,
        /// Both curvatures.
        mismatch: Box<CurvatureMismatch>,
    },
    /// Prestress is requested, but the file has no table.
    #[error(
        "properties \"{name}\" request the effect of prestress, but \"{file}\" has no table of it"
    )]
    NoPrestress {
        /// Name of the properties.
        name: String,
        /// The property file.
        file: String,
    },
    /// Prestress is requested, but there is no file.
    #[error("properties \"{name}\" request the effect of prestress, but have no \"file\"")]
    InlinePrestress {
        /// Name of the properties.
        name: String,
    },
    /// Internal damping that is not given, or given twice.
    #[error("\"damping\" needs one of {0}")]
    OneDamping(&'static str),
    /// A list of a wrong length.
    #[error("\"{key}\" lists {found}, expected {expected}")]
    Count {
        /// The key.
        key: &'static str,
        /// Number of items found.
        found: usize,
        /// Expected number, as text.
        expected: &'static str,
    },
    /// An angle of a quarter turn or more.
    #[error("\"{key}\" is {} deg, expected less than 90 deg to either side", six(*.found))]
    SteepAngle {
        /// The key.
        key: &'static str,
        /// The angle found \[deg\].
        found: f64,
    },
    /// A relaxed angle of a hinge near a full turn or more.
    #[error("\"angle\" is {} deg, expected at most 330 deg to either side", six(*.found))]
    FullTurn {
        /// The angle found \[deg\].
        found: f64,
    },
    /// An axis without direction.
    #[error("\"axis\" has no direction: its length is zero")]
    NoAxis,
    /// A blade at a hub whose axis points along x.
    #[error("the axis of the hub points along x, so that azimuth zero is undefined")]
    AxisAlongSpan,
    /// A blade without pieces.
    #[error("blade \"{blade}\" has no [[blade.piece]], expected at least one")]
    NoPieces {
        /// Name of the blade.
        blade: String,
    },
    /// A piece of a blade without properties.
    #[error("{piece} has no \"properties\", and the blade has none for all its pieces")]
    NoProperties {
        /// The piece, as text.
        piece: String,
    },
    /// A beam with the same node twice.
    #[error("{beam} has node \"{node}\" twice, expected three nodes")]
    NodeTwice {
        /// The beam, as text.
        beam: String,
        /// Name of the node.
        node: String,
    },
    /// Two nodes of a beam at the same position.
    #[error("{beam}: \"{first}\" and \"{second}\" are at the same position, expected a distance")]
    Coincident {
        /// The beam, as text.
        beam: String,
        /// Name of a node.
        first: String,
        /// Name of the other node.
        second: String,
    },
    /// A middle node beyond an end.
    #[error("{beam}: \"{middle}\" is not between \"{first}\" and \"{last}\"")]
    OutOfOrder {
        /// The beam, as text.
        beam: String,
        /// Names of the nodes as listed.
        first: String,
        /// The second.
        middle: String,
        /// The third.
        last: String,
    },
    /// A middle node too far from the middle.
    #[error(
        "{beam}: \"{middle}\" is at {:.1} % of the way from \"{first}\" to \"{last}\", \
         expected 45 % to 55 %",
        100.0 * .part
    )]
    OffMiddle {
        /// The beam, as text.
        beam: String,
        /// Names of the nodes as listed.
        first: String,
        /// The second.
        middle: String,
        /// The third.
        last: String,
        /// Position of the middle node, as part of the way \[-\].
        part: f64,
    },
    /// Section axes across the beam.
    #[error(
        "{beam}: the section axis x at \"{node}\" is {degrees:.1} deg off the line of the beam, \
         expected at most {limit} deg"
    )]
    AcrossLine {
        /// The beam, as text.
        beam: String,
        /// Name of the node.
        node: String,
        /// Angle between the axis and the line \[deg\].
        degrees: f64,
        /// The largest angle accepted \[deg\].
        limit: f64,
    },
    /// Section axes that turn too much within a beam.
    #[error(
        "{beam}: the section turns by {degrees:.1} deg between \"{node}\" and the middle, \
         expected less than {limit} deg"
    )]
    Wrung {
        /// The beam, as text.
        beam: String,
        /// Name of the node.
        node: String,
        /// Angle of the rotation \[deg\].
        degrees: f64,
        /// The largest angle accepted \[deg\].
        limit: f64,
    },
    /// Consistent inertia of finite volumes.
    #[error(
        "\"consistent\" inertia belongs to the variational beam, expected \"lumped\" with \
         formulation = \"finite-volume\""
    )]
    PortionsOnly,
    /// An interpolation key for the variational beam.
    #[error(
        "\"interpolation\" is a key of formulation = \"finite-volume\"; the variational beam \
         interpolates by rotation vectors"
    )]
    OwnInterpolation,
    /// A body with impossible moments of inertia.
    #[error(
        "body \"{body}\" has the inertia {found:?} kg m^2, expected each at most the sum of the others"
    )]
    ImpossibleInertia {
        /// Name of the body.
        body: String,
        /// The three moments \[kg m^2\].
        found: [f64; 3],
    },
    /// A joint of a node with itself.
    #[error("{joint} joins \"{node}\" to itself, expected two nodes")]
    JoinedToItself {
        /// The joint, as text.
        joint: String,
        /// Name of the node.
        node: String,
    },
    /// A relaxed angle without a spring.
    #[error("\"angle\" is the angle of the relaxed spring, but the hinge has none")]
    NoSpring,
    /// Properties of a moving hub for a hub that cannot move.
    #[error("\"{key}\" is a key of a hub that moves, but this one has no \"support\"")]
    HeldHub {
        /// The key.
        key: &'static str,
    },
    /// A damper in a direction in which the hub is held.
    #[error("\"{direction}\" has a damping but no stiffness: the hub is fixed in this direction")]
    DampedClamp {
        /// The direction.
        direction: &'static str,
    },
    /// A spring in the ground frame off the axis.
    #[error(
        "spring \"{spring}\" has fixed_to = \"world\", but node \"{node}\" is not on the axis of the hub"
    )]
    OffAxis {
        /// Name of the spring.
        spring: String,
        /// Name of the node.
        node: String,
    },
    /// A spring in the ground frame that is not isotropic about the axis.
    #[error(
        "spring \"{spring}\" has fixed_to = \"world\", but is not isotropic about the axis of the hub"
    )]
    Anisotropic {
        /// Name of the spring.
        spring: String,
    },
    /// An impossible damping ratio of an oscillation.
    #[error("\"{name}\" is {}, expected a damping ratio from 0 to below 1", six(*.found))]
    NoRatio {
        /// The key, or the name of the mode.
        name: String,
        /// The number found [-].
        found: f64,
    },
    /// A name that is not a possible name of a mode.
    #[error("\"{name}\" is not a name of a mode, expected a name like \"flap 1\"")]
    NoModeName {
        /// The name found.
        name: String,
    },
    /// No rotor speed.
    #[error("\"speeds\" is empty, expected at least one rotor speed")]
    NoSpeeds,
    /// A rotor speed below zero.
    #[error("\"{key}\" has the speed {} rpm, expected zero or more", six(*.rpm))]
    NegativeSpeed {
        /// The key.
        key: &'static str,
        /// The speed \[rpm\].
        rpm: f64,
    },
    /// A duplicate rotor speed.
    #[error("\"speeds\" has the speed {} rpm twice, expected each once", six(*.rpm))]
    SpeedTwice {
        /// The speed \[rpm\].
        rpm: f64,
    },
    /// A rotor speed of a model with free parts.
    #[error("\"free\" is true at the rotor speed {} rpm, expected the speed 0 only", six(*.rpm))]
    FreeRotation {
        /// The speed \[rpm\].
        rpm: f64,
    },
    /// A speed for shapes that is not analyzed.
    #[error("\"{key}\" has the speed {} rpm, expected some of \"speeds\"", six(*.rpm))]
    ShapeSpeed {
        /// The key.
        key: &'static str,
        /// The speed \[rpm\].
        rpm: f64,
        /// The nearest one that is analyzed \[rpm\].
        nearest: f64,
    },
    /// A number that is no multiple of the rotor speed.
    #[error("\"harmonics\" has {}, expected whole numbers from 1 to 1000", six(*.found))]
    NoMultiple {
        /// The number found [-].
        found: f64,
    },
    /// A range that is one speed.
    #[error("\"speeds\" runs from {rpm} rpm to {rpm} rpm, expected two speeds", rpm = six(*.rpm))]
    EmptyRange {
        /// The speed \[rpm\].
        rpm: f64,
    },
    /// A table of measurements that cannot be read.
    #[error("no table of measurements at \"{file}\": {reason}")]
    NoMeasurements {
        /// Location where the file was searched.
        file: String,
        /// The reason, as text.
        reason: String,
    },
    /// A table of measurements without the expected heading.
    #[error("the columns are {found}, expected \"speed_rpm,frequency_hz,order\"")]
    Heading {
        /// The heading found, in quotes, or `missing`.
        found: String,
    },
    /// A row of measurements that cannot be read.
    #[error("row \"{found}\" cannot be read, expected {expected}")]
    Row {
        /// The row as written.
        found: String,
        /// The expected content, as text.
        expected: &'static str,
    },
    /// Two measurements of one mode at one speed.
    #[error("order {order} at this speed is already measured on line {line}, expected one row")]
    RowTwice {
        /// The order.
        order: usize,
        /// Line of the first.
        line: usize,
    },
    /// Further rows with problems.
    #[error("{count} more rows have problems")]
    MoreRows {
        /// Number of rows.
        count: usize,
    },
    /// A table of measurements without a row.
    #[error("the table has no row, expected at least one measured frequency")]
    NoRows,
    /// A problem that every input file can have.
    #[error(transparent)]
    Document(#[from] DocumentProblem),
}

/// Names that people give the frame of the model.
const FRAME: [&str; 5] = ["ground", "world", "frame", "fixed", "inertial"];

impl Explain for InputProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::UnknownName {
                kind, name, known, ..
            } => return Some(nearest(kind, name, known)),
            Self::NoPropertyFile { file, known, .. } => return Some(nearest_file(file, known)),
            Self::Unsound { problem, .. } => return problem.help(),
            Self::OtherCurvature { mismatch, .. } => return mismatch.help(),
            Self::Document(problem) => return problem.help(),
            Self::NoPrestress { .. } => {
                "put prestress = \"biot\" into the section file and analyze it again, or remove \
                 \"prestress\" to ignore prestress"
            }
            Self::InlinePrestress { .. } => "only property files have tables of prestress",
            Self::ShapeSpeed { nearest, .. } => {
                return Some(format!("the nearest is {} rpm", six(*nearest)));
            }
            Self::NoModeName { .. } => {
                "modes are called by flap, lag (edge), torsion, axial, lateral or coupled, and a number, as in the table of modes"
            }
            Self::FreeRotation { .. } => {
                "write speeds = 0, or hold the model and remove \"free\": parts that nothing holds do not follow the rotation"
            }
            Self::NoMultiple { .. } => "a multiple n is the line nP, n per revolution",
            Self::NoRatio { .. } => "the ratio is relative to critical damping: 1 % is 0.01",
            Self::UnusedNode { .. } => {
                "name it in a [[beam]], a [[body]] or a [[joint]], or remove it"
            }
            Self::AxisAlongSpan => {
                "azimuth 0 is the projection of x across the axis: turn the model, for example axis = [0, 0, 1]"
            }
            Self::OutOfOrder { .. } => {
                "list the nodes from one end to the other, the middle one second"
            }
            Self::OffMiddle { .. } => {
                "move the middle node, or its offset, to the middle of the beam"
            }
            Self::AcrossLine { .. } => {
                "give the nodes an \"orientation\", or the beam \"section_axes\", with x along the beam, from the first node to the last"
            }
            Self::NoSpring => "give the hinge a \"stiffness\", or turn its second node",
            Self::HeldHub { .. } => {
                "add support = { in_plane = ... }: directions that it does not name are fixed"
            }
            Self::DampedClamp { .. } => "name the direction in \"support\", 0 for no spring",
            Self::OffAxis { .. } | Self::Anisotropic { .. } => {
                "in rotating axes this support is not constant: fixed_to = \"frame\" turns with the model"
            }
            Self::Wrung { .. } => "divide the beam into shorter ones",
            Self::NoProperties { .. } => "name the properties in [[blade]] or in the piece",
            Self::ImpossibleInertia { .. } => {
                "the moments are about the center, in the axes of the node; with J about the shaft alone write [J / 2, J / 2, J], a disk"
            }
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}

/// A number in a message.
fn six(value: f64) -> String {
    short_number(value, 6)
}

fn nearest(kind: &str, found: &str, known: &[String]) -> String {
    if kind == "node" && FRAME.contains(&found.to_lowercase().as_str()) {
        return "the frame of the model is no node: a joint, rod or spring with one node connects it \
                to the frame, and a node with a [[clamp]] is held in it"
            .to_owned();
    }
    if kind == "drive" && found.contains(['(', '*', '/', '+', '^']) {
        return format!("an expression begins with =, as in \"= {found}\"");
    }
    match nearest_name(found, known.iter().map(String::as_str)) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None if known.is_empty() => format!("the file has no {kind}"),
        None if kind == "signal" => format!(
            "a quantity of the model becomes a signal by [sensors.NAME]; signals are {}",
            shortened(known)
        ),
        None => format!("{kind}: {}", shortened(known)),
    }
}

fn nearest_file(found: &str, known: &[String]) -> String {
    let name = found.rsplit(['/', '\\']).next().unwrap_or(found);
    match nearest_name(name, known.iter().map(String::as_str)) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None if known.is_empty() => "section-analyzer writes property files".to_owned(),
        None => format!("property files there: {}", shortened(known)),
    }
}

/// Names in quotes, the first ones if there are many.
fn shortened(names: &[String]) -> String {
    const SHOWN: usize = 12;
    let quoted: Vec<_> = names
        .iter()
        .take(SHOWN)
        .map(|name| format!("\"{name}\""))
        .collect();
    match names.len() {
        0 => "none".to_owned(),
        all if all > SHOWN => format!("{} and {} more", quoted.join(", "), all - SHOWN),
        _ => quoted.join(", "),
    }
}
