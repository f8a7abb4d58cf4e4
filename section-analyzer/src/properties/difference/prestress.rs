//! Comparison of the changes of the stiffness by internal forces, heat and imposed states.

use nalgebra::{Matrix4, Vector6};
use shared_geom::section::{PRESTRESS_COMPONENTS, Prestress, SectionProperties};

use super::Part;
use super::entries::{Entries, largest_force};

/// Compares tables of prestress and changes of the stiffness; those by different strain
/// measures differ by the size of the stiffness, and are not compared.
pub(super) fn compare(a: &SectionProperties, b: &SectionProperties, entries: &mut Entries) {
    let tables = (a.prestress.as_ref(), b.prestress.as_ref());
    if let Some((first, second)) = entries.both("a table of prestress", tables.0, tables.1) {
        if first.strain_measure != second.strain_measure {
            let names = [first, second].map(|table| table.strain_measure.name());
            let words = format!(
                "the prestress of A uses the strain of {}, the prestress of B the strain of {}",
                names[0], names[1]
            );
            return entries.unlike.push(words);
        }
        table(a, first, second, entries);
        let change = |section: &SectionProperties, table: &Prestress| Change {
            matrix: table.per_kelvin,
            force: section.thermal_force,
        };
        let what = "a change of the stiffness per kelvin";
        let units = ["N/K", "N m/K", "N m^2/K"];
        let changes = [change(a, first), change(b, second)];
        changes_of_stiffness(a, changes, [what, "per kelvin"], units, entries);
    }
    for first in &a.imposed {
        // a state that only one of the two has is reported with its forces
        let second = b.imposed.iter().find(|state| state.name == first.name);
        let Some(second) = second else {
            continue;
        };
        let changes = [first, second].map(|state| Change {
            matrix: state.stiffness_change,
            force: Some(state.restrained_force),
        });
        let name = &first.name;
        let what = format!("a change of the stiffness by the imposed state {name}");
        let name = format!("imposed {name}");
        let units = ["N", "N m", "N m^2"];
        changes_of_stiffness(a, changes, [&what, &name], units, entries);
    }
}

/// Compares entries relative to their contribution to the stiffness at an axial strain of
/// one.
///
/// ```text
/// (b - a)_ijk / sqrt(K_ii K_jj K_kk / K_11)
/// ```
fn table(section: &SectionProperties, a: &Prestress, b: &Prestress, entries: &mut Entries) {
    let root = section.stiffness.diagonal().map(f64::sqrt);
    for (at, value) in a.third.entries() {
        let [i, j, k] = at.map(|index| PRESTRESS_COMPONENTS[index]);
        let name = format!("prestress {}{}{}", i + 1, j + 1, k + 1);
        let lengths = [i, j, k].iter().filter(|component| **component > 2).count();
        let unit = ["N", "N m", "N m^2", "N m^3"][lengths];
        let scale = root[i] * root[j] * root[k] / root[0];
        let values = [value, b.third.at(at)];
        entries.add(Part::Prestress, name, values, unit, scale);
    }
}

/// A change of the stiffness without internal force, and the restrained force of its cause:
/// 4x4 \[N, N m, N m^2\] and 6 components \[N, N m\], or both per kelvin.
struct Change {
    matrix: Option<Matrix4<f64>>,
    force: Option<Vector6<f64>>,
}

/// Compares changes of the stiffness relative to the larger of the free strain of their
/// cause, the relative change by expansion alone, and their largest entry.
///
/// ```text
/// (b - a)_ij / (sqrt(K_ii K_jj) e)
/// e = max over k, l of |f_k| / sqrt(K_kk K_11) and |a_kl| / sqrt(K_kk K_ll)
/// ```
///
/// If the section has no stress, both changes are round-off and differ; the strain is not
/// round-off.
fn changes_of_stiffness(
    section: &SectionProperties,
    [first, second]: [Change; 2],
    [what, name]: [&str; 2],
    units: [&'static str; 3],
    entries: &mut Entries,
) {
    let Some((a, b)) = entries.both(what, first.matrix, second.matrix) else {
        return;
    };
    let root = section.stiffness.diagonal().map(f64::sqrt);
    let of = PRESTRESS_COMPONENTS;
    let weight = Matrix4::from_fn(|i, j| root[of[i]] * root[of[j]]);
    let size = |change: &Matrix4<f64>, force: Option<Vector6<f64>>| {
        let strain = force.map_or(0.0, |force| {
            largest_force(&root, force.as_slice()) / root[0]
        });
        change.component_div(&weight).amax().max(strain)
    };
    let scale = match size(&a, first.force) {
        0.0 => size(&b, second.force),
        positive => positive,
    };
    for i in 0..4 {
        for j in i..4 {
            let name = format!("{name}, stiffness {}{}", of[i] + 1, of[j] + 1);
            let unit = units[usize::from(i > 0) + usize::from(j > 0)];
            let values = [a[(i, j)], b[(i, j)]];
            let scale = scale * weight[(i, j)];
            entries.add(Part::Prestress, name, values, unit, scale);
        }
    }
}
