//! Laminates along curves as written, and their cells in the mesh.

use shared_geom::document::{Document, Table};
use shared_geom::mesh::{Mesh, PhysicalGroup};
use shared_geom::units::Dimension;

use super::groups;
use super::problem::InputProblem;
use super::regions::{Written, WrittenAngle, WrittenRegion, constant_angle, name};
use crate::mesh::{Lamina, LaminaSide, Laminated, add_laminae};
use crate::section::CellMaterial;

const SIDES: [LaminaSide; 3] = [LaminaSide::Left, LaminaSide::Right, LaminaSide::Center];
/// Keys of a laminate of one ply, which exclude a list of plies.
const ONE_PLY: [&str; 3] = ["material", "thickness", "fiber_angle"];

/// `[[lamina]]` as far as it could be read.
#[derive(Debug, Clone)]
pub(super) struct WrittenLamina {
    curve: Option<Written>,
    /// What its regions are called; the name of the curve if there is none.
    name: Option<Written>,
    side: Option<LaminaSide>,
    /// From the line outward, or from right to left; `None` if something about them is
    /// wrong that leaves their number open.
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
    let tables = root.tables("lamina");
    tables
        .iter()
        .map(|table| {
            let lamina = WrittenLamina {
                curve: name(table, "curve", "the name of a physical curve"),
                name: own_name(table),
                side: table
                    .word("side", &SIDES.map(LaminaSide::name))
                    .map(|side| SIDES[side]),
                plies: plies(table),
            };
            table.finish();
            lamina
        })
        .collect()
}

fn own_name(table: &Table<'_>) -> Option<Written> {
    let text = table.text("name")?;
    if text.trim().is_empty() || text.contains(char::is_control) {
        table.wrong("name", "a text of one line, without control characters");
        return None;
    }
    let line = table.line_of("name");
    Some(Written { text, line })
}

/// The plies: a list of them, or the table is itself one.
fn plies(table: &Table<'_>) -> Option<Vec<WrittenPly>> {
    // Every key is asked for, so that none of them counts as unknown.
    let own = ONE_PLY.map(|key| (key, table.has(key)));
    let own = own.iter().find(|(_, has)| *has).map(|(key, _)| *key);
    match (table.has("plies"), own) {
        (true, Some(key)) => {
            table.note(key, &InputProblem::PliesAndPly { key });
            None
        }
        (true, None) => {
            let tables = table.tables("plies");
            let plies: Vec<_> = tables.iter().map(ply).collect();
            tables.iter().for_each(Table::finish);
            if table.is_list("plies") && table.row_count("plies") == Some(0) {
                table.wrong("plies", "at least one ply");
            }
            (!plies.is_empty()).then_some(plies)
        }
        (false, None) => {
            table.note("", &InputProblem::NoPlies);
            None
        }
        (false, Some(_)) => Some(vec![ply(table)]),
    }
}

fn ply(table: &Table<'_>) -> WrittenPly {
    let fiber_angle = match table.has("fiber_angle") {
        true => constant_angle(table, "fiber_angle"),
        false => Some(0.0),
    };
    WrittenPly {
        line: table.line(),
        material: name(table, "material", "the name of a material"),
        thickness: table.require_positive("thickness", Dimension::LENGTH),
        fiber_angle,
    }
}

impl WrittenLamina {
    /// What its cells are called: its name, with a number for each of several plies.
    fn labels(&self) -> Vec<String> {
        let name = self.name.as_ref().or(self.curve.as_ref());
        let name = name.map_or("?", |name| name.text.as_str());
        let count = self.plies.as_ref().map_or(0, Vec::len);
        match count {
            1 => vec![name.to_owned()],
            _ => (1..=count)
                .map(|number| format!("{name}/{number}"))
                .collect(),
        }
    }

    /// Where its name stands.
    fn line(&self) -> usize {
        let written = self.name.as_ref().or(self.curve.as_ref());
        written.map_or(0, |written| written.line)
    }
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
/// `meters_per_unit`: the cells, and the laminates as the mesh has them; `None` when
/// anything was noted.
pub(super) fn add(
    document: &Document,
    mesh: &mut Mesh,
    laminae: &[WrittenLamina],
    meters_per_unit: f64,
) -> Option<(Laminated, Vec<Lamina>)> {
    let is_free = names_are_free(document, mesh, laminae);
    // Every laminate is looked at before the first wrong one ends the search.
    let found: Vec<_> = laminae
        .iter()
        .map(|lamina| {
            let curve = groups::curve(document, mesh, lamina.curve.as_ref()?)?;
            let plies = lamina.plies.as_ref()?.iter();
            let thicknesses = plies.map(|ply| Some(ply.thickness? / meters_per_unit));
            Some(Lamina {
                curve,
                side: lamina.side,
                thicknesses: thicknesses.collect::<Option<_>>()?,
                groups: Vec::new(),
            })
        })
        .collect();
    let mut found: Vec<Lamina> = found.into_iter().collect::<Option<_>>()?;
    if !is_free {
        return None;
    }
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
    match add_laminae(mesh, &found) {
        Ok(laminated) => Some((laminated, found)),
        Err(problems) => {
            for (lamina, problem) in problems {
                let line = laminae[lamina].curve.as_ref().map_or(0, |curve| curve.line);
                document.note(line, &problem);
            }
            None
        }
    }
}

/// Notes names of laminates that surfaces or other laminates have.
fn names_are_free(document: &Document, mesh: &Mesh, laminae: &[WrittenLamina]) -> bool {
    let surfaces = mesh.groups.iter().filter(|group| group.dimension == 2);
    let mut taken: Vec<String> = surfaces.map(PhysicalGroup::label).collect();
    let mut is_free = true;
    for lamina in laminae {
        let labels = lamina.labels();
        if let Some(label) = labels.iter().find(|label| taken.contains(label)) {
            let name = label.clone();
            document.note(lamina.line(), &InputProblem::LaminaName { name });
            is_free = false;
        }
        taken.extend(labels);
    }
    is_free
}

/// The index of the region of each cell of the laminates, of those that [`regions`] has.
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

/// Material and angles of the cells of the laminates, where `materials` are those of
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
