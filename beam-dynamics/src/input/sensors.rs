//! What signals may read: `[sensors.NAME]`.

use std::collections::BTreeMap;

use shared_geom::document::{DocumentProblem, Item, Table};
use shared_geom::expression::{Names, is_name, written};
use shared_geom::units::{self, Dimension};

use super::draft::Draft;
use super::{InputProblem, drives};
use crate::elements::{Input, Post, Sensed, Sensor, Signal};

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

/// What expressions may read by name; what is wrong is `None`.
pub(super) type Readable = BTreeMap<String, Option<Input>>;

/// Names that signals may read, before the nodes are known that are sensed: those of sensors,
/// and of the outputs of systems of states.
pub(super) fn names(root: &Table<'_>) -> Vec<String> {
    let sensors = root.is_table("sensors").then(|| root.table("sensors"));
    let mut names = sensors.flatten().map_or(Vec::new(), |table| table.keys());
    if root.is_list("state_space") {
        for table in root.tables("state_space") {
            let outputs = table.item("outputs").and_then(|item| item.list());
            let texts = outputs.iter().flatten().filter_map(|item| item.text());
            names.extend(texts.map(str::to_owned));
        }
    }
    names
}

/// Whether `name`, which stands under `key`, is one that expressions may read and that is free;
/// notes what is wrong with it.
pub(super) fn is_free(name: &str, table: &Table<'_>, key: &str, draft: &Draft) -> bool {
    let document = table.document();
    let taken = [
        ("a sensor or an output", draft.readable().contains_key(name)),
        (
            "a parameter",
            document.parameters().iter().any(|own| own.0 == name),
        ),
        ("a drive", draft.drives().has(name)),
    ];
    let by = taken.iter().find(|taken| taken.1).map(|taken| taken.0);
    let own = name.to_owned();
    let problem = match by {
        _ if !is_name(name) || name == "t" => drives::DriveProblem::SignalName { name: own },
        Some(by) => drives::DriveProblem::SignalTaken { name: own, by },
        None => return true,
    };
    table.note(key, &problem);
    false
}

/// Reads every `[sensors.NAME]`.
pub(super) fn read(root: &Table<'_>, draft: &mut Draft) {
    for (name, table) in root.named_tables("sensors") {
        let is_free = is_free(&name, &table, "", draft);
        let sensor = sensor(&table, &name, draft);
        table.finish();
        let input = sensor.filter(|_| is_free).map(|(sensor, unit)| {
            let scalar = sensor.scalar().clone();
            draft.add_load(Box::new(sensor));
            Input { scalar, unit }
        });
        draft.add_readable(name, input);
    }
}

/// A sensor, and SI units in one of its unit.
fn sensor(table: &Table<'_>, name: &str, draft: &mut Draft) -> Option<(Sensor, f64)> {
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
    let sensor = Sensor::new(name, sensed, post, component?, draft.nodes());
    Some((sensor, unit?))
}

/// Reads what a load is multiplied by under `key`, see [`signal_of`]. One without the key;
/// `None` when it is wrong.
pub(super) fn signal(table: &Table<'_>, key: &str, draft: &Draft) -> Option<Signal> {
    match table.item(key) {
        Some(item) => signal_of(&item, draft),
        None => Some(Signal::default()),
    }
}

/// Reads a pure number that depends on time and on what expressions may read: a number, the
/// name of a drive, a drive, an expression, or a name that expressions may read.
pub(super) fn signal_of(item: &Item<'_>, draft: &Draft) -> Option<Signal> {
    let drive = || drives::read_value(item, Dimension::NUMBER, draft.drives()).map(Signal::Drive);
    let readable = draft.readable();
    let Some(text) = item.text() else {
        return drive();
    };
    let text = match written(text) {
        Some(text) => text,
        None if readable.contains_key(text.trim()) => text.trim(),
        None => {
            let name = text.trim();
            if !readable.is_empty() && is_name(name) && !draft.drives().has(name) {
                let known = readable.keys().cloned().chain(draft.drives().names());
                item.note(&InputProblem::UnknownName {
                    kind: "signal",
                    name: name.to_owned(),
                    user: format!("\"{}\"", item.key()),
                    known: known.collect(),
                });
                return None;
            }
            return drive();
        }
    };
    let document = item.document();
    let constants = document.parameters();
    let variables = ["t"].into_iter();
    let variables = variables.chain(readable.keys().map(String::as_str));
    let variables: Vec<_> = variables.collect();
    let names = Names {
        variables: &variables,
        constants: &constants,
    };
    let expression = document.expression(item.key(), item.line(), text, &names)?;
    if !(1..variables.len()).any(|index| expression.uses(index)) {
        return drive();
    }
    if constants.iter().any(|own| own.1.is_nan()) {
        // Which of the parameters is wrong has been told.
        return None;
    }
    // What is not used may be wrong: only what is used is kept.
    let mut used = Vec::new();
    let mut kept = vec!["t"];
    for (index, (name, input)) in readable.iter().enumerate() {
        if expression.uses(index + 1) {
            used.push(input.clone()?);
            kept.push(name);
        }
    }
    let names = Names {
        variables: &kept,
        constants: &constants,
    };
    let expression = document.expression(item.key(), item.line(), text, &names)?;
    let units = [document.factor(Dimension::TIME), 1.0];
    Some(Signal::sensing(expression, used, units))
}
