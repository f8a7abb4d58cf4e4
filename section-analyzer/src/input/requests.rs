//! Requests for further results of a section.

use shared_geom::document::schema::ValueKind::{Count, Word};
use shared_geom::keys;
use shared_geom::section::StrainMeasure;

/// Largest number of end effects.
const MOST_END_EFFECTS: usize = 20;

keys! {
    /// Number of decaying solutions to find, beginning with the slowest decay from an end or a
    /// jump; this takes several times as long as the analysis.
    pub(super) END_EFFECTS: Option<usize> = "end_effects", [Count(MOST_END_EFFECTS)]
        as "a whole number from 1 to 20", optional, "3";
    /// Requests the change of the stiffness with the internal forces, by a strain to second order:
    /// biot is the usual one, green is 1/2 (F'F - 1).
    pub(super) PRESTRESS: Option<usize> = "prestress", [Word(&StrainMeasure::NAMES)], optional,
        "\"biot\"";
}
