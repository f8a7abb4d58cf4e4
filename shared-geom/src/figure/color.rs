//! Colors that remain distinguishable for color-blind readers and in gray print.
//!
//! # References
//! - M. Okabe, K. Ito, "Color Universal Design: how to make figures and
//!   presentations that are friendly to colorblind people" (2008).
//! - S. van der Walt, N. Smith, "A better default colormap for Matplotlib",
//!   SciPy 2015: the map "viridis".
//! - K. Moreland, "Diverging color maps for scientific visualization", Proc. 5th
//!   Int. Symp. Visual Computing (2009), section 4.

/// Red, green and blue of a color.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Color(pub u8, pub u8, pub u8);

impl Color {
    pub(super) fn bytes(self) -> [u8; 3] {
        [self.0, self.1, self.2]
    }

    /// The color on the way to `other`, after a part of it from 0 to 1.
    pub fn mixed(self, other: Self, part: f64) -> Self {
        let mix = |from: u8, to: u8| {
            let from = f64::from(from);
            (from + part * (f64::from(to) - from)).round() as u8
        };
        Self(
            mix(self.0, other.0),
            mix(self.1, other.1),
            mix(self.2, other.2),
        )
    }
}

/// Black: text and outlines.
pub const BLACK: Color = Color(0, 0, 0);
/// White: the sheet.
pub const WHITE: Color = Color(255, 255, 255);

/// Colors of categories, by Okabe and Ito; black, the color of axes and outlines, is
/// omitted, and yellow comes last, since it is faint on white.
pub const CATEGORIES: [Color; 7] = [
    Color(0, 114, 178),
    Color(230, 159, 0),
    Color(0, 158, 115),
    Color(204, 121, 167),
    Color(86, 180, 233),
    Color(213, 94, 0),
    Color(240, 228, 66),
];

/// Color of the category number `index`, from zero; from the eighth the colors repeat,
/// each time half way to white.
pub fn category(index: usize) -> Color {
    let fade = 0.5_f64.powi((index / CATEGORIES.len()).min(3) as i32);
    CATEGORIES[index % CATEGORIES.len()].mixed(WHITE, 1.0 - fade)
}

/// Ten evenly spaced colors of "viridis".
const SEQUENTIAL: [[u8; 3]; 10] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x28, 0x78],
    [0x3E, 0x49, 0x89],
    [0x31, 0x68, 0x8E],
    [0x26, 0x82, 0x8E],
    [0x1F, 0x9E, 0x89],
    [0x35, 0xB7, 0x79],
    [0x6D, 0xCD, 0x59],
    [0xB4, 0xDE, 0x2C],
    [0xFD, 0xE7, 0x25],
];

/// Blue over light gray to brown: Moreland's interpolation between (0, 68, 146)
/// and (150, 48, 0) with the unsaturated magnitude 94.
const DIVERGING: [[u8; 3]; 17] = [
    [0, 68, 146],
    [0, 94, 172],
    [0, 121, 193],
    [0, 147, 209],
    [51, 173, 220],
    [104, 196, 227],
    [151, 215, 231],
    [196, 229, 234],
    [238, 238, 238],
    [233, 228, 205],
    [228, 213, 170],
    [221, 192, 134],
    [213, 168, 100],
    [201, 141, 69],
    [187, 111, 41],
    [170, 81, 17],
    [150, 48, 0],
];

/// Color of a magnitude: dark at 0, light at 1; values outside are cut off.
pub fn sequential(value: f64) -> Color {
    between(&SEQUENTIAL, value)
}

/// Color of a signed value: blue at -1, light gray at 0, brown at 1; values
/// outside are cut off.
pub fn diverging(value: f64) -> Color {
    between(&DIVERGING, 0.5 * (value + 1.0))
}

/// Linear interpolation in an evenly spaced table over [0, 1]; NaN is treated as 0.
fn between(table: &[[u8; 3]], value: f64) -> Color {
    let value = if value.is_nan() { 0.0 } else { value };
    let position = value.clamp(0.0, 1.0) * (table.len() - 1) as f64;
    let below = (position as usize).min(table.len() - 2);
    let part = position - below as f64;
    let channel = |c: usize| {
        let (low, high) = (f64::from(table[below][c]), f64::from(table[below + 1][c]));
        // rounded: the channel is positive, and a byte cuts off
        (low + part * (high - low) + 0.5) as u8
    };
    Color(channel(0), channel(1), channel(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CIE 1976 lightness of an sRGB color (IEC 61966-2-1, white D65).
    fn lightness(Color(r, g, b): Color) -> f64 {
        let linear = |c: u8| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                ((c + 0.055) / 1.055).powf(2.4)
            }
        };
        let y = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
        if y > 216.0 / 24389.0 {
            116.0 * y.cbrt() - 16.0
        } else {
            y * 24389.0 / 27.0
        }
    }

    /// Perceptually uniform: equal steps of lightness, about 76/9 each for viridis;
    /// the table is rounded to whole channels and keeps them within 2.
    #[test]
    fn sequential_lightness_rises_evenly() {
        let steps = (0..9).map(|k| {
            let at = |k: i32| lightness(sequential(f64::from(k) / 9.0));
            at(k + 1) - at(k)
        });
        for step in steps {
            assert!((step - 76.0 / 9.0).abs() < 2.0, "{step}");
        }
    }

    /// Zero is the lightest; the ends are equally dark within 6 of 100.
    #[test]
    fn diverging_map_is_lightest_at_zero_and_falls_to_both_sides() {
        for k in 0..8 {
            let (a, b) = (f64::from(k) / 8.0, f64::from(k + 1) / 8.0);
            assert!(lightness(diverging(a)) > lightness(diverging(b)));
            assert!(lightness(diverging(-a)) > lightness(diverging(-b)));
        }
        let ends = lightness(diverging(-1.0)) - lightness(diverging(1.0));
        assert!(ends.abs() < 6.0, "{ends}");
    }

    #[test]
    fn values_outside_and_no_numbers_have_a_color() {
        assert_eq!(sequential(-3.0), sequential(0.0));
        assert_eq!(sequential(f64::INFINITY), sequential(1.0));
        assert_eq!(sequential(f64::NAN), sequential(0.0));
        assert_eq!(diverging(0.0), Color(238, 238, 238));
    }

    #[test]
    fn categories_differ_far_beyond_the_palette() {
        let colors: Vec<_> = (0..14).map(category).collect();
        for (i, a) in colors.iter().enumerate() {
            assert!(!colors[i + 1..].contains(a), "{i}");
        }
    }
}
