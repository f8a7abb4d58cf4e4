//! Inputs and outputs of a linear model, by names of the file.
//!
//! An input replaces a drive of its name: all users of the drive read a scalar that begins at the value
//! of the drive. A control of a trim of an equilibrium is such a scalar already. Outputs are scalars
//! that expressions read by name, or columns, of which scalars are made.

use nalgebra::DMatrix;
use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::analyses::Analyses;
use super::builder::ModelBuilder;
use super::control;
use super::drives::{Catalog, Measure, Read};
use super::readings::Reading;
use super::trim;
use crate::case::{LinearAbout, LinearPort, LinearSettings, ModesSettings, TrimMethod};
use crate::elements::control::{Matrices, StateSpace};
use crate::elements::{Sensor, Signal};
use crate::model::{Drive, Quantity, Scalar, ScalarSpec, ScalarStart};

mod problem;
mod request;

pub use problem::LinearProblem;
pub use request::{LinearChoice, LinearRequest};

/// The inputs as declared: those that replace drives, with their values.
pub(super) struct Declared<'a> {
    request: &'a LinearRequest,
    inputs: Vec<LinearPort>,
    held: Vec<(Scalar, f64)>,
}

/// Makes the inputs readable by expressions, in place of the drives of their names; `None` if one is
/// wrong.
pub(super) fn declare<'a>(
    root: &Table<'_>,
    request: &'a LinearRequest,
    drives: &mut Catalog,
    trim: Option<&trim::Declared>,
) -> Option<Declared<'a>> {
    let mut is_sound = true;
    let mut declared = Declared {
        request,
        inputs: Vec::new(),
        held: Vec::new(),
    };
    for (option, names) in [("--input", &request.inputs), ("--output", &request.outputs)] {
        let doubled = (1..names.len()).find(|&i| names[..i].contains(&names[i]));
        if let Some(name) = doubled.map(|i| names[i].clone()) {
            root.note("", &LinearProblem::Doubled { name, option });
            is_sound = false;
        }
    }
    for name in &request.inputs {
        match input(name, drives, trim, &mut declared.held) {
            Ok(port) => declared.inputs.extend(port),
            Err(problem) => {
                root.note("", &problem);
                is_sound = false;
            }
        }
    }
    is_sound.then_some(declared)
}

/// The input of a name; `Ok(None)` for a wrong drive, which has been noted.
pub(super) fn input(
    name: &str,
    drives: &mut Catalog,
    trim: Option<&trim::Declared>,
    held: &mut Vec<(Scalar, f64)>,
) -> Result<Option<LinearPort>, LinearProblem> {
    let name = name.to_owned();
    if let Some(control) = trim.and_then(|trim| trim.control(&name)) {
        let scalar = control.cloned();
        let scalar = scalar.ok_or(LinearProblem::Parameter { name: name.clone() })?;
        let unit = "-".to_owned();
        return Ok(Some(LinearPort { name, unit, scalar }));
    }
    if !drives.has(&name) {
        let controls = trim.into_iter().flat_map(trim::Declared::names);
        let known = drives.names().chain(controls).collect();
        return Err(LinearProblem::Input { name, known });
    }
    let Some((value, measure)) = drives.at_start(&name) else {
        return Ok(None);
    };
    if !value.is_finite() {
        return Err(LinearProblem::NoValue { name, value });
    }
    let unit = unit_of(&measure);
    let scalar = Scalar::new(ScalarSpec {
        owner: name.clone(),
        unknown: Quantity::new("input", unit.clone(), 1.0),
        equation: Quantity::new("input", unit.clone(), 1.0),
        has_rate: true,
        rate: None,
        start: ScalarStart::Constant(value),
    });
    drives.add_input(&name, (scalar.clone(), measure));
    held.push((scalar.clone(), value));
    Ok(Some(LinearPort { name, unit, scalar }))
}

/// Adds the inputs and outputs to the model, and chooses the equilibrium among the analyses, which then
/// have it as modes; `None` if something is wrong.
pub(super) fn read(
    root: &Table<'_>,
    declared: Declared<'_>,
    analyses: &mut Analyses,
    builder: &mut ModelBuilder,
) -> Option<LinearSettings> {
    for (scalar, value) in declared.held {
        builder.add_control(Box::new(held(scalar, value)));
    }
    let names = declared.request.outputs.as_slice();
    let mut outputs: Vec<_> = names.iter().map(|name| readable(name, builder)).collect();
    let is_sound = add_columns(root, (names, &mut outputs[..]), builder);
    let about = about(declared.request, analyses);
    if let Err(problem) = &about {
        root.note("", problem);
    }
    let known = || known_outputs(root, builder);
    for (name, _) in names
        .iter()
        .zip(&outputs)
        .filter(|(_, output)| output.is_none())
    {
        let (name, known) = (name.clone(), known());
        root.note("", &LinearProblem::Output { name, known });
    }
    let settings = LinearSettings {
        about: about.ok()?,
        inputs: declared.inputs,
        outputs: outputs.into_iter().collect::<Option<_>>()?,
    };
    is_sound.then_some(settings)
}

/// The element that holds an input at a value.
fn held(scalar: Scalar, value: f64) -> StateSpace {
    let label = scalar.owner.clone();
    let value = Signal::from(Drive::Constant(value));
    let gain = Matrices::gain(DMatrix::identity(1, 1));
    StateSpace::new(label, gain, vec![value], vec![scalar], &[])
}

/// The output of a name that expressions read.
fn readable(name: &str, builder: &ModelBuilder) -> Option<LinearPort> {
    let Read { input, measure } = builder.drives().read_by(name)?;
    Some(LinearPort {
        name: name.to_owned(),
        unit: unit_of(measure),
        scalar: input.scalar.clone(),
    })
}

/// Makes scalars of the columns among the outputs that are still unknown; `false` if one is wrong.
fn add_columns(
    root: &Table<'_>,
    (names, outputs): (&[String], &mut [Option<LinearPort>]),
    builder: &mut ModelBuilder,
) -> bool {
    let mut is_sound = true;
    for table in root.listed("output", "column") {
        let Some(card) = table.is_text("name").then(|| table.text("name")).flatten() else {
            continue;
        };
        let is_of_card = |name: &String| {
            let rest = name.strip_prefix(&card);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
        };
        let pairs = || names.iter().zip(outputs.iter()).enumerate();
        let wanted = pairs().filter(|(_, (name, output))| output.is_none() && is_of_card(name));
        let wanted: Vec<_> = wanted.map(|(i, (name, _))| (i, name)).collect();
        if wanted.is_empty() {
            continue;
        }
        let found = of_column(&table, &card, builder);
        is_sound &= found.is_some();
        let mut found = found.unwrap_or_default();
        for (i, name) in wanted {
            let index = found.iter().position(|found| found.0.name == *name);
            if let Some((port, quantity, kind)) = index.map(|index| found.swap_remove(index)) {
                let words = (kind, port.name.as_str());
                let attached = control::attach(quantity, words, &port.scalar, builder);
                if let Err(problem) = &attached {
                    table.note("quantity", problem);
                    is_sound = false;
                }
                outputs[i] = Some(port);
            }
        }
    }
    is_sound
}

/// An output, with its quantity and the word of this.
type OfColumn = (LinearPort, crate::case::Quantity, &'static str);

/// The quantities of the columns of a card; `None` if it is wrong.
fn of_column(table: &Table<'_>, card: &str, builder: &ModelBuilder) -> Option<Vec<OfColumn>> {
    let kind = control::sensed(table)?;
    let user = format!("column \"{card}\"");
    let reading = Reading {
        table,
        builder,
        user: &user,
    };
    let parts = reading.parts(kind)?;
    let is_alone = parts.len() == 1;
    let port = |part: super::readings::Found| {
        let name = if is_alone {
            card.to_owned()
        } else {
            format!("{card}_{}", part.word)
        };
        let unit = si_unit(part.dimension);
        let quantity = Quantity::new(kind.0.replace('_', " "), unit.clone(), 1.0);
        let scalar = Sensor::output(&name, quantity);
        (LinearPort { name, unit, scalar }, part.quantity, kind.0)
    };
    Some(parts.into_iter().map(port).collect())
}

/// All names that may be outputs: columns of several components by the names of their cards.
fn known_outputs(root: &Table<'_>, builder: &ModelBuilder) -> Vec<String> {
    let of_columns = root.listed("output", "column").into_iter();
    let of_columns = of_columns.flat_map(|table| {
        let card = table.is_text("name").then(|| table.text("name")).flatten();
        let names = |card: String| match of_column(&table, &card, builder) {
            Some(found) => found.into_iter().map(|one| one.0.name).collect(),
            None => vec![card],
        };
        card.map_or_else(Vec::new, names)
    });
    builder
        .drives()
        .readable_names()
        .chain(of_columns)
        .collect()
}

/// The equilibrium about which the model is linearized; other speeds of `[modes]` are removed.
fn about(request: &LinearRequest, analyses: &mut Analyses) -> Result<LinearAbout, LinearProblem> {
    if let Some(trim) = &analyses.trim {
        return match (trim.method, request.about, request.speed) {
            (TrimMethod::Equilibrium, None | Some(LinearChoice::Trim), None) => {
                Ok(LinearAbout::Trim)
            }
            (TrimMethod::Equilibrium, None | Some(LinearChoice::Trim), Some(_)) => {
                Err(LinearProblem::SpeedOfTrim)
            }
            (TrimMethod::Equilibrium, Some(choice), _) => Err(LinearProblem::BesideTrim(choice)),
            _ => Err(LinearProblem::PeriodicTrim),
        };
    }
    if request.about == Some(LinearChoice::Periodic) {
        let speed = analyses.periodic.as_ref().and_then(|own| own.speed);
        return match (&analyses.periodic, speed, request.speed) {
            (None, ..) => Err(LinearProblem::Missing(LinearChoice::Periodic)),
            (_, Some(_), None) => Ok(LinearAbout::Period),
            _ => Err(LinearProblem::SpeedOfPeriod),
        };
    }
    let of_modes = analyses.modes.as_ref().map(|modes| modes.speeds.as_slice());
    let of_static = analyses.statics.as_ref().map(|own| [own.speed, own.to]);
    let choice = request.about.or(match (of_modes, of_static) {
        (Some(_), _) => Some(LinearChoice::Modes),
        (None, Some(_)) => Some(LinearChoice::Static),
        (None, None) => None,
    });
    let (speed, proportional) = match (choice, of_modes, of_static) {
        (Some(LinearChoice::Modes), Some(speeds), _) => match (speeds, request.speed) {
            (_, Some(speed)) | (&[speed], None) => (speed, 1.0),
            (speeds, None) => {
                let count = speeds.len();
                return Err(LinearProblem::Speeds { count });
            }
        },
        (Some(LinearChoice::Static), _, Some([speed, to])) => (request.speed.unwrap_or(speed), to),
        (Some(choice), ..) => return Err(LinearProblem::Missing(choice)),
        (None, ..) => (request.speed.unwrap_or(0.0), 1.0),
    };
    let own = analyses.modes.take();
    let own = own.unwrap_or_else(|| ModesSettings::new(Vec::new(), 1));
    analyses.modes = Some(ModesSettings {
        speeds: vec![speed],
        shapes: Vec::new(),
        ..own
    });
    Ok(LinearAbout::Equilibrium {
        speed,
        proportional,
    })
}

/// The SI unit of a measure.
fn unit_of(measure: &Measure) -> String {
    match measure {
        Measure::Unit(unit) => si_unit(unit.dimension),
        Measure::Declared(dimension) => si_unit(*dimension),
        Measure::Plain => "-".to_owned(),
    }
}

/// The SI unit of a dimension, `-` for a pure number.
fn si_unit(dimension: Dimension) -> String {
    const NAMED: [(Dimension, &str); 9] = [
        (Dimension::NUMBER, "-"),
        (Dimension::FORCE, "N"),
        (Dimension::MOMENT, "N m"),
        (Dimension::FORCE_PER_LENGTH, "N/m"),
        (Dimension::POWER, "W"),
        (Dimension::VOLTAGE, "V"),
        (Dimension::CHARGE, "C"),
        (Dimension::CURRENT, "A"),
        (Dimension::STRESS, "Pa"),
    ];
    if let Some((_, name)) = NAMED.iter().find(|named| named.0 == dimension) {
        return (*name).to_owned();
    }
    let parts = [
        ("kg", dimension.mass),
        ("m", dimension.length),
        ("rad", dimension.angle),
        ("K", dimension.temperature),
        ("A", dimension.current),
        ("s", dimension.time),
    ];
    let written = |sign: i8| {
        let own = parts.iter().filter(move |part| part.1.signum() == sign);
        let own = own.map(|(unit, power)| match power.abs() {
            1 => (*unit).to_owned(),
            power => format!("{unit}^{power}"),
        });
        own.collect::<Vec<_>>()
    };
    match (written(1).join(" "), written(-1).join("/")) {
        (above, below) if below.is_empty() => above,
        (above, below) if above.is_empty() => format!("1/{below}"),
        (above, below) => format!("{above}/{below}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_written_as_products() {
        for (dimension, expected) in [
            (Dimension::ANGLE, "rad"),
            (Dimension::ROTATION_SPEED, "rad/s"),
            (Dimension::ACCELERATION, "m/s^2"),
            (Dimension::TURNING_DAMPER, "kg m^2/s"),
            (Dimension::CURVATURE, "rad/m"),
            (Dimension::FREQUENCY, "1/s"),
            (Dimension::MOMENT, "N m"),
            (Dimension::NUMBER, "-"),
        ] {
            assert_eq!(si_unit(dimension), expected);
        }
    }
}
