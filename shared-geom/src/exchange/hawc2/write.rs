//! Writes a blade as an htc file with a main body, the fully populated st file that it
//! names, and a classic st file.

use std::fmt::Write as _;
use std::path::PathBuf;

use super::lost::{lost, matrices};
use super::section::{Classic, Inertia, PrincipalAxes};
use super::st;
use crate::blade::{Blade, BladeDamping, Station};
use crate::exchange::Writing;
use crate::exchange::frame::Convention;
use crate::exchange::header::Header;
use crate::exchange::plain::{Plain, course_name};
use crate::exchange::text::{digits, upper};

/// Young's modulus of the classic rows, which have E and areas as separate columns [Pa].
/// Only the products matter.
const MODULUS: f64 = 1e10;

/// Shear modulus of the classic rows [Pa].
const SHEAR_MODULUS: f64 = MODULUS / 2.6;

/// The blade as files of HAWC2.
pub(in crate::exchange) fn write(blade: &Blade, name: &str) -> Writing {
    let plain = Plain::of(blade);
    let full = format!("{name}_st.dat");
    let classic = format!("{name}_classic_st.dat");
    Writing {
        files: vec![
            (
                PathBuf::from(format!("{name}.htc")),
                htc(blade, &plain, &full, &classic),
            ),
            (
                PathBuf::from(full),
                st_file(blade, &plain, &st::FULL, |station| {
                    full_row(station).to_vec()
                }),
            ),
            (
                PathBuf::from(classic),
                st_file(blade, &plain, &st::CLASSIC, |station| {
                    classic_row(station).to_vec()
                }),
            ),
        ],
        lost: lost(blade, &plain),
    }
}

fn htc(blade: &Blade, plain: &Plain, full: &str, classic: &str) -> String {
    let header = Header::new(blade, Convention::Hawc2, "the line of c2_def");
    let mut text = header.lines("; ");
    let _ = writeln!(
        text,
        "; course: {} (of c2_def between its points)",
        course_name(plain.course)
    );
    let _ = writeln!(text, "; twist: positive about +z, nose up");
    let _ = writeln!(
        text,
        "; properties also, without their couplings, in {classic} (no FPM)"
    );
    text += "begin new_htc_structure;\n  begin main_body;\n    name blade1 ;\n";
    text += "    type timoschenko ;\n    nbodies 1 ;\n    node_distribution c2_def ;\n";
    let damping = damping(blade).map(|factor| format!("{factor:.16e}"));
    let _ = writeln!(text, "    damping_posdef {} ;", damping.join(" "));
    let _ = writeln!(
        text,
        "    begin timoschenko_input ;\n      filename ./{full} ;\n      FPM 1 ;\n      set 1 1 ;\n    \
         end timoschenko_input ;"
    );
    let _ = writeln!(
        text,
        "    begin c2_def ;\n      nsec {} ;",
        plain.points.len()
    );
    let axes = Convention::Hawc2.axes();
    for (i, point) in plain.points.iter().enumerate() {
        let principal = axes.tr_mul(&point.position);
        let numbers = [
            principal.x,
            principal.y,
            principal.z,
            point.twist.to_degrees(),
        ]
        .map(digits);
        let _ = writeln!(text, "      sec {} {} ;", i + 1, numbers.join(" "));
    }
    text += "    end c2_def ;\n  end main_body ;\nend new_htc_structure ;\n";
    text
}

/// Factors of the mass, which are zero, and of the stiffness [s].
fn damping(blade: &Blade) -> [f64; 6] {
    let ours = match blade.damping {
        Some(BladeDamping::Proportional(time)) => [time; 6],
        Some(BladeDamping::Times(times)) => times,
        _ => [0.0; 6],
    };
    let [_, _, _, x, y, z] = Convention::Hawc2.values_from_ours(&ours);
    // In the order of deflections along x and y, see the reader.
    [0.0, 0.0, 0.0, y, x, z]
}

fn st_file(
    blade: &Blade,
    plain: &Plain,
    columns: &[&str],
    row: impl Fn(&Station) -> Vec<f64>,
) -> String {
    let point = "the elastic center (x_e, y_e) of each row, in the principal axes of bending \
                 turned by pitch about +z";
    let header = Header::new(blade, Convention::Hawc2, point);
    let mut text = String::from("1 number of sets, Nset\n");
    let _ = writeln!(text, "-----------------\n#1 {}", blade.name);
    // A mark in a comment would start a set.
    text += &header.lines("; ").replace(['#', '$'], " ");
    let title = |column: &&str| format!("{column:>24}");
    let titles: Vec<_> = columns.iter().map(title).collect();
    let _ = writeln!(text, "{}\n$1 {}", titles.join(" "), plain.stations.len());
    for station in &plain.stations {
        let numbers: Vec<_> = row(station).into_iter().map(digits).collect();
        let _ = writeln!(text, "{}", numbers.join(" "));
    }
    text
}

/// The row of 30 columns.
fn full_row(station: &Station) -> [f64; 30] {
    let (k, m) = matrices(station);
    let axes = PrincipalAxes::of(&k);
    let inertia = Inertia::of(&m, axes);
    let mut row = [0.0; 30];
    row[..6].copy_from_slice(&mass_columns(station, &inertia));
    row[6..9].copy_from_slice(&position_columns(axes));
    row[9..].copy_from_slice(&upper(&axes.into_principal(&k)));
    row
}

/// The row of 19 columns.
fn classic_row(station: &Station) -> [f64; 19] {
    let (k, m) = matrices(station);
    let axes = PrincipalAxes::of(&k);
    let inertia = Inertia::of(&m, axes);
    let classic = Classic::of(&k, axes);
    let area = classic.axial / MODULUS;
    let mut row = [0.0; 19];
    row[..6].copy_from_slice(&mass_columns(station, &inertia));
    row[6..16].copy_from_slice(&[
        classic.shear_center.x,
        classic.shear_center.y,
        MODULUS,
        SHEAR_MODULUS,
        classic.bending.x / MODULUS,
        classic.bending.y / MODULUS,
        classic.torsion / SHEAR_MODULUS,
        classic.shear.x / (SHEAR_MODULUS * area),
        classic.shear.y / (SHEAR_MODULUS * area),
        area,
    ]);
    row[16..].copy_from_slice(&position_columns(axes));
    row
}

fn mass_columns(station: &Station, inertia: &Inertia) -> [f64; 6] {
    let (center, radii) = (inertia.center, inertia.radii);
    [
        station.arc_length,
        inertia.mass,
        center.x,
        center.y,
        radii.x,
        radii.y,
    ]
}

fn position_columns(axes: PrincipalAxes) -> [f64; 3] {
    [axes.pitch.to_degrees(), axes.elastic.x, axes.elastic.y]
}
