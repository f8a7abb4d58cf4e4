//! Laminates along curves as written, and their cells in the mesh.

use shared_geom::document::schema::ValueKind::{Name, Positive, Quantity, Tables, Text, Word};
use shared_geom::document::schema::{Family, KeySchema, TableSchema};
use shared_geom::document::{Document, NestedList, Table};
use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::keys;
use shared_geom::mesh::{Mesh, PhysicalGroup};
use shared_geom::units::Dimension;

use super::groups;
use super::problem::InputProblem;
use super::regions::{Angle, MATERIAL, Written, WrittenAngle, WrittenRegion};
use crate::mesh::{
    DoubledNodes, Lamina, LaminaProblem, LaminaSide, Laminated, MeshReport, SectionMesh, of_laminae,
};
use crate::section::CellMaterial;

mod faces;

pub(super) use faces::{Faces, add_with_faces};

keys! {
    /// Laminates along physical curves of the mesh, next to cells or without.
    pub(super) LAMINAE: NestedList = "lamina", [Tables(&LAMINA)], optional, "";
    /// The name of a physical curve, or its tag.
    CURVE: Written = "curve", [Name], required, "\"outer\"";
    /// Name in reports and tables; several plies are NAME/1, NAME/2 and so on.
    NAME: Option<Written> = "name", [Text], or "name of the curve", "\"skin\"";
    /// Side of the line on which the plies lie, seen along it.
    SIDE: Option<usize> = "side", [Word(&["left", "right", "center"])],
        or "the side without cells; \"center\" if no cells are adjacent", "\"left\"";
    /// The plies from the line outward; with side = "center" from right to left.
    PLIES: NestedList = "plies", [Tables(&PLY)], required, "";
    /// Thickness of the ply.
    THICKNESS: f64 = "thickness", [Positive(Dimension::LENGTH)], required, "\"0.2 mm\"";
    /// Angle of the fiber from x toward the direction of the line.
    FIBER_ANGLE: Angle = "fiber_angle", [Quantity(Dimension::ANGLE)], or "0" = Angle(0.0), "45";
}

/// The keys of a ply, which exclude a list of plies.
const ONE_PLY: &[KeySchema] = &[MATERIAL.schema, THICKNESS.schema, FIBER_ANGLE.schema];

const LAMINA: TableSchema = TableSchema {
    title: "[[lamina]]",
    meaning: "Plies along a physical curve of the mesh: each line becomes cells with the \
              thickness of a ply.",
    keys: &[CURVE.schema, NAME.schema, SIDE.schema],
    families: &[
        Family {
            name: "plies",
            meaning: "A list of plies.",
            keys: &[PLIES.schema],
        },
        Family {
            name: "one ply",
            meaning: "A single ply.",
            keys: ONE_PLY,
        },
    ],
};

const PLY: TableSchema = TableSchema {
    title: "plies = [{ ... }]",
    meaning: "A ply of a laminate.",
    keys: ONE_PLY,
    families: &[],
};

/// The sides, parallel to the words of [`SIDE`].
const SIDES: [LaminaSide; 3] = [LaminaSide::Left, LaminaSide::Right, LaminaSide::Center];

/// `[[lamina]]` as far as it could be read.
#[derive(Debug, Clone)]
pub(super) struct WrittenLamina {
    curve: Option<Written>,
    /// Name of its regions; without it the name of the curve.
    name: Option<Written>,
    side: Option<LaminaSide>,
    /// From the line outward, or from right to left; `None` if a problem leaves their
    /// number unknown.
    plies: Option<Vec<WrittenPly>>,
}

#[derive(Debug, Clone)]
struct WrittenPly {
    line: usize,
    material: Option<Written>,
    /// Positive \[m\].
    thickness: Option<f64>,
    /// Angle of the fiber from x towards the line \[rad\].
    fiber_angle: Option<f64>,
}

/// Reads every `[[lamina]]`.
pub(super) fn read(root: &Table<'_>) -> Vec<WrittenLamina> {
    let laminae = root.each(&LAMINAE, |table| {
        Some(WrittenLamina {
            curve: table.get(&CURVE),
            name: own_name(table),
            side: table.get(&SIDE).flatten().map(|side| SIDES[side]),
            plies: plies(table),
        })
    });
    laminae.unwrap_or_default()
}

fn own_name(table: &Table<'_>) -> Option<Written> {
    let is_right = |name: &Option<Written>| name.as_ref().is_none_or(Written::is_line);
    let expected = "a text of one line, without control characters";
    table.get_if(&NAME, is_right, expected).flatten()
}

/// The plies: a list of them, or the table itself as the only ply.
fn plies(table: &Table<'_>) -> Option<Vec<WrittenPly>> {
    // All keys are read, so that none of them is reported as unknown.
    let own: Vec<_> = ONE_PLY.iter().filter(|key| table.has(key)).collect();
    match (table.has(&PLIES), own.first()) {
        (true, Some(key)) => {
            let key = key.name;
            table.note(key, &InputProblem::PliesAndPly { key });
            None
        }
        (true, None) => {
            let plies = table.each(&PLIES, |table| Some(ply(table)));
            if table.row_count(&PLIES) == Some(0) {
                table.wrong(&PLIES, "at least one ply");
            }
            plies.filter(|plies| !plies.is_empty())
        }
        (false, None) => {
            table.note("", &InputProblem::NoPlies);
            None
        }
        (false, Some(_)) => Some(vec![ply(table)]),
    }
}

fn ply(table: &Table<'_>) -> WrittenPly {
    WrittenPly {
        line: table.line(),
        material: table.get(&MATERIAL),
        thickness: table.get(&THICKNESS),
        fiber_angle: table.get(&FIBER_ANGLE).map(|angle| angle.0),
    }
}

impl WrittenLamina {
    /// Its name, or the name of its curve.
    fn called(&self) -> Option<&str> {
        let name = self.name.as_ref().or(self.curve.as_ref());
        name.map(|name| name.text.as_str())
    }

    /// Names of its regions: its name, with a number for each of several plies.
    fn labels(&self) -> Vec<String> {
        let name = self.called().unwrap_or("?");
        let count = self.plies.as_ref().map_or(0, Vec::len);
        match count {
            1 => vec![name.to_owned()],
            _ => (1..=count)
                .map(|number| format!("{name}/{number}"))
                .collect(),
        }
    }

    /// Line of its name.
    fn line(&self) -> usize {
        let written = self.name.as_ref().or(self.curve.as_ref());
        written.map_or(0, |written| written.line)
    }
}

/// Names of the plies of the laminate `name`, if it has several.
pub(super) fn plies_of(laminae: &[WrittenLamina], name: &str) -> Vec<String> {
    let is_named = |lamina: &&WrittenLamina| {
        let own = lamina.name.as_ref().or(lamina.curve.as_ref());
        own.is_some_and(|own| own.text == name)
    };
    let labels = laminae.iter().find(is_named).map(WrittenLamina::labels);
    labels.filter(|labels| labels.len() > 1).unwrap_or_default()
}

/// A region for each ply of each laminate, in their order.
pub(super) fn regions(laminae: &[WrittenLamina]) -> Vec<WrittenRegion> {
    let of_lamina = |lamina: &WrittenLamina| -> Vec<WrittenRegion> {
        let plies = lamina.plies.iter().flatten();
        let follow = lamina.curve.as_ref().map(|curve| WrittenAngle::Follow {
            curve: curve.clone(),
            reverse: false,
        });
        let region = |(ply, text): (&WrittenPly, String)| WrittenRegion {
            line: ply.line,
            group: Some(Written {
                text,
                line: ply.line,
            }),
            material: ply.material.clone(),
            fiber_angle: ply.fiber_angle.map(WrittenAngle::Constant),
            plane_angle: follow.clone(),
        };
        plies.zip(lamina.labels()).map(region).collect()
    };
    laminae.iter().flat_map(of_lamina).collect()
}

/// Adds the cells of the laminates to the mesh, whose unit of length is
/// `meters_per_unit`, and their faces; without cells if a problem was noted.
pub(super) fn add(
    document: &Document,
    mesh: &mut Mesh,
    laminae: &[WrittenLamina],
    meters_per_unit: f64,
) -> Added {
    let found = found(document, mesh, laminae, meters_per_unit);
    let names = Names::check(document, mesh, laminae, &found);
    let found: Option<Vec<Lamina>> = found.into_iter().collect();
    let made = found.filter(|_| names.are_free).and_then(|mut found| {
        add_groups(mesh, laminae, &mut found);
        let (laminated, faces) = made(document, mesh, laminae, &found)?;
        Some((Made { found, laminated }, faces))
    });
    match made {
        Some((made, faces)) if names.are_distinguished(document) => Added {
            cells: Some(made),
            faces,
        },
        _ => Added {
            cells: None,
            faces: Faces::unknown(laminae),
        },
    }
}

/// Names of the laminates.
pub(super) fn names_of(laminae: &[WrittenLamina]) -> Vec<Option<String>> {
    let names = laminae.iter().map(WrittenLamina::called);
    names.map(|name| name.map(str::to_owned)).collect()
}

/// The laminates and their cells.
#[derive(Debug)]
pub(super) struct Made {
    pub found: Vec<Lamina>,
    pub laminated: Laminated,
}

/// Result of [`add`].
#[derive(Debug)]
pub(super) struct Added {
    /// `None` if a problem was noted.
    pub cells: Option<Made>,
    pub faces: Faces,
}

impl Added {
    /// The cells, if they could be made.
    pub fn laminated(&self) -> Option<&Laminated> {
        self.cells.as_ref().map(|made| &made.laminated)
    }

    /// The mesh with the laminates in meters, if it is sound; problems of plies are noted
    /// at their lines, all others at the mesh.
    pub fn checked(
        &self,
        document: &Document,
        mesh: &Mesh,
        laminae: &[WrittenLamina],
        (unit, doubled_nodes, position): (f64, DoubledNodes, &SourceLocation),
    ) -> Option<(SectionMesh, MeshReport)> {
        // without its laminates the section may be in separate parts
        let made = self.cells.as_ref()?;
        let problems = match SectionMesh::checked(mesh, unit, doubled_nodes) {
            Ok(checked) => return Some(checked),
            Err(problems) => problems,
        };
        let (own, reported) = of_laminae(mesh, &made.found, &made.laminated, problems);
        note(document, laminae, reported);
        let mut diagnostics = Diagnostics::new();
        for problem in &own {
            diagnostics.push(position.clone(), problem);
        }
        document.keep::<()>(diagnostics.into_result(()));
        None
    }
}

/// Notes problems of laminates at the lines of their curves.
fn note(document: &Document, laminae: &[WrittenLamina], problems: Vec<(usize, LaminaProblem)>) {
    for (lamina, problem) in problems {
        let line = laminae[lamina].curve.as_ref().map_or(0, |curve| curve.line);
        document.note(line, &problem);
    }
}

/// The laminates on the curves of the mesh, as far as they are known; all of them are
/// checked.
fn found(
    document: &Document,
    mesh: &Mesh,
    laminae: &[WrittenLamina],
    meters_per_unit: f64,
) -> Vec<Option<Lamina>> {
    let of_mesh = |lamina: &WrittenLamina| {
        let curve = groups::curve(document, mesh, lamina.curve.as_ref()?)?;
        let plies = lamina.plies.as_ref()?.iter();
        let thicknesses = plies.map(|ply| Some(ply.thickness? / meters_per_unit));
        Some(Lamina {
            curve,
            side: lamina.side,
            thicknesses: thicknesses.collect::<Option<_>>()?,
            groups: Vec::new(),
        })
    };
    laminae.iter().map(of_mesh).collect()
}

/// Adds a physical surface for each ply.
fn add_groups(mesh: &mut Mesh, laminae: &[WrittenLamina], found: &mut [Lamina]) {
    for (lamina, written) in found.iter_mut().zip(laminae) {
        for label in written.labels() {
            lamina.groups.push(mesh.groups.len());
            let tags = mesh.groups.iter().map(|group| group.tag);
            let tag = tags.max().unwrap_or(0).saturating_add(1);
            mesh.groups.push(PhysicalGroup {
                dimension: 2,
                tag,
                name: Some(label),
            });
        }
    }
}

fn made(
    document: &Document,
    mesh: &mut Mesh,
    laminae: &[WrittenLamina],
    found: &[Lamina],
) -> Option<(Laminated, Faces)> {
    match add_with_faces(mesh, &names_of(laminae), found) {
        Ok(made) => Some(made),
        Err(problems) => {
            note(document, laminae, problems);
            None
        }
    }
}

/// Names of laminates, with their conflicts.
struct Names {
    /// Whether no name conflict was noted.
    are_free: bool,
    /// Lines and names of unnamed laminates on a curve shared with another laminate: the
    /// fit of the laminates is checked first.
    twice: Vec<(usize, String)>,
}

impl Names {
    /// Notes names that surfaces or other laminates have; names from unknown curves are
    /// ignored.
    fn check(
        document: &Document,
        mesh: &Mesh,
        laminae: &[WrittenLamina],
        found: &[Option<Lamina>],
    ) -> Self {
        let surfaces = mesh.groups.iter().filter(|group| group.dimension == 2);
        let surfaces: Vec<String> = surfaces.map(PhysicalGroup::label).collect();
        let mut taken: Vec<(String, Option<&str>)> =
            surfaces.into_iter().map(|label| (label, None)).collect();
        let mut names = Self {
            are_free: true,
            twice: Vec::new(),
        };
        for (lamina, found) in laminae.iter().zip(found) {
            if lamina.name.is_none() && found.is_none() {
                continue;
            }
            // the curve that gives the name, if any
            let curve = lamina.curve.as_ref().filter(|_| lamina.name.is_none());
            let curve = curve.map(|curve| curve.text.as_str());
            let labels = lamina.labels();
            let same = taken.iter().find(|(label, _)| labels.contains(label));
            match same {
                None => {}
                Some((name, of)) if curve.is_some() && *of == curve => {
                    names.twice.push((lamina.line(), name.clone()));
                }
                Some((name, _)) => {
                    let name = name.clone();
                    document.note(lamina.line(), &InputProblem::LaminaName { name });
                    names.are_free = false;
                }
            }
            taken.extend(labels.into_iter().map(|label| (label, curve)));
        }
        names
    }

    /// Notes laminates on one curve that have the same name.
    fn are_distinguished(self, document: &Document) -> bool {
        let is_reported = self.twice.is_empty();
        for (line, name) in self.twice {
            document.note(line, &InputProblem::LaminaName { name });
        }
        is_reported
    }
}

/// The index of the region of each cell of the laminates, in the list of [`regions`].
pub(super) fn region_of_cells(laminae: &[WrittenLamina], laminated: &Laminated) -> Vec<usize> {
    let mut first = Vec::with_capacity(laminae.len());
    let mut count = 0;
    for lamina in laminae {
        first.push(count);
        count += lamina.plies.as_ref().map_or(0, Vec::len);
    }
    let cells = laminated.cells.iter();
    cells.map(|cell| first[cell.lamina] + cell.ply).collect()
}

/// The tag of the line of each cell of the laminates.
pub(super) fn lines_of_cells(laminated: &Laminated) -> Vec<u64> {
    laminated.cells.iter().map(|cell| cell.line).collect()
}

/// Material and angles of the cells of the laminates; `materials` are the materials of
/// their regions.
pub(super) fn cells(
    laminae: &[WrittenLamina],
    laminated: &Laminated,
    materials: &[usize],
) -> Option<Vec<CellMaterial>> {
    let regions = region_of_cells(laminae, laminated);
    let cells = laminated.cells.iter().zip(regions).map(|(cell, region)| {
        let ply = laminae[cell.lamina].plies.as_ref()?.get(cell.ply)?;
        Some(CellMaterial {
            material: *materials.get(region)?,
            fiber_angle: ply.fiber_angle?,
            plane_angle: cell.direction,
        })
    });
    cells.collect()
}
