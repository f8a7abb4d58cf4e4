//! Columns of runs over time: a panel for each unit, or more if there are many columns.
//!
//! For one run, colors distinguish the columns. For several, colors distinguish the runs if every
//! panel has one column, and else the columns, with tone and dashes for the runs; a legend above
//! all panels shows this.

use shared_geom::figure::{Axes, Drawing, Figure, Legend, Sample, Stroke, WIDTH, range};

use super::{Heading, RunFileProblem, TimeTable};
use crate::input::short_number;

mod line;
mod names;
mod titles;

use line::{COLORS, TONES, of_column, of_run, of_tone, thinned, toned};

/// Largest number of panels in the figure of a run.
const MOST_PANELS: usize = 12;
/// Largest height of a figure \[figure pixels\].
const MOST_HEIGHT: f64 = 20_000.0;
/// Heights \[figure pixels\].
const HEAD: f64 = 76.0;
const FRAME: f64 = 340.0;
/// Least and largest height of a path drawn with equal scales.
const PATH: [f64; 2] = [FRAME, 1600.0];
/// Left and right margin.
const MARGINS: [f64; 2] = [210.0, 50.0];
/// Between a legend and the frame below it, and between panels.
const GAPS: [f64; 2] = [12.0, 56.0];
const FOOT: f64 = 120.0;
/// Part of the largest value of a unit up to which values are round-off.
const ROUND_OFF: f64 = 1e-12;
/// Units in which an angle of one radian is this large: a scale even if all angles are small.
const ANGLES: [(&str, f64); 3] = [("rad", 1.0), ("deg", 57.3), ("mrad", 1000.0)];

/// Curves over time or over another column, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct TimePlot {
    title: String,
    /// Name and unit of the horizontal axis.
    across: String,
    /// Unit of a position on the horizontal axis, over which positions of the same unit are drawn
    /// as a path; empty over time.
    path_unit: String,
    /// Names of the runs.
    runs: Vec<String>,
    panels: Vec<Curves>,
}

/// The curves of a panel.
#[derive(Debug, Clone, PartialEq)]
struct Curves {
    unit: String,
    columns: Vec<String>,
    /// Meanings of the columns; empty if unknown.
    meanings: Vec<String>,
    curves: Vec<Curve>,
}

/// One column of one run.
#[derive(Debug, Clone, PartialEq)]
struct Curve {
    /// Index of the column in its panel.
    column: usize,
    run: usize,
    /// Points, in pieces without a gap [units of the columns].
    pieces: Vec<Vec<[f64; 2]>>,
}

/// A column, for the runs that have it.
#[derive(Debug, Clone)]
struct Found {
    heading: Heading,
    curves: Vec<Curve>,
}

impl TimePlot {
    /// The columns `wanted` of `tables` over the column `across`; all columns if none is requested;
    /// of further tables the columns that they have. A name that ends in `*` represents all names
    /// that begin with it. The title names the tables.
    ///
    /// # Errors
    /// [`RunFileProblem`]: a column that a table does not have, `across` in several units,
    /// or fewer than two rows.
    pub fn new(
        tables: &[TimeTable],
        across: &str,
        wanted: &[String],
    ) -> Result<Self, RunFileProblem> {
        let (heading, x) = common_heading(tables, across)?;
        let mut found: Vec<Found> = Vec::new();
        for (run, table) in tables.iter().enumerate() {
            let column_across = table.find(across)?[0];
            for column in chosen(table, column_across, wanted)? {
                let heading = &table.headings[column];
                let curve = Curve {
                    column: 0,
                    run,
                    pieces: pieces(&table.columns[column_across], &table.columns[column], x),
                };
                let known = found.iter_mut().find(|known| {
                    known.heading.name == heading.name && known.heading.unit == heading.unit
                });
                match known {
                    Some(known) => known.curves.push(curve),
                    None => found.push(Found {
                        heading: heading.clone(),
                        curves: vec![curve],
                    }),
                }
            }
        }
        let mut plot = Self {
            title: names::title(tables),
            across: title_across(&heading),
            path_unit: match heading.name.as_str() {
                "time" => String::new(),
                _ => heading.shown_unit().to_owned(),
            },
            runs: names::runs(tables),
            panels: Vec::new(),
        };
        for group in found.chunk_by(|a, b| is_of_one_vector(&a.heading, &b.heading)) {
            plot.add(group);
        }
        Ok(plot)
    }

    /// The same figure with another title.
    #[must_use]
    pub fn titled(self, title: &str) -> Self {
        Self {
            title: title.to_owned(),
            ..self
        }
    }

    /// Names of the runs for the legend.
    #[cfg(test)]
    pub(super) fn run_names(&self) -> &[String] {
        &self.runs
    }

    /// Indices of the columns of each panel.
    #[cfg(test)]
    pub(super) fn panel_columns(&self) -> Vec<usize> {
        self.panels
            .iter()
            .map(|panel| panel.columns.len())
            .collect()
    }

    /// Largest number of columns of one panel.
    fn most_columns(&self) -> usize {
        match self.runs.len() {
            0 | 1 => COLORS,
            2 => 4,
            runs if runs <= TONES => 3,
            _ => 1,
        }
    }

    /// Adds columns that belong together to the last panel of their unit that has space for all, or
    /// to new ones.
    fn add(&mut self, group: &[Found]) {
        let most = self.most_columns();
        for part in group.chunks(most) {
            let unit = part[0].heading.shown_unit();
            let last = self.panels.iter().rposition(|panel| panel.unit == unit);
            let fitting = last.filter(|k| self.panels[*k].columns.len() + part.len() <= most);
            let index = fitting.unwrap_or_else(|| {
                self.panels.push(Curves {
                    unit: unit.to_owned(),
                    columns: Vec::new(),
                    meanings: Vec::new(),
                    curves: Vec::new(),
                });
                self.panels.len() - 1
            });
            let panel = &mut self.panels[index];
            for found in part {
                let column = panel.columns.len();
                panel.columns.push(found.heading.name.clone());
                panel.meanings.push(found.heading.words.clone());
                let curves = found.curves.iter().cloned();
                let curves = curves.map(|curve| Curve { column, ..curve });
                panel.curves.extend(curves);
            }
            // Later runs are drawn on top of all curves of earlier ones.
            panel.curves.sort_by_key(|curve| curve.run);
        }
    }

    /// Omits panels after the first dozen; returns the names of their columns.
    pub fn shorten(&mut self) -> Vec<String> {
        let kept = self.panels.len().min(MOST_PANELS);
        let left_out = self.panels.drain(kept..).flat_map(|panel| panel.columns);
        left_out.collect()
    }

    /// Whether one figure can hold all panels.
    ///
    /// # Errors
    /// [`RunFileProblem`]: too many panels.
    pub fn check_size(&self) -> Result<(), RunFileProblem> {
        if self.full_height() <= MOST_HEIGHT {
            return Ok(());
        }
        let curves = self.panels.iter().map(|panel| panel.curves.len()).sum();
        let panels = self.panels.len();
        Err(RunFileProblem::ManyPanels { curves, panels })
    }

    fn full_height(&self) -> f64 {
        let panels = self.panels.iter().map(|panel| self.height(panel));
        self.head() + panels.sum::<f64>() + FOOT - GAPS[1]
    }

    /// Height of title and legend of runs.
    fn head(&self) -> f64 {
        let legend = self.legend_of_runs().map(|legend| legend.height(space()));
        HEAD + legend.map_or(0.0, |height| height + GAPS[0])
    }

    /// Height of the frame of a panel: a path has the scale of its other axis.
    fn frame(&self, curves: &Curves) -> f64 {
        if curves.unit != self.path_unit {
            return FRAME;
        }
        let [x, y] = [self.range(), self.values(curves)];
        (space() * (y[1] - y[0]) / (x[1] - x[0])).clamp(PATH[0], PATH[1])
    }

    /// Height of a panel with its legend.
    fn height(&self, curves: &Curves) -> f64 {
        self.legend(curves).height(space()) + GAPS[0] + self.frame(curves) + GAPS[1]
    }

    /// Horizontal range of all panels.
    fn range(&self) -> [f64; 2] {
        let all = self.panels.iter().flat_map(Curves::points);
        tight(all.map(|point| point[0]))
    }

    /// Whether colors distinguish the runs instead of the columns.
    fn is_by_run(&self) -> bool {
        self.runs.len() > 1 && self.panels.iter().all(|panel| panel.columns.len() == 1)
    }

    fn stroke(&self, curve: &Curve) -> Stroke {
        match self.runs.len() {
            0 | 1 => of_column(curve.column),
            runs if self.is_by_run() => of_run(curve.run, runs),
            _ => toned(of_column(curve.column), curve.run),
        }
    }

    /// Lines of the runs, if there are several.
    fn legend_of_runs(&self) -> Option<Legend> {
        let count = self.runs.len();
        let stroke = |run: usize| {
            if self.is_by_run() {
                of_run(run, count)
            } else {
                of_tone(run)
            }
        };
        let entries = self.runs.iter().enumerate();
        let entries = entries.map(|(run, name)| (name.clone(), Sample::Line(stroke(run))));
        let entries = entries.collect();
        (count > 1).then_some(Legend { entries })
    }

    /// Names of the columns of a panel, with their lines if colors distinguish them.
    fn legend(&self, panel: &Curves) -> Legend {
        let entry = |(column, name): (usize, &String)| {
            let mut curves = panel.curves.iter().filter(|curve| curve.column == column);
            let name = if curves.all(|curve| curve.pieces.is_empty()) {
                format!("{name} (no numbers)")
            } else {
                name.clone()
            };
            if self.is_by_run() {
                (name, Sample::None)
            } else {
                (name, Sample::Line(of_column(column)))
            }
        };
        let columns = panel.columns.iter().enumerate();
        Legend {
            entries: columns.map(entry).collect(),
        }
    }

    /// Magnitude up to which values of a unit are round-off.
    fn floor(&self, unit: &str) -> f64 {
        let of_unit = self.panels.iter().filter(|panel| panel.unit == unit);
        let largest = of_unit.map(Curves::largest).fold(0.0, f64::max);
        let angle = ANGLES.iter().find(|known| known.0 == unit);
        ROUND_OFF * largest.max(angle.map_or(0.0, |known| known.1))
    }

    /// Vertical range of a panel.
    fn values(&self, curves: &Curves) -> [f64; 2] {
        let values = curves.points().map(|point| point[1]);
        range(values, self.floor(&curves.unit))
    }

    /// Draws a panel whose legend begins at `top`.
    fn draw_panel(&self, drawing: &mut Drawing, curves: &Curves, (top, is_last): (f64, bool)) {
        let legend = self.legend(curves);
        let frame_top = top + legend.height(space()) + GAPS[0];
        let axes = Axes {
            left: MARGINS[0],
            right: MARGINS[0] + space(),
            top: frame_top,
            bottom: frame_top + self.frame(curves),
            x: self.range(),
            y: self.values(curves),
        };
        legend.draw(drawing, [axes.left, top], space());
        axes.draw_grid(drawing);
        for curve in &curves.curves {
            let stroke = self.stroke(curve);
            for piece in &curve.pieces {
                axes.curve(drawing, piece, stroke);
            }
        }
        let below = is_last.then_some(self.across.as_str());
        let length = axes.bottom - axes.top;
        let title = titles::title(&curves.columns, &curves.meanings, &curves.unit, length);
        axes.draw(drawing, below, &title);
        let largest = curves.largest();
        if largest > 0.0 && largest <= self.floor(&curves.unit) {
            let largest = short_number(largest, 2);
            let note = format!("zero up to round-off: at most {largest} {}", curves.unit);
            axes.note(drawing, &note);
        }
    }
}

impl Curves {
    /// Largest magnitude of a value.
    fn largest(&self) -> f64 {
        let values = self.points().map(|point| point[1].abs());
        values.fold(0.0, f64::max)
    }

    fn points(&self) -> impl Iterator<Item = &[f64; 2]> {
        let pieces = self.curves.iter().flat_map(|curve| &curve.pieces);
        pieces.flatten()
    }
}

impl Figure for TimePlot {
    fn size(&self) -> (u32, u32) {
        (WIDTH, self.full_height().ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 40.0]);
        if let Some(legend) = self.legend_of_runs() {
            legend.draw(drawing, [MARGINS[0], HEAD], space());
        }
        let mut top = self.head();
        for (number, curves) in self.panels.iter().enumerate() {
            let is_last = number + 1 == self.panels.len();
            self.draw_panel(drawing, curves, (top, is_last));
            top += self.height(curves);
        }
    }
}

/// Width of a frame \[figure pixels\].
fn space() -> f64 {
    f64::from(WIDTH) - MARGINS[0] - MARGINS[1]
}

/// Column of the horizontal axis, the same in all tables, and its range.
fn common_heading(
    tables: &[TimeTable],
    across: &str,
) -> Result<(Heading, [f64; 2]), RunFileProblem> {
    let mut first: Option<&Heading> = None;
    let mut values = Vec::new();
    for table in tables {
        if table.rows() < 2 {
            let (file, rows) = (table.file.clone(), table.rows());
            return Err(RunFileProblem::NoRows { file, rows });
        }
        let index = table.find(across)?[0];
        let heading = &table.headings[index];
        let known = *first.get_or_insert(heading);
        if known.unit != heading.unit {
            return Err(RunFileProblem::OtherUnit {
                name: heading.name.clone(),
                file: table.file.clone(),
                units: [known, heading].map(|heading| heading.shown_unit().to_owned()),
            });
        }
        let numbers = table.columns[index].iter();
        values.extend(numbers.copied().filter(|value| value.is_finite()));
    }
    let heading = first.cloned().unwrap_or_else(Heading::time);
    Ok((heading, tight(values.into_iter())))
}

/// Meaning, or else name, and unit of the horizontal axis.
fn title_across(heading: &Heading) -> String {
    let words = Some(&heading.words).filter(|words| !words.is_empty());
    let unit = heading.shown_unit().replace('*', " ");
    format!("{} [{unit}]", words.unwrap_or(&heading.name))
}

/// Whether two columns have one unit and names that differ only after the last `_`.
fn is_of_one_vector(a: &Heading, b: &Heading) -> bool {
    let first = |heading: &Heading| Some(heading.name.rsplit_once('_')?.0.to_owned());
    a.unit == b.unit && first(a).is_some() && first(a) == first(b)
}

/// Indices of the drawn columns.
fn chosen(table: &TimeTable, x: usize, wanted: &[String]) -> Result<Vec<usize>, RunFileProblem> {
    if wanted.is_empty() {
        return Ok((0..table.headings.len())
            .filter(|column| *column != x && table.headings[*column].name != "time")
            .collect());
    }
    let mut all = Vec::new();
    for name in wanted {
        for column in table.find(name)? {
            if !all.contains(&column) {
                all.push(column);
            }
        }
    }
    Ok(all)
}

/// The curve in pieces without its gaps, each with the points that show all of it in the range
/// `range` of `x`.
fn pieces(x: &[f64], y: &[f64], range: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let points: Vec<_> = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
    let is_number = |point: &[f64; 2]| point.iter().all(|value| value.is_finite());
    let all = points.split(|point| !is_number(point));
    let pieces = all.filter(|piece| !piece.is_empty());
    pieces.map(|piece| thinned(piece, range, space())).collect()
}

/// The range of values without margins.
fn tight(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low < high {
        [low, high]
    } else {
        range([low, high], 0.0)
    }
}
