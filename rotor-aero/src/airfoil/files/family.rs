//! Several files of one airfoil, as XFOIL writes one per Reynolds number.

use std::path::Path;

use shared_geom::error::Diagnostics;

use super::super::data::{AirfoilData, Curve};
use super::joint::condition;
use super::notes::Notes;
use super::reading::{ReadAirfoil, Reading};

/// Joins airfoils of equal names, and sorts their curves by Mach number, Reynolds number and
/// deflection. A Mach number that only some files state is 0 in the others.
///
/// # Errors
/// No reading, or two curves of one condition.
pub fn merge(readings: Vec<Reading>) -> Result<Reading, Diagnostics> {
    let mut notes = Notes::new(Path::new("the files of the airfoil"));
    let mut merged: Option<Reading> = None;
    for reading in readings {
        match &mut merged {
            None => merged = Some(reading),
            Some(merged) => {
                merged.airfoils.extend(reading.airfoils);
                merged.remarks.extend(reading.remarks);
            }
        }
    }
    if merged.is_none() {
        notes.missing(0, "a file", "name at least one file");
    }
    if let Some(merged) = &mut merged {
        let airfoils = std::mem::take(&mut merged.airfoils);
        merged.airfoils = joined(airfoils);
        for airfoil in &mut merged.airfoils {
            complete(&mut airfoil.data);
            check(&airfoil.data, &mut notes);
        }
    }
    Ok(notes.finish(merged, "the family of polars")?.0)
}

/// One airfoil per name and set, in the order of the first.
fn joined(airfoils: Vec<ReadAirfoil>) -> Vec<ReadAirfoil> {
    let mut all: Vec<ReadAirfoil> = Vec::new();
    for airfoil in airfoils {
        let is_it = |known: &&mut ReadAirfoil| {
            known.data.name == airfoil.data.name && known.set == airfoil.set
        };
        match all.iter_mut().find(is_it) {
            Some(known) => {
                known.data.lift.extend(airfoil.data.lift);
                known.data.drag.extend(airfoil.data.drag);
                known.data.moment.extend(airfoil.data.moment);
                known.unsteady.extend(airfoil.unsteady);
            }
            None => all.push(airfoil),
        }
    }
    all
}

/// Sorts the curves, and sets a Mach number that only some of them have to 0 in the others.
fn complete(data: &mut AirfoilData) {
    for curves in [&mut data.lift, &mut data.drag, &mut data.moment] {
        if curves.iter().any(|curve| curve.mach.is_some()) {
            for curve in curves.iter_mut() {
                curve.mach = curve.mach.or(Some(0.0));
            }
        }
        let key = |curve: &Curve| condition(curve).map(|value| value.unwrap_or(0.0));
        curves.sort_by(|a, b| {
            let pairs = key(a).into_iter().zip(key(b));
            let mut orders = pairs.map(|(a, b)| a.total_cmp(&b));
            orders
                .find(|order| order.is_ne())
                .unwrap_or(std::cmp::Ordering::Equal)
        });
    }
}

/// Notes two curves of one coefficient and one condition.
pub(super) fn check(data: &AirfoilData, notes: &mut Notes) {
    let lists = [
        ("lift", &data.lift),
        ("drag", &data.drag),
        ("moment", &data.moment),
    ];
    for (what, curves) in lists {
        for (i, curve) in curves.iter().enumerate() {
            let [mach, reynolds, flap] = condition(curve);
            let before = curves.get(..i).unwrap_or_default();
            if before
                .iter()
                .any(|other| condition(other) == condition(curve))
            {
                let show =
                    |value: Option<f64>| value.map_or("any".to_owned(), |value| value.to_string());
                let found = format!(
                    "two tables at Mach number {}, Reynolds number {}, deflection {}",
                    show(mach),
                    show(reynolds),
                    show(flap)
                );
                let help = "delete one of them, or correct its conditions";
                notes.wrong(
                    0,
                    [
                        &format!("{what} of airfoil \"{}\"", data.name),
                        &found,
                        "one",
                        help,
                    ],
                );
            }
        }
    }
}
