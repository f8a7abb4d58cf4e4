//! The requested stability over a parameter: `[stability]`.

use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Boolean, Count, Positive, Word};
use shared_geom::error::Explain;
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::Input;
use super::mode_style::WORDS as MODE_WORDS;
use super::rotor_speed::RPM;
use super::sweep::{self, FROM, PARAMETER, STEPS, TO, VALUES};
use crate::case::{
    ModesSettings, PeriodicSettings, StabilityMethod, StabilitySettings, TrimMethod, TrimSettings,
    Words,
};

/// Largest number of roots: the dimension of the space of multipliers.
const MOST: usize = 400;
/// Relative difference up to which two rotor speeds are the same.
const SAME: f64 = 1e-12;

keys! {
    /// Roots over a parameter: growth, frequency, and the boundaries of stability.
    pub(super) STABILITY = "[stability]";
    /// Small motions about the equilibrium of `[modes]`, or about the periodic motion of
    /// `[periodic]`: by its multipliers, or by multiblade coefficients averaged over it.
    BY: usize = "by", [Word(&["modes", "Floquet", "averaged"])], or "\"modes\"" = 0, "\"Floquet\"";
    /// Whether to search the boundaries of stability between the values.
    BOUNDARIES: bool = "boundaries", [Boolean], or "true" = true, "false";
    /// Largest error of a boundary, as a part of the range of the values.
    TOLERANCE: f64 = "tolerance", [Positive(Dimension::NUMBER)], or "1e-8" = 1e-8, "1e-6";
    /// Roots, the least damped first; a pair counts as two. Without it: the modes of `[modes]`,
    /// all multipliers larger than 0.9 and at least ten, or of averaged equations the twenty lowest
    /// oscillations and all other roots that were found and decay by less than a factor exp(2 pi) in
    /// a revolution.
    ROOTS: Option<usize> = "count", [Count(MOST)], optional, "12";
    /// Words in the names of modes: lag, progressive, regressive; or edge, forward, backward.
    WORDS: Option<usize> = "words", [Word(&Words::NAMES)], or "the words of `[modes]`", "\"wind\"";
    with PARAMETER.schema, VALUES.schema, FROM.schema, TO.schema, STEPS.schema;
}

/// A problem of `[stability]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StabilityProblem {
    /// The analysis of one value is missing.
    #[error("\"by\" is \"{by}\", which needs [{card}]")]
    NoAnalysis {
        /// The word of the method.
        by: &'static str,
        /// The card that defines the analysis of one value.
        card: &'static str,
    },
    /// Several rotor speeds.
    #[error("\"by\" is \"modes\", but [modes] has {count} speeds, expected one")]
    Speeds {
        /// Their number.
        count: usize,
    },
    /// Modes of a trim at another speed.
    #[error(
        "[modes] has the speed {} rpm, but the equilibrium of [trim] has {} rpm, expected the same",
        .modes / RPM, .trim / RPM
    )]
    OtherSpeed {
        /// Of `[modes]` [rad/s].
        modes: f64,
        /// Of `[trim]` [rad/s].
        trim: f64,
    },
    /// Multiblade coordinates without a speed of the rotor.
    #[error("\"by\" is \"averaged\", but [periodic] has no \"speed\" of a rotor")]
    NoSpeed,
    /// Values that turn back.
    #[error(
        "the values are {first} and then {second}, expected values that all increase or all decrease"
    )]
    NotInOrder {
        /// A value [unit of the parameter].
        first: f64,
        /// The value after it [unit of the parameter].
        second: f64,
    },
    /// The parameter is a control.
    #[error("the parameter \"{name}\" is a control of [trim] too")]
    Control {
        /// Its name.
        name: String,
    },
}

impl Explain for StabilityProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::NoAnalysis { card: "modes", .. } => {
                "add [modes] with speeds = [300], or write by = \"Floquet\""
            }
            Self::NoAnalysis { .. } => {
                "add [periodic] with the speed of the rotor, or write by = \"modes\""
            }
            Self::Speeds { .. } => {
                "write one speed; to vary it, make it an expression of the parameter: \
                 speeds = [\"= rpm\"]"
            }
            Self::OtherSpeed { .. } => "write one speed in both, or one parameter for both",
            Self::NotInOrder { .. } => "sort the values, and write each once",
            Self::NoSpeed => "write the \"speed\" of the rotor in place of \"period\"",
            Self::Control { .. } => {
                "remove the control and its target, or choose another parameter"
            }
        };
        Some(text.to_owned())
    }
}

/// The other analyses of the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Others<'a> {
    pub modes: Option<&'a ModesSettings>,
    pub periodic: Option<&'a PeriodicSettings>,
    pub trim: Option<&'a TrimSettings>,
}

impl Input {
    /// Words for the motion of blades: of `[stability]`, of `[modes]`, or else of rotors.
    pub fn words(&self) -> Words {
        let own = self.stability.as_ref().and_then(|own| own.words);
        let style = self.modes.as_ref().map(|own| own.style.words);
        own.or(style).unwrap_or_default()
    }
}

/// The words of a `[modes]` without anything else, beside a `[stability]` of a periodic motion, which needs no
/// modes; `None` otherwise.
pub(super) fn words_alone(root: &Table<'_>) -> Option<Words> {
    let table = |key: &str| root.is_table(key).then(|| root.table(key))?;
    let stability = table("stability").filter(|own| own.is_text(&BY))?;
    let by = stability.text(BY.name())?;
    let modes = table("modes").filter(|modes| modes.keys() == [MODE_WORDS.name()])?;
    if by == "modes" {
        return None;
    }
    let words = modes.get(&MODE_WORDS);
    modes.finish();
    words.map(|words| Words::ALL[words])
}

/// Reads `[stability]` of a file with other analyses; `Some(None)` without the card.
pub(super) fn read(root: &Table<'_>, others: Others<'_>) -> Option<Option<StabilitySettings>> {
    if !root.has("stability") {
        return Some(None);
    }
    let table = root.table("stability")?;
    let (by, boundaries) = (table.get(&BY), table.get(&BOUNDARIES));
    let (tolerance, count) = (table.get(&TOLERANCE), table.get(&ROOTS));
    let words = table.get(&WORDS);
    let sweep = sweep::read(&table);
    table.finish();
    let settings = StabilitySettings {
        sweep: sweep?,
        method: [
            StabilityMethod::Modes,
            StabilityMethod::Floquet,
            StabilityMethod::Averaged,
        ][by?],
        boundaries: boundaries?,
        tolerance: tolerance?,
        count: count?,
        words: words?.map(|k| Words::ALL[k]),
    };
    let problem = of_values(&settings).or_else(|| of_others(&settings, others));
    if let Some((key, problem)) = problem {
        table.note(key, &problem);
        return None;
    }
    Some(Some(settings))
}

/// The first problem of the values, and its key.
fn of_values(settings: &StabilitySettings) -> Option<(&'static str, StabilityProblem)> {
    let values = &settings.sweep.values;
    let rises = values.get(1) > values.first();
    let mut pairs = values.windows(2);
    let turned = pairs.find(|pair| pair[0] == pair[1] || (pair[1] > pair[0]) != rises)?;
    let (first, second) = (turned[0], turned[1]);
    Some(("", StabilityProblem::NotInOrder { first, second }))
}

/// The first problem with the other analyses of the file, and its key.
fn of_others(
    settings: &StabilitySettings,
    others: Others<'_>,
) -> Option<(&'static str, StabilityProblem)> {
    let trim = others.trim;
    let swept = &settings.sweep.parameter;
    if trim.is_some_and(|trim| trim.parameters.iter().any(|own| own.name == *swept)) {
        let name = swept.clone();
        return Some((PARAMETER.name(), StabilityProblem::Control { name }));
    }
    let missing = |by, card| Some((BY.name(), StabilityProblem::NoAnalysis { by, card }));
    match (settings.method, others.modes, others.periodic) {
        (StabilityMethod::Floquet, _, None) => missing("Floquet", "periodic"),
        (StabilityMethod::Floquet, ..) => None,
        (StabilityMethod::Averaged, _, None) => missing("averaged", "periodic"),
        (StabilityMethod::Averaged, _, Some(periodic)) => periodic
            .speed
            .is_none()
            .then_some((BY.name(), StabilityProblem::NoSpeed)),
        (StabilityMethod::Modes, None, _) => missing("modes", "modes"),
        (StabilityMethod::Modes, Some(modes), _) => {
            let &[speed] = &modes.speeds[..] else {
                let count = modes.speeds.len();
                return Some((BY.name(), StabilityProblem::Speeds { count }));
            };
            let trim = trim
                .filter(|trim| trim.method == TrimMethod::Equilibrium)?
                .speed;
            let is_same = (speed - trim).abs() <= SAME * speed.abs().max(trim.abs());
            let problem = StabilityProblem::OtherSpeed { modes: speed, trim };
            (!is_same).then_some((BY.name(), problem))
        }
    }
}
