//! C81 tables, written with six characters per number.

use super::super::super::data::{AirfoilData, Curve};
use super::super::joint::{Joint, is_sound};
use super::super::notes::Notes;
use super::super::reading::{ReadAirfoil, Writing};
use super::{PER_LINE, TITLE, WIDTH};

/// Most Mach numbers or angles of a block: the counts have two digits.
const MOST: usize = 99;

/// The airfoils as one file; notes problems.
pub(in super::super) fn write(airfoils: &[ReadAirfoil], notes: &mut Notes) -> Option<Writing> {
    let mut lost = Vec::new();
    let mut text = String::new();
    for airfoil in airfoils {
        if is_sound(&airfoil.data, notes) {
            text += &table(&airfoil.data, &mut lost, notes)?;
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

/// The table of an airfoil.
fn table(data: &AirfoilData, lost: &mut Vec<String>, notes: &mut Notes) -> Option<String> {
    let name: String = data
        .name
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    let title: String = name.chars().take(TITLE).collect();
    if name.chars().count() > TITLE {
        lost.push(format!(
            "the end of the name \"{name}\": a title has {TITLE} characters"
        ));
    }
    let blocks = [
        ("lift", &data.lift),
        ("drag", &data.drag),
        ("moment", &data.moment),
    ];
    let blocks = blocks.map(|(what, curves)| {
        let what = format!("{what} of airfoil \"{}\"", data.name);
        block(&what, curves, lost, notes)
    });
    let [lift, drag, moment] = blocks;
    let blocks = [lift?, drag?, moment?];
    let counts: String = blocks
        .iter()
        .map(|block| format!("{:2}{:2}", block.counts[0], block.counts[1]))
        .collect();
    let body: String = blocks.iter().map(|block| block.text.as_str()).collect();
    Some(format!("{title:<TITLE$}{counts}\n{body}"))
}

/// Rounding of a coefficient that is not reported: round-off of changes of units \[-\].
const ROUND_OFF: f64 = 1e-9;

/// The largest difference between values and the written numbers \[-\].
fn rounding<'v>(values: impl Iterator<Item = &'v f64>) -> f64 {
    let error = |value: &f64| {
        let written: Option<f64> = six(*value)?.parse().ok();
        written.map(|written| (written - value).abs())
    };
    values.filter_map(error).fold(0.0, f64::max)
}

/// Lines of one coefficient.
struct Block {
    counts: [usize; 2],
    text: String,
}

fn block(what: &str, curves: &[Curve], lost: &mut Vec<String>, notes: &mut Notes) -> Option<Block> {
    let mut sorted: Vec<&Curve> = curves.iter().collect();
    let mach = |curve: &Curve| curve.mach.unwrap_or(0.0);
    sorted.sort_by(|a, b| mach(a).total_cmp(&mach(b)));
    if sorted.windows(2).any(|two| mach(two[0]) == mach(two[1])) {
        let help = "write one file per Reynolds number and deflection";
        notes.wrong(
            0,
            [
                what,
                "two tables of one Mach number",
                "tables that depend on Mach alone",
                help,
            ],
        );
        return None;
    }
    if sorted
        .iter()
        .any(|curve| curve.reynolds.is_some() || curve.flap.is_some())
    {
        lost.push(format!("{what}: the Reynolds number and the deflection"));
    }
    let joint = Joint::of(&sorted);
    if joint.added > 0 {
        lost.push(format!(
            "{what}: {} values are interpolated to a common grid",
            joint.added
        ));
    }
    let counts = [sorted.len(), joint.alpha.len()];
    if counts.iter().any(|&count| count > MOST) {
        let found = format!("{} Mach numbers and {} angles", counts[0], counts[1]);
        let help = "leave angles out, above all between -180 and -30 and between 30 and 180 deg";
        notes.wrong(0, [what, &found, "at most 99 of both", help]);
        return None;
    }
    let machs: Vec<f64> = sorted.iter().map(|curve| mach(curve)).collect();
    let text = lines(what, &machs, &joint, notes)?;
    let error = rounding(joint.columns.iter().flatten());
    if error > ROUND_OFF {
        lost.push(format!(
            "{what}: digits beyond six characters, {error:.1e} at most"
        ));
    }
    Some(Block { counts, text })
}

/// The record of the Mach numbers, then the ones of the angles.
fn lines(what: &str, machs: &[f64], joint: &Joint, notes: &mut Notes) -> Option<String> {
    if machs.is_empty() {
        return Some(String::new());
    }
    let mut text = record(None, machs, what, notes)?;
    let mut before = String::new();
    for (i, alpha) in joint.alpha.iter().enumerate() {
        let values: Vec<f64> = joint
            .columns
            .iter()
            .filter_map(|column| column.get(i).copied())
            .collect();
        let angle = alpha.to_degrees();
        let shown = six(angle)?;
        if shown == before {
            let found = format!("two angles that are both written {shown}");
            let help = "leave one of the two angles out";
            notes.wrong(
                0,
                [what, &found, "angles that differ in six characters", help],
            );
            return None;
        }
        text += &record(Some(angle), &values, what, notes)?;
        before = shown;
    }
    Some(text)
}

/// One record, on as many lines as it needs.
fn record(first: Option<f64>, values: &[f64], what: &str, notes: &mut Notes) -> Option<String> {
    let mut field = |value: f64| {
        let shown = six(value);
        if shown.is_none() {
            let help = "coefficients of airfoils are smaller: check the values";
            notes.wrong(
                0,
                [
                    what,
                    &value.to_string(),
                    "a number of at most six characters",
                    help,
                ],
            );
        }
        shown.map(|shown| format!("{shown:>WIDTH$}"))
    };
    let mut text = match first {
        Some(value) => field(value)?,
        None => " ".repeat(WIDTH),
    };
    for (i, value) in values.iter().enumerate() {
        if i > 0 && i % PER_LINE == 0 {
            text += "\n";
            text += &" ".repeat(WIDTH);
        }
        text += &field(*value)?;
    }
    Some(text + "\n")
}

/// A number in at most six characters, with as many decimals as they allow.
pub(super) fn six(value: f64) -> Option<String> {
    (0..=5).rev().find_map(|decimals| {
        let plain = format!("{value:.decimals$}");
        let short = match plain.strip_prefix("-0.") {
            Some(rest) => format!("-.{rest}"),
            None => plain
                .strip_prefix("0.")
                .map_or(plain.clone(), |rest| format!(".{rest}")),
        };
        (short.len() <= 6).then_some(short)
    })
}
