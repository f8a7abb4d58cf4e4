//! The dynamics input: the cards of `NAME.dynamics.toml`, checked, as a case for the
//! analysis.
//!
//! Every card has its own file, which reads the card and adds its content to the model. All
//! problems of a file are reported at once, each with file, line and remedy.

use std::collections::BTreeMap;
use std::path::Path;

use shared_geom::document::{Document, Table, read_text};
use shared_geom::error::{Diagnostics, Place};
use shared_geom::files::name_without;

use crate::assembly::{massless, mechanism};
use crate::case::{
    BucklingQuestion, Model, ModesQuestion, OutputQuestion, StaticQuestion, TransientQuestion,
};
use crate::elements::Element;
use crate::result::Measured;

mod along;
mod beam_card;
mod beam_check;
mod beam_section;
mod beams;
mod blade_file;
mod blades;
mod bodies;
mod clamps;
mod columns;
mod control;
mod csv_rows;
mod curved;
mod curved_fit;
mod damping;
mod draft;
mod drives;
mod electrodes;
mod elsewhere;
mod ends;
mod formulation;
mod frames;
mod heat;
mod hinge_card;
mod hub;
mod hub_support;
mod in_place;
mod internal_forces;
mod joints;
mod laws;
mod loads;
mod measured;
mod modal_damping;
mod mode_style;
mod moments;
mod naming;
mod nodes;
mod number;
mod problem;
mod properties;
mod questions;
mod readings;
mod rods;
pub mod schema;
mod speeds;
mod springs;
mod summary;
mod transient;

#[cfg(test)]
mod frame_tests;
#[cfg(test)]
mod joint_tests;
#[cfg(test)]
mod robust_tests;
#[cfg(test)]
mod test_files;
#[cfg(test)]
mod tests;

pub use blade_file::{BladeQuestion, is_blade_file, read_blade};
pub use blades::BladeProblem;
pub use columns::ColumnProblem;
pub use control::StateSpaceProblem;
pub use drives::DriveProblem;
pub use electrodes::ElectrodeProblem;
pub use frames::FrameProblem;
pub use heat::HeatProblem;
pub use joints::JointProblem;
pub use laws::LawProblem;
pub use loads::LoadProblem;
pub use number::short_number;
pub use problem::InputProblem;
pub use readings::ReadingProblem;

pub use summary::Summary;
pub use transient::TransientProblem;

use draft::Draft;
use questions::Questions;

/// Ending of the names of dynamics inputs.
pub const ENDING: &str = ".dynamics.toml";

/// A checked input.
#[derive(Debug)]
pub struct Input {
    /// The model.
    pub model: Model,
    /// The requested modes; `None` without `[modes]`.
    pub modes: Option<ModesQuestion>,
    /// The requested equilibria under loads; `None` without `[static]`.
    pub statics: Option<StaticQuestion>,
    /// The requested critical loads; `None` without `[buckling]`.
    pub buckling: Option<BucklingQuestion>,
    /// The output of a run in time.
    pub output: OutputQuestion,
    /// The requested motion in time; `None` without `[transient]`.
    pub transient: Option<TransientQuestion>,
    /// Measurements to compare with the result; empty if there are none.
    pub measured: Measured,
    /// Names of the joints without a spring, whose motion only inertia and loads resist.
    pub free_hinges: Vec<String>,
    /// Location of each node in the files.
    pub node_places: Vec<Place>,
    /// The contents of the model.
    pub summary: Summary,
    /// Location of each joint in the files.
    pub joint_places: BTreeMap<String, Place>,
    /// Remarks on the files for the user: defaults that were used, plausibility.
    pub remarks: Vec<String>,
}

/// Reads and checks the dynamics input at `path`, with the files that it names.
///
/// # Errors
/// All problems of the input and its files: unreadable files, unknown keys and names, wrong
/// values, impossible geometry; and if there are none of these, the ways in which the model
/// can move freely.
pub fn read(path: &Path) -> Result<Input, Diagnostics> {
    let file = path.display().to_string();
    checked(&read_text(path)?, &file, &name_of(path))
}

/// Reads and checks the text of a dynamics input, as if it were at `path`: the paths of its files
/// are relative to it.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: impl AsRef<Path>) -> Result<Input, Diagnostics> {
    let path = path.as_ref();
    checked(text, &path.display().to_string(), &name_of(path))
}

/// The input in the text of a file, whose results are called `name`.
fn checked(text: &str, file: &str, name: &str) -> Result<Input, Diagnostics> {
    let mut document = Document::parse_with_includes(text, file)?;
    declare(&document, &document.root_of(&schema::DYNAMICS_FILE));
    if !frames::repeat(&mut document) {
        return document.finish(None);
    }
    let input = cards(&document, name);
    let mut input = document.finish(input)?;
    let mut problems = Diagnostics::new();
    let mobility = mechanism::find(&input.model.system);
    // In time a part that is not held may move freely, but it must have mass.
    let only_in_time = input.transient.is_some()
        && input.modes.is_none()
        && input.statics.is_none()
        && input.buckling.is_none();
    let place = |node: &str| {
        let mut nodes = input.model.system.nodes().iter().zip(&input.node_places);
        let found = nodes.find(|(own, _)| own.label == node);
        found.map_or_else(|| Place::file(file), |(_, place)| place.clone())
    };
    for found in mobility.mechanisms.iter().filter(|_| !only_in_time) {
        problems.push(place(&found.node), found);
    }
    let massless = match input.transient {
        Some(_) => massless::find(&input.model.system),
        None => Vec::new(),
    };
    for found in &massless {
        problems.push(place(&found.node), found);
    }
    if !only_in_time {
        input.remarks.extend(free_hinges(&mobility.free_hinges));
    }
    if input.modes.is_some() || input.statics.is_some() || input.buckling.is_some() {
        input.remarks.extend(sampled(&input.model));
    }
    input.free_hinges = mobility.free_hinges;
    problems.into_result(input)
}

/// Remark on joints that can move without a spring.
fn free_hinges(names: &[String]) -> Option<String> {
    let [first, others @ ..] = names else {
        return None;
    };
    let others = match others.len() {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    Some(format!(
        "joint \"{first}\"{others} can move freely: at rest this is a motion of frequency zero"
    ))
}

/// Remark on systems that sample, in analyses without time.
fn sampled(model: &Model) -> Option<String> {
    let elements = model.system.elements();
    let mut names = elements
        .filter(|one| one.memory().is_some())
        .map(Element::label);
    let first = names.next()?;
    let others = match names.count() {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    Some(format!(
        "\"{first}\"{others}, which samples, acts only in runs in time: in statics, buckling and \
         modes its outputs are zero"
    ))
}

/// The file's name without folder and ending, from which outputs are named.
pub fn name_of(path: &Path) -> String {
    match is_blade_file(path) {
        true => blade_file::name_of(path),
        false => name_without(path, ENDING),
    }
}

/// Declares the units of numbers and the parameters.
fn declare(document: &Document, root: &Table<'_>) {
    document.declare_units(root);
    document.declare_parameters(root);
}

/// Reads every card, in an order in which each finds the names that it uses.
fn cards(document: &Document, default_name: &str) -> Option<Input> {
    let root = document.root_of(&schema::DYNAMICS_FILE);
    let name = root.text("name").unwrap_or_else(|| default_name.to_owned());
    let _read = ["units", "parameters", "include"].map(|key| root.has(key));
    let mut drives = drives::read_named(&root);
    let control = control::declare(&root, &mut drives);
    let properties = properties::read(&root, &drives);
    let hub = hub::read(&root);

    let mut draft = Draft::new(properties, hub);
    draft.set_drives(drives);
    draft.set_frames(frames::read(&root));
    hub_support::add(&root, &mut draft);
    nodes::read(&root, &mut draft);
    blades::read(&root, &mut draft);
    beams::read(&root, &mut draft);
    clamps::read(&root, &mut draft);
    bodies::read(&root, &mut draft);
    joints::read_hinges(&root, &mut draft);
    joints::read_rigid(&root, &mut draft);
    joints::read_joints(&root, &mut draft);
    rods::read(&root, &mut draft);
    springs::read(&root, &mut draft);
    loads::read(&root, &mut draft);
    internal_forces::read(&root, &mut draft);
    electrodes::read(&root, &mut draft);
    control::read(control, &mut draft);
    let gravity = loads::gravity(&root, &draft);
    let questions = questions::read(&root);
    let measured = measured::read(&root);
    let output = columns::read(&root, &draft);
    root.finish_beside(&elsewhere::OF_FILE);

    draft.check(&root);
    transient::check(&root, &draft);
    let times = questions.as_ref().and_then(Questions::times);
    if let Some(times) = times {
        check_run(document, &draft, times);
    }
    draft
        .drives()
        .check_start(document, times.map_or(0.0, |[start, _]| start));
    if let (Some(output), Some(questions)) = (&output, &questions) {
        columns::check(&root, output, questions.transient.as_ref());
    }
    let ((gravity, gravity_drive), questions) = (gravity?, questions?);
    questions.check(&root, &gravity, &draft.hub()?.spin());
    let nodes = draft.initial();
    let node_places = nodes.map(|(_, _, line)| document.place(line)).collect();
    let joints = draft.joint_lines();
    let joints = joints.map(|(name, line)| (name.to_owned(), document.place(line)));
    let joint_places = joints.collect();
    let mut input = finish(name, draft, questions, measured?)?;
    input.node_places = node_places;
    input.joint_places = joint_places;
    input.model.gravity = gravity;
    input.model.gravity_drive = gravity_drive;
    input.output = output?;
    Some(input)
}

/// Notes problems of loads and drives in a run from and to the given `times` \[s\].
fn check_run(document: &Document, draft: &Draft, times: [f64; 2]) {
    draft.drives().check_run(document, times);
    control::check_run(document, draft, times);
}

/// The input if the model is complete.
fn finish(name: String, draft: Draft, questions: Questions, measured: Measured) -> Option<Input> {
    let summary = draft.summary(questions.modes.as_ref(), &measured);
    let remarks = draft.remarks(questions.buckling.is_some());
    let spin = draft.hub()?.spin();
    let model = draft.model(name, spin)?;
    Some(Input {
        model,
        modes: questions.modes,
        statics: questions.statics,
        buckling: questions.buckling,
        output: OutputQuestion::default(),
        transient: questions.transient,
        measured,
        free_hinges: Vec::new(),
        node_places: Vec::new(),
        joint_places: BTreeMap::new(),
        summary,
        remarks,
    })
}
