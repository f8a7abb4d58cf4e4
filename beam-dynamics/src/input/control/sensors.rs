//! What signals may read: `[sensors.NAME]`.

use shared_geom::document::{DocumentProblem, Table};
use shared_geom::units::{self, Dimension};

use crate::elements::{Input, Post, Sensed, Sensor};
use crate::input::draft::Draft;
use crate::input::drives::{self, Measure, Read};
use crate::model::Scalar;

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

/// A sensor whose name expressions may read.
pub(super) struct Declared<'a> {
    name: String,
    table: Table<'a>,
    /// What it senses, and its scalar; `None` where they are wrong.
    sensed: Option<(Sensed, Scalar)>,
}

/// Lets expressions read every `[sensors.NAME]`.
pub(super) fn declare<'a>(root: &Table<'a>, drives: &mut drives::Catalog) -> Vec<Declared<'a>> {
    let declare = |(name, table): (String, Table<'a>)| {
        let is_free = drives.is_free(&name, &table, "");
        let found = sensed(&table).filter(|_| is_free);
        let sensed =
            found.map(|(sensed, measure)| (sensed, Sensor::output(&name, sensed), measure));
        let read = sensed.as_ref().map(|(_, scalar, measure)| Read {
            input: Input {
                scalar: scalar.clone(),
                unit: measure.factor(table.document()),
            },
            measure: *measure,
        });
        drives.add_readable(name.clone(), read);
        Declared {
            name,
            table,
            sensed: sensed.map(|(sensed, scalar, _)| (sensed, scalar)),
        }
    };
    root.named_tables("sensors")
        .into_iter()
        .map(declare)
        .collect()
}

/// A quantity that is sensed, and its unit.
fn sensed(table: &Table<'_>) -> Option<(Sensed, Measure)> {
    let known = QUANTITIES.map(|quantity| quantity.0);
    let quantity = table
        .require_text("quantity", "what is sensed")
        .and_then(|_| table.word("quantity", &known));
    let (_, sensed, dimension) = QUANTITIES[quantity?];
    if !table.has("unit") {
        return Some((sensed, Measure::Declared(dimension)));
    }
    let text = table.text("unit")?;
    let unit = units::parse_as(&text, dimension).map_err(|problem| {
        let key = "unit".to_owned();
        table.note("unit", &DocumentProblem::Unit { key, problem });
    });
    Some((sensed, Measure::Unit(unit.ok()?)))
}

/// Adds every sensor to the model.
pub(super) fn read(declared: Vec<Declared<'_>>, draft: &mut Draft) {
    for one in declared {
        let sensor = sensor(&one, draft);
        one.table.finish();
        match sensor {
            Some(sensor) => draft.add_load(Box::new(sensor)),
            None => draft.note_broken(),
        }
    }
}

fn sensor(declared: &Declared<'_>, draft: &mut Draft) -> Option<Sensor> {
    let Declared {
        name,
        table,
        sensed,
    } = declared;
    let words = format!("sensor \"{name}\"");
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
    let (sensed, scalar) = sensed.as_ref()?;
    let post = Post {
        node: own??,
        against: against?,
        axes: axes?,
    };
    if *sensed == Sensed::Rotation
        && post
            .axes
            .is_some_and(|axes| axes != post.against.unwrap_or(post.node))
    {
        table.note("axes_of", &drives::DriveProblem::AxesOfRotation);
        return None;
    }
    let of = (scalar.clone(), *sensed);
    Some(Sensor::new(name, of, post, component?, draft.nodes()))
}
