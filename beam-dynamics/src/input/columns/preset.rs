//! Default columns of a file.

use super::column::is_name;
use crate::case::{Column, ElectrodeQuantity, Quantity};
use crate::elements::{
    Axes, Definition, EnergyPart, NodeQuantity, NodeVector, Part, RotorQuantity,
};
use crate::input::builder::ModelBuilder;

/// Nodes with columns of their own.
const MOST_NODES: usize = 8;

/// The positions of the most informative nodes, electric quantities, the air on rotors, and the energies.
pub(super) fn columns(builder: &ModelBuilder) -> Vec<Column> {
    let mut columns: Vec<Column> = Vec::new();
    for node in builder.main_nodes(MOST_NODES) {
        let label = &builder.nodes()[node].label;
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let mut name = format!("{}_{axis}", as_name(label));
            while columns.iter().any(|column| column.name == name) {
                name.insert(0, '_');
            }
            columns.push(Column {
                name,
                unit: "m".to_owned(),
                factor: 1.0,
                words: format!("position {axis} of {label}"),
                quantity: Quantity::Node(NodeQuantity {
                    node,
                    vector: NodeVector::Position,
                    part: Part::Component(k),
                    against: None,
                    axes: Axes::Model,
                }),
            });
        }
    }
    columns.extend(of_electrodes(builder));
    columns.extend(of_rotors(builder));
    let electric = ("electric_energy", EnergyPart::Electric);
    let electric = (!builder.electrodes().is_empty()).then_some(electric);
    for (name, part) in [
        ("kinetic_energy", EnergyPart::Kinetic),
        ("elastic_energy", EnergyPart::Elastic),
        ("gravity_energy", EnergyPart::Gravity),
        ("energy", EnergyPart::Total),
    ]
    .into_iter()
    .chain(electric)
    {
        columns.push(Column {
            name: name.to_owned(),
            unit: "J".to_owned(),
            factor: 1.0,
            words: name.replace('_', " "),
            quantity: Quantity::Energy(part),
        });
    }
    columns
}

/// Voltage, charge and current of every electrode.
fn of_electrodes(builder: &ModelBuilder) -> Vec<Column> {
    const QUANTITIES: [(&str, ElectrodeQuantity, &str); 3] = [
        ("voltage", ElectrodeQuantity::Voltage, "V"),
        ("charge", ElectrodeQuantity::Charge, "C"),
        ("current", ElectrodeQuantity::Current, "A"),
    ];
    let cards = builder.electrodes().iter().enumerate();
    let columns = cards.flat_map(|(electrode, card)| {
        QUANTITIES.map(|(word, quantity, unit)| Column {
            name: format!("{word}_{}", as_name(&card.label)),
            unit: unit.to_owned(),
            factor: 1.0,
            words: format!("{word} of electrode {}", card.label),
            quantity: Quantity::Electrode {
                electrode,
                quantity,
            },
        })
    });
    columns.collect()
}

/// Thrust, torque and power of every rotor in the air, with its name if there are several.
fn of_rotors(builder: &ModelBuilder) -> Vec<Column> {
    const QUANTITIES: [(&str, RotorQuantity, &str); 3] = [
        ("thrust", RotorQuantity::Thrust, "N"),
        ("torque", RotorQuantity::Torque, "N m"),
        ("power", RotorQuantity::Power, "W"),
    ];
    let mut rotors: Vec<(&str, Vec<String>)> = Vec::new();
    for blade in builder.air_blades() {
        let Some(name) = blade.rotor.as_deref() else {
            continue;
        };
        let strips = blade.strips.iter().map(|strip| strip.0.clone());
        match rotors.iter_mut().find(|rotor| rotor.0 == name) {
            Some(rotor) => rotor.1.extend(strips),
            None => rotors.push((name, strips.collect())),
        }
    }
    let one = rotors.len() == 1;
    let columns = rotors.into_iter().flat_map(|(name, strips)| {
        QUANTITIES.map(|(word, quantity, unit)| Column {
            name: match one {
                true => word.to_owned(),
                false => format!("{word}_{}", as_name(name)),
            },
            unit: unit.to_owned(),
            factor: 1.0,
            words: format!("{word} of {name}"),
            quantity: Quantity::Rotor {
                strips: strips.clone(),
                quantity,
                definition: Definition::Rotor,
            },
        })
    });
    columns.collect()
}

/// The label of a node, converted to a name of a column.
fn as_name(label: &str) -> String {
    let letter = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = label.chars().map(letter).collect();
    if is_name(&name) {
        name
    } else {
        format!("n{name}")
    }
}
