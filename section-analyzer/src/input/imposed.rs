//! Imposed states as written: `[temperature.NAME]` and `[initial_strain.NAME]`.

use std::collections::BTreeSet;

use nalgebra::Vector6;
use shared_geom::document::schema::ValueKind::{Name, NamedTables, Quantity, Tables, Text, Vector};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::document::{Document, Key, NestedByName, NestedList, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::cell_table::{CellTable, LARGEST_RISE, RISE};
use super::files::Files;
use super::laminae::{self, WrittenLamina};
use super::names::is_load_name;
use super::problem::InputProblem;
use super::regions::{Written, WrittenRegion};
use crate::section::{CellMaterial, FreeStrain, ImposedStrain, Section, TemperatureField};

mod problem;

pub use problem::ImposedProblem;

keys! {
    /// Rises of temperature, by name.
    pub(super) TEMPERATURES: NestedByName = "temperature", [NamedTables(&TEMPERATURE)], optional, "";
    /// Initial strains, by name.
    pub(super) STRAINS: NestedByName = "initial_strain", [NamedTables(&INITIAL_STRAIN)], optional, "";
    /// Rise of temperature.
    UNIFORM: f64 = "rise", [Quantity(Dimension::TEMPERATURE)], required, "50";
    /// Change of the rise per length along y and along z.
    GRADIENT: [f64; 2] = "gradient", [Vector(2, Dimension::TEMPERATURE_GRADIENT)]
        as "an array of 2, the gradients along y and z", required, "[0, \"3 K/mm\"]";
    /// Rise at the origin of the mesh.
    AT_ORIGIN: f64 = "rise", [Quantity(Dimension::TEMPERATURE)], or "0" = 0.0, "20";
    /// CSV file with the header cell,rise and a row for each cell of the mesh, by its tag, and
    /// for each line with plies; rises in the declared unit.
    TABLE: Written = "table", [Text], required, "\"rises.csv\"";
}

/// A temperature.
const TEMPERATURE: TableSchema = TableSchema {
    title: "[temperature.NAME]",
    meaning: "A rise of temperature above the state without stress. NAME is made of letters, \
              digits, - and _.",
    keys: &[],
    families: &[
        Family {
            name: "uniform",
            meaning: "Constant in the section.",
            keys: &[UNIFORM.schema],
        },
        Family {
            name: "gradient",
            meaning: "Linear in the section.",
            keys: &[GRADIENT.schema, AT_ORIGIN.schema],
        },
        Family {
            name: "table",
            meaning: "Cell by cell.",
            keys: &[TABLE.schema],
        },
    ],
};

keys! {
    /// Strain that the material would have without any stress, as from cure or swelling. NAME is
    /// made of letters, digits, - and _, and differs from the names of temperatures.
    INITIAL_STRAIN = "[initial_strain.NAME]";
    /// The strained regions; the others have no initial strain.
    REGIONS: NestedList = "region", [Tables(&REGION)], required, "";
}

keys! {
    /// A region and its initial strain.
    REGION = "[[initial_strain.NAME.region]]";
    /// The name of a physical surface of a region, or its tag, or the name of a lamina, for all
    /// its plies.
    GROUP: Written = "group", [Name], required, "\"skin\"";
    /// Strain in material axes, order 11, 22, 33, 23, 13, 12 with engineering shear strains.
    STRAIN: [f64; 6] = "strain", [Vector(6, Dimension::NUMBER)]
        as "an array of 6 strains in material axes, order 11 22 33 23 13 12", required,
        "[-2e-4, -4e-3, -4e-3, 0, 0, 0]";
}

/// Largest initial strain \[-\]: beyond it linear theory does not apply.
const LARGEST_STRAIN: f64 = 1.0;

/// The components of a strain in material axes.
const COMPONENTS: [&str; 6] = ["11", "22", "33", "23", "13", "12"];

/// Every imposed state of a file, as far as it could be read.
#[derive(Debug, Default)]
pub(super) struct WrittenStates {
    temperatures: Vec<WrittenState<Temperature>>,
    initial_strains: Vec<WrittenState<Vec<RegionStrain>>>,
}

/// A state; its name is known even if its content is wrong, so that loads can refer to
/// it.
#[derive(Debug)]
struct WrittenState<T> {
    name: String,
    line: usize,
    content: Option<T>,
}

/// A temperature rise as given in the input.
#[derive(Debug)]
enum Temperature {
    Linear(TemperatureField),
    Table(Written),
}

/// The initial strain of a region, in material axes \[-\]; unreadable values are missing.
#[derive(Debug)]
struct RegionStrain {
    group: Option<Written>,
    strain: Option<Vector6<f64>>,
}

/// Reads every `[temperature.NAME]` and `[initial_strain.NAME]`.
pub(super) fn read(root: &Table<'_>) -> WrittenStates {
    let temperatures = states(root, &TEMPERATURES, temperature);
    let initial_strains = states(root, &STRAINS, region_strains);
    for strain in &initial_strains {
        let same = temperatures.iter().find(|state| state.name == strain.name);
        if let Some(state) = same {
            let (name, line) = (strain.name.clone(), state.line);
            let problem = ImposedProblem::NameTwice { name, line };
            root.document().note(strain.line, &problem);
        }
    }
    WrittenStates {
        temperatures,
        initial_strains,
    }
}

fn states<T>(
    root: &Table<'_>,
    key: &Key<NestedByName>,
    read: impl Fn(&str, &Table<'_>) -> Option<T>,
) -> Vec<WrittenState<T>> {
    let states = root.each_by_name(key, |name, table| {
        let name = name.to_owned();
        if !is_load_name(&name) {
            let (kind, name) = (key.name(), name.clone());
            table.note("", &ImposedProblem::Name { kind, name });
        }
        Some(WrittenState {
            content: read(&name, table),
            line: table.line(),
            name,
        })
    });
    let states = states.unwrap_or_default().into_iter();
    states.map(|(_, state)| state).collect()
}

fn temperature(name: &str, table: &Table<'_>) -> Option<Temperature> {
    // All keys are read, so that none of them is reported as unknown.
    let has = [table.has(&UNIFORM), table.has(&GRADIENT), table.has(&TABLE)];
    let found = match has {
        [_, false, false] if !has[0] => "none of them",
        [_, false, false] | [_, true, false] => {
            return linear(name, table).map(Temperature::Linear);
        }
        [false, false, true] => return table.get(&TABLE).map(Temperature::Table),
        [true, false, true] => "\"rise\" and \"table\"",
        [_, true, true] => "\"gradient\" and \"table\"",
    };
    let name = name.to_owned();
    table.note("", &ImposedProblem::Form { name, found });
    None
}

fn linear(name: &str, table: &Table<'_>) -> Option<TemperatureField> {
    let is_right = |rise: &f64| rise.abs() <= LARGEST_RISE;
    let expected = "a rise of temperature of at most 100000 K";
    let rise = table.get_if(&AT_ORIGIN, is_right, expected);
    let gradient = if table.has(&GRADIENT) {
        let is_right = |slopes: &[f64; 2]| slopes.iter().all(|k| k.abs() <= LARGEST_RISE / 1e-3);
        table.get_if(&GRADIENT, is_right, "gradients of at most 1e8 K/m")
    } else {
        Some([0.0; 2])
    };
    let field = TemperatureField {
        rise: rise?,
        gradient: gradient?,
    };
    if field == TemperatureField::default() {
        note_zero(name, TEMPERATURES.name(), table);
        return None;
    }
    Some(field)
}

fn note_zero(name: &str, kind: &'static str, table: &Table<'_>) {
    let name = name.to_owned();
    table.note("", &ImposedProblem::Zero { kind, name });
}

fn region_strains(state: &str, table: &Table<'_>) -> Option<Vec<RegionStrain>> {
    let tables = table.tables(&REGIONS);
    if tables.is_empty() {
        let name = state.to_owned();
        table.note("", &ImposedProblem::NoRegion { name });
        return None;
    }
    let strains: Vec<_> = tables.iter().map(region_strain).collect();
    let is_zero = |region: &RegionStrain| region.strain == Some(Vector6::zeros());
    if strains.iter().all(is_zero) {
        note_zero(state, STRAINS.name(), table);
    }
    Some(strains)
}

fn region_strain(table: &Table<'_>) -> RegionStrain {
    let group = table.get(&GROUP);
    let strain = strain(table);
    table.finish_beside(&[("region", "\"group\"")]);
    RegionStrain { group, strain }
}

fn strain(table: &Table<'_>) -> Option<Vector6<f64>> {
    let strain = table.get(&STRAIN)?;
    let large = strain.iter().position(|part| part.abs() > LARGEST_STRAIN);
    if let Some(entry) = large {
        let problem = ImposedProblem::Large {
            component: COMPONENTS[entry],
            value: strain[entry],
            limit: LARGEST_STRAIN,
        };
        table.note(&STRAIN, &problem);
        return None;
    }
    Some(Vector6::from(strain))
}

/// Tags that the rows of a table may use.
#[derive(Debug)]
pub(super) struct Rows {
    /// The tag of every cell, the cells of laminates last.
    pub tags: Vec<u64>,
    /// The tag of the line of each cell of a laminate, in their order.
    pub lines: Vec<u64>,
}

impl Rows {
    /// The row of each cell: its own, or for a cell of a laminate the row of its line.
    fn keys(&self, table: &CellTable) -> Vec<u64> {
        let solid = self.tags.len().saturating_sub(self.lines.len());
        let (cells, plies) = self.tags.split_at(solid);
        let of_plies = plies.iter().zip(&self.lines);
        let of_plies = of_plies.map(|(&own, &line)| match table.value(own) {
            Some(_) => own,
            None => line,
        });
        cells.iter().copied().chain(of_plies).collect()
    }
}

impl WrittenStates {
    /// Names of the states of a kind, `temperature` or `initial_strain`.
    pub fn names(&self, kind: &str) -> Vec<String> {
        match kind {
            kind if kind == TEMPERATURES.name() => names(&self.temperatures),
            _ => names(&self.initial_strains),
        }
    }

    /// The strain of each region and initial strain; notes regions that the file does not
    /// have, and regions given twice. The name of a laminate represents its plies.
    pub fn strains_of_regions(
        &self,
        document: &Document,
        regions: &[WrittenRegion],
        laminae: &[WrittenLamina],
    ) -> Option<Vec<Vec<FreeStrain>>> {
        let groups = regions.iter().map(|region| region.group.as_ref());
        let groups: Vec<_> = groups.map(|g| g.map(|group| group.text.clone())).collect();
        let of_state = |state: &WrittenState<Vec<RegionStrain>>| {
            let mut strains = vec![None; regions.len()];
            let mut is_sound = true;
            for (written, text, strain) in by_region(state.content.as_ref()?, laminae) {
                let same = |known: &Option<String>| known.as_ref() == Some(&text);
                let (name, group) = (state.name.clone(), text.clone());
                let problem = match groups.iter().position(same) {
                    None => ImposedProblem::UnknownRegion {
                        name,
                        group,
                        known: groups.iter().flatten().cloned().collect(),
                    },
                    Some(region) if strains[region].is_some() => {
                        ImposedProblem::RegionTwice { name, group }
                    }
                    Some(region) => {
                        strains[region] = Some(FreeStrain::constant(strain.unwrap_or_default()));
                        is_sound &= strain.is_some();
                        continue;
                    }
                };
                document.note(written.line, &problem);
                is_sound = false;
            }
            let strains = strains.into_iter().map(Option::unwrap_or_default);
            is_sound.then(|| strains.collect())
        };
        // All states are checked before the first wrong one ends the search.
        let found: Vec<_> = self.initial_strains.iter().map(of_state).collect();
        found.into_iter().collect()
    }

    /// The temperature rises of every table, by cell; `None` for a temperature without
    /// table. Notes tables whose rows do not match the mesh; `rows` is `None` while the
    /// mesh is not known.
    pub fn rises(
        &self,
        document: &Document,
        files: &mut Files<'_>,
        rows: &Option<Rows>,
    ) -> Option<Vec<Option<Vec<f64>>>> {
        let mut of_state = |state: &WrittenState<Temperature>| match state.content.as_ref()? {
            Temperature::Linear(_) => Some(None),
            Temperature::Table(written) => {
                let rises = rises(document, files, rows.as_ref(), written)?;
                if rises.iter().all(|rise| *rise == 0.0) {
                    let (kind, name) = ("temperature", state.name.clone());
                    document.note(written.line, &ImposedProblem::Zero { kind, name });
                }
                Some(Some(rises))
            }
        };
        // All tables are read before the first wrong one ends the reading.
        let found: Vec<_> = self.temperatures.iter().map(&mut of_state).collect();
        found.into_iter().collect()
    }

    /// The states of `section`, temperatures first, from the `rises` of the tables and
    /// the `strains` of the regions, with the region of each cell in `region_of_cell`.
    /// Notes temperatures for which no material expands.
    pub fn states(
        &self,
        document: &Document,
        section: &Section,
        rises: Vec<Option<Vec<f64>>>,
        (strains, region_of_cell): (Vec<Vec<FreeStrain>>, &[usize]),
    ) -> Vec<ImposedStrain> {
        let is_heated = |cell: &CellMaterial| {
            let expansion = section.materials[cell.material].expansion;
            expansion.is_some_and(|along| along != [0.0; 3])
        };
        if !section.cells.iter().any(is_heated) {
            for state in &self.temperatures {
                let name = state.name.clone();
                document.note(state.line, &ImposedProblem::NothingExpands { name });
            }
        }
        let temperatures = self.temperatures.iter().zip(rises);
        let temperatures = temperatures.map(|(state, rises)| match (&state.content, rises) {
            (Some(Temperature::Linear(field)), _) => {
                ImposedStrain::of_temperature(&state.name, section, field)
            }
            (_, rises) => ImposedStrain::of_rises(&state.name, section, &rises.unwrap_or_default()),
        });
        let strains = self.initial_strains.iter().zip(strains);
        let strains = strains.map(|(state, of_region)| ImposedStrain {
            name: state.name.clone(),
            cells: region_of_cell
                .iter()
                .map(|&region| of_region[region])
                .collect(),
        });
        temperatures.chain(strains).collect()
    }
}

/// The strains with the names of their regions, for laminates of each ply.
fn by_region<'a>(
    strains: &'a [RegionStrain],
    laminae: &[WrittenLamina],
) -> Vec<(&'a Written, String, Option<Vector6<f64>>)> {
    let named = strains.iter().filter_map(|region| {
        let group = region.group.as_ref()?;
        let plies = laminae::plies_of(laminae, &group.text);
        let names = if plies.is_empty() {
            vec![group.text.clone()]
        } else {
            plies
        };
        Some(
            names
                .into_iter()
                .map(move |name| (group, name, region.strain)),
        )
    });
    named.flatten().collect()
}

fn names<T>(states: &[WrittenState<T>]) -> Vec<String> {
    states.iter().map(|state| state.name.clone()).collect()
}

/// The temperature rises of a table, cell by cell \[K\].
fn rises(
    document: &Document,
    files: &mut Files<'_>,
    rows: Option<&Rows>,
    written: &Written,
) -> Option<Vec<f64>> {
    let path = files.path(written);
    let text = files.read_text("temperature table", &path, written)?;
    let table = document.keep(CellTable::parse(&text, &path, &RISE))?;
    let rows = rows?;
    let keys = rows.keys(&table);
    let expected: BTreeSet<_> = keys.iter().copied().collect();
    if let Some(misfit) = table.misfit(&expected, &rows.lines) {
        let problem = InputProblem::TableCells {
            column: RISE.heading,
            table: written.text.clone(),
            found: table.len(),
            expected: expected.len(),
            users: if rows.lines.is_empty() {
                "the mesh".to_owned()
            } else {
                "the mesh and each line with plies".to_owned()
            },
            has_lines: !rows.lines.is_empty(),
            missing: misfit.missing.into(),
            unknown: misfit.unknown.into(),
        };
        document.note(written.line, &problem);
        return None;
    }
    let unit = document.factor(Dimension::TEMPERATURE);
    keys.iter()
        .map(|&tag| Some(unit * table.value(tag)?))
        .collect()
}
