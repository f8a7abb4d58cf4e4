//! Blades of HAWC2: the st file with the properties, classic (19 columns) or fully
//! populated (30), and the main body of an htc file, which has the line (`c2_def`) and
//! names the st file.
//!
//! Axes: see [`Convention::Hawc2`]; twist and pitch positive about +z, nose up. The
//! reference points of the matrices of the rows: see [`section`]. HAWC2 interpolates each
//! column linearly between the distances `r` of the rows; a blade of Helicoid is linear
//! in the entries of the matrices about the line, which is the same at the rows and close
//! to it between them.
//!
//! # References
//! - Columns and their points of reference: documentation of the `wetb` package of DTU
//!   (0.1.33), which follows the user's manual of HAWC2; the sign of the pitch is settled
//!   by the tests of [`section`] and by two descriptions of the IEA-15.
//! - Radii of gyration about the elastic center: also the converter of BECAS.

use std::path::Path;

use nalgebra::{Vector2, Vector3};

use crate::blade::{Blade, BladeDamping, Interpolation, Station};
use crate::document::read_text;
use crate::error::Diagnostics;
use crate::line::{Course, LinePoint, ReferenceLine};

use super::frame::Convention;
use super::plain::{course_name, stated_course};
use super::problem::{ExchangeProblem, Problems};
use super::stations::{name_of, provenance};
use super::text::from_upper;
use super::{Options, Reading};

mod htc;
mod lost;
mod section;
mod st;
mod write;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test that cannot continue fails")]
mod htc_tests;
#[cfg(test)]
mod tests;

use htc::Body;
pub(super) use section::{Classic, Inertia, PrincipalAxes};
use st::{Row, SubSet};

pub(super) use write::write;

/// Part of the length by which the rows may end before or beyond the line and are
/// scaled to its length: files measure differently along a bent blade.
const STRETCH: f64 = 0.02;

/// A difference of lengths that rounded digits explain, as part of the length.
const DIGITS: f64 = 1e-9;

/// Whether `text` is an st file or an htc file with a body.
pub(super) fn recognize(text: &str) -> bool {
    htc::recognize(text) || st::recognize(text)
}

/// Reads an htc file with the st file that it names, or an st file alone as a straight
/// blade.
///
/// # Errors
/// All errors of the files.
pub(super) fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    if htc::recognize(text) {
        return read_body(text, file, options.body.as_deref());
    }
    let mut remarks = Vec::new();
    let mut problems = Problems::new(&file.display().to_string());
    let rows = chosen_rows(text, None, &mut remarks, &mut problems);
    let rows = problems.finish(rows)?;
    let length = rows.last().map_or(0.0, Row::distance);
    remarks.push(format!(
        "the line is straight, {length} m long, without twist: an st file has none; give the htc \
         file that names it"
    ));
    let line = ReferenceLine::straight(length);
    Ok(assemble(&rows, line, None, remarks, file, &[text]))
}

/// Whether `text` is an htc file, whose bodies have names.
pub(super) fn has_bodies(text: &str) -> bool {
    htc::recognize(text)
}

/// Reads the blade of an htc file, or the body called `wanted`; returns the problems of both files.
fn read_body(text: &str, file: &Path, wanted: Option<&str>) -> Result<Reading, Diagnostics> {
    let mut remarks = Vec::new();
    let mut problems = Problems::new(&file.display().to_string());
    let (body, mut texts) = htc::body(text, (file, wanted), &mut remarks, &mut problems);
    let companion = body.as_ref().and_then(|body| {
        let named = body.st_file.as_ref()?;
        let found = named.find();
        if found.is_none() {
            problems.turn_to(&named.by);
            problems.push(named.line, &named.missing("the st file of the body"));
        }
        found
    });
    let (body, path) = problems.finish(body.zip(companion))?;
    let st_text = read_text(&path)?;
    let mut problems = Problems::new(&path.display().to_string());
    let rows = chosen_rows(&st_text, Some(&body), &mut remarks, &mut problems);
    let rows = problems.finish(rows)?;
    if body.masses > 0 {
        let count = body.masses;
        remarks.push(format!(
            "{count} concentrated masses are not read: add them to the model"
        ));
    }
    let course = texts.iter().find_map(|text| stated_course(text));
    let line = line_of(&body, course, &mut remarks);
    texts.push(st_text);
    let texts: Vec<_> = texts.iter().map(String::as_str).collect();
    Ok(assemble(&rows, line, Some(&body), remarks, file, &texts))
}

/// The rows that the htc file selects, or the first rows of an st file alone.
fn chosen_rows(
    text: &str,
    body: Option<&Body>,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<Vec<Row>> {
    let all = st::sub_sets(text, problems);
    let wanted = body.and_then(|body| body.set);
    let chosen = match wanted {
        Some((set, number, _)) => all
            .iter()
            .find(|one| (one.set, one.number) == (set, number)),
        None => all.first(),
    };
    let names: Vec<_> = all.iter().map(SubSet::name).collect();
    let Some(chosen) = chosen else {
        problems.push(0, &no_set(wanted, &names));
        return None;
    };
    if wanted.is_none() && all.len() > 1 {
        let others: Vec<_> = names.iter().skip(1).map(String::as_str).collect();
        remarks.push(format!(
            "{} is read; not {}",
            chosen.name(),
            others.join("; ")
        ));
    }
    st::rows(chosen, body.map(|body| body.is_full), problems)
}

fn no_set(wanted: Option<(usize, usize, usize)>, names: &[String]) -> ExchangeProblem {
    let there = match names {
        [] => "none: the file may have been cut off".to_owned(),
        _ => names.join("; "),
    };
    match wanted {
        Some((set, number, line)) => ExchangeProblem::Other {
            what: "the properties of the blade".to_owned(),
            found: format!(
                "no set {set}, sub-set {number}, which line {line} of the htc file names"
            ),
            expected: format!("one of {there}"),
            help: "correct the line \"set\" of timoschenko_input".to_owned(),
        },
        None => ExchangeProblem::Missing {
            what: "a sub-set ($1 20, and 20 rows after it)".to_owned(),
            help: "the file may have been cut off".to_owned(),
        },
    }
}

/// The line of `c2_def`, in Helicoid's axes, with the stated interpolation.
fn line_of(body: &Body, course: Option<Course>, remarks: &mut Vec<String>) -> ReferenceLine {
    let axes = Convention::Hawc2.axes();
    let height = |point: Option<&[f64; 4]>| point.map_or(0.0, |point| point[2]);
    let is_downward = height(body.points.last()) < height(body.points.first());
    // About y of the body, by half a turn.
    let side = if is_downward { -1.0 } else { 1.0 };
    let point = |&[x, y, z, twist]: &[f64; 4]| LinePoint {
        position: axes * Vector3::new(side * x, y, side * z),
        twist: twist.to_radians(),
    };
    if is_downward {
        remarks.push(format!(
            "c2_def of \"{}\" goes along -z, as of towers: it is turned about its y by half a turn",
            body.name
        ));
    }
    let points: Vec<_> = body.points.iter().map(point).collect();
    let course = course.unwrap_or_else(|| {
        let grows = points
            .windows(2)
            .all(|two| two[1].position.x > two[0].position.x);
        let course = if grows {
            Course::Spline
        } else {
            Course::Polyline
        };
        remarks.push(format!(
            "the interpolation between the {} points of c2_def is not stated: a {}",
            points.len(),
            course_name(course)
        ));
        course
    });
    ReferenceLine::through(points, course)
}

/// The blade of rows along a line.
fn assemble(
    rows: &[Row],
    line: ReferenceLine,
    body: Option<&Body>,
    mut remarks: Vec<String>,
    file: &Path,
    texts: &[&str],
) -> Reading {
    let length = line.length();
    let end = rows.last().map_or(length, Row::distance);
    let stretch = stretch(end, length, &mut remarks);
    let mut too_small = Vec::new();
    let stations = rows.iter().map(|row| {
        let (mut station, small) = station(row);
        station.arc_length *= stretch;
        if small {
            too_small.push(row.distance());
        }
        station
    });
    let stations = cut(stations.collect(), length);
    if let Some(first) = too_small.first() {
        remarks.push(format!(
            "radii of gyration at {} of {} rows, the first at r = {first} m, are smaller than the \
             distance of the mass center from the elastic center, their reference in HAWC2: the \
             moment of inertia about the mass center is set to zero; the file may contain radii \
             about the mass center",
            too_small.len(),
            rows.len()
        ));
    }
    let blade = Blade {
        name: name_of(file),
        line,
        reference_point: Vector2::zeros(),
        stations,
        interpolation: Interpolation::Linear,
        damping: body.and_then(|body| damping(body, &mut remarks)),
        provenance: provenance("HAWC2", texts),
    };
    let other_damping = body.map_or(&[][..], |body| &body.other_damping);
    remarks.extend(
        other_damping
            .iter()
            .map(|statement| other_damping_remark(statement)),
    );
    Reading {
        has_other_damping: !other_damping.is_empty(),
        ..Reading::new(blade, remarks)
    }
}

/// Remark on a statement of damping that has no counterpart.
fn other_damping_remark(statement: &str) -> String {
    format!(
        "\"{statement}\" is not read: of HAWC2's damping only damping_posdef, factors of mass and \
         stiffness, is converted; give damping in [[blade]], or damping ratios in [modes]"
    )
}

/// Factor of the distances of the rows.
fn stretch(end: f64, length: f64, remarks: &mut Vec<String>) -> f64 {
    let off = end / length - 1.0;
    if off.abs() <= DIGITS || !off.is_finite() {
        return 1.0;
    }
    let what = format!("the rows end at r = {end:.4} m, the line c2_def at {length:.4} m");
    if off.abs() <= STRETCH {
        remarks.push(format!(
            "{what}: the distances of the rows are scaled to the length of the line"
        ));
        return length / end;
    }
    let held = if off > 0.0 {
        "rows beyond it are not used"
    } else {
        "the last row holds to the end of the line"
    };
    remarks.push(format!("{what}: {held}"));
    1.0
}

/// The stations up to the end of the line, with one at the end.
fn cut(mut stations: Vec<Station>, length: f64) -> Vec<Station> {
    let beyond = |station: &Station| station.arc_length > length * (1.0 + DIGITS);
    let Some(first) = stations.iter().position(beyond) else {
        return stations;
    };
    if let [.., a, b] = &mut stations[..=first] {
        let v = (length - a.arc_length) / (b.arc_length - a.arc_length);
        b.stiffness = a.stiffness * (1.0 - v) + b.stiffness * v;
        b.mass = a.mass * (1.0 - v) + b.mass * v;
        b.arc_length = length;
    }
    stations.truncate(first + 1);
    stations
}

/// The station of a row, in Helicoid's axes, and whether its radii of gyration are too
/// small.
fn station(row: &Row) -> (Station, bool) {
    let vector = Vector2::new;
    let (axes, stiffness, inertia) = match row {
        Row::Classic(row) => {
            let [
                _,
                m,
                x_cg,
                y_cg,
                ri_x,
                ri_y,
                x_sh,
                y_sh,
                e,
                g,
                i_x,
                i_y,
                i_p,
                k_x,
                k_y,
                a,
                ..,
            ] = *row;
            let axes = axes_of_row(&row[16..]);
            let classic = Classic {
                axial: e * a,
                bending: vector(e * i_x, e * i_y),
                torsion: g * i_p,
                shear: vector(k_x * g * a, k_y * g * a),
                shear_center: vector(x_sh, y_sh),
            };
            let inertia = inertia(&[m, x_cg, y_cg, ri_x, ri_y]);
            (axes, classic.matrix(axes), inertia)
        }
        Row::Full(row) => {
            let axes = axes_of_row(&row[6..]);
            let stiffness = axes.to_line(&from_upper(&row[9..]));
            let [_, m, x_cg, y_cg, ri_x, ri_y, ..] = *row;
            (axes, stiffness, inertia(&[m, x_cg, y_cg, ri_x, ri_y]))
        }
    };
    let (mass, too_small) = inertia.matrix(axes);
    let convention = Convention::Hawc2;
    let station = Station {
        arc_length: row.distance(),
        stiffness: symmetric(&convention.to_ours(&stiffness)),
        mass: symmetric(&convention.to_ours(&mass)),
    };
    (station, too_small)
}

/// A product of three matrices is symmetric up to round-off.
fn symmetric(matrix: &nalgebra::Matrix6<f64>) -> nalgebra::Matrix6<f64> {
    0.5 * (matrix + matrix.transpose())
}

/// Pitch, x_e and y_e are adjacent.
fn axes_of_row(columns: &[f64]) -> PrincipalAxes {
    let value = |i: usize| columns.get(i).copied().unwrap_or(0.0);
    PrincipalAxes {
        elastic: Vector2::new(value(1), value(2)),
        pitch: value(0).to_radians(),
    }
}

fn inertia(&[mass, x_cg, y_cg, ri_x, ri_y]: &[f64; 5]) -> Inertia {
    Inertia {
        mass,
        center: Vector2::new(x_cg, y_cg),
        radii: Vector2::new(ri_x, ri_y),
    }
}

/// The damping of `damping_posdef`: factors of bending and torsional stiffness. The ones of x and y belong to
/// deflections along these axes, edge and flap, not to bending about them: with this order the first flap and
/// edge modes of the public models have the damping for which their files say that they were tuned.
fn damping(body: &Body, remarks: &mut Vec<String>) -> Option<BladeDamping> {
    let [m_x, m_y, m_z, k_x, k_y, k_z] = body.damping?;
    if [m_x, m_y, m_z].iter().any(|&factor| factor != 0.0) {
        remarks.push(format!(
            "factors of the mass in damping_posdef ({m_x}, {m_y}, {m_z} 1/s) are not read"
        ));
    }
    let times = Convention::Hawc2.values_to_ours(&[0.0, 0.0, 0.0, k_y, k_x, k_z]);
    times.iter().any(|&time| time != 0.0).then(|| {
        remarks.push(
            "the factors of damping_posdef are damping times of bending and torsion; axial \
             force and shears have no damping"
                .to_owned(),
        );
        BladeDamping::Times(times)
    })
}
