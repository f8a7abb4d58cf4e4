//! Report of the decay of end effects along the beam.

use super::text::{coordinate, number, table};
use crate::solution::EndEffects;

/// Fraction of an end effect that remains at the second distance.
const LITTLE: f64 = 0.01;

/// The part of the report about end effects.
pub fn end_effects(found: &EndEffects) -> String {
    let heading = ["to 1/e [m]", "to 1 % [m]", "wave length [m]"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for mode in &found.modes {
        rows.push(vec![
            number(mode.distance((-1.0_f64).exp())),
            number(mode.distance(LITTLE)),
            mode.wave_length().map_or_else(|| "-".to_owned(), number),
        ]);
    }
    let status = match found.is_converged {
        true if found.modes.len() < found.wanted => {
            "  The mesh has no further end effects.\n".to_owned()
        }
        true => String::new(),
        false => format!(
            "  (not converged: the rates still change by {:.1e} with {} vectors)\n",
            found.change, found.vectors
        ),
    };
    let words = found.modes.first().map_or_else(String::new, |slowest| {
        format!(
            "  End effects fall to 1/e within {} m, to 1 % within {} m: the beam model holds \
             beyond\n  this distance from a root or a jump.\n",
            plain(slowest.distance((-1.0_f64).exp())),
            plain(slowest.distance(LITTLE)),
        )
    });
    format!(
        "End effects: decaying solutions, slowest decay first, equal ones once\n\
         {}{words}{status}",
        table(&rows, "rrr")
    )
}

/// A length in plain notation if that is short.
fn plain(length: f64) -> String {
    coordinate(length, length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::DecayingMode;

    #[test]
    fn the_farthest_is_reported_in_words() {
        let mut found = EndEffects {
            modes: vec![
                DecayingMode {
                    rate: 4.0,
                    wave_number: 0.0,
                },
                DecayingMode {
                    rate: 8.0,
                    wave_number: 5.0,
                },
            ],
            wanted: 2,
            change: 1e-11,
            is_converged: true,
            vectors: 42,
        };
        let text = end_effects(&found);
        assert!(
            text.contains("End effects fall to 1/e within 0.25 m, to 1 % within 1.15129 m"),
            "{text}"
        );
        assert!(
            text.contains("1.25664") && !text.contains("not converged"),
            "{text}"
        );
        assert!(!text.contains("no further"), "{text}");
        found.wanted = 3;
        assert!(end_effects(&found).contains("The mesh has no further end effects."));
        found.is_converged = false;
        found.change = 2e-5;
        let text = end_effects(&found);
        assert!(
            text.contains("not converged: the rates still change by 2.0e-5 with 42 vectors"),
            "{text}"
        );
    }
}
