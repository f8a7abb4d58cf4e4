//! Tables as text.

use crate::blade::{Blade, BladeDamping};
use crate::exchange::text::{digits, upper};
use crate::line::Course;

use super::tables::{LINE, SECTIONS, station_columns};
use super::{MARK, interpolation_name, statement};

/// The whole blade.
pub(super) fn write_blade(blade: &Blade) -> String {
    let mut text = head(blade);
    count(blade.stations.len(), &mut text);
    line(blade, &mut text);
    text.push_str("table,stations\n");
    text.push_str(&station_columns().join(","));
    text.push('\n');
    for station in &blade.stations {
        let values = std::iter::once(station.arc_length)
            .chain(upper(&station.stiffness))
            .chain(upper(&station.mass));
        text.push_str(&joined(values));
    }
    text
}

/// The line alone.
pub(in crate::exchange) fn write_line(blade: &Blade) -> String {
    let mut text = head(blade);
    line(blade, &mut text);
    text
}

/// The line, and arc lengths with the names of section files.
pub(in crate::exchange) fn write_index(blade: &Blade, index: &[(f64, String)]) -> String {
    let linear = Blade {
        interpolation: crate::blade::Interpolation::Linear,
        ..blade.clone()
    };
    let mut text = head(&linear);
    count(index.len(), &mut text);
    line(blade, &mut text);
    text.push_str(&format!("table,sections\n{}\n", SECTIONS.join(",")));
    for (position, file) in index {
        text.push_str(&format!("{},{file}\n", digits(*position).trim()));
    }
    text
}

fn head(blade: &Blade) -> String {
    let damping = match &blade.damping {
        Some(BladeDamping::Proportional(time)) => format!("proportional {}", digits(*time).trim()),
        Some(BladeDamping::Times(times)) => {
            format!(
                "times {}",
                times.map(|time| digits(time).trim().to_owned()).join(" ")
            )
        }
        // Matrices were converted to times earlier, and arcs to points.
        None | Some(BladeDamping::Viscous(_)) => "none".to_owned(),
    };
    let course = match blade.line.course {
        Course::Polyline | Course::Arcs => "polyline",
        Course::Spline => "spline",
    };
    // A name of several lines would end the header.
    let name = blade.name.replace(['\n', '\r'], " ");
    format!(
        "# {MARK}\n{}# name: {name}\n# units: SI (m, rad, N, N m, N m^2, kg/m, kg, kg m, s)\n\
         # course: {course}\n# interpolation: {}\n# damping: {damping}\n",
        statement(blade),
        interpolation_name(blade.interpolation),
    )
}

/// The number of stations shows a reader that the file is complete.
fn count(stations: usize, text: &mut String) {
    text.push_str(&format!("# stations: {stations}\n"));
}

fn line(blade: &Blade, text: &mut String) {
    text.push_str(&format!("table,line\n{}\n", LINE.join(",")));
    for point in &blade.line.points {
        let [x, y, z] = point.position.into();
        text.push_str(&joined([x, y, z, point.twist]));
    }
}

fn joined(values: impl IntoIterator<Item = f64>) -> String {
    let words = values
        .into_iter()
        .map(|value| digits(value).trim().to_owned());
    words.collect::<Vec<_>>().join(",") + "\n"
}
