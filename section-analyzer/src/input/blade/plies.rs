//! Plies of skin and spar as written.

use shared_geom::document::schema::ValueKind::Quantity;
use shared_geom::document::{Item, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::super::regions::Angle;
use super::{BladeFileProblem, BladeRegion, Lines, Reading};
use crate::mesh::generate::blade::{Ply, Spar, SparPly};

keys! {
    /// Angle of the fiber from x toward the wall.
    FIBER_ANGLE: Angle = "fiber_angle", [Quantity(Dimension::ANGLE)], or "0" = Angle(0.0), "45";
}

/// Largest number of cells through a ply.
const MOST_CELLS: usize = 50;
/// Positions of a ply of the spar.
const PARTS_OF_SECTION: [&str; 5] = ["upper", "lower", "web", "front_web", "rear_web"];
/// Keys that restrict a ply of the spar.
const LIMITS: [&str; 4] = ["from", "to", "on", "filler"];

/// Material and angles of a physical surface.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Use {
    pub name: String,
    pub material: String,
    /// Angle of the fiber \[rad\].
    pub fiber_angle: f64,
    pub follow: Option<&'static str>,
    line: usize,
}

/// All physical surfaces so far.
#[derive(Debug, Default)]
pub(super) struct Uses {
    known: Vec<Use>,
}

impl Uses {
    /// The surfaces as regions.
    pub fn regions(self) -> Vec<BladeRegion> {
        self.known.into_iter().map(BladeRegion::from).collect()
    }

    /// Adds a surface, or notes that its name has another meaning elsewhere.
    fn add(&mut self, table: &Table<'_>, new: Use) {
        match self.known.iter().find(|known| known.name == new.name) {
            None => self.known.push(new),
            Some(known) => {
                let same = Use {
                    line: known.line,
                    ..new
                };
                if *known != same {
                    let problem = BladeFileProblem::NameTwice {
                        name: same.name,
                        line: known.line,
                    };
                    table.note("name", &problem);
                }
            }
        }
    }
}

/// Name, material and angle of a table; returns the name.
pub(super) fn material_of(
    table: &Table<'_>,
    uses: &mut Uses,
    follow: Option<&'static str>,
) -> Option<String> {
    let _ = table.require_item(
        "name",
        "the name of a physical surface, and of its material",
    );
    let name = word(table, "name");
    let material = match table.has("material") {
        true => word(table, "material"),
        false => name.clone(),
    };
    let fiber_angle = match follow {
        Some(_) => table.get(&FIBER_ANGLE).map(|angle| angle.0),
        None => Some(0.0),
    };
    let name = name?;
    uses.add(
        table,
        Use {
            name: name.clone(),
            material: material?,
            fiber_angle: fiber_angle?,
            follow,
            line: table.line(),
        },
    );
    Some(name)
}

/// A name that is valid in meshes and section files.
fn word(table: &Table<'_>, key: &str) -> Option<String> {
    if !table.has(key) {
        return None;
    }
    let text = table.text(key)?;
    let fits = |letter: char| letter.is_alphanumeric() || "-_+.".contains(letter);
    if text.is_empty() || !text.chars().all(fits) {
        table.wrong(
            key,
            "a name of letters, digits, \"-\", \"_\", \"+\" and \".\"",
        );
        return None;
    }
    Some(text)
}

impl Reading<'_> {
    /// The plies of the skin from the outside in, and whether it is closed at the
    /// trailing edge.
    pub(super) fn skin(
        &self,
        root: &Table<'_>,
        lines: &mut Lines,
        uses: &mut Uses,
    ) -> Option<(Vec<Ply>, bool)> {
        let table = root.require_table("skin", "a table [skin] with its plies")?;
        lines.skin = table.line_of("plies");
        let closure = match table.has("closure") {
            true => table.word("closure", &["closed", "open"]),
            false => Some(0),
        };
        let is_inside_out = is_inside_out(&table);
        let tables = plies_of(&table);
        let plies: Vec<Option<Ply>> = tables
            .iter()
            .map(|table| {
                let ply = self.ply(table, uses, "contour");
                table.finish_beside(&LIMITS.map(|key| (key, "a ply of the spar")));
                ply
            })
            .collect();
        table.finish();
        let mut plies: Vec<Ply> = plies.into_iter().collect::<Option<_>>()?;
        if is_inside_out? {
            plies.reverse();
        }
        let is_closed = closure? == 0;
        (!plies.is_empty()).then_some((plies, is_closed))
    }

    /// The spar.
    pub(super) fn spar(
        &self,
        root: &Table<'_>,
        lines: &mut Lines,
        uses: &mut Uses,
    ) -> Option<Spar> {
        let table = root.table("spar")?;
        lines.spar = table.line_of("plies");
        lines.front_web = table.line_of("front_web");
        lines.rear_web = table.line_of("rear_web");
        let _ = table.require_item("rear_web", "the part of the chord at its rear face");
        let rear = match table.has("rear_web") {
            true => self.part(&table, "rear_web"),
            false => None,
        };
        let front = match table.has("front_web") {
            true => self.part(&table, "front_web").map(Some),
            false => Some(None),
        };
        let is_inside_out = is_inside_out(&table);
        let tables = plies_of(&table);
        let has_front = table.has("front_web");
        let plies: Vec<Option<SparPly>> = tables
            .iter()
            .map(|table| {
                let ply = self.spar_ply(table, uses, (front.flatten(), rear), has_front);
                table.finish();
                ply
            })
            .collect();
        table.finish();
        let mut plies: Vec<SparPly> = plies.into_iter().collect::<Option<_>>()?;
        lines.plies = tables.iter().map(Table::line).collect();
        if is_inside_out? {
            plies.reverse();
            lines.plies.reverse();
        }
        if plies.is_empty() {
            return None;
        }
        Some(Spar {
            front_web: front?,
            rear_web: rear?,
            plies,
        })
    }

    fn ply(&self, table: &Table<'_>, uses: &mut Uses, follow: &'static str) -> Option<Ply> {
        let name = material_of(table, uses, Some(follow));
        let thickness = self.length(table, "thickness");
        let count = count_or(table, "count", 1, usize::MAX);
        let cells = count_or(table, "cells", 1, MOST_CELLS);
        let has_faces = match table.has("faces") {
            true => table.boolean("faces"),
            false => Some(false),
        };
        Some(Ply {
            name: name?,
            thickness: thickness? * count? as f64,
            cells: cells?,
            has_faces: has_faces?,
        })
    }

    fn spar_ply(
        &self,
        table: &Table<'_>,
        uses: &mut Uses,
        (front, rear): (Option<f64>, Option<f64>),
        has_front: bool,
    ) -> Option<SparPly> {
        let ply = self.ply(table, uses, "spar");
        let from = self.part_or(table, "from", f64::NEG_INFINITY);
        let to = self.part_or(table, "to", f64::INFINITY);
        let positions = parts_of_section(table, has_front);
        let filler = filler(table, uses);
        let (from, to) = (from?, to?);
        // a ply that extends to the webs includes their corners
        let from = match front {
            Some(front) if from == front => f64::NEG_INFINITY,
            None if from <= 0.0 => f64::NEG_INFINITY,
            _ => from,
        };
        let to = if Some(to) == rear { f64::INFINITY } else { to };
        let [upper, lower, front_web, rear_web] = positions?;
        let range = Some([from, to]);
        Some(SparPly {
            ply: ply?,
            upper: range.filter(|_| upper),
            lower: range.filter(|_| lower),
            webs: [front_web, rear_web],
            filler: filler?,
        })
    }
}

/// Tables of plies; notes an empty list.
fn plies_of<'a>(table: &Table<'a>) -> Vec<Table<'a>> {
    let _ = table.require_item("plies", "a list of plies");
    let tables = table.tables("plies");
    if table.is_list("plies") && table.row_count("plies") == Some(0) {
        table.wrong("plies", "at least one ply");
    }
    tables
}

fn is_inside_out(table: &Table<'_>) -> Option<bool> {
    if !table.has("order") {
        return Some(false);
    }
    let word = table.word("order", &["outside_in", "inside_out"]);
    word.map(|word| word == 1)
}

fn count_or(table: &Table<'_>, key: &str, default: usize, most: usize) -> Option<usize> {
    if !table.has(key) {
        return Some(default);
    }
    let count = table.count(key)?;
    if count > most {
        table.wrong(key, &format!("a whole number from 1 to {most}"));
        return None;
    }
    Some(count)
}

/// Whether a ply is on the upper and lower surface, in the front and in the rear web.
fn parts_of_section(table: &Table<'_>, has_front: bool) -> Option<[bool; 4]> {
    if !table.has("on") {
        return Some([true; 4]);
    }
    let mut positions = [false; 4];
    let mut is_good = true;
    for name in table.texts("on")? {
        match name.as_str() {
            "upper" => positions[0] = true,
            "lower" => positions[1] = true,
            "web" => (positions[2], positions[3]) = (true, true),
            "front_web" if has_front => positions[2] = true,
            "rear_web" => positions[3] = true,
            _ => {
                let known = PARTS_OF_SECTION
                    .iter()
                    .filter(|position| has_front || **position != "front_web");
                let problem = BladeFileProblem::UnknownPart {
                    found: name,
                    known: known.map(|&position| position.to_owned()).collect(),
                };
                table.note("on", &problem);
                is_good = false;
            }
        }
    }
    if is_good && positions == [false; 4] {
        table.wrong("on", "at least one position");
        return None;
    }
    is_good.then_some(positions)
}

/// The filler that replaces a ply: its name alone, or a table; `None` if it is wrong.
fn filler(table: &Table<'_>, uses: &mut Uses) -> Option<Option<String>> {
    if !table.has("filler") {
        return Some(None);
    }
    let item: Item<'_> = table.item("filler")?;
    let Some(own) = item.table("\"filler\"") else {
        table.wrong(
            "filler",
            "a table { name = ..., material = ..., fiber_angle = ... }",
        );
        return None;
    };
    let name = material_of(&own, uses, Some("spar"));
    own.finish();
    name.map(Some)
}
