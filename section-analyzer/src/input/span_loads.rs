//! Tables of internal forces along a blade, and the table of its stations.
//!
//! A table of forces comes in two forms: a row for each position and instant, in any order (columns
//! `arc` or `eta`, and all of `case`, `time`, `step` that distinguish the instants), as
//! `beam-dynamics static` writes it; or a row for each time, with columns `NAME_axial` and so on for
//! positions that the command line gives, as `beam-dynamics transient` writes it, with `case` and
//! `member` as in the other form.
//! Envelopes, `axial_max`, `axial_min` and so on, have the first form.

use std::path::Path;

use nalgebra::Vector6;
use shared_geom::error::Diagnostics;
use shared_geom::units::Dimension;

use super::column_table::{ColumnTable, plain};

mod columns;
mod envelope;
mod forms;
mod instants;
mod problem;
mod stations;

pub use problem::SpanLoadProblem;
pub use stations::{
    FINGERPRINT, ListedStation, SECTIONS, blade_name, is_blade, read_stations, section_file_name,
    section_fingerprint,
};

/// The six components as columns name them, and their dimensions.
const COMPONENTS: [(&str, Dimension); 6] = [
    ("axial", Dimension::FORCE),
    ("shear_y", Dimension::FORCE),
    ("shear_z", Dimension::FORCE),
    ("torsion", Dimension::MOMENT),
    ("bending_y", Dimension::MOMENT),
    ("bending_z", Dimension::MOMENT),
];
/// Columns that distinguish instants together, with the words for reports.
const INSTANTS: [&str; 3] = ["case", "time", "step"];
/// Name of the only load of a table without instants.
const NAMELESS: &str = "load";
/// Distance from its only position at which a load is valid [-].
const NEAR: f64 = 0.005;
/// Distance beyond the positions of a load that is always small, and one that never is [-].
const BEYOND: [f64; 2] = [1e-3, 0.1];

/// Internal forces along the blade at one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadInstant {
    /// Name for reports, as `case gust time 1.25`.
    pub name: String,
    /// The load case, if the table has it.
    pub case: Option<String>,
    /// Time, if the table has it \[s\].
    pub time: Option<f64>,
    /// Positions along the span [-] in order, and the internal force there about the reference
    /// line, in section axes \[N, N m\].
    pub points: Vec<(f64, Vector6<f64>)>,
}

impl LoadInstant {
    /// The internal force at a position: linear between the positions and beyond them; with one
    /// position only near it.
    pub fn at(&self, eta: f64) -> Option<Vector6<f64>> {
        if self.points.len() < 2 {
            let (at, force) = self.points.first()?;
            return ((at - eta).abs() < NEAR).then_some(*force);
        }
        let after = self.points.partition_point(|point| point.0 <= eta);
        let after = after.clamp(1, self.points.len() - 1);
        let ((a, f), (b, g)) = (&self.points[after - 1], &self.points[after]);
        match b - a {
            width if width > 0.0 => Some(f + (g - f) * ((eta - a) / width)),
            _ => Some(*g),
        }
    }

    /// The same instant of one of several tables, whose name precedes its case.
    #[must_use]
    pub fn of_table(self, table: &str) -> Self {
        let own = self.case.as_ref().map(|case| format!("case {case}"));
        let rest = own.and_then(|own| self.name.strip_prefix(&*own));
        let rest = rest.unwrap_or(if self.name == NAMELESS {
            ""
        } else {
            &self.name
        });
        let case = match &self.case {
            Some(case) => format!("{table} {case}"),
            None => table.to_owned(),
        };
        let name = format!("case {case} {}", rest.trim_start());
        Self {
            name: name.trim_end().to_owned(),
            case: Some(case),
            ..self
        }
    }

    /// Distance of a position beyond the first or last one of the load, if it is more than a tenth
    /// of the length or more than the distance of the two positions at this end.
    pub fn extrapolated(&self, eta: f64) -> Option<f64> {
        let [[first, second], [next, last]] = match &self.points[..] {
            [first, second] => [[first, second]; 2],
            [first, second, .., next, last] => [[first, second], [next, last]],
            [first, middle, last] => [[first, middle], [middle, last]],
            _ => return None,
        };
        let ends = [
            (first.0 - eta, second.0 - first.0),
            (eta - last.0, last.0 - next.0),
        ];
        let [small, large] = BEYOND;
        let is_far = |(beyond, width): &&(f64, f64)| beyond > &width.clamp(small, large);
        ends.iter().find(is_far).map(|end| end.0)
    }
}

/// Source of the positions of a table of loads.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadPositions {
    /// Length of the blade, for columns `arc` \[m\].
    pub length: f64,
    /// The beam or blade, of a table with several.
    pub member: Option<String>,
    /// Names of groups of columns and their positions [-], for tables over time.
    pub named: Vec<(String, f64)>,
}

/// The content of a table of loads.
#[derive(Debug, Clone, PartialEq)]
pub struct SpanLoads {
    /// The internal forces at each instant.
    pub instants: Vec<LoadInstant>,
    /// Headings of the columns that have no effect, without the columns of equilibria.
    pub unused: Vec<String>,
    /// Whether the positions of a case are of different instants, as of the envelope of a run.
    pub is_mixed: bool,
}

/// Reads a table of loads.
///
/// # Errors
/// All problems of its columns, and the first cell without a number.
pub fn read_loads(path: &Path, positions: &LoadPositions) -> Result<SpanLoads, Diagnostics> {
    const REMEDY: &str = "positions of tables over time are given by --at NAME=ETA, for columns \
                          NAME_axial, NAME_shear_y and so on";
    let table = LoadTable(ColumnTable::read(path, REMEDY)?);
    let mut instants = match positions.named.is_empty() {
        true if table.is_envelope() => table.corners(positions)?,
        true => table.long(positions)?,
        false => table.wide(positions)?,
    };
    for instant in &mut instants {
        instant.points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    let starts = positions.named.iter().map(|(name, _)| start_of(name));
    let unused = table.unused(&starts.collect::<Vec<_>>());
    Ok(SpanLoads {
        instants,
        unused,
        is_mixed: table.is_mixed()?,
    })
}

/// The beginning of the names of a group of columns.
fn start_of(name: &str) -> String {
    format!("{}_", plain(name))
}

/// A table of internal forces.
#[derive(Debug)]
struct LoadTable(ColumnTable);
