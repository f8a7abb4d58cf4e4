//! Problems of aerodynamic blades from files.

use shared_geom::error::{Explain, nearest_name};

use crate::input::short_number;

/// A problem of `file` in `[blade.aerodynamics]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum FileProblem {
    #[error("[blade.aerodynamics] has \"file\" and \"stations\", expected one of them")]
    FileAndStations,
    #[error("\"{key}\" without \"file\", to whose stations it belongs")]
    WithoutFile { key: &'static str },
    #[error("\"{file}\" has no twist, expected \"twist_file\"")]
    NoTwist { file: String },
    #[error("\"{file}\" has stations by their radius, expected \"root_radius\"")]
    NoRoot { file: String },
    #[error(
        "station {} of \"{file}\" is at {} m from the root, expected a position on the line, \
         from 0 to {} m",
        .index + 1,
        short_number(*.found, 6),
        short_number(*.length, 6)
    )]
    OffLine {
        file: String,
        /// Index of the station, from zero.
        index: usize,
        /// Its distance from the root \[m\].
        found: f64,
        /// Largest distance on the line \[m\].
        length: f64,
        is_by_radius: bool,
    },
    #[error(
        "station {} of \"{file}\" has the airfoil number {found}, expected 1 to {count}, the \
         number of airfoils",
        .index + 1
    )]
    Index {
        file: String,
        /// Index of the station, from zero.
        index: usize,
        /// Number of the airfoil, from one.
        found: usize,
        /// Number of airfoils.
        count: usize,
    },
    #[error("station {} of \"{file}\" states no airfoil, and {count} airfoils are given", .index + 1)]
    NoName {
        file: String,
        /// Index of the station, from zero.
        index: usize,
        /// Number of airfoils.
        count: usize,
    },
    #[error(
        "unknown airfoil{} {} in \"{file}\"",
        if names.len() > 1 { "s" } else { "" },
        quoted(names)
    )]
    Unknown {
        file: String,
        /// Names without an airfoil.
        names: Vec<String>,
        /// Names of all airfoils.
        known: Vec<String>,
    },
    #[error("no airfoils for \"{file}\", expected \"airfoils\" or \"airfoil_file\"")]
    NoAirfoils { file: String },
    #[error(
        "station {} of \"{file}\" has profiles of set {set}, which no airfoil belongs to",
        .index + 1
    )]
    NoSet {
        file: String,
        /// Index of the station, from zero.
        index: usize,
        /// Number of the set, from one.
        set: usize,
    },
    #[error("station {} of \"{file}\": {reason}", .index + 1)]
    Thickness {
        file: String,
        /// Index of the station, from zero.
        index: usize,
        /// The reason, as text.
        reason: String,
        help: Option<String>,
    },
    #[error(
        "station {} of \"{file}\" has a thickness of {} % of the chord, less than any airfoil",
        .index + 1,
        short_number(*.percent, 6)
    )]
    Fraction {
        file: String,
        /// Index of the station, from zero.
        index: usize,
        /// Its thickness over its chord \[%\].
        percent: f64,
    },
    #[error("no file is named \"{pattern}\"")]
    NoMatch { pattern: String },
}

fn quoted(names: &[String]) -> String {
    let names: Vec<_> = names.iter().map(|name| format!("\"{name}\"")).collect();
    names.join(", ")
}

/// The remedy of unknown names: a name that is near to one of them, or the places of airfoils.
fn remedy(names: &[String], known: &[String]) -> String {
    let near = |name: &String| nearest_name(name, known.iter().map(String::as_str));
    if let Some(near) = names.iter().find_map(near) {
        return format!("did you mean \"{near}\"?");
    }
    let places = "the file has no polars of them: add airfoils = [\"polars/*.dat\"], airfoil_file = \
                  \"pc.dat\", or tables [airfoils.NAME] of these names";
    match known {
        [] => places.to_owned(),
        _ => format!("{places}; known: {}", known.join(", ")),
    }
}

impl Explain for FileProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::FileAndStations => "remove one of them",
            Self::WithoutFile { .. } => "add \"file\", or remove this key",
            Self::NoTwist { .. } => {
                "add twist_file = \"NAME.htc\", a blade file with the twist of the chord"
            }
            Self::NoRoot { .. } => "add root_radius = 1.5, the radius at which the blade begins",
            Self::OffLine {
                is_by_radius: true, ..
            } => "correct \"root_radius\", or the length of the blade",
            Self::OffLine { .. } => "the file must belong to this blade: compare the lengths",
            Self::Index { .. } => {
                "list all airfoils in their order, as AFNames in the main file of AeroDyn"
            }
            Self::NoName { .. } => "give one airfoil for all stations, or one for each",
            Self::NoAirfoils { .. } => {
                "add airfoils = [\"polars/*.dat\"], a list of names of [airfoils], of files and of folders, or \
                 airfoil_file = \"pc.dat\", a file with all of them; airfoil = \"NAME\" of [rotor] is for all \
                 stations"
            }
            Self::Unknown { names, known, .. } => return Some(remedy(names, known)),
            Self::NoSet { .. } => "add the pc file of HAWC2 as \"airfoil_file\"",
            Self::Thickness { help, .. } => return help.clone(),
            Self::Fraction { percent, .. } => {
                return Some(format!(
                    "the ae file of HAWC2 has thicknesses in percent of the chord: {} there if it is a fraction",
                    short_number(100.0 * percent, 6)
                ));
            }
            Self::NoMatch { .. } => "correct the pattern: * is any number of letters of a name",
        };
        Some(text.to_owned())
    }
}
