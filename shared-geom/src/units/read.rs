//! Reads units and quantities as text.
//!
//! A unit is a product of names with powers: `N m^2`, `N*m2`, `N·m²`, `N-m^2`, `kg/m3`,
//! `kg m-3`. Names without a sign between them are a product only for the pairs that
//! [`JOINED`] lists, `Nm` among them; [`SPELLINGS`] are other spellings of names. A known name
//! is never split: `mm` is a millimeter, `mN` a millinewton, and `Nms`, which may be `N m s` or
//! `N ms`, is refused.

use super::{Dimension, NAMES, Unit, UnitProblem};

/// Lengths that may follow a force or a mass without a sign.
const LENGTHS: &[&str] = &["m", "mm", "cm", "km", "in", "ft"];

/// Names that may be written together: each of the first with each of the second.
const JOINED: [(&[&str], &[&str]); 4] = [
    (&["N", "kN", "MN", "mN", "daN", "lbf", "kip"], LENGTHS),
    (&["N", "kN", "MN", "mN", "daN"], &["s"]),
    (&["kg"], LENGTHS),
    (&["A", "mA", "V"], &["s"]),
];

/// Other spellings, each with the unit as text. No other unit has a name that differs from them in
/// the size of letters alone: `mn` may be a millinewton or a meganewton, and is refused.
const SPELLINGS: &[(&[&str], &str)] = &[
    (&["GPA", "Gpa", "gpa"], "GPa"),
    (&["MPA", "Mpa", "mpa"], "MPa"),
    (&["KPA", "KPa", "Kpa", "kpa"], "kPa"),
    (&["PA", "pa"], "Pa"),
    (&["PSI", "Psi"], "psi"),
    (&["KSI", "Ksi"], "ksi"),
    (&["MSI", "msi"], "Msi"),
    (&["KN"], "kN"),
    (&["LBF", "Lbf"], "lbf"),
    (&["KG", "Kg"], "kg"),
    (&["lbs", "lbm"], "lb"),
    (&["cc", "ccm"], "cm^3"),
    (&["RPM"], "rpm"),
    (&["rps"], "rev/s"),
    (&["meter", "meters", "metre", "metres"], "m"),
    (
        &["millimeter", "millimeters", "millimetre", "millimetres"],
        "mm",
    ),
    (&["inch", "inches"], "in"),
    (&["foot", "feet"], "ft"),
    (&["sec", "secs", "second", "seconds"], "s"),
    (&["minute", "minutes"], "min"),
    (&["hour", "hours"], "h"),
    (&["degree", "degrees"], "deg"),
    (&["radian", "radians"], "rad"),
    (&["hertz", "hz"], "Hz"),
];

/// Names of the pound, which is a mass here and a force to many.
const POUNDS: [&str; 3] = ["lb", "lbs", "lbm"];

/// The text of a unit in which pounds are pounds-force, `None` if it has none.
pub(super) fn with_pounds_force(text: &str) -> Option<String> {
    let words = text.split_inclusive(|at| !is_letter(at)).map(|word| {
        let name = word.trim_end_matches(|at| !is_letter(at));
        match POUNDS.contains(&name) {
            true => format!("lbf{}", &word[name.len()..]),
            false => word.to_owned(),
        }
    });
    let changed: String = words.collect();
    (changed != text).then_some(changed)
}

/// Signs that separate the factors of a product.
const TIMES: [char; 4] = ['*', '\u{b7}', '\u{22c5}', '\u{d7}'];
/// Minus signs: ASCII, the sign of mathematics, superscript.
const MINUS: [char; 3] = ['-', '\u{2212}', '\u{207b}'];
/// Superscript digits from 0 to 9.
const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
/// Largest power of a unit.
const LARGEST_POWER: i8 = 9;

/// A part of the text of a unit.
enum Token<'a> {
    /// A sign of multiplication.
    Times,
    /// A sign of division.
    Over,
    /// A factor and its power; `1` is a name too.
    Factor(&'a str, i8),
}

/// Reads a simple or compound unit: factors joined by `*`, `·`, `-`, a space or `/`, each
/// with an optional whole power, as in `lbf*s^2/in^4`, `kg/m3`, `N m²`, `Nm`.
/// Each `/` divides by the one factor after it. `1` is no unit.
///
/// # Errors
/// [`UnitProblem`] for an unknown name or a text that is no product of units.
pub fn parse(text: &str) -> Result<Unit, UnitProblem> {
    let malformed = || UnitProblem::Malformed { found: text.into() };
    let mut unit = number();
    let mut sign = 1;
    let mut after_operator = true;
    let mut rest = text.trim();
    while !rest.is_empty() {
        let (token, left) = next(rest).ok_or_else(malformed)?;
        rest = left.trim_start();
        match token {
            Token::Times | Token::Over if after_operator => return Err(malformed()),
            Token::Times => after_operator = true,
            Token::Over => {
                after_operator = true;
                sign = -1;
            }
            Token::Factor(name, power) => {
                unit = times(unit, factors(name)?, power, sign);
                (sign, after_operator) = (1, false);
            }
        }
    }
    if after_operator || !unit.factor.is_normal() {
        return Err(malformed());
    }
    Ok(unit)
}

/// A pure number as a unit.
fn number() -> Unit {
    Unit {
        dimension: Dimension::NUMBER,
        factor: 1.0,
    }
}

/// `unit` times the product of `factors`, of which the last has the power `power`; divided
/// by them if `sign` is negative.
fn times(unit: Unit, factors: [Unit; 2], power: i8, sign: i8) -> Unit {
    let [first, last] = factors;
    [(first, sign), (last, sign * power)]
        .into_iter()
        .fold(unit, |unit, (factor, power)| Unit {
            dimension: unit.dimension.times(factor.dimension, power),
            factor: unit.factor * factor.factor.powi(i32::from(power)),
        })
}

/// The first token of a text without leading space, and the text after it; `None` if it
/// has no meaning in a unit.
fn next(text: &str) -> Option<(Token<'_>, &str)> {
    let first = text.chars().next()?;
    let after = &text[first.len_utf8()..];
    if TIMES.contains(&first) {
        return Some((Token::Times, after));
    }
    if first == '/' {
        return Some((Token::Over, after));
    }
    if MINUS.contains(&first) && after.starts_with(is_letter) {
        return Some((Token::Times, after));
    }
    if first == '1' && !after.starts_with(|next: char| next.is_ascii_digit() || next == '.') {
        return Some((Token::Factor("1", 1), after));
    }
    let end = text.find(|at| !is_letter(at)).unwrap_or(text.len());
    let (name, rest) = text.split_at(end);
    if name.is_empty() {
        return None;
    }
    let (power, rest) = power(rest)?;
    Some((Token::Factor(name, power), rest))
}

/// Whether a character may be in the name of a unit.
fn is_letter(at: char) -> bool {
    at.is_alphabetic() || at == '°' || at == '%' || at == '_'
}

/// The power at the start of a text, 1 if there is none, and the text after it; `None` for
/// a power that is no whole number, or too large.
fn power(text: &str) -> Option<(i8, &str)> {
    let (text, is_required) = match text.strip_prefix('^') {
        Some(rest) => (rest, true),
        None => (text, false),
    };
    let unsigned = text.strip_prefix(MINUS);
    let is_negative = unsigned.is_some();
    let unsigned = unsigned.or_else(|| text.strip_prefix('+').filter(|_| is_required));
    let digits = unsigned.unwrap_or(text);
    let end = digits.find(|at| digit(at).is_none());
    let (digits, rest) = digits.split_at(end.unwrap_or(digits.len()));
    if digits.is_empty() {
        return (!is_required).then_some((1, text));
    }
    if rest.starts_with('.') {
        return None;
    }
    let power = digits.chars().try_fold(0_i8, |power, at| {
        let digit = digit(at)?;
        power.checked_mul(10)?.checked_add(digit)
    })?;
    let power = Some(power).filter(|power| *power <= LARGEST_POWER)?;
    Some((if is_negative { -power } else { power }, rest))
}

/// The value of a digit, raised or not.
fn digit(at: char) -> Option<i8> {
    let raised = RAISED.iter().position(|raised| *raised == at);
    let value = at
        .to_digit(10)
        .or(raised.and_then(|value| value.try_into().ok()))?;
    value.try_into().ok()
}

/// The unit of a name: the pure number and the unit, or the two units of a joined name.
fn factors(name: &str) -> Result<[Unit; 2], UnitProblem> {
    if name == "1" {
        return Ok([number(), number()]);
    }
    let plain = plain(name);
    if let Some(unit) = simple(&plain) {
        return Ok([number(), unit]);
    }
    joined(&plain).ok_or_else(|| UnitProblem::Unknown {
        found: name.into(),
        expected: None,
    })
}

/// A name in the letters of the table: signs for degrees, ohms and micro written out.
fn plain(name: &str) -> String {
    let mut plain = String::new();
    for at in name.chars() {
        match at {
            '°' => plain.push_str("deg"),
            'Ω' | '\u{2126}' => plain.push_str("Ohm"),
            'µ' | 'μ' => plain.push('u'),
            other => plain.push(other),
        }
    }
    plain
}

/// The unit of a name, or of another spelling of it.
fn simple(name: &str) -> Option<Unit> {
    if let Some((_, unit)) = SPELLINGS.iter().find(|known| known.0.contains(&name)) {
        return parse(unit).ok();
    }
    let (_, dimension, factor) = *NAMES.iter().find(|unit| unit.0 == name)?;
    Some(Unit { dimension, factor })
}

/// The two units of a joined name, such as `Nm`.
fn joined(name: &str) -> Option<[Unit; 2]> {
    let split = |first: &&str, seconds: &[&str]| {
        let second = name.strip_prefix(*first)?;
        let second = seconds.iter().find(|known| **known == second)?;
        Some([simple(first)?, simple(second)?])
    };
    JOINED
        .iter()
        .find_map(|(firsts, seconds)| firsts.iter().find_map(|first| split(first, seconds)))
}

/// The ways of reading a name that begins with a force as a product of three units or of a
/// pair that [`JOINED`] does not list, as text.
pub(super) fn products(name: &str) -> Vec<String> {
    let rest = |text: &str| -> Vec<String> {
        let whole = simple(text).map(|_| text.to_owned()).into_iter();
        let split = (1..text.len()).filter(|at| text.is_char_boundary(*at));
        let pairs = split.map(|at| text.split_at(at));
        let pairs = pairs.filter(|(a, b)| simple(a).is_some() && simple(b).is_some());
        whole
            .chain(pairs.map(|(a, b)| format!("{a} {b}")))
            .collect()
    };
    let forces = NAMES.iter().filter(|unit| unit.1 == Dimension::FORCE);
    let rests = forces.filter_map(|force| Some((force.0, name.strip_prefix(force.0)?)));
    let products = rests.flat_map(|(force, text)| {
        let rests = rest(text).into_iter();
        rests.map(move |rest| format!("{force} {rest}"))
    });
    products.collect()
}

/// Splits a quantity into its number and the text of its unit, between which spaces are
/// optional; `None` if it does not begin with a number, or has no unit. `23e-6/K` is the
/// number 23e-6 and the unit `1/K`; `70 e9 Pa` and `70*10^9 Pa` have the number 70e9.
pub(super) fn split_quantity(text: &str) -> Option<(f64, String)> {
    let text = text.trim();
    let end = number_end(text)?;
    let number: f64 = text[..end].parse().ok()?;
    let after = exponent(text[end..].trim_start()).filter(|_| !text[..end].contains(['e', 'E']));
    let (number, rest) = match after {
        Some((exponent, rest)) => (format!("{}e{exponent}", &text[..end]).parse().ok()?, rest),
        None => (number, &text[end..]),
    };
    let (rest, is_apart) = (rest.trim_start(), rest.starts_with(' '));
    let unit = match rest.chars().next()? {
        '/' => format!("1{rest}"),
        '1' if is_apart => rest.to_owned(),
        first if is_letter(first) => rest.to_owned(),
        _ => return None,
    };
    Some((number, unit))
}

/// The exponent at the start of a text after a number, and the text after it: `e9`, `*10^9`,
/// `x 10^-3`, `×10⁹`; `None` for other texts.
fn exponent(text: &str) -> Option<(i32, &str)> {
    let is_plain = |at: char| at.is_ascii_digit();
    let is_raised = |at: char| RAISED.contains(&at);
    let (after, is_digit): (_, &dyn Fn(char) -> bool) = match text.strip_prefix(['e', 'E']) {
        Some(after) => (after, &is_plain),
        None => {
            let ten = text
                .strip_prefix('x')
                .or_else(|| text.strip_prefix(TIMES))?;
            let power = ten.trim_start().strip_prefix("10")?;
            match power.strip_prefix('^') {
                Some(after) => (after, &is_plain),
                None => (power, &is_raised),
            }
        }
    };
    let unsigned = after.strip_prefix(MINUS);
    let sign = if unsigned.is_some() { -1 } else { 1 };
    let digits = unsigned.unwrap_or_else(|| after.strip_prefix('+').unwrap_or(after));
    let end = digits.find(|at| !is_digit(at)).unwrap_or(digits.len());
    let (digits, rest) = digits.split_at(end);
    let size = digits.chars().try_fold(0_i32, |size, at| {
        let next = size * 10 + i32::from(digit(at)?);
        (next < 1000).then_some(next)
    })?;
    (!digits.is_empty()).then_some((sign * size, rest))
}

/// The end of the number at the start of a text; an exponent belongs to it only if it has
/// digits.
fn number_end(text: &str) -> Option<usize> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let sign = text.len() - unsigned.len();
    let digits = |from: usize| {
        let rest = &unsigned[from..];
        let count = rest.find(|at: char| !at.is_ascii_digit());
        from + count.unwrap_or(rest.len())
    };
    let mut end = digits(0);
    let mut has_digits = end > 0;
    if unsigned[end..].starts_with('.') {
        let fraction = digits(end + 1);
        has_digits |= fraction > end + 1;
        end = fraction;
    }
    if !has_digits {
        return None;
    }
    if let Some(exponent) = unsigned[end..].strip_prefix(['e', 'E']) {
        let from = unsigned.len() - exponent.strip_prefix(['+', '-']).unwrap_or(exponent).len();
        if digits(from) > from {
            end = digits(from);
        }
    }
    Some(sign + end)
}

#[cfg(test)]
mod tests {
    use super::super::{parse_any, parse_as, parse_quantity};
    use super::*;
    use crate::error::Explain;

    /// Each notation is the same unit as the one with signs of multiplication and powers.
    #[test]
    fn all_notations_of_a_unit_agree() {
        for (short, long) in [
            ("Nm", "N*m"),
            ("N·m", "N*m"),
            ("N⋅m", "N*m"),
            ("N-m", "N*m"),
            ("N m", "N*m"),
            ("kNm", "kN*m"),
            ("MNm", "MN*m"),
            ("mNm", "mN*m"),
            ("Nmm", "N*mm"),
            ("Nm2", "N*m^2"),
            ("kNmm2", "kN*mm^2"),
            ("Nm/rad", "N*m/rad"),
            ("Nm²", "N*m^2"),
            ("Ns/m", "N*s/m"),
            ("lbfin", "lbf*in"),
            ("lbf-ft", "lbf*ft"),
            ("daNm", "daN*m"),
            ("rad/sec", "rad/s"),
            ("rps", "rev/s"),
            ("degrees", "deg"),
            ("degree/second", "deg/s"),
            ("meters", "m"),
            ("inch", "in"),
            ("feet", "ft"),
            ("kg/m3", "kg/m^3"),
            ("kg m-3", "kg/m^3"),
            ("kg·m⁻³", "kg/m^3"),
            ("kgm2", "kg*m^2"),
            ("g/cm3", "g/cm^3"),
            ("g/cm³", "g/cm^3"),
            ("N/mm2", "N/mm^2"),
            ("m²", "m^2"),
            ("m⁴", "m^4"),
            ("µm", "um"),
            ("μs", "us"),
            ("kΩ", "kOhm"),
            ("°", "deg"),
            ("°C", "degC"),
            ("1/°F", "1/degF"),
            ("rad s^-1", "rad/s"),
            ("gpa", "GPa"),
            ("mpa", "MPa"),
            ("MSI", "Msi"),
            ("g/cc", "g/cm^3"),
            ("Kg/m3", "kg/m^3"),
            ("lbs/in^3", "lb/in^3"),
            ("KN/mm2", "kN/mm^2"),
        ] {
            assert_eq!(parse(short), parse(long), "{short}");
            assert!(parse(long).is_ok(), "{long}");
        }
    }

    /// Numbers by hand: 1 N/mm^2 = 1 MPa, 1 g/cm^3 = 1000 kg/m^3, 1 mN m = 1e-3 N m.
    #[test]
    fn joined_names_have_the_right_factors() {
        let close = |text, dimension, value: f64| {
            let unit = parse_as(text, dimension).unwrap();
            assert!((unit.factor / value - 1.0).abs() < 1e-15, "{text}");
        };
        close("N/mm2", Dimension::STRESS, 1e6);
        close("g/cm3", Dimension::DENSITY, 1e3);
        close("mN", Dimension::FORCE, 1e-3);
        close("mNm", Dimension::MOMENT, 1e-3);
        close("MNm", Dimension::MOMENT, 1e6);
        close("Nmm", Dimension::MOMENT, 1e-3);
        close("kNm2", Dimension::BENDING_STIFFNESS, 1e3);
        close("kgm2", Dimension::INERTIA, 1.0);
        // a known name is never a product
        close("mm", Dimension::LENGTH, 1e-3);
        close("ms", Dimension::TIME, 1e-3);
        close("kOhm", Dimension::RESISTANCE, 1e3);
    }

    #[test]
    fn spaces_before_the_unit_are_optional() {
        let read = |text, dimension| parse_quantity(text, dimension).unwrap();
        assert_eq!(read("5kN", Dimension::FORCE), 5e3);
        assert_eq!(read("-5kNm", Dimension::MOMENT), -5e3);
        assert_eq!(read("1e3N", Dimension::FORCE), 1e3);
        assert_eq!(read(" 2.5e-3 m ", Dimension::LENGTH), 2.5e-3);
        assert_eq!(read(".5mm", Dimension::LENGTH), 0.5e-3);
        assert_eq!(read("23e-6/K", Dimension::EXPANSION), 23e-6);
        assert_eq!(read("23e-6 1/K", Dimension::EXPANSION), 23e-6);
        assert_eq!(read("1.6 g/cc", Dimension::DENSITY), 1.6e3);
        for text in [
            "70 e9 Pa",
            "70 E+9 Pa",
            "70e9Pa",
            "70*10^9 Pa",
            "70 x 10^9 Pa",
            "70×10⁹ Pa",
        ] {
            assert_eq!(read(text, Dimension::STRESS), 70e9, "{text}");
        }
        assert_eq!(read("23 x10^-6/K", Dimension::EXPANSION), 23e-6);
        assert_eq!(
            read("30°", Dimension::ANGLE),
            read("30 deg", Dimension::ANGLE)
        );
        assert_eq!(parse_any("2Nm").unwrap(), (2.0, Dimension::MOMENT));
    }

    /// 1 N m/deg = 180/pi N m/rad; a force per angle is not a moment per angle.
    #[test]
    fn moments_per_angle_are_stiffnesses_of_rotation() {
        let read = |text, dimension| parse_quantity(text, dimension).unwrap();
        let stiffness = 180.0 / std::f64::consts::PI;
        assert_eq!(read("5 kN*m/rad", Dimension::MOMENT), 5e3);
        assert!((read("1 Nm/deg", Dimension::MOMENT) / stiffness - 1.0).abs() < 1e-15);
        assert_eq!(read("3 N*m*s/rad", Dimension::TURNING_DAMPER), 3.0);
        assert!(parse_quantity("1 N/rad", Dimension::FORCE).is_err());
        assert!(parse_quantity("1 N*m*rad", Dimension::MOMENT).is_err());
    }

    /// 1 ft lbf = 1.355 817 948 331 4 N m (NIST SP 811, table B.8); 1 daN = 10 N. A pound in a moment
    /// is a force: a mass times a length is no moment.
    #[test]
    fn pounds_in_moments_are_forces() {
        let read = |text, dimension| parse_quantity(text, dimension).unwrap();
        for text in [
            "3 ft-lb", "3 ft*lb", "3 lb ft", "3 ft-lbs", "36 in-lb", "3 ft-lbf",
        ] {
            let found = read(text, Dimension::MOMENT) / (3.0 * 1.355_817_948_331_4);
            assert!((found - 1.0).abs() < 1e-14, "{text}");
        }
        assert_eq!(read("20 daN m", Dimension::MOMENT), 200.0);
        assert!(parse_quantity("3 lb", Dimension::FORCE).is_err());
        assert!(parse_quantity("3 lb", Dimension::MOMENT).is_err());
    }

    #[test]
    fn frequencies_and_pounds_in_place_of_others_are_explained() {
        let help = |text, dimension| {
            let problem = parse_quantity(text, dimension).unwrap_err();
            problem.help().unwrap_or_default()
        };
        for frequency in ["5 Hz", "50 1/s"] {
            assert_eq!(
                help(frequency, Dimension::ROTATION_SPEED),
                "units of it: rpm, rad/s, deg/s; a frequency is not an angle per time: give radians \
                 per second as rad/s, and revolutions per second as rev/s"
            );
        }
        assert_eq!(
            help("3 lb/in^2", Dimension::STRESS),
            "did you mean \"lbf/in^2\"? \"lb\" is a mass"
        );
    }

    #[test]
    fn ambiguous_and_wrong_units_are_explained() {
        let help = |text, dimension| {
            let problem = parse_quantity(text, dimension).unwrap_err();
            format!("{problem}; {}", problem.help().unwrap_or_default())
        };
        assert_eq!(
            help("2 Nms/rad", Dimension::TURNING_DAMPER),
            "unknown unit \"Nms\"; separate the factors: \"N ms\" or \"N m s\""
        );
        assert_eq!(
            help("2 furlong", Dimension::ROTATION_SPEED),
            "unknown unit \"furlong\"; units of it: rpm, rad/s, deg/s"
        );
        assert_eq!(
            help("2 NM", Dimension::MOMENT),
            "unknown unit \"NM\"; did you mean \"N m\"?"
        );
        assert_eq!(
            help("2 furlong", Dimension::DENSITY),
            "unknown unit \"furlong\"; units of it: kg/m^3, g/cm^3, lb/in^3, slug/ft^3"
        );
        for bad in [
            "1,5 kN",
            "5",
            "5 ",
            "kN",
            "5 kN^",
            "5 kN^1.5",
            "5 m2.5",
            "5 m^99",
            "5 --m",
            "5 m-",
            "inf kN",
            "NaN kN",
            "5 2m",
            "5.",
            "e5 kN",
            "5 10kN",
            "5 m··m",
            "5 e Pa",
            "5e3 e3 Pa",
            "5*109 Pa",
            "5*10 Pa",
            "5 x 10^ Pa",
            "5 e9999 Pa",
        ] {
            assert!(parse_any(bad).is_err(), "{bad}");
        }
    }
}
