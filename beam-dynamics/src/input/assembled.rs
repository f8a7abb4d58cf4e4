//! Checks of the assembled model: motions that nothing holds, nodes without mass, controls without
//! effect, and constraints that the scheme of the run cannot enforce.

use shared_geom::document::Table;
use shared_geom::error::{Diagnostics, SourceLocation};

use super::motion_remarks::{free_hinges, free_parts, sampled};
use super::{Input, periodic, repeats, transient, trim};
use crate::assembly::{massless, mechanism};
use crate::case::TrimMethod;

/// Places of the file to which problems of the assembled model refer.
pub(super) struct Locations {
    file: SourceLocation,
    /// Names and cards of the controls of a trim.
    controls: Vec<(String, SourceLocation)>,
    scheme: Option<SourceLocation>,
    periodic: Option<SourceLocation>,
}

impl Locations {
    /// The places in the file `root`, which is called `file`.
    pub fn new(root: &Table<'_>, file: &str) -> Self {
        Self {
            file: SourceLocation::file(file),
            controls: trim::locations(root),
            scheme: transient::scheme_location(root),
            periodic: periodic::location(root),
        }
    }

    fn node(&self, input: &Input, name: &str) -> SourceLocation {
        let mut nodes = input.model.system.nodes().iter().zip(&input.node_locations);
        let found = nodes.find(|(node, _)| node.label == name);
        found.map_or_else(|| self.file.clone(), |(_, location)| location.clone())
    }
}

/// The input with its free hinges and remarks, if the assembled model suits its analyses.
///
/// # Errors
/// All problems.
pub(super) fn checked(mut input: Input, locations: &Locations) -> Result<Input, Diagnostics> {
    let mut problems = trim::problems(&input.model, &locations.controls);
    let unenforced = transient::unenforced(input.transient.as_ref(), &input.model.system);
    if let Some((location, found)) = locations.scheme.as_ref().zip(unenforced) {
        problems.push(location.clone(), &found);
    }
    // Rotors that do not repeat are the reason of a model that does not.
    let periodic = input
        .periodic
        .as_ref()
        .filter(|_| input.unrepeated.is_empty());
    let unrepeated = periodic.and_then(|own| repeats::problem(&input.model, own));
    if let Some((location, found)) = locations.periodic.as_ref().zip(unrepeated) {
        input.unrepeated.push(location.clone(), &found);
    }
    let mobility = mechanism::find(&input.model.system);
    let is_trimmed = (input.trim.as_ref()).is_some_and(|own| own.method == TrimMethod::Equilibrium);
    let is_held = input.statics.is_some() || input.buckling.is_some() || is_trimmed;
    let is_in_time = input.transient.is_some() || input.periodic.is_some();
    let only_in_time = is_in_time && input.modes.is_none() && !is_held;
    let is_free = input.modes.as_ref().is_some_and(|modes| modes.free);
    // A part that is not held may move freely in time and in free modes, but it must have mass.
    let may_move = only_in_time || is_free && !is_held;
    for found in mobility.mechanisms.iter().filter(|_| !may_move) {
        problems.push(locations.node(&input, &found.node), found);
    }
    if is_in_time || is_free {
        for found in massless::find(&input.model.system) {
            problems.push(locations.node(&input, &found.node), &found);
        }
    }
    if !only_in_time {
        input.remarks.extend(free_hinges(&mobility.free_hinges));
    }
    if is_free {
        input.remarks.extend(free_parts(&mobility.mechanisms));
    }
    if input.modes.is_some() || is_held {
        input.remarks.extend(sampled(&input.model));
    }
    input.free_hinges = mobility.free_hinges;
    problems.into_result(input)
}
