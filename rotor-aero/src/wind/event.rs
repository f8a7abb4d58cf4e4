//! Transient events of IEC 61400-1 ed. 3, from a start time: the whole air changes at once.
//!
//! ```text
//! EOG, T = 10.5 s: V - 0.37 Vg sin(3 pi t/T) (1 - cos(2 pi t/T))
//! EDC, T = 6 s:    direction + th/2 (1 - cos(pi t/T)), held after T
//! ECD, T = 10 s:   V + Vcg/2 (1 - cos(pi t/T)) and direction + th/2 (1 - cos(pi t/T)), held
//! EWS, T = 12 s:   V + (z - zh)/D A (1 - cos(2 pi t/T)),   or y/D instead of (z - zh)/D
//! ```
//!
//! Sections 6.3.2.2 to 6.3.2.6 of the standard; amplitudes are in the description of the turbine.

use std::f64::consts::{PI, TAU};

use crate::real::Real;

/// An event and its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Start \[s\].
    pub start: f64,
    /// Its formula.
    pub shape: EventShape,
}

/// The formula of an event.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EventShape {
    /// Extreme operating gust (EOG).
    OperatingGust {
        /// Amplitude `Vg` \[m/s\].
        amplitude: f64,
    },
    /// Extreme direction change (EDC).
    DirectionChange {
        /// Angle, in the sense of the direction of the mean wind \[rad\].
        angle: f64,
    },
    /// Extreme coherent gust with direction change (ECD).
    CoherentGust {
        /// Rise of the speed `Vcg` \[m/s\].
        rise: f64,
        /// Angle, in the sense of the direction of the mean wind \[rad\].
        angle: f64,
    },
    /// Extreme vertical shear (EWS).
    VerticalShear {
        /// Amplitude `A` over one diameter, with sign \[m/s\].
        amplitude: f64,
        /// Diameter of the rotor \[m\].
        diameter: f64,
        /// Height of the hub \[m\].
        hub_height: f64,
    },
    /// Extreme horizontal shear (EWS).
    HorizontalShear {
        /// Amplitude `A` over one diameter, with sign \[m/s\].
        amplitude: f64,
        /// Diameter of the rotor \[m\].
        diameter: f64,
    },
}

impl EventShape {
    /// Duration \[s\].
    pub fn duration(&self) -> f64 {
        match self {
            Self::OperatingGust { .. } => 10.5,
            Self::DirectionChange { .. } => 6.0,
            Self::CoherentGust { .. } => 10.0,
            Self::VerticalShear { .. } | Self::HorizontalShear { .. } => 12.0,
        }
    }
}

impl Event {
    /// Times of its start, its end and three instants between them \[s\].
    pub fn corners(&self) -> [f64; 5] {
        let duration = self.shape.duration();
        [0.0, 0.25, 0.5, 0.75, 1.0].map(|part| self.start + part * duration)
    }

    /// Time since the start over the duration, from 0 to 1.
    fn phase(&self, time: f64) -> f64 {
        ((time - self.start) / self.shape.duration()).clamp(0.0, 1.0)
    }

    /// Turn of the mean wind at a time \[rad\].
    pub fn turn(&self, time: f64) -> f64 {
        let rise = 0.5 * (1.0 - (PI * self.phase(time)).cos());
        match self.shape {
            EventShape::DirectionChange { angle } | EventShape::CoherentGust { angle, .. } => {
                angle * rise
            }
            _ => 0.0,
        }
    }

    /// Speed along the wind that is added at a point \[m/s\].
    pub fn speed<T: Real>(&self, at: &[T; 3], time: f64) -> T {
        let s = self.phase(time);
        let whole = 1.0 - (TAU * s).cos();
        match self.shape {
            EventShape::OperatingGust { amplitude } => {
                T::from(-0.37 * amplitude * (3.0 * PI * s).sin() * whole)
            }
            EventShape::DirectionChange { .. } => T::from(0.0),
            EventShape::CoherentGust { rise, .. } => T::from(0.5 * rise * (1.0 - (PI * s).cos())),
            EventShape::VerticalShear {
                amplitude,
                diameter,
                hub_height,
            } => (at[2] - hub_height) * (amplitude * whole / diameter),
            EventShape::HorizontalShear {
                amplitude,
                diameter,
            } => at[1] * (amplitude * whole / diameter),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn speed(shape: EventShape, at: [f64; 3], time: f64) -> f64 {
        Event { start: 2.0, shape }.speed(&at, time)
    }

    #[test]
    fn nothing_before_and_gusts_end() {
        let shapes = [
            EventShape::OperatingGust { amplitude: 5.0 },
            EventShape::CoherentGust {
                rise: 15.0,
                angle: 1.0,
            },
            EventShape::DirectionChange { angle: 1.0 },
        ];
        for shape in shapes {
            let event = Event { start: 2.0, shape };
            assert_eq!(speed(shape, [0.0; 3], 1.0), 0.0);
            assert_eq!(event.turn(1.0), 0.0);
        }
        assert!(speed(shapes[0], [0.0; 3], 99.0).abs() < 1e-14);
        // held after the end
        assert_eq!(speed(shapes[1], [0.0; 3], 99.0), 15.0);
        let held = Event {
            start: 2.0,
            shape: shapes[2],
        };
        assert_eq!(held.turn(99.0), 1.0);
        assert!((held.turn(5.0) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn shears_are_linear_across_the_rotor() {
        let vertical = EventShape::VerticalShear {
            amplitude: 6.0,
            diameter: 100.0,
            hub_height: 90.0,
        };
        // largest at half time: twice the amplitude over a diameter
        assert!((speed(vertical, [0.0, 7.0, 140.0], 8.0) - 6.0).abs() < 1e-14);
        assert!((speed(vertical, [0.0, 7.0, 40.0], 8.0) + 6.0).abs() < 1e-14);
        let horizontal = EventShape::HorizontalShear {
            amplitude: -6.0,
            diameter: 100.0,
        };
        assert!((speed(horizontal, [0.0, 50.0, 3.0], 8.0) + 6.0).abs() < 1e-14);
        assert_eq!(speed(horizontal, [0.0, 50.0, 3.0], 14.0), 0.0);
    }
}
