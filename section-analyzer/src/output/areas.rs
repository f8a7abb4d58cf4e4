//! Areas, moments of area and perimeters, in the report and as a table.

use super::text::{coordinate, number, table};
use crate::properties::{AreaProperties, AreaTable};

/// The part of the report; moments below round-off are shown as zero.
pub(super) fn areas(areas: &AreaTable) -> String {
    let rows = || areas.regions.iter().chain([&areas.total]);
    let heading = |columns: &[&str]| columns.iter().map(|&name| name.to_owned()).collect();

    let mut about_reference: Vec<Vec<String>> = vec![heading(&[
        "region", "int y dA", "int z dA", "Iyy", "Izz", "Iyz",
    ])];
    about_reference.extend(rows().map(|row| {
        let area = row.area;
        let first = row.first.map(|moment| shown(moment, area.powf(1.5)));
        let second = [row.second.yy, row.second.zz, row.second.yz];
        let second = second.map(|moment| shown(moment, area * area));
        named(row, first.into_iter().chain(second))
    }));

    let mut about_centroid: Vec<Vec<String>> = vec![heading(&[
        "region",
        "y",
        "z",
        "Iyy",
        "Izz",
        "Iyz",
        "perimeter",
    ])];
    let size = areas.total.area.sqrt();
    about_centroid.extend(rows().map(|row| {
        let position = row.centroid.map(|value| coordinate(value, size));
        let second = [row.central.yy, row.central.zz, row.central.yz];
        let second = second.map(|moment| shown(moment, row.area * row.area));
        let perimeter = number(row.perimeter.length());
        named(row, position.into_iter().chain(second).chain([perimeter]))
    }));
    format!(
        "Moments of area about the reference point [m^3, m^4]\n{}\n\
         Centroid, moments of area about it, and length of the boundary [m, m^4]\n\
         \x20 (Iyy = int z^2 dA, Izz = int y^2 dA, Iyz = int y z dA)\n{}{}",
        table(&about_reference, "lr"),
        table(&about_centroid, "lr"),
        boundary(&areas.total),
    )
}

fn named(row: &AreaProperties, cells: impl Iterator<Item = String>) -> Vec<String> {
    std::iter::once(row.name.clone()).chain(cells).collect()
}

/// `value`, or zero if it is round-off compared with `scale`.
fn shown(value: f64, scale: f64) -> String {
    number(if value.abs() <= super::text::ZERO * scale {
        0.0
    } else {
        value
    })
}

/// Outline and holes of the whole section.
fn boundary(total: &AreaProperties) -> String {
    let perimeter = &total.perimeter;
    let lengths = |lines: &[f64]| {
        let lines = lines.iter().map(|&length| number(length));
        lines.collect::<Vec<_>>().join(", ")
    };
    let outer = format!("  outline {}", lengths(&perimeter.outer));
    match perimeter.holes.len() {
        0 => format!("{outer}, no hole\n"),
        1 => format!("{outer}; 1 hole {}\n", lengths(&perimeter.holes)),
        holes => format!("{outer}; {holes} holes {}\n", lengths(&perimeter.holes)),
    }
}

const HEADING: [&str; 18] = [
    "region",
    "cells",
    "area [m^2]",
    "centroid_y [m]",
    "centroid_z [m]",
    "first_moment_y [m^3]",
    "first_moment_z [m^3]",
    "iyy [m^4]",
    "izz [m^4]",
    "iyz [m^4]",
    "central_iyy [m^4]",
    "central_izz [m^4]",
    "central_iyz [m^4]",
    "perimeter [m]",
    "outer_perimeter [m]",
    "holes",
    "hole_perimeter [m]",
    "mass [kg/m]",
];

/// One row per region and one for the whole section, called `total`, as CSV.
///
/// `first_moment_y` is `int y dA`, `iyy` is `int z^2 dA`, `izz` is `int y^2 dA`, all about the
/// reference point; moments called central are about the centroid of the row.
pub fn areas_csv(areas: &AreaTable) -> String {
    let rows = areas.regions.iter().chain([&areas.total]).map(csv_row);
    super::text::csv(std::iter::once(HEADING.map(str::to_owned).to_vec()).chain(rows))
}

fn csv_row(row: &AreaProperties) -> Vec<String> {
    // an empty sum is -0
    let exact = |value: f64| format!("{:e}", value + 0.0);
    let [y, z] = row.centroid;
    let [first_y, first_z] = row.first;
    let (second, central) = (row.second, row.central);
    let mut cells = vec![row.name.clone(), row.cells.to_string()];
    cells.extend([row.area, y, z, first_y, first_z].map(exact));
    cells.extend([second.yy, second.zz, second.yz].map(exact));
    cells.extend([central.yy, central.zz, central.yz].map(exact));
    let perimeter = &row.perimeter;
    cells.extend([perimeter.length(), perimeter.outer_length()].map(exact));
    cells.push(perimeter.holes.len().to_string());
    cells.extend([perimeter.hole_length(), row.mass].map(exact));
    cells
}
