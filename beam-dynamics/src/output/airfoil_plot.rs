//! Coefficients of airfoils over the angle of attack, at all angles and in attached flow.

use rotor_aero::airfoil::Curve as Table;
use rotor_aero::airfoil::files::ReadAirfoil;
use shared_geom::figure::{Axes, Drawing, Figure, Legend, Sample, Stroke, WIDTH, category, range};

use crate::input::short_number;

/// Largest number of curves in a panel.
const MOST: usize = 21;
/// Angles at the ends of the range of attached flow \[deg\].
const ATTACHED: [f64; 2] = [-20.0, 25.0];
/// Tables up to this angle have no panels for all angles \[deg\].
const WIDE: f64 = 60.0;
const COEFFICIENTS: [&str; 3] = ["lift cl [-]", "drag cd [-]", "moment cm [-]"];
const HEAD: f64 = 76.0;
const FRAME: f64 = 400.0;
const LEFT: f64 = 190.0;
const RIGHT: f64 = 40.0;
/// Between panels beside and below each other \[figure pixels\].
const GAPS: [f64; 2] = [190.0, 60.0];
const FOOT: f64 = 120.0;
const LINE: f64 = 3.5;

/// The figure of the airfoils of a file, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct AirfoilPlot {
    title: String,
    names: Vec<String>,
    /// Curves of lift, drag and moment: index of their name, and points [deg, -].
    curves: [Vec<(usize, Vec<[f64; 2]>)>; 3],
    /// Number of curves that are not drawn.
    omitted: usize,
}

impl AirfoilPlot {
    /// The curves of airfoils; colors distinguish airfoils and conditions.
    pub fn new(title: &str, airfoils: &[ReadAirfoil]) -> Self {
        let mut plot = Self {
            title: title.to_owned(),
            names: Vec::new(),
            curves: [const { Vec::new() }; 3],
            omitted: 0,
        };
        for airfoil in airfoils {
            let data = &airfoil.data;
            let is_alone = airfoils.len() == 1;
            for (kind, tables) in [&data.lift, &data.drag, &data.moment].iter().enumerate() {
                for table in *tables {
                    plot.add(kind, table, (!is_alone).then_some(data.name.as_str()));
                }
            }
        }
        plot
    }

    fn add(&mut self, kind: usize, table: &Table, airfoil: Option<&str>) {
        let name = condition(table, airfoil);
        let known = self.names.iter().position(|known| *known == name);
        let index = match known {
            Some(index) => index,
            None if self.names.len() < MOST => {
                self.names.push(name);
                self.names.len() - 1
            }
            None => {
                self.omitted += 1;
                return;
            }
        };
        let points = table.alpha.iter().zip(&table.values);
        let points = points.map(|(angle, value)| [angle.to_degrees(), *value]);
        let points = points.filter(|point| point.iter().all(|value| value.is_finite()));
        self.curves[kind].push((index, points.collect()));
    }

    /// A remark on the curves that are not drawn.
    pub fn remark(&self) -> Option<String> {
        let omitted = self.omitted;
        (omitted > 0).then(|| {
            format!(
                "{omitted} curves are not in the figure, which has {MOST} conditions: use --name"
            )
        })
    }

    fn points(&self, kind: usize) -> impl Iterator<Item = &[f64; 2]> {
        self.curves[kind].iter().flat_map(|curve| &curve.1)
    }

    /// Ranges of the angle, one for each column of panels \[deg\].
    fn columns(&self) -> Vec<[f64; 2]> {
        let angles = (0..3).flat_map(|kind| self.points(kind).map(|point| point[0]));
        let [low, high] = angles.fold([0.0_f64; 2], |[low, high], angle| {
            [low.min(angle), high.max(angle)]
        });
        if low < -WIDE || high > WIDE {
            vec![[low.min(-180.0), high.max(180.0)], ATTACHED]
        } else {
            vec![[low.min(-5.0), high.max(5.0)]]
        }
    }

    fn legend(&self) -> Legend {
        let mut legend = Legend::default();
        let named = self.names.iter().enumerate();
        for (index, name) in named.filter(|(_, name)| !name.is_empty()) {
            legend.add(name.as_str(), Sample::Line(stroke(index)));
        }
        legend
    }

    /// Top of the first panel.
    fn top(&self) -> f64 {
        HEAD + self.legend().height(f64::from(WIDTH) - LEFT - RIGHT) + 30.0
    }

    /// Draws a panel: its coefficient, its range of angles, and its frame.
    fn draw_panel(
        &self,
        drawing: &mut Drawing,
        (kind, x): (usize, [f64; 2]),
        [left, right, top]: [f64; 3],
    ) {
        let is_in = |angle: f64| angle >= x[0] - 1e-9 && angle <= x[1] + 1e-9;
        let pieces = self.curves[kind].iter();
        let pieces: Vec<_> = pieces
            .map(|(index, points)| (index, within(points, x)))
            .collect();
        let values = pieces.iter().flat_map(|piece| &piece.1);
        let values = values.filter(|point| is_in(point[0])).map(|point| point[1]);
        let axes = Axes {
            left,
            right,
            top,
            bottom: top + FRAME,
            x,
            y: range(values, 1e-9),
        };
        axes.draw_grid(drawing);
        for (index, points) in &pieces {
            if !points.is_empty() {
                axes.curve(drawing, points, stroke(**index));
            }
        }
        let below = (kind == 2).then_some("angle of attack [deg]");
        axes.draw(drawing, below, COEFFICIENTS[kind]);
    }
}

impl Figure for AirfoilPlot {
    fn size(&self) -> (u32, u32) {
        let height = self.top() + 3.0 * FRAME + 2.0 * GAPS[1] + FOOT;
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let width = f64::from(WIDTH);
        drawing.title(&self.title, [40.0, 40.0]);
        let legend = self.legend();
        legend.draw(drawing, [LEFT, HEAD], width - LEFT - RIGHT);
        let columns = self.columns();
        let gaps = GAPS[0] * (columns.len() as f64 - 1.0);
        let space = (width - LEFT - RIGHT - gaps) / columns.len() as f64;
        for (column, x) in columns.iter().enumerate() {
            let left = LEFT + column as f64 * (space + GAPS[0]);
            for kind in 0..3 {
                let top = self.top() + kind as f64 * (FRAME + GAPS[1]);
                self.draw_panel(drawing, (kind, *x), [left, left + space, top]);
            }
        }
    }
}

/// The style of the curves of a name: after all colors the next dashes.
fn stroke(index: usize) -> Stroke {
    const COLORS: usize = 6;
    Stroke::new(LINE, category(index % COLORS)).dashed(index / COLORS)
}

/// Airfoil and conditions of a curve, empty if it has none.
fn condition(table: &Table, airfoil: Option<&str>) -> String {
    let mut parts: Vec<String> = airfoil.map(str::to_owned).into_iter().collect();
    parts.extend(
        table
            .mach
            .map(|mach| format!("Mach {}", short_number(mach, 4))),
    );
    parts.extend(
        table
            .reynolds
            .map(|number| format!("Re {}", short_number(number, 4))),
    );
    let flap = table.flap.map(f64::to_degrees);
    parts.extend(flap.map(|flap| format!("flap {} deg", short_number(flap, 4))));
    parts.join(", ")
}

/// The part of a curve in a range of angles, with interpolated ends.
fn within(points: &[[f64; 2]], [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    let cut = |a: &[f64; 2], b: &[f64; 2], x: f64| {
        let share = (x - a[0]) / (b[0] - a[0]);
        [x, a[1] + share * (b[1] - a[1])]
    };
    for (index, point) in points.iter().enumerate() {
        let before = index.checked_sub(1).and_then(|index| points.get(index));
        if let Some(before) = before {
            for end in [from, to] {
                if before[0] < end && point[0] > end {
                    kept.push(cut(before, point, end));
                }
            }
        }
        if (from..=to).contains(&point[0]) {
            kept.push(*point);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use rotor_aero::airfoil::AirfoilData;

    use super::*;

    fn airfoil(angles: &[f64], mach: &[Option<f64>]) -> ReadAirfoil {
        let curve = |mach: &Option<f64>| Table {
            mach: *mach,
            alpha: angles.iter().map(|angle| angle.to_radians()).collect(),
            values: angles.iter().map(|angle| 0.01 * angle).collect(),
            ..Table::default()
        };
        let curves: Vec<_> = mach.iter().map(curve).collect();
        ReadAirfoil {
            data: AirfoilData {
                name: "a".to_owned(),
                lift: curves.clone(),
                drag: curves.clone(),
                moment: curves,
                ..AirfoilData::default()
            },
            ..ReadAirfoil::default()
        }
    }

    #[test]
    fn ends_of_a_range_are_interpolated() {
        let points = [[-180.0, 0.0], [0.0, 1.0], [180.0, 0.0]];
        let found = within(&points, [-90.0, 90.0]);
        assert_eq!(found, [[-90.0, 0.5], [0.0, 1.0], [90.0, 0.5]]);
        assert_eq!(within(&points, [10.0, 28.0]).len(), 2);
    }

    #[test]
    fn wide_tables_have_six_panels_and_narrow_ones_three() {
        let wide = AirfoilPlot::new(
            "t",
            &[airfoil(&[-180.0, 0.0, 180.0], &[Some(0.1), Some(0.2)])],
        );
        let texts: Vec<_> = wide.drawing().texts().map(str::to_owned).collect();
        let count = |text: &str| texts.iter().filter(|found| *found == text).count();
        assert_eq!((count("lift cl [-]"), count("Mach 0.1")), (2, 1));
        assert_eq!(count("angle of attack [deg]"), 2);
        let narrow = AirfoilPlot::new("t", &[airfoil(&[-10.0, 15.0], &[None])]);
        let columns = narrow.columns();
        // Round-off of the conversion to radians and back.
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-12;
        assert!(columns.len() == 1 && near(columns[0][0], -10.0) && near(columns[0][1], 15.0));
    }

    #[test]
    fn many_conditions_are_reported() {
        let mach: Vec<_> = (0..30).map(|k| Some(f64::from(k) / 100.0)).collect();
        let plot = AirfoilPlot::new("t", &[airfoil(&[-10.0, 15.0], &mach)]);
        assert!(plot.remark().unwrap().contains("27 curves"));
    }
}
