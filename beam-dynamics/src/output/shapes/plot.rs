//! Shapes of the lowest modes along the span, one small plot per mode.

use shared_geom::figure::{
    Anchor, Axes, CATEGORIES, Color, Drawing, Figure, INK, Label, Legend, SMALL, Stroke, TEXT,
    WIDTH,
};

use super::{MemberMotion, Shaped, member_motion, shaped, structure};
use crate::case::{Model, Words};
use crate::input::short_number;
use crate::output::text::{DAMPED, RPM};
use crate::result::{FrequencyTable, ModeKind};

/// Modes that are shown.
const MOST: usize = 12;
const COLUMNS: usize = 3;
/// Height of a row of plots \[figure pixels\].
const ROW: f64 = 330.0;
const HEAD: f64 = 160.0;
const FOOT: f64 = 120.0;
const LINE: f64 = 4.5;
const THIN: f64 = 2.0;
/// Components that stay below this part of the largest are not drawn.
const FAINT: f64 = 0.01;
/// Relative difference below which frequencies are treated as equal, as of the equal blades of a
/// rotor.
const EQUAL: f64 = 1e-5;
/// Meaning of the components.
const NAMES: [&str; 4] = ["flap", "lag", "torsion angle x length / 10", "axial"];
const COLORS: [Color; 4] = [CATEGORIES[0], CATEGORIES[5], CATEGORIES[2], CATEGORIES[3]];

/// Shapes of modes at one speed, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct ShapePlot {
    title: String,
    modes: Vec<Shown>,
    /// Whether modes that look like others were omitted.
    thinned: bool,
    words: Words,
}

#[derive(Debug, Clone, PartialEq)]
struct Shown {
    name: String,
    /// Frequency, damping if there is any, and the member if there are several.
    values: String,
    length: f64,
    member_motion: MemberMotion,
}

impl ShapePlot {
    /// Shapes of the lowest modes at speed index `speed` of `table`; `None` if there are no shapes
    /// or no beams.
    pub fn new(model: &Model, table: &FrequencyTable, speed: usize) -> Option<Self> {
        let structure = structure(model);
        let mut found = shaped(table, speed);
        let count = found.len();
        found.dedup_by(|mode, before| mode.is_like(before));
        let thinned = found.len() < count;
        let shown = found.into_iter().filter_map(|mode| {
            let member_motion = member_motion(&structure, &model.naming, mode.shape)?;
            let member = &structure.members[member_motion.member];
            let mut values = format!("{} Hz", short_number(mode.frequency, 4));
            if mode.damping_ratio.abs() > DAMPED {
                let per_cent = short_number(100.0 * mode.damping_ratio, 2);
                values.push_str(&format!(", {per_cent} %"));
            }
            if structure.members.len() > 1 {
                values.push_str(&format!(", {}", member.name));
            }
            Some(Shown {
                name: mode.shown.clone(),
                values,
                length: member.length,
                member_motion,
            })
        });
        let modes: Vec<_> = shown.take(MOST).collect();
        let rpm = short_number(table.speeds.get(speed)? * RPM, 6);
        (!modes.is_empty()).then(|| Self {
            title: format!("{}: shapes of modes at {rpm} rpm", table.name),
            modes,
            thinned,
            words: table.style.words,
        })
    }

    /// Components that at least one mode has.
    fn components(&self) -> Vec<usize> {
        let has = |component: &usize| self.modes.iter().any(|mode| mode.has(*component));
        (0..NAMES.len()).filter(has).collect()
    }
}

impl Shaped<'_> {
    /// Whether the mode looks like another one, of another of equal blades.
    fn is_like(&self, other: &Self) -> bool {
        let apart = (self.frequency - other.frequency).abs();
        self.kind == other.kind && apart <= EQUAL * self.frequency
    }
}

impl Shown {
    fn has(&self, component: usize) -> bool {
        let mut points = self.member_motion.points.iter();
        points.any(|point| point.1[component].norm() > FAINT)
    }

    /// Whether a component moves in phase with the largest one.
    fn is_real(&self, component: usize) -> bool {
        let mut points = self.member_motion.points.iter();
        points.any(|point| point.1[component].re.abs() > FAINT)
    }

    /// Whether a component moves out of phase with the largest one.
    fn is_complex(&self, component: usize) -> bool {
        let mut points = self.member_motion.points.iter();
        points.any(|point| point.1[component].im.abs() > FAINT)
    }

    fn draw(&self, drawing: &mut Drawing, panel: &Axes, on_one_line: bool) {
        panel.draw_grid(drawing);
        for (component, color) in COLORS.into_iter().enumerate() {
            let part = |pick: fn(&nalgebra::Complex<f64>) -> f64| -> Vec<_> {
                let points = self.member_motion.points.iter();
                points
                    .map(|(arc, motion)| [*arc, pick(&motion[component])])
                    .collect()
            };
            if self.is_real(component) {
                panel.curve(drawing, &part(|z| z.re), Stroke::new(LINE, color));
            }
            if self.is_complex(component) {
                panel.curve(drawing, &part(|z| z.im), Stroke::new(THIN, color));
            }
        }
        panel.draw(drawing, Some(""), "");
        self.draw_title(drawing, panel, on_one_line);
    }

    fn title(&self) -> String {
        format!("{}, {}", self.name, self.values)
    }

    /// Name and values on one line, or on two.
    fn draw_title(&self, drawing: &mut Drawing, panel: &Axes, on_one_line: bool) {
        let space = title_width(panel.right - panel.left);
        let label = Label::new(SMALL).bold();
        if on_one_line {
            return drawing.text(&self.title(), [panel.left, panel.top - 30.0], label);
        }
        let lines = [
            (&self.name, label, 54.0),
            (&self.values, Label::new(SMALL), 23.0),
        ];
        for (line, label, above) in lines {
            let line = drawing.shortened(line, label, space);
            drawing.text(&line, [panel.left, panel.top - above], label);
        }
    }
}

/// Space for a title over a panel of some width.
fn title_width(width: f64) -> f64 {
    width + 60.0
}

impl Figure for ShapePlot {
    fn size(&self) -> (u32, u32) {
        let rows = self.modes.len().div_ceil(COLUMNS);
        let height = HEAD + ROW * rows as f64 + FOOT;
        (WIDTH, height as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let (width, height) = drawing.size();
        drawing.title(&self.title, [40.0, 44.0]);
        let entry = |component: usize| {
            let name = match component {
                1 => ModeKind::Lag.word_in(self.words),
                _ => NAMES[component],
            };
            (name.to_owned(), LINE, COLORS[component])
        };
        let mut legend: Vec<_> = self.components().into_iter().map(entry).collect();
        let mut all = self.modes.iter();
        if all.any(|mode| (0..NAMES.len()).any(|component| mode.is_complex(component))) {
            let gray = Color(90, 90, 90);
            legend.push(("thin: a quarter of a period earlier".to_owned(), THIN, gray));
        }
        Legend::of_lines(legend).draw(drawing, [40.0, 74.0], width - 80.0);
        let column = (width - 60.0) / COLUMNS as f64;
        let (panel_width, bold) = (column - 140.0, Label::new(SMALL).bold());
        let fits = |mode: &Shown| {
            let title = mode.title();
            drawing.shortened(&title, bold, title_width(panel_width)) == title
        };
        let on_one_line = self.modes.iter().all(fits);
        for (index, mode) in self.modes.iter().enumerate() {
            let left = 40.0 + column * (index % COLUMNS) as f64 + 90.0;
            let top = HEAD + ROW * (index / COLUMNS) as f64 + 50.0;
            let panel = Axes {
                left,
                right: left + panel_width,
                top,
                bottom: top + ROW - 130.0,
                x: [0.0, mode.length],
                y: [-1.1, 1.1],
            };
            mode.draw(drawing, &panel, on_one_line);
        }
        let label = Label::new(TEXT).colored(INK).anchored(Anchor::Middle);
        let text = "arc position along the undeformed line [m]";
        drawing.text(text, [0.5 * width, height - 70.0], label);
        let text = "motion over its largest component [-]";
        let rows = self.modes.len().div_ceil(COLUMNS) as f64;
        let middle = [34.0, HEAD + 0.5 * ROW * rows];
        drawing.text(text, middle, label.upward());
        if self.thinned {
            let text = "of modes of one kind and frequency only the first is shown";
            let label = Label::new(SMALL).anchored(Anchor::Middle);
            drawing.text(text, [0.5 * width, height - 28.0], label);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn every_mode_has_a_plot_with_its_name_and_frequency() {
        let (model, table) = samples::shaped();
        let text = samples::texts(&ShapePlot::new(&model, &table, 0).unwrap());
        for expected in [
            "shaped blade: shapes of modes at 0 rpm",
            "flap 1, 1.4 Hz",
            "lag 1, 22.25 Hz, 2 %",
            "flap",
            "torsion angle x length / 10",
            "thin: a quarter of a period earlier",
        ] {
            assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
        }
        let mut long = table.clone();
        long.branches[1].name = "lag 1 progressive on one of many".to_owned();
        let plot = ShapePlot::new(&model, &long, 0).unwrap();
        let text = samples::texts(&plot);
        for expected in [
            "lag 1 progressive on one of many",
            "22.25 Hz, 2 %",
            "1.4 Hz",
        ] {
            assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
        }
        let mut twice = table.clone();
        twice.branches.push(twice.branches[0].clone());
        let plot = ShapePlot::new(&model, &twice, 0).unwrap();
        assert_eq!((plot.modes.len(), plot.thinned), (2, true));
        assert_eq!(ShapePlot::new(&model, &table, 1), None);
        assert_eq!(ShapePlot::new(&model, &table, 9), None);
    }
}
