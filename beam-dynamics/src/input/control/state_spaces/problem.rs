//! Problems of systems of states.

use shared_geom::error::Explain;

/// A problem of a `[[state_space]]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StateSpaceProblem {
    /// The system is not given, or in several ways.
    #[error("the system is given by {}, expected one way", in_words(.given))]
    Ways {
        /// The ways found.
        given: Vec<&'static str>,
    },
    /// A transfer function between more than two signals.
    #[error(
        "\"numerator\" and \"denominator\" connect one input and one output, and there are {} \
         inputs and {} outputs", .found[0], .found[1]
    )]
    NotSingle {
        /// Numbers of inputs and outputs.
        found: [usize; 2],
    },
    /// A transfer function that grows with the frequency, or divides by zero.
    #[error(
        "\"numerator\" has {} coefficients and \"denominator\" {}, expected at most as many as in \
         the denominator, the first of which is not zero", .degrees[0], .degrees[1]
    )]
    Improper {
        /// Numbers of coefficients.
        degrees: [usize; 2],
    },
    /// A number of initial values that differs from the number of states.
    #[error("\"start\" has {found} numbers, and the system {states} states")]
    Starts {
        /// Number of values under the key.
        found: usize,
        /// Number of states of the system.
        states: usize,
    },
    /// A system that samples, without an initial equilibrium.
    #[error("a system with \"sample_time\" starts from numbers, found \"settled\"")]
    Sampled,
    /// A key for systems that sample.
    #[error("\"{key}\" applies to systems that sample, but there is no \"sample_time\"")]
    NotSampled {
        /// The key.
        key: &'static str,
    },
    /// A sample time that is too short for a run.
    #[error("\"sample_time\" gives {samples:.1e} samples in the run, expected at most 1e8")]
    ManySamples {
        /// Number of samples of the run.
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
                "coefficients are in order of decreasing powers of s; add a small time constant \
                 to the denominator if the numerator differentiates"
            }
            Self::Starts { .. } => "leave out \"start\" for zeros, or write start = \"settled\"",
            Self::Sampled => {
                "give numbers: the states before the first sample, or leave out \"start\" for zeros"
            }
            Self::NotSampled { .. } => "add \"sample_time\", or leave the key out",
            Self::ManySamples { .. } => {
                "sample less often, or leave out \"sample_time\": a system of \
                                         continuous states resolves fast changes"
            }
            Self::Doubled { .. } => "add both in one",
        };
        Some(text.to_owned())
    }
}
