//! What can be wrong with systems of states.

use shared_geom::error::Explain;

/// A problem of a `[[state_space]]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StateSpaceProblem {
    /// The system is given in no way, or in several.
    #[error("the system is given by {}, expected one way", in_words(.given))]
    Ways {
        /// The ways that are there.
        given: Vec<&'static str>,
    },
    /// A transfer function between more than two signals.
    #[error(
        "\"numerator\" and \"denominator\" lead from one input to one output, and there are {} \
         inputs and {} outputs", .found[0], .found[1]
    )]
    NotSingle {
        /// Numbers of inputs and outputs.
        found: [usize; 2],
    },
    /// A transfer function that grows with the frequency, or divides by zero.
    #[error(
        "\"numerator\" has {} coefficients and \"denominator\" {}, expected no more than in the \
         denominator, the first of which is not zero", .degrees[0], .degrees[1]
    )]
    Improper {
        /// Numbers of coefficients.
        degrees: [usize; 2],
    },
    /// Another number of starts than of states.
    #[error("\"start\" has {found} numbers, and the system {states} states")]
    Starts {
        /// Numbers under the key.
        found: usize,
        /// States of the system.
        states: usize,
    },
    /// A system that samples has no rest of its own.
    #[error("a system with \"sample_time\" starts from numbers, found \"settled\"")]
    Sampled,
    /// A key of systems that sample.
    #[error("\"{key}\" is of systems that sample, and there is no \"sample_time\"")]
    NotSampled {
        /// The key.
        key: &'static str,
    },
    /// A sample time that no run can take.
    #[error("\"sample_time\" makes {samples:.1e} samples in the run, expected 1e8 at most")]
    ManySamples {
        /// Samples of the run.
        samples: f64,
    },
    /// Two transfer functions between the same signals.
    #[error("there is a transfer function from this input to this output already ({line})")]
    Doubled {
        /// Line of the first.
        line: String,
    },
}

fn in_words(given: &[&str]) -> String {
    match given {
        [] => "nothing".to_owned(),
        given => given.join(" and "),
    }
}

impl Explain for StateSpaceProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Ways { .. } => {
                "give matrices \"a\" to \"d\", or a \"file\" with them, or \"numerator\" and \
                 \"denominator\", or [[state_space.transfer]]"
            }
            Self::NotSingle { .. } => "write a [[state_space.transfer]] for each input and output",
            Self::Improper { .. } => {
                "coefficients stand by falling powers of s; add a small time constant to the \
                 denominator where the numerator differentiates"
            }
            Self::Starts { .. } => "leave out \"start\" for zeros, or write start = \"settled\"",
            Self::Sampled => {
                "give its states before the first sample, or leave out \"start\" for zeros"
            }
            Self::NotSampled { .. } => "add \"sample_time\", or leave the key out",
            Self::ManySamples { .. } => {
                "sample less often, or leave out \"sample_time\": a system of \
                                         states of its own resolves what is quick"
            }
            Self::Doubled { .. } => "add both into one",
        };
        Some(text.to_owned())
    }
}
