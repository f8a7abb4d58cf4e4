//! Equal parts around the axis of rotation in an analysis of modes: blades, or arms of a model without
//! blades.

use crate::case::{Arms, Model};
use crate::modes::Rotor;
use crate::result::FrequencyTable;

/// The rotor of the equal blades or arms of a model; `turns`: at a speed above zero.
pub(super) fn rotor(model: &Model, turns: bool) -> Option<Rotor> {
    let blades = model.around_the_axis(turns);
    Rotor::new(blades, &model.frame_rotation.axis)
}

/// Modes of one frequency that a model may have: both bending directions of every blade.
pub(super) fn copies(model: &Model) -> usize {
    2 * model.around_the_axis(true).len().max(2)
}

/// Remarks on modes that are left out of the Campbell diagram, for two speeds or more.
pub(super) fn left_out(table: &FrequencyTable, arms: &Arms) -> Vec<String> {
    let mut found = Vec::new();
    if table.speeds.len() > 1
        && let Arms::Unequal(why) = arms
    {
        found.push(format!(
            "the Campbell diagram leaves out the modes of the arms, which have no pattern around the axis: \
             {why}"
        ));
    }
    found.extend(table.mixed_whirls());
    found
}
