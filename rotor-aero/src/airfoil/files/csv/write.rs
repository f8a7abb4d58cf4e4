//! Columns of airfoils, written with all digits.

use super::super::super::data::Curve;
use super::super::joint::{Condition, condition, conditions, is_sound};
use super::super::notes::Notes;
use super::super::reading::{ReadAirfoil, Writing};

const HEADER: &str =
    "airfoil,thickness [-],mach [-],reynolds [-],flap [rad],alpha [deg],cl [-],cd [-],cm [-]\n";

/// The airfoils as one file; notes problems.
pub(in super::super) fn write(airfoils: &[ReadAirfoil], notes: &mut Notes) -> Option<Writing> {
    let mut text = HEADER.to_owned();
    let mut lost = Vec::new();
    for airfoil in airfoils {
        if !is_sound(&airfoil.data, notes) {
            return None;
        }
        for condition in conditions(&airfoil.data) {
            text += &rows(airfoil, &condition);
        }
        if !airfoil.unsteady.is_empty() {
            lost.push(format!(
                "airfoil \"{}\": the unsteady constants",
                airfoil.data.name
            ));
        }
    }
    Some(Writing { text, lost })
}

/// The rows of one condition: a cell is blank if its curve lacks the angle.
fn rows(airfoil: &ReadAirfoil, wanted: &Condition) -> String {
    let data = &airfoil.data;
    let of = |curves: &[Curve]| -> Vec<(f64, f64)> {
        let curves = curves.iter().filter(|curve| condition(curve) == *wanted);
        let pairs = curves.flat_map(|curve| curve.alpha.iter().zip(&curve.values));
        pairs
            .map(|(alpha, value)| (alpha.to_degrees(), *value))
            .collect()
    };
    let lists = [of(&data.lift), of(&data.drag), of(&data.moment)];
    let mut angles: Vec<f64> = lists.iter().flatten().map(|pair| pair.0).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    let cell = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
    let name = data.name.replace(['\n', '\r', '"'], " ");
    let [mach, reynolds, flap] = wanted.map(cell);
    let head = format!(
        "\"{name}\",{},{mach},{reynolds},{flap}",
        cell(data.thickness)
    );
    let row = |angle: &f64| {
        let at =
            |list: &Vec<(f64, f64)>| list.iter().find(|pair| pair.0 == *angle).map(|pair| pair.1);
        let values: String = lists
            .iter()
            .map(|list| format!(",{}", cell(at(list))))
            .collect();
        format!("{head},{angle}{values}\n")
    };
    angles.iter().map(row).collect()
}
