//! Columns of runs over time: a panel for each unit.

use std::path::Path;

use plotters::backend::DrawingBackend;
use shared_geom::figure::{Anchor, Canvas, Drawing, FigureProblem, Label, TEXT, WIDTH, category};
use shared_geom::files::{OutputProblem, write_figure};

use super::{Heading, RunFileProblem, TimeTable};
use crate::output::panel::{Panel, SMALL, draw_legend, draw_title, range};

/// Curves of one panel at most; more are divided.
const MOST_CURVES: usize = 7;
/// Parts of the width in each of which a curve shows its least and its largest value.
const PARTS: usize = 1500;
/// Panels of the figure of a run at most.
const MOST_PANELS: usize = 12;
/// Height of a figure at most \[figure pixels\].
const MOST_HEIGHT: f64 = 20_000.0;
const LINE: f64 = 3.5;
/// Heights \[figure pixels\].
const HEAD: f64 = 90.0;
const FRAME: f64 = 340.0;
/// Least and largest height of a path that is drawn in equal scales.
const PATH: [f64; 2] = [FRAME, 1600.0];
/// Left and right margin.
const MARGINS: [f64; 2] = [210.0, 50.0];
const GAP: f64 = 70.0;
const FOOT: f64 = 120.0;
const LEGEND_ROW: f64 = 1.4 * SMALL;

/// Curves over time or over another column, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct TimePlot {
    title: String,
    /// Name and unit of what goes to the right.
    across: String,
    /// Unit of a place that goes to the right, over which a place of the same unit is drawn
    /// as a path; empty over time.
    path_unit: String,
    panels: Vec<Curves>,
}

/// The curves of a panel.
#[derive(Debug, Clone, PartialEq)]
struct Curves {
    unit: String,
    curves: Vec<Curve>,
}

/// One column of one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Name of the column, with the run where there are several.
    pub name: String,
    /// Points, in runs without a gap [units of the columns].
    pub pieces: Vec<Vec<[f64; 2]>>,
}

impl TimePlot {
    /// The columns `wanted` of `tables` over the column `across`; all columns when none is
    /// wanted, of further tables those that they have. A name that ends in `*` stands for
    /// all that begin so.
    ///
    /// # Errors
    /// [`RunFileProblem`]: a column that a table does not have, or fewer than two rows.
    pub fn new(
        title: &str,
        tables: &[TimeTable],
        across: &str,
        wanted: &[String],
    ) -> Result<Self, RunFileProblem> {
        let mut plot = Self {
            title: title.to_owned(),
            across: String::new(),
            path_unit: String::new(),
            panels: Vec::new(),
        };
        let names = short_names(tables);
        let mut found: Vec<(Heading, Vec<Curve>)> = Vec::new();
        for (table, short) in tables.iter().zip(&names) {
            if table.rows() < 2 {
                let (file, rows) = (table.file.clone(), table.rows());
                return Err(RunFileProblem::NoRows { file, rows });
            }
            let x = table.find(across)?[0];
            plot.across = labeled(&table.headings[x]);
            if table.headings[x].name != "time" {
                plot.path_unit = table.headings[x].shown_unit().to_owned();
            }
            for column in chosen(table, x, wanted)? {
                let heading = &table.headings[column];
                let curve = Curve {
                    name: match tables.len() {
                        1 => heading.name.clone(),
                        _ => format!("{} ({short})", heading.name),
                    },
                    pieces: pieces(&table.columns[x], &table.columns[column]),
                };
                let is_same =
                    |other: &Heading| other.name == heading.name && other.unit == heading.unit;
                match found.iter_mut().find(|(other, _)| is_same(other)) {
                    Some((_, curves)) => curves.push(curve),
                    None => found.push((heading.clone(), vec![curve])),
                }
            }
        }
        for (heading, curves) in found {
            plot.add(heading.shown_unit(), curves);
        }
        Ok(plot)
    }

    /// Adds the curves of one column to the last panel of its unit, or to a new one.
    fn add(&mut self, unit: &str, curves: Vec<Curve>) {
        let last = self.panels.iter_mut().rfind(|panel| panel.unit == unit);
        match last {
            Some(panel) if panel.curves.len() + curves.len() <= MOST_CURVES => {
                panel.curves.extend(curves);
            }
            _ => self.panels.push(Curves {
                unit: unit.to_owned(),
                curves,
            }),
        }
    }

    /// Leaves out panels after the first dozen; names of their curves.
    pub fn shorten(&mut self) -> Vec<String> {
        let kept = self.panels.len().min(MOST_PANELS);
        let left_out = self.panels.drain(kept..).flat_map(|panel| panel.curves);
        left_out.map(|curve| curve.name).collect()
    }

    /// Whether one figure can hold all panels.
    ///
    /// # Errors
    /// [`RunFileProblem`]: there are too many.
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
        HEAD + panels.sum::<f64>() + FOOT - GAP
    }

    /// Height of the frame of a panel: a path has the scale of its other axis.
    fn frame(&self, curves: &Curves) -> f64 {
        if curves.unit != self.path_unit {
            return FRAME;
        }
        let all = self.panels.iter().flat_map(Curves::points);
        let [x, y] = [tight(all.map(|point| point[0])), curves.range()];
        let width = f64::from(WIDTH) - MARGINS[0] - MARGINS[1];
        (width * (y[1] - y[0]) / (x[1] - x[0])).clamp(PATH[0], PATH[1])
    }

    /// Height of a panel with its legend.
    fn height(&self, curves: &Curves) -> f64 {
        curves.legend_rows() * LEGEND_ROW + self.frame(curves) + GAP
    }

    /// Writes the plot to `path`, as PNG or SVG by its ending.
    ///
    /// # Errors
    /// [`OutputProblem`]: another ending, or a file that cannot be written.
    pub fn save(&self, path: &Path) -> Result<(), OutputProblem> {
        write_figure(path, (WIDTH, self.full_height().ceil() as u32), self)
    }
}

impl Curves {
    /// Rows of the legend: they are broken where names are long.
    fn legend_rows(&self) -> f64 {
        // Letters are about half as wide as high.
        let width = |curve: &Curve| 112.0 + 0.55 * SMALL * curve.name.chars().count() as f64;
        let all: f64 = self.curves.iter().map(width).sum();
        (all / (f64::from(WIDTH) - 400.0)).ceil().max(1.0)
    }

    fn range(&self) -> [f64; 2] {
        range(self.points().map(|point| point[1]), 0.0)
    }

    fn points(&self) -> impl Iterator<Item = &[f64; 2]> {
        let pieces = self.curves.iter().flat_map(|curve| &curve.pieces);
        pieces.flatten()
    }
}

impl Drawing for TimePlot {
    fn draw<B: DrawingBackend>(&self, canvas: &Canvas<B>) -> Result<(), FigureProblem> {
        let (width, height) = canvas.size();
        draw_title(canvas, &self.title, [40.0, 44.0])?;
        let all = self.panels.iter().flat_map(Curves::points);
        let x = tight(all.map(|point| point[0]));
        let [left, right] = MARGINS;
        let mut top = HEAD;
        for (number, curves) in self.panels.iter().enumerate() {
            let frame_top = top + curves.legend_rows() * LEGEND_ROW;
            let panel = Panel {
                left,
                right: width - right,
                top: frame_top,
                bottom: frame_top + self.frame(curves),
                x,
                y: curves.range(),
            };
            let entries: Vec<_> = curves
                .curves
                .iter()
                .enumerate()
                .map(|(k, curve)| (curve.name.clone(), 2.0 * LINE, category(k)))
                .collect();
            draw_legend(canvas, [panel.left, top], &entries)?;
            panel.draw_zero(canvas)?;
            for (k, curve) in curves.curves.iter().enumerate() {
                for piece in &curve.pieces {
                    panel.curve(canvas, piece, LINE, category(k))?;
                }
            }
            panel.draw_frame(canvas, [8, 5], number + 1 == self.panels.len())?;
            let middle = 0.5 * (panel.top + panel.bottom);
            let label = Label::new(TEXT).anchored(Anchor::Middle).upward();
            canvas.text(&format!("[{}]", curves.unit), [44.0, middle], label)?;
            top += self.height(curves);
        }
        let label = Label::new(TEXT).anchored(Anchor::Middle);
        let middle = 0.5 * (left + width - right);
        canvas.text(&self.across, [middle, height - 36.0], label)
    }
}

fn labeled(heading: &Heading) -> String {
    format!("{} [{}]", heading.name, heading.shown_unit())
}

/// Places of the columns that are drawn.
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

/// File names without what all results are called, with the folder where they are equal.
fn short_names(tables: &[TimeTable]) -> Vec<String> {
    let short = |table: &TimeTable| {
        let path = Path::new(&table.file);
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let endings = [".transient.csv", ".transient.nc", ".csv", ".nc"];
        let stem = endings.iter().find_map(|ending| name.strip_suffix(ending));
        stem.unwrap_or(&name).to_owned()
    };
    let names: Vec<_> = tables.iter().map(short).collect();
    let is_alone = |name: &String| names.iter().filter(|other| *other == name).count() == 1;
    let both = names.iter().zip(tables);
    both.map(|(name, table)| match is_alone(name) {
        true => name.clone(),
        false => table.file.clone(),
    })
    .collect()
}

/// The curve without its gaps, each piece with the least and the largest value of every
/// part of the width.
fn pieces(x: &[f64], y: &[f64]) -> Vec<Vec<[f64; 2]>> {
    let points: Vec<_> = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
    let is_number = |point: &[f64; 2]| point.iter().all(|value| value.is_finite());
    let all = points.split(|point| !is_number(point));
    let size = (points.len() / PARTS).max(1);
    let pieces = all.filter(|piece| !piece.is_empty());
    pieces
        .map(|piece| match size {
            1 | 2 => piece.to_vec(),
            size => thinned(piece, size),
        })
        .collect()
}

/// Of each `size` points the first, the least, the largest and the last, in their order.
fn thinned(points: &[[f64; 2]], size: usize) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    for part in points.chunks(size) {
        let by_value = |a: &usize, b: &usize| part[*a][1].total_cmp(&part[*b][1]);
        let least = (0..part.len()).min_by(by_value).unwrap_or(0);
        let largest = (0..part.len()).max_by(by_value).unwrap_or(0);
        let mut places = vec![0, least, largest, part.len() - 1];
        places.sort_unstable();
        places.dedup();
        kept.extend(places.into_iter().map(|place| part[place]));
    }
    kept
}

/// The range of values without room at its ends.
fn tight(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    match low < high {
        true => [low, high],
        false => range([low, high], 0.0),
    }
}
