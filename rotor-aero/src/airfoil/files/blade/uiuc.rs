//! Propeller geometry of UIUC: rows of r/R, c/R and the angle of the chord [deg].
//!
//! The radius is not in the file: it is given as an option, or is half of the diameter [in] in
//! the name of the file, as in `apcsf_10x7_geom.txt`.

use shared_geom::exchange::text::lines;

use super::super::notes::Notes;
use super::BladeOptions;
use super::apc::INCH;
use super::station::{AeroStation, BladeAero, BladeFormat, SpanOrigin};

/// Whether `text` begins with the titles.
pub(super) fn recognize(text: &str) -> bool {
    let first = text
        .lines()
        .find(|line| !line.trim().is_empty())
        .unwrap_or_default();
    let words: Vec<_> = first
        .split_whitespace()
        .map(str::to_ascii_lowercase)
        .collect();
    words.iter().map(String::as_str).eq(["r/r", "c/r", "beta"])
}

/// Reads the propeller of a file.
pub(super) fn read(text: &str, options: &BladeOptions, notes: &mut Notes) -> Option<BladeAero> {
    let lines = lines(text);
    let mut stations = Vec::new();
    let radius = options.radius.or_else(|| named_radius(notes));
    if radius.is_none() {
        let help =
            "give \"geometry_radius\" of [rotor], or name the file NAME_10x7_geom.txt (inches)";
        notes.missing(0, "the radius of the propeller", help);
    }
    let size = radius.unwrap_or(1.0);
    for line in lines.iter().skip(1) {
        if let Some([part, chord, angle]) =
            line.numbers::<3>("row of the geometry", &mut notes.problems)
        {
            if !(0.0..=1.0).contains(&part) {
                let help = "the first column is the radius over the radius of the tip";
                notes.wrong(line.number, ["r/R", &part.to_string(), "0 to 1", help]);
            }
            stations.push(AeroStation::plain(
                part * size,
                chord * size,
                angle.to_radians(),
            ));
        }
    }
    let mut blade = BladeAero::of(BladeFormat::Uiuc, SpanOrigin::RotationAxis, stations);
    blade.tip_radius = radius;
    Some(blade)
}

/// Half of the diameter in the name of the file [m].
fn named_radius(notes: &mut Notes) -> Option<f64> {
    let name = notes.file.rsplit(['/', '\\']).next()?.to_owned();
    let diameter = name.split('_').find_map(|part| {
        let (diameter, pitch) = part.split_once('x')?;
        pitch.parse::<f64>().ok()?;
        diameter.parse::<f64>().ok()
    });
    let diameter = diameter.filter(|diameter| (0.1..1000.0).contains(diameter))?;
    notes.remark(
        0,
        &format!("the radius is half of the diameter in the name of the file, {diameter} in"),
    );
    Some(diameter / 2.0 * INCH)
}
