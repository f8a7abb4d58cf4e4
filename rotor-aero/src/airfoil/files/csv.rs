//! Columns with a header: `alpha [deg]`, `cl`, `cd`, `cm`, and perhaps `airfoil`, `mach`,
//! `reynolds`, `flap [deg]`, `thickness`.
//!
//! Lines that begin with `#` are comments. Columns are separated by commas, semicolons, tabs or
//! blanks. A blank cell of a coefficient is no point of its curve, so that each coefficient can
//! have its own grid.

use shared_geom::error::shortened;
use shared_geom::exchange::text::Line;

use super::super::data::Curve;
use super::grid::{Grid, Row, Unit};
use super::notes::Notes;
use super::reading::{Options, ReadAirfoil};

pub(super) mod header;
mod write;

use header::{Header, Kind, cells, content, separator};
pub(super) use write::write;

/// Whether `text` begins with a header that names the angle of attack and lift.
pub(super) fn recognize(text: &str) -> bool {
    content(text)
        .first()
        .is_some_and(|line| header::is_header(line.text))
}

/// Rows of one airfoil at one condition.
struct Group {
    name: String,
    condition: [Option<f64>; 3],
    thickness: Option<f64>,
    line: usize,
    rows: [Vec<Row>; 3],
}

/// Reads the airfoils of a file.
pub(super) fn read(text: &str, _: &Options, notes: &mut Notes) -> Option<Vec<ReadAirfoil>> {
    let lines = content(text);
    let Some((first, rest)) = lines.split_first() else {
        notes.missing(
            0,
            "the header",
            "write \"alpha [deg],cl [-],cd [-],cm [-]\"",
        );
        return None;
    };
    let separator = separator(first.text);
    let header = Header::of(first, separator, notes)?;
    let mut groups: Vec<Group> = Vec::new();
    for line in rest {
        add(
            line,
            &cells(line.text, separator),
            &header,
            &mut groups,
            notes,
        );
    }
    if rest.is_empty() {
        notes.missing(
            first.number,
            "a row of numbers after the header",
            "the file may have been cut off",
        );
    }
    let mut airfoils: Vec<ReadAirfoil> = Vec::new();
    for group in groups {
        group.add_to(&mut airfoils, header.unit, notes);
    }
    Some(airfoils)
}

/// Adds a line to its group.
fn add(
    line: &Line<'_>,
    cells: &[String],
    header: &Header,
    groups: &mut Vec<Group>,
    notes: &mut Notes,
) {
    if cells.len() != header.kinds.len() {
        let found = format!("{} cells: \"{}\"", cells.len(), shortened(line.text));
        let expected = format!("{}, as in the header", header.kinds.len());
        notes.wrong(
            line.number,
            [
                "row of coefficients",
                &found,
                &expected,
                "the line may have been cut off",
            ],
        );
        return;
    }
    let Some(numbers) = numbers(line.number, cells, header, notes) else {
        return;
    };
    let value = |kind: Kind| value(&numbers, kind);
    let Some(alpha) = value(Kind::Alpha) else {
        notes.missing(
            line.number,
            "the angle of attack",
            "every row needs an angle",
        );
        return;
    };
    let Some(group) = group(line.number, cells, header, &numbers, groups) else {
        return;
    };
    for (rows, kind) in group
        .rows
        .iter_mut()
        .zip([Kind::Lift, Kind::Drag, Kind::Moment])
    {
        if let Some(value) = value(kind) {
            rows.push(Row {
                line: line.number,
                alpha,
                values: vec![value],
            });
        }
    }
}

/// The value of a column.
fn value(numbers: &[(Kind, f64)], kind: Kind) -> Option<f64> {
    let found = numbers.iter().find(|(known, _)| *known == kind);
    found.map(|(_, value)| *value)
}

/// The group of a line; a new one if its airfoil or condition is new.
fn group<'g>(
    line: usize,
    cells: &[String],
    header: &Header,
    numbers: &[(Kind, f64)],
    groups: &'g mut Vec<Group>,
) -> Option<&'g mut Group> {
    let column = header.column(Kind::Name);
    let name = column.and_then(|i| cells.get(i)).cloned();
    let name = name.unwrap_or_default();
    let flap = value(numbers, Kind::Flap).map(|flap| header.flap.radians(flap));
    let condition = [
        value(numbers, Kind::Mach),
        value(numbers, Kind::Reynolds),
        flap,
    ];
    let is_it = |group: &Group| group.name == name && group.condition == condition;
    let index = groups.iter().rposition(is_it).unwrap_or(groups.len());
    if index == groups.len() {
        groups.push(Group {
            name,
            condition,
            thickness: value(numbers, Kind::Thickness),
            line,
            rows: [Vec::new(), Vec::new(), Vec::new()],
        });
    }
    groups.get_mut(index)
}

/// The numbers of a line by their columns; notes wrong words.
fn numbers(
    line: usize,
    cells: &[String],
    header: &Header,
    notes: &mut Notes,
) -> Option<Vec<(Kind, f64)>> {
    let mut numbers = Vec::new();
    let mut is_sound = true;
    let columns = header.kinds.iter().zip(&header.factors);
    for ((kind, factor), cell) in columns.zip(cells) {
        if matches!(kind, Kind::Name | Kind::Other) || cell.is_empty() {
            continue;
        }
        match notes.number(line, kind.title(), cell) {
            Some(value) => numbers.push((*kind, value * factor)),
            None => is_sound = false,
        }
    }
    is_sound.then_some(numbers)
}

impl Group {
    /// Adds the curves to the airfoil of its name.
    fn add_to(self, airfoils: &mut Vec<ReadAirfoil>, unit: Unit, notes: &mut Notes) {
        let index = airfoils
            .iter()
            .position(|airfoil| airfoil.data.name == self.name);
        let index = index.unwrap_or_else(|| {
            airfoils.push(ReadAirfoil::default());
            airfoils.len() - 1
        });
        let Some(airfoil) = airfoils.get_mut(index) else {
            return;
        };
        airfoil.data.name.clone_from(&self.name);
        airfoil.data.thickness = airfoil.data.thickness.or(self.thickness);
        let of = if self.name.is_empty() {
            String::new()
        } else {
            format!(" of airfoil \"{}\"", self.name)
        };
        let lists: [&mut Vec<Curve>; 3] = [
            &mut airfoil.data.lift,
            &mut airfoil.data.drag,
            &mut airfoil.data.moment,
        ];
        for ((rows, title), list) in self.rows.iter().zip(["lift", "drag", "moment"]).zip(lists) {
            if rows.is_empty() {
                continue;
            }
            let what = format!("{title}{of}");
            let grid = Grid::of(rows, unit, (&what, self.line), notes);
            list.extend(grid.and_then(|grid| grid.curve(0, self.condition)));
        }
    }
}
