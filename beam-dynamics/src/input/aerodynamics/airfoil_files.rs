//! Airfoils from files of any known format.

use rotor_aero::airfoil::files::{self, ReadAirfoil, Reading};
use rotor_aero::airfoil::{
    Airfoil, AirfoilData, AirfoilProblem, Interpolation, RADIANS, UnsteadyConstants,
};
use shared_geom::document::Table;
use shared_geom::error::Explain;

use super::problem::StripProblem;

/// The table of the airfoil `name` from files with its constants, as named under a key: one per Reynolds number, or
/// one for all; `of_file` is its name in a file of several. Problems are noted.
pub(super) fn read(
    name: &str,
    (table, key): (&Table<'_>, &str),
    written: &[String],
    of_file: Option<&str>,
    remarks: &mut Vec<String>,
) -> Option<(AirfoilData, UnsteadyConstants)> {
    let readings = written.iter().map(|file| {
        let mut reading = one(name, (table, key), file, of_file)?;
        let of_airfoil = |remark: String| format!("airfoil \"{name}\": {remark}");
        remarks.extend(
            std::mem::take(&mut reading.remarks)
                .into_iter()
                .map(of_airfoil),
        );
        Some(reading)
    });
    let readings: Vec<_> = readings.collect();
    let readings: Vec<Reading> = readings.into_iter().collect::<Option<_>>()?;
    let merged = table.keep_file(key, files::merge(readings))?;
    let first = merged.airfoils.into_iter().next()?;
    let constants = constants(&first, remarks);
    Some((first.data, constants))
}

/// The constants of unsteady models of an airfoil; tables with other ones are remarked.
pub(in crate::input) fn constants(
    airfoil: &ReadAirfoil,
    remarks: &mut Vec<String>,
) -> UnsteadyConstants {
    let (found, are_equal) = airfoil.constants();
    if !are_equal {
        remarks.push(format!(
            "airfoil \"{}\": its tables have different constants of unsteady models; the ones of the \
             first are used",
            airfoil.data.name
        ));
    }
    found
}

/// The reading of one file with the airfoil alone, under the name `name`.
fn one(
    name: &str,
    (table, key): (&Table<'_>, &str),
    file: &str,
    of_file: Option<&str>,
) -> Option<Reading> {
    let path = table.existing(key, file)?;
    let mut reading = table.document().keep(files::read(&path))?;
    let is_alone = reading.airfoils.len() == 1;
    let is_it = |found: &str| of_file.map_or(is_alone, |wanted| found == wanted);
    let known = reading.airfoils.iter();
    let known: Vec<_> = known.map(|airfoil| airfoil.data.name.clone()).collect();
    reading.airfoils.retain(|airfoil| is_it(&airfoil.data.name));
    if reading.airfoils.is_empty() {
        let problem = StripProblem::Unknown {
            kind: "airfoil of the file",
            name: of_file.unwrap_or_default().to_owned(),
            user: format!("airfoil \"{name}\""),
            known,
        };
        table.note(key, &problem);
        return None;
    }
    // Two sets of profiles may have equal names.
    reading.airfoils.truncate(1);
    for airfoil in &mut reading.airfoils {
        name.clone_into(&mut airfoil.data.name);
        airfoil.set = None;
    }
    Some(reading)
}

/// The airfoil of a table; problems are noted under a key. Its remarks are added.
pub(in crate::input) fn checked(
    data: &AirfoilData,
    (table, key): (&Table<'_>, &str),
    remarks: &mut Vec<String>,
) -> Option<Airfoil> {
    match Airfoil::new(data, Interpolation::Monotone) {
        Ok(airfoil) => {
            let own = airfoil.remarks().iter().map(ToString::to_string);
            remarks.extend(own.map(|remark| format!("airfoil \"{}\": {remark}", data.name)));
            Some(airfoil)
        }
        Err(problems) => {
            for problem in problems {
                note(&data.name, problem, (table, key));
            }
            None
        }
    }
}

/// Notes a problem of a table, with the keys that solve it.
pub(super) fn note(name: &str, problem: AirfoilProblem, (table, key): (&Table<'_>, &str)) {
    let help = match problem {
        AirfoilProblem::Incomplete {
            from_deg, to_deg, ..
        } if from_deg.abs().max(to_deg.abs()) > RADIANS => Some(format!(
            "add \"viterna = true\" to [airfoils.{name}], or write a complete table: \
             beam-dynamics airfoil FILE --viterna --out NEW"
        )),
        _ => problem.help(),
    };
    let problem = StripProblem::Airfoil {
        name: name.to_owned(),
        reason: problem.to_string(),
        help,
    };
    table.note(key, &problem);
}
