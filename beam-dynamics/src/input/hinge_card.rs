//! Spring and damper of a hinge.

use crate::elements::Signal;
use crate::elements::joints::HingeSpring;

/// Spring and damper of a hinge as a card defines them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct HingeCard {
    /// The spring, with the relaxed angle if it is constant.
    pub spring: HingeSpring,
    /// The relaxed angle if it changes \[rad\].
    pub relaxed: Option<Signal>,
}
