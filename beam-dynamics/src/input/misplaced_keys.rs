//! Keys in the wrong table or by another name, and the right ones.

/// Keys of other cards that are written at the top of a file by mistake.
pub(super) const OF_FILE: [(&str, &str); 32] = [
    ("duration", "\"to\" in [transient]"),
    ("dt", "\"step\" in [transient]"),
    ("rpm", SPEEDS),
    ("omega", SPEEDS),
    ("rotation_speed", SPEEDS),
    ("rotor_speed", SPEEDS),
    ("speed", SPEEDS),
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

/// Keys of `[[node]]` by names of other cards and programs.
pub(super) const OF_NODE: [(&str, &str); 7] = [
    ("at", "\"position\""),
    ("point", "\"position\""),
    ("coordinates", "\"position\""),
    ("location", "\"position\""),
    ("x", "position = [x, y, z]"),
    ("rotation", "\"orientation\", a rotation vector"),
    ("axes", "\"orientation\", a rotation vector"),
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
pub(super) const OF_TRANSIENT: [(&str, &str); 29] = [
    ("start_time", "\"from\", the first instant"),
    ("t_start", "\"from\", the first instant"),
    ("t0", "\"from\", the first instant"),
    ("duration", LAST),
    ("end", LAST),
    ("end_time", LAST),
    ("final_time", LAST),
    ("stop", LAST),
    ("stop_time", LAST),
    ("t_end", LAST),
    ("tmax", LAST),
    ("time", LAST),
    ("dt", "\"step\""),
    ("timestep", "\"step\""),
    ("time_step", "\"step\""),
    ("step_size", "\"step\""),
    ("integrator", "\"scheme\""),
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
    ("rho_inf", "\"radius\""),
];
/// The key of the last instant.
const LAST: &str = "\"to\", the last instant";

/// Keys of `[modes]` by names of other programs.
pub(super) const OF_MODES: [(&str, &str); 9] = [
    ("speed", "\"speeds\""),
    ("rpm", "\"speeds\", as in speeds = [0, \"300 rpm\"]"),
    ("omega", "\"speeds\""),
    ("rotor_speed", "\"speeds\""),
    ("rotor_speeds", "\"speeds\""),
    ("number", "\"count\""),
    ("modes", "\"count\""),
    ("n_modes", "\"count\""),
    ("damping", "\"damping_ratio\""),
];

/// Keys of `[gravity]` by names of other programs.
pub(super) const OF_GRAVITY: [(&str, &str); 4] = [
    ("g", ACCELERATION),
    ("value", ACCELERATION),
    ("vector", ACCELERATION),
    ("direction", ACCELERATION),
];
/// The key of gravity.
const ACCELERATION: &str = "acceleration = [0, 0, -9.81]";

/// Keys of `[output]` by names of other programs.
pub(super) const OF_OUTPUT: [(&str, &str); 5] = [
    ("dt", "\"every\", a number of steps or a time with its unit"),
    (
        "interval",
        "\"every\", a number of steps or a time with its unit",
    ),
    (
        "step",
        "\"every\", a number of steps or a time with its unit",
    ),
    ("columns", "[[output.column]]"),
    ("vtk", "\"vtu\""),
];
