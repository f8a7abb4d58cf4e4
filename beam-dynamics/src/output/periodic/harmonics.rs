//! Harmonics of the columns at multiples of the speed of a rotor, as text.

use crate::case::Column;
use crate::input::short_number;
use crate::result::Harmonics;

/// Digits of numbers.
const DIGITS: usize = 5;
/// Harmonics below this part of the largest number of a unit are round-off.
const ROUND_OFF: f64 = 1e-14;

/// Of each column the mean, and size and phase of the harmonics 1, N and 2 N of a revolution, given the
/// number N of blades and the revolutions in a period: a rotor of equal blades passes to the fixed system
/// only multiples of N. Empty without harmonics at these. Harmonics that are round-off are zero, without a phase.
pub fn rotor_harmonics_text(
    columns: &[Column],
    found: &[Harmonics],
    (blades, revolutions): (&[usize], usize),
) -> String {
    let most = found.iter().map(|own| own.parts.len()).max().unwrap_or(0);
    let mut orders: Vec<_> = blades
        .iter()
        .flat_map(|count| [1, *count, 2 * count])
        .collect();
    orders.sort_unstable();
    orders.dedup();
    orders.retain(|order| order * revolutions <= most);
    if columns.is_empty() || orders.is_empty() {
        return String::new();
    }
    let width = columns
        .iter()
        .map(|own| own.name.len() + own.unit.len() + 3);
    let width = width.max().unwrap_or(0).max(10);
    let mut text = format!(
        "\nHarmonics c cos(n psi - phase)\n  {:width$}  {:>12}",
        "column", "mean"
    );
    for order in &orders {
        text.push_str(&format!(
            "  {:>12} {:>11}",
            format!("{order}/rev"),
            "phase [deg]"
        ));
    }
    text.push('\n');
    let largest = |unit: &str| {
        let of_unit = columns
            .iter()
            .zip(found)
            .filter(|(column, _)| column.unit == unit);
        of_unit.map(|(_, own)| own.largest()).fold(0.0, f64::max)
    };
    for (column, own) in columns.iter().zip(found) {
        let least = ROUND_OFF * largest(&column.unit);
        let name = format!("{} [{}]", column.name, column.unit);
        text.push_str(&format!(
            "  {name:width$}  {:>12}",
            short_number(own.mean, DIGITS)
        ));
        for order in &orders {
            let [cosine, sine] = own
                .parts
                .get(order * revolutions - 1)
                .copied()
                .unwrap_or_default();
            let [size, phase] = shown([cosine, sine], least);
            text.push_str(&format!("  {size:>12} {phase:>11}"));
        }
        text.push('\n');
    }
    text
}

/// Size and phase of a harmonic; zero without a phase below the least size.
fn shown([cosine, sine]: [f64; 2], least: f64) -> [String; 2] {
    let size = cosine.hypot(sine);
    if size > least {
        let phase = format!("{:.2}", sine.atan2(cosine).to_degrees());
        [short_number(size, DIGITS), phase]
    } else {
        ["0", "-"].map(str::to_owned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Quantity;

    // 3 cos + 4 sin = 5 cos(psi - 53.13 deg); a blade count above the harmonics leaves the first one.
    #[test]
    fn sizes_and_phases() {
        let column = Column {
            name: "lift".to_owned(),
            unit: "N".to_owned(),
            factor: 1.0,
            words: String::new(),
            quantity: Quantity::StepLength,
        };
        let found = Harmonics {
            mean: 7.0,
            parts: vec![[3.0, 4.0], [0.0, -2.0]],
        };
        let columns = [column];
        let found = [found];
        let text = rotor_harmonics_text(&columns, &found, (&[2], 1));
        let last = text.lines().last().unwrap();
        let words: Vec<_> = last.split_whitespace().collect();
        assert_eq!(words, ["lift", "[N]", "7", "5", "53.13", "2", "-90.00"]);
        assert!(!rotor_harmonics_text(&columns, &found, (&[3], 1)).contains("3/rev"));
        // Round-off of the lift.
        let small = [Harmonics {
            mean: 7.0,
            parts: vec![[3e-14, 4e-14], [0.0, -2.0]],
        }];
        let text = rotor_harmonics_text(&columns, &small, (&[2], 1));
        let last = text.lines().last().unwrap();
        let words: Vec<_> = last.split_whitespace().collect();
        assert_eq!(words, ["lift", "[N]", "7", "0", "-", "2", "-90.00"]);
        assert_eq!(rotor_harmonics_text(&columns, &found, (&[3], 3)), "");
    }
}
