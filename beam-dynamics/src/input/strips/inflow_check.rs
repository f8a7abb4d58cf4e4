//! Checks of each `[[inflow]]` with the strips that refer to it: the number of blades and the radii that
//! it states.

use shared_geom::document::Table;
use shared_geom::error::Explain;

use crate::input::aerodynamics::{Inflow, InflowKind};
use crate::input::builder::{AirBlade, ModelBuilder};
use crate::input::short_number;

/// Radius of a disk over the radius of its tips at most: beyond this it is a mistake in the unit or the
/// digits, no wake that is wider than its rotor.
const WIDEST: f64 = 1.25;

/// Part of a radius by which numbers of a file may differ from the model.
const ROUNDED: f64 = 1e-6;

/// A key of an inflow that contradicts its blades.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InflowProblem {
    /// Another number of blades.
    #[error(
        "inflow \"{name}\" has \"blades\" = {found}, and {count} blades refer to it: expected {count}"
    )]
    Blades {
        /// Name of the inflow.
        name: String,
        /// Number found.
        found: usize,
        /// Number of blades in the model.
        count: usize,
    },
    /// Blades of several cards without their number.
    #[error(
        "inflow \"{name}\" has no \"blades\", and blades of several cards refer to it, {count} in all: \
         expected their number, since the card of a blade has only its own"
    )]
    NoBlades {
        /// Name of the inflow.
        name: String,
        /// Number of blades in the model.
        count: usize,
    },
    /// A root beyond the first strip.
    #[error(
        "inflow \"{name}\" has \"hub_radius\" = {} m, and the first strip of \"{blade}\" is at {} m: \
         expected a radius below it",
        short_number(*.found, 6),
        short_number(*.first, 6)
    )]
    HubRadius {
        /// Name of the inflow.
        name: String,
        /// Radius found \[m\].
        found: f64,
        /// Name of the blade.
        blade: String,
        /// Radius of its first strip \[m\].
        first: f64,
    },
    /// A disk that is not the one of its blades.
    #[error(
        "inflow \"{name}\" has \"radius\" = {} m, and the last strip of \"{blade}\" is at {} m, its tip \
         at {} m: expected {} to {} m",
        short_number(*.found, 6),
        short_number(*.last, 6),
        short_number(*.tip, 6),
        short_number(*.last, 6),
        short_number(WIDEST * *.tip, 6)
    )]
    Radius {
        /// Name of the inflow.
        name: String,
        /// Radius found \[m\].
        found: f64,
        /// Name of the blade.
        blade: String,
        /// Radius of its last strip \[m\].
        last: f64,
        /// Radius of its tip \[m\].
        tip: f64,
    },
}

impl Explain for InflowProblem {
    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Blades { name, .. } => format!(
                "correct \"blades\", or give inflow = \"{name}\" to every blade of the rotor; one blade \
                 alone may represent all"
            ),
            Self::NoBlades { count, .. } => format!("add blades = {count} to the inflow"),
            Self::HubRadius { .. } => {
                "give the radius at which the blades begin, or leave \"hub_radius\" out".to_owned()
            }
            Self::Radius { .. } => "leave \"radius\" out: it is the radius of the tip; \
                \"effective_radius\" is the part of it with lift"
                .to_owned(),
        })
    }
}

/// Number of blades, radius of the hub and radius of the disk that an inflow states \[m\].
type Stated = (Option<usize>, Option<f64>, Option<f64>);

/// Notes keys of inflows that contradict the blades of the model.
pub(in crate::input) fn check(root: &Table<'_>, builder: &mut ModelBuilder) {
    if builder.has_broken_air() {
        return;
    }
    let inflows = builder.aerodynamics().inflows.clone().unwrap_or_default();
    let mut remarks = Vec::new();
    for (inflow, table) in inflows.iter().zip(root.tables("inflow")) {
        let users = builder.air_blades().iter();
        let users =
            users.filter(|blade| blade.has_inflow && blade.rotor.as_ref() == Some(&inflow.name));
        let users: Vec<&AirBlade> = users.collect();
        let stated = match &inflow.kind {
            InflowKind::Annular(annular) => annular.stated(),
            InflowKind::Disk(design) => (None, None, design.radius),
        };
        for (key, problem) in problems(inflow, stated, &users) {
            table.note(key, &problem);
        }
        remarks.extend(one_of_several(inflow, stated.0, &users));
        if users.is_empty() {
            remarks.push(format!(
                "inflow \"{0}\" has no effect, since no blade and no strip refers to it: give them \
                 inflow = \"{0}\"",
                inflow.name
            ));
        }
    }
    builder.add_remarks(remarks);
}

/// Blades of `[[blade]]` among the users of an inflow; blades of bodies may have several cards each.
fn blades<'a>(users: &'a [&AirBlade]) -> impl Iterator<Item = usize> + 'a {
    users.iter().filter_map(|user| user.siblings)
}

/// One blade that represents a rotor.
fn one_of_several(inflow: &Inflow, stated: Option<usize>, users: &[&AirBlade]) -> Option<String> {
    let stated = stated.filter(|stated| *stated > 1 && blades(users).count() == 1)?;
    Some(format!(
        "inflow \"{}\" is of {stated} blades, and one of them is in the model: its thrust, torque and power \
         are of one blade",
        inflow.name
    ))
}

/// The problems of a number of blades, a radius of the hub and a radius of the disk, with their keys.
fn problems(
    inflow: &Inflow,
    (number, hub_radius, radius): Stated,
    users: &[&AirBlade],
) -> Vec<(&'static str, InflowProblem)> {
    let counts = of_number(inflow, number, users);
    let hub = hub_radius.and_then(|found| of_hub(inflow, found, users));
    let disk = radius.and_then(|found| of_disk(inflow, found, users));
    counts.into_iter().chain(hub).chain(disk).collect()
}

fn of_number(
    inflow: &Inflow,
    number: Option<usize>,
    users: &[&AirBlade],
) -> Option<(&'static str, InflowProblem)> {
    let (name, count) = (inflow.name.clone(), blades(users).count());
    match number {
        Some(found) if count > 1 && found != count => {
            Some(("blades", InflowProblem::Blades { name, found, count }))
        }
        None if inflow.is_annular() && blades(users).any(|of_card| of_card != count) => {
            Some(("", InflowProblem::NoBlades { name, count }))
        }
        _ => None,
    }
}

fn of_hub(
    inflow: &Inflow,
    found: f64,
    users: &[&AirBlade],
) -> Option<(&'static str, InflowProblem)> {
    let (blade, first) = users
        .iter()
        .filter_map(|user| Some((user.name.clone(), user.radii()?[0])))
        .reduce(|first, next| match next.1 < first.1 * (1.0 - ROUNDED) {
            true => next,
            false => first,
        })?;
    let name = inflow.name.clone();
    let problem = InflowProblem::HubRadius {
        name,
        found,
        blade,
        first,
    };
    (first <= found).then_some(("hub_radius", problem))
}

fn of_disk(
    inflow: &Inflow,
    found: f64,
    users: &[&AirBlade],
) -> Option<(&'static str, InflowProblem)> {
    let (user, last) = users
        .iter()
        .filter_map(|user| Some((user, user.radii()?[1])))
        .reduce(|last, next| match next.1 > last.1 * (1.0 + ROUNDED) {
            true => next,
            false => last,
        })?;
    let is_inside = (last * (1.0 - ROUNDED)..=WIDEST * user.length).contains(&found);
    let problem = InflowProblem::Radius {
        name: inflow.name.clone(),
        found,
        blade: user.name.clone(),
        last,
        tip: user.length,
    };
    (!is_inside).then_some(("radius", problem))
}

#[cfg(test)]
mod tests {
    use crate::input::test_files::{STRIP, read_beside, reported};

    /// Blades from 0.5 m to 4.5 m with one strip in the middle of each meter, by the numbers of blades
    /// of their cards.
    fn rotor(inflow: &str, cards: &[usize]) -> String {
        let card = |(number, count): (usize, &usize)| {
            format!(
                "[[blade]]\nname = \"b{number}\"\ncount = {count}\nhub_radius = 0.5\nproperties = \"strip\"\n\
                 piece = [{{ length = 4, elements = 4 }}]\n[blade.aerodynamics]\ninflow = \"lift\"\nstrips = 1\n\
                 stations = [{{ at = 0, chord = 0.3, airfoil = \"naca0012\" }}, \
                 {{ at = 4, chord = 0.3, airfoil = \"naca0012\" }}]\n"
            )
        };
        let cards: String = cards.iter().enumerate().map(card).collect();
        format!(
            "units = \"SI\"\n[[inflow]]\nname = \"lift\"\n{inflow}\n{STRIP}{cards}[static]\nspeed = 60\n"
        )
    }

    #[test]
    fn numbers_and_radii_are_the_ones_of_the_blades() {
        let disk = "kind = \"Drees\"\n";
        for (inflow, cards, words) in [
            (
                "blades = 3",
                &[2][..],
                [
                    ":4: inflow \"lift\" has \"blades\" = 3, and 2 blades refer to it: expected 2",
                    "give inflow = \"lift\" to every blade of the rotor; one blade alone may represent all",
                ],
            ),
            (
                "",
                &[1, 2],
                [
                    ":2: inflow \"lift\" has no \"blades\", and blades of several cards refer to it, 3 in all",
                    "add blades = 3 to the inflow",
                ],
            ),
            (
                "hub_radius = 1.5",
                &[2],
                [
                    ":4: inflow \"lift\" has \"hub_radius\" = 1.5 m, and the first strip of \"b0 1\" is at 1 m: \
                     expected a radius below it",
                    "or leave \"hub_radius\" out",
                ],
            ),
            (
                "kind = \"Drees\"\nradius = 3",
                &[2],
                [
                    ":5: inflow \"lift\" has \"radius\" = 3 m, and the last strip of \"b0 1\" is at 4 m, its \
                     tip at 4.5 m: expected 4 to 5.625 m",
                    "leave \"radius\" out: it is the radius of the tip",
                ],
            ),
        ] {
            let shown = reported(read_beside(&rotor(inflow, cards), &[]));
            for words in words {
                assert!(shown.contains(words), "{words}\n{shown}");
            }
            assert_eq!(shown.matches("error:").count(), 1, "{shown}");
        }
        for (inflow, cards) in [
            ("blades = 3\nhub_radius = 0.9", &[1, 2][..]),
            ("hub_radius = 0.5", &[2]),
            (&format!("{disk}radius = 4.2"), &[1, 2]),
        ] {
            let found = read_beside(&rotor(inflow, cards), &[]);
            assert!(found.is_ok(), "{inflow}: {:?}", found.err());
        }
    }

    #[test]
    fn one_blade_is_a_rotor_with_a_remark() {
        let input = read_beside(&rotor("blades = 3", &[1]), &[]).unwrap();
        let expected = "inflow \"lift\" is of 3 blades, and one of them is in the model: its thrust, torque \
                        and power are of one blade";
        assert!(
            input.remarks.iter().any(|remark| remark == expected),
            "{:?}",
            input.remarks
        );
    }

    #[test]
    fn an_inflow_without_blades_has_no_effect() {
        let text = rotor("blades = 3", &[3]).replacen("inflow = \"lift\"\n", "", 3);
        let remarks = read_beside(&text, &[]).unwrap().remarks;
        let expected = "inflow \"lift\" has no effect, since no blade and no strip refers to it";
        let has_it = |remarks: &[String]| remarks.iter().any(|one| one.starts_with(expected));
        assert!(has_it(&remarks), "{text}\n{remarks:?}");
        let sound = read_beside(&rotor("blades = 3", &[3]), &[]).unwrap();
        assert!(!has_it(&sound.remarks), "{:?}", sound.remarks);
    }

    #[test]
    fn a_span_without_air_is_remarked() {
        let remarks = |to: &str| {
            let text = rotor("blades = 3", &[1]).replace("{ at = 4,", to);
            read_beside(&text, &[]).unwrap().remarks
        };
        let short = remarks("{ at = 3,");
        let expected = "blade \"b0\": the stations are from 0 to 3 m of its 4 m, and the rest has no \
                        forces of the air: check the unit and the origin of the positions";
        assert!(short.iter().any(|remark| remark == expected), "{short:?}");
        let whole = remarks("{ at = 3.9,");
        assert!(
            !whole
                .iter()
                .any(|remark| remark.contains("the stations are")),
            "{whole:?}"
        );
    }

    #[test]
    fn wide_chords_and_dense_air_are_remarked() {
        let wide = rotor("blades = 3", &[1]).replace("chord = 0.3", "chord = 300");
        let remarks = read_beside(&(wide + "[air]\ndensity = 1225\n"), &[]);
        let remarks = remarks.unwrap().remarks;
        for expected in [
            "blade \"b0\": the chord is 300 m, more than the length of the blade, 4 m: check the unit",
            "[air]: the density is 1225 kg/m^3, more than of water: check the unit",
        ] {
            assert!(
                remarks.iter().any(|remark| remark == expected),
                "{remarks:?}"
            );
        }
        let sound = rotor("blades = 3", &[1]) + "[air]\ndensity = 1025\n";
        let remarks = read_beside(&sound, &[]).unwrap().remarks;
        assert!(
            !remarks
                .iter()
                .any(|remark| remark.contains("check the unit"))
        );
    }
}
