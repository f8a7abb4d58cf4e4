//! Writes a blade as a windIO file.

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

/// Remark on the parts that the schema requires and that a blade does not have, in lines.
pub const PART: [&str; 2] = [
    "a blade only: the schema of windIO also requires assembly, airfoils, chord, rthick,",
    "section_offset_y, anchors and layers; beam-dynamics convert --into FILE writes into a complete file",
];

/// A file of version 1.
pub(super) fn version_1(blade: &Blade, name: &str) -> Writing {
    let plain = Plain::of(blade);
    let mut lost = plain.lost.clone();
    lost.extend(lost_damping(blade));
    let mut text = head(blade, &plain, name);
    text += "components:\n    blade:\n        elastic_properties_mb:\n            six_x_six:\n";
    text += &joined(&six_by_six(&plain, &" ".repeat(16)));
    finish(name, text, lost)
}

/// The internal damping, which version 1 does not have.
pub(super) fn lost_damping(blade: &Blade) -> Option<String> {
    blade.damping.as_ref()?;
    Some(format!(
        "internal damping ({}): windIO version 1 has no field for it",
        damping_in_words(blade)
    ))
}

/// Lines of the table of version 1: axis, twist and matrices.
pub(super) fn six_by_six(plain: &Plain, margin: &str) -> Vec<String> {
    let deeper = format!("{margin}    ");
    let mut lines = vec![format!("{margin}reference_axis:")];
    lines.extend(axis_columns(plain, &deeper));
    lines.push(format!("{margin}twist:"));
    lines.extend(grid_and_values(&deeper, &plain.point_parts, &twist(plain)));
    let grid = plain.station_parts();
    for (key, matrices) in [
        ("stiff_matrix", matrices(plain, |station| station.stiffness)),
        ("inertia_matrix", matrices(plain, |station| station.mass)),
    ] {
        lines.push(format!("{margin}{key}:"));
        lines.push(format!("{deeper}grid: {}", list(&grid)));
        lines.push(format!("{deeper}values:"));
        let rows = matrices.iter().map(|matrix| list(&upper(matrix)));
        lines.extend(rows.map(|row| format!("{deeper}- {row}")));
    }
    lines
}

/// A file of version 2.
pub(super) fn version_2(blade: &Blade, name: &str) -> Writing {
    let plain = Plain::of(blade);
    let mut lost = plain.lost.clone();
    let comment = PART.map(|line| format!("# {line}\n")).concat();
    let mut text = head(blade, &plain, name) + &comment + "windIO_version: '2.0'\n";
    text += "components:\n    blade:\n        reference_axis:\n";
    text += &joined(&axis_columns(&plain, &" ".repeat(12)));
    text += "        outer_shape:\n            twist:\n";
    text += &joined(&twist_columns(&plain, &" ".repeat(16)));
    text += "        structure:\n            elastic_properties:\n";
    let margin = " ".repeat(16);
    for (key, lines) in elastic_tables(blade, &plain, &mut lost) {
        let lines = indented(&lines, &format!("{margin}    "));
        text += &format!("{margin}{key}:\n{}", joined(&lines));
    }
    finish(name, text, lost)
}

/// Lines of the twist of version 2 [deg].
pub(super) fn twist_columns(plain: &Plain, margin: &str) -> Vec<String> {
    let twist: Vec<_> = twist(plain).into_iter().map(f64::to_degrees).collect();
    grid_and_values(margin, &plain.point_parts, &twist)
}

/// Names and lines of the tables of stiffness, mass and damping of version 2; adds the
/// losses.
pub(super) fn elastic_tables(
    blade: &Blade,
    plain: &Plain,
    lost: &mut Vec<String>,
) -> [(&'static str, Vec<String>); 3] {
    let grid = plain.station_parts();
    let stiffness = matrices(plain, |station| station.stiffness);
    let pairs = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
    let entry = |(i, j): (usize, usize)| {
        let values: Vec<_> = stiffness.iter().map(|k| k[(i, j)]).collect();
        format!("K{}{}: {}", i + 1, j + 1, list(&values))
    };
    let mut of_stiffness = vec![format!("grid: {}", list(&grid))];
    of_stiffness.extend(pairs.map(entry));
    let inertia = matrices(plain, |station| station.mass);
    let seven: Vec<_> = inertia.iter().map(mass::values).collect();
    let mut of_inertia = vec![format!("grid: {}", list(&grid))];
    of_inertia.extend(mass::NAMES.iter().enumerate().map(|(i, key)| {
        let values: Vec<_> = seven.iter().map(|seven| seven[i]).collect();
        format!("{key}: {}", list(&values))
    }));
    let of_damping = vec![format!("mu: {}", list(&times(blade).unwrap_or_default()))];
    if blade.damping.is_some() && times(blade).is_none() {
        lost.push(
            "internal damping by matrices: windIO has one time for each component".to_owned(),
        );
    }
    lost.extend(lost_mass(&inertia, &grid));
    [
        ("inertia_matrix", of_inertia),
        ("stiffness_matrix", of_stiffness),
        ("structural_damping", of_damping),
    ]
}

/// The lines with a margin.
pub(super) fn indented(lines: &[String], margin: &str) -> Vec<String> {
    lines.iter().map(|line| format!("{margin}{line}")).collect()
}

/// The lines as a text.
fn joined(lines: &[String]) -> String {
    lines.iter().map(|line| format!("{line}\n")).collect()
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

/// Lines of the columns x, y, z of the reference axis [m].
pub(super) fn axis_columns(plain: &Plain, margin: &str) -> Vec<String> {
    let axes = Convention::BeamDyn.axes();
    let points: Vec<_> = plain
        .points
        .iter()
        .map(|point| axes.tr_mul(&point.position))
        .collect();
    let columns = ["x", "y", "z"].into_iter().enumerate();
    let columns = columns.flat_map(|(i, key)| {
        let values: Vec<_> = points.iter().map(|point| point[i]).collect();
        let deeper = format!("{margin}    ");
        let head = [format!("{margin}{key}:")].into_iter();
        head.chain(grid_and_values(&deeper, &plain.point_parts, &values))
            .collect::<Vec<_>>()
    });
    columns.collect()
}

/// The two lines of a column.
fn grid_and_values(margin: &str, grid: &[f64], values: &[f64]) -> Vec<String> {
    vec![
        format!("{margin}grid: {}", list(grid)),
        format!("{margin}values: {}", list(values)),
    ]
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
    let off = inertia.iter().zip(grid).map(|(matrix, &position)| {
        let left = matrix - mass::matrix(mass::values(matrix));
        // Entries of the three blocks have different units.
        let part = |rows: usize, columns: usize| {
            let greatest = matrix.fixed_view::<3, 3>(rows, columns).amax();
            let left = left.fixed_view::<3, 3>(rows, columns).amax();
            if left > 0.0 { left / greatest } else { 0.0 }
        };
        (part(0, 0).max(part(0, 3)).max(part(3, 3)), position)
    });
    let (part, position) = off.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (part > EQUAL).then(|| {
        format!(
            "mass entries beyond m, center of mass and moments of inertia: up to {part:.1e} of the \
             greatest of their block, at {position:.3} of the length"
        )
    })
}
