//! The text report of a recovery: the load, the resultants of the stresses, the extreme
//! stresses and the failure indices of each region.

use nalgebra::Vector6;
use shared_geom::wrench::COMPONENTS;

use super::electric_states::electrodes;
use super::round_off::{size, without_round_off};
use super::strengths::strengths;
use super::text::{ZERO, coordinate, number, table};
use crate::material::{ElasticLaw, MaterialLimits};
use crate::recovery::{Extreme, Range, Recovery, STRESS_NAMES, region_failures, region_stresses};
use crate::section::Section;

const CONVENTION: &str = "\
Convention
  Stresses xx to xy are in section axes: x along the beam, y and z in the section. 11 to
  12 are in material axes: 1 the fiber, 2 across it in the ply, 3 the normal of the wall;
  the stress of isotropic materials is listed without them.
  Moments are about the reference point, the origin of the mesh. SI units: N, m, Pa.
";

/// Indices of the stresses in material axes among the 13 stresses.
const MATERIAL_AXES: std::ops::Range<usize> = 6..12;

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
        load(recovery, size(section)),
        electrodes(section, recovery),
        stresses(section, recovery),
        failures(section, limits, recovery),
    ];
    let parts: Vec<_> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join("\n")
}

/// `size` is the largest coordinate of a node \[m\].
fn load(recovery: &Recovery, size: f64) -> String {
    let heading = ["", "load", "of the stresses", "generalized strain"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let strain = without_round_off(&recovery.generalized_strain, size, recovery.strain_scale);
    // without internal force, the resultant of a load along the beam is round-off
    let has_force = recovery.load.force.amax() > 0.0;
    let resultant = if has_force {
        without_round_off(&recovery.resultant, size.recip(), 0.0)
    } else {
        Vector6::zeros()
    };
    for (i, component) in COMPONENTS.iter().enumerate() {
        rows.push(vec![
            (*component).to_owned(),
            number(recovery.load.force[i]),
            number(resultant[i]),
            number(strain[i]),
        ]);
    }
    format!(
        "Internal force about the reference point [N, N m] and generalized strain [-, 1/m]\n{}{}  \
         (the resultants of the stresses differ from the load by {:.1e} of {})\n",
        table(&rows, "lr"),
        acting_with(recovery),
        recovery.resultant_error,
        match (recovery.load.imposed.is_empty(), has_force) {
            (true, true) => "it",
            (true, false) => "their size",
            (false, _) => "it or of the imposed stresses",
        },
    )
}

/// The imposed states of the load and the load along the beam, if there are any.
fn acting_with(recovery: &Recovery) -> String {
    let states = &recovery.load.imposed;
    let mut words = if states.is_empty() {
        String::new()
    } else {
        format!("  under the imposed strains of {}\n", states.join(", "))
    };
    if recovery.is_distributed {
        words += "  with a load along the beam, shown at the end\n";
    }
    words
}

fn stresses(section: &Section, recovery: &Recovery) -> String {
    let (size, least) = (size(section), recovery.stress_scale);
    let mut parts = Vec::new();
    for region in region_stresses(section, recovery) {
        let name = &section.mesh.groups[region.group];
        let has_axes = has_material_axes(section, region.group);
        parts.push(format!(
            "Extreme stresses of region \"{name}\", at integration points [Pa, m]\n{}",
            ranges(&region.points, has_axes, "cell", (size, least))
        ));
        parts.push(format!(
            "Extreme stresses of region \"{name}\", smoothed at nodes [Pa, m]\n{}",
            ranges(&region.nodes, has_axes, "node", (size, least))
        ));
    }
    parts.join("\n")
}

/// Whether a material of the region has material axes.
fn has_material_axes(section: &Section, group: usize) -> bool {
    let mut cells = section.mesh.cells.iter().zip(&section.cells);
    cells.any(|(cell, made_of)| {
        let law = &section.materials[made_of.material].law;
        cell.group == group && !matches!(law, ElasticLaw::Isotropic { .. })
    })
}

/// Rows of the stresses, in material axes only if `has_axes`; `size` is the largest
/// coordinate, `least` the reference size for round-off of stresses.
fn ranges(ranges: &[Range; 13], has_axes: bool, what: &str, (size, least): (f64, f64)) -> String {
    let heading = ["", "smallest", what, "y", "z", "largest", what, "y", "z"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let scale = ranges
        .iter()
        .map(|range| range.min.value.abs().max(range.max.value.abs()));
    let scale = scale.fold(least, f64::max);
    for (i, (range, name)) in ranges.iter().zip(STRESS_NAMES).enumerate() {
        if MATERIAL_AXES.contains(&i) && !has_axes {
            continue;
        }
        let mut row = vec![name.to_owned()];
        row.extend(extreme(&range.min, scale, size));
        row.extend(extreme(&range.max, scale, size));
        rows.push(row);
    }
    table(&rows, "lr")
}

/// Value, tag and position; round-off has no position.
fn extreme(extreme: &Extreme, scale: f64, size: f64) -> [String; 4] {
    if extreme.value.abs() <= ZERO * scale {
        return ["0", "", "", ""].map(str::to_owned);
    }
    let [y, z] = extreme.position.map(|x| coordinate(x, size));
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
    let is_stressed = stressed_groups(section, recovery);
    for failure in &found {
        if !is_stressed[failure.group] {
            let name = section.mesh.groups[failure.group].clone();
            let criterion = failure.worst.criterion.name().to_owned();
            rows.push(vec![
                name,
                criterion,
                "0".to_owned(),
                reserve(f64::INFINITY),
            ]);
            continue;
        }
        let [y, z] = failure.position.map(|x| coordinate(x, size));
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
    let stressed = found.iter().filter(|failure| is_stressed[failure.group]);
    let smallest = stressed.map(|failure| failure.worst.reserve_factor);
    let smallest = smallest.fold(f64::INFINITY, f64::min);
    format!(
        "Failure indices at the integration point with the smallest reserve factor\n  \
         (safe up to an index of 1; the load times the reserve factor has the index 1)\n{}  \
         smallest reserve factor: {}\n",
        table(&rows, "llrrlr"),
        reserve(smallest)
    )
}

/// Whether each region has a stress above round-off.
fn stressed_groups(section: &Section, recovery: &Recovery) -> Vec<bool> {
    let mut found = vec![false; section.mesh.groups.len()];
    for point in &recovery.points {
        let group = section.mesh.cells[point.cell].group;
        found[group] |= point.tensors.stress.amax() > ZERO * recovery.stress_scale;
    }
    found
}

fn reserve(factor: f64) -> String {
    if factor.is_finite() {
        number(factor)
    } else {
        "none".to_owned()
    }
}
