//! Airfoils from files of any known format.

use rotor_aero::airfoil::files;
use rotor_aero::airfoil::{Airfoil, Interpolation};
use shared_geom::document::Table;

use super::problem::StripProblem;

/// The airfoil `name` from a file, as named under a key; `of_file` is its name in a file of
/// several. Problems are noted.
pub(super) fn read(
    name: &str,
    (table, key): (&Table<'_>, &str),
    file: &str,
    of_file: Option<String>,
    remarks: &mut Vec<String>,
) -> Option<Airfoil> {
    let path = table.existing(key, file)?;
    let reading = table.document().keep(files::read(&path))?;
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
    match Airfoil::new(&found.data, Interpolation::Monotone) {
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
