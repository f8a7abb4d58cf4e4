//! The fan plot: frequencies over rotor speed, with the multiples of the speed.

use std::path::Path;

use plotters::backend::DrawingBackend;
use plotters::style::RGBColor;
use shared_geom::figure::{CATEGORIES, Canvas, Drawing, FigureProblem, Label, TEXT, WIDTH};
use shared_geom::files::{OutputProblem, write_figure};

use super::text::{DAMPED, RPM};
use crate::result::{FrequencyTable, Measured, ModeBranch, ModeKind};

mod axes;
mod boxes;
mod curves;
mod damping;
mod labels;
mod legend;
mod per_rev;

use axes::Axes;
use boxes::Obstacles;

/// Width and height, without the damping \[figure pixels\].
const SIZE: (u32, u32) = (WIDTH, 1250);
/// Height of the plot of damping below \[figure pixels\].
const DAMPING: u32 = 480;
/// Size of labels next to lines.
const SMALL: f64 = 0.8 * TEXT;
/// Colors of modes: the colors of categories without yellow, which is faint as a line.
const COLORS: usize = CATEGORIES.len() - 1;

/// A fan plot, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct FanPlot {
    title: String,
    /// Rotor speeds \[rpm\].
    speeds: Vec<f64>,
    curves: Vec<Curve>,
    /// Measured speeds \[rpm\] and frequencies \[Hz\].
    measured: Vec<[f64; 2]>,
}

/// One mode: its frequency at each speed.
#[derive(Debug, Clone, PartialEq)]
struct Curve {
    name: String,
    kind: ModeKind,
    /// Frequencies \[Hz\].
    frequencies: Vec<Option<f64>>,
    color: RGBColor,
    /// Damping ratios \[%\].
    damping: Vec<Option<f64>>,
    /// Pattern of the line: a different one for each repetition of the colors.
    pattern: usize,
}

impl FanPlot {
    /// The plot of `table` and the measured points; `None` for fewer than two speeds, which make no
    /// lines, and without modes.
    pub fn new(table: &FrequencyTable, measured: &Measured) -> Option<Self> {
        let speeds: Vec<_> = table.speeds.iter().map(|speed| speed * RPM).collect();
        let shown = |branch: &&ModeBranch| branch.points.iter().any(Option::is_some);
        let curves: Vec<_> = table
            .branches
            .iter()
            .filter(shown)
            .enumerate()
            .map(|(index, branch)| Curve::new(index, branch, speeds.len()))
            .collect();
        let points = measured
            .points
            .iter()
            .map(|point| [point.speed * RPM, point.frequency]);
        (speeds.len() > 1 && !curves.is_empty()).then(|| Self {
            title: table.name.clone(),
            speeds,
            curves,
            measured: points.collect(),
        })
    }

    /// Writes the plot to `path`, as PNG or SVG by its ending.
    ///
    /// # Errors
    /// [`FigureProblem`]: another ending, or a file that cannot be written.
    pub fn save(&self, path: &Path) -> Result<(), OutputProblem> {
        let below = if self.is_damped() { DAMPING } else { 0 };
        write_figure(path, (SIZE.0, SIZE.1 + below), self)
    }
}

impl FanPlot {
    /// Whether any mode is damped or grows.
    fn is_damped(&self) -> bool {
        let mut ratios = self.curves.iter().flat_map(|c| c.damping.iter().flatten());
        ratios.any(|per_cent| per_cent.abs() > 100.0 * DAMPED)
    }

    /// The name above all, in smaller letters if it is long.
    fn draw_title<B: DrawingBackend>(
        &self,
        canvas: &Canvas<B>,
        axes: &Axes,
    ) -> Result<(), FigureProblem> {
        // Bold letters are wider than the measured ones.
        let width = 1.2 * canvas.text_width(&self.title, TEXT);
        let (total, height) = (canvas.size().0, f64::from(SIZE.1));
        let size = TEXT * ((total - axes.left - 24.0) / width).min(1.0);
        canvas.text(
            &self.title,
            [axes.left, 0.032 * height],
            Label::new(size).bold(),
        )
    }
}

impl Curve {
    fn new(index: usize, branch: &ModeBranch, speeds: usize) -> Self {
        let point = |k: usize| branch.points.get(k).and_then(Option::as_ref);
        Self {
            name: branch.name.clone(),
            kind: branch.kind,
            frequencies: (0..speeds)
                .map(|k| point(k).map(|point| point.frequency))
                .collect(),
            damping: (0..speeds)
                .map(|k| point(k).map(|point| 100.0 * point.damping_ratio))
                .collect(),
            color: CATEGORIES[index % COLORS],
            pattern: index / COLORS,
        }
    }

    /// Whether there are points at half of the speeds at least: shorter ones are mostly pieces of a
    /// mode of a multiple frequency, of which not all modes were requested.
    fn is_long(&self) -> bool {
        2 * self.frequencies.iter().flatten().count() >= self.frequencies.len()
    }

    /// Speed number and frequency of the last point.
    fn end(&self) -> Option<(usize, f64)> {
        let points = self.frequencies.iter().enumerate();
        points
            .rev()
            .find_map(|(k, frequency)| Some((k, (*frequency)?)))
    }
}

impl Drawing for FanPlot {
    fn draw<B: DrawingBackend>(&self, canvas: &Canvas<B>) -> Result<(), FigureProblem> {
        let axes = Axes::new(canvas, self);
        let multiples = per_rev::multiples(&axes);
        let mut obstacles = Obstacles::default();
        for curve in &self.curves {
            for run in curves::frequency_runs(self, curve, &axes) {
                obstacles.add_line(&run);
            }
        }
        for &point in &self.measured {
            obstacles.add_disc(axes.place(point), curves::RING);
        }

        per_rev::draw_lines(canvas, &multiples)?;
        let at_ends = labels::beside_ends(canvas, self, &axes, &mut obstacles)?;
        per_rev::draw_labels(canvas, &axes, &multiples, &mut obstacles)?;
        curves::draw(canvas, self, &axes)?;
        at_ends.draw(canvas)?;
        labels::draw_column(canvas, self, &axes)?;
        if self.is_damped() {
            damping::draw(canvas, self, &axes)?;
        }
        axes.draw(canvas, self.is_damped())?;
        self.draw_title(canvas, &axes)?;
        legend::draw(canvas, self, &axes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn one_speed_has_no_plot() {
        let mut table = samples::small();
        assert!(FanPlot::new(&table, &Measured::default()).is_some());
        table.speeds.truncate(1);
        assert_eq!(FanPlot::new(&table, &Measured::default()), None);
        table.branches.clear();
        assert_eq!(FanPlot::new(&table, &Measured::default()), None);
    }

    #[test]
    fn the_plot_names_axes_modes_and_multiples() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fan.svg");
        let plot = FanPlot::new(&samples::swept_tip(9), &samples::epps_chandra()).unwrap();
        plot.save(&path).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        for expected in [
            "swept tip, 15 deg",
            "rotor speed [rpm]",
            "frequency [Hz]",
            "measured",
            "flap 1",
            "axial 1",
            "coupled 1",
            "1P",
            "10P",
        ] {
            assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
        }
    }

    // If a measured point lies beyond the last speed, the names are at the ends of the lines within
    // the frame; a line from there to the column beyond the frame would look like more of the
    // curve.
    #[test]
    fn no_line_is_drawn_beyond_the_last_speed() {
        let table = samples::swept_tip(3);
        let mut measured = Measured::default();
        let lines = |measured: &Measured| {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("fan.svg");
            let plot = FanPlot::new(&table, measured).unwrap();
            plot.save(&path).unwrap();
            let text = std::fs::read_to_string(&path).unwrap();
            assert!(text.contains("\nflap 1\n"));
            let color = plot.curves[0].color;
            let color = format!("#{:02X}{:02X}{:02X}", color.0, color.1, color.2);
            let of_color = |line: &&str| line.contains("polyline") && line.contains(&color);
            text.lines().filter(of_color).count()
        };
        let with_leaders = lines(&measured);
        measured.points.push(crate::result::MeasuredPoint {
            speed: 2.0 * table.speeds[2],
            frequency: 10.0,
            order: None,
        });
        assert!(lines(&measured) < with_leaders);
    }

    #[test]
    fn damping_is_drawn_below_where_there_is_any() {
        let draw = |table: &FrequencyTable| {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("fan.svg");
            let plot = FanPlot::new(table, &Measured::default()).unwrap();
            plot.save(&path).unwrap();
            std::fs::read_to_string(&path).unwrap()
        };
        let title = "\ndamping ratio [%]\n";
        let damped = draw(&samples::crowded());
        assert!(damped.contains(title));
        assert_eq!(damped.matches("\nrotor speed [rpm]\n").count(), 1);
        assert!(!draw(&samples::swept_tip(3)).contains(title));
    }

    #[test]
    fn a_short_piece_of_a_line_has_no_name() {
        let mut table = samples::swept_tip(9);
        let named = |table: &FrequencyTable| {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("fan.svg");
            let plot = FanPlot::new(table, &Measured::default()).unwrap();
            plot.save(&path).unwrap();
            let text = std::fs::read_to_string(&path).unwrap();
            text.contains("\naxial 1\n")
        };
        // Five points of nine, then three.
        assert!(named(&table));
        table.branches[9].points[3..].fill(None);
        assert!(!named(&table));
    }

    // Colors repeat with other patterns, never alone.
    #[test]
    fn no_two_modes_look_alike() {
        let plot = FanPlot::new(&samples::crowded(), &Measured::default()).unwrap();
        assert_eq!(plot.curves.len(), 4 * COLORS);
        let looks: Vec<_> = plot.curves.iter().map(|c| (c.color, c.pattern)).collect();
        for (i, look) in looks.iter().enumerate() {
            assert!(!looks[i + 1..].contains(look), "{i}");
        }
    }
}
