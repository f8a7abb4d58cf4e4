//! Distributed loads as written: `[[load.NAME.traction]]` on curves of the mesh and
//! `[[load.NAME.volume]]` in its regions.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{Name, Numbers, Quantity, Tables, Vector};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::document::{Document, Key, NestedList, Table};
use shared_geom::keys;
use shared_geom::mesh::Mesh;
use shared_geom::units::Dimension;

use super::groups;
use super::laminae::{self, Faces, WrittenLamina};
use super::regions::Written;
use crate::mesh::{Bank, CurveSide, SectionMesh};
use crate::section::{Action, DistributedForce, DistributedLoad, Traction, VolumeForce};

mod problem;
mod words;

pub use problem::DistributedProblem;

keys! {
    /// Forces on surfaces of the beam, which act along it.
    pub(super) TRACTIONS: NestedList = "traction", [Tables(&TRACTION)], optional, "";
    /// Forces in the volume of the beam, which act along it.
    pub(super) VOLUMES: NestedList = "volume", [Tables(&VOLUME)], optional, "";
    /// The name of a physical curve, or its tag, along sides of cells; a face of a lamina is
    /// "NAME/outer", or "NAME/left" and "NAME/right" if it is centered.
    CURVE: Written = "curve", [Name], required, "\"top\"";
    /// Coefficients c0, c1, c2, ... of the polynomial c0 + c1 x + c2 x^2 + ... that multiplies the
    /// force, x along the beam from this section in the declared unit of length.
    ALONG: Vec<f64> = "along", [Numbers(MOST_COEFFICIENTS)]
        as "an array of 1 to 9 numbers, not all zero", or "[1]" = vec![1.0], "[1, 0.5]";
    /// Pressure on the surface; suction is negative.
    PRESSURE: f64 = "pressure", [Quantity(Dimension::STRESS)], required, "\"2 kPa\"";
    /// Force per area in the direction of the lines of the curve.
    TANGENTIAL: f64 = "tangential", [Quantity(Dimension::STRESS)], required, "\"300 Pa\"";
    /// Force per area along x, y and z.
    FORCE: Vector3<f64> = "force", [Vector(3, Dimension::STRESS)], required, "[0, 0, \"-2 kPa\"]";
    /// The name of the loaded physical surface, or its tag, or the name of a lamina, for all its
    /// plies.
    REGION: Option<Written> = "region", [Name] as "the name of a physical surface",
        or "the whole section", "\"skin\"";
    /// Force per volume along x, y and z.
    FORCE_PER_VOLUME: Vector3<f64> = "force", [Vector(3, Dimension::FORCE_PER_VOLUME)], required,
        "[0, 0, \"-12 kN/m^3\"]";
    /// Acceleration along x, y and z.
    ACCELERATION: Vector3<f64> = "acceleration", [Vector(3, Dimension::ACCELERATION)], required,
        "[0, 0, -9.81]";
}

const TRACTION: TableSchema = TableSchema {
    title: "[[load.NAME.traction]]",
    meaning: "A force per area on the surface that a curve of the mesh makes along the beam, \
              constant along the curve.",
    keys: &[CURVE.schema, ALONG.schema],
    families: &[
        Family {
            name: "pressure",
            meaning: "Normal to the surface; not on a curve with cells on both sides.",
            keys: &[PRESSURE.schema],
        },
        Family {
            name: "tangential",
            meaning: "Along the curve, in the plane of the section.",
            keys: &[TANGENTIAL.schema],
        },
        Family {
            name: "force",
            meaning: "In section axes.",
            keys: &[FORCE.schema],
        },
    ],
};

const VOLUME: TableSchema = TableSchema {
    title: "[[load.NAME.volume]]",
    meaning: "A force per volume, constant in its regions or proportional to the density.",
    keys: &[REGION.schema, ALONG.schema],
    families: &[
        Family {
            name: "force",
            meaning: "Given as it is.",
            keys: &[FORCE_PER_VOLUME.schema],
        },
        Family {
            name: "acceleration",
            meaning: "Density times acceleration: weight, or the centrifugal force outward.",
            keys: &[ACCELERATION.schema],
        },
    ],
};

/// Largest number of coefficients of a polynomial: a degree of eight.
const MOST_COEFFICIENTS: usize = 9;

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
    let tractions = table.each(&TRACTIONS, |part| Some(traction(part)));
    let mut parts = tractions.unwrap_or_default();
    for part in table.tables(&VOLUMES) {
        parts.push(volume(&part));
        part.finish_beside(&[("group", "\"region\"")]);
    }
    let is_written = |key| table.has(key) && table.row_count(key) != Some(0);
    let is_written = [&TRACTIONS, &VOLUMES].into_iter().any(is_written);
    WrittenDistribution { parts, is_written }
}

fn traction(table: &Table<'_>) -> WrittenPart {
    let curve = table.get(&CURVE);
    let along = along(table);
    let found = [
        number(table, &PRESSURE, Traction::Pressure),
        number(table, &TANGENTIAL, Traction::Tangential),
        vector(table, &FORCE, Traction::Force),
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
    let region = table.get(&REGION);
    let along = along(table);
    let found = [
        vector(table, &FORCE_PER_VOLUME, VolumeForce::Force),
        vector(table, &ACCELERATION, VolumeForce::Acceleration),
    ];
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

/// A key and the force under it, if present.
fn number<T>(
    table: &Table<'_>,
    key: &Key<f64>,
    force: impl Fn(f64) -> T,
) -> (&'static str, Option<T>) {
    let value = table.given(key);
    let value = value.filter(|value| checked(table, key.name(), &[*value]));
    (key.name(), value.map(force))
}

/// As [`number`], for a vector.
fn vector<T>(
    table: &Table<'_>,
    key: &Key<Vector3<f64>>,
    force: impl Fn(Vector3<f64>) -> T,
) -> (&'static str, Option<T>) {
    let value = table.given(key);
    let value = value.filter(|value| checked(table, key.name(), value.as_slice()));
    (key.name(), value.map(force))
}

/// Coefficients of the polynomial along the beam, per power of a meter.
fn along(table: &Table<'_>) -> Option<Vec<f64>> {
    let is_right = |coefficients: &Vec<f64>| coefficients.iter().any(|c| *c != 0.0);
    let coefficients = table.get_if(&ALONG, is_right, ALONG.schema.expected)?;
    let unit = table.document().factor(Dimension::LENGTH);
    let powers = (0..).map(|power| unit.powi(power));
    let in_si = coefficients.iter().zip(powers).map(|(c, unit)| c / unit);
    let in_si: Vec<f64> = in_si.collect();
    checked(table, ALONG.name(), &in_si).then_some(in_si)
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
    if plies.is_empty() {
        Some(vec![group(lookup, written)?])
    } else {
        found.collect()
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
