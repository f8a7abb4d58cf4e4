//! Internal forces along blades and lines of beams, one small plot per component.

use shared_geom::figure::{Axes, CATEGORIES, Color, Drawing, Figure, Legend, Stroke, WIDTH, range};

use super::floors::{Floors, clean};
use super::text::loads_of;
use crate::output::structure::Structure;
use crate::result::StaticResult;

/// Titles of the components with their units, in their order.
const TITLES: [&str; 6] = [
    "axial force [N]",
    "shear force y [N]",
    "shear force z [N]",
    "torsional moment [N m]",
    "bending moment y [N m]",
    "bending moment z [N m]",
];
const HEIGHT: u32 = 1500;
/// Space for the titles of the horizontal axes \[figure pixels\].
const FOOT: f64 = 46.0;
const LINE: f64 = 4.0;
const POINT: f64 = 6.5;
/// Forces and moments below this part of their scale are shown as zero.
const ROUND_OFF: f64 = 1e-9;
/// Colors of members: the colors of categories without yellow, which is faint as a line.
const COLORS: usize = CATEGORIES.len() - 1;

/// Internal forces along the span, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct ForcePlot {
    title: String,
    curves: Vec<Curve>,
    length: f64,
    /// Below these, forces and moments are shown as zero.
    floors: Floors,
}

/// The evaluation points of a member.
#[derive(Debug, Clone, PartialEq)]
struct Curve {
    name: String,
    color: Color,
    /// Arc position \[m\] and internal force \[N, N m\].
    points: Vec<(f64, [f64; 6])>,
}

impl ForcePlot {
    /// Internal forces at the end of the path; `None` without beams or equilibria.
    pub fn new(result: &StaticResult) -> Option<Self> {
        let last = result.last().filter(|step| !step.sections.is_empty())?;
        let structure = Structure::new(&result.nodes, &result.beams, &result.blades);
        let along = structure.along(&last.sections);
        let curve = |(number, member): (usize, &crate::output::structure::Member)| {
            let own = along.iter().zip(&last.sections);
            let own = own.filter(|((of, _), _)| *of == number);
            let mut points: Vec<_> = own
                .map(|((_, arc), section)| (*arc, section.internal_force.into()))
                .collect();
            points.sort_by(|a: &(f64, [f64; 6]), b| a.0.total_cmp(&b.0));
            Curve {
                name: member.name.clone(),
                color: CATEGORIES[number % COLORS],
                points,
            }
        };
        let curves: Vec<_> = structure.members.iter().enumerate().map(curve).collect();
        let lengths = structure.members.iter().map(|member| member.length);
        Some(Self {
            title: format!("{}: internal forces {}", result.name, loads_of(last, 4)),
            length: lengths.fold(0.0, f64::max),
            floors: Floors::new(last, structure.size(), ROUND_OFF),
            curves,
        })
    }

    fn draw_component(&self, drawing: &mut Drawing, component: usize, [top, bottom]: [f64; 2]) {
        let left = 190.0 + (component / 3) as f64 * 890.0;
        let floor = self.floors.of_component(component);
        let shown = |force: &[f64; 6]| clean(force[component], floor);
        let values = self.curves.iter().flat_map(|curve| &curve.points);
        let axes = Axes {
            left,
            right: left + 680.0,
            top: top + 20.0,
            bottom: bottom - 66.0,
            x: [0.0, self.length],
            // With zero, so that a constant force is recognizable.
            y: range(values.map(|point| shown(&point.1)).chain([0.0]), floor),
        };
        axes.draw_grid(drawing);
        for curve in &self.curves {
            let points = curve.points.iter();
            let points: Vec<_> = points.map(|(arc, force)| [*arc, shown(force)]).collect();
            axes.curve(drawing, &points, Stroke::new(LINE, curve.color));
            for point in points {
                drawing.disc(axes.position(point), POINT, curve.color);
            }
        }
        axes.draw(drawing, Some(title_below(component)), TITLES[component]);
        let values = self.curves.iter().flat_map(|curve| &curve.points);
        let sizes = values.map(|point| point.1[component].abs());
        let largest = sizes.fold(0.0, f64::max);
        if largest > 0.0 && largest <= floor {
            axes.note(drawing, "zero up to round-off");
        }
    }
}

/// Title of the horizontal axis: of the lowest panels only.
fn title_below(component: usize) -> &'static str {
    match component % 3 {
        2 => "arc position along the undeformed line [m]",
        _ => "",
    }
}

impl Figure for ForcePlot {
    fn size(&self) -> (u32, u32) {
        (WIDTH, HEIGHT)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        let entry = |curve: &Curve| (curve.name.clone(), LINE, curve.color);
        let legend = Legend::of_lines(self.curves.iter().map(entry));
        let space = f64::from(WIDTH) - 80.0;
        legend.draw(drawing, [40.0, 80.0], space);
        let head = 90.0 + legend.height(space);
        let row = (f64::from(HEIGHT) - head - FOOT) / 3.0;
        for component in 0..6 {
            let top = head + (component % 3) as f64 * row;
            self.draw_component(drawing, component, [top, top + row]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn every_component_has_a_plot_with_its_unit() {
        let plot = ForcePlot::new(&samples::bent(&[0.0, 1.0])).unwrap();
        assert_eq!(plot.curves[0].points.len(), 8);
        assert_eq!(plot.curves[0].points[7].0, 9.375);
        let text = samples::texts(&plot);
        for expected in TITLES.iter().chain(&["blade"]) {
            assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
        }
        assert_eq!(ForcePlot::new(&samples::bent(&[])), None);
    }

    // Bending of 1e-13 N m compared with 1 kN is zero: the panel shows zero between -1 and 1.
    #[test]
    fn round_off_is_drawn_as_zero() {
        let mut result = samples::bent(&[0.0, 1.0]);
        let last = result.steps.last_mut().unwrap();
        last.reactions.clear();
        for (k, section) in last.sections.iter_mut().enumerate() {
            let noise = 1e-13 * (k as f64 - 3.5);
            section.internal_force.fixed_rows_mut::<3>(3).fill(noise);
        }
        let text = samples::texts(&ForcePlot::new(&result).unwrap());
        assert!(!text.contains("e-13"));
        assert_eq!(text.matches("\n-1.0\n").count(), 3);
    }
}
