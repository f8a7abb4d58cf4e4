//! The arguments of the commands that work with property files.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use nalgebra::Vector2;
use shared_geom::error::{Explain, nearest_name};
use shared_geom::units::{Dimension, UnitProblem, parse_quantity};

pub(super) const REPORT: &str = "\
Shows property files as text and tables

Prints for each file its origin, the convention, stiffness and mass, engineering
values about the centers, centers, principal axes and couplings, as the report of an
analysis does.";

pub(super) const REPORT_EXAMPLE: &str = "\
Example:
  section-analyzer report blade/results/root.properties.json";

pub(super) const COMPARE: &str = "\
Compares two property files

Prints the differences of B from A, relative to reference values: stiffness and
mass to sqrt(Aii Ajj), centers to the radius of gyration sqrt((EIy + EIz) / EA) of A,
principal values to themselves; then the numbers that differ by more than the
tolerance, largest first.

If the files have different reference points, or one was rotated relative to its mesh, B
is first transformed to the point and the axes of A, which is reported. With --as-given
the numbers are compared as they are.";

pub(super) const COMPARE_EXAMPLE: &str = "\
Example, the same section on two meshes:
  section-analyzer compare fine.properties.json coarse.properties.json --tolerance 1e-3

Exit codes: 0 equal within the tolerance; 1 different; 2 wrong input or command line.";

pub(super) const SHIFT: &str = "\
Moves the reference point of a property file

Writes the same section about another reference point: stiffness and mass are shifted
exactly, and the centers and everything else are relative to the new point. The section
and its axes stay in position. The new file states its origin and the
change.";

pub(super) const SHIFT_EXAMPLE: &str = "\
Examples, the point 25 mm ahead of the present one, and the shear center:
  section-analyzer shift a.properties.json --to \"25 mm, 0\" --out b.properties.json
  section-analyzer shift a.properties.json --to shear-center --out b.properties.json";

pub(super) const ROTATE: &str = "\
Turns the axes of a property file

Writes the same section in axes y, z turned about +x (from +y toward +z) at the same
reference point: stiffness, mass and everything else are transformed exactly. The
section stays in position, so that in the new axes it appears turned the other way. The
new file states its origin and the change.";

pub(super) const ROTATE_EXAMPLE: &str = "\
Examples, axes turned nose up, and axes along the principal axes of bending:
  section-analyzer rotate a.properties.json --angle \"3.5 deg\" --out b.properties.json
  section-analyzer rotate a.properties.json --to-principal bending --out b.properties.json";

/// Files to show.
#[derive(Debug, Args)]
pub(in crate::cli) struct ReportArguments {
    /// Property files, NAME.properties.json, or solved blades, NAME.blade.json, for all of their sections
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
}

/// Files to compare.
#[derive(Debug, Args)]
pub(in crate::cli) struct CompareArguments {
    /// Property file to compare with
    pub a: PathBuf,
    /// Property file to compare
    pub b: PathBuf,
    /// Largest relative difference that is treated as equal
    #[arg(long, value_name = "NUMBER", default_value = "1e-6", value_parser = tolerance, allow_hyphen_values = true)]
    pub tolerance: f64,
    /// Compare the numbers as they are, each about its own point and in its own axes
    #[arg(long)]
    pub as_given: bool,
}

/// The new reference point.
#[derive(Debug, Args)]
pub(in crate::cli) struct ShiftArguments {
    /// Property file, NAME.properties.json
    pub file: PathBuf,
    /// New reference point: Y,Z relative to the present point in its axes, with their units
    /// ("25 mm, 0"); or tension-center, shear-center, mass-center
    #[arg(long, value_name = "POINT", value_parser = point, allow_hyphen_values = true)]
    pub to: Point,
    /// Property file to write, different from FILE
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// The rotation of the axes.
#[derive(Debug, Args)]
pub(in crate::cli) struct RotateArguments {
    /// Property file, NAME.properties.json
    pub file: PathBuf,
    #[command(flatten)]
    pub turn: Turn,
    /// Property file to write, different from FILE
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// The rotation of the axes, in one of two ways.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub(in crate::cli) struct Turn {
    /// Angle with its unit, positive from +y toward +z: "30 deg", "0.5 rad"
    #[arg(long, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    pub angle: Option<f64>,
    /// Turn y to the first principal axis
    #[arg(long, value_name = "AXES", value_enum)]
    pub to_principal: Option<PrincipalName>,
}

/// A reference point for components.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::cli) enum Point {
    /// (y, z) from the present reference point \[m\].
    At(Vector2<f64>),
    TensionCenter,
    ShearCenter,
    MassCenter,
}

/// Kinds of principal axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum PrincipalName {
    /// Of the bending stiffness at the tension center
    Bending,
    /// Of the moments of inertia at the mass center
    Inertia,
}

const CENTERS: [(&str, Point); 3] = [
    ("tension-center", Point::TensionCenter),
    ("shear-center", Point::ShearCenter),
    ("mass-center", Point::MassCenter),
];

/// Two lengths, or the name of a center.
fn point(text: &str) -> Result<Point, String> {
    let trimmed = text.trim();
    if let Some((_, center)) = CENTERS.iter().find(|center| center.0 == trimmed) {
        return Ok(*center);
    }
    let coordinates: Vec<_> = trimmed.split(',').collect();
    if let [y, z] = coordinates[..] {
        return Ok(Point::At(Vector2::new(length(y)?, length(z)?)));
    }
    let names = CENTERS.map(|center| center.0);
    Err(match nearest_name(trimmed, names) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("expected Y,Z as in \"25 mm, 0\", or {}", names.join(", ")),
    })
}

/// A length with its unit, or zero, in meters.
fn length(text: &str) -> Result<f64, String> {
    const EXPECTED: &str = "a length with its unit, such as \"25 mm\" or \"0.025 m\"";
    match text.trim().parse::<f64>() {
        Ok(0.0) => Ok(0.0),
        Ok(number) if number.is_finite() => {
            Err(format!("{number} has no unit, expected {EXPECTED}"))
        }
        _ => finite(quantity(text.trim(), Dimension::LENGTH, EXPECTED)?),
    }
}

/// An angle with its unit, in radians.
fn angle(text: &str) -> Result<f64, String> {
    const EXPECTED: &str = "an angle with its unit, such as \"30 deg\" or \"0.5 rad\"";
    if text.trim().parse::<f64>().is_ok() {
        return Err(format!("it has no unit, expected {EXPECTED}"));
    }
    let angle = finite(quantity(text.trim(), Dimension::ANGLE, EXPECTED)?)?;
    // round-off leaves no accurate digit of a much larger angle
    if angle.abs() <= 1000.0 * std::f64::consts::TAU {
        Ok(angle)
    } else {
        Err("expected at most 1000 revolutions".to_owned())
    }
}

fn quantity(text: &str, dimension: Dimension, expected: &str) -> Result<f64, String> {
    parse_quantity(text, dimension).map_err(|problem| match &problem {
        UnitProblem::Quantity { .. } => format!("expected {expected}"),
        other => match other.help() {
            Some(help) => format!("{other}; {help}"),
            None => other.to_string(),
        },
    })
}

fn tolerance(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok();
    let good = number.filter(|number| number.is_finite() && *number >= 0.0);
    good.ok_or_else(|| "expected a number, 0 or more".to_owned())
}

fn finite(value: f64) -> Result<f64, String> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err("expected finite numbers".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_lengths_or_centers() {
        let at = |y: f64, z: f64| Ok(Point::At(Vector2::new(y, z)));
        assert_eq!(point("25 mm, -0.5 m"), at(25.0 * 1e-3, -0.5));
        assert_eq!(point("25mm, 0"), at(25.0 * 1e-3, 0.0));
        assert_eq!(point(" -1 in,2e-3 m "), at(-0.0254, 2e-3));
        assert_eq!(point("shear-center"), Ok(Point::ShearCenter));
        for (text, expected) in [
            ("sheer-center", "did you mean \"shear-center\"?"),
            ("nose", "expected Y,Z as in \"25 mm, 0\""),
            ("1,2,3", "expected Y,Z"),
            (
                "25, 0",
                "25 has no unit, expected a length with its unit, such as \"25 mm\"",
            ),
            ("1 m, nan", "expected a length with its unit"),
            ("1 m, inf mm", "expected a length with its unit"),
            (
                "2 deg, 0",
                "\"deg\" measures an angle, expected a length; units of it: m, mm",
            ),
            ("2 mn, 0", "unknown unit \"mn\"; did you mean"),
            (",", "expected a length with its unit"),
            ("", "expected Y,Z"),
        ] {
            let shown = point(text).unwrap_err();
            assert!(shown.contains(expected), "{text}: {shown}");
        }
    }

    #[test]
    fn angles_need_a_unit() {
        assert_eq!(angle("180 deg"), Ok(std::f64::consts::PI));
        assert_eq!(angle("-0.5 rad"), Ok(-0.5));
        for (text, expected) in [
            ("30", "it has no unit, expected an angle"),
            ("thirty deg", "expected an angle with its unit"),
            ("1e20 deg", "expected at most 1000 revolutions"),
            ("nan deg", "expected an angle with its unit"),
            ("3 mm", "\"mm\" measures a length, expected an angle"),
        ] {
            let shown = angle(text).unwrap_err();
            assert!(shown.contains(expected), "{text}: {shown}");
        }
    }

    #[test]
    fn tolerances_are_zero_or_more() {
        assert_eq!(tolerance("0"), Ok(0.0));
        assert_eq!(tolerance("1e-3"), Ok(1e-3));
        for text in ["-1e-9", "nan", "inf", "tight", ""] {
            assert!(tolerance(text).is_err(), "{text}");
        }
    }
}
