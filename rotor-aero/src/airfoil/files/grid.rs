//! Angles of attack of one table: ascending, inside half a turn, in radians.

use std::f64::consts::PI;

use super::super::data::Curve;
use super::notes::Notes;

/// Angles this far beyond half a turn are rounded numbers of the half turn [rad].
const ROUNDED: f64 = 2e-4;

/// Tables that begin or end this close to half a turn are closed there, if requested [rad].
const ALMOST: f64 = 0.01;

/// Unit of the angles of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    Degrees,
    Radians,
}

impl Unit {
    /// An angle of the file [rad].
    pub fn radians(self, angle: f64) -> f64 {
        match self {
            Self::Degrees => angle.to_radians(),
            Self::Radians => angle,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Degrees => "deg",
            Self::Radians => "rad",
        }
    }

    fn half_turn(self) -> &'static str {
        match self {
            Self::Degrees => "180",
            Self::Radians => "pi",
        }
    }
}

/// One angle of a table, and the coefficients there.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub line: usize,
    /// In the unit of the file.
    pub alpha: f64,
    pub values: Vec<f64>,
}

/// Coefficients over checked angles.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    /// Ascending [rad].
    pub alpha: Vec<f64>,
    /// One list per coefficient.
    pub columns: Vec<Vec<f64>>,
}

impl Grid {
    /// Checks the rows of the table `what`, whose first line is `line`; notes problems. With a problem
    /// it has the sound rows: the file is refused, but its table is not absent.
    pub fn of(
        rows: &[Row],
        unit: Unit,
        (what, line): (&str, usize),
        notes: &mut Notes,
    ) -> Option<Self> {
        let Some(first) = rows.first() else {
            notes.missing(
                line,
                &format!("{what}: a row of numbers"),
                "give at least one angle",
            );
            return None;
        };
        let mut grid = Self {
            alpha: Vec::with_capacity(rows.len()),
            columns: vec![Vec::with_capacity(rows.len()); first.values.len()],
        };
        let mut is_sound = true;
        for row in rows {
            is_sound &= grid.add(row, unit, what, notes);
        }
        if is_sound {
            grid.remark(what, line, notes);
        }
        Some(grid)
    }

    /// Adds a row; notes its problem.
    fn add(&mut self, row: &Row, unit: Unit, what: &str, notes: &mut Notes) -> bool {
        if row.values.len() != self.columns.len() {
            let found = format!("{} coefficients", row.values.len());
            let expected = format!("{}, as in the first row", self.columns.len());
            let help = "the line may have been cut off";
            notes.wrong(row.line, [what, &found, &expected, help]);
            return false;
        }
        let Some(alpha) = inside(row, unit, what, notes) else {
            return false;
        };
        match self.alpha.last() {
            Some(&last) if alpha == last => return self.repeated(row, what, notes),
            Some(&last) if alpha < last => {
                let found = format!("{} after a larger angle", row.alpha);
                let help =
                    "put the rows in the order of the angle; the file may have lost a header";
                notes.wrong(
                    row.line,
                    [&angle_of(what), &found, "ascending angles", help],
                );
                return false;
            }
            _ => {}
        }
        self.alpha.push(alpha);
        for (column, value) in self.columns.iter_mut().zip(&row.values) {
            column.push(*value);
        }
        true
    }

    /// A repeated angle: the first row is kept if both are equal.
    fn repeated(&self, row: &Row, what: &str, notes: &mut Notes) -> bool {
        let lasts = self.columns.iter().map(|column| column.last());
        let is_same = lasts.eq(row.values.iter().map(Some));
        if is_same {
            let text = format!(
                "{what}: the angle {} is repeated with equal values",
                row.alpha
            );
            notes.remark(row.line, &text);
            return true;
        }
        let found = format!("{} again, with other values", row.alpha);
        let help = "delete one of the two rows";
        notes.wrong(row.line, [&angle_of(what), &found, "each angle once", help]);
        false
    }

    /// A remark on a table that does not close.
    fn remark(&self, what: &str, line: usize, notes: &mut Notes) {
        let (first, last) = (self.alpha.first().copied(), self.alpha.last().copied());
        if (first == Some(-PI)) != (last == Some(PI)) && self.alpha.len() > 1 {
            let text = format!("{what}: only one end of the table is at half a turn");
            notes.remark(line, &text);
        }
    }

    /// Adds points at -pi and pi to a table that ends close to them, linear over the gap.
    pub fn close(&mut self, what: &str, line: usize, notes: &mut Notes) {
        let (Some(&first), Some(&last)) = (self.alpha.first(), self.alpha.last()) else {
            return;
        };
        let gap = 2.0 * PI + first - last;
        let is_near = first + PI <= ALMOST && PI - last <= ALMOST;
        if !is_near || gap <= 0.0 || first >= last {
            return;
        }
        let part = (PI - last) / gap;
        for column in &mut self.columns {
            if let (Some(&a), Some(&b)) = (column.last(), column.first()) {
                let value = a + part * (b - a);
                add_ends(column, value, (first > -PI, last < PI));
            }
        }
        if first > -PI {
            self.alpha.insert(0, -PI);
        }
        if last < PI {
            self.alpha.push(PI);
        }
        notes.remark(
            line,
            &format!("{what}: the table from {first} to {last} rad is closed at pi"),
        );
    }

    /// The curve of a column.
    pub fn curve(&self, column: usize, [mach, reynolds, flap]: [Option<f64>; 3]) -> Option<Curve> {
        let values = self.columns.get(column)?.clone();
        Some(Curve {
            mach,
            reynolds,
            flap,
            alpha: self.alpha.clone(),
            values,
        })
    }
}

fn add_ends(column: &mut Vec<f64>, value: f64, (before, after): (bool, bool)) {
    if before {
        column.insert(0, value);
    }
    if after {
        column.push(value);
    }
}

fn angle_of(what: &str) -> String {
    format!("{what}: angle of attack")
}

/// The angle of a row inside half a turn [rad]; notes another one.
fn inside(row: &Row, unit: Unit, what: &str, notes: &mut Notes) -> Option<f64> {
    let alpha = unit.radians(row.alpha);
    let beyond = alpha.abs() - PI;
    if beyond <= 0.0 {
        return Some(alpha);
    }
    if beyond <= ROUNDED {
        if beyond > 1e-12 {
            notes.remark(
                row.line,
                &format!("{what}: the angle {} is set to half a turn", row.alpha),
            );
        }
        return Some(PI.copysign(alpha));
    }
    let (name, half) = (unit.name(), unit.half_turn());
    let found = format!("{} {name}", row.alpha);
    let expected = format!("-{half} to {half} {name}");
    let help = "write angles beyond half a turn less a turn; check the unit of the angles";
    notes.wrong(row.line, [&angle_of(what), &found, &expected, help]);
    None
}
