//! Writes a blade as a windIO file.

use std::fmt::Write as _;
use std::path::PathBuf;

use nalgebra::{Matrix6, Vector2};

use super::super::Writing;
use super::super::frame::Convention;
use super::super::header::Header;
use super::super::plain::{Plain, course_name};
use super::super::text::upper;
use super::mass;
use crate::blade::{Blade, BladeDamping};

/// Relative difference, to the greatest entry of the block, below which mass entries are
/// equal.
const EQUAL: f64 = 1e-12;

/// A file of version 1.
pub(super) fn version_1(blade: &Blade, name: &str) -> Writing {
    let plain = Plain::of(blade);
    let mut lost = plain.lost.clone();
    if blade.damping.is_some() {
        lost.push(format!(
            "internal damping ({}): windIO version 1 has no field for it",
            damping_in_words(blade)
        ));
    }
    let mut text = head(blade, &plain, name);
    text += "components:\n    blade:\n        elastic_properties_mb:\n            six_x_six:\n";
    let margin = " ".repeat(16);
    text += &axis(&plain, &margin);
    text += &column("twist", &margin, &plain.point_parts, &twist(&plain));
    let grid = plain.station_parts();
    for (key, matrices) in [
        (
            "stiff_matrix",
            matrices(&plain, |station| station.stiffness),
        ),
        ("inertia_matrix", matrices(&plain, |station| station.mass)),
    ] {
        let _ = writeln!(text, "{margin}{key}:\n{margin}    grid: {}", list(&grid));
        let _ = writeln!(text, "{margin}    values:");
        for matrix in &matrices {
            let _ = writeln!(text, "{margin}    - {}", list(&upper(matrix)));
        }
    }
    finish(name, text, lost)
}

/// A file of version 2.
pub(super) fn version_2(blade: &Blade, name: &str) -> Writing {
    let plain = Plain::of(blade);
    let mut lost = plain.lost.clone();
    let mut text = head(blade, &plain, name) + "windIO_version: '2.0'\n";
    text += "components:\n    blade:\n";
    text += &axis(&plain, &" ".repeat(8));
    text += "        outer_shape:\n";
    let twist: Vec<_> = twist(&plain).into_iter().map(f64::to_degrees).collect();
    text += &column("twist", &" ".repeat(12), &plain.point_parts, &twist);
    text += "        structure:\n            elastic_properties:\n";
    let margin = " ".repeat(16);
    let grid = plain.station_parts();
    let stiffness = matrices(&plain, |station| station.stiffness);
    let _ = writeln!(
        text,
        "{margin}stiffness_matrix:\n{margin}    grid: {}",
        list(&grid)
    );
    for i in 0..6 {
        for j in i..6 {
            let values: Vec<_> = stiffness.iter().map(|k| k[(i, j)]).collect();
            let _ = writeln!(text, "{margin}    K{}{}: {}", i + 1, j + 1, list(&values));
        }
    }
    let inertia = matrices(&plain, |station| station.mass);
    let _ = writeln!(
        text,
        "{margin}inertia_matrix:\n{margin}    grid: {}",
        list(&grid)
    );
    let seven: Vec<_> = inertia.iter().map(mass::values).collect();
    for (i, key) in mass::NAMES.iter().enumerate() {
        let values: Vec<_> = seven.iter().map(|seven| seven[i]).collect();
        let _ = writeln!(text, "{margin}    {key}: {}", list(&values));
    }
    let _ = writeln!(
        text,
        "{margin}structural_damping:\n{margin}    mu: {}",
        list(&times(blade).unwrap_or_default())
    );
    if blade.damping.is_some() && times(blade).is_none() {
        lost.push(
            "internal damping by matrices: windIO has one time for each component".to_owned(),
        );
    }
    lost.extend(lost_mass(&inertia, &grid));
    finish(name, text, lost)
}

fn finish(name: &str, text: String, lost: Vec<String>) -> Writing {
    Writing {
        files: vec![(PathBuf::from(format!("{name}.yaml")), text)],
        lost,
    }
}

fn head(blade: &Blade, plain: &Plain, name: &str) -> String {
    let header = Header::new(blade, Convention::BeamDyn, "the reference axis");
    let twist = "twist: positive nose down, about -z of the root axes";
    let course = course_name(plain.course);
    format!(
        "{}# {twist}\n# course: {course} (of the reference axis between its points)\nname: {}\n",
        header.lines("# "),
        quoted(name)
    )
}

/// A text that every reader reads as text.
fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\'', "''"))
}

/// The twist of windIO, nose down [rad].
fn twist(plain: &Plain) -> Vec<f64> {
    let twists = plain.points.iter().zip(&plain.turns);
    twists.map(|(point, turn)| turn - point.twist).collect()
}

fn axis(plain: &Plain, margin: &str) -> String {
    let axes = Convention::BeamDyn.axes();
    let points: Vec<_> = plain
        .points
        .iter()
        .map(|point| axes.tr_mul(&point.position))
        .collect();
    let mut text = format!("{margin}reference_axis:\n");
    let margin = format!("{margin}    ");
    for (i, key) in ["x", "y", "z"].into_iter().enumerate() {
        let values: Vec<_> = points.iter().map(|point| point[i]).collect();
        text += &column(key, &margin, &plain.point_parts, &values);
    }
    text
}

fn column(key: &str, margin: &str, grid: &[f64], values: &[f64]) -> String {
    format!(
        "{margin}{key}:\n{margin}    grid: {}\n{margin}    values: {}\n",
        list(grid),
        list(values)
    )
}

fn matrices(
    plain: &Plain,
    which: impl Fn(&crate::blade::Station) -> Matrix6<f64>,
) -> Vec<Matrix6<f64>> {
    let matrix = |station| Convention::BeamDyn.from_ours(&which(station));
    plain.stations.iter().map(matrix).collect()
}

fn list(values: &[f64]) -> String {
    let numbers: Vec<_> = values.iter().map(|&value| number(value)).collect();
    format!("[{}]", numbers.join(", "))
}

/// A number with 17 digits and a signed exponent, which YAML 1.1 needs to see a number.
fn number(value: f64) -> String {
    // no negative zero, which results from changes of axes
    let text = format!("{:.16e}", value + 0.0);
    match text.split_once('e') {
        Some((digits, exponent)) if !exponent.starts_with('-') => format!("{digits}e+{exponent}"),
        _ => text,
    }
}

/// Damping times in the order of BeamDyn [s]; `None` for damping by matrices.
fn times(blade: &Blade) -> Option<[f64; 6]> {
    let ours = match blade.damping {
        None => [0.0; 6],
        Some(BladeDamping::Proportional(time)) => [time; 6],
        Some(BladeDamping::Times(times)) if blade.reference_point == Vector2::zeros() => times,
        Some(_) => return None,
    };
    Some(Convention::BeamDyn.values_from_ours(&ours))
}

fn damping_in_words(blade: &Blade) -> String {
    match &blade.damping {
        Some(BladeDamping::Proportional(time)) => format!("{time} s times K"),
        Some(BladeDamping::Times(times)) => format!("times {times:?} s"),
        _ => "matrices".to_owned(),
    }
}

/// The entries of the mass matrices that the seven numbers omit.
fn lost_mass(inertia: &[Matrix6<f64>], grid: &[f64]) -> Option<String> {
    let off = inertia.iter().zip(grid).map(|(matrix, &place)| {
        let left = matrix - mass::matrix(mass::values(matrix));
        // Entries of the three blocks have different units.
        let part = |rows: usize, columns: usize| {
            let greatest = matrix.fixed_view::<3, 3>(rows, columns).amax();
            let left = left.fixed_view::<3, 3>(rows, columns).amax();
            if left > 0.0 { left / greatest } else { 0.0 }
        };
        (part(0, 0).max(part(0, 3)).max(part(3, 3)), place)
    });
    let (part, place) = off.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (part > EQUAL).then(|| {
        format!(
            "mass entries beyond m, center of mass and moments of inertia: up to {part:.1e} of the \
             greatest of their block, at {place:.3} of the length"
        )
    })
}
