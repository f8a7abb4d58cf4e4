//! Problems of `[trim]`.

use shared_geom::error::{Explain, counted};

/// A problem of `[trim]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TrimProblem {
    /// Controls and targets differ in number.
    #[error(
        "[trim] has {} and {}, expected as many of each, at least one",
        counted(*controls, "control"),
        counted(*targets, "target")
    )]
    Counts {
        /// Number of controls.
        controls: usize,
        /// Number of targets.
        targets: usize,
    },
    /// No periodic motion.
    #[error("\"method\" is \"{method}\", which needs [periodic]")]
    NoPeriod {
        /// The method.
        method: &'static str,
    },
    /// A march of the periodic motion.
    #[error("the controls are found by shooting, but \"method\" of [periodic] is \"march\"")]
    Marched,
    /// Another analysis, which does not find the controls.
    #[error("[trim] with this \"method\" is beside [{card}], which does not find the controls")]
    Beside {
        /// The other card.
        card: &'static str,
    },
    /// A key of another method.
    #[error("\"{key}\" has no effect with this \"method\"")]
    Idle {
        /// The key.
        key: &'static str,
    },
    /// A first guess outside of the bounds.
    #[error("the first guess of \"{name}\" is {guess}, expected {}", range([*lower, *upper]))]
    Bounds {
        /// Name of the control.
        name: String,
        /// The guess.
        guess: f64,
        /// Least value.
        lower: f64,
        /// Largest value.
        upper: f64,
    },
    /// A guess of a parameter.
    #[error("\"guess\" of \"{name}\", whose value in [parameters] is the first guess")]
    GuessOfParameter {
        /// Name of the control.
        name: String,
    },
    /// A harmonic of an equilibrium.
    #[error("harmonic {harmonic} of an equilibrium, which does not change with time")]
    Harmonic {
        /// Its number.
        harmonic: usize,
    },
    /// A harmonic that the steps do not resolve.
    #[error("harmonic {harmonic} needs more than {} steps a period, and [periodic] has {steps}", 2 * harmonic)]
    Aliased {
        /// Its number.
        harmonic: usize,
        /// Steps of a period.
        steps: usize,
    },
    /// A cosine or sine of the mean.
    #[error("\"part\" without \"harmonic\": the target is the mean, which has no parts")]
    PartOfMean,
    /// A control without effect.
    #[error("no expression uses the control \"{name}\", so that no target depends on it")]
    Unused {
        /// Its name.
        name: String,
    },
    /// A sweep over a control.
    #[error("the sweep gives values to \"{name}\", which is a control too")]
    SweptControl {
        /// The name.
        name: String,
    },
}

/// The numbers between two bounds, of which one may be infinite, as text.
fn range([lower, upper]: [f64; 2]) -> String {
    match (lower.is_finite(), upper.is_finite()) {
        (true, true) => format!("a number between its bounds {lower} and {upper}"),
        (true, false) => format!("at least its bound {lower}"),
        _ => format!("at most its bound {upper}"),
    }
}

impl Explain for TrimProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Counts { .. } => "give each [[trim.control]] one [[trim.target]]",
            Self::NoPeriod { .. } => {
                "add [periodic] with the speed of the rotor, or write method = \"equilibrium\""
            }
            Self::Marched => "write method = \"autopilot\" in [trim], or leave out the march",
            Self::Beside { .. } => {
                "write the analyses into two files, which include the same model: replace the \
                 controls by parameters in the other one"
            }
            Self::Idle { key: "speed" } => "the speed of the periodic motion is in [periodic]",
            Self::Idle { .. } => "remove it, or write the method to which it belongs",
            Self::Bounds { .. } => "write lower < upper, and a guess between them",
            Self::GuessOfParameter { .. } => "change the parameter",
            Self::Harmonic { .. } => "use the mean, or method = \"shooting\"",
            Self::Aliased { .. } => {
                "give [periodic] several \"steps\" for each wave, or a lower harmonic"
            }
            Self::PartOfMean => "add harmonic = 1, once in a period, or remove \"part\"",
            Self::Unused { name } => {
                return Some(format!(
                    "use it, as in collective = \"{name}\" of [rotor.swashplate], or remove it with its \
                     target"
                ));
            }
            Self::SweptControl { .. } => "remove the control and its target, or the sweep",
        };
        Some(text.to_owned())
    }
}
