//! The comparison of two property files, as text and numbers.

use nalgebra::Matrix6;
use shared_geom::section::SectionProperties;
use shared_geom::wrench::COMPONENTS;

use super::parts::joined;
use super::text::{ZERO, coordinate, number, table};
use crate::properties::{Difference, Entry, Part};

/// Largest number of entries in the list of differences.
const SHOWN: usize = 12;

/// Name of a property file and its content.
pub type Named<'a> = (&'a str, &'a SectionProperties);

/// The comparison of the files A and B; the last part is the verdict.
pub fn comparison(a: Named<'_>, b: Named<'_>, difference: &Difference, tolerance: f64) -> String {
    let of_part = |part: Part| {
        difference
            .entries
            .iter()
            .filter(move |entry| entry.part == part)
    };
    let rest = |entry: &&Entry| {
        let shown = [Part::Stiffness, Part::Mass, Part::Center, Part::Principal];
        !shown.contains(&entry.part)
    };
    let length = difference.length;
    let mass = if a.1.mass[(0, 0)] == 0.0 && b.1.mass[(0, 0)] == 0.0 {
        "Mass per length\n  neither section has mass\n".to_owned()
    } else {
        format!(
            "Mass per length, (B - A)ij / sqrt(Aii Ajj)\n{}",
            relative_matrix(&difference.mass)
        )
    };
    let parts = [
        head(a, b, difference),
        format!(
            "Stiffness, (B - A)ij / sqrt(Aii Ajj)\n{}",
            relative_matrix(&difference.stiffness)
        ),
        mass,
        format!(
            "Centers, differences relative to {} m: sqrt((EIy + EIz) / EA) of A\n{}",
            number(length),
            entries(of_part(Part::Center), length)
        ),
        format!(
            "Principal axes, angles weighted with |first - second| / larger\n{}",
            entries(of_part(Part::Principal), 0.0)
        ),
        optional(entries(difference.entries.iter().filter(rest), 0.0)),
        verdict(difference, tolerance),
    ];
    joined(&parts)
}

fn head(a: Named<'_>, b: Named<'_>, difference: &Difference) -> String {
    let source = |named: Named<'_>| named.1.provenance.input_hash.clone();
    let inputs = match source(a) == source(b) {
        _ if source(a).is_empty() || source(b).is_empty() => "unknown for at least one of them",
        true => "the same mesh and materials",
        false => "different",
    };
    let mut text = format!(
        "Comparison\n  A         {}: \"{}\"\n  B         {}: \"{}\"\n  inputs    {inputs}\n",
        a.0, a.1.name, b.0, b.1.name
    );
    if difference.brought.is_empty() {
        let point = |named: Named<'_>| {
            let point = named.1.reference_point;
            [point.x, point.y]
                .map(|value| coordinate(value, difference.length))
                .join(", ")
        };
        text += &if a.1.reference_point == b.1.reference_point {
            format!("  point     ({}) m for both\n", point(a))
        } else {
            format!(
                "  point     ({}) m for A, ({}) m for B: as given\n",
                point(a),
                point(b)
            )
        };
    }
    for (number, change) in difference.brought.iter().enumerate() {
        let label = if number == 0 { "point" } else { "" };
        text += &format!("  {label:<9} B is transformed to A: {change}\n");
    }
    text
}

/// The relative differences under the names of the components.
fn relative_matrix(a: &Matrix6<f64>) -> String {
    let heading = std::iter::once("").chain(COMPONENTS).map(str::to_owned);
    let mut rows = vec![heading.collect::<Vec<_>>()];
    for (i, name) in COMPONENTS.into_iter().enumerate() {
        let values = a
            .row(i)
            .iter()
            .map(|value| relative(*value))
            .collect::<Vec<_>>();
        rows.push(std::iter::once(name.to_owned()).chain(values).collect());
    }
    table(&rows, "lr")
}

/// A relative difference to two digits, with its sign.
fn relative(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        format!("{value:+.1e}")
    }
}

/// A table of entries; lengths that are round-off compared with `scale` are shown as zero.
fn entries<'a>(entries: impl Iterator<Item = &'a Entry>, scale: f64) -> String {
    let heading = ["", "A", "B", "", "relative"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    rows.extend(entries.map(|entry| row(entry, scale)));
    match rows.len() {
        1 => String::new(),
        _ => table(&rows, "lrrlr"),
    }
}

fn row(entry: &Entry, scale: f64) -> Vec<String> {
    let (a, b, unit) = match entry.unit {
        "rad" => (entry.a.to_degrees(), entry.b.to_degrees(), "deg"),
        unit => (entry.a, entry.b, unit),
    };
    let shown = |value: f64| match (entry.unit, scale > 0.0) {
        ("rad", _) => coordinate(value, 1.0),
        (_, true) => coordinate(value, scale),
        (_, false) => number(beside(value, entry)),
    };
    vec![
        entry.name.clone(),
        shown(a),
        shown(b),
        unit.to_owned(),
        relative(entry.relative),
    ]
}

/// The value, or zero if it is round-off compared with the reference of the relative
/// difference.
fn beside(value: f64, entry: &Entry) -> f64 {
    let weight = ((entry.b - entry.a) / entry.relative).abs();
    if value.abs() <= ZERO * weight {
        0.0
    } else {
        value
    }
}

fn optional(table: String) -> String {
    if table.is_empty() {
        table
    } else {
        format!("Curvature, electrodes, temperature, prestress, damping\n{table}")
    }
}

/// The verdict: the differences beyond the tolerance, largest first, or equality.
fn verdict(difference: &Difference, tolerance: f64) -> String {
    let beyond = difference.beyond(tolerance);
    let tolerance = if tolerance == 0.0 {
        "0".to_owned()
    } else {
        format!("{tolerance:e}")
    };
    let mut text = String::new();
    if !difference.unlike.is_empty() {
        text += "Unlike\n";
        for words in &difference.unlike {
            text += &format!("  {words}\n");
        }
        text.push('\n');
    }
    let (count, all) = (beyond.len(), difference.entries.len());
    if count == 0 {
        let words = if difference.unlike.is_empty() {
            "Equal within"
        } else {
            "The numbers of both are equal within"
        };
        let largest = relative(difference.largest()).replace('+', "");
        return text
            + &format!("{words} {tolerance}: the largest relative difference is {largest}\n");
    }
    text +=
        &format!("Different: {count} of {all} numbers by more than {tolerance}, largest first\n");
    let heading = ["", "", "A", "B", "", "relative"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for entry in beyond.iter().take(SHOWN) {
        let mut cells = vec![part(entry.part).to_owned()];
        cells.extend(row(entry, 0.0));
        rows.push(cells);
    }
    text += &table(&rows, "llrrlr");
    if count > SHOWN {
        text += &format!("  and {} more\n", count - SHOWN);
    }
    text
}

fn part(part: Part) -> &'static str {
    match part {
        Part::Stiffness => "stiffness",
        Part::Mass => "mass",
        Part::Center => "center",
        Part::Principal => "principal axes",
        Part::Curvature => "undeformed beam",
        Part::Piezo => "electrodes",
        Part::Thermal => "temperature",
        Part::Prestress => "prestress",
        Part::Damping => "damping",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1e-9 compared with a stiffness of 1e6 is round-off, 1e-3 is not.
    #[test]
    fn round_off_of_a_different_number_is_shown_as_zero() {
        let shown = |a: f64| {
            let entry = Entry {
                part: Part::Stiffness,
                name: "axial-torsion".to_owned(),
                a,
                b: 2e6,
                unit: "N m",
                relative: (2e6 - a) / 1e6,
            };
            row(&entry, 0.0)[1].clone()
        };
        assert_eq!(shown(-1e-9), "0");
        assert_eq!(shown(-1e-3), "-1.00000e-3");
        assert_eq!(shown(2e6), "2.00000e6");
    }
}
