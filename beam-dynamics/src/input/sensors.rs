//! What loads may sense: `[sensors.NAME]`.

use std::collections::BTreeMap;

use shared_geom::document::{DocumentProblem, Table};
use shared_geom::expression::{Names, written};
use shared_geom::units::{self, Dimension};

use super::draft::Draft;
use super::drives;
use crate::elements::{Post, Sensed, Sensor, Signal};

const QUANTITIES: [(&str, Sensed, Dimension); 5] = [
    ("position", Sensed::Position, Dimension::LENGTH),
    ("displacement", Sensed::Displacement, Dimension::LENGTH),
    ("rotation", Sensed::Rotation, Dimension::ANGLE),
    ("velocity", Sensed::Velocity, Dimension::VELOCITY),
    (
        "angular_velocity",
        Sensed::AngularVelocity,
        Dimension::ROTATION_SPEED,
    ),
];

/// The sensors of an input by name; those that are wrong are `None`.
pub(super) type Sensors = BTreeMap<String, Option<Sensor>>;

/// Names of the sensors of an input, before the nodes are known that they sense.
pub(super) fn names(root: &Table<'_>) -> Vec<String> {
    match root.has("sensors") && root.is_table("sensors") {
        true => root
            .table("sensors")
            .map_or(Vec::new(), |table| table.keys()),
        false => Vec::new(),
    }
}

/// Reads every `[sensors.NAME]`.
pub(super) fn read(root: &Table<'_>, draft: &mut Draft) -> Sensors {
    let mut sensors = Sensors::new();
    for (name, table) in root.named_tables("sensors") {
        let is_free = shared_geom::expression::is_name(&name)
            && name != "t"
            && !root.document().parameters().iter().any(|own| own.0 == name);
        if !is_free {
            let name = name.clone();
            table.note("", &drives::DriveProblem::SensorName { name });
        }
        let sensor = sensor(&table, &name, draft);
        table.finish();
        sensors.insert(name, sensor.filter(|_| is_free));
    }
    sensors
}

fn sensor(table: &Table<'_>, name: &str, draft: &mut Draft) -> Option<Sensor> {
    let words = format!("sensor \"{name}\"");
    let known = QUANTITIES.map(|quantity| quantity.0);
    let quantity = table
        .require_text("quantity", "what is sensed")
        .and_then(|_| table.word("quantity", &known));
    let component = table
        .require_text("component", "\"x\", \"y\" or \"z\"")
        .and_then(|_| table.word("component", &["x", "y", "z"]));
    let mut node = |key: &str| match table.has(key) {
        true => {
            let name = table.text(key)?;
            draft.find_node(&name, table, key, &words).map(Some)
        }
        false => Some(None),
    };
    let (own, against, axes) = (node("node"), node("against"), node("axes_of"));
    if !table.has("node") {
        let _ = table.require_text("node", "the name of a node");
        return None;
    }
    let (_, sensed, dimension) = QUANTITIES[quantity?];
    let unit = match table.has("unit") {
        false => Some(table.document().factor(dimension)),
        true => {
            let text = table.text("unit")?;
            let unit = units::parse_as(&text, dimension).map_err(|problem| {
                let key = "unit".to_owned();
                table.note("unit", &DocumentProblem::Unit { key, problem });
            });
            unit.ok().map(|unit| unit.factor)
        }
    };
    let post = Post {
        node: own??,
        against: against?,
        axes: axes?,
    };
    if sensed == Sensed::Rotation
        && post
            .axes
            .is_some_and(|axes| axes != post.against.unwrap_or(post.node))
    {
        let problem = drives::DriveProblem::AxesOfRotation;
        table.note("axes_of", &problem);
        return None;
    }
    Some(Sensor::new(sensed, post, component?, unit?, draft.nodes()))
}

/// Reads what a load is multiplied by under `key`: a drive, or an expression of what is
/// sensed too. One without the key; `None` when it is wrong.
pub(super) fn signal(table: &Table<'_>, key: &str, draft: &Draft) -> Option<Signal> {
    const PURE: Dimension = Dimension::NUMBER;
    let Some(item) = table.item(key) else {
        return Some(Signal::default());
    };
    let sensors = draft.sensors();
    let text = item.text().and_then(written);
    let (Some(text), false) = (text, sensors.is_empty()) else {
        return drives::read(table, key, PURE, draft.drives()).map(Signal::Drive);
    };
    let document = table.document();
    let constants = document.parameters();
    let variables: Vec<_> = ["t"]
        .into_iter()
        .chain(sensors.keys().map(String::as_str))
        .collect();
    let names = Names {
        variables: &variables,
        constants: &constants,
    };
    let expression = document.expression(key, item.line(), text, &names)?;
    if !(1..variables.len()).any(|index| expression.uses(index)) {
        return drives::read(table, key, PURE, draft.drives()).map(Signal::Drive);
    }
    if constants.iter().any(|own| own.1.is_nan()) {
        // Which of the parameters is wrong has been told.
        return None;
    }
    // A sensor that is not used may be wrong: only those that are used are kept.
    let mut used = Vec::new();
    let mut kept = vec!["t"];
    for (index, (name, sensor)) in sensors.iter().enumerate() {
        if expression.uses(index + 1) {
            used.push(sensor.clone()?);
            kept.push(name);
        }
    }
    let names = Names {
        variables: &kept,
        constants: &constants,
    };
    let expression = document.expression(key, item.line(), text, &names)?;
    let units = [document.factor(Dimension::TIME), 1.0];
    Some(Signal::sensing(expression, used, units))
}
