//! Quantities of the air: of strips, and of rotors.

use shared_geom::document::Table;

use super::keys::{AT, DEFINITION, DEFINITIONS, OF, ROTOR, STRIP};
use super::kind::Kind;
use super::problem::ReadingProblem;
use crate::case::Quantity;
use crate::elements::{Definition, RotorQuantity, StripQuantity};
use crate::input::builder::{AirBlade, ModelBuilder};
use crate::input::number::short_number;

/// The definitions, in the order of their words.
const OF_WORDS: [Definition; 3] = [Definition::Rotor, Definition::Wind, Definition::Propeller];

/// A quantity, with its words.
type Worded = (String, Quantity);

/// A quantity at a point of a blade.
pub(super) fn of_strip(
    (table, builder): (&Table<'_>, &ModelBuilder),
    kind: &Kind,
    quantity: StripQuantity,
) -> Option<Worded> {
    let name = table.require_text(OF, "the name of a blade or [[strip]]");
    let (at, strip) = (table.get(&AT), table.get(&STRIP));
    let (name, at, strip) = (name?, at?, strip?);
    let blades = builder.air_blades();
    let Some(blade) = blades.iter().find(|blade| blade.name == name) else {
        if !builder.has_broken_air() && !builder.is_broken_blade(&name) {
            let known = blades.iter().map(|blade| blade.name.clone()).collect();
            table.note(OF, &ReadingProblem::NoStrips { name, known });
        }
        return None;
    };
    let (strips, place) = match (at, strip) {
        (Some(at), None) => (
            between(blade, at).map_err(|problem| table.note(&AT, &problem)),
            match blade.rotor {
                Some(_) => format!("{} of the radius of {name}", short_number(at, 6)),
                None => format!("{} of the length of {name}", short_number(at, 6)),
            },
        ),
        (None, Some(number)) => (
            numbered(blade, number).map_err(|problem| table.note(&STRIP, &problem)),
            format!("strip {number} of {name}"),
        ),
        (at, _) => {
            let found = if at.is_some() { "both" } else { "none" };
            table.note("quantity", &ReadingProblem::Position { found });
            return None;
        }
    };
    let strips = strips.ok()?;
    let words = format!("{} at {place}", kind.0.replace('_', " "));
    Some((words, Quantity::Strip { strips, quantity }))
}

/// The strip with a number from one.
fn numbered(blade: &AirBlade, number: usize) -> Result<Vec<(String, f64)>, ReadingProblem> {
    let strip = number
        .checked_sub(1)
        .and_then(|index| blade.strips.get(index));
    match strip {
        Some((label, _)) => Ok(vec![(label.clone(), 1.0)]),
        None => Err(ReadingProblem::StripNumber {
            found: number,
            count: blade.strips.len(),
            blade: blade.name.clone(),
        }),
    }
}

/// The strips around a part of the radius of the tip or of the length, with their weights.
fn between(blade: &AirBlade, at: f64) -> Result<Vec<(String, f64)>, ReadingProblem> {
    let parts = blade.strips.windows(2).find_map(|pair| {
        let [a, b] = [&pair[0], &pair[1]].map(|strip| strip.1 / blade.length);
        let part = (at - a) / (b - a);
        (0.0..=1.0).contains(&part).then(|| {
            let strips = [(pair[0].0.clone(), 1.0 - part), (pair[1].0.clone(), part)];
            strips.into_iter().filter(|strip| strip.1 > 0.0).collect()
        })
    });
    parts.ok_or_else(|| {
        let part = |strip: Option<&(String, f64)>| strip.map_or(0.0, |one| one.1 / blade.length);
        ReadingProblem::OffStrips {
            found: at,
            ends: [part(blade.strips.first()), part(blade.strips.last())],
            blade: blade.name.clone(),
        }
    })
}

/// A quantity of a rotor.
pub(super) fn of_rotor(
    (table, builder): (&Table<'_>, &ModelBuilder),
    kind: &Kind,
    quantity: RotorQuantity,
) -> Option<Worded> {
    let rotor = rotor(table, builder);
    let definition = if quantity.is_defined() {
        definition(table, kind, quantity)
    } else {
        Some(Definition::Rotor)
    };
    let (rotor, definition) = (rotor?, definition?);
    let blades = builder.air_blades().iter();
    let strips = blades.filter(|blade| blade.rotor.as_ref() == Some(&rotor));
    let strips = strips.flat_map(|blade| blade.strips.iter().map(|strip| strip.0.clone()));
    let quantity = Quantity::Rotor {
        strips: strips.collect(),
        quantity,
        definition,
    };
    Some((format!("{} of {rotor}", kind.0.replace('_', " ")), quantity))
}

/// The name of the rotor of a card.
fn rotor(table: &Table<'_>, builder: &ModelBuilder) -> Option<String> {
    let name = table.get(&ROTOR)?;
    let mut known: Vec<String> = Vec::new();
    for rotor in builder.air_blades().iter().flat_map(|blade| &blade.rotor) {
        if !known.contains(rotor) {
            known.push(rotor.clone());
        }
    }
    let (key, found) = match name {
        None if known.len() == 1 => return known.pop(),
        Some(name) if known.contains(&name) => return Some(name),
        Some(name) if builder.is_of_broken_part(&name) => return None,
        _ if builder.has_broken_air() => return None,
        _ if known.is_empty() && builder.has_broken_rotors() => return None,
        None if builder.has_broken_rotors() => return None,
        Some(name) => (OF, format!("\"{name}\" is not a rotor in the air")),
        None => {
            let count = known.len();
            (
                "quantity",
                format!("the model has {count} rotors in the air"),
            )
        }
    };
    table.note(key, &ReadingProblem::Rotor { found, known });
    None
}

/// The definition of a card.
fn definition(table: &Table<'_>, kind: &Kind, quantity: RotorQuantity) -> Option<Definition> {
    let known = quantity.definitions();
    let Some(word) = table.get(&DEFINITION)? else {
        return known.first().copied();
    };
    let found = *OF_WORDS.get(word)?;
    if known.contains(&found) {
        return Some(found);
    }
    let words = OF_WORDS.iter().zip(DEFINITIONS);
    let words = words.filter(|(own, _)| known.contains(own));
    let problem = ReadingProblem::Definition {
        found: DEFINITIONS[word],
        quantity: kind.0,
        known: words.map(|(_, word)| word).collect(),
    };
    table.note(&DEFINITION, &problem);
    None
}
