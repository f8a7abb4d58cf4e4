//! Materials and laminae, as tables of layup files.
//!
//! Axis 1 is along the fiber, 2 in the ply, 3 through it, as here. The stiffness of an anisotropic
//! material is in the order 11, 12, 13, 22, 23, 33 of the file.

use std::collections::HashMap;
use std::fmt::Write;
use std::path::PathBuf;

use shared_geom::exchange::text::number;

use super::super::Materials;
use super::super::constants::{Origin, checked};
use super::files::{Element, Notes};
use super::geometry::positive;

/// Constants of an orthotropic law.
const NINE: [&str; 9] = [
    "e1", "e2", "e3", "g12", "g13", "g23", "nu12", "nu13", "nu23",
];
/// Poisson's ratio across the fiber of a transversely isotropic material without it.
const ACROSS: f64 = 0.3;
/// Rows and columns of the stiffness in the order 11, 22, 33, 23, 13, 12.
const ORDER: [usize; 6] = [0, 3, 5, 4, 2, 1];
/// Names of the strengths, each with its other names.
const STRENGTHS: [(&str, [&str; 3]); 9] = [
    ("xt", ["xt", "t1", "x"]),
    ("xc", ["xc", "c1", "xc"]),
    ("yt", ["yt", "t2", "y"]),
    ("yc", ["yc", "c2", "yc"]),
    ("zt", ["zt", "t3", "z"]),
    ("zc", ["zc", "c3", "zc"]),
    ("s12", ["s", "s12", "s"]),
    ("s13", ["t", "s13", "t"]),
    ("s23", ["r", "s23", "r"]),
];

/// A material and a thickness.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Lamina {
    pub material: String,
    pub thickness: f64,
}

/// The materials and laminae of the files. Of two of one name the last one counts.
pub(super) struct Known<'x> {
    materials: HashMap<&'x str, Element<'x>>,
    laminae: HashMap<&'x str, Option<Lamina>>,
}

impl<'x> Known<'x> {
    /// Reads `<materials>`; notes problems of laminae.
    pub fn read(parts: &[Element<'x>], notes: &mut Notes) -> Self {
        let mut known = Self {
            materials: HashMap::new(),
            laminae: HashMap::new(),
        };
        for material in parts.iter().flat_map(|part| part.named("material")) {
            if let Some(name) = material.required_name(notes) {
                let is_again = known.materials.insert(name, material).is_some();
                notes.again(material, is_again);
            }
        }
        for lamina in parts.iter().flat_map(|part| part.named("lamina")) {
            if let Some(name) = lamina.required_name(notes) {
                let read = known.lamina_of(lamina, notes);
                let is_again = known.laminae.insert(name, read).is_some();
                notes.again(lamina, is_again);
            }
        }
        known
    }

    fn lamina_of(&self, element: Element<'x>, notes: &mut Notes) -> Option<Lamina> {
        let material = element.required("material", notes);
        let thickness = element.required("thickness", notes);
        let thickness = positive(thickness?.0, notes);
        let (at, material) = material?;
        if !self.has(&material, at, notes) {
            return None;
        }
        Some(Lamina {
            material,
            thickness: thickness?,
        })
    }

    /// Whether there is a material of a name; notes another name.
    pub fn has(&self, material: &str, at: Element<'_>, notes: &mut Notes) -> bool {
        let is_known = self.materials.contains_key(material);
        if !is_known {
            notes.unknown(at, ["the material", material], &self.names());
        }
        is_known
    }

    fn names(&self) -> Vec<&'x str> {
        let mut names: Vec<&str> = self.materials.keys().copied().collect();
        names.sort_unstable();
        names
    }

    /// The lamina of a name; notes another name.
    pub fn lamina(&self, name: &str, at: Element<'_>, notes: &mut Notes) -> Option<Lamina> {
        let Some(lamina) = self.laminae.get(name) else {
            let mut names: Vec<&str> = self.laminae.keys().copied().collect();
            names.sort_unstable();
            notes.unknown(at, ["the lamina", name], &names);
            return None;
        };
        lamina.clone()
    }

    /// The tables of the materials that are used; notes problems.
    pub fn constants(
        &self,
        used: &[&str],
        treatment: Materials,
        notes: &mut Notes,
    ) -> Option<String> {
        let mut text = String::from("units = \"SI\"\n");
        let mut origins = vec![None];
        let mut is_complete = true;
        for name in used {
            let element = self.materials.get(*name)?;
            match table(*element, name, notes) {
                Some(table) => text.push_str(&table),
                None => is_complete = false,
            }
            let origin: Origin = (PathBuf::from(element.file), element.line());
            origins.resize(text.lines().count(), Some(origin));
        }
        if treatment == Materials::Repaired {
            let remark = "materials of PreVABS are taken as given, without repair";
            notes.remarks.push(remark.to_owned());
        }
        let help = |_: &str| Some("correct the constants of the material");
        is_complete.then(|| checked(text, &origins, help, &mut notes.problems))?
    }
}

/// The table of a material; notes problems.
fn table(element: Element<'_>, name: &str, notes: &mut Notes) -> Option<String> {
    let density = match element
        .child("density")
        .filter(|one| !one.text().is_empty())
    {
        Some(one) => one.numbers::<1>(notes).map(|one| one[0]),
        None => {
            let remark = format!("{} has no density: 1 is taken", element.shown());
            notes.remarks.push(remark);
            Some(1.0)
        }
    };
    let Some(elastic) = element.child("elastic") else {
        let help = "write its constants in <elastic>";
        notes.wrong(
            element,
            [&element.shown(), "no <elastic>", "elastic constants", help],
        );
        return None;
    };
    let kind = element
        .attribute("type")
        .unwrap_or("isotropic")
        .to_lowercase();
    let law = match kind.as_str() {
        "" | "isotropic" => isotropic(elastic, notes),
        "orthotropic" | "engineering" => orthotropic(elastic, notes),
        "transversely isotropic" | "lamina" => across(elastic, element, notes),
        "anisotropic" => anisotropic(elastic, notes),
        _ => {
            let what = format!("type of {}", element.shown());
            let expected = "isotropic, transversely isotropic, orthotropic or anisotropic";
            let help = "correct the type";
            notes.wrong(element, [&what, &format!("\"{kind}\""), expected, help]);
            None
        }
    };
    let mut text = format!("\n[material.{name:?}]\n{}", law?);
    // writing to a string cannot fail
    let _ = writeln!(text, "density = {:?}", density?);
    let is_isotropic = matches!(kind.as_str(), "" | "isotropic");
    text += &strength(element, name, is_isotropic, notes);
    Some(text)
}

/// The required constants of names; notes those that are absent or no numbers.
fn values<const N: usize>(
    elastic: Element<'_>,
    names: [&str; N],
    notes: &mut Notes,
) -> Option<[f64; N]> {
    let read = names.map(|name| {
        let (at, _) = elastic.required(name, notes)?;
        at.numbers::<1>(notes).map(|one| one[0])
    });
    let all: Option<Vec<f64>> = read.into_iter().collect();
    all.and_then(|all| all.try_into().ok())
}

/// Rows `key = value`.
fn rows<'k>(keys: impl IntoIterator<Item = &'k str>, values: &[f64]) -> String {
    let pairs = keys.into_iter().zip(values);
    pairs
        .map(|(key, value)| format!("{key} = {value:?}\n"))
        .collect()
}

fn isotropic(elastic: Element<'_>, notes: &mut Notes) -> Option<String> {
    let found = values(elastic, ["e", "nu"], notes)?;
    Some(rows(["young", "poisson"], &found))
}

fn orthotropic(elastic: Element<'_>, notes: &mut Notes) -> Option<String> {
    let found = values(elastic, NINE, notes)?;
    Some(rows(NINE, &found))
}

/// Four constants, and defaults of the others: e3 = e2, nu13 = nu12, nu23 = 0.3, g13 = g12,
/// g23 = e3 / (2 (1 + nu23)).
fn across(elastic: Element<'_>, element: Element<'_>, notes: &mut Notes) -> Option<String> {
    let [e1, e2, g12, nu12] = values(elastic, ["e1", "e2", "g12", "nu12"], notes)?;
    let mut assumed = Vec::new();
    let mut given = |name: &'static str, default: f64| match elastic.child(name) {
        Some(one) => one.numbers::<1>(notes).map(|one| one[0]),
        None => {
            assumed.push(format!("{name} = {default}"));
            Some(default)
        }
    };
    let e3 = given("e3", e2)?;
    let nu13 = given("nu13", nu12)?;
    let nu23 = given("nu23", ACROSS)?;
    let g13 = given("g13", g12)?;
    let g23 = given("g23", e3 / (2.0 * (1.0 + nu23)))?;
    if !assumed.is_empty() {
        let assumed = assumed.join(", ");
        let remark = format!("{}: {assumed}, as PreVABS takes them", element.shown());
        notes.remarks.push(remark);
    }
    Some(rows(NINE, &[e1, e2, e3, g12, g13, g23, nu12, nu13, nu23]))
}

fn anisotropic(elastic: Element<'_>, notes: &mut Notes) -> Option<String> {
    let mut stiffness = [[0.0; 6]; 6];
    let mut is_complete = true;
    for i in 0..6 {
        for j in i..6 {
            let name = format!("c{}{}", i + 1, j + 1);
            let value = values(elastic, [name.as_str()], notes);
            is_complete &= value.is_some();
            let [value] = value.unwrap_or_default();
            stiffness[i][j] = value;
            stiffness[j][i] = value;
        }
    }
    let row = |i: usize| {
        let entries = ORDER.map(|j| format!("{:?}", stiffness[ORDER[i]][j]));
        format!("[{}]", entries.join(", "))
    };
    let all = [0, 1, 2, 3, 4, 5].map(row).join(", ");
    is_complete.then(|| format!("stiffness = [{all}]\n"))
}

/// The table of strengths for stress criteria, or of strain limits for strain criteria, with the
/// defaults of PreVABS; empty without them.
fn strength(element: Element<'_>, name: &str, is_isotropic: bool, notes: &mut Notes) -> String {
    let Some(given) = element.child("strength") else {
        return String::new();
    };
    let criterion = element
        .child("failure_criterion")
        .map(|one| one.text().to_lowercase());
    let criterion = criterion.unwrap_or_default();
    let is_strain = criterion == "2" || criterion.contains("strain");
    let table = if is_strain {
        "strain_limit"
    } else {
        "strength"
    };
    let found = |names: [&str; 3]| {
        let all = names.into_iter().find_map(|name| given.child(name));
        all.and_then(|one| number(&one.text()))
            .filter(|value| *value > 0.0)
    };
    let read = STRENGTHS.map(|(_, names)| found(names));
    let [xt, xc, yt, yc, zt, zc, s12, s13, s23] = read;
    let xc = xc.or(xt);
    let head = format!("\n[material.{name:?}.{table}]\n");
    let needed = [xt, xc, s12];
    let [Some(xt), Some(xc), Some(s12)] = needed else {
        if is_isotropic && !is_strain && (criterion == "5" || criterion.contains("mises")) {
            return xt.map_or_else(String::new, |xt| head + &rows(["yield"], &[xt]));
        }
        let remark = format!(
            "{}: its strengths are not taken, s or xt is absent",
            element.shown()
        );
        notes.remarks.push(remark);
        return String::new();
    };
    if is_isotropic {
        return head + &rows(["tension", "compression", "shear"], &[xt, xc, s12]);
    }
    let yt = yt.unwrap_or(xt);
    let yc = yc.unwrap_or(xt);
    let zt = zt.unwrap_or(yt);
    let all = [
        xt,
        xc,
        yt,
        yc,
        zt,
        zc.unwrap_or(zt),
        s12,
        s13.unwrap_or(s12),
        s23.unwrap_or(0.25 * (yt + yc)),
    ];
    head + &rows(STRENGTHS.iter().map(|one| one.0), &all)
}
