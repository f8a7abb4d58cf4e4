//! Stability over a parameter of the file: roots at its values, modes that are followed, boundaries.
//!
//! 1. For each value the file is read with this value, and the controls of a trim are found.
//! 2. The roots are the eigenvalues about the equilibrium of the turning frame, or the multipliers
//!    of the periodic motion.
//! 3. The scan adds values where they are needed, and finds the boundaries.

mod crossing;
pub mod follow;
mod names;
pub mod refine;
mod request;
mod scan;
mod seen;
mod source;
mod touching;
mod votes;

pub use request::{Evaluate, ScanSettings};
pub use scan::{Scan, scan};

use super::trim::Reader;
use crate::case::{StabilityMethod, StabilitySettings, TrimSettings};
use crate::input::short_number;
use crate::result::{StabilityPoint, StabilityResult, StabilityRoot};
use source::Source;

/// The stability requested by `settings`, of the file that `read` reads, trimmed as `trim` requests.
pub fn stability(
    name: &str,
    settings: &StabilitySettings,
    trim: Option<&TrimSettings>,
    read: Reader<'_>,
) -> StabilityResult {
    let values = settings.sweep.values.clone();
    let requested = values.len();
    let mut of_scan = ScanSettings {
        values,
        boundaries: settings.boundaries,
        tolerance: 0.0,
    };
    of_scan.tolerance = settings.tolerance * of_scan.range();
    let mut source = Source::new(settings, trim, read);
    if settings.method == StabilityMethod::Modes {
        source.prepare();
    }
    let found = scan(&of_scan, &mut |at| source.roots(at));
    let mut remarks = found.remarks;
    remarks.extend(source.remarks());
    remarks.extend(of_two_blades(&found.modes, source.is_double()));
    remarks.extend(overdamped(settings, &found.points, &found.modes));
    remarks.extend(unresolved(settings, &found.points, &found.modes));
    let mut points = found.points;
    for point in &mut points {
        point.controls = source.controls(point.at);
    }
    let controls = trim.map_or_else(Vec::new, |trim| {
        let all = trim.controls.iter().chain(&trim.parameters);
        all.map(|control| control.name.clone()).collect()
    });
    StabilityResult {
        name: name.to_owned(),
        method: match settings.method {
            StabilityMethod::Modes => "eigenvalues about the equilibrium of the turning frame",
            StabilityMethod::Floquet => "multipliers of the periodic motion",
            StabilityMethod::Averaged => {
                "eigenvalues of multiblade coefficients averaged over the periodic motion"
            }
        },
        parameter: settings.sweep.parameter.clone(),
        requested,
        controls,
        modes: found.modes,
        points,
        boundaries: found.boundaries,
        failures: found.failures,
        remarks,
    }
}

/// The frequencies of two blades that move against each other, as a remark.
fn of_two_blades(modes: &[String], is_double: bool) -> Option<String> {
    let word = "differential";
    let is_such = is_double && modes.iter().any(|name| name.ends_with(word));
    is_such.then(|| {
        format!(
            "the frequencies f of {word} modes of two blades are those in axes that turn with them; in the \
             fixed frame they are seen at f + n and |f - n| with the speed n of the rotor"
        )
    })
}

/// Modes that do not oscillate at some of the requested values, with these, as a remark.
fn overdamped(
    settings: &StabilitySettings,
    points: &[StabilityPoint],
    modes: &[String],
) -> Vec<String> {
    let parameter = &settings.sweep.parameter;
    let of_mode = |(mode, name): (usize, &String)| {
        let is_so = |point: &&StabilityPoint| {
            let root = point.root_of(mode);
            point.is_requested && root.is_some_and(|root| root.is_overdamped)
        };
        let values = points.iter().filter(is_so);
        let values: Vec<_> = values.map(|point| short_number(point.at, 9)).collect();
        (!values.is_empty()).then(|| {
            let values = values.join(", ");
            format!("\"{name}\" is overdamped, without oscillation of the blades, at {parameter} = {values}")
        })
    };
    modes.iter().enumerate().filter_map(of_mode).collect()
}

/// Part of the critical damping, and of the growth, above which the error of the steps is a remark [-].
const UNRESOLVED: [f64; 2] = [0.005, 0.2];

/// Modes whose growth has a large error by the steps of the period, as a remark.
fn unresolved(
    settings: &StabilitySettings,
    points: &[StabilityPoint],
    modes: &[String],
) -> Option<String> {
    let parameter = &settings.sweep.parameter;
    let is_large = |root: &StabilityRoot, error: f64| {
        let [damping, part] = UNRESOLVED;
        let size = root.growth().hypot(root.in_blades);
        !root.is_neutral && error > damping * size && error > part * root.growth().abs()
    };
    let of_point = |point: &StabilityPoint| {
        let roots = point.roots.iter().zip(&point.modes);
        let large = roots.filter_map(|(root, mode)| {
            let error = root.error.filter(|error| is_large(root, *error))?;
            let [growth, error] = [root.growth(), error].map(|own| short_number(own, 3));
            let (name, at) = (&modes[*mode], short_number(point.at, 9));
            Some(format!(
                "\"{name}\" at {parameter} = {at}, growth {growth} 1/s, error {error} 1/s"
            ))
        });
        large.collect::<Vec<_>>()
    };
    let all: Vec<String> = points.iter().flat_map(of_point).collect();
    let others = match all.len() {
        0 => return None,
        1 => String::new(),
        count => format!(" (and {} others)", count - 1),
    };
    Some(format!(
        "the steps of the period are too long for {}{others}: more \"steps\", or stages = \"three\"",
        all[0]
    ))
}
