//! The keys of `[[state_space]]`.

use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{
    Count, Drive, Drives, Lines, Quantities, Tables, Text, Texts, Word,
};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::sampled;

/// A linear system of states.
pub(in crate::input) const STATE_SPACE: TableSchema = TableSchema {
    title: "[[state_space]]",
    meaning: "A linear system of states x, inputs u and outputs y: `x' = A x + B u`, \
              `y = C x + D u`; with `sample_time` a sampled one.",
    keys: &[
        NAME.schema,
        INPUTS.schema,
        OUTPUTS.schema,
        START.schema,
        sampled::SAMPLE_TIME.schema,
        sampled::OFFSET.schema,
        sampled::DELAY.schema,
        sampled::LIMITS.schema,
        sampled::RATE_LIMITS.schema,
    ],
    families: &[
        Family {
            name: "matrices",
            meaning: "By matrices; a missing one is zero.",
            keys: &[A.schema, B.schema, C.schema, D.schema],
        },
        Family {
            name: "file",
            meaning: "By the matrices of a file.",
            keys: &[FILE.schema],
        },
        Family {
            name: "transfer function",
            meaning: "One input and one output by a transfer function.",
            keys: &[NUMERATOR.schema, DENOMINATOR.schema],
        },
        Family {
            name: "transfer functions",
            meaning: "Several inputs or outputs by transfer functions.",
            keys: &[TRANSFER.schema],
        },
    ],
};

keys! {
    /// Its name, for messages.
    pub(super) NAME: Option<String> = "name", [Text], or "`state space` and its number", "\"controller\"";
    /// Inputs: numbers, drives, names of sensors or outputs, and expressions.
    pub(super) INPUTS: ByHand = "inputs", [Drives(Dimension::NUMBER), Drive(Dimension::NUMBER)], required,
        "[\"tilt\"]";
    /// Names of the outputs, which expressions read, also in this card.
    pub(super) OUTPUTS: Vec<String> = "outputs", [Texts], required, "[\"torque\"]";
    /// A number for each state, or the steady states.
    pub(super) START: ByHand = "start", [Quantities(Dimension::NUMBER), Word(&["settled"])], or "zeros",
        "[0.1]";
    /// Matrix A; without it there are no states.
    pub(super) A: ByHand = "a", [Lines(0)], optional, "[[-1]]";
    /// Matrix B.
    pub(super) B: ByHand = "b", [Lines(0)], or "zero", "[[1]]";
    /// Matrix C.
    pub(super) C: ByHand = "c", [Lines(0)], or "zero", "[[2]]";
    /// Matrix D.
    pub(super) D: ByHand = "d", [Lines(0)], or "zero", "[[0.5]]";
    /// A TOML file with `a` to `d`; a relative path is relative to the folder of this file.
    pub(super) FILE: String = "file", [Text], required, "\"law.toml\"";
    /// The transfer functions.
    pub(super) TRANSFER: ByHand = "transfer", [Tables(&TRANSFER_FUNCTION)], required, "";
}

keys! {
    /// A transfer function of a coupled pair.
    TRANSFER_FUNCTION = "[[state_space.transfer]]";
    /// The number of the input, from 1.
    pub(super) INPUT: usize = "input", [Count(usize::MAX)], required, "1";
    /// The name of an output.
    pub(super) OUTPUT: String = "output", [Text], required, "\"torque\"";
    with NUMERATOR.schema, DENOMINATOR.schema;
}

keys! {
    /// Coefficients of descending powers of s, or of z if the system samples.
    pub(super) NUMERATOR: Vec<f64> = "numerator", [Quantities(Dimension::NUMBER)]
        as "a list of coefficients of decreasing powers of s", required, "[8.08, 37.31]";
    /// The same; not of a lower degree.
    pub(super) DENOMINATOR: Vec<f64> = "denominator", [Quantities(Dimension::NUMBER)]
        as "a list of coefficients of decreasing powers of s", required, "[0.01, 1]";
}
