//! Plies of skin and spar as written.

use shared_geom::document::{Key, NestedList, Table};

use super::keys::{
    CELLS, CLOSURE, COUNT, FACES, FIBER_ANGLE, FILLER, FROM, FRONT_WEB, LIMITS, MATERIAL, NAME, ON,
    ORDER, REAR_WEB, SKIN_PLIES, SPAR_PLIES, THICKNESS, TO,
};
use super::{BladeFileProblem, BladeRegion, Lines, Reading};
use crate::mesh::generate::blade::{Ply, Spar, SparPly};

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
                    table.note(&NAME, &problem);
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
    let name = table.get(&NAME).map(|name| name.0);
    let material = table.get(&MATERIAL);
    let fiber_angle = match follow {
        Some(_) => table.get(&FIBER_ANGLE).map(|angle| angle.0),
        None => Some(0.0),
    };
    let name = name?;
    uses.add(
        table,
        Use {
            name: name.clone(),
            material: material?.map_or(name.clone(), |material| material.0),
            fiber_angle: fiber_angle?,
            follow,
            line: table.line(),
        },
    );
    Some(name)
}

impl Reading<'_> {
    /// The plies of the skin from the outside in, and whether it is closed at the
    /// trailing edge.
    pub(super) fn skin(
        &self,
        table: &Table<'_>,
        lines: &mut Lines,
        uses: &mut Uses,
    ) -> Option<(Vec<Ply>, bool)> {
        lines.skin = table.line_of(&SKIN_PLIES);
        let (closure, order) = (table.get(&CLOSURE), table.get(&ORDER));
        let beside = LIMITS.map(|key| (key, "a ply of the spar"));
        let mut plies = plies(table, &SKIN_PLIES, &beside, |table| {
            self.ply(table, uses, "contour")
        })?;
        if order? == INSIDE_OUT {
            plies.reverse();
        }
        Some((plies, closure? == 0))
    }

    /// The spar.
    pub(super) fn spar(
        &self,
        table: &Table<'_>,
        lines: &mut Lines,
        uses: &mut Uses,
    ) -> Option<Spar> {
        lines.spar = table.line_of(&SPAR_PLIES);
        lines.front_web = table.line_of(&FRONT_WEB);
        lines.rear_web = table.line_of(&REAR_WEB);
        let rear = table.get(&REAR_WEB).map(|part| part.0);
        let front = table.get(&FRONT_WEB).map(|part| part.map(|part| part.0));
        let order = table.get(&ORDER);
        let has_front = table.has(&FRONT_WEB);
        let mut of_plies = Vec::new();
        let mut plies = plies(table, &SPAR_PLIES, &[], |table| {
            of_plies.push(table.line());
            self.spar_ply(table, uses, (front.flatten(), rear), has_front)
        })?;
        if order? == INSIDE_OUT {
            plies.reverse();
            of_plies.reverse();
        }
        lines.plies = of_plies;
        Some(Spar {
            front_web: front?,
            rear_web: rear?,
            plies,
        })
    }

    fn ply(&self, table: &Table<'_>, uses: &mut Uses, follow: &'static str) -> Option<Ply> {
        let name = material_of(table, uses, Some(follow));
        let thickness = self.length(table, &THICKNESS);
        let (count, cells) = (table.get(&COUNT), table.get(&CELLS));
        let has_faces = table.get(&FACES);
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
        let (from, to) = (table.get(&FROM), table.get(&TO));
        let positions = positions(table, has_front);
        let filler = table.nested(&FILLER, |table| material_of(table, uses, Some("spar")));
        // a ply that extends to the webs includes their corners
        let from = match from?.map_or(f64::NEG_INFINITY, |part| part.0) {
            from if front == Some(from) => f64::NEG_INFINITY,
            from if front.is_none() && from <= 0.0 => f64::NEG_INFINITY,
            from => from,
        };
        let to = to?.map_or(f64::INFINITY, |part| part.0);
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

/// The index of the word of plies that begin inside.
const INSIDE_OUT: usize = 1;

/// The plies of a list, each read by `read`; notes an empty list, and unknown keys, of which
/// some belong `beside`.
fn plies<T>(
    table: &Table<'_>,
    key: &Key<NestedList>,
    beside: &[(&str, &'static str)],
    mut read: impl FnMut(&Table<'_>) -> Option<T>,
) -> Option<Vec<T>> {
    table.require_item(key, &key.schema.expected())?;
    if table.is_list(key) && table.row_count(key) == Some(0) {
        table.wrong(key, "at least one ply");
        return None;
    }
    // Every ply is read, so that each wrong one is noted.
    let tables = table.tables(key);
    let plies: Vec<_> = tables
        .iter()
        .map(|table| {
            let ply = read(table);
            table.finish_beside(beside);
            ply
        })
        .collect();
    plies
        .into_iter()
        .collect::<Option<Vec<T>>>()
        .filter(|plies| !plies.is_empty())
}

/// Whether a ply is on the upper and lower surface, in the front and in the rear web.
fn positions(table: &Table<'_>, has_front: bool) -> Option<[bool; 4]> {
    let Some(words) = table.get(&ON)? else {
        return Some([true; 4]);
    };
    let mut positions = [false; 4];
    for word in words {
        match word {
            0 | 1 => positions[word] = true,
            2 => (positions[2], positions[3]) = (true, true),
            3 if !has_front => {
                table.note(&ON, &BladeFileProblem::NoFrontWeb);
                return None;
            }
            _ => positions[word - 1] = true,
        }
    }
    if positions == [false; 4] {
        table.wrong(&ON, "at least one position");
        return None;
    }
    Some(positions)
}
