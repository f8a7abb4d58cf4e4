//! Airfoils by name: `[airfoils.NAME]`.

use std::cell::RefCell;
use std::sync::Arc;

use rotor_aero::airfoil::{
    Airfoil, AirfoilData, BUILT_IN, BuiltIn, LinearLift, Section, UnsteadyConstants, built_in,
};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{NotNegative, Positive, Quantity, Text, Texts};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::airfoil_files;
use super::changes::{self, COMPRESSIBLE, Changes, MIRROR, STALL_DELAY, VITERNA};
use super::problem::StripProblem;
use super::unsteady::{self, UNSTEADY};

keys! {
    /// An airfoil: a file, a built-in airfoil, or linear lift.
    pub(in crate::input) CARD = "[airfoils.NAME]";
    /// The file, relative to this file, or a list of files, one for each Reynolds number; its
    /// format is recognized.
    FILE: Option<Vec<String>> = "file", [Texts], optional, "\"DU21_A17.dat\"";
    /// The airfoil of the file, if it has several.
    AIRFOIL: Option<String> = "airfoil", [Text], optional, "\"SNL-FFA-W3-500\"";
    /// A built-in airfoil: "naca0012", "flat_plate" or "thin".
    BUILT_IN_NAME: Option<String> = "built_in", [Text], optional, "\"naca0012\"";
    /// Linear lift without stall: its slope per radian.
    SLOPE: Option<f64> = "slope", [Positive(Dimension::NUMBER)], optional, "5.73";
    /// Linear lift: angle of attack without lift.
    ZERO_LIFT: f64 = "zero_lift", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "-3.2";
    /// Linear lift: coefficient of drag.
    DRAG: f64 = "drag", [NotNegative(Dimension::NUMBER)], or "0" = 0.0, "0.01";
    /// Linear lift: coefficient of the moment about the quarter chord.
    MOMENT: f64 = "moment", [Quantity(Dimension::NUMBER)], or "0" = 0.0, "-0.05";
    /// Thickness over chord, in place of the one of its file: its place in a `family`.
    THICKNESS: Option<f64> = "thickness", [Positive(Dimension::NUMBER)], or "as in the file", "0.21";
    with STALL_DELAY.schema, VITERNA.schema, COMPRESSIBLE.schema, MIRROR.schema,
        UNSTEADY.schema;
}

/// Airfoils by name; wrong ones are `None`.
#[derive(Debug, Clone, Default)]
pub(in crate::input) struct Airfoils {
    named: Vec<(String, Option<Arc<Airfoil>>)>,
    /// Unknown names that are noted.
    unknown: RefCell<Vec<String>>,
    /// Remarks on tables.
    pub remarks: Vec<String>,
}

/// Reads every `[airfoils.NAME]`.
pub(in crate::input) fn read(root: &Table<'_>) -> Airfoils {
    let mut airfoils = Airfoils::default();
    for (name, table) in root.named_tables("airfoils") {
        let found = airfoil(&name, &table, &mut airfoils.remarks);
        let (airfoil, constants) = found.unzip();
        let constants = unsteady::read(&table, constants.unwrap_or_default());
        let airfoil = airfoil.zip(constants).zip(table.get(&THICKNESS));
        let airfoil = airfoil.map(|((airfoil, constants), thickness)| {
            airfoil.with_unsteady(constants).with_thickness(thickness)
        });
        table.finish();
        airfoils.named.push((name, airfoil.map(Arc::new)));
    }
    airfoils
}

/// An airfoil, and the constants of unsteady models of its file.
fn airfoil(
    name: &str,
    table: &Table<'_>,
    remarks: &mut Vec<String>,
) -> Option<(Airfoil, UnsteadyConstants)> {
    let (file, of_file) = (table.get(&FILE), table.get(&AIRFOIL));
    let (built_in, slope) = (table.get(&BUILT_IN_NAME), table.get(&SLOPE));
    let linear = [&ZERO_LIFT, &DRAG, &MOMENT];
    let has_linear = linear.iter().find(|key| table.has(**key));
    let has_linear = has_linear.map(|key| key.name());
    let [zero_lift, drag, moment] = linear.map(|key| table.get(key));
    let changes = changes::read(table);
    let name = name.to_owned();
    let (file, of_file, built_in, slope) = (file?, of_file?, built_in?, slope?);
    let changes = changes?;
    let given = [file.is_some(), built_in.is_some(), slope.is_some()];
    one_source(&name, table, given)?;
    let useless = match (&file, slope) {
        (_, None) if has_linear.is_some() => has_linear.map(|key| (key, SLOPE.name())),
        (None, _) if of_file.is_some() => Some((AIRFOIL.name(), FILE.name())),
        (_, Some(_)) => changes.of_table().map(|key| (key, FILE.name())),
        _ => None,
    };
    if let Some((key, needed)) = useless {
        table.note(key, &StripProblem::Useless { name, key, needed });
        return None;
    }
    if let Some(files) = file {
        let at = (table, FILE.name());
        let (data, constants) =
            airfoil_files::read(&name, at, &files, of_file.as_deref(), remarks)?;
        let found = changed(data, &changes, at, remarks)?;
        // The constants are of the upright section.
        return Some(if changes.mirrors() {
            (found, UnsteadyConstants::default())
        } else {
            (found, constants)
        });
    }
    if let Some(wanted) = built_in {
        let at = (table, BUILT_IN_NAME.name());
        let found = named_built_in(&wanted, at, &format!("airfoil \"{name}\""))?;
        let found = if changes.is_any() {
            changed(found.data(), &changes, at, remarks)
        } else {
            Some(found.airfoil())
        };
        return without_constants(found?);
    }
    let lift = LinearLift {
        slope: slope?,
        zero_lift: zero_lift?,
        drag_0: drag?,
        moment: moment?,
        ..LinearLift::default()
    };
    without_constants(of_lift(lift, (&name, &changes), table)?)
}

/// An airfoil of linear lift with its change by the Mach number.
fn of_lift(
    lift: LinearLift,
    (name, changes): (&str, &Changes),
    table: &Table<'_>,
) -> Option<Airfoil> {
    let lift = match changes.mach_limit() {
        Some(limit) => lift.with_compressibility(name, limit),
        None => Ok(lift),
    };
    let note = |problem| airfoil_files::note(name, problem, (table, COMPRESSIBLE.name()));
    lift.map(Airfoil::linear).map_err(note).ok()
}

/// Notes an airfoil of no source or of several.
fn one_source(name: &str, table: &Table<'_>, given: [bool; 3]) -> Option<()> {
    let found = match given.iter().filter(|given| **given).count() {
        0 => "no source",
        1 => return Some(()),
        _ => "several sources",
    };
    let name = name.to_owned();
    table.note("", &StripProblem::AirfoilSource { name, found });
    None
}

/// An airfoil whose source states no constants.
fn without_constants(airfoil: Airfoil) -> Option<(Airfoil, UnsteadyConstants)> {
    Some((airfoil, UnsteadyConstants::default()))
}

/// The airfoil of a changed table; problems are noted under a key.
fn changed(
    data: AirfoilData,
    changes: &Changes,
    at: (&Table<'_>, &str),
    remarks: &mut Vec<String>,
) -> Option<Airfoil> {
    let name = data.name.clone();
    match changes.apply(data) {
        Ok(data) => {
            let found = airfoil_files::checked(&data, at, remarks)?;
            Some(if changes.delays_stall() {
                found.without_stall_delay()
            } else {
                found
            })
        }
        Err(problems) => {
            for problem in problems {
                airfoil_files::note(&name, problem, at);
            }
            None
        }
    }
}

/// A built-in airfoil by its name; another name is noted under `key`.
fn named_built_in(
    name: &str,
    (table, key): (&Table<'_>, &str),
    user: &str,
) -> Option<&'static BuiltIn> {
    let found = BUILT_IN.iter().find(|one| one.name == name);
    if found.is_none() {
        let problem = StripProblem::Unknown {
            kind: "built-in airfoil",
            name: name.to_owned(),
            user: user.to_owned(),
            known: BUILT_IN.iter().map(|one| one.name.to_owned()).collect(),
        };
        table.note(key, &problem);
    }
    found
}

impl Airfoils {
    /// Whether the name is one of `[airfoils]`.
    pub fn has_own(&self, name: &str) -> bool {
        self.named.iter().any(|named| named.0 == name)
    }

    /// Names of the airfoils of the file, and of the built-in ones.
    pub fn known(&self) -> impl Iterator<Item = &str> {
        let own = self.named.iter().map(|named| named.0.as_str());
        own.chain(BUILT_IN.iter().map(|one| one.name))
    }

    /// Adds an airfoil, unless its name is known; `None` for a wrong one.
    pub fn add(&mut self, name: &str, airfoil: Option<Arc<Airfoil>>) {
        if !self.has_own(name) {
            self.named.push((name.to_owned(), airfoil));
        }
    }

    /// Whether the name is an airfoil of the file, or a built-in one.
    pub fn has(&self, name: &str) -> bool {
        self.named.iter().any(|named| named.0 == name) || built_in(name).is_some()
    }

    /// The section of the airfoil `name`, as named under a key of a table, described by `user`;
    /// `None` if it is wrong, or unknown, which is noted at its first use.
    pub fn find(
        &self,
        name: &str,
        (table, key): (&Table<'_>, &str),
        user: &str,
    ) -> Option<Section> {
        if let Some((_, found)) = self.named.iter().find(|named| named.0 == name) {
            return found.clone().map(Section::single);
        }
        if let Some(found) = built_in(name) {
            return Some(Section::single(Arc::new(found)));
        }
        if self.unknown.borrow().iter().any(|unknown| unknown == name) {
            return None;
        }
        self.unknown.borrow_mut().push(name.to_owned());
        let problem = StripProblem::Unknown {
            kind: "airfoil",
            name: name.to_owned(),
            user: user.to_owned(),
            known: self.known().map(str::to_owned).collect(),
        };
        table.note(key, &problem);
        None
    }
}

#[cfg(test)]
#[path = "airfoils_tests.rs"]
mod tests;
