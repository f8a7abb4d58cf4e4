//! Units: names, compound units such as `lbf*s^2/in^4`, and the system of units
//! that an input file declares.
//!
//! Everything inside the programs is SI; only input and output convert.
//!
//! # Example
//!
//! ```
//! use shared_geom::units::{Dimension, parse_quantity};
//!
//! let stiffness = parse_quantity("73.1 GPa", Dimension::STRESS).expect("a stress");
//! assert!((stiffness - 73.1e9).abs() < 1e-3);
//! // a length is not a stress
//! assert!(parse_quantity("73.1 mm", Dimension::STRESS).is_err());
//! ```

use crate::error::{Explain, nearest_name};

mod dimension;
mod read;
mod separators;

pub use dimension::Dimension;
pub use read::parse;

use read::{products, split_quantity, with_pounds_force};

/// A unit: its dimension and the number of SI units in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its dimension.
    pub dimension: Dimension,
    /// SI units in one of it [SI unit of the dimension].
    pub factor: f64,
}

/// Pound-force in newtons: 0.45359237 kg times 9.80665 m/s^2 (exact).
const LBF: f64 = 4.448_221_615_260_5;
/// Inch in meters (exact).
const INCH: f64 = 0.0254;
/// Foot in meters (exact).
const FOOT: f64 = 0.3048;
/// Degree Rankine, equal to a degree Fahrenheit, in kelvins (exact).
const RANKINE: f64 = 5.0 / 9.0;
const DEG: f64 = std::f64::consts::PI / 180.0;
const REV: f64 = 2.0 * std::f64::consts::PI;

/// Names of the simple units, with dimension and factor.
const NAMES: &[(&str, Dimension, f64)] = &[
    ("m", Dimension::LENGTH, 1.0),
    ("mm", Dimension::LENGTH, 1e-3),
    ("cm", Dimension::LENGTH, 1e-2),
    ("km", Dimension::LENGTH, 1e3),
    ("um", Dimension::LENGTH, 1e-6),
    ("in", Dimension::LENGTH, INCH),
    ("ft", Dimension::LENGTH, FOOT),
    ("kg", Dimension::MASS, 1.0),
    ("g", Dimension::MASS, 1e-3),
    ("t", Dimension::MASS, 1e3),
    ("lb", Dimension::MASS, 0.453_592_37),
    ("slug", Dimension::MASS, LBF / FOOT),
    ("s", Dimension::TIME, 1.0),
    ("ms", Dimension::TIME, 1e-3),
    ("us", Dimension::TIME, 1e-6),
    ("min", Dimension::TIME, 60.0),
    ("h", Dimension::TIME, 3600.0),
    ("rad", Dimension::ANGLE, 1.0),
    ("deg", Dimension::ANGLE, DEG),
    ("rev", Dimension::ANGLE, REV),
    ("rpm", Dimension::ROTATION_SPEED, REV / 60.0),
    ("Hz", Dimension::FREQUENCY, 1.0),
    ("kHz", Dimension::FREQUENCY, 1e3),
    ("N", Dimension::FORCE, 1.0),
    ("kN", Dimension::FORCE, 1e3),
    ("MN", Dimension::FORCE, 1e6),
    ("mN", Dimension::FORCE, 1e-3),
    ("daN", Dimension::FORCE, 10.0),
    ("lbf", Dimension::FORCE, LBF),
    ("kip", Dimension::FORCE, 1e3 * LBF),
    ("W", Dimension::POWER, 1.0),
    ("kW", Dimension::POWER, 1e3),
    ("MW", Dimension::POWER, 1e6),
    ("hp", Dimension::POWER, 550.0 * FOOT * LBF),
    ("kt", Dimension::VELOCITY, 1852.0 / 3600.0),
    ("mph", Dimension::VELOCITY, 5280.0 * FOOT / 3600.0),
    ("Pa", Dimension::STRESS, 1.0),
    ("kPa", Dimension::STRESS, 1e3),
    ("MPa", Dimension::STRESS, 1e6),
    ("GPa", Dimension::STRESS, 1e9),
    ("psi", Dimension::STRESS, LBF / (INCH * INCH)),
    ("ksi", Dimension::STRESS, 1e3 * LBF / (INCH * INCH)),
    ("Msi", Dimension::STRESS, 1e6 * LBF / (INCH * INCH)),
    ("K", Dimension::TEMPERATURE, 1.0),
    ("degC", Dimension::TEMPERATURE, 1.0),
    ("degF", Dimension::TEMPERATURE, RANKINE),
    ("R", Dimension::TEMPERATURE, RANKINE),
    ("V", Dimension::VOLTAGE, 1.0),
    ("mV", Dimension::VOLTAGE, 1e-3),
    ("kV", Dimension::VOLTAGE, 1e3),
    ("A", Dimension::CURRENT, 1.0),
    ("mA", Dimension::CURRENT, 1e-3),
    ("uA", Dimension::CURRENT, 1e-6),
    ("C", Dimension::CHARGE, 1.0),
    ("uC", Dimension::CHARGE, 1e-6),
    ("nC", Dimension::CHARGE, 1e-9),
    ("pC", Dimension::CHARGE, 1e-12),
    ("Ohm", Dimension::RESISTANCE, 1.0),
    ("kOhm", Dimension::RESISTANCE, 1e3),
    ("MOhm", Dimension::RESISTANCE, 1e6),
    ("H", Dimension::INDUCTANCE, 1.0),
    ("mH", Dimension::INDUCTANCE, 1e-3),
    ("F", Dimension::CAPACITANCE, 1.0),
    ("uF", Dimension::CAPACITANCE, 1e-6),
    ("nF", Dimension::CAPACITANCE, 1e-9),
    ("pF", Dimension::CAPACITANCE, 1e-12),
];

/// Compound units of quantities without a simple one, for messages: other names of the
/// same unit follow the first.
const COMPOUND: &[(Dimension, &[&str])] = &[
    (Dimension::CURVATURE, &["deg/m", "rad/m"]),
    (Dimension::ROTATION_SPEED, &["rpm", "rad/s", "deg/s"]),
    (Dimension::VELOCITY, &["m/s", "km/h", "ft/s"]),
    (Dimension::MOMENT, &["N m", "kN m", "lbf in", "lbf ft"]),
    (
        Dimension::DENSITY,
        &["kg/m^3", "g/cm^3", "lb/in^3", "slug/ft^3"],
    ),
    (
        Dimension::BENDING_STIFFNESS,
        &["N m^2", "N mm^2", "lbf in^2"],
    ),
    (Dimension::CHARGE_PER_AREA, &["C/m^2", "N/V/m", "psi in/V"]),
    (Dimension::STRAIN_PER_FIELD, &["m/V", "pC/N", "in/V"]),
    (Dimension::PERMITTIVITY, &["F/m", "pF/m", "lbf/V^2"]),
];

/// The compound units of a quantity, if it has any.
fn compound(dimension: Dimension) -> Option<&'static [&'static str]> {
    let found = COMPOUND.iter().find(|known| known.0 == dimension);
    found.map(|known| known.1)
}

/// Errors of a unit or a declaration of units.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum UnitProblem {
    /// A simple unit whose name is not in the table.
    #[error("unknown unit \"{found}\"")]
    Unknown {
        /// The name as written.
        found: String,
        /// Dimension expected of the whole unit, if known.
        expected: Option<Dimension>,
    },
    /// A compound unit that cannot be parsed.
    #[error("unit \"{found}\" cannot be read, expected a product like \"lbf*s^2/in^4\"")]
    Malformed {
        /// The unit as written.
        found: String,
    },
    /// A quantity that is not a number and a unit.
    #[error("\"{found}\" cannot be read, expected {}", quantity_words(*.expected))]
    Quantity {
        /// The quantity as written.
        found: String,
        /// Dimension expected, if known.
        expected: Option<Dimension>,
    },
    /// A unit of another quantity.
    #[error("\"{found}\" measures {measures}, expected {expected}")]
    Dimension {
        /// The unit as written.
        found: String,
        /// Its dimension.
        measures: Dimension,
        /// Dimension expected.
        expected: Dimension,
    },
}

/// The form of a quantity, with an example of its kind.
fn quantity_words(expected: Option<Dimension>) -> String {
    if expected == Some(Dimension::NUMBER) {
        return "a number".to_owned();
    }
    if let Some([unit, ..]) = expected.and_then(compound) {
        return format!("a number and a unit, as in \"5 {unit}\"");
    }
    let unit = expected.filter(|expected| *expected != Dimension::STRESS);
    let unit = unit.and_then(|expected| NAMES.iter().find(|unit| unit.1 == expected));
    let example = unit.map_or("73.1 GPa".to_owned(), |unit| format!("3 {}", unit.0));
    format!("a number and a unit, as in \"{example}\"")
}

impl Explain for UnitProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Unknown { found, expected } => Some(help_with_unknown(found, *expected)),
            Self::Malformed { .. } => None,
            Self::Quantity { found, .. } => separators::without_separators(found),
            Self::Dimension {
                expected: Dimension::CURVATURE,
                ..
            } => Some("units of it: deg/m, rad/m; the inverse of a radius in m is in rad/m".into()),
            Self::Dimension {
                measures: Dimension::FREQUENCY,
                expected: Dimension::ROTATION_SPEED,
                ..
            } => Some(
                "units of it: rpm, rad/s, deg/s; a frequency is not an angle per time: give radians \
                 per second as rad/s, and revolutions per second as rev/s"
                    .into(),
            ),
            Self::Dimension {
                found, expected, ..
            } => {
                if let Some(force) = in_pounds_force(found, *expected) {
                    return Some(format!("did you mean \"{force}\"? \"lb\" is a mass"));
                }
                if let Some(units) = compound(*expected) {
                    return Some(format!("units of it: {}", units.join(", ")));
                }
                let fitting: Vec<_> = NAMES
                    .iter()
                    .filter(|unit| unit.1 == *expected)
                    .map(|unit| unit.0)
                    .collect();
                (!fitting.is_empty()).then(|| format!("units of it: {}", fitting.join(", ")))
            }
        }
    }
}

/// The nearest name among the units of the quantity `expected`, else all of them; among
/// all units if no quantity is expected, or one without a named unit.
fn help_with_unknown(found: &str, expected: Option<Dimension>) -> String {
    let products = products(found);
    if !products.is_empty() {
        return format!("separate the factors: \"{}\"", products.join("\" or \""));
    }
    let fitting = NAMES.iter().filter(|unit| Some(unit.1) == expected);
    let mut names: Vec<_> = fitting.map(|unit| unit.0).collect();
    let compound = expected.and_then(compound).unwrap_or_default().iter();
    names.extend(compound.filter(|name| NAMES.iter().all(|unit| unit.0 != **name)));
    let what = if names.is_empty() {
        "known units"
    } else {
        "units of it"
    };
    if names.is_empty() {
        names.extend(NAMES.iter().map(|unit| unit.0));
    }
    // Of names that are equally near, one of the same length is the likelier one.
    let mut by_length = names.clone();
    by_length.sort_by_key(|name| name.len().abs_diff(found.len()));
    match nearest_name(found, by_length) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("{what}: {}", names.join(", ")),
    }
}

/// The text of a unit with pounds-force in place of pounds, if it then measures `expected`.
fn in_pounds_force(text: &str, expected: Dimension) -> Option<String> {
    let changed = with_pounds_force(text)?;
    let unit = parse(&changed).ok()?;
    (unit.dimension == expected).then_some(changed)
}

/// As [`parse`], for a unit that must measure `expected`. Stiffnesses and dampers of rotation are moments
/// per radian: `N*m/rad` is `N*m`, and `N*m/deg` 180/pi of it. The pound in a moment, as in `ft-lb`,
/// is the pound-force; everywhere else it is a mass.
///
/// # Errors
/// As [`parse`], and [`UnitProblem::Dimension`].
pub fn parse_as(text: &str, expected: Dimension) -> Result<Unit, UnitProblem> {
    let unit = parse(text).map_err(|problem| match problem {
        // A part of a compound unit may have any dimension.
        UnitProblem::Unknown { found, .. } if found == text.trim() => UnitProblem::Unknown {
            found,
            expected: Some(expected),
        },
        other => other,
    })?;
    let per_angle = [Dimension::MOMENT, Dimension::TURNING_DAMPER].contains(&expected)
        && unit.dimension.times(Dimension::ANGLE, 1) == expected;
    if unit.dimension == expected || per_angle {
        Ok(unit)
    } else if let Some(force) =
        in_pounds_force(text, expected).filter(|_| expected == Dimension::MOMENT)
    {
        parse(&force)
    } else {
        Err(UnitProblem::Dimension {
            found: text.into(),
            measures: unit.dimension,
            expected,
        })
    }
}

/// Quantities with units that a file may declare, with the key of each.
pub const DECLARABLE: [(&str, Dimension); 11] = [
    ("length", Dimension::LENGTH),
    ("mass", Dimension::MASS),
    ("force", Dimension::FORCE),
    ("time", Dimension::TIME),
    ("angle", Dimension::ANGLE),
    ("stress", Dimension::STRESS),
    ("density", Dimension::DENSITY),
    ("mass_per_length", Dimension::MASS_PER_LENGTH),
    ("rotation_speed", Dimension::ROTATION_SPEED),
    ("temperature", Dimension::TEMPERATURE),
    ("voltage", Dimension::VOLTAGE),
];

/// The units of the plain numbers of a file.
///
/// A declared quantity uses its unit. Undeclared units follow from length, time, force
/// and mass: quantities with a force in them (mass to the power one, time to minus two,
/// or to minus one as in dampers) use the unit of force, others the unit of mass; a
/// missing one of the two is consistent with the other. Angles are degrees, rotation
/// speeds rpm and rises of temperature kelvins unless declared. Electric quantities are
/// composed of force, length, time and the unit of voltage, the volt unless declared: a
/// charge is a force times a length per voltage, a permittivity a force per square of a
/// voltage.
#[derive(Debug, Clone, PartialEq)]
pub struct Units {
    declared: Vec<(Dimension, f64)>,
}

impl Default for Units {
    fn default() -> Self {
        Self::si()
    }
}

impl Units {
    /// Meter, kilogram, second, newton; angles in degrees, rotation speeds in rpm.
    pub fn si() -> Self {
        Self {
            declared: Vec::new(),
        }
    }

    /// Declares the unit of one quantity.
    pub fn declare(&mut self, dimension: Dimension, unit: Unit) {
        self.declared.push((dimension, unit.factor));
    }

    /// SI units in one declared unit of `dimension` [SI unit of the dimension].
    pub fn factor(&self, dimension: Dimension) -> f64 {
        if let Some(factor) = self.declared_factor(dimension) {
            return factor;
        }
        let length = self.declared_factor(Dimension::LENGTH).unwrap_or(1.0);
        let time = self.declared_factor(Dimension::TIME).unwrap_or(1.0);
        let angle = match dimension {
            Dimension::ROTATION_SPEED => return REV / 60.0,
            _ => self.declared_factor(Dimension::ANGLE).unwrap_or(DEG),
        };
        let acceleration = length / (time * time);
        let mass = self.declared_factor(Dimension::MASS);
        let force = self.declared_factor(Dimension::FORCE);
        let Dimension {
            length: l,
            mass: m,
            time: t,
            angle: a,
            temperature: k,
            current: i,
        } = dimension;
        let kelvin = self.declared_factor(Dimension::TEMPERATURE).unwrap_or(1.0);
        let volt = self.declared_factor(Dimension::VOLTAGE).unwrap_or(1.0);
        // a current is a power per voltage, kg m^2 s^-3 V^-1
        let part = |own: i8, of_power: i8| own.saturating_add(i.saturating_mul(of_power));
        let (l, m, t) = (part(l, 2), part(m, 1), part(t, -3));
        let rest = angle.powi(i32::from(a)) * kelvin.powi(i32::from(k)) / volt.powi(i32::from(i));
        if m == 1 && matches!(t, -3..=-1) {
            let force = force
                .or(mass.map(|mass| mass * acceleration))
                .unwrap_or(1.0);
            return force * length.powi(i32::from(l) - 1) * time.powi(i32::from(t) + 2) * rest;
        }
        let mass = mass
            .or(force.map(|force| force / acceleration))
            .unwrap_or(1.0);
        mass.powi(i32::from(m)) * length.powi(i32::from(l)) * time.powi(i32::from(t)) * rest
    }

    fn declared_factor(&self, dimension: Dimension) -> Option<f64> {
        let declared = self.declared.iter().find(|pair| pair.0 == dimension);
        declared.map(|pair| pair.1)
    }
}

/// Reads a quantity with its unit, such as `10.6e6 psi`, `0.063 in` or `5kN`; the value
/// is in SI units.
///
/// # Errors
/// [`UnitProblem`]; [`UnitProblem::Quantity`] for a text without a number or a unit.
pub fn parse_quantity(text: &str, expected: Dimension) -> Result<f64, UnitProblem> {
    let malformed = || UnitProblem::Quantity {
        found: text.into(),
        expected: Some(expected),
    };
    let (number, unit) = split_quantity(text).ok_or_else(malformed)?;
    Ok(number * parse_as(&unit, expected)?.factor)
}

/// Reads a quantity of any kind with its unit; the value is in SI units.
///
/// # Errors
/// As [`parse_quantity`].
pub fn parse_any(text: &str) -> Result<(f64, Dimension), UnitProblem> {
    let malformed = || UnitProblem::Quantity {
        found: text.into(),
        expected: None,
    };
    let (number, unit) = split_quantity(text).ok_or_else(malformed)?;
    let unit = parse(&unit)?;
    if (number * unit.factor).is_finite() {
        Ok((number * unit.factor, unit.dimension))
    } else {
        Err(malformed())
    }
}

/// A number as in messages: nine digits, without the digits of round-off.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn compound_units_have_their_factors() {
        // 1 lbf s^2/in^4 = 4.4482216 / 0.0254^4 kg/m^3 (exact definitions).
        let density = parse_as("lbf*s^2/in^4", Dimension::DENSITY).unwrap();
        assert_relative_eq!(density.factor, LBF / INCH.powi(4), max_relative = 1e-15);
        // 1 slug/ft^3 = 515.3788184 kg/m^3 (NIST SP 811, table B.9).
        let slug = parse_as("slug/ft^3", Dimension::DENSITY).unwrap();
        assert_relative_eq!(slug.factor, 515.378_818_4, max_relative = 1e-9);
        // 1 psi = 6894.757293 Pa (NIST SP 811).
        let psi = parse_as("lbf/in^2", Dimension::STRESS).unwrap();
        assert_relative_eq!(psi.factor, 6_894.757_293, max_relative = 1e-9);
        assert_relative_eq!(
            parse("psi").unwrap().factor,
            psi.factor,
            max_relative = 1e-15
        );
        assert_eq!(
            parse("N m^2").unwrap().dimension,
            Dimension::BENDING_STIFFNESS
        );
        assert_eq!(parse("rev/min").unwrap(), parse("rpm").unwrap());
    }

    #[test]
    fn wrong_units_are_explained() {
        let unknown = parse("rpn").unwrap_err();
        assert_eq!(unknown.to_string(), "unknown unit \"rpn\"");
        assert_eq!(unknown.help().unwrap(), "did you mean \"rpm\"?");
        let other = parse_as("kg", Dimension::STRESS).unwrap_err();
        assert_eq!(
            other.to_string(),
            "\"kg\" measures a mass, expected a stress"
        );
        for bad in ["", "*m", "m*", "m//s", "m^x", "m^99", "m**2", "2 m"] {
            assert!(parse(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn an_unknown_unit_is_corrected_to_one_of_the_expected_quantity() {
        let help = |text, expected| parse_as(text, expected).unwrap_err().help().unwrap();
        // "MN" is as near, but it is a force.
        assert_eq!(help("mn", Dimension::LENGTH), "did you mean \"mm\"?");
        assert_eq!(help("mn", Dimension::FORCE), "did you mean \"MN\"?");
        assert_eq!(help("GPs", Dimension::STRESS), "did you mean \"GPa\"?");
        assert_eq!(
            help("furlong", Dimension::LENGTH),
            "units of it: m, mm, cm, km, um, in, ft"
        );
        // Parts of a compound unit have other dimensions than the whole.
        assert_eq!(help("kgs/m^3", Dimension::DENSITY), "did you mean \"kg\"?");
        let quantity = parse_quantity("3 mn", Dimension::LENGTH).unwrap_err();
        assert_eq!(quantity.help().unwrap(), "did you mean \"mm\"?");
    }

    #[test]
    fn undeclared_units_follow_from_length_force_and_time() {
        let mut units = Units::si();
        units.declare(Dimension::LENGTH, parse("in").unwrap());
        units.declare(Dimension::FORCE, parse("lbf").unwrap());
        let psi = parse("psi").unwrap().factor;
        assert_relative_eq!(units.factor(Dimension::STRESS), psi, max_relative = 1e-14);
        let density = parse("lbf*s^2/in^4").unwrap().factor;
        assert_relative_eq!(
            units.factor(Dimension::DENSITY),
            density,
            max_relative = 1e-14
        );
        let inertia = parse("lbf*s^2").unwrap().factor;
        let per_length = units.factor(Dimension::INERTIA_PER_LENGTH);
        assert_relative_eq!(per_length, inertia, max_relative = 1e-14);
        assert_relative_eq!(units.factor(Dimension::ROTATION_SPEED), REV / 60.0);
        assert_relative_eq!(units.factor(Dimension::ANGLE), DEG);
        // Millimeter and newton: mass is the tonne.
        let mut metric = Units::si();
        metric.declare(Dimension::LENGTH, parse("mm").unwrap());
        metric.declare(Dimension::FORCE, parse("N").unwrap());
        assert_relative_eq!(metric.factor(Dimension::MASS), 1e3, max_relative = 1e-14);
    }

    // Temperatures are differences: 9 degF and 9 R are 5 K, and there is no offset.
    #[test]
    fn temperatures_are_rises() {
        let rise = |text| parse_quantity(text, Dimension::TEMPERATURE).unwrap();
        assert_eq!(rise("50 degC"), 50.0);
        assert_relative_eq!(rise("9 degF"), 5.0, max_relative = 1e-15);
        assert_relative_eq!(rise("9 R"), 5.0, max_relative = 1e-15);
        let steel = parse_quantity("6.5e-6 1/degF", Dimension::EXPANSION).unwrap();
        assert_relative_eq!(steel, 11.7e-6, max_relative = 1e-14);
        assert!(parse_quantity("1e-5", Dimension::EXPANSION).is_err());
        assert_eq!(
            Dimension::THERMAL_MOMENT.to_string(),
            "a quantity in kg m^2 s^-2 K^-1"
        );

        let mut units = Units::si();
        assert_eq!(units.factor(Dimension::EXPANSION), 1.0);
        units.declare(Dimension::TEMPERATURE, parse("degF").unwrap());
        units.declare(Dimension::FORCE, parse("lbf").unwrap());
        units.declare(Dimension::LENGTH, parse("in").unwrap());
        assert_relative_eq!(
            units.factor(Dimension::EXPANSION),
            1.8,
            max_relative = 1e-15
        );
        let moment = parse("lbf in/degF").unwrap();
        assert_eq!(moment.dimension, Dimension::THERMAL_MOMENT);
        assert_relative_eq!(
            units.factor(Dimension::THERMAL_MOMENT),
            moment.factor,
            max_relative = 1e-14
        );
        let gradient = parse("degF/in").unwrap();
        assert_relative_eq!(
            units.factor(Dimension::TEMPERATURE_GRADIENT),
            gradient.factor,
            max_relative = 1e-14
        );
    }

    /// 1 psi in/V = 175.126835 C/m^2 = 1 lbf/(in V): one unit by three ways. A plain number
    /// in inches and pounds is in such units, made of force, length and volt.
    #[test]
    fn electric_units_are_made_of_force_length_and_voltage() {
        let e = parse_as("psi in/V", Dimension::CHARGE_PER_AREA).unwrap();
        assert_relative_eq!(e.factor, 175.126_835_246, max_relative = 1e-11);
        let d = parse_as("pC/N", Dimension::STRAIN_PER_FIELD).unwrap();
        assert_relative_eq!(d.factor, 1e-12, max_relative = 1e-15);
        assert_eq!(parse("F/m").unwrap().dimension, Dimension::PERMITTIVITY);
        assert_eq!(parse("C/V").unwrap(), parse("F").unwrap());
        assert_eq!(parse("A s").unwrap(), parse("C").unwrap());
        assert_eq!(parse("V/A").unwrap(), parse("Ohm").unwrap());
        assert_eq!(parse("V s/A").unwrap(), parse("H").unwrap());
        assert_eq!(
            parse("N m/s").unwrap().dimension,
            parse("V A").unwrap().dimension
        );

        let si = Units::si();
        let mut units = Units::si();
        units.declare(Dimension::LENGTH, parse("in").unwrap());
        units.declare(Dimension::FORCE, parse("lbf").unwrap());
        for (dimension, unit) in [
            (Dimension::VOLTAGE, "V"),
            (Dimension::CHARGE_PER_AREA, "psi in/V"),
            (Dimension::STRAIN_PER_FIELD, "in/V"),
            (Dimension::PERMITTIVITY, "lbf/V^2"),
            (Dimension::CHARGE, "lbf in/V"),
            (Dimension::CAPACITANCE, "lbf in/V^2"),
            (Dimension::CURRENT, "lbf in/s/V"),
        ] {
            assert_eq!(si.factor(dimension), 1.0, "{unit}");
            let unit = parse_as(unit, dimension).unwrap();
            assert_relative_eq!(units.factor(dimension), unit.factor, max_relative = 1e-14);
        }
        units.declare(Dimension::VOLTAGE, parse("kV").unwrap());
        let d = units.factor(Dimension::STRAIN_PER_FIELD);
        assert_relative_eq!(d, 1e-3 * INCH, max_relative = 1e-14);
        assert_eq!(
            parse_as("pC/m", Dimension::STRAIN_PER_FIELD)
                .unwrap_err()
                .help()
                .unwrap(),
            "units of it: m/V, pC/N, in/V"
        );
    }

    #[test]
    fn quantities_carry_their_unit() {
        let e = parse_quantity("10.6e6 psi", Dimension::STRESS).unwrap();
        assert_relative_eq!(e, 10.6e6 * 6_894.757_293_168, max_relative = 1e-12);
        assert!(parse_quantity("psi", Dimension::STRESS).is_err());
        assert!(parse_quantity("ten psi", Dimension::STRESS).is_err());
    }
}
