//! Roots and boundaries as CSV.

use std::f64::consts::TAU;

use crate::input::short_number;
use crate::output::rows::{csv_text, heading, number};
use crate::result::StabilityResult;

/// Digits of boundaries.
const DIGITS: usize = 14;

/// A row for each value and root: the value, whether it was requested, controls of a trim, number of the
/// mode, its name, growth, frequency, damping ratio, multiplier, estimated error of the exponent, and
/// whether it is unstable. Missing values are empty.
pub fn stability_csv(result: &StabilityResult) -> String {
    let names = [result.parameter.as_str(), "requested"].into_iter();
    let names = names.chain(result.controls.iter().map(String::as_str));
    let heading = heading(names)
        + ",number,mode,growth [1/s],frequency [Hz],damping ratio [-],\
           multiplier real part [-],multiplier imaginary part [-],error [1/s],unstable";
    let optional = |value: Option<f64>| value.map_or_else(String::new, number);
    let word = |is: bool| if is { "yes" } else { "no" }.to_owned();
    let rows = result.points.iter().flat_map(|point| {
        point
            .roots
            .iter()
            .zip(&point.modes)
            .map(move |(root, mode)| {
                let mut row = vec![short_number(point.at, DIGITS), word(point.is_requested)];
                row.extend(
                    (0..result.controls.len()).map(|k| optional(point.controls.get(k).copied())),
                );
                row.extend([(mode + 1).to_string(), result.modes[*mode].clone()]);
                row.extend([number(root.growth()), number(root.frequency() / TAU)]);
                row.push(optional(root.damping_ratio()));
                row.push(optional(root.multiplier.map(|own| own.re)));
                row.push(optional(root.multiplier.map(|own| own.im)));
                row.push(optional(root.error));
                row.push(match root.is_resolved() {
                    true if root.is_neutral => "azimuth".to_owned(),
                    true => word(root.is_unstable()),
                    false => "below error".to_owned(),
                });
                row
            })
    });
    csv_text(&heading, rows)
}

/// A row for each boundary: value, type, frequency, stable side, numbers of unstable roots on both
/// sides, mode.
pub fn boundary_csv(result: &StabilityResult) -> String {
    let heading = format!(
        "{},type,frequency [Hz],stable,unstable roots below,unstable roots above,mode",
        heading([result.parameter.as_str()])
    );
    let rows = result.boundaries.iter().map(|own| {
        vec![
            short_number(own.at, DIGITS),
            own.kind.word().to_owned(),
            number(own.frequency / TAU),
            own.stable.word().to_owned(),
            own.unstable[0].to_string(),
            own.unstable[1].to_string(),
            own.name.clone(),
        ]
    });
    csv_text(&heading, rows)
}
