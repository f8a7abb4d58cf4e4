//! The keys of `[modes]` for names and figures: words, unit of frequency, multiples of the rotor
//! speed, speed of names.

use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Quantities, Quantity, Word};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::InputProblem;
use super::rotor_speed::{RPM, analyzed};
use crate::case::{FrequencyUnit, ModeStyle, Words};

/// Largest multiple of the rotor speed.
const HIGHEST: f64 = 1000.0;

keys! {
    /// Words for the motion of blades: lag, progressive, regressive; or edge, forward, backward. Beside a
    /// `[stability]` of a periodic motion it may be the only key of `[modes]`.
    pub(super) WORDS: usize = "words", [Word(&Words::NAMES)], or "\"rotor\"" = 0, "\"wind\"";
    /// Unit of frequencies in tables and figures; with `"rad/s"` rotor speeds are in it too.
    pub(super) FREQUENCY_UNIT: usize = "frequency_unit", [Word(&FrequencyUnit::NAMES)],
        or "\"Hz\"" = 0, "\"1/rev\"";
    /// Multiples of the rotor speed in figures and among the critical speeds.
    pub(super) HARMONICS: Option<Vec<f64>> = "harmonics", [Quantities(Dimension::NUMBER)],
        or "1 and multiples of the number of blades", "[1, 3, 6]";
    /// Speed, among `speeds`, at which modes are named.
    pub(super) NAME_AT: Option<f64> = "name_at", [Quantity(Dimension::ROTATION_SPEED)],
        or "the first speed", "\"300 rpm\"";
}

/// Reads the keys; `speeds` \[rad/s\] are the speeds of the analysis. `None` if one is wrong.
pub(super) fn read(table: &Table<'_>, speeds: Option<&[f64]>) -> Option<ModeStyle> {
    let words = table.get(&WORDS).map(|k| Words::ALL[k]);
    let unit = table.get(&FREQUENCY_UNIT).map(|k| FrequencyUnit::ALL[k]);
    let harmonics = if table.has(&HARMONICS) {
        harmonics(table)
    } else {
        Some(Vec::new())
    };
    let name_at = if table.has(&NAME_AT) {
        name_at(table, speeds).map(Some)
    } else {
        Some(None)
    };
    Some(ModeStyle {
        words: words?,
        unit: unit?,
        harmonics: harmonics?,
        name_at: name_at?,
    })
}

/// The multiples, ascending and without doubles.
fn harmonics(table: &Table<'_>) -> Option<Vec<u32>> {
    const KEY: &str = HARMONICS.name();
    let found = table.get(&HARMONICS)??;
    let is_multiple = |x: &f64| x.fract() == 0.0 && (1.0..=HIGHEST).contains(x);
    let wrong = found.iter().find(|number| !is_multiple(number));
    if let Some(&found) = wrong {
        table.note(KEY, &InputProblem::NoMultiple { found });
        return None;
    }
    if found.is_empty() {
        table.wrong(KEY, "at least one multiple of the rotor speed");
        return None;
    }
    let mut multiples: Vec<_> = found.iter().map(|number| *number as u32).collect();
    multiples.sort_unstable();
    multiples.dedup();
    Some(multiples)
}

/// The speed of names, among `speeds`.
fn name_at(table: &Table<'_>, speeds: Option<&[f64]>) -> Option<f64> {
    const KEY: &str = NAME_AT.name();
    let wanted = table.get(&NAME_AT)??;
    let (found, nearest) = analyzed(speeds?, wanted)?;
    if found {
        return Some(nearest);
    }
    let [rpm, nearest] = [wanted, nearest].map(|speed| speed / RPM);
    let key = KEY;
    table.note(KEY, &InputProblem::ShapeSpeed { key, rpm, nearest });
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use shared_geom::document::Document;

    fn style(text: &str) -> Result<ModeStyle, String> {
        let document = Document::parse(&format!("[modes]\n{text}"), "a.toml").unwrap();
        let style = {
            let root = document.root();
            let table = root.require_table("modes", "").unwrap();
            let style = read(&table, Some(&[0.0, 100.0 * RPM]));
            table.finish();
            style
        };
        document
            .finish(style)
            .map_err(|problems| problems.to_string())
    }

    #[test]
    fn words_units_multiples_and_the_speed_of_names_are_chosen() {
        assert_eq!(style("").unwrap(), ModeStyle::default());
        let all = "words = \"wind\"\nfrequency_unit = \"1/rev\"\nharmonics = [6, 1, 3, 3]\n\
                   name_at = \"100 rpm\"";
        let expected = ModeStyle {
            words: Words::Wind,
            unit: FrequencyUnit::PerRevolution,
            harmonics: vec![1, 3, 6],
            name_at: Some(100.0 * RPM),
        };
        assert_eq!(style(all).unwrap(), expected);
    }

    #[test]
    fn wrong_styles_are_reported_all_at_once() {
        let shown =
            style("words = \"edge\"\nfrequency_unit = \"hz\"\nharmonics = [1, 2.5]\nname_at = 70")
                .unwrap_err();
        for expected in [
            "\"words\" is \"edge\", expected one of",
            "\"frequency_unit\" is \"hz\"",
            "\"harmonics\" has 2.5, expected whole numbers from 1 to 1000",
            "\"name_at\" has the speed 70 rpm, expected some of \"speeds\"\n  help: the nearest is 100 rpm",
        ] {
            assert!(shown.contains(expected), "{expected}: {shown}");
        }
        assert!(style("harmonics = []").is_err());
        assert!(style("harmonics = [0]").unwrap_err().contains("has 0"));
    }
}
