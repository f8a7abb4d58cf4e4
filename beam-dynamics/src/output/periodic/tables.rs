//! Harmonics and multipliers as CSV.

use std::f64::consts::TAU;

use crate::case::Column;
use crate::input::short_number;
use crate::output::rows::csv_text;
use crate::result::{FloquetTable, Harmonics};

/// Digits of numbers.
const DIGITS: usize = 12;
const FLOQUET: &str = "number,real part [-],imaginary part [-],size [-],growth [1/s],frequency [Hz],\
    frequency [1/period],damping ratio [-],error [1/s],residual [-],share [-],stability,motion";

/// A row for each column: name, unit, mean, and the factors of cosine and sine of each harmonic.
pub(super) fn harmonics_csv(columns: &[Column], found: &[Harmonics]) -> String {
    let count = found.iter().map(|own| own.parts.len()).max().unwrap_or(0);
    let mut heading = "column,unit,mean".to_owned();
    for m in 1..=count {
        heading.push_str(&format!(",cos {m},sin {m}"));
    }
    let rows = columns.iter().zip(found).map(|(column, own)| {
        let mut cells = vec![column.name.clone(), column.unit.clone()];
        let numbers = std::iter::once(&own.mean).chain(own.parts.iter().flatten());
        cells.extend(numbers.map(|number| short_number(*number, DIGITS)));
        cells
    });
    csv_text(&heading, rows)
}

/// A row for each multiplier: number, multiplier, growth, frequency, also in multiples of the
/// fundamental one, damping ratio, error and residual, share, stability, and the dominant motion.
/// Missing values are empty.
pub(super) fn floquet_csv(table: &FloquetTable, period: f64) -> String {
    let number = |value: f64| short_number(value, DIGITS);
    let optional = |value: Option<f64>| value.map_or_else(String::new, number);
    let rows = table.modes.iter().enumerate().map(|(index, mode)| {
        let hertz = mode.frequency() / TAU;
        vec![
            (index + 1).to_string(),
            number(mode.multiplier.re),
            number(mode.multiplier.im),
            number(mode.multiplier.norm()),
            number(mode.exponent.re),
            number(hertz),
            number(hertz * period),
            optional(mode.damping_ratio()),
            mode.error
                .map_or_else(String::new, |error| format!("{error:.3e}")),
            format!("{:.3e}", mode.residual),
            format!("{:.4}", mode.share),
            mode.stability().word().to_owned(),
            mode.label(),
        ]
    });
    csv_text(FLOQUET, rows)
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;
    use crate::result::FloquetMode;

    #[test]
    fn a_row_a_multiplier() {
        let mode = FloquetMode {
            shape: Vec::new(),
            multiplier: Complex::new(0.3, 0.4),
            exponent: Complex::new(-0.6, 0.8 * TAU),
            branch: 0,
            share: 1.0,
            others: Vec::new(),
            residual: 1e-14,
            error: Some(2e-7),
            name: "node \"a\": rotation about y".to_owned(),
            pattern: None,
            blades: None,
            in_blades: 0.0,
            in_coordinates: Default::default(),
            is_neutral: false,
        };
        let table = FloquetTable {
            modes: vec![mode],
            products: 2,
            states: Some(2),
        };
        let text = floquet_csv(&table, 2.0);
        let row = text.lines().nth(1).unwrap();
        assert!(row.starts_with("1,0.3,0.4,0.5,-0.6,0.8,1.6,0.118"), "{row}");
        assert!(
            row.ends_with(",2.000e-7,1.000e-14,1.0000,stable,\"node \"\"a\"\": rotation about y\"")
        );
    }

    #[test]
    fn a_row_a_column() {
        let found = Harmonics {
            mean: 1.0,
            parts: vec![[2.0, -3.0]],
        };
        assert_eq!(
            harmonics_csv(&[], &[found]),
            "column,unit,mean,cos_1,sin_1\n"
        );
    }
}
