//! Maps of the coefficients of a turbine over tip speed ratio and pitch: colors and contours.

use shared_geom::figure::{
    Anchor, Axes, BLACK, Drawing, Figure, INK, Label, SMALL, Stroke, TEXT, ValueTriangle, WHITE,
    WIDTH,
};

use super::columns::{Column, TURBINE_CP, TURBINE_CT};
use crate::output::color_bar::{CONTOUR, ColorBar};
use crate::result::{PerformancePoint, PerformanceResult, PerformanceTable};

const HEIGHT: u32 = 1000;
/// Size of the mark of the largest value.
const MARK: f64 = 9.0;

/// A coefficient on the grid.
#[derive(Debug, Clone, PartialEq)]
struct Grid {
    name: &'static str,
    /// Rows of equal pitch.
    values: Vec<Vec<f64>>,
    /// Largest value of the maps of all parts.
    high: f64,
}

impl Grid {
    /// Colors from zero on.
    fn bar(&self) -> ColorBar {
        ColorBar {
            range: [0.0, self.high],
        }
    }
}

/// Maps of both coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct MapPlot {
    title: String,
    ratios: Vec<f64>,
    pitches: Vec<f64>,
    grids: Vec<Grid>,
}

impl MapPlot {
    /// The maps of a table; `None` if it is no grid.
    pub(super) fn new(result: &PerformanceResult, table: &PerformanceTable) -> Option<Self> {
        if !table.is_map {
            return None;
        }
        let rows: Vec<&[PerformancePoint]> = table.curves().map(|(_, points)| points).collect();
        let ratios = rows.first()?.iter().map(|point| table.at(point));
        let ratios: Vec<f64> = ratios.collect();
        let pitches = rows.iter().filter_map(|row| row.first());
        let pitches = pitches.map(|point| point.setting().pitch.to_degrees());
        let grid = |column: Column| {
            let row = |row: &&[PerformancePoint]| row.iter().map(column.value).collect::<Vec<_>>();
            let values: Vec<Vec<f64>> = rows.iter().map(row).collect();
            // The maps of all parts have the same colors.
            let parts = result.tables.iter().filter(|table| table.is_map);
            let all = parts.flat_map(|table| &table.points).map(column.value);
            let finite = all.filter(|value| value.is_finite());
            let high = finite.fold(0.0_f64, f64::max);
            (high > 0.0).then_some(Grid {
                name: column.name,
                values,
                high,
            })
        };
        let grids = [TURBINE_CP, TURBINE_CT].into_iter().filter_map(grid);
        let grids: Vec<Grid> = grids.collect();
        (!grids.is_empty()).then(|| Self {
            title: format!("{}: {}", result.name, table.name),
            ratios,
            pitches: pitches.collect(),
            grids,
        })
    }

    /// The four corners of each cell with their values: ratio, pitch, value.
    fn cells<'a>(&'a self, grid: &'a Grid) -> impl Iterator<Item = [[f64; 3]; 4]> + 'a {
        let corner = |i: usize, j: usize| [self.ratios[j], self.pitches[i], grid.values[i][j]];
        let rows = 0..self.pitches.len().saturating_sub(1);
        rows.flat_map(move |i| {
            let columns = 0..self.ratios.len().saturating_sub(1);
            columns.map(move |j| {
                [
                    corner(i, j),
                    corner(i, j + 1),
                    corner(i + 1, j + 1),
                    corner(i + 1, j),
                ]
            })
        })
    }

    fn draw_grid(&self, drawing: &mut Drawing, axes: &Axes, grid: &Grid) {
        let mut triangles = Vec::new();
        for cell in self.cells(grid) {
            for corners in [[0, 1, 2], [0, 2, 3]] {
                let corner = |index: usize| cell[corners[index]];
                triangles.push(ValueTriangle {
                    corners: [0, 1, 2].map(|k| axes.position([corner(k)[0], corner(k)[1]])),
                    values: [0, 1, 2].map(|k| corner(k)[2]),
                });
            }
        }
        let bar = grid.bar();
        drawing.shade(triangles, |value| bar.color(value));
        for level in bar.levels() {
            for cell in self.cells(grid) {
                for [start, end] in crossings(&cell, level) {
                    let ends = [axes.position(start), axes.position(end)];
                    Stroke::new(CONTOUR, WHITE).draw(drawing, &ends);
                }
            }
        }
    }

    /// The ratio, the pitch and the value of the largest coefficient.
    fn largest(&self, grid: &Grid) -> Option<[f64; 3]> {
        let rows = grid.values.iter().zip(&self.pitches);
        let all = rows.flat_map(|(row, pitch)| {
            let row = row.iter().zip(&self.ratios);
            row.map(move |(value, ratio)| [*ratio, *pitch, *value])
        });
        all.filter(|it| it[2].is_finite())
            .max_by(|a, b| a[2].total_cmp(&b[2]))
    }
}

/// The pieces of a contour in a cell, which is cut into two triangles.
fn crossings(cell: &[[f64; 3]; 4], level: f64) -> Vec<[[f64; 2]; 2]> {
    let mut pieces = Vec::new();
    for corners in [[0, 1, 2], [0, 2, 3]] {
        let mut ends = Vec::new();
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let (a, b) = (cell[corners[a]], cell[corners[b]]);
            if (a[2] < level) != (b[2] < level) {
                let part = (level - a[2]) / (b[2] - a[2]);
                ends.push([a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])]);
            }
        }
        if let [start, end] = ends[..]
            && [start, end].iter().flatten().all(|it| it.is_finite())
        {
            pieces.push([start, end]);
        }
    }
    pieces
}

impl Figure for MapPlot {
    fn size(&self) -> (u32, u32) {
        (WIDTH, HEIGHT)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        let (first, last) = (
            |list: &[f64]| list.first().copied(),
            |list: &[f64]| list.last().copied(),
        );
        let ends = |list: &[f64]| [first(list).unwrap_or(0.0), last(list).unwrap_or(1.0)];
        let half = 0.5 * f64::from(WIDTH);
        for (index, grid) in self.grids.iter().enumerate() {
            let start = index as f64 * half;
            let axes = Axes {
                left: start + 170.0,
                right: start + half - 150.0,
                top: 160.0,
                bottom: f64::from(HEIGHT) - 130.0,
                x: ends(&self.ratios),
                y: ends(&self.pitches),
            };
            self.draw_grid(drawing, &axes, grid);
            let title = Label::new(TEXT).colored(INK);
            drawing.text(
                &format!("{} [-]", grid.name),
                [axes.left, axes.top - 36.0],
                title,
            );
            if let Some([ratio, pitch, value]) = self.largest(grid) {
                let at = axes.position([ratio, pitch]);
                drawing.ring(at, MARK, 3.0, BLACK);
                let text = format!("largest {value:.3}");
                let label = Label::new(SMALL).colored(INK).anchored(Anchor::End);
                drawing.text(&text, [axes.right, axes.top - 36.0], label);
            }
            grid.bar()
                .draw(drawing, axes.right, [axes.top, axes.bottom]);
            axes.draw(drawing, Some("tip speed ratio [-]"), "pitch [deg]");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The plane z = x over the unit square: the contour at 1/4 is the line x = 1/4, in two
    /// pieces.
    #[test]
    fn contours_of_a_plane_are_straight() {
        let cell = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 1.0],
            [1.0, 1.0, 1.0],
            [0.0, 1.0, 0.0],
        ];
        let found = crossings(&cell, 0.25);
        assert_eq!(found.len(), 2);
        assert!(
            found
                .iter()
                .flatten()
                .all(|point| (point[0] - 0.25).abs() < 1e-15)
        );
        assert!(crossings(&cell, 2.0).is_empty());
        let broken = cell.map(|[x, y, _]| [x, y, f64::NAN]);
        assert!(crossings(&broken, 0.25).is_empty());
    }
}
