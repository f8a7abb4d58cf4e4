//! Unit, range and colors of a field, and its color bar.

use shared_geom::figure::{
    Anchor, Color, Drawing, INK, Label, SMALL, TEXT, diverging, sequential, tick_label,
};

use super::field::Quantity;
use crate::output::figure_parts::{boxed, draw_color_bar};

/// Color of a field that is zero.
const NOTHING: Color = Color(225, 225, 225);
/// Spread below which values are equal, relative to the largest value.
const UNIFORM: f64 = 1e-6;
/// Size below which values are round-off, relative to the largest.
const NOISE: f64 = 1e-9;
/// Color of failure, different from all others.
const FAILED: Color = Color(214, 20, 60);
/// A value of failure: all such values have the same color.
const BEYOND: f64 = 2.0;
/// Space at the end of the bar for failure, and gap before it [figure pixels].
const BOX: f64 = 190.0;
const GAP: f64 = 40.0;
/// Height of the bar [figure pixels].
const HEIGHT: f64 = 44.0;

/// Units of stress, each for values from its size on [Pa]. Megapascals are used up to ten
/// thousand, as usual in engineering.
const UNITS: [(f64, f64, &str); 4] = [
    (1e10, 1e9, "GPa"),
    (1e6, 1e6, "MPa"),
    (1e3, 1e3, "kPa"),
    (0.0, 1.0, "Pa"),
];

/// Units of potential and of electric field, like the units of stress [V], [V/m].
const POTENTIALS: [(f64, f64, &str); 4] = [
    (1e4, 1e3, "kV"),
    (1e-1, 1.0, "V"),
    (1e-4, 1e-3, "mV"),
    (0.0, 1e-6, "uV"),
];
const FIELDS: [(f64, f64, &str); 4] = [
    (1e6, 1e6, "MV/m"),
    (1e3, 1e3, "kV/m"),
    (1e-1, 1.0, "V/m"),
    (0.0, 1e-3, "mV/m"),
];

/// Conversion of values to colors and numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    quantity: Quantity,
    /// Ends of the bar [SI].
    low: f64,
    high: f64,
    /// Size of the unit [SI].
    factor: f64,
    unit: &'static str,
}

impl Scale {
    /// A scale for values between these ends; all below `negligible` are zero.
    pub fn new(quantity: Quantity, [lowest, highest]: [f64; 2], negligible: f64) -> Self {
        let largest = lowest.abs().max(highest.abs());
        let (low, high) = if largest > negligible {
            (lowest.min(0.0), highest.max(0.0))
        } else {
            (0.0, 0.0)
        };
        let of = |units: [(f64, f64, &'static str); 4]| {
            let mut known = units.into_iter();
            let found = known.find(|(from, _, _)| largest >= *from);
            found.unwrap_or(units[3])
        };
        let (_, factor, unit) = match quantity {
            Quantity::Index => (0.0, 1.0, ""),
            Quantity::Potential => of(POTENTIALS),
            Quantity::ElectricField => of(FIELDS),
            Quantity::SignedStress | Quantity::Stress => of(UNITS),
        };
        Self {
            quantity,
            low,
            high,
            factor,
            unit,
        }
    }

    /// Whether all values are round-off.
    pub fn is_zero(&self) -> bool {
        self.low == self.high
    }

    /// The highest value [SI].
    pub fn highest(&self) -> f64 {
        self.high
    }

    /// Whether these lowest and highest values are different.
    pub fn distinguishes(&self, [lowest, highest]: [f64; 2]) -> bool {
        highest - lowest > UNIFORM * self.largest() && !self.is_zero()
    }

    fn largest(&self) -> f64 {
        self.high.max(-self.low)
    }

    /// The value drawn for `value`: indices are shown from 0 to 1, independent of their range,
    /// so that safe and failed are distinguished in all figures.
    pub fn drawn(&self, value: f64) -> f64 {
        match self.quantity {
            Quantity::Index if value > 1.0 => BEYOND,
            _ => value,
        }
    }

    /// Ends of the bar [SI].
    fn ends(&self) -> [f64; 2] {
        match self.quantity {
            Quantity::Index => [0.0, 1.0],
            _ => [self.low, self.high],
        }
    }

    /// Color of a value [SI].
    pub fn color(&self, value: f64) -> Color {
        if self.is_zero() {
            return NOTHING;
        }
        match self.quantity {
            Quantity::SignedStress | Quantity::Potential => diverging(value / self.largest()),
            Quantity::Stress | Quantity::ElectricField => sequential(value / self.high),
            Quantity::Index if value > 1.0 => FAILED,
            Quantity::Index => sequential(value),
        }
    }

    /// The value in four digits with its unit; round-off of the largest is zero.
    pub fn shown(&self, value: f64) -> String {
        let value = if value.abs() > NOISE * self.largest() {
            value
        } else {
            0.0
        };
        let value: f64 = format!("{:.3e}", value / self.factor)
            .parse()
            .unwrap_or(value);
        let number = tick_label(value, 0.0);
        match self.unit {
            "" => number,
            unit => format!("{number} {unit}"),
        }
    }

    /// The text for a field without extremes; `is_whole` if all cells have a value.
    pub fn uniform_words(&self, is_whole: bool) -> String {
        let position = if is_whole {
            "in the whole section"
        } else {
            "where it is not white"
        };
        if self.is_zero() {
            format!("zero {position}, up to round-off")
        } else {
            let value = if self.high > 0.0 { self.high } else { self.low };
            format!("{} {position}", self.shown(value))
        }
    }

    /// Draws the bar between the `ends` from left to right, with ticks and its name.
    pub fn draw_bar(&self, drawing: &mut Drawing, [left, right]: [f64; 2], top: f64, name: &str) {
        if self.is_zero() {
            return;
        }
        let bottom = top + HEIGHT;
        let mut right = right;
        if self.quantity == Quantity::Index && self.high > 1.0 {
            let failed = boxed([right - BOX, top], [right, bottom]);
            drawing.polygon(&failed, FAILED);
            drawing.outline(&failed, 2.0, INK);
            let label = Label::new(SMALL).colored(INK).anchored(Anchor::Middle);
            let below = [right - 0.5 * BOX, bottom + 10.0 + 0.7 * TEXT];
            drawing.text("above 1: fails", below, label);
            right -= BOX + GAP;
        }
        let ends = self.ends().map(|value| value / self.factor);
        let name = self.axis_name(name);
        let color = |value: f64| self.color(self.factor * value);
        let corners = [[left, top], [right, bottom]];
        draw_color_bar(drawing, corners, (ends, &name), color);
    }

    fn axis_name(&self, name: &str) -> String {
        match self.quantity {
            Quantity::Index => format!("{name} [-] (at most 1 means safe)"),
            _ => format!("{name} [{}]", self.unit),
        }
    }
}
