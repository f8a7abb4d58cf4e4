//! The dynamics input: the cards of `NAME.dynamics.toml`, checked, as a case for the
//! analysis.
//!
//! Every card has its own file, which reads the card and adds its content to the model. All
//! problems of a file are reported at once, each with file, line and remedy.

use std::collections::BTreeMap;
use std::path::Path;

use nalgebra::Vector3;
use shared_geom::document::{Document, Table, read_text};
use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::file_kind::FileKind;
use shared_geom::files::name_without;

use crate::case::{
    BucklingSettings, LinearSettings, Model, ModesSettings, OutputSettings, PeriodicSettings,
    StabilitySettings, StaticSettings, TransientSettings, TrimSettings,
};
use crate::result::Measured;

mod aerodynamics;
mod analyses;
mod assembled;
mod beam_card;
mod beam_check;
mod beam_properties;
mod beam_section;
mod beams;
mod blade_file;
mod blades;
mod bodies;
mod builder;
mod clamps;
mod columns;
mod control;
mod csv_rows;
mod curved;
mod curved_fit;
mod damping;
mod drive_times;
mod driven_joint;
mod drives;
mod electrodes;
mod ends;
mod equal_arms;
mod formulation;
mod frames;
mod heat;
mod held;
mod hinge_card;
mod hub;
mod hub_support;
mod inline_properties;
mod internal_forces;
mod joints;
mod laws;
mod linear;
mod loads;
mod measured;
mod misplaced_keys;
mod modal_damping;
mod mode_style;
mod moments;
mod motion_remarks;
mod naming;
mod nodes;
mod number;
mod performance;
mod periodic;
mod problem;
mod properties;
mod readings;
mod repeats;
mod rods;
mod rotating_start;
mod rotor_speed;
mod rotors;
pub mod schema;
mod speeds;
mod springs;
mod stability;
mod strips;
mod summary;
mod sweep;
mod too_stiff;
mod transient;
mod trim;

#[cfg(test)]
mod frame_tests;
#[cfg(test)]
mod joint_tests;
#[cfg(test)]
mod test_files;
#[cfg(test)]
mod tests;

pub use aerodynamics::{AirProblem, FamilyProblem, StripProblem};
pub use blade_file::{BladeSettings, is_blade_file, read_blade};
pub use blades::BladeProblem;
pub use columns::ColumnProblem;
pub use control::StateSpaceProblem;
pub use drives::DriveProblem;
pub use electrodes::ElectrodeProblem;
pub use frames::FrameProblem;
pub use heat::HeatProblem;
pub use joints::JointProblem;
pub use laws::LawProblem;
pub use linear::{LinearChoice, LinearProblem, LinearRequest};
pub use loads::LoadProblem;
pub use number::short_number;
pub use performance::{
    PerformanceProblem, ROTOR_ENDING, parse_rotor, read_rotor, rotor_json_schema, rotor_reference,
};
pub use periodic::PeriodicProblem;
pub use problem::InputProblem;
pub use readings::ReadingProblem;
pub use repeats::NotRepeated;
pub use rotors::{RotorProblem, RotorRunProblem};
pub use stability::StabilityProblem;
pub use strips::InflowProblem;
pub use summary::Summary;
pub use sweep::SweepProblem;
pub use transient::TransientProblem;
pub use trim::TrimProblem;

use analyses::Analyses;
use builder::ModelBuilder;
use rotors::Rotors;

/// Ending of the names of dynamics inputs.
pub const ENDING: &str = ".dynamics.toml";

/// A checked input.
#[derive(Debug)]
pub struct Input {
    /// The model.
    pub model: Model,
    /// The requested modes; `None` without `[modes]`.
    pub modes: Option<ModesSettings>,
    /// The requested equilibria under loads; `None` without `[static]`.
    pub statics: Option<StaticSettings>,
    /// The requested critical loads; `None` without `[buckling]`.
    pub buckling: Option<BucklingSettings>,
    /// The output of a run in time.
    pub output: OutputSettings,
    /// The requested motion in time; `None` without `[transient]`.
    pub transient: Option<TransientSettings>,
    /// The requested periodic motion; `None` without `[periodic]`.
    pub periodic: Option<PeriodicSettings>,
    /// The requested trim; `None` without `[trim]`.
    pub trim: Option<TrimSettings>,
    /// The requested stability over a parameter; `None` without `[stability]`.
    pub stability: Option<StabilitySettings>,
    /// The requested linear model, if one was requested.
    pub linear: Option<LinearSettings>,
    /// Measurements to compare with the result; empty if there are none.
    pub measured: Measured,
    /// Names of the joints without a spring, whose motion only inertia and loads resist.
    pub free_hinges: Vec<String>,
    /// Location of each node in the files.
    pub node_locations: Vec<SourceLocation>,
    /// The `[parameters]` with their values \[unit of each\].
    pub parameters: Vec<(String, f64)>,
    /// The contents of the model.
    pub summary: Summary,
    /// Location of each joint in the files.
    pub joint_locations: BTreeMap<String, SourceLocation>,
    /// Problems of the model with `[periodic]`, which concern the analyses of it only.
    pub unrepeated: Diagnostics,
    /// Remarks on the files for the user: defaults that were used, plausibility.
    pub remarks: Vec<String>,
}

impl Input {
    /// The input for an analysis of `[periodic]`.
    ///
    /// # Errors
    /// A model that is another one a period later.
    pub fn repeating(self) -> Result<Self, Diagnostics> {
        self.unrepeated.clone().into_result(self)
    }
}

/// Reads and checks the dynamics input at `path`, with the files that it names.
///
/// # Errors
/// All problems of the input and its files: unreadable files, unknown keys and names, wrong
/// values, impossible geometry; and if there are none of these, the ways in which the model
/// can move freely.
pub fn read(path: &Path) -> Result<Input, Diagnostics> {
    read_with(path, &[])
}

/// Reads it with other values of the parameters that are `given`, each in the declared unit.
///
/// # Errors
/// As [`read`].
pub fn read_with(path: &Path, given: &[(String, f64)]) -> Result<Input, Diagnostics> {
    let text = read_text(path)?;
    FileKind::Dynamics.require(path, &text)?;
    let names = (&*path.display().to_string(), &*name_of(path));
    checked(&text, names, (given, None))
}

/// Reads it with the inputs and outputs of a linear model, and with other values of the parameters
/// that are `given`, each in the declared unit.
///
/// # Errors
/// As [`read`], and unknown names of the request.
pub fn read_linear(
    path: &Path,
    request: &LinearRequest,
    given: &[(String, f64)],
) -> Result<Input, Diagnostics> {
    let text = read_text(path)?;
    FileKind::Dynamics.require(path, &text)?;
    parse_linear(&text, path, request, given)
}

/// Reads it from its text, as if it were at `path`.
///
/// # Errors
/// As [`read_linear`].
pub fn parse_linear(
    text: &str,
    path: impl AsRef<Path>,
    request: &LinearRequest,
    given: &[(String, f64)],
) -> Result<Input, Diagnostics> {
    let path = path.as_ref();
    let names = (&*path.display().to_string(), &*name_of(path));
    checked(text, names, (given, Some(request)))
}

/// Reads and checks the text of a dynamics input, as if it were at `path`: the paths of its files
/// are relative to it.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: impl AsRef<Path>) -> Result<Input, Diagnostics> {
    parse_with(text, path, &[])
}

/// Reads it with other values of the parameters that are `given`, each in the declared unit.
///
/// # Errors
/// As [`read`].
pub fn parse_with(
    text: &str,
    path: impl AsRef<Path>,
    given: &[(String, f64)],
) -> Result<Input, Diagnostics> {
    let path = path.as_ref();
    let names = (&*path.display().to_string(), &*name_of(path));
    checked(text, names, (given, None))
}

/// The text of the dynamics input at `path`, with other cards in place of each `[[rotor]]`. A comment names
/// the parameters whose values are numbers in these cards.
///
/// # Errors
/// Problems of syntax, of included files and of rotors.
pub fn expanded(path: &Path) -> Result<String, Diagnostics> {
    let text = read_text(path)?;
    FileKind::Dynamics.require(path, &text)?;
    rotors::expanded(&text, &path.display().to_string())
}

/// The input in the text of a file, whose results are called `name`, with other values of the
/// parameters that are `given`, and a linear model if it is requested.
fn checked(
    text: &str,
    (file, name): (&str, &str),
    (given, linear): (&[(String, f64)], Option<&LinearRequest>),
) -> Result<Input, Diagnostics> {
    let mut document = Document::parse_with_includes(text, file)?;
    document.require_known(&schema::DYNAMICS_FILE, "dynamics file")?;
    declare(&document, &document.root_of(&schema::DYNAMICS_FILE), given);
    // Problems of rotors are reported with all others.
    let inputs = linear.map_or(&[][..], |request| request.inputs.as_slice());
    let rotors = rotors::expand(&mut document, inputs);
    if !frames::repeat(&mut document) {
        return document.finish(None);
    }
    let mut unrepeated = Diagnostics::new();
    let input = cards(&document, name, (&rotors, linear), &mut unrepeated);
    let input = input.filter(|_| rotors.is_ok());
    let root = document.root_of(&schema::DYNAMICS_FILE);
    let locations = assembled::Locations::new(&root, file);
    match document.finish(input) {
        Ok(input) => assembled::checked(
            Input {
                unrepeated,
                ..input
            },
            &locations,
        ),
        Err(mut problems) => {
            problems.append(unrepeated);
            problems.sort_by_line();
            Err(problems)
        }
    }
}

/// The file's name without folder and ending, from which outputs are named.
pub fn name_of(path: &Path) -> String {
    let is_rotor = path.to_string_lossy().ends_with(ROTOR_ENDING);
    match is_blade_file(path) {
        true => blade_file::name_of(path),
        false if is_rotor => name_without(path, ROTOR_ENDING),
        false => name_without(path, ENDING),
    }
}

/// Declares the units of numbers and the parameters.
fn declare(document: &Document, root: &Table<'_>, given: &[(String, f64)]) {
    document.declare_units(root);
    document.declare_parameters_as(root, given);
}

/// Reads every card, in an order in which each finds the names that it uses.
fn cards(
    document: &Document,
    default_name: &str,
    (rotors, linear): (&Rotors, Option<&LinearRequest>),
    unrepeated: &mut Diagnostics,
) -> Option<Input> {
    let root = document.root_of(&schema::DYNAMICS_FILE);
    let name = root.text("name").unwrap_or_else(|| default_name.to_owned());
    let _read = ["units", "parameters", "include", "rotor", "output"].map(|key| root.has(key));
    let inputs = linear.map_or(&[][..], |request| request.inputs.as_slice());
    let mut drives = drives::read_named(&root, inputs);
    let control = control::declare(&root, &mut drives);
    let trim = trim::declare(&root, &mut drives);
    let ports = linear.map(|request| linear::declare(&root, request, &mut drives, trim.as_ref()));
    let properties = properties::read(&root, &drives);
    let hub = hub::read(&root);

    let mut builder = ModelBuilder::new(properties, hub);
    builder.note_broken_rotors(rotors.as_ref().err());
    builder.set_drives(drives);
    builder.set_frames(frames::read(&root));
    hub_support::add(&root, &mut builder);
    let gravity = loads::gravity(&root, &mut builder);
    let weight = gravity.as_ref().map_or_else(Vector3::zeros, |own| own.0);
    let air = aerodynamics::read(&root, &weight, builder.drives());
    if air.air.is_none() && root.has("air") {
        builder.note_broken_air();
    }
    builder.set_aerodynamics(air);
    parts(&root, &mut builder);
    control::read(control, &mut builder);
    let mut periodic = periodic::read(&root, &rotors::turning(rotors), &mut builder);
    let of_period = periodic.as_mut().and_then(Option::as_mut);
    let trim = trim::read(&root, trim, of_period, &mut builder);
    let mut analyses = analyses::read(&root, periodic, trim);
    let measured = measured::read(&root);
    let (linear, output) = outputs(&root, ports, analyses.as_mut(), &mut builder);
    root.finish_beside(&misplaced_keys::OF_FILE);

    builder.check(&root);
    transient::check(&root, &builder);
    drive_times::check(document, &builder, analyses.as_ref());
    if let Some(output) = &output {
        columns::check(&root, output, (analyses.as_ref(), builder.beams().len()));
    }
    let ((gravity, gravity_drive), analyses) = (gravity?, analyses?);
    check_rotation((document, &root, rotors), &gravity, &mut builder, &analyses)?;
    *unrepeated = rotors::unrepeated(document, rotors, &analyses);
    let (node_locations, joint_locations) = builder.locations(document);
    let mut input = finish(name, builder, analyses, measured?)?;
    input.linear = linear?;
    input.node_locations = node_locations;
    input.joint_locations = joint_locations;
    input.parameters = document.parameters().clone();
    input.model.words = rotors::words(rotors, input.words());
    input.model.gravity = gravity;
    input.model.gravity_drive = gravity_drive;
    input.output = output?;
    Some(input)
}

/// Notes rotors, gravity, supports and air that do not suit the rotation of the analyses; `None` if
/// the hub is wrong.
fn check_rotation(
    (document, root, rotors): (&Document, &Table<'_>, &Rotors),
    gravity: &Vector3<f64>,
    builder: &mut ModelBuilder,
    analyses: &Analyses,
) -> Option<()> {
    let mut remarks = rotors::check(document, rotors, analyses, builder.hub()?);
    let drives = builder.drives();
    remarks.extend(drive_times::remark(document, rotors, drives, analyses));
    builder.add_remarks(remarks);
    analyses.check(root, gravity, &builder.hub()?.frame_rotation());
    if !rotors::check_starts(root, rotors, analyses, builder.hub()?) {
        rotating_start::check((document, root), builder, analyses);
    }
    rotors::check_averaged(root, rotors, builder, analyses);
    check_air(root, builder, analyses);
    Some(())
}

/// Reads the cards of the parts of the model.
fn parts(root: &Table<'_>, builder: &mut ModelBuilder) {
    nodes::read(root, builder);
    blades::read(root, builder);
    beams::read(root, builder);
    clamps::read(root, builder);
    bodies::read(root, builder);
    joints::read_hinges(root, builder);
    joints::read_rigid(root, builder);
    joints::read_joints(root, builder);
    rods::read(root, builder);
    springs::read(root, builder);
    strips::read_cards(root, builder);
    loads::read(root, builder);
    internal_forces::read(root, builder);
    electrodes::read(root, builder);
}

/// The linear model of declared ports, `Some(None)` without; and the output of runs, which has no
/// columns beside a linear model: they are outputs of this one if they are requested.
fn outputs(
    root: &Table<'_>,
    ports: Option<Option<linear::Declared<'_>>>,
    analyses: Option<&mut Analyses>,
    builder: &mut ModelBuilder,
) -> (Option<Option<LinearSettings>>, Option<OutputSettings>) {
    match ports {
        None => (Some(None), columns::read(root, builder)),
        Some(ports) => {
            let both = ports.zip(analyses);
            let found = both.and_then(|(ports, own)| linear::read(root, ports, own, builder));
            (found.map(Some), Some(OutputSettings::default()))
        }
    }
}

/// Notes a wind that does not suit the analyses, and turbulence boxes too small for the blades.
fn check_air(root: &Table<'_>, builder: &mut ModelBuilder, analyses: &Analyses) {
    let (Some(hub), Some(air)) = (builder.hub(), builder.aerodynamics().used_air()) else {
        return;
    };
    let rotation = hub.frame_rotation();
    let blades = builder.air_blades().iter();
    let limits = blades.flat_map(|blade| {
        let limits = blade.mach_limits.iter();
        limits.map(|limit| (blade.name.as_str(), limit))
    });
    aerodynamics::check_mach(root, air, (&rotation, analyses.highest_start()), limits);
    aerodynamics::check_steady(root, air, (&rotation, analyses.highest_speed()));
    aerodynamics::check_ground(root, air, (&builder.rotor_centers(), &rotation.center));
    if let Some([_, end]) = analyses.times() {
        let frame = &air.wind().frame;
        let extents = builder.air_blades().iter();
        let extents = extents.filter_map(|blade| blade.extent(frame));
        aerodynamics::check_boxes(root, air, extents, end);
    }
    strips::check_inflows(root, builder);
}

/// The input if the model is complete.
fn finish(
    name: String,
    builder: ModelBuilder,
    analyses: Analyses,
    measured: Measured,
) -> Option<Input> {
    let summary = builder.summary(analyses.modes.as_ref(), &measured);
    let remarks = builder.remarks(analyses.buckling.is_some(), analyses.modes.is_some());
    let frame_rotation = builder.hub()?.frame_rotation();
    let model = equal_arms::with_arms(builder.model(name, frame_rotation)?, &analyses);
    Some(Input {
        model,
        modes: analyses.modes,
        statics: analyses.statics,
        buckling: analyses.buckling,
        output: OutputSettings::default(),
        transient: analyses.transient,
        periodic: analyses.periodic,
        trim: analyses.trim,
        stability: analyses.stability,
        linear: None,
        measured,
        free_hinges: Vec::new(),
        node_locations: Vec::new(),
        joint_locations: BTreeMap::new(),
        parameters: Vec::new(),
        summary,
        unrepeated: Diagnostics::new(),
        remarks,
    })
}
