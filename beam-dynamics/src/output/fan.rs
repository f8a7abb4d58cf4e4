//! The fan plot: frequencies over rotor speed, with the multiples of the speed.

use shared_geom::figure::{Color, Drawing, Figure, WIDTH};

use super::text::DAMPED;
use crate::case::{FrequencyUnit, Words};
use crate::input::short_number;
use crate::result::{CriticalSpeed, FixedTable, FrequencyTable, Measured, ModeKind};

mod axes;
mod boxes;
mod curves;
mod damping;
mod fixed;
mod groups;
mod labels;
mod legend;
mod looks;
mod marked;
mod per_rev;

use boxes::Obstacles;
use groups::{Group, groups};
use marked::{MARKED, Marked};

/// Width and height, without the damping \[figure pixels\].
const SIZE: (u32, u32) = (WIDTH, 1250);
/// Height of the plot of damping below \[figure pixels\].
const DAMPING: u32 = 480;
/// Position of the legend \[figure pixels\].
const LEGEND: f64 = 70.0;
/// Largest frequency per revolution that is drawn, over the largest at the last speed.
const PER_REV_LIMIT: f64 = 1.6;
/// Frequencies over the largest multiple at the last speed beyond which the critical speeds would be
/// pressed together at the lower edge; and where modes are then no more drawn.
const PRESSED: f64 = 5.0;
const FAR: f64 = 2.0;

/// A fan plot, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct FanPlot {
    title: String,
    /// Rotor speeds in the unit that belongs to the unit of the frequencies.
    speeds: Vec<f64>,
    /// Unit of all frequencies.
    unit: FrequencyUnit,
    /// Name of the vertical axis, without the unit.
    axis: &'static str,
    words: Words,
    /// Multiples of the rotor speed that are drawn; `None`: the first ten, and some above.
    multiples: Option<Vec<u32>>,
    curves: Vec<Curve>,
    /// Measured speeds and frequencies.
    measured: Vec<[f64; 2]>,
    /// Critical speeds and frequencies.
    critical: Vec<[f64; 2]>,
    /// Which critical speeds are marked, as text.
    marked: String,
    /// Remark on modes far above the multiples of the speed, which are not drawn.
    above: Option<String>,
    /// Patterns of lines with their meaning; none where they only distinguish modes.
    patterns: Vec<(usize, String)>,
}

/// One mode, or modes that coincide: the frequency at each speed.
#[derive(Debug, Clone, PartialEq)]
struct Curve {
    name: String,
    /// Kind of the name.
    kind: ModeKind,
    /// Kind at each speed.
    kinds: Vec<Option<ModeKind>>,
    /// Frequencies in the unit of the plot.
    frequencies: Vec<Option<f64>>,
    /// Speeds at which the line is reflected at zero.
    zeros: Vec<f64>,
    color: Color,
    /// Damping ratios \[%\].
    damping: Vec<Option<f64>>,
    /// Pattern of the line.
    pattern: usize,
}

impl FanPlot {
    /// The plot of `table` in the turning axes and the measured points; `None` for fewer than two
    /// speeds, which make no lines, and without modes.
    pub fn new(table: &FrequencyTable, measured: &Measured) -> Option<Self> {
        let mut plot = Self::empty(table, "frequency in the turning axes");
        let groups = groups(table);
        let first = groups.iter().map(Group::first);
        let stems: Vec<_> = first.map(|branch| (branch.kind, branch.stem())).collect();
        let curves = groups.iter().zip(looks::looks(&stems));
        let curves = curves.map(|(group, look)| Curve::of_group(group, look, table));
        plot.curves = curves.collect();
        plot.measured = measured
            .points
            .iter()
            .filter_map(|point| {
                let value = plot.unit.value(point.frequency, point.speed)?;
                Some([plot.unit.speed(point.speed), value])
            })
            .collect();
        plot.mark(&table.critical_of_blade(&table.harmonics()));
        plot.marked = MARKED.to_owned();
        plot.cut();
        (plot.speeds.len() > 1 && !plot.curves.is_empty()).then_some(plot)
    }

    /// The plot of `fixed`, the modes of `table` as seen from the fixed system: the Campbell
    /// diagram.
    pub fn campbell(table: &FrequencyTable, fixed: &FixedTable) -> Self {
        let mut plot = Self::empty(table, "frequency in the fixed system");
        plot.multiples = Some(table.harmonics());
        plot.patterns = fixed::patterns(fixed, table);
        plot.curves = fixed::curves(fixed, table);
        let marked = Marked::new(table, &fixed.critical);
        plot.mark(&marked.speeds);
        plot.marked = marked.text;
        plot.cut();
        plot.leave_out_far(&table.harmonics());
        plot
    }

    /// Marks critical speeds.
    fn mark(&mut self, critical: &[CriticalSpeed]) {
        let position = |critical: &CriticalSpeed| {
            let value = self.unit.value(critical.frequency, critical.speed)?;
            Some([self.unit.speed(critical.speed), value])
        };
        self.critical = critical.iter().filter_map(position).collect();
    }

    /// A plot of `table` without curves.
    fn empty(table: &FrequencyTable, axis: &'static str) -> Self {
        let style = &table.style;
        let chosen = !style.harmonics.is_empty() || table.blades() > 1;
        Self {
            title: table.name.clone(),
            speeds: table.speeds.iter().map(|s| style.unit.speed(*s)).collect(),
            unit: style.unit,
            axis,
            words: style.words,
            multiples: chosen.then(|| table.harmonics()),
            curves: Vec::new(),
            measured: Vec::new(),
            critical: Vec::new(),
            marked: String::new(),
            above: None,
            patterns: Vec::new(),
        }
    }

    /// Drops points far above those at the last speed: frequencies over a small rotor speed.
    fn cut(&mut self) {
        if self.unit != FrequencyUnit::PerRevolution {
            return;
        }
        let ends = self.curves.iter().filter_map(|curve| Some(curve.end()?.1));
        let limit = PER_REV_LIMIT * ends.fold(1.0, f64::max);
        for curve in &mut self.curves {
            let values = curve.frequencies.iter_mut();
            values.for_each(|value| *value = value.filter(|value| *value <= limit));
        }
        self.critical.retain(|point| point[1] <= limit);
        self.measured.retain(|point| point[1] <= limit);
    }
}

impl FanPlot {
    /// Leaves out curves that are far above the largest multiple of the last speed at all speeds, if
    /// they would press the critical speeds together.
    fn leave_out_far(&mut self, multiples: &[u32]) {
        let most = f64::from(multiples.iter().copied().max().unwrap_or(0));
        let last = self.speeds.last().copied().unwrap_or(0.0);
        let reach = match self.unit {
            FrequencyUnit::PerRevolution => most,
            // A speed in rpm is a frequency in 1/min.
            FrequencyUnit::RadiansPerSecond => most * last,
            unit => unit.value(most * last / 60.0, 0.0).unwrap_or(0.0),
        };
        let values = |curve: &Curve| {
            curve
                .frequencies
                .iter()
                .flatten()
                .copied()
                .collect::<Vec<_>>()
        };
        let lowest = |curve: &Curve| values(curve).into_iter().fold(f64::INFINITY, f64::min);
        let all = self.curves.iter().flat_map(&values);
        let is_pressed = all.fold(0.0, f64::max) > PRESSED * reach;
        let is_near = |curve: &Curve| lowest(curve) <= FAR * reach;
        if !is_pressed || !self.curves.iter().any(is_near) {
            return;
        }
        let far: Vec<_> = self.curves.iter().filter(|c| !is_near(c)).collect();
        let from = far
            .iter()
            .map(|curve| lowest(curve))
            .fold(f64::INFINITY, f64::min);
        let lines = if far.len() == 1 { "line" } else { "lines" };
        let text = format!(
            "{} {lines} from {} {} on not drawn",
            far.len(),
            short_number(from, 3),
            self.unit.word()
        );
        self.above = (!far.is_empty()).then_some(text);
        self.curves.retain(is_near);
    }

    /// Title of the horizontal axis.
    fn speed_title(&self) -> String {
        format!("rotor speed [{}]", self.unit.speed_word())
    }

    /// Title of the vertical axis.
    fn axis_title(&self) -> String {
        format!("{} [{}]", self.axis, self.unit.word())
    }

    /// Whether any mode is damped or grows.
    fn is_damped(&self) -> bool {
        let mut ratios = self.curves.iter().flat_map(|c| c.damping.iter().flatten());
        ratios.any(|per_cent| per_cent.abs() > 100.0 * DAMPED)
    }
}

impl Curve {
    /// The curve of modes that coincide.
    fn of_group(
        group: &Group<'_>,
        (color, pattern): (Color, usize),
        table: &FrequencyTable,
    ) -> Self {
        let point = |k: usize| group.point(k);
        let speeds = || 0..table.speeds.len();
        let value = |k: usize| {
            let frequency = point(k)?.frequency;
            table.style.unit.value(frequency, table.speeds[k])
        };
        Self {
            name: group.name(table),
            kind: group.first().kind,
            kinds: speeds()
                .map(|k| point(k).map(|point| group.first().kind_at(point)))
                .collect(),
            frequencies: speeds().map(value).collect(),
            zeros: Vec::new(),
            damping: speeds()
                .map(|k| point(k).map(|point| 100.0 * point.damping_ratio))
                .collect(),
            color,
            pattern,
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

impl Figure for FanPlot {
    fn size(&self) -> (u32, u32) {
        let below = if self.is_damped() { DAMPING } else { 0 };
        (SIZE.0, SIZE.1 + below)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let axes = axes::axes(self);
        let multiples = per_rev::multiples(&axes, self.unit, self.multiples.as_deref());
        let mut obstacles = Obstacles::default();
        for curve in &self.curves {
            for run in curves::frequency_runs(self, curve, &axes) {
                obstacles.add_line(&run);
            }
        }
        for &point in &self.measured {
            obstacles.add_disc(axes.position(point), curves::RING);
        }

        axes.draw_grid(drawing);
        per_rev::draw_lines(drawing, &multiples);
        let at_ends = labels::beside_ends(self, &axes, &mut obstacles);
        per_rev::draw_labels(drawing, &axes, &multiples, &mut obstacles);
        curves::draw(drawing, self, &axes);
        at_ends.draw(drawing);
        labels::draw_column(drawing, self, &axes);
        if self.is_damped() {
            damping::draw(drawing, self, &axes);
        }
        let title = self.speed_title();
        let below = (!self.is_damped()).then_some(title.as_str());
        axes.draw(drawing, below, &self.axis_title());
        drawing.title(&self.title, [axes.left, 40.0]);
        let (mut top, space) = (LEGEND, f64::from(WIDTH) - axes.left);
        for legend in legend::legends(self) {
            legend.draw(drawing, [axes.left, top], space);
            top += legend.height(space);
        }
    }
}

#[cfg(test)]
#[path = "fan_tests.rs"]
mod tests;
