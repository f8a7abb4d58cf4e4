//! Optional properties of sections: curvature, electrodes, thermal force, damping.

use nalgebra::{Matrix6, Vector3};
use shared_geom::section::{Damping, InitialCurvature, Piezo, SectionProperties};
use shared_geom::wrench::COMPONENTS;

use super::entries::{Entries, largest_force};
use super::{Part, prestress};

/// Compares the optional properties.
pub(super) fn compare(a: &SectionProperties, b: &SectionProperties, entries: &mut Entries) {
    curvature(a, b, entries);
    if let Some((first, second)) = entries.both("electrodes", a.piezo.as_ref(), b.piezo.as_ref()) {
        piezo(a, first, second, entries);
    }
    let thermal = entries.both("a thermal force", a.thermal_force, b.thermal_force);
    if let Some((first, second)) = thermal {
        let columns = [first.as_slice(), second.as_slice()];
        forces(
            a,
            columns,
            Part::Thermal,
            "thermal force",
            ["N/K", "N m/K"],
            entries,
        );
    }
    imposed(a, b, entries);
    prestress::compare(a, b, entries);
    let dampings = (damping(a), damping(b));
    if dampings != (None, None) {
        let matrix = |damping: Option<Matrix6<f64>>| damping.unwrap_or_else(Matrix6::zeros);
        entries.matrix(Part::Damping, &matrix(dampings.0), &matrix(dampings.1));
    }
}

/// Compares the restrained forces of states of one name; the free strains follow from them.
fn imposed(a: &SectionProperties, b: &SectionProperties, entries: &mut Entries) {
    for first in &a.imposed {
        let second = b.imposed.iter().find(|state| state.name == first.name);
        let what = format!("the imposed state {}", first.name);
        if let Some((first, second)) = entries.both(&what, Some(first), second) {
            let name = format!("imposed {}", first.name);
            let columns = [&first.restrained_force, &second.restrained_force];
            let columns = columns.map(|force| force.as_slice());
            forces(a, columns, Part::Thermal, &name, ["N", "N m"], entries);
        }
    }
    for second in &b.imposed {
        if !a.imposed.iter().any(|state| state.name == second.name) {
            let words = format!("only B has the imposed state {}", second.name);
            entries.unlike.push(words);
        }
    }
}

/// Compares curvatures relative to one over the length, and slopes; a beam without them is
/// straight.
fn curvature(a: &SectionProperties, b: &SectionProperties, entries: &mut Entries) {
    if a.initial_curvature.is_none() && b.initial_curvature.is_none() {
        return;
    }
    let straight = InitialCurvature {
        curvature: Vector3::zeros(),
        slope: Vector3::x(),
    };
    let [a, b] = [a, b].map(|section| section.initial_curvature.unwrap_or(straight));
    for axis in 0..3 {
        let letter = ["x", "y", "z"][axis];
        let curvatures = [a.curvature[axis], b.curvature[axis]];
        let scale = entries.length.recip();
        let name = format!("curvature {letter}");
        entries.add(Part::Curvature, name, curvatures, "1/m", scale);
        let slopes = [a.slope[axis], b.slope[axis]];
        entries.add(Part::Curvature, format!("slope {letter}"), slopes, "", 1.0);
    }
}

/// Compares columns of forces, and capacitances relative to `sqrt(c_ii c_jj)`.
fn piezo(section: &SectionProperties, a: &Piezo, b: &Piezo, entries: &mut Entries) {
    if a.electrodes != b.electrodes {
        let names = |piezo: &Piezo| piezo.electrodes.join(", ");
        let (first, second) = (names(a), names(b));
        let words = format!("the electrodes of A are {first}, the electrodes of B {second}");
        return entries.unlike.push(words);
    }
    for (i, electrode) in a.electrodes.iter().enumerate() {
        let columns = [&a.coupling, &b.coupling].map(|coupling| coupling.column(i).into_owned());
        let columns = [columns[0].as_slice(), columns[1].as_slice()];
        let name = format!("electrode {electrode}");
        forces(
            section,
            columns,
            Part::Piezo,
            &name,
            ["N/V", "N m/V"],
            entries,
        );
        for (j, other) in a.electrodes.iter().enumerate().skip(i) {
            let capacitances = [a.capacitance[(i, j)], b.capacitance[(i, j)]];
            let scale = (a.capacitance[(i, i)] * a.capacitance[(j, j)]).abs().sqrt();
            let name = format!("capacitance {electrode}-{other}");
            entries.add(Part::Piezo, name, capacitances, "F/m", scale);
        }
    }
}

/// Compares six forces relative to the largest of A, each in terms of the stiffness.
///
/// ```text
/// (b - a)_i / (sqrt(K_ii) max_j |a_j| / sqrt(K_jj))
/// ```
fn forces(
    section: &SectionProperties,
    [a, b]: [&[f64]; 2],
    part: Part,
    name: &str,
    units: [&'static str; 2],
    entries: &mut Entries,
) {
    let root = section.stiffness.diagonal().map(f64::sqrt);
    let scale = match largest_force(&root, a) {
        0.0 => largest_force(&root, b),
        positive => positive,
    };
    for i in 0..6 {
        let name = format!("{name}, {}", COMPONENTS[i]);
        let unit = units[usize::from(i > 2)];
        entries.add(part, name, [a[i], b[i]], unit, scale * root[i]);
    }
}

/// The damping matrix, for either form of input.
fn damping(section: &SectionProperties) -> Option<Matrix6<f64>> {
    Some(match section.damping? {
        Damping::StiffnessProportional(time) => time * section.stiffness,
        Damping::Viscous(matrix) => matrix,
    })
}
