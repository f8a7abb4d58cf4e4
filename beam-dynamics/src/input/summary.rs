//! The contents of an input, in one line.

use std::fmt;

use shared_geom::error::counted;

use super::builder::ModelBuilder;
use super::number::short_number;
use super::rotor_speed::RPM;
use crate::case::ModesSettings;
use crate::result::Measured;

/// Contents of a model and number of results.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Number of nodes.
    pub nodes: usize,
    /// Number of beams.
    pub beams: usize,
    /// Number of bodies.
    pub bodies: usize,
    /// Number of clamped nodes.
    pub clamps: usize,
    /// Number of hinges, rigid connections and joints.
    pub joints: usize,
    /// Number of springs and rods.
    pub springs: usize,
    /// Mass of beams and bodies \[kg\].
    pub mass: f64,
    /// Number of requested modes.
    pub modes: usize,
    /// Lowest and highest rotor speed \[rad/s\].
    pub speed_range: [f64; 2],
    /// Number of rotor speeds.
    pub speeds: usize,
    /// Number of measured frequencies.
    pub measured: usize,
}

impl ModelBuilder {
    /// Counts the contents of the model.
    pub fn summary(&self, modes: Option<&ModesSettings>, measured: &Measured) -> Summary {
        let speeds = modes.map_or(&[][..], |modes| &modes.speeds);
        let ends = [speeds.first(), speeds.last()];
        Summary {
            nodes: self.nodes().len(),
            beams: self.beams().len(),
            bodies: self.body_count(),
            clamps: self.clamped().len(),
            joints: self.count_of("joint"),
            springs: self.count_of("spring"),
            mass: self.mass(),
            modes: modes.map_or(0, |modes| modes.count),
            speed_range: ends.map(|speed| speed.copied().unwrap_or(0.0)),
            speeds: speeds.len(),
            measured: measured.points.len(),
        }
    }
}

impl fmt::Display for Summary {
    /// `13 nodes, 6 beams, 1 clamp, mass 0.0151 kg; 8 modes at 3 speeds, 0 to 750 rpm`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}, {}",
            counted(self.nodes, "node"),
            counted(self.beams, "beam")
        )?;
        for (count, what) in [
            (self.bodies, "body"),
            (self.clamps, "clamp"),
            (self.joints, "joint"),
            (self.springs, "spring"),
        ] {
            if count > 0 {
                write!(f, ", {}", counted(count, what))?;
            }
        }
        write!(f, ", mass {} kg", short_number(self.mass, 4))?;
        if self.modes > 0 {
            self.write_modes(f)?;
        }
        match self.measured {
            0 => Ok(()),
            count => write!(f, "; {}", counted(count, "measured point")),
        }
    }
}

impl Summary {
    fn write_modes(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "; {} at {}, ",
            counted(self.modes, "mode"),
            counted(self.speeds, "speed")
        )?;
        let [low, high] = self.speed_range.map(|speed| short_number(speed / RPM, 6));
        match self.speeds {
            1 => write!(f, "{low} rpm"),
            _ => write!(f, "{low} to {high} rpm"),
        }
    }
}
