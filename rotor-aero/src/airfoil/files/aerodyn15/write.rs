//! Polars of AeroDyn 15, written with all digits.

use super::super::super::constants::UnsteadyConstants;
use super::super::super::data::AirfoilData;
use super::super::joint::{Condition, Joint, conditions, find, is_sound};
use super::super::notes::Notes;
use super::super::reading::{ReadAirfoil, Writing};

/// The file of one airfoil; notes problems.
pub(in super::super) fn write(airfoils: &[ReadAirfoil], notes: &mut Notes) -> Option<Writing> {
    let [airfoil] = airfoils else {
        let found = format!("{} airfoils", airfoils.len());
        notes.wrong(
            0,
            [
                "AeroDyn 15 polar",
                &found,
                "one airfoil",
                "write one file per airfoil",
            ],
        );
        return None;
    };
    let data = &airfoil.data;
    if !is_sound(data, notes) {
        return None;
    }
    let conditions = conditions(data);
    if conditions
        .iter()
        .any(|[mach, _, _]| *mach != conditions[0][0])
    {
        let help = "write one file per Mach number, or a C81 table";
        notes.wrong(0, ["AeroDyn 15 polar", "several Mach numbers", "one", help]);
        return None;
    }
    let mut lost = Vec::new();
    if conditions.iter().any(|[mach, _, _]| mach.is_some()) {
        lost.push("the Mach number".to_owned());
    }
    let tables: Option<String> = conditions
        .iter()
        .enumerate()
        .map(|(i, condition)| {
            let constants = airfoil
                .unsteady
                .iter()
                .find(|constants| fits(constants, condition));
            table((i + 1, condition), data, constants, (&mut lost, notes))
        })
        .collect();
    Some(Writing {
        text: head(airfoil, conditions.len()) + &tables?,
        lost,
    })
}

/// Angles that differ by less are one, rounded between deg and rad [rad].
const SAME: f64 = 1e-9;

/// Whether constants are of the table of a condition.
fn fits(constants: &UnsteadyConstants, [_, reynolds, flap]: &Condition) -> bool {
    let control = constants.control.unwrap_or(0.0).to_radians();
    constants.reynolds == *reynolds && (flap.unwrap_or(0.0) - control).abs() < SAME
}

fn head(airfoil: &ReadAirfoil, tables: usize) -> String {
    let rule = "! ------------------------------------------------------------------------------\n";
    let mut text =
        "! ------------ AirfoilInfo v1.01.x Input File ----------------------------------\n"
            .to_owned();
    let name = airfoil.data.name.replace(['\n', '\r'], " ");
    text += &format!("! {name}\n{rule}");
    text += &field("DEFAULT", "InterpOrd", "order of the interpolation");
    if let Some(thickness) = airfoil.data.thickness {
        text += &field(
            &thickness.to_string(),
            "RelThickness",
            "thickness over chord",
        );
    }
    text += &field("1", "NonDimArea", "area over chord squared");
    let coordinates = airfoil.coordinates.as_ref();
    let coordinates = coordinates.map_or("0".to_owned(), |file| format!("@\"{file}\""));
    text += &field(&coordinates, "NumCoords", "number of coordinates");
    text + &field(&tables.to_string(), "NumTabs", "number of tables") + rule
}

fn field(value: &str, name: &str, meaning: &str) -> String {
    format!("{value:<24} {name:<12} ! {meaning}\n")
}

/// One table.
fn table(
    (index, condition): (usize, &Condition),
    data: &AirfoilData,
    constants: Option<&UnsteadyConstants>,
    (lost, notes): (&mut Vec<String>, &mut Notes),
) -> Option<String> {
    let [_, reynolds, flap] = condition;
    let lift = find(&data.lift, condition);
    let drag = find(&data.drag, condition);
    let (Some(lift), Some(drag)) = (lift, drag) else {
        let what = format!("table {index}: lift and drag of one Reynolds number and deflection");
        notes.missing(0, &what, "give both coefficients for the same conditions");
        return None;
    };
    let mut curves = vec![lift, drag];
    curves.extend(find(&data.moment, condition));
    let joint = Joint::of(&curves);
    if joint.added > 0 {
        lost.push(format!(
            "table {index}: {} values are interpolated to a common grid",
            joint.added
        ));
    }
    let mut text = format!("! data for table {index}\n");
    let millions = reynolds.unwrap_or(0.0) / 1e6;
    text += &field(&millions.to_string(), "Re", "Reynolds number in millions");
    text += &field(
        &flap.unwrap_or(0.0).to_degrees().to_string(),
        "Ctrl",
        "control setting",
    );
    let has = if constants.is_some() { "True" } else { "False" };
    text += &field(has, "InclUAdata", "whether unsteady constants follow");
    for (name, value) in constants.iter().flat_map(|constants| &constants.values) {
        let value = value.map_or("Default".to_owned(), |value| value.to_string());
        text += &field(&value, name, "unsteady constant");
    }
    text += &field(&joint.alpha.len().to_string(), "NumAlf", "number of rows");
    Some(text + &rows(&joint))
}

fn rows(joint: &Joint) -> String {
    let titles = ["Alpha (deg)", "Cl (-)", "Cd (-)", "Cm (-)"];
    let titles: String = titles
        .iter()
        .take(1 + joint.columns.len())
        .map(|title| format!("{title:>24}"))
        .collect();
    let mut text = format!("!{titles}\n");
    for (i, alpha) in joint.alpha.iter().enumerate() {
        text += &format!("{:24.16e}", alpha.to_degrees());
        for value in joint.columns.iter().filter_map(|column| column.get(i)) {
            text += &format!("{value:24.16e}");
        }
        text += "\n";
    }
    text
}
