//! Materials of windIO files as tables of layup files.
//!
//! Axis 1 is along the fiber, 2 in the ply, 3 through it; E, G and nu are lists of 11, 22, 33, of
//! 12, 13, 23, and of 12, 13, 23. A law is possible if
//!
//! ```text
//! D = 1 - nu12^2 E2/E1 - nu13^2 E3/E1 - nu23^2 E3/E2 - 2 nu12 nu13 nu23 E3/E1 > 0
//! ```
//!
//! and nu_ij^2 < E_i/E_j.

use std::fmt::Write;
use std::path::PathBuf;

use shared_geom::document::basic_string;
use shared_geom::error::quoted;
use shared_geom::exchange::text::number;
use shared_geom::exchange::windio_fields::numbers;
use shared_geom::exchange::yaml::{Node, Value};

use super::super::Materials;
use super::super::constants::checked;
use super::layers::Used;
use super::{Notes, items, named, required};

/// Step of the factor of Poisson's ratios through the thickness, and the least D that it gives.
const REPAIR: [f64; 2] = [0.05, 0.05];
/// Poisson's ratio in the place of larger ones of isotropic materials.
const LARGEST: f64 = 0.49;

/// Part by which the shear modulus of an isotropic material differs from the one of E and nu without a remark;
/// foams and adhesives of public blades have up to 0.1.
const OTHER_SHEAR: f64 = 0.15;

/// The strength of a direction without one \[Pa\].
const UNLIMITED: f64 = 1e30;
/// Keys of strengths of a ply, with their list of Xt, Xc, S and their position in it: the ones that a
/// table needs, and the ones with a default.
const NEEDED: [(&str, (usize, usize)); 5] = [
    ("xt", (0, 0)),
    ("xc", (1, 0)),
    ("yt", (0, 1)),
    ("yc", (1, 1)),
    ("s12", (2, 0)),
];
const OTHERS: [(&str, (usize, usize)); 4] = [
    ("zt", (0, 2)),
    ("zc", (1, 2)),
    ("s13", (2, 1)),
    ("s23", (2, 2)),
];

/// Keys of the three lists, in the order of the lists.
const KEYS: [(&str, [&str; 3]); 3] = [
    ("E", ["e1", "e2", "e3"]),
    ("G", ["g12", "g13", "g23"]),
    ("nu", ["nu12", "nu13", "nu23"]),
];

/// The tables of the materials that are used, with their units; notes problems.
pub(super) fn constants(
    root: &Node,
    used: &[Used],
    treatment: Materials,
    notes: &mut Notes,
) -> Option<String> {
    let list = required(root, "the file", "materials", notes)?;
    let known: Vec<&str> = items(list, "materials", notes)?
        .into_iter()
        .filter_map(|node| node.entry("name")?.text())
        .collect();
    // with the line of the file for each line of the text
    let mut text = String::from("units = \"SI\"\n");
    let mut lines = vec![list.line];
    let mut is_complete = true;
    for one in used {
        let name = &one.material;
        let Some(node) = named(root, name) else {
            let expected = ["a material of the file", &known.join("\n")];
            let what = format!("material of {}", one.layer);
            notes.unknown(one.line, &what, name, expected);
            is_complete = false;
            continue;
        };
        match table(node, name, treatment, notes) {
            Some(table) => text.push_str(&table),
            None => is_complete = false,
        }
        lines.resize(text.lines().count(), node.line);
    }
    if !is_complete {
        return None;
    }
    let file = PathBuf::from(&notes.file);
    let origin = |line: usize| Some((file.clone(), line));
    let origins: Vec<_> = lines.into_iter().map(origin).collect();
    checked(text, &origins, repair, &mut notes.problems)
}

/// The remedy for the row of a law that Poisson's ratios make impossible; problems of several
/// constants are on the row of the material.
fn repair(row: &str) -> Option<&str> {
    let is_of_ratios = ["nu", "poisson", "[material"]
        .iter()
        .any(|start| row.starts_with(start));
    is_of_ratios.then_some("--repair-materials takes smaller Poisson's ratios")
}

/// The table of a material.
fn table(node: &Node, name: &str, treatment: Materials, notes: &mut Notes) -> Option<String> {
    let of = format!("material \"{name}\"");
    let density = required(node, &of, "rho", notes).and_then(|at| values::<1>(at, &of, notes));
    let is_orthotropic = matches!(node.entry("E").map(|e| &e.value), Some(Value::List(_)));
    remark_on_kind(node, &of, is_orthotropic, notes);
    let mut text = format!("\n[material.{}]\n", basic_string(name));
    let law = if is_orthotropic {
        orthotropic(node, &of, treatment, notes)
    } else {
        isotropic(node, &of, treatment, notes)
    };
    text += &law?;
    // writing to a string cannot fail
    let _ = writeln!(text, "density = {:?}", density?[0]);
    let strength = strength(node, name, is_orthotropic, notes);
    text += &strength;
    text += &fatigue(node, (&of, is_orthotropic), !strength.is_empty(), notes);
    Some(text)
}

/// A remark if `orth` and the form of the constants disagree.
fn remark_on_kind(node: &Node, of: &str, is_orthotropic: bool, notes: &mut Notes) {
    let Some(at) = node.entry("orth") else {
        return;
    };
    let Some(named) = at.text().and_then(number) else {
        return;
    };
    if (named != 0.0) != is_orthotropic {
        let (form, kind) = match is_orthotropic {
            true => ("a list", "an orthotropic"),
            false => ("a number", "an isotropic"),
        };
        notes.remarks.push(format!(
            "line {}: {of}: orth is {named}, and E is {form}: {kind} material is taken",
            at.line
        ));
    }
}

fn isotropic(node: &Node, of: &str, treatment: Materials, notes: &mut Notes) -> Option<String> {
    let [young, poisson] = ["E", "nu"].map(|key| {
        let at = required(node, of, key, notes)?;
        values::<1>(at, &format!("{key} of {of}"), notes)
    });
    let ([young], [mut poisson]) = (young?, poisson?);
    if treatment == Materials::Repaired && poisson > LARGEST {
        notes.remarks.push(format!(
            "line {}: {of}: Poisson's ratio {poisson} is replaced by {LARGEST}",
            node.line
        ));
        poisson = LARGEST;
    }
    let shear = node.entry("G").and_then(Node::text).and_then(number);
    let expected = young / (2.0 * (1.0 + poisson));
    if let Some(shear) = shear.filter(|shear| (shear / expected - 1.0).abs() > OTHER_SHEAR) {
        notes.remarks.push(format!(
            "line {}: {of}: G is {shear:e} Pa, and E/(2 (1 + nu)) is {expected:.3e} Pa: E and nu are used",
            node.line
        ));
    }
    Some(format!("young = {young:?}\npoisson = {poisson:?}\n"))
}

fn orthotropic(node: &Node, of: &str, treatment: Materials, notes: &mut Notes) -> Option<String> {
    let lists = KEYS.map(|(key, _)| {
        let at = required(node, of, key, notes)?;
        values::<3>(at, &format!("{key} of {of}"), notes)
    });
    let [e, g, nu] = lists;
    let (e, g, mut nu) = (e?, g?, nu?);
    if treatment == Materials::Repaired && !is_possible(e, nu, 0.0) {
        let steps = (1..20).map(|i| 1.0 - REPAIR[0] * f64::from(i));
        let changed = |factor: f64| [nu[0], factor * nu[1], factor * nu[2]];
        let mut factors = steps.filter(|factor| is_possible(e, changed(*factor), REPAIR[1]));
        if let Some(factor) = factors.next() {
            nu = changed(factor);
            notes.remarks.push(format!(
                "line {}: {of}: no material can have these constants; nu13 and nu23 are \
                 multiplied by {factor:.2}",
                node.line
            ));
        }
    }
    let rows = KEYS.iter().zip([e, g, nu]);
    let row = |((_, keys), values): (&(&str, [&str; 3]), [f64; 3])| {
        let pairs = keys.iter().zip(values);
        pairs
            .map(|(key, value)| format!("{key} = {value:?}\n"))
            .collect::<String>()
    };
    Some(rows.map(row).collect())
}

/// Whether D is larger than a bound, and each pair of directions is possible.
fn is_possible([e1, e2, e3]: [f64; 3], [nu12, nu13, nu23]: [f64; 3], least: f64) -> bool {
    let squares = [
        nu12 * nu12 * e2 / e1,
        nu13 * nu13 * e3 / e1,
        nu23 * nu23 * e3 / e2,
    ];
    let determinant = 1.0 - squares.iter().sum::<f64>() - 2.0 * nu12 * nu13 * nu23 * e3 / e1;
    determinant > least && squares.iter().all(|square| *square < 1.0)
}

/// The table of strengths, if the file has any. Others, absent or zero, are so large that they do not
/// matter, which is a remark; through the thickness they have the defaults of the table.
fn strength(node: &Node, name: &str, is_orthotropic: bool, notes: &mut Notes) -> String {
    let mut read = |key: &str| -> Vec<f64> {
        let Some(at) = node.entry(key) else {
            return Vec::new();
        };
        match &at.value {
            Value::List(_) => numbers(at, key, &mut notes.problems).unwrap_or_default(),
            _ => at.text().and_then(number).into_iter().collect(),
        }
    };
    let lists = ["Xt", "Xc", "S"].map(&mut read);
    let at = |(list, index): (usize, usize)| {
        let value = lists[list].get(index).copied();
        value.filter(|value| *value > 0.0)
    };
    let needed: &[(&str, (usize, usize))] = if is_orthotropic {
        &NEEDED
    } else {
        &[
            ("tension", (0, 0)),
            ("compression", (1, 0)),
            ("shear", (2, 0)),
        ]
    };
    let unknown = needed.iter().filter(|(_, source)| at(*source).is_none());
    let unknown: Vec<&str> = unknown.map(|(key, _)| *key).collect();
    if unknown.len() == needed.len() {
        return String::new();
    }
    if !unknown.is_empty() {
        notes.remarks.push(format!(
            "line {}: material \"{name}\": no strength {} in Xt, Xc and S: such failure is not assessed",
            node.line,
            quoted(&unknown)
        ));
    }
    let needed = needed
        .iter()
        .map(|(key, source)| (*key, at(*source).unwrap_or(UNLIMITED)));
    let others = OTHERS.iter().filter(|_| is_orthotropic);
    let others = others.filter_map(|(key, source)| Some((*key, at(*source)?)));
    let rows = needed.chain(others);
    let rows = rows.map(|(key, value)| format!("{key} = {value:?}\n"));
    format!("\n[material.{}.strength]\n", basic_string(name)) + &rows.collect::<String>()
}

/// The slopes `m` of S-N lines, at the end of the table of strengths, if there is one; the stress `A` at
/// one cycle is the strength here. Values that are not used are remarks.
fn fatigue(
    node: &Node,
    (of, is_orthotropic): (&str, bool),
    has_strength: bool,
    notes: &mut Notes,
) -> String {
    let mut read = |key: &str| -> Vec<f64> {
        let Some(at) = node.entry(key) else {
            return Vec::new();
        };
        let list = match &at.value {
            Value::List(_) => numbers(at, key, &mut notes.problems).unwrap_or_default(),
            _ => at.text().and_then(number).into_iter().collect(),
        };
        // zeros are no value
        list.into_iter().filter(|value| *value != 0.0).collect()
    };
    let [slopes, intercepts] = ["m", "A"].map(&mut read);
    if !intercepts.is_empty() {
        notes.remarks.push(format!(
            "line {}: {of}: A is not used, S-N lines begin at the strengths",
            node.line
        ));
    }
    if slopes.is_empty() {
        return String::new();
    }
    if !has_strength {
        notes.remarks.push(format!(
            "line {}: {of}: m is not used without one of Xt, Xc and S",
            node.line
        ));
        return String::new();
    }
    let keys = ["m", "m_matrix"]
        .into_iter()
        .take(if is_orthotropic { 2 } else { 1 });
    let rows = keys.zip(slopes);
    rows.map(|(key, slope)| format!("{key} = {slope:?}\n"))
        .collect()
}

/// `N` numbers: one value, or a list; notes others.
fn values<const N: usize>(node: &Node, what: &str, notes: &mut Notes) -> Option<[f64; N]> {
    let list = match &node.value {
        Value::List(_) => numbers(node, what, &mut notes.problems)?,
        _ => node.text().and_then(number).into_iter().collect(),
    };
    let found = match list.len() {
        0 => node.kind(),
        count => format!("{count} numbers"),
    };
    let values = list.try_into().ok();
    if values.is_none() {
        let expected = match N {
            1 => "a number".to_owned(),
            _ => format!("a list of {N} numbers"),
        };
        let help = "E, G and nu are numbers, or lists of 3 of an orthotropic material";
        notes.wrong(node.line, [what, &found, &expected, help]);
    }
    values
}
