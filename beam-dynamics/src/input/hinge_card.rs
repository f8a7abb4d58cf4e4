//! Spring and damper of a hinge.

use crate::elements::Signal;
use crate::elements::joints::HingeSpring;

/// Spring and damper of a hinge as a card means them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct HingeCard {
    /// The spring, with the relaxed angle where that does not change.
    pub spring: HingeSpring,
    /// The relaxed angle where it changes \[rad\].
    pub relaxed: Option<Signal>,
}
