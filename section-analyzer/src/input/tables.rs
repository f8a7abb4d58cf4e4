//! The angle tables of all regions: each file read once, and its rows compared with the
//! cells of all regions that use it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use shared_geom::document::Document;
use shared_geom::error::quoted;
use shared_geom::units::Dimension;

use super::cell_table::{ANGLE, CellTable};
use super::files::Files;
use super::problem::InputProblem;
use super::regions::{Written, WrittenAngle, WrittenRegion};

/// A table and its users.
#[derive(Debug)]
struct TableUse {
    /// Location of its first use.
    written: Written,
    table: Option<CellTable>,
    cells: BTreeSet<u64>,
    groups: Vec<String>,
    /// Whether the cells of all its regions are known: not if a region names a group that
    /// the mesh does not have.
    is_complete: bool,
}

/// Every angle table of the input, by the path of its file.
#[derive(Debug, Default)]
pub(super) struct Tables {
    uses: BTreeMap<PathBuf, TableUse>,
}

impl Tables {
    /// Reads every table used by a region.
    pub fn read(document: &Document, files: &mut Files<'_>, regions: &[WrittenRegion]) -> Self {
        let mut tables = Self::default();
        let angles = regions
            .iter()
            .flat_map(|region| [&region.fiber_angle, &region.plane_angle]);
        for angle in angles.flatten() {
            let WrittenAngle::Table(written) = angle else {
                continue;
            };
            let path = files.path(written);
            if tables.uses.contains_key(&path) {
                continue;
            }
            let text = files.read_text("angle table", &path, written);
            let table = text.and_then(|text| document.keep(CellTable::parse(&text, &path, &ANGLE)));
            let table_use = TableUse {
                written: written.clone(),
                table,
                cells: BTreeSet::new(),
                groups: Vec::new(),
                is_complete: true,
            };
            tables.uses.insert(path, table_use);
        }
        tables
    }

    /// Adds the cells of a region to the cells that use the table at `path`.
    pub fn expect(&mut self, path: &PathBuf, group: &str, cells: &[u64]) {
        if let Some(table_use) = self.uses.get_mut(path) {
            table_use.cells.extend(cells);
            table_use.is_complete &= !cells.is_empty();
            if !table_use.groups.iter().any(|known| known == group) {
                table_use.groups.push(group.to_owned());
            }
        }
    }

    /// Notes every table whose rows do not match its cells.
    pub fn check(&self, document: &Document) {
        for table_use in self.uses.values().filter(|table_use| table_use.is_complete) {
            let Some(table) = &table_use.table else {
                continue;
            };
            if let Some(misfit) = table.misfit(&table_use.cells, &[]) {
                let problem = InputProblem::TableCells {
                    column: ANGLE.heading,
                    table: table_use.written.text.clone(),
                    found: table.len(),
                    expected: table_use.cells.len(),
                    users: quoted(&table_use.groups),
                    has_lines: false,
                    missing: misfit.missing.into(),
                    unknown: misfit.unknown.into(),
                };
                document.note(table_use.written.line, &problem);
            }
        }
    }

    /// The angle of a cell \[rad\], from the table at `path`.
    pub fn angle(&self, document: &Document, path: &PathBuf, cell: u64) -> Option<f64> {
        let angle = self.uses.get(path)?.table.as_ref()?.value(cell)?;
        Some(angle * document.factor(Dimension::ANGLE))
    }
}
