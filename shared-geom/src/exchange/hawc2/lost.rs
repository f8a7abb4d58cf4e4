//! Properties that the files of HAWC2 cannot carry, with their size.

use nalgebra::Matrix6;

use super::section::{Classic, Inertia, PrincipalAxes, difference};
use crate::blade::{Blade, BladeDamping, Station};
use crate::exchange::frame::Convention;
use crate::exchange::plain::Plain;

/// Smaller differences are round-off [-].
const EQUAL: f64 = 1e-12;

/// Smaller angles of the section axes are not reported [rad].
const LEVEL: f64 = 1e-6;

/// Lost properties of `blade`, as text.
pub(super) fn lost(blade: &Blade, plain: &Plain) -> Vec<String> {
    let mut lost = plain.lost.clone();
    lost.extend(mass(plain));
    lost.extend(between(plain));
    lost.extend(damping(blade));
    lost.extend(axes(plain));
    lost.extend(classic(plain));
    lost.push(
        "the chord: HAWC2's aerodynamics places the half chord on c2_def, which is the reference \
         line here"
            .to_owned(),
    );
    lost
}

/// A station in HAWC2's axes.
pub(super) fn matrices(station: &Station) -> (Matrix6<f64>, Matrix6<f64>) {
    let convention = Convention::Hawc2;
    (
        convention.from_ours(&station.stiffness),
        convention.from_ours(&station.mass),
    )
}

/// The greatest of `sizes` and its arc length, unless it is round-off.
fn greatest(sizes: impl Iterator<Item = (f64, f64)>) -> Option<(f64, f64)> {
    let greatest = sizes.max_by(|a, b| a.0.total_cmp(&b.0));
    greatest.filter(|(size, _)| *size > EQUAL)
}

fn mass(plain: &Plain) -> Option<String> {
    let sizes = plain.stations.iter().map(|station| {
        let (k, m) = matrices(station);
        let axes = PrincipalAxes::of(&k);
        let (back, _) = Inertia::of(&m, axes).matrix(axes);
        (difference(&back, &m), station.arc_length)
    });
    let (size, s) = greatest(sizes)?;
    Some(format!(
        "mass coupling beyond m, mass center and two radii of gyration (the product of inertia in \
         the principal axes of bending): up to {size:.2e} of the moments of inertia, at {s:.3} m"
    ))
}

fn classic(plain: &Plain) -> Option<String> {
    let sizes = plain.stations.iter().map(|station| {
        let (k, _) = matrices(station);
        let axes = PrincipalAxes::of(&k);
        let own = axes.into_principal(&k);
        let back = axes.into_principal(&Classic::of(&k, axes).matrix(axes));
        (difference(&back, &own), station.arc_length)
    });
    let (size, s) = greatest(sizes)?;
    Some(format!(
        "in the classic file alone, stiffness coupling beyond elastic and shear center: up to \
         {size:.2e} of the diagonal, at {s:.3} m"
    ))
}

/// Half way between the rows: linear columns against linear matrices.
fn between(plain: &Plain) -> Option<String> {
    let sizes = plain.stations.windows(2).map(|two| {
        let rows = [&two[0], &two[1]].map(|station| {
            let (k, _) = matrices(station);
            let axes = PrincipalAxes::of(&k);
            (axes, axes.into_principal(&k), k)
        });
        let [a, b] = rows;
        let axes = PrincipalAxes {
            elastic: 0.5 * (a.0.elastic + b.0.elastic),
            pitch: 0.5 * (a.0.pitch + b.0.pitch),
        };
        let expected = axes.into_principal(&(0.5 * (a.2 + b.2)));
        let size = difference(&(0.5 * (a.1 + b.1)), &expected);
        (size, 0.5 * (two[0].arc_length + two[1].arc_length))
    });
    let (size, s) = greatest(sizes)?;
    Some(format!(
        "the interpolation of the stiffness between the rows: HAWC2 interpolates each column linearly, \
         Helicoid the entries about the line; half way, the difference is up to {size:.2e} of \
         the diagonal, at {s:.3} m"
    ))
}

fn damping(blade: &Blade) -> Option<String> {
    let is_zero = match &blade.damping {
        None => true,
        Some(BladeDamping::Proportional(time)) => *time == 0.0,
        Some(BladeDamping::Times([axial, y, z, ..])) => [axial, y, z].iter().all(|t| **t == 0.0),
        Some(BladeDamping::Viscous(all)) => all.iter().flatten().all(|entry| *entry == 0.0),
    };
    if is_zero {
        return None;
    }
    Some(match &blade.damping {
        None => return None,
        Some(BladeDamping::Proportional(time)) => format!(
            "damping of axial force and shears ({time} s): damping_posdef has factors of bending \
             and torsion"
        ),
        Some(BladeDamping::Times([axial, y, z, ..])) => format!(
            "damping of axial force and shears ({axial}, {y}, {z} s): damping_posdef has factors \
             of bending and torsion"
        ),
        Some(BladeDamping::Viscous(_)) => {
            "damping by matrices: damping_posdef has factors of the stiffness".to_owned()
        }
    })
}

/// The meaning of twist if the line has both prebend and sweep.
fn axes(plain: &Plain) -> Option<String> {
    let turn = plain
        .turns
        .iter()
        .fold(0.0_f64, |most, turn| most.max(turn.abs()));
    (turn > LEVEL).then(|| {
        format!(
            "the axes of zero twist if the line has both prebend and sweep: tools differ, here by \
             up to {:.1e} deg; written for a chord level before twist",
            turn.to_degrees()
        )
    })
}
