//! Stall of the blades in a motion: strips of which the static flow is attached along less than a part of
//! the chord, where lift no longer rises as it does below.

use crate::assembly::System;
use crate::elements::Observations;
use crate::model::{Conditions, State};
use crate::result::Stall;

/// Part of the chord with attached flow at which stall begins \[-\].
///
/// References: [Leishman1989].
const ATTACHED: f64 = 0.7;
/// Part of the largest speed of an instant below which a strip does not count: near the hub, and where the
/// flow comes from behind.
const SLOW: f64 = 0.3;

/// Strips of a model over instants.
pub(super) struct StallSum<'a> {
    system: &'a System,
    instants: usize,
    stalled: usize,
    all: usize,
    largest: f64,
}

impl<'a> StallSum<'a> {
    pub fn new(system: &'a System) -> Self {
        Self {
            system,
            instants: 0,
            stalled: 0,
            all: 0,
            largest: 0.0,
        }
    }

    /// Adds an instant.
    pub fn add(&mut self, state: &State, conditions: &Conditions) {
        let mut observed = Observations::default();
        for (index, element) in self.system.elements().enumerate() {
            if element.reports().is_some() {
                let system = self.system;
                system.observe_element(index, state, conditions, &mut observed);
            }
        }
        self.instants += 1;
        let speeds = observed.air.iter().map(|own| own.flow.speed);
        let least = SLOW * speeds.fold(0.0, f64::max);
        for own in observed.air.iter().filter(|own| own.flow.speed > least) {
            self.all += 1;
            self.stalled += usize::from(own.attached < ATTACHED);
            if own.flow.alpha.abs() > self.largest.abs() {
                self.largest = own.flow.alpha;
            }
        }
    }

    /// The stall; `None` without strips.
    pub fn found(&self) -> Option<Stall> {
        (self.all > 0).then(|| Stall {
            largest_angle: self.largest,
            part: self.stalled as f64 / self.all as f64,
        })
    }
}
