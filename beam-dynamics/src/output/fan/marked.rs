//! Critical speeds that are marked.

use crate::result::{CriticalSpeed, FrequencyTable};

/// Text of the legend if all are marked.
pub(super) const MARKED: &str = "critical speed";
/// Critical speeds of a rotor above which only the ones at the multiples b and 2b are marked.
const MOST: usize = 30;

/// The critical speeds that are marked, with the text of the legend.
pub(super) struct Marked {
    pub speeds: Vec<CriticalSpeed>,
    pub text: String,
}

impl Marked {
    /// All of the critical speeds, or of many at multiples that the file did not choose the speeds at
    /// which loads of b equal blades excite a mode, and those at which a whirl comes to rest.
    pub fn new(table: &FrequencyTable, all: &[CriticalSpeed]) -> Self {
        let blades = u32::try_from(table.blades()).unwrap_or(0);
        let is_chosen = blades < 2 || !table.style.harmonics.is_empty();
        if is_chosen || all.len() <= MOST {
            return Self {
                speeds: all.to_vec(),
                text: MARKED.to_owned(),
            };
        }
        let orders = [0, blades, 2 * blades];
        let own = all.iter().filter(|one| orders.contains(&one.order));
        let reverses = match own.clone().any(|one| one.order == 0) {
            true => ", and where a whirl reverses",
            false => "",
        };
        Self {
            speeds: own.cloned().collect(),
            text: format!("{MARKED} at {blades}P or {}P{reverses}", 2 * blades),
        }
    }
}
