//! Energies of elements.

/// Energy of an element.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// Kinetic energy, of the motion in space [J].
    pub kinetic: f64,
    /// Energy stored in elastic parts [J].
    pub elastic: f64,
    /// Potential of gravity, zero at the origin [J].
    pub gravity: f64,
    /// Energy of the electric fields at the present voltages, and of inductances [J].
    pub electric: f64,
}

impl Energy {
    /// The sum of all parts [J].
    pub fn total(&self) -> f64 {
        self.kinetic + self.elastic + self.gravity + self.electric
    }

    /// A part of it [J].
    pub fn part(&self, part: EnergyPart) -> f64 {
        match part {
            EnergyPart::Kinetic => self.kinetic,
            EnergyPart::Elastic => self.elastic,
            EnergyPart::Gravity => self.gravity,
            EnergyPart::Electric => self.electric,
            EnergyPart::Total => self.total(),
        }
    }
}

impl std::ops::AddAssign for Energy {
    fn add_assign(&mut self, other: Self) {
        self.kinetic += other.kinetic;
        self.elastic += other.elastic;
        self.gravity += other.gravity;
        self.electric += other.electric;
    }
}

/// A part of the energy of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergyPart {
    /// Of motion in space.
    Kinetic,
    /// Stored in elastic parts.
    Elastic,
    /// Potential of gravity.
    Gravity,
    /// Of electric fields and inductances.
    Electric,
    /// The sum of all parts.
    Total,
}

/// Source of the derivatives of the energy of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergySlope {
    /// It has no energy.
    Zero,
    /// Kinetic energy and potential of gravity, from its momenta and forces.
    Momenta,
    /// Elastic energy, from its forces.
    Forces,
    /// Elastic energy, which it reads itself, see [`super::Reports::reading`].
    Read,
    /// They are unknown: it has other forces than the derivatives of its energy, or is driven.
    Unknown,
}

impl EnergySlope {
    /// Whether an element has this kind of energy.
    pub fn has(self, part: EnergyPart) -> bool {
        match part {
            EnergyPart::Kinetic | EnergyPart::Gravity => self == Self::Momenta,
            EnergyPart::Elastic => matches!(self, Self::Forces | Self::Read | Self::Unknown),
            EnergyPart::Electric => self == Self::Unknown,
            EnergyPart::Total => self != Self::Zero,
        }
    }
}
