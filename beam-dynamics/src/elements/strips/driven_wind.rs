//! Mean wind by drives.

use rotor_aero::wind::{MeanWind, WindOverTime};

use crate::model::Drive;

/// A mean wind of which some numbers are drives.
#[derive(Debug, Clone)]
pub struct DrivenWind {
    /// All other numbers.
    pub constant: MeanWind,
    /// Speed at the reference height \[m/s\].
    pub speed: Drive,
    /// Turn of the direction, clockwise seen from above \[rad\].
    pub turn: Drive,
    /// Angle above the level \[rad\].
    pub upflow: Drive,
    /// Vertical wind \[m/s\].
    pub vertical: Drive,
}

impl DrivenWind {
    /// Whether none of its numbers changes.
    pub fn is_steady(&self) -> bool {
        self.drives().all(|drive| drive.constant().is_some())
    }

    fn drives(&self) -> impl Iterator<Item = &Drive> {
        [&self.speed, &self.turn, &self.upflow, &self.vertical].into_iter()
    }
}

impl WindOverTime for DrivenWind {
    fn at(&self, time: f64) -> MeanWind {
        let [speed, direction, upflow, vertical] =
            [&self.speed, &self.turn, &self.upflow, &self.vertical]
                .map(|drive| drive.at(time).value);
        MeanWind {
            speed,
            direction,
            upflow,
            vertical,
            ..self.constant
        }
    }

    fn next_corner(&self, time: f64) -> f64 {
        let corners = self.drives().map(|drive| drive.next_corner(time));
        corners.fold(f64::INFINITY, f64::min)
    }
}
