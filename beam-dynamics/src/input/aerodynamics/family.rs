//! Airfoils of typed stations: by name, or by thickness among the airfoils of a family.

use rotor_aero::airfoil::{Blend, BlendProblem, Section};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Positive, Text, Texts};
use shared_geom::error::Explain;
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::airfoils::Airfoils;

keys! {
    /// Names of airfoils of different thickness, between which stations with `thickness` lie.
    pub(in crate::input) FAMILY: Option<Vec<String>> = "family", [Texts], optional,
        "[\"DU40\", \"DU21\"]";
    /// The airfoil of a station: a name of `[airfoils]`, or a built-in one; blended linearly to the
    /// next station.
    pub(in crate::input) AIRFOIL: Option<String> = "airfoil", [Text], optional, "\"DU21\"";
    /// Thickness over chord of a station, in place of `airfoil`: the mixture of the two airfoils of
    /// `family` between which it lies, linear in the thickness.
    pub(in crate::input) THICKNESS: Option<f64> = "thickness", [Positive(Dimension::NUMBER)],
        optional, "0.24";
}

/// A problem of a family, or of a station that has an airfoil by its thickness.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FamilyProblem {
    /// Neither an airfoil nor a thickness, or both.
    #[error("the station has {found}, expected one of \"airfoil\" and \"thickness\"")]
    Source {
        /// The keys found, as text.
        found: &'static str,
    },
    /// A thickness without a family.
    #[error("the station has \"thickness\", and its blade has no \"family\" of airfoils")]
    NoFamily,
    /// A family that no station uses.
    #[error("\"family\" has no effect: {reason}")]
    Unused {
        /// The reason, as text.
        reason: &'static str,
    },
    /// An airfoil of a family without a thickness.
    #[error("airfoil \"{airfoil}\" of \"family\" states no thickness over chord")]
    NoThickness {
        /// Its name.
        airfoil: String,
    },
    /// Two airfoils of one thickness.
    #[error(
        "airfoils \"{first}\" and \"{second}\" of \"family\" have the same thickness over chord"
    )]
    SameThickness {
        /// Name of the first one.
        first: String,
        /// Name of the second one.
        second: String,
    },
    /// A thickness that no two airfoils enclose.
    #[error("thickness over chord: {0}")]
    Blend(BlendProblem),
}

impl Explain for FamilyProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Source { .. } => Some("airfoil = \"DU21\", or thickness = 0.24".to_owned()),
            Self::NoFamily => Some("family = [\"DU40\", \"DU21\"], beside the stations".to_owned()),
            Self::Unused { .. } => Some("remove it".to_owned()),
            Self::NoThickness { airfoil } => {
                Some(format!("add \"thickness\" to [airfoils.{airfoil}]"))
            }
            Self::SameThickness { .. } => {
                Some("give each airfoil of a family a thickness of its own".to_owned())
            }
            Self::Blend(BlendProblem::OutOfRange { .. }) => {
                Some("add an airfoil of this thickness or beyond it to the family".to_owned())
            }
            Self::Blend(problem) => problem.help(),
        }
    }
}

/// Airfoils in the order of their thickness.
#[derive(Debug)]
pub(in crate::input) struct Family {
    /// Thickness over chord \[-\], and airfoil.
    profiles: Vec<(f64, Section)>,
    blend: Blend,
}

/// The airfoil of a station, and its thickness if this selects it \[-\].
pub(in crate::input) type OfStation = (Section, Option<f64>);

impl Family {
    /// The family of the stations of a table; `Some(None)` without one, `None` if it is wrong.
    pub fn read(table: &Table<'_>, airfoils: &Airfoils, user: &str) -> Option<Option<Self>> {
        let Some(names) = table.get(&FAMILY)? else {
            return Some(None);
        };
        let at = (table, FAMILY.name());
        let found = names.iter().map(|name| airfoils.find(name, at, user));
        let found: Vec<Option<Section>> = found.collect();
        let sections: Vec<Section> = found.into_iter().collect::<Option<_>>()?;
        let named = names.into_iter().zip(sections);
        let profiles = match profiles(named) {
            Ok(profiles) => profiles,
            Err(problem) => {
                table.note(&FAMILY, &problem);
                return None;
            }
        };
        // Single airfoils of different thickness make a blend.
        let airfoils = profiles
            .iter()
            .filter_map(|(_, section)| section.parts().next());
        let airfoils: Vec<_> = airfoils.map(|(_, airfoil)| airfoil.clone()).collect();
        let blend = Blend::by_thickness(&airfoils).ok()?;
        Some(Some(Self { profiles, blend }))
    }

    /// Sections between two stations, of which position \[m\] and thickness \[-\] are given, by the
    /// positions at which the mixture of two profiles changes.
    pub fn between(&self, ends: [[f64; 2]; 2]) -> Vec<(f64, Section)> {
        let profiles = self.profiles.iter();
        let profiles = profiles.filter_map(|(thickness, section)| {
            Some((position_between(*thickness, ends)?, section.clone()))
        });
        profiles.collect()
    }
}

/// Airfoils by their names with their thickness over chord \[-\].
fn profiles(
    named: impl Iterator<Item = (String, Section)>,
) -> Result<Vec<(f64, Section)>, FamilyProblem> {
    let mut found: Vec<(String, f64, Section)> = Vec::new();
    for (name, section) in named {
        let thickness = section.parts().next().and_then(|part| part.1.thickness());
        let Some(thickness) = thickness else {
            return Err(FamilyProblem::NoThickness { airfoil: name });
        };
        if let Some((first, ..)) = found.iter().find(|other| other.1 == thickness) {
            let (first, second) = (first.clone(), name);
            return Err(FamilyProblem::SameThickness { first, second });
        }
        found.push((name, thickness, section));
    }
    let profiles = found.into_iter();
    Ok(profiles
        .map(|(_, thickness, section)| (thickness, section))
        .collect())
}

/// Part of the distance of two stations that separates a profile between them from both.
const SAME: f64 = 1e-9;

/// The position between two stations, of which position \[m\] and thickness \[-\] are given, at which
/// the thickness is the one of a profile, if there is one.
pub(in crate::input) fn position_between(
    thickness: f64,
    [[start, from], [end, to]]: [[f64; 2]; 2],
) -> Option<f64> {
    let share = (thickness - from) / (to - from);
    (share > SAME && share < 1.0 - SAME).then_some(start + share * (end - start))
}

/// Reads the airfoil of a station.
pub(in crate::input) fn of_station(
    table: &Table<'_>,
    (airfoils, family): (&Airfoils, Option<&Option<Family>>),
    user: &str,
) -> Option<OfStation> {
    let (name, thickness) = (table.get(&AIRFOIL), table.get(&THICKNESS));
    let found = match (name?, thickness?) {
        (Some(name), None) => {
            let section = airfoils.find(&name, (table, AIRFOIL.name()), user)?;
            return Some((section, None));
        }
        (None, Some(thickness)) => {
            // A wrong family is reported already.
            let Some(family) = family? else {
                table.note(&THICKNESS, &FamilyProblem::NoFamily);
                return None;
            };
            return match family.blend.section(thickness) {
                Ok(section) => Some((section, Some(thickness))),
                Err(problem) => {
                    table.note(&THICKNESS, &FamilyProblem::Blend(problem));
                    None
                }
            };
        }
        (Some(_), Some(_)) => "both",
        (None, None) => "neither",
    };
    table.note("", &FamilyProblem::Source { found });
    None
}

/// Notes a family that no station uses.
pub(in crate::input) fn note_unused(
    table: &Table<'_>,
    family: Option<&Option<Family>>,
    used: bool,
) {
    if matches!(family, Some(Some(_))) && !used {
        let reason = "no station has \"thickness\"";
        table.note(&FAMILY, &FamilyProblem::Unused { reason });
    }
}

/// Notes a family beside a file of stations; whether there is one.
pub(in crate::input) fn note_beside_file(table: &Table<'_>) -> bool {
    let is_given = table.has(&FAMILY);
    if is_given {
        let reason = "it belongs to \"stations\", and \"file\" has its own airfoils";
        table.note(&FAMILY, &FamilyProblem::Unused { reason });
    }
    is_given
}

#[cfg(test)]
mod tests {
    use crate::input::test_files::{STRIP, read_beside, reported};

    /// A table without a thickness.
    const TABLE: &str =
        "alpha [deg],cl,cd,cm\n-180,0,0.1,0\n-10,-1,0.1,0\n10,1,0.1,0\n180,0,0.1,0\n";

    /// The problems of a blade with lines of its strips, and airfoils of .2 and .3.
    fn problems(lines: &str) -> String {
        let airfoils = "[airfoils.a]\nslope = 5\nthickness = 0.2\n[airfoils.b]\nslope = 6\n\
                        thickness = 0.3\n[airfoils.c]\nfile = \"c.csv\"\n";
        let text = format!(
            "units = \"SI\"\n{airfoils}{STRIP}[[blade]]\nname = \"b\"\nproperties = \"strip\"\n\
             piece = [{{ length = 4, elements = 1 }}]\n[blade.aerodynamics]\n{lines}[static]\n"
        );
        reported(read_beside(&text, &[("c.csv", TABLE)]))
    }

    const FAMILY: &str = "family = [\"a\", \"b\"]\n";
    const A: &str = "airfoil = \"a\"";

    fn stations(first: &str, second: &str) -> String {
        format!(
            "stations = [{{ at = 0, chord = 0.3, {first} }}, {{ at = 4, chord = 0.3, {second} }}]\n"
        )
    }

    #[test]
    fn wrong_stations_have_remedies() {
        let both = "airfoil = \"DU21\", or thickness = 0.24";
        for (family, second, expected, help) in [
            (
                "",
                "airfoil = \"a\", thickness = 0.2",
                "the station has both, expected one of \"airfoil\" and \"thickness\"",
                both,
            ),
            (
                "",
                "twist = 2",
                "the station has neither, expected one of \"airfoil\" and \"thickness\"",
                both,
            ),
            (
                "",
                "thickness = 0.2",
                "the station has \"thickness\", and its blade has no \"family\" of airfoils",
                "family = [\"DU40\", \"DU21\"], beside the stations",
            ),
            (
                FAMILY,
                "thickness = 0.4",
                "thickness over chord: no airfoil at 0.4: the airfoils are from 0.2 to 0.3",
                "add an airfoil of this thickness or beyond it to the family",
            ),
            (
                FAMILY,
                A,
                "\"family\" has no effect: no station has \"thickness\"",
                "remove it",
            ),
        ] {
            let shown = problems(&(family.to_owned() + &stations(A, second)));
            for words in [expected, help] {
                assert!(shown.contains(words), "{words}\n{shown}");
            }
            assert_eq!(shown.matches("error:").count(), 1, "{shown}");
        }
    }

    #[test]
    fn wrong_families_have_remedies() {
        for (second, expected, help) in [
            (
                "c",
                "airfoil \"c\" of \"family\" states no thickness over chord",
                "add \"thickness\" to [airfoils.c]",
            ),
            (
                "a",
                "airfoils \"a\" and \"a\" of \"family\" have the same thickness over chord",
                "give each airfoil of a family a thickness of its own",
            ),
            (
                "d",
                "unknown airfoil \"d\" in blade \"b\"",
                "known: a, b, c",
            ),
        ] {
            let family = format!("family = [\"a\", \"{second}\"]\n");
            let shown = problems(&(family + &stations(A, "thickness = 0.2")));
            for words in [expected, help] {
                assert!(shown.contains(words), "{words}\n{shown}");
            }
            assert_eq!(shown.matches("error:").count(), 1, "{shown}");
        }
        let shown = problems(&format!("{FAMILY}file = \"a.dat\"\n"));
        let expected = "\"family\" has no effect: it belongs to \"stations\", and \"file\" has its own airfoils";
        assert!(shown.contains(expected), "{shown}");
    }

    #[test]
    fn rotor_files_have_families() {
        let rotor = format!("units = \"SI\"\n[rotor]\nblades = 2\n{FAMILY}");
        let rotor = rotor
            + "stations = [{ r = 1, chord = 0.3, thickness = 0.2 }, { r = 4, chord = 0.3, thickness = 0.5 }]\n\
               [airfoils.a]\nslope = 5\nthickness = 0.2\n[airfoils.b]\nslope = 6\nthickness = 0.3\n\
               [[sweep]]\nspeed = 8\nrotor_speed = 10\n";
        let found = crate::input::parse_rotor(&rotor, "a.rotor.toml");
        let shown = found.map(|_| ()).unwrap_err().to_string();
        let expected = "thickness over chord: no airfoil at 0.5: the airfoils are from 0.2 to 0.3";
        assert!(shown.contains(expected), "{shown}");
        let found = crate::input::parse_rotor(&rotor.replace("0.5", "0.3"), "a.rotor.toml");
        assert!(found.is_ok(), "{:?}", found.err());
    }
}
