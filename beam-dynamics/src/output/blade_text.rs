//! Description of the contents of a blade file.

use nalgebra::Vector2;
use shared_geom::blade::{Blade, BladeDamping, Interpolation, Station};
use shared_geom::exchange::{Format, Reading};
use shared_geom::line::{Course, ReferenceLine};
use shared_geom::section::{Centers, least_eigenvalue};

use super::text::aligned;

/// Names of the diagonal of a stiffness matrix, and their units.
const STIFFNESS: [(&str, &str); 6] = [
    ("axial", "N"),
    ("shear y (edge)", "N"),
    ("shear z (flap)", "N"),
    ("torsion", "N m^2"),
    ("bending y (flap)", "N m^2"),
    ("bending z (edge)", "N m^2"),
];

/// The description of the blade of `file`.
pub fn blade_text(file: &str, format: Format, reading: &Reading) -> String {
    let blade = &reading.blade;
    let mut text = format!("{file}: {}\n\n", format.title());
    let mut say = |topic: &str, words: String| text.push_str(&format!("{topic:<17}{words}\n"));
    say("name", blade.name.clone());
    for (topic, words) in meaning(format) {
        say(topic, words);
    }
    say("line", line_words(&blade.line));
    let (bend, sweep, twist) = shape_words(&blade.line);
    say("", bend);
    say("", sweep);
    say("twist", twist);
    say("stations", station_words(blade));
    for (topic, words) in mass_words(blade) {
        say(topic, words);
    }
    say("damping", damping_words(reading));
    say("stiffness", definite_words(blade));
    text.push('\n');
    text.push_str(&stiffness_table(blade));
    text.push('\n');
    text.push_str(&center_table(blade));
    let missing = missing(reading);
    list(&mut text, "Not in the file", &missing);
    list(&mut text, "Remarks", &reading.remarks);
    let problems = blade.summarized_problems();
    let problems: Vec<_> = problems.iter().map(ToString::to_string).collect();
    list(&mut text, "Wrong", &problems);
    text
}

/// A list with a heading; empty without items.
pub fn list(text: &mut String, head: &str, lines: &[String]) {
    if lines.is_empty() {
        return;
    }
    text.push_str(&format!("\n{head}\n"));
    for line in lines {
        text.push_str(&format!("  {line}\n"));
    }
}

/// Axes, order and point of the matrices in the file, in the reader's terms.
fn meaning(format: Format) -> Vec<(&'static str, String)> {
    let convention = format.convention();
    vec![
        ("axes of the file", convention.axes_in_words().to_owned()),
        ("order", convention.order().join(", ")),
        ("reference point", format.reference_point().to_owned()),
        (
            "below",
            "all in x along the blade, y to the leading edge, z to the upper side, about the line"
                .to_owned(),
        ),
    ]
}

fn line_words(line: &ReferenceLine) -> String {
    let course = match line.course {
        Course::Polyline => "straight pieces through",
        Course::Spline => "a spline through",
        Course::Arcs => "arcs between",
    };
    let [x, y, z] = line
        .points
        .first()
        .map_or([0.0; 3], |point| point.position.into());
    format!(
        "{course} {} points, {:.6} m long, from ({x:.4}, {y:.4}, {z:.4}) m",
        line.points.len(),
        line.length()
    )
}

/// Prebend, sweep and twist.
fn shape_words(line: &ReferenceLine) -> (String, String, String) {
    let points = &line.points;
    let largest = |of: &dyn Fn(usize) -> f64| {
        let far = |a: &usize, b: &usize| of(*a).abs().total_cmp(&of(*b).abs());
        let at = (0..points.len()).max_by(far).unwrap_or(0);
        (of(at), points.get(at).map_or(0.0, |point| point.position.x))
    };
    let (up, at_up) = largest(&|i| points[i].position.z);
    let (ahead, at_ahead) = largest(&|i| points[i].position.y);
    let degrees = |i: usize| points.get(i).map_or(0.0, |point| point.twist.to_degrees());
    let prebend = match up {
        0.0 => "no prebend".to_owned(),
        _ => format!("prebend up to z = {up:.4} m, at x = {at_up:.3} m"),
    };
    let sweep = match ahead {
        0.0 => "no sweep".to_owned(),
        _ => format!("sweep up to y = {ahead:.4} m, at x = {at_ahead:.3} m"),
    };
    let twist = format!(
        "{:.4} deg at the root, {:.4} deg at the tip, positive nose up (leading edge to z)",
        degrees(0),
        degrees(points.len().saturating_sub(1))
    );
    (prebend, sweep, twist)
}

fn station_words(blade: &Blade) -> String {
    let positions = blade.positions();
    let course = match blade.interpolation {
        Interpolation::Linear => "linear between",
        Interpolation::Constant => "constant from each to the next",
    };
    let jumps = match (blade.interpolation, blade.jumps().len()) {
        (Interpolation::Constant, _) | (_, 0) => String::new(),
        (_, count) => format!(", {count} jumps"),
    };
    format!(
        "{} from {:.6} to {:.6} m along the line, {course}{jumps}",
        blade.stations.len(),
        positions.first().unwrap_or(&0.0),
        positions.last().unwrap_or(&0.0)
    )
}

fn mass_words(blade: &Blade) -> Vec<(&'static str, String)> {
    let moments = blade.mass_moments();
    if moments.mass == 0.0 {
        return vec![("mass", "none".to_owned())];
    }
    let [x, y, z] = moments.center.into();
    let [ix, iy, iz] = [0, 1, 2].map(|i| moments.inertia[(i, i)]);
    vec![
        ("mass", format!("{:.4} kg", moments.mass)),
        (
            "mass center",
            format!("({x:.4}, {y:.4}, {z:.4}) m from the root"),
        ),
        (
            "mass moment",
            format!("{:.6e} kg m, mass times distance along x", moments.mass * x),
        ),
        (
            "inertia",
            format!(
                "about the root: x {ix:.6e}, y {iy:.6e} (flapping), z {iz:.6e} (lagging) kg m^2"
            ),
        ),
    ]
}

fn damping_words(reading: &Reading) -> String {
    match &reading.blade.damping {
        None if reading.has_other_damping => {
            "none that is converted; the remarks name the damping of the file".to_owned()
        }
        None => "none".to_owned(),
        Some(BladeDamping::Proportional(time)) => {
            format!("proportional to stiffness, time {time:.6e} s (ratio pi f t at f Hz)")
        }
        Some(BladeDamping::Times(times)) => {
            let times = times.map(|time| format!("{time:.4e}")).join(" ");
            format!("times of the components, in the order below: {times} s")
        }
        Some(BladeDamping::Viscous(_)) => "a 6x6 matrix at each station".to_owned(),
    }
}

/// Whether the stiffness is positive definite, and its least eigenvalue.
fn definite_words(blade: &Blade) -> String {
    let least = |station: &Station| match least_eigenvalue(&station.stiffness) {
        value if value.is_nan() => f64::NEG_INFINITY,
        value => value,
    };
    let all = blade.stations.iter();
    let all = all.map(|station| (least(station), station.arc_length));
    let worst = all.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, 0.0));
    let (value, position) = worst;
    let verdict = if value > 0.0 {
        "positive definite at all stations"
    } else {
        "NOT positive definite"
    };
    format!(
        "{verdict}; least eigenvalue, scaled to a unit diagonal, {value:.3e} at {position:.4} m"
    )
}

/// The least and the largest value of a quantity, with their positions.
fn range(values: &[(f64, f64)]) -> [(f64, f64); 2] {
    let order = |a: &&(f64, f64), b: &&(f64, f64)| a.0.total_cmp(&b.0);
    let least = values.iter().min_by(order);
    let most = values.iter().max_by(order);
    [least, most].map(|found| found.copied().unwrap_or((0.0, 0.0)))
}

fn words(cells: &[&str]) -> Vec<String> {
    cells.iter().map(|&cell| cell.to_owned()).collect()
}

/// A row of a quantity: least and largest value, with their positions.
fn range_row(name: String, values: &[(f64, f64)], digits: impl Fn(f64) -> String) -> Vec<String> {
    let [least, most] = range(values);
    let position = |s: f64| format!("{s:.3}");
    vec![
        name,
        digits(least.0),
        position(least.1),
        digits(most.0),
        position(most.1),
    ]
}

fn stiffness_table(blade: &Blade) -> String {
    let about_line = |s: f64| blade.at(s, shared_geom::line::Side::Outer);
    let positions = blade.positions();
    let mut rows = vec![words(&["", "least", "at m", "largest", "at m"])];
    for (i, (name, unit)) in STIFFNESS.iter().enumerate() {
        let values = positions.iter().map(|&s| (about_line(s).0[(i, i)], s));
        let name = format!("{name} [{unit}]");
        rows.push(range_row(name, &values.collect::<Vec<_>>(), |value| {
            format!("{value:.4e}")
        }));
    }
    let mass = positions.iter().map(|&s| (about_line(s).1[(0, 0)], s));
    let mass: Vec<_> = mass.collect();
    rows.push(range_row("mass [kg/m]".to_owned(), &mass, |value| {
        format!("{value:.4}")
    }));
    aligned(&rows)
}

fn center_table(blade: &Blade) -> String {
    let at = |s: f64| {
        let (stiffness, mass) = blade.at(s, shared_geom::line::Side::Outer);
        Centers::of(&stiffness, &mass).map(|centers| (centers, s))
    };
    let centers: Vec<_> = blade.positions().into_iter().filter_map(at).collect();
    if centers.is_empty() {
        return "centers: none, the stiffness or the mass is singular\n".to_owned();
    }
    type Of = fn(&Centers) -> Vector2<f64>;
    let kinds: [(&str, Of); 3] = [
        ("tension center", |centers| centers.tension),
        ("shear center", |centers| centers.shear),
        ("mass center", |centers| centers.mass),
    ];
    let mut rows = vec![words(&[
        "from the line",
        "least",
        "at m",
        "largest",
        "at m",
    ])];
    for (name, of) in kinds {
        for (axis, letter) in ["y", "z"].iter().enumerate() {
            let values = centers.iter().map(|(centers, s)| (of(centers)[axis], *s));
            let values: Vec<_> = values.collect();
            rows.push(range_row(
                format!("{name} {letter} [m]"),
                &values,
                |value| format!("{value:.5}"),
            ));
        }
    }
    aligned(&rows)
}

/// Missing parts of a blade.
fn missing(reading: &Reading) -> Vec<String> {
    let blade = &reading.blade;
    let mut missing = Vec::new();
    let length = blade.length();
    let positions = blade.positions();
    let (first, last) = (
        positions.first().unwrap_or(&0.0),
        positions.last().unwrap_or(&0.0),
    );
    let margin = 1e-9 * length;
    if *first > margin {
        missing.push(format!(
            "properties from the root to {first:.6} m, taken from the first station"
        ));
    }
    if *last < length - margin {
        missing.push(format!(
            "properties from {last:.6} m to the tip at {length:.6} m, taken from the last station"
        ));
    }
    if blade.damping.is_none() && !reading.has_other_damping {
        missing.push("damping".to_owned());
    }
    if blade.provenance.input_hash.is_empty() {
        missing.push("the hash of its source".to_owned());
    }
    missing
}
