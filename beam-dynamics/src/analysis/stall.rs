//! Stall of the blades in a motion: strips of which the static flow is attached along less than a part of
//! the chord, where lift no longer rises as it does below.

use crate::assembly::System;
use crate::elements::{AirState, Observations};
use crate::model::{Conditions, State};
use crate::result::Stall;

/// Part of the chord with attached flow at which stall begins \[-\].
///
/// References: [Leishman1989].
const ATTACHED: f64 = 0.7;
/// Part of the largest speed of an instant below which a strip does not count: near the hub, and where the
/// flow comes from behind.
const SLOW: f64 = 0.3;

/// Strips over instants.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct StallCount {
    stalled: usize,
    all: usize,
    largest: f64,
}

impl StallCount {
    /// Adds the strips of an instant.
    pub fn add<'a>(&mut self, strips: impl Iterator<Item = &'a AirState> + Clone) {
        let speeds = strips.clone().map(|own| own.flow.speed);
        let least = SLOW * speeds.fold(0.0, f64::max);
        for own in strips.filter(|own| own.flow.speed > least) {
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

/// Strips of a model over instants.
pub(super) struct StallSum<'a> {
    system: &'a System,
    count: StallCount,
}

impl<'a> StallSum<'a> {
    pub fn new(system: &'a System) -> Self {
        Self {
            system,
            count: StallCount::default(),
        }
    }

    /// Adds an instant.
    pub fn add(&mut self, state: &State, conditions: &Conditions) {
        let air = air_at(self.system, state, conditions);
        self.count.add(air.iter());
    }

    /// The stall; `None` without strips.
    pub fn found(&self) -> Option<Stall> {
        self.count.found()
    }
}

/// The strips of a model in the air.
pub(super) fn air_at(system: &System, state: &State, conditions: &Conditions) -> Vec<AirState> {
    let mut observed = Observations::default();
    for (index, element) in system.elements().enumerate() {
        if element.reports().is_some() {
            system.observe_element(index, state, conditions, &mut observed);
        }
    }
    observed.air
}
