//! Exchange of energy between elements and the outside of the model.

/// Exchange of energy between an element and the outside of the model: its work on the nodes beyond
/// its own energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Exchange {
    /// No exchange: the work of its forces on the nodes comes from its energy.
    #[default]
    Nothing,
    /// It supplies or absorbs energy: loads, driven joints, springs whose relaxed state is driven,
    /// electrodes, laws without an energy.
    Driven,
    /// It dissipates energy, and may be driven as well.
    Viscous,
}

impl Exchange {
    /// The exchange of an element that resists rates, depends on time or has forces without an
    /// energy.
    pub fn of(is_viscous: bool, is_driven: bool) -> Self {
        match (is_viscous, is_driven) {
            (true, _) => Self::Viscous,
            (false, true) => Self::Driven,
            (false, false) => Self::Nothing,
        }
    }
}
