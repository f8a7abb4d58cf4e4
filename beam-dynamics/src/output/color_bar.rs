//! Colors of the values of a map, and the bar that explains them.

use shared_geom::figure::{
    Color, Drawing, INK, Label, SMALL, Ticks, WHITE, sequential, tick_label,
};

/// Number of levels of the contours.
const LEVELS: usize = 10;
/// Width of the lines.
pub(super) const CONTOUR: f64 = 2.0;
const BAR: f64 = 26.0;
const GAP: f64 = 24.0;

/// Colors between two values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ColorBar {
    /// The values of the darkest and the lightest color.
    pub range: [f64; 2],
}

impl ColorBar {
    /// The colors of finite values; `None` if there are none.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
        for value in values.into_iter().filter(|value| value.is_finite()) {
            low = low.min(value);
            high = high.max(value);
        }
        if low > high {
            return None;
        }
        // Equal values are in the middle; round-off is not drawn as a variation.
        let least = 1e-3 * low.abs().max(high.abs()).max(1e-12);
        let middle = 0.5 * (low + high);
        Some(Self {
            range: if high - low < least {
                [middle - least, middle + least]
            } else {
                [low, high]
            },
        })
    }

    /// The color of a value.
    pub fn color(&self, value: f64) -> Color {
        sequential((value - self.range[0]) / (self.range[1] - self.range[0]))
    }

    /// Values of contours, inside of the range.
    pub fn levels(&self) -> Vec<f64> {
        let [low, high] = self.range;
        let ticks = Ticks::between(low, high, LEVELS);
        ticks.positions().filter(|level| *level > low).collect()
    }

    /// The bar to the right of a map whose right edge and upper and lower ends are given.
    pub fn draw(&self, drawing: &mut Drawing, right: f64, [top, bottom]: [f64; 2]) {
        let [left, right] = [right + GAP, right + GAP + BAR];
        let [low, high] = self.range;
        let height = bottom - top;
        let at = |part: f64| bottom - part * height;
        let steps = 64;
        for step in 0..steps {
            let part = |step: i32| f64::from(step) / f64::from(steps);
            let [from, to] = [at(part(step)), at(part(step + 1))];
            let corners = [[left, from], [right, from], [right, to], [left, to]];
            drawing.polygon(&corners, sequential(part(step) + 0.5 * part(1)));
        }
        let label = Label::new(SMALL).colored(INK);
        for level in self.levels() {
            let y = at((level - low) / (high - low));
            drawing.line(&[[left, y], [right, y]], CONTOUR, WHITE);
            drawing.text(&tick_label(level, high - low), [right + 10.0, y], label);
        }
        let corners = [[left, bottom], [right, bottom], [right, top], [left, top]];
        drawing.outline(&corners, CONTOUR, INK);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_round_and_inside() {
        let found = ColorBar { range: [0.0, 0.48] }.levels();
        assert!(found.len() >= 4 && found.iter().all(|it| *it > 0.0 && *it <= 0.48));
        let found = ColorBar { range: [-3.0, 7.0] }.levels();
        assert!(found.contains(&0.0) && found.iter().all(|it| *it > -3.0 && *it <= 7.0));
    }

    #[test]
    fn equal_values_have_one_color() {
        let bar = ColorBar::of([2.0, f64::NAN, 2.0 + 1e-12]).unwrap();
        assert_eq!(bar.color(2.0), sequential(0.5));
        assert_eq!(ColorBar::of([f64::NAN]), None);
    }
}
