//! Mach numbers of a strip beyond the tables of its airfoils.

use super::{ActingAir, FLOW, Strip};
use crate::airfoil::Section;

/// A flow whose Mach number is beyond the table of an airfoil, which has the values of the last
/// curves there.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "the flow has Mach {found:.3}, and the table of airfoil \"{airfoil}\" is for Mach numbers from \
     {} to {}",
    range[0],
    range[1]
)]
pub struct BeyondMach {
    /// Name of the airfoil whose table ends first.
    pub airfoil: String,
    /// Mach number of the flow without induction \[-\].
    pub found: f64,
    /// Mach numbers of the table \[-\].
    pub range: [f64; 2],
}

/// The airfoil of a section whose table ends at the least Mach number: its name and its range
/// \[-\].
fn first_end(section: &Section) -> Option<(&str, [f64; 2])> {
    let parts = section.parts();
    let ranges = parts.filter_map(|(_, airfoil)| Some((airfoil.name(), airfoil.mach_range()?)));
    ranges.min_by(|a, b| a.1[1].total_cmp(&b.1[1]))
}

/// The largest Mach number for which all tables of a section have values \[-\].
pub(super) fn largest(section: &Section) -> f64 {
    first_end(section).map_or(f64::INFINITY, |(_, range)| range[1])
}

impl Strip {
    /// Whether the tables of its airfoils reach to the Mach number of a flow, without induction.
    pub fn is_within_tables(&self, air: ActingAir<'_>, flow: &[f64; FLOW]) -> bool {
        flow[0].hypot(flow[1]) <= self.largest_mach * air.still.sound_speed
    }

    /// The airfoil whose table ends below the Mach number of a flow, without induction.
    pub fn beyond_mach(&self, air: ActingAir<'_>, flow: &[f64; FLOW]) -> Option<BeyondMach> {
        let found = flow[0].hypot(flow[1]) / air.still.sound_speed;
        let (airfoil, range) = first_end(self.polar.section())?;
        (found > range[1]).then(|| BeyondMach {
            airfoil: airfoil.to_owned(),
            found,
            range,
        })
    }
}
