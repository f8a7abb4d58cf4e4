//! Keys in the wrong table, and the right tables.

/// Keys of other cards that are written at the top of a file by mistake.
pub(super) const OF_FILE: [(&str, &str); 25] = [
    ("mode", "[modes]"),
    ("statics", "[static]"),
    ("column", "[[output.column]]"),
    ("columns", "[[output.column]]"),
    ("piece", "[[blade.piece]]"),
    ("sensor", "[sensors.NAME]"),
    ("drive", "[drives.NAME]"),
    ("property", "[properties.NAME]"),
    ("force", "[[load]] with \"force\""),
    ("moment", "[[load]] with \"moment\""),
    ("support", "\"support\" in [hub]"),
    ("speeds", "\"speeds\" in [modes]"),
    ("from", "\"from\" in [transient]"),
    ("to", "\"to\" in [transient]"),
    ("step", "\"step\" in [transient]"),
    ("scheme", "\"scheme\" in [transient]"),
    ("radius", "\"radius\" in [transient]"),
    ("newton", "\"newton\" in [transient]"),
    ("redundant", "\"redundant\" in [transient]"),
    ("every", "\"every\" in [output]"),
    ("restart_every", "\"restart_every\" in [output]"),
    ("vtu", "\"vtu\" in [output]"),
    ("acceleration", "\"acceleration\" in [gravity]"),
    ("law", "\"law\" in [[spring]], [[rod]] or [[beam]]"),
    ("mass", "\"mass\" in [[body]], or [[blade.mass]]"),
];

/// Keys of other cards that are written in `[hub]` by mistake.
pub(super) const OF_HUB: [(&str, &str); 4] = [
    ("speed", SPEEDS),
    ("speeds", SPEEDS),
    ("rpm", SPEEDS),
    ("omega", SPEEDS),
];
/// The keys of rotor speeds.
const SPEEDS: &str = "\"speeds\" in [modes], or \"speed\" in [static] or [transient]";

/// Keys of other cards that are written in `[transient]` by mistake.
pub(super) const OF_TRANSIENT: [(&str, &str); 11] = [
    ("every", "\"every\" in [output]"),
    ("restart_every", "\"restart_every\" in [output]"),
    ("vtu", "\"vtu\" in [output]"),
    ("first", "step = { first = ... }"),
    ("least", "step = { first = ..., least = ... }"),
    ("most", "step = { first = ..., most = ... }"),
    (
        "tolerance",
        "step = { first = ..., tolerance = ... }, or newton = { tolerance = ... }",
    ),
    ("iterations", "newton = { iterations = ... }"),
    ("method", "newton = { method = ... }"),
    ("column", "[[output.column]]"),
    ("rho", "\"radius\""),
];
