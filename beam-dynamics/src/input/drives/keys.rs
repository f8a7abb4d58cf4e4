//! The keys of drives, by their kinds.

use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{
    Count, Drives, Free, Lines, Positive, Quantity, Text, Texts, Vector, Word,
};
use shared_geom::document::schema::{Family, KeySchema, Need, TableSchema, key};
use shared_geom::units::Dimension;

use super::measure::Measure;
use shared_geom::{choice, keys};

/// Default number of sines of a random drive.
const DEFAULT_TERMS: usize = 64;
/// Largest number of sines of a random drive.
const MOST_TERMS: usize = 10_000;

/// The key that distinguishes the families, and its meaning.
pub(super) const KIND: [&str; 2] = ["kind", "Kind of the drive."];

/// A drive: a number that changes with time.
pub(in crate::input) const DRIVE: TableSchema = TableSchema {
    title: "[drives.NAME]",
    meaning: "A number that changes with time, used by its name or written as a table in place \
              of a number. Its numbers are in the unit of the key that uses it, or in its `unit`.",
    keys: &[UNIT.schema],
    families: &[
        Family {
            name: "constant",
            meaning: "A constant.",
            keys: &[choice!(KIND, "constant"), VALUE.schema],
        },
        Family {
            name: "ramp",
            meaning: "From one value to another, constant before and after.",
            keys: &[
                choice!(KIND, "ramp"),
                FROM.schema,
                TO.schema,
                START.schema,
                END.schema,
                RAMP_DURATION.schema,
                SHAPE.schema,
            ],
        },
        Family {
            name: "step",
            meaning: "A jump.",
            keys: &[choice!(KIND, "step"), FROM.schema, TO.schema, TIME.schema],
        },
        Family {
            name: "harmonic",
            meaning: "A sine; constant before the start and after the last cycle.",
            keys: &[
                choice!(KIND, "harmonic"),
                MEAN.schema,
                AMPLITUDE.schema,
                FREQUENCY.schema,
                PHASE.schema,
                START.schema,
                CYCLES.schema,
            ],
        },
        Family {
            name: "doublet",
            meaning: "Up for half of the duration, down for the other half.",
            keys: &[
                choice!(KIND, "doublet"),
                AMPLITUDE.schema,
                START.schema,
                DURATION.schema,
            ],
        },
        Family {
            name: "table",
            meaning: "Values at times, of a CSV file or of rows.",
            keys: &[
                choice!(KIND, "table"),
                FILE.schema,
                COLUMNS.schema,
                ROWS.schema,
                INTERPOLATION.schema,
                OUTSIDE.schema,
            ],
        },
        Family {
            name: "expression",
            meaning: "A function of the time `t`.",
            keys: &[KIND_OF_EXPRESSION, EXPRESSION.schema],
        },
        Family {
            name: "sum",
            meaning: "A sum of drives.",
            keys: &[choice!(KIND, "sum"), SUMMANDS.schema],
        },
        Family {
            name: "product",
            meaning: "A product of drives.",
            keys: &[choice!(KIND, "product"), FACTORS.schema],
        },
        Family {
            name: "random in a band",
            meaning: "A sum of sines of random frequencies and phases.",
            keys: &[
                choice!(KIND, "random"),
                MEAN.schema,
                DEVIATION.schema,
                SEED.schema,
                BAND.schema,
                TERMS.schema,
            ],
        },
        Family {
            name: "random at intervals",
            meaning: "Independent random values, with straight pieces between them.",
            keys: &[
                choice!(KIND, "random"),
                MEAN.schema,
                DEVIATION.schema,
                SEED.schema,
                INTERVAL.schema,
            ],
        },
    ],
};

/// The kind of an expression, which the key `expression` implies.
const KIND_OF_EXPRESSION: KeySchema = key(
    "kind",
    &[Word(&["expression"])],
    Need::Default("implied"),
    "\"expression\"",
    "Kind of the drive.",
);

keys! {
    /// Unit of its numbers, only of named drives: the keys that use it must have its dimension.
    pub(super) UNIT: Measure = "unit", [Text], or "the unit of the key" = Measure::Plain, "\"kN\"";
    /// The value.
    pub(super) VALUE: ByHand = "value", [Free], required, "3";
    /// Value before.
    pub(super) FROM: ByHand = "from", [Free], or "0", "0";
    /// Value after.
    pub(super) TO: ByHand = "to", [Free], required, "3";
    /// Time of the beginning.
    pub(super) START: f64 = "start", [Quantity(Dimension::TIME)], or "0" = 0.0, "1";
    /// Time of the end of a ramp; either this or `duration`.
    pub(super) END: Option<f64> = "end", [Quantity(Dimension::TIME)], optional, "2";
    /// Time from start to end; either this or `end`.
    pub(super) RAMP_DURATION: Option<f64> = "duration", [Quantity(Dimension::TIME)], optional, "1";
    /// Shape of a ramp: the first and second derivatives of the smooth one vanish at both ends.
    pub(super) SHAPE: usize = "shape", [Word(&["linear", "smooth"])], or "\"linear\"" = 0, "\"smooth\"";
    /// Time of the jump.
    pub(super) TIME: f64 = "time", [Quantity(Dimension::TIME)], required, "1";
    /// Mean value.
    pub(super) MEAN: ByHand = "mean", [Free], or "0", "1";
    /// Amplitude.
    pub(super) AMPLITUDE: ByHand = "amplitude", [Free], required, "5";
    /// Frequency.
    pub(super) FREQUENCY: f64 = "frequency", [Positive(Dimension::FREQUENCY)], required, "0.5";
    /// Phase at the start.
    pub(super) PHASE: f64 = "phase", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "-90";
    /// Number of cycles.
    pub(super) CYCLES: f64 = "cycles", [Positive(Dimension::NUMBER)], or "unlimited" = f64::INFINITY, "3";
    /// Length in time.
    pub(super) DURATION: f64 = "duration", [Positive(Dimension::TIME)], required, "2";
    /// A CSV file with a heading, in place of `rows`.
    pub(super) FILE: Option<String> = "file", [Text], optional, "\"gust.csv\"";
    /// Columns of the file, of the times and of the values.
    pub(super) COLUMNS: Option<Vec<String>> = "columns", [Texts], or "the first two", "[\"time\", \"thrust\"]";
    /// Rows of a time and a value, in place of `file`.
    pub(super) ROWS: ByHand = "rows", [Lines(2)], optional, "[[0, 0], [1, 50]]";
    /// Interpolation between the rows.
    pub(super) INTERPOLATION: usize = "interpolation", [Word(&["linear", "spline"])], or "\"linear\"" = 0,
        "\"spline\"";
    /// Beyond the rows: an error, or the first and the last value.
    pub(super) OUTSIDE: usize = "outside", [Word(&["error", "hold"])], or "\"error\"" = 0, "\"hold\"";
    /// Expression of `t` in the declared unit of time, and of parameters.
    pub(super) EXPRESSION: ByHand = "expression", [Text], required, "\"3*sin(2*pi*t)\"";
    /// The summands.
    pub(super) SUMMANDS: ByHand = "terms", [Drives(Dimension::NUMBER)], required, "[\"swing\", 2]";
    /// The factors, the first in the unit of the key, the others pure numbers.
    pub(super) FACTORS: ByHand = "factors", [Drives(Dimension::NUMBER)], required, "[\"swing\", \"= exp(-t)\"]";
    /// Standard deviation, zero or more.
    pub(super) DEVIATION: ByHand = "deviation", [Free], required, "2";
    /// Seed of the random numbers: equal seeds give equal values.
    pub(super) SEED: usize = "seed", [Count(usize::MAX)], required, "7";
    /// Lowest and highest frequency.
    pub(super) BAND: [f64; 2] = "band", [Vector(2, Dimension::FREQUENCY)], required, "[0.1, 2]";
    /// Number of sines.
    pub(super) TERMS: usize = "terms", [Count(MOST_TERMS)], or "64" = DEFAULT_TERMS, "128";
    /// Time between independent values.
    pub(super) INTERVAL: f64 = "interval", [Positive(Dimension::TIME)], required, "0.5";
}
