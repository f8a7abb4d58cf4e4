//! How elements exchange energy with what is outside of the model.

/// How an element exchanges energy with what is outside of the model: what it gives the
/// nodes beyond its own energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Exchange {
    /// Not at all: what its forces give the nodes is taken from its energy.
    #[default]
    Nothing,
    /// It gives and takes: loads, driven joints, springs whose relaxed state is driven,
    /// electrodes, laws without an energy.
    Driven,
    /// It resists rates, and may be driven as well.
    Viscous,
}

impl Exchange {
    /// That of an element which resists rates, is given something over time or has forces
    /// without an energy.
    pub fn of(is_viscous: bool, is_driven: bool) -> Self {
        match (is_viscous, is_driven) {
            (true, _) => Self::Viscous,
            (false, true) => Self::Driven,
            (false, false) => Self::Nothing,
        }
    }
}
