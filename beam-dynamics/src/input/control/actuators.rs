//! Actuators: `[[actuator]]`, signals that joints can follow.
//!
//! The name of a card is the name of its position, which expressions read.

use shared_geom::document::schema::ValueKind::{
    Drive as OneDrive, NotNegative, Positive, Quantity, Text, Vector, Word,
};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::elements::Input;
use crate::elements::control::{Actuator, Servo};
use crate::input::builder::ModelBuilder;
use crate::input::drives::{self, Catalog, Measure, Read};
use crate::model::{Scalar, ScalarStart};

keys! {
    /// A servo of second order, whose position joints can follow.
    pub(in crate::input) CARD = "[[actuator]]";
    /// A name, which expressions read: the position.
    NAME: String = "name", [Text], required, "\"pitch\"";
    /// Commanded position.
    COMMAND: ByHand = "command", [OneDrive(Dimension::NUMBER)], required, "\"= 2*sin(t)\"";
    /// Natural frequency.
    FREQUENCY: f64 = "frequency", [Positive(Dimension::FREQUENCY)], required, "\"8 Hz\"";
    /// Damping ratio; 0.7 is an overshoot of 5 %.
    DAMPING_RATIO: f64 = "damping_ratio", [NotNegative(Dimension::NUMBER)], or "0.7" = DAMPING,
        "1";
    /// Smallest and largest command.
    LIMITS: Option<[f64; 2]> = "limits", [Vector(2, Dimension::NUMBER)]
        as "the least and the largest command, two increasing numbers", optional, "[-10, 20]";
    /// Largest rate of the position, per second.
    RATE_LIMIT: Option<f64> = "rate_limit", [Positive(Dimension::NUMBER)], optional, "60";
    /// Unit of command, limits and position.
    UNIT: Measure = "unit", [Text], or "the unit of the key that uses it" = Measure::Plain,
        "\"deg\"";
    /// Initial position, at rest; `"settled"` is at the command.
    START: ByHand = "start", [Quantity(Dimension::NUMBER), Word(&["settled"])], or "\"settled\"",
        "5";
}

/// Default damping ratio: an overshoot of 5 %.
const DAMPING: f64 = 0.7;

/// A card whose position expressions read.
pub(super) struct Named<'a> {
    table: Table<'a>,
    /// Its name and the position; `None` if they are wrong.
    position: Option<(String, Scalar)>,
}

/// Makes the position of every `[[actuator]]` readable by expressions.
pub(super) fn declare<'a>(root: &Table<'a>, drives: &mut Catalog) -> Vec<Named<'a>> {
    let declare = |table: Table<'a>| {
        let name = table.get(&NAME);
        let (start, measure) = (start(&table), table.get(&UNIT));
        let name = name.filter(|name| drives.is_free(name, &table, NAME.name()));
        let position = name.clone().zip(start);
        let position = position.map(|(name, start)| {
            let scalar = Actuator::position(&name, start);
            (name, scalar)
        });
        if let Some(name) = name {
            let input = |scalar: &Scalar| Input {
                scalar: scalar.clone(),
                unit: 1.0,
            };
            let read = position
                .as_ref()
                .zip(measure)
                .map(|((_, scalar), measure)| Read {
                    input: input(scalar),
                    measure,
                });
            drives.add_readable(name, read);
        }
        Named { table, position }
    };
    root.tables("actuator").into_iter().map(declare).collect()
}

/// Initial position: a number, or the command, at which the actuator rests.
fn start(table: &Table<'_>) -> Option<ScalarStart> {
    const KEY: &str = START.name();
    if !table.has(KEY) {
        return Some(ScalarStart::Settled);
    }
    match table.item(KEY).as_ref().and_then(|item| item.text()) {
        Some("settled") => return Some(ScalarStart::Settled),
        Some(text) if !text.trim_start().starts_with('=') => {
            table.wrong(KEY, "a number, or \"settled\"");
            return None;
        }
        _ => {}
    }
    (table.quantity(KEY, Dimension::NUMBER)).map(ScalarStart::Value)
}

/// Adds every `[[actuator]]` to the model.
pub(super) fn read(named: Vec<Named<'_>>, builder: &mut ModelBuilder) {
    for card in named {
        let table = &card.table;
        let command = match table.require_item(&COMMAND, "a number, a drive or an expression") {
            Some(item) => drives::signal_of(&item, Dimension::NUMBER, builder.drives()),
            None => None,
        };
        let servo = servo(table);
        table.finish();
        match (command, servo, card.position) {
            (Some(command), Some(servo), Some((name, position))) => {
                builder.add_control(Box::new(Actuator::new(name, servo, command, position)));
            }
            _ => builder.note_broken(),
        }
    }
}

fn servo(table: &Table<'_>) -> Option<Servo> {
    let (frequency, damping) = (table.get(&FREQUENCY), table.get(&DAMPING_RATIO));
    let is_right = |limits: &Option<[f64; 2]>| limits.is_none_or(|[least, most]| least < most);
    let limits = table.get_if(&LIMITS, is_right, LIMITS.schema.expected);
    let rate_limit = table.get(&RATE_LIMIT);
    Some(Servo {
        frequency: std::f64::consts::TAU * frequency?,
        damping: damping?,
        limits: limits?,
        rate_limit: rate_limit?,
    })
}
