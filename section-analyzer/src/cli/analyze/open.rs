//! `--open`: driven electrodes that have no charge in a run.

use shared_geom::error::{Diagnostics, Explain, SourceLocation, nearest_name};
use thiserror::Error;

use crate::input::Input;
use crate::section::Circuit;

/// Keyword for all driven electrodes.
const ALL: &str = "all";

/// A wrong name after `--open`.
#[derive(Debug, Error)]
enum OpenProblem {
    #[error("--open {name}: the section has no such electrode")]
    Unknown { name: String, known: Vec<String> },
    #[error("--open {name}: the section has no driven electrode")]
    None { name: String },
    #[error("--open {name}: this electrode is at ground, expected one that is driven")]
    Ground { name: String },
    #[error("--open {name}: load \"{load}\" has a voltage for this electrode")]
    Driven { name: String, load: String },
}

impl Explain for OpenProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Unknown { name, known } => {
                let nearest = nearest_name(name, known.iter().map(String::as_str));
                Some(match nearest {
                    Some(nearest) => format!("did you mean \"{nearest}\"?"),
                    None if known.is_empty() => "the section has no driven electrodes".to_owned(),
                    None => format!("electrodes that can be open: {}", known.join(", ")),
                })
            }
            Self::None { .. } => Some("remove --open".to_owned()),
            Self::Ground { .. } => {
                Some("ground or drive one electrode of each dielectric".to_owned())
            }
            Self::Driven { .. } => Some(
                "an open electrode has the voltage of zero charge: remove --open or the voltage"
                    .to_owned(),
            ),
        }
    }
}

/// Changes the driven electrodes called `names` to floating electrodes.
///
/// # Errors
/// All problems of the names, as text.
pub(super) fn open(input: &mut Input, names: &[String]) -> Result<(), String> {
    let mut problems = Diagnostics::new();
    let location = SourceLocation::file(input.summary.file.clone());
    for name in names {
        if let Err(problem) = open_one(input, name) {
            problems.push(location.clone(), &problem);
        }
    }
    if problems.is_empty() {
        Ok(())
    } else {
        Err(problems.to_string())
    }
}

fn open_one(input: &mut Input, name: &str) -> Result<(), OpenProblem> {
    let written = || name.to_owned();
    let electrodes = &mut input.section.electrodes;
    let known: Vec<_> = electrodes.iter().map(|known| known.name.clone()).collect();
    let is_all = name == ALL && !known.iter().any(|known| known == ALL);
    let requested = |known: &str| is_all || known == name;
    let mut opened = Vec::new();
    for electrode in electrodes.iter_mut().filter(|known| requested(&known.name)) {
        match electrode.circuit {
            Circuit::Ground if !is_all => return Err(OpenProblem::Ground { name: written() }),
            Circuit::Ground => {}
            Circuit::Driven | Circuit::Floating => {
                electrode.circuit = Circuit::Floating;
                opened.push(electrode.name.clone());
            }
        }
    }
    if opened.is_empty() {
        let name = written();
        let of_use = electrodes
            .iter()
            .filter(|known| known.circuit != Circuit::Ground);
        let known: Vec<_> = of_use.map(|known| known.name.clone()).collect();
        return Err(if is_all && !electrodes.is_empty() {
            OpenProblem::None { name }
        } else {
            OpenProblem::Unknown { name, known }
        });
    }
    for load in &input.loads {
        if let Some((name, _)) = load.voltages.iter().find(|(name, _)| opened.contains(name)) {
            return Err(OpenProblem::Driven {
                name: name.clone(),
                load: load.name.clone(),
            });
        }
    }
    Ok(())
}
