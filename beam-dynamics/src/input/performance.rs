//! The rotor input: `NAME.rotor.toml`, a rigid rotor and its operating points.

use std::f64::consts::PI;
use std::path::Path;

use rotor_aero::rotor::OperatingPoint;
use serde_json::Value;
use shared_geom::document::schema::ValueKind::{
    NamedTables, Parameters, Table as OneTable, Tables, Text, Word,
};
use shared_geom::document::schema::{self, UNITS};
use shared_geom::document::{ByHand, Document, PARAMETER_TABLE, Table, read_text};
use shared_geom::error::Diagnostics;
use shared_geom::file_kind::FileKind;
use shared_geom::files::name_without;
use shared_geom::keys;

use super::aerodynamics;
use crate::case::{PerformanceCase, PerformancePart, PerformanceRequest};

mod air;
mod blade_file;
mod loads_at;
mod mach;
mod momentum;
mod power_curves;
mod problem;
mod qprop;
mod rotor;
mod schedule_file;
mod schedules;
mod stations;
mod sweeps;
mod values;

pub use problem::PerformanceProblem;

/// Ending of the names of rotor inputs.
pub const ROTOR_ENDING: &str = ".rotor.toml";

keys! {
    /// A rigid rotor and its operating points.
    pub ROTOR_FILE = "NAME.rotor.toml";
    /// Name in reports and figures.
    NAME: ByHand = "name", [Text], or "NAME of the file", "\"NREL 5 MW\"";
    /// Units of plain numbers: SI with degrees and rpm, or the units of the table.
    UNITS_KEY: ByHand = "units", [Word(&["SI"]), OneTable(&UNITS)], required, "\"SI\"";
    /// Numbers with names, for expressions; a quantity is converted to the declared unit.
    PARAMETERS: ByHand = "parameters", [Parameters(&PARAMETER_TABLE)], optional,
        "{ tip = 63 }";
    /// The rotor.
    ROTOR: ByHand = "rotor", [OneTable(&rotor::CARD)], required, "";
    /// Airfoils, by name.
    AIRFOILS: ByHand = "airfoils", [NamedTables(&aerodynamics::AIRFOIL)], optional, "";
    /// Switches of annular momentum.
    MOMENTUM: ByHand = "momentum", [OneTable(&momentum::CARD)], optional, "";
    /// The air.
    AIR: ByHand = "air", [OneTable(&air::CARD)], optional, "";
    /// Grids of operating points.
    SWEEPS: ByHand = "sweep", [Tables(&sweeps::CARD)], optional, "";
    /// Operating points one by one.
    SCHEDULES: ByHand = "schedule", [Tables(&schedules::CARD)], optional, "";
    /// Operating curves of turbines.
    POWER_CURVES: ByHand = "power_curve", [Tables(&power_curves::CARD)], optional, "";
}

/// The opening of the reference page.
const OPENING: &str = "\
# Rotor input reference

Every key of a rotor file, `NAME.rotor.toml`.
Made by `beam-dynamics schema --of rotor --format markdown`; do not edit.
The use of the keys is described in [Performance of rotors](performance.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"63 m\"`.
In place of any number, a text that begins with `=` is an expression of parameters.
";

/// The JSON schema of a rotor file, draft 2020-12.
pub fn rotor_json_schema() -> Value {
    schema::shared_json_schema(&ROTOR_FILE, schema::Numbers::Expressions)
}

/// The reference page of the rotor file, in Markdown.
pub fn rotor_reference() -> String {
    schema::reference(&ROTOR_FILE, OPENING)
}

/// Reads and checks the rotor input at `path`, with the files that it names.
///
/// # Errors
/// All problems of the input and its files.
pub fn read_rotor(path: &Path) -> Result<PerformanceCase, Diagnostics> {
    let text = read_text(path)?;
    FileKind::Rotor.require(path, &text)?;
    parse_rotor(&text, path)
}

/// Reads and checks the text of a rotor input, as if it were at `path`.
///
/// # Errors
/// As [`read_rotor`].
pub fn parse_rotor(text: &str, path: impl AsRef<Path>) -> Result<PerformanceCase, Diagnostics> {
    let path = path.as_ref();
    let document = Document::parse(text, &path.display().to_string())?;
    let root = document.root_of(&ROTOR_FILE);
    document.declare_units(&root);
    document.declare_parameters(&root);
    let case = case(&root, name_without(path, ROTOR_ENDING));
    document.finish(case)
}

/// Notes a point at a negative speed of rotation.
fn turns_forward(table: &Table<'_>, part: &PerformancePart) {
    let PerformanceRequest::Settings(settings) = &part.request else {
        return;
    };
    if let Some(point) = settings.iter().find(|point| point.omega < 0.0) {
        let rpm = point.omega * 30.0 / PI;
        table.note("", &PerformanceProblem::Backward { rpm });
    }
}

fn case(root: &Table<'_>, default_name: String) -> Option<PerformanceCase> {
    let name = root.text("name").unwrap_or(default_name);
    let _read = ["units", "parameters"].map(|key| root.has(key));
    let airfoils = aerodynamics::read_airfoils(root);
    let momentum = momentum::read(root);
    let air = air::read(root);
    let mut remarks = airfoils.remarks.clone();
    remarks.extend(air.as_ref().and_then(aerodynamics::remark_on_density));
    let table = root.require_table(
        "rotor",
        "the rotor: [rotor] with \"blades\" and \"stations\"",
    );
    let rotor = table
        .as_ref()
        .and_then(|table| rotor::read(table, &airfoils, momentum, &mut remarks));
    let radius = rotor
        .as_ref()
        .map_or(1.0, |rotor| rotor.rotor.disk_radius());
    let parts = parts(root, radius, rotor.as_ref());
    root.finish();
    let (table, rotor, air) = (table?, rotor?, air?);
    let mut parts = parts?;
    for (part, table) in &mut parts {
        loads_at::check(table, part, radius);
        turns_forward(table, part);
    }
    let parts: Vec<PerformancePart> = parts.into_iter().map(|part| part.0).collect();
    if !rotor.holds_mach {
        let key = rotor::OUTSIDE_MACH.name();
        mach::check((&table, key), &rotor.rotor, &parts, air.sound_speed);
    }
    Some(PerformanceCase {
        name,
        machine: rotor.machine,
        air: OperatingPoint {
            density: air.density,
            viscosity: air.viscosity,
            speed_of_sound: air.sound_speed,
            shear_exponent: rotor.shear,
            ..OperatingPoint::default()
        },
        rotor: rotor.rotor,
        parts,
        remarks,
    })
}

/// The requested points, each with its table.
fn parts<'a>(
    root: &Table<'a>,
    radius: f64,
    rotor: Option<&rotor::Rotor>,
) -> Option<Vec<(PerformancePart, Table<'a>)>> {
    let [curves, schedules, sweeps] =
        ["power_curve", "schedule", "sweep"].map(|key| root.tables(key));
    if let (Some(first), Some(rotor)) = (curves.first(), rotor) {
        let machine = rotor::WORDS[rotor.machine as usize];
        if machine != rotor::WORDS[0] {
            first.note("", &PerformanceProblem::NotATurbine { machine });
        }
    }
    if curves.is_empty() && schedules.is_empty() && sweeps.is_empty() {
        root.note("", &PerformanceProblem::NoPoints);
        return None;
    }
    let usual = |kind: &str, index: usize| format!("{kind} {}", index + 1);
    let mut read: Vec<Option<(PerformancePart, Table<'a>)>> = Vec::new();
    for (index, table) in curves.into_iter().enumerate() {
        let part = power_curves::read(&table, usual("power curve", index));
        read.push(part.map(|part| (part, table)));
    }
    for (index, table) in schedules.into_iter().enumerate() {
        let part = schedules::read(&table, usual("schedule", index));
        read.push(part.map(|part| (part, table)));
    }
    for (index, table) in sweeps.into_iter().enumerate() {
        let part = sweeps::read(&table, usual("sweep", index), radius);
        read.push(part.map(|part| (part, table)));
    }
    let parts = read.into_iter().collect::<Option<Vec<_>>>()?;
    for (index, (part, table)) in parts.iter().enumerate() {
        if parts[..index].iter().any(|other| other.0.name == part.name) {
            let name = part.name.clone();
            table.note("name", &PerformanceProblem::SameName { name });
        }
    }
    Some(parts)
}
