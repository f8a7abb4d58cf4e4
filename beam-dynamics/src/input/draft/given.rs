//! What the cards of a model may use by name beside its parts: drives, frames, sensors.

use super::Draft;
use crate::input::drives;
use crate::input::frames::Frames;
use crate::input::sensors::Sensors;

impl Draft {
    /// The drives by name.
    pub fn drives(&self) -> &drives::Catalog {
        &self.drives
    }

    /// Says which drives have a name.
    pub fn set_drives(&mut self, drives: drives::Catalog) {
        self.drives = drives;
    }

    /// The frames in which cards may be written.
    pub fn frames(&self) -> &Frames {
        &self.frames
    }

    /// Says which frames there are.
    pub fn set_frames(&mut self, frames: Frames) {
        self.frames = frames;
    }

    /// What loads may sense.
    pub fn sensors(&self) -> &Sensors {
        &self.sensors
    }

    /// Says what loads may sense.
    pub fn set_sensors(&mut self, sensors: Sensors) {
        self.sensors = sensors;
    }
}
