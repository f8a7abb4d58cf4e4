//! Description of airfoil tables.

use rotor_aero::airfoil::files::ReadAirfoil;
use rotor_aero::airfoil::{
    Airfoil, AirfoilData, AirfoilProblem, Characteristics, Curve, Extreme, Interpolation,
};
use shared_geom::error::Explain;

use super::blade_text::list;
use super::text::aligned;
use crate::input::short_number;

/// The description of the airfoils of a file after a heading, and whether one of them is wrong.
pub fn airfoil_text(head: &str, airfoils: &[ReadAirfoil], remarks: &[String]) -> (String, bool) {
    let mut text = match airfoils.len() {
        1 => format!("{head}, 1 airfoil\n"),
        count => format!("{head}, {count} airfoils\n"),
    };
    let mut own = Vec::new();
    let mut wrong = Vec::new();
    for airfoil in airfoils {
        describe(&mut text, airfoil);
        match Airfoil::new(&airfoil.data, Interpolation::Monotone) {
            Ok(checked) => own.extend(checked.remarks().iter().map(ToString::to_string)),
            Err(problems) => wrong.extend(grouped(&problems)),
        }
    }
    let mut remarks = remarks.to_vec();
    own.retain(|remark| !remarks.contains(remark));
    remarks.extend(own);
    list(&mut text, "Remarks", &remarks);
    list(&mut text, "Wrong", &wrong);
    (text, !wrong.is_empty())
}

/// Problems with their remedies; of those with one remedy the first.
fn grouped(problems: &[AirfoilProblem]) -> Vec<String> {
    let mut lines = Vec::new();
    for (index, problem) in problems.iter().enumerate() {
        let help = problem.help();
        let alike = |list: &[AirfoilProblem]| list.iter().filter(|one| one.help() == help).count();
        if help.is_some() && alike(&problems[..index]) > 0 {
            continue;
        }
        lines.push(problem.to_string());
        let more = alike(&problems[index + 1..]);
        if help.is_some() && more > 0 {
            lines.push(format!("  and {more} more curves with this problem"));
        }
        let option = match problem {
            AirfoilProblem::Incomplete { .. } => ": add --viterna, and --out for a new file",
            _ => "",
        };
        lines.extend(help.map(|help| format!("  help: {help}{option}")));
    }
    lines
}

fn describe(text: &mut String, airfoil: &ReadAirfoil) {
    let data = &airfoil.data;
    text.push_str(&format!("\n{}\n", data.name));
    let mut say = |topic: &str, words: String| text.push_str(&format!("  {topic:<18}{words}\n"));
    if let Some(thickness) = data.thickness {
        say(
            "thickness",
            format!("{} of the chord", short_number(thickness, 4)),
        );
    }
    if let Some(set) = airfoil.set {
        say("set of profiles", set.to_string());
    }
    say("curves", curves(data));
    say("angle of attack", angles(data));
    for (topic, value, factor) in conditions() {
        // Most sections have no flap.
        let is_stated = all(data).any(|curve| value(curve).is_some());
        if is_stated || topic != FLAP {
            say(topic, values(data, value, factor));
        }
    }
    if let Some(center) = airfoil.aerodynamic_center {
        let center = short_number(center, 4);
        say(
            "moment about",
            format!("{center} of the chord, the aerodynamic center of the file"),
        );
    }
    if !airfoil.unsteady.is_empty() {
        let words = match airfoil.unsteady.len() {
            1 => "constants of 1 table".to_owned(),
            count => format!("constants of {count} tables"),
        };
        say("unsteady", words);
    }
    text.push('\n');
    text.push_str(&table(&data.characteristics()));
}

/// Topic of the deflections.
const FLAP: &str = "flap [deg]";

/// A condition of a curve.
type Condition = fn(&Curve) -> Option<f64>;

/// The conditions of curves, with the factor to the unit of their topic.
fn conditions() -> [(&'static str, Condition, f64); 3] {
    [
        ("Mach number", |curve| curve.mach, 1.0),
        ("Reynolds number", |curve| curve.reynolds, 1.0),
        (FLAP, |curve| curve.flap, 1.0_f64.to_degrees()),
    ]
}

fn curves(data: &AirfoilData) -> String {
    let counts = [
        ("lift", &data.lift),
        ("drag", &data.drag),
        ("moment", &data.moment),
    ];
    let counts = counts.map(|(name, curves)| {
        let points: usize = curves.iter().map(|curve| curve.alpha.len()).sum();
        format!("{name} {} ({points} points)", curves.len())
    });
    counts.join(", ")
}

fn all(data: &AirfoilData) -> impl Iterator<Item = &Curve> {
    data.lift.iter().chain(&data.drag).chain(&data.moment)
}

fn angles(data: &AirfoilData) -> String {
    let all = || all(data).flat_map(|curve| &curve.alpha).copied();
    let [low, high] = [
        all().fold(f64::INFINITY, f64::min),
        all().fold(f64::NEG_INFINITY, f64::max),
    ];
    if low <= high {
        format!("{} to {} deg", degrees(low), degrees(high))
    } else {
        "none".to_owned()
    }
}

fn degrees(angle: f64) -> String {
    short_number(angle.to_degrees(), 6)
}

/// The values of a condition, each once.
fn values(data: &AirfoilData, value: Condition, factor: f64) -> String {
    let mut found: Vec<f64> = all(data).filter_map(value).collect();
    found.sort_by(f64::total_cmp);
    found.dedup();
    let shown = |value: &f64| short_number(factor * value, 6);
    match &found[..] {
        [] => "not stated".to_owned(),
        [only] => format!("{}, used at all", shown(only)),
        [first, .., last] => {
            format!(
                "{} to {}, {} values",
                shown(first),
                shown(last),
                found.len()
            )
        }
    }
}

/// Title, value and unit of a column.
type Column = (&'static str, fn(&Characteristics) -> Option<f64>, f64);

/// A row of numbers for each curve of lift.
fn table(rows: &[Characteristics]) -> String {
    let has =
        |value: fn(&Characteristics) -> Option<f64>| rows.iter().any(|row| value(row).is_some());
    let columns: [Column; 3] = [
        ("Mach", |row| row.mach, 1.0),
        ("Re", |row| row.reynolds, 1.0),
        (FLAP, |row| row.flap, 1.0_f64.to_degrees()),
    ];
    let used: Vec<_> = columns.into_iter().filter(|column| has(column.1)).collect();
    let mut cells = vec![vec!["  ".to_owned()]];
    cells[0].extend(used.iter().map(|column| column.0.to_owned()));
    let titles = [
        "zero lift [deg]",
        "slope [1/rad]",
        "cl max",
        "at [deg]",
        "cl min",
        "at [deg]",
        "cd min",
        "at [deg]",
        "cl/cd max",
        "at [deg]",
        "cm at zero lift",
    ];
    cells[0].extend(titles.map(str::to_owned));
    for row in rows {
        let mut line = vec!["  ".to_owned()];
        let conditions = used
            .iter()
            .map(|column| number(column.1(row).map(|it| column.2 * it)));
        line.extend(conditions);
        line.push(fixed(row.zero_lift.map(f64::to_degrees), 2));
        line.push(fixed(row.slope, 3));
        let extremes = [
            (row.lift_max, 3),
            (row.lift_min, 3),
            (row.drag_min, 5),
            (row.ratio_max, 1),
        ];
        for (extreme, digits) in extremes {
            line.extend(pair(extreme, digits));
        }
        line.push(fixed(row.moment_zero, 4));
        cells.push(line);
    }
    aligned(&cells)
}

fn number(value: Option<f64>) -> String {
    value.map_or("-".to_owned(), |value| short_number(value, 4))
}

fn fixed(value: Option<f64>, digits: usize) -> String {
    let factor = 10.0_f64.powi(digits as i32);
    // Adding zero removes the sign of a rounded zero.
    value.map_or("-".to_owned(), |value| {
        let rounded = (value * factor).round() / factor + 0.0;
        format!("{rounded:.digits$}")
    })
}

fn pair(extreme: Option<Extreme>, digits: usize) -> [String; 2] {
    [
        fixed(extreme.map(|at| at.value), digits),
        fixed(extreme.map(|at| at.angle.to_degrees()), 1),
    ]
}
