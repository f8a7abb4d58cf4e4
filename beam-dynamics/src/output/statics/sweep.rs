//! Equilibria over a parameter: a table with a row for each value, its report and its figure.

use shared_geom::figure::{Panel, PanelPlot, scale};

use crate::elements::{Definition, RotorAir, RotorQuantity};
use crate::input::short_number;
use crate::output::rows::{csv_text, heading, number};
use crate::output::text::{RPM, aligned};
use crate::result::{StaticSweep, StaticSweepPoint, TipMotion};

/// Digits of the report.
const DIGITS: usize = 6;
/// Quantities that the figure leaves out: they follow from others, or are small beside them.
const NOT_DRAWN: [&str; 3] = ["torque", "tip speed ratio", "tip edge"];
/// Difference of the tips of equal blades over the largest value \[-\].
const EQUAL: f64 = 1e-5;

/// A quantity at all points; not a number where there is no equilibrium.
struct Column {
    name: String,
    /// Empty for parameters.
    unit: &'static str,
    values: Vec<f64>,
    /// Whether the report and the figure have it: not the same one of an equal blade.
    is_shown: bool,
}

/// Quantities of a rotor: name, unit and value.
type OfRotor = (&'static str, &'static str, fn(&RotorAir, Definition) -> f64);

/// Quantities of a rotor that the air drives.
const DRIVEN: [OfRotor; 7] = [
    ("rotor speed", "rpm", |rotor, _| rotor.turning * RPM),
    ("thrust", "N", |rotor, _| rotor.thrust),
    ("torque", "N m", |rotor, _| rotor.torque),
    ("power", "W", |rotor, _| rotor.power()),
    ("thrust coefficient", "-", |rotor, by| {
        rotor.value(RotorQuantity::ThrustCoefficient, by)
    }),
    ("power coefficient", "-", |rotor, by| {
        rotor.value(RotorQuantity::PowerCoefficient, by)
    }),
    ("tip speed ratio", "-", |rotor, by| {
        rotor.value(RotorQuantity::TipSpeedRatio, by)
    }),
];

/// Quantities of a blade: name, unit and value.
type OfBlade = (&'static str, &'static str, fn(&TipMotion) -> f64);

const TIPS: [OfBlade; 4] = [
    ("tip along axis", "m", |tip| tip.along_axis),
    ("tip flap", "m", |tip| tip.flap),
    ("tip edge", "m", |tip| tip.edge),
    ("tip twist", "deg", |tip| tip.twist.to_degrees()),
];

/// All quantities of a sweep.
fn columns(sweep: &StaticSweep) -> Vec<Column> {
    let mut columns = parameters(sweep);
    let mut of_rotors = of_rotors(sweep);
    // The speed of the rotor may be one of the parameters.
    for column in &mut of_rotors {
        column.is_shown = !columns.iter().any(|own| is_same(own, column));
    }
    columns.extend(of_rotors);
    columns.extend(of_tips(sweep));
    columns
}

/// The parameters that vary with the one of the sweep.
fn parameters(sweep: &StaticSweep) -> Vec<Column> {
    let column = |name: &str| {
        let value = |point: &StaticSweepPoint| {
            let mut all = point.parameters.iter();
            all.find(|own| own.0 == name).map_or(f64::NAN, |own| own.1)
        };
        Column {
            name: name.to_owned(),
            unit: "",
            values: sweep.points.iter().map(value).collect(),
            is_shown: true,
        }
    };
    sweep.varying().into_iter().map(column).collect()
}

/// Sums and coefficients of each rotor, whose name is written if there are several.
fn of_rotors(sweep: &StaticSweep) -> Vec<Column> {
    let Some(first) = sweep.points.iter().find(|point| !point.rotors.is_empty()) else {
        return Vec::new();
    };
    let mut columns = Vec::new();
    for (name, _) in &first.rotors {
        let found: Vec<Option<&RotorAir>> = sweep
            .points
            .iter()
            .map(|point| {
                let mut all = point.rotors.iter();
                all.find(|own| own.0 == *name).map(|own| &own.1)
            })
            .collect();
        let by = definition(found.iter().copied().flatten());
        // The tip speed ratio belongs to turbines.
        let count = if by == Definition::Wind {
            DRIVEN.len()
        } else {
            DRIVEN.len() - 1
        };
        let one = first.rotors.len() == 1;
        columns.extend(DRIVEN[..count].iter().map(|(quantity, unit, value)| {
            Column {
                name: if one {
                    (*quantity).to_owned()
                } else {
                    format!("{name} {quantity}")
                },
                unit,
                values: found
                    .iter()
                    .map(|rotor| rotor.map_or(f64::NAN, |own| value(own, by)))
                    .collect(),
                is_shown: true,
            }
        }));
    }
    columns
}

/// The definition of coefficients of a rotor: of wind turbines if the air drives it where its power is
/// largest.
fn definition<'a>(rotors: impl Iterator<Item = &'a RotorAir>) -> Definition {
    let largest = rotors
        .map(RotorAir::power)
        .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
    if largest > 0.0 {
        Definition::Wind
    } else {
        Definition::Rotor
    }
}

/// The tips of all blades.
fn of_tips(sweep: &StaticSweep) -> Vec<Column> {
    let Some(first) = sweep.points.iter().find(|point| !point.tips.is_empty()) else {
        return Vec::new();
    };
    let column = |index: usize, (quantity, unit, value): &OfBlade| {
        let of = |point: &StaticSweepPoint| point.tips.get(index).map_or(f64::NAN, value);
        Column {
            name: format!("{} {quantity}", first.tips[index].blade),
            unit,
            values: sweep.points.iter().map(of).collect(),
            is_shown: true,
        }
    };
    let of_blade =
        |index: usize| -> Vec<Column> { TIPS.iter().map(|tip| column(index, tip)).collect() };
    let mut columns = of_blade(0);
    for index in 1..first.tips.len() {
        let mut own = of_blade(index);
        let is_equal = own
            .iter()
            .zip(&columns)
            .all(|(own, first)| is_same(own, first));
        own.iter_mut()
            .for_each(|column| column.is_shown = !is_equal);
        columns.extend(own);
    }
    columns
}

/// Whether two columns have the same values but for round-off.
fn is_same(one: &Column, other: &Column) -> bool {
    let largest = other.values.iter().filter(|value| value.is_finite());
    let largest = largest.fold(0.0, |a: f64, b| a.max(b.abs()));
    let mut pairs = one.values.iter().zip(&other.values);
    pairs.all(|(a, b)| a.is_nan() && b.is_nan() || (a - b).abs() <= EQUAL * largest)
}

/// A row for each value: the parameter, other parameters that vary with it, of each rotor speed, thrust,
/// torque, power and coefficients, of each blade the deformation of its tip, iterations, residual, and
/// whether the equilibrium was found. Missing values are empty.
pub fn sweep_csv(sweep: &StaticSweep) -> String {
    let columns = columns(sweep);
    let title = |column: &Column| match column.unit {
        "" => column.name.clone(),
        unit => format!("{} [{unit}]", column.name),
    };
    let mut names = vec![sweep.parameter.clone()];
    names.extend(columns.iter().map(title));
    names.extend(["iterations", "residual [-]", "status"].map(str::to_owned));
    let rows = sweep.points.iter().enumerate().map(|(index, point)| {
        let mut row = vec![number(point.at)];
        let cells = columns.iter().map(|column| column.values[index]);
        row.extend(cells.map(|value| {
            if value.is_finite() {
                number(value)
            } else {
                String::new()
            }
        }));
        row.extend(effort(point));
        row.push(status(point).to_owned());
        row
    });
    csv_text(&heading(names.iter().map(String::as_str)), rows)
}

/// Iterations of all steps, and the residual of the last.
fn effort(point: &StaticSweepPoint) -> [String; 2] {
    let steps = point.path.iter().flat_map(|path| &path.steps);
    let iterations: usize = steps.clone().map(|step| step.iterations).sum();
    match steps.last() {
        Some(last) => [iterations.to_string(), format!("{:.3e}", last.residual)],
        None => [String::new(), String::new()],
    }
}

fn status(point: &StaticSweepPoint) -> &'static str {
    match point.failure {
        None => "found",
        Some(_) => "not found",
    }
}

/// The table of the quantities, in multiples of their units, and the remarks.
pub fn sweep_text(sweep: &StaticSweep) -> String {
    let columns = columns(sweep);
    let shown: Vec<_> = columns.iter().filter(|column| column.is_shown).collect();
    let scales = shown
        .iter()
        .map(|column| scale(column.unit, column.values.iter().copied()));
    let scales: Vec<_> = scales.collect();
    let mut titles = vec![sweep.parameter.clone()];
    titles.extend(
        shown
            .iter()
            .zip(&scales)
            .map(|(column, (prefix, _))| match column.unit {
                "" => column.name.clone(),
                unit => format!("{} [{prefix}{unit}]", column.name),
            }),
    );
    titles.push(String::new());
    let rows = sweep.points.iter().enumerate().map(|(index, point)| {
        let mut row = vec![short_number(point.at, DIGITS)];
        row.extend(shown.iter().zip(&scales).map(|(column, (_, factor))| {
            let value = column.values[index] * factor;
            if value.is_finite() {
                short_number(value, DIGITS)
            } else {
                String::new()
            }
        }));
        row.push(if point.failure.is_some() {
            status(point).to_owned()
        } else {
            String::new()
        });
        row
    });
    let rows: Vec<_> = std::iter::once(titles).chain(rows).collect();
    let mut text = format!(
        "{}\n\nEquilibria over {}\n\n{}",
        sweep.name,
        sweep.parameter,
        aligned(&rows)
    );
    text.push_str(&format!(
        "\n{} of {} equilibria are found\n",
        sweep.found(),
        sweep.points.len()
    ));
    if !sweep.remarks.is_empty() {
        text.push_str("\nRemarks\n");
        sweep
            .remarks
            .iter()
            .for_each(|remark| text.push_str(&format!("  {remark}\n")));
    }
    text
}

/// The quantities over the parameter; `None` for less than two equilibria, or without quantities.
pub(super) fn sweep_plot(sweep: &StaticSweep) -> Option<PanelPlot> {
    let is_drawn = |column: &Column| !NOT_DRAWN.iter().any(|name| column.name.ends_with(name));
    let shown = columns(sweep).into_iter();
    let shown = shown.filter(|column| column.is_shown && is_drawn(column));
    let panels = shown.map(|column| {
        let points = sweep.points.iter().zip(&column.values);
        let curves = vec![points.map(|(point, value)| [point.at, *value]).collect()];
        match column.unit {
            "" => Panel {
                title: column.name,
                curves,
            },
            unit => Panel::scaled((&column.name, unit), curves),
        }
    });
    let panels: Vec<_> = panels.collect();
    (sweep.found() > 1 && !panels.is_empty()).then(|| PanelPlot {
        title: format!("{}: equilibria over {}", sweep.name, sweep.parameter),
        across: sweep.parameter.clone(),
        names: Vec::new(),
        panels,
    })
}
