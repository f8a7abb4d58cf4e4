//! Delay of stall at the stations of a rigid rotor.

use crate::airfoil::{RotorPlace, RotorStallDelay, Section};
use crate::rotor::blade::RigidRotor;

impl RigidRotor<Section> {
    /// The rotor with delayed stall at each of its stations, by their distances from the shaft.
    #[must_use]
    pub fn with_stall_delay(mut self, delay: &RotorStallDelay) -> Self {
        let tip_radius = self.disk_radius();
        for point in self.points() {
            let station = point.station.and_then(|at| self.stations.get_mut(at));
            let Some(station) = station else {
                continue;
            };
            let place = RotorPlace {
                chord: station.chord,
                radius: point.z,
                tip_radius,
            };
            station.section = delay.section(&station.section, place);
        }
        self
    }
}
