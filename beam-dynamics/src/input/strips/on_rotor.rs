//! Strips on a rotor: their inflow, the end of their lift, and the delay of their stall, by their distance
//! from the shaft.

use rotor_aero::airfoil::{RotorPlace, RotorStallDelay, Section};
use rotor_aero::strip::StripInflow;

use super::rotor::Rotor;
use super::stations::{Between, Stations};

/// Strips of a line on a rotor, or on none.
#[derive(Default)]
pub(super) struct OnRotor<'a> {
    /// Model of the inflow.
    pub inflow: Option<StripInflow>,
    /// Arc length beyond which they have no lift, if there is one \[m\].
    pub end: Option<f64>,
    place: Option<Place<'a>>,
}

/// Distances from the shaft.
struct Place<'a> {
    /// At a position on the line \[m\].
    radius: Box<dyn Fn(f64) -> f64 + 'a>,
    /// Of the tip \[m\].
    tip: f64,
}

impl<'a> OnRotor<'a> {
    /// Of the strips of one of several blades, whose tips have a radius \[m\]; `radius` is the distance
    /// from the shaft at a position on the line \[m\].
    pub fn new(
        (rotor, stations): (&Rotor, &Stations),
        (blades, tip): (usize, f64),
        radius: impl Fn(f64) -> f64 + 'a,
    ) -> Self {
        let mut positions = stations.positions();
        let first = positions.next().unwrap_or_default();
        let last = positions.last().unwrap_or(first);
        let end = rotor.end_of_lift(tip);
        Self {
            inflow: rotor.inflow(blades, radius(first)),
            end: (radius(last) > end).then(|| last_inside([first, last], |at| radius(at) <= end)),
            place: Some(Place {
                radius: Box::new(radius),
                tip,
            }),
        }
    }

    /// The section at a position on the line \[m\], with its stall delayed.
    pub fn section(
        &self,
        delay: Option<&RotorStallDelay>,
        position: f64,
        between: &Between,
    ) -> Section {
        match delay.zip(self.place.as_ref()) {
            None => between.airfoil.clone(),
            Some((delay, place)) => delay.section(
                &between.airfoil,
                RotorPlace {
                    chord: between.chord,
                    radius: (place.radius)(position),
                    tip_radius: place.tip,
                },
            ),
        }
    }
}

/// The last position between two that is inside; radii increase along a blade.
fn last_inside([mut low, mut high]: [f64; 2], is_inside: impl Fn(f64) -> bool) -> f64 {
    // Halves of the span down to round-off.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if is_inside(middle) {
            low = middle
        } else {
            high = middle
        }
    }
    low
}
