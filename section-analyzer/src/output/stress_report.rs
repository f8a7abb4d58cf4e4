//! The text report of a recovery: the load, what it comes to, the extreme stresses and
//! the failure indices of each region.

use nalgebra::Vector6;
use shared_geom::wrench::COMPONENTS;

use super::strengths::strengths;
use super::text::{ZERO, coordinate, number, table};
use crate::material::MaterialLimits;
use crate::recovery::{Extreme, Range, Recovery, STRESS_NAMES, region_failures, region_stresses};
use crate::section::Section;

const CONVENTION: &str = "\
Convention
  Stresses xx to xy are in section axes: x along the beam, y and z in the section. 11 to
  12 are in material axes: 1 the fiber, 2 across it in the ply, 3 the normal of the wall.
  Moments are about the reference point, the origin of the mesh. SI units: N, m, Pa.
";

/// The report of the stresses of `section` under one load; `limits` are the strengths
/// of its materials.
pub fn stress_report(section: &Section, limits: &[MaterialLimits], recovery: &Recovery) -> String {
    let parts = [
        format!(
            "Stresses of section \"{}\" under load \"{}\"\n",
            section.name, recovery.load.name
        ),
        CONVENTION.to_owned(),
        strengths(&section.materials, limits),
        load(recovery),
        stresses(section, recovery),
        failures(section, limits, recovery),
    ];
    let parts: Vec<_> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join("\n")
}

fn load(recovery: &Recovery) -> String {
    let heading = ["", "load", "of the stresses", "generalized strain"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let strain = without_round_off(&recovery.generalized_strain);
    let resultant = without_round_off(&recovery.resultant);
    for (i, component) in COMPONENTS.iter().enumerate() {
        rows.push(vec![
            (*component).to_owned(),
            number(recovery.load.force[i]),
            number(resultant[i]),
            number(strain[i]),
        ]);
    }
    format!(
        "Internal force [N, N m] and generalized strain [-, 1/m]\n{}  \
         (the resultants of the stresses differ from the load by {:.1e} of it)\n",
        table(&rows, "lr"),
        recovery.resultant_error
    )
}

/// What is zero beside the largest component, shown as zero.
fn without_round_off(values: &Vector6<f64>) -> Vector6<f64> {
    let scale = values.amax();
    values.map(|value| {
        if value.abs() <= ZERO * scale {
            0.0
        } else {
            value
        }
    })
}

fn stresses(section: &Section, recovery: &Recovery) -> String {
    let size = size(section);
    let mut parts = Vec::new();
    for region in region_stresses(section, recovery) {
        let name = &section.mesh.groups[region.group];
        parts.push(format!(
            "Extreme stresses of region \"{name}\", at integration points [Pa, m]\n{}",
            ranges(&region.points, "cell", size)
        ));
        parts.push(format!(
            "Extreme stresses of region \"{name}\", smoothed at nodes [Pa, m]\n{}",
            ranges(&region.nodes, "node", size)
        ));
    }
    parts.join("\n")
}

/// Largest coordinate of a node: what is zero beside it is shown as zero \[m\].
fn size(section: &Section) -> f64 {
    let coordinates = section.mesh.nodes.iter().flatten();
    coordinates.fold(0.0, |size, x| x.abs().max(size))
}

fn ranges(ranges: &[Range; 13], what: &str, size: f64) -> String {
    let heading = ["", "smallest", what, "y", "z", "largest", what, "y", "z"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let scale = ranges
        .iter()
        .map(|range| range.min.value.abs().max(range.max.value.abs()));
    let scale = scale.fold(0.0, f64::max);
    for (range, name) in ranges.iter().zip(STRESS_NAMES) {
        let mut row = vec![name.to_owned()];
        row.extend(extreme(&range.min, scale, size));
        row.extend(extreme(&range.max, scale, size));
        rows.push(row);
    }
    table(&rows, "lr")
}

/// Value, tag and place; round-off has no place.
fn extreme(extreme: &Extreme, scale: f64, size: f64) -> [String; 4] {
    if extreme.value.abs() <= ZERO * scale {
        return ["0", "", "", ""].map(str::to_owned);
    }
    let [y, z] = extreme.place.map(|x| coordinate(x, size));
    [number(extreme.value), extreme.tag.to_string(), y, z]
}

fn failures(section: &Section, limits: &[MaterialLimits], recovery: &Recovery) -> String {
    let found = region_failures(section, limits, recovery);
    if found.is_empty() {
        return "Failure indices\n  none: no material has strengths\n".to_owned();
    }
    let heading = [
        "region",
        "criterion",
        "index",
        "reserve factor",
        "mode",
        "cell",
        "y [m]",
        "z [m]",
    ];
    let size = size(section);
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for failure in &found {
        let [y, z] = failure.place.map(|x| coordinate(x, size));
        rows.push(vec![
            section.mesh.groups[failure.group].clone(),
            failure.worst.criterion.name().to_owned(),
            number(failure.worst.index),
            reserve(failure.worst.reserve_factor),
            failure.worst.mode.name().to_owned(),
            failure.tag.to_string(),
            y,
            z,
        ]);
    }
    let smallest = found.iter().map(|failure| failure.worst.reserve_factor);
    let smallest = smallest.fold(f64::INFINITY, f64::min);
    format!(
        "Failure indices at the integration point with the smallest reserve factor\n  \
         (safe up to an index of 1; the load times the reserve factor has the index 1)\n{}  \
         smallest reserve factor: {}\n",
        table(&rows, "llrrlr"),
        reserve(smallest)
    )
}

fn reserve(factor: f64) -> String {
    match factor.is_finite() {
        true => number(factor),
        false => "none".to_owned(),
    }
}
