//! Distributed loads as written: `[[load.NAME.traction]]` on curves of the mesh and
//! `[[load.NAME.volume]]` in its regions.

use nalgebra::Vector3;
use shared_geom::document::{Document, Table};
use shared_geom::mesh::Mesh;
use shared_geom::units::Dimension;

use super::groups;
use super::laminae::{self, Faces, WrittenLamina};
use super::regions::{Written, name};
use crate::mesh::{Bank, CurveSide, SectionMesh};
use crate::section::{Action, DistributedForce, DistributedLoad, Traction, VolumeForce};

mod problem;
mod words;

pub use problem::DistributedProblem;

/// Largest number of coefficients of a polynomial: a degree of eight.
pub(super) const MOST_COEFFICIENTS: usize = 9;

/// Largest component \[Pa, N/m^3, m/s^2\] and coefficient: far beyond all structures; the
/// squares of the stresses are still finite.
const LARGEST: f64 = 1e20;

/// The distributed parts of a load as far as they could be read.
#[derive(Debug, Clone, Default)]
pub(super) struct WrittenDistribution {
    parts: Vec<WrittenPart>,
    /// Whether the load has distributed parts, read or not.
    is_written: bool,
}

/// A part, whose curve or region is not yet compared with the mesh; unreadable values are
/// missing.
#[derive(Debug, Clone)]
struct WrittenPart {
    location: WrittenLocation,
    along: Option<Vec<f64>>,
}

#[derive(Debug, Clone)]
enum WrittenLocation {
    Curve(Option<Written>, Option<Traction>),
    /// A region, or the whole section.
    Region(Option<Option<Written>>, Option<VolumeForce>),
}

/// Data in which names of loads are looked up.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lookup<'a> {
    pub document: &'a Document,
    /// The mesh as in its file, with the laminates.
    pub mesh: &'a Mesh,
    /// The same mesh in meters, if it is sound.
    pub section_mesh: Option<&'a SectionMesh>,
    pub laminae: &'a [WrittenLamina],
    /// The faces of laminates.
    pub faces: &'a Faces,
}

/// Reads the distributed parts of the load in `table`; notes problems.
pub(super) fn read(table: &Table<'_>) -> WrittenDistribution {
    let mut parts = Vec::new();
    for part in table.tables("traction") {
        parts.push(traction(&part));
        part.finish();
    }
    for part in table.tables("volume") {
        parts.push(volume(&part));
        part.finish_beside(&[("group", "\"region\"")]);
    }
    let is_written = |key: &str| table.has(key) && table.row_count(key) != Some(0);
    let is_written = ["traction", "volume"].into_iter().any(is_written);
    WrittenDistribution { parts, is_written }
}

fn traction(table: &Table<'_>) -> WrittenPart {
    let curve = name(table, "curve", "the name of a physical curve");
    let along = along(table);
    let pressure = number(table, "pressure").map(Traction::Pressure);
    let tangential = number(table, "tangential").map(Traction::Tangential);
    let force = vector(table, "force", Dimension::STRESS).map(Traction::Force);
    let found = [
        ("pressure", pressure),
        ("tangential", tangential),
        ("force", force),
    ];
    let expected = "\"pressure\", \"tangential\" or \"force\"";
    let traction = only(table, "traction", expected, found);
    if traction.is_some_and(|traction| traction.size() == 0.0) {
        note_zero(table, "traction");
    }
    WrittenPart {
        location: WrittenLocation::Curve(curve, traction),
        along,
    }
}

fn note_zero(table: &Table<'_>, part: &'static str) {
    table.note("", &DistributedProblem::Zero { part });
}

fn volume(table: &Table<'_>) -> WrittenPart {
    let region = match table.has("region") {
        true => name(table, "region", "the name of a physical surface").map(Some),
        false => Some(None),
    };
    let along = along(table);
    let force = vector(table, "force", Dimension::FORCE_PER_VOLUME).map(VolumeForce::Force);
    let acceleration = vector(table, "acceleration", Dimension::ACCELERATION);
    let acceleration = acceleration.map(VolumeForce::Acceleration);
    let found = [("force", force), ("acceleration", acceleration)];
    let force = only(
        table,
        "volume force",
        "\"force\" or \"acceleration\"",
        found,
    );
    if force.is_some_and(|force| force.size(1.0) == 0.0) {
        note_zero(table, "volume force");
    }
    WrittenPart {
        location: WrittenLocation::Region(region, force),
        along,
    }
}

/// The given one of several forces; otherwise the problem is noted. Unreadable forces
/// have been reported.
fn only<T, const N: usize>(
    table: &Table<'_>,
    part: &'static str,
    expected: &'static str,
    found: [(&'static str, Option<T>); N],
) -> Option<T> {
    let given: Vec<_> = found
        .into_iter()
        .filter(|(key, _)| table.has(key))
        .collect();
    match &given[..] {
        [] => table.note("", &DistributedProblem::NoForce { part, expected }),
        [_] => {}
        [(first, _), (second, _), ..] => {
            let (first, second) = (*first, *second);
            let problem = DistributedProblem::TwoForces {
                part,
                first,
                second,
            };
            table.note(second, &problem);
            return None;
        }
    }
    given.into_iter().next().and_then(|(_, force)| force)
}

/// A stress under `key`, if present.
fn number(table: &Table<'_>, key: &str) -> Option<f64> {
    if !table.has(key) {
        return None;
    }
    let value = table.quantity(key, Dimension::STRESS)?;
    checked(table, key, &[value]).then_some(value)
}

fn vector(table: &Table<'_>, key: &str, dimension: Dimension) -> Option<Vector3<f64>> {
    if !table.has(key) {
        return None;
    }
    let value = table.vector(key, dimension)?;
    checked(table, key, value.as_slice()).then_some(value)
}

/// Coefficients of the polynomial along the beam, per power of a meter; 1 if not given.
fn along(table: &Table<'_>) -> Option<Vec<f64>> {
    if !table.has("along") {
        return Some(vec![1.0]);
    }
    let expected = format!("an array of 1 to {MOST_COEFFICIENTS} numbers, not all zero");
    let coefficients = match table.is_list("along") {
        true => table.quantities("along", Dimension::NUMBER)?,
        false => Vec::new(),
    };
    let count = coefficients.len();
    if !(1..=MOST_COEFFICIENTS).contains(&count) || coefficients.iter().all(|c| *c == 0.0) {
        table.wrong("along", &expected);
        return None;
    }
    let unit = table.document().factor(Dimension::LENGTH);
    let powers = (0..).map(|power| unit.powi(power));
    let in_si = coefficients.iter().zip(powers).map(|(c, unit)| c / unit);
    let in_si: Vec<f64> = in_si.collect();
    checked(table, "along", &in_si).then_some(in_si)
}

/// Checks that no number is beyond all structures.
fn checked(table: &Table<'_>, key: &str, values: &[f64]) -> bool {
    let large = values.iter().position(|value| value.abs() > LARGEST);
    if let Some(entry) = large {
        let problem = DistributedProblem::Large {
            key: key.to_owned(),
            entry: (values.len() > 1).then_some(entry + 1),
            value: values[entry],
            limit: LARGEST,
        };
        table.note(key, &problem);
    }
    large.is_none()
}

impl WrittenDistribution {
    /// Whether the load has no distributed part.
    pub fn is_empty(&self) -> bool {
        !self.is_written
    }

    /// The load on the mesh; `None` if it has a problem, which has been noted.
    pub fn on_mesh(&self, lookup: Lookup<'_>) -> Option<DistributedLoad> {
        // all parts are checked before the first wrong one ends the search
        let parts: Vec<_> = self.parts.iter().map(|part| part.on_mesh(lookup)).collect();
        let parts: Option<Vec<_>> = parts.into_iter().collect();
        Some(DistributedLoad {
            parts: parts?.concat(),
        })
    }
}

impl WrittenPart {
    /// The part on the mesh: one for each ply if a laminate is named.
    fn on_mesh(&self, lookup: Lookup<'_>) -> Option<Vec<DistributedForce>> {
        // the names are looked up even if the values are wrong
        let actions = match &self.location {
            WrittenLocation::Curve(curve, traction) => {
                let found = sides(lookup, curve.as_ref()?, traction.as_ref());
                let (sides, traction) = (found?, (*traction)?);
                vec![Action::Traction { sides, traction }]
            }
            WrittenLocation::Region(region, force) => {
                let groups = match region.as_ref()? {
                    Some(region) => groups_of(lookup, region)?.into_iter().map(Some).collect(),
                    None => vec![None],
                };
                let force = (*force)?;
                let volume = |group| Action::Volume { group, force };
                groups.into_iter().map(volume).collect()
            }
        };
        let along = self.along.as_ref()?;
        let force = |action| DistributedForce {
            action,
            along: along.clone(),
        };
        Some(actions.into_iter().map(force).collect())
    }
}

/// The sides on the curve that `written` names.
fn sides(
    lookup: Lookup<'_>,
    written: &Written,
    traction: Option<&Traction>,
) -> Option<Vec<CurveSide>> {
    let Lookup {
        document,
        mesh,
        faces,
        ..
    } = lookup;
    if faces.is_open(&written.text) {
        return None;
    }
    let group = groups::curve(document, mesh, written)?;
    let label = mesh.groups[group].label();
    let section_mesh = lookup.section_mesh?;
    let curve = section_mesh.curves.iter().find(|c| c.label == label)?;
    let sides = match section_mesh.sides_of_curve(curve) {
        Ok(sides) => sides,
        Err(line) => {
            let problem = DistributedProblem::NoSide {
                curve: written.text.clone(),
                line: line.tag,
                at: [0, 1].map(|axis| 0.5 * (line.first[axis] + line.second[axis])),
                faces: faces.on(&label),
            };
            document.note(written.line, &problem);
            return None;
        }
    };
    let inside = sides.iter().find(|side| side.bank == Bank::Both);
    match (traction, inside) {
        (Some(Traction::Pressure(_)), Some(side)) => {
            let problem = DistributedProblem::Inside {
                curve: written.text.clone(),
                line: side.tag,
                faces: faces.on(&label),
            };
            document.note(written.line, &problem);
            None
        }
        _ => Some(sides),
    }
}

/// The region that `written` names, or the regions of the plies of a laminate: their
/// indices in the groups of the section mesh.
pub(super) fn groups_of(lookup: Lookup<'_>, written: &Written) -> Option<Vec<usize>> {
    if lookup.faces.is_open(&written.text) {
        return None;
    }
    let plies = laminae::plies_of(lookup.laminae, &written.text);
    let found = plies.iter().map(|ply| {
        let text = ply.clone();
        let line = written.line;
        group(lookup, &Written { text, line })
    });
    match plies.is_empty() {
        true => Some(vec![group(lookup, written)?]),
        false => found.collect(),
    }
}

/// The region that `written` names: its index in the groups of the section mesh.
fn group(lookup: Lookup<'_>, written: &Written) -> Option<usize> {
    let Lookup { document, mesh, .. } = lookup;
    let group = groups::surface(document, mesh, written)?;
    let label = mesh.groups[group].label();
    let known = &lookup.section_mesh?.groups;
    let found = known.iter().position(|known| *known == label);
    if found.is_none() {
        let problem = DistributedProblem::NoRegion {
            group: written.text.clone(),
            known: known.clone(),
        };
        document.note(written.line, &problem);
    }
    found
}
