//! The stations of a blade beside another blade.
//!
//! Compared are quantities that do not depend on the reference points and axes of both blades:
//!
//! ```text
//! m = M11,  EA = K11,  EI = principal values of inverse(C[5..6, 5..6]),  GJ = 1/C44,  C = inverse(K)
//! ```

use nalgebra::Matrix6;
use shared_geom::blade::Blade;
use shared_geom::line::Side;

use super::{SolvedSpan, SolvedStation};
use crate::mesh::short;
use crate::output::text::{csv, table};
use crate::properties::{PrincipalAxes, invert_symmetric};

/// The quantities: columns, and words for reports.
pub(super) const QUANTITIES: [(&str, &str); 5] = [
    ("mass [kg/m]", "mass"),
    ("ea [N]", "EA"),
    ("ei_flap [N m^2]", "EI flap"),
    ("ei_edge [N m^2]", "EI edge"),
    ("gj [N m^2]", "GJ"),
];

/// The values of a section by its stiffness and mass; NaN without an inverse.
fn values(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> [f64; 5] {
    let compliance = invert_symmetric(stiffness);
    let [flap, edge, torsion] = compliance.map_or([f64::NAN; 3], |compliance| {
        let axes = PrincipalAxes::of_bending(&compliance);
        [axes.first, axes.second, 1.0 / compliance[(3, 3)]]
    });
    [mass[(0, 0)], stiffness[(0, 0)], flap, edge, torsion]
}

/// Mass, EA, EI flap, EI edge and GJ of a station, and of `other` at the same part of its length.
pub(in crate::output) fn values_beside(station: &SolvedStation, other: &Blade) -> [[f64; 5]; 2] {
    let side = if station.properties.name.ends_with("_inner") {
        Side::Inner
    } else {
        Side::Outer
    };
    let (stiffness, mass) = other.at(station.eta * other.length(), side);
    let own = &station.properties;
    [values(&own.stiffness, &own.mass), values(&stiffness, &mass)]
}

/// One row per station, as CSV: each quantity of the blade, of `other`, and the difference over the
/// value of `other`.
pub fn comparison_csv(span: &SolvedSpan<'_>, other: &Blade) -> String {
    let mut heading = vec!["section".to_owned(), "eta [-]".to_owned()];
    for (column, _) in QUANTITIES {
        let (name, unit) = column.split_once(' ').unwrap_or((column, ""));
        heading.extend([
            column.to_owned(),
            format!("{name}_other {unit}"),
            format!("{name}_difference [%]"),
        ]);
    }
    let rows = span.stations.iter().map(|station| {
        let [own, others] = values_beside(station, other);
        let mut cells = vec![
            station.properties.name.clone(),
            format!("{:e}", station.eta),
        ];
        for (a, b) in own.into_iter().zip(others) {
            cells.extend([a, b, 100.0 * (a / b - 1.0)].map(|value| format!("{value:e}")));
        }
        cells
    });
    csv(std::iter::once(heading).chain(rows))
}

/// The median and the largest difference of each quantity.
pub fn comparison_text(span: &SolvedSpan<'_>, other: &Blade) -> String {
    let heading = ["", "median [%]", "largest [%]", "at eta"];
    let mut lines = vec![heading.map(str::to_owned).to_vec()];
    let pairs: Vec<_> = span
        .stations
        .iter()
        .map(|one| (one.eta, values_beside(one, other)))
        .collect();
    for (number, (_, word)) in QUANTITIES.iter().enumerate() {
        let part = |(eta, [own, others]): &(f64, [[f64; 5]; 2])| {
            (100.0 * (own[number] / others[number] - 1.0), *eta)
        };
        let mut parts: Vec<(f64, f64)> = pairs.iter().map(part).collect();
        parts.retain(|part| part.0.is_finite());
        parts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let median = parts.get(parts.len() / 2);
        let largest = parts.iter().max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        if let (Some(median), Some(largest)) = (median, largest) {
            lines.push(vec![
                (*word).to_owned(),
                format!("{:+.2}", median.0),
                format!("{:+.2}", largest.0),
                short(largest.1),
            ]);
        }
    }
    format!(
        "Differences from \"{}\", {} m long\n{}",
        other.name,
        short(other.length()),
        table(&lines, "lrrr")
    )
}
