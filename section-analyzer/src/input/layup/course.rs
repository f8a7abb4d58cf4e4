//! Quantities along the span.
//!
//! Monotone cubics on the interval of length h with v = x - x_i and d = (f_{i+1} - f_i)/h,
//!
//! ```text
//! f = f_i + s_i v + (3 d - 2 s_i - s_{i+1}) v^2/h + (s_i + s_{i+1} - 2 d) v^3/h^2
//! s = (w_- + w_+) / (w_-/d_- + w_+/d_+),  w_- = 2 h_+ + h_-,  w_+ = h_+ + 2 h_-,  if d_- d_+ > 0
//! ```
//!
//! and s = 0 otherwise. At the ends, with the nearest intervals h_1 and h_2, it is the slope of the
//! parabola through three values,
//!
//! ```text
//! s = ((2 h_1 + h_2) d_1 - h_1 d_2) / (h_1 + h_2),
//! ```
//!
//! 0 if its sign differs from d_1, and at most 3 d_1 if d_1 and d_2 have opposite signs.
//!
//! # References
//! - F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic
//!   interpolants", SIAM Journal on Scientific and Statistical Computing 5, 1984.

use shared_geom::document::schema::ValueKind::{Boolean, FreeMatrix, Quantities, Text, Word};
use shared_geom::document::schema::{Family, KeySchema, TableSchema};
use shared_geom::document::{ByHand, Declared, Table, Value};
use shared_geom::error::Diagnostics;
use shared_geom::keys;
use shared_geom::units::{Dimension, rounded};

use super::super::column_table::ColumnTable;
use super::angle::{Angle, is_within_a_turn};
use super::problem::LayupFileProblem;

/// A quantity along the span.
pub(super) const COURSE: TableSchema = TableSchema {
    title: "{ eta = [...], value = [...] }",
    meaning: "A quantity along the span; outside of its range a layer or web is absent, and all else \
              has the value of the nearest end.",
    keys: &[HOLD.schema, COURSE_KIND.schema],
    families: &[
        Family {
            name: "eta",
            meaning: "Values at parts of the length.",
            keys: &[ETA.schema, VALUE.schema],
        },
        Family {
            name: "span",
            meaning: "Values at lengths from the root along the line.",
            keys: &[SPAN.schema, VALUE.schema],
        },
        Family {
            name: "file",
            meaning: "Columns of a table: `eta` or `span [m]`, and the values; commas separate its \
                      cells, numbers without a unit are in SI units.",
            keys: &[FILE.schema, COLUMN.schema],
        },
    ],
};

keys! {
    /// Positions along the span, ascending, 0 at the root to 1 at the tip.
    ETA: ByHand = "eta", [Quantities(Dimension::NUMBER)], required, "[0, 0.2, 1]";
    /// Lengths from the root along the line, ascending.
    SPAN: ByHand = "span", [Quantities(Dimension::LENGTH)], required, "[0, 12, 60]";
    /// The values there.
    VALUE: ByHand = "value", [FreeMatrix], required, "[1.5, 1.9, 1]";
    /// Table with named columns, from the folder of this file.
    FILE: String = "file", [Text], required, "\"blade.csv\"";
    /// The column of the values.
    COLUMN: String = "column", [Text], required, "\"cap [mm]\"";
    /// Whether a layer is present beyond the positions too, with the value of the nearest end.
    HOLD: bool = "hold", [Boolean], or "false" = false, "true";
    /// Between the positions: monotone cubics, straight lines, or the value of the position before.
    COURSE_KIND: usize = "course", [Word(&WORDS)],
        or "\"monotone\"" = 0, "\"linear\"";
}

/// Largest number of changes of a whole number between two positions; beyond, the last one follows.
const MOST_CHANGES: usize = 10_000;
/// Error of the position of a change, in lengths of the table.
const CLOSE: f64 = 1e-12;

/// The words of the kinds, in their order.
const WORDS: [&str; 3] = ["monotone", "linear", "constant"];

/// How values between positions follow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Monotone,
    Linear,
    Constant,
}

/// A quantity along the span, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    eta: Vec<f64>,
    value: Vec<f64>,
    kind: Kind,
    /// Whether the end values continue beyond the table.
    is_held: bool,
    /// The line of the file of positions that are lengths \[m\].
    lengths: Option<usize>,
}

impl Course {
    fn new(eta: Vec<f64>, value: Vec<f64>, kind: Kind) -> Self {
        Self {
            eta,
            value,
            kind,
            is_held: false,
            lengths: None,
        }
    }

    /// One value, everywhere.
    pub fn constant(value: f64) -> Self {
        Self {
            is_held: true,
            ..Self::new(vec![0.0], vec![value], Kind::Constant)
        }
    }

    /// Monotone cubics through values at ascending positions.
    pub fn monotone(eta: Vec<f64>, value: Vec<f64>) -> Self {
        Self::new(eta, value, Kind::Monotone)
    }

    /// The quantity in whole numbers, times `factor`: constant between positions at which the
    /// whole number changes.
    pub fn rounded(&self, factor: f64) -> Self {
        let whole = |eta: f64| factor * self.at(eta).round();
        let Some((&first, &last)) = self.positions().first().zip(self.positions().last()) else {
            return self.map(|_, value| factor * value.round());
        };
        let (mut eta, mut value) = (vec![first], vec![whole(first)]);
        // monotone between two positions
        for pair in self.positions().windows(2) {
            let mut from = pair[0];
            for _ in 0..MOST_CHANGES {
                if whole(from) == whole(pair[1]) {
                    break;
                }
                let (mut low, mut high) = (from, pair[1]);
                while high - low > CLOSE * (last - first) {
                    let middle = 0.5 * (low + high);
                    if whole(middle) == whole(from) {
                        low = middle
                    } else {
                        high = middle
                    }
                }
                eta.push(high);
                value.push(whole(high));
                from = high;
            }
        }
        if eta[eta.len() - 1] < last {
            eta.push(last);
            value.push(whole(last));
        }
        Self {
            is_held: self.is_held,
            lengths: self.lengths,
            ..Self::new(eta, value, Kind::Constant)
        }
    }

    /// The line of the file of positions that are lengths, which are to be divided by the length of
    /// the line.
    pub(super) fn lengths(&self) -> Option<usize> {
        self.lengths
    }

    /// Divides positions that are lengths by the length of the line \[m\].
    pub(super) fn divide_lengths(&mut self, length: f64) {
        if self.lengths.take().is_some() {
            for eta in &mut self.eta {
                *eta /= length;
            }
        }
    }

    /// Whether the end values continue beyond the table.
    pub fn is_held(&self) -> bool {
        self.is_held
    }

    /// Whether a table is one of positions and values.
    pub(super) fn has_positions(table: &Table<'_>) -> bool {
        [&ETA, &SPAN, &VALUE].iter().any(|key| table.has(key)) || table.has(&FILE)
    }

    /// The sum with `factor` times another one, at the positions of both: of the kind of one if the
    /// other one is constant, else lines if both are lines, and monotone cubics through the sums.
    pub fn plus(&self, other: &Self, factor: f64) -> Self {
        let mut eta: Vec<f64> = [self.positions(), other.positions()].concat();
        if eta.is_empty() {
            return Self::constant(self.value[0] + factor * other.value[0]);
        }
        eta.sort_by(f64::total_cmp);
        eta.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
        let sum = |eta: &f64| self.at(*eta) + factor * other.at(*eta);
        let value = eta.iter().map(sum).collect();
        let kind = match (self.positions().is_empty(), other.positions().is_empty()) {
            (_, true) => self.kind,
            (true, _) => other.kind,
            _ if self.kind == other.kind => self.kind,
            _ => Kind::Monotone,
        };
        Self {
            lengths: self.lengths.or(other.lengths),
            ..Self::new(eta, value, kind)
        }
    }

    /// The quantity with other values at the same positions.
    pub fn map(&self, change: impl Fn(f64, f64) -> f64) -> Self {
        let pairs = self.eta.iter().zip(&self.value);
        let value = pairs.map(|(eta, value)| change(*eta, *value)).collect();
        Self {
            value,
            ..self.clone()
        }
    }

    /// The part of the table between two positions, with values at both.
    pub fn within(&self, [from, to]: [f64; 2]) -> Self {
        let Some(all) = Some(self.positions()).filter(|all| !all.is_empty()) else {
            return Self::monotone(vec![from, to], vec![self.value[0]; 2]);
        };
        let (from, to) = (from.max(all[0]), to.min(all[all.len() - 1]));
        let inside = all.iter().copied().filter(|eta| *eta > from && *eta < to);
        let eta: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
        let value = eta.iter().map(|eta| self.at(*eta)).collect();
        Self::new(eta, value, self.kind)
    }

    /// The word of the interpolation between positions.
    pub fn word(&self) -> &'static str {
        WORDS[self.kind as usize]
    }

    /// Whether it is zero along the whole span.
    pub fn is_zero(&self) -> bool {
        self.value.iter().all(|value| *value == 0.0)
    }

    /// Positions and values.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.eta.iter().copied().zip(self.value.iter().copied())
    }

    /// Whether a position is within the table; a value without position is everywhere.
    pub fn covers(&self, eta: f64) -> bool {
        let last = self.eta.len() - 1;
        self.is_held || (eta >= self.eta[0] - 1e-12 && eta <= self.eta[last] + 1e-12)
    }

    /// The value at a position; beyond the table the value at its end.
    pub fn at(&self, eta: f64) -> f64 {
        let (x, f) = (&self.eta, &self.value);
        let last = x.len() - 1;
        if eta <= x[0] || last == 0 {
            return f[0];
        }
        if eta >= x[last] {
            return f[last];
        }
        let i = x.partition_point(|x| *x <= eta) - 1;
        match self.kind {
            Kind::Constant => f[i],
            Kind::Linear => f[i] + (f[i + 1] - f[i]) / (x[i + 1] - x[i]) * (eta - x[i]),
            Kind::Monotone => monotone(x, &|i| f[i], eta),
        }
    }

    /// Positions of the table; none for one value.
    pub fn positions(&self) -> &[f64] {
        match self.eta.len() {
            1 => &[],
            _ => &self.eta,
        }
    }
}

/// The monotone cubics through two or more values at ascending positions, at a position between
/// them.
pub(super) fn monotone(x: &[f64], f: &dyn Fn(usize) -> f64, at: f64) -> f64 {
    let i = x.partition_point(|x| *x <= at).clamp(1, x.len() - 1) - 1;
    let (h, v) = (x[i + 1] - x[i], at - x[i]);
    let d = (f(i + 1) - f(i)) / h;
    let (a, b) = (slope(x, f, i), slope(x, f, i + 1));
    let square = (3.0 * d - 2.0 * a - b) / h;
    let cube = (a + b - 2.0 * d) / (h * h);
    f(i) + v * (a + v * (square + v * cube))
}

/// Slope of the monotone cubics at a position of the table.
fn slope(x: &[f64], f: &dyn Fn(usize) -> f64, i: usize) -> f64 {
    let step = |i: usize| x[i + 1] - x[i];
    let secant = |i: usize| (f(i + 1) - f(i)) / step(i);
    let last = x.len() - 1;
    if last == 1 {
        return secant(0);
    }
    if i == 0 || i == last {
        let (near, next) = if i == 0 { (0, 1) } else { (last - 1, last - 2) };
        let ([h1, h2], [d1, d2]) = ([near, next].map(step), [near, next].map(secant));
        let slope = ((2.0 * h1 + h2) * d1 - h1 * d2) / (h1 + h2);
        return match slope * d1 > 0.0 {
            false => 0.0,
            true if d1 * d2 < 0.0 && slope.abs() > 3.0 * d1.abs() => 3.0 * d1,
            true => slope,
        };
    }
    let (before, after) = (secant(i - 1), secant(i));
    if before * after <= 0.0 {
        return 0.0;
    }
    let (low, high) = (step(i - 1), step(i));
    let weights = [2.0 * high + low, high + 2.0 * low];
    (weights[0] + weights[1]) / (weights[0] / before + weights[1] / after)
}

impl Declared for Course {}

impl Value for Course {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let dimension = key.dimension();
        if !table.is_table(key) {
            return match dimension {
                Dimension::ANGLE => Angle::read(table, key).map(|angle| Self::constant(angle.0)),
                _ => f64::read(table, key).map(Self::constant),
            };
        }
        let inner = table.table(key)?.described(&COURSE);
        let (kind, is_held) = (inner.get(&COURSE_KIND), inner.get(&HOLD));
        let lists = [&ETA, &SPAN, &VALUE].map(|key| inner.has(key));
        if lists[0] && lists[1] || inner.has(&FILE) && lists.contains(&true) {
            inner.note("", &LayupFileProblem::Positions);
            return None;
        }
        let points = if inner.has(&FILE) {
            of_file(&inner, dimension)
        } else {
            of_lists(&inner, dimension)
        };
        inner.finish();
        let (kind, is_held, (positions, value)) = (kind?, is_held?, points?);
        let in_lengths = positions.in_lengths;
        let eta = positions.all;
        let place = [&ETA, &SPAN].into_iter().find(|key| inner.has(key));
        let place = place.map_or(FILE.name(), |key| key.name());
        if let Some(found) = disorder(&eta, in_lengths) {
            let expected = if in_lengths {
                "ascending lengths from 0"
            } else {
                "ascending positions from 0 to 1"
            };
            inner.wrong(place, &format!("{expected}, not {found}"));
            return None;
        }
        let is_angle = dimension == Dimension::ANGLE;
        let is_wrong = |value: &f64| !key.has_sign(*value) || is_angle && !is_within_a_turn(*value);
        if let Some(number) = value.iter().position(is_wrong) {
            let (key_name, found, at) = (key.name, value[number], eta[number]);
            let problem = if is_angle {
                LayupFileProblem::turned(key_name, found, at)
            } else {
                LayupFileProblem::Value {
                    key: key_name,
                    found: rounded(found).to_string(),
                    at,
                    expected: key.expected_number(),
                }
            };
            table.note(key, &problem);
            return None;
        }
        let kind = [Kind::Monotone, Kind::Linear, Kind::Constant][kind];
        Some(Self {
            is_held,
            lengths: in_lengths.then(|| inner.line_of(place)),
            ..Self::new(eta, value, kind)
        })
    }
}

/// The first position that is outside of the span, or not behind the one before.
pub(super) fn disorder(positions: &[f64], in_lengths: bool) -> Option<String> {
    let most = if in_lengths { f64::INFINITY } else { 1.0 };
    let outside = positions.iter().find(|at| !(0.0..=most).contains(*at));
    let turned = positions.windows(2).find(|pair| pair[1] <= pair[0]);
    let turned = turned.map(|pair| format!("{} after {}", pair[1], pair[0]));
    outside.map(f64::to_string).or(turned)
}

/// Positions of a table, one or more.
struct Positions {
    all: Vec<f64>,
    in_lengths: bool,
}

/// The lists of a table; notes problems.
fn of_lists(inner: &Table<'_>, dimension: Dimension) -> Option<(Positions, Vec<f64>)> {
    let in_lengths = inner.has(&SPAN);
    let (key, of) = if in_lengths {
        (&SPAN, Dimension::LENGTH)
    } else {
        (&ETA, Dimension::NUMBER)
    };
    let eta = inner
        .require_item(key, "positions along the span")
        .and_then(|_| inner.quantities(key.name(), of));
    let value = inner
        .require_item(&VALUE, "the values at these positions")
        .and_then(|_| inner.quantities(VALUE.name(), dimension));
    let (all, value) = (eta?, value?);
    if all.len() != value.len() || all.is_empty() {
        let expected = format!(
            "as many values as positions: {} of \"{}\"",
            all.len(),
            key.name()
        );
        inner.wrong(&VALUE, &expected);
        return None;
    }
    Some((Positions { all, in_lengths }, value))
}

/// The columns of a file; notes problems.
fn of_file(inner: &Table<'_>, dimension: Dimension) -> Option<(Positions, Vec<f64>)> {
    const REMEDY: &str = "positions are in a column eta or span [m]";
    let (file, column) = (inner.get(&FILE)?, inner.get(&COLUMN));
    let path = inner.existing(&FILE, &file)?;
    let read = || -> Result<(Positions, Vec<f64>), Diagnostics> {
        let table = ColumnTable::read(&path, REMEDY)?;
        if table.index("eta").is_some() && table.index("span").is_some() {
            return Err(table.problem(1, &LayupFileProblem::Positions));
        }
        let in_lengths = table.index("span").is_some();
        let (position, of) = if in_lengths {
            ("span", Dimension::LENGTH)
        } else {
            ("eta", Dimension::NUMBER)
        };
        let [at, value] = table.require([position, column.as_deref().unwrap_or_default()])?;
        let numbers = |column: usize, dimension: Dimension| {
            let factor = table.factor(column, dimension)?;
            let rows = table.rows.iter();
            rows.map(|row| Ok(factor * table.number(row, column)?))
                .collect::<Result<Vec<f64>, Diagnostics>>()
        };
        let all = numbers(at, of)?;
        Ok((Positions { all, in_lengths }, numbers(value, dimension)?))
    };
    column.as_ref()?;
    inner.keep_file(FILE.name(), read())
}
