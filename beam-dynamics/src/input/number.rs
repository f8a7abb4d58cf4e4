//! Numbers in messages and tables.

/// The value with at most `digits` significant digits and no trailing zeros; very
/// small and very large ones with a power of ten.
///
/// ```
/// use beam_dynamics::input::short_number;
///
/// assert_eq!(short_number(52.359_877_559_829_89 * 30.0 / 3.141_592_653_589_793, 6), "500");
/// assert_eq!(short_number(-0.000_012_5, 6), "-1.25e-5");
/// ```
pub fn short_number(value: f64, digits: usize) -> String {
    let decimals = digits.saturating_sub(1);
    let rounded: f64 = format!("{value:.decimals$e}").parse().unwrap_or(value);
    let is_plain = rounded == 0.0 || (1e-3..1e7).contains(&rounded.abs()) || !rounded.is_finite();
    match (rounded == 0.0, is_plain) {
        // Without the sign of a negative zero.
        (true, _) => "0".to_owned(),
        (_, true) => rounded.to_string(),
        (_, false) => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::short_number;

    #[test]
    fn digits_that_say_nothing_are_left_out() {
        for (value, digits, expected) in [
            (-0.0, 4, "0"),
            (0.1 + 0.2, 9, "0.3"),
            (-1234.56, 3, "-1230"),
            (9.9996e-4, 4, "0.001"),
            (1.5e8, 4, "1.5e8"),
            (f64::NAN, 4, "NaN"),
            (f64::INFINITY, 4, "inf"),
        ] {
            assert_eq!(short_number(value, digits), expected);
        }
    }
}
