//! State quantities that signals may read: `[sensors.NAME]`.
//!
//! A sensor reads one of the quantities of columns, by the same keys.

use shared_geom::document::Table;
use shared_geom::document::schema::TableSchema;
use shared_geom::document::schema::ValueKind::Text;
use shared_geom::keys;

use crate::case::{ElectrodeQuantity, Quantity};
use crate::elements::circuits::Circuit;
use crate::elements::{
    Axes, EnergyPart, Input, NodeReading, NodeVector, Reading as ElementReading, RotorQuantity,
    RotorSum, Sensor, StripQuantity,
};
use crate::input::builder::ModelBuilder;
use crate::input::drives::{self, Measure, Read};
use crate::input::readings::{self, Kind, Reading, ReadingProblem, Source};
use crate::model::{Quantity as ScalarQuantity, Scalar};

/// A quantity of the state that expressions read by its name.
pub(in crate::input) const CARD: TableSchema = TableSchema {
    title: "[sensors.NAME]",
    meaning: "A number of the state that expressions read by the name.",
    keys: &[UNIT.schema],
    families: &[
        readings::NODES,
        readings::MOMENTA,
        readings::SECTIONS,
        readings::REACTIONS,
        readings::JOINTS,
        readings::ANGLES,
        readings::SPRINGS,
        readings::ELECTRODES,
        readings::STRIPS,
        readings::ROTORS,
        readings::ENERGIES,
    ],
};

keys! {
    /// Unit of its value in expressions.
    UNIT: Option<String> = "unit", [Text], or "the declared unit", "\"rad\"";
}

/// A sensor whose name expressions may read.
pub(super) struct Declared<'a> {
    name: String,
    table: Table<'a>,
    /// Its quantity; `None` if it is wrong.
    kind: Option<&'static Kind>,
    /// Its scalar; `None` if its unit or its name is wrong too.
    scalar: Option<Scalar>,
}

/// Makes every `[sensors.NAME]` readable by expressions.
pub(super) fn declare<'a>(root: &Table<'a>, drives: &mut drives::Catalog) -> Vec<Declared<'a>> {
    let declare = |(name, table): (String, Table<'a>)| {
        let is_free = drives.is_free(&name, &table, "");
        let kind = kind(&table);
        let found = kind.and_then(|kind| Some((kind, measure(kind, &table)?)));
        let read = found.filter(|_| is_free).map(|(kind, measure)| {
            let words = kind.0.replace('_', " ");
            let quantity = ScalarQuantity::new(words, kind.3, 1.0);
            Read {
                input: Input {
                    scalar: Sensor::output(&name, quantity),
                    unit: measure.factor(table.document()),
                },
                measure,
            }
        });
        drives.add_readable(name.clone(), read.clone());
        Declared {
            name,
            table,
            kind,
            scalar: read.map(|read| read.input.scalar),
        }
    };
    let tables = root.named_tables("sensors").into_iter();
    tables.map(declare).collect()
}

/// The quantity of a sensor, or of a card with the same keys.
pub(in crate::input) fn kind(table: &Table<'_>) -> Option<&'static Kind> {
    let kind = readings::kind(table)?;
    let reason = match kind.1 {
        Source::Drive | Source::Signal => "its name can be used in expressions directly",
        Source::Energy(EnergyPart::Electric) => "the derivatives of this energy are not known",
        Source::Strip(StripQuantity::TangentialLoad) => {
            "the derivatives of the direction around the shaft are not known"
        }
        Source::Rotor(quantity) if sum_of(quantity).is_none() => {
            "of the quantities of rotors only \"thrust\", \"torque\" and \"power\" are"
        }
        Source::StepLength | Source::Iterations => "it is not a number of the state",
        Source::Node(NodeVector::Euler(_)) => "the derivatives of these angles are not known",
        Source::Momentum { .. } if !table.has("of") => "the momenta of single nodes are",
        _ => return Some(kind),
    };
    let quantity = kind.0;
    table.note("quantity", &ReadingProblem::NotSensed { quantity, reason });
    None
}

/// The unit of its value: its `unit`, or the declared unit of its dimension.
fn measure(kind: &Kind, table: &Table<'_>) -> Option<Measure> {
    let component = table.item("component");
    let component = component.as_ref().and_then(|item| item.text());
    let dimension = readings::dimension_of(kind, component);
    let Some(unit) = table.get(&UNIT)? else {
        return Some(Measure::Declared(dimension));
    };
    let unit = readings::unit(table, &unit, dimension)?;
    Some(Measure::Unit(unit))
}

/// Adds every sensor to the model.
pub(super) fn read(declared: Vec<Declared<'_>>, builder: &mut ModelBuilder) {
    for one in declared {
        let is_read = sensor(&one, builder).is_some();
        // The keys of an unknown quantity are not checked.
        if one.kind.is_some() {
            one.table.finish();
        }
        if !is_read {
            builder.note_broken();
        }
    }
}

fn sensor(declared: &Declared<'_>, builder: &mut ModelBuilder) -> Option<()> {
    let Declared {
        name,
        table,
        kind,
        scalar,
    } = declared;
    let kind = (*kind)?;
    let user = format!("sensor \"{name}\"");
    let reading = Reading {
        table,
        builder,
        user: &user,
    };
    let mut found = reading.parts(kind)?;
    if found.len() != 1 {
        let (name, found) = (name.clone(), found.len());
        table.note("", &ReadingProblem::Several { name, found });
        return None;
    }
    let scalar = scalar.as_ref()?;
    let found = found.remove(0);
    let words = (kind.0, name.as_str());
    match attach(found.quantity, words, scalar, builder) {
        Ok(()) => Some(()),
        Err(problem) => {
            let key = if table.has("of") { "of" } else { "quantity" };
            table.note(key, &problem);
            None
        }
    }
}

/// Makes a scalar of a quantity, given the words for it and the name of the sensor.
pub(in crate::input) fn attach(
    quantity: Quantity,
    (word, name): (&'static str, &str),
    scalar: &Scalar,
    builder: &mut ModelBuilder,
) -> Result<(), ReadingProblem> {
    let not_sensed = |reason| ReadingProblem::NotSensed {
        quantity: word,
        reason,
    };
    match quantity {
        Quantity::Node(quantity) => {
            let reading = NodeReading::new(&quantity, builder.nodes());
            reading
                .nodes()
                .iter()
                .for_each(|node| builder.use_node(*node));
            builder.add_control(Box::new(Sensor::new(name, scalar.clone(), reading)));
        }
        Quantity::Element { label, reading } => {
            if !builder.reports(&label, &reading) {
                return Err(not_sensed("the element under \"of\" does not have it"));
            }
            if !knows_axes(&reading, &label, builder) {
                return Err(ReadingProblem::AxesOfOther);
            }
            builder.watch(label, reading, scalar.clone());
        }
        Quantity::Electrode {
            electrode,
            quantity,
        } => {
            let index = index_of(&builder.electrodes()[electrode].circuit, quantity);
            let index = index
                .ok_or_else(|| not_sensed("it is not an unknown of this electrode's circuit"))?;
            builder.watch_electrode((electrode, index), name.to_owned(), scalar.clone());
        }
        Quantity::Energy(part) => {
            let known = builder.watch_energy(part, name, scalar);
            known.map_err(|element| ReadingProblem::EnergyOf {
                quantity: word,
                element,
            })?;
        }
        Quantity::Rotor {
            strips, quantity, ..
        } => {
            let sum = sum_of(quantity).ok_or_else(|| not_sensed("it is not a sum over strips"))?;
            let of = |strip| (strip, ElementReading::Rotor(sum));
            builder.watch_strips(strips.into_iter().map(of), name, scalar);
        }
        Quantity::Strip { strips, quantity } => {
            let of = |(strip, weight)| (strip, ElementReading::Strip(quantity, weight));
            builder.watch_strips(strips.into_iter().map(of), name, scalar);
        }
        // These have been refused as kinds.
        _ => return Err(not_sensed("it is not a number of the state")),
    }
    Ok(())
}

/// The sum over strips that a quantity is.
fn sum_of(quantity: RotorQuantity) -> Option<RotorSum> {
    match quantity {
        RotorQuantity::Thrust => Some(RotorSum::Thrust),
        RotorQuantity::Torque => Some(RotorSum::Torque),
        RotorQuantity::Power => Some(RotorSum::Power),
        _ => None,
    }
}

/// Whether the axes of a reaction belong to a node on which the element acts.
fn knows_axes(reading: &ElementReading, label: &str, builder: &ModelBuilder) -> bool {
    match reading {
        ElementReading::Reaction {
            axes: Axes::Node(node),
            ..
        } => builder.nodes_of_joint(label).contains(node),
        _ => true,
    }
}

/// The index of an unknown of a circuit, see [`Circuit::scalars`].
fn index_of(circuit: &Circuit, quantity: ElectrodeQuantity) -> Option<usize> {
    let unknowns = match circuit {
        Circuit::Held(_) => 0,
        Circuit::Open { .. } => 1,
        Circuit::Shunt { inductance, .. } => 2 + usize::from(*inductance > 0.0),
    };
    let index = match quantity {
        ElectrodeQuantity::Voltage => 0,
        ElectrodeQuantity::Charge => 1,
        ElectrodeQuantity::Current => 2,
    };
    (index < unknowns).then_some(index)
}
