//! The effect of the internal forces on the stiffness, in a report.

use nalgebra::{Matrix4, Matrix6, Vector6};
use shared_geom::section::{
    PRESTRESS_COMPONENTS, Prestress, SectionProperties, least_eigenvalue, prestress_part,
};
use shared_geom::wrench::COMPONENTS;

use super::text::{matrix, number, table};
use crate::properties::radius_of_gyration;
use crate::recovery::LoadCase;

/// Entries below this fraction of their reference size are left out: round-off of the
/// solution.
const ZERO: f64 = 1e-10;

/// The table of third derivatives of a section and its results: the change of the stiffness
/// with axial force and moments, by temperature and imposed states, and the stiffness under
/// each load. Each load is given with a flag: whether it has forces along the beam. Empty
/// without a table.
pub fn prestress_report(properties: &SectionProperties, loads: &[(&LoadCase, bool)]) -> String {
    let Some(prestress) = &properties.prestress else {
        return String::new();
    };
    let measure = prestress.strain_measure.name();
    let mut text = format!(
        "Prestress, third derivatives T of the energy by strain ({measure} strain)\n\
         {}  (1 axial, 4 torsion, 5 bending y, 6 bending z; all others are zero)\n",
        entries(properties, prestress),
    );
    if let Some(compliance) = properties.stiffness.try_inverse() {
        let by_axial = prestress.by_force(&compliance, 0);
        text += &format!(
            "\nPrestress, change of the stiffness per axial force at the reference point [-, m, m^2]\n{}",
            of_four(&by_axial, properties)
        );
        let at_center = at_tension_center(properties);
        let change = prestress.at_strain(&(compliance * at_center))[(3, 3)];
        let square = radius_of_gyration(properties).powi(2);
        text += &format!(
            "  (per axial force at the tension center torsion gains {} m^2, {:.4} of \
             (EIy + EIz)/EA)\n",
            number(change),
            change / square
        );
        text += &by_moments(prestress, &compliance, properties);
    }
    let per_kelvin = prestress.per_kelvin.iter();
    let per_kelvin = per_kelvin.map(|change| ("per kelvin".to_owned(), change));
    let states = properties.imposed.iter().filter_map(|state| {
        let change = state.stiffness_change.as_ref()?;
        Some((format!("by the imposed state \"{}\"", state.name), change))
    });
    for (words, change) in per_kelvin.chain(states) {
        text += &format!(
            "\nPrestress, change of the stiffness {words}, without internal force [N, N m, N m^2]\n{}",
            change_of_free(change, properties)
        );
    }
    for (load, is_along) in loads {
        text += &format!("\n{}", under_load(properties, load, *is_along));
    }
    text
}

/// A unit axial force at the tension center, about the reference point.
fn at_tension_center(properties: &SectionProperties) -> Vector6<f64> {
    let center = properties.centers.tension;
    Vector6::new(1.0, 0.0, 0.0, 0.0, center.y, -center.x)
}

/// The change of the stiffness with each moment; round-off compared with
/// `sqrt(Kii Kjj/(K11 Kkk))` is shown as zero.
fn by_moments(
    prestress: &Prestress,
    compliance: &Matrix6<f64>,
    properties: &SectionProperties,
) -> String {
    let root = properties.stiffness.diagonal().map(f64::sqrt);
    let mut text = String::new();
    for (k, moment) in PRESTRESS_COMPONENTS.into_iter().enumerate().skip(1) {
        let mut change = prestress.by_force(compliance, k);
        for (i, first) in PRESTRESS_COMPONENTS.into_iter().enumerate() {
            for (j, second) in PRESTRESS_COMPONENTS.into_iter().enumerate() {
                let scale = root[first] * root[second] / (root[0] * root[moment]);
                if change[(i, j)].abs() <= ZERO * scale {
                    change[(i, j)] = 0.0;
                }
            }
        }
        text += &format!(
            "\nPrestress, change of the stiffness per moment of {} [1/m, -, m]\n{}",
            COMPONENTS[moment],
            of_four(&change, properties)
        );
    }
    text
}

/// The entries above round-off, a line each.
fn entries(properties: &SectionProperties, prestress: &Prestress) -> String {
    let root = properties.stiffness.diagonal().map(f64::sqrt);
    let mut rows = Vec::new();
    for (at, value) in prestress.third.entries() {
        let [i, j, k] = at.map(|index| PRESTRESS_COMPONENTS[index]);
        let scale = root[i] * root[j] * root[k] / root[0];
        if value.abs() > ZERO * scale {
            let lengths = [i, j, k].iter().filter(|component| **component > 2).count();
            rows.push(vec![
                format!("T{}{}{}", i + 1, j + 1, k + 1),
                number(value),
                ["N", "N m", "N m^2", "N m^3"][lengths].to_owned(),
                [i, j, k].map(|component| COMPONENTS[component]).join(", "),
            ]);
        }
    }
    table(&rows, "lrll")
}

/// A 4x4 matrix under the names of its components; round-off compared with
/// `sqrt(Kii Kjj)/K11` is shown as zero.
fn of_four(a: &Matrix4<f64>, properties: &SectionProperties) -> String {
    four(a, properties, 1.0 / properties.stiffness[(0, 0)])
}

/// As [`of_four`], for a change by an imposed state; round-off compared with its largest
/// entry, relative to `sqrt(Kii Kjj)`, is shown as zero.
fn change_of_free(change: &Matrix4<f64>, properties: &SectionProperties) -> String {
    let root = properties.stiffness.diagonal().map(f64::sqrt);
    let root = prestress_part(&root);
    let largest = change.component_div(&(root * root.transpose())).amax();
    four(change, properties, largest)
}

fn four(a: &Matrix4<f64>, properties: &SectionProperties, unit: f64) -> String {
    let names = PRESTRESS_COMPONENTS.map(|component| COMPONENTS[component]);
    let root = properties.stiffness.diagonal().map(f64::sqrt);
    let heading = std::iter::once("").chain(names).map(str::to_owned);
    let mut rows = vec![heading.collect::<Vec<_>>()];
    for (i, name) in names.into_iter().enumerate() {
        let mut row = vec![name.to_owned()];
        for j in 0..4 {
            let [first, second] = [i, j].map(|index| root[PRESTRESS_COMPONENTS[index]]);
            let scale = first * second * unit;
            let is_zero = a[(i, j)].abs() <= ZERO * scale;
            row.push(number(if is_zero { 0.0 } else { a[(i, j)] }));
        }
        rows.push(row);
    }
    table(&rows, "lr")
}

/// The stiffness under a load and its imposed states; a remark if it is not positive
/// definite.
fn under_load(properties: &SectionProperties, load: &LoadCase, is_along: bool) -> String {
    let Some(stiffness) = properties.stiffness_at(&load.force) else {
        return String::new();
    };
    let by_imposed = properties.change_by_imposed(&load.imposed);
    let stiffness = stiffness + by_imposed.unwrap_or_else(Matrix6::zeros);
    let names = load.imposed.iter().map(|name| format!("\"{name}\""));
    let names = names.collect::<Vec<_>>().join(", ");
    let of_imposed = match by_imposed {
        _ if names.is_empty() => String::new(),
        Some(_) => format!("  (with the effect of {names} on the section)\n"),
        None => format!("  (without the stresses of {names}, which are unknown)\n"),
    };
    let of_forces_along = if is_along {
        "  (of the load along the beam only the internal force is included: the stresses that \
             it adds within the section are ignored)\n"
    } else {
        ""
    };
    let least = least_eigenvalue(&stiffness);
    let remark = if least > 0.0 {
        ""
    } else {
        "  (not positive definite: at this load the section itself is unstable, or the \
             load is too large for the first order)\n"
    };
    format!(
        "Stiffness under load \"{}\", to first order [N, N m, N m^2]\n{}{of_imposed}\
         {of_forces_along}{remark}",
        load.name,
        matrix(&stiffness)
    )
}
