//! Airfoils from files of any known format.

use rotor_aero::airfoil::files::{self, Reading};
use rotor_aero::airfoil::{Airfoil, Interpolation, Viterna};
use shared_geom::document::Table;

use super::problem::StripProblem;

/// The use of a file of airfoils.
pub(super) struct Wanted {
    /// Name of the airfoil in a file of several.
    pub of_file: Option<String>,
    /// Aspect ratio for the extension to the full circle \[-\].
    pub viterna: Option<f64>,
}

/// The airfoil `name` from files of one family, as named under a key. Problems are noted.
pub(super) fn read(
    name: &str,
    (table, key): (&Table<'_>, &str),
    files: &[String],
    Wanted { of_file, viterna }: Wanted,
    remarks: &mut Vec<String>,
) -> Option<Airfoil> {
    let readings = files.iter().map(|file| {
        let path = table.existing(key, file)?;
        table.document().keep(files::read(&path))
    });
    // Every file is read, so that the problems of each are noted.
    let readings: Vec<_> = readings.collect();
    let readings = readings.into_iter().collect::<Option<Vec<_>>>()?;
    let reading = match <[Reading; 1]>::try_from(readings) {
        Ok([only]) => only,
        Err(several) => table.document().keep(files::merge(several))?,
    };
    let found = match &of_file {
        Some(wanted) => reading
            .airfoils
            .iter()
            .find(|airfoil| airfoil.data.name == *wanted),
        None if reading.airfoils.len() == 1 => reading.airfoils.first(),
        None => None,
    };
    let Some(found) = found else {
        let known = reading.airfoils.iter();
        let problem = StripProblem::Unknown {
            kind: "airfoil of the file",
            name: of_file.unwrap_or_default(),
            user: format!("airfoil \"{name}\""),
            known: known.map(|airfoil| airfoil.data.name.clone()).collect(),
        };
        table.note(key, &problem);
        return None;
    };
    let of_airfoil = |remark: String| format!("airfoil \"{name}\": {remark}");
    remarks.extend(reading.remarks.iter().cloned().map(of_airfoil));
    let extended = match viterna {
        Some(ratio) => found.data.extended(&Viterna::of_aspect_ratio(ratio)),
        None => Ok(found.data.clone()),
    };
    match extended.and_then(|data| Airfoil::new(&data, Interpolation::Monotone)) {
        Ok(airfoil) => {
            let own = airfoil.remarks().iter().map(ToString::to_string);
            remarks.extend(own.map(of_airfoil));
            Some(airfoil)
        }
        Err(problems) => {
            for problem in &problems {
                table.note(key, problem);
            }
            None
        }
    }
}
